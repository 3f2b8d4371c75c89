//! What the thread tells the window after every frame.

use super::Loop;
use crate::sim::status::{Published, Status, Stepping};
use crate::solver::body::Body;
use crate::solver::snapshot::Snapshot;
use std::sync::Arc;

impl Loop {
    /// Hands the newest picture over, of the frame that is shown.
    pub(super) fn publish(&mut self) {
        let _publish = tracing::info_span!("publish").entered();
        let mut snapshot = Snapshot::default();
        let (field, tension, mut ghost) = (self.field(), self.tension(), self.ghost());
        self.status.recording = self.timeline();
        if let Some(runner) = self.shown() {
            let world = runner.world();
            snapshot = runner.particles();
            (snapshot.field, snapshot.tension) = (field, tension);
            let plan = world.plan();
            let stepping = |(body, count): (&Body, &u32)| Stepping {
                name: body.parts().name.clone(),
                dt: body.parts().dt,
                stable_dt: body.parts().stable_dt,
                limited_by: body.parts().limited_by.clone(),
                substeps: count * plan.outer_steps,
            };
            self.status = Status {
                time: world.time(),
                bodies: world.bodies().iter().zip(&plan.substeps).map(stepping).collect(),
                particles: world.bodies().iter().map(|body| body.state().len()).sum(),
                divergence: world.divergence().map(ToString::to_string),
                measures: world.measures(),
                ..std::mem::take(&mut self.status)
            };
        }
        let mut compared = Vec::new();
        if let Some(side_by_side) = &self.side_by_side {
            snapshot = side_by_side.snapshot();
            ghost = None;
            self.status.time = snapshot.time;
            compared = side_by_side.compared();
        }
        let at_rest = Arc::clone(&self.at_rest);
        self.out.publish(Published {
            snapshot,
            ghost,
            at_rest,
            placed: self.placed,
            status: self.status.clone(),
            compared,
        });
    }
}
