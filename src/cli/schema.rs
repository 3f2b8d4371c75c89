//! `sinew schema`: the JSON Schema of scene files.

use super::{CliError, Console, Outcome};
use crate::io::scene_schema;

/// Prints the schema.
///
/// # Errors
/// [`CliError::Output`].
pub(super) fn run(console: &mut Console) -> Result<Outcome, CliError> {
    console.print(&format!("{:#}\n", scene_schema()))?;
    Ok(Outcome::Done)
}
