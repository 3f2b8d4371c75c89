//! Signed numbers read off a body.

use super::body::Body;
use super::forces::{Inelastic, MatrixForce};
use super::layers::Layers;
use crate::geometry::turn::{mean, turn_about};
use glam::DVec3;

/// A value, a number or a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeasureValue {
    /// A number.
    Scalar(f64),
    /// A vector, world axes.
    Vector(DVec3),
}

impl MeasureValue {
    /// Its size, for comparing.
    pub fn magnitude(&self) -> f64 {
        match self {
            Self::Scalar(value) => value.abs(),
            Self::Vector(value) => value.length(),
        }
    }
}

/// Particles of one body.
pub(crate) type Group = Vec<u32>;

/// What is read.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Quantity {
    /// Mean displacement from the rest shape in the world [mm].
    MeanDisplacement(Group),
    /// Mean displacement from the rest shape in the world along a unit direction [mm].
    Advance(Group, DVec3),
    /// Largest displacement [mm].
    TipDisplacement(Group),
    /// Shortening of the distance between two groups along an axis, over the rest distance.
    HeightLoss(Group, Group, usize),
    /// Turn of the first group against the second about a unit axis [degrees].
    Twist(Group, Group, DVec3),
    /// Displacement of the first group against the second, across the line between them at rest [mm].
    Shear(Group, Group),
    /// Force on the pins of a group along a unit direction [N]; the flags tell which axes are held, particle by
    /// particle.
    ReactionForce(Group, Vec<DVec3>, DVec3),
    /// Torque on the pins of a group about a unit direction through the group's centre [N m].
    ReactionTorque(Group, Vec<DVec3>, DVec3),
    /// Force on a collider, by its index [N].
    ColliderForce(usize),
    /// Extent of all particles along an axis [m].
    Size(usize),
    /// Distance between the centres of a two-layer body's layers [m].
    LayerOffset,
    /// Volume [m³], or area [m²], enclosed by a two-layer body's outer layer, and its unit.
    Volume(&'static str),
    /// Moment of inertia of a two-layer body over M Ro².
    InertiaRatio,
    /// Work of drives [J].
    ActivationWork,
    /// Energy that was lost to yielding and viscosity [J].
    Dissipated,
    /// Greatest equivalent plastic strain of the matrix.
    PlasticStrain,
    /// Share of the pairs across all seams that is torn.
    Torn,
    /// Mean stress of the matrix [Pa] along a unit direction, or its equivalent.
    Stress(Group, Option<DVec3>),
    /// Mean strain of the matrix along a unit direction, or its equivalent.
    Strain(Group, Option<DVec3>),
    /// Mean length of the velocities [m/s].
    Speed(Group),
    /// Upward force on a panel [N].
    PanelForce(usize),
    /// Force of a group on all that it touches, along a unit direction [N].
    ContactForce(Group, DVec3),
    /// Force in the edge of some centre lines that is pulled most [N].
    GreatestTension(Vec<usize>),
    /// Mean force in the edges of some centre lines [N].
    MeanTension(Vec<usize>),
}

const MILLI: f64 = 1e3;

