//! Scenes put together for tests: scene in, report out.

use glam::DVec3;
use sinew::bake::{Baked, bake};
use sinew::scene::{
    Assets, Axis, Body, BoxShape, Distance, Fibre, Material, Measure, MeasureKind, Motion, PaperStiffness, Pin, Ramp,
    Region, RestShape, Rigidity, Scene, Side, Stiffness,
};
use sinew::sim::Runner;

pub const H: f64 = 0.015;
pub const D: f64 = 0.006;

/// A box of whole layers, long axis up, its lower face at the origin's height.
pub fn block(layers: [u32; 3], young_modulus: f64) -> Body {
    let size = layers.map(|n| f64::from(n) * D);
    let material = Material::new(young_modulus, 0.33, 1000.0).with_particle_mass(4e-4).with_support_radius(H);
    Body::new("block", BoxShape::new(size).with_center([0.0, 0.5 * size[1], 0.0]))
        .with_name("Block")
        .with_material(material)
}

/// The paper's short bar: 7 x 7 x 12 particles.
pub fn short_bar(young_modulus: f64) -> Body {
    block([7, 12, 7], young_modulus)
}

/// A scene without gravity, floor or anything else.
pub fn in_space(body: Body) -> Scene {
    Scene::new("test").with_gravity([0.0; 3]).with_body(body)
}

pub fn layers(id: &str, axis: Axis, side: Side, count: u32) -> Region {
    Region::layers(id, axis, side, count)
}

pub fn pin(region: &str, axes: &[Axis], motion: Motion) -> Pin {
    Pin::new(format!("pin {region}"), region).with_axes(axes.iter().copied()).with_motion(motion)
}

pub const ALL: [Axis; 3] = Axis::ALL;

pub fn measure(name: &str, kind: MeasureKind) -> Measure {
    Measure::new(name, "block", kind)
}

pub fn ramp(direction: [f64; 3], distance: Distance, duration: f64) -> Motion {
    Ramp::new(direction, distance, duration).into()
}

pub fn rigidity(ea: f64, ei: f64) -> Stiffness {
    Rigidity::new(ea, ei).into()
}

pub fn paper(kb: f64, ks: f64) -> Stiffness {
    PaperStiffness::new(kb, ks).into()
}

pub fn fibre(
    id: &str,
    vertices: Vec<[f64; 3]>,
    stiffness: Stiffness,
    volume_fraction: f64,
    rest_shape: RestShape,
) -> Fibre {
    Fibre::through(id, vertices)
        .with_stiffness(stiffness)
        .with_volume_fraction(volume_fraction)
        .with_rest_shape(rest_shape)
}

pub fn baked(scene: &Scene) -> Baked {
    scene.validate().expect("a valid scene");
    bake(scene, &Assets::default()).expect("a scene that bakes")
}

pub fn runner(scene: &Scene) -> Runner {
    Runner::new(baked(scene))
}

/// Runs until everything rests, at most `frames` frames.
pub fn settle(scene: &Scene, frames: u64) -> Runner {
    let mut runner = runner(scene);
    for _ in 0..frames {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        if runner.at_rest() {
            return runner;
        }
    }
    panic!("not at rest after {frames} frames");
}

pub fn scalar(runner: &Runner, index: usize) -> f64 {
    match runner.world().measures()[index] {
        sinew::solver::MeasureValue::Scalar(value) => value,
        sinew::solver::MeasureValue::Vector(value) => panic!("a vector: {value}"),
    }
}

/// A reproducible vector in a cube of half width 1.
pub fn wobble(i: usize, salt: u64) -> DVec3 {
    let mut seed = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ salt.wrapping_mul(0xD1B5_4A32_D192_ED03);
    let mut next = || {
        seed ^= seed >> 31;
        seed = seed.wrapping_mul(0xBF58_476D_1CE4_E5B9);
        seed ^= seed >> 29;
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    DVec3::new(next(), next(), next())
}
