//! Sheets are drawn by two strokes, chosen, changed, moved and taken away, by pointer and keys.

use super::editing::set;
use super::{Window, button, click, draw, is_settled, press_key, still, stroke, until, view};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use sinew::scene::{Drive, GrainAlong, Sheet, SheetRestShape, SheetSource, SweptStrokes};
use sinew::sketch::View;
use sinew::test_support::ui::App;

fn sheets(app: &App) -> &[Sheet] {
    &app.scene().bodies[0].sheets
}

fn strokes(sheet: &Sheet) -> &SweptStrokes {
    match &sheet.source {
        SheetSource::Strokes(strokes) => strokes,
        other => panic!("not drawn: {other:?}"),
    }
}

fn settle(window: &mut Window) {
    window.step();
    until(window, is_settled);
    window.step();
}

/// Draws a slanted line across the front view and a level one into the side view: a sheet that leans.
fn draw_a_sheet(window: &mut Window) {
    press_key(window, Modifiers::SHIFT, Key::E);
    draw(window, "Front", |s| [0.24 * s - 0.12, 0.1 * s - 0.05]);
    draw(window, "Side", |s| [0.24 * s - 0.12, 0.1]);
    settle(window);
}

fn hover(window: &mut Window, at: Pos2) {
    window.event(Event::PointerMoved(at));
    window.step();
}

fn click_at(window: &mut Window, at: Pos2) {
    hover(window, at);
    button(window, at, PointerButton::Primary, true);
    window.step();
    button(window, at, PointerButton::Primary, false);
    window.step();
    window.step();
}

#[test]
fn two_strokes_sweep_a_sheet_that_is_previewed_and_undone() {
    let mut window = still();
    let fibres = window.state().scene().bodies[0].fibres.len();
    press_key(&mut window, Modifiers::SHIFT, Key::E);
    draw(&mut window, "Front", |s| [0.24 * s - 0.12, 0.1 * s - 0.05]);
    assert!(window.state().message().is_some_and(|text| text.contains("swept")), "{:?}", window.state().message());
    assert_eq!(window.state().swept_preview(), []);
    // While the second stroke grows the surface does, from the first stroke on.
    let path = stroke(view(&window, "Side"), |s| [0.24 * s - 0.12, 0.1]);
    hover(&mut window, path[0]);
    button(&window, path[0], PointerButton::Primary, true);
    window.step();
    let mut grown = Vec::new();
    for &at in &path[1..] {
        window.event(Event::PointerMoved(at));
        window.step();
        grown.push(window.state().swept_preview().len());
    }
    let last = window.state().swept_preview();
    button(&window, path[path.len() - 1], PointerButton::Primary, false);
    window.run_steps(2);
    assert!(grown.is_sorted() && grown[5] > 0 && grown[5] < grown[59], "{grown:?}");
    settle(&mut window);

    let app = window.state();
    let [sheet] = sheets(app) else { panic!("{:?}", app.message()) };
    assert_eq!((strokes(sheet).first.view, strokes(sheet).second.view), (View::Front, View::Side));
    assert_eq!((app.selected_sheet().as_deref(), sheet.name.as_str()), (Some("sheet-1"), "Sheet 1"));
    assert_eq!(app.scene().bodies[0].fibres.len(), fibres, "no fibre was drawn");
    // The solid takes it up where it was previewed.
    let shown = &app.published().at_rest.bodies[0].sheets[0];
    assert!(shown.vertices.len() > 8 && !shown.triangles.is_empty());
    let off = |at: &DVec3| last.iter().map(|seen| seen.distance(*at)).fold(f64::INFINITY, f64::min);
    assert!(shown.vertices.iter().all(|at| off(at) < 2e-3), "it lies elsewhere");

    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(sheets(window.state()).is_empty() && window.state().selected_sheet().is_none());
    press_key(&mut window, Modifiers::COMMAND, Key::Y);
    assert_eq!(sheets(window.state()).len(), 1);
    // The pen of fibres draws fibres again.
    press_key(&mut window, Modifiers::NONE, Key::E);
    draw(&mut window, "Front", |s| [0.0, 0.5 * s - 0.25]);
    draw(&mut window, "Side", |s| [0.05 * s, 0.5 * s - 0.25]);
    assert_eq!((window.state().scene().bodies[0].fibres.len(), sheets(window.state()).len()), (fibres + 1, 1));
}

#[test]
fn strokes_side_by_side_are_refused_and_the_first_waits() {
    let mut window = still();
    press_key(&mut window, Modifiers::SHIFT, Key::E);
    draw(&mut window, "Front", |s| [0.0, 0.4 * s - 0.2]);
    draw(&mut window, "Side", |s| [0.0, 0.4 * s - 0.2]);
    assert!(sheets(window.state()).is_empty());
    assert!(window.state().message().is_some_and(|text| text.contains("side by side")));
    draw(&mut window, "Side", |s| [0.2 * s - 0.1, 0.0]);
    assert_eq!(sheets(window.state()).len(), 1, "{:?}", window.state().message());
}

