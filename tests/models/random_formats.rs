//! Meshes made at random go the way of a dropped file: written in every format, read, filled, put together and moved.

use crate::random::for_every;
use crate::random_meshes::{KINDS, mesh, volume};
use crate::shapes::single;
use crate::writers::{glb, gltf, obj, ply, stl, stl_text};
use glam::DVec3;
use sinew::bake::{BakeError, bake};
use sinew::geometry::{FillError, FillResolution, Kernel, Model, Solid, fill};
use sinew::io::{load_assets, load_model};
use sinew::scene::{Assets, Body, Initial, Material, MeshShape, Scene, Shape};
use sinew::sim::Runner;
use sinew::test_support::solver::{Skin, SkinShape};
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Names of the files, and whether the numbers in them are single precision; every kind of mesh meets each of them.
const FILES: [(&str, bool); 8] = [
    ("a.obj", false),
    ("ascii.ply", false),
    ("little.ply", false),
    ("big.ply", false),
    ("text.stl", true),
    ("binary.stl", true),
    ("a.gltf", true),
    ("a.glb", true),
];

/// Particles that are asked for, one after the other, until one is enough for the shape.
const COUNTS: [u32; 3] = [60, 400, 4000];

/// Every so manieth is put together and moved for 0.1 s, if [`MOVED`] particles are enough for it: every kind of mesh
/// and every format is among them.
const EVERY: u64 = 13;
const MOVED: u32 = 60;

fn written(model: &Model, file: &str) -> Vec<u8> {
    match file {
        "a.obj" => obj(model),
        "ascii.ply" => ply(model, "ascii"),
        "little.ply" => ply(model, "binary_little_endian"),
        "big.ply" => ply(model, "binary_big_endian"),
        "text.stl" => stl_text(model),
        "binary.stl" => stl(model),
        "a.gltf" => gltf(model),
        _ => glb(model),
    }
}

/// A mesh as its file has it, the name of that, and the file's bytes.
fn file_of(seed: u64) -> (Model, &'static str, Vec<u8>) {
    let (points, faces, _) = mesh(seed);
    let mut model = single(points.into_iter().map(DVec3::from_array).collect(), faces);
    let (name, is_single) = FILES[(seed / KINDS) as usize % FILES.len()];
    let bytes = written(&model, name);
    if is_single {
        model.positions.iter_mut().for_each(|p| *p = p.as_vec3().as_dvec3());
    }
    (model, name, bytes)
}

/// The mesh as a soft body that is thrown onto a floor just below it, in so many particles. It gives by a tenth of its
/// size under its own weight, whatever its size, so that few steps are needed.
fn scene(model: &Model, file: &str, particles: u32) -> Scene {
    let extent = extent(model);
    let low = model.positions.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
    let mut body = Body::from_mesh("body", MeshShape::new(file).with_particles(particles))
        .with_material(Material::new(1e5 * extent, 0.3, 1000.0));
    let speed = extent.sqrt();
    body.initial = Initial {
        velocity: [0.3 * speed, -speed, 0.0],
        angular_velocity: [4.0, -3.0, 6.0].map(|turn| turn / speed),
        ..Initial::default()
    };
    Scene::new("Random").with_floor(low - 0.02 * extent).with_body(body)
}

fn extent(model: &Model) -> f64 {
    let (min, max) = model.positions.iter().fold((DVec3::MAX, DVec3::MIN), |(a, b), p| (a.min(*p), b.max(*p)));
    (max - min).max_element()
}

/// Its particles and their skin, in the fewest particles that are enough; none where not even the most are.
fn embedded(solid: &Solid) -> Result<Option<(Vec<DVec3>, Skin)>, String> {
    for count in COUNTS {
        match fill(solid, FillResolution::Particles(count), 2.5, 100_000) {
            Ok(filling) => {
                let (particles, kernel) = (filling.sample.points, Kernel::new(2.5 * filling.sample.spacing));
                let skin =
                    Skin::embed(&SkinShape::of(solid), &particles, kernel, &mut |_, _| {}).ok_or("there is no skin")?;
                return Ok(Some((particles, skin)));
            }
            Err(FillError::TooThin { .. }) => {}
            Err(error) => return Err(error.to_string()),
        }
    }
    Ok(None)
}

