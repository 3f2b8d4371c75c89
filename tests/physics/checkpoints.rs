//! A world that goes back to a checkpoint moves on as if nothing had happened since, bit for bit.

use glam::DVec3;
use sinew::bake::bake;
use sinew::io::scene_from_json;
use sinew::scene::{Assets, IntegratorKind, Precision, Scene};
use sinew::sim::Runner;
use sinew::solver::Dynamics;
use sinew::solver::Energies;
use sinew::solver::Force;
use sinew::solver::Integrator;
use sinew::solver::ParticleState;
use sinew::solver::Snapshot;
use sinew::solver::World;
use sinew::test_support::solver::MatrixForce;
use std::cell::Cell;

/// A bar of curved and straight fibres that break, a ball of two layers and a ring, a panel that falls on them all, a
/// floor, a pin that moves, damping, and measures with peaks.
const CROWD: &str = r#"{"version": 1, "room": {"floor": 0, "friction": 0.4},
    "time": {"frames_per_second": 240},
    "panels": [{"id": "lid", "height": 0.1, "size": [4, 4], "mass": 0.5, "motion": "falls"}],
    "bodies": [{"id": "bar", "self_contact": true, "shape": {"box": {"center": [0, 0.03, 0], "size": [0.03, 0.06, 0.03]}},
        "placement": {"translation": [0, 0.004, 0]},
        "initial": {"velocity": [0.05, -0.5, 0], "deformation": [[1, 0.1, 0], [0, 1.05, 0], [0, 0, 1]]},
        "material": {"young_modulus": 1e5, "mass": {"per_particle": 4e-4}, "support_radius": 0.015,
            "damping": {"pair": 20, "air": 0.5}},
        "regions": [{"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 1}}}],
        "pins": [{"id": "hold", "region": "top", "axes": ["x"],
            "motion": {"ramp": {"direction": [1, 0, 0], "distance": {"metres": 0.005}, "duration": 0.05}}}],
        "fibres": [
            {"id": "bent", "source": {"vertices": [[0.006, 0.005, 0], [0.01, 0.03, 0.003], [0.006, 0.055, 0]]},
                "stiffness": {"rigidity": {"ea": 10, "ei": 1e-4}}, "volume_fraction": 0.5, "rest_shape": "as_drawn",
                "break_past": {"angle": 4}},
            {"id": "straight", "source": {"vertices": [[-0.006, 0.005, 0], [-0.006, 0.03, 0], [-0.006, 0.055, 0]]},
                "stiffness": {"rigidity": {"ea": 10, "ei": 1e-4}}, "volume_fraction": 0.5, "break_past": {"tension": 0.05}}
        ]}],
    "two_layer": [
        {"id": "ball", "shape": {"ball": {"subdivisions": 1}}, "placement": {"translation": [0, 1.5, 0]}},
        {"id": "ring", "self_contact": true, "shape": {"ring": {}}, "placement": {"translation": [0, 1.2, 0]}}],
    "measures": [{"name": "shear", "body": "bar", "kind": {"size": {"axis": "y"}}, "over_time": "peak"}]}"#;

fn baked(scene: &Scene) -> World {
    bake(scene, &Assets::default()).unwrap().world
}

fn bits(world: &World) -> Vec<u64> {
    let state = |body: &sinew::solver::Body| {
        let forces = (0..body.state().len()).map(|i| body.net_force(i)).collect::<Vec<_>>();
        let vectors: Vec<DVec3> = [&*body.state().positions, &*body.state().velocities, &*forces].concat();
        let energy = body.energies(world.time()).total();
        let mut bits: Vec<u64> = vectors.iter().flat_map(DVec3::to_array).map(f64::to_bits).collect();
        bits.extend([energy.to_bits(), body.steps(), body.evaluations(), body.breaks().count() as u64]);
        bits
    };
    let mut all: Vec<u64> = world.bodies().iter().flat_map(state).collect();
    all.extend(world.panels().iter().flat_map(|panel| [panel.height.to_bits(), panel.velocity.to_bits()]));
    all.extend(world.reported_measures().iter().map(|value| value.magnitude().to_bits()));
    all.extend([world.time().to_bits(), world.frame()]);
    all
}

/// Runs `frames` frames with a checkpoint at each, then goes back to some of them, in the same world and in another one
/// of the same scene, and runs on.
fn goes_back_exactly(start: &World, frames: usize) {
    let mut world = start.clone();
    let mut kept = vec![(world.checkpoint(), bits(&world))];
    for _ in 0..frames {
        world.advance_frame();
        kept.push((world.checkpoint(), bits(&world)));
    }
    let last = world.clone();
    let mut other = start.clone();
    for from in [frames - 1, 1, frames / 2, 0, frames / 3] {
        for world in [&mut world, &mut other] {
            world.go_back(&kept[from].0);
            for (frame, (_, expected)) in kept.iter().enumerate().skip(from) {
                assert!(bits(world) == *expected, "from frame {from}, at frame {frame}");
                world.advance_frame();
            }
        }
    }
    world.go_back(&kept[frames].0);
    assert_eq!(Snapshot::of(&world), Snapshot::of(&last));
}

#[test]
fn everything_that_a_scene_may_hold_goes_back_exactly() {
    let world = baked(&scene_from_json(CROWD).unwrap());
    let mut broken = world.clone();
    let mut met = false;
    for _ in 0..36 {
        broken.advance_frame();
        met |= broken.panels()[0].velocity > -9.0 * broken.time();
    }
    assert!(broken.bodies()[0].breaks().count() >= 2, "{} breaks", broken.bodies()[0].breaks().count());
    assert!(met, "the panel is held up");
    goes_back_exactly(&world, 36);
}

#[test]
fn in_fast_precision() {
    let mut scene = scene_from_json(CROWD).unwrap();
    scene.bodies[0].material.precision = Precision::Fast;
    goes_back_exactly(&baked(&scene), 12);
}

#[test]
fn under_every_integrator() {
    for kind in IntegratorKind::ALL {
        let mut scene = scene_from_json(CROWD).unwrap();
        // A frame of a thousandth of a second, so that the slow ones are soon done.
        scene.time.frames_per_second = 1000.0;
        scene.bodies[0].integrator = kind.into();
        scene.two_layer.iter_mut().for_each(|body| body.integrator = kind.into());
        goes_back_exactly(&baked(&scene), 6);
    }
}

#[test]
fn particles_too_dense_for_a_stencil_go_back_exactly() {
    let mut scene = scene_from_json(CROWD).unwrap();
    scene.two_layer.clear();
    scene.bodies[0].material.spacing_ratio = 0.28;
    let world = baked(&scene);
    let matrix = world.bodies()[0].parts().forces.iter().find_map(|force| force.downcast_ref::<MatrixForce>()).unwrap();
    assert!(!matrix.is_stencil());
    goes_back_exactly(&world, 6);
}

#[test]
fn pulls_go_back_with_the_body() {
    let mut world = baked(&scene_from_json(CROWD).unwrap());
    let body = world.body_mut(0).unwrap();
    body.grab(body.point(3).unwrap(), DVec3::new(0.1, 0.1, 0.0));
    goes_back_exactly(&world, 12);
}

/// A force and an integrator with a memory, of a library's user, who says nothing of checkpoints.
#[derive(Clone, Default)]
struct Fatigue {
    evaluations: f64,
}

impl Force for Fatigue {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        self.evaluations += 1.0;
        for (force, x) in forces.iter_mut().zip(&state.positions) {
            *force -= 0.1 / self.evaluations * *x;
        }
    }

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

#[derive(Clone, Default)]
struct TwoStep {
    before: Vec<DVec3>,
}

impl Integrator for TwoStep {
    fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
        let mut now = Vec::new();
        dynamics.start(time, state);
        dynamics.accelerations(state, &mut now);
        if self.before.is_empty() {
            self.before.clone_from(&now);
        }
        for i in 0..state.len() {
            state.velocities[i] += dt * (1.5 * now[i] - 0.5 * self.before[i]);
            state.positions[i] += dt * state.velocities[i];
        }
        self.before = now;
        dynamics.constrain(time + dt, state);
    }

    fn stable_step(&self, omega: f64, _damping: f64) -> f64 {
        1.0 / omega
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        Box::new(self.clone())
    }
}

