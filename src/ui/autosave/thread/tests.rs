//! What the thread keeps, and where.

use super::*;
use crate::sim::Worker;
use std::fs;

/// One that keeps in this folder, and what it tells.
fn autosaver(folder: &Path) -> (Autosaver, Receiver<AutosaveReport>) {
    let (told, reports) = channel();
    let mut autosaver = Autosaver::new(LatestSlot::default(), told, || ());
    autosaver.folder = Some(folder.to_owned());
    (autosaver, reports)
}

fn put(autosaver: &Autosaver, number: u64) {
    let scene = Arc::new(Scene::new(format!("scene {number}")));
    *locked(&autosaver.slot) = Some(WaitingDocument { number, origin: Origin::default(), scene });
}

/// Documents that are kept in a folder.
fn kept(folder: &Path) -> Vec<String> {
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    files.filter(|path| path.extension().is_some_and(|end| end == "json")).map(text).collect()
}

fn text(path: PathBuf) -> String {
    fs::read_to_string(path).expect("a text")
}

#[test]
fn a_newer_document_outlives_that_an_older_one_is_forgotten() {
    let folder = tempfile::tempdir().expect("a folder");
    let (mut autosaver, _reports) = autosaver(folder.path());
    // Asked for in this order by the window: keep 5 now, it is saved; meanwhile the next was put in the slot.
    put(&autosaver, 6);
    autosaver.go(AutosaveRequest::KeepNow);
    autosaver.go(AutosaveRequest::Forget(5));
    let left = kept(folder.path());
    assert!(left.len() == 1 && left[0].contains("scene 6"), "{left:?}");
    autosaver.go(AutosaveRequest::Forget(6));
    assert!(kept(folder.path()).is_empty());
}

#[test]
fn a_folder_that_vanishes_is_made_again() {
    let above = tempfile::tempdir().expect("a folder");
    let folder = above.path().join("recovery");
    let (mut autosaver, reports) = autosaver(&folder);
    for number in 1..4 {
        put(&autosaver, number);
        autosaver.go(AutosaveRequest::KeepNow);
        let left = kept(&folder);
        assert!(left.len() == 1 && left[0].contains(&format!("scene {number}")), "{left:?}");
        fs::remove_dir_all(&folder).expect("removed");
    }
    assert!(reports.try_recv().is_err(), "nothing went wrong");
}

#[test]
fn documents_are_offered_before_recordings_are_read_which_is_done_beside() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = RecoveryFile::open(folder.path()).expect("opened");
    place.write(&Origin::default(), &Scene::new("document")).expect("kept");
    drop(place);
    let scene = serde_json::to_string(&Scene::new("recorded")).expect("JSON");
    let begin = format!("{{\"begin\":{{\"program\":\"1\",\"scene\":{scene}}}}}\n");
    let frames = "{\"frame\":\"00\"}\n".repeat(3);
    fs::write(folder.path().join("recovery-a.recording"), format!("{begin}{frames}{{\"fra")).expect("written");
    // One that never went on.
    let empty = folder.path().join("recovery-b.recording");
    fs::write(&empty, begin).expect("written");
    let (told, reports) = channel();
    let (wake, awake) = channel();
    let name = || std::thread::current().name().map(str::to_owned);
    let mut autosaver = Autosaver::new(LatestSlot::default(), told, move || wake.send(name()).expect("heard"));
    autosaver.go(AutosaveRequest::Folder(folder.path().to_owned()));
    let Ok(AutosaveReport::Offers(offers)) = reports.recv() else { panic!("no documents") };
    assert_eq!(offers.iter().map(RecoveryOffer::name).collect::<Vec<_>>(), ["document"]);
    assert_eq!(awake.recv(), Ok(name()));
    let Ok(AutosaveReport::Recordings(recordings)) = reports.recv() else { panic!("no recordings") };
    assert_eq!(awake.recv().expect("heard").as_deref(), Some("recordings"), "who keeps documents waits for none");
    assert_eq!(recordings.iter().map(|of| (of.name(), of.frames)).collect::<Vec<_>>(), [("recorded", 3)]);
    assert!(!crate::io::is_there(&empty));
}

#[test]
fn that_a_recording_is_as_long_as_it_may_be_is_said_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let (mut autosaver, reports) = autosaver(folder.path());
    let scene = Scene { description: "x".repeat(2000), ..Scene::new("recorded") };
    let (wake, woken) = channel();
    let worker = Worker::start(Arc::new(scene), Arc::default(), false, move || wake.send(()).unwrap_or_default());
    // Its journal begins anew where the scene has been put together.
    while worker.take().is_none_or(|published| published.status.recording.frames == 0) {
        woken.recv().expect("it starts");
    }
    autosaver.recorder = Some((Recorder::new(worker.journal_tail(), Origin::default()), Instant::now()));
    autosaver.record();
    assert!(reports.try_recv().is_err(), "all of it is kept");
    let (recorder, _) = autosaver.recorder.as_mut().expect("it records");
    recorder.bound(folder.path().join("bound.recording"), 1000);
    for _ in 0..3 {
        autosaver.record();
    }
    assert!(matches!(reports.try_recv(), Ok(AutosaveReport::RecordedUpTo(1000))));
    assert!(reports.try_recv().is_err(), "once is enough");
    let left = text(folder.path().join("bound.recording"));
    assert!(left.ends_with('\n') && left.len() <= 1000 && left.contains("place"), "{left}");
}
