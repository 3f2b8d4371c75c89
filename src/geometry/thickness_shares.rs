//! Shares of the matter of a solid by how thick it is.

use glam::DVec3;

/// Thicknesses of a solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Thickness {
    /// Thickness [m], the nearest place of the surface, and the share of the matter that is no thicker; in rising
    /// order.
    places: Vec<(f64, DVec3, f64)>,
}

impl Thickness {
    /// Of places that stand for as much of the matter each: thickness [m], and the nearest place of the surface [m].
    pub(crate) fn new(mut found: Vec<(f64, DVec3)>) -> Self {
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let count = found.len() as f64;
        let place = |(k, (thickness, place)): (usize, (f64, DVec3))| (thickness, place, (k + 1) as f64 / count);
        Self { places: found.into_iter().enumerate().map(place).collect() }
    }

    /// Thickness that all but this share of the matter has at least [m]; none where nothing was found.
    pub(crate) fn of_all_but(&self, share: f64) -> Option<f64> {
        let place = self.places.partition_point(|(.., below)| *below <= share);
        self.places.get(place).or(self.places.last()).map(|(thickness, ..)| *thickness)
    }

    /// Share of the matter that is thinner than this [m], and where the surface is nearest to the thinnest of it [m].
    pub(crate) fn thinner_than(&self, thickness: f64) -> Option<(f64, DVec3)> {
        let count = self.places.partition_point(|(found, ..)| *found < thickness);
        let (.., share) = self.places.get(count.checked_sub(1)?)?;
        Some((*share, self.places[0].1))
    }
}
