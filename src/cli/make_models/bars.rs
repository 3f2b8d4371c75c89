//! Bars with round edges.

use crate::geometry::lattice::Cuboid;
use crate::geometry::mesh::box_surface;
use crate::geometry::model::{MeshData, Model};
use glam::DVec3;

/// Radius of the edges over the least extent. All particles of the paper's bars lie inside up to 0.16.
const ROUNDING: f64 = 0.13;

/// A bar standing on the origin, of these extents [m] but for what keeps its volume that of the box, its surface cut
/// into `cells` along each axis.
pub(super) fn bar(size: DVec3, cells: [f64; 3]) -> Model {
    // A grid on the surface of a box of whole cells, each then stretched to the bar.
    let grid = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::from_array(cells) }, 1.0);
    let radius = ROUNDING * size.min_element();
    let inner = 0.5 * size - radius;
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    for place in &grid.positions {
        let on_box = *place / DVec3::from_array(cells) * size;
        let core = on_box.clamp(-inner, inner);
        let normal = (on_box - core).normalize_or(DVec3::Y);
        positions.push(core + radius * normal);
        normals.push(normal.as_vec3());
    }
    let mut mesh = crate::geometry::mesh::TriangleMesh { positions, triangles: grid.triangles };
    let scale = (size.element_product() / mesh.volume()).cbrt();
    for position in &mut mesh.positions {
        *position = scale * (*position + DVec3::new(0.0, 0.5 * size.y, 0.0));
    }
    let mut model = Model::default();
    model.add(MeshData { positions: mesh.positions, normals, triangles: mesh.triangles, ..MeshData::default() });
    model
}
