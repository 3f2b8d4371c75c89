//! One body of the scene: particles, forces, start, stable step.

use super::contact_surface::contact_surface;
use super::draft::Draft;
use super::elements::{self, OwnElements};
use super::error::BakeError;
use super::fibres::PlacedFibre;
use super::integrator::{integrator, stable_steps, step_parameter, stepping};
use super::limits::{Resistance, Softer, SolidParameter};
use super::note::Note;
use super::parted_skin::parted_skin;
use super::particle_sampling::ParticleSampling;
use super::pins::{Following, holders, note_pins};
use super::region_materials::varied;
use super::sheets::PlacedSheet;
use super::stage::{BakeStage, Tell, unless_stopped};
use super::start::{deformed, give_impulse, spin, to_world};
use super::surroundings::Surroundings;
use super::thin_places::ThinPlaces;
use super::{drives, fibres, follows, fractions, regime, room, self_contact, sheets, supports};
use crate::geometry::kernel::Kernel;
use crate::scene::{AnyBody, Assets, Body, BodyKind, Mass, Material, Precision, Scene};
use crate::solver::body::{BodyParts, RestScale};
use crate::solver::collider::Collider;
use crate::solver::embedding::Embedder;
use crate::solver::forces::element::Structure;
use crate::solver::forces::{
    AirDrag, Contact, ContactLaw, Elasticity, ElementForce, FibreForce, Force, Gravity, InelasticLaw, MatrixForce,
    PairDamping, Plasticity, SelfContact, SheetForce, StepLimit, Viscosity,
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

/// What counts as at rest of particles so far apart [m], of such a volume [m³].
fn rest_scale(young_modulus: f64, spacing: f64, volume: f64) -> RestScale {
    RestScale {
        force: REST_FORCE * young_modulus * spacing * spacing,
        energy: REST_FORCE * REST_FORCE * young_modulus * volume,
    }
}

pub(super) fn draft(
    scene: &Scene,
    body: &Body,
    (sampling, assets, colliders, own): (&ParticleSampling<'_>, &Assets, &Arc<[Collider]>, &[OwnElements]),
    path: &str,
    notes: &mut Vec<Note>,
    progress: &mut Tell<'_>,
) -> Result<Draft, BakeError> {
    let name = body.title();
    let material = &body.material;
    let spacing = material.spacing();
    let kernel = Kernel::new(material.support_radius);
    let ParticleSampling { sample, volume: shape_volume, size, shares, .. } = sampling;
    let volume = spacing.powi(3) * sample.stretch.element_product();
    let around = Surroundings::find(body, (sampling, kernel), path, notes, progress)?;
    let Surroundings { neighbourhood, apart, seams: (seams, bonds), embedder } = around;
    let diagonal = size.length();
    let placed = fibres::Placing { body, embedder: &embedder, diagonal, path, notes }.place();
    let surfaces = sheets::Placing { body, embedder: &embedder, diagonal, path, notes }.place();
    let elements = elements::Placing { body, embedder: &embedder, path, notes }.place(own)?;
    let skin = sampling.skin(kernel, &mut |done, of| progress(name, BakeStage::Skin { done, of }))?.map(Arc::new);
    let mut told = |done, of| progress(name, BakeStage::Skin { done, of });
    let parted_skin = parted_skin(sampling, (&seams, &bonds), kernel, &mut told)?.map(Arc::new);

    let mass = match material.mass {
        Mass::Density(density) => density * shape_volume / sampling.whole as f64,
        Mass::PerParticle(mass) => mass,
    };
    let filled = (mass * sample.points.len() as f64, sampling.filled_volume());
    notes.extend(regime::notes(scene, body, *size, filled, path));
    let orientation = body.placement.rotation.quaternion();
    let regions = supports::regions(body, sample, path)?;
    let rest: Arc<[DVec3]> = sample.points.iter().map(|&x| to_world(&body.placement, x)).collect();
    let varied = varied(body, &regions, &sample.points, [mass, shape_volume / sampling.whole as f64], path)?;
    let mut masses = varied.masses.unwrap_or_else(|| vec![mass; sample.points.len()]);
    if let (Some(shares), Mass::Density(_)) = (shares, &material.mass) {
        share_out(&mut masses, &shares.volumes);
    }
    let state = initial_state(body, &sample.points, &regions, masses, path)?;

    let fractions = fractions::fractions(body, &sample.points, kernel, (&placed, &surfaces));
    let matrix = matrix(body, (sampling, &neighbourhood), &fractions, varied.stiffening);
    let thinning = fractions::driven(body, &sample.points, kernel, (&placed, &surfaces))
        .map(|driven| Box::new(matrix.thinning(driven, orientation)) as Box<dyn Force>);
    let inelastic = inelastic(material).map(|law| Box::new(matrix.inelastic(law, orientation)) as Box<dyn Force>);
    let matrix = in_precision(matrix, material.precision).with_seams(bonds, orientation);
    let mut forces: Vec<Box<dyn Force>> = vec![Box::new(matrix)];
    let lines = elements.iter().map(Structure::drawn).collect();
    let structures = (elements, placed.as_slice(), surfaces.as_slice());
    let (softer, strongest) = add_structures(body, (&embedder, volume, &state), structures, path, &mut forces)?;
    forces.extend(thinning.into_iter().chain(inelastic));
    forces.extend(weight_and_damping(scene, body, &apart, varied.damping.as_deref()));
    let flow = scene.wind.as_ref().and(skin.as_deref()).and_then(|skin| drives::wind(scene, skin.flow_surface()));
    forces.extend(flow.map(|flow| Box::new(flow) as Box<dyn Force>));

    let contact = Contact::new(room::planes(scene), contact_law(scene, body, mass));
    let itself = self_contact::of_solid(body, &contact.law, &sample.points);
    let touching = contact_limit(scene, (&contact, colliders), itself.as_ref(), &state);
    let particles = (AnyBody::Solid(body), sample.points.as_slice(), &regions);
    let followed = follows::bind(scene, assets, particles, path, notes)?;
    let led = follows::springs(&followed, &body.follows, &state);
    let limits = [touching, follows::step_limit(&led, &state)];
    let resistance = unless_stopped(progress, (name, BakeStage::StableStep), |stop| {
        Resistance::measured(&forces, softer, &state, spacing, limits, material.damping.air, stop)
    })?;
    let stable_steps = stable_steps(|integrator| resistance.stable_step(integrator));
    let stepping = stepping(scene, body, &stable_steps, &forces, &state);
    notes.extend(stepping.note(path));
    let integrator = integrator(stepping.integrator);
    let stable_dt = resistance.stable_step(integrator.as_ref());
    let explicit_dt = resistance.stable_step(&LeapFrog::default());
    let limited_by = resistance.limited_by(integrator.as_ref()).map(|parameter| strongest.pointer(parameter, path));
    forces.extend(led.into_iter().map(|springs| Box::new(springs) as Box<dyn Force>));
    let law = contact.law;
    forces.extend(contacts(contact, itself, (colliders, spacing)));

    let mut constraints = follows::constraints(&followed, &rest);
    constraints.extend(supports::constraints((&body.pins, &body.drives), &regions, &rest, &state, path)?);
    let parts = BodyParts {
        id: body.id.clone(),
        pointer: path.to_owned(),
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
        contact_surface: contact_surface(scene, sample, &sampling.hollows, skin.as_deref()),
        fibres: placed.iter().map(PlacedFibre::line).collect(),
        sheets: surfaces.iter().map(|of| of.surface(body)).collect(),
        elements: lines,
        layers: None,
        skin,
        parted_skin,
        reach: material.support_radius,
        rest_scale: rest_scale(material.young_modulus, spacing, volume),
        mean_neighbours: neighbourhood.mean_neighbours(),
        dt: stable_dt,
        stable_dt,
        explicit_dt,
        limited_by,
        step_parameter: step_parameter(scene).to_owned(),
    };
    note_pins(scene, &holders(&body.pins, &body.follows, path), &parts, Following::of_solid(body), notes);
    Ok(Draft { parts, regions, stable_steps, fractions, thin: ThinPlaces::of(sampling, kernel) })
}

/// The matrix of a body whose particles have these fractions of fibre, stiffer by regions.
fn matrix(
    body: &Body,
    (sampling, neighbourhood): (&ParticleSampling<'_>, &Arc<Neighbourhood>),
    fractions: &[f64],
    stiffening: Option<Arc<[f64]>>,
) -> MatrixForce {
    let (material, sample) = (&body.material, &sampling.sample);
    MatrixForce::varied(
        Arc::clone(neighbourhood),
        sample.points.as_slice().into(),
        Elasticity::new(material.young_modulus, material.poisson_ratio, material.spacing())
            .stretched_by(sample.stretch_along()),
        material.spacing().powi(3) * sample.stretch.element_product(),
        (
            fractions::matrix_fractions(fractions),
            stiffening,
            sampling.shares.as_ref().map(|shares| shares.stiffness.as_slice().into()),
        ),
        body.placement.rotation.quaternion(),
    )
}

/// Share of the mean mass that a particle has at least: a lighter one would make the stable step short.
const LIGHTEST: f64 = 0.5;

/// Gives particles masses by the volumes that they stand for, of the same sum.
fn share_out(masses: &mut [f64], volumes: &[f64]) {
    let whole: f64 = masses.iter().sum();
    for (mass, volume) in masses.iter_mut().zip(volumes) {
        *mass *= volume.max(LIGHTEST);
    }
    let scale = whole / masses.iter().sum::<f64>();
    for mass in masses {
        *mass *= scale;
    }
}

/// Contact with the room, with colliders and with itself, as far as there is any.
fn contacts(
    contact: Contact,
    itself: Option<SelfContact>,
    (colliders, spacing): (&Arc<[Collider]>, f64),
) -> impl Iterator<Item = Box<dyn Force>> {
    let with_colliders = super::colliders::contact(colliders, contact.law, spacing);
    let with_room = (!contact.planes.is_empty()).then(|| Box::new(contact) as Box<dyn Force>);
    let with_itself = itself.map(|itself| Box::new(itself) as Box<dyn Force>);
    with_room.into_iter().chain(with_colliders).chain(with_itself)
}

/// What contact with all that there is, itself included, may ask of the step.
fn contact_limit(
    scene: &Scene,
    (contact, colliders): (&Contact, &Arc<[Collider]>),
    itself: Option<&SelfContact>,
    state: &ParticleState,
) -> StepLimit {
    let touches = !contact.planes.is_empty() || !scene.panels.is_empty() || !colliders.is_empty();
    let limit = if touches { contact.step_limit(state) } else { StepLimit::default() };
    itself.map_or(limit, |of| self_contact::either(limit, of.step_limit(state)))
}

/// What of a body's structures is the stiffest, by their places in the scene.
struct Strongest {
    fibre: Option<usize>,
    sheet: Option<usize>,
}

impl Strongest {
    /// The pointer to a parameter of the body at `path`.
    fn pointer(&self, parameter: SolidParameter, path: &str) -> String {
        match (parameter, self.fibre, self.sheet) {
            (SolidParameter::Fibres, Some(fibre), _) => format!("{path}/fibres/{fibre}/stiffness"),
            (SolidParameter::Sheets, _, Some(sheet)) => format!("{path}/sheets/{sheet}/stiffness"),
            (parameter, ..) => parameter.pointer(path),
        }
    }
}

/// Adds the forces of elements, sheets and fibres; gives those that there were without them, and what of them is the
/// stiffest.
fn add_structures(
    body: &Body,
    (embedder, volume, state): (&Embedder<'_>, f64, &ParticleState),
    (elements, fibres, sheets): (Vec<Structure>, &[PlacedFibre], &[PlacedSheet]),
    path: &str,
    forces: &mut Vec<Box<dyn Force>>,
) -> Result<(Softer, Strongest), BakeError> {
    let orientation = body.placement.rotation.quaternion();
    let rods = fibres::rods(body, embedder, volume, fibres, path)?;
    let rests = sheets::rests(body, sheets);
    let strongest = Strongest { fibre: fibres::strongest(body, fibres, &rods), sheet: sheets::strongest(body, sheets) };
    let mut softer = Softer::default();
    if !elements.is_empty() {
        softer.matrix = Some(forces.clone());
        forces.push(Box::new(ElementForce::new(elements, &state.positions, orientation)));
    }
    if !rests.is_empty() {
        softer.unsheeted = Some(forces.clone());
        forces.push(Box::new(SheetForce::new(rests.into())));
    }
    if !rods.is_empty() {
        softer.unthreaded = Some(forces.clone());
        forces.push(Box::new(FibreForce::new(rods.into(), orientation)));
    }
    Ok((softer, strongest))
}

/// A matrix that computes its forces as exactly as is asked for.
fn in_precision(matrix: MatrixForce, precision: Precision) -> MatrixForce {
    match precision {
        Precision::Exact => matrix,
        Precision::Fast => matrix.fast(),
    }
}

/// What of a material is not elastic, if anything.
fn inelastic(material: &Material) -> Option<InelasticLaw> {
    let viscosity = material.viscosity.as_ref().map(|of| Viscosity { shear: of.shear, bulk: of.bulk });
    let plasticity = material.plasticity.as_ref().map(|of| Plasticity {
        yield_stress: of.yield_stress,
        hardening: of.hardening,
        creep_time: of.creep_time,
    });
    let viscosity = viscosity.filter(|of| *of != Viscosity::default());
    (viscosity.is_some() || plasticity.is_some()).then_some(InelasticLaw { viscosity, plasticity })
}

/// Gravity, damping between particles and drag of the air, as many of them as there are; `rates` are those of the
/// damping at every particle where it is not the same everywhere.
fn weight_and_damping(
    scene: &Scene,
    body: &Body,
    neighbourhood: &Neighbourhood,
    rates: Option<&[f64]>,
) -> Vec<Box<dyn Force>> {
    let damping = &body.material.damping;
    let mut forces: Vec<Box<dyn Force>> = Vec::new();
    let gravity = DVec3::from_array(scene.gravity);
    if gravity != DVec3::ZERO {
        forces.push(Box::new(Gravity::new(gravity, drives::gravity(scene))));
    }
    if let Some(rates) = rates {
        forces.push(Box::new(PairDamping::varied(rates, neighbourhood)));
    } else if damping.pair > 0.0 {
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
    masses: Vec<f64>,
    path: &str,
) -> Result<ParticleState, BakeError> {
    let n = points.len();
    let positions: Vec<DVec3> = deformed(&body.initial, points).map(|x| to_world(&body.placement, x)).collect();
    let velocity = DVec3::from_array(body.initial.velocity);
    let mut state = ParticleState { velocities: vec![velocity; n], masses, positions };
    spin(&mut state, &body.initial);
    for (k, impulse) in body.impulses.iter().enumerate() {
        let group = supports::find(regions, &impulse.region, &format!("{path}/impulses/{k}/region"))?;
        give_impulse(&mut state, group, DVec3::from_array(impulse.impulse));
    }
    Ok(state)
}
