//! From a world to its frames.

use super::carrier::Carrier;
use super::fibre_directions::fibre_directions;
use super::frame::{BodyFrame, FibreFrame, Frame, ParticleFrame, Wanted};
use super::normals::Normals;
use super::panel::{panel_frame, panel_name, panel_subject};
use super::space::Space;
use super::subject::{BodySubject, FibreSubject, Subject};
use crate::geometry::file_mesh::FileMesh;
use crate::scene::{AnyBody, Assets, Scene};
use crate::solver::body::{Body, FibreLine};
use crate::solver::field::FieldKind;
use crate::solver::world::World;
use glam::DVec3;
use std::f64::consts::PI;

/// Takes the frames of a world.
pub(crate) struct Motion {
    subject: Subject,
    carriers: Vec<Carrier>,
    /// Of every body; none of one that has no normals, or where none are wanted.
    normals: Vec<Option<Normals>>,
    wanted: Wanted,
    /// From one frame that is taken to the next.
    step: u64,
}

impl Motion {
    /// Of a world that was put together from a scene and its assets.
    pub(crate) fn new(scene: &Scene, assets: &Assets, world: &World, space: Space, wanted: Wanted) -> Self {
        let all: Vec<AnyBody<'_>> = scene.all_bodies().collect();
        let bodies = world.bodies().iter().map(|body| {
            let of = all.iter().copied().find(|of| of.id() == body.parts().id);
            body_subject(of, assets, body, space)
        });
        let (mut bodies, carriers): (Vec<BodySubject>, Vec<Carrier>) = bodies.unzip();
        let normals = bodies.iter_mut().map(|body| Normals::of(&mut body.mesh)).collect();
        bodies.extend(world.panels().iter().map(|panel| panel_subject(panel, panel_name(scene, panel), space)));
        let subject = Subject { name: scene.name.clone(), frame_seconds: world.plan().frame_seconds, space, bodies };
        Self { subject, carriers, normals, wanted, step: 1 }
    }

    /// Of which only every so many frames are taken: each lasts as many times as long, and they are counted without the
    /// rest.
    pub(crate) fn every(mut self, step: u64) -> Self {
        self.subject.frame_seconds *= step as f64;
        self.step = step;
        self
    }

    /// What moves.
    pub(crate) fn subject(&self) -> &Subject {
        &self.subject
    }

    /// The world as it stands.
    pub(crate) fn frame(&self, world: &World) -> Frame {
        let bodies = world.bodies().iter().enumerate().map(|(index, body)| self.body(index, body));
        let Self { wanted, subject, .. } = self;
        let panels = world.panels().iter().map(|panel| panel_frame(panel, subject.space, wanted.velocities));
        Frame { number: world.number() / self.step, time: world.time(), bodies: bodies.chain(panels).collect() }
    }

    fn body(&self, index: usize, body: &Body) -> BodyFrame {
        let (carrier, mesh) = (&self.carriers[index], &self.subject.bodies[index].mesh);
        let (Wanted { velocities, normals, particles, tensions }, space) = (self.wanted, self.subject.space);
        let (state, parts) = (body.state(), body.parts());
        let positions = &state.positions;
        let carrying = carrying(body);
        let moving = || carrier.velocities(positions, &state.velocities, carrying);
        let tensions = if tensions { body.tensions() } else { Vec::new() };
        let fibre = |(index, line): (usize, &FibreLine)| FibreFrame {
            vertices: space.places(line.vertices.iter().map(|vertex| vertex.gather(positions)).collect()),
            tensions: tensions.get(index).map_or_else(Vec::new, |edges| at_vertices(edges)),
        };
        let ends = parts.layers.iter().flat_map(|layers| layers.springs.ends().iter().flatten());
        let vertices = space.places(carrier.places(positions, carrying));
        let turning = self.normals[index].as_ref().filter(|_| normals);
        BodyFrame {
            normals: turning.map_or_else(Vec::new, |normals| normals.over(mesh, &vertices)),
            vertices,
            velocities: if velocities { space.places(moving()) } else { Vec::new() },
            fibres: parts.fibres.iter().enumerate().map(fibre).collect(),
            springs: space.places(ends.map(|&end| positions[end as usize]).collect()),
            particles: if particles { particle_frame(body, space) } else { ParticleFrame::default() },
        }
    }
}

