//! Patterns: layouts of fibres, shown with what they do, fitted to the body and added to it as fibres.

mod own;
mod panel;
mod place;
mod tiles;

pub(super) use own::{Question, ask};

use super::action::Action;
use super::app::{App, Gravity, PropertyTab};
use super::thumbs::Thumbs;
use crate::draw::Bounds;
use crate::edit::Command;
use crate::edit::fibre_ops::{BENDING, Called, laid};
use crate::scene::Fibre;
use crate::sketch::View;
use crate::sketch::pattern::{Pattern, Polyline};
use glam::{DVec2, DVec3};
use own::Own;
use std::collections::HashMap;
use std::path::PathBuf;

/// What the panel keeps.
#[derive(Default)]
pub(super) struct Patterns {
    chosen: Option<Chosen>,
    /// Values that were changed, by the pattern: they are there when it is chosen again.
    values: HashMap<&'static str, Vec<f64>>,
    fit: Fit,
    /// Least and greatest corner of the part of the body that is filled, model frame [m].
    region: Option<[DVec3; 2]>,
    /// Where a box around that part begins, and in which view.
    drag: Option<(View, DVec2)>,
    /// Whether the fibres that are there make room.
    replaces: bool,
    own: Own,
    strips: Thumbs,
}

/// A pattern.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Chosen {
    /// One that comes with the program, by its identifier.
    Shipped(&'static str),
    /// A person's own, by its file.
    Own(PathBuf),
}

/// What a pattern is fitted to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Fit {
    /// The whole body.
    #[default]
    Whole,
    /// A part of it.
    Region,
}

impl Patterns {
    /// Forgets the region: it was a part of another body.
    pub(super) fn forget_region(&mut self) {
        (self.region, self.drag) = (None, None);
    }

    /// Values of a pattern's parameters.
    fn values_of(&self, pattern: &Pattern) -> Vec<f64> {
        self.values.get(pattern.id).cloned().unwrap_or_else(|| pattern.defaults())
    }
}

impl App {
    /// Shows the patterns.
    pub(super) fn show_patterns(&mut self) {
        self.tab = PropertyTab::Patterns;
    }

    /// Whether an action on patterns can be asked for just now.
    pub(super) fn can_keep_pattern(&self) -> bool {
        self.active_body().is_some_and(|body| !body.fibres.is_empty())
    }

    /// Whether a pattern is chosen and shown.
    pub(super) fn lays_pattern(&self) -> bool {
        self.tab == PropertyTab::Patterns && self.patterns.chosen.is_some() && self.active_body().is_some()
    }

    /// Least and greatest corner of the active body at rest, model frame [m].
    fn body_box(&self) -> Option<[DVec3; 2]> {
        let body = self.model.bodies.first()?;
        let points = if body.skin.is_empty() { &body.particles } else { &body.skin };
        Bounds::of(points.iter().copied()).map(|bounds| [bounds.min, bounds.max])
    }

    /// The box that the chosen pattern fills.
    fn pattern_box(&self) -> Option<[DVec3; 2]> {
        let whole = self.body_box()?;
        match self.patterns.fit {
            Fit::Whole => Some(whole),
            Fit::Region => Some(self.patterns.region.unwrap_or(whole)),
        }
    }

    /// The chosen pattern's fibres where they would be, model frame [m]; none while no pattern is shown.
    pub fn pattern_preview(&self) -> Vec<Polyline> {
        let Some([min, max]) = self.pattern_box().filter(|_| self.lays_pattern()) else { return Vec::new() };
        match &self.patterns.chosen {
            Some(Chosen::Shipped(id)) => Pattern::by_id(id)
                .map_or_else(Vec::new, |pattern| pattern.lay(&self.patterns.values_of(pattern), min, max)),
            Some(Chosen::Own(path)) => self.patterns.own.get(path).map_or_else(Vec::new, |own| own.lay(min, max)),
            None => Vec::new(),
        }
    }

    /// Name of the chosen pattern, how the identifiers of its fibres begin, and how they bend.
    fn chosen_pattern(&self) -> Option<(String, String, f64)> {
        match self.patterns.chosen.as_ref()? {
            Chosen::Shipped(id) => {
                Pattern::by_id(id).map(|pattern| (pattern.title.to_owned(), pattern.id.to_owned(), pattern.bending))
            }
            Chosen::Own(path) => {
                let title = self.patterns.own.get(path)?.title().to_owned();
                Some((title, "pattern".to_owned(), BENDING))
            }
        }
    }

    /// Puts the chosen pattern's fibres into the body, in one step.
    fn add_pattern(&mut self) {
        let lines = self.pattern_preview();
        let (Some(body), Some((title, id, bending))) = (self.active_body(), self.chosen_pattern()) else { return };
        let spacing = self.sampling().spacing;
        let gone: &[Fibre] = if self.patterns.replaces { &body.fibres } else { &[] };
        let stay: &[Fibre] = if self.patterns.replaces { &[] } else { &body.fibres };
        let fibres = laid(Called { id: &id, title: &title, bending, spacing }, &lines, &body.material, stay);
        let added: Vec<String> = fibres.iter().map(|fibre| fibre.id.clone()).collect();
        let remove = gone.iter().map(|old| Command::RemoveFibre { body: body.id.clone(), fibre: old.id.clone() });
        let add = fibres.into_iter().map(|fibre| Command::AddFibre { body: body.id.clone(), fibre });
        let name = match gone.len() {
            0 => format!("Add pattern {title}"),
            _ => format!("Replace fibres by pattern {title}"),
        };
        let command = Command::Many { name, commands: remove.chain(add).collect() };
        let said = match added.len() {
            1 => format!("{title}: one fibre is in the solid"),
            count => format!("{title}: {count} fibres are in the solid"),
        };
        self.say(Gravity::Note, said);
        self.gesture += 1;
        self.apply(&command);
        self.editing.selection.set(added);
        // They are fibres like any other now; the gallery offers the next pattern.
        self.patterns.chosen = None;
    }

    /// Leaves a region; whether there was one.
    pub(super) fn leave_region(&mut self) -> bool {
        let held = self.takes_region();
        if held {
            self.patterns.fit = Fit::Whole;
            self.patterns.forget_region();
        }
        held
    }

    /// What of patterns is asked for by a command.
    pub(super) fn pattern_action(&mut self, action: Action) {
        match action {
            Action::KeepPattern => self.ask_to_keep(),
            _ => self.show_patterns(),
        }
    }
}
