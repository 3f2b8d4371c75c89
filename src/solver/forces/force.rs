//! What a force is.

use super::fibre::breaking::FibreBreak;
use crate::solver::energy::Energies;
use crate::solver::hand::Hand;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::any::Any;

/// What a force asks of the time step beyond what its linearisation at the start shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepLimit {
    /// Square of an angular frequency that may come into play later, such as a contact's [1/s²].
    pub frequency_squared: f64,
    /// Greatest rate of damping [1/s].
    pub damping_rate: f64,
}

/// A force on the particles of one body.
///
/// An implementor may keep scratch data between calls (warm starts), but the force must depend on time and state
/// alone, up to round-off, and must not depend on the number of threads.
pub trait Force: Any + Send + Sync {
    /// Adds the forces [N] at `time` [s] to `forces`, one for each particle.
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]);

    /// Adds the energy [J] that the force stores; its negative gradient is the conservative part of the force.
    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies);

    /// What the force asks of the time step beyond its linearisation at the start.
    fn step_limit(&self, _state: &ParticleState) -> StepLimit {
        StepLimit::default()
    }

    /// Groups of particles such that the force on one hangs only on the motion of itself and of those in its groups:
    /// implicit integrators ask for stiffnesses there. Without any, none hangs on another; a force that ties more than
    /// it says is still stepped rightly, but with more evaluations.
    fn couplings(&self) -> Vec<Vec<u32>> {
        Vec::new()
    }

    /// Whether it acts between the body's own particles alone: of all its forces neither sum nor moment is anything,
    /// wherever the body is.
    fn is_internal(&self) -> bool {
        false
    }

    /// Until when [s] it may change though nothing moves. One that does not say so may at any time, and its body never
    /// sleeps.
    fn changes_until(&self) -> f64 {
        f64::INFINITY
    }

    /// Until when [s] a prescribed change in time goes on; the body is not at rest before.
    fn driven_until(&self) -> f64 {
        0.0
    }

    /// Whether what it does not come from the body alone: it may give energy that no [`Self::add_energy`] tells of,
    /// though it does not change in time.
    fn does_work(&self) -> bool {
        false
    }

    /// The work that it has done on the body from outside so far [J], where it books that step by step; work of one
    /// that [`Self::does_work`] and does not is told from where the body is at the ends of frames.
    fn outside_work(&self) -> Option<f64> {
        None
    }

    /// The work that its drive has done so far [J], as it is taken from the energy `activation`.
    fn drive_work(&self) -> f64 {
        0.0
    }

    /// Has a hand lead the body's shared drive of an identifier, or none.
    fn give(&mut self, _to: &str, _led: Option<Hand>) {}

    /// What is wrong with a state, where the force has no meaning in it; the body is stopped then.
    fn fault(&self, _state: &ParticleState) -> Option<&'static str> {
        None
    }

    /// Told of the state at the end of every step, `time` [s], so that a force that breaks can do so; true if it is
    /// another force from now on.
    fn end_step(&mut self, _time: f64, _state: &ParticleState) -> bool {
        false
    }

    /// Goes on from where the forces of the same body stood before an edit, and from any time: what has broken stays
    /// broken, and nothing that was noted of the body's start counts any more. There are none where the body starts
    /// anew.
    fn adopt(&mut self, _before: &[Box<dyn Force>]) {}

    /// Energy [J] that it has lost for good so far, to yielding or viscosity; only what says so here.
    fn dissipated(&self) -> f64 {
        0.0
    }

    /// Tells every number beside positions and velocities that the motion goes on from, such as what has yielded, in a
    /// fixed order; hashes of states hold them.
    fn remembered(&self, _number: &mut dyn FnMut(f64)) {}

    /// What the force is called where forces are timed or told one by one; unless it says so, as its type is.
    fn name(&self) -> &'static str {
        let name = std::any::type_name::<Self>();
        let name = name.split('<').next().unwrap_or(name);
        name.rsplit("::").next().unwrap_or(name)
    }

    /// What has broken so far, in the order of time.
    fn breaks(&self) -> &[FibreBreak] {
        &[]
    }

    /// Memory that a copy takes beside what copies share [bytes], so that a recording of many can be bounded. By
    /// default that of the value itself; one with lists of its own adds them.
    fn bytes(&self) -> usize {
        size_of_val(self)
    }

    /// A copy that resists every move from the start as much as the force ever does, with what drives it at its
    /// greatest or at its least: what the stable step is measured with.
    fn clone_at_extreme(&self, _greatest: bool) -> Box<dyn Force> {
        self.clone_box()
    }

    /// A copy in a box; bodies are cloned to be replayed or probed. It gives the same forces from here on, bit for bit:
    /// warm starts go along, buffers need not (see `crate::solver::scratch::Scratch`).
    fn clone_box(&self) -> Box<dyn Force>;
}

impl dyn Force {
    /// The force itself where it is a `T`, so that what only a `T` knows can be asked of it.
    pub fn downcast_ref<T: Force>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }

    /// [`Self::downcast_ref`], to change it.
    pub(crate) fn downcast_mut<T: Force>(&mut self) -> Option<&mut T> {
        (self as &mut dyn Any).downcast_mut()
    }
}

impl Clone for Box<dyn Force> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}

/// The sum of all forces [N] at time zero, one for each particle.
pub(crate) fn total_forces(forces: &mut [Box<dyn Force>], state: &ParticleState) -> Vec<DVec3> {
    let mut sum = vec![DVec3::ZERO; state.len()];
    for force in forces {
        force.add_forces(0.0, state, &mut sum);
    }
    sum
}
