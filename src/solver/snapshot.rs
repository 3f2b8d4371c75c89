//! What the solver shows of itself: plain positions at one time.

pub(crate) use super::body::SurfacePoint;
use super::body::{Body, ElementLines, SheetSurface};
use super::collider::{Collider, Pose};
pub(crate) use super::field::FieldKind;
pub use super::forces::fibre::breaking::{BreakPlace, FibreBreak};
pub(crate) use super::forces::springs::SpringKind;
use super::layers::Layers;
use super::skin::Skin;
use super::world::World;
use crate::geometry::obstacle::Obstacle;
use crate::geometry::rig::Rig;
use glam::{DVec3, Vec3};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// A world at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Simulated time [s].
    pub time: f64,
    /// Bodies in the order of the scene.
    pub bodies: Vec<BodySnapshot>,
    /// Heights of the panels' undersides [m] in the order of the scene.
    pub panels: Vec<f64>,
    /// The colliders, in the order of the scene.
    pub colliders: Vec<ColliderSnapshot>,
    /// A field over the bodies, where one was asked for.
    pub field: Option<FieldSnapshot>,
    /// What the fibres carry, where that was asked for.
    pub tension: Option<TensionSnapshot>,
    /// What the fibres do by themselves, where that was asked for.
    pub activation: Option<ActivationSnapshot>,
}

/// A collider at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct ColliderSnapshot {
    /// Identifier of the scene.
    pub id: String,
    /// Corners of its surface in its own frame [m], three to a face, each with its unit normal.
    pub surface: Arc<[[DVec3; 2]]>,
    /// Whether it goes on beyond what is shown of it.
    pub is_endless: bool,
    /// Where it is.
    pub pose: Pose,
}

impl ColliderSnapshot {
    fn of(collider: &Collider, time: f64) -> Self {
        Self {
            id: collider.id.clone(),
            surface: Arc::clone(&collider.surface),
            is_endless: matches!(*collider.obstacle, Obstacle::HalfSpace),
            pose: collider.pose(time),
        }
    }

    /// Corners of its surface in the world [m], three to a face, each with its unit normal.
    pub(crate) fn in_world(&self) -> impl Iterator<Item = [DVec3; 2]> {
        self.surface.iter().map(|[x, normal]| [self.pose.to_world(*x), self.pose.rotation * *normal])
    }
}

/// What the fibres of a world carry along themselves at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct TensionSnapshot {
    /// Force [N] that one end of a colour map stands for, pulled; the other end stands for as much, pressed.
    pub range: f64,
    /// Forces [N] of the edges of every fibre of every body, negative where they are pressed.
    pub bodies: Vec<Vec<Vec<f64>>>,
}

impl TensionSnapshot {
    /// Less than this [N] is rounding.
    const LEAST: f64 = 1e-6;

    /// That of a world as it stands, over its own range.
    pub fn of(world: &World) -> Self {
        let bodies: Vec<Vec<Vec<f64>>> = world.bodies().iter().map(Body::tensions).collect();
        let forces = bodies.iter().flatten().flatten().map(|force| force.abs());
        let range = forces.filter(|force| force.is_finite()).fold(Self::LEAST, f64::max);
        Self { range, bodies }
    }
}

/// What the fibres of a world do by themselves at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct ActivationSnapshot {
    /// Of the edges of every fibre of every body: the value of the drive, and the share by which that has the edge want
    /// to be shorter.
    pub bodies: Vec<Vec<Vec<[f64; 2]>>>,
}

impl ActivationSnapshot {
    /// That of a world as it stands.
    pub fn of(world: &World) -> Self {
        Self { bodies: world.bodies().iter().map(Body::activations).collect() }
    }
}

/// A field over the bodies at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldSnapshot {
    /// Which.
    pub kind: FieldKind,
    /// Values that the ends of a colour map stand for, in the field's own unit; the second is above the first.
    pub range: [f64; 2],
    /// Values at the particles of every body; none for a body without such a field.
    pub bodies: Vec<Vec<f64>>,
}

