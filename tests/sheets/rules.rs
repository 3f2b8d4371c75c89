//! What is said of sheets that cannot be as they were given.

use crate::common::*;
use sinew::bake::Baked;
use sinew::geometry::Kernel;
use sinew::scene::{
    Body, Drive, Falloff, GrainAlong, Scene, Sheet, SheetActivation, SheetStiffness, SweptStrokes, ViewStroke, Wave,
};
use sinew::sketch::View;

const E: f64 = 1e5;

fn stroke(view: View, points: &[[f64; 2]]) -> ViewStroke {
    ViewStroke::new(view, points.iter().copied())
}

/// A level sheet through the middle of a bar, drawn by two strokes, across and deep by `half` spacings to either side.
fn level(half: f64) -> Sheet {
    let (half, y) = (half * D, 6.0 * D);
    let strokes =
        SweptStrokes::new(stroke(View::Front, &[[-half, y], [half, y]]), stroke(View::Side, &[[-half, y], [half, y]]));
    Sheet::swept("s", strokes)
}

fn said(sheet: Sheet) -> (String, Baked) {
    let baked = baked(&in_space(short_bar(E).with_sheet(sheet)));
    let notes: Vec<String> = baked.notes.iter().map(ToString::to_string).collect();
    (notes.join("\n"), baked)
}

#[test]
fn sheets_are_trimmed_left_out_and_warned_of_with_figures() {
    let (notes, baked) = said(level(3.0));
    assert_eq!(notes, "");
    let surface = &baked.world.bodies()[0].parts().sheets[0];
    assert_eq!((surface.vertices.len(), surface.triangles.len(), surface.rim.len()), (49, 72, 1));
    // It sticks out by five spacings on every side: 16 x 16 cells, of which those inside stay.
    let (notes, baked) = said(level(8.0));
    let surface = &baked.world.bodies()[0].parts().sheets[0];
    assert!(notes.contains("triangles lie outside the material") && notes.contains("of 512"), "{notes}");
    assert!((72..=128).contains(&surface.triangles.len()), "{}", surface.triangles.len());
    let (notes, baked) = said(Sheet { source: level(3.0).source, ..Sheet::grid("far", vec![vec![[1.0; 3]; 2]; 2]) });
    assert!(notes.is_empty() && baked.world.bodies()[0].parts().sheets.len() == 1, "{notes}");
    let far =
        Sheet::grid("far", vec![vec![[1.0, 0.0, 0.0], [1.01, 0.0, 0.0]], vec![[1.0, 0.01, 0.0], [1.01, 0.01, 0.0]]]);
    let (notes, baked) = said(far);
    assert!(notes.contains("left out: none of its 2 triangles lies deep enough"), "{notes}");
    assert!(baked.world.bodies()[0].parts().sheets.is_empty());
    let fine =
        (0..3).map(|k| (0..3).map(|i| [1e-3 * f64::from(i), 0.03 + 2e-3 * f64::from(k), 0.0]).collect()).collect();
    let (notes, _) = said(Sheet::grid("fine", fine));
    assert!(notes.contains("left out: a triangle of it has 1.00e-6 m²"), "{notes}");
    let beside = SweptStrokes::new(
        stroke(View::Front, &[[0.0, 0.01], [0.0, 0.06]]),
        stroke(View::Side, &[[0.0, 0.01], [0.0, 0.06]]),
    );
    let (notes, _) = said(Sheet::swept("line", beside));
    assert!(notes.contains("left out: The strokes run side by side"), "{notes}");
    let (notes, _) = said(level(3.0).with_stiffness(SheetStiffness::new(10.0, 0.0)));
    assert!(notes.contains("weakens the solid") && notes.contains("1.200e3 N/m"), "{notes}");
}

#[test]
fn the_matrix_gives_way_by_the_distance_from_the_surface() {
    let energy = |sheets: &[f64], falloff: Falloff| {
        let mut bar = short_bar(E);
        bar.material.volume_fraction_falloff = falloff;
        bar.initial.deformation[1][1] = 1.01;
        bar.sheets = sheets
            .iter()
            .enumerate()
            .map(|(k, &share)| {
                let sheet = level(2.5).with_volume_fraction(share);
                Sheet { id: format!("s{k}"), ..sheet }
            })
            .collect();
        baked(&in_space(bar)).world.bodies()[0].energies(0.0).matrix
    };
    let none = energy(&[], Falloff::Kernel);
    let kernel = energy(&[0.8], Falloff::Kernel);
    assert_eq!(energy(&[0.8, 0.3], Falloff::Kernel), kernel, "the largest counts");
    assert!(kernel > energy(&[0.8], Falloff::Linear));
    // By the definition: the square's nearest point is the place itself, clamped.
    let shares: f64 = baked(&in_space(short_bar(E))).world.bodies()[0]
        .parts()
        .rest
        .iter()
        .map(|x| {
            let away = |at: f64| (at.abs() - 2.5 * D).max(0.0);
            let distance = (away(x.x).powi(2) + (x.y - 6.0 * D).powi(2) + away(x.z).powi(2)).sqrt();
            1.0 - 0.8 * Kernel::new(H).relative(distance)
        })
        .sum();
    assert!((kernel / none - shares / 588.0).abs() < 1e-9, "{} {}", kernel / none, shares / 588.0);
}

