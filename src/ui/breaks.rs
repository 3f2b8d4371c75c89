//! Fibres that break and bodies that tear are said when they do.

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
        let bodies = || next.snapshot.bodies.iter().enumerate();
        let all: Vec<(f64, Failure<'_>)> = bodies()
            .flat_map(|(index, body)| {
                let fibres = body.breaks.iter().map(move |at| (at.time, Failure::Fibre(index, at)));
                fibres.chain(body.first_tear.map(|time| (time, Failure::Seam(&body.name))))
            })
            .collect();
        let newest = all.iter().max_by(|a, b| a.0.total_cmp(&b.0));
        // By its time alone: an edit may have renumbered bodies and fibres.
        let said = self.broke.take();
        let last = said.as_ref().map_or(f64::NEG_INFINITY, |(time, _)| *time);
        match (newest, said) {
            (Some((time, of)), _) if *time > last => {
                let text = match of {
                    Failure::Fibre(body, at) => {
                        let breaks = bodies().map(|(_, body)| body.breaks.len()).sum::<usize>();
                        let in_all = if breaks > 1 { format!(", {breaks} breaks in all") } else { String::new() };
                        format!("Fibre {} broke at {time:.3} s{in_all}", fibre_name(cx.scene(), &next, *body, at.fibre))
                    }
                    Failure::Seam(body) => format!("{body} began to tear at {time:.3} s"),
                };
                self.broke = Some((*time, text.clone()));
                cx.say(Severity::Note, text);
            }
            (Some((time, _)), Some((_, text))) => self.broke = Some((*time, text)),
            (None, Some((_, text))) if cx.status.message.as_ref().map(|(_, said)| said) == Some(&text) => {
                cx.status.message = None;
            }
            _ => {}
        }
    }
}

/// What has given way.
enum Failure<'a> {
    /// A fibre of a body by its index.
    Fibre(usize, &'a FibreBreak),
    /// A seam of a body of this name.
    Seam(&'a str),
}

/// What a person calls a fibre of a published state.
fn fibre_name(scene: &Scene, shown: &Published, body: usize, fibre: u32) -> String {
    let id = shown.snapshot.bodies.get(body).and_then(|body| body.fibres.get(fibre as usize));
    let id = id.map_or_else(|| fibre.to_string(), |fibre| fibre.id.clone());
    let fibres = scene.bodies.get(body).map_or(&[][..], |body| &body.fibres);
    fibres.iter().find(|fibre| fibre.id == id).map_or(id, |fibre| fibre.title().to_owned())
}
