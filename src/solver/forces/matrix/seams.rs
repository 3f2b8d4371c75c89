//! The matrix beside seams, which comes apart bond by bond.
//!
//! Particles that feel others across a seam are taken out of the stencil, in which their share of the energy is
//! nothing, and computed here pair by pair from neighbourhoods of their own. So a body without seams knows nothing of
//! them, and one with seams pays for the particles beside them alone, as much before they tear as after.
//!
//! A bond that is longer than so many times its length at rest is cut at the end of the step, at both ends: it no
//! longer has a weight, and A, B and n of both particles (the module's head) are those of the bonds that are left. So
//! a linear deformation is still computed exactly, forces are still pairwise equal and opposite, and the energy is
//! that of a body which was cut there from the start. What was stored less than before is released, and booked.
//!
//! Tearing never gives energy. A particle that no longer hears of a bond takes the strain of those that are left, which
//! may be the greater one: where bonds past their length would have more stored once they are torn, they hold on until
//! they are drawn further. They all do at last, as what they store grows with the square of the gap.
//!
//! Neighbourhoods with all bonds across the seams cut are looked at before the body is put together. Those with fewer
//! cut span space all the more: A is a sum over bonds.

use super::partial::PartialMatrix;
use super::reference::ReferenceConfiguration;
use crate::solver::state::ParticleState;
use glam::{DQuat, DVec3};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The bonds across one seam.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SeamBonds {
    /// Length over that at rest past which one tears.
    pub(crate) stretch: f64,
    /// Particles at both ends of every bond.
    pub(crate) pairs: Vec<[u32; 2]>,
}

/// What has become of a seam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeamTear {
    /// Bonds across it.
    pub bonds: usize,
    /// How many of them are torn.
    pub torn: usize,
    /// When the first one tore [s].
    pub first: Option<f64>,
}

/// The matrix at the particles beside seams.
#[derive(Clone)]
pub(super) struct Seams {
    fixed: Arc<Beside>,
    /// The material with the bonds that are left.
    left: ReferenceConfiguration,
    /// Which bonds are torn, seam after seam.
    torn: Arc<Vec<bool>>,
    tears: Vec<SeamTear>,
    /// Energy that was released [J].
    pub(super) released: f64,
    /// Of the particles that feel others across a seam.
    matrix: PartialMatrix,
}

/// Share of the energy around bonds under which what they would take is rounding.
const NOTHING: f64 = 1e-12;

/// What never changes.
struct Beside {
    seams: Vec<SeamBonds>,
    /// Bonds of all seams, one after another.
    bonds: Vec<Bond>,
}

/// A bond across a seam.
struct Bond {
    ends: [u32; 2],
    /// Its places in the lists of both.
    places: [usize; 2],
    /// Square of the length past which it tears [m²].
    longest_squared: f64,
    seam: usize,
}

impl Seams {
    /// Those of a matrix over `reference`, of a body that starts turned by `orientation`.
    pub(super) fn new(reference: &ReferenceConfiguration, seams: Vec<SeamBonds>, orientation: DQuat) -> Self {
        let mut particles: Vec<u32> = seams.iter().flat_map(|seam| seam.pairs.iter().flatten().copied()).collect();
        particles.sort_unstable();
        particles.dedup();
        let neighbourhood = reference.neighbourhood.only(&particles);
        let bond = |seam: usize, stretch: f64, [i, j]: [u32; 2]| {
            let place = |i: u32, j: u32| neighbourhood.place(i as usize, j as usize);
            let length = reference.positions[i as usize].distance(reference.positions[j as usize]);
            let places = [place(i, j)?, place(j, i)?];
            Some(Bond { ends: [i, j], places, longest_squared: (stretch * length).powi(2), seam })
        };
        let bonds: Vec<Bond> = seams
            .iter()
            .enumerate()
            .flat_map(|(k, seam)| seam.pairs.iter().filter_map(move |&pair| bond(k, seam.stretch, pair)))
            .collect();
        let tears = seams.iter().map(|seam| SeamTear { bonds: seam.pairs.len(), torn: 0, first: None }).collect();
        Self {
            matrix: PartialMatrix::new(&neighbourhood, &particles, orientation),
            left: ReferenceConfiguration { neighbourhood: Arc::new(neighbourhood), ..reference.clone() },
            torn: Arc::new(vec![false; bonds.len()]),
            tears,
            released: 0.0,
            fixed: Arc::new(Beside { seams, bonds }),
        }
    }

    /// What is left of a reference configuration without these particles: they have no share in it.
    pub(super) fn others(&self, reference: &ReferenceConfiguration) -> ReferenceConfiguration {
        let mut weights = reference.matrix_weight.to_vec();
        for &i in self.matrix.particles() {
            weights[i as usize] = 0.0;
        }
        ReferenceConfiguration { matrix_weight: weights.into(), ..reference.clone() }
    }

    /// The place of a particle among those beside seams, if it is one.
    fn place(&self, i: usize) -> Option<usize> {
        self.matrix.particles().binary_search(&(i as u32)).ok()
    }

    /// The material by which a particle is computed, if it is one of these.
    pub(super) fn reference_of(&self, i: usize) -> Option<&ReferenceConfiguration> {
        self.place(i).map(|_| &self.left)
    }

    /// Rotation of a particle at the last evaluation, if it is one of these.
    pub(super) fn rotation(&self, i: usize) -> Option<DQuat> {
        self.place(i).map(|place| self.matrix.rotations[place])
    }

    /// What has become of each seam.
    pub(super) fn tears(&self) -> &[SeamTear] {
        &self.tears
    }

