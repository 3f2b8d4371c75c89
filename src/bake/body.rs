//! One body of the scene: particles, forces, start, stable step.

use super::draft::Draft;
use super::error::BakeError;
use super::integrator::{integrator, stable_steps, step_parameter, stepping};
use super::limits::{Resistance, SolidParameter};
use super::note::Note;
use super::particle_sampling::ParticleSampling;
use super::pins::{Following, note_pins};
use super::stage::{BakeStage, Tell, unless_stopped};
use super::start::{deformed, give_impulse, spin, to_world};
use super::{drives, fibres, room, supports};
use crate::geometry::kernel::Kernel;
use crate::scene::{Body, BodyKind, Mass, Precision, Scene};
use crate::solver::body::{BodyParts, RestScale};
use crate::solver::embedding::Embedder;
use crate::solver::forces::{
    AirDrag, Contact, ContactLaw, Elasticity, FibreForce, Force, Gravity, MatrixForce, PairDamping, StepLimit,
};
use crate::solver::integrators::LeapFrog;
use crate::solver::neighbourhood::Neighbourhood;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::collections::HashMap;
use std::sync::Arc;

/// Friction below its Coulomb limit acts like a damper of this share of the contact's critical rate.
const STICKING: f64 = 0.5;

/// Net force below which a particle counts as at rest, in units of E D².
const REST_FORCE: f64 = 2e-7;

pub(super) fn draft(
    scene: &Scene,
    body: &Body,
    sampling: &ParticleSampling<'_>,
    path: &str,
    notes: &mut Vec<Note>,
    progress: &mut Tell<'_>,
) -> Result<Draft, BakeError> {
    let name = body.title();
    let material = &body.material;
    let spacing = material.spacing();
    let kernel = Kernel::new(material.support_radius);
    let volume = spacing.powi(3);

    let ParticleSampling { sample, volume: shape_volume, size, .. } = sampling;
    let neighbourhood = unless_stopped(progress, (name, BakeStage::Neighbours), |stop| {
        Neighbourhood::on_lattice_unless(sample, kernel, volume, stop).transpose()
    })?
    .map_err(|source| BakeError::TooThin { path: format!("{path}/material/support_radius"), source })?;
    let neighbourhood = Arc::new(neighbourhood);

    let embedding = (name, BakeStage::Embedding);
    let embedder = unless_stopped(progress, embedding, |stop| Embedder::new_unless(&sample.points, kernel, stop))?;
    let diagonal = size.length();
    let placed = fibres::Placing { body, embedder: &embedder, diagonal, path, notes }.place();
    let skin = sampling.skin(kernel, &mut |done, of| progress(name, BakeStage::Skin { done, of }))?.map(Arc::new);

    let mass = match material.mass {
        Mass::Density(density) => density * shape_volume / sample.points.len() as f64,
        Mass::PerParticle(mass) => mass,
    };
    let orientation = body.placement.rotation.quaternion();
    let regions = supports::regions(body, sample, path)?;
    let rest: Arc<[DVec3]> = sample.points.iter().map(|&x| to_world(&body.placement, x)).collect();
    let state = initial_state(body, &sample.points, &regions, mass, path)?;

    let fractions = fibres::fractions(body, &sample.points, kernel, &placed);
    let matrix = MatrixForce::new(
        Arc::clone(&neighbourhood),
        sample.points.as_slice().into(),
        Elasticity::new(material.young_modulus, material.poisson_ratio, spacing),
        volume,
        fibres::matrix_fractions(&fractions),
        orientation,
    );
    let mut forces: Vec<Box<dyn Force>> = vec![Box::new(match material.precision {
        Precision::Exact => matrix,
        Precision::Fast => matrix.fast(),
    })];
    let rods = fibres::rods(body, &embedder, volume, &placed, path)?;
    let strongest = fibres::strongest(body, &placed, &rods);
    let mut matrix_alone = None;
    if !rods.is_empty() {
        matrix_alone = Some(forces.clone());
        forces.push(Box::new(FibreForce::new(rods.into(), orientation)));
    }
    forces.extend(weight_and_damping(scene, body, &neighbourhood));
    let flow = scene.wind.as_ref().and(skin.as_deref()).and_then(|skin| drives::wind(scene, skin.flow_surface()));
    forces.extend(flow.map(|flow| Box::new(flow) as Box<dyn Force>));

    let contact = Contact::new(room::planes(scene), contact_law(scene, body, mass));
    let touches = !contact.planes.is_empty() || !scene.panels.is_empty();
    let contact_limit = if touches { contact.step_limit(&state) } else { StepLimit::default() };
    let resistance = unless_stopped(progress, (name, BakeStage::StableStep), |stop| {
        Resistance::measured(&forces, matrix_alone, &state, spacing, contact_limit, material.damping.air, stop)
    })?;
    let stable_steps = stable_steps(|integrator| resistance.stable_step(integrator));
    let stepping = stepping(scene, body, &stable_steps, &forces, &state);
    notes.extend(stepping.note(path));
    let integrator = integrator(stepping.integrator);
    let stable_dt = resistance.stable_step(integrator.as_ref());
    let explicit_dt = resistance.stable_step(&LeapFrog::default());
    let limited_by = resistance.limited_by(integrator.as_ref()).map(|parameter| match (parameter, strongest) {
        (SolidParameter::Fibres, Some(fibre)) => format!("{path}/fibres/{fibre}/stiffness"),
        (parameter, _) => parameter.pointer(path),
    });
    let law = contact.law;
    if !contact.planes.is_empty() {
        forces.push(Box::new(contact));
    }

    let constraints = supports::constraints((&body.pins, &body.drives), &regions, &rest, &state, path)?;
    let parts = BodyParts {
        id: body.id.clone(),
        name: name.to_owned(),
        kind: match body.kind {
            BodyKind::FibreSolid => "fibre_solid",
        },
        state,
        model: sample.points.as_slice().into(),
        rest,
        forces,
        integrator,
        integrator_word: stepping.integrator.word(),
        integrator_reason: stepping.reason,
        constraints,
        contact: law,
        fibres: placed.iter().map(fibres::PlacedFibre::line).collect(),
        layers: None,
        skin,
        reach: material.support_radius,
        rest_scale: RestScale {
            force: REST_FORCE * material.young_modulus * spacing * spacing,
            energy: REST_FORCE * REST_FORCE * material.young_modulus * volume,
        },
        mean_neighbours: neighbourhood.mean_neighbours(),
        dt: stable_dt,
        stable_dt,
        explicit_dt,
        limited_by,
        step_parameter: step_parameter(scene).to_owned(),
    };
    note_pins(scene, &body.pins, &parts, Following::of_solid(body), path, notes);
    Ok(Draft { parts, regions, stable_steps, fractions, thin: sampling.thin.clone() })
}

