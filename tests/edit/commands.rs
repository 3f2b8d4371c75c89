//! Commands over several parts at once, and what undo calls them.

use crate::shapes::*;
use crate::{every_field, scene};
use sinew::edit::fibre_ops::{Transform, copies, smooth, transform};
use sinew::edit::{Command, EditError, Editor, Item};
use sinew::io::{load_scene, save_scene, scene_to_json};
use sinew::scene::{Body, Dab, Fibre, Placement, TwoLayer, add_dab};

fn fibres(editor: &Editor) -> &[Fibre] {
    &editor.scene().bodies[0].fibres
}

fn fibre_item(fibre: &str) -> Item {
    Item::Fibre { body: "bar".into(), fibre: fibre.into() }
}

#[test]
fn several_fibres_change_in_one_step_with_a_name() {
    let mut editor = Editor::new(scene());
    let first = scene_to_json(editor.scene());
    let by = Transform::translation(glam::DVec3::new(0.002, 0.0, 0.0));
    let moved: Vec<Fibre> =
        fibres(&editor)[..3].iter().map(|fibre| transform(fibre, &by, SAMPLING).expect("a move").fibre).collect();
    editor.apply(&Command::set_fibres("Move", "bar", moved.clone())).expect("a change");
    assert_eq!(editor.undo_name(), Some("Move 3 fibres"));
    assert_eq!(fibres(&editor)[..3], moved);

    let one = smooth(&fibres(&editor)[1], 1, SAMPLING).expect("a fibre").fibre;
    let name = format!("Smooth {}", one.name);
    let command = Command::set_fibres("Smooth", "bar", vec![one]);
    assert_eq!(command.name(), name);

    let copied = copies(&fibres(&editor)[..2], fibres(&editor));
    let count = fibres(&editor).len();
    editor.apply(&Command::add_fibres("Duplicate", "bar", copied.clone())).expect("a change");
    assert_eq!((editor.undo_name(), fibres(&editor).len()), (Some("Duplicate 2 fibres"), count + 2));

    let gone = copied.iter().map(|fibre| fibre.id.as_str());
    editor.apply(&Command::remove_fibres("bar", gone)).expect("a change");
    assert_eq!((editor.undo_name(), fibres(&editor).len()), (Some("Delete 2 fibres"), count));
    assert_eq!(Command::remove_fibres("bar", ["x"]).name(), "Delete fibre");

    for _ in 0..3 {
        assert!(editor.undo());
    }
    assert!(!editor.undo() && scene_to_json(editor.scene()) == first);
}

#[test]
fn many_changes_are_all_made_or_none() {
    let mut editor = Editor::new(scene());
    let mut fibre = fibres(&editor)[0].clone();
    fibre.volume_fraction = 0.125;
    let good = Command::SetFibre { body: "bar".into(), fibre: fibre.clone() };
    let missing = Command::RemoveFibre { body: "bar".into(), fibre: "none".into() };
    fibre.volume_fraction = 7.0;
    let invalid = Command::SetFibre { body: "bar".into(), fibre };
    for bad in [missing, invalid] {
        let commands = vec![good.clone(), Command::SetGravity([0.0; 3]), bad];
        let refused = editor.apply(&Command::Many { name: "Several".into(), commands });
        assert!(refused.is_err());
        assert_eq!(**editor.scene(), scene());
        assert!(editor.undo_name().is_none() && !editor.is_changed());
    }
    // Later changes see what earlier ones did.
    let copied = copies([&fibres(&editor)[0]], fibres(&editor)).remove(0);
    let id = copied.id.clone();
    let add = Command::AddFibre { body: "bar".into(), fibre: copied };
    let remove = Command::RemoveFibre { body: "bar".into(), fibre: id };
    let there_and_back = Command::Many { name: "Nothing".into(), commands: vec![add, remove] };
    editor.apply(&there_and_back).expect("a change");
    assert!(editor.undo_name().is_none(), "what changes nothing is no step");
}

#[test]
fn bodies_come_and_go_with_what_reads_them() {
    let mut editor = Editor::new(every_field());
    let before = every_field();
    let taken = Command::AddBody(Body::cuboid("balloon", [0.1; 3]).into());
    assert!(matches!(editor.apply(&taken), Err(EditError::Missing(_))), "of either kind");
    editor.apply(&Command::RemoveBody { body: "bar".into() }).expect("a change");
    let left = editor.scene();
    assert!(left.find_body("bar").is_none() && left.measures.iter().all(|measure| measure.body != "bar"));
    assert!(left.measures.len() < before.measures.len());
    editor.apply(&Command::AddBody(TwoLayer::ball("bar").into())).expect("its name is free");
    let placement = Placement { translation: [1.0, 2.0, 3.0], ..Placement::default() };
    editor.apply(&Command::SetPlacement { body: "bar".into(), placement }).expect("a change");
    assert_eq!(editor.scene().two_layer_body("bar").expect("it is there").placement.translation, [1.0, 2.0, 3.0]);
    assert_eq!(editor.undo_name(), Some("Place body"));
    let other = Command::SetBody { verb: "Scale".into(), body: Body::cuboid("bar", [0.1; 3]).into() };
    assert!(matches!(editor.apply(&other), Err(EditError::Missing(_))), "it is of the other kind");
    while editor.undo() {}
    assert_eq!(**editor.scene(), before);
}

