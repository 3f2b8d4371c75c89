//! The work done on a world from outside since it began, as it goes.

use crate::solver::body::Body;
use crate::solver::outside_body::{OutsideBody, WorkOnBody, is_moved};
use crate::solver::panel::Panel;

/// The work that moved pins, driven panels and forces from outside have done.
#[derive(Clone, Debug, Default)]
pub(super) struct DoneWork {
    /// On each body [J].
    pub(super) on_bodies: Vec<WorkOnBody>,
    /// By driven panels [J].
    pub(super) by_panels: f64,
}

/// That work, and what it is told from next.
#[derive(Clone, Debug, Default)]
pub(super) struct OutsideWork {
    done: DoneWork,
    /// What moved pins held of each body when that was last added; none of a body without any.
    held: Vec<Option<OutsideBody>>,
    /// What was pushed of each at the last frame.
    pushed: Vec<OutsideBody>,
    /// Height of every panel [m] and the force on it from below [N] at the last outer step.
    panels: Vec<[f64; 2]>,
}

impl OutsideWork {
    /// Makes ready for a frame that begins at `time` [s], where nothing is known of the one before.
    pub(super) fn begin(&mut self, bodies: &[Body], (panels, pushes): (&[Panel], &[f64]), time: f64) {
        self.done.on_bodies.resize(bodies.len(), WorkOnBody::default());
        if self.held.len() != bodies.len() {
            self.held = bodies.iter().map(|body| is_moved(body).then(|| OutsideBody::held_of(body))).collect();
            self.pushed = bodies.iter().map(|body| OutsideBody::pushed_of(body, time)).collect();
            self.panels = now(panels, pushes);
        }
    }

    /// Adds what was done on a body up to its present state.
    pub(super) fn add_held(&mut self, index: usize, body: &Body) {
        // One that diverged was put back to where it was good, by nobody.
        if let Some(before) = &mut self.held[index]
            && body.divergence().is_none()
        {
            let now = OutsideBody::held_of(body);
            self.done.on_bodies[index].add(before.work_until(&now));
            *before = now;
        }
    }

    /// Adds what driven panels did in an outer step.
    pub(super) fn add_panels(&mut self, panels: &[Panel], pushes: &[f64]) {
        let now = now(panels, pushes);
        for (panel, (a, b)) in panels.iter().zip(self.panels.iter().zip(&now)) {
            if panel.driven.is_some() {
                self.done.by_panels -= 0.5 * (a[1] + b[1]) * (b[0] - a[0]);
            }
        }
        self.panels = now;
    }

    /// Adds all that is left of a frame that ends at `time` [s].
    pub(super) fn end(&mut self, bodies: &[Body], time: f64) {
        for (index, body) in bodies.iter().enumerate().filter(|(_, body)| body.divergence().is_none()) {
            self.add_held(index, body);
            let now = OutsideBody::pushed_of(body, time);
            self.done.on_bodies[index].add(self.pushed[index].work_until(&now));
            self.pushed[index] = now;
        }
    }

    /// What was done so far.
    pub(super) fn done(&self) -> DoneWork {
        self.done.clone()
    }

    /// What was done on a body by its index [J], what it passed on to others left out.
    pub(super) fn on_itself(&self, body: usize) -> f64 {
        self.done.on_bodies.get(body).map_or(0.0, |done| done.work - done.passed_on)
    }

    /// As much done, and nothing known of the last frame.
    pub(super) fn from_here_on(done: DoneWork) -> Self {
        Self { done, ..Self::default() }
    }

    /// What goes on in a world in which these bodies, by their index in this one, go on.
    pub(super) fn taken_on(&self, goes_on: &[Option<usize>]) -> Self {
        let on = |was: &Option<usize>| was.and_then(|was| self.done.on_bodies.get(was).copied()).unwrap_or_default();
        Self::from_here_on(DoneWork { on_bodies: goes_on.iter().map(on).collect(), ..self.done })
    }
}

fn now(panels: &[Panel], pushes: &[f64]) -> Vec<[f64; 2]> {
    panels.iter().zip(pushes).map(|(panel, &push)| [panel.height, push]).collect()
}
