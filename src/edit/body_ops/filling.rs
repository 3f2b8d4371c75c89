//! How finely a body is filled, which changes neither its mass nor its stiffness.

use crate::scene::{Body, Mass, Rigidity, Shape, Stiffness};

/// A fibre solid of which nothing is said particle by particle, so that others may fill it: the mass of a particle of a
/// volume [m³] becomes a density, and Kb and Ks of a fibre, of which Kb is taken times that volume, its rigidities.
pub fn of_any_filling(body: &Body, particle_volume: f64) -> Body {
    let mut body = body.clone();
    if let Mass::PerParticle(mass) = body.material.mass {
        body.material.mass = Mass::Density(mass / particle_volume);
    }
    for fibre in &mut body.fibres {
        if let Stiffness::Paper(_) = fibre.stiffness {
            let (ea, ei) = fibre.stiffness.rigidity(particle_volume);
            fibre.stiffness = Rigidity::new(ea, ei).into();
        }
    }
    body
}

/// The body with a model that so many particles fill, where a count says how finely it is.
#[must_use]
pub fn filled_by(mut body: Body, count: u32) -> Body {
    if let Shape::Mesh(shape) = &mut body.shape {
        shape.particles = shape.particles.map(|_| count);
    }
    body
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Fibre, MeshShape, PaperStiffness};

    #[test]
    fn mass_and_rigidity_are_those_of_the_particles_before() {
        let mut body = Body::cuboid("bar", [0.03; 3]);
        body.material.mass = Mass::PerParticle(4e-4);
        body.fibres = vec![Fibre::through("fibre", [[0.0; 3], [0.0, 0.01, 0.0]])];
        body.fibres[0].stiffness = PaperStiffness::new(1000.0, 20.0).into();
        let volume = 2e-7;
        let after = of_any_filling(&body, volume);
        let Mass::Density(density) = after.material.mass else { panic!("a density") };
        assert!((density - 2000.0).abs() < 1e-9, "{density}");
        assert_eq!(after.fibres[0].stiffness.rigidity(1.0), body.fibres[0].stiffness.rigidity(volume));
        assert_eq!(of_any_filling(&after, 1.0), after);
    }

    #[test]
    fn only_a_model_that_is_filled_by_a_count_takes_another() {
        let count = |shape: Shape| match filled_by(Body::new("body", shape), 700).shape {
            Shape::Mesh(shape) => shape.particles,
            _ => None,
        };
        assert_eq!(count(MeshShape::new("a.obj").with_particles(100).into()), Some(700));
        assert_eq!(count(MeshShape::new("a.obj").into()), None);
    }
}
