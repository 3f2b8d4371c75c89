//! Drives of a scene for the solver.

use crate::scene::{self, AfterLast, DriveKeys, Interpolation, SharedDrive};
use crate::solver::drive::{After, Between, Drive, Key, Wave};
use crate::solver::forces::{Flow, FlowSurface};
use crate::solver::shared_drive;
use glam::DVec3;

/// A drive beside those that a body shares; one that names none of them does nothing.
pub(crate) fn drive(drive: &scene::Drive, shared: &[SharedDrive]) -> Drive {
    if let scene::Drive::Shared(id) = drive
        && let Some(own) = drive.resolved(shared)
    {
        return Drive::Shared { id: id.as_str().into(), own: Box::new(self::drive(own, &[])), hand: None };
    }
    match drive.resolved(shared) {
        None | Some(scene::Drive::Shared(_)) => Drive::Constant(0.0),
        Some(scene::Drive::Constant(value)) => Drive::Constant(*value),
        Some(scene::Drive::Keyframes(keys)) => keyframes(keys),
        Some(scene::Drive::Wave(wave)) => Drive::Wave(Wave {
            mean: wave.mean,
            amplitude: wave.amplitude,
            period: wave.period,
            phase: wave.phase_degrees.to_radians(),
            wavelength: wave.wavelength,
            start: wave.start,
        }),
    }
}

/// The drives that the parts of a body share.
pub(super) fn shared(drives: &[SharedDrive]) -> Vec<shared_drive::SharedDrive> {
    let of = |one: &SharedDrive| {
        let drive = drive(&scene::Drive::Shared(one.id.clone()), drives);
        shared_drive::SharedDrive { id: one.id.as_str().into(), drive }
    };
    drives.iter().map(of).collect()
}

/// What a scene's gravity is multiplied by, if anything.
pub(super) fn gravity(scene: &scene::Scene) -> Option<Drive> {
    scene.gravity_drive.as_ref().map(|of| drive(of, &[]))
}

/// Whether a scene has a wind that pushes on anything.
pub(super) fn blows(scene: &scene::Scene) -> bool {
    scene.wind.as_ref().is_some_and(|wind| wind.density * wind.drag > 0.0)
}

/// The push of a scene's wind on a surface, if there is any.
pub(super) fn wind(scene: &scene::Scene, surface: FlowSurface) -> Option<Flow> {
    let wind = scene.wind.as_ref().filter(|_| blows(scene))?;
    let velocity = DVec3::from_array(wind.velocity);
    let driven = wind.drive.as_ref().map(|of| drive(of, &[]));
    Some(Flow::new(velocity, driven, wind.density * wind.drag, surface))
}

fn keyframes(of: &DriveKeys) -> Drive {
    let keys = keys(of);
    let (Some(first), Some(last), Some(otherwise)) = (of.keys.first(), of.keys.last(), &of.otherwise) else {
        return keys;
    };
    Drive::Over {
        keys: Box::new(keys),
        begins: [first.time, of.keys.get(1).unwrap_or(first).time],
        ends: otherwise.back_in.map(|seconds| [last.time, last.time + seconds]),
        own: Box::new(drive(&otherwise.drive, &[])),
    }
}

fn keys(keys: &DriveKeys) -> Drive {
    Drive::Keys {
        keys: keys.keys.iter().map(|key| Key { time: key.time, value: key.value, slope: key.slope }).collect(),
        between: match keys.between {
            Interpolation::Stepped => Between::Stepped,
            Interpolation::Linear => Between::Linear,
            Interpolation::Smooth => Between::Smooth,
        },
        after: after(keys.after),
    }
}

/// What comes after the last.
pub(super) fn after(last: AfterLast) -> After {
    match last {
        AfterLast::Hold => After::Hold,
        AfterLast::Repeat => After::Repeat,
        AfterLast::Mirror => After::Mirror,
    }
}
