//! The parts of a fibre as elements, one by one: edges, bends, twists. [`super::FibreForce`] does the same in packed
//! loops.

use super::between::Between;
use super::corner::{Corner, straight_energy, straight_gradients};
use super::muscle::Muscle;
use crate::solver::forces::element::contract::{Element, Local, Slopes};
use glam::{DMat3, DVec3};

/// Stretch of an edge, `k/2 (|e| - l)²`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretching {
    /// Its ends.
    pub(crate) points: [u32; 2],
    /// `l_f EA / l0` [N/m].
    pub(crate) stiffness: f64,
    /// l0 [m].
    pub(crate) drawn: f64,
    /// Share by which it wants to be shorter where its drive is 1.
    pub(crate) contract: f64,
    /// Length at rest now, but for what it has yielded [m].
    pub(crate) rest: f64,
    /// By how much it has become longer for good [m].
    pub(crate) yielded: f64,
}

impl Element for Stretching {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        let stretch = at.points[1].distance(at.points[0]) - self.rest - self.yielded;
        0.5 * self.stiffness * stretch * stretch
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let edge = at.points[1] - at.points[0];
        let pull = self.stiffness * (edge.length() - self.rest - self.yielded);
        pulled(pull, edge, out);
    }

    /// Both ends move: twice k, for any length at rest above zero.
    fn majorant(&self) -> f64 {
        2.0 * self.stiffness
    }

    fn activate(&mut self, value: f64) {
        self.rest = self.drawn * (1.0 - self.contract * value);
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(*self)
    }
}

fn pulled(pull: f64, edge: DVec3, out: &mut Slopes<'_>) {
    let pull = pull * edge.normalize_or_zero();
    out.points[0] -= pull;
    out.points[1] += pull;
}

/// Pull of a muscle along an edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pull {
    /// The edge's ends.
    pub(crate) points: [u32; 2],
    /// How it pulls.
    pub(crate) muscle: Muscle,
    /// Length of the edge as drawn [m].
    pub(crate) drawn: f64,
    /// How far it is excited.
    pub(crate) excited: f64,
}

impl Element for Pull {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        let length = at.points[1].distance(at.points[0]);
        self.muscle.energy(self.excited, length / self.drawn, self.drawn)
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let edge = at.points[1] - at.points[0];
        pulled(self.muscle.pull(self.excited, edge.length() / self.drawn), edge, out);
    }

    fn majorant(&self) -> f64 {
        2.0 * self.muscle.stiffest().pull(1.0, 1.0) / self.drawn
    }

    fn activate(&mut self, value: f64) {
        self.excited = value;
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(*self)
    }
}

/// Bending at a vertex of a fibre that is straight at rest, `4 S (1 - c) / (1 + c)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StraightBend {
    /// Before, at and after the vertex.
    pub(crate) points: [u32; 3],
    /// S [N m].
    pub(crate) stiffness: f64,
}

fn bent([before, after]: [DVec3; 2], out: &mut Slopes<'_>) {
    out.points[0] -= before;
    out.points[1] += before - after;
    out.points[2] += after;
}

impl Element for StraightBend {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        Corner::at(at.points, 0).map_or(0.0, |corner| 4.0 * self.stiffness * straight_energy(corner.cosine))
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        if let Some(corner) = Corner::at(at.points, 0) {
            bent(straight_gradients(&corner, self.stiffness), out);
        }
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(*self)
    }
}

/// Bending at a vertex of a fibre whose rest shape turns with the material, `S |kb - R kb0|²`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurvedBend {
    /// Before, at and after the vertex.
    pub(crate) points: [u32; 3],
    /// The vertex.
    pub(crate) at: [u32; 1],
    /// S [N m].
    pub(crate) stiffness: f64,
    /// kb0 as drawn and yielded, model frame.
    pub(crate) drawn: DVec3,
    /// A quarter of the angle [rad] by which both edges want to turn there where the drive is 1, and the axis of that.
    pub(crate) curl: Option<(f64, DVec3)>,
    /// kb0 now.
    pub(crate) rest: DVec3,
}

impl Element for CurvedBend {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn turns(&self) -> &[u32] {
        &self.at
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        let Some(corner) = Corner::at(at.points, 0) else { return 0.0 };
        let r = DMat3::from_quat(at.turns[0]);
        self.stiffness * (corner.binormal() - r * self.rest).length_squared()
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let Some(corner) = Corner::at(at.points, 0) else { return };
        let r = DMat3::from_quat(at.turns[0]);
        let gradient = 2.0 * self.stiffness * (corner.binormal() - r * self.rest);
        let (before, after) = corner.curved_gradients(gradient);
        bent([before, after], out);
        out.turns[0] -= self.rest.cross(r.transpose() * gradient);
    }

    fn activate(&mut self, value: f64) {
        if let Some((quarter, axis)) = self.curl {
            self.rest = self.drawn + 2.0 * (quarter * value).tan() * axis;
        }
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(*self)
    }
}

/// Twist of an edge, `k/2 (theta - theta0)²`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Twisting {
    /// Its ends.
    pub(crate) points: [u32; 2],
    /// `l_f GJ / l0` [N m].
    pub(crate) stiffness: f64,
    /// Its direction at rest, model frame.
    pub(crate) axis: DVec3,
    /// theta0 where the drive is 1 [rad].
    pub(crate) wanted: f64,
    /// theta0 now.
    pub(crate) rest: f64,
}

impl Element for Twisting {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn turns(&self) -> &[u32] {
        &self.points
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        0.5 * self.stiffness * (Between::new(self.axis, at.turns).angle - self.rest).powi(2)
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let between = Between::new(self.axis, at.turns);
        let moment = self.stiffness * (between.angle - self.rest);
        let [a, b] = between.spins(self.axis);
        out.turns[0] += moment * a;
        out.turns[1] += moment * b;
    }

    fn activate(&mut self, value: f64) {
        self.rest = self.wanted * value;
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(*self)
    }
}
