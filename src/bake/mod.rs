//! From the document to the solver: the one place where a [`Scene`] meets solver internals. Pure: the same
//! scene gives the same world, bit for bit.

mod body;
mod fibres;
mod layer_model;
mod limits;
mod measures;
mod particle_sampling;
mod spans;
mod supports;
mod two_layer;

pub use fibres::PlacedFibre;

use crate::scene::{AnyBody, Assets, PanelMotion, Scene, TimeStep};
use crate::solver::body::Body;
use crate::solver::body_contact::stiffness_between;
use crate::solver::neighbourhood::TooThin;
use crate::solver::panel::Panel;
use crate::solver::world::{StepPlan, World};
use body::Draft;
use glam::{DVec2, DVec3};
use std::collections::HashMap;
use std::fmt;
use thiserror::Error;

/// A scene that cannot be put together.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BakeError {
    /// No lattice point lies inside the shape.
    #[error(
        "{path}: no particle fits into the shape at a spacing of {spacing} m; lower {body}/material/support_radius"
    )]
    Empty {
        /// Pointer to the shape.
        path: String,
        /// Pointer to the body.
        body: String,
        /// Particle spacing [m].
        spacing: f64,
    },
    /// The shape's model was not loaded.
    #[error("{path}: the model was not loaded; load the scene's assets first")]
    NotLoaded {
        /// Pointer to the shape's path.
        path: String,
    },
    /// The shape would need more particles than are allowed.
    #[error(
        "{path}: about {wanted:.1e} {what} where {limit:.1e} are allowed; give {suggested:.2e} m or more, or check the scale"
    )]
    TooMany {
        /// Pointer to the value that decides.
        path: String,
        /// What there would be too much of.
        what: &'static str,
        /// How many there would be.
        wanted: f64,
        /// Greatest number.
        limit: f64,
        /// Support radius that would do [m].
        suggested: f64,
    },
    /// Much of a mesh is thinner than two layers.
    #[error(
        "{path}: the shape is too thin for its particles ({flat} of {total} have too few others around them): {}",
        remedy(*.suggested)
    )]
    MeshTooThin {
        /// Pointer to the value that decides.
        path: String,
        /// Particles that nothing could hold in place.
        flat: usize,
        /// Lattice points inside.
        total: usize,
        /// Support radius that gives two layers [m], as was tried.
        suggested: Option<f64>,
    },
    /// Part of the shape is a single layer of particles.
    #[error("{path}: {source}")]
    TooThin {
        /// Pointer to the support radius.
        path: String,
        /// What was found.
        source: TooThin,
    },
    /// A region that selects no particle.
    #[error("{path}: the region selects none of the {particles} particles; enlarge it or remove it")]
    EmptyRegion {
        /// Pointer to the region.
        path: String,
        /// Particles of the body.
        particles: usize,
    },
    /// A two-layer body whose gas has no room.
    #[error("{path}: the gas would have a volume of {volume:.3e} at the start; deform the body less")]
    InsideOut {
        /// Pointer to the deformation.
        path: String,
        /// Signed volume [m³], or area [m²].
        volume: f64,
    },
    /// A two-layer body whose outer layer would have holes.
    #[error(
        "{path}: the surface is not closed ({open_edges} open edges), so that no gas stays in it; close it in the program \
         it is from"
    )]
    NotClosed {
        /// Pointer to the mesh's path.
        path: String,
        /// Edges of one face only.
        open_edges: usize,
    },
    /// A two-layer body of more particles than are allowed.
    #[error("{path}: the mesh has {points} points where {limit} are allowed; simplify it")]
    TooManyPoints {
        /// Pointer to the mesh's path.
        path: String,
        /// Points of the mesh.
        points: usize,
        /// Greatest number.
        limit: usize,
    },
    /// An inner layer that does not fit into the outer one.
    #[error(
        "{path}: {value} turns the inner layer inside out (faces turned over: {turned}, pairs that pass through each \
         other: {crossings}, volume inside: {volume:.2e} m³); {remedy}"
    )]
    InnerLayer {
        /// Pointer to the offset.
        path: String,
        /// The offset, as given.
        value: f64,
        /// Faces that would look the other way.
        turned: usize,
        /// Pairs of faces that would pass through each other.
        crossings: usize,
        /// Volume inside [m³].
        volume: f64,
        /// What to give.
        remedy: String,
    },
    /// A reference to something that is not there.
    #[error("{path}: {what} \"{id}\" does not exist; there are: {known}")]
    Unknown {
        /// Pointer to the reference.
        path: String,
        /// What it refers to.
        what: &'static str,
        /// The identifier.
        id: String,
        /// Identifiers that exist.
        known: String,
    },
    /// A height between regions that lie at the same height.
    #[error(
        "{path}: the two regions lie only {apart:.2e} m apart along this axis, which is no height; choose another axis"
    )]
    NoHeight {
        /// Pointer to the axis.
        path: String,
        /// Distance at rest [m].
        apart: f64,
    },
    /// More steps to a frame than anybody can wait for.
    #[error(
        "{path}: a frame of {frame_seconds:.3e} s would take {steps:.2e} steps of at most {stable_dt:.2e} s for \"{body}\"; \
         raise the frame rate, or {}", softer(.limited_by.as_deref())
    )]
    TooManySteps {
        /// Pointer to the frame rate.
        path: String,
        /// Name of the body.
        body: String,
        /// Length of a frame [s].
        frame_seconds: f64,
        /// Steps that it would take.
        steps: f64,
        /// Stable step [s].
        stable_dt: f64,
        /// Pointer to the parameter that sets it.
        limited_by: Option<String>,
    },
    /// A reaction asked of a region that nothing holds.
    #[error("{path}: nothing holds region \"{region}\", so it has no reaction; add a pin on it")]
    NotHeld {
        /// Pointer to the measure.
        path: String,
        /// The region.
        region: String,
    },
}

