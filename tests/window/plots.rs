//! Readings of the running scene: plotted below the views, written as a table.

use super::{Window, advance, click, hold, open, press_key, reset, scene, until};
use egui::accesskit::Toggled;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use sinew::bake::bake;
use sinew::io::scene_from_json;
use sinew::scene::Assets;
use sinew::sim::{Runner, TimeSeries};
use sinew::test_support::ui::{Action, App};
use sinew::ui::Document;

/// A cube that falls, with two measures in different units.
const CUBE: &str = r#"{"version": 1, "room": {"floor": -5}, "bodies": [{"id": "cube",
    "shape": {"box": {"size": [0.04, 0.04, 0.04]}},
    "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.02},
    "regions": [{"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 1}}}]}],
    "measures": [{"name": "fall", "body": "cube", "kind": {"mean_displacement": {"region": "top"}}},
        {"name": "height", "body": "cube", "kind": {"size": {"axis": "y"}}}]}"#;

fn shown(window: &Window, text: &str) -> bool {
    window.query_all_by_label_contains(text).next().is_some()
}

/// A fifth of a second after the start, held.
fn played() -> Window {
    let mut window = open(scene(CUBE));
    hold(&mut window);
    reset(&mut window);
    for _ in 0..12 {
        advance(&mut window);
    }
    window
}

#[test]
fn the_panel_folds_and_has_a_tab_for_every_unit() {
    let mut window = played();
    assert!(!shown(&window, "Energies"));
    let before = super::view(&window, "Result").height();
    press_key(&mut window, Modifiers::ALT, Key::E);
    window.step();
    assert!(super::view(&window, "Result").height() < before - 150.0);
    for text in ["Energy [J]", "Total", "Kinetic", "Gravity", "Momenta", "Measures [mm]", "Measures [m]"] {
        assert!(shown(&window, text), "{text}");
    }
    // A cube that falls freely has neither fibres nor springs nor contact.
    for text in ["Stretching", "Springs", "Contact"] {
        assert!(!shown(&window, text), "{text}");
    }
    click(&mut window, "Momenta");
    assert!(
        shown(&window, "Linear momentum [kg m/s]") && shown(&window, "Angular momentum about the origin [kg m²/s]")
    );
    click(&mut window, "Measures [m]");
    assert!(shown(&window, "height 0.0") && !shown(&window, "fall "));
    click(&mut window, "Close");
    assert!(!shown(&window, "Energies"));
}

#[test]
fn the_legend_has_present_values_and_leaves_lines_out() {
    let mut window = played();
    press_key(&mut window, Modifiers::ALT, Key::E);
    window.step();
    let time = window.state().published().status.time;
    let mass: f64 = window.state().time_series(|recorded| {
        let row = recorded.world.last().expect("a row");
        let momentum = recorded.world.columns().iter().position(|column| column.name.ends_with(": linear_momentum y"));
        -row[momentum.expect("the column")] / (9.81 * time)
    });
    // A half of m v².
    let kinetic = format!("{:.3}", 0.5 * mass * (9.81 * time).powi(2));
    assert!(shown(&window, &format!("{kinetic} J")), "{kinetic}");
    let kept = |window: &Window| {
        let row = window.get_by_label_contains("Kinetic ");
        row.accesskit_node().toggled()
    };
    assert_eq!(kept(&window), Some(Toggled::True));
    window.get_by_label_contains("Kinetic ").click();
    window.step();
    window.step();
    assert_eq!(kept(&window), Some(Toggled::False));
}

#[test]
fn readings_begin_anew_with_a_reset() {
    let mut window = played();
    let rows = |app: &App| app.time_series(|recorded| recorded.world.len());
    assert!(rows(window.state()) > 10);
    press_key(&mut window, Modifiers::COMMAND, Key::R);
    until(&mut window, |app| rows(app) == 1);
    press_key(&mut window, Modifiers::NONE, Key::Period);
    until(&mut window, |app| rows(app) == 2);
    press_key(&mut window, Modifiers::ALT, Key::E);
    window.step();
    press_key(&mut window, Modifiers::COMMAND, Key::R);
    until(&mut window, |app| rows(app) == 1);
    window.step();
    assert!(shown(&window, "press Play"));
}

#[test]
fn the_table_is_that_of_the_command_line_with_every_frame() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fall.csv");
    let mut window = played();
    press_key(&mut window, Modifiers::ALT, Key::E);
    click(&mut window, "Export as CSV…");
    super::editing::type_path(&mut window, &path);
    let said = window.state().message().unwrap_or_default().to_owned();
    assert!(said.starts_with("Wrote ") && said.contains("fall.csv"), "{said}");
    let scene = scene_from_json(CUBE).expect("a scene");
    let mut runner = Runner::new(bake(&scene, &Assets::default()).expect("it bakes"));
    let mut series = TimeSeries::new(runner.world(), usize::MAX);
    series.push(runner.world());
    while runner.world().time() + 1e-9 < window.state().published().status.time {
        runner.advance_frame();
        series.push(runner.world());
    }
    let expected = String::from_utf8(series.to_csv().expect("a table")).expect("text");
    let written = std::fs::read_to_string(&path).expect("the table");
    assert!(expected.lines().count() > 12);
    assert_eq!(written, expected);
}

