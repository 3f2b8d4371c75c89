//! One two-layer body of the scene: particles, springs, gas, start, stable step.

use super::body::{Draft, deformed, integrator, kick, room_planes, spin, to_world, turn};
use super::{BakeError, BakeStage, supports};
use crate::geometry::octahedron::{edges, sphere};
use crate::scene::{ContactKind, Initial, PressureIn, Scene, TimeStep, TwoLayer, TwoLayerShape};
use crate::solver::body::{BodyParts, RestScale};
use crate::solver::constraint::{Constraint, PrescribedMotion};
use crate::solver::forces::pressure::Surface;
use crate::solver::forces::springs::{SpringGroup, SpringKind};
use crate::solver::forces::{AirDrag, Contact, ContactLaw, DragSpring, Force, Gravity, Pressure, Springs};
use crate::solver::layers::Layers;
use crate::solver::modes::{fastest_modes, greatest_stable_step};
use crate::solver::skin::Skin;
use crate::solver::state::ParticleState;
use glam::{BVec3, DVec3};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Net force below which a particle counts as at rest, in units of KS times the radius.
const REST_FORCE: f64 = 1e-7;

pub(super) fn draft(
    scene: &Scene,
    body: &TwoLayer,
    path: &str,
    progress: &mut dyn FnMut(&str, BakeStage),
) -> Result<Draft, BakeError> {
    let name = if body.name.is_empty() { &body.id } else { &body.name };
    progress(name, BakeStage::Sampling);
    let model = Model::new(&body.shape);
    let regions = supports::chosen(&body.regions, &model.points, path)?;
    let regions = with_layers(regions, model.outer, model.points.len());
    let rest: Arc<[DVec3]> = model.points.iter().map(|&x| to_world(&body.placement, x)).collect();
    let masses = masses(body, &model, &regions, path)?;
    let mut state = start(&body.initial, body, &model.points, masses);
    for (k, impulse) in body.impulses.iter().enumerate() {
        let group = supports::find(&regions, &impulse.region, &format!("{path}/impulses/{k}/region"))?;
        kick(&mut state, group, DVec3::from_array(impulse.impulse));
    }

    let layers = layers(scene, body, &model, &rest);
    let mut forces: Vec<Box<dyn Force>> = vec![Box::new(layers.springs.clone())];
    for pressure in gas(body, &layers) {
        let volume = pressure.volume(&state.positions);
        if volume <= 0.0 {
            return Err(BakeError::InsideOut { path: format!("{path}/initial/deformation"), volume });
        }
        forces.push(Box::new(pressure));
    }
    let gravity = DVec3::from_array(scene.gravity);
    if gravity != DVec3::ZERO {
        forces.push(Box::new(Gravity { acceleration: gravity }));
    }
    if body.air_drag > 0.0 {
        forces.push(Box::new(AirDrag { rate: body.air_drag }));
    }
    for drag in &body.drags {
        let target = DVec3::from_array(drag.target);
        forces.push(Box::new(DragSpring {
            particle: DragSpring::nearest(&state.positions[..model.outer], target),
            target,
            stiffness: body.mks,
            damping: body.mkd,
            until: drag.until.unwrap_or(f64::INFINITY),
        }));
    }

    progress(name, BakeStage::StableStep);
    let integrator = integrator(body.integrator);
    let law = ContactLaw {
        radius: 0.0,
        stiffness: body.contact.kc,
        damping: body.contact.cc,
        friction: scene.room.friction,
        sticking: body.contact.ct,
    };
    let contact = Contact { planes: room_planes(scene), law };
    let touches = !contact.planes.is_empty() || !scene.panels.is_empty();
    // Around the rest shape: what a start far from it asks for is not what the run will ask for.
    let at_rest = ParticleState { positions: rest.to_vec(), ..state.clone() };
    let mut probed = forces.clone();
    if touches {
        probed.push(Box::new(touched(&at_rest, model.outer, &law)));
    }
    let modes = fastest_modes(&mut probed, &at_rest, body.shape.radius());
    let stable_dt = greatest_stable_step(integrator.as_ref(), &modes);
    if !contact.planes.is_empty() {
        forces.push(Box::new(contact));
    }
    let mut constraints = in_plane(body, &model, &state);
    constraints.extend(supports::constraints(&body.pins, &regions, &rest, &state, path)?);
    let radius = body.shape.radius();
    let parts = BodyParts {
        id: body.id.clone(),
        name: name.clone(),
        kind: "two_layer",
        model: model.points.as_slice().into(),
        rest,
        forces,
        integrator,
        constraints,
        contact: law,
        fibres: Vec::new(),
        skin: model.skin(),
        reach: radius,
        rest_scale: RestScale {
            force: REST_FORCE * body.ks * radius,
            energy: REST_FORCE * REST_FORCE * body.ks * radius * radius,
        },
        mean_neighbours: 2.0 * layers.springs.ends().len() as f64 / state.len() as f64,
        layers: Some(Arc::new(layers)),
        state,
        dt: stable_dt,
        stable_dt,
        step_parameter: match &scene.time.step {
            TimeStep::Automatic(_) => "/time/step/automatic/safety".to_owned(),
            TimeStep::Manual(_) => "/time/step/manual/dt".to_owned(),
        },
    };
    Ok(Draft { parts, regions })
}

/// Points and how they hang together, in the model frame; the outer layer comes first.
struct Model {
    points: Vec<DVec3>,
    outer: usize,
    /// Edges of the outer layer; the inner layer has the same.
    edges: Vec<[u32; 2]>,
    /// Faces of the outer layer in 3D.
    faces: Vec<[u32; 3]>,
    dimension: u32,
}

