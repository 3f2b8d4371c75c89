//! What can be driven in a scene, and commands that put drives there.

use crate::every_field;
use sinew::edit::{Command, Editor};
use sinew::io::{apply_sets, scene_to_json};
use sinew::scene::{Drivable, Drive, DriveKeys, Motion, PanelMotion, Scene, Wave};

fn fibre(fibre: &str) -> Drivable {
    Drivable::Fibre { body: "bar".into(), fibre: fibre.into() }
}

fn set(of: &Drivable, drive: impl Into<Option<Drive>>) -> Command {
    Command::SetDrive { of: of.clone(), drive: drive.into() }
}

fn json(scene: &Scene) -> serde_json::Value {
    serde_json::from_str(&scene_to_json(scene)).expect("what was written is JSON")
}

/// As many drives as a file has: whatever is one is tagged as one, and what one is otherwise is a part of it.
fn count(value: &serde_json::Value) -> usize {
    let own = |(key, value): (&String, &serde_json::Value)| {
        let is_drive = key.ends_with("drive") && value.as_object().is_some_and(|of| of.len() == 1);
        if key == "otherwise" { 0 } else { usize::from(is_drive) + count(value) }
    };
    match value {
        serde_json::Value::Object(fields) => fields.iter().map(own).sum(),
        serde_json::Value::Array(items) => items.iter().map(count).sum(),
        _ => 0,
    }
}

#[test]
fn every_drive_of_a_file_is_listed_under_its_pointer() {
    let scene = every_field();
    let written = json(&scene);
    let mut pointers = Vec::new();
    for of in scene.drivables() {
        let pointer = of.pointer(&scene).expect("it is there");
        let there = of.drive(&scene).map(|drive| serde_json::to_value(drive).expect("a drive is JSON"));
        assert_eq!(written.pointer(&pointer), there.as_ref(), "{pointer}");
        assert!(!of.title(&scene).is_empty(), "{pointer}");
        pointers.extend(there.map(|_| pointer));
    }
    assert_eq!(pointers.len(), count(&written), "{pointers:?}");
    assert!(pointers.len() >= 10, "{pointers:?}");
}

