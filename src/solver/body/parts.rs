//! What bodies are put together from.

use crate::solver::constraint::Constraint;
use crate::solver::contact_surface::ContactSurface;
use crate::solver::embedding::EmbeddingWeights;
use crate::solver::forces::{ContactLaw, Force};
use crate::solver::integrators::Integrator;
use crate::solver::layers::Layers;
use crate::solver::skin::{PartedSkin, Skin};
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// What a body is put together from.
#[derive(Clone)]
pub struct BodyParts {
    /// Stable identifier of the scene.
    pub id: String,
    /// JSON pointer of the scene's body.
    pub pointer: String,
    /// Name a person reads.
    pub name: String,
    /// Kind, as in reports.
    pub kind: &'static str,
    /// Particles at the start.
    pub state: ParticleState,
    /// Rest positions in the model frame [m].
    pub model: Arc<[DVec3]>,
    /// Rest positions in the world [m]: where the particles would start without any initial deformation.
    pub rest: Arc<[DVec3]>,
    /// Everything that pushes and pulls.
    pub forces: Vec<Box<dyn Force>>,
    /// How it is stepped.
    pub integrator: Box<dyn Integrator>,
    /// The integrator's word, as in scene files; "other" once a program has given the body one of its own.
    pub integrator_word: &'static str,
    /// Why it was chosen, where the scene leaves that open and it is not the usual one.
    pub integrator_reason: Option<String>,
    /// Prescribed motions.
    pub(crate) constraints: Vec<Constraint>,
    /// How it pushes on other things.
    pub(crate) contact: ContactLaw,
    /// By what it meets other fibre solids; none where it does not.
    pub(crate) contact_surface: Option<Arc<ContactSurface>>,
    /// Centre lines of the fibres, for drawing and counting.
    pub fibres: Vec<FibreLine>,
    /// Sheets, for drawing and counting.
    pub sheets: Vec<SheetSurface>,
    /// Elements, for drawing and counting.
    pub elements: Vec<ElementLines>,
    /// Build of a two-layer body; none for others.
    pub layers: Option<Arc<Layers>>,
    /// Render surface.
    pub skin: Option<Arc<Skin>>,
    /// What that becomes where seams tear; none without any.
    pub parted_skin: Option<Arc<PartedSkin>>,
    /// Distance [m] that no particle may cross in one step against the body's mean motion.
    pub reach: f64,
    /// Force [N] and energy [J] scales below which the body counts as at rest.
    pub rest_scale: RestScale,
    /// Mean number of neighbours of a particle.
    pub mean_neighbours: f64,
    /// Time step [s].
    pub dt: f64,
    /// Greatest stable time step that was measured [s].
    pub stable_dt: f64,
    /// Greatest stable time step of leap-frog [s].
    pub explicit_dt: f64,
    /// JSON pointer of the parameter that chooses the time step, named when the body diverges.
    pub step_parameter: String,
    /// JSON pointer of the parameter that sets the stable step: of all, halving it raises that step most. None where no
    /// single one does by more than a hundredth.
    pub limited_by: Option<String>,
}

impl BodyParts {
    /// A step that follows the body's stiffest motion [s]: its own, or leap-frog's where its own is not bounded by
    /// that.
    pub(super) fn resolved_dt(&self) -> f64 {
        if self.stable_dt.is_finite() { self.dt } else { self.dt.min(self.explicit_dt) }
    }
}

/// Scales below which a body counts as at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestScale {
    /// Largest net force on a free particle [N].
    pub force: f64,
    /// Kinetic energy of a particle [J].
    pub energy: f64,
}

/// Centre line of one embedded fibre.
#[derive(Clone, Debug, PartialEq)]
pub struct FibreLine {
    /// Identifier of the scene's fibre.
    pub id: String,
    /// Embedded vertices, ends without force included.
    pub vertices: Vec<EmbeddingWeights>,
}

/// Surface of one embedded sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetSurface {
    /// Identifier of the scene's sheet.
    pub id: String,
    /// Embedded vertices, those without force included.
    pub vertices: Vec<EmbeddingWeights>,
    /// Three vertices a triangle.
    pub triangles: Arc<[[u32; 3]]>,
    /// Lines along its grain; none where it has none.
    pub threads: Arc<[Vec<SurfacePoint>]>,
    /// Lines of vertices where it ends.
    pub rim: Arc<[Vec<u32>]>,
}

/// What is drawn of elements over the same points.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementLines {
    /// Identifier of the scene's element, or of who made them.
    pub id: String,
    /// Embedded points.
    pub points: Vec<EmbeddingWeights>,
    /// Between which of them lines are drawn.
    pub lines: Arc<[[u32; 2]]>,
}

/// A point on an edge of a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Vertices at both ends of the edge.
    pub ends: [u32; 2],
    /// How far it lies from the first to the second, 0 to 1.
    pub share: f64,
}

impl SurfacePoint {
    /// A vertex itself.
    pub(crate) fn vertex(vertex: u32) -> Self {
        Self { ends: [vertex; 2], share: 0.0 }
    }
}
