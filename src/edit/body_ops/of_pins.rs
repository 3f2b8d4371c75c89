//! What becomes of pins when their body is moved, turned or scaled: their regions are the body's, their motions the
//! world's.

use super::rigid::Rigid;
use crate::scene::{Distance, Motion, Pin};
use glam::DVec3;

/// Pins that go along with their body.
pub(super) fn carried_pins(pins: &mut [Pin], by: &Rigid) {
    for pin in pins {
        match &mut pin.motion {
            Motion::Fixed => {}
            Motion::Ramp(ramp) => ramp.direction = by.direction(ramp.direction),
            Motion::Turn(turn) => {
                turn.axis = by.direction(turn.axis);
                turn.origin = turn.origin.map(|at| by.apply(at));
            }
            Motion::Keyframes(keys) => keys.iter_mut().for_each(|key| key.offset = by.direction(key.offset)),
            Motion::Driven(driven) => {
                driven.offset = by.direction(driven.offset);
                if let Some(turn) = &mut driven.turn {
                    turn.axis = by.direction(turn.axis);
                    turn.origin = turn.origin.map(|at| by.apply(at));
                }
            }
        }
    }
}

/// Pins that move their body as far for its size as before.
pub(super) fn scaled_pins(pins: &mut [Pin], pivot: DVec3, factor: f64) {
    let far = |offset: [f64; 3]| offset.map(|part| factor * part);
    let about = |at: [f64; 3]| (pivot + factor * (DVec3::from_array(at) - pivot)).to_array();
    for pin in pins {
        match &mut pin.motion {
            Motion::Fixed => {}
            Motion::Ramp(ramp) => {
                if let Distance::Metres(distance) = &mut ramp.distance {
                    *distance *= factor;
                }
            }
            Motion::Turn(turn) => turn.origin = turn.origin.map(about),
            Motion::Keyframes(keys) => keys.iter_mut().for_each(|key| key.offset = far(key.offset)),
            Motion::Driven(driven) => {
                driven.offset = far(driven.offset);
                if let Some(turn) = &mut driven.turn {
                    turn.origin = turn.origin.map(about);
                }
            }
        }
    }
}
