//! One two-layer body of the scene: particles, springs, gas, start, stable step.

use super::draft::Draft;
use super::error::BakeError;
use super::integrator::{integrator, stable_steps, step_parameter};
use super::layer_model::LayerModel;
use super::note::Note;
use super::pins::{Following, holders, note_pins};
use super::stage::{BakeStage, Tell, unless_stopped};
use super::start::{deformed, give_impulse, spin, to_world};
use super::thin_places::ThinPlaces;
use super::{drives, follows, limits, room, self_contact, supports};
use crate::scene::{
    AnyBody, Assets, ContactKind, Initial, IntegratorChoice, IntegratorKind, PressureIn, Scene, SpringChoice, TwoLayer,
};
use crate::solver::body::{BodyParts, RestScale};
use crate::solver::collider::Collider;
use crate::solver::constraint::{Constraint, PrescribedMotion};
use crate::solver::embedding::EmbeddingWeights;
use crate::solver::forces::pressure::Surface;
use crate::solver::forces::springs::SpringKind;
use crate::solver::forces::{
    ActiveSprings, AirDrag, Contact, ContactLaw, FlowSurface, Force, Grab, Gravity, Pressure, Springs, total_forces,
};
use crate::solver::integrators::{Integrator, LeapFrog};
use crate::solver::layers::Layers;
use crate::solver::modes::fastest_modes;
use crate::solver::state::ParticleState;
use glam::{BVec3, DVec3};
use std::collections::HashSet;
use std::sync::Arc;

/// Net force below which a particle counts as at rest, in units of KS times the radius.
const REST_FORCE: f64 = 1e-7;

/// What counts as at rest of springs of this constant [N/m] on a body of this radius [m].
fn rest_scale(ks: f64, radius: f64) -> RestScale {
    RestScale { force: REST_FORCE * ks * radius, energy: REST_FORCE * REST_FORCE * ks * radius * radius }
}

