//! What the thread keeps, and where.

use super::*;
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
