//! Sheets: surfaces in a body, from strokes or vertices, with a stiffness, a rest shape and what a drive does to them.

use super::extra::is_false;
use super::{Drive, Extra, ViewStroke};
use crate::sketch::{SketchError, Sweep, sweep};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Most sheets in a body.
pub const MAX_SHEETS: usize = 1000;

/// Most vertices of a sheet that is given by its own.
pub const MAX_SHEET_VERTICES: usize = 100_000;

/// One sheet embedded in a body: a membrane that resists stretch and shear in its own surface, and bends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Sheet {
    /// Stable identifier, unique among the body's sheets.
    pub id: String,
    /// Name a person reads.
    #[serde(default)]
    pub name: String,
    /// Whether it is left out of what is seen; it acts all the same.
    #[serde(default, skip_serializing_if = "is_false")]
    pub hidden: bool,
    /// Colour in which it is drawn, red, green and blue from 0 to 255; the theme's unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<[u8; 3]>,
    /// Where it lies, in the model frame.
    pub source: SheetSource,
    /// How it resists.
    pub stiffness: SheetStiffness,
    /// Share `l_s` of the material that is sheet in its surface, 0 to 1.
    #[serde(default = "default_volume_fraction")]
    pub volume_fraction: f64,
    /// The shape in which it carries no bending energy.
    #[serde(default)]
    pub rest_shape: SheetRestShape,
    /// How it acts by itself; it only resists unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub activation: Option<SheetActivation>,
    /// What makes it a seam, along which the body tears: it carries nothing then, and its stiffness, volume fraction
    /// and rest shape do not count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seam: Option<Seam>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Sheet {
    /// A sheet that is swept by two strokes.
    ///
    /// Its stiffness is [`SheetStiffness::default`], its volume fraction 0.25, and it is at rest as it is drawn.
    pub fn swept(id: impl Into<String>, strokes: SweptStrokes) -> Self {
        Self::new(id, SheetSource::Strokes(strokes))
    }

    /// A sheet through rows of vertices in the model frame [m], two rows of two or more, all as long; else as
    /// [`Sheet::swept`]. Rows run as the first stroke of a swept one does.
    pub fn grid(id: impl Into<String>, rows: Vec<Vec<[f64; 3]>>) -> Self {
        Self::new(id, SheetSource::Grid(rows))
    }

    /// A sheet of triangles in the model frame: vertices [m] and three indices a triangle; else as [`Sheet::swept`].
    pub fn of_triangles(id: impl Into<String>, vertices: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        Self::new(id, SheetSource::Triangles(SheetTriangles { vertices, triangles, extra: Extra::new() }))
    }

    fn new(id: impl Into<String>, source: SheetSource) -> Self {
        Self {
            id: id.into(),
            name: String::new(),
            hidden: false,
            color: None,
            source,
            stiffness: SheetStiffness::default(),
            volume_fraction: default_volume_fraction(),
            rest_shape: SheetRestShape::default(),
            activation: None,
            seam: None,
            extra: Extra::new(),
        }
    }

    /// With a name that a person reads.
    #[must_use]
    pub fn with_name(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// With another resistance.
    #[must_use]
    pub fn with_stiffness(self, stiffness: SheetStiffness) -> Self {
        Self { stiffness, ..self }
    }

    /// With another share of the material that is sheet in its surface, 0 to 1.
    #[must_use]
    pub fn with_volume_fraction(self, volume_fraction: f64) -> Self {
        Self { volume_fraction, ..self }
    }

    /// With another shape in which it carries no bending energy.
    #[must_use]
    pub fn with_rest_shape(self, rest_shape: SheetRestShape) -> Self {
        Self { rest_shape, ..self }
    }

    /// Acting by itself.
    #[must_use]
    pub fn with_activation(self, activation: SheetActivation) -> Self {
        Self { activation: Some(activation), ..self }
    }

    /// A seam, along which the body tears past a stretch: length over that at rest.
    #[must_use]
    pub fn tearing_past(self, stretch: f64) -> Self {
        Self { seam: Some(Seam { stretch, extra: Extra::new() }), ..self }
    }
}

/// What a sheet that is a seam stands: the material on one side of it no longer feels that on the other where it is
/// pulled apart further. A reset mends it. Beside one the material takes no viscosity and no plasticity, and its fibres
/// no driven volume fraction; two layers of particles must be left on either side. Fibres and sheets across it go on
/// holding both sides together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Seam {
    /// Length over that at rest, above 1, past which neighbours across it part.
    pub stretch: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Least and greatest stretch that a seam may stand.
pub(crate) const SEAM_STRETCH: [f64; 2] = [1.001, 10.0];

/// Where a sheet lies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SheetSource {
    /// One stroke swept along another; the raw strokes are the source of truth.
    Strokes(SweptStrokes),
    /// Rows of vertices in the model frame [m], used as they are: two rows of two or more, all as long. Rows run along
    /// the sheet's first direction.
    Grid(Vec<Vec<[f64; 3]>>),
    /// Triangles, used as they are.
    Triangles(SheetTriangles),
}

