//! Panels as boxes that move up and down.

use super::frame::BodyFrame;
use super::space::Space;
use super::subject::BodySubject;
use crate::geometry::file_mesh::FileMesh;
use crate::scene;
use crate::solver::panel::Panel;
use glam::DVec3;

/// The corners of every side of a box, seen from outside.
pub(super) const PANEL_SIDES: [[u32; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// How many they are.
pub(super) const PANEL_VERTICES: usize = 8;

/// What a panel is called: by its name, or else by its identifier.
pub(super) fn panel_name<'a>(scene: &'a scene::Scene, panel: &'a Panel) -> &'a str {
    let named = scene.panels.iter().find(|of| of.id == panel.id).map(|of| of.name.as_str());
    named.filter(|name| !name.is_empty()).unwrap_or(&panel.id)
}

/// A panel as it stands, called so.
pub(super) fn panel_subject(panel: &Panel, name: &str, space: Space) -> BodySubject {
    let mut mesh = FileMesh { points: places(panel, space), ..FileMesh::default() };
    for side in &PANEL_SIDES {
        mesh.add_face(side);
    }
    BodySubject { name: name.to_owned(), mesh, ..BodySubject::default() }
}

/// A panel at one time.
pub(super) fn panel_frame(panel: &Panel, space: Space, with_velocities: bool) -> BodyFrame {
    let vertices = places(panel, space);
    let velocity = space.place(panel.velocity * DVec3::Y);
    let velocities = if with_velocities { vec![velocity; vertices.len()] } else { Vec::new() };
    BodyFrame { vertices, velocities, ..BodyFrame::default() }
}

/// The corners: of two that differ along one axis the lower first, X the fastest.
fn places(panel: &Panel, space: Space) -> Vec<DVec3> {
    let half = panel.half_size;
    let extent = DVec3::new(2.0 * half.x, scene::Panel::THICKNESS * 2.0 * half.min_element(), 2.0 * half.y);
    let low = DVec3::new(panel.center.x - half.x, panel.height, panel.center.y - half.y);
    let corner = |k: u32| low + extent * DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2));
    (0..PANEL_VERTICES as u32).map(|k| space.place(corner(k))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::file_mesh::face_normals;

    #[test]
    fn all_sides_look_outwards() {
        let corner = |k: u32| DVec3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2));
        let mut mesh = FileMesh { points: (0..8).map(corner).collect(), ..FileMesh::default() };
        for side in &PANEL_SIDES {
            mesh.add_face(side);
        }
        for (side, normal) in PANEL_SIDES.iter().zip(face_normals(&mesh, &mesh.points)) {
            let middle = side.iter().map(|&k| corner(k)).sum::<DVec3>() / 4.0;
            assert!((normal / 2.0 - 2.0 * (middle - DVec3::splat(0.5))).length() < 1e-12, "{side:?} {normal}");
        }
    }
}