pub(super) fn draft(
    scene: &Scene,
    body: &TwoLayer,
    (assets, colliders): (&Assets, &Arc<[Collider]>),
    path: &str,
    notes: &mut Vec<Note>,
    progress: &mut Tell<'_>,
) -> Result<Draft, BakeError> {
    let name = body.title();
    progress(name, BakeStage::Sampling { done: 0, of: 1 })?;
    let model = LayerModel::new(&body.shape, assets, path, notes)?;
    progress(name, BakeStage::Sampling { done: 1, of: 1 })?;
    let regions = supports::chosen(&body.regions, &model.points, path)?;
    let regions = with_layers(regions, model.outer, model.points.len());
    let rest: Arc<[DVec3]> = model.points.iter().map(|&x| to_world(&body.placement, x)).collect();
    let masses = masses(body, &model, &regions, path)?;
    let mut state = start(&body.initial, body, &model.points, masses);
    for (k, impulse) in body.impulses.iter().enumerate() {
        let group = supports::find(&regions, &impulse.region, &format!("{path}/impulses/{k}/region"))?;
        give_impulse(&mut state, group, DVec3::from_array(impulse.impulse));
    }
    let layers = layers(scene, body, &model, &rest);
    encloses(&gas(body, &layers), &state, path)?;
    let active = active_springs(body, &layers.springs, &regions, path, notes)?;
    let particles = (AnyBody::TwoLayer(body), model.points.as_slice(), &regions);
    let followed = follows::bind(scene, assets, particles, path, notes)?;
    let mut forces = own_forces(scene, body, (&model, &active), &layers, (&state, &followed));

    let kind = match body.integrator {
        IntegratorChoice::Automatic => IntegratorKind::LeapFrog,
        IntegratorChoice::Given(kind) => kind,
    };
    let integrator = integrator(kind);
    let contact = Contact::new(room::planes(scene), contact_law(scene, body));
    let touches = !contact.planes.is_empty() || !scene.panels.is_empty() || !colliders.is_empty();
    // Around the rest shape: what a start far from it asks for is not what the run will ask for.
    let at_rest = ParticleState { positions: rest.to_vec(), ..state.clone() };
    let squeeze = squeeze(&model.springs(body).with_active(active.clone()), &gas(body, &layers), &at_rest);
    let probed = |body: &TwoLayer| {
        let body = &TwoLayer { pressure: squeeze * body.pressure, ..body.clone() };
        let own = own_forces(scene, body, (&model, &active), &layers, (&state, &followed));
        let mut forces: Vec<_> = own.iter().map(|force| force.clone_at_extreme(true)).collect();
        if touches {
            forces.push(Box::new(touched(&at_rest, model.outer, &contact_law(scene, body))));
        }
        if body.self_contact {
            // What it touches gives way, and is as light.
            let law = contact_law(scene, body);
            let law = ContactLaw { stiffness: 2.0 * law.stiffness, damping: 2.0 * law.damping, ..law };
            forces.push(Box::new(touched(&at_rest, at_rest.len(), &law)));
        }
        forces
    };
    let modes = unless_stopped(progress, (name, BakeStage::StableStep), |stop| {
        fastest_modes(&mut probed(body), &at_rest, model.radius, stop)
    })?;
    let wind = limits::wind_rate(&forces, &at_rest);
    let layered = limits::Layered { body, path, state: &at_rest, model: &model, wind };
    let burst = layered.burst(&forces);
    let step = |integrator: &dyn Integrator| layered.stable_step(modes.greatest_stable_step(integrator, wind), burst);
    let stable_dt = step(integrator.as_ref());
    let stable_steps = stable_steps(step);
    let plain = |body: &TwoLayer| own_forces(scene, body, (&model, &active), &layers, (&state, &followed));
    let limited_by = layered.limited_by(&modes, integrator.as_ref(), probed, plain);
    let law = contact.law;
    if !contact.planes.is_empty() {
        forces.push(Box::new(contact));
    }
    forces.extend(super::colliders::contact(colliders, law, model.spacing()));
    forces.extend(self_contact::of_two_layer(body, &law, &model).map(|itself| Box::new(itself) as Box<dyn Force>));
    let mut constraints = in_plane(body, &model, &state);
    constraints.extend(follows::constraints(&followed, &rest));
    constraints.extend(supports::constraints((&body.pins, &body.drives), &regions, &rest, &state, path)?);
    let parts = BodyParts {
        explicit_dt: step(&LeapFrog::default()),
        id: body.id.clone(),
        pointer: path.to_owned(),
        name: name.to_owned(),
        kind: "two_layer",
        model: model.points.as_slice().into(),
        rest,
        forces,
        integrator,
        integrator_word: kind.word(),
        integrator_reason: None,
        constraints,
        contact: law,
        contact_surface: None,
        fibres: Vec::new(),
        sheets: Vec::new(),
        elements: Vec::new(),
        skin: model.skin,
        parted_skin: None,
        reach: model.radius,
        rest_scale: rest_scale(body.ks, model.radius),
        mean_neighbours: 2.0 * layers.springs.ends().len() as f64 / state.len() as f64,
        layers: Some(Arc::new(layers)),
        state,
        dt: stable_dt,
        stable_dt,
        limited_by,
        step_parameter: step_parameter(scene).to_owned(),
    };
    if parts.skin.is_none() && drives::blows(scene) {
        let text =
            "the wind does not push on it: a segment or a ring has no surface; give a ball or a mesh, or `air_drag`";
        notes.push(Note { path: path.to_owned(), text: text.to_owned(), warning: true });
    }
    let holders = holders(&body.pins, &body.follows, path);
    note_pins(scene, &holders, &parts, Following::of_two_layer(body, model.radius), notes);
    Ok(Draft { parts, regions, stable_steps, fractions: Vec::new(), thin: ThinPlaces::default() })
}

/// All forces but contact, with the constants of `body`; it is grabbed by the particles that are nearest at the start.
fn own_forces(
    scene: &Scene,
    body: &TwoLayer,
    (model, active): (&LayerModel, &[ActiveSprings]),
    layers: &Layers,
    (start, followed): (&ParticleState, &[follows::Bound]),
) -> Vec<Box<dyn Force>> {
    let springs = model.springs(body).with_active(active.to_vec());
    let mut forces: Vec<Box<dyn Force>> = vec![Box::new(springs)];
    forces.extend(gas(body, layers).into_iter().map(|gas| Box::new(gas) as Box<dyn Force>));
    let gravity = DVec3::from_array(scene.gravity);
    if gravity != DVec3::ZERO {
        forces.push(Box::new(Gravity::new(gravity, drives::gravity(scene))));
    }
    if body.air_drag > 0.0 {
        forces.push(Box::new(AirDrag { rate: body.air_drag }));
    }
    if let Some(Surface::Faces(faces)) = scene.wind.as_ref().and(layers.outer_surface.as_ref()) {
        let vertices = (0..model.outer as u32).map(EmbeddingWeights::of_particle).collect();
        let surface = FlowSurface { vertices, triangles: Arc::clone(faces) };
        forces.extend(drives::wind(scene, surface).map(|flow| Box::new(flow) as Box<dyn Force>));
    }
    let led = follows::springs(followed, &body.follows, start);
    forces.extend(led.into_iter().map(|springs| Box::new(springs) as Box<dyn Force>));
    for grab in &body.grabs {
        let target = DVec3::from_array(grab.target);
        forces.push(Box::new(Grab {
            point: EmbeddingWeights::of_particle(nearest(&start.positions[..model.outer], target)),
            target,
            stiffness: body.mks,
            damping: body.mkd,
            until: grab.until.unwrap_or(f64::INFINITY),
        }));
    }
    forces
}

