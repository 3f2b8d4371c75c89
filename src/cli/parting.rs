//! Where two runs of the same motion part, and by which force.

use crate::scene::one_line;
use crate::sim::Runner;
use crate::solver::Body;
use glam::DVec3;
use rayon::ThreadPool;
use std::cell::Cell;

fn differs(p: DVec3, q: DVec3) -> bool {
    p.to_array().map(f64::to_bits) != q.to_array().map(f64::to_bits)
}

/// The first body, and particle of it, in which two runs differ, and what of it does: its position, its velocity, or
/// the force on it.
pub(super) fn parting(a: &Runner, b: &Runner) -> Option<String> {
    let mut bodies = a.world().bodies().iter().zip(b.world().bodies());
    bodies.find_map(|(a, b)| {
        let (x, y) = (a.state(), b.state());
        let particle = |i: usize| {
            let what = if differs(x.positions[i], y.positions[i]) {
                "position"
            } else if differs(x.velocities[i], y.velocities[i]) {
                "velocity"
            } else if differs(a.net_force(i), b.net_force(i)) {
                "net force"
            } else {
                return None;
            };
            Some(format!("the {what} of particle {i} of body \"{}\" differs", one_line(&a.parts().name)))
        };
        (0..x.len().min(y.len())).find_map(particle)
    })
}

/// What sets two runs apart within a frame at whose beginning they agree, each on its threads: the step in which they
/// part, and the first force that comes to other bits from the same state before it.
pub(super) fn cause_of(a: (&ThreadPool, &Runner), b: (&ThreadPool, &Runner)) -> String {
    // They agree after `same` steps, as far as is known, and differ after `other`.
    let (mut same, mut other) = (0, stepped(a, usize::MAX).1);
    let mut last = (a.1.clone(), b.1.clone());
    while same < other {
        let middle = same.midpoint(other);
        let there = (stepped(a, middle).0, stepped(b, middle).0);
        if parting(&there.0, &there.1).is_some() {
            other = middle;
        } else {
            (same, last) = (middle + 1, there);
        }
    }
    let step = format!("they part in step {} of it", other.max(1));
    let forces = |pool: &ThreadPool, runner: &Runner| -> Vec<_> {
        let time = runner.world().time();
        pool.install(|| runner.world().bodies().iter().map(|body| body.forces_apart(time)).collect())
    };
    let (on_a, on_b) = (forces(a.0, &last.0), forces(b.0, &last.1));
    let mut of_bodies = on_a.iter().zip(&on_b).zip(last.0.world().bodies());
    match of_bodies.find_map(|((a, b), body)| first_force(body, a, b)) {
        Some(force) => format!("{step}, by {force}"),
        None => format!("{step}, where every force comes to the same bits: by the integrator, or by a constraint"),
    }
}

/// The runner after so many steps of the bodies in its next frame, and how many it took.
fn stepped((pool, from): (&ThreadPool, &Runner), steps: usize) -> (Runner, usize) {
    let mut runner = from.clone();
    let taken = pool.install(|| {
        let taken = Cell::new(0);
        runner.frame_unless(&|| {
            let is_end = taken.get() == steps;
            taken.set(taken.get() + usize::from(!is_end));
            is_end
        });
        taken.get()
    });
    (runner, taken)
}

/// What the forces on a body do to its particles, by their names [N].
type ForcesApart = [(&'static str, Vec<DVec3>)];

/// The first force on a body that comes to other bits in one run than in another, and where.
fn first_force(body: &Body, a: &ForcesApart, b: &ForcesApart) -> Option<String> {
    a.iter().zip(b).find_map(|((name, a), (_, b))| {
        let particle = a.iter().zip(b).position(|(&p, &q)| differs(p, q))?;
        Some(format!("the force \"{name}\" on particle {particle} of body \"{}\"", one_line(&body.parts().name)))
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;
    use crate::bake::bake;
    use crate::io::scene_from_json;
    use crate::scene::Assets;
    use crate::solver::{Energies, Force, ParticleState};

    /// A force that is there within a span of time [s]: as one that hangs on threads could be.
    #[derive(Clone)]
    struct Uneven {
        from: f64,
        by: f64,
    }

    impl Force for Uneven {
        fn add_forces(&mut self, time: f64, _state: &ParticleState, forces: &mut [DVec3]) {
            forces[3].y += if time >= self.from { self.by } else { 0.0 };
        }

        fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}

        fn clone_box(&self) -> Box<dyn Force> {
            Box::new(self.clone())
        }
    }

    fn runner() -> Runner {
        let material = r#"{"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.015}"#;
        let scene = scene_from_json(&format!(
            r#"{{"version": 1, "bodies": [
                {{"id": "first", "shape": {{"box": {{"size": [0.03, 0.03, 0.03]}}}}, "material": {material},
                    "placement": {{"translation": [0.5, 0, 0]}}}},
                {{"id": "second", "shape": {{"box": {{"size": [0.03, 0.03, 0.03]}}}}, "material": {material}}}]}}"#
        ));
        Runner::new(bake(&scene.unwrap(), &Assets::default()).unwrap())
    }

    fn with(from: f64, by: f64) -> Runner {
        let mut runner = runner();
        runner.body_mut(1).unwrap().add_force(Box::new(Uneven { from, by }));
        runner
    }

    #[test]
    fn two_runs_that_part_tell_step_body_particle_and_force() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        let seconds = runner().world().plan().frame_seconds;
        let (a, b) = (with(0.5 * seconds, 1e-6), with(0.5 * seconds, 2e-6));
        assert_eq!(parting(&a, &b), None);
        let [mut ended_a, mut ended_b] = [a.clone(), b.clone()];
        ended_a.advance_frame();
        ended_b.advance_frame();
        let place = parting(&ended_a, &ended_b).unwrap();
        assert!(place.contains("of body \"second\" differs"), "{place}");
        let cause = cause_of((&pool, &a), (&pool, &b));
        let steps = stepped((&pool, &a), usize::MAX).1;
        let step: usize = cause.split_whitespace().nth(4).unwrap().parse().unwrap();
        // The second body takes its steps behind those of the first.
        assert!((steps / 2 + 1..steps).contains(&step), "{cause} of {steps}");
        // A force that tells no name is called as its type is.
        let early = cause_of((&pool, &with(0.0, 1e-6)), (&pool, &with(0.0, 2e-6)));
        assert!(early.ends_with("by the force \"Uneven\" on particle 3 of body \"second\""), "{early}");
    }

    #[test]
    fn the_first_of_the_forces_is_told() {
        let runner = runner();
        let bodies = runner.world().bodies();
        let apart = bodies[0].forces_apart(0.0);
        let names: Vec<&str> = apart.iter().map(|(name, _)| *name).collect();
        assert!(names.contains(&"matrix") && names.last() == Some(&"other bodies and panels"), "{names:?}");
        assert_eq!(first_force(&bodies[0], &apart, &apart), None);
        let mut other = apart.clone();
        for (_, forces) in &mut other {
            forces[7].z = f64::from_bits(forces[7].z.to_bits() ^ 1);
        }
        let told = first_force(&bodies[0], &apart, &other).unwrap();
        assert_eq!(told, format!("the force \"{}\" on particle 7 of body \"first\"", names[0]));
    }
}
