//! Moving, turning and scaling a body.

use super::of_elements::scale_element;
use super::of_fibres::{scaled_drives, scaled_fibre, scaled_source};
use super::of_pins::{carried_pins, scaled_pins};
use super::of_two_layer::scaled_two_layer;
use super::rigid::Rigid;
use crate::edit::fibre_ops::FibreEditError;
use crate::edit::sheet_ops;
use crate::scene::{
    Body, Dab, Follow, FollowSelect, Impulse, Mass, OwnedBody, Placement, Region, Rotation, Selector, Shape, VoidShape,
};
use glam::{DQuat, DVec3};

/// The body moved by `offset` [m], world.
pub fn moved(body: &OwnedBody, offset: DVec3) -> OwnedBody {
    carried(body, &Rigid { turn: DQuat::IDENTITY, offset })
}

/// The body turned about an axis of any length but zero through a pivot [m], world, right-handed by `radians`.
///
/// # Errors
/// An axis that points nowhere.
pub fn turned(body: &OwnedBody, pivot: DVec3, axis: DVec3, radians: f64) -> Result<OwnedBody, FibreEditError> {
    let unit = axis.try_normalize().ok_or(FibreEditError::NoDirection(axis.to_array()))?;
    let turn = DQuat::from_axis_angle(unit, radians);
    Ok(carried(body, &Rigid { turn, offset: pivot - turn * pivot }))
}

/// The body larger by a factor above zero about a pivot [m], world. The scene's assets have to have its mesh in the new
/// scale.
///
/// # Errors
/// A factor that leaves nothing.
pub fn scaled(body: &OwnedBody, pivot: DVec3, factor: f64) -> Result<OwnedBody, FibreEditError> {
    if !(factor.is_finite() && factor > 0.0) {
        return Err(FibreEditError::NoSize(factor));
    }
    let mut body = body.clone();
    match &mut body {
        OwnedBody::Solid(body) => scale_solid(body, factor)?,
        OwnedBody::TwoLayer(body) => **body = scaled_two_layer(body, factor),
    }
    let mut view = body.view_mut();
    view.regions_mut().iter_mut().for_each(|region| scale_region(region, factor));
    scaled_drives(view.drives_mut(), factor);
    scaled_pins(view.pins_mut(), pivot, factor);
    view.follows_mut().iter_mut().for_each(|follow| scale_follow(follow, factor));
    let placement = view.placement_mut();
    let at = DVec3::from_array(placement.translation);
    placement.translation = (pivot + factor * (at - pivot)).to_array();
    Ok(body)
}

/// Where a point of the model frame [m] stands in the world.
pub fn placed(placement: &Placement, point: DVec3) -> DVec3 {
    placement.rotation.quaternion() * point + DVec3::from_array(placement.translation)
}

fn carried(body: &OwnedBody, by: &Rigid) -> OwnedBody {
    let mut body = body.clone();
    if let OwnedBody::TwoLayer(body) = &mut body {
        body.grabs.iter_mut().for_each(|grab| grab.target = by.apply(grab.target));
    }
    let mut view = body.view_mut();
    carried_pins(view.pins_mut(), by);
    let placement = view.placement_mut();
    placement.translation = by.apply(placement.translation);
    if by.turn != DQuat::IDENTITY {
        let (axis, angle) = (by.turn * placement.rotation.quaternion()).normalize().to_axis_angle();
        // The shorter way round.
        let angle = if angle > std::f64::consts::PI { angle - std::f64::consts::TAU } else { angle };
        let extra = std::mem::take(&mut placement.rotation.extra);
        placement.rotation = Rotation { extra, ..Rotation::about(axis, angle.to_degrees()) };
    }
    body
}

fn scale_solid(body: &mut Body, factor: f64) -> Result<(), FibreEditError> {
    match &mut body.shape {
        Shape::Box(shape) => {
            shape.center = shape.center.map(|at| factor * at);
            shape.size = shape.size.map(|size| factor * size);
        }
        Shape::Ball(shape) => shape.radius *= factor,
        Shape::Cylinder(shape) => (shape.radius, shape.height) = (factor * shape.radius, factor * shape.height),
        Shape::Capsule(shape) => (shape.radius, shape.height) = (factor * shape.radius, factor * shape.height),
        Shape::Torus(shape) => {
            (shape.radius, shape.tube_radius) = (factor * shape.radius, factor * shape.tube_radius);
        }
        Shape::Mesh(shape) => shape.scale *= factor,
    }
    let material = &mut body.material;
    material.support_radius *= factor;
    if let Mass::PerParticle(mass) = &mut material.mass {
        *mass *= factor.powi(3);
    }
    for fibre in &mut body.fibres {
        *fibre = scaled_fibre(fibre, factor)?;
    }
    for sheet in &mut body.sheets {
        *sheet = sheet_ops::scaled(sheet, factor)?;
    }
    body.elements.iter_mut().for_each(|element| scale_element(element, factor));
    scale_paint(&mut body.paint, factor);
    for void in &mut body.voids {
        scale_void(&mut void.shape, factor)?;
    }
    for of in &mut body.region_materials {
        of.transition *= factor;
    }
    for Impulse { impulse, .. } in &mut body.impulses {
        // As fast as before.
        *impulse = impulse.map(|part| part * factor.powi(3));
    }
    Ok(())
}

fn scale_paint(paint: &mut [Dab], factor: f64) {
    for dab in paint {
        dab.center = dab.center.map(|at| factor * at);
        dab.radius *= factor;
    }
}

fn scale_follow(follow: &mut Follow, factor: f64) {
    *follow.leader.scale_mut() *= factor;
    if let FollowSelect::Distance(distance) = &mut follow.select {
        *distance *= factor;
    }
    scale_paint(&mut follow.paint, factor);
}

fn scale_void(shape: &mut VoidShape, factor: f64) -> Result<(), FibreEditError> {
    let scale = |at: &mut [f64; 3]| *at = at.map(|at| factor * at);
    match shape {
        VoidShape::Sphere { center, radius, .. } => {
            scale(center);
            *radius *= factor;
        }
        VoidShape::Box { min, max, .. } => {
            scale(min);
            scale(max);
        }
        VoidShape::Tube { source, radius, .. } => {
            *source = scaled_source(source, factor)?;
            *radius *= factor;
        }
        VoidShape::Mesh(mesh) => mesh.scale *= factor,
    }
    Ok(())
}

fn scale_region(region: &mut Region, factor: f64) {
    let scale = |at: &mut [f64; 3]| *at = at.map(|at| factor * at);
    match &mut region.select {
        Selector::Everything | Selector::Layers { .. } => {}
        Selector::Box { min, max, .. } => {
            scale(min);
            scale(max);
        }
        Selector::Sphere { center, radius, .. } => {
            scale(center);
            *radius *= factor;
        }
    }
}
