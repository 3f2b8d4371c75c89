//! Every step by which a file is written fails once, in every way in which disks and power cuts let it fail: there is
//! always one whole version, the one from before or the new one; nothing is left behind after the next start; and what
//! is said names the file and what happened.

use crate::files::in_new_folder;
use crate::read::refused;
use crate::{every_field, exports};
use sinew::geometry::Model;
use sinew::io::{FrameFolder, load_scene, save_scene, scene_to_json, write_glb};
use sinew::scene::{Body, Scene};
use sinew::sim::Journal;
use sinew::test_support::io::{
    Fate, LeftRecording, Origin, RecoveryFile, Step, judged, left_recordings, read_journal, recoverable_documents,
    write_journal, write_recording,
};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Something that is written, in two versions, and a next start.
pub struct Kind {
    pub name: &'static str,
    /// Writes version 0 or 1 into a folder.
    pub write: fn(&Path, usize) -> Result<(), String>,
    /// Which versions the folder holds whole, one or none of each file.
    pub versions: fn(&Path) -> Vec<usize>,
    /// What the next start does.
    pub start: fn(&Path),
    /// Whether more than one file is written, so that those before the fault are new already.
    several: bool,
}

/// Long enough to be written in several pieces.
fn scene(version: usize) -> Scene {
    Scene { name: format!("version {version}"), description: "x".repeat(20_000 * (version + 1)), ..every_field() }
}

fn file(folder: &Path) -> PathBuf {
    folder.join("it.json")
}

fn version_of(scene: &Scene) -> usize {
    (0..2).find(|&version| *scene == self::scene(version)).expect("a whole version")
}

fn journal(version: usize) -> Journal {
    let scene = Scene::new("x".repeat(9000 * (version + 1))).with_body(Body::cuboid("cube", [0.03; 3]));
    serde_json::from_value(serde_json::json!({"program": "1", "scene": scene, "asked": [], "hashes": ["0"]}))
        .expect("a journal")
}

/// Lines of a recording.
fn lines(version: usize) -> Vec<String> {
    (0..12).map(|k| format!("{version} {k} {}", "x".repeat(900 * (k % 3) + version))).collect()
}

/// The version of a recording, whose lines are whole up to any one behind its start.
fn recorded(left: &LeftRecording) -> usize {
    let found: Vec<_> = left.lines().expect("a file").collect();
    assert!(found.len() >= 2, "it has not begun");
    (0..2).find(|&version| found == lines(version)[..found.len()]).expect("whole lines of one version")
}

fn model(version: usize) -> Model {
    let count = 300 * (version + 1);
    let positions = (0..count).map(|k| glam::DVec3::new(k as f64, (k * k % 7) as f64, (k % 5) as f64)).collect();
    let triangles = (0..count as u32 - 2).map(|k| [k, k + 1, k + 2]).collect();
    let mut model = Model::default();
    model.add(sinew::geometry::MeshData { positions, triangles, ..Default::default() });
    model
}

fn frame(version: usize) -> Vec<u8> {
    [b'0' + version as u8].repeat(20_000 + version)
}

