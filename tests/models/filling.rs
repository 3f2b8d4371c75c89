//! Particles inside a mesh: as much volume, none outside, the same for every order of the file.

use crate::shapes::{shuffled, single, solid, sphere, torus, turned};
use glam::{DMat3, DVec3};
use sinew::geometry::Solid;
use sinew::geometry::{FillResolution, fill};

const REACH: f64 = 2.5;

fn filled(solid: &Solid, fineness: FillResolution) -> Vec<DVec3> {
    let filling = fill(solid, fineness, REACH, 2_000_000).expect("a filling");
    let volume = filling.sample.points.len() as f64 * filling.sample.spacing.powi(3);
    assert!((volume / solid.volume - 1.0).abs() < 0.02, "{volume} of {}", solid.volume);
    assert!(filling.sample.points.iter().all(|&point| solid.contains(point)));
    filling.sample.points
}

#[test]
fn volumes_agree_within_two_per_cent() {
    let askew = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize_or_zero(), 0.7);
    for model in [sphere(24, 0.05), torus(48, 24, 0.05, 0.02)] {
        for model in [turned(&model, askew), model] {
            let solid = solid(&model);
            assert!(solid.report.closed && solid.report.findings().is_empty(), "{:?}", solid.report);
            for spacing in [0.004, 0.006, 0.009] {
                filled(&solid, FillResolution::Spacing(spacing));
            }
            for count in [200, 588, 3000] {
                let points = filled(&solid, FillResolution::Particles(count));
                assert!((points.len() as f64 / f64::from(count) - 1.0).abs() < 0.02, "{} for {count}", points.len());
            }
        }
    }
}

#[test]
fn particles_do_not_depend_on_the_order_of_the_file() {
    // A torus turned inside out here and there, one with a hole, and one as it should be.
    let whole = torus(24, 12, 0.05, 0.02);
    let mut muddled = whole.clone();
    muddled.triangles.iter_mut().step_by(7).for_each(|t| t.swap(1, 2));
    let mut faces = whole.triangles.clone();
    faces.drain(100..106);
    let open = single(whole.positions.clone(), faces);
    for model in [whole, muddled, open] {
        let expected = filled(&solid(&model), FillResolution::Spacing(0.006));
        for seed in 1..4 {
            let again = filled(&solid(&shuffled(&model, seed)), FillResolution::Spacing(0.006));
            let same = expected.len() == again.len()
                && expected
                    .iter()
                    .zip(&again)
                    .all(|(a, b)| a.to_array().map(f64::to_bits) == b.to_array().map(f64::to_bits));
            assert!(same, "seed {seed}");
        }
    }
}
