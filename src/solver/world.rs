//! The simulated world: bodies and panels, advanced frame by frame.
//!
//! What acts within a body, its contact with the room and the grabs are forces of the body's own and evaluated in each
//! of its steps. Contact between two bodies ([`super::body_contact`]) and between a body and a panel ([`super::panel`])
//! belongs to a pair and is no force of either: it is evaluated here at the ends of every outer step, both sides of a
//! pair together, and given as impulses, half of an outer step's before the bodies' own steps and half after them. Its
//! energy is among the bodies' energies of contact.

mod asleep;
mod checkpoint;
mod eased;
mod grips;
mod hands;
mod measured;
mod probe;
mod starts;
mod totals;
mod watch;
mod watched;
mod work;

pub use checkpoint::Checkpoint;
pub use probe::Probe;
pub use watched::{Accuracy, MOST_GAINED};

use eased::Eased;
use grips::Grips;
use watched::Watch;
use work::OutsideWork;

use super::body::{Body, Divergence};
use super::body_contact::{Allowance, add_body_contact};
use super::collider::Collider;
use super::forces::Gravity;
use super::measure::MeasureValue;
use super::overlap::Overlap;
use super::panel::Panel;
use glam::DVec3;
use std::sync::Arc;

/// How a frame is divided. Everything here is chosen from the scene when it is baked, never from timing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StepPlan {
    /// Simulated time of one frame [s].
    pub frame_seconds: f64,
    /// Outer steps of a frame: contact between bodies and with panels is evaluated once in each.
    pub outer_steps: u32,
    /// Steps of each body in an outer step.
    pub substeps: Vec<u32>,
}

/// Bodies and panels at one time.
#[derive(Clone)]
pub struct World {
    bodies: Vec<Body>,
    panels: Vec<Panel>,
    /// Bodies touch them on their own.
    colliders: Arc<[Collider]>,
    probes: Vec<Probe>,
    /// Greatest value of every probe so far, by magnitude, with its sign.
    peaks: Vec<MeasureValue>,
    plan: StepPlan,
    gravity: Gravity,
    /// What overlapped when the motion began.
    overlaps: Vec<Overlap>,
    /// What of that the world eases apart; bodies are eased out of the room on their own.
    eased: Eased,
    /// What bodies hold on to.
    grips: Grips,
    /// Whether the forces between bodies and panels are those of the present state.
    contact_current: bool,
    /// Force on every panel from below [N].
    panel_pushes: Vec<f64>,
    work: OutsideWork,
    watch: Watch,
    /// Time at which frame 0 began [s]; not zero after an edit.
    since: f64,
    frame: u64,
}

impl World {
    /// A world at time zero.
    pub(crate) fn new(
        bodies: Vec<Body>,
        (panels, colliders): (Vec<Panel>, Arc<[Collider]>),
        probes: Vec<Probe>,
        plan: StepPlan,
        gravity: Gravity,
    ) -> Self {
        let mut world = Self {
            panel_pushes: vec![0.0; panels.len()],
            bodies,
            panels,
            colliders,
            probes,
            peaks: Vec::new(),
            plan,
            gravity,
            overlaps: Vec::new(),
            eased: Eased::default(),
            grips: Grips::default(),
            contact_current: false,
            work: OutsideWork::default(),
            watch: Watch::default(),
            since: 0.0,
            frame: 0,
        };
        world.ease_apart(None);
        world.peaks = world.measures();
        world
    }

    /// What overlapped when the motion began, and how it is eased apart.
    pub fn overlaps(&self) -> &[Overlap] {
        &self.overlaps
    }

