//! What is said about models that are not as they should be, and what is done.

use crate::shapes::{joined, moved, single, solid, sphere, torus};
use glam::DVec3;
use sinew::geometry::Model;
use sinew::geometry::Refusal;
use sinew::geometry::Solid;
use sinew::geometry::{FillError, FillResolution, fill};

fn findings(model: &Model) -> Vec<String> {
    solid(model).report.findings().iter().map(ToString::to_string).collect()
}

fn says(model: &Model, text: &str) {
    let found = findings(model);
    assert!(found.iter().any(|line| line.contains(text)), "no {text:?} in {found:?}");
}

/// Whether a repaired model holds as much as the sound one.
fn holds_as_much(damaged: &Model, sound: &Model, tolerance: f64) {
    let (damaged, sound) = (solid(damaged).volume, solid(sound).volume);
    assert!((damaged / sound - 1.0).abs() < tolerance, "{damaged} instead of {sound}");
}

#[test]
fn holes_are_counted_and_bridged_by_the_winding_number() {
    let sound = sphere(24, 0.05);
    let mut faces = sound.triangles.clone();
    // Two holes: four faces around a pole, and one face elsewhere.
    faces.retain(|t| !(t.contains(&0) && t[1] < 10));
    faces.remove(800);
    let open = single(sound.positions.clone(), faces);
    says(&open, "2 holes with ");
    says(&open, "not closed: inside and outside are told apart by the winding number, 0 % of the inside in doubt");
    holds_as_much(&open, &sound, 0.02);
    let open = solid(&open);
    assert!(open.contains(DVec3::ZERO) && !open.contains(DVec3::new(0.0, 0.0, 0.08)));
    let filling = fill(&open, FillResolution::Particles(2000), 2.5, 100_000).unwrap();
    assert!(filling.volume_error.abs() < 0.02);
}

#[test]
fn surfaces_that_enclose_nothing_are_refused_with_the_reason() {
    let sound = sphere(24, 0.05);
    let keep = |most: f64| {
        let center = |t: &&[u32; 3]| t.iter().map(|&i| sound.positions[i as usize].z).sum::<f64>() / 3.0 < most;
        single(sound.positions.clone(), sound.triangles.iter().filter(center).copied().collect())
    };
    let bowl = Solid::new(&keep(-0.01)).unwrap_err();
    assert!(matches!(bowl, Refusal::TooOpen { holes: 1, .. }), "{bowl}");
    assert!(bowl.to_string().contains("too open to tell its inside from its outside"), "{bowl}");
    let sheet = single(vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y], vec![[0, 1, 2], [1, 3, 2]]);
    let sheet = Solid::new(&sheet).unwrap_err();
    assert!(sheet.to_string().contains("encloses nothing"), "{sheet}");
    assert_eq!(Solid::new(&Model::default()).unwrap_err(), Refusal::NoFaces { lost_faces: 0 });
}

#[test]
fn faces_and_pieces_that_look_the_wrong_way_are_turned() {
    let sound = sphere(16, 0.05);
    let mut inverted = sound.clone();
    inverted.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    says(&inverted, "1 piece inside out: turned round");
    holds_as_much(&inverted, &sound, 1e-12);
    let mut muddled = sound.clone();
    muddled.triangles.iter_mut().step_by(5).for_each(|t| t.swap(1, 2));
    says(&muddled, "faces turned round to agree with their neighbours");
    holds_as_much(&muddled, &sound, 1e-12);
}

#[test]
fn faces_that_add_nothing_are_left_out() {
    let sound = sphere(16, 0.05);
    let mut model = sound.clone();
    model.triangles.extend([[3, 3, 4], sound.triangles[7], sound.triangles[9]]);
    model.parts[0].triangles.end += 3;
    says(&model, "1 face of zero size left out");
    says(&model, "2 faces left out as duplicates");
    holds_as_much(&model, &sound, 1e-12);
    // Both sides of every face, as some programs export what is to be seen from both.
    let mut both = sound.clone();
    both.triangles.extend(sound.triangles.iter().map(|&[a, b, c]| [a, c, b]));
    both.parts[0].triangles.end *= 2;
    holds_as_much(&both, &sound, 1e-12);
}

