//! What the newest change does: the scene plays again from its start in slow motion beside itself as it was before, and
//! by how much the body differs is told at it.

use super::context::{Context, EffectNote, Ghost};
use super::top_bar::TopBar;
use crate::geometry::difference::{Difference, Ends};
use crate::scene::Scene;
use crate::sim::SimCommand;
use std::sync::Arc;

/// Simulated over real time.
const SPEED: f64 = 0.1;
/// As many frames for each of the scene's, so that slow motion is smooth.
const FINER: f64 = 8.0;
/// How much of the motion is shown [s, simulated].
const LASTS: f64 = 0.4;
/// What is seen.
const CAPTION: &str = "Beside it, pale, the same without the last change. Draw on, or Escape, when you have seen it.";

/// Shows what the newest change does, until the scene is changed, Escape is pressed or another ghost is chosen.
#[derive(Default)]
pub(super) struct EffectShow {
    plays: Option<Playing>,
}

struct Playing {
    scene: Arc<Scene>,
    body: usize,
    /// The ends of the body as it lies in its model frame.
    ends: Option<Ends>,
    /// By how much it has differed at the most so far.
    greatest: Difference,
}

impl EffectShow {
    /// Begins to play what is open.
    pub(super) fn begin(&mut self, cx: &mut Context, top_bar: &mut TopBar) {
        let mut finer = (**cx.scene()).clone();
        finer.time.frames_per_second *= FINER;
        cx.simulation.show_instead(Some(Arc::new(finer)), &cx.document);
        cx.simulation.choose_ghost(Some(Ghost::BeforeEdit), &cx.document);
        top_bar.choose_speed(SPEED, cx);
        cx.ask(SimCommand::Reset);
        cx.ask(SimCommand::Play);
        cx.caption = Some(CAPTION);
        cx.ghost_beside = true;
        let body = cx.active.index;
        let scene = Arc::clone(cx.scene());
        self.plays = Some(Playing { scene, body, ends: None, greatest: Difference::default() });
    }

    /// Whether it plays.
    pub(super) fn plays(&self) -> bool {
        self.plays.is_some()
    }

    /// Measures what is shown, begins again after a while, and ends once the person goes on.
    pub(super) fn watch(&mut self, ctx: &egui::Context, cx: &mut Context, top_bar: &mut TopBar) {
        let Some(playing) = &mut self.plays else { return };
        let is_left = ctx.input(|input| input.key_pressed(egui::Key::Escape));
        let is_other = !Arc::ptr_eq(&playing.scene, cx.scene()) || cx.simulation.ghost() != Some(Ghost::BeforeEdit);
        if is_left || is_other {
            self.end(cx, top_bar);
            return;
        }
        let published = cx.simulation.published();
        if !cx.simulation.is_up_to_date() || published.status.baking.is_some() {
            return;
        }
        let at_rest = published.at_rest.bodies.get(playing.body).map(|body| &body.particles[..]);
        let ends = playing.ends.take().or_else(|| Ends::of(at_rest?));
        let live = published.snapshot.bodies.get(playing.body).map(|body| &body.particles[..]);
        let before = published.ghost.as_ref().and_then(|ghost| ghost.bodies.get(playing.body));
        if let (Some(ends), Some(live), Some(before)) = (&ends, live, before) {
            let now = Difference::between(ends, live, &before.particles);
            playing.greatest = playing.greatest.greater(now);
            let top = live.iter().copied().fold(live[0], |top, at| if at.y > top.y { at } else { top });
            cx.effect = Some(EffectNote { text: playing.greatest.told(), at: top });
        }
        playing.ends = ends;
        if cx.simulation.published().status.time >= LASTS {
            cx.ask(SimCommand::Reset);
        }
    }

    fn end(&mut self, cx: &mut Context, top_bar: &mut TopBar) {
        self.plays = None;
        cx.caption = None;
        cx.effect = None;
        cx.ghost_beside = false;
        if cx.simulation.ghost() == Some(Ghost::BeforeEdit) {
            cx.simulation.choose_ghost(None, &cx.document);
        }
        if cx.simulation.shows_instead() {
            cx.simulation.show_instead(None, &cx.document);
        }
        top_bar.choose_speed(1.0, cx);
    }
}
