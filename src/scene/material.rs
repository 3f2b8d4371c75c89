//! Materials: elasticity, mass, discretisation, damping.

use super::Extra;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A homogeneous, isotropic elastic material and its discretisation. The fibres do the rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Material {
    /// Young's modulus E [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio nu, from 0 to 0.49.
    #[serde(default = "default_poisson")]
    pub poisson_ratio: f64,
    /// Density or mass.
    pub mass: Mass,
    /// Support radius h of the smoothing kernel [m].
    pub support_radius: f64,
    /// Particle spacing over support radius, D / h.
    #[serde(default = "default_spacing_ratio")]
    pub spacing_ratio: f64,
    /// What takes energy out of the motion.
    #[serde(default)]
    pub damping: Damping,
    /// How the matrix resists being strained fast; not at all unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub viscosity: Option<Viscosity>,
    /// How the matrix yields; it springs back from everything unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plasticity: Option<Plasticity>,
    /// How a fibre's volume fraction falls off with the distance from its structure particles, out to h.
    #[serde(default)]
    pub volume_fraction_falloff: Falloff,
    /// On which material particles a structure particle hangs.
    #[serde(default, skip_serializing_if = "FibreEmbedding::is_compact")]
    pub fibre_embedding: FibreEmbedding,
    /// How exactly the matrix's forces are computed.
    #[serde(default)]
    pub precision: Precision,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Support radius h of a material unless another is chosen [m]: that of the scenes that ship with a bar of a hand's
/// size. With the usual spacing ratio particles are 6 mm apart.
pub const USUAL_SUPPORT_RADIUS: f64 = 0.015;

impl Material {
    /// A material by its Young's modulus E [Pa], Poisson's ratio (0 to 0.49) and density [kg/m³].
    ///
    /// It is discretised by [`USUAL_SUPPORT_RADIUS`] and D / h = 0.4, as the fibre paper's bars are, and undamped. A
    /// body of another size than a hand's needs another support radius, a fifth of its thickness or less.
    pub fn new(young_modulus: f64, poisson_ratio: f64, density: f64) -> Self {
        Self {
            young_modulus,
            poisson_ratio,
            mass: Mass::Density(density),
            support_radius: USUAL_SUPPORT_RADIUS,
            spacing_ratio: default_spacing_ratio(),
            damping: Damping::default(),
            viscosity: None,
            plasticity: None,
            volume_fraction_falloff: Falloff::default(),
            fibre_embedding: FibreEmbedding::default(),
            precision: Precision::default(),
            extra: Extra::new(),
        }
    }

    /// With a mass of each particle [kg] in place of a density; the fibre paper uses 4e-4.
    #[must_use]
    pub fn with_particle_mass(self, mass: f64) -> Self {
        Self { mass: Mass::PerParticle(mass), ..self }
    }

    /// With another support radius h of the smoothing kernel [m].
    #[must_use]
    pub fn with_support_radius(self, support_radius: f64) -> Self {
        Self { support_radius, ..self }
    }

    /// With radial damping between neighbouring particles [1/s] and drag of the surrounding air [1/s].
    #[must_use]
    pub fn with_damping(self, pair: f64, air: f64) -> Self {
        Self { damping: Damping { pair, air, ..self.damping }, ..self }
    }

    /// With a matrix that resists being strained fast.
    #[must_use]
    pub fn with_viscosity(self, viscosity: Viscosity) -> Self {
        Self { viscosity: Some(viscosity), ..self }
    }

    /// With a matrix that yields.
    #[must_use]
    pub fn with_plasticity(self, plasticity: Plasticity) -> Self {
        Self { plasticity: Some(plasticity), ..self }
    }

    /// With forces of the matrix computed in f32, in place of f64.
    #[must_use]
    pub fn in_fast_precision(self) -> Self {
        Self { precision: Precision::Fast, ..self }
    }

    /// Particle spacing D [m].
    pub fn spacing(&self) -> f64 {
        self.spacing_ratio * self.support_radius
    }
}

impl Default for Material {
    /// As soft as the bar that the window starts with: 1e5 Pa, Poisson's ratio 0.33, and the density of water.
    fn default() -> Self {
        Self::new(1e5, default_poisson(), 1000.0)
    }
}

/// Mass of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mass {
    /// Density [kg/m³] times the volume of the shape, shared evenly by its particles.
    Density(f64),
    /// Mass of each material particle [kg]; the fibre paper uses 4e-4.
    PerParticle(f64),
}

