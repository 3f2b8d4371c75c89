//! What changes from frame to frame.

use glam::DVec3;

/// What is wanted of a frame beside places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Wanted {
    /// Velocities of the surfaces' vertices.
    pub(crate) velocities: bool,
    /// Particles with their fields.
    pub(crate) particles: bool,
    /// What fibres carry.
    pub(crate) tensions: bool,
}

/// A motion at one time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Frame {
    /// Number of the frame; 0 is the start.
    pub(crate) number: u64,
    /// Simulated time [s].
    pub(crate) time: f64,
    /// Bodies in the order of the scene.
    pub(crate) bodies: Vec<BodyFrame>,
}

/// A body at one time.
#[derive(Clone, Debug, Default)]
pub(crate) struct BodyFrame {
    /// Vertices of its mesh.
    pub(crate) vertices: Vec<DVec3>,
    /// Their velocities [units/s]; empty unless wanted.
    pub(crate) velocities: Vec<DVec3>,
    /// Fibres in the order of the scene.
    pub(crate) fibres: Vec<FibreFrame>,
    /// Places of both ends of every spring.
    pub(crate) springs: Vec<DVec3>,
    /// Particles; empty unless wanted.
    pub(crate) particles: ParticleFrame,
}

/// A fibre at one time.
#[derive(Clone, Debug, Default)]
pub(crate) struct FibreFrame {
    /// Vertices.
    pub(crate) vertices: Vec<DVec3>,
    /// Force along the fibre [N] at every vertex, the mean of the edges beside it, negative where it is pressed; empty
    /// unless wanted.
    pub(crate) tensions: Vec<f64>,
}

/// Particles at one time; a field that a body has not is empty.
#[derive(Clone, Debug, Default)]
pub(crate) struct ParticleFrame {
    /// Places.
    pub(crate) positions: Vec<DVec3>,
    /// Velocities [units/s].
    pub(crate) velocities: Vec<DVec3>,
    /// Share of fibre in the volume [1].
    pub(crate) fractions: Vec<f64>,
    /// Equivalent strain of the matrix [1].
    pub(crate) strains: Vec<f64>,
    /// Equivalent stress of the matrix after von Mises [Pa].
    pub(crate) stresses: Vec<f64>,
    /// Mean direction of the fibres that a particle carries, of length one; zero for one that carries none.
    pub(crate) directions: Vec<DVec3>,
}

impl Frame {
    /// The first place that is no numbers, as a message calls it, and its value.
    pub(crate) fn not_finite(&self, name: impl Fn(usize) -> String) -> Option<(String, DVec3)> {
        let lost = |points: &[DVec3]| points.iter().enumerate().find(|(_, p)| !p.is_finite()).map(|(k, p)| (k, *p));
        self.bodies.iter().enumerate().find_map(|(index, body)| {
            let told = |what: &str, found: Option<(usize, DVec3)>| {
                found.map(|(k, p)| (format!("frame {}, body {:?}: {what} {k}", self.number, name(index)), p))
            };
            told("vertex", lost(&body.vertices))
                .or_else(|| told("velocity of vertex", lost(&body.velocities)))
                .or_else(|| body.fibres.iter().find_map(|fibre| told("vertex of a fibre", lost(&fibre.vertices))))
                .or_else(|| told("particle", lost(&body.particles.positions)))
                .or_else(|| told("velocity of particle", lost(&body.particles.velocities)))
        })
    }
}