/// Of the particles, the one nearest to a point.
fn nearest(positions: &[DVec3], target: DVec3) -> u32 {
    let distance = |i: &usize| positions[*i].distance_squared(target);
    (0..positions.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0) as u32
}

fn contact_law(scene: &Scene, body: &TwoLayer) -> ContactLaw {
    ContactLaw {
        radius: 0.0,
        stiffness: body.contact.kc,
        damping: body.contact.cc,
        friction: scene.room.friction,
        sticking: body.contact.ct,
        holding: room::holding(scene, body.contact.kc),
    }
}

fn layers(scene: &Scene, body: &TwoLayer, model: &LayerModel, rest: &[DVec3]) -> Layers {
    let normal = body.placement.rotation.quaternion() * DVec3::Z;
    debug_assert_eq!(rest.len(), model.points.len());
    Layers {
        dimension: model.dimension,
        outer: model.outer,
        springs: model.springs(body),
        outer_surface: model.surface(0, normal),
        inner_surface: model.has_inner_layer().then(|| model.surface(model.outer, normal)).flatten(),
        grab: [body.mks, body.mkd],
        reset: match body.contact.law {
            ContactKind::Penalty => Vec::new(),
            ContactKind::PaperReset => room::planes(scene),
        },
    }
}

/// The springs that act, each with both ends in its region.
fn active_springs(
    body: &TwoLayer,
    springs: &Springs,
    regions: &supports::Regions,
    path: &str,
    notes: &mut Vec<Note>,
) -> Result<Vec<ActiveSprings>, BakeError> {
    let mut all = Vec::new();
    // Of springs that two of them have, the later one counts.
    let mut taken = HashSet::new();
    for (k, of) in body.active_springs.iter().enumerate().rev() {
        let region = supports::find(regions, &of.region, &format!("{path}/active_springs/{k}/region"))?;
        let is_within: HashSet<u32> = region.iter().copied().collect();
        let kinds: &[SpringKind] = match of.springs {
            SpringChoice::All => {
                &[SpringKind::Structural, SpringKind::Radius, SpringKind::ShearLeft, SpringKind::ShearRight]
            }
            SpringChoice::Structural => &[SpringKind::Structural],
            SpringChoice::Radius => &[SpringKind::Radius],
            SpringChoice::Shear => &[SpringKind::ShearLeft, SpringKind::ShearRight],
        };
        let groups = springs.groups().iter().filter(|group| kinds.contains(&group.kind));
        let chosen = groups.flat_map(|group| group.springs.clone());
        let chosen = chosen.filter(|&spring| springs.ends()[spring].iter().all(|end| is_within.contains(end)));
        let chosen: Vec<u32> = chosen.map(|spring| spring as u32).filter(|&spring| taken.insert(spring)).collect();
        if chosen.is_empty() {
            let text = "moves nothing: no spring of that kind has both ends in its region, or later ones have them all";
            notes.push(Note { path: format!("{path}/active_springs/{k}"), text: text.to_owned(), warning: true });
        }
        all.push(ActiveSprings::new(&of.id, chosen, of.contract, drives::drive(&of.drive, &body.drives)));
    }
    Ok(all)
}

/// A body that its springs make smaller swings past the size that they hold it at, by up to half as much again where
/// they do it at once; found by simulation of balls under contractions of 0.3 and 0.6.
const PAST: f64 = 1.45;

/// By what factor gas is stiffer where active springs have made the body as small as it ever gets: a body that is
/// smaller by a factor s all over has `1 / s²` times the slope of its pressure by a move, in two dimensions and in
/// three.
fn squeeze(springs: &Springs, gas: &[Pressure], state: &ParticleState) -> f64 {
    if gas.is_empty() || !springs.is_active() {
        return 1.0;
    }
    let center = state.positions.iter().sum::<DVec3>() / state.len() as f64;
    let mut forces: Vec<Box<dyn Force>> = vec![springs.clone_at_extreme(true)];
    forces.extend(gas.iter().map(|gas| gas.clone_at_extreme(false)));
    let mut scaled = state.clone();
    scaled.velocities.fill(DVec3::ZERO);
    // Which way the forces move all of it: what they do as it grows by a share.
    let mut grows = |by: f64| {
        for (to, from) in scaled.positions.iter_mut().zip(&state.positions) {
            *to = center + by * (*from - center);
        }
        let forces = total_forces(&mut forces, &scaled);
        forces.iter().zip(&scaled.positions).map(|(force, x)| force.dot(*x - center)).sum::<f64>() > 0.0
    };
    if grows(1.0) {
        return 1.0;
    }
    let (mut small, mut large) = (0.0, 1.0);
    for _ in 0..20 {
        let middle = 0.5 * (small + large);
        if grows(middle) { small = middle } else { large = middle }
    }
    // As far as it swings past, but not to nothing.
    (1.0 - PAST * (1.0 - large)).max(0.5 * large).powi(-2)
}

