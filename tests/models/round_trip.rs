//! A mesh written by the tests' own small writers is read back as it was, in every format.

use crate::shapes::{sphere, torus};
use crate::writers::{obj, ply, stl, stl_text};
use glam::DVec3;
use sinew::geometry::Model;
use sinew::io::{load_model, write_glb};
use std::fs;

/// The greatest distance between corners of the same faces, as a share of the extent.
fn apart(a: &Model, b: &Model) -> f64 {
    assert_eq!(a.triangles.len(), b.triangles.len());
    let corners = |model: &Model| -> Vec<DVec3> {
        model.triangles.iter().flatten().map(|&i| model.positions[i as usize]).collect()
    };
    let (from, to) = a.positions.iter().fold((DVec3::MAX, DVec3::MIN), |(min, max), p| (min.min(*p), max.max(*p)));
    let distances = corners(a).into_iter().zip(corners(b)).map(|(a, b)| a.distance(b));
    distances.fold(0.0, f64::max) / (to - from).length()
}

#[test]
fn a_mesh_is_read_as_it_was_written() {
    let folder = tempfile::tempdir().expect("a folder");
    // Near the origin, far away from it, and very small.
    let moves: [(f64, DVec3); 3] =
        [(1.0, DVec3::ZERO), (1.0, DVec3::new(12_345.678_9, -9_876.543_21, 100.0)), (1e-5, DVec3::new(1e-4, 0.0, 0.0))];
    for shape in [sphere(9, 1.0 / 3.0), torus(24, 16, 0.7, 0.1)] {
        for (scale, shift) in moves {
            let mut model = shape.clone();
            model.positions.iter_mut().for_each(|p| *p = scale * *p + shift);
            let files = [
                ("a.obj", obj(&model), 0.0),
                ("ascii.ply", ply(&model, "ascii"), 0.0),
                ("little.ply", ply(&model, "binary_little_endian"), 0.0),
                ("big.ply", ply(&model, "binary_big_endian"), 0.0),
                ("text.stl", stl_text(&model), 1e-7),
                ("binary.stl", stl(&model), 1e-7),
            ];
            // Single precision is of the distance from the origin, not of the extent.
            let far = 1.0 + shift.length() / scale;
            for (name, bytes, precision) in files {
                let path = folder.path().join(name);
                fs::write(&path, bytes).expect("written");
                let read = load_model(&path).unwrap_or_else(|error| panic!("{error}"));
                let distance = apart(&model, &read);
                assert!(distance <= precision * far, "{name}, {scale} and {shift}: {distance}");
            }
            let path = folder.path().join("a.glb");
            write_glb(&path, &model, "mesh").expect("written");
            let distance = apart(&model, &load_model(&path).unwrap());
            assert!(distance <= 1e-7 * far, "glb, {scale} and {shift}: {distance}");
        }
    }
}
