//! What a person wants to see.

use super::{Colour, Slice};

/// What is shown.
#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::struct_excessive_bools, reason = "independent switches, as a person flips them")]
pub struct Display {
    /// How skins are shown.
    pub skin: SkinStyle,
    /// Material particles as cool balls, as in figure 3 of the fibre paper.
    pub particles: bool,
    /// Fibres as round tubes, sheets as films.
    pub fibres: bool,
    /// Structure particles as warm balls.
    pub structure: bool,
    /// Springs of two-layer bodies, each kind in its own colour, and the particles of their layers.
    pub springs: bool,
    /// Raw strokes, at rest, in the planes in which they were drawn.
    pub strokes: bool,
    /// Grid, with the axes on it and its scale beside it.
    pub grid: bool,
    /// Directions of the axes in a corner.
    pub axes: bool,
    /// Walls and ceiling of the room, faintly.
    pub room: bool,
    /// Where bodies are cut open; fibres stay whole.
    pub slice: Option<Slice>,
    /// Colours of the bodies in the order of the snapshot; the theme's where there is none.
    pub tints: Vec<Colour>,
    /// Fibres that are selected: (body, fibre), in the order of the snapshot.
    pub selected: Vec<[u32; 2]>,
    /// Sheets that are selected, likewise.
    pub selected_sheets: Vec<[u32; 2]>,
    /// Which of the scene's bodies is the snapshot's first: another than 0 where one body is shown alone.
    pub first_body: usize,
}

/// How skins are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SkinStyle {
    /// Lit and opaque.
    #[default]
    Shaded,
    /// See-through.
    XRay,
    /// Not at all.
    Hidden,
}

impl Default for Display {
    fn default() -> Self {
        Self {
            skin: SkinStyle::Shaded,
            particles: false,
            fibres: true,
            structure: false,
            springs: false,
            strokes: false,
            grid: true,
            axes: true,
            room: true,
            slice: None,
            tints: Vec::new(),
            selected: Vec::new(),
            selected_sheets: Vec::new(),
            first_body: 0,
        }
    }
}

impl Display {
    /// The solid see-through, with its fibres.
    pub fn x_ray() -> Self {
        Self { skin: SkinStyle::XRay, ..Self::default() }
    }

    /// Material and structure particles and fibres, without the skin: figure 3 of the fibre paper.
    pub fn particles() -> Self {
        Self { skin: SkinStyle::Hidden, particles: true, structure: true, ..Self::default() }
    }
}