    /// Which bonds are torn, seam after seam as they were given.
    pub(super) fn torn(&self) -> &[bool] {
        &self.torn
    }

    /// Memory of what a copy does not share [bytes].
    pub(super) fn bytes(&self) -> usize {
        let is_torn = self.tears.iter().any(|tear| tear.torn > 0);
        let own = if is_torn { self.left.neighbourhood.bytes() + size_of_val(&**self.torn) } else { 0 };
        size_of_val(self) + size_of_val(&*self.matrix.rotations) + own
    }

    /// The same with every bond torn.
    pub(super) fn all_torn(&self) -> Self {
        let mut torn = self.clone();
        torn.tear(&(0..self.fixed.bonds.len()).collect::<Vec<_>>(), 0.0);
        torn
    }

    pub(super) fn add_forces(&mut self, positions: &[DVec3], forces: &mut [DVec3]) {
        let weights = &self.left.matrix_weight;
        self.matrix.add_forces(&self.left, |_, i| weights[i as usize], positions, forces);
    }

    /// Elastic and zero-energy energy [J] of a particle, if it is one of these.
    pub(super) fn energy(&self, i: usize, positions: &[DVec3]) -> Option<(f64, f64)> {
        self.place(i).map(|place| self.left.energy(i, positions, self.matrix.rotations[place]))
    }

    /// Tears the bonds that are too long at the end of a step at `time` [s]; true if there are any.
    pub(super) fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        let (positions, bonds, torn) = (&state.positions, &self.fixed.bonds, &self.torn);
        let is_too_long = |&k: &usize| {
            let Bond { ends: [i, j], longest_squared, .. } = bonds[k];
            !torn[k] && positions[i as usize].distance_squared(positions[j as usize]) > longest_squared
        };
        let mut parted: Vec<usize> = (0..bonds.len()).into_par_iter().with_min_len(1024).filter(is_too_long).collect();
        if parted.is_empty() {
            return false;
        }
        let mut released = self.released_by(&parted, positions);
        if released.is_none() {
            // Those that would by themselves, if together they do.
            parted.retain(|&k| self.released_by(&[k], positions).is_some());
            released = self.released_by(&parted, positions);
        }
        if let Some(released) = released.filter(|_| !parted.is_empty()) {
            self.tear(&parted, time);
            self.released += released;
        }
        released.is_some() && !parted.is_empty()
    }

    /// The energy that is released where some bonds tear [J]; none where it would take any.
    fn released_by(&mut self, parted: &[usize], positions: &[DVec3]) -> Option<f64> {
        let cuts = self.cuts(parted);
        let stored = |this: &Self| -> f64 {
            let of = |i: u32| this.energy(i as usize, positions).map_or(0.0, |(elastic, zero)| elastic + zero);
            cuts.iter().map(|(i, _)| of(*i)).sum()
        };
        let before = stored(self);
        let neighbourhood = Arc::make_mut(&mut self.left.neighbourhood);
        let were: Vec<_> = cuts.iter().map(|(i, places)| neighbourhood.cut(*i as usize, places)).collect();
        let after = stored(self);
        let neighbourhood = Arc::make_mut(&mut self.left.neighbourhood);
        for ((i, _), were) in cuts.iter().zip(&were) {
            neighbourhood.mend(*i as usize, were);
        }
        (after - before <= NOTHING * before).then_some(before - after)
    }

    /// Particles at the ends of some bonds, in ascending order, with the places of the bonds in their lists.
    fn cuts(&self, parted: &[usize]) -> Vec<(u32, Vec<usize>)> {
        let mut cuts: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for &k in parted {
            let Bond { ends, places, .. } = self.fixed.bonds[k];
            for (end, place) in ends.into_iter().zip(places) {
                cuts.entry(end).or_default().push(place);
            }
        }
        cuts.into_iter().collect()
    }

    /// Tears bonds by their numbers.
    fn tear(&mut self, parted: &[usize], time: f64) {
        let torn = Arc::make_mut(&mut self.torn);
        for &k in parted {
            torn[k] = true;
            let tear = &mut self.tears[self.fixed.bonds[k].seam];
            tear.torn += 1;
            tear.first.get_or_insert(time);
        }
        let cuts = self.cuts(parted);
        let neighbourhood = Arc::make_mut(&mut self.left.neighbourhood);
        for (i, places) in cuts {
            neighbourhood.cut(i as usize, &places);
        }
    }

    /// Goes on with what is torn of the seams of `before` an edit: of those along the same bonds, whatever they tear
    /// past now; one that was moved is whole.
    pub(super) fn adopt(&mut self, before: &Self) {
        let first = |of: &Self, seam: usize| of.fixed.bonds.partition_point(|bond| bond.seam < seam);
        let mut times: Vec<(usize, Option<f64>)> = Vec::new();
        let mut parted = Vec::new();
        for (now, seam) in self.fixed.seams.iter().enumerate() {
            let same = |old: &SeamBonds| old.pairs == seam.pairs;
            let Some(was) = before.fixed.seams.iter().position(same) else { continue };
            let (here, there) = (first(self, now), first(before, was));
            let count = first(self, now + 1) - here;
            parted.extend((0..count).filter(|k| before.torn[there + k]).map(|k| here + k));
            times.push((now, before.tears[was].first));
        }
        if !parted.is_empty() {
            self.tear(&parted, 0.0);
        }
        for (seam, time) in times {
            self.tears[seam].first = time;
        }
        self.released = before.released;
    }
}