#[test]
fn vertices_that_are_no_numbers_take_their_faces_with_them() {
    let sound = sphere(24, 0.05);
    let mut model = sound.clone();
    model.positions[300].y = f64::NAN;
    model.positions[500].z = f64::INFINITY;
    says(&model, "2 vertices without a usable position: the 12 faces at them left out");
    holds_as_much(&model, &sound, 0.02);
    let mut lost = sound;
    lost.positions.iter_mut().for_each(|p| p.x = f64::NAN);
    assert!(matches!(Solid::new(&lost), Err(Refusal::NoFaces { lost_faces: 2304 })));
}

#[test]
fn seams_are_welded_even_when_they_gape_a_little() {
    let sound = sphere(16, 0.05);
    // Every face on its own, as in an STL; then with corners that are off by a hair.
    let split: Vec<DVec3> = sound.triangles.iter().flatten().map(|&i| sound.positions[i as usize]).collect();
    let faces = |n: usize| (0..n as u32 / 3).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect::<Vec<_>>();
    let soup = single(split.clone(), faces(split.len()));
    assert!(findings(&soup).is_empty());
    let torn: Vec<DVec3> = split.iter().enumerate().map(|(k, &p)| p * (1.0 + 1e-7 * (k % 5) as f64)).collect();
    let torn = single(torn, faces(split.len()));
    says(&torn, "points welded to close gaps");
    assert!(solid(&torn).report.closed);
}

#[test]
fn parts_that_overlap_are_filled_once_and_cavities_stay_empty() {
    let ball = sphere(24, 0.05);
    let pair = joined(&[&ball, &moved(&ball, DVec3::new(0.05, 0.003, 0.002))]);
    says(&pair, "pairs of faces pass through each other");
    let one = solid(&ball).volume;
    // Two balls half a diameter apart have 27/16 of the volume of one.
    assert!((solid(&pair).volume / one - 27.0 / 16.0).abs() < 0.01);

    let mut small = sphere(16, 0.02);
    let nested = joined(&[&ball, &small]);
    says(&nested, "1 piece within another, filled once");
    assert!((solid(&nested).volume / one - 1.0).abs() < 0.005);
    small.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    let hollow = joined(&[&ball, &small]);
    says(&hollow, "1 cavity kept empty");
    assert!((solid(&hollow).volume - (one - solid(&sphere(16, 0.02)).volume)).abs() < 1e-12);
    assert!(!solid(&hollow).contains(DVec3::ZERO));
    // The same inside out as a whole.
    let mut inverted = hollow.clone();
    inverted.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    holds_as_much(&inverted, &hollow, 1e-12);
}

#[test]
fn edges_of_more_than_two_faces_are_counted() {
    // Two tetrahedra that share an edge.
    let positions = vec![
        DVec3::ZERO,
        DVec3::Z,
        DVec3::new(1.0, 0.0, 0.0),
        DVec3::new(0.5, 1.0, 0.0),
        DVec3::new(-1.0, 0.0, 0.0),
        DVec3::new(-0.5, -1.0, 0.0),
    ];
    let tetrahedron = |a: u32, b: u32, c: u32, d: u32| [[a, b, c], [a, c, d], [a, d, b], [b, d, c]];
    let faces = [tetrahedron(0, 1, 2, 3), tetrahedron(0, 1, 4, 5)].concat();
    let model = single(positions, faces);
    says(&model, "1 non-manifold edge (of more than two faces)");
    assert!(solid(&model).report.closed);
    assert!((solid(&model).volume - 2.0 / 6.0).abs() < 0.01);
}

#[test]
fn a_sheet_too_thin_names_the_spacing_that_gives_two_layers() {
    let flat = torus(64, 16, 0.06, 0.02);
    let mut sheet = flat.clone();
    sheet.positions.iter_mut().for_each(|p| p.z *= 0.15);
    let sheet = solid(&sheet);
    let Err(FillError::TooThin { suggested: Some(spacing), .. }) =
        fill(&sheet, FillResolution::Spacing(0.009), 2.5, 2_000_000)
    else {
        panic!("too thin")
    };
    let filling = fill(&sheet, FillResolution::Spacing(spacing), 2.5, 2_000_000).unwrap();
    let thin = filling.thinness.single + filling.pruned;
    assert!(thin * 50 <= filling.sample.points.len(), "{thin} of {}", filling.sample.points.len());
}

#[test]
fn separate_pieces_are_found() {
    let ball = sphere(16, 0.03);
    let two = solid(&joined(&[&ball, &moved(&ball, DVec3::X * 0.2)]));
    assert_eq!(two.report.pieces, 2);
    let filling = fill(&two, FillResolution::Particles(600), 2.5, 100_000).unwrap();
    assert_eq!(filling.sample.pieces().1, 2);
}
