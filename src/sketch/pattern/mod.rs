//! Patterns: layouts of fibres to start from, fitted to a box; each makes one deformation plain.
//!
//! How it works. A layout is drawn in the unit cube and stretched into the box, less a margin, so that no number a person
//! types can lead out of it. What has to know the box (angles, lengths, which way is flat) is told its extents.
//!
//! Why not fitted to the surface. Fibres that leave a model's surface are trimmed when they are put into it, as those that
//! were drawn by hand; a pattern is a start and is edited as any fibre.

mod curves;
mod lines;
mod own;
mod planes;
mod shipped;

pub use own::{OwnPattern, PatternError};
pub use shipped::PATTERNS;

use glam::DVec3;

/// Vertices of one fibre [m].
pub type Polyline = Vec<DVec3>;

/// Number that a pattern is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Stable identifier, unique within the pattern.
    pub id: &'static str,
    /// Name a person reads.
    pub title: &'static str,
    /// What it changes, for a person.
    pub tip: &'static str,
    /// Unit a person reads; empty for counts and shares.
    pub unit: &'static str,
    /// What it is unless it is changed.
    pub default: f64,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// Whether it is rounded to a whole number.
    pub whole: bool,
}

impl Parameter {
    /// The value nearest to `value` that is allowed; the default for what is no number.
    pub fn held(&self, value: f64) -> f64 {
        if !value.is_finite() {
            return self.default;
        }
        let [least, greatest] = self.range;
        let held = value.clamp(least, greatest);
        if self.whole { held.round() } else { held }
    }
}

/// A layout of fibres with parameters.
#[derive(Clone, Copy, Debug)]
pub struct Pattern {
    /// Stable identifier, unique among the patterns.
    pub id: &'static str,
    /// Name a person reads.
    pub title: &'static str,
    /// What the fibres do to a solid, in a line.
    pub does: &'static str,
    /// What it is given; the last one is the margin as a share of the box's least extent.
    pub parameters: &'static [Parameter],
    /// Bending stiffness of its fibres over their axial rigidity, in particle spacings squared: fibres in the middle plane of
    /// something flat carry it by bending alone.
    pub bending: f64,
    /// Polylines in the unit cube, from the values before the margin.
    layout: fn(&[f64], &Inner) -> Vec<Polyline>,
}

impl Pattern {
    /// The pattern with this identifier.
    pub fn by_id(id: &str) -> Option<&'static Self> {
        PATTERNS.iter().find(|pattern| pattern.id == id)
    }

    /// Value of every parameter unless it is changed.
    pub fn defaults(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.default).collect()
    }

    /// The fibres' vertices [m] in the box from `min` to `max` [m], model frame, by the values of the parameters in their
    /// order. Values are held within their ranges, those that are left out are defaults. A box without volume has none.
    pub fn lay(&self, values: &[f64], min: DVec3, max: DVec3) -> Vec<Polyline> {
        let held: Vec<f64> = self
            .parameters
            .iter()
            .enumerate()
            .map(|(k, parameter)| parameter.held(values.get(k).copied().unwrap_or(parameter.default)))
            .collect();
        let Some((&margin, values)) = held.split_last() else { return Vec::new() };
        let extents = max - min;
        if !(extents.is_finite() && extents.min_element() > 0.0) {
            return Vec::new();
        }
        let margin = margin * extents.min_element();
        let (low, high) = (min + margin, max - margin);
        let inner = Inner::new(high - low);
        let mut fibres = (self.layout)(values, &inner);
        for vertex in fibres.iter_mut().flatten() {
            // Twice held: first against layouts that overshoot, then against the last bit of the sum.
            *vertex = (low + vertex.clamp(DVec3::ZERO, DVec3::ONE) * inner.size).clamp(low, high);
        }
        fibres
    }
}

/// The box that is filled, less its margin.
struct Inner {
    /// Extents [m].
    size: DVec3,
    /// Axes from the longest to the thinnest; of equal ones Y before X before Z.
    order: [usize; 3],
}

impl Inner {
    fn new(size: DVec3) -> Self {
        let mut order = [1, 0, 2];
        order.sort_by(|&a, &b| size[b].total_cmp(&size[a]));
        Self { size, order }
    }

    /// A place of the unit cube by its share along the longest, the middle and the thinnest axis.
    fn place(&self, along: f64, across: f64, through: f64) -> DVec3 {
        let mut place = DVec3::ZERO;
        for (axis, share) in self.order.into_iter().zip([along, across, through]) {
            place[axis] = share;
        }
        place
    }
}

/// `count` vertices of a curve over [0, 1].
fn curve(count: f64, at: impl Fn(f64) -> DVec3) -> Polyline {
    let last = (count - 1.0).max(1.0);
    (0..=last as usize).map(|k| at(k as f64 / last)).collect()
}

/// A straight fibre of `count` vertices.
fn line(count: f64, from: DVec3, to: DVec3) -> Polyline {
    curve(count, |t| from.lerp(to, t))
}

/// Shares of [0, 1] for `count` things side by side: the middle for a single one, from end to end for more.
fn side_by_side(count: f64) -> impl Iterator<Item = f64> + Clone {
    let count = count as usize;
    (0..count).map(move |k| if count == 1 { 0.5 } else { k as f64 / (count - 1) as f64 })
}
