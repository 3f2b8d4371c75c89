//! What may fail: putting a scene together, and every step of the solver.

use crate::bake::{BakeError, BakeStage, Baked, bake_with_progress};
use crate::scene::{Assets, Scene};
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Hears the name of a body and what is being worked on; breaks off what is no longer wanted.
pub(super) type Tell<'a> = dyn FnMut(&str, BakeStage) -> ControlFlow<()> + 'a;

/// Puts a scene together; none where `progress` broke off.
///
/// # Errors
/// Why it cannot be.
pub(super) fn build(scene: &Scene, assets: &Assets, progress: &mut Tell<'_>) -> Result<Option<Baked>, String> {
    unless_stopped(|| {
        scene.validate().map_err(|error| error.to_string())?;
        Ok(bake_with_progress(scene, assets, progress))
    })
}

/// What comes of putting a scene together; none where that was stopped.
///
/// # Errors
/// Why it cannot be.
pub(super) fn unless_stopped<T>(
    work: impl FnOnce() -> Result<Result<T, BakeError>, String>,
) -> Result<Option<T>, String> {
    match guarded(work).flatten()? {
        Ok(built) => Ok(Some(built)),
        Err(BakeError::Cancelled) => Ok(None),
        Err(error) => Err(error.to_string()),
    }
}

/// Does what may panic. What it worked on cannot be trusted after an error.
///
/// # Errors
/// What the panic said.
pub(super) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| {
        let said = panic
            .downcast_ref::<&str>()
            .map(|text| (*text).to_owned())
            .or_else(|| panic.downcast_ref::<String>().cloned())
            .unwrap_or_else(|| "no message".to_owned());
        format!("the solver failed ({said}); the document is unharmed: undo the last change or reset")
    })
}