impl FieldSnapshot {
    /// A field of a world as it stands, over its own range, which begins at 0 so that a body that nothing is done to
    /// has the map's first colour.
    pub fn of(world: &World, kind: FieldKind) -> Self {
        let bodies: Vec<Vec<f64>> = world.bodies().iter().map(|body| body.field(kind)).collect();
        let top = bodies.iter().flatten().copied().filter(|value| value.is_finite()).fold(kind.least(), f64::max);
        Self { kind, range: [0.0, top], bodies }
    }
}

/// A body at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodySnapshot {
    /// Name a person reads.
    pub name: String,
    /// Material particles [m].
    pub particles: Vec<DVec3>,
    /// Structure particles of each fibre [m].
    pub fibres: Vec<FibreSnapshot>,
    /// Sheets.
    pub sheets: Vec<SheetSnapshot>,
    /// Elements.
    pub elements: Vec<ElementSnapshot>,
    /// Where fibres are broken: indices into `fibres` and their vertices.
    pub breaks: Vec<FibreBreak>,
    /// When the first pair of neighbours across its seams tore [s].
    pub first_tear: Option<f64>,
    /// Vertices of the skin [m]; empty where only the particles were taken, see [`BodySnapshot::surface`].
    pub skin: Vec<DVec3>,
    /// Unit normals of the skin's vertices; empty where only the particles were taken.
    pub normals: Vec<Vec3>,
    /// Vertex indices of the skin's faces.
    pub triangles: Arc<[[u32; 3]]>,
    /// Linear red, green, blue and opacity of the skin's vertices; empty where the model had none.
    pub colours: Arc<[[f32; 4]]>,
    /// How the skin hangs on the particles.
    pub embedding: SkinEmbedding,
    /// Layers and springs of a two-layer body; none for others.
    pub layers: Option<LayersSnapshot>,
}

/// How the skin of a body hangs on its particles.
#[derive(Clone, Debug, Default)]
pub struct SkinEmbedding(Option<Arc<Skin>>);

#[cfg(test)]
impl SkinEmbedding {
    /// A skin whose vertices are the first `count` particles.
    pub(crate) fn of_particles(count: u32, triangles: &[[u32; 3]]) -> Self {
        let (points, point_of) = (vec![DVec3::ZERO; count as usize], (0..count).collect::<Vec<_>>());
        let shape =
            super::skin::SkinShape { points: &points, point_of: &point_of, normals: &[], colours: &[], triangles };
        Self(Some(Arc::new(Skin::of_particles(&shape))))
    }
}

impl From<Arc<Skin>> for SkinEmbedding {
    fn from(skin: Arc<Skin>) -> Self {
        Self(Some(skin))
    }
}

impl PartialEq for SkinEmbedding {
    /// It follows from the scene as the faces do, which are compared.
    fn eq(&self, other: &Self) -> bool {
        self.0.is_some() == other.0.is_some()
    }
}

impl BodySnapshot {
    /// Vertices of the skin [m], worked out here where only the particles were taken; empty for a body without one.
    pub fn surface(&self) -> Cow<'_, [DVec3]> {
        match &self.embedding.0 {
            Some(skin) if self.skin.is_empty() => Cow::Owned(skin.positions(&self.particles)),
            _ => Cow::Borrowed(&self.skin),
        }
    }

    /// The same body elsewhere.
    #[must_use]
    pub fn moved(&self, by: DVec3) -> Self {
        let mut moved = self.clone();
        let fibres = moved.fibres.iter_mut().flat_map(|fibre| &mut fibre.vertices);
        let sheets = moved.sheets.iter_mut().flat_map(|sheet| &mut sheet.vertices);
        let elements = moved.elements.iter_mut().flat_map(|element| &mut element.points);
        for point in moved.particles.iter_mut().chain(&mut moved.skin).chain(fibres).chain(sheets).chain(elements) {
            *point += by;
        }
        moved
    }

    /// What the surface hangs on beside the particles: directions that turn with the body, behind them in the rig's
    /// sums.
    pub(crate) fn directions(&self) -> Vec<DVec3> {
        self.embedding.0.as_ref().map_or_else(Vec::new, |skin| skin.directions(&self.particles))
    }

    /// The surface that pictures show, over the particles; none for a body without a skin.
    pub(crate) fn rig(&self) -> Option<&Arc<Rig>> {
        self.embedding.0.as_ref().map(|skin| skin.rig())
    }
}