#[test]
fn parts_are_renamed_hidden_and_coloured() {
    let mut editor = Editor::new(every_field());
    let balloon = Item::Body("balloon".into());
    let [left, right] = ["left", "right"].map(fibre_item);
    let bar = Item::Body("bar".into());
    for (command, name) in [
        (Command::SetName { item: left.clone(), name: "Rib".into() }, "Rename fibre"),
        (Command::SetName { item: balloon.clone(), name: "Bag".into() }, "Rename body"),
        (Command::SetHidden { items: vec![left.clone(), right.clone()], hidden: false }, "Show 2 fibres"),
        (Command::SetHidden { items: vec![right.clone()], hidden: true }, "Hide fibre"),
        (Command::SetHidden { items: vec![bar.clone(), balloon.clone()], hidden: false }, "Show 2 bodies"),
        (Command::SetColor { items: vec![bar, left, right], color: Some([1, 2, 3]) }, "Colour body and 2 fibres"),
        (Command::SetColor { items: vec![balloon], color: None }, "Colour body"),
    ] {
        editor.apply(&command).expect("a change");
        assert_eq!(editor.undo_name(), Some(name));
    }
    let scene = editor.scene();
    let (bar, balloon) = (&scene.bodies[0], &scene.two_layer[0]);
    let [left, right] = [&bar.fibres[0], &bar.fibres[1]];
    assert_eq!((left.name.as_str(), balloon.name.as_str()), ("Rib", "Bag"));
    assert_eq!([bar.hidden, balloon.hidden, left.hidden, right.hidden], [false, false, false, true]);
    assert_eq!([bar.color, left.color, right.color], [Some([1, 2, 3]); 3]);
    assert_eq!(balloon.color, None);
    for item in [Item::Body("none".into()), fibre_item("none")] {
        for command in [
            Command::SetName { item: item.clone(), name: "x".into() },
            Command::SetHidden { items: vec![item.clone()], hidden: true },
            Command::SetColor { items: vec![item.clone()], color: None },
        ] {
            assert!(matches!(editor.apply(&command), Err(EditError::Missing(_))));
        }
    }
}

#[test]
fn paint_is_set_and_cleared_as_a_whole() {
    let mut editor = Editor::new(every_field());
    let mut paint = editor.scene().bodies[0].paint.clone();
    let dab = Dab::new([0.0; 3], 0.01, 0.5);
    // One drag of the brush, dab by dab.
    for k in 0..5 {
        add_dab(&mut paint, Dab { center: [0.0, 0.001 * f64::from(k), 0.0], ..dab.clone() });
        editor.apply_in(&Command::SetPaint { body: "bar".into(), paint: paint.clone() }, Some(1)).expect("paint");
    }
    assert_eq!((editor.undo_name(), editor.scene().bodies[0].paint.len()), (Some("Paint volume fraction"), 7));
    editor.apply(&Command::SetPaint { body: "bar".into(), paint: Vec::new() }).expect("cleared");
    assert_eq!((editor.undo_name(), editor.scene().bodies[0].paint.len()), (Some("Clear painted fraction"), 0));
    assert!(editor.undo() && editor.scene().bodies[0].paint == paint);
    assert!(editor.undo() && **editor.scene() == every_field() && !editor.undo());
    let wide = Command::SetPaint { body: "bar".into(), paint: vec![Dab { value: 2.0, ..dab }] };
    let refused = editor.apply(&wide).expect_err("out of range").to_string();
    assert!(refused.starts_with("/bodies/0/paint/0/value: 2 is out of range"), "{refused}");
}

#[test]
fn looks_are_no_part_of_the_motion_and_names_are() {
    let before = every_field();
    let mut editor = Editor::new(before.clone());
    let items = vec![Item::Body("bar".into()), Item::Body("balloon".into()), fibre_item("right")];
    editor.apply(&Command::SetHidden { items: items.clone(), hidden: true }).expect("a change");
    editor.apply(&Command::SetColor { items, color: Some([9, 9, 9]) }).expect("a change");
    assert!(**editor.scene() != before && editor.scene().moves_like(&before));
    editor.apply(&Command::SetGravity([0.0, -1.0, 0.0])).expect("a change");
    assert!(!editor.scene().moves_like(&before));
}

#[test]
fn the_history_survives_saving() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.json");
    let mut editor = Editor::new(scene());
    editor.apply(&Command::SetGravity([0.0, -1.0, 0.0])).expect("a change");
    editor.apply(&Command::SetGravity([0.0, -2.0, 0.0])).expect("a change");
    assert!(editor.undo() && editor.is_changed());
    save_scene(&path, editor.scene()).expect("saved");
    editor.mark_saved();
    assert!(!editor.is_changed());
    assert_eq!((editor.undo_name(), editor.redo_name()), (Some("Change gravity"), Some("Change gravity")));
    assert!(editor.redo() && editor.is_changed() && editor.scene().gravity[1] == -2.0);
    assert!(editor.undo() && !editor.is_changed(), "back at what was saved");
    assert!(editor.undo() && editor.is_changed());
    assert_eq!(**editor.scene(), scene());
    assert!(editor.redo() && !editor.is_changed());
    assert_eq!(load_scene(&path).expect("a scene"), **editor.scene());
}
