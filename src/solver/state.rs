//! The moving part of a body.

use glam::DVec3;

/// Particles of one body as a structure of arrays; index i is the same particle in each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParticleState {
    /// Positions [m], world.
    pub positions: Vec<DVec3>,
    /// Velocities [m/s], world.
    pub velocities: Vec<DVec3>,
    /// Masses [kg].
    pub masses: Vec<f64>,
}

impl ParticleState {
    /// Number of particles.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there is no particle.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Total mass [kg].
    pub fn mass(&self) -> f64 {
        self.masses.iter().sum()
    }

    /// Centre of mass [m].
    pub fn center(&self) -> DVec3 {
        self.positions.iter().zip(&self.masses).map(|(&x, &m)| x * m).sum::<DVec3>() / self.mass()
    }

    /// Linear momentum [kg m/s].
    pub fn linear_momentum(&self) -> DVec3 {
        self.velocities.iter().zip(&self.masses).map(|(&v, &m)| v * m).sum()
    }

    /// Angular momentum about the world's origin [kg m²/s].
    pub fn angular_momentum(&self) -> DVec3 {
        (0..self.len()).map(|i| self.positions[i].cross(self.velocities[i]) * self.masses[i]).sum()
    }

    /// Kinetic energy [J].
    pub fn kinetic_energy(&self) -> f64 {
        self.velocities.iter().zip(&self.masses).map(|(v, m)| 0.5 * m * v.length_squared()).sum()
    }
}
