//! Moving, turning and mirroring a fibre or some of its vertices.

use super::axis_map::{AxisMap, carried, carried_stroke};
use super::edited::{Edited, Sampling, chosen, with_vertices};
use super::error::FibreEditError;
use super::vertices::vertices;
use crate::scene::{Activation, Fibre, FibreSource, ViewStroke};
use glam::{DMat3, DQuat, DVec3};

/// A turn's entries within this of -1, 0 and 1 are taken for them: right angles come out of radians with such errors.
const ROUND_OFF: f64 = 1e-12;

/// A move, turn, mirroring or scaling of the model frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    matrix: DMat3,
    offset: DVec3,
}

impl Transform {
    /// A move by `offset` [m].
    pub fn translation(offset: DVec3) -> Self {
        Self { matrix: DMat3::IDENTITY, offset }
    }

    /// A turn about an axis of any length but zero through a pivot [m], right-handed by `radians`.
    ///
    /// # Errors
    /// An axis that points nowhere.
    pub fn rotation(pivot: DVec3, axis: DVec3, radians: f64) -> Result<Self, FibreEditError> {
        let axis = unit(axis)?;
        let matrix = exact(DMat3::from_quat(DQuat::from_axis_angle(axis, radians)));
        Ok(Self { matrix, offset: pivot - matrix * pivot })
    }

    /// A mirroring in the plane through `point` [m] across a normal of any length but zero.
    ///
    /// # Errors
    /// A normal that points nowhere.
    pub fn reflection(point: DVec3, normal: DVec3) -> Result<Self, FibreEditError> {
        let normal = unit(normal)?;
        let across = |k: usize| 2.0 * normal[k] * normal;
        let matrix = exact(DMat3::IDENTITY - DMat3::from_cols(across(0), across(1), across(2)));
        Ok(Self { matrix, offset: point - matrix * point })
    }

    /// Larger by a factor above zero about a pivot [m].
    ///
    /// # Errors
    /// A factor that leaves nothing.
    pub fn scaling(pivot: DVec3, factor: f64) -> Result<Self, FibreEditError> {
        if !(factor.is_finite() && factor > 0.0) {
            return Err(FibreEditError::NoSize(factor));
        }
        Ok(Self { matrix: DMat3::from_diagonal(DVec3::splat(factor)), offset: (1.0 - factor) * pivot })
    }

    /// Where it takes a point [m].
    pub fn apply(&self, point: DVec3) -> DVec3 {
        self.matrix * point + self.offset
    }

    /// Where it takes a direction, which a scaling makes longer.
    pub fn direction(&self, direction: DVec3) -> DVec3 {
        self.matrix * direction
    }

    /// The strokes that give what two strokes gave, at its new place; none where axes do not go to axes.
    pub(in crate::edit) fn carried(&self, strokes: [&ViewStroke; 2]) -> Option<[ViewStroke; 2]> {
        let map = self.axis_map()?;
        Some(strokes.map(|stroke| carried_stroke(stroke, &map)))
    }

    /// What becomes of how a fibre acts: the axis that it curls about turns along, and a mirroring reverses a sense of
    /// turning about an axis as well as one along the fibre.
    fn carry(&self, fibre: Fibre) -> Fibre {
        let volume = self.matrix.determinant();
        let sense = volume.signum();
        // Of a turn it is one but for round-off.
        let size = if (volume.abs() - 1.0).abs() < ROUND_OFF { 1.0 } else { volume.abs().cbrt() };
        let mut activation = fibre.activation;
        if let Some(Activation { curl, twist, .. }) = &mut activation {
            if let Some(curl) = curl {
                // Adding zero turns -0 into 0.
                curl.axis = (sense * (self.matrix * DVec3::from_array(curl.axis)) + DVec3::ZERO).to_array();
                curl.degrees_per_metre /= size;
            }
            if let Some(twist) = twist {
                twist.degrees_per_metre *= sense / size;
            }
        }
        Fibre { activation, ..fibre }
    }

    /// Where it takes the axes, if it takes axes to axes.
    pub(super) fn axis_map(&self) -> Option<AxisMap> {
        let mut map = AxisMap { to: [0; 3], factor: [0.0; 3], offset: self.offset };
        for axis in 0..3 {
            let image = self.matrix.col(axis);
            let to = image.abs().max_position();
            if image.abs() != image[to].abs() * DVec3::AXES[to] {
                return None;
            }
            (map.to[axis], map.factor[axis]) = (to, image[to]);
        }
        Some(map)
    }
}

fn unit(direction: DVec3) -> Result<DVec3, FibreEditError> {
    direction.try_normalize().ok_or(FibreEditError::NoDirection(direction.to_array()))
}

fn exact(matrix: DMat3) -> DMat3 {
    let near = |entry: f64| if (entry - entry.round()).abs() < ROUND_OFF { entry.round() } else { entry };
    DMat3::from_cols_array(&matrix.to_cols_array().map(near))
}

/// Moves, turns, mirrors or scales a fibre, with what it does by itself. A pair of strokes stays one under any move and
/// scaling, and under turns and mirrorings that take axes to axes; it becomes vertices under others.
///
/// # Errors
/// Numbers that are not finite, or strokes that give no curve.
pub fn transform(fibre: &Fibre, by: &Transform, sampling: Sampling) -> Result<Edited, FibreEditError> {
    if let (FibreSource::Strokes(pair), Some(map)) = (&fibre.source, by.axis_map()) {
        if !by.offset.is_finite() {
            return Err(FibreEditError::NotFinite { index: 0 });
        }
        let source = FibreSource::Strokes(carried(pair, &map));
        return Ok(Edited::whole(by.carry(Fibre { source, ..fibre.clone() })));
    }
    let moved: Vec<DVec3> = vertices(fibre, sampling)?.into_iter().map(|vertex| by.apply(vertex)).collect();
    let edited = with_vertices(fibre, &moved)?;
    Ok(Edited { fibre: by.carry(edited.fibre), ..edited })
}

/// Moves, turns or mirrors some vertices of a fibre; the others stay. All of them are [`transform`], and strokes stay
/// strokes where they do there.
///
/// # Errors
/// No such vertex, neighbours that would lie in one place, numbers that are not finite, or strokes that give no curve.
pub fn transform_vertices(
    fibre: &Fibre,
    indices: &[usize],
    by: &Transform,
    sampling: Sampling,
) -> Result<Edited, FibreEditError> {
    let mut vertices = vertices(fibre, sampling)?;
    let chosen = chosen(indices, vertices.len())?;
    if !chosen.contains(&false) {
        return transform(fibre, by, sampling);
    }
    if !chosen.contains(&true) {
        return Ok(Edited::whole(fibre.clone()));
    }
    for (vertex, chosen) in vertices.iter_mut().zip(chosen) {
        if chosen {
            *vertex = by.apply(*vertex);
        }
    }
    with_vertices(fibre, &vertices)
}
