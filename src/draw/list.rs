//! What is to be seen, as plain data.

use super::{Bounds, Colour, Slice, Theme};
use crate::geometry::rig::Rig;
use glam::{DVec3, Vec3};
use std::borrow::Cow;
use std::sync::Arc;

/// Everything that is to be seen of a world at one time, but for the point of view.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawList {
    /// World position [m] of the list's own origin, about which the positions of all items are given.
    pub origin: DVec3,
    /// What is worth framing, in the world; none for an empty scene.
    pub bounds: Option<Bounds>,
    /// Triangle meshes.
    pub meshes: Vec<Mesh>,
    /// Polylines.
    pub lines: Vec<Line>,
    /// Sets of points.
    pub points: Vec<Points>,
    /// Words.
    pub labels: Vec<Label>,
    /// What lies below everything.
    pub ground: Ground,
    /// Where surfaces skinned to particles are cut open; everything else is as it is given.
    pub slice: Option<Slice>,
    /// Colours and lights.
    pub theme: Theme,
    /// What pick numbers stand for.
    pub picks: Picks,
}

/// A vertex of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// Position [m] about the list's origin.
    pub position: Vec3,
    /// Unit normal.
    pub normal: Vec3,
}

/// A surface skinned to particles: whoever draws it moves its vertices.
#[derive(Clone, Debug)]
pub struct SkinnedFaces {
    /// How it is skinned to them.
    pub(crate) rig: Arc<Rig>,
    /// Where they are [m], about the list's origin; behind them the rig's directions.
    pub particles: Vec<Vec3>,
}

impl PartialEq for SkinnedFaces {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.rig, &other.rig) && self.particles == other.particles
    }
}

impl SkinnedFaces {
    /// Where its vertices are [m], about the list's origin.
    pub(super) fn positions(&self) -> Vec<Vec3> {
        self.rig.vertices.apply(&self.rig.points.apply(&self.particles))
    }
}

/// What a mesh is made of; faces turn counter-clockwise seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub enum Faces {
    /// Vertices, and three indices a triangle.
    Free(Vec<Vertex>, Vec<u32>),
    /// The skin of a body.
    Skinned(SkinnedFaces),
}

impl Faces {
    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        match self {
            Self::Free(vertices, _) => vertices.len(),
            Self::Skinned(skinned) => skinned.rig.vertices.len(),
        }
    }

    /// Vertices and indices, worked out here where they are skinned to particles.
    pub fn worked_out(&self) -> (Cow<'_, [Vertex]>, Cow<'_, [u32]>) {
        match self {
            Self::Free(vertices, indices) => (Cow::Borrowed(vertices), Cow::Borrowed(indices)),
            Self::Skinned(skinned) => {
                let rig = &skinned.rig;
                let positions = skinned.positions();
                let normals = rig.normals(&positions);
                let vertex = |(position, normal)| Vertex { position, normal };
                (
                    Cow::Owned(positions.into_iter().zip(normals).map(vertex).collect()),
                    Cow::Owned(rig.triangles.iter().flatten().copied().collect()),
                )
            }
        }
    }
}

/// A triangle mesh in one colour, or in one a vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// What it is made of.
    pub faces: Faces,
    /// Colour.
    pub colour: Colour,
    /// Colours of the vertices in place of that, sRGB, 0 to 255; none at all for a mesh in one colour.
    pub tints: Vec<[u8; 3]>,
    /// What light does to it.
    pub surface: SurfaceStyle,
    /// Whether it darkens the floor.
    pub casts_shadow: bool,
    /// What a pick of it gives, as [`DrawList::register`] numbered it; zero for what cannot be picked.
    pub pick: u32,
}

/// What light does to a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceStyle {
    /// Lit and opaque.
    Solid,
    /// See-through in its middle and denser towards its outline; what lies inside shows and is picked first.
    XRay,
    /// Lit from whichever side it is seen, at the colour's opacity and denser where it is seen aslant; what lies behind
    /// shines through.
    Film,
    /// One even tone at the colour's opacity, seen from both sides: walls, ghosts.
    Faint,
}

/// A polyline with a width in pixels, whatever the distance.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Points [m] about the list's origin.
    pub points: Vec<Vec3>,
    /// Width [pixels of a display at scale 1].
    pub width: f32,
    /// Colour.
    pub colour: Colour,
    /// Share of its opacity with which it shows through what is in front: 0 hidden, 1 on top of everything.
    pub through: f32,
    /// As [`Mesh::pick`].
    pub pick: u32,
}

