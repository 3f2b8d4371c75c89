//! The colliders of a scene for the solver.

use super::error::BakeError;
use super::supports;
use crate::geometry::obstacle::Obstacle;
use crate::geometry::obstacle_surface::surface;
use crate::scene::{self, Assets, ColliderShape, Scene};
use crate::solver::collider::Collider;
use crate::solver::forces::{ColliderContact, ContactLaw, Force};
use glam::DVec3;
use std::sync::Arc;

/// The scene's colliders.
pub(super) fn colliders(scene: &Scene, assets: &Assets) -> Result<Arc<[Collider]>, BakeError> {
    scene.colliders.iter().enumerate().map(|(index, of)| collider(of, index, assets)).collect()
}

fn collider(of: &scene::Collider, index: usize, assets: &Assets) -> Result<Collider, BakeError> {
    let obstacle = obstacle(&of.shape, index, assets)?;
    let translation = DVec3::from_array(of.placement.translation);
    Ok(Collider {
        id: of.id.clone(),
        name: of.title().to_owned(),
        surface: surface(&obstacle).into(),
        obstacle: Arc::new(obstacle),
        rotation: of.placement.rotation.quaternion(),
        translation,
        motion: supports::motion(&of.motion, &[], &[], &[translation]),
        friction: of.friction,
    })
}

fn obstacle(shape: &ColliderShape, index: usize, assets: &Assets) -> Result<Obstacle, BakeError> {
    Ok(match shape {
        ColliderShape::Sphere(of) => Obstacle::Ball(of.radius),
        ColliderShape::Box(of) => Obstacle::Cuboid(0.5 * DVec3::from_array(of.size)),
        ColliderShape::Capsule(of) => Obstacle::Capsule { radius: of.radius, half: 0.5 * of.length },
        ColliderShape::Plane => Obstacle::HalfSpace,
        ColliderShape::Mesh(of) => {
            let mesh = assets
                .obstacle(of)
                .ok_or_else(|| BakeError::NotLoaded { path: format!("/colliders/{index}/shape/mesh/path") })?;
            Obstacle::Mesh(if of.hollow && mesh.is_solid() { Arc::new(mesh.hollow()) } else { Arc::clone(mesh) })
        }
    })
}

/// Contact with them of a body whose particles lie `spacing` [m] apart, where there are any.
pub(super) fn contact(colliders: &Arc<[Collider]>, law: ContactLaw, spacing: f64) -> Option<Box<dyn Force>> {
    let contact = || ColliderContact::new(Arc::clone(colliders), law, spacing);
    (!colliders.is_empty()).then(|| Box::new(contact()) as Box<dyn Force>)
}
