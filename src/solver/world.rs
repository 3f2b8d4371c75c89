//! The simulated world: bodies and panels, advanced frame by frame.

use super::body::{Body, Divergence};
use super::measure::{MeasureValue, Quantity};
use super::panel::Panel;
use glam::DVec3;

/// How a frame is divided. Everything here is chosen from the scene when it is baked, never from timing.
#[derive(Clone, Debug, PartialEq)]
pub struct StepPlan {
    /// Simulated time of one frame [s].
    pub frame_seconds: f64,
    /// Outer steps of a frame: bodies and panels meet once in each.
    pub outer_steps: u32,
    /// Steps of each body in an outer step.
    pub substeps: Vec<u32>,
}

/// A named measure of one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Name in reports.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// What is read.
    pub quantity: Quantity,
}

/// Bodies and panels at one time.
#[derive(Clone)]
pub struct World {
    bodies: Vec<Body>,
    panels: Vec<Panel>,
    probes: Vec<Probe>,
    plan: StepPlan,
    gravity: DVec3,
    /// Time at which frame 0 began [s]; not zero after an edit.
    since: f64,
    frame: u64,
}

impl World {
    /// A world at time zero.
    pub fn new(bodies: Vec<Body>, panels: Vec<Panel>, probes: Vec<Probe>, plan: StepPlan, gravity: DVec3) -> Self {
        Self { bodies, panels, probes, plan, gravity, since: 0.0, frame: 0 }
    }

    /// The bodies in the order of the scene.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// One body, to give it another integrator or one more force.
    pub fn body_mut(&mut self, index: usize) -> Option<&mut Body> {
        self.bodies.get_mut(index)
    }

    /// The panels in the order of the scene.
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// The measures in the order of the scene.
    pub fn probes(&self) -> &[Probe] {
        &self.probes
    }

    /// How a frame is divided.
    pub fn plan(&self) -> &StepPlan {
        &self.plan
    }

    /// Frames advanced so far.
    pub fn frame(&self) -> u64 {
        self.frame
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        self.time_at(0)
    }

    /// Time of an outer step of the present frame, from whole numbers so that no rounding adds up.
    fn time_at(&self, outer: u32) -> f64 {
        self.since + (self.frame as f64 + f64::from(outer) / f64::from(self.plan.outer_steps)) * self.plan.frame_seconds
    }

    /// Takes over the motion of `before`, the same world before an edit, so that the simulation goes on: time, panels, and
    /// the state of every body that still has the same particles. The others start anew.
    pub fn adopt(&mut self, before: &Self) {
        self.since = before.time();
        self.frame = 0;
        for body in &mut self.bodies {
            if let Some(old) = before.bodies.iter().find(|old| old.parts().id == body.parts().id) {
                body.adopt(old);
            }
        }
        for panel in &mut self.panels {
            if let Some(old) = before.panels.iter().find(|old| old.id == panel.id) {
                panel.height = old.height;
                panel.velocity = old.velocity;
            }
        }
        let time = self.time();
        for body in &mut self.bodies {
            body.settle(time);
        }
    }

    /// Advances by one frame. A body that diverges stops in the state of the frame before; the others go on.
    pub fn advance_frame(&mut self) {
        for body in &mut self.bodies {
            body.checkpoint();
        }
        let outer_dt = self.plan.frame_seconds / f64::from(self.plan.outer_steps);
        for outer in 0..self.plan.outer_steps {
            let time = self.time_at(outer);
            for body in &mut self.bodies {
                body.held_mut().fill(DVec3::ZERO);
            }
            // Contact between two things is evaluated once an outer step, equal and opposite.
            for panel in &mut self.panels {
                let lift = self.bodies.iter_mut().map(|body| panel.press(body)).sum();
                panel.advance(time, outer_dt, lift, self.gravity.y);
            }
            for (body, &count) in self.bodies.iter_mut().zip(&self.plan.substeps) {
                body.kick(outer_dt);
                body.advance(time, count);
            }
        }
        self.frame += 1;
        let time = self.time();
        for body in &mut self.bodies {
            body.settle(time);
        }
    }

    /// Present values of the measures.
    pub fn measures(&self) -> Vec<MeasureValue> {
        self.probes.iter().map(|probe| probe.quantity.read(&self.bodies[probe.body])).collect()
    }

    /// The first body that was stopped, if any.
    pub fn divergence(&self) -> Option<&Divergence> {
        self.bodies.iter().find_map(Body::divergence)
    }

    /// Whether every body is at rest, every prescribed motion has ended and no panel moves.
    pub fn at_rest(&self) -> bool {
        let time = self.time();
        let still = |panel: &Panel| panel.end() <= time && panel.velocity.abs() < 1e-6;
        self.bodies.iter().all(|body| body.at_rest(time)) && self.panels.iter().all(still)
    }
}
