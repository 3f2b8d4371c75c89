//! Laws: their energies are integrals of their forces, and a spring is a fibre's edge.

use crate::common::*;
use crate::gradients::{forces, state};
use crate::{E, element_force, stored};
use glam::DVec3;
use sinew::scene::{Element, ElementLaw, ElementMeasure, IntegratorKind, Manual, RestShape, TimeStep};
use sinew::sim::Runner;

/// A block with a rope along its middle.
fn rope(law: ElementLaw) -> (Box<dyn sinew::solver::Force>, Vec<DVec3>) {
    let points = [[0.0, D, 0.0], [0.0, 4.0 * D, 0.0]];
    let body = block([4, 5, 4], E).with_element(Element::new("rope", ElementMeasure::Length, points, law));
    let world = baked(&in_space(body)).world;
    (element_force(&world.bodies()[0]), world.bodies()[0].state().positions.clone())
}

/// Particles stretched along the rope to `s` of its length.
fn stretched(rest: &[DVec3], s: f64) -> Vec<DVec3> {
    rest.iter().map(|x| DVec3::new(x.x, s * x.y, x.z)).collect()
}

#[test]
fn the_energy_of_a_table_is_the_exact_integral_of_its_force_along_any_path() {
    // A law of the note, with its ends held.
    let table = [[0.9, -2.0], [1.0, 0.0], [1.2, 5.0]];
    let (force, rest) = rope(ElementLaw::Table(table.to_vec()));
    let length = 3.0 * D;
    // By hand, piece by piece: trapezia, and rectangles beyond the ends.
    let by_hand = |s: f64| -> f64 {
        length
            * match s {
                _ if s < 0.9 => 0.5 * 2.0 * 0.1 + 2.0 * (0.9 - s),
                _ if s < 1.0 => 0.5 * 20.0 * (1.0 - s).powi(2),
                _ if s < 1.2 => 0.5 * 25.0 * (s - 1.0).powi(2),
                _ => 0.5 * 5.0 * 0.2 + 5.0 * (s - 1.2),
            }
    };
    for s in [0.5, 0.85, 0.9, 0.93, 1.0, 1.05, 1.2, 1.5, 3.0] {
        let found = stored(&*force, 0.0, &stretched(&rest, s)).elements;
        assert!((found - by_hand(s)).abs() < 1e-13 * length.max(by_hand(s)), "{s}: {found} J, not {} J", by_hand(s));
    }
}

#[test]
fn a_table_pulls_as_it_says_and_sideways_only_along_itself() {
    let table = [[0.9, -2.0], [1.0, 0.0], [1.2, 5.0]];
    let (mut force, rest) = rope(ElementLaw::Table(table.to_vec()));
    for (s, expected) in [(0.7, -2.0), (0.95, -1.0), (1.1, 2.5), (1.3, 5.0)] {
        let x = stretched(&rest, s);
        // The force that all particles above the middle feel, times the weights: the pull on the upper point.
        let found = forces(&mut *force, 0.0, &x);
        let work: f64 = found.iter().zip(&rest).map(|(force, rest)| force.y * rest.y).sum();
        // dE/ds = l0 psi'.
        assert!((work + 3.0 * D * expected).abs() < 1e-13, "{s}: {work}");
        assert!(found.iter().all(|force| force.x.abs() < 1e-15 && force.z.abs() < 1e-15));
    }
}

#[test]
fn a_length_under_a_spring_moves_as_a_fibre_of_that_ea() {
    let ea = 20.0 * E * D * D;
    // So little volume that the matrix is what it is without it.
    let share = 1e-9;
    let vertices = vec![[0.0, D, 0.3 * D], [0.0, 2.5 * D, 0.3 * D], [0.0, 4.0 * D, 0.3 * D]];
    let plain = || {
        let mut body = block([4, 5, 4], E);
        body.initial.deformation = [[1.0, 0.1, 0.0], [0.0, 1.1, 0.0], [0.05, 0.0, 1.0]];
        body.integrator = IntegratorKind::LeapFrog.into();
        body
    };
    let threaded =
        plain().with_fibre(fibre("f", vertices.clone(), rigidity(ea / share, 0.0), share, RestShape::Straight));
    let spring = |k: usize| {
        Element::new(format!("e{k}"), ElementMeasure::Length, [vertices[k], vertices[k + 1]], ElementLaw::spring(ea))
    };
    let roped = plain().with_element(spring(0)).with_element(spring(1));
    let run = |body| {
        let mut scene = in_space(body);
        let extra = std::collections::BTreeMap::new();
        scene.time.step = TimeStep::Manual(Manual { dt: 1e-4, substeps_per_frame: 100, extra });
        let mut runner = Runner::new(baked(&scene));
        (0..3).for_each(|_| runner.advance_frame());
        let body = &runner.world().bodies()[0];
        (body.state().positions.clone(), body.energies(runner.world().time()))
    };
    let ((x, of_fibre), (y, of_elements)) = (run(threaded), run(roped));
    let (bare, _) = run(plain());
    let largest = |of: &[DVec3]| of.iter().zip(&y).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    println!("{:.1e} m apart, {:.1e} m from a body without", largest(&x), largest(&bare));
    assert!(largest(&x) < 1e-7 * D && largest(&bare) > 0.02 * D);
    assert!((of_fibre.stretching / of_elements.elements - 1.0).abs() < 1e-5, "{of_fibre:?}\n{of_elements:?}");
}

#[test]
fn a_hinge_may_fold_through_half_a_turn() {
    let points = [[0.0, D, 0.0], [0.0, 4.0 * D, 0.0], [-1.2 * D, 2.5 * D, 0.0], [1.2 * D, 2.5 * D, 0.0]];
    let one = Element::new("hinge", ElementMeasure::Dihedral, points, ElementLaw::spring(1e-3));
    let world = baked(&in_space(block([4, 5, 4], E).with_element(one))).world;
    let mut force = element_force(&world.bodies()[0]);
    let rest = world.bodies()[0].state().positions.clone();
    for degrees in (0..=200).step_by(10) {
        let angle = f64::from(degrees).to_radians();
        // One half is turned about the middle line.
        let turned = |x: &DVec3| {
            if x.x > 0.0 {
                DVec3::new(x.x * angle.cos() - x.z * angle.sin(), x.y, x.x * angle.sin() + x.z * angle.cos())
            } else {
                *x
            }
        };
        let x: Vec<DVec3> = rest.iter().map(turned).collect();
        let before = stored(&*force, 0.0, &x).elements;
        force.end_step(0.0, &state(&x));
        assert_eq!(before, stored(&*force, 0.0, &x).elements, "{degrees}");
        // Points on the line stay in the middle of both halves: half of its angle is what the hinge sees of either.
        assert!(degrees == 0 || before > 0.0, "{degrees}");
    }
    let opened = stored(&*force, 0.0, &rest).elements;
    assert!(opened > 0.5e-3 * (300f64.to_radians()).powi(2), "still as often round: {opened}");
}
