//! The packed loops of fibres and sheets keep the contract of elements: one by one they do the same.

use crate::common::*;
use crate::gradients::{deformed, errors, forces};
use crate::{E, stored};
use glam::{DQuat, DVec3};
use sinew::scene::{Activation, Fibre, RestShape, Rigidity, Sheet, SheetStiffness, Wave};
use sinew::solver::{EmbeddingWeights, Force};
use sinew::test_support::solver::{ElementForce, FibreForce, SheetForce, SheetLaw, SheetRest};

fn helix(id: &str, phase: f64, gj: f64, rest: RestShape) -> Fibre {
    let vertices = (0..9).map(|k| {
        let angle = 0.7 * f64::from(k) + phase;
        [1.1 * D * angle.cos(), D * (0.7 + 0.45 * f64::from(k)), 1.1 * D * angle.sin()]
    });
    let mut one = fibre(id, vertices.collect(), rigidity(1.0, 1.0), 0.3, rest);
    one.stiffness = Rigidity::new(40.0 * E * D * D, 5.0 * E * D.powi(4)).with_twisting(gj).into();
    one
}

/// Forces and energies of both, with particles deformed; the time is that at which drives are looked at.
fn same(fast: &mut dyn Force, plain: &mut dyn Force, time: f64, rest: &[DVec3]) {
    let x = deformed(rest);
    let (found, expected) = (forces(fast, time, &x), forces(plain, time, &x));
    let largest = expected.iter().map(|f| f.length()).fold(0.0, f64::max);
    let off = found.iter().zip(&expected).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) / largest;
    let (of_fast, of_plain) = (stored(fast, time, &x).potential(), stored(plain, time, &x).potential());
    println!("forces {off:.1e}, energies {:.1e}", (of_fast / of_plain - 1.0).abs());
    assert!(off < 1e-12, "{off:e}");
    assert!((of_fast / of_plain - 1.0).abs() < 1e-12, "{of_fast} and {of_plain}");
}

#[test]
fn fibres_in_packed_loops_are_their_elements() {
    let gj = 3.0 * E * D.powi(4);
    for (what, fibres) in [
        ("straight", vec![helix("a", 0.0, 0.0, RestShape::Straight), helix("b", 2.0, 0.0, RestShape::Straight)]),
        ("curved", vec![helix("a", 0.0, 0.0, RestShape::AsDrawn), helix("b", 2.0, 0.0, RestShape::AsDrawn)]),
        ("both, twisted", vec![helix("a", 0.0, gj, RestShape::Straight), helix("b", 2.0, gj, RestShape::AsDrawn)]),
    ] {
        println!("{what}");
        let mut body = block([4, 5, 4], E);
        body.fibres = fibres;
        let world = baked(&in_space(body)).world;
        let parts = world.bodies()[0].parts();
        let fast = parts.forces.iter().find_map(|force| force.downcast_ref::<FibreForce>()).expect("fibres");
        let rest = parts.state.positions.clone();
        let mut plain = ElementForce::of_fibres(fast.rests(), 0.0, &rest, DQuat::IDENTITY);
        same(&mut fast.clone(), &mut plain, 0.0, &rest);
        let [gradient, sum, torque] = errors(&mut plain, &deformed(&rest));
        println!("gradient {gradient:.1e}, force {sum:.1e}, torque {torque:.1e}");
        assert!(gradient < 2e-9 && sum < 1e-14 && torque < 1e-14);
    }
}

#[test]
fn fibres_that_act_are_their_elements_at_any_time() {
    let wave = Wave { mean: 0.5, amplitude: 0.4, wavelength: Some(3.0 * D), ..Wave::new(0.05) };
    let act = Activation {
        curl: Activation::curling(300.0, [0.0, 0.0, 1.0], 0.0).curl,
        muscle: Activation::pulling(0.5, 0.0).muscle,
        twist: Activation::twisting(900.0, 0.0).twist,
        ..Activation::contracting(0.3, wave)
    };
    let mut body = block([4, 5, 4], E).with_fibre(helix("a", 0.0, 3.0 * E * D.powi(4), RestShape::AsDrawn));
    body.fibres[0].activation = Some(act);
    let world = baked(&in_space(body)).world;
    let parts = world.bodies()[0].parts();
    let fast = parts.forces.iter().find_map(|force| force.downcast_ref::<FibreForce>()).expect("fibres");
    let rest = parts.state.positions.clone();
    for time in [0.0, 0.06, 0.071, 0.083] {
        let mut plain = ElementForce::of_fibres(fast.rests(), time, &rest, DQuat::IDENTITY);
        same(&mut fast.clone(), &mut plain, time, &rest);
    }
}

#[test]
fn sheets_in_loops_are_their_elements() {
    let x: Vec<DVec3> =
        (0..12).map(|k| DVec3::new(f64::from(k % 4), f64::from(k / 4), 0.1 * f64::from(k % 3))).collect();
    let vertices = (0..12).map(|k| EmbeddingWeights { weights: vec![(k, 1.0)] }).collect();
    let cell = |k: u32| [[k, k + 1, k + 4], [k + 1, k + 5, k + 4]];
    let ways = [DVec3::X, DVec3::new(1.0, 0.6, 0.0)];
    let triangles: Vec<_> = [0, 1, 2, 4, 5, 6].into_iter().flat_map(cell).map(|of| (of, ways)).collect();
    let law = SheetLaw { et: 40.0, poisson_ratio: 0.4, bending: 3.0, grain: 25.0, volume_fraction: 0.4 };
    let sheets = [SheetRest::new(vertices, &x, &triangles, law, |_, _| false)];
    let mut plain = ElementForce::of_sheets(&sheets, &x);
    let moved: Vec<DVec3> = x.iter().enumerate().map(|(k, x)| *x * 1.2 + 0.3 * wobble(k, 5)).collect();
    let mut fast = SheetForce::new(sheets.into());
    let (found, expected) = (forces(&mut fast, 0.0, &moved), forces(&mut plain, 0.0, &moved));
    let largest = expected.iter().map(|f| f.length()).fold(0.0, f64::max);
    assert!(found.iter().zip(&expected).all(|(a, b)| a.distance(*b) < 1e-13 * largest));
    let (of_fast, of_plain) = (stored(&fast, 0.0, &moved).potential(), stored(&plain, 0.0, &moved).potential());
    assert!((of_fast / of_plain - 1.0).abs() < 1e-13 && of_fast > 1.0);
    assert!(plain.couplings().len() > triangles.len());
}

#[test]
fn a_scene_with_a_sheet_has_no_elements_of_its_own() {
    let sheet = Sheet::grid("s", vec![vec![[0.0, D, -D], [0.0, D, D]], vec![[0.0, 4.0 * D, -D], [0.0, 4.0 * D, D]]])
        .with_stiffness(SheetStiffness::new(10.0, 0.0));
    let world = baked(&in_space(block([4, 5, 4], E).with_sheet(sheet))).world;
    assert!(world.bodies()[0].parts().forces.iter().all(|force| force.name() != "elements"));
}
