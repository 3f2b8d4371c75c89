//! From the document to the solver: the one place where a [`Scene`] meets solver internals. Pure: the same
//! scene gives the same world, bit for bit.

mod body;
mod colliders;
mod contact_surface;
mod draft;
mod drives;
mod elements;
mod error;
mod falloff;
mod fibres;
#[cfg(feature = "gui")]
mod followed_bones;
mod follows;
mod fractions;
mod integrator;
mod layer_model;
mod limits;
mod measures;
mod mesh_filling;
mod note;
mod overlaps;
mod parted_skin;
mod particle_sampling;
mod pins;
mod regime;
mod region_materials;
mod room;
mod seams;
mod section_notes;
mod self_contact;
mod sheet_shape;
mod sheets;
mod slide;
mod spans;
mod stage;
mod start;
mod step_plan;
mod supports;
mod surroundings;
mod thin_places;
mod two_layer;
mod voids;

pub(crate) use drives::drive as solver_drive;
pub use elements::OwnElements;
pub use error::BakeError;
pub use fibres::PlacedFibre;
#[cfg(feature = "gui")]
pub(crate) use followed_bones::followed_bones;
pub use note::Note;
pub use stage::BakeStage;
pub use thin_places::ThinPlaces;

use crate::scene::{AnyBody, Assets, IntegratorKind, Scene};
use crate::solver::body::Body;
use crate::solver::forces::Gravity;
use crate::solver::swing::{Swing, swing_under};
use crate::solver::world::World;
use glam::DVec3;
use stage::Tell;
use std::collections::HashMap;
use std::ops::ControlFlow;

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
    /// Where each body is thinner than its particles resolve, as far as a note is made of it.
    pub thin: Vec<ThinPlaces>,
    /// Greatest stable step of each body [s] under every integrator, in the order of [`IntegratorKind::ALL`].
    stable_steps: Vec<Vec<f64>>,
}

impl Baked {
    /// Greatest step [s] that all bodies are estimated to take under `integrator`.
    pub fn stable_step(&self, integrator: IntegratorKind) -> f64 {
        self.stable_steps_under(integrator).fold(f64::INFINITY, f64::min)
    }

    fn stable_steps_under(&self, integrator: IntegratorKind) -> impl Iterator<Item = f64> {
        let index = IntegratorKind::ALL.iter().position(|kind| *kind == integrator);
        self.stable_steps.iter().filter_map(move |of_body| of_body.get(index?).copied())
    }

    /// The world with every body under `integrator` in steps of `dt` [s], one to a frame: no sub-steps, no automatic
    /// choice. It moves as the one that the scene gives with these in its file, and measures nothing.
    pub fn single_stepped(&self, integrator: IntegratorKind, dt: f64) -> World {
        let mut world = self.world.clone();
        world.step_singly(dt);
        for (index, stable_dt) in self.stable_steps_under(integrator).enumerate() {
            if let Some(body) = world.body_mut(index) {
                body.set_integrator(integrator::integrator(integrator));
                body.set_step(dt, stable_dt);
            }
        }
        world
    }

    /// What `integrator` makes of an undamped swing of `omega` [rad/s] in steps of `dt` [s].
    pub(crate) fn swing_under(integrator: IntegratorKind, omega: f64, dt: f64) -> Option<Swing> {
        swing_under(integrator::integrator(integrator), omega, dt)
    }
}

/// Puts a scene together. Call [`Scene::validate`] first: values out of range are not looked for again here. `assets`
/// holds the solids of the scene's meshes; a scene without any needs none.
///
/// # Errors
/// [`BakeError`] with the pointer to what cannot be put together.
pub fn bake(scene: &Scene, assets: &Assets) -> Result<Baked, BakeError> {
    bake_with_progress(scene, assets, &mut |_, _| ControlFlow::Continue(()))
}

/// [`bake`], with elements of a program's own in its bodies. Each is tried first ([`crate::solver::check_element`]),
/// and the stable step is measured with them.
///
/// # Errors
/// [`BakeError`] with the pointer to what cannot be put together; [`BakeError::ElementRefused`] with the figure of what
/// is wrong with an element.
pub fn bake_with_elements(scene: &Scene, assets: &Assets, own: &[OwnElements]) -> Result<Baked, BakeError> {
    elements::have_bodies(own, scene)?;
    let progress = &mut |_: &str, _| ControlFlow::Continue(());
    spans::within(progress, |progress| rebuild(scene, (assets, own), progress))
}

/// [`bake`], and `progress` hears what is being worked on: the name of a body and the stage. It is not asked again once
/// it breaks off.
///
/// # Errors
/// [`BakeError`] with the pointer to what cannot be put together; [`BakeError::Cancelled`] where `progress` broke off.
pub fn bake_with_progress(
    scene: &Scene,
    assets: &Assets,
    progress: &mut dyn FnMut(&str, BakeStage) -> ControlFlow<()>,
) -> Result<Baked, BakeError> {
    spans::within(progress, |progress| rebuild(scene, (assets, &[]), progress))
}

fn rebuild(
    scene: &Scene,
    (assets, own): (&Assets, &[OwnElements]),
    progress: &mut Tell<'_>,
) -> Result<Baked, BakeError> {
    let mut notes = Vec::new();
    let mut drafts = Vec::new();
    let colliders = colliders::colliders(scene, assets)?;
    for (index, body) in scene.all_bodies().enumerate() {
        let path = scene.body_pointer(index);
        drafts.push(match body {
            AnyBody::Solid(body) => {
                let sampling = particle_sampling::sample_particles(body, assets, &path, &mut notes, progress)?;
                let body = sampling.effective(body);
                body::draft(scene, &body, (&sampling, assets, &colliders, own), &path, &mut notes, progress)?
            }
            AnyBody::TwoLayer(body) => {
                two_layer::draft(scene, body, (assets, &colliders), &path, &mut notes, progress)?
            }
        });
    }
    let plan = step_plan::step_plan(scene, &drafts, &colliders)?;
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
    let stable_steps = drafts.iter_mut().map(|draft| std::mem::take(&mut draft.stable_steps)).collect();
    let fractions = drafts.iter_mut().map(|draft| std::mem::take(&mut draft.fractions)).collect();
    let thin = drafts.iter_mut().map(|draft| std::mem::take(&mut draft.thin)).collect();
    let (mut bodies, regions): (Vec<Body>, Vec<_>) =
        drafts.into_iter().map(|draft| (Body::new(draft.parts), draft.regions)).unzip();
    for (body, of) in bodies.iter_mut().zip(scene.all_bodies()) {
        body.share(drives::shared(of.drives()));
    }
    let gravity = Gravity::new(DVec3::from_array(scene.gravity), drives::gravity(scene));
    let world = World::new(bodies, (room::panels(scene), colliders), probes, plan, gravity);
    overlaps::note_overlaps(scene, &world, &mut notes);
    Ok(Baked { world, notes, regions, fractions, thin, stable_steps })
}
