//! How an element's force hangs on what it measures.
//!
//! Energies are `E = m0 psi(x)` with `x = m / m0 + c` of a length, an area or a volume m, m0 that at rest and c the
//! share by which a drive has it want to be smaller; `E = psi(x)` with `x = m - m0 + c` [rad] of an angle. So psi' is
//! dE/dm: a force [N], a tension [N/m], a pressure [Pa] or a moment [N m]. As psi'' does not hang on c, no drive makes
//! an element stiffer.

/// Widths of a muscle over which its force is told where it is steepest by.
const STEEPEST: f64 = 2.0;

/// psi of an element, by its slope psi'.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Law {
    /// `psi' = k (x - rest)`.
    Spring(f64),
    /// The same where it is pulled, and nothing where it is pressed.
    TensionOnly(f64),
    /// `psi' = T0 a max(0, 1 - q²)`, `q = (x - rest) / w`, a how far it is excited.
    Muscle {
        /// T0.
        force: f64,
        /// w.
        width: f64,
    },
    /// Between given points straight, beyond the first and the last as there.
    Table(Vec<[f64; 2]>),
}

/// A law about the value of x at rest, 1 of sizes and 0 of angles, excited so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Excited<'a> {
    pub(super) law: &'a Law,
    pub(super) rest: f64,
    /// a of a muscle.
    pub(super) by: f64,
}

impl Excited<'_> {
    /// psi, nothing at rest.
    pub(super) fn energy(self, x: f64) -> f64 {
        let from = x - self.rest;
        match self.law {
            Law::Spring(k) => 0.5 * k * from * from,
            Law::TensionOnly(k) => 0.5 * k * from.max(0.0).powi(2),
            Law::Muscle { force, width } => {
                let q = (from / width).clamp(-1.0, 1.0);
                force * self.by * width * (q - q * q * q / 3.0)
            }
            Law::Table(points) => integral(points, self.rest, x),
        }
    }

    /// psi'.
    pub(super) fn slope(self, x: f64) -> f64 {
        let from = x - self.rest;
        match self.law {
            Law::Spring(k) => k * from,
            Law::TensionOnly(k) => k * from.max(0.0),
            Law::Muscle { force, width } => {
                let q = from / width;
                force * self.by * (1.0 - q * q).max(0.0)
            }
            Law::Table(points) => value(points, x),
        }
    }
}

impl Law {
    /// Greatest psi'' anywhere, a muscle fully excited; never below zero.
    pub(super) fn steepest(&self) -> f64 {
        match self {
            Self::Spring(k) | Self::TensionOnly(k) => *k,
            Self::Muscle { force, width } => STEEPEST * force / width,
            Self::Table(points) => points.windows(2).map(rise).fold(0.0, f64::max),
        }
    }

    /// Greatest of `psi'(x) / (x - c)` over all x of a size above c, for any c from `least` to `most`, which is how a
    /// pulled line resists sideways; infinite where it still pulls as it vanishes.
    pub(super) fn greatest_over_size(&self, [least, most]: [f64; 2]) -> f64 {
        match self {
            // As `k (x - 1) / (x - c)`, whose bound is that of ever longer ones for c up to 1.
            Self::Spring(k) | Self::TensionOnly(k) if most <= 1.0 => *k,
            // Up to `1 - w` it does not pull; beyond it is below a line through there of its greatest slope.
            Self::Muscle { width, .. } if most <= 1.0 - width => self.steepest(),
            Self::Spring(_) | Self::TensionOnly(_) | Self::Muscle { .. } => f64::INFINITY,
            // Over a straight piece this is monotone: the greatest is at an end of one.
            Self::Table(points) => [least, most].map(|c| greatest_quotient(points, c)).into_iter().fold(0.0, f64::max),
        }
    }
}

fn greatest_quotient(points: &[[f64; 2]], c: f64) -> f64 {
    if value(points, c) > 0.0 {
        return f64::INFINITY;
    }
    // Straight from nothing at c the quotient is the slope of that piece.
    let beyond = points.iter().filter(|[x, _]| *x > c).map(|[x, y]| y / (x - c));
    let here = points.windows(2).filter(|of| of[0][0] <= c && c < of[1][0]).map(rise);
    beyond.chain(here).fold(0.0, f64::max)
}

fn rise(of: &[[f64; 2]]) -> f64 {
    (of[1][1] - of[0][1]) / (of[1][0] - of[0][0])
}

fn value(points: &[[f64; 2]], x: f64) -> f64 {
    match points.partition_point(|point| point[0] <= x) {
        0 => points.first().map_or(0.0, |point| point[1]),
        k if k == points.len() => points[k - 1][1],
        k => points[k - 1][1] + rise(&points[k - 1..=k]) * (x - points[k - 1][0]),
    }
}

/// Integral of the table from one place to another, piece by piece, each exactly.
fn integral(points: &[[f64; 2]], from: f64, to: f64) -> f64 {
    if to < from {
        return -integral(points, to, from);
    }
    let inner = points.iter().map(|point| point[0]).filter(|x| (from..to).contains(x));
    let mut sum = 0.0;
    let mut last = from;
    for next in inner.chain([to]) {
        sum += 0.5 * (value(points, last) + value(points, next)) * (next - last);
        last = next;
    }
    sum
}
