//! What an element is: the one contract that all structures in a body keep.

use glam::{DQuat, DVec3};

/// Most points that one element may name.
pub const MOST_POINTS: usize = 8;

/// The points of one element at one time.
#[derive(Clone, Copy, Debug)]
pub struct Local<'a> {
    /// Where its points are [m], in the order of [`Element::points`].
    pub points: &'a [DVec3],
    /// How the material is turned around those that it reads it at, from the model frame into the world, in the order
    /// of [`Element::turns`].
    pub turns: &'a [DQuat],
}

/// What an element's energy changes by; an element adds to what is there.
#[derive(Debug)]
pub struct Slopes<'a> {
    /// Gradients by its points [N].
    pub points: &'a mut [DVec3],
    /// Derivatives by small turns of the material around the points of [`Element::turns`], `R -> R exp([w]x)`, so in
    /// the model frame [N m].
    pub turns: &'a mut [DVec3],
}

/// What became of an element at the end of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Change {
    /// It is what it was.
    #[default]
    None,
    /// It rests otherwise from now on, and has lost so much energy for good [J].
    Yielded(f64),
    /// It carries nothing any more; what it stored is lost.
    Broken,
}

/// Energy of a few points that ride on a body's particles, and of how the material around some of them is turned.
///
/// It must depend on nothing but where the points are to each other and to the material: then momentum and angular
/// momentum are kept. [`check`](super::check()) tries that, and that the slopes are the energy's.
pub trait Element: Send + Sync {
    /// The structure's points that it hangs on, [`MOST_POINTS`] at most, none of them twice.
    fn points(&self) -> &[u32];

    /// Those of the structure's points at which it reads how the material is turned.
    fn turns(&self) -> &[u32] {
        &[]
    }

    /// Energy [J].
    fn energy(&self, at: &Local<'_>) -> f64;

    /// Adds the derivatives of the energy to `out`.
    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>);

    /// Greatest stiffness k [N/m] with which it ever resists any move of its points, in whatever state and however it
    /// is driven: no curvature of the energy by its points is above k. Where there is no such number, infinity: the
    /// step is then measured with the element as it is at the start.
    fn majorant(&self) -> f64 {
        f64::INFINITY
    }

    /// Told the value of its drive now, before it is asked for anything. Only the energy may follow it, not what the
    /// element is made of: the work that a drive does is told from what its change adds to the energy.
    fn activate(&mut self, _value: f64) {}

    /// Told where it is at the end of every step: it may yield or break.
    fn end_step(&mut self, _at: &Local<'_>) -> Change {
        Change::None
    }

    /// Tells every number that it goes on from beside what it was made of, in a fixed order; hashes of states hold
    /// them.
    fn remembered(&self, _number: &mut dyn FnMut(f64)) {}

    /// Between which of the structure's points lines are drawn; from each of its points to the next unless it says
    /// otherwise.
    fn lines(&self) -> Vec<[u32; 2]> {
        self.points().windows(2).map(|ends| [ends[0], ends[1]]).collect()
    }

    /// What resists every move from the start as much as the element ever does where it has no [`Self::majorant`];
    /// itself unless it can say more.
    fn stiffest(&self, _start: &Local<'_>) -> Box<dyn Element> {
        self.clone_box()
    }

    /// A copy in a box; bodies are cloned to be replayed or probed.
    fn clone_box(&self) -> Box<dyn Element>;
}

impl Clone for Box<dyn Element> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}
