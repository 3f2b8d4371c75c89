//! What the simulation thread does when the solver fails.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::shared::{Outlet, Shared};
use super::simulation::Simulation;
use crate::scene::Scene;
use crate::sim::command::SimCommand;
use crate::sim::runner::Runner;
use crate::solver::energy::Energies;
use crate::solver::forces::Force;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// A force with a fault.
#[derive(Clone)]
struct Faulty;

impl Force for Faulty {
    fn add_forces(&mut self, _time: f64, _state: &ParticleState, _forces: &mut [DVec3]) {
        panic!("out of cheese");
    }

    fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

fn runner(simulation: &mut Simulation) -> Option<&mut Runner> {
    simulation.motion.runs.live.runner_mut()
}

#[test]
fn a_panic_in_the_solver_is_reported_and_a_reset_goes_on() {
    let shared = Shared::default();
    let outlet = Outlet::new(shared.clone(), || {});
    let scene: Scene =
        serde_json::from_str(r#"{"version": 1, "two_layer": [{"id": "ring", "shape": {"ring": {}}}]}"#).unwrap();
    let mut simulation = Simulation::new(Arc::new(scene), Arc::default(), true, outlet);
    simulation.start();
    runner(&mut simulation).unwrap().body_mut(0).unwrap().add_force(Box::new(Faulty));
    simulation.motion.advance();
    simulation.motion.publish();
    let published = shared.take().unwrap();
    assert!(published.status.failure.as_ref().is_some_and(|text| text.contains("out of cheese")));
    assert!(!published.status.playing);
    // What was kept is still there to go on from.
    simulation.handle(SimCommand::StepBack, 0);
    assert!(simulation.motion.replay.is_active());
    simulation.handle(SimCommand::ContinueHere, 0);
    assert!(simulation.motion.status.failure.is_none() && !simulation.motion.replay.is_active());
    simulation.handle(SimCommand::Step, 0);
    assert!(runner(&mut simulation).is_some_and(|runner| runner.world().time() > 0.0));
    simulation.handle(SimCommand::Reset, 0);
    simulation.handle(SimCommand::Step, 0);
    assert!(simulation.motion.status.failure.is_none());
    assert!(runner(&mut simulation).is_some_and(|runner| runner.world().time() > 0.0));
}
