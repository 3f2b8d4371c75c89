//! Balls, cylinders, capsules and tori are filled as what they are, and a body that is scaled is filled by as many
//! particles.

use glam::DVec3;
use sinew::bake::bake;
use sinew::edit::body_ops::{moved, scaled, turned};
use sinew::scene::*;
use sinew::sim::Runner;
use std::f64::consts::FRAC_PI_2;

fn runner(body: &OwnedBody) -> Runner {
    let mut scene = Scene::new("Round").with_gravity([0.0; 3]);
    match body {
        OwnedBody::Solid(body) => scene.bodies.push((**body).clone()),
        OwnedBody::TwoLayer(body) => scene.two_layer.push((**body).clone()),
    }
    scene.validate().unwrap();
    Runner::new(bake(&scene, &Assets::default()).unwrap())
}

fn positions(runner: &Runner) -> &[DVec3] {
    &runner.world().bodies()[0].state().positions
}

fn soft(shape: impl Into<Shape>) -> Body {
    Body::new("body", shape).with_material(Material::new(1e5, 0.33, 1000.0).with_support_radius(0.01))
}

#[test]
fn round_bodies_are_filled_as_what_they_are() {
    let shapes: [Shape; 4] = [
        BallShape::new(0.03).into(),
        CylinderShape::new(0.02, 0.06).into(),
        CapsuleShape::new(0.018, 0.03).into(),
        TorusShape::new(0.03, 0.012).into(),
    ];
    for shape in shapes {
        let (volume, size) = (shape.volume().unwrap(), DVec3::from_array(shape.size().unwrap()));
        let runner = runner(&soft(shape.clone()).into());
        let body = &runner.world().bodies()[0];
        assert!((body.state().mass() / (1000.0 * volume) - 1.0).abs() < 1e-9, "{shape:?}");
        let at = positions(&runner);
        let middle = at.iter().sum::<DVec3>() / at.len() as f64;
        assert!(middle.length() < 0.02 * size.max_element(), "{shape:?}: {middle}");
        let (low, high) = at.iter().fold((DVec3::MAX, DVec3::MIN), |(low, high), &at| (low.min(at), high.max(at)));
        // The outermost particles lie half a spacing within.
        let error = ((high - low) - (size - DVec3::splat(0.004))).abs().max_element();
        assert!(error < 1.1 * 0.004, "{shape:?}: {low} {high}");
        // About the axis, m r²/2 and its like: what is said of the shape, not of its box.
        let about_y = at.iter().map(|at| at.x * at.x + at.z * at.z).sum::<f64>() / at.len() as f64;
        let theory = match &shape {
            Shape::Ball(of) => 0.4 * of.radius.powi(2),
            Shape::Cylinder(of) => 0.5 * of.radius.powi(2),
            Shape::Torus(of) => of.radius.powi(2) + 0.75 * of.tube_radius.powi(2),
            _ => continue,
        };
        assert!((about_y / theory - 1.0).abs() < 0.05, "{shape:?}: {about_y} instead of {theory}");
    }
}

#[test]
fn a_torus_without_a_hole_and_a_ball_of_no_size_are_refused() {
    for (shape, at) in [
        (Shape::from(TorusShape::new(0.02, 0.02)), "/bodies/0/shape/torus/tube_radius"),
        (BallShape::new(0.0).into(), "/bodies/0/shape/ball/radius"),
        (CapsuleShape::new(0.02, -1.0).into(), "/bodies/0/shape/capsule/height"),
        (CylinderShape::new(f64::NAN, 1.0).into(), "/bodies/0/shape/cylinder/radius"),
    ] {
        let said = Scene::new("Odd").with_body(soft(shape)).validate().unwrap_err().to_string();
        assert!(said.starts_with(at), "{said}");
    }
    let huge = soft(BallShape::new(10.0));
    let said = Scene::new("Huge").with_body(huge).validate().unwrap_err().to_string();
    assert!(said.contains("million particles"), "{said}");
}

