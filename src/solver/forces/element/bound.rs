//! What bounds the stiffness of an element.

use super::contract::{Element, Local, Slopes};
use glam::DVec3;

/// As stiff against any move of points against each other as an element of a majorant k ever is: `k/2 sum |p - mean|²`.
/// It keeps no torque and moves nothing: the stable step is measured with it.
#[derive(Clone, Debug)]
pub(crate) struct Bound {
    points: Vec<u32>,
    /// [N/m]
    stiffness: f64,
}

impl Bound {
    pub(super) fn new(points: &[u32], stiffness: f64) -> Self {
        Self { points: points.to_vec(), stiffness }
    }
}

fn mean(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

impl Element for Bound {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        let mean = mean(at.points);
        0.5 * self.stiffness * at.points.iter().map(|p| p.distance_squared(mean)).sum::<f64>()
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let mean = mean(at.points);
        for (slope, point) in out.points.iter_mut().zip(at.points) {
            *slope += self.stiffness * (*point - mean);
        }
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(self.clone())
    }
}
