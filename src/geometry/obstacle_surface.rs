//! What an obstacle looks like, in its own frame.

use super::lattice::Cuboid;
use super::mesh::{TriangleMesh, box_surface};
use super::obstacle::Obstacle;
use super::obstacle_mesh::ObstacleMesh;
use super::octahedron::sphere;
use glam::DVec3;

/// Corners of triangles, three in a row, each with its unit normal.
pub(crate) type Corners = Vec<[DVec3; 2]>;

/// How far a plane is shown to either side [m].
const SHOWN: f64 = 2.0;
/// Times that the faces of a ball are divided.
const ROUNDNESS: u32 = 4;
/// Faces that turn by less than the angle of this cosine are of one smooth surface.
const SMOOTH: f64 = 0.75;

/// The surface of an obstacle.
pub(crate) fn surface(obstacle: &Obstacle) -> Corners {
    match obstacle {
        Obstacle::Ball(radius) => round(*radius, 0.0),
        Obstacle::Capsule { radius, half } => round(*radius, *half),
        Obstacle::Cuboid(half) => {
            let size = 2.0 * *half;
            flat(&box_surface(&Cuboid { center: DVec3::ZERO, size }, size.max_element()))
        }
        Obstacle::HalfSpace => {
            let corner = |x: f64, z: f64| [SHOWN * DVec3::new(x, 0.0, z), DVec3::Y];
            let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
            vec![a, b, c, a, c, d]
        }
        Obstacle::Mesh(mesh) => smooth(mesh),
    }
}

/// A ball, its halves moved apart along Y by `half` [m] each.
fn round(radius: f64, half: f64) -> Corners {
    let ball = sphere(ROUNDNESS);
    let place = |face: &[u32; 3]| {
        let middle: f64 = face.iter().map(|&i| ball.positions[i as usize].y).sum();
        face.map(|i| {
            let normal = ball.positions[i as usize].normalize_or(DVec3::Y);
            // What lies in the middle belongs to the half of its face: the cylinder is put in between.
            let side = if normal.y.abs() > 1e-9 { normal.y } else { middle };
            [radius * normal + DVec3::Y * half.copysign(side), normal]
        })
    };
    let mut corners: Corners = ball.triangles.iter().flat_map(place).collect();
    if half > 0.0 {
        let mut ring: Vec<DVec3> =
            ball.positions.iter().map(|x| x.normalize_or(DVec3::Y)).filter(|x| x.y.abs() <= 1e-9).collect();
        ring.sort_by(|a, b| a.z.atan2(a.x).total_cmp(&b.z.atan2(b.x)));
        for (k, &a) in ring.iter().enumerate() {
            let b = ring[(k + 1) % ring.len()];
            let at = |n: DVec3, side: f64| [radius * n + DVec3::Y * (side * half), n];
            corners.extend([at(a, -1.0), at(a, 1.0), at(b, 1.0), at(a, -1.0), at(b, 1.0), at(b, -1.0)]);
        }
    }
    corners
}

fn flat(mesh: &TriangleMesh) -> Corners {
    let corners = mesh.triangles.iter().flat_map(|face| {
        let [a, b, c] = face.map(|i| mesh.positions[i as usize]);
        let normal = (b - a).cross(c - a).normalize_or(DVec3::Y);
        [a, b, c].map(|corner| [corner, normal])
    });
    corners.collect()
}

/// A mesh with edges where it has them.
fn smooth(mesh: &ObstacleMesh) -> Corners {
    let (points, faces) = (mesh.points(), mesh.faces());
    let area = |face: &[u32; 3]| {
        let [a, b, c] = face.map(|i| points[i as usize]);
        (b - a).cross(c - a)
    };
    let mut around = vec![Vec::new(); points.len()];
    for face in faces {
        for &i in face {
            around[i as usize].push(area(face));
        }
    }
    let corners = faces.iter().flat_map(|face| {
        let own = area(face).normalize_or(DVec3::Y);
        face.map(|i| {
            let near = around[i as usize].iter().filter(|area| area.normalize_or_zero().dot(own) > SMOOTH);
            [points[i as usize], near.sum::<DVec3>().normalize_or(own)]
        })
    });
    corners.collect()
}
