//! A scene and a snapshot of its world become a draw list.

use super::list::{DrawList, Line, Mesh, PickId, PickKind, Points, Size, Surface, Vertex};
use super::normals::smooth_normals;
use super::options::{Display, SkinStyle};
use super::surroundings;
use super::tube::tube;
use super::{Bounds, Theme};
use crate::scene::Scene;
use crate::solver::snapshot::{BodySnapshot, Snapshot};
use glam::{DVec3, Vec3};

/// Radii in particle spacings D: fibres thin enough to stay apart when drawn a spacing from each other, structure
/// particles as beads on them, material particles with room to look in between.
const FIBRE_RADIUS: f64 = 0.22;
const SELECTED_RADIUS: f64 = 0.32;
const STRUCTURE_RADIUS: f64 = 0.30;
const MATERIAL_RADIUS: f64 = 0.20;

/// Share of a fibre's mark that shows through the skin.
const THROUGH: f32 = 0.35;

/// What is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The document.
    pub scene: &'a Scene,
    /// A state of its world; its bodies are those of the scene, in order.
    pub snapshot: &'a Snapshot,
    /// Another state, shown as a pale shape: where everything began, or would be.
    pub ghost: Option<&'a Snapshot>,
}

/// Everything that is to be seen.
pub fn draw(subject: &Subject<'_>, display: &Display, theme: &Theme) -> DrawList {
    let Subject { scene, snapshot, ghost } = *subject;
    let bounds = surroundings::bounds(scene, snapshot);
    let origin = bounds.map_or(DVec3::ZERO, |bounds| bounds.center());
    let mut list = DrawList::new(origin, surroundings::ground(scene, bounds, display), *theme);
    list.bounds = bounds;
    // Fibres are numbered through all bodies, so that no two in sight share a hue.
    let mut hue = 0;
    for (index, body) in snapshot.bodies.iter().enumerate() {
        let pen = Pen { index: index as u32, spacing: spacing(scene, index, body), display, theme };
        pen.body(body, &mut list, &mut hue);
        if let (true, Some(body)) = (display.strokes, scene.bodies.get(index)) {
            surroundings::strokes(body, &mut list);
        }
    }
    for body in ghost.iter().flat_map(|ghost| &ghost.bodies) {
        let mesh = skin_mesh(&list, body, Surface::Faint);
        list.meshes.extend(mesh.map(|mesh| Mesh { colour: theme.ghost, casts_shadow: false, ..mesh }));
    }
    surroundings::panels(scene, snapshot, &mut list);
    if display.room {
        surroundings::walls(scene, &mut list);
    }
    list
}

/// Particle spacing D [m]; for a body that the document does not have (any more), what its particles fill.
fn spacing(scene: &Scene, index: usize, body: &BodySnapshot) -> f64 {
    scene.bodies.get(index).map(|body| body.material.spacing()).unwrap_or_else(|| {
        let radius = Bounds::of(body.particles.iter().copied()).map_or(1.0, |bounds| bounds.radius());
        radius / (body.particles.len().max(1) as f64).cbrt()
    })
}

/// The skin of a body as a mesh that nothing picks; none where it has none or is no longer made of numbers.
///
/// This is the seam for moving vertices on the graphics processor: embedding weights and particles would go into the
/// list in place of vertices, and everything below it would stay as it is.
fn skin_mesh(list: &DrawList, body: &BodySnapshot, surface: Surface) -> Option<Mesh> {
    if body.triangles.is_empty() || body.skin.iter().any(|point| !point.is_finite()) {
        return None;
    }
    let positions: Vec<Vec3> = body.skin.iter().map(|&point| list.local(point)).collect();
    let normals = smooth_normals(&positions, &body.triangles);
    Some(Mesh {
        vertices: positions.into_iter().zip(normals).map(|(position, normal)| Vertex { position, normal }).collect(),
        indices: body.triangles.iter().flatten().copied().collect(),
        colour: list.theme.skin,
        surface,
        casts_shadow: true,
        pick: 0,
    })
}

/// Draws one body.
struct Pen<'a> {
    index: u32,
    spacing: f64,
    display: &'a Display,
    theme: &'a Theme,
}

impl Pen<'_> {
    fn body(&self, body: &BodySnapshot, list: &mut DrawList, hue: &mut usize) {
        for (index, fibre) in body.fibres.iter().enumerate() {
            self.fibre(index as u32, &fibre.vertices, *hue, list);
            *hue += 1;
        }
        let mut has_skin = false;
        let surface = if self.display.skin == SkinStyle::XRay { Surface::XRay } else { Surface::Solid };
        if let (true, Some(mut mesh)) = (self.display.skin != SkinStyle::Hidden, skin_mesh(list, body, surface)) {
            mesh.pick = self.number(PickKind::Skin, 1, list);
            list.meshes.push(mesh);
            has_skin = true;
        }
        // A body without a skin shows what it is made of instead.
        if self.display.particles || (!has_skin && self.display.skin != SkinStyle::Hidden) {
            let pick = self.number(PickKind::Particle, body.particles.len(), list);
            self.balls(&body.particles, MATERIAL_RADIUS, self.theme.material, pick, list);
        }
    }

    fn fibre(&self, index: u32, vertices: &[DVec3], hue: usize, list: &mut DrawList) {
        let points: Vec<Vec3> = vertices.iter().filter(|v| v.is_finite()).map(|&v| list.local(v)).collect();
        let selected = self.display.selected.contains(&[self.index, index]);
        if self.display.fibres {
            let radius = self.spacing * if selected { SELECTED_RADIUS } else { FIBRE_RADIUS };
            let (vertices, indices) = tube(&points, radius as f32);
            if !indices.is_empty() {
                let pick = list.register(PickId { body: self.index, kind: PickKind::Fibre, index }, 1);
                let colour = self.theme.fibre(hue);
                let casts_shadow = self.display.skin != SkinStyle::Shaded;
                list.meshes.push(Mesh { vertices, indices, colour, surface: Surface::Solid, casts_shadow, pick });
            }
        }
        if selected {
            let line = Line { points, width: 1.5, colour: self.theme.accent, through: THROUGH, pick: 0 };
            list.lines.push(line);
        }
        if self.display.structure {
            let pick = self.number(PickKind::StructureVertex { fibre: index }, vertices.len(), list);
            self.balls(vertices, STRUCTURE_RADIUS, self.theme.structure, pick, list);
        }
    }

    fn balls(&self, at: &[DVec3], radius: f64, colour: super::Colour, pick: u32, list: &mut DrawList) {
        let centres = at.iter().map(|&point| list.local(point)).collect();
        let size = Size::Metres((radius * self.spacing) as f32);
        list.points.push(Points { centres, size, colour, through: 0.0, pick });
    }

    fn number(&self, kind: PickKind, count: usize, list: &mut DrawList) -> u32 {
        list.register(PickId { body: self.index, kind, index: 0 }, count)
    }
}
