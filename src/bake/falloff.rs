//! How much of the material is fibre or sheet at a distance from one.

use crate::geometry::kernel::Kernel;
use crate::scene::{Falloff, Material};

/// Share of the volume fraction that is left at a distance [m].
pub(super) fn curve(material: &Material, kernel: Kernel) -> impl Fn(f64) -> f64 + Sync + use<> {
    let (falloff, h) = (material.volume_fraction_falloff, kernel.support_radius);
    move |distance: f64| match falloff {
        Falloff::Kernel => kernel.relative(distance),
        Falloff::Linear => (1.0 - distance / h).max(0.0),
        Falloff::Constant => f64::from(u8::from(distance < h)),
    }
}
