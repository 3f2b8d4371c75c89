//! The force of all elements of a body.

use super::contract::{Change, Element};
use super::structure::{Places, Structure};
use crate::solver::drive::Drive;
use crate::solver::energy::Energies;
use crate::solver::forces::force::Force;
use crate::solver::hand::Hand;
use crate::solver::state::ParticleState;
use glam::{DQuat, DVec3};

/// What the elements of a body do together: one gather, their slopes, one scatter.
#[derive(Clone)]
pub struct ElementForce {
    structures: Vec<Structure>,
    /// Where the body is at the start, structure after structure, for [`Force::clone_at_extreme`].
    start: Vec<Places>,
    /// Last turns of the material around all points, structure after structure, the warm starts of the next.
    turns: Vec<Vec<DQuat>>,
    /// Work that drives have done up to the last booking [J].
    work: f64,
    /// When [s] that was, and where the points were.
    booked: Option<(f64, Vec<Places>)>,
    dissipated: f64,
}

impl ElementForce {
    /// Of these structures among particles that start at `positions` [m]; `orientation` is the turn of the model frame
    /// in the world there.
    pub(crate) fn new(structures: Vec<Structure>, positions: &[DVec3], orientation: DQuat) -> Self {
        let mut turns: Vec<Vec<DQuat>> = structures.iter().map(|of| vec![orientation; of.points.len()]).collect();
        let place = |(of, turns): (&Structure, &Vec<DQuat>)| of.places(positions, turns);
        let start: Vec<Places> = structures.iter().zip(&turns).map(place).collect();
        turns.iter_mut().zip(&start).for_each(|(turns, start)| turns.copy_from_slice(start.turns()));
        let mut this = Self { structures, start, turns, work: 0.0, booked: None, dissipated: 0.0 };
        this.structures.iter_mut().for_each(|of| of.follow(0.0));
        this
    }

    /// Whether any of them is driven.
    pub(crate) fn is_driven(&self) -> bool {
        self.structures.iter().any(|of| of.drive.is_some())
    }

    fn places(&self, positions: &[DVec3]) -> Vec<Places> {
        self.structures.iter().zip(&self.turns).map(|(of, turns)| of.places(positions, turns)).collect()
    }

    /// Energies [J] of the driven structures as their drives have it at a time [s], in these places.
    fn driven_energy(&self, time: f64, at: &[Places]) -> f64 {
        let driven = self.structures.iter().zip(at).filter(|(of, _)| of.drive.is_some());
        driven.map(|(of, at)| followed(of, time).energy(at)).sum()
    }
}

fn followed(of: &Structure, time: f64) -> Structure {
    let mut of = of.clone();
    of.follow(time);
    of
}

impl Force for ElementForce {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let at = self.places(&state.positions);
        for ((of, at), turns) in self.structures.iter_mut().zip(&at).zip(&mut self.turns) {
            turns.copy_from_slice(at.turns());
            of.follow(time);
            of.add_forces(at, forces);
        }
        if self.booked.is_none() && self.is_driven() {
            self.booked = Some((time, at));
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.activation -= self.work;
        for (of, turns) in self.structures.iter().zip(&self.turns) {
            let at = of.places(&state.positions, turns);
            energies.elements += if of.drive.is_some() { followed(of, time).energy(&at) } else { of.energy(&at) };
        }
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        self.structures.iter().flat_map(Structure::couplings).collect()
    }

    fn changes_until(&self) -> f64 {
        self.structures.iter().filter_map(|of| of.drive.as_ref()).map(Drive::until).fold(0.0, f64::max)
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn drive_work(&self) -> f64 {
        self.work
    }

    fn dissipated(&self) -> f64 {
        self.dissipated
    }

    fn give(&mut self, to: &str, led: Option<Hand>) {
        self.structures.iter_mut().filter_map(|of| of.drive.as_mut()).for_each(|drive| drive.give(to, led));
    }

    /// Books the work of the step: half of what the change of the drives adds to the energy where it began, half of
    /// what it adds where it ended. Then lets go what yields or breaks.
    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let at = self.places(&state.positions);
        if let (true, Some((before, was))) = (self.is_driven(), &self.booked) {
            let more = |at: &[Places]| self.driven_energy(time, at) - self.driven_energy(*before, at);
            self.work += 0.5 * (more(was) + more(&at));
        }
        let mut changed = false;
        for (of, at) in self.structures.iter_mut().zip(&at) {
            of.follow(time);
            for (kind, holds) in of.elements.iter_mut().filter(|(_, holds)| *holds) {
                let at = at.of(kind.element());
                let before = kind.energy(&at.local());
                match kind.end_step(&at.local()) {
                    Change::None => continue,
                    Change::Yielded(energy) => self.dissipated += energy,
                    Change::Broken => {
                        *holds = false;
                        self.dissipated += before;
                    }
                }
                changed = true;
            }
        }
        if self.is_driven() {
            self.booked = Some((time, at));
        }
        changed
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        self.booked = None;
        let Some(before) = before.iter().find_map(|force| force.downcast_ref::<Self>()) else {
            self.work = 0.0;
            return;
        };
        (self.work, self.dissipated) = (before.work, before.dissipated);
        // Structures over the same points are the same ones: what is broken in them stays so.
        for of in &mut self.structures {
            let same = |old: &&Structure| {
                old.id == of.id && old.points == of.points && old.elements.len() == of.elements.len()
            };
            if let Some(old) = before.structures.iter().find(same) {
                for ((kind, holds), (old, held)) in of.elements.iter_mut().zip(&old.elements) {
                    kind.adopt(old);
                    *holds = *held;
                }
            }
        }
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        for (kind, holds) in self.structures.iter().flat_map(|of| &of.elements) {
            kind.remembered(number);
            if !holds {
                number(0.0);
            }
        }
    }

    fn name(&self) -> &'static str {
        "elements"
    }

    fn bytes(&self) -> usize {
        let elements = self.structures.iter().map(|of| size_of_val(&*of.elements)).sum::<usize>();
        let turns = self.turns.iter().map(|turns| size_of_val(&**turns)).sum::<usize>();
        let booked = self.booked.iter().flat_map(|(_, at)| at).map(Places::bytes).sum::<usize>();
        size_of_val(self) + elements + turns + booked
    }

    fn clone_at_extreme(&self, greatest: bool) -> Box<dyn Force> {
        let extreme = |(of, at): (&Structure, &Places)| of.at_extreme(greatest, at);
        let structures = self.structures.iter().zip(&self.start).map(extreme).collect();
        Box::new(Self { structures, booked: None, ..self.clone() })
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
