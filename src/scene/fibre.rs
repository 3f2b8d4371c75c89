//! Fibres: strokes or vertices, stiffness, rest shape.

use super::extra::{is_false, is_zero};
use super::{Activation, Drive, Extra, SharedDrive};
use crate::sketch::{LiftOptions, Lifted, SketchError, Stroke, View, lift};
use glam::DVec2;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One fibre embedded in a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Fibre {
    /// Stable identifier, unique within the body.
    pub id: String,
    /// Name a person reads.
    #[serde(default)]
    pub name: String,
    /// Whether it is left out of what is seen; it moves all the same.
    #[serde(default, skip_serializing_if = "is_false")]
    pub hidden: bool,
    /// Colour in which it is drawn, red, green and blue from 0 to 255; the theme's unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub color: Option<[u8; 3]>,
    /// Where it runs, in the model frame.
    pub source: FibreSource,
    /// How it resists stretching and bending.
    pub stiffness: Stiffness,
    /// Share `l_f` of the material that is fibre at its centre line, 0 to 1.
    #[serde(default = "default_volume_fraction")]
    pub volume_fraction: f64,
    /// The shape in which it carries no bending energy.
    #[serde(default)]
    pub rest_shape: RestShape,
    /// What it breaks past; it never breaks unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub break_past: Option<BreakPast>,
    /// What it yields past, and then stays as it was bent or pulled; it springs back unless given.
    #[serde(default, rename = "yield", skip_serializing_if = "Option::is_none")]
    pub yields: Option<YieldPast>,
    /// How it acts by itself; it only resists unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub activation: Option<Activation>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Fibre {
    /// A fibre through vertices in the model frame [m], three or more.
    ///
    /// Its stiffness is [`Stiffness::default`], its volume fraction 0.25 (the fibre paper's Table 1), it is at rest as
    /// it is drawn, and it never breaks.
    pub fn through<V: Into<[f64; 3]>>(id: impl Into<String>, vertices: impl IntoIterator<Item = V>) -> Self {
        Self::new(id, FibreSource::Vertices(vertices.into_iter().map(Into::into).collect()))
    }

    /// A fibre drawn by one stroke in each of two views, else as [`Fibre::through`].
    pub fn drawn(id: impl Into<String>, strokes: StrokePair) -> Self {
        Self::new(id, FibreSource::Strokes(strokes))
    }

    fn new(id: impl Into<String>, source: FibreSource) -> Self {
        Self {
            id: id.into(),
            name: String::new(),
            hidden: false,
            color: None,
            source,
            stiffness: Stiffness::default(),
            volume_fraction: default_volume_fraction(),
            rest_shape: RestShape::default(),
            break_past: None,
            yields: None,
            activation: None,
            extra: Extra::new(),
        }
    }

    /// With a name that a person reads.
    #[must_use]
    pub fn with_name(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// With another resistance against stretching and bending.
    #[must_use]
    pub fn with_stiffness(self, stiffness: impl Into<Stiffness>) -> Self {
        Self { stiffness: stiffness.into(), ..self }
    }

    /// With another share of the material that is fibre at its centre line, 0 to 1.
    #[must_use]
    pub fn with_volume_fraction(self, volume_fraction: f64) -> Self {
        Self { volume_fraction, ..self }
    }

    /// With another shape in which it carries no bending energy.
    #[must_use]
    pub fn with_rest_shape(self, rest_shape: RestShape) -> Self {
        Self { rest_shape, ..self }
    }

    /// With what it yields past, as a wire does.
    #[must_use]
    pub fn with_yield(self, yields: YieldPast) -> Self {
        Self { yields: Some(yields), ..self }
    }

    /// Acting by itself.
    #[must_use]
    pub fn with_activation(self, activation: Activation) -> Self {
        Self { activation: Some(activation), ..self }
    }

    /// The greatest volume fraction that it ever has at its centre line, in a body that shares these drives.
    pub(crate) fn greatest_fraction(&self, shared: &[SharedDrive]) -> f64 {
        let own = self.volume_fraction;
        let Some((of, at_one)) = self.activation.as_ref().and_then(|of| Some((of, of.volume_fraction?))) else {
            return own;
        };
        let range = of.drive.resolved(shared).and_then(Drive::range).unwrap_or([0.0; 2]);
        range.map(|value| own + (at_one - own) * value).into_iter().fold(own, f64::max)
    }
}

/// What a fibre breaks past, into two. What is left out never breaks it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct BreakPast {
    /// Turn of a vertex away from the rest shape [degrees], up to 180: past it the fibre no longer bends there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// Force that an edge carries, the volume fraction included [N]: past it the fibre is cut there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl BreakPast {
    /// A turn of a vertex away from the rest shape [degrees], up to 180.
    pub fn angle(degrees: f64) -> Self {
        Self { angle: Some(degrees), ..Self::default() }
    }

    /// A force that an edge carries [N].
    pub fn tension(newtons: f64) -> Self {
        Self { tension: Some(newtons), ..Self::default() }
    }
}

/// What a fibre yields past: a wire that is bent further stays bent. Resetting the motion mends it. What is left out
/// never yields.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct YieldPast {
    /// Force that an edge carries, the volume fraction included [N]: past it the edge takes another length at rest, a
    /// fifth to five times the drawn one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
    /// Curvature away from the rest shape [degrees/m]: past it the fibre takes another shape at rest, as far as a right
    /// angle from one edge to the next.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub curvature_degrees_per_metre: Option<f64>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl YieldPast {
    /// By curvature away from the rest shape [degrees/m].
    pub fn curvature(degrees_per_metre: f64) -> Self {
        Self { curvature_degrees_per_metre: Some(degrees_per_metre), ..Self::default() }
    }

    /// By the force that an edge carries [N].
    pub fn tension(force: f64) -> Self {
        Self { tension: Some(force), ..Self::default() }
    }
}

