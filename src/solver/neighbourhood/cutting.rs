//! Neighbourhoods that come apart, bond by bond.

use super::{Neighbourhood, RestBond, outer};
use glam::{DMat3, DVec3};

impl Neighbourhood {
    /// The neighbourhoods of some particles alone, in ascending order, such that their bonds can be cut: the others
    /// have none.
    pub(in crate::solver) fn only(&self, particles: &[u32]) -> Self {
        let mut this = Self {
            lattice: self.lattice.clone(),
            is_cut: self.is_cut,
            starts: Vec::with_capacity(self.starts.len()),
            neighbours: Vec::new(),
            bonds: Vec::new(),
            palette: self.palette.clone(),
            offsets: self.offsets.clone(),
            inverse_moment: self.inverse_moment.clone(),
            weighted_sum: self.weighted_sum.clone(),
            weight_sum: self.weight_sum.clone(),
        };
        // What a cut bond is: one of no weight.
        this.palette.push(RestBond { weighted_offset: DVec3::ZERO, weight: 0.0 });
        this.offsets.push(DVec3::ZERO);
        let mut wanted = particles.iter().peekable();
        this.starts.push(0);
        for i in 0..self.len() {
            if wanted.next_if(|&&next| next as usize == i).is_some() {
                this.neighbours.extend(&self.neighbours[self.range(i)]);
                this.bonds.extend(&self.bonds[self.range(i)]);
            }
            this.starts.push(this.neighbours.len() as u32);
        }
        this
    }

    /// The bond at a place of the lists, cut or not.
    pub(in crate::solver) fn bond(&self, place: usize) -> &RestBond {
        &self.palette[self.bonds[place] as usize]
    }

    /// Particle `i`'s place in the lists for neighbour `j`, if they are neighbours.
    pub(in crate::solver) fn place(&self, i: usize, j: usize) -> Option<usize> {
        let range = self.range(i);
        let among = &self.neighbours[range.clone()];
        among.binary_search(&(j as u32)).ok().map(|k| range.start + k)
    }

    /// Cuts the bonds at these places of the lists, all of particle `i`, of one that was made by [`Self::only`]; gives
    /// what puts them back. What follows from the rest shape is that of the bonds that are left, of which there must be
    /// enough to span space.
    pub(in crate::solver) fn cut(&mut self, i: usize, places: &[usize]) -> Vec<(usize, u32)> {
        let nothing = self.palette.len() as u32 - 1;
        let were = places.iter().map(|&place| (place, self.bonds[place])).collect();
        for &place in places {
            self.bonds[place] = nothing;
        }
        self.take_moments(i);
        were
    }

    /// Puts bonds of particle `i` back as they were before a cut.
    pub(in crate::solver) fn mend(&mut self, i: usize, were: &[(usize, u32)]) {
        for &(place, bond) in were {
            self.bonds[place] = bond;
        }
        self.take_moments(i);
    }

    fn take_moments(&mut self, i: usize) {
        let (mut moment, mut sum, mut weight) = (DMat3::ZERO, DVec3::ZERO, 0.0);
        for k in self.range(i) {
            let (bond, offset) = (self.palette[self.bonds[k] as usize], self.offsets[self.bonds[k] as usize]);
            moment += outer(bond.weighted_offset, offset);
            sum += bond.weighted_offset;
            weight += bond.weight;
        }
        let inverse = (0.5 * (moment + moment.transpose())).inverse();
        self.inverse_moment[i] = 0.5 * (inverse + inverse.transpose());
        self.weighted_sum[i] = sum;
        self.weight_sum[i] = weight;
    }
}
