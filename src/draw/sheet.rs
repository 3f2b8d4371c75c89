//! Sheets as thin films with their rims, and threads along their grain.

use super::Colour;
use super::body_drawer::BodyDrawer;
use super::list::{DrawList, Faces, Line, Mesh, PickId, PickKind, SurfaceStyle, Vertex};
use crate::solver::snapshot::SheetSnapshot;
use glam::Vec3;

/// Opacity of a film, and of one that is selected.
const OPACITY: f32 = 0.42;
const SELECTED_OPACITY: f32 = 0.62;
/// Widths [pixels] of threads, rims and the rim of one that is selected.
const THREAD_WIDTH: f32 = 1.0;
const RIM_WIDTH: f32 = 1.6;
const SELECTED_WIDTH: f32 = 2.6;
/// How much darker than the film its threads are, and how opaque.
const THREAD_SHADE: f32 = 0.55;
const THREAD_OPACITY: f32 = 0.75;

impl BodyDrawer<'_> {
    pub(super) fn sheet(
        &self,
        index: u32,
        sheet: &SheetSnapshot,
        colour: Colour,
        [has_skin, clear]: [bool; 2],
        list: &mut DrawList,
    ) {
        // As fibres: inside an opaque skin that nothing cuts open there is nothing to see of them.
        let is_seen = self.display.fibres && (!has_skin || clear || self.display.slice.is_some());
        if !is_seen || sheet.vertices.iter().any(|at| !at.is_finite()) {
            return;
        }
        let is_selected = self.display.selected_sheets.contains(&[self.index, index]);
        let id = PickId { body: self.index, kind: PickKind::Sheet, index };
        let pick = list.register(id, 1);
        list.meshes.push(Mesh {
            faces: faces(sheet, list),
            colour: colour.with_alpha(if is_selected { SELECTED_OPACITY } else { OPACITY }),
            tints: Vec::new(),
            surface: SurfaceStyle::Film,
            casts_shadow: !has_skin,
            pick,
        });
        let Colour { red, green, blue, .. } = colour;
        let dark =
            Colour { red: THREAD_SHADE * red, green: THREAD_SHADE * green, blue: THREAD_SHADE * blue, alpha: 1.0 };
        for thread in sheet.threads.iter() {
            let points = thread.iter().map(|&of| list.local(sheet.point(of))).collect();
            let colour = dark.with_alpha(THREAD_OPACITY);
            list.lines.push(Line { points, width: THREAD_WIDTH, colour, through: 0.0, pick: 0 });
        }
        let (width, colour) =
            if is_selected { (SELECTED_WIDTH, self.theme.accent) } else { (RIM_WIDTH, dark.with_alpha(0.9)) };
        for rim in sheet.rim.iter() {
            let points = rim.iter().map(|&k| list.local(sheet.vertices[k as usize])).collect();
            list.lines.push(Line { points, width, colour, through: 0.0, pick });
        }
    }
}

/// The triangles, with normals that are means over those around a vertex, the larger the heavier.
fn faces(sheet: &SheetSnapshot, list: &DrawList) -> Faces {
    let positions: Vec<Vec3> = sheet.vertices.iter().map(|&at| list.local(at)).collect();
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for &[a, b, c] in sheet.triangles.iter() {
        let [x, y, z] = [a, b, c].map(|k| positions[k as usize]);
        let normal = (y - x).cross(z - x);
        for k in [a, b, c] {
            normals[k as usize] += normal;
        }
    }
    let vertex = |(position, normal): (Vec3, Vec3)| Vertex { position, normal: normal.normalize_or(Vec3::Y) };
    let vertices = positions.into_iter().zip(normals).map(vertex).collect();
    Faces::Free(vertices, sheet.triangles.iter().flatten().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::list::Ground;
    use crate::draw::{Display, Theme};
    use crate::solver::snapshot::SurfacePoint;
    use glam::DVec3;

    fn drawn(display: &Display, around: [bool; 2]) -> DrawList {
        let edge = |ends: [u32; 2]| SurfacePoint { ends, share: 0.5 };
        let sheet = SheetSnapshot {
            id: "s".to_owned(),
            vertices: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y],
            triangles: [[0, 1, 2], [1, 3, 2]].into(),
            threads: [vec![edge([0, 2]), edge([1, 2]), edge([1, 3])]].into(),
            rim: [vec![0, 1, 3, 2, 0]].into(),
        };
        let theme = Theme::light();
        let ground = Ground { height: 0.0, solid: true, grid: true, axes: true };
        let mut list = DrawList::new(DVec3::ZERO, ground, theme);
        let drawer = BodyDrawer { index: 2, spacing: 0.1, display, theme: &theme };
        drawer.sheet(1, &sheet, Colour::hex(0x80_a0c0), around, &mut list);
        list
    }

    #[test]
    fn a_sheet_is_a_film_with_threads_and_a_rim_that_can_be_picked() {
        let list = drawn(&Display::default(), [true, true]);
        let [film] = list.meshes.as_slice() else { panic!("{:?}", list.meshes) };
        assert_eq!((film.surface, film.casts_shadow), (SurfaceStyle::Film, false));
        let picked = PickId { body: 2, kind: PickKind::Sheet, index: 1 };
        assert_eq!(list.picks.find(film.pick), Some(picked));
        let Faces::Free(vertices, indices) = &film.faces else { panic!("no skin") };
        assert_eq!((vertices.len(), indices.len()), (4, 6));
        assert!(vertices.iter().all(|vertex| vertex.normal.distance(Vec3::Z) < 1e-6));
        let [thread, rim] = list.lines.as_slice() else { panic!("{:?}", list.lines) };
        assert_eq!(thread.points, [Vec3::new(0.0, 0.5, 0.0), Vec3::new(0.5, 0.5, 0.0), Vec3::new(1.0, 0.5, 0.0)]);
        assert_eq!((rim.points.len(), rim.pick), (5, film.pick));
    }

    #[test]
    fn an_opaque_skin_hides_it_and_a_chosen_one_stands_out() {
        assert!(drawn(&Display::default(), [true, false]).meshes.is_empty());
        assert_eq!(drawn(&Display::default(), [false, false]).meshes.len(), 1);
        let chosen = Display { selected_sheets: vec![[2, 1]], ..Display::default() };
        let (plain, chosen) = (drawn(&Display::default(), [true, true]), drawn(&chosen, [true, true]));
        assert!(chosen.meshes[0].colour.alpha > plain.meshes[0].colour.alpha);
        assert_eq!(chosen.lines[1].colour, Theme::light().accent);
    }
}