/// Where a fibre runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FibreSource {
    /// Drawn as one stroke in each of two orthogonal views; the raw strokes are the source of truth.
    Strokes(StrokePair),
    /// Vertices in the model frame [m], used as they are.
    Vertices(Vec<[f64; 3]>),
}

/// One stroke in each of two orthogonal views.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StrokePair {
    /// The stroke that was drawn first.
    pub first: ViewStroke,
    /// The stroke that was drawn second, in another view.
    pub second: ViewStroke,
    /// Run the second stroke the other way from what the correspondence chose.
    #[serde(default)]
    pub flip_second: bool,
    /// What to do where the strokes cover different ranges of their shared axis.
    #[serde(default)]
    pub mismatch: Mismatch,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl StrokePair {
    /// The strokes in the order in which they were drawn; they must be of different views.
    pub fn new(first: ViewStroke, second: ViewStroke) -> Self {
        Self { first, second, flip_second: false, mismatch: Mismatch::default(), extra: Extra::new() }
    }

    /// The curve that the strokes make in a model of this diagonal [m].
    ///
    /// # Errors
    /// As [`lift`].
    pub fn lifted(&self, model_diagonal: f64) -> Result<Lifted, SketchError> {
        let stretch = self.mismatch == Mismatch::Stretch;
        let options = LiftOptions { flip_second: self.flip_second, stretch, model_diagonal };
        lift(&self.first.stroke(), &self.second.stroke(), &options)
    }
}

/// A stroke as it was drawn in one view.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ViewStroke {
    /// View in which it was drawn: front shows X and Y, side Z and Y, top X and Z.
    pub view: View,
    /// Points as drawn, [horizontal, vertical] in the view's plane [m].
    pub points: Vec<[f64; 2]>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl ViewStroke {
    /// A stroke through points, [horizontal, vertical] in the view's plane [m].
    pub fn new<P: Into<[f64; 2]>>(view: View, points: impl IntoIterator<Item = P>) -> Self {
        Self { view, points: points.into_iter().map(Into::into).collect(), extra: Extra::new() }
    }

    pub(super) fn stroke(&self) -> Stroke {
        Stroke { view: self.view, points: self.points.iter().copied().map(DVec2::from_array).collect() }
    }
}

/// What to do where two strokes cover ranges of their shared axis that differ by more than 5 % of the larger range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mismatch {
    /// Cut both to the range that they share; ranges that differ by more than 25 % are refused.
    #[default]
    Clip,
    /// Stretch the second onto the range of the first, however far they differ.
    Stretch,
}

/// Resistance of a fibre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Stiffness {
    /// The rod's own rigidities.
    Rigidity(Rigidity),
    /// The fibre paper's Table 1 figures.
    Paper(PaperStiffness),
}

impl Default for Stiffness {
    /// Ten times as stiff as the default material that it displaces, as fibres drawn in the window are:
    /// EA = 140 N, EI = 1e-4 N m².
    fn default() -> Self {
        Rigidity::new(140.0, 1e-4).into()
    }
}

impl From<Rigidity> for Stiffness {
    fn from(rigidity: Rigidity) -> Self {
        Self::Rigidity(rigidity)
    }
}

impl From<PaperStiffness> for Stiffness {
    fn from(paper: PaperStiffness) -> Self {
        Self::Paper(paper)
    }
}

/// Rigidities of a rod.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Rigidity {
    /// Axial rigidity EA [N].
    pub ea: f64,
    /// Bending stiffness EI [N m²].
    pub ei: f64,
    /// Twisting stiffness GJ [N m²]; 0, which is none, unless given. A solid resists twist by itself far more than most
    /// of its fibres: it is there for fibres that twist by themselves, and for thin ones.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub gj: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Rigidity {
    /// Axial rigidity EA [N] and bending stiffness EI [N m²].
    pub fn new(ea: f64, ei: f64) -> Self {
        Self { ea, ei, gj: 0.0, extra: Extra::new() }
    }

    /// With a twisting stiffness GJ [N m²].
    #[must_use]
    pub fn with_twisting(self, gj: f64) -> Self {
        Self { gj, ..self }
    }
}

/// Table 1's stiffnesses, read as EA = 2 Ks N and EI = Kb V / 2 with V the volume of a particle: the only reading
/// that reproduces figures 6 and 7 of the paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PaperStiffness {
    /// Bending stiffness Kb as printed in Table 1.
    pub kb: f64,
    /// Stretching stiffness Ks as printed in Table 1.
    pub ks: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl PaperStiffness {
    /// Kb and Ks as Table 1 prints them.
    pub fn new(kb: f64, ks: f64) -> Self {
        Self { kb, ks, extra: Extra::new() }
    }
}

impl Stiffness {
    /// Axial rigidity EA [N] and bending stiffness EI [N m²], given the volume of a material particle [m³].
    pub fn rigidity(&self, particle_volume: f64) -> (f64, f64) {
        match self {
            Self::Rigidity(rigidity) => (rigidity.ea, rigidity.ei),
            Self::Paper(paper) => (2.0 * paper.ks, 0.5 * paper.kb * particle_volume),
        }
    }

    /// Twisting stiffness GJ [N m²].
    pub fn twisting(&self) -> f64 {
        match self {
            Self::Rigidity(rigidity) => rigidity.gj,
            Self::Paper(_) => 0.0,
        }
    }
}

/// The shape in which a fibre carries no bending energy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RestShape {
    /// Straight: a fibre drawn curved pulls the solid straight.
    Straight,
    /// As it was drawn: nothing moves by itself.
    #[default]
    AsDrawn,
}

fn default_volume_fraction() -> f64 {
    0.25
}