#[test]
fn what_is_in_a_body_goes_along_as_it_is_moved_turned_and_scaled() {
    let fibre = Fibre::through("fibre", [[0.0, -0.02, 0.0], [0.0, 0.0, 0.0], [0.0, 0.02, 0.0]])
        .with_stiffness(Rigidity::new(100.0, 1e-4));
    let turn = Turn::new([0.0, 1.0, 0.0], 90.0, 1.0).with_origin([0.1, 0.0, 0.0]);
    let body: OwnedBody = soft(CylinderShape::new(0.02, 0.06))
        .with_fibre(fibre)
        .with_region(Region::in_sphere("tip", [0.0, 0.03, 0.0], 0.012))
        .with_pin(Pin::new("pin", "tip").with_motion(turn))
        .into();
    let before = runner(&body);
    let large = scaled(&body, DVec3::ZERO, 2.0).unwrap();
    let after = runner(&large);
    let far = |a: &DVec3, b: &DVec3| (2.0 * *a).distance(*b);
    assert_eq!(positions(&before).len(), positions(&after).len());
    let error = positions(&before).iter().zip(positions(&after)).map(|(a, b)| far(a, b)).fold(0.0, f64::max);
    assert!(error < 1e-9, "{error}");
    let OwnedBody::Solid(solid) = &large else { panic!("a solid") };
    assert_eq!(solid.regions, [Region::in_sphere("tip", [0.0, 0.06, 0.0], 0.024)], "the pin holds what it held");
    assert_eq!(solid.material.young_modulus, 1e5);
    assert_eq!(solid.fibres[0].stiffness, Stiffness::Rigidity(Rigidity::new(400.0, 1.6e-3)));

    // Turned and moved, every particle is where a rigid motion takes it, and so is the axis of the pin.
    let quarter = turned(&moved(&body, DVec3::X), DVec3::X, DVec3::Z, FRAC_PI_2).unwrap();
    let after = runner(&quarter);
    let there = |at: DVec3| DVec3::X + DVec3::new(-at.y, at.x, at.z);
    let error =
        positions(&before).iter().zip(positions(&after)).map(|(a, b)| there(*a).distance(*b)).fold(0.0, f64::max);
    assert!(error < 1e-9, "{error}");
    let Motion::Turn(turn) = &quarter.view().pins()[0].motion else { panic!("a turn") };
    let [axis, origin] = [turn.axis, turn.origin.unwrap()].map(DVec3::from_array);
    assert!(axis.distance(DVec3::NEG_X) < 1e-9 && origin.distance(DVec3::new(1.0, 0.1, 0.0)) < 1e-9, "{axis} {origin}");
    assert!(scaled(&body, DVec3::ZERO, 0.0).is_err() && turned(&body, DVec3::ZERO, DVec3::ZERO, 1.0).is_err());
}

#[test]
fn a_two_layer_body_of_another_size_sags_by_the_same_share_of_it() {
    let sag = |factor: f64| {
        let ball = TwoLayer { air_drag: 3.0, ..TwoLayer::ball("ball") }.with_translation([0.0, 2.1, 0.0]);
        let OwnedBody::TwoLayer(ball) = scaled(&ball.into(), DVec3::ZERO, factor).unwrap() else { panic!("layers") };
        let scene = Scene::new("Ball").with_floor(0.0).with_two_layer(*ball);
        let mut runner = Runner::new(bake(&scene, &Assets::default()).unwrap());
        // Times go with the root of the size.
        while runner.world().time() < 2.0 * factor.sqrt() {
            runner.advance_frame();
        }
        let at = positions(&runner);
        let [low, high] = at.iter().fold([f64::MAX, f64::MIN], |[low, high], at| [low.min(at.y), high.max(at.y)]);
        (high - low) / factor
    };
    let (paper, small) = (sag(1.0), sag(0.0625));
    assert!((small / paper - 1.0).abs() < 0.05 && paper > 1.0, "{paper} and {small}");
}

