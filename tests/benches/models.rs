//! Models: load, fill, embed, skin, on all threads: `cargo bench --bench models`.

use divan::Bencher;
use divan::counter::ItemsCount;
use glam::DVec3;
use sinew::geometry::Kernel;
use sinew::geometry::Solid;
use sinew::geometry::{FillError, FillResolution, fill};
use sinew::geometry::{MeshData, Model};
use sinew::io::{load_model, write_glb};
use sinew::test_support::geometry::isosurface;
use sinew::test_support::solver::{Skin, SkinShape};
use std::path::{Path, PathBuf};

fn main() {
    divan::main();
}

/// Particles and skin of a solid.
fn filled(solid: &Solid, particles: u32) -> (Vec<DVec3>, Skin) {
    let sample = fill(solid, FillResolution::Particles(particles), 2.5, 2_000_000).expect("a filling").sample;
    let kernel = Kernel::new(2.5 * sample.spacing);
    let skin = Skin::embed(&SkinShape::of(solid), &sample.points, kernel, &mut |_, _| {}).expect("a skin");
    (sample.points, skin)
}

/// From the file to a skin that can be moved.
fn load_fill_embed(path: &Path, particles: u32) -> Skin {
    let solid = Solid::new(&load_model(path).expect("a model")).expect("an inside");
    filled(&solid, particles).1
}

fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name)
}

/// A bumpy ball of about `faces` faces.
fn ball(faces: f64) -> Model {
    let field = |p: DVec3| p.length() - 1.0 - 0.05 * (7.0 * p.x).sin() * (7.0 * p.y).sin() * (7.0 * p.z).sin();
    // Cells that a unit sphere cuts: about 1.5 times its area over theirs, two faces each.
    let cell = (2.0 * 1.5 * 4.0 * std::f64::consts::PI / faces).sqrt();
    isosurface(&field, DVec3::splat(-1.2), DVec3::splat(1.2), cell)
}

/// The plant: 31.5k vertices, 2723 particles.
#[divan::bench(sample_count = 10)]
fn plant_load_fill_embed() -> Skin {
    load_fill_embed(&shipped("plant.glb"), 2723)
}

/// 500k faces, 50 000 particles.
#[divan::bench(sample_count = 3)]
fn half_a_million_faces_load_fill_embed(bencher: Bencher<'_, '_>) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ball.glb");
    let model = ball(500_000.0);
    assert!((450_000..600_000).contains(&model.triangles.len()), "{}", model.triangles.len());
    write_glb(&path, &model, "ball").expect("a file");
    bencher.bench_local(|| load_fill_embed(&path, 50_000));
}

/// 50k vertices over 2700 particles: positions and normals, once a frame.
#[divan::bench(sample_count = 50)]
fn skin_a_frame(bencher: Bencher<'_, '_>) {
    let model = ball(100_000.0);
    let (particles, skin) = filled(&Solid::new(&model).expect("an inside"), 2700);
    bencher.counter(ItemsCount::new(skin.len())).bench_local(|| {
        let positions = skin.positions(&particles);
        let normals = skin.normals(&positions);
        (positions, normals)
    });
}

/// A tube of 256 faces around the y axis, at 50 000 particles about as thick as they are apart; its ends are open at
/// will.
fn tube(is_open: bool) -> Model {
    let (sides, rings) = (32_u32, [(0.5, -1.0), (0.5, 1.0), (0.49, 1.0), (0.49, -1.0)]);
    let at = |k: u32| {
        let (sine, cosine) = (std::f64::consts::TAU * f64::from(k / 4) / f64::from(sides)).sin_cos();
        let (radius, y): (f64, f64) = rings[k as usize % 4];
        DVec3::new(radius * sine, y, radius * cosine)
    };
    let quads = (0..4 * sides).filter(|k| !is_open || k % 2 == 0).map(|k| {
        let [next, above] = [(k + 4) % (4 * sides), k / 4 * 4 + (k + 1) % 4];
        [k, next, (next / 4 * 4) + (next + 1) % 4, above]
    });
    let triangles = quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let mut model = Model::default();
    model.add(MeshData { positions: (0..4 * sides).map(at).collect(), triangles, ..MeshData::default() });
    model
}

/// From a model to its particles, or to the spacing that it is too thin for.
#[divan::bench(args = [false, true], sample_count = 3)]
fn thin_tube_check_fill(is_open: bool) -> f64 {
    let solid = Solid::new(&tube(is_open)).expect("an inside");
    match fill(&solid, FillResolution::Particles(50_000), 2.5, 2_000_000) {
        Ok(filling) => filling.volume_error,
        Err(FillError::TooThin { suggested, .. }) => suggested.unwrap_or_default(),
        Err(other) => panic!("{other}"),
    }
}

/// 100k faces, 3 % of them missing, 50 000 particles.
#[divan::bench(sample_count = 3)]
fn holes_everywhere_check_fill(bencher: Bencher<'_, '_>) {
    let mut model = ball(100_000.0);
    let mut number = 0_u32;
    model.triangles.retain(|_| {
        number = number.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        number >> 16 > 1966
    });
    model.parts.clear();
    bencher.bench_local(|| {
        let solid = Solid::new(&model).expect("an inside");
        fill(&solid, FillResolution::Particles(50_000), 2.5, 2_000_000).expect("a filling").sample.points.len()
    });
}
