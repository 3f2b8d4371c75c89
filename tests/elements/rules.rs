//! What is said of elements that do not fit where they are drawn.

use crate::E;
use crate::common::*;
use sinew::scene::{Element, ElementLaw, ElementMeasure};

#[test]
fn points_just_outside_are_moved_in_and_far_ones_leave_their_element_out() {
    let rope = |id: &str, top: f64| {
        Element::new(id, ElementMeasure::Length, [[0.0, D, 0.0], [2.0 * D, top * D, 2.0 * D]], ElementLaw::spring(1.0))
    };
    // The block ends at 5 D, its last particles lie at 4.5 D.
    let body = block([4, 5, 4], E).with_element(rope("on the face", 5.0)).with_element(rope("far", 8.0));
    let baked = baked(&in_space(body));
    let elements = &baked.world.bodies()[0].parts().elements;
    assert_eq!(elements.iter().map(|of| of.id.as_str()).collect::<Vec<_>>(), ["on the face"]);
    let notes: Vec<String> = baked.notes.iter().map(ToString::to_string).collect();
    let said = |start: &str, words: &str| notes.iter().any(|note| note.starts_with(start) && note.contains(words));
    assert!(said("/bodies/0/elements/0:", "1 of 2 points lay just outside"), "{notes:?}");
    assert!(said("/bodies/0/elements/1:", "is left out"), "{notes:?}");
}
