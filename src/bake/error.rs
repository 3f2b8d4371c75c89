//! What keeps a scene from being put together.

use crate::geometry::FillError;
use crate::sketch::SketchError;
use crate::solver::neighbourhood::TooThin;
use thiserror::Error;

/// A scene that cannot be put together.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BakeError {
    /// It was no longer wanted: whoever heard how far it had come broke it off.
    #[error("putting the scene together was stopped")]
    Cancelled,
    /// No lattice point lies inside the shape.
    #[error(
        "{path}: no particle fits into the shape at a spacing of {spacing} m; lower {body}/material/support_radius"
    )]
    Empty {
        /// Pointer to the shape.
        path: String,
        /// Pointer to the body.
        body: String,
        /// Particle spacing [m].
        spacing: f64,
    },
    /// An element of a program's own that is none.
    #[error("{path}: {element} is refused: {why}")]
    ElementRefused {
        /// Pointer to the body.
        path: String,
        /// Which.
        element: String,
        /// What is wrong with it, with its figure.
        why: String,
    },
    /// Elements of a program's own for a body that is not there.
    #[error("elements {id:?} are of a body {body:?}, which is no fibre solid of the scene")]
    NoBodyOfElements {
        /// What they are called.
        id: String,
        /// The body.
        body: String,
    },
    /// The shape's model was not loaded.
    #[error("{path}: the model was not loaded; load the scene's assets first")]
    NotLoaded {
        /// Pointer to the shape's path.
        path: String,
    },
    /// The shape would need more particles than are allowed.
    #[error("{path}: about {wanted:.1e} {what} where {limit:.1e} are allowed; give {suggested}, or check the scale")]
    TooMany {
        /// Pointer to the value that decides.
        path: String,
        /// What there would be too much of.
        what: &'static str,
        /// How many there would be.
        wanted: f64,
        /// Greatest number.
        limit: f64,
        /// What would do.
        suggested: String,
    },
    /// Much of a mesh is thinner than two layers.
    #[error(
        "{path}: the shape is too thin for its particles ({flat} of {total} have too few others around them): {remedy}"
    )]
    MeshTooThin {
        /// Pointer to the value that decides.
        path: String,
        /// Particles that nothing could hold in place.
        flat: usize,
        /// Lattice points inside.
        total: usize,
        /// What gives two layers, as was tried, or else to be done.
        remedy: String,
    },
    /// The pieces of a mesh lie too far apart.
    #[error("{path}: {source}")]
    MeshTooWide {
        /// Pointer to the mesh.
        path: String,
        /// How far.
        source: FillError,
    },
    /// Part of the shape is a single layer of particles.
    #[error("{path}: {source}")]
    TooThin {
        /// Pointer to the support radius.
        path: String,
        /// What was found.
        source: TooThin,
    },
    /// A wall beside a void that is hardly more than one layer of particles thick.
    #[error(
        "{path}: {count} particles beside it, the first at {at:.4?} m, are a wall of less than two layers, which cannot resist \
         bending; leave {least:.2e} m or more, or give the material a support radius of {support_radius:.2e} m, which makes two \
         layers of one"
    )]
    ThinWall {
        /// Pointer to the void's shape.
        path: String,
        /// Particles of the wall.
        count: usize,
        /// The first of them [m].
        at: [f64; 3],
        /// Thickness of two layers [m].
        least: f64,
        /// Support radius at which one layer becomes two [m].
        support_radius: f64,
    },
    /// A layer beside a seam that nothing would hold once that is torn.
    #[error(
        "{path}: {count} particles, the first at {at:.4?} m, would be a single layer once the seam is torn, which cannot resist \
         bending; leave {least:.2e} m or more on either side, or give the material a smaller support radius"
    )]
    ThinBesideSeam {
        /// Pointer to the seam.
        path: String,
        /// Particles of such layers.
        count: usize,
        /// The first of them [m].
        at: [f64; 3],
        /// Thickness of two layers [m].
        least: f64,
    },
    /// A tube whose strokes make no line.
    #[error("{path}: {source}")]
    VoidUndrawn {
        /// Pointer to the source.
        path: String,
        /// What is wrong with it.
        source: SketchError,
    },
    /// A region that selects no particle.
    #[error("{path}: the region selects none of the {particles} particles; enlarge it or remove it")]
    EmptyRegion {
        /// Pointer to the region.
        path: String,
        /// Particles of the body.
        particles: usize,
    },
    /// A two-layer body whose gas has no room.
    #[error("{path}: the gas would have a volume of {volume:.3e} at the start; deform the body less")]
    InsideOut {
        /// Pointer to the deformation.
        path: String,
        /// Signed volume [m³], or area [m²].
        volume: f64,
    },
    /// A two-layer body whose outer layer would have holes.
    #[error(
        "{path}: the surface is not closed ({open_edges} open edges), so that no gas stays in it; close it in the program \
         it is from"
    )]
    NotClosed {
        /// Pointer to the mesh's path.
        path: String,
        /// Edges of one face only.
        open_edges: usize,
    },
    /// A two-layer body of more particles than are allowed.
    #[error("{path}: the mesh has {points} points where {limit} are allowed; simplify it")]
    TooManyPoints {
        /// Pointer to the mesh's path.
        path: String,
        /// Points of the mesh.
        points: usize,
        /// Greatest number.
        limit: usize,
    },
    /// An inner layer that does not fit into the outer one.
    #[error(
        "{path}: {value} turns the inner layer inside out (faces turned over: {turned}, pairs that pass through each \
         other: {crossings}, volume inside: {volume:.2e} m³); {remedy}"
    )]
    InnerLayer {
        /// Pointer to the offset.
        path: String,
        /// The offset, as given.
        value: f64,
        /// Faces that would look the other way.
        turned: usize,
        /// Pairs of faces that would pass through each other.
        crossings: usize,
        /// Volume inside [m³].
        volume: f64,
        /// What to give.
        remedy: String,
    },
    /// A reference to something that is not there.
    #[error("{path}: {what} \"{id}\" does not exist; there are: {known}")]
    Unknown {
        /// Pointer to the reference.
        path: String,
        /// What it refers to.
        what: &'static str,
        /// The identifier.
        id: String,
        /// Identifiers that exist.
        known: String,
    },
    /// A height between regions that lie at the same height.
    #[error(
        "{path}: the two regions lie only {apart:.2e} m apart along this axis, which is no height; choose another axis"
    )]
    NoHeight {
        /// Pointer to the axis.
        path: String,
        /// Distance at rest [m].
        apart: f64,
    },
    /// A fibre that is to curl or twist by more from vertex to vertex than such a turn is told by.
    #[error(
        "{path}: {rate} degrees/m, where the drive is {largest}, turn the fibre by {degrees:.0} degrees between vertices \
         {longest:.2e} m apart, and less than {most} are possible; give at most {:.3} degrees/m in size or put the vertices \
         nearer to each other", 0.99 * most / (largest * longest)
    )]
    TurnsTooFar {
        /// Pointer to the turn per length.
        path: String,
        /// Turn per length [degrees/m].
        rate: f64,
        /// Greatest size of the drive's values.
        largest: f64,
        /// Greatest distance of the vertices [m].
        longest: f64,
        /// Turn from vertex to vertex [degrees].
        degrees: f64,
        /// The turn that it stays below [degrees].
        most: f64,
    },
    /// A motion that no particle follows.
    #[error("{path}: none of the {particles} particles follows by this; choose more of them")]
    NothingFollows {
        /// Pointer to what chooses them.
        path: String,
        /// Particles of the body.
        particles: usize,
    },
    /// A joint that makes everything flat.
    #[error(
        "{path}: the joint \"{joint}\" is shown without an extent along some axis, so that nothing can be bound to it; give it a \
         scale above zero in the file"
    )]
    FlatJoint {
        /// Pointer to the file's path.
        path: String,
        /// Its name.
        joint: String,
    },
    /// A point cache without a mesh that it moves.
    #[error(
        "{path}: nothing says of which mesh its points are the vertices; give `rest` the model that it was made of"
    )]
    NoRest {
        /// Pointer to the cache.
        path: String,
    },
    /// A point cache of another mesh.
    #[error(
        "{path}: the cache has {points} points and the mesh that it is to move {vertices} vertices; give `rest` the model that it \
         was made of"
    )]
    CacheCount {
        /// Pointer to the cache's path.
        path: String,
        /// Points of the cache.
        points: usize,
        /// Vertices of the mesh.
        vertices: usize,
    },
    /// More steps to a frame than anybody can wait for.
    #[error(
        "{path}: a frame of {frame_seconds:.3e} s would take {steps:.2e} steps of at most {stable_dt:.2e} s for \"{body}\"; \
         raise the frame rate, {remedy}"
    )]
    TooManySteps {
        /// Pointer to the frame rate.
        path: String,
        /// Name of the body.
        body: String,
        /// Length of a frame [s].
        frame_seconds: f64,
        /// Steps that it would take.
        steps: f64,
        /// Stable step [s].
        stable_dt: f64,
        /// What else to do, with the pointers to what it takes.
        remedy: String,
    },
    /// A reaction asked of a region that nothing holds.
    #[error("{path}: nothing holds region \"{region}\", so it has no reaction; add a pin on it")]
    NotHeld {
        /// Pointer to the measure.
        path: String,
        /// The region.
        region: String,
    },
}

/// What shortens no frame and lengthens the step: of the parameter that sets it, and of an integrator, by their
/// pointers.
pub(super) fn softer(limited_by: Option<&str>, integrator: Option<&str>) -> String {
    let lower = limited_by.map_or("soften its material or fibres".to_owned(), |pointer| format!("lower {pointer}"));
    match integrator {
        Some(pointer) => format!("{lower}, or choose another {pointer}, under which what nothing damps does not grow"),
        None => format!("or {lower}"),
    }
}

/// Where a reference fails: the identifiers that exist, for the message.
pub(super) fn known<'a>(ids: impl Iterator<Item = &'a str>) -> String {
    let ids: Vec<&str> = ids.collect();
    if ids.is_empty() { "none".to_owned() } else { ids.join(", ") }
}