/// The gas, where there is any. A body without an inner layer has all its gas in the outer one.
fn gas(body: &TwoLayer, layers: &Layers) -> Vec<Pressure> {
    let Some(outer) = layers.outer_surface.clone().filter(|_| body.pressure > 0.0) else { return Vec::new() };
    let spaces = match (body.pressure_in, layers.inner_surface.clone()) {
        (PressureIn::Inner, Some(inner)) => vec![vec![(inner, 1.0)]],
        (PressureIn::Both, Some(inner)) => vec![vec![(outer, 1.0)], vec![(inner, 1.0)]],
        (PressureIn::Annulus, Some(inner)) => vec![vec![(outer, 1.0), (inner, -1.0)]],
        _ => vec![vec![(outer, 1.0)]],
    };
    let drive = body.pressure_drive.as_ref().map(|drive| drives::drive(drive, &body.drives));
    spaces.into_iter().map(|surfaces| Pressure::new(body.pressure, surfaces).driven(drive.clone())).collect()
}

/// Refuses a start whose gas has no volume.
fn encloses(gas: &[Pressure], state: &ParticleState, path: &str) -> Result<(), BakeError> {
    let volumes = gas.iter().map(|pressure| pressure.volume(&state.positions));
    match volumes.into_iter().find(|volume| *volume <= 0.0) {
        Some(volume) => Err(BakeError::InsideOut { path: format!("{path}/initial/deformation"), volume }),
        None => Ok(()),
    }
}

/// What a contact asks of the time step: the lightest of the first `touching` particles touches something that does not
/// give.
fn touched(state: &ParticleState, touching: usize, law: &ContactLaw) -> Grab {
    let lightest = (0..touching).min_by(|&a, &b| state.masses[a].total_cmp(&state.masses[b])).unwrap_or(0);
    Grab {
        point: EmbeddingWeights::of_particle(lightest as u32),
        target: state.positions[lightest],
        stiffness: law.stiffness,
        damping: law.damping.max(law.sticking),
        until: f64::INFINITY,
    }
}

fn with_layers(mut regions: supports::Regions, outer: usize, all: usize) -> supports::Regions {
    let range = |range: std::ops::Range<usize>| range.map(|i| i as u32).collect();
    regions.insert("outer".to_owned(), range(0..outer));
    regions.insert("inner".to_owned(), range(outer..all));
    regions.insert("everything".to_owned(), range(0..all));
    regions
}

/// Masses layer by layer, then region by region: of two regions that overlap the later one counts.
fn masses(body: &TwoLayer, model: &LayerModel, regions: &supports::Regions, path: &str) -> Result<Vec<f64>, BakeError> {
    let mut masses = vec![body.mass; model.points.len()];
    masses[model.outer..].fill(body.inner_mass.unwrap_or(body.mass));
    for (k, of) in body.masses.iter().enumerate() {
        for &i in supports::find(regions, &of.region, &format!("{path}/masses/{k}/region"))? {
            masses[i as usize] = of.mass;
        }
    }
    Ok(masses)
}

fn start(initial: &Initial, body: &TwoLayer, points: &[DVec3], masses: Vec<f64>) -> ParticleState {
    let positions = deformed(initial, points).map(|x| to_world(&body.placement, x)).collect();
    let velocities = vec![DVec3::from_array(initial.velocity); points.len()];
    let mut state = ParticleState { positions, velocities, masses };
    spin(&mut state, initial);
    state
}

/// A ring whose plane lies across a world axis is held in it; the forces of any other ring lie in its plane anyway.
fn in_plane(body: &TwoLayer, model: &LayerModel, state: &ParticleState) -> Vec<Constraint> {
    let normal = (body.placement.rotation.quaternion() * DVec3::Z).abs();
    let locked = BVec3::new(normal.x > 1.0 - 1e-12, normal.y > 1.0 - 1e-12, normal.z > 1.0 - 1e-12);
    if model.dimension != 2 || !locked.any() {
        return Vec::new();
    }
    vec![Constraint {
        id: None,
        particles: (0..state.len() as u32).collect(),
        start: state.positions.clone(),
        found: None,
        locked,
        motion: PrescribedMotion::Fixed,
    }]
}
