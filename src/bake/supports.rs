//! Regions and pins.

use super::drives::drive;
use super::error::{BakeError, known};
use crate::geometry::lattice::LatticeSample;
use crate::scene::{Axis, Body, Distance, Easing, Motion, Pin, Region, Selector, SharedDrive, Side};
use crate::solver::constraint::{Constraint, Course, PrescribedMotion};
use crate::solver::state::ParticleState;
use glam::{BVec3, DMat3, DVec3, IVec3};
use std::collections::HashMap;

/// Particles of regions by their ids.
pub(super) type Regions = HashMap<String, Vec<u32>>;

/// Particles of every region of a body.
pub(super) fn regions(body: &Body, sample: &LatticeSample, path: &str) -> Result<Regions, BakeError> {
    select(&body.regions, sample, path)
}

/// Particles of every region among points that lie on no lattice; regions that count its layers hold none.
pub(super) fn chosen(regions: &[Region], points: &[DVec3], path: &str) -> Result<Regions, BakeError> {
    let extent = points.iter().map(|x| x.abs().max_element()).fold(0.0, f64::max);
    let cells = vec![IVec3::ZERO; points.len()];
    let sample =
        LatticeSample { spacing: extent, axes: DMat3::IDENTITY, stretch: DVec3::ONE, points: points.to_vec(), cells };
    select(regions, &sample, path)
}

fn select(regions: &[Region], sample: &LatticeSample, path: &str) -> Result<Regions, BakeError> {
    let mut found = HashMap::new();
    for (k, region) in regions.iter().enumerate() {
        let inside = selector(&region.select, sample);
        let group: Vec<u32> = (0..sample.points.len()).filter(|&i| inside(i)).map(|i| i as u32).collect();
        if group.is_empty() {
            return Err(BakeError::EmptyRegion {
                path: format!("{path}/regions/{k}/select"),
                particles: sample.points.len(),
            });
        }
        found.insert(region.id.clone(), group);
    }
    Ok(found)
}

/// Edges of selections include what lies on them to this share of the spacing.
const ON_EDGE: f64 = 1e-6;

fn selector<'a>(select: &'a Selector, sample: &'a LatticeSample) -> Box<dyn Fn(usize) -> bool + 'a> {
    let slack = ON_EDGE * sample.spacing;
    match select {
        Selector::Everything => Box::new(|_| true),
        Selector::Layers { axis, side, count, .. } => {
            let axis = axis.index();
            let along = move |cell: &IVec3| cell[axis];
            let count = count.cast_signed();
            let first = sample.cells.iter().map(along).min().unwrap_or(0);
            let last = sample.cells.iter().map(along).max().unwrap_or(0);
            match side {
                Side::Min => Box::new(move |i| along(&sample.cells[i]) < first + count),
                Side::Max => Box::new(move |i| along(&sample.cells[i]) > last - count),
            }
        }
        Selector::Box { min, max, .. } => {
            let (min, max) = (DVec3::from_array(*min) - slack, DVec3::from_array(*max) + slack);
            Box::new(move |i| sample.points[i].cmpge(min).all() && sample.points[i].cmple(max).all())
        }
        Selector::Sphere { center, radius, .. } => {
            let center = DVec3::from_array(*center);
            Box::new(move |i| sample.points[i].distance(center) <= radius + slack)
        }
    }
}

/// The particles of a region, or an error that lists the regions there are.
pub(super) fn find<'a>(
    regions: &'a HashMap<String, Vec<u32>>,
    id: &str,
    path: &str,
) -> Result<&'a Vec<u32>, BakeError> {
    regions.get(id).ok_or_else(|| {
        let mut ids: Vec<&str> = regions.keys().map(String::as_str).collect();
        ids.sort_unstable();
        BakeError::Unknown { path: path.to_owned(), what: "region", id: id.to_owned(), known: known(ids.into_iter()) }
    })
}

/// Prescribed motions of a body's pins, relative to where the particles start.
pub(super) fn constraints(
    (pins, drives): (&[Pin], &[SharedDrive]),
    regions: &Regions,
    rest: &[DVec3],
    state: &ParticleState,
    path: &str,
) -> Result<Vec<Constraint>, BakeError> {
    let mut found = Vec::new();
    for (k, pin) in pins.iter().enumerate() {
        let particles = find(regions, &pin.region, &format!("{path}/pins/{k}/region"))?.clone();
        let start: Vec<DVec3> = particles.iter().map(|&i| state.positions[i as usize]).collect();
        let locked = BVec3::new(pin.axes.contains(&Axis::X), pin.axes.contains(&Axis::Y), pin.axes.contains(&Axis::Z));
        let motion = motion(&pin.motion, drives, rest, &start);
        let id = Some(pin.id.as_str().into());
        found.push(Constraint { id, particles, start, found: None, locked, motion });
    }
    Ok(found)
}

/// A prescribed motion of what starts at `start` [m]; a turn without an origin goes about the middle of that, and
/// `rest` is what shares of an extent are of.
pub(super) fn motion(motion: &Motion, drives: &[SharedDrive], rest: &[DVec3], start: &[DVec3]) -> PrescribedMotion {
    let course =
        |start: f64, duration: f64, easing: Easing| Course { start, duration, smooth: easing == Easing::Smooth };
    let center = || start.iter().sum::<DVec3>() / start.len() as f64;
    match motion {
        Motion::Fixed => PrescribedMotion::Fixed,
        Motion::Ramp(ramp) => {
            let direction = DVec3::from_array(ramp.direction).normalize_or_zero();
            let distance = match ramp.distance {
                Distance::Metres(metres) => metres,
                Distance::Fraction(fraction) => fraction * extent(rest, direction),
            };
            PrescribedMotion::Ramp {
                displacement: distance * direction,
                course: course(ramp.start, ramp.duration, ramp.easing),
            }
        }
        Motion::Turn(turn) => PrescribedMotion::Turn {
            axis: DVec3::from_array(turn.axis).normalize_or(DVec3::Y),
            origin: turn.origin.map_or_else(center, DVec3::from_array),
            angle: turn.degrees.to_radians(),
            course: course(turn.start, turn.duration, turn.easing),
        },
        Motion::Driven(driven) => PrescribedMotion::Driven {
            drive: drive(&driven.drive, drives),
            offset: DVec3::from_array(driven.offset),
            turn: driven.turn.as_ref().map(|turn| {
                let axis = DVec3::from_array(turn.axis).normalize_or(DVec3::Y);
                (axis, turn.origin.map_or_else(center, DVec3::from_array), turn.degrees.to_radians())
            }),
        },
        Motion::Keyframes(keys) => {
            PrescribedMotion::Keyframes(keys.iter().map(|key| (key.time, DVec3::from_array(key.offset))).collect())
        }
    }
}

/// Extent of the particles along a unit direction [m].
fn extent(points: &[DVec3], direction: DVec3) -> f64 {
    let along = points.iter().map(|x| x.dot(direction));
    along.clone().fold(f64::NEG_INFINITY, f64::max) - along.fold(f64::INFINITY, f64::min)
}
