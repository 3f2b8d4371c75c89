//! What is noticed while a scene is put together.

use std::fmt;

/// Something worth knowing that does not stop the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// Pointer to what it is about.
    pub path: String,
    /// What happened, with its figures.
    pub text: String,
    /// Whether the person should act on it.
    pub warning: bool,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path, self.text)
    }
}
