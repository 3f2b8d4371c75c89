//! What the simulation thread does when the solver fails.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::solver::energy::Energies;
use crate::solver::forces::Force;
use crate::solver::state::ParticleState;
use glam::DVec3;

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

#[test]
fn a_panic_in_the_solver_is_reported_and_a_reset_goes_on() {
    let slot: Slot = Arc::default();
    let out = Out { slot: Arc::clone(&slot), records: Arc::default(), notify: Box::new(|| {}) };
    let scene: Scene =
        serde_json::from_str(r#"{"version": 1, "two_layer": [{"id": "ring", "shape": {"ring": {}}}]}"#).unwrap();
    let mut worker = Loop::new(Arc::new(scene), Arc::default(), true, out);
    worker.put_together(false);
    worker.runner.as_mut().unwrap().body_mut(0).unwrap().add_force(Box::new(Faulty));
    worker.advance();
    worker.publish();
    let published = slot.lock().unwrap().take().unwrap();
    assert!(published.status.failure.as_ref().is_some_and(|text| text.contains("out of cheese")));
    assert!(!published.status.playing);
    // What was kept is still there to go on from.
    worker.obey(SimCommand::StepBack);
    assert!(worker.in_replay());
    worker.obey(SimCommand::ContinueHere);
    assert!(worker.status.failure.is_none() && !worker.in_replay());
    worker.obey(SimCommand::Step);
    assert!(worker.runner.as_ref().is_some_and(|runner| runner.world().time() > 0.0));
    worker.obey(SimCommand::Reset);
    worker.obey(SimCommand::Step);
    assert!(worker.status.failure.is_none());
    assert!(worker.runner.as_ref().is_some_and(|runner| runner.world().time() > 0.0));
}
