//! What a body is made of: material particles as balls, springs as lines.

use super::body_drawer::{BodyDrawer, THROUGH};
use super::list::{DrawList, Line, PickKind, Points, Size};
use super::options::SkinStyle;
use super::{Colour, colour_map};
use crate::solver::snapshot::{BodySnapshot, LayersSnapshot, SpringKind};
use glam::{DVec3, Vec3};

/// Radius of material particles in particle spacings D: with room to look in between.
const MATERIAL_RADIUS: f64 = 0.20;

/// Springs [pixels].
const SPRING_WIDTH: f32 = 1.5;

impl BodyDrawer<'_> {
    /// What is to be seen of it, and of a field over its range.
    pub(super) fn particles(
        &self,
        body: &BodySnapshot,
        has_skin: bool,
        field: Option<([f64; 2], &[f64])>,
        list: &mut DrawList,
    ) {
        // A body without a skin shows what it is made of instead.
        let bare = !has_skin && self.display.skin != SkinStyle::Hidden;
        if let (true, Some(layers)) = (self.display.springs || bare, &body.layers) {
            self.springs(layers, &body.particles, list);
        }
        if self.display.particles || bare || (self.display.springs && body.layers.is_some()) {
            let pick = self.number(PickKind::Particle, body.particles.len(), list);
            let outer = body.layers.as_ref().map_or(body.particles.len(), |layers| layers.outer);
            let (outer, inner) = body.particles.split_at(outer.min(body.particles.len()));
            let cool = self.tint().unwrap_or(self.theme.material);
            let tints = field.map_or_else(Vec::new, |(range, values)| colour_map::of(values, range));
            self.left_of(outer, MATERIAL_RADIUS, cool, tints, pick, list);
            self.left_of(inner, MATERIAL_RADIUS, self.theme.structure, Vec::new(), pick + outer.len() as u32, list);
        }
    }

    /// Material particles, but for those that are cut away.
    fn left_of(&self, at: &[DVec3], radius: f64, colour: Colour, tints: Vec<[u8; 3]>, pick: u32, list: &mut DrawList) {
        let hidden = |point: &DVec3| self.display.slice.is_some_and(|slice| slice.hides(*point));
        let left: Vec<DVec3> = at.iter().map(|point| if hidden(point) { DVec3::NAN } else { *point }).collect();
        self.balls(&left, radius, colour, pick, list);
        if let Some(balls) = list.points.last_mut().filter(|_| !at.is_empty()) {
            balls.tints = tints;
        }
    }

    fn springs(&self, layers: &LayersSnapshot, at: &[DVec3], list: &mut DrawList) {
        let theme = self.theme;
        for (kind, range) in &layers.kinds {
            let colour = match kind {
                SpringKind::Structural => self.tint().unwrap_or(theme.text.with_alpha(0.8)),
                SpringKind::Radius => theme.axes[1],
                SpringKind::ShearLeft => theme.axes[0],
                SpringKind::ShearRight => theme.axes[2],
            };
            let hidden = |&i: &u32| {
                let point = at.get(i as usize);
                point.zip(self.display.slice).is_some_and(|(point, slice)| slice.hides(*point))
            };
            for ends in layers.springs[range.clone()].iter().filter(|ends| !ends.iter().any(hidden)) {
                let points: Vec<Vec3> = ends.iter().filter_map(|&i| Some(list.local(*at.get(i as usize)?))).collect();
                list.lines.push(Line { points, width: SPRING_WIDTH, colour, through: THROUGH, pick: 0 });
            }
        }
    }

    pub(super) fn balls(&self, at: &[DVec3], radius: f64, colour: Colour, pick: u32, list: &mut DrawList) {
        if at.is_empty() {
            return;
        }
        let centres = at.iter().map(|&point| list.local(point)).collect();
        let size = Size::Metres((radius * self.spacing) as f32);
        list.points.push(Points { centres, size, colour, tints: Vec::new(), through: 0.0, pick });
    }
}
