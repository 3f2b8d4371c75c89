//! What bodies touch: the planes of the room, and its panels.

use super::drives::drive;
use crate::scene::{PanelMotion, Scene, Sticking};
use crate::solver::drive::{After, Between, Drive, Key};
use crate::solver::forces::Plane;
use crate::solver::panel::{DrivenHeight, Panel};
use glam::{DVec2, DVec3};

/// Floor, ceiling and walls, as far as there are any.
pub(super) fn planes(scene: &Scene) -> Vec<Plane> {
    let room = &scene.room;
    let sides = [
        (room.floor, DVec3::Y),
        (room.ceiling, DVec3::NEG_Y),
        (room.x_min, DVec3::X),
        (room.x_max, DVec3::NEG_X),
        (room.z_min, DVec3::Z),
        (room.z_max, DVec3::NEG_Z),
    ];
    sides.into_iter().filter_map(|(at, normal)| at.map(|at| Plane { point: at * normal.abs(), normal })).collect()
}

/// Stiffness [N/m] of what holds a particle along a surface, as stiff as its contact is across, if anything does.
pub(super) fn holding(scene: &Scene, stiffness: f64) -> f64 {
    match scene.room.sticking {
        Sticking::Spring => stiffness,
        Sticking::Damper => 0.0,
    }
}

/// The scene's panels at the start.
pub(super) fn panels(scene: &Scene) -> Vec<Panel> {
    scene.panels.iter().map(|drawn| panel(drawn, scene.room.floor)).collect()
}

fn panel(panel: &crate::scene::Panel, floor: Option<f64>) -> Panel {
    let mut placed = Panel {
        id: panel.id.clone(),
        height: panel.height,
        velocity: 0.0,
        center: DVec2::from_array(panel.center),
        half_size: 0.5 * DVec2::from_array(panel.size),
        mass: panel.mass,
        friction: panel.friction,
        floor,
        driven: match &panel.motion {
            PanelMotion::Falls => None,
            PanelMotion::Driven(keys) => {
                let keys = keys.iter().map(|key| Key::at_rest((key.time, key.height))).collect();
                let drive = Drive::Keys { keys, between: Between::Smooth, after: After::Hold };
                Some(DrivenHeight { drive, height: 0.0, travel: 1.0 })
            }
            PanelMotion::Follows(of) => {
                Some(DrivenHeight { drive: drive(&of.drive, &[]), height: panel.height, travel: of.travel })
            }
        },
    };
    placed.follow(0.0);
    placed
}

/// The side of the room whose plane has this normal into the free side.
pub(super) fn side(normal: DVec3) -> &'static str {
    match normal.to_array() {
        [_, y, _] if y > 0.5 => "floor",
        [_, y, _] if y < -0.5 => "ceiling",
        [x, ..] if x > 0.5 => "wall x_min",
        [x, ..] if x < -0.5 => "wall x_max",
        [.., z] if z > 0.5 => "wall z_min",
        _ => "wall z_max",
    }
}
