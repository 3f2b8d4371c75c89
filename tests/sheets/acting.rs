//! Sheets that act, and sheets at rest in another shape than they were drawn in.

use crate::common::*;
use sinew::scene::{Body, DriveKeys, Sheet, SheetActivation, SheetRestShape, SheetStiffness, Wave};
use sinew::sim::Runner;

const E: f64 = 1e5;
const LAYERS: [u32; 3] = [4, 9, 4];

/// A slender bar with a sheet beside its axis, on the side of +x.
fn bar(sheet: impl Fn(Sheet) -> Sheet) -> Body {
    let rows = (0..LAYERS[1]).map(|k| {
        let row = (0..4).map(|i| [D, D * (f64::from(k) + 0.5), D * (f64::from(i) - 1.5)]);
        row.collect()
    });
    let stiff = SheetStiffness::new(60.0 * E * D, 0.0);
    block(LAYERS, E).with_sheet(sheet(Sheet::grid("s", rows.collect()).with_stiffness(stiff)))
}

/// Mean x of the ends less that of the middle, over the spacing.
fn bow(runner: &Runner) -> f64 {
    let body = &runner.world().bodies()[0];
    let mean = |which: &dyn Fn(f64) -> bool| {
        let of: Vec<f64> = (0..body.state().len())
            .filter(|&i| which(body.parts().model[i].y / D))
            .map(|i| body.state().positions[i].x)
            .collect();
        of.iter().sum::<f64>() / of.len() as f64
    };
    let top = f64::from(LAYERS[1]) - 1.0;
    (mean(&|y| y < 1.0 || y > top) - mean(&|y| (y - 0.5 * (top + 1.0)).abs() < 0.6)) / D
}

fn run(body: Body, frames: u32) -> Runner {
    let mut scene = in_space(body);
    scene.time.frames_per_second = 100.0;
    let mut runner = Runner::new(baked(&scene));
    for _ in 0..frames {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
    runner
}

#[test]
fn a_sheet_that_becomes_shorter_along_the_bar_bends_it_to_its_side() {
    let drive = || DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]);
    let bent = |contract: [f64; 2]| {
        let mut bar = bar(|sheet| sheet.with_activation(SheetActivation::contracting(contract, drive())));
        bar.material.damping.air = 60.0;
        let bow = bow(&run(bar, 12));
        println!("{contract:?}: bow {bow:.3} D");
        bow
    };
    // Rows run across the bar: its length is the second direction.
    let (shorter, longer, across) = (bent([0.0, 0.2]), bent([0.0, -0.2]), bent([0.2, 0.0]));
    assert!(shorter > 0.5 && longer < -0.4, "{shorter}, {longer}");
    assert!(across < 0.3 * shorter, "{across}");
}

#[test]
fn a_sheet_that_curls_bends_the_bar_as_far_as_both_stiffnesses_have_it() {
    // In the middle of the bar, its length the second direction.
    let rows = (0..LAYERS[1]).map(|k| {
        let row = (0..4).map(|i| [0.0, D * (f64::from(k) + 0.5), D * (f64::from(i) - 1.5)]);
        row.collect()
    });
    let stiff = 200.0 * E * D.powi(3);
    let (wanted, drive) = (0.04 / D, DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]));
    let sheet = Sheet::grid("s", rows.collect())
        .with_stiffness(SheetStiffness::new(0.0, stiff))
        .with_activation(SheetActivation::curling([0.0, wanted.to_degrees()], drive));
    let mut body = block(LAYERS, E).with_sheet(sheet);
    body.material.damping.air = 60.0;
    // The ends lie four layers from the middle: D (4²) kappa / 2. Rows run along +z, and z turned into y looks to -x.
    let found = -bow(&run(body, 12)) / (8.0 * D);
    let (hinges, matrix) = (0.25 * stiff * 3.0 * D, 0.75 * E * (4.0 * D).powi(4) / 12.0);
    let expected = wanted * hinges / (hinges + matrix);
    println!("curvature {:.3} of what both come to", found / expected);
    assert!((found / expected - 1.0).abs() < 0.15, "{found} rad/m, not {expected}");
}

#[test]
fn the_work_of_an_activation_closes_the_balance() {
    let wave = Wave { mean: 0.5, amplitude: 0.5, ..Wave::new(0.04) };
    let acting =
        SheetActivation { curl_degrees_per_metre: [0.0, 800.0], ..SheetActivation::contracting([0.1, 0.25], wave) };
    let mut bar = bar(|sheet| sheet.with_activation(acting.clone()));
    bar.sheets[0].stiffness.bending = 20.0 * E * D.powi(3);
    // One and three quarters of the wave: a good part of what was done is still there.
    let runner = run(bar, 7);
    let energies = runner.world().bodies()[0].energies(runner.world().time());
    let done = -energies.activation;
    println!("{done:.4e} J of the drive, {:.1e} J of them unaccounted for", energies.total());
    assert!(done > 1e-4 && energies.hinges > 0.0, "{energies:?}");
    assert!(energies.total().abs() < 0.02 * done, "{energies:?}");
}

#[test]
fn drawn_sheets_rest_and_flat_ones_pull_flat() {
    let curved = |rest: SheetRestShape| {
        let rows = (0..LAYERS[1]).map(|k| {
            let y = f64::from(k) - 4.0;
            let row = (0..4).map(|i| [D * (0.08 * y * y - 1.0), D * (y + 4.5), D * (f64::from(i) - 1.5)]);
            row.collect()
        });
        let stiff = SheetStiffness::new(0.0, 5.0 * E * D.powi(3));
        let sheet = Sheet::grid("s", rows.collect()).with_stiffness(stiff).with_rest_shape(rest);
        let mut body = block(LAYERS, E).with_sheet(sheet);
        body.material.damping.air = 60.0;
        run(body, 10)
    };
    let drawn = curved(SheetRestShape::AsDrawn);
    let body = &drawn.world().bodies()[0];
    let moved = body.state().positions.iter().zip(body.parts().rest.iter()).map(|(x, rest)| x.distance(*rest));
    assert!(moved.fold(0.0, f64::max) < 1e-12);
    // Drawn as an arc whose ends lie towards +x: to be flat they go to -x.
    let flat = bow(&curved(SheetRestShape::Flat));
    println!("bow {flat:.3} D");
    assert!(flat < -0.1, "{flat}");
}