/// How a two-layer body is put together.
#[derive(Clone, Debug, PartialEq)]
pub struct LayersSnapshot {
    /// Number of particles in the outer layer; those of the inner layer follow.
    pub outer: usize,
    /// Particles at both ends of every spring.
    pub springs: Arc<[[u32; 2]]>,
    /// Which of the springs are of which kind.
    pub kinds: Vec<(SpringKind, Range<usize>)>,
}

impl LayersSnapshot {
    fn of(layers: &Layers) -> Self {
        let kinds = layers.springs.groups().iter().map(|group| (group.kind, group.springs.clone())).collect();
        Self { outer: layers.outer, springs: Arc::clone(layers.springs.ends()), kinds }
    }
}

/// A fibre at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FibreSnapshot {
    /// Identifier of the scene's fibre.
    pub id: String,
    /// Structure particles [m].
    pub vertices: Vec<DVec3>,
}

/// Elements over the same points at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementSnapshot {
    /// Identifier of the scene's element, or of who made them.
    pub id: String,
    /// Points [m].
    pub points: Vec<DVec3>,
    /// Between which of them lines are drawn.
    pub lines: Arc<[[u32; 2]]>,
}

impl ElementSnapshot {
    fn of(lines: &ElementLines, positions: &[DVec3]) -> Self {
        let points = lines.points.iter().map(|point| point.gather(positions)).collect();
        Self { id: lines.id.clone(), points, lines: Arc::clone(&lines.lines) }
    }
}

/// A sheet at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetSnapshot {
    /// Identifier of the scene's sheet.
    pub id: String,
    /// Vertices [m].
    pub vertices: Vec<DVec3>,
    /// Three vertices a triangle.
    pub triangles: Arc<[[u32; 3]]>,
    /// Lines along its grain; none where it has none.
    pub threads: Arc<[Vec<SurfacePoint>]>,
    /// Lines of vertices where it ends.
    pub rim: Arc<[Vec<u32>]>,
}

impl SheetSnapshot {
    fn of(sheet: &SheetSurface, positions: &[DVec3]) -> Self {
        Self {
            id: sheet.id.clone(),
            vertices: sheet.vertices.iter().map(|vertex| vertex.gather(positions)).collect(),
            triangles: Arc::clone(&sheet.triangles),
            threads: Arc::clone(&sheet.threads),
            rim: Arc::clone(&sheet.rim),
        }
    }

    /// A point on an edge [m].
    pub(crate) fn point(&self, of: SurfacePoint) -> DVec3 {
        let [from, to] = of.ends.map(|k| self.vertices[k as usize]);
        from.lerp(to, of.share)
    }
}

impl Snapshot {
    /// Name of the first body of which some point is no finite number; none where all can be drawn and written.
    pub fn not_finite(&self) -> Option<&str> {
        let is_whole = |body: &BodySnapshot| {
            let fibres = body.fibres.iter().flat_map(|fibre| &fibre.vertices);
            let normals = body.normals.iter().all(|normal| normal.is_finite());
            let sheets = body.sheets.iter().flat_map(|sheet| &sheet.vertices);
            let elements = body.elements.iter().flat_map(|element| &element.points);
            let points = body.particles.iter().chain(&body.skin).chain(fibres).chain(sheets).chain(elements);
            normals && points.into_iter().all(|point| point.is_finite())
        };
        self.bodies.iter().find(|body| !is_whole(body)).map(|body| body.name.as_str())
    }