/// Every corner of every face of the solid where the file put it.
fn faces_are_those_of_the_file(solid: &Solid, file: &Model) -> bool {
    let corners = |model: &Model| -> Vec<DVec3> {
        model.triangles.iter().flatten().map(|&i| model.positions[i as usize]).collect()
    };
    corners(&solid.model) == corners(file)
}

fn is_finite(runner: &Runner) -> bool {
    let snapshot = runner.snapshot();
    let body = &snapshot.bodies[0];
    body.skin.iter().chain(&body.particles).all(|x| x.is_finite()) && body.normals.iter().all(|x| x.is_finite())
}

/// Reads and fills one, and moves it in one of so many particles; whether it could be filled.
fn tried(seed: u64, folder: &Path, counts: &[u32]) -> Result<bool, String> {
    let (model, file, bytes) = file_of(seed);
    fs::write(folder.join(file), bytes).map_err(|error| error.to_string())?;
    let shape = MeshShape::new(file);
    let assets = load_assets(&scene(&model, file, 1), folder, &mut |_| {}).map_err(|error| error.to_string())?;
    let solid = assets.solid(&shape).ok_or("nothing was loaded")?;
    let expected = volume(seed);
    if (solid.volume / expected - 1.0).abs() >= 0.02 {
        return Err(format!("{file}: {:.5e} m³ instead of {expected:.5e}", solid.volume));
    }
    if !faces_are_those_of_the_file(solid, &model) {
        return Err(format!("{file}: its faces are others than those that were written"));
    }
    let Some((particles, skin)) = embedded(solid)? else { return Ok(false) };
    let off = worst(&skin.positions(&particles), &solid.model.positions);
    if off.is_nan() || off > 1e-9 * extent(&model) {
        return Err(format!("{file}: the skin is off by {off:e} m at rest"));
    }
    for &count in counts {
        if moved(&scene(&model, file, count), &assets, &model).map_err(|text| format!("{file}: {text}"))? {
            break;
        }
    }
    Ok(true)
}

/// The greatest distance; what is no number counts as the greatest.
fn worst(found: &[DVec3], expected: &[DVec3]) -> f64 {
    if found.len() != expected.len() {
        return f64::INFINITY;
    }
    let distances = found.iter().zip(expected).map(|(a, b)| a.distance(*b));
    distances.fold(0.0, |worst, distance| if distance <= worst { worst } else { distance })
}

/// Puts a scene together and runs it for 0.1 s. One that is too thin for its particles is refused, which is another
/// test: false.
fn moved(scene: &Scene, assets: &Assets, model: &Model) -> Result<bool, String> {
    scene.validate().map_err(|error| error.to_string())?;
    let baked = match bake(scene, assets) {
        Ok(baked) => baked,
        Err(BakeError::MeshTooThin { .. } | BakeError::TooThin { .. }) => return Ok(false),
        Err(error) => return Err(error.to_string()),
    };
    let mut runner = Runner::new(baked);
    let off = worst(&runner.snapshot().bodies[0].skin, &model_vertices(assets, scene));
    if off.is_nan() || off > 1e-9 * extent(model) {
        return Err(format!("the skin of the body is off by {off:e} m at rest"));
    }
    for frame in 0..runner.frames_for(0.1) {
        runner.advance_frame();
        if !is_finite(&runner) {
            return Err(format!("frame {frame} is no numbers"));
        }
    }
    runner.world().divergence().map_or(Ok(true), |divergence| Err(divergence.to_string()))
}

fn model_vertices(assets: &Assets, scene: &Scene) -> Vec<DVec3> {
    let Shape::Mesh(shape) = &scene.bodies[0].shape else { return Vec::new() };
    assets.solid(shape).map_or_else(Vec::new, |solid| solid.model.positions.clone())
}

