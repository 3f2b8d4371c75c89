//! The document: what a person makes, saves and undoes. Data and validation only; nothing here simulates.
//!
//! Every length is in metres, mass in kilograms, time in seconds, force in newtons; angles are in degrees because
//! people type them. The frame is right-handed with Y up. Bodies are described in their own rest frame (the *model
//! frame*, in which fibres, regions and strokes live) and put into the world by a [`Placement`].
//!
//! Each struct keeps the JSON fields it does not know in `extra`, so that a scene written by a newer program
//! survives loading and saving here.

mod activation;
mod any_body;
mod assets;
mod axis;
mod body;
mod building;
mod collider;
mod document;
mod drivable;
mod drivable_words;
mod drive;
mod element;
mod extra;
mod fibre;
mod follow;
mod integrator;
mod keyed;
mod layer_shape;
mod material;
mod measure;
mod naming;
mod paint;
mod panel;
mod pin;
mod region;
mod region_material;
mod room;
mod round_shape;
mod shape;
mod sheet;
mod size;
mod spring_act;
mod start;
mod time;
mod two_layer;
mod validate;
mod void;
mod wind;

pub use activation::{Activation, Curl, MusclePull, TwistRate};
pub use any_body::{AnyBody, AnyBodyMut, OwnedBody};
pub use assets::{Assets, ModelFile};
pub use axis::{Axis, Side};
pub use body::{Body, BodyKind};
pub use collider::{Collider, ColliderBox, ColliderCapsule, ColliderMesh, ColliderShape, ColliderSphere};
pub use document::{MAX_PARTICLES, SCENE_VERSION, Scene, Units};
pub use drivable::Drivable;
pub use drive::{AfterLast, Drive, DriveKey, DriveKeys, Interpolation, Otherwise, SharedDrive, Wave};
pub use element::{Element, ElementActivation, ElementLaw, ElementMeasure, MAX_ELEMENTS, MAX_TABLE_POINTS, SpringLaw};
pub use extra::Extra;
pub use fibre::{
    BreakPast, Fibre, FibreSource, Mismatch, PaperStiffness, RestShape, Rigidity, Stiffness, StrokePair, ViewStroke,
    YieldPast,
};
pub use follow::{CacheLeader, Follow, FollowSelect, FollowSprings, Hold, Leader, SkeletonLeader};
pub use integrator::{IntegratorChoice, IntegratorKind};
pub use layer_shape::{Ball, ClosedMesh, InnerOffset, Ring, Segment, TwoLayerShape};
pub use material::{
    Damping, Falloff, FibreEmbedding, Mass, Material, Plasticity, Precision, USUAL_SUPPORT_RADIUS, Viscosity,
};
pub use measure::{
    Advance, Along, Between, Extent, Measure, MeasureKind, OfFibre, OfRegion, OnCollider, OnPanel, OverEdges, OverTime,
    Reaction, Strained, Touching, Turned,
};
#[cfg(feature = "gui")]
pub(crate) use naming::UNTITLED;
pub use paint::{Dab, MAX_DABS, add_dab, painted};
pub use panel::{HeightKey, Panel, PanelDrive, PanelMotion};
pub use pin::{Distance, DrivenMotion, DrivenTurn, Easing, Keyframe, Motion, Pin, Ramp, Turn};
pub use region::{Region, Selector};
pub use region_material::RegionMaterial;
pub use room::{Room, Sticking};
pub use round_shape::{BallShape, CapsuleShape, CylinderShape, TorusShape};
pub use shape::{BoxShape, MeshShape, Placement, Rotation, Shape};
pub(crate) use sheet::SEAM_STRETCH;
pub use sheet::{
    Grain, GrainAlong, MAX_SHEET_VERTICES, MAX_SHEETS, Seam, Sheet, SheetActivation, SheetRestShape, SheetSource,
    SheetStiffness, SheetTriangles, SweptStrokes,
};
pub(crate) use size::BYTES_PER_PARTICLE;
pub use spring_act::{ActiveSprings, SpringChoice};
pub use start::{Impulse, Initial};
pub use time::{Automatic, Manual, Time, TimeStep};
pub use two_layer::{ContactKind, Grab, PressureIn, RegionMass, TwoLayer, TwoLayerContact};
pub use validate::SceneError;
pub(crate) use validate::{brief, one_line};
pub use void::{MAX_VOIDS, Void, VoidMesh, VoidShape};
pub use wind::Wind;
