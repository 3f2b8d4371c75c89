//! Elements of a body stand in its tab, and are taken out there.

use super::drives::one_step;
use super::{Window, hold, is_settled, open, press_key, scene, until};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use sinew::scene::{Drivable, Drive};

const ROPES: &str = r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{
    "id": "cube", "shape": {"box": {"size": [0.06, 0.06, 0.06]}},
    "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.03},
    "elements": [
        {"id": "Cord", "measure": "length", "points": [[0, -0.02, 0], [0, 0.02, 0]], "law": {"spring": {"stiffness": 150}}},
        {"id": "Sinew", "measure": "length", "points": [[0.01, -0.02, 0], [0.01, 0.02, 0]],
         "law": {"table": [[0.9, -2], [1, 0], [1.2, 5]]}},
        {"id": "Far", "measure": "length", "points": [[0.01, -0.02, 0], [0.01, 0.2, 0]],
         "law": {"tension_only": {"stiffness": 5}}}
    ]}]}"#;

fn ids(window: &Window) -> Vec<String> {
    window.state().scene().bodies[0].elements.iter().map(|element| element.id.clone()).collect()
}

#[test]
fn elements_are_listed_with_what_they_are_and_one_is_removed_and_comes_back() {
    let mut window = open(scene(ROPES));
    hold(&mut window);
    until(&mut window, is_settled);
    window.run_steps(2);
    let said = ["length: spring of 150 N", "length: table of 3 points", "length: 5 N, pulled only"];
    for text in ["Elements", "Cord", "Sinew", "Far", "outside"].into_iter().chain(said) {
        assert_eq!(window.query_all_by_label(text).count(), 1, "{text}");
    }
    let shown = window.state().published().at_rest.bodies[0].elements.len();
    assert_eq!(shown, 2, "the one that lies outside does nothing");
    window.get_all_by_label("Remove").next().expect("a button").click();
    window.run_steps(2);
    assert_eq!(ids(&window), ["Sinew", "Far"]);
    assert_eq!(window.state().undo_name(), Some("Change elements"));
    assert!(window.query_by_label("Cord").is_none());
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(ids(&window), ["Cord", "Sinew", "Far"]);
}

#[test]
fn an_element_acts_once_its_number_is_typed_and_is_keyed_beside_it() {
    let mut window = open(scene(ROPES));
    hold(&mut window);
    until(&mut window, is_settled);
    window.run_steps(2);
    let acts = |window: &Window| window.state().scene().bodies[0].elements[0].activation.clone();
    assert_eq!(acts(&window), None);
    // The first of the fields is the first element's.
    one_step(&mut window, "Change elements", |window| {
        let field = window.get_all_by_label("Contracts by").find(|node| node.value().is_some());
        let at = field.expect("a field").rect().center();
        super::drives::click_at(window, at);
        window.run_steps(2);
        press_key(window, Modifiers::COMMAND, Key::A);
        window.event(egui::Event::Text("0.25".to_owned()));
        window.step();
        press_key(window, Modifiers::NONE, Key::Enter);
    });
    assert_eq!(acts(&window).map(|acts| (acts.contract, acts.drive)), Some((0.25, Drive::Constant(1.0))));
    let of = Drivable::Element { body: "cube".into(), element: "Cord".into() };
    let name = format!("Set a key of {}", of.title(window.state().scene()));
    one_step(&mut window, "Set key", |window| window.get_by_label(&name).click());
    assert!(matches!(of.drive(window.state().scene()), Some(Drive::Keyframes(keys)) if keys.keys.len() == 1));
    one_step(&mut window, "Change elements", |window| {
        window.get_all_by_label("Acts no more").next().expect("a button").click();
    });
    assert_eq!(acts(&window), None);
}
