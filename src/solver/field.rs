//! What can be read at every particle of a body, for pictures: how it is strained, stressed, filled with fibre, moving;
//! and at every edge of its fibres, how hard they pull.

use super::body::Body;
use super::forces::{FibreForce, Inelastic, MatrixForce, MatrixThinning};

/// A scalar at every particle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FieldKind {
    /// Equivalent strain of the matrix [1], `sqrt(2/3 e' : e')` with `e' = e - tr(e)/3 I` and `e = sym(R^T F) - I`:
    /// what a bar of equal volume is stretched by that changes its shape as much.
    Strain,
    /// Equivalent stress of the matrix after von Mises [Pa], `sqrt(3/2 s' : s')` with `s' = s - tr(s)/3 I` and
    /// `s = 2 mu e + lambda tr(e) I`: in the material's own frame, at the matrix itself, not thinned by its share.
    Stress,
    /// Share of fibre in the volume [1].
    VolumeFraction,
    /// Length of the velocity [m/s].
    Speed,
}

impl FieldKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Strain, Self::Stress, Self::VolumeFraction, Self::Speed];

    /// The least value that counts as something, in the field's own unit: whatever lies below is rounding.
    pub fn least(self) -> f64 {
        match self {
            Self::Strain | Self::VolumeFraction | Self::Speed => 1e-6,
            Self::Stress => 1e-3,
        }
    }
}

impl Body {
    /// The values of a field at the particles, in its own unit; empty for a body that has no such thing, as one of two
    /// layers has no matrix.
    pub fn field(&self, kind: FieldKind) -> Vec<f64> {
        let state = self.state();
        let matrix = self.parts().forces.iter().find_map(|force| force.downcast_ref::<MatrixForce>());
        let read = |of: fn(&MatrixForce, &[_]) -> Vec<f64>| {
            matrix.map_or_else(Vec::new, |matrix| of(matrix, &state.positions))
        };
        match kind {
            FieldKind::Strain => read(MatrixForce::von_mises_strains),
            FieldKind::Stress => {
                let inelastic = self.parts().forces.iter().find_map(|force| force.downcast_ref::<Inelastic>());
                match inelastic.filter(|inelastic| inelastic.yields()) {
                    Some(inelastic) => inelastic.von_mises_stresses(&state.positions),
                    None => read(MatrixForce::von_mises_stresses),
                }
            }
            FieldKind::VolumeFraction => {
                let mut fractions = read(|matrix, _| matrix.fibre_fractions());
                let changing = self.parts().forces.iter().find_map(|force| force.downcast_ref::<MatrixThinning>());
                if let Some(changing) = changing {
                    changing.put_fractions(&mut fractions);
                }
                fractions
            }
            FieldKind::Speed => state.velocities.iter().map(|velocity| velocity.length()).collect(),
        }
    }

    /// Force [N] that every edge of every centre line carries along itself, negative where it is pressed; zero where it
    /// is broken or nothing stretches.
    pub fn tensions(&self) -> Vec<Vec<f64>> {
        let edges = self.parts().fibres.iter().map(|line| line.vertices.len().saturating_sub(1));
        let mut lines: Vec<Vec<f64>> = edges.map(|count| vec![0.0; count]).collect();
        for fibres in self.parts().forces.iter().filter_map(|force| force.downcast_ref::<FibreForce>()) {
            fibres.tensions(&self.state().positions, &mut lines);
        }
        lines
    }

    /// What every edge of every centre line does by itself: its drive, and the share by which that has it want to be
    /// shorter; zeros where it does not act.
    pub fn activations(&self) -> Vec<Vec<[f64; 2]>> {
        let edges = self.parts().fibres.iter().map(|line| line.vertices.len().saturating_sub(1));
        let mut lines: Vec<Vec<[f64; 2]>> = edges.map(|count| vec![[0.0; 2]; count]).collect();
        for fibres in self.parts().forces.iter().filter_map(|force| force.downcast_ref::<FibreForce>()) {
            fibres.activations(&mut lines);
        }
        lines
    }
}