/// Whether two solids are one, to the bit: what a file does not keep, such as the order of its vertices, leaves no
/// trace.
fn same(a: &Solid, b: &Solid) -> bool {
    a.volume.to_bits() == b.volume.to_bits()
        && a.surface.points == b.surface.points
        && a.surface.faces == b.surface.faces
}

/// One mesh through every format is one solid; in those of single precision that of the rounded mesh.
#[test]
fn a_mesh_is_the_same_solid_through_every_format() {
    for_every(0..2 * KINDS, |seed| {
        let (points, faces, _) = mesh(seed);
        let whole = single(points.into_iter().map(DVec3::from_array).collect(), faces);
        let mut rounded = whole.clone();
        rounded.positions.iter_mut().for_each(|p| *p = p.as_vec3().as_dvec3());
        let solid = |model: &Model| Solid::new(model).map_err(|refusal| refusal.to_string());
        let expected = [solid(&whole)?, solid(&rounded)?];
        let between = expected[1].volume / expected[0].volume - 1.0;
        if between.abs() > 1e-4 {
            return Err(format!("single precision changes the volume by {between:e}"));
        }
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        for (file, is_single) in FILES {
            let path = folder.path().join(file);
            fs::write(&path, written(&whole, file)).map_err(|error| error.to_string())?;
            let read = solid(&load_model(&path).map_err(|error| error.to_string())?)?;
            if !same(&read, &expected[usize::from(is_single)]) {
                return Err(format!("{file}: another solid of {} m³", read.volume));
            }
        }
        Ok(())
    });
}

/// Meshes with faces taken away and turned round, some next to nothing: what is said of them is no more than a whole.
#[test]
fn no_more_than_all_of_an_inside_is_in_doubt() {
    let doubted = AtomicUsize::new(0);
    for_every(0..200, |seed| {
        let (points, mut faces, _) = mesh(seed);
        let mut state = seed;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / f64::from(1_u32 << 31)
        };
        let [gone, turned] = [0.9 * random(), 0.5 * random()];
        faces.retain(|_| random() > gone);
        for face in &mut faces {
            if random() < turned {
                face.swap(0, 1);
            }
        }
        let model = single(points.into_iter().map(DVec3::from_array).collect(), faces);
        let said = match Solid::new(&model) {
            Ok(solid) => solid.report.findings().iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"),
            Err(refusal) => refusal.to_string(),
        };
        for (at, _) in said.match_indices(" % of the inside in doubt") {
            let figure = said[..at].rsplit(' ').next().unwrap_or_default();
            let doubt: f64 = figure.parse().map_err(|_| format!("{figure} is no number: {said}"))?;
            if !(0.0..=100.0).contains(&doubt) {
                return Err(said);
            }
            doubted.fetch_add(1, Ordering::Relaxed);
        }
        Ok(())
    });
    assert!(doubted.into_inner() > 20);
}

/// Tries all 2,000, each moved in as many particles as `counts` tells.
fn all(counts: impl Fn(u64) -> &'static [u32] + Sync) {
    let unfilled = AtomicUsize::new(0);
    for_every(0..2000, |seed| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        if !tried(seed, folder.path(), counts(seed))? {
            unfilled.fetch_add(1, Ordering::Relaxed);
        }
        Ok(())
    });
    // Tubes with walls of a fiftieth of their radius.
    let unfilled = unfilled.into_inner();
    assert!(unfilled < 100, "{unfilled} are too thin for {} particles", COUNTS[2]);
}

/// 2,000 meshes through all formats, each filled with as few particles as it takes. Moved for 0.1 s is every thirteenth
/// of them only: all of them take minutes.
#[test]
fn every_format_is_read_filled_and_moved() {
    all(|seed| if seed.is_multiple_of(EVERY) { &[MOVED] } else { &[] });
}

/// As above, and each is moved in as few particles as are enough for it.
#[test]
#[ignore = "takes minutes: see CONTRIBUTING.md"]
fn two_thousand_meshes_are_moved() {
    all(|_| &COUNTS);
}
