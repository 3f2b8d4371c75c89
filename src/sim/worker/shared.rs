//! What the simulation thread hands to the window.

use super::time_series_set::TimeSeriesSet;
use crate::scene::Scene;
use crate::sim::journal::Journal;
use crate::sim::status::Published;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What both sides can reach: the newest picture, and the numbers of every frame.
#[derive(Clone, Default)]
pub(super) struct Shared {
    latest: Arc<Mutex<Option<Arc<Published>>>>,
    series: Arc<Mutex<TimeSeriesSet>>,
    journal: Arc<Mutex<Option<Journal>>>,
}

impl Shared {
    /// The newest picture since the last call.
    pub(super) fn take(&self) -> Option<Arc<Published>> {
        lock(&self.latest).take()
    }

    /// Reads or writes the numbers; the other side waits meanwhile.
    pub(super) fn with_series<T>(&self, work: impl FnOnce(&mut TimeSeriesSet) -> T) -> T {
        work(&mut lock(&self.series))
    }

    /// Reads or writes the journal; the other side waits meanwhile.
    pub(super) fn with_journal<T>(&self, work: impl FnOnce(&mut Journal) -> T) -> T {
        work(lock(&self.journal).get_or_insert_with(|| Journal::new(Arc::new(Scene::new("")))))
    }
}

/// The thread's side.
pub(super) struct Outlet {
    shared: Shared,
    notify: Box<dyn Fn() + Send>,
}

impl Outlet {
    /// Calls `notify` after every picture.
    pub(super) fn new(shared: Shared, notify: impl Fn() + Send + 'static) -> Self {
        Self { shared, notify: Box::new(notify) }
    }

    /// Hands a picture over in place of the last one.
    pub(super) fn publish(&self, published: Published) {
        *lock(&self.shared.latest) = Some(Arc::new(published));
        (self.notify)();
    }

    /// Writes the numbers.
    pub(super) fn with_series(&self, work: impl FnOnce(&mut TimeSeriesSet)) {
        self.shared.with_series(work);
    }

    /// Writes the journal.
    pub(super) fn with_journal<T>(&self, work: impl FnOnce(&mut Journal) -> T) -> T {
        self.shared.with_journal(work)
    }
}

/// What a mutex guards. A thread that failed while it held it has left nothing half done: all is replaced as a whole.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
