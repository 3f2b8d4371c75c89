//! How large what moves is, before any of it is taken.

use super::panel::{PANEL_SIDES, PANEL_VERTICES, panel_name};
use crate::geometry::file_mesh::FileMesh;
use crate::scene::{AnyBody, Assets, Scene};
use crate::solver::world::World;

/// How large a body is for other programs.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct BodySize {
    /// Name a person reads.
    pub(crate) name: String,
    /// Vertices of its mesh: those of its file, or else of its skin, or particles.
    pub(crate) vertices: usize,
    /// Normals that turn with it.
    pub(crate) normals: usize,
    /// Faces of that.
    pub(crate) faces: usize,
    /// Whether the mesh is that of a file.
    pub(crate) is_of_file: bool,
    /// Fibres.
    pub(crate) fibres: usize,
    /// Sheets.
    pub(crate) sheets: usize,
    /// Springs.
    pub(crate) springs: usize,
    /// Particles.
    pub(crate) particles: usize,
}

/// The sizes of the bodies and panels of a world that was put together from a scene and its assets.
pub(crate) fn sizes(scene: &Scene, assets: &Assets, world: &World) -> Vec<BodySize> {
    let each = world.bodies().iter().map(|body| {
        let parts = body.parts();
        let model = scene.all_bodies().find(|of| of.id() == parts.id).and_then(AnyBody::model);
        let file = model.and_then(|model| assets.solid(model)).and_then(|solid| solid.model.file.as_deref());
        let skin = parts.skin.as_ref().map(|skin| (skin.len(), skin.triangles().len()));
        let of_file = file.map(|mesh| (mesh.points.len(), mesh.counts.len()));
        let (vertices, faces) = of_file.or(skin).unwrap_or((parts.model.len(), 0));
        BodySize {
            name: parts.name.clone(),
            vertices,
            normals: file.map_or(0, normals),
            faces,
            is_of_file: file.is_some(),
            fibres: parts.fibres.len(),
            sheets: parts.sheets.len(),
            springs: parts.layers.as_ref().map_or(0, |layers| layers.springs.ends().len()),
            particles: body.state().len(),
        }
    });
    let panels = world.panels().iter().map(|panel| {
        let name = panel_name(scene, panel).to_owned();
        BodySize { name, vertices: PANEL_VERTICES, faces: PANEL_SIDES.len(), ..BodySize::default() }
    });
    each.chain(panels).collect()
}

/// Pairs of a vertex and a normal that the corners of a mesh have.
fn normals(mesh: &FileMesh) -> usize {
    let Some(given) = &mesh.normals else { return 0 };
    let mut pairs: Vec<(u32, u32)> = mesh.corners.iter().copied().zip(given.corners.iter().copied()).collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs.len()
}
