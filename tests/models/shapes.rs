//! Meshes made for tests.

use glam::{DMat3, DVec3};
use sinew::geometry::Solid;
use sinew::geometry::{MeshData, Model};

/// A closed surface over a grid of angles, both wrapping round: `around` and `along` in [0, 1).
fn wrapped(n: u32, m: u32, at: impl Fn(f64, f64) -> DVec3) -> Model {
    let position = |k: u32| at(f64::from(k / m) / f64::from(n), f64::from(k % m) / f64::from(m));
    let index = |i: u32, j: u32| (i % n) * m + j % m;
    let triangles = (0..n * m).flat_map(|k| {
        let (i, j) = (k / m, k % m);
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    single((0..n * m).map(position).collect(), triangles.collect())
}

pub fn single(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Model {
    let mut model = Model::default();
    model.add(MeshData { positions, triangles, ..MeshData::default() });
    model
}

/// A torus about the z axis.
pub fn torus(n: u32, m: u32, large: f64, small: f64) -> Model {
    wrapped(n, m, |u, v| {
        let (u, v) = (u * std::f64::consts::TAU, v * std::f64::consts::TAU);
        let out = large + small * v.cos();
        DVec3::new(out * u.cos(), out * u.sin(), small * v.sin())
    })
}

/// A sphere of `n` rings of `2 n` vertices and two poles.
pub fn sphere(n: u32, radius: f64) -> Model {
    let m = 2 * n;
    let mut positions = vec![DVec3::new(0.0, 0.0, radius), DVec3::new(0.0, 0.0, -radius)];
    for i in 1..=n {
        for j in 0..m {
            let u = std::f64::consts::PI * f64::from(i) / f64::from(n + 1);
            let v = std::f64::consts::TAU * f64::from(j) / f64::from(m);
            positions.push(radius * DVec3::new(u.sin() * v.cos(), u.sin() * v.sin(), u.cos()));
        }
    }
    let index = |i: u32, j: u32| 2 + i * m + j % m;
    let mut triangles = Vec::new();
    for j in 0..m {
        triangles.push([0, index(0, j), index(0, j + 1)]);
        triangles.push([1, index(n - 1, j + 1), index(n - 1, j)]);
        for i in 0..n - 1 {
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    single(positions, triangles)
}

/// The same model with its vertices and faces in another order, its faces begun at other corners.
pub fn shuffled(model: &Model, seed: u64) -> Model {
    let mut state = seed | 1;
    let mut random = move |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let mut shuffle = |count: usize| {
        let mut order: Vec<usize> = (0..count).collect();
        for k in (1..count).rev() {
            order.swap(k, random(k + 1));
        }
        order
    };
    let vertices = shuffle(model.positions.len());
    let faces = shuffle(model.triangles.len());
    let mut new_index = vec![0; vertices.len()];
    for (new, &old) in vertices.iter().enumerate() {
        new_index[old] = new as u32;
    }
    let triangles = faces
        .iter()
        .map(|&face| {
            let mut triangle = model.triangles[face].map(|i| new_index[i as usize]);
            triangle.rotate_left(face % 3);
            triangle
        })
        .collect();
    single(vertices.iter().map(|&k| model.positions[k]).collect(), triangles)
}

pub fn turned(model: &Model, rotation: DMat3) -> Model {
    let mut model = model.clone();
    model.positions.iter_mut().for_each(|p| *p = rotation * *p);
    model
}

pub fn solid(model: &Model) -> Solid {
    Solid::new(model).expect("a solid")
}

/// Several models as one, a part each.
pub fn joined(models: &[&Model]) -> Model {
    let mut all = Model::default();
    for model in models {
        all.add(MeshData {
            positions: model.positions.clone(),
            triangles: model.triangles.clone(),
            ..MeshData::default()
        });
    }
    all
}

pub fn moved(model: &Model, by: DVec3) -> Model {
    let mut model = model.clone();
    model.positions.iter_mut().for_each(|p| *p += by);
    model
}
