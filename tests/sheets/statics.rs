//! Small displacements of a baked body at rest, by conjugate gradients on differences of its forces.

use glam::DVec3;
use sinew::solver::{Body, Force};

/// A body whose particles are moved a little, some of them as is prescribed.
pub struct Statics {
    forces: Vec<Box<dyn Force>>,
    body: Body,
    /// Displacements that are so much larger than what is computed with [1/m].
    small: f64,
}

impl Statics {
    pub fn of(body: &Body) -> Self {
        Self { forces: body.parts().forces.clone(), body: body.clone(), small: 1e-7 }
    }

    /// Rest positions [m].
    pub fn rest(&self) -> &[DVec3] {
        &self.body.state().positions
    }

    /// Forces [N] by which displacements `u` [m] are resisted.
    pub fn resisted(&mut self, u: &[DVec3]) -> Vec<DVec3> {
        let [forth, back] = [1.0, -1.0].map(|sign| {
            let mut state = self.body.state().clone();
            state.positions.iter_mut().zip(u).for_each(|(x, u)| *x += sign * self.small * *u);
            let mut sum = vec![DVec3::ZERO; u.len()];
            self.forces.iter_mut().for_each(|force| force.add_forces(0.0, &state, &mut sum));
            sum
        });
        forth.into_iter().zip(back).map(|(forth, back)| (back - forth) / (2.0 * self.small)).collect()
    }

    /// Displacements [m] in which nothing is left over but where components are `held` at those of `given`.
    pub fn solved(&mut self, given: &[DVec3], held: &[[bool; 3]]) -> Vec<DVec3> {
        let free = |v: &[DVec3]| -> Vec<DVec3> {
            let part = |(v, held): (&DVec3, &[bool; 3])| DVec3::select((*held).into(), DVec3::ZERO, *v);
            v.iter().zip(held).map(part).collect()
        };
        let dot = |a: &[DVec3], b: &[DVec3]| a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum::<f64>();
        let mut u = given.to_vec();
        let mut left: Vec<DVec3> = free(&self.resisted(&u)).into_iter().map(|force| -force).collect();
        let mut way = left.clone();
        let (start, mut square) = (dot(&left, &left), dot(&left, &left));
        for _ in 0..4000 {
            let resisted = free(&self.resisted(&way));
            let step = square / dot(&way, &resisted);
            u.iter_mut().zip(&way).for_each(|(u, way)| *u += step * *way);
            left.iter_mut().zip(&resisted).for_each(|(left, resisted)| *left -= step * *resisted);
            let next = dot(&left, &left);
            if next < 1e-14 * start {
                return u;
            }
            let share = next / square;
            way.iter_mut().zip(&left).for_each(|(way, left)| *way = *left + share * *way);
            square = next;
        }
        panic!("{square:e} of {start:e} are left");
    }
}