#[test]
fn particles_of_round_bodies_stand_for_what_is_inside_of_their_cells() {
    let shapes: [Shape; 4] = [
        BallShape::new(0.011).into(),
        CylinderShape::new(0.0085, 0.04).into(),
        CapsuleShape::new(0.009, 0.03).into(),
        TorusShape::new(0.03, 0.0085).into(),
    ];
    for shape in shapes {
        let volume = shape.volume().unwrap();
        let mut scene = Scene::new("Round").with_gravity([0.0; 3]).with_body(soft(shape.clone()));
        scene.measures = vec![Measure::new("volume", "body", MeasureKind::Volume)];
        let runner = Runner::new(bake(&scene, &Assets::default()).unwrap());
        let [filled] = runner.world().measures()[..] else { panic!("one") };
        let sinew::solver::MeasureValue::Scalar(filled) = filled else { panic!("a number") };
        // Its surface is made of flat faces.
        assert!((filled / volume - 1.0).abs() < 0.02, "{shape:?}: {filled} of {volume}");
        let state = runner.world().bodies()[0].state();
        assert!((state.mass() / (1000.0 * volume) - 1.0).abs() < 1e-9, "{shape:?}");
        let [least, most] = [f64::min, f64::max].map(|of| state.masses.iter().copied().reduce(of).unwrap());
        assert!(least < 0.95 * most, "{shape:?}: particles that are all alike, {least} to {most}");
        let middle = state.positions.iter().zip(&state.masses).map(|(at, mass)| *at * *mass).sum::<DVec3>();
        assert!(middle.length() / state.mass() < 4e-5, "{shape:?}: {middle}");
        // About the axis, that of a cell included.
        let moment = |(at, mass): (&DVec3, &f64)| mass * (at.x * at.x + at.z * at.z);
        let about_y = state.positions.iter().zip(&state.masses).map(moment).sum::<f64>() / state.mass();
        let theory = match &shape {
            Shape::Ball(of) => 0.4 * of.radius.powi(2),
            Shape::Cylinder(of) => 0.5 * of.radius.powi(2),
            Shape::Torus(of) => of.radius.powi(2) + 0.75 * of.tube_radius.powi(2),
            _ => continue,
        };
        let ratio = (about_y + 0.004_f64.powi(2) / 6.0) / theory;
        assert!((ratio - 1.0).abs() < 0.05, "{shape:?}: {ratio}");
    }
}

#[test]
fn a_round_body_is_strained_evenly_by_a_linear_displacement_and_not_at_all_by_a_turn() {
    let runner = |deformation: [[f64; 3]; 3]| {
        let mut body = soft(CapsuleShape::new(0.009, 0.03));
        body.initial.deformation = deformation;
        body.regions = vec![
            Region::in_sphere("all", [0.0; 3], 1.0),
            Region::in_sphere("top", [0.0, 0.024, 0.0], 0.006),
            Region::in_sphere("side", [0.009, 0.0, 0.0], 0.004),
        ];
        let mut scene = Scene::new("Round").with_gravity([0.0; 3]).with_body(body);
        let stress = |region: &str| Measure::new(region, "body", MeasureKind::stress(region, Some([0.0, 1.0, 0.0])));
        scene.measures = ["all", "top", "side"].map(stress).to_vec();
        scene.validate().unwrap();
        Runner::new(bake(&scene, &Assets::default()).unwrap())
    };
    let strained = runner([[1.002, 0.0, 0.0], [0.0, 0.99, 0.0], [0.0, 0.0, 1.003]]);
    let [lambda, mu] = [1e5 * 0.33 / (1.33 * 0.34), 1e5 / (2.0 * 1.33)];
    let theory = 2.0 * mu * -0.01 + lambda * (0.002 - 0.01 + 0.003);
    for stress in strained.world().measures() {
        let sinew::solver::MeasureValue::Scalar(stress) = stress else { panic!("a number") };
        assert!((stress / theory - 1.0).abs() < 1e-6, "{stress} Pa, not {theory}");
    }
    let (sine, cosine) = 0.7_f64.sin_cos();
    let mut turned = runner([[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]]);
    let before = positions(&turned).to_vec();
    for _ in 0..10 {
        turned.advance_frame();
    }
    let moved = positions(&turned).iter().zip(&before).map(|(now, before)| now.distance(*before)).fold(0.0, f64::max);
    assert!(moved < 1e-9, "{moved} m");
}
