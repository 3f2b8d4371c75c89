//! A flat grid of hinges bends alike in all directions.

use crate::gradients::{NOTHING, bare, energies};
use glam::DVec3;
use sinew::test_support::solver::{SheetForce, SheetLaw};
use std::sync::Arc;

const BENDING: f64 = 0.7;
/// Radius of curvature, in cells.
const RADIUS: f64 = 1e4;

/// Bending energy of a grid of cells `size` large, flat at rest and shaped by `shape` now.
fn energy(columns: usize, rows: usize, size: [f64; 2], shape: &dyn Fn([f64; 2]) -> DVec3) -> f64 {
    let points: Vec<[f64; 2]> =
        (0..columns * rows).map(|k| [(k % columns) as f64 * size[0], (k / columns) as f64 * size[1]]).collect();
    let flat: Vec<DVec3> = points.iter().map(|&[u, v]| DVec3::new(u, v, 0.0)).collect();
    let bent: Vec<DVec3> = points.iter().map(|&at| shape(at)).collect();
    let law = SheetLaw { bending: BENDING, ..NOTHING };
    let force = SheetForce::new(Arc::new([bare(&flat, columns, law, [DVec3::X; 2])]));
    energies(&force, &bent).hinges
}

/// Bending energy of a cell far from any rim, over that of a plate of stiffness `BENDING` in which both curvatures have
/// these squares in sum.
fn of_plate(size: [f64; 2], squares: f64, shape: &dyn Fn([f64; 2]) -> DVec3) -> f64 {
    let at = |columns: usize, rows: usize| energy(columns, rows, size, shape);
    // What grows with the area alone, whatever the rims do; diagonals come again after two cells.
    let cells = at(9, 9) - at(7, 9) - at(9, 7) + at(7, 7);
    cells / 4.0 / (0.5 * BENDING * squares * size[0] * size[1])
}

#[test]
fn cylinders_about_any_direction_have_one_stiffness() {
    for size in [[1.0, 1.0], [1.0, 1.5], [1.0, 2.0]] {
        for eighth in 0..7 {
            let degrees = 22.5 * f64::from(eighth);
            let (sin, cos) = degrees.to_radians().sin_cos();
            let cylinder = |[u, v]: [f64; 2]| {
                let (along, around) = (u * cos + v * sin, (v * cos - u * sin) / RADIUS);
                DVec3::new(along, RADIUS * around.sin(), RADIUS * (1.0 - around.cos()))
            };
            let ratio = of_plate(size, RADIUS.powi(-2), &cylinder);
            println!("{size:?}, {degrees} degrees: {ratio:.5}");
            assert!((ratio - 1.0).abs() < 1e-3, "{size:?}, {degrees} degrees: {ratio}");
        }
    }
}

#[test]
fn saddles_and_spheres_have_the_sum_of_both() {
    for (what, sign) in [("sphere", 1.0), ("saddle", -1.0)] {
        let shape = |[u, v]: [f64; 2]| DVec3::new(u, v, 0.5 * (u * u + sign * v * v) / RADIUS);
        let ratio = of_plate([1.0, 1.0], 2.0 * RADIUS.powi(-2), &shape);
        println!("{what}: {ratio:.5}");
        assert!((ratio - 1.0).abs() < 5e-3, "{what}: {ratio}");
    }
}
