//! Elements as thin lines between their points.

use super::body_drawer::{BodyDrawer, THROUGH};
use super::list::{DrawList, Line};
use crate::solver::snapshot::ElementSnapshot;

/// Width of the lines [pixels].
const WIDTH: f32 = 1.6;

impl BodyDrawer<'_> {
    pub(super) fn element(&self, element: &ElementSnapshot, [has_skin, clear]: [bool; 2], list: &mut DrawList) {
        // As fibres: inside an opaque skin that nothing cuts open there is nothing to see of them.
        let is_seen = self.display.fibres && (!has_skin || clear || self.display.slice.is_some());
        if !is_seen || element.points.iter().any(|at| !at.is_finite()) {
            return;
        }
        for ends in element.lines.iter() {
            let points = ends.map(|k| list.local(element.points[k as usize])).to_vec();
            list.lines.push(Line { points, width: WIDTH, colour: self.theme.structure, through: THROUGH, pick: 0 });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::list::Ground;
    use crate::draw::{Display, Theme};
    use glam::{DVec3, Vec3};

    #[test]
    fn an_element_is_a_thin_line_between_its_points_where_the_skin_is_clear() {
        let theme = Theme::light();
        let display = Display::default();
        let drawer = BodyDrawer { index: 0, spacing: 0.1, display: &display, theme: &theme };
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
        let element = ElementSnapshot { id: "rope".to_owned(), points, lines: [[0, 1], [1, 2]].into() };
        let drawn = |around: [bool; 2], element: &ElementSnapshot| {
            let ground = Ground { height: 0.0, solid: true, grid: true, axes: true };
            let mut list = DrawList::new(DVec3::ZERO, ground, theme);
            drawer.element(element, around, &mut list);
            list.lines
        };
        let lines = drawn([true, true], &element);
        assert_eq!(
            lines.iter().map(|line| line.points.clone()).collect::<Vec<_>>(),
            [[Vec3::ZERO, Vec3::X], [Vec3::X, Vec3::Y]]
        );
        assert!(drawn([true, false], &element).is_empty());
        let broken = ElementSnapshot { points: vec![DVec3::NAN; 3], ..element };
        assert!(drawn([true, true], &broken).is_empty());
    }
}
