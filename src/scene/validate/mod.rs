//! Validation: every number in range, every reference resolved, one clear error at the first that is not.
//!
//! The document's types say what a value may look like; the checks here say what it may be. They are ordered as
//! the fields of a scene file, so that the first error is the first one a reader meets.

mod bodies;
mod check;
mod collider;
mod drives;
mod elements;
mod error;
mod follows;
mod lines;
mod measure;
mod paint;
mod parts;
mod sheets;
mod solid;
mod two_layer;
mod voids;

pub use error::SceneError;
pub(crate) use error::{brief, one_line};

use super::{Automatic, Manual, Panel, PanelDrive, PanelMotion, Room, SCENE_VERSION, Scene, Time, TimeStep, Wind};
use check::{
    At, Checked, Ids, finite, fraction, increasing, not_negative, number, ordered, positive, require, vector, within,
};

/// Longest simulated time a scene may ask for [s], eleven days.
const LONGEST: f64 = 1e6;

/// Greatest frame rate [1/s]; beyond it a frame is shorter than any useful step.
const FASTEST: f64 = 1e5;

/// Most steps to a frame that are given by hand: nothing would be seen to happen.
const MOST_STEPS: u32 = 1_000_000;

impl Scene {
    /// Checks every value and reference.
    ///
    /// # Errors
    /// The first value that is out of range or refers to nothing.
    pub fn validate(&self) -> Result<(), SceneError> {
        let root = At::ROOT;
        require(
            &root.field("version"),
            &self.version,
            self.version == SCENE_VERSION,
            "is not a known version",
            || format!("give {SCENE_VERSION}"),
        )?;
        vector(&root.field("gravity"), &self.gravity, "m/s²")?;
        if let Some(drive) = &self.gravity_drive {
            drives::of_scene(&root.field("gravity_drive"), drive)?;
        }
        if let Some(of) = &self.wind {
            wind(&root.field("wind"), of)?;
        }
        room(&root.field("room"), &self.room)?;
        panels(&root.field("panels"), &self.panels)?;
        collider::colliders(&root.field("colliders"), &self.colliders)?;
        time(&root.field("time"), &self.time)?;
        let bodies = bodies::bodies(&root, self)?;
        measure::measures(&root.field("measures"), self, &bodies)
    }
}

fn wind(at: &At<'_>, wind: &Wind) -> Checked {
    vector(&at.field("velocity"), &wind.velocity, "m/s")?;
    if let Some(drive) = &wind.drive {
        drives::of_scene(&at.field("drive"), drive)?;
    }
    not_negative(&at.field("density"), wind.density, "kg/m³")?;
    not_negative(&at.field("drag"), wind.drag, "")
}

fn room(at: &At<'_>, room: &Room) -> Checked {
    let pairs = [
        (("floor", room.floor), ("ceiling", room.ceiling)),
        (("x_min", room.x_min), ("x_max", room.x_max)),
        (("z_min", room.z_min), ("z_max", room.z_max)),
    ];
    for (low, high) in pairs {
        for (name, coordinate) in [low, high] {
            coordinate.map_or(Ok(()), |value| finite(&at.field(name), value, "m"))?;
        }
        if let (Some(least), Some(greatest)) = (low.1, high.1) {
            ordered(&at.field(high.0), least, greatest, &format!("{} ({} m)", low.0, number(least)))?;
        }
    }
    not_negative(&at.field("friction"), room.friction, "")?;
    fraction(&at.field("contact_damping"), room.contact_damping)
}

fn panels(at: &At<'_>, panels: &[Panel]) -> Checked {
    let mut ids = Ids::of("panel");
    for (index, panel) in panels.iter().enumerate() {
        let at = at.item(index);
        ids.add(&at.field("id"), &panel.id)?;
        finite(&at.field("height"), panel.height, "m")?;
        vector(&at.field("center"), &panel.center, "m")?;
        for (axis, &size) in panel.size.iter().enumerate() {
            positive(&at.field("size").item(axis), size, "m")?;
        }
        positive(&at.field("mass"), panel.mass, "kg")?;
        not_negative(&at.field("friction"), panel.friction, "")?;
        let at = at.field("motion");
        match &panel.motion {
            PanelMotion::Falls => {}
            PanelMotion::Driven(keys) => {
                let at = at.field("driven");
                increasing(&at, keys.iter().map(|key| key.time))?;
                for (index, key) in keys.iter().enumerate() {
                    finite(&at.item(index).field("height"), key.height, "m")?;
                }
            }
            PanelMotion::Follows(PanelDrive { drive, travel, .. }) => {
                let at = at.field("follows");
                drives::of_scene(&at.field("drive"), drive)?;
                finite(&at.field("travel"), *travel, "m")?;
            }
        }
    }
    Ok(())
}

fn time(at: &At<'_>, time: &Time) -> Checked {
    let rate = at.field("frames_per_second");
    positive(&rate, time.frames_per_second, "frames a second")?;
    within(&rate, time.frames_per_second, 0.0, FASTEST, "frames a second")?;
    within(&at.field("duration"), time.duration, 0.0, LONGEST, "s")?;
    let at = at.field("step");
    match &time.step {
        TimeStep::Automatic(Automatic { safety, .. }) => {
            let at = at.field("automatic");
            positive(&at.field("safety"), *safety, "")?;
            fraction(&at.field("safety"), *safety)
        }
        TimeStep::Manual(Manual { dt, substeps_per_frame, .. }) => {
            let at = at.field("manual");
            positive(&at.field("dt"), *dt, "s")?;
            let count = at.field("substeps_per_frame");
            require(&count, substeps_per_frame, *substeps_per_frame >= 1, "takes no step at all", || "give 1 or more")?;
            let few = *substeps_per_frame <= MOST_STEPS;
            require(&count, substeps_per_frame, few, "are more steps to a frame than anybody can wait for", || {
                format!("give {MOST_STEPS} or fewer")
            })
        }
    }
}