#[test]
fn a_table_replaces_a_file_only_after_asking() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fall.csv");
    std::fs::write(&path, "mine").expect("written");
    let mut window = played();
    let ask = |window: &mut Window| {
        let ctx = window.ctx.clone();
        window.state_mut().dispatch(&ctx, Action::Export);
        window.run_steps(3);
        super::editing::type_path(window, &path);
        window.run_steps(3);
        assert!(shown(window, "Replace fall.csv?"));
        assert_eq!(std::fs::read_to_string(&path).expect("the file"), "mine");
    };
    ask(&mut window);
    click(&mut window, "Cancel");
    assert_eq!(std::fs::read_to_string(&path).expect("the file"), "mine");
    ask(&mut window);
    click(&mut window, "Replace");
    assert!(std::fs::read_to_string(&path).expect("the table").starts_with("time"));
}

#[test]
fn a_table_that_cannot_be_written_is_said_and_the_scene_is_no_place_for_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.json");
    std::fs::write(&path, CUBE).expect("written");
    let mut window = open(Document::load(Some(path.clone())).expect("a scene"));
    window.state_mut().export(&folder.path().join("missing").join("r.csv"));
    let said = window.state().message().unwrap_or_default().to_owned();
    assert!(said.contains("missing"), "{said}");
    window.state_mut().export(&path);
    assert!(window.state().message().is_some_and(|said| said.contains("the scene's own file")));
    assert_eq!(std::fs::read_to_string(&path).expect("still there"), CUBE);
    // Unless told otherwise it goes beside the scene.
    let ctx = window.ctx.clone();
    window.state_mut().dispatch(&ctx, Action::Export);
    window.step();
    window.step();
    assert!(shown(&window, "Export readings of every frame"));
}

#[test]
fn what_runs_beside_is_dashed() {
    let mut window = super::still();
    press_key(&mut window, Modifiers::ALT, Key::O);
    until(&mut window, |app| app.published().ghost.is_some());
    for rows in 2..=3 {
        press_key(&mut window, Modifiers::NONE, Key::Period);
        until(&mut window, |app| {
            app.time_series(|recorded| recorded.ghost.as_ref().is_some_and(|ghost| ghost.len() == rows))
        });
    }
    press_key(&mut window, Modifiers::ALT, Key::E);
    window.step();
    assert!(shown(&window, "Dashed: the ghost"));
    let energies = |app: &App| {
        app.time_series(|recorded| {
            let last = |series: &TimeSeries| series.last().expect("a row")[1..10].to_vec();
            [last(&recorded.world), last(recorded.ghost.as_ref().expect("a ghost"))]
        })
    };
    let [world, ghost] = energies(window.state());
    assert!(world[3] > 0.0 && ghost[3] == 0.0, "only the world stretches fibres: {world:?} {ghost:?}");
}