#[test]
fn sets_reach_every_drive_of_a_file() {
    let scene = every_field();
    let mut kinds = std::collections::BTreeSet::new();
    for of in scene.drivables().into_iter().filter(|of| of.drive(&scene).is_some()) {
        let pointer = of.pointer(&scene).expect("it is there");
        let period = format!("{pointer}/wave/period");
        // First a wave in its place, then a value of that wave.
        let changed =
            apply_sets(&scene, [(pointer.as_str(), r#"{"wave": {"period": 0.4}}"#), (period.as_str(), "0.3")])
                .unwrap_or_else(|error| panic!("{pointer}: {error}"));
        assert_eq!(of.drive(&changed), Some(&Drive::from(Wave::new(0.3))), "{pointer}");
        changed.validate().unwrap_or_else(|error| panic!("{pointer}: {error}"));
        kinds.insert(pointer.split('/').filter(|part| part.parse::<usize>().is_err()).collect::<Vec<&str>>().join("/"));
    }
    let all = [
        "/bodies/drives/drive",
        "/bodies/elements/activation/drive",
        "/bodies/fibres/activation/drive",
        "/bodies/pins/motion/driven/drive",
        "/bodies/sheets/activation/drive",
        "/colliders/motion/driven/drive",
        "/gravity_drive",
        "/panels/motion/follows/drive",
        "/two_layer/active_springs/drive",
        "/two_layer/drives/drive",
        "/two_layer/pressure_drive",
        "/wind/drive",
    ];
    assert_eq!(kinds.iter().map(String::as_str).collect::<Vec<&str>>(), all);
}

#[test]
fn a_drive_is_put_anywhere_and_taken_away_again() {
    for of in every_field().drivables() {
        let mut editor = Editor::new(every_field());
        let before = scene_to_json(editor.scene());
        let there = of.drive(editor.scene()).cloned();
        let drive = Drive::from(DriveKeys::new([(0.0, 0.25), (0.5, 0.75)]));
        if of == fibre("wire") {
            // One that yields does not act.
            let refused = editor.apply(&set(&of, drive)).expect_err("it yields").to_string();
            assert!(refused.starts_with("/bodies/0/fibres/2/yield: "), "{refused}");
            continue;
        }
        if of == (Drivable::Sheet { body: "stamp".into(), sheet: "perforation".into() }) {
            // A seam carries nothing.
            let refused = editor.apply(&set(&of, drive)).expect_err("it is a seam").to_string();
            assert!(refused.starts_with("/bodies/2/sheets/0/seam: "), "{refused}");
            continue;
        }
        editor.apply(&set(&of, drive.clone())).unwrap_or_else(|error| panic!("{of:?}: {error}"));
        assert_eq!(of.drive(editor.scene()), Some(&drive), "{of:?}");
        assert_eq!(editor.undo_name(), Some("Change drive"));
        let followed = !of.followers(editor.scene()).is_empty();
        let gone = editor.apply(&set(&of, None));
        assert_eq!(gone.is_err(), followed, "{of:?}: a shared drive that is followed stays");
        if !followed {
            assert_eq!(of.drive(editor.scene()), None, "{of:?}");
            assert!(editor.undo());
        }
        assert!(editor.undo() && scene_to_json(editor.scene()) == before, "{of:?} had {there:?}");
    }
}

#[test]
fn what_a_drive_moves_stays_as_it_is() {
    let mut editor = Editor::new(every_field());
    let wave = Drive::from(Wave::new(0.5));
    let activation = |editor: &Editor| editor.scene().bodies[0].fibres[0].activation.clone().expect("it acts");
    let before = activation(&editor);
    editor.apply(&set(&fibre("left"), wave.clone())).expect("a change");
    assert_eq!(activation(&editor), sinew::scene::Activation { drive: wave.clone(), ..before });
    // A pin that ramped follows the drive, a little upwards; one that was driven keeps its way.
    for (pin, way) in [("push", [0.0, 0.01, 0.0]), ("stir", [0.0, 0.01, 0.0])] {
        let of = Drivable::Pin { body: "bar".into(), pin: pin.into() };
        editor.apply(&set(&of, wave.clone())).expect("a change");
        let motion = &editor.scene().bodies[0].pins.iter().find(|one| one.id == pin).expect("it is there").motion;
        let Motion::Driven(driven) = motion else { panic!("{pin}: {motion:?}") };
        assert_eq!((driven.offset, driven.turn.is_some()), (way, pin == "stir"));
    }
    let lid = Drivable::Panel("lid".into());
    editor.apply(&set(&lid, wave)).expect("a change");
    assert!(matches!(editor.scene().panels[0].motion, PanelMotion::Follows(_)));
    editor.apply(&set(&lid, None)).expect("a change");
    assert_eq!(editor.scene().panels[0].motion, PanelMotion::Falls);
}

#[test]
fn limits_are_where_validation_refuses() {
    let scene = every_field();
    let mut tried = 0;
    for of in scene.drivables().into_iter().filter(|of| of.drive(&scene).is_some()) {
        for (limit, out) in of.limits(&scene).into_iter().zip([-1.0, 1.0]) {
            if limit.is_finite() {
                let mut editor = Editor::new(scene.clone());
                editor.apply(&set(&of, Drive::Constant(limit))).unwrap_or_else(|error| panic!("{of:?}: {error}"));
                let beyond = limit + out * 1e-3;
                assert!(editor.apply(&set(&of, Drive::Constant(beyond))).is_err(), "{of:?} takes {beyond}");
                tried += 1;
            }
        }
    }
    assert!(tried >= 6, "{tried} limits were tried");
}

#[test]
fn what_is_shared_says_who_follows_it() {
    let scene = every_field();
    let slow = Drivable::Shared { body: "bar".into(), drive: "slow".into() };
    assert_eq!(slow.followers(&scene), [fibre("left")]);
    assert_eq!(fibre("left").source(&scene), slow);
    assert_eq!(fibre("left").resolved(&scene), slow.drive(&scene));
    assert_eq!(fibre("right").source(&scene), fibre("right"));
    // A wave along fibres is no motion of a pin.
    assert!(slow.runs_along(&scene) && fibre("left").runs_along(&scene));
    assert!(!Drivable::Shared { body: "bar".into(), drive: "nod".into() }.runs_along(&scene));
    assert!(!Drivable::Gravity.runs_along(&scene));
    let mut editor = Editor::new(scene);
    let missing = editor.apply(&set(&fibre("none"), Drive::Constant(1.0))).expect_err("it is not there");
    assert_eq!(missing.to_string(), "a fibre \"none\" of \"bar\" is not there");
}