/// Extent of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// Radius [m]: a ball in the scene.
    Metres(f32),
    /// Radius [pixels of a display at scale 1], whatever the distance.
    Pixels(f32),
}

/// Balls of one size, in one colour or each in its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Centres [m] about the list's origin.
    pub centres: Vec<Vec3>,
    /// Radius.
    pub size: Size,
    /// Colour.
    pub colour: Colour,
    /// Colours of the balls in place of that, as [`Mesh::tints`].
    pub tints: Vec<[u8; 3]>,
    /// As [`Line::through`].
    pub through: f32,
    /// Pick number of the first; the others follow. Zero for what cannot be picked.
    pub pick: u32,
}

/// A few words beside a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Where [m], about the list's origin.
    pub at: Vec3,
    /// What they say.
    pub text: String,
    /// Colour.
    pub colour: Colour,
}

/// What lies below everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Height [m], world Y, of the plane that carries the grid.
    pub height: f64,
    /// Whether it is a floor, which hides what is below and takes shadows, or a mere grid in the air.
    pub solid: bool,
    /// Whether the grid is drawn, with its scale.
    pub grid: bool,
    /// Whether the directions of the axes stand in a corner.
    pub axes: bool,
}

/// Something that can be pointed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PickId {
    /// Body in the order of the scene; 0 for a panel or a collider.
    pub body: u32,
    /// What it is.
    pub kind: PickKind,
    /// Which one: of the body's fibres, sheets or particles, of the fibre's vertices, of the scene's panels or
    /// colliders; 0 for a skin.
    pub index: u32,
}

/// Kinds of things that can be pointed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PickKind {
    /// The skin of a body.
    Skin,
    /// A material particle.
    Particle,
    /// A fibre.
    Fibre,
    /// A structure particle of a fibre.
    StructureVertex {
        /// The fibre, in the order of the body's snapshot.
        fibre: u32,
    },
    /// A sheet.
    Sheet,
    /// A panel.
    Panel,
    /// A collider.
    Collider,
}

/// What pick numbers stand for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picks(Vec<PickRange>);

#[derive(Clone, Copy, Debug, PartialEq)]
struct PickRange {
    start: u32,
    count: u32,
    first: PickId,
}

impl DrawList {
    /// An empty list about `origin` [m].
    pub fn new(origin: DVec3, ground: Ground, theme: Theme) -> Self {
        Self {
            origin,
            bounds: None,
            meshes: Vec::new(),
            lines: Vec::new(),
            points: Vec::new(),
            labels: Vec::new(),
            ground,
            slice: None,
            theme,
            picks: Picks::default(),
        }
    }

    /// A world position [m] as items give theirs.
    pub(crate) fn local(&self, point: DVec3) -> Vec3 {
        (point - self.origin).as_vec3()
    }

    /// Numbers `count` things that can be picked, `first` and those whose index follows; gives the first number.
    pub fn register(&mut self, first: PickId, count: usize) -> u32 {
        self.picks.register(first, count)
    }
}

impl Picks {
    pub(super) fn register(&mut self, first: PickId, count: usize) -> u32 {
        let start = self.0.last().map_or(1, |last| last.start + last.count);
        self.0.push(PickRange { start, count: count as u32, first });
        start
    }

    /// What a number from a picture of picks stands for.
    pub fn find(&self, number: u32) -> Option<PickId> {
        let behind = self.0.partition_point(|range| range.start <= number);
        let range = self.0.get(behind.checked_sub(1)?)?;
        let step = number - range.start;
        (step < range.count).then(|| PickId { index: range.first.index + step, ..range.first })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pick_numbers_stand_for_what_was_registered() {
        let ground = Ground { height: 0.0, solid: true, grid: true, axes: true };
        let mut list = DrawList::new(DVec3::ZERO, ground, Theme::light());
        let skin = PickId { body: 2, kind: PickKind::Skin, index: 0 };
        let particle = PickId { body: 2, kind: PickKind::Particle, index: 0 };
        let (a, b) = (list.register(skin, 1), list.register(particle, 10));
        assert_eq!(list.picks.find(0), None);
        assert_eq!(list.picks.find(a), Some(skin));
        assert_eq!(list.picks.find(b + 9), Some(PickId { index: 9, ..particle }));
        assert_eq!(list.picks.find(b + 10), None);
    }
}