#[test]
fn what_a_sheet_is_like_is_changed_beside_the_views() {
    let mut window = still();
    draw_a_sheet(&mut window);
    set(&mut window, "Et", "4 kN/m");
    set(&mut window, "Volume fraction", "0.3");
    click(&mut window, "Second");
    click(&mut window, "Flat");
    let sheet = sheets(window.state())[0].clone();
    assert_eq!((sheet.stiffness.et, sheet.volume_fraction, sheet.rest_shape), (4000.0, 0.3, SheetRestShape::Flat));
    let grain = sheet.stiffness.grain.as_ref().expect("a grain");
    assert_eq!((&grain.along, grain.et), (&GrainAlong::Second, 4000.0));
    settle(&mut window);
    assert!(!window.state().published().at_rest.bodies[0].sheets[0].threads.is_empty());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(sheets(window.state())[0].rest_shape, SheetRestShape::AsDrawn);
    window.set_size(Vec2::new(1280.0, 1000.0));
    window.run_steps(3);
    click(&mut window, "Activation");
    window.run_steps(20);
    set(&mut window, "across by", "0.2");
    set(&mut window, "Curls along by", "300");
    let acts = sheets(window.state())[0].activation.clone().expect("it acts");
    assert_eq!((acts.contract, acts.curl_degrees_per_metre), ([0.0, 0.2], [300.0, 0.0]));
    assert_eq!(acts.drive, Drive::Constant(1.0));
    click(&mut window, "Acts no more");
    assert_eq!(sheets(window.state())[0].activation, None);
}

#[test]
fn a_sheet_is_made_a_seam_and_says_what_it_stands() {
    let mut window = still();
    draw_a_sheet(&mut window);
    click(&mut window, "Seam");
    assert_eq!(sheets(window.state())[0].seam.as_ref().map(|seam| seam.stretch), Some(1.3));
    set(&mut window, "Tears past", "1.6");
    assert_eq!(sheets(window.state())[0].seam.as_ref().map(|seam| seam.stretch), Some(1.6));
    // What does not count is not shown.
    assert!(window.query_by_label("Volume fraction").is_none() && window.query_by_label("Flat").is_none());
    settle(&mut window);
    let notes = window.state().published().status.notes.clone();
    assert!(notes.iter().any(|note| note.contains("pairs of neighbours lie across the seam")), "{notes:?}");
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(sheets(window.state())[0].seam, None);
    press_key(&mut window, Modifiers::COMMAND, Key::Y);
    assert!(sheets(window.state())[0].seam.is_some());
    click(&mut window, "Seam");
    assert_eq!(sheets(window.state())[0].seam, None);
    window.get_by_label("Volume fraction");
}

#[test]
fn a_sheet_is_chosen_moved_hidden_copied_and_deleted() {
    let mut window = still();
    draw_a_sheet(&mut window);
    let before = sheets(window.state())[0].clone();
    press_key(&mut window, Modifiers::NONE, Key::W);
    let front = view(&window, "Front");
    click_at(&mut window, front.center() + 0.45 * front.size());
    assert_eq!(window.state().selected_sheet(), None);
    // Seen from the front it is a line; from the side it has a face.
    let side = view(&window, "Side").center();
    click_at(&mut window, side);
    assert_eq!(window.state().selected_sheet().as_deref(), Some("sheet-1"));

    press_key(&mut window, Modifiers::NONE, Key::G);
    press_key(&mut window, Modifiers::NONE, Key::Y);
    window.event(Event::Text("-4".to_owned()));
    window.step();
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    settle(&mut window);
    let moved = sheets(window.state())[0].clone();
    let height = |sheet: &Sheet| strokes(sheet).first.points[0][1];
    assert!((height(&moved) - height(&before) + 0.004).abs() < 1e-9, "{}", height(&moved) - height(&before));
    assert_eq!(window.state().undo_name(), Some("Move Sheet 1"));
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(sheets(window.state())[0], before);
    press_key(&mut window, Modifiers::COMMAND, Key::Y);

    press_key(&mut window, Modifiers::SHIFT, Key::D);
    assert_eq!((sheets(window.state()).len(), window.state().selected_sheet().as_deref()), (2, Some("sheet-2")));
    press_key(&mut window, Modifiers::NONE, Key::Delete);
    assert_eq!((sheets(window.state()).len(), window.state().selected_sheet()), (1, None));
    click(&mut window, "Show Sheet 1");
    assert!(sheets(window.state())[0].hidden);
    press_key(&mut window, Modifiers::ALT, Key::H);
    assert!(!sheets(window.state())[0].hidden);
    let name = window.get_by_label("Sheet 1");
    name.click();
    window.run_steps(2);
    press_key(&mut window, Modifiers::NONE, Key::X);
    assert!(sheets(window.state()).is_empty());
}