pub const KINDS: [Kind; 8] = [
    Kind {
        name: "save",
        write: |folder, version| save_scene(&file(folder), &scene(version)).map_err(|error| error.to_string()),
        versions: |folder| load_scene(&file(folder)).iter().map(version_of).collect(),
        start: |folder| save_scene(&folder.join("other.json"), &Scene::new("other")).expect("saved"),
        several: false,
    },
    Kind {
        name: "autosave",
        write: |folder, version| {
            // Of one document, which stays open from version to version.
            let keep = |kept: &RecoveryFile| kept.write(&Origin::default(), &scene(version));
            RecoveryFile::open(folder)
                .and_then(|kept| keep(&kept).map(|()| kept))
                .map(drop)
                .map_err(|error| error.to_string())
        },
        versions: |folder| {
            let found = recoverable_documents(folder);
            found.iter().map(|document| version_of(&document.load().expect("whole"))).collect()
        },
        start: |folder| {
            recoverable_documents(folder);
            drop(RecoveryFile::open(folder).expect("opened"));
        },
        several: true,
    },
    Kind {
        name: "recording",
        write: |folder, version| write_journal(&file(folder), &journal(version)).map_err(|error| error.to_string()),
        versions: |folder| {
            let of = |found: &Journal| (0..2).find(|&version| *found == journal(version)).expect("a whole version");
            read_journal(&file(folder)).iter().map(of).collect()
        },
        start: |folder| save_scene(&folder.join("other.json"), &Scene::new("other")).expect("saved"),
        several: false,
    },
    Kind {
        name: "recording that grows",
        write: |folder, version| {
            let write = |kept: RecoveryFile| write_recording(&kept, &lines(version));
            RecoveryFile::open(folder).and_then(write).map_err(|error| error.to_string())
        },
        versions: |folder| left_recordings(folder).iter().map(recorded).collect(),
        start: |folder| {
            recoverable_documents(folder);
            drop(RecoveryFile::open(folder).expect("opened"));
        },
        several: true,
    },
    Kind {
        name: "model",
        write: |folder, version| {
            write_glb(&folder.join("it.glb"), &model(version), "it").map_err(|error| error.to_string())
        },
        versions: |folder| {
            let faces = |version: usize| model(version).triangles.len();
            let found = sinew::io::load_model(&folder.join("it.glb"));
            let of = |found: &Model| (0..2).find(|&v| found.triangles.len() == faces(v)).expect("a whole version");
            found.iter().map(of).collect()
        },
        start: |folder| save_scene(&folder.join("other.json"), &Scene::new("other")).expect("saved"),
        several: false,
    },
    Kind {
        name: "frames",
        write: |folder, version| {
            let written = FrameFolder::create(&folder.join("frames"), "txt")
                .and_then(|mut frames| (0..3).try_for_each(|_| frames.push(|out| out.write_all(&frame(version)))));
            written.map_err(|error| error.to_string())
        },
        versions: |folder| {
            let whole = |k: usize| fs::read(folder.join(format!("frames/frame_{k:06}.txt"))).ok();
            let of = |bytes: Vec<u8>| (0..2).find(|&version| bytes == frame(version)).expect("a whole version");
            (0..3).filter_map(whole).map(of).collect()
        },
        start: |folder| drop(FrameFolder::create(&folder.join("frames"), "txt").expect("made")),
        several: true,
    },
    Kind {
        name: "export that grows",
        write: exports::cache,
        versions: exports::caches,
        start: |folder| exports::cache(folder, 1).expect("written"),
        several: true,
    },
    Kind {
        name: "export",
        write: exports::shapes,
        versions: exports::found_shapes,
        start: |folder| exports::shapes(folder, 1).expect("written"),
        several: true,
    },
];

/// Temporary files in a folder and those in it, and locks without a document.
pub fn litter(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(litter(&path));
        }
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        if ending == "tmp" || ending == "lock" && !path.with_extension("json").exists() {
            found.push(path);
        }
    }
    found
}

/// All files in a folder and in those in it, by their paths from it.
fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = PathBuf::from(path.file_name().expect("a name"));
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(within, bytes)| (name.join(within), bytes)));
        } else {
            found.push((name, fs::read(&path).expect("a file")));
        }
    }
    found
}

/// Puts such files into a folder.
fn put(files: &[(PathBuf, Vec<u8>)], folder: &Path) {
    for (name, bytes) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        fs::write(path, bytes).expect("written");
    }
}

/// The steps of a write, and what comes of it where the step of that number has this fate.
fn faulted(kind: &Kind, folder: &Path, fault: Option<(usize, Fate)>) -> (Vec<Step>, Result<(), String>) {
    let steps = Arc::new(Mutex::new(Vec::new()));
    let judge = {
        let steps = Arc::clone(&steps);
        move |step| {
            let mut so_far = steps.lock().expect("whole");
            so_far.push(step);
            fault.filter(|(number, _)| *number + 1 == so_far.len()).map_or(Fate::Done, |(_, fate)| fate)
        }
    };
    let outcome = judged(judge, || (kind.write)(folder, 1));
    let steps = steps.lock().expect("whole").clone();
    (steps, outcome)
}

/// The versions that are found, as soon as they are those that are wanted, or after a while: a process that another
/// test begins just now holds every lock of this one until it has begun.
fn versions(kind: &Kind, folder: &Path, is_wanted: impl Fn(&[usize]) -> bool) -> Vec<usize> {
    let found = || (kind.versions)(folder);
    (0..1000)
        .map(|_| found())
        .inspect(|_| std::thread::yield_now())
        .find(|found| is_wanted(found))
        .unwrap_or_else(found)
}

