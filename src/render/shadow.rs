//! The shadow on the floor, made once for a list: see shadow.wgsl and shade.wgsl.

use crate::draw::DrawList;
use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3, Vec4};

/// Towards the key light: over the left shoulder of who looks from the front, and high.
pub(super) const KEY_DIRECTION: Vec3 = Vec3::new(-0.42, 0.80, 0.43);
/// Width of the light a metre of distance: the tangent of half its angle.
const LIGHT_WIDTH: f32 = 0.20;
/// Reach and height of the contact shadow in radii of what casts it.
const CONTACT_REACH: f32 = 0.55;
const CONTACT_HEIGHT: f32 = 0.16;

/// As `Caster` in the shaders.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Caster {
    slope: Vec4,
    window: Vec4,
    soft: Vec4,
}

impl Caster {
    /// Along the key light, and from straight above, over the part of the floor that a shadow can reach; none where
    /// there is no floor, or nothing above it.
    pub(super) fn of(list: &DrawList) -> Option<[Self; 2]> {
        let bounds = list.bounds.filter(|_| list.ground.solid)?;
        let ground = (list.ground.height - list.origin.y) as f32;
        let key = KEY_DIRECTION.normalize_or(Vec3::Y);
        let slope = Vec2::new(key.x, key.z) / key.y;
        let tallest = (list.local(bounds.max).y - ground).max(1e-6);
        let fall = |corner: Vec3| Vec2::new(corner.x, corner.z) - slope * (corner.y - ground).max(0.0);
        let corners = bounds.corners().map(|corner| list.local(corner));
        let places = corners.map(fall).into_iter().chain(corners.map(|corner| Vec2::new(corner.x, corner.z)));
        let (low, high) =
            places.fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        let radius = bounds.radius() as f32;
        let margin = LIGHT_WIDTH * tallest + CONTACT_REACH * radius;
        let middle = 0.5 * (low + high);
        let half = 0.5 * (high - low).max_element() + margin;
        let window = Vec4::new(middle.x, middle.y, half, 0.0);
        let soft = Vec4::new(LIGHT_WIDTH, CONTACT_REACH * radius, CONTACT_HEIGHT * radius, 0.0);
        let along = |slope: Vec2| Self { slope: Vec4::new(slope.x, slope.y, ground, tallest), window, soft };
        (half.is_finite() && half > 0.0).then(|| [along(slope), along(Vec2::ZERO)])
    }

    /// Middle and half extent of the shadow on the floor.
    pub(super) fn place(&self) -> Vec4 {
        self.window
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::{Bounds, Ground, Theme};
    use glam::DVec3;

    #[test]
    fn only_a_floor_takes_a_shadow_and_the_whole_of_it() {
        let ground = Ground { height: 1.0, solid: true, grid: true, axes: true };
        let mut list = DrawList::new(DVec3::new(5.0, 1.0, 0.0), ground, Theme::light());
        assert_eq!(Caster::of(&list), None);
        let (min, max) = (DVec3::new(4.9, 1.2, -0.1), DVec3::new(5.1, 1.4, 0.1));
        list.bounds = Some(Bounds { min, max });
        let [along_key, _] = Caster::of(&list).unwrap();
        let place = along_key.place();
        // A corner at height 0.4 falls away from the light by 0.4 times its slope.
        let far = 0.1 + 0.4 * 0.42 / 0.8;
        assert!(place.x + place.z > far && place.x - place.z < -0.1);
        list.ground.solid = false;
        assert_eq!(Caster::of(&list), None);
    }
}
