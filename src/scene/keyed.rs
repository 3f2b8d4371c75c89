//! Motions with a course of their own (heights, offsets, ramps, turns) as the same motion by a drive, which can be seen
//! and changed key by key.

use super::{
    Distance, DriveKeys, DrivenMotion, DrivenTurn, Easing, Interpolation, Motion, Panel, PanelDrive, PanelMotion,
};
use glam::DVec3;

/// Offsets further than this from one line, as a share of the farthest one, are on none.
const ASIDE: f64 = 1e-9;

impl Panel {
    /// The heights that it follows, as a drive: how far above its height it stands. None of one that follows no
    /// heights.
    pub fn heights_as_drive(&self) -> Option<PanelDrive> {
        let PanelMotion::Driven(heights) = &self.motion else { return None };
        let above = heights.iter().map(|key| (key.time, key.height - self.height));
        let farthest = above.clone().map(|(_, above)| above).max_by(|a, b| a.abs().total_cmp(&b.abs()));
        let travel = farthest.filter(|travel| *travel != 0.0).unwrap_or(1.0);
        Some(PanelDrive::new(DriveKeys::new(above.map(|(time, above)| (time, above / travel))), travel))
    }
}

impl Motion {
    /// The same motion by a drive; none where it stays, has a drive already, goes along no straight line, or by a share
    /// of a body's extent.
    pub fn as_driven(&self) -> Option<DrivenMotion> {
        match self {
            Self::Fixed | Self::Driven(_) => None,
            Self::Ramp(ramp) => {
                let Distance::Metres(metres) = ramp.distance else { return None };
                let offset = metres * DVec3::from_array(ramp.direction).try_normalize()?;
                Some(DrivenMotion::new(once(ramp.start, ramp.duration, ramp.easing), offset))
            }
            Self::Turn(turn) => {
                let keys = once(turn.start, turn.duration, turn.easing);
                let turned = DrivenTurn { origin: turn.origin, ..DrivenTurn::new(turn.axis, turn.degrees) };
                Some(DrivenMotion::new(keys, [0.0; 3]).with_turn(turned))
            }
            Self::Keyframes(keys) => {
                let offsets = keys.iter().map(|key| (key.time, DVec3::from_array(key.offset)));
                let lengths = offsets.clone().map(|(_, offset)| offset);
                let farthest = lengths.max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
                let square = farthest.length_squared();
                if square == 0.0 {
                    return Some(DrivenMotion::new(linear(offsets.map(|(time, _)| (time, 0.0))), farthest));
                }
                let is_on_line =
                    |offset: DVec3| offset.cross(farthest).length() <= ASIDE * square && farthest.is_finite();
                if !offsets.clone().all(|(_, offset)| is_on_line(offset)) {
                    return None;
                }
                let shares = offsets.map(|(time, offset)| (time, offset.dot(farthest) / square));
                Some(DrivenMotion::new(linear(shares), farthest))
            }
        }
    }
}

/// From 0 to 1 within a time [s].
fn once(start: f64, duration: f64, easing: Easing) -> DriveKeys {
    let between = match easing {
        Easing::Linear => Interpolation::Linear,
        Easing::Smooth => Interpolation::Smooth,
    };
    DriveKeys { between, ..DriveKeys::new([(start, 0.0), (start + duration, 1.0)]) }
}

fn linear(keys: impl IntoIterator<Item = (f64, f64)>) -> DriveKeys {
    DriveKeys { between: Interpolation::Linear, ..DriveKeys::new(keys) }
}
