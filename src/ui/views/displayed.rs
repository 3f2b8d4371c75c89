//! What a view shows of the bodies: the model at rest that is drawn into, or the simulation.

use super::kind::PaneKind;
use crate::sim::Published;
use crate::solver::snapshot::Snapshot;
use crate::ui::context::Context;
use std::ops::Deref;
use std::sync::Arc;

/// A state of the bodies, shared with who made it.
#[derive(Clone, Debug)]
pub(crate) enum DisplayedState {
    /// A body at rest, as it is drawn into.
    Model(Arc<Snapshot>),
    /// The simulation.
    Running(Arc<Published>),
    /// The bodies as they would be placed.
    Placed(Arc<Snapshot>),
}

impl Deref for DisplayedState {
    type Target = Snapshot;

    fn deref(&self) -> &Snapshot {
        match self {
            Self::Model(snapshot) | Self::Placed(snapshot) => snapshot,
            Self::Running(published) => &published.snapshot,
        }
    }
}

impl PartialEq for DisplayedState {
    /// Whether it is the same one: what is published is never changed.
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Model(a), Self::Model(b)) | (Self::Placed(a), Self::Placed(b)) => Arc::ptr_eq(a, b),
            (Self::Running(a), Self::Running(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

impl DisplayedState {
    /// What a view of this kind shows.
    pub(crate) fn of(kind: PaneKind, cx: &Context) -> Self {
        match kind {
            PaneKind::Result if cx.placed.is_some() => Self::Placed(cx.placed.clone().unwrap_or_default()),
            PaneKind::Result => Self::Running(Arc::clone(cx.simulation.published())),
            PaneKind::Drawing(_) => Self::Model(Arc::clone(&cx.active.model)),
        }
    }

    /// The place of the active body among the bodies that are shown.
    pub(crate) fn active(&self, cx: &Context) -> usize {
        match self {
            Self::Running(_) | Self::Placed(_) => cx.active.index,
            Self::Model(_) => 0,
        }
    }
}