fn softer(limited_by: Option<&str>) -> String {
    limited_by.map_or("soften its material or fibres".to_owned(), |pointer| format!("lower {pointer}"))
}

fn remedy(suggested: Option<f64>) -> String {
    match suggested {
        Some(radius) => format!("a support radius of {radius:.3e} m gives two layers"),
        None => "two layers would take more particles than are allowed; give it more thickness".to_owned(),
    }
}

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

/// What is being worked on, for progress on long bakes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BakeStage {
    /// Filling the shape with particles.
    Sampling,
    /// Finding neighbours.
    Neighbours,
    /// Embedding fibres.
    Embedding,
    /// Embedding the skin.
    Skin {
        /// Points that are done.
        done: usize,
        /// Points in all.
        of: usize,
    },
    /// Measuring the stable time step.
    StableStep,
}

impl fmt::Display for BakeStage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sampling => f.write_str("filling the shape with particles"),
            Self::Neighbours => f.write_str("finding neighbours"),
            Self::Embedding => f.write_str("embedding the fibres"),
            Self::Skin { done, of } => write!(f, "embedding the skin, {done} of {of} points"),
            Self::StableStep => f.write_str("measuring the stable time step"),
        }
    }
}

/// A world ready to run, and what was noticed on the way.
#[derive(Clone)]
pub struct Baked {
    /// The world at time zero.
    pub world: World,
    /// What was noticed.
    pub notes: Vec<Note>,
    /// Particles of the regions of each body, by the region's id.
    pub regions: Vec<HashMap<String, Vec<u32>>>,
    /// Volume fraction of fibre at every particle of each body, painted or by distance; none of a two-layer body.
    pub fractions: Vec<Vec<f64>>,
}

/// Puts a scene together. Call [`Scene::validate`] first: values out of range are not looked for again here. `assets`
/// holds the solids of the scene's meshes; a scene without any needs none.
///
/// # Errors
/// [`BakeError`] with the pointer to what cannot be put together.
pub fn bake(scene: &Scene, assets: &Assets) -> Result<Baked, BakeError> {
    bake_with_progress(scene, assets, &mut |_, _| {})
}

/// [`bake`], and `progress` hears what is being worked on: the name of a body and the stage.
///
/// # Errors
/// [`BakeError`] with the pointer to what cannot be put together.
pub fn bake_with_progress(
    scene: &Scene,
    assets: &Assets,
    progress: &mut dyn FnMut(&str, BakeStage),
) -> Result<Baked, BakeError> {
    spans::within(progress, |progress| put_together(scene, assets, progress))
}