/// Damping. Neither kind changes the rest state.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Damping {
    /// Radial damping between neighbouring particles [1/s]; keeps linear and angular momentum.
    pub pair: f64,
    /// Drag of the surrounding air, acceleration per velocity [1/s].
    pub air: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

/// Resistance of the matrix against being strained fast (Kelvin and Voigt): jelly against rubber. It takes energy from
/// every change of shape and none from a body that turns as it stands. Over Young's modulus it is a time; where that is
/// longer than the step, the step shrinks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Viscosity {
    /// Against a change of shape [Pa s].
    pub shear: f64,
    /// Against a change of volume [Pa s].
    pub bulk: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Viscosity {
    /// Against a change of shape and one of volume [Pa s].
    pub fn new(shear: f64, bulk: f64) -> Self {
        Self { shear, bulk, extra: Extra::new() }
    }
}

/// How the matrix yields (von Mises): dents stay. Resetting the motion mends them. Pulled, pressed and sheared it
/// yields as theory has it. Bent, it springs back 1.3 to 1.7 times as far, since part of what holds the particles in
/// place is elastic (half of the bending of three layers, a seventh of seven): what is to keep a pose takes a fibre
/// that yields.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Plasticity {
    /// Stress at which a pulled bar yields [Pa].
    pub yield_stress: f64,
    /// By how much that grows as it yields, over the plastic strain [Pa].
    #[serde(default)]
    pub hardening: f64,
    /// Time in which a stress above it fades [s]; at once unless given.
    #[serde(default)]
    pub creep_time: f64,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Plasticity {
    /// By the stress at which a pulled bar yields [Pa]: at once, and as easily the further it has yielded.
    pub fn new(yield_stress: f64) -> Self {
        Self { yield_stress, hardening: 0.0, creep_time: 0.0, extra: Extra::new() }
    }
}

/// How a fibre's volume fraction falls off with distance d from its nearest structure particle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Falloff {
    /// By the kernel, W(d) / W(0) (eq. 13).
    #[default]
    Kernel,
    /// Linearly, 1 - d / h.
    Linear,
    /// Not at all within h.
    Constant,
}

/// On which of the material particles around it a structure particle hangs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FibreEmbedding {
    /// On those whose kernel weight is more than 6 % of the heaviest one: about half of those in reach, and half of
    /// what a fibre costs. Every linear motion is carried exactly. Of a pressed bar with four straight fibres the
    /// force is the same to a two-thousandth, so that fibres are hardly stiffer in what moves slowly; the stable step,
    /// which the fastest motion of fibres sets, is 3 % shorter than with all, as that is stiffer by 6 %.
    #[default]
    Compact,
    /// On all within the support radius, as eq. 17 has it.
    All,
}

impl FibreEmbedding {
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "serde asks so")]
    fn is_compact(&self) -> bool {
        *self == Self::Compact
    }
}

/// How exactly the matrix's forces are computed. Positions, velocities, fibres, contact and energies are f64 in any
/// case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Precision {
    /// In f64, to round-off.
    #[default]
    Exact,
    /// In f32, from deviations from the body's rigid motion: up to 1.7 times as fast, and off by some millionths of the
    /// greatest force.
    Fast,
}

fn default_poisson() -> f64 {
    0.33
}

fn default_spacing_ratio() -> f64 {
    0.4
}
