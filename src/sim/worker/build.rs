//! What may fail: putting a scene together, and every step of the solver.

use crate::bake::{BakeStage, Baked, bake_with_progress};
use crate::scene::{Assets, Scene};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Puts a scene together; `progress` hears the name of a body and what is being worked on.
///
/// # Errors
/// Why it cannot be.
pub(super) fn build(
    scene: &Scene,
    assets: &Assets,
    progress: &mut dyn FnMut(&str, BakeStage),
) -> Result<Baked, String> {
    guarded(|| {
        scene.validate().map_err(|error| error.to_string())?;
        bake_with_progress(scene, assets, progress).map_err(|error| error.to_string())
    })
    .flatten()
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
