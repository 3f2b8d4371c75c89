//! A force beside the particles that take it up: its moment about them is given as forces that turn them.
//!
//! With y_k their places about the mean of them and `J = sum (|y|² I - y (x) y)`, the forces `(J^-1 t) x y_k` sum to
//! nothing and have the moment t. Their power is `t . w` with `w = J^-1 sum y_k x v_k`, the turn that is read off the
//! velocities: what is braked at a place is braked as fast as the place moves.

use glam::{DMat3, DVec3};

/// Particles that lie on a line take no moment; so flat an inertia, over that of a ball of them, counts as one.
const FLAT: f64 = 1e-6;

/// Particles that turn together.
pub(super) struct Turning<'a> {
    particles: &'a [u32],
    center: DVec3,
    inverse: DMat3,
}

impl<'a> Turning<'a> {
    /// None of particles on a line.
    pub(super) fn of(particles: &'a [u32], positions: &[DVec3]) -> Option<Self> {
        let first = positions[*particles.first()? as usize];
        let center =
            first + particles.iter().map(|&k| positions[k as usize] - first).sum::<DVec3>() / particles.len() as f64;
        let mut inertia = DMat3::ZERO;
        for &k in particles {
            let y = positions[k as usize] - center;
            inertia +=
                DMat3::from_diagonal(DVec3::splat(y.length_squared())) - DMat3::from_cols(y * y.x, y * y.y, y * y.z);
        }
        let mean = (inertia.x_axis.x + inertia.y_axis.y + inertia.z_axis.z) / 3.0;
        (inertia.determinant() > FLAT * mean * mean * mean).then(|| Self {
            particles,
            center,
            inverse: inertia.inverse(),
        })
    }

    /// How they turn [rad/s] at these velocities [m/s], or have turned [rad] by these ways [m].
    pub(super) fn turn(&self, positions: &[DVec3], motion: impl Fn(u32) -> DVec3) -> DVec3 {
        let moment = |&k: &u32| (positions[k as usize] - self.center).cross(motion(k));
        self.inverse * self.particles.iter().map(moment).sum::<DVec3>()
    }

    /// The forces [N] that have a moment [N m].
    pub(super) fn forces(&self, moment: DVec3, positions: &[DVec3]) -> Vec<(u32, DVec3)> {
        let about = self.inverse * moment;
        self.particles.iter().map(|&k| (k, about.cross(positions[k as usize] - self.center))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forces_have_the_moment_and_the_power_of_the_turn() {
        let positions = [DVec3::X, DVec3::new(0.1, 1.0, 0.2), DVec3::new(0.3, 0.2, 2.0), DVec3::ONE];
        let velocities = [DVec3::Y, DVec3::new(0.3, -0.4, 1.0), DVec3::new(-0.2, 0.0, 0.7), DVec3::NEG_Z];
        for particles in [&[0, 1, 2][..], &[0, 1, 2, 3]] {
            let turning = Turning::of(particles, &positions).expect("they span a plane");
            let moment = DVec3::new(0.3, -0.2, 0.5);
            let forces = turning.forces(moment, &positions);
            let sum: DVec3 = forces.iter().map(|(_, f)| *f).sum();
            let about: DVec3 = forces.iter().map(|&(k, f)| positions[k as usize].cross(f)).sum();
            let power: f64 = forces.iter().map(|&(k, f)| f.dot(velocities[k as usize])).sum();
            assert!(sum.length() < 1e-15 && about.distance(moment) < 1e-14, "{sum} {about}");
            assert!((power - moment.dot(turning.turn(&positions, |k| velocities[k as usize]))).abs() < 1e-14);
        }
        assert!(Turning::of(&[0, 3], &positions).is_none(), "a line takes no moment");
    }
}
