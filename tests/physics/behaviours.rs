//! What a person must see: fibres strengthen, shear and twist what drops on the floor.

use crate::common::*;
use sinew::scene::{Axis, Fibre, MeasureKind, RestShape, Scene, Side, Sticking, Stiffness};
use sinew::solver::MeasureValue;

/// The short bar that drops on its end at 15 m/s, measured by its peaks.
fn dropped(fibres: Vec<Fibre>) -> Scene {
    let mut bar = short_bar(5e7);
    bar.placement.translation = [0.0, 0.0005, 0.0];
    bar.initial.velocity = [0.0, -15.0, 0.0];
    bar.fibres = fibres;
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    let mut scene = in_space(bar);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.room.floor = Some(0.0);
    scene.room.sticking = Sticking::Damper;
    scene.time.frames_per_second = 20_000.0;
    scene.measures = vec![
        measure("loss", MeasureKind::height_loss("top", "bottom", Axis::Y)).at_peak(),
        measure("twist", MeasureKind::twist("top", "bottom", [0.0, 1.0, 0.0])).at_peak(),
        measure("shear", MeasureKind::shear("top", "bottom")).at_peak(),
    ];
    scene
}

fn table_1() -> Stiffness {
    paper(5e5, 2.5e5)
}

/// Four fibres through the bar, at each height turned by `turns` per metre about the axis and leaning by `lean`.
fn four(turns: f64, lean: f64) -> Vec<Fibre> {
    (0..4)
        .map(|k| {
            let vertices = (0..13)
                .map(|i| {
                    let y = 0.003 + 0.0055 * f64::from(i);
                    let angle = std::f64::consts::TAU * (turns * (y - 0.036) + (f64::from(k) + 0.5) / 4.0);
                    [0.0145 * angle.cos() + lean * (y - 0.036), y, 0.0145 * angle.sin()]
                })
                .collect();
            fibre(&format!("f{k}"), vertices, table_1(), 0.25, RestShape::Straight)
        })
        .collect()
}

fn peaks(scene: &Scene) -> (f64, f64, glam::DVec3) {
    let mut runner = runner(scene);
    for _ in 0..50 {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
    match runner.reported_measures()[..] {
        [MeasureValue::Scalar(loss), MeasureValue::Scalar(twist), MeasureValue::Vector(shear)] => (loss, twist, shear),
        ref other => panic!("{other:?}"),
    }
}

#[test]
fn vertical_fibres_stiffen_the_fall() {
    let (without, twist, shear) = peaks(&dropped(Vec::new()));
    let (with, ..) = peaks(&dropped(four(0.0, 0.0)));
    println!("loss without {without:.4}, with {with:.4}");
    assert!((without - 0.08).abs() < 0.01, "{without}");
    assert!(with < 0.04, "{with}");
    assert!(twist.abs() < 1e-6 && shear.length() < 1e-6, "a plain bar neither twists nor shears: {twist} {shear}");
}

#[test]
fn helices_twist_by_their_handedness() {
    let (_, right, _) = peaks(&dropped(four(5.0, 0.0)));
    let (_, left, _) = peaks(&dropped(four(-5.0, 0.0)));
    println!("{right:.4} {left:.4} degrees");
    // A squeezed helix unwinds: fibres that climb clockwise, seen from above, turn the top counter-clockwise.
    assert!(right > 0.5, "{right}");
    assert!((right + left).abs() < 0.02 * right.abs(), "{right} {left}");
}

#[test]
fn slanted_fibres_shear_along_the_slant() {
    let (_, _, right) = peaks(&dropped(four(0.0, 0.25)));
    let (_, _, left) = peaks(&dropped(four(0.0, -0.25)));
    println!("{right} {left} mm");
    // The top goes with the slant: towards +x where the fibres lean to +x.
    assert!(right.x > 0.3 && right.z.abs() < 0.05 * right.x.abs(), "{right}");
    assert!((right.x + left.x).abs() < 0.02 * right.x.abs(), "{right} {left}");
}
