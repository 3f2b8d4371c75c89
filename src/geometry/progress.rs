//! How far a long piece of work has come, and whether it is still wanted.

use std::ops::ControlFlow;

/// Hears how many of how many steps are done, at most; breaks off what is no longer wanted.
pub(crate) type Progress<'a> = dyn FnMut(usize, usize) -> ControlFlow<()> + 'a;

/// Asked from time to time whether to go on.
pub(crate) type GoOn<'a> = dyn FnMut() -> ControlFlow<()> + 'a;

/// Work in so many steps, of which some take long.
pub(crate) struct Steps<'a, 'b> {
    done: usize,
    of: usize,
    progress: &'a mut Progress<'b>,
}

impl<'a, 'b> Steps<'a, 'b> {
    /// None of so many is done.
    pub(crate) fn new(of: usize, progress: &'a mut Progress<'b>) -> Self {
        Self { done: 0, of, progress }
    }

    /// So many are done, at least; what begins anew has come no less far.
    pub(crate) fn reach(&mut self, done: usize) -> ControlFlow<()> {
        self.done = self.done.max(done).min(self.of);
        self.ask()
    }

    /// Whether to go on with the step that is under way.
    pub(crate) fn ask(&mut self) -> ControlFlow<()> {
        (self.progress)(self.done, self.of)
    }
}