#[test]
fn forces_and_integrators_of_others_are_right_by_default() {
    let mut world = baked(&scene_from_json(CROWD).unwrap());
    let body = world.body_mut(0).unwrap();
    body.add_force(Box::new(Fatigue::default()));
    body.set_integrator(Box::new(TwoStep::default()));
    assert_eq!(body.parts().integrator_word, "other");
    goes_back_exactly(&world, 12);
}

#[test]
fn a_stopped_body_goes_back_to_before_it_was_stopped() {
    let mut scene = scene_from_json(CROWD).unwrap();
    scene.two_layer.clear();
    let mut world = baked(&scene);
    world.advance_frame();
    let kept = world.checkpoint();
    world.body_mut(0).unwrap().strike(DVec3::X * 1e6);
    world.advance_frame();
    assert!(world.divergence().is_some());
    let stopped = (world.checkpoint(), bits(&world));
    world.go_back(&kept);
    assert!(world.divergence().is_none());
    world.advance_frame();
    assert!(world.divergence().is_none());
    world.go_back(&stopped.0);
    assert!(world.divergence().is_some() && bits(&world) == stopped.1);
}

/// A checkpoint takes little more than a hundred bytes a particle, whatever the rest data take, and says how many.
#[test]
fn a_checkpoint_is_small() {
    let mut scene = scene_from_json(CROWD).unwrap();
    scene.two_layer.clear();
    scene.panels.clear();
    let mut world = baked(&scene);
    world.advance_frame();
    let each = world.checkpoint().bytes() as f64 / world.bodies()[0].state().len() as f64;
    println!("{each:.0} bytes a particle");
    assert!((100.0..160.0).contains(&each), "{each}");
    assert!(world.bytes() > 4 * world.checkpoint().bytes(), "rest data are counted in the world");
}

#[test]
fn a_frame_that_is_ended_anywhere_leaves_all_as_if_it_had_never_begun() {
    let scene = scene_from_json(CROWD).unwrap();
    let mut whole = Runner::new(bake(&scene, &Assets::default()).unwrap());
    let mut ended = whole.clone();
    for frame in 0..4 {
        let before = bits(ended.world());
        let asked = Cell::new(0);
        // Asked so often in this frame; ended at each of some of them, first and last among them.
        let counted = whole.clone().advance_frame_unless(&|| {
            asked.set(asked.get() + 1);
            false
        });
        assert!(counted && asked.get() > 10, "asked {} times", asked.get());
        for at in [0, 1, asked.get() / 3, asked.get() / 2, asked.get() - 1] {
            let left = Cell::new(at);
            assert!(!ended.advance_frame_unless(&|| left.replace(left.get() - 1) == 0), "frame {frame}, at {at}");
            assert!(bits(ended.world()) == before, "frame {frame}, ended at {at}");
        }
        whole.advance_frame();
        assert!(ended.advance_frame_unless(&|| false));
        assert!(bits(ended.world()) == bits(whole.world()), "frame {frame}");
    }
}
