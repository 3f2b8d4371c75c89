//! Where a body stands free of all others.

use crate::draw::Bounds;
use crate::edit::body_ops::placed;
use crate::scene::{Panel, Scene};
use crate::solver::snapshot::BodySnapshot;
use crate::ui::context::Context;
use glam::DVec3;

/// A body in an empty scene is this large [m].
const HAND: f64 = 0.07;
/// A new body falls so far, in shares of its height.
const DROP: f64 = 0.15;
/// It keeps this share of its size between itself and others.
const GAP: f64 = 0.15;
/// So many places are tried to each side.
const TRIED: i32 = 12;

/// The greatest extent that a new body is to have [m]: that of the body in the middle of those that are there, by size.
pub(super) fn usual_size(cx: &Context) -> f64 {
    let bodies = &cx.simulation.published().at_rest.bodies;
    let extent = |body: &BodySnapshot| {
        let points = if body.skin.is_empty() { &body.particles } else { &body.skin };
        Bounds::of(points.iter().copied()).map(|bounds| (bounds.max - bounds.min).max_element())
    };
    let mut extents: Vec<f64> = bodies.iter().filter_map(extent).filter(|size| *size > 0.0).collect();
    extents.sort_by(f64::total_cmp);
    extents.get(extents.len() / 2).copied().unwrap_or(HAND)
}

/// Where the middle of a body of this half size [m] stands free of all others, where they are now and where they start:
/// beside them, a little above the floor, or else above them.
pub(crate) fn beside(half: DVec3, cx: &Context) -> DVec3 {
    let published = cx.simulation.published();
    let of = |points: &[DVec3]| Bounds::of(points.iter().copied());
    // The skin reaches beyond the particles, by as much as where the body is at rest.
    let reach = |index: usize| {
        let rest = published.at_rest.bodies.get(index)?;
        let [skin, particles] = [of(&rest.skin)?, of(&rest.particles)?];
        Some((particles.min - skin.min).max(skin.max - particles.max).max(DVec3::ZERO))
    };
    let now = published.snapshot.bodies.iter().enumerate().filter_map(|(index, body)| {
        let Bounds { min, max } = of(&body.particles)?;
        let reach = reach(index).unwrap_or_default();
        Some(Bounds { min: min - reach, max: max + reach })
    });
    let mut taken: Vec<Bounds> = now.collect();
    taken.extend(starts(cx));
    let around = taken.iter().copied().reduce(Bounds::union);
    let middle = around.map_or(DVec3::ZERO, |bounds| bounds.center());
    let drop = 2.0 * half.y * DROP;
    let height = match (cx.scene().room.floor, around) {
        (Some(floor), _) => floor + half.y + drop,
        (None, Some(bounds)) => bounds.center().y,
        (None, None) => half.y + drop,
    };
    let apart = half + DVec3::splat(GAP * half.max_element());
    let is_free = |at: &DVec3| {
        let own = Bounds { min: *at - apart, max: *at + apart };
        taken.iter().all(|other| own.max.cmple(other.min).any() || own.min.cmpge(other.max).any())
            && is_in_room(cx.scene(), *at, half)
    };
    let steps = (0..=TRIED).flat_map(|k| if k == 0 { vec![0] } else { vec![k, -k] });
    let step = apart.x.max(half.max_element());
    let mut tried = steps.map(|k| DVec3::new(middle.x + f64::from(k) * step, height, middle.z));
    let above = || {
        let top = around.map_or(height, |bounds| bounds.max.y + apart.y);
        DVec3::new(middle.x, top.max(height), middle.z)
    };
    tried.find(is_free).unwrap_or_else(above)
}

/// Boxes around the bodies where they start, as far as they are put together.
fn starts(cx: &Context) -> Vec<Bounds> {
    let rest = &cx.simulation.published().at_rest.bodies;
    let boxes = cx.scene().all_bodies().zip(rest).filter_map(|(body, rest)| {
        let place = |&at: &DVec3| placed(body.placement(), at);
        let points = if rest.skin.is_empty() { &rest.particles } else { &rest.skin };
        Bounds::of(points.iter().map(place))
    });
    boxes.collect()
}

/// Whether a box lies between the walls and beside what a panel can come down on.
fn is_in_room(scene: &Scene, at: DVec3, half: DVec3) -> bool {
    let room = &scene.room;
    let (low, high) = (at - half, at + half);
    let above = |least: Option<f64>, low: f64| least.is_none_or(|least| low >= least);
    let below = |most: Option<f64>, high: f64| most.is_none_or(|most| high <= most);
    let walls = above(room.x_min, low.x) && below(room.x_max, high.x) && above(room.z_min, low.z);
    let under = |panel: &Panel| {
        let away = [at.x - panel.center[0], at.z - panel.center[1]].map(f64::abs);
        away[0] < half.x + 0.5 * panel.size[0] && away[1] < half.z + 0.5 * panel.size[1]
    };
    walls && below(room.z_max, high.z) && below(room.ceiling, high.y) && !scene.panels.iter().any(under)
}
