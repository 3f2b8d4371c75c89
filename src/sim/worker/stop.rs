//! Whether what is being put together is still wanted.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Flags that end the putting together of a scene at its next sign of progress. Copies share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Stop(Arc<Flags>);

#[derive(Debug, Default)]
struct Flags {
    outdated: AtomicBool,
    asked: AtomicBool,
}

impl Stop {
    /// A newer request makes it pointless.
    pub(super) fn outdate(&self) {
        self.0.outdated.store(true, Ordering::SeqCst);
    }

    /// Somebody asks for it.
    pub(super) fn ask(&self) {
        self.0.asked.store(true, Ordering::SeqCst);
    }

    /// Nothing stops what begins now.
    pub(super) fn clear(&self) {
        self.0.outdated.store(false, Ordering::SeqCst);
        self.0.asked.store(false, Ordering::SeqCst);
    }

    /// Whether it is to end.
    pub(super) fn is_set(&self) -> bool {
        self.is_asked() || self.0.outdated.load(Ordering::SeqCst)
    }

    /// Whether somebody asked for that.
    pub(super) fn is_asked(&self) -> bool {
        self.0.asked.load(Ordering::SeqCst)
    }
}