impl Quantity {
    /// Name of the kind in reports.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::MeanDisplacement(..) => "mean_displacement",
            Self::Advance(..) => "advance",
            Self::TipDisplacement(..) => "tip_displacement",
            Self::HeightLoss(..) => "height_loss",
            Self::Twist(..) => "twist",
            Self::Shear(..) => "shear",
            Self::ReactionForce(..) => "reaction_force",
            Self::ReactionTorque(..) => "reaction_torque",
            Self::ColliderForce(_) => "collider_force",
            Self::Size(_) => "size",
            Self::LayerOffset => "layer_offset",
            Self::Volume(_) => "volume",
            Self::InertiaRatio => "inertia_ratio",
            Self::ActivationWork => "activation_work",
            Self::Dissipated => "dissipated",
            Self::PlasticStrain => "plastic_strain",
            Self::Torn => "torn",
            Self::Stress(..) => "stress",
            Self::Strain(..) => "strain",
            Self::Speed(_) => "speed",
            Self::PanelForce(_) => "panel_force",
            Self::ContactForce(..) => "contact_force",
            Self::GreatestTension(_) | Self::MeanTension(_) => "fibre_tension",
        }
    }

    /// Unit of the value.
    pub(crate) fn unit(&self) -> &'static str {
        match self {
            Self::MeanDisplacement(..) | Self::Advance(..) | Self::TipDisplacement(..) | Self::Shear(..) => "mm",
            Self::HeightLoss(..) | Self::InertiaRatio | Self::PlasticStrain | Self::Torn | Self::Strain(..) => {
                "fraction"
            }
            Self::Size(_) | Self::LayerOffset => "m",
            Self::Volume(unit) => unit,
            Self::Twist(..) => "degrees",
            Self::ReactionForce(..)
            | Self::ColliderForce(_)
            | Self::PanelForce(_)
            | Self::ContactForce(..)
            | Self::GreatestTension(_)
            | Self::MeanTension(_) => "N",
            Self::Stress(..) => "Pa",
            Self::Speed(_) => "m/s",
            Self::ReactionTorque(..) => "N m",
            Self::ActivationWork | Self::Dissipated => "J",
        }
    }

    /// Distance at rest [m] along the axis of a height loss; infinite for everything else.
    pub(crate) fn rest_distance(&self, rest: &[DVec3]) -> f64 {
        match self {
            Self::HeightLoss(a, b, axis) => (mean(a, rest) - mean(b, rest))[*axis].abs(),
            _ => f64::INFINITY,
        }
    }

    /// Whether the value needs the forces of the present state, which not every integrator leaves after a step.
    pub(crate) fn needs_forces(&self) -> bool {
        matches!(self, Self::ReactionForce(..) | Self::ReactionTorque(..))
    }

    /// Whether the value is a vector.
    pub(crate) fn is_vector(&self) -> bool {
        matches!(self, Self::MeanDisplacement(..) | Self::Shear(..) | Self::ColliderForce(_))
    }

    /// Value at the present time [s].
    pub(crate) fn read(&self, body: &Body, time: f64) -> MeasureValue {
        let now = &body.state().positions;
        let rest = &body.parts().rest;
        match self {
            Self::MeanDisplacement(group) => MeasureValue::Vector(MILLI * (mean(group, now) - mean(group, rest))),
            Self::Advance(group, along) => {
                MeasureValue::Scalar(MILLI * (mean(group, now) - mean(group, rest)).dot(*along))
            }
            Self::TipDisplacement(group) => MeasureValue::Scalar(
                MILLI * group.iter().map(|&i| now[i as usize].distance(rest[i as usize])).fold(0.0, f64::max),
            ),
            Self::HeightLoss(a, b, axis) => {
                let before = (mean(a, rest) - mean(b, rest))[*axis];
                let after = (mean(a, now) - mean(b, now))[*axis];
                MeasureValue::Scalar(1.0 - after / before)
            }
            Self::Twist(a, b, axis) => {
                let turn = turn_about(a, rest, now, *axis) - turn_about(b, rest, now, *axis);
                // Into (-180, 180].
                let wrapped = turn - 360.0 * ((turn - 180.0) / 360.0).ceil();
                MeasureValue::Scalar(wrapped)
            }
            Self::Shear(a, b) => {
                let line = (mean(a, rest) - mean(b, rest)).normalize_or_zero();
                let moved = (mean(a, now) - mean(a, rest)) - (mean(b, now) - mean(b, rest));
                MeasureValue::Vector(MILLI * (moved - line * moved.dot(line)))
            }
            Self::ReactionForce(group, held, along) => MeasureValue::Scalar(
                group.iter().zip(held).map(|(&i, &held)| (body.net_force(i as usize) * held).dot(*along)).sum(),
            ),
            Self::ReactionTorque(group, held, along) => {
                let center = mean(group, now);
                let torque: DVec3 = group
                    .iter()
                    .zip(held)
                    .map(|(&i, &held)| (now[i as usize] - center).cross(body.net_force(i as usize) * held))
                    .sum();
                MeasureValue::Scalar(torque.dot(*along))
            }
            Self::ColliderForce(collider) => {
                MeasureValue::Vector(body.collider_contact().map_or(DVec3::ZERO, |contact| contact.force_on(*collider)))
            }
            Self::Size(axis) => {
                let (least, most) =
                    now.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), x| (x[*axis].min(l), x[*axis].max(m)));
                MeasureValue::Scalar(most - least)
            }
            Self::LayerOffset => of_layers(body, |layers| layers.offset(body.state())),
            Self::Volume(_) => match matrix(body) {
                Some(matrix) => MeasureValue::Scalar(matrix.present_volume(now)),
                None => {
                    of_layers(body, |layers| layers.outer_surface.as_ref().map_or(0.0, |surface| surface.volume(now)))
                }
            },
            Self::InertiaRatio => of_layers(body, |layers| layers.inertia_ratio(body.state())),
            Self::ActivationWork => MeasureValue::Scalar(body.drive_work()),
            Self::Dissipated => MeasureValue::Scalar(body.dissipated()),
            Self::PlasticStrain => MeasureValue::Scalar(body.plastic_strain()),
            Self::Torn => MeasureValue::Scalar(body.torn()),
            Self::Stress(group, along) => {
                let yielded = body.parts().forces.iter().find_map(|force| force.downcast_ref::<Inelastic>());
                of_matrix(body, |matrix| matrix.mean_stress(group, *along, now, yielded))
            }
            Self::Strain(group, along) => of_matrix(body, |matrix| matrix.mean_strain(group, *along, now)),
            Self::Speed(group) => {
                let speeds = group.iter().map(|&i| body.state().velocities[i as usize].length());
                MeasureValue::Scalar(speeds.sum::<f64>() / group.len().max(1) as f64)
            }
            Self::PanelForce(panel) => MeasureValue::Scalar(body.panel_push(*panel)),
            Self::ContactForce(group, along) => {
                let on_it = group.iter().map(|&i| body.contact_force(i as usize, time)).sum::<DVec3>();
                MeasureValue::Scalar(-on_it.dot(*along))
            }
            Self::GreatestTension(lines) => {
                let edges = tensions(body, lines);
                MeasureValue::Scalar(edges.into_iter().reduce(f64::max).unwrap_or_default())
            }
            Self::MeanTension(lines) => {
                let edges = tensions(body, lines);
                MeasureValue::Scalar(edges.iter().sum::<f64>() / edges.len().max(1) as f64)
            }
        }
    }
}

fn matrix(body: &Body) -> Option<&MatrixForce> {
    body.parts().forces.iter().find_map(|force| force.downcast_ref())
}

/// A number of a matrix; zero where there is none.
fn of_matrix(body: &Body, read: impl Fn(&MatrixForce) -> f64) -> MeasureValue {
    MeasureValue::Scalar(matrix(body).map_or(0.0, read))
}

/// Forces in the edges of some of a body's centre lines [N].
fn tensions(body: &Body, lines: &[usize]) -> Vec<f64> {
    let all = body.tensions();
    lines.iter().filter_map(|&line| all.get(line)).flatten().copied().collect()
}

/// A number of a two-layer body; zero for others.
fn of_layers(body: &Body, read: impl Fn(&Layers) -> f64) -> MeasureValue {
    MeasureValue::Scalar(body.parts().layers.as_deref().map_or(0.0, read))
}
