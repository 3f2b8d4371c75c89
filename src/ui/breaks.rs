//! Fibres that break are said when they do.

use super::context::{Context, Severity};
use crate::scene::Scene;
use crate::sim::Published;
use crate::solver::snapshot::FibreBreak;
use std::sync::Arc;

/// What was said of breaks.
#[derive(Debug, Default)]
pub(super) struct BreakWatch {
    /// The last break that was said: its time [s] and the words.
    broke: Option<(f64, String)>,
}

impl BreakWatch {
    /// Says what has broken in the newest state since the one before it, and takes that back once nothing is broken any
    /// more.
    pub(super) fn watch(&mut self, before: &Published, cx: &mut Context) {
        let next = Arc::clone(cx.simulation.published());
        if !next.compared.is_empty() || !before.compared.is_empty() {
            return;
        }
        let bodies = next.snapshot.bodies.iter().enumerate();
        let all: Vec<(usize, &FibreBreak)> =
            bodies.flat_map(|(index, body)| body.breaks.iter().map(move |at| (index, at))).collect();
        let newest = all.iter().max_by(|a, b| a.1.time.total_cmp(&b.1.time));
        // By its time alone: an edit may have renumbered bodies and fibres.
        let said = self.broke.take();
        let last = said.as_ref().map_or(f64::NEG_INFINITY, |(time, _)| *time);
        match (newest, said) {
            (Some(&(body, at)), _) if at.time > last => {
                let in_all = if all.len() > 1 { format!(", {} breaks in all", all.len()) } else { String::new() };
                let fibre = fibre_name(cx.scene(), &next, body, at.fibre);
                let text = format!("Fibre {fibre} broke at {:.3} s{in_all}", at.time);
                self.broke = Some((at.time, text.clone()));
                cx.say(Severity::Note, text);
            }
            (Some((_, at)), Some((_, text))) => self.broke = Some((at.time, text)),
            (None, Some((_, text))) if cx.status.message.as_ref().map(|(_, said)| said) == Some(&text) => {
                cx.status.message = None;
            }
            _ => {}
        }
    }
}

/// What a person calls a fibre of a published state.
fn fibre_name(scene: &Scene, shown: &Published, body: usize, fibre: u32) -> String {
    let id = shown.snapshot.bodies.get(body).and_then(|body| body.fibres.get(fibre as usize));
    let id = id.map_or_else(|| fibre.to_string(), |fibre| fibre.id.clone());
    let fibres = scene.bodies.get(body).map_or(&[][..], |body| &body.fibres);
    fibres.iter().find(|fibre| fibre.id == id).map_or(id, |fibre| fibre.title().to_owned())
}