/// Gravity, damping between particles and drag of the air, as many of them as there are.
fn weight_and_damping(scene: &Scene, body: &Body, neighbourhood: &Neighbourhood) -> Vec<Box<dyn Force>> {
    let damping = &body.material.damping;
    let mut forces: Vec<Box<dyn Force>> = Vec::new();
    let gravity = DVec3::from_array(scene.gravity);
    if gravity != DVec3::ZERO {
        forces.push(Box::new(Gravity::new(gravity, drives::gravity(scene))));
    }
    if damping.pair > 0.0 {
        forces.push(Box::new(PairDamping::new(damping.pair, neighbourhood)));
    }
    if damping.air > 0.0 {
        forces.push(Box::new(AirDrag { rate: damping.air }));
    }
    forces
}

/// Particles are balls of radius D / 2, as stiff against others as the material.
fn contact_law(scene: &Scene, body: &Body, mass: f64) -> ContactLaw {
    let spacing = body.material.spacing();
    let stiffness = body.material.young_modulus * spacing;
    let critical = (stiffness * mass).sqrt();
    ContactLaw {
        radius: 0.5 * spacing,
        stiffness,
        damping: 2.0 * scene.room.contact_damping * critical,
        friction: scene.room.friction,
        sticking: STICKING * critical,
        holding: room::holding(scene, stiffness),
    }
}

fn initial_state(
    body: &Body,
    points: &[DVec3],
    regions: &HashMap<String, Vec<u32>>,
    mass: f64,
    path: &str,
) -> Result<ParticleState, BakeError> {
    let n = points.len();
    let positions: Vec<DVec3> = deformed(&body.initial, points).map(|x| to_world(&body.placement, x)).collect();
    let velocity = DVec3::from_array(body.initial.velocity);
    let mut state = ParticleState { velocities: vec![velocity; n], masses: vec![mass; n], positions };
    spin(&mut state, &body.initial);
    for (k, impulse) in body.impulses.iter().enumerate() {
        let group = supports::find(regions, &impulse.region, &format!("{path}/impulses/{k}/region"))?;
        give_impulse(&mut state, group, DVec3::from_array(impulse.impulse));
    }
    Ok(state)
}
