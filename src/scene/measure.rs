//! Measures: signed numbers read off the motion.

use super::{Axis, Extra};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A quantity read off one body each frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Measure {
    /// Name in reports and series, unique among the measures.
    pub name: String,
    /// Body that is measured.
    pub body: String,
    /// What is measured, and where.
    pub kind: MeasureKind,
    /// Which of the values over time a report gives.
    #[serde(default)]
    pub over_time: OverTime,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Measure {
    /// A quantity of the body with this identifier; a report gives its last value.
    pub fn new(name: impl Into<String>, body: impl Into<String>, kind: MeasureKind) -> Self {
        Self { name: name.into(), body: body.into(), kind, over_time: OverTime::default(), extra: Extra::new() }
    }

    /// Reported by its value of greatest magnitude.
    #[must_use]
    pub fn at_peak(self) -> Self {
        Self { over_time: OverTime::Peak, ..self }
    }
}

/// What is measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MeasureKind {
    /// Mean displacement of a region from where it started [mm], a vector.
    MeanDisplacement(OfRegion),
    /// Mean displacement of a region from where it started, along a direction [mm].
    Advance(Advance),
    /// Largest distance of any particle of a region from where it started [mm].
    TipDisplacement(OfRegion),
    /// Relative shortening between the centres of two regions along an axis [fraction]; negative when it grows.
    HeightLoss(Extent),
    /// Turn of one region against another about an axis [degrees], right-handed.
    Twist(Turned),
    /// Displacement of one region against another, across the line between them at the start [mm], a vector.
    Shear(Between),
    /// Force with which the body pushes on the pins of a region, along a direction [N].
    ReactionForce(Reaction),
    /// Torque with which the body turns the pins of a region, about a direction through the region's centre [N m].
    ReactionTorque(Reaction),
    /// Force with which the body pushes on a collider [N], a vector.
    ColliderForce(OnCollider),
    /// Extent of the whole body along an axis [m].
    Size(Along),
    /// Distance between the centres of mass of the two layers of a two-layer body [m].
    LayerOffset,
    /// Volume enclosed by the outer layer of a two-layer body [m³], its area [m²] in 2D; of a fibre solid the sum over
    /// its particles of what each fills at rest, times by how much the material there has grown.
    Volume,
    /// Moment of inertia of a two-layer body about its centre [fraction of M Ro²], Ro the mean distance of the outer
    /// particles from it: about the normal of the plane in 2D, the mean over all axes in 3D. It tells where the mass
    /// is.
    InertiaRatio,
    /// Work that the drives of the body's fibres, of gravity and of its gas have done on it [J]; not that of pins,
    /// panels and wind.
    ActivationWork,
    /// Energy that the body has lost for good to yielding, tearing and viscosity of its matrix [J]; not to damping,
    /// contact or drag.
    Dissipated,
    /// Greatest equivalent plastic strain of the body's matrix [fraction]: all that a particle has yielded, there and
    /// back.
    PlasticStrain,
    /// Pairs of neighbours across the seams of a fibre solid that are torn, of all across them [fraction].
    Torn,
    /// Mean stress of the matrix in a region of a fibre solid [Pa]: along a direction, or the equivalent one.
    Stress(Strained),
    /// Mean strain of the matrix in a region of a fibre solid [fraction]: along a direction, or the equivalent one.
    Strain(Strained),
    /// Mean length of the velocities in a region [m/s].
    Speed(OfRegion),
    /// Force with which the body pushes up a panel [N].
    PanelForce(OnPanel),
    /// Force with which the body, or a region of it, pushes on all that it touches, along a direction [N]: room, panels
    /// and other bodies.
    ContactForce(Touching),
    /// Force that a fibre carries along itself [N], negative where it is pressed.
    FibreTension(OfFibre),
}

impl MeasureKind {
    /// Mean stress of the matrix in a region along a direction, or the equivalent one after von Mises [Pa].
    pub fn stress(region: impl Into<String>, along: Option<[f64; 3]>) -> Self {
        Self::Stress(Strained { region: region.into(), along, extra: Extra::new() })
    }

    /// Mean strain of the matrix in a region along a direction, or the equivalent one after von Mises [fraction].
    pub fn strain(region: impl Into<String>, along: Option<[f64; 3]>) -> Self {
        Self::Strain(Strained { region: region.into(), along, extra: Extra::new() })
    }

    /// Mean length of the velocities in a region [m/s].
    pub fn speed(region: impl Into<String>) -> Self {
        Self::Speed(OfRegion { region: region.into(), extra: Extra::new() })
    }

    /// Force with which the body pushes up a panel [N].
    pub fn panel_force(panel: impl Into<String>) -> Self {
        Self::PanelForce(OnPanel { panel: panel.into(), extra: Extra::new() })
    }

    /// Force with which the whole body pushes on all that it touches, along a direction [N].
    pub fn contact_force(along: impl Into<[f64; 3]>) -> Self {
        Self::ContactForce(Touching { region: None, along: along.into(), extra: Extra::new() })
    }

