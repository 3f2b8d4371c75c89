//! Fibres that break are said when they do.

use super::app::{App, Gravity};
use crate::sim::Published;
use crate::solver::snapshot::FibreBreak;

impl App {
    /// Says what has broken since the last picture, and takes that back once nothing is broken any more.
    pub(super) fn watch_breaks(&mut self, next: &Published) {
        if !next.compared.is_empty() || !self.published.compared.is_empty() {
            return;
        }
        let bodies = next.snapshot.bodies.iter().enumerate();
        let all: Vec<(usize, &FibreBreak)> =
            bodies.flat_map(|(index, body)| body.breaks.iter().map(move |at| (index, at))).collect();
        let newest = all.iter().max_by(|a, b| a.1.time.total_cmp(&b.1.time));
        // By its time alone: an edit may have renumbered bodies and fibres.
        let said = self.seeing.broke.take();
        let last = said.as_ref().map_or(f64::NEG_INFINITY, |(time, _)| *time);
        match (newest, said) {
            (Some(&(body, at)), _) if at.time > last => {
                let in_all = if all.len() > 1 { format!(", {} breaks in all", all.len()) } else { String::new() };
                let text = format!("Fibre {} broke at {:.3} s{in_all}", self.fibre_name(next, body, at.fibre), at.time);
                self.seeing.broke = Some((at.time, text.clone()));
                self.say(Gravity::Note, text);
            }
            (Some((_, at)), Some((_, text))) => self.seeing.broke = Some((at.time, text)),
            (None, Some((_, text))) if self.message() == Some(&text) => self.message = None,
            _ => {}
        }
    }

    /// What a person calls a fibre of a picture.
    fn fibre_name(&self, shown: &Published, body: usize, fibre: u32) -> String {
        let id = shown.snapshot.bodies.get(body).and_then(|body| body.fibres.get(fibre as usize));
        let id = id.map_or_else(|| fibre.to_string(), |fibre| fibre.id.clone());
        let fibres = self.scene().bodies.get(body).map_or(&[][..], |body| &body.fibres);
        fibres.iter().find(|fibre| fibre.id == id).map_or(id, |fibre| fibre.title().to_owned())
    }
}
