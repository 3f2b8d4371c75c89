//! What the newest change does: the scene plays again from its start in slow motion beside itself as it was before, and
//! by how much the body differs is told at it.

use super::context::{Context, EffectNote, Ghost};
use super::slow_motion::SlowMotion;
use super::top_bar::TopBar;
use crate::geometry::difference::{Difference, Ends};
use crate::scene::Scene;
use crate::sim::SimCommand;
use std::sync::Arc;

const SHOWN: SlowMotion = SlowMotion {
    ghost: Ghost::BeforeEdit,
    speed: 0.1,
    finer: 8.0,
    caption: "Beside it, pale, the same without the last change. Draw on, or Escape, when you have seen it.",
};
/// How much of the motion is shown [s, simulated].
const LASTS: f64 = 0.4;
/// Smaller differences are not told [degrees], [share of the length].
const LEAST: [f64; 2] = [1.0, 0.005];

/// Shows what the newest change does, until the scene is changed, Escape is pressed or another ghost is chosen.
#[derive(Default)]
pub(super) struct EffectShow {
    plays: Option<Playing>,
}

struct Playing {
    scene: Arc<Scene>,
    body: usize,
    /// Simulated over real time before.
    speed: f64,
    /// The ends of the body as it lies in its model frame.
    ends: Option<Ends>,
    /// By how much it has differed at the most so far.
    greatest: Difference,
}

impl EffectShow {
    /// Begins to play what is open.
    pub(super) fn begin(&mut self, cx: &mut Context, top_bar: &mut TopBar) {
        let before = SHOWN.begin(cx, top_bar);
        // Begun again, it still goes back to what was chosen.
        let speed = self.plays.take().map_or(before, |playing| playing.speed);
        let (scene, body) = (Arc::clone(cx.scene()), cx.active.index);
        self.plays = Some(Playing { scene, body, speed, ends: None, greatest: Difference::default() });
    }

    /// Whether it plays.
    pub(super) fn plays(&self) -> bool {
        self.plays.is_some()
    }

    /// Measures what is shown, begins again after a while, and ends once the person goes on.
    pub(super) fn watch(&mut self, ctx: &egui::Context, cx: &mut Context, top_bar: &mut TopBar) {
        let Some(playing) = &mut self.plays else { return };
        let is_left = !cx.has_dialog && ctx.input(|input| input.key_pressed(egui::Key::Escape));
        let is_other = !Arc::ptr_eq(&playing.scene, cx.scene()) || cx.simulation.ghost() != Some(SHOWN.ghost);
        if is_left || is_other {
            SHOWN.end(playing.speed, cx, top_bar);
            cx.effect = None;
            self.plays = None;
            return;
        }
        let published = cx.simulation.published();
        if !cx.simulation.is_up_to_date() || published.status.baking.is_some() {
            return;
        }
        let at_rest = published.at_rest.bodies.get(playing.body).map(|body| &body.particles[..]);
        playing.ends = playing.ends.take().or_else(|| Ends::of(at_rest?));
        let live = published.snapshot.bodies.get(playing.body).map(|body| &body.particles[..]);
        let before = published.ghost.as_ref().and_then(|ghost| ghost.bodies.get(playing.body));
        if let (Some(ends), Some(live), Some(before)) = (&playing.ends, live, before)
            && let Some(top) = live.iter().copied().reduce(|top, at| if at.y > top.y { at } else { top })
        {
            playing.greatest = playing.greatest.greater(Difference::between(ends, live, &before.particles));
            cx.effect = Some(EffectNote { text: told(playing.greatest), at: top });
        }
        if cx.simulation.published().status.time >= LASTS {
            cx.ask(SimCommand::Reset);
        }
    }
}

/// What is worth telling of a difference, in words.
fn told(of: Difference) -> String {
    let mut told = Vec::new();
    if of.twist.abs() >= LEAST[0] {
        told.push(format!("{:+.0}° of twist", of.twist));
    }
    if of.lean >= LEAST[0] {
        told.push(format!("{:+.0}° of lean", of.lean));
    }
    if of.longer[1].abs() >= LEAST[1] {
        told.push(format!("{:+.1} mm of length", 1e3 * of.longer[0]));
    }
    if told.is_empty() { "no difference yet".to_owned() } else { told.join(", ") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_worth_telling_is_told_with_its_sign() {
        let of = |twist, lean, longer| told(Difference { twist, lean, longer });
        assert_eq!(of(7.5, 0.2, [0.0, 0.0]), "+8° of twist");
        assert_eq!(of(-23.2, 3.4, [-0.0021, -0.03]), "-23° of twist, +3° of lean, -2.1 mm of length");
        assert_eq!(of(0.3, 0.0, [1e-5, 1e-4]), "no difference yet");
    }
}