fn put_together(scene: &Scene, assets: &Assets, progress: &mut dyn FnMut(&str, BakeStage)) -> Result<Baked, BakeError> {
    let mut notes = Vec::new();
    let panels: Vec<Panel> = scene.panels.iter().map(|drawn| panel(drawn, scene.room.floor)).collect();
    let mut drafts = Vec::new();
    for (index, body) in scene.all_bodies().enumerate() {
        let path = scene.body_pointer(index);
        progress(body.title(), BakeStage::Sampling);
        drafts.push(match body {
            AnyBody::Solid(body) => {
                let sampling = particle_sampling::sample_particles(body, assets, &path, &mut notes)?;
                let body = sampling.effective(body);
                body::draft(scene, &body, &sampling, &path, &mut notes, progress)?
            }
            AnyBody::TwoLayer(body) => two_layer::draft(scene, body, assets, &path, &mut notes, progress)?,
        });
    }
    let plan = plan(scene, &drafts)?;
    for (index, (draft, &substeps)) in drafts.iter_mut().zip(&plan.substeps).enumerate() {
        let dt = plan.frame_seconds / f64::from(plan.outer_steps) / f64::from(substeps);
        draft.parts.dt = dt;
        if dt > draft.parts.stable_dt {
            let set_by = draft.parts.limited_by.as_ref().map_or(String::new(), |pointer| format!(", set by {pointer}"));
            notes.push(Note {
                path: "/time/step/manual/dt".to_owned(),
                text: format!(
                    "{dt:.3e} s is beyond the stable step {:.3e} s of body {index} (\"{}\"{set_by}), which will most \
                     likely diverge; give at most {:.2e} s or use the automatic step",
                    draft.parts.stable_dt,
                    draft.parts.name,
                    0.7 * draft.parts.stable_dt
                ),
                warning: true,
            });
        }
    }
    let probes = measures::probes(scene, &drafts)?;
    let fractions = drafts.iter_mut().map(|draft| std::mem::take(&mut draft.fractions)).collect();
    let (bodies, regions) = drafts.into_iter().map(|draft| (Body::new(draft.parts), draft.regions)).unzip();
    let world = World::new(bodies, panels, probes, plan, DVec3::from_array(scene.gravity));
    Ok(Baked { world, notes, regions, fractions })
}

fn panel(panel: &crate::scene::Panel, floor: Option<f64>) -> Panel {
    Panel {
        id: panel.id.clone(),
        height: panel.height,
        velocity: 0.0,
        center: DVec2::from_array(panel.center),
        half_size: 0.5 * DVec2::from_array(panel.size),
        mass: panel.mass,
        friction: panel.friction,
        floor,
        driven: match &panel.motion {
            PanelMotion::Falls => None,
            PanelMotion::Driven(keys) => Some(keys.iter().map(|key| (key.time, key.height)).collect()),
        },
    }
}

/// More steps than this to one frame are refused: nothing would be seen to happen.
const MOST_STEPS: f64 = 1e6;

/// Divides a frame so that no body steps beyond its share of the stable step. Bodies that share a panel step together;
/// bodies that may meet share outer steps short enough for the contact between them.
fn plan(scene: &Scene, drafts: &[Draft]) -> Result<StepPlan, BakeError> {
    let (frame_seconds, wanted, for_contact): (f64, Vec<u32>, u32) = match &scene.time.step {
        TimeStep::Automatic(automatic) => {
            let frame = scene.time.frame_seconds();
            let count = |stable: f64| (frame / (automatic.safety * stable)).ceil().max(1.0) as u32;
            for draft in drafts {
                let stable_dt = draft.parts.stable_dt;
                let steps = frame / (automatic.safety * stable_dt);
                if steps.is_nan() || steps > MOST_STEPS {
                    return Err(BakeError::TooManySteps {
                        path: "/time/frames_per_second".to_owned(),
                        body: draft.parts.name.clone(),
                        frame_seconds: frame,
                        steps,
                        stable_dt,
                        limited_by: draft.parts.limited_by.clone(),
                    });
                }
            }
            let wanted = drafts.iter().map(|draft| count(draft.parts.stable_dt)).collect();
            (frame, wanted, count(stable_contact_step(drafts)))
        }
        TimeStep::Manual(manual) => {
            let count = manual.substeps_per_frame;
            (scene.time.frame_seconds(), vec![count; drafts.len()], count)
        }
    };
    let outer_steps = match (scene.panels.is_empty(), drafts.len()) {
        (false, _) => wanted.iter().copied().max().unwrap_or(1).max(for_contact),
        (true, 0 | 1) => 1,
        (true, _) => for_contact,
    };
    let substeps = wanted.iter().map(|count| count.div_ceil(outer_steps)).collect();
    Ok(StepPlan { frame_seconds, outer_steps, substeps })
}

/// Greatest outer step [s] that resolves the contact between any two bodies; infinite without any.
fn stable_contact_step(drafts: &[Draft]) -> f64 {
    // A particle of a surface may carry several others.
    const CARRIED: f64 = 4.0;
    let lightest = |draft: &Draft| draft.parts.state.masses.iter().copied().fold(f64::INFINITY, f64::min);
    let mut fastest: f64 = 0.0;
    for (index, a) in drafts.iter().enumerate() {
        for b in &drafts[index + 1..] {
            let stiffness = CARRIED * stiffness_between(&a.parts.contact, &b.parts.contact);
            fastest = fastest.max(stiffness * (1.0 / lightest(a) + 1.0 / lightest(b)));
        }
    }
    if fastest > 0.0 { 2.0 / fastest.sqrt() } else { f64::INFINITY }
}

/// Where a reference fails: the identifiers that exist, for the message.
fn known<'a>(ids: impl Iterator<Item = &'a str>) -> String {
    let ids: Vec<&str> = ids.collect();
    if ids.is_empty() { "none".to_owned() } else { ids.join(", ") }
}
