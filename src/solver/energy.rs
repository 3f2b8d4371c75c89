//! Energies of a body by what stores them.

/// Energies [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Energy of motion.
    pub kinetic: f64,
    /// Strain energy of the matrix.
    pub matrix: f64,
    /// Energy of the terms that hold back the zero-energy modes.
    pub zero_energy: f64,
    /// Stretching energy of the fibres.
    pub stretching: f64,
    /// Bending energy of the fibres.
    pub bending: f64,
    /// Energy of springs.
    pub springs: f64,
    /// Energy of enclosed gas.
    pub pressure: f64,
    /// Elastic energy of contacts: with the room and panels whole, with other bodies half.
    pub contact: f64,
    /// Potential energy in the gravity field, zero at the world's origin.
    pub gravity: f64,
}

impl Energies {
    /// Sum of all.
    pub fn total(&self) -> f64 {
        self.kinetic + self.potential()
    }

    /// Sum of all but the kinetic energy.
    pub fn potential(&self) -> f64 {
        self.matrix
            + self.zero_energy
            + self.stretching
            + self.bending
            + self.springs
            + self.pressure
            + self.contact
            + self.gravity
    }
}
