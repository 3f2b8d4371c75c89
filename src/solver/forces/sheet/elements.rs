//! The parts of a sheet as elements, one by one: triangles and hinges. [`super::SheetForce`] does the same in loops.

use super::hinge::{HingeRest, hinge_angle, hinge_slopes, unwound};
use super::membrane::{MembraneLaw, TriangleRest};
use crate::solver::forces::element::contract::{Change, Element, Local, Slopes};
use glam::DVec2;

/// Stretch and shear of a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    /// At rest.
    pub(crate) rest: TriangleRest,
    /// What it is made of.
    pub(crate) law: MembraneLaw,
    /// Shares by which it wants to be shorter along its two directions where the drive is 1.
    pub(crate) contract: DVec2,
    /// Its size along them over the drawn one now.
    pub(crate) metric: DVec2,
}

impl Element for Triangle {
    fn points(&self) -> &[u32] {
        &self.rest.vertices
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        self.rest.energy(&self.law, [at.points[0], at.points[1], at.points[2]], self.metric)
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let [second, third] = self.rest.slopes(&self.law, [at.points[0], at.points[1], at.points[2]], self.metric);
        out.points[0] -= second + third;
        out.points[1] += second;
        out.points[2] += third;
    }

    fn activate(&mut self, value: f64) {
        self.metric = DVec2::ONE - self.contract * value;
    }

    fn lines(&self) -> Vec<[u32; 2]> {
        let [a, b, c] = self.rest.vertices;
        vec![[a, b], [b, c], [c, a]]
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(*self)
    }
}

/// Bending at an edge between two triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hinge {
    /// At rest.
    pub(crate) rest: HingeRest,
    /// Curvatures that it wants along both directions where the drive is 1 [rad/m].
    pub(crate) curl: DVec2,
    /// Curvatures that it wants now.
    pub(crate) curvature: DVec2,
    /// Its angle at the end of the last step [rad].
    pub(crate) last: f64,
}

impl Hinge {
    fn angle(&self, at: &Local<'_>) -> f64 {
        unwound(hinge_angle([at.points[0], at.points[1], at.points[2], at.points[3]]), self.last)
    }
}

impl Element for Hinge {
    fn points(&self) -> &[u32] {
        &self.rest.vertices
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        self.rest.energy(self.angle(at), self.curvature)
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let moment = self.rest.stiffness * (self.angle(at) - self.rest.angle - self.rest.curl.dot(self.curvature));
        let corners = [at.points[0], at.points[1], at.points[2], at.points[3]];
        let Some(by) = hinge_slopes(corners).filter(|_| moment != 0.0) else { return };
        for (out, slope) in out.points.iter_mut().zip(by) {
            *out += moment * slope;
        }
    }

    fn activate(&mut self, value: f64) {
        self.curvature = self.curl * value;
    }

    fn end_step(&mut self, at: &Local<'_>) -> Change {
        self.last = self.angle(at);
        Change::None
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        number(self.last);
    }

    fn lines(&self) -> Vec<[u32; 2]> {
        let [a, b, ..] = self.rest.vertices;
        vec![[a, b]]
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(*self)
    }
}
