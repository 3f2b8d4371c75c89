//! Other programs: the unit and the axes that they take numbers for.

use crate::export::Space;
use crate::geometry::model::UpAxis;

/// A program that motions are made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Program {
    /// Blender: metres, Z up.
    Blender,
    /// Houdini: metres, Y up.
    Houdini,
    /// Maya: centimetres, Y up.
    Maya,
    /// Unreal Engine: centimetres, Z up. Its axes are left-handed; its importers see to that.
    Unreal,
}

impl Program {
    /// All of them, by the names that people know.
    pub(crate) const ALL: [(&'static str, Self); 4] =
        [("Blender", Self::Blender), ("Houdini", Self::Houdini), ("Maya", Self::Maya), ("Unreal", Self::Unreal)];

    /// The unit and axes of its scenes as they are set up unless somebody changes them.
    pub(crate) fn space(self) -> Space {
        let (up, scale) = match self {
            Self::Blender => (UpAxis::Z, 1.0),
            Self::Houdini => (UpAxis::Y, 1.0),
            Self::Maya => (UpAxis::Y, 100.0),
            Self::Unreal => (UpAxis::Z, 100.0),
        };
        Space { up, scale }
    }
}