impl Model {
    fn new(shape: &TwoLayerShape) -> Self {
        let (mut points, edges, faces, radii) = match shape {
            TwoLayerShape::Segment(segment) => {
                let end = 0.5 * segment.length * DVec3::X;
                (vec![-end, end], vec![[0, 1]], Vec::new(), None)
            }
            TwoLayerShape::Ring(ring) => {
                let n = ring.sides;
                let at = |k: u32| {
                    // The first side lies flat below, so that the body stands on it.
                    let angle = TAU * ((f64::from(k) + 0.5) / f64::from(n) - 0.25);
                    DVec3::new(angle.cos(), angle.sin(), 0.0)
                };
                let edges = (0..n).map(|k| [k, (k + 1) % n]).collect();
                let radii = (ring.outer_radius, (!ring.single_layer).then_some(ring.inner_radius));
                ((0..n).map(at).collect(), edges, Vec::new(), Some(radii))
            }
            TwoLayerShape::Ball(ball) => {
                let mesh = sphere(ball.subdivisions);
                let edges = edges(&mesh);
                let radii = (ball.outer_radius, (!ball.single_layer).then_some(ball.inner_radius));
                (mesh.positions, edges, mesh.triangles, Some(radii))
            }
        };
        let outer = points.len();
        if let Some((outer_radius, inner_radius)) = radii {
            let unit = points.clone();
            points = unit.iter().map(|&x| outer_radius * x).collect();
            points.extend(inner_radius.into_iter().flat_map(|radius| unit.iter().map(move |&x| radius * x)));
        }
        Self { points, outer, edges, faces, dimension: shape.dimension() }
    }

    fn has_inner_layer(&self) -> bool {
        self.points.len() > self.outer
    }

    /// Every spring, kind by kind, with the constants of the body.
    fn springs(&self, body: &TwoLayer) -> Springs {
        let n = self.outer as u32;
        let inner = self.has_inner_layer();
        let between = |pairs: Vec<[u32; 2]>| if inner { pairs } else { Vec::new() };
        let mut structural = self.edges.clone();
        structural.extend(between(self.edges.iter().map(|&[a, b]| [a + n, b + n]).collect()));
        let radius = between((0..n).map(|i| [i + n, i]).collect());
        let left = between(self.edges.iter().map(|&[a, b]| [a + n, b]).collect());
        let right = between(self.edges.iter().map(|&[a, b]| [b + n, a]).collect());
        let mut ends: Vec<[u32; 2]> = Vec::new();
        let mut groups = Vec::new();
        for (kind, springs) in [
            (SpringKind::Structural, structural),
            (SpringKind::Radius, radius),
            (SpringKind::ShearLeft, left),
            (SpringKind::ShearRight, right),
        ] {
            let (stiffness, damping) =
                if kind == SpringKind::Structural { (body.ks, body.kd) } else { (body.rks, body.rkd) };
            let first = ends.len();
            ends.extend(springs);
            groups.push(SpringGroup { kind, stiffness, damping, springs: first..ends.len() });
        }
        let at = |i: u32| self.points[i as usize];
        let rest_lengths = ends.iter().map(|&[a, b]| at(a).distance(at(b))).collect();
        Springs::new(ends.into(), rest_lengths, groups)
    }

    /// Surface of a layer whose first particle is `first`.
    fn surface(&self, first: usize, normal: DVec3) -> Option<Surface> {
        let first = first as u32;
        match self.dimension {
            2 => Some(Surface::Polygon {
                edges: self.edges.iter().map(|edge| edge.map(|i| i + first)).collect(),
                normal,
            }),
            3 => Some(Surface::Faces(self.faces.iter().map(|face| face.map(|i| i + first)).collect())),
            _ => None,
        }
    }

    /// The outer layer of a ball, drawn as it is.
    fn skin(&self) -> Option<Arc<Skin>> {
        (self.dimension == 3).then(|| Arc::new(Skin::of_particles(self.outer as u32, &self.faces)))
    }
}

fn layers(scene: &Scene, body: &TwoLayer, model: &Model, rest: &[DVec3]) -> Layers {
    let normal = turn(&body.placement.rotation) * DVec3::Z;
    debug_assert_eq!(rest.len(), model.points.len());
    Layers {
        dimension: model.dimension,
        outer: model.outer,
        springs: model.springs(body),
        outer_surface: model.surface(0, normal),
        inner_surface: model.has_inner_layer().then(|| model.surface(model.outer, normal)).flatten(),
        drag: [body.mks, body.mkd],
        reset: match body.contact.law {
            ContactKind::Penalty => Vec::new(),
            ContactKind::PaperReset => room_planes(scene),
        },
    }
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
    spaces.into_iter().map(|surfaces| Pressure::new(body.pressure, surfaces)).collect()
}

/// What a contact asks of the time step: the lightest outer particle touches something that does not give.
fn touched(state: &ParticleState, outer: usize, law: &ContactLaw) -> DragSpring {
    let lightest = (0..outer).min_by(|&a, &b| state.masses[a].total_cmp(&state.masses[b])).unwrap_or(0);
    DragSpring {
        particle: lightest,
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
fn masses(body: &TwoLayer, model: &Model, regions: &supports::Regions, path: &str) -> Result<Vec<f64>, BakeError> {
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
fn in_plane(body: &TwoLayer, model: &Model, state: &ParticleState) -> Vec<Constraint> {
    let normal = (turn(&body.placement.rotation) * DVec3::Z).abs();
    let locked = BVec3::new(normal.x > 1.0 - 1e-12, normal.y > 1.0 - 1e-12, normal.z > 1.0 - 1e-12);
    if model.dimension != 2 || !locked.any() {
        return Vec::new();
    }
    vec![Constraint {
        particles: (0..state.len() as u32).collect(),
        start: state.positions.clone(),
        locked,
        motion: PrescribedMotion::Fixed,
    }]
}