/// Two strokes in two orthogonal views, of which the first is carried along the second.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SweptStrokes {
    /// The stroke that is carried along. Where its view does not say how deep it lies, it begins where the second does.
    pub first: ViewStroke,
    /// The stroke along which it is carried, drawn in another view.
    pub second: ViewStroke,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl SweptStrokes {
    /// The strokes in the order in which they were drawn; they must be of different views.
    pub fn new(first: ViewStroke, second: ViewStroke) -> Self {
        Self { first, second, extra: Extra::new() }
    }

    /// The vertices that the strokes sweep in a model of this diagonal, no nearer to each other than `spacing` along
    /// either [m].
    ///
    /// # Errors
    /// As [`sweep`].
    pub fn swept(&self, model_diagonal: f64, spacing: f64) -> Result<Sweep, SketchError> {
        sweep(&self.first.stroke(), &self.second.stroke(), model_diagonal, spacing)
    }
}

/// Triangles of a sheet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SheetTriangles {
    /// Vertices in the model frame [m].
    pub vertices: Vec<[f64; 3]>,
    /// Three indices into the vertices a triangle; an edge belongs to two triangles at most.
    pub triangles: Vec<[u32; 3]>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Resistance of a sheet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SheetStiffness {
    /// Young's modulus times thickness Et [N/m].
    pub et: f64,
    /// Poisson's ratio in the surface, 0 to 0.49.
    #[serde(default = "default_poisson_ratio")]
    pub poisson_ratio: f64,
    /// Bending stiffness `E t³ / 12` [N m], the same in all directions; 0, which is none, unless given. Bent one way it
    /// does not want to bend the other.
    #[serde(default)]
    pub bending: f64,
    /// A direction in which it is stiffer; the same in all unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grain: Option<Grain>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl SheetStiffness {
    /// Young's modulus times thickness [N/m] and bending stiffness [N m], without a grain.
    pub fn new(et: f64, bending: f64) -> Self {
        Self { et, poisson_ratio: default_poisson_ratio(), bending, grain: None, extra: Extra::new() }
    }

    /// With another Poisson's ratio in the surface.
    #[must_use]
    pub fn with_poisson_ratio(self, poisson_ratio: f64) -> Self {
        Self { poisson_ratio, ..self }
    }

    /// Stiffer along a direction by so much [N/m].
    #[must_use]
    pub fn with_grain(self, along: GrainAlong, et: f64) -> Self {
        Self { grain: Some(Grain { along, et, extra: Extra::new() }), ..self }
    }
}

impl Default for SheetStiffness {
    /// Ten times as stiff as the default material that it displaces, as sheets drawn in the window are: Et = 12 000
    /// N/m, bending stiffness 8.6e-3 N m.
    fn default() -> Self {
        Self::new(1.2e4, 8.6e-3)
    }
}

/// A direction in which a sheet is stiffer, as if threads ran there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Grain {
    /// Which way it runs.
    pub along: GrainAlong,
    /// Young's modulus times thickness of the threads, beside that of the sheet [N/m].
    pub et: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Ways in which a grain may run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum GrainAlong {
    /// Along the first stroke, or the rows of a grid.
    First,
    /// Along the second stroke, or across the rows of a grid.
    Second,
    /// As this vector of the model frame lies in the sheet, of any length but zero.
    Direction([f64; 3]),
}

/// The shape in which a sheet carries no bending energy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SheetRestShape {
    /// As it was drawn: nothing moves by itself.
    #[default]
    AsDrawn,
    /// Flat: a sheet drawn curved pulls the solid flat.
    Flat,
}

/// What a drive does to a sheet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SheetActivation {
    /// What all below is multiplied by.
    pub drive: Drive,
    /// Shares by which the sheet wants to be shorter than it was drawn: along the first stroke, the rows of a grid or
    /// the grain of triangles, and across that; with the drive from -0.5 to 0.8.
    #[serde(default, skip_serializing_if = "are_zero")]
    pub contract: [f64; 2],
    /// Curvatures that the sheet wants to have beside those of its rest shape, along and across [degrees/m]; above zero
    /// it curls to the side to which its first direction turned into its second one looks, right-handed. It takes a
    /// `bending` stiffness.
    #[serde(default, skip_serializing_if = "are_zero")]
    pub curl_degrees_per_metre: [f64; 2],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl SheetActivation {
    /// Shorter along and across by shares, times a drive.
    pub fn contracting(contract: [f64; 2], drive: impl Into<Drive>) -> Self {
        Self { drive: drive.into(), contract, curl_degrees_per_metre: [0.0; 2], extra: Extra::new() }
    }

    /// Curling along and across by so many degrees a metre, times a drive.
    pub fn curling(degrees_per_metre: [f64; 2], drive: impl Into<Drive>) -> Self {
        Self { curl_degrees_per_metre: degrees_per_metre, ..Self::contracting([0.0; 2], drive) }
    }
}

fn are_zero(values: &[f64; 2]) -> bool {
    *values == [0.0; 2]
}

fn default_volume_fraction() -> f64 {
    0.25
}

fn default_poisson_ratio() -> f64 {
    0.33
}