    /// The world as it stands.
    pub fn of(world: &World) -> Self {
        Self::with(world, true, |body| &body.state().positions)
    }

    /// The world as it stands, without the positions of skins: pictures work them out by themselves.
    pub fn of_particles(world: &World) -> Self {
        Self::with(world, false, |body| &body.state().positions)
    }

    /// Every body at rest in its own model frame, as it is drawn into.
    pub(crate) fn in_model_frames(world: &World) -> Self {
        Self::with(world, true, |body| &body.parts().model)
    }

    fn with<'a>(world: &'a World, skins: bool, positions: impl Fn(&'a Body) -> &'a [DVec3]) -> Self {
        let bodies = world
            .bodies()
            .iter()
            .map(|body| {
                let positions = positions(body);
                let parts = body.parts();
                let skin = body.skin().map(Arc::as_ref);
                let moved = skin.filter(|_| skins);
                let vertices = moved.map_or_else(Vec::new, |skin| skin.positions(positions));
                BodySnapshot {
                    name: parts.name.clone(),
                    particles: positions.to_vec(),
                    fibres: parts
                        .fibres
                        .iter()
                        .map(|fibre| FibreSnapshot {
                            id: fibre.id.clone(),
                            vertices: fibre.vertices.iter().map(|vertex| vertex.gather(positions)).collect(),
                        })
                        .collect(),
                    sheets: parts.sheets.iter().map(|sheet| SheetSnapshot::of(sheet, positions)).collect(),
                    elements: parts.elements.iter().map(|of| ElementSnapshot::of(of, positions)).collect(),
                    breaks: body.breaks().copied().collect(),
                    first_tear: body.first_tear(),
                    normals: moved.map_or_else(Vec::new, |skin| skin.normals(&vertices)),
                    skin: vertices,
                    triangles: skin.map_or_else(Arc::default, |skin| Arc::clone(skin.triangles())),
                    colours: skin.map_or_else(Arc::default, |skin| Arc::clone(skin.colours())),
                    embedding: SkinEmbedding(body.skin().cloned()),
                    layers: parts.layers.as_deref().map(LayersSnapshot::of),
                }
            })
            .collect();
        let panels = world.panels().iter().map(|panel| panel.height).collect();
        let colliders = world.colliders().iter().map(|of| ColliderSnapshot::of(of, world.time())).collect();
        Self { time: world.time(), bodies, panels, colliders, field: None, tension: None, activation: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_with_a_point_that_is_no_number_is_named() {
        let body = |name: &str| BodySnapshot {
            name: name.to_owned(),
            particles: vec![DVec3::ZERO, DVec3::ONE],
            skin: vec![DVec3::X],
            normals: vec![Vec3::Y],
            fibres: vec![FibreSnapshot { id: "fibre".to_owned(), vertices: vec![DVec3::Z] }],
            ..BodySnapshot::default()
        };
        let whole = Snapshot { bodies: vec![body("a"), body("b")], ..Snapshot::default() };
        assert_eq!(whole.not_finite(), None);
        let broken = |change: &dyn Fn(&mut BodySnapshot)| {
            let mut snapshot = whole.clone();
            change(&mut snapshot.bodies[1]);
            snapshot.not_finite().map(str::to_owned)
        };
        let b = Some("b".to_owned());
        assert_eq!(broken(&|body| body.particles[1].y = f64::NAN), b);
        assert_eq!(broken(&|body| body.skin[0].x = f64::INFINITY), b);
        assert_eq!(broken(&|body| body.normals[0].x = f32::NAN), b);
        assert_eq!(broken(&|body| body.fibres[0].vertices[0].z = f64::NEG_INFINITY), b);
    }
}