    /// The bodies in the order of the scene.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// Opposite corners of the box around all bodies where they were put, undeformed [m]; none without a body.
    pub(crate) fn placed(&self) -> Option<[DVec3; 2]> {
        let rest = self.bodies.iter().flat_map(|body| body.parts().rest.iter().copied());
        rest.map(|point| [point; 2]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    }

    /// One body, to give it another integrator or one more force.
    pub fn body_mut(&mut self, index: usize) -> Option<&mut Body> {
        self.contact_current = false;
        self.bodies.get_mut(index)
    }

    /// The panels in the order of the scene.
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// The colliders in the order of the scene.
    pub fn colliders(&self) -> &[Collider] {
        &self.colliders
    }

    /// Force of all bodies on a collider [N].
    pub fn force_on_collider(&self, collider: usize) -> DVec3 {
        self.bodies.iter().filter_map(Body::collider_contact).map(|contact| contact.force_on(collider)).sum()
    }

    /// Work that a collider has done on all bodies so far [J].
    pub fn work_of_collider(&self, collider: usize) -> f64 {
        self.bodies.iter().filter_map(Body::collider_contact).map(|contact| contact.work_of(collider)).sum()
    }

    /// Gravity as it is now [m/s²].
    pub(crate) fn gravity(&self) -> DVec3 {
        self.gravity.at(self.time())
    }

    /// Force on a panel from below [N], by its index; zero where there is no such panel.
    pub fn panel_force(&self, panel: usize) -> f64 {
        self.panel_pushes.get(panel).copied().unwrap_or_default()
    }

    /// The measures in the order of the scene.
    pub fn probes(&self) -> &[Probe] {
        &self.probes
    }

    /// How a frame is divided.
    pub(crate) fn plan(&self) -> &StepPlan {
        &self.plan
    }

    /// Makes every frame one step of `dt` [s] from now on, which the bodies must take too, and measures nothing more.
    pub(crate) fn step_singly(&mut self, dt: f64) {
        self.probes.clear();
        self.peaks.clear();
        self.plan = StepPlan { frame_seconds: dt, outer_steps: 1, substeps: vec![1; self.bodies.len()] };
    }

    /// Frames advanced so far.
    pub fn frame(&self) -> u64 {
        self.frame
    }

    /// Number of the present frame as its time counts them: on through edits, at which [`World::frame`] begins anew.
    pub(crate) fn number(&self) -> u64 {
        (self.time() / self.plan.frame_seconds).round().max(0.0) as u64
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        self.time_at(0)
    }

    /// Time of an outer step of the present frame, from whole numbers so that no rounding adds up.
    fn time_at(&self, outer: u32) -> f64 {
        self.since + (self.frame as f64 + f64::from(outer) / f64::from(self.plan.outer_steps)) * self.plan.frame_seconds
    }

    /// Takes over the motion of `before`, the same world before an edit, so that the simulation goes on: time, panels,
    /// and the state of every body that still has the same particles. The others start anew.
    pub(crate) fn adopt(&mut self, before: &Self) {
        self.since = before.time();
        self.frame = 0;
        self.contact_current = false;
        let mut goes_on = vec![None; self.bodies.len()];
        for (body, goes_on) in self.bodies.iter_mut().zip(&mut goes_on) {
            let old = before.bodies.iter().position(|old| old.parts().id == body.parts().id);
            *goes_on = old.filter(|&old| body.adopt(&before.bodies[old], before.time()));
            if goes_on.is_none() {
                body.start_late();
            }
        }
        self.work = before.work.taken_on(&goes_on);
        self.watch = Watch::default();
        for panel in &mut self.panels {
            if let Some(old) = before.panels.iter().find(|old| old.id == panel.id) {
                panel.height = old.height;
                panel.velocity = old.velocity;
            }
            panel.follow(before.time());
        }
        let panel = |old: usize| self.panels.iter().position(|panel| panel.id == before.panels[old].id);
        self.grips = before.grips.renumbered(|old| goes_on.iter().position(|&was| was == Some(old)), panel);
        self.ease_apart(Some((before, &goes_on)));
        let time = self.time();
        for body in &mut self.bodies {
            body.update_net_forces(time);
        }
        self.peaks = self.measures();
    }

    /// Evaluates the contact between bodies and with panels at `time` [s], `dt` [s] after it last was: each pair of
    /// things together, equal and opposite.
    fn evaluate_contact(&mut self, time: f64, dt: f64) {
        for body in &mut self.bodies {
            body.clear_external_forces();
        }
        for first in 0..self.bodies.len() {
            let (before, after) = self.bodies.split_at_mut(first + 1);
            let a = &mut before[first];
            for (b, second) in after.iter_mut().zip(first + 1..) {
                let mut allowance = Allowance::default();
                if let Some(pair) = self.eased.pair(first, second) {
                    allowance = pair.allowance(time);
                    let kept = 0.5 * pair.easing.energy_at(time);
                    a.add_contact_energy(kept);
                    b.add_contact_energy(kept);
                }
                self.grips.of_pair([first, second], |grip| add_body_contact(a, b, &allowance, grip, dt));
            }
        }
        for (index, (push, panel)) in self.panel_pushes.iter_mut().zip(&self.panels).enumerate() {
            let bodies = self.bodies.iter_mut().enumerate();
            let (eased, grips) = (&self.eased, &mut self.grips);
            let pushes = bodies.map(|(body, of)| {
                let eased = eased.panel(body, index);
                let push = grips.of_panel([body, index], |grip| panel.add_contact(of, eased, grip, time));
                of.add_panel_push(push);
                push
            });
            *push = pushes.sum();
        }
        self.contact_current = true;
    }

    /// Half a kick by the forces between bodies and panels over an outer step of `dt` [s].
    fn half_kick(&mut self, time: f64, dt: f64, asleep: &[bool]) {
        for (body, _) in self.bodies.iter_mut().zip(asleep).filter(|(_, asleep)| !**asleep) {
            body.kick(0.5 * dt);
        }
        for (panel, &push) in self.panels.iter_mut().zip(&self.panel_pushes) {
            panel.kick(0.5 * dt, push, self.gravity.at(time).y);
        }
    }

    /// Advances by one frame. A body that diverges stops in the state of the frame before; the others go on. Bodies at
    /// rest that nothing comes near take no steps.
    pub fn advance_frame(&mut self) {
        self.advance_frame_unless(&|| false);
    }

    /// [`Self::advance_frame`] unless `stop`, asked before every step, says that the frame is no longer wanted: false
    /// then, and the world has to go back to a checkpoint.
    pub(crate) fn advance_frame_unless(&mut self, stop: &dyn Fn() -> bool) -> bool {
        let asleep = self.asleep();
        if !asleep.contains(&false) && !asleep.is_empty() {
            self.frame += 1;
            return true;
        }
        if !self.contact_current {
            self.bodies.iter_mut().for_each(Body::begin_outer_step);
            self.evaluate_contact(self.time(), 0.0);
        }
        self.work.begin(&self.bodies, (&self.panels, &self.panel_pushes), self.time());
        self.begin_watch();
        for body in &mut self.bodies {
            body.save_last_good();
        }
        let outer_dt = self.plan.frame_seconds / f64::from(self.plan.outer_steps);
        for outer in 0..self.plan.outer_steps {
            let time = self.time_at(outer);
            // Kick, drift, kick around the bodies' own steps: what rests under a load shows no velocity, and the
            // contact takes no energy.
            self.half_kick(time, outer_dt, &asleep);
            self.bodies.iter_mut().for_each(Body::begin_outer_step);
            for panel in &mut self.panels {
                panel.drift(time, outer_dt);
            }
            for (index, (body, &count)) in self.bodies.iter_mut().zip(&self.plan.substeps).enumerate() {
                if asleep[index] {
                    continue;
                }
                // Bodies that take turns many times in a frame would fill a trace with their steps.
                let whole = self.plan.outer_steps == 1;
                let _body = whole.then(|| tracing::info_span!("body", name = body.parts().name).entered());
                let (probes, peaks, work) = (&self.probes, &mut self.peaks, &mut self.work);
                let is_whole = body.advance(time, count, stop, &mut |body, time| {
                    work.add_held(index, body);
                    for (probe, peak) in probes.iter().zip(peaks.iter_mut()) {
                        if probe.peak && probe.body == index && (body.is_current() || !probe.quantity.needs_forces()) {
                            probe.raise(peak, body, time);
                        }
                    }
                });
                if !is_whole {
                    return false;
                }
            }
            let end = self.time_at(outer + 1);
            self.evaluate_contact(end, outer_dt);
            self.work.add_panels(&self.panels, &self.panel_pushes);
            self.half_kick(end, outer_dt, &asleep);
        }
        self.frame += 1;
        let time = self.time();
        for body in &mut self.bodies {
            body.update_net_forces(time);
        }
        self.bodies.iter_mut().for_each(Body::see_tears);
        self.work.end(&self.bodies, time);
        self.end_watch();
        for (probe, peak) in self.probes.iter().zip(&mut self.peaks) {
            if probe.peak {
                probe.raise(peak, &self.bodies[probe.body], time);
            }
        }
        true
    }

    /// The first body that was stopped, if any.
    pub fn divergence(&self) -> Option<&Divergence> {
        self.bodies.iter().find_map(Body::divergence)
    }

    /// What the world goes on from.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            bodies: self.bodies.iter().map(Body::checkpoint).collect(),
            panels: self.panels.iter().map(|panel| [panel.height, panel.velocity]).collect(),
            peaks: self.peaks.clone(),
            contact_current: self.contact_current,
            panel_pushes: self.panel_pushes.clone(),
            work: self.work.done(),
            watch: self.watch.clone(),
            eased: self.eased.clone(),
            grips: self.grips.clone(),
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
        self.panel_pushes.clone_from(&to.panel_pushes);
        self.work = OutsideWork::from_here_on(to.work.clone());
        self.watch.clone_from(&to.watch);
        self.eased.clone_from(&to.eased);
        self.grips.clone_from(&to.grips);
        self.since = to.since;
        self.frame = to.frame;
    }
}
