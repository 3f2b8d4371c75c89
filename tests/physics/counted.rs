//! Evaluations that are reported are all there were, those for the stiffness of implicit steps among them.

use crate::common::*;
use crate::two_layer::{ring, two_layer, with};
use glam::DVec3;
use serde_json::json;
use sinew::scene::{Axis, IntegratorKind, Motion, Scene, Side};
use sinew::solver::{Energies, Force, ParticleState};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// A weak spring to the origin from every particle [N/m] that counts how often it, or any copy of it, is asked.
#[derive(Clone)]
struct Counted {
    stiffness: f64,
    asked: Arc<AtomicU64>,
}

impl Force for Counted {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        self.asked.fetch_add(1, Ordering::Relaxed);
        for (force, &x) in forces.iter_mut().zip(&state.positions) {
            *force -= self.stiffness * x;
        }
    }
    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.springs += state.positions.iter().map(|x| 0.5 * self.stiffness * x.length_squared()).sum::<f64>();
    }
    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

/// Frames of a scene's first body with such a spring: evaluations as they are reported and as they were counted.
fn reported_and_counted(scene: &Scene, frames: u32) -> [u64; 2] {
    let mut world = baked(scene).world;
    let asked = Arc::new(AtomicU64::new(0));
    let body = world.body_mut(0).expect("a body");
    let before = body.evaluations();
    body.add_force(Box::new(Counted { stiffness: 1e-3, asked: Arc::clone(&asked) }));
    (0..frames).for_each(|_| world.advance_frame());
    assert!(world.divergence().is_none(), "{:?}", world.divergence());
    [world.bodies()[0].evaluations() - before, asked.load(Ordering::Relaxed)]
}

#[test]
fn every_evaluation_under_any_integrator_is_counted() {
    for integrator in IntegratorKind::ALL {
        // A solid, whose matrix turns with it, one that strikes the floor, and a body of springs, which is asked anew.
        let mut held = block([3, 4, 3], 1e5);
        held.material.damping.pair = 20.0;
        held.initial.deformation = [[1.1, 0.05, 0.0], [0.0, 0.95, 0.0], [0.0, 0.0, 1.0]];
        let mut falling = in_space(held.clone());
        falling.bodies[0].initial.velocity = [0.0, -1.0, 0.0];
        falling.room.floor = Some(-0.001);
        held.regions = vec![layers("foot", Axis::Y, Side::Min, 1)];
        held.pins = vec![pin("foot", &ALL, Motion::Fixed)];
        let spun = two_layer(&[with(ring(), json!({"initial": {"angular_velocity": [0, 0, 3]}}))], json!({}));
        for (what, mut scene) in [("held", in_space(held)), ("falling", falling), ("ring", spun)] {
            match scene.bodies.first_mut() {
                Some(body) => body.integrator = integrator.into(),
                None => scene.two_layer[0].integrator = integrator.into(),
            }
            if integrator == IntegratorKind::FibresImplicit && scene.bodies.is_empty() {
                continue;
            }
            scene.time.frames_per_second = 500.0;
            let [reported, counted] = reported_and_counted(&scene, 2);
            println!("{integrator:?}, {what}: {reported} reported, {counted} counted");
            assert_eq!(reported, counted, "{integrator:?}, {what}");
            assert!(counted > 2, "{integrator:?}, {what}");
        }
    }
}