fn refused(change: impl Fn(&mut Body)) -> String {
    let mut scene: Scene = in_space(short_bar(E).with_sheet(level(3.0)));
    change(&mut scene.bodies[0]);
    scene.validate().expect_err("a refusal").to_string()
}

#[test]
fn what_cannot_be_is_refused_with_its_place() {
    let sheet = |change: &dyn Fn(&mut Sheet)| refused(|body| change(&mut body.sheets[0]));
    let cases = [
        (sheet(&|of| of.stiffness.et = -1.0), "/bodies/0/sheets/0/stiffness/et"),
        (sheet(&|of| of.stiffness.poisson_ratio = 0.6), "/bodies/0/sheets/0/stiffness/poisson_ratio"),
        (sheet(&|of| of.stiffness.bending = f64::NAN), "/bodies/0/sheets/0/stiffness/bending"),
        (sheet(&|of| of.volume_fraction = 1.5), "/bodies/0/sheets/0/volume_fraction"),
        (
            sheet(&|of| of.stiffness = SheetStiffness::new(1.0, 0.0).with_grain(GrainAlong::Direction([0.0; 3]), 1.0)),
            "/bodies/0/sheets/0/stiffness/grain/along/direction",
        ),
        (
            sheet(&|of| of.activation = Some(SheetActivation::contracting([0.9, 0.0], 1.0))),
            "/bodies/0/sheets/0/activation/contract/0",
        ),
        (
            sheet(&|of| of.activation = Some(SheetActivation::contracting([0.1, 0.0], Drive::Shared("none".into())))),
            "/bodies/0/sheets/0/activation/drive/shared",
        ),
        (
            sheet(&|of| {
                let wave = Wave { wavelength: Some(0.1), ..Wave::new(1.0) };
                of.activation = Some(SheetActivation::contracting([0.1, 0.0], wave));
            }),
            "/bodies/0/sheets/0/activation/drive",
        ),
        (
            sheet(&|of| {
                of.stiffness.bending = 0.0;
                of.activation = Some(SheetActivation::curling([100.0, 0.0], 1.0));
            }),
            "/bodies/0/sheets/0/activation/curl_degrees_per_metre",
        ),
        (sheet(&|of| of.source = Sheet::grid("g", vec![vec![[0.0; 3]; 2]]).source), "/bodies/0/sheets/0/source/grid"),
        (
            sheet(&|of| of.source = Sheet::grid("g", vec![vec![[0.0; 3]; 2], vec![[0.0; 3]; 3]]).source),
            "/bodies/0/sheets/0/source/grid/1",
        ),
        (
            sheet(&|of| of.source = Sheet::of_triangles("t", vec![[0.0; 3]; 3], vec![[0, 1, 3]]).source),
            "/bodies/0/sheets/0/source/triangles/triangles/0",
        ),
        (
            sheet(&|of| {
                let triangles = vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]];
                of.source = Sheet::of_triangles("t", vec![[0.0; 3]; 5], triangles).source;
            }),
            "/bodies/0/sheets/0/source/triangles/triangles/2",
        ),
        (
            sheet(&|of| {
                of.source = Sheet::of_triangles("t", vec![[0.0; 3]; 3], vec![[0, 1, 2]]).source;
                of.activation = Some(SheetActivation::contracting([0.1, 0.0], 1.0));
            }),
            "/bodies/0/sheets/0/activation",
        ),
        (
            sheet(&|of| {
                let again = stroke(View::Front, &[[0.0, 0.0], [0.01, 0.0]]);
                of.source = Sheet::swept("s", SweptStrokes::new(again.clone(), again)).source;
            }),
            "/bodies/0/sheets/0/source/strokes/second/view",
        ),
        (refused(|body| body.sheets.push(level(2.0))), "/bodies/0/sheets/1/id"),
    ];
    for (error, place) in cases {
        assert!(error.starts_with(place) && !error[place.len()..].starts_with('/'), "{error}, not {place}");
    }
}
