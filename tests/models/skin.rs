//! The skin follows its particles.

use crate::shapes::{solid, torus};
use glam::{DMat3, DVec3, Vec3};
use sinew::geometry::Kernel;
use sinew::geometry::Model;
use sinew::geometry::{FillResolution, fill};
use sinew::test_support::solver::{Skin, SkinShape};

fn skinned(model: &Model, normals: &[Vec3]) -> (Skin, Vec<DVec3>, Vec<DVec3>) {
    let solid = solid(model);
    let sample = fill(&solid, FillResolution::Particles(1200), 2.5, 100_000).expect("a filling").sample;
    let shape = SkinShape {
        points: &solid.surface.points,
        point_of: &solid.surface.point_of,
        normals,
        colours: &[],
        triangles: &solid.model.triangles,
    };
    let skin = Skin::embed(&shape, &sample.points, Kernel::new(2.5 * sample.spacing), &mut |_, _| {}).expect("a skin");
    (skin, sample.points, solid.model.positions)
}

/// A torus with a spike far outside of what the particles reach.
fn spiked() -> Model {
    let mut model = torus(64, 32, 0.05, 0.02);
    model.positions[17] *= 1.6;
    model
}

#[test]
fn the_rest_shape_is_reproduced() {
    let (skin, particles, vertices) = skinned(&spiked(), &[]);
    let worst = skin.positions(&particles).iter().zip(&vertices).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert!(worst < 2e-15, "{worst}");
}

#[test]
fn affine_motions_of_the_particles_move_the_skin_alike() {
    let (skin, particles, vertices) = skinned(&spiked(), &[]);
    let gradient = DMat3::from_cols_array(&[1.1, 0.2, -0.3, 0.05, 0.9, 0.4, -0.2, 0.1, 1.3]);
    let map = |x: &DVec3| gradient * *x + DVec3::new(0.3, -0.2, 0.1);
    let moved: Vec<DVec3> = particles.iter().map(map).collect();
    let found = skin.positions(&moved);
    let worst = found.iter().zip(&vertices).map(|(a, b)| a.distance(map(b))).fold(0.0, f64::max);
    assert!(worst < 1e-12, "{worst}");
}

#[test]
fn normals_turn_with_the_surface_and_edges_stay_sharp() {
    let model = torus(64, 32, 0.05, 0.02);
    let (skin, particles, vertices) = skinned(&model, &[]);
    let quarter = DMat3::from_rotation_y(std::f64::consts::FRAC_PI_2);
    let turned: Vec<DVec3> = particles.iter().map(|&x| quarter * x).collect();
    let normals = skin.normals(&skin.positions(&turned));
    for (vertex, normal) in vertices.iter().zip(&normals) {
        let core = DVec3::new(vertex.x, vertex.y, 0.0).normalize_or_zero() * 0.05;
        let expected = quarter * (*vertex - core).normalize_or_zero();
        assert!(expected.as_vec3().dot(*normal) > 0.99);
    }
    // Two vertices at one place whose normals in the file differ do not share one afterwards.
    let mut split = model.clone();
    let double = split.positions.len() as u32;
    split.positions.push(split.positions[0]);
    let first = split.triangles.iter().position(|t| t.contains(&0)).unwrap();
    split.triangles[first] = split.triangles[first].map(|i| if i == 0 { double } else { i });
    let mut file_normals: Vec<Vec3> = vec![Vec3::X; split.positions.len()];
    file_normals[double as usize] = Vec3::Y;
    let (skin, particles, _) = skinned(&split, &file_normals);
    let positions = skin.positions(&particles);
    assert_eq!(positions[0], positions[double as usize]);
    let normals = skin.normals(&positions);
    let [a, b, c] = split.triangles[first].map(|i| positions[i as usize]);
    let face = (b - a).cross(c - a).normalize_or_zero().as_vec3();
    assert!(normals[double as usize].dot(face) > 0.999_99);
    assert!(normals[0].dot(face) < 0.9999);
}

#[test]
fn the_same_bits_on_any_number_of_threads() {
    let (skin, particles, _) = skinned(&torus(64, 32, 0.05, 0.02), &[]);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let positions = skin.positions(&particles);
            let normals = skin.normals(&positions);
            (positions, normals)
        })
    };
    assert_eq!(on(1), on(3));
}