#[test]
fn whatever_step_fails_there_is_one_whole_version_and_no_litter() {
    let errors = [ErrorKind::StorageFull, ErrorKind::ReadOnlyFilesystem, ErrorKind::PermissionDenied];
    for kind in &KINDS {
        let first = in_new_folder(|folder| {
            (kind.write)(folder, 0).expect("written");
            files(folder)
        });
        let steps = in_new_folder(|folder| {
            (kind.write)(folder, 0).expect("written");
            let (steps, outcome) = faulted(kind, folder, None);
            assert_eq!(outcome, Ok(()), "{}", kind.name);
            assert!((kind.versions)(folder).contains(&1), "{}", kind.name);
            steps
        });
        for step in [Step::Make, Step::Write, Step::Sync, Step::Rename] {
            assert!(steps.contains(&step), "{}: {steps:?}", kind.name);
        }
        let (mut failed, mut done) = (0, 0);
        for number in 0..steps.len() {
            for fate in [Fate::Fails(errors[number % errors.len()]), Fate::Short(7), Fate::Ends] {
                let what = format!("{}, step {number} of {steps:?}: {fate:?}", kind.name);
                in_new_folder(|folder| {
                    put(&first, folder);
                    let before = (kind.versions)(folder);
                    let (_, outcome) = faulted(kind, folder, Some((number, fate)));
                    let after = versions(kind, folder, |found| {
                        found.len() >= before.len() && (outcome.is_err() || found.contains(&1))
                    });
                    match &outcome {
                        Ok(()) => {
                            assert!(after.contains(&1), "{what}: {after:?}");
                            done += 1;
                        }
                        Err(said) => {
                            refused(said);
                            failed += 1;
                            assert!(said.contains(&*folder.to_string_lossy()), "{what}: it names no file: {said}");
                            let is_new = kind.several || fate == Fate::Ends;
                            assert!(is_new || after == before, "{what}: {after:?} where {before:?} was there");
                        }
                    }
                    assert!(after.len() >= before.len(), "{what}: {after:?} of {before:?} are left");
                    if fate != Fate::Ends && steps[number] != Step::Remove {
                        let left = litter(folder);
                        assert!(left.is_empty(), "{what}: {left:?}");
                    }
                    (kind.start)(folder);
                    let left = litter(folder);
                    assert!(left.is_empty(), "{what}: after the next start {left:?}");
                    let found = (kind.versions)(folder).len();
                    assert!(found == after.len(), "{what}: the next start took one away");
                });
            }
        }
        assert!(failed > 5 && done >= steps.len(), "{}: {failed} failed and {done} did not", kind.name);
    }
}

#[test]
fn a_disk_that_takes_no_byte_costs_nothing_and_is_named() {
    for kind in &KINDS {
        in_new_folder(|folder| {
            (kind.write)(folder, 0).expect("written");
            let before = (kind.versions)(folder);
            for fault in [ErrorKind::StorageFull, ErrorKind::ReadOnlyFilesystem, ErrorKind::NotFound] {
                let judge = move |step| if step == Step::Remove { Fate::Done } else { Fate::Fails(fault) };
                let said = judged(judge, || (kind.write)(folder, 1)).expect_err(kind.name);
                refused(&said);
                assert!(said.contains("cannot be written"), "{}: {said}", kind.name);
                assert_eq!((kind.versions)(folder), before, "{}", kind.name);
                assert_eq!(litter(folder), Vec::<PathBuf>::new(), "{}", kind.name);
            }
        });
    }
}

#[test]
fn bytes_that_go_a_few_at_a_time_are_all_written() {
    for kind in &KINDS {
        in_new_folder(|folder| {
            let judge = |step| if step == Step::Write { Fate::Short(1000) } else { Fate::Done };
            judged(judge, || (kind.write)(folder, 1)).expect(kind.name);
            assert!((kind.versions)(folder).iter().all(|&version| version == 1), "{}", kind.name);
        });
    }
}

#[test]
fn the_document_is_kept_in_memory_when_its_file_is_not_written() {
    let mut editor = sinew::edit::Editor::new(scene(0));
    editor.apply(&sinew::edit::Command::SetGravity([0.0, -1.0, 0.0])).expect("changed");
    let before = scene_to_json(editor.scene());
    in_new_folder(|folder| {
        let full = |_| Fate::Fails(ErrorKind::StorageFull);
        judged(full, || save_scene(&file(folder), editor.scene())).expect_err("the disk is full");
        assert!(editor.is_changed() && editor.undo_name().is_some());
        assert_eq!(scene_to_json(editor.scene()), before);
        save_scene(&file(folder), editor.scene()).expect("now there is room");
        assert_eq!(load_scene(&file(folder)).as_ref().ok(), Some(&**editor.scene()));
    });
}
