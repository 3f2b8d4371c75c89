//! How large what moves is, before any of it is taken.

use crate::scene::{Assets, Scene};
use crate::solver::world::World;

/// How large a body is for other programs.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct BodySize {
    /// Name a person reads.
    pub(crate) name: String,
    /// Vertices of its mesh: those of its file, or else of its skin, or particles.
    pub(crate) vertices: usize,
    /// Faces of that.
    pub(crate) faces: usize,
    /// Whether the mesh is that of a file.
    pub(crate) is_of_file: bool,
    /// Fibres.
    pub(crate) fibres: usize,
    /// Springs.
    pub(crate) springs: usize,
    /// Particles.
    pub(crate) particles: usize,
}

/// The sizes of the bodies of a world that was put together from a scene and its assets.
pub(crate) fn sizes(scene: &Scene, assets: &Assets, world: &World) -> Vec<BodySize> {
    let each = world.bodies().iter().map(|body| {
        let parts = body.parts();
        let model = scene.all_bodies().find(|of| of.id() == parts.id).and_then(|of| of.model());
        let file = model.and_then(|model| assets.solid(model)).and_then(|solid| solid.model.file.as_deref());
        let skin = parts.skin.as_ref().map(|skin| (skin.len(), skin.triangles().len()));
        let of_file = file.map(|mesh| (mesh.points.len(), mesh.counts.len()));
        let (vertices, faces) = of_file.or(skin).unwrap_or((parts.model.len(), 0));
        BodySize {
            name: parts.name.clone(),
            vertices,
            faces,
            is_of_file: file.is_some(),
            fibres: parts.fibres.len(),
            springs: parts.layers.as_ref().map_or(0, |layers| layers.springs.ends().len()),
            particles: body.state().len(),
        }
    });
    each.collect()
}