    /// Greatest or mean force that a fibre carries along itself [N].
    pub fn fibre_tension(fibre: impl Into<String>, of: OverEdges) -> Self {
        Self::FibreTension(OfFibre { fibre: fibre.into(), of, extra: Extra::new() })
    }

    /// Mean displacement of a region from where it started [mm], a vector.
    pub fn mean_displacement(region: impl Into<String>) -> Self {
        Self::MeanDisplacement(OfRegion { region: region.into(), extra: Extra::new() })
    }

    /// Mean displacement of a region from where it started, along a direction [mm].
    pub fn advance(region: impl Into<String>, along: impl Into<[f64; 3]>) -> Self {
        Self::Advance(Advance { region: region.into(), along: along.into(), extra: Extra::new() })
    }

    /// Largest distance of any particle of a region from where it started [mm].
    pub fn tip_displacement(region: impl Into<String>) -> Self {
        Self::TipDisplacement(OfRegion { region: region.into(), extra: Extra::new() })
    }

    /// Relative shortening between the centres of two regions along an axis [fraction].
    pub fn height_loss(region: impl Into<String>, against: impl Into<String>, axis: Axis) -> Self {
        Self::HeightLoss(Extent { region: region.into(), against: against.into(), axis, extra: Extra::new() })
    }

    /// Turn of one region against another about an axis [degrees].
    pub fn twist(region: impl Into<String>, against: impl Into<String>, axis: impl Into<[f64; 3]>) -> Self {
        let axis = axis.into();
        Self::Twist(Turned { region: region.into(), against: against.into(), axis, extra: Extra::new() })
    }

    /// Displacement of one region against another, across the line between them at the start [mm], a vector.
    pub fn shear(region: impl Into<String>, against: impl Into<String>) -> Self {
        Self::Shear(Between { region: region.into(), against: against.into(), extra: Extra::new() })
    }

    /// Force with which the body pushes on the pins of a region, along a direction [N].
    pub fn reaction_force(region: impl Into<String>, along: impl Into<[f64; 3]>) -> Self {
        Self::ReactionForce(Reaction { region: region.into(), along: along.into(), extra: Extra::new() })
    }

    /// Torque with which the body turns the pins of a region, about a direction through the region's centre [N m].
    pub fn reaction_torque(region: impl Into<String>, along: impl Into<[f64; 3]>) -> Self {
        Self::ReactionTorque(Reaction { region: region.into(), along: along.into(), extra: Extra::new() })
    }

    /// Force with which the body pushes on a collider [N], a vector.
    pub fn collider_force(collider: impl Into<String>) -> Self {
        Self::ColliderForce(OnCollider { collider: collider.into(), extra: Extra::new() })
    }

    /// Extent of the whole body along an axis [m].
    pub fn size(axis: Axis) -> Self {
        Self::Size(Along { axis, extra: Extra::new() })
    }
}

/// A region and a direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Advance {
    /// The region.
    pub region: String,
    /// Direction of any length but zero, world axes.
    pub along: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// An axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Along {
    /// World axis.
    pub axis: Axis,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A collider.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OnCollider {
    /// Identifier of the collider.
    pub collider: String,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OfRegion {
    /// Region of the body.
    pub region: String,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// One region against another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Between {
    /// Region that moves.
    pub region: String,
    /// Region against which it is measured.
    pub against: String,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// One region against another along an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Extent {
    /// Region at one end.
    pub region: String,
    /// Region at the other end.
    pub against: String,
    /// World axis along which the distance is taken.
    pub axis: Axis,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// One region against another about an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Turned {
    /// Region that turns.
    pub region: String,
    /// Region against which the turn is measured.
    pub against: String,
    /// Axis of the turn, of any length but zero, world axes.
    pub axis: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Reaction of a held region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Reaction {
    /// Region that is held by a pin.
    pub region: String,
    /// Direction of any length but zero, world axes.
    pub along: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A region of the matrix.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Strained {
    /// The region.
    pub region: String,
    /// Direction of any length but zero, world axes: what is stretched or pulled along it counts, positive, and what is
    /// pressed, negative. Without it the equivalent value after von Mises is taken.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub along: Option<[f64; 3]>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A panel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OnPanel {
    /// Panel of the scene.
    pub panel: String,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// What touches, and a direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Touching {
    /// Region of the body; all of it unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Direction of any length but zero, world axes.
    pub along: [f64; 3],
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// A fibre of a fibre solid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OfFibre {
    /// Fibre of the body.
    pub fibre: String,
    /// What is taken of its edges.
    #[serde(default)]
    pub of: OverEdges,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// What is taken of the edges of a fibre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OverEdges {
    /// The one that is pulled most.
    #[default]
    Greatest,
    /// The mean over all.
    Mean,
}

/// Which of the values over time a report gives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OverTime {
    /// The last one.
    #[default]
    Final,
    /// The one of greatest magnitude, with its sign.
    Peak,
}
