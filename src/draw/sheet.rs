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
