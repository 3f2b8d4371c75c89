//! Scenes put together for tests: scene in, report out.

use glam::DVec3;
use sinew::bake::{Baked, bake};
use sinew::scene::{
    Assets, Axis, Body, BoxShape, Damping, Distance, Easing, Extra, Fibre, FibreSource, Initial, IntegratorKind, Mass,
    Material, Measure, MeasureKind, Motion, OverTime, PaperStiffness, Pin, Placement, Ramp, Reaction, Region,
    RestShape, Rigidity, Rotation, Scene, Selector, Shape, Side, Stiffness,
};
use sinew::sim::Runner;

pub const H: f64 = 0.015;
pub const D: f64 = 0.006;

/// A box of whole layers, long axis up, its lower face at the origin's height.
pub fn block(layers: [u32; 3], young_modulus: f64) -> Body {
    let size = layers.map(|n| f64::from(n) * D);
    Body {
        id: "block".into(),
        name: "Block".into(),
        hidden: false,
        color: None,
        kind: sinew::scene::BodyKind::FibreSolid,
        shape: Shape::Box(BoxShape {
            center: [0.0, 0.5 * size[1], 0.0],
            size,
            lattice_rotation: Rotation::default(),
            extra: Extra::new(),
        }),
        placement: Placement::default(),
        material: Material {
            young_modulus,
            poisson_ratio: 0.33,
            mass: Mass::PerParticle(4e-4),
            support_radius: H,
            spacing_ratio: 0.4,
            damping: Damping::default(),
            volume_fraction_falloff: sinew::scene::Falloff::Kernel,
            extra: Extra::new(),
        },
        integrator: IntegratorKind::LeapFrog,
        initial: Initial::default(),
        impulses: Vec::new(),
        fibres: Vec::new(),
        paint: Vec::new(),
        regions: Vec::new(),
        pins: Vec::new(),
        extra: Extra::new(),
    }
}

/// The paper's short bar: 7 x 7 x 12 particles.
pub fn short_bar(young_modulus: f64) -> Body {
    block([7, 12, 7], young_modulus)
}

/// A scene without gravity, floor or anything else.
pub fn in_space(body: Body) -> Scene {
    Scene { name: "test".into(), gravity: [0.0; 3], bodies: vec![body], ..Scene::default() }
}

pub fn layers(id: &str, axis: Axis, side: Side, count: u32) -> Region {
    Region { id: id.into(), select: Selector::Layers { axis, side, count, extra: Extra::new() }, extra: Extra::new() }
}

pub fn pin(region: &str, axes: &[Axis], motion: Motion) -> Pin {
    Pin { id: format!("pin {region}"), region: region.into(), axes: axes.to_vec(), motion, extra: Extra::new() }
}

pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

pub fn measure(name: &str, kind: MeasureKind) -> Measure {
    Measure { name: name.into(), body: "block".into(), kind, over_time: OverTime::Final, extra: Extra::new() }
}

pub fn reaction(region: &str, along: [f64; 3]) -> Reaction {
    Reaction { region: region.into(), along, extra: Extra::new() }
}

pub fn ramp(direction: [f64; 3], distance: Distance, duration: f64) -> Motion {
    Motion::Ramp(Ramp { direction, distance, start: 0.0, duration, easing: Easing::Smooth, extra: Extra::new() })
}

pub fn rigidity(ea: f64, ei: f64) -> Stiffness {
    Stiffness::Rigidity(Rigidity { ea, ei, extra: Extra::new() })
}

pub fn paper(kb: f64, ks: f64) -> Stiffness {
    Stiffness::Paper(PaperStiffness { kb, ks, extra: Extra::new() })
}

pub fn fibre(
    id: &str,
    vertices: Vec<[f64; 3]>,
    stiffness: Stiffness,
    volume_fraction: f64,
    rest_shape: RestShape,
) -> Fibre {
    Fibre {
        id: id.into(),
        name: String::new(),
        hidden: false,
        color: None,
        source: FibreSource::Vertices(vertices),
        stiffness,
        volume_fraction,
        rest_shape,
        break_past: None,
        extra: Extra::new(),
    }
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
        sinew::solver::measure::MeasureValue::Scalar(value) => value,
        sinew::solver::measure::MeasureValue::Vector(value) => panic!("a vector: {value}"),
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