/// How many particles, the first ones, carry its surface.
fn carrying(body: &Body) -> usize {
    body.parts().layers.as_ref().map_or(body.state().len(), |layers| layers.outer)
}

/// A body, and what carries its vertices.
fn body_subject(of: Option<AnyBody<'_>>, assets: &Assets, body: &Body, space: Space) -> (BodySubject, Carrier) {
    let parts = body.parts();
    let (mut mesh, carrier) = match (of.and_then(|of| mesh_of_file(of, assets)), &parts.skin) {
        (Some(mesh), _) => Carrier::of_mesh(mesh, body),
        (None, Some(skin)) => {
            let mesh = FileMesh::of_triangles("", skin.positions(&parts.model), skin.triangles());
            (mesh, Carrier::Skin(skin.clone()))
        }
        (None, None) => (FileMesh::of_triangles("", parts.model.to_vec(), &[]), Carrier::Particles),
    };
    if let Some(of) = of {
        let placement = of.placement();
        let (turn, shift) = (placement.rotation.quaternion(), DVec3::from_array(placement.translation));
        mesh.move_points(|point| space.place(turn * point + shift));
        mesh.turn_normals(|normal| space.direction(turn * normal));
    }
    let width = width(of, body);
    let fibre = |line: &FibreLine| FibreSubject {
        id: line.id.clone(),
        vertices: line.vertices.len(),
        width: space.scale * width(&line.id),
    };
    let subject = BodySubject {
        name: parts.name.clone(),
        mesh,
        fibres: parts.fibres.iter().map(fibre).collect(),
        springs: parts.layers.as_ref().map_or_else(Vec::new, |layers| layers.springs.ends().to_vec()),
    };
    (subject, carrier)
}

/// The mesh of the file that a body is from, in its model frame.
fn mesh_of_file(of: AnyBody<'_>, assets: &Assets) -> Option<FileMesh> {
    assets.solid(of.model()?)?.model.file.as_deref().cloned()
}

/// The width of a fibre [m], by its identifier: that of a round rod which fills its share of a particle's section, the
/// greatest one where a drive changes that.
fn width<'a>(of: Option<AnyBody<'a>>, body: &Body) -> impl Fn(&str) -> f64 + use<'a> {
    let reach = body.parts().reach;
    move |id| {
        let Some(AnyBody::Solid(solid)) = of else { return 0.0 };
        let share = solid
            .fibres
            .iter()
            .find(|fibre| fibre.id == id)
            .map_or(0.0, |fibre| fibre.greatest_fraction(&solid.drives));
        2.0 * reach * solid.material.spacing_ratio * (share / PI).sqrt()
    }
}

/// Means over the edges beside every vertex.
fn at_vertices(edges: &[f64]) -> Vec<f64> {
    (0..=edges.len())
        .map(|vertex| {
            let beside = &edges[vertex.saturating_sub(1)..(vertex + 1).min(edges.len())];
            beside.iter().sum::<f64>() / beside.len().max(1) as f64
        })
        .collect()
}

fn particle_frame(body: &Body, space: Space) -> ParticleFrame {
    let (state, fibres) = (body.state(), &body.parts().fibres);
    let directions = if fibres.is_empty() { Vec::new() } else { fibre_directions(fibres, &state.positions) };
    ParticleFrame {
        positions: space.places(state.positions.clone()),
        velocities: space.places(state.velocities.clone()),
        fractions: body.field(FieldKind::VolumeFraction),
        strains: body.field(FieldKind::Strain),
        stresses: body.field(FieldKind::Stress),
        directions: directions.into_iter().map(|v| space.direction(v)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_carries_the_mean_of_the_edges_beside_it() {
        assert_eq!(at_vertices(&[1.0, 3.0]), [1.0, 2.0, 3.0]);
        assert_eq!(at_vertices(&[]), [0.0]);
    }
}
