//! The examples do what they say: each checks itself.

mod box_drop;
mod own_element;
mod own_force;
mod parameter_study;

#[test]
fn a_box_falls_onto_the_floor() {
    box_drop::main().expect("the example runs");
}

#[test]
fn a_structure_of_ones_own_ties_points_of_a_body() {
    own_element::main().expect("the example runs");
}

#[test]
fn a_force_of_ones_own_swings_a_body() {
    own_force::main().expect("the example runs");
}

#[test]
fn a_rod_sags_as_it_is_soft() {
    parameter_study::main().expect("the example runs");
}
