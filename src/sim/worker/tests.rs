//! What the simulation thread does when the solver fails, and when a scene is no longer wanted.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::queue::command_queue;
use super::shared::{Outlet, Shared};
use super::simulation::Simulation;
use super::stop::Stop;
use crate::scene::Scene;
use crate::sim::command::SimCommand;
use crate::sim::runner::Runner;
use crate::solver::dynamics::Dynamics;
use crate::solver::energy::Energies;
use crate::solver::forces::Force;
use crate::solver::integrators::Integrator;
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
    let mut simulation = Simulation::new(Arc::new(scene), Arc::default(), true, outlet, Stop::default());
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

/// Loses a place, and no velocity by which that would be noticed.
#[derive(Clone)]
struct Losing;

impl Integrator for Losing {
    fn step(&mut self, _dynamics: &mut Dynamics<'_>, state: &mut ParticleState, _time: f64, _dt: f64) {
        state.positions[1].y = f64::NAN;
    }

    fn stable_step(&self, _omega: f64, _damping: f64) -> f64 {
        1.0
    }

    fn clone_box(&self) -> Box<dyn Integrator> {
        Box::new(self.clone())
    }
}

#[test]
fn a_place_that_is_no_number_is_said_with_its_body_and_a_reset_goes_on() {
    let shared = Shared::default();
    let mut simulation =
        Simulation::new(scene(4), Arc::default(), true, Outlet::new(shared.clone(), || {}), Stop::default());
    simulation.start();
    simulation.motion.publish();
    assert_eq!(shared.take().unwrap().status.lost, None);
    runner(&mut simulation).unwrap().body_mut(0).unwrap().set_integrator(Box::new(Losing));
    simulation.motion.advance();
    simulation.motion.publish();
    let status = shared.take().unwrap().status.clone();
    let said = status.lost.clone().unwrap();
    assert!(said.starts_with("body \"bar\": at 0.016667 s a point of it is no longer a finite number"), "{said}");
    assert!(said.contains("take a smaller step (/time/step/automatic/safety)"), "{said}");
    assert!(!status.playing);
    simulation.handle(SimCommand::Reset, 0);
    simulation.motion.publish();
    assert_eq!(shared.take().unwrap().status.lost, None);
    simulation.handle(SimCommand::Step, 0);
    assert!(runner(&mut simulation).is_some_and(|runner| runner.particles().not_finite().is_none()));
}

/// A box of so many particles along its length.
fn scene(length: u32) -> Arc<Scene> {
    let size = 0.006 * f64::from(length);
    let text = format!(
        r#"{{"version": 1, "bodies": [{{"id": "bar", "shape": {{"box": {{"size": [{size}, 0.03, 0.03]}}}},
            "material": {{"young_modulus": 1e5, "mass": {{"per_particle": 4e-4}}, "support_radius": 0.015}}}}]}}"#
    );
    Arc::new(serde_json::from_str(&text).unwrap())
}

fn particles(simulation: &mut Simulation) -> Option<usize> {
    runner(simulation).map(|runner| runner.world().bodies()[0].state().len())
}

#[test]
fn a_newer_document_ends_the_work_on_an_older_one_and_is_put_together() {
    let (sender, receiver) = command_queue();
    let outlet = Outlet::new(Shared::default(), || {});
    let mut simulation = Simulation::new(scene(4), Arc::default(), false, outlet, receiver.stop());
    simulation.start();
    assert_eq!(particles(&mut simulation), Some(100));
    let hear = |simulation: &mut Simulation, newer: Option<SimCommand>| {
        receiver.begin(None).unwrap();
        while let Some(request) = receiver.next() {
            // As if it came while the work on this one is going on.
            if let Some(command) = &newer {
                assert!(sender.send(command.clone()));
            }
            simulation.handle(request.command, request.documents);
        }
    };
    let send = |command: SimCommand| assert!(sender.send(command));
    send(SimCommand::Edit(scene(5)));
    hear(&mut simulation, Some(SimCommand::Edit(scene(6))));
    // The older one was not put together, and nobody is told.
    assert_eq!(particles(&mut simulation), Some(100));
    assert!(!simulation.motion.status.stopped && simulation.motion.status.failure.is_none());
    hear(&mut simulation, None);
    assert_eq!(particles(&mut simulation), Some(150));
    assert_eq!(simulation.motion.status.edits, 2);
    // A document that only looks otherwise than one that was never put together is.
    send(SimCommand::Edit(scene(7)));
    let mut named = (*scene(7)).clone();
    named.name = "another".to_owned();
    hear(&mut simulation, Some(SimCommand::Edit(Arc::new(named))));
    assert_eq!(particles(&mut simulation), Some(150));
    hear(&mut simulation, None);
    assert_eq!(particles(&mut simulation), Some(175));
    // One that is opened and edited before it was put together begins anew.
    simulation.handle(SimCommand::Step, 0);
    send(SimCommand::Open(scene(8), Arc::default()));
    hear(&mut simulation, Some(SimCommand::Edit(scene(9))));
    assert_eq!(particles(&mut simulation), None);
    hear(&mut simulation, None);
    assert_eq!(particles(&mut simulation), Some(225));
    assert_eq!(simulation.motion.replay.recording().len(), 1);
    simulation.handle(SimCommand::Step, 0);
    assert!(runner(&mut simulation).is_some_and(|runner| runner.world().time() > 0.0));
}

#[test]
fn what_somebody_stops_is_told_and_a_reset_puts_it_together() {
    let (sender, receiver) = command_queue();
    let outlet = Outlet::new(Shared::default(), || {});
    let mut simulation = Simulation::new(scene(4), Arc::default(), false, outlet, receiver.stop());
    simulation.start();
    assert!(sender.send(SimCommand::Edit(scene(5))));
    receiver.begin(None).unwrap();
    let request = receiver.next().unwrap();
    sender.stop();
    simulation.handle(request.command, request.documents);
    assert_eq!(particles(&mut simulation), Some(100));
    assert!(simulation.motion.status.stopped && simulation.motion.status.failure.is_none());
    // The old one still moves.
    assert!(receiver.next().is_none());
    simulation.handle(SimCommand::Step, 0);
    assert!(simulation.motion.status.stopped);
    simulation.handle(SimCommand::Reset, 0);
    assert_eq!(particles(&mut simulation), Some(125));
    assert!(!simulation.motion.status.stopped);
}
