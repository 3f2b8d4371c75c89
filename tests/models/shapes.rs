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

/// A surface about the y axis, of rings of radius and height; the first and the last are points.
pub fn lathe(profile: &[(f64, f64)], around: u32) -> Model {
    let inner = &profile[1..profile.len() - 1];
    let (low, high) = (profile[0].1, profile[profile.len() - 1].1);
    let mut positions = vec![DVec3::Y * low, DVec3::Y * high];
    for &(radius, height) in inner {
        positions.extend((0..around).map(|k| {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(around);
            DVec3::new(radius * angle.sin(), height, radius * angle.cos())
        }));
    }
    let index = |ring: u32, k: u32| 2 + ring * around + k % around;
    let last = inner.len() as u32 - 1;
    let mut triangles = Vec::new();
    for k in 0..around {
        triangles.push([0, index(0, k + 1), index(0, k)]);
        triangles.push([1, index(last, k), index(last, k + 1)]);
        for ring in 0..last {
            let [a, b, c, d] = [index(ring, k), index(ring, k + 1), index(ring + 1, k + 1), index(ring + 1, k)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    single(positions, triangles)
}

/// The surface of those cells between cuts along the axes that are filled.
pub fn blocks(xs: &[f64], ys: &[f64], zs: &[f64], filled: impl Fn([usize; 3]) -> bool) -> Model {
    let cuts = [xs, ys, zs];
    let counts = cuts.map(|cuts| cuts.len() - 1);
    let is_filled = |cell: [i32; 3]| {
        let inside = (0..3).all(|axis| cell[axis] >= 0 && (cell[axis] as usize) < counts[axis]);
        inside && filled(cell.map(|i| i as usize))
    };
    let corner = |at: [i32; 3]| {
        let [i, j, k] = at.map(|i| i as u32);
        (i * ys.len() as u32 + j) * zs.len() as u32 + k
    };
    let mut positions = Vec::new();
    for &x in xs {
        for &y in ys {
            positions.extend(zs.iter().map(|&z| DVec3::new(x, y, z)));
        }
    }
    let mut triangles = Vec::new();
    for cell in 0..(counts[0] * counts[1] * counts[2]) {
        let [i, j, k] = [cell / (counts[1] * counts[2]), cell / counts[2] % counts[1], cell % counts[2]];
        let cell = [i, j, k].map(|i| i32::try_from(i).expect("few cuts"));
        for axis in (0..3).filter(|_| is_filled(cell)) {
            for side in [0, 1] {
                let mut beside = cell;
                beside[axis] += 2 * side - 1;
                if is_filled(beside) {
                    continue;
                }
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let at = |a: i32, b: i32| {
                    let mut at = cell;
                    at[axis] += side;
                    at[u] += a;
                    at[v] += b;
                    corner(at)
                };
                let [a, b, c, d] = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
                let faces = if side == 1 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
                triangles.extend(faces);
            }
        }
    }
    single(positions, triangles)
}
