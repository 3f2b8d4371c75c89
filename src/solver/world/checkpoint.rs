//! What a world goes on from: kept frame by frame, it lets a motion be looked at again and taken up anywhere.

use super::World;
use crate::solver::body::Body;
use crate::solver::body::checkpoint::BodyCheckpoint;
use crate::solver::measure::MeasureValue;

/// Everything of a world that moving changes: about 120 bytes a particle. A world that goes back to it moves on as
/// if nothing had happened since, bit for bit.
#[derive(Clone)]
pub struct Checkpoint {
    bodies: Vec<BodyCheckpoint>,
    /// Height [m] and velocity [m/s] of every panel.
    panels: Vec<[f64; 2]>,
    peaks: Vec<MeasureValue>,
    contact_current: bool,
    lifts: Vec<f64>,
    since: f64,
    frame: u64,
}

impl Checkpoint {
    /// Memory that it takes [bytes].
    pub fn bytes(&self) -> usize {
        let bodies: usize = self.bodies.iter().map(BodyCheckpoint::bytes).sum();
        let rest = size_of_val(&*self.panels) + size_of_val(&*self.peaks) + size_of_val(&*self.lifts);
        size_of_val(self) + bodies + rest
    }
}

impl World {
    /// What the world goes on from.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            bodies: self.bodies.iter().map(Body::checkpoint).collect(),
            panels: self.panels.iter().map(|panel| [panel.height, panel.velocity]).collect(),
            peaks: self.peaks.clone(),
            contact_current: self.contact_current,
            lifts: self.lifts.clone(),
            since: self.since,
            frame: self.frame,
        }
    }

    /// Back to a checkpoint of this world, or of another that was baked from the same scene.
    pub fn go_back(&mut self, to: &Checkpoint) {
        for (body, kept) in self.bodies.iter_mut().zip(&to.bodies) {
            body.go_back(kept);
        }
        for (panel, [height, velocity]) in self.panels.iter_mut().zip(&to.panels) {
            (panel.height, panel.velocity) = (*height, *velocity);
        }
        self.peaks.clone_from(&to.peaks);
        self.contact_current = to.contact_current;
        self.lifts.clone_from(&to.lifts);
        self.since = to.since;
        self.frame = to.frame;
    }

    /// Memory that the world takes [bytes], about.
    pub fn bytes(&self) -> usize {
        self.bodies.iter().map(Body::bytes).sum()
    }
}
