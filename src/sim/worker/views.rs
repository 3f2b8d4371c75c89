//! What the window asked to see besides positions: a field over the bodies, and the tensions and activations of fibres.

use crate::sim::runner::Runner;
use crate::solver::snapshot::{ActivationSnapshot, FieldKind, FieldSnapshot, Snapshot, TensionSnapshot};
use crate::solver::world::World;

/// Share of the way by which a range narrows from one picture to the next: a second or so in all.
const NARROWING: f64 = 0.03;

/// What goes into every picture.
#[derive(Default)]
pub(super) struct ViewRequests {
    field: Option<FieldKind>,
    /// Upper end of the field's range.
    field_end: f64,
    tension: bool,
    /// End of the range of tensions [N].
    tension_end: f64,
    activation: bool,
}

impl ViewRequests {
    /// Shows a field from now on, or none.
    pub(super) fn choose_field(&mut self, field: Option<FieldKind>) {
        self.field = field;
        self.field_end = 0.0;
    }

    /// Shows tensions from now on, or no longer.
    pub(super) fn choose_tension(&mut self, on: bool) {
        self.tension = on;
        self.tension_end = 0.0;
    }

    /// Shows what fibres do by themselves from now on, or no longer.
    pub(super) fn choose_activation(&mut self, on: bool) {
        self.activation = on;
    }

    /// Begins new ranges.
    pub(super) fn forget_ranges(&mut self) {
        (self.field_end, self.tension_end) = (0.0, 0.0);
    }

    /// Positions of a run with what was asked for.
    pub(super) fn picture(&mut self, run: &Runner) -> Snapshot {
        let mut snapshot = run.particles();
        snapshot.field = self.field(run.world());
        snapshot.tension = self.tension(run.world());
        snapshot.activation = self.activation.then(|| ActivationSnapshot::of(run.world()));
        snapshot
    }

    /// The range widens at once, so that nothing is cut off, and narrows slowly, so that colours keep their meaning
    /// through a swing.
    fn field(&mut self, world: &World) -> Option<FieldSnapshot> {
        let mut field = FieldSnapshot::of(world, self.field?);
        field.range[1] = followed(&mut self.field_end, field.range[1]);
        Some(field)
    }

    fn tension(&mut self, world: &World) -> Option<TensionSnapshot> {
        let mut tension = self.tension.then(|| TensionSnapshot::of(world))?;
        tension.range = followed(&mut self.tension_end, tension.range);
        Some(tension)
    }
}

/// The end of a range that follows what it has to hold now.
fn followed(end: &mut f64, now: f64) -> f64 {
    *end = now.max(*end + NARROWING * (now - *end));
    *end
}
