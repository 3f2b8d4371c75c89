//! The matrix of a body: its particles, seams of it that tear, and the skin along them.

use super::Body;
use crate::solver::forces::{MatrixForce, SeamTear};
use crate::solver::skin::{Skin, TornSkin};
use std::sync::Arc;

impl Body {
    /// What has become of the seams of its matrix that lie in it, in the order of the scene.
    pub fn tears(&self) -> &[SeamTear] {
        self.matrix().map_or(&[], MatrixForce::tears)
    }

    /// Share of the pairs across all seams that is torn.
    pub(crate) fn torn(&self) -> f64 {
        let [torn, all] = self.tears().iter().fold([0, 0], |[torn, all], of| [torn + of.torn, all + of.bonds]);
        if all > 0 { torn as f64 / all as f64 } else { 0.0 }
    }

    /// When the first pair across a seam tore [s].
    pub(crate) fn first_tear(&self) -> Option<f64> {
        self.tears().iter().filter_map(|seam| seam.first).reduce(f64::min)
    }

    /// Volume of a material particle at rest [m³]; none of a two-layer body.
    pub fn particle_volume(&self) -> Option<f64> {
        self.matrix().map(MatrixForce::particle_volume)
    }

    /// The matrix of a fibre solid.
    fn matrix(&self) -> Option<&MatrixForce> {
        self.parts.forces.iter().find_map(|force| force.downcast_ref())
    }

    /// The surface that is drawn, as it is torn by now.
    pub(crate) fn skin(&self) -> Option<&Arc<Skin>> {
        self.torn_skin.as_ref().map(|of| &of.skin).or(self.parts.skin.as_ref())
    }

    /// Has the skin show what is torn by now.
    pub(in crate::solver) fn see_tears(&mut self) {
        let Some(parted) = self.parts.parted_skin.clone() else { return };
        let torn = self.matrix().map_or(&[][..], MatrixForce::torn);
        if !torn.contains(&true) {
            self.torn_skin = None;
        } else if self.torn_skin.as_ref().is_none_or(|of| of.torn != torn) {
            self.torn_skin = Some(TornSkin { torn: torn.to_vec(), skin: Arc::new(parted.at(torn)) });
        }
    }
}
