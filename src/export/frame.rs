//! What changes from frame to frame.

use glam::DVec3;

/// What is wanted of a frame beside places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "each is a thing of its own")]
pub(crate) struct Wanted {
    /// Velocities of the surfaces' vertices.
    pub(crate) velocities: bool,
    /// Normals of the surfaces that have any in their files.
    pub(crate) normals: bool,
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
    /// Bodies in the order of the scene, and the panels behind them.
    pub(crate) bodies: Vec<BodyFrame>,
}

/// A body at one time.
#[derive(Clone, Debug, Default)]
pub(crate) struct BodyFrame {
    /// Vertices of its mesh.
    pub(crate) vertices: Vec<DVec3>,
    /// Their velocities [units/s]; empty unless wanted.
    pub(crate) velocities: Vec<DVec3>,
    /// Normals, in the order of those of its mesh; empty unless wanted.
    pub(crate) normals: Vec<DVec3>,
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

/// The first of some numbers that is none, or none in single precision, and its place among them.
fn lost<const N: usize>(all: impl IntoIterator<Item = [f64; N]>, in_single: bool) -> Option<(usize, String)> {
    let is_lost = |c: f64| !c.is_finite() || (in_single && !(c as f32).is_finite());
    let told = |values: [f64; N]| {
        let text: Vec<String> = values.iter().map(f64::to_string).collect();
        if N == 1 { text.concat() } else { format!("[{}]", text.join(", ")) }
    };
    all.into_iter()
        .enumerate()
        .find(|(_, values)| values.iter().any(|&c| is_lost(c)))
        .map(|(k, values)| (k, told(values)))
}

impl Frame {
    /// The first value that is no number, or none in single precision where that is what is written; as a message calls
    /// it, and what it is.
    pub(crate) fn not_finite(&self, in_single: bool, name: impl Fn(usize) -> String) -> Option<(String, String)> {
        let vectors = |all: &[DVec3]| lost(all.iter().map(DVec3::to_array), in_single);
        let scalars = |all: &[f64]| lost(all.iter().map(|&value| [value]), in_single);
        self.bodies.iter().enumerate().find_map(|(index, body)| {
            let particles = &body.particles;
            let of_fibres = |found: &dyn Fn(&FibreFrame) -> Option<(usize, String)>| body.fibres.iter().find_map(found);
            let found = [
                ("vertex", vectors(&body.vertices)),
                ("velocity of vertex", vectors(&body.velocities)),
                ("normal", vectors(&body.normals)),
                ("vertex of a fibre", of_fibres(&|fibre| vectors(&fibre.vertices))),
                ("tension of a fibre at its vertex", of_fibres(&|fibre| scalars(&fibre.tensions))),
                ("end of a spring", vectors(&body.springs)),
                ("particle", vectors(&particles.positions)),
                ("velocity of particle", vectors(&particles.velocities)),
                ("volume fraction of particle", scalars(&particles.fractions)),
                ("strain of particle", scalars(&particles.strains)),
                ("stress of particle", scalars(&particles.stresses)),
                ("fibre direction of particle", vectors(&particles.directions)),
            ];
            let told = |(what, found): (&str, Option<(usize, String)>)| {
                found.map(|(k, value)| (format!("frame {}, body {:?}: {what} {k}", self.number, name(index)), value))
            };
            found.into_iter().find_map(told)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Puts vectors or numbers where a frame has them.
    type Put = fn(&mut BodyFrame, Vec<DVec3>, Vec<f64>);

    #[test]
    fn whatever_is_no_number_is_found_in_the_precision_that_is_written() {
        let at = |v: f64| vec![DVec3::ZERO, DVec3::new(0.0, v, 0.0)];
        let of = |v: f64| vec![0.0, v];
        let puts: [(&str, Put); 12] = [
            ("vertex", |body, v, _| body.vertices = v),
            ("velocity of vertex", |body, v, _| body.velocities = v),
            ("normal", |body, v, _| body.normals = v),
            ("vertex of a fibre", |body, v, _| body.fibres = vec![FibreFrame { vertices: v, ..FibreFrame::default() }]),
            ("tension of a fibre at its vertex", |body, _, s| {
                body.fibres = vec![FibreFrame { tensions: s, ..FibreFrame::default() }];
            }),
            ("end of a spring", |body, v, _| body.springs = v),
            ("particle", |body, v, _| body.particles.positions = v),
            ("velocity of particle", |body, v, _| body.particles.velocities = v),
            ("volume fraction of particle", |body, _, s| body.particles.fractions = s),
            ("strain of particle", |body, _, s| body.particles.strains = s),
            ("stress of particle", |body, _, s| body.particles.stresses = s),
            ("fibre direction of particle", |body, v, _| body.particles.directions = v),
        ];
        for (what, put) in puts {
            for (value, in_double, in_single) in
                [(1.0, false, false), (1e39, false, true), (f64::NAN, true, true), (f64::NEG_INFINITY, true, true)]
            {
                let mut body = BodyFrame::default();
                put(&mut body, at(value), of(value));
                let frame = Frame { number: 7, bodies: vec![BodyFrame::default(), body], ..Frame::default() };
                let found = |single| frame.not_finite(single, |index| format!("b{index}"));
                assert_eq!(found(false).is_some(), in_double, "{what} {value}");
                let told = found(true).map(|(what, _)| what);
                assert_eq!(told, in_single.then(|| format!("frame 7, body \"b1\": {what} 1")), "{value}");
            }
        }
    }
}
