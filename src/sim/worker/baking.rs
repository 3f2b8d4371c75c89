//! How the thread puts its world together from the document.

use super::Loop;
use crate::bake::{Baked, bake_with_progress};
use crate::scene::Scene;
use crate::sim::Runner;
use crate::sim::side_by_side::SideBySide;
use crate::solver::snapshot::Snapshot;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

impl Loop {
    /// Bakes the scene. After an edit the motion goes on; where the scene cannot be put together, the old world does.
    pub(super) fn put_together(&mut self, keep_motion: bool) {
        let scene = Arc::clone(&self.scene);
        let result = catch_unwind(AssertUnwindSafe(|| self.bake(&scene)));
        self.status.baking = None;
        match result {
            Ok(Ok(baked)) => {
                self.status.notes = baked.notes.iter().map(ToString::to_string).collect();
                self.status.failure = None;
                let fresh = Runner::new(baked);
                self.at_rest = Arc::new(Snapshot::in_model_frames(fresh.world()));
                self.placed = fresh.world().placed();
                self.start = Some(Arc::new(fresh.clone()));
                let mut runner = fresh;
                if let Some(before) = self.runner.as_ref().filter(|_| keep_motion) {
                    runner.adopt(before);
                }
                self.runner = Some(runner);
                if !keep_motion {
                    self.record_anew();
                }
                self.start_comparison();
            }
            Ok(Err(problem)) => self.status.failure = Some(problem),
            Err(panic) => self.status.failure = Some(describe(panic.as_ref())),
        }
    }

    /// Nothing is left of the last document.
    pub(super) fn forget(&mut self) {
        self.live();
        self.look_ahead();
        self.replay.recording.clear();
        self.forget_readings();
        (self.start, self.runner, self.placed) = (None, None, None);
        self.at_rest = Arc::default();
        self.status.divergence = None;
        self.status.bodies.clear();
        self.status.measures.clear();
    }

    pub(super) fn bake(&mut self, scene: &Scene) -> Result<Baked, String> {
        scene.validate().map_err(|error| error.to_string())?;
        let mut shown = Instant::now();
        let assets = Arc::clone(&self.assets);
        bake_with_progress(scene, &assets, &mut |name, stage| {
            self.status.baking = Some(format!("{name}: {stage}"));
            // Only what takes long enough to be read is shown.
            if shown.elapsed() > Duration::from_millis(200) {
                shown = Instant::now();
                self.publish();
            }
        })
        .map_err(|error| error.to_string())
    }

    /// Starts what is to be compared from the start of the scene; nothing where nothing is.
    pub(super) fn start_comparison(&mut self) {
        self.side_by_side = None;
        let (integrators, dt) = &self.wanted;
        if integrators.is_empty() {
            return;
        }
        match SideBySide::new(&self.scene, &self.assets, integrators, *dt) {
            Ok(side_by_side) => self.side_by_side = Some(side_by_side),
            Err(problem) => self.status.failure = Some(problem.to_string()),
        }
    }
}

/// What a panic said.
pub(super) fn describe(panic: &(dyn std::any::Any + Send)) -> String {
    let said = panic
        .downcast_ref::<&str>()
        .map(|text| (*text).to_owned())
        .or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".to_owned());
    format!("the solver failed ({said}); the document is unharmed: undo the last change or reset")
}
