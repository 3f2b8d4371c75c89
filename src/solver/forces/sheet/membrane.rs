//! One triangle of a sheet: stretch and shear in its own surface.

use glam::{DMat2, DVec2, DVec3};

/// Stretch, relative to the greatest, below which that of a triangle that is pressed flat counts as so much: there its
/// directions would be no numbers.
const FLATTEST: f64 = 1e-9;

/// What the triangles of a sheet are made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MembraneLaw {
    /// `l_s Et / (2 (1 + nu))` [N/m].
    pub mu: f64,
    /// `l_s nu Et / (1 - nu²)` [N/m].
    pub lambda: f64,
    /// `l_s Et_m` of the grain [N/m].
    pub grain: f64,
}

/// A triangle at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleRest {
    /// Its vertices among the sheet's.
    pub vertices: [u32; 3],
    /// Inverse of `Dm`, whose columns are both edges from the first vertex in the sheet's two directions [1/m].
    pub inverse: DMat2,
    /// Area [m²].
    pub area: f64,
    /// Unit vector of the grain in these directions.
    pub grain: DVec2,
}

impl TriangleRest {
    /// A triangle between points at rest [m], `along` the first direction of the sheet and `grain` that of its threads,
    /// both vectors of space of any length; what is across the triangle of them does not count. None where it has no
    /// area or the direction none in it.
    pub fn new(vertices: [u32; 3], x: [DVec3; 3], [along, grain]: [DVec3; 2]) -> Option<Self> {
        let (a, b) = (x[1] - x[0], x[2] - x[0]);
        let normal = a.cross(b);
        let area = 0.5 * normal.length();
        let up = normal.try_normalize()?;
        let flat = |v: DVec3| v - up * up.dot(v);
        let first = flat(along).try_normalize()?;
        let second = up.cross(first);
        let within = |v: DVec3| DVec2::new(v.dot(first), v.dot(second));
        let edges = DMat2::from_cols(within(a), within(b));
        let inverse = edges.inverse();
        let grain = within(flat(grain)).try_normalize().unwrap_or(DVec2::X);
        inverse.is_finite().then_some(Self { vertices, inverse, area, grain })
    }

    /// Columns of F, of points at `x` [m], the sheet at rest being larger by `metric` along its two directions.
    fn gradient(&self, x: [DVec3; 3], metric: DVec2) -> [DVec3; 2] {
        let (a, b) = (x[1] - x[0], x[2] - x[0]);
        let [first, second] = [self.inverse.x_axis, self.inverse.y_axis];
        [(a * first.x + b * first.y) / metric.x, (a * second.x + b * second.y) / metric.y]
    }

    /// Energy [J].
    pub fn energy(&self, law: &MembraneLaw, x: [DVec3; 3], metric: DVec2) -> f64 {
        let f = self.gradient(x, metric);
        let e = stretch_of(f).stretch - DMat2::IDENTITY;
        let trace = e.x_axis.x + e.y_axis.y;
        let square = e.x_axis.length_squared() + e.y_axis.length_squared();
        let mut density = law.mu * square + 0.5 * law.lambda * trace * trace;
        if law.grain > 0.0 {
            let longer = (f[0] * self.grain.x + f[1] * self.grain.y).length() - 1.0;
            density += 0.5 * law.grain * longer * longer;
        }
        self.area * metric.x * metric.y * density
    }

    /// Gradients of the energy by its second and third point [N]; that by the first is less their sum.
    pub fn slopes(&self, law: &MembraneLaw, x: [DVec3; 3], metric: DVec2) -> [DVec3; 2] {
        let f = self.gradient(x, metric);
        let Stretch { stretch, inverse } = stretch_of(f);
        let e = stretch - DMat2::IDENTITY;
        let trace = e.x_axis.x + e.y_axis.y;
        // P = R sigma = F U^-1 sigma.
        let sigma = inverse * (e * (2.0 * law.mu) + DMat2::IDENTITY * (law.lambda * trace));
        let mut p = [0, 1].map(|k| f[0] * sigma.col(k).x + f[1] * sigma.col(k).y);
        if law.grain > 0.0 {
            let along = f[0] * self.grain.x + f[1] * self.grain.y;
            let length = along.length();
            if length > 0.0 {
                let pull = along * (law.grain * (length - 1.0) / length);
                p[0] += pull * self.grain.x;
                p[1] += pull * self.grain.y;
            }
        }
        let area = self.area * metric.x * metric.y;
        let (p, q) = (p[0] * (area / metric.x), p[1] * (area / metric.y));
        let [first, second] = [self.inverse.x_axis, self.inverse.y_axis];
        [p * first.x + q * second.x, p * first.y + q * second.y]
    }
}

/// U of `F = R U`.
struct Stretch {
    stretch: DMat2,
    inverse: DMat2,
}

/// By Cayley and Hamilton: `U = (C + s I) / t`, `C = F^T F`, `s = det U`, `t = tr U`.
fn stretch_of([a, b]: [DVec3; 2]) -> Stretch {
    let c = DMat2::from_cols_array(&[a.dot(a), a.dot(b), a.dot(b), b.dot(b)]);
    let trace = c.x_axis.x + c.y_axis.y;
    // The determinant of C as a cross product: it is never below zero.
    let s = a.cross(b).length().max(FLATTEST * trace).max(f64::MIN_POSITIVE);
    let t = (trace + 2.0 * s).sqrt();
    let stretch = (c + DMat2::IDENTITY * s) * (1.0 / t);
    // The inverse of a symmetric matrix of 2 x 2 with determinant s and trace t.
    let inverse = (DMat2::IDENTITY * t - stretch) * (1.0 / s);
    Stretch { stretch, inverse }
}
