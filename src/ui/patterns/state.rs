//! Which pattern is chosen, with which numbers, and where it goes.

use super::own::OwnPatterns;
use crate::edit::Command;
use crate::edit::fibre_ops::{BENDING, Called, laid, made_to_act};
use crate::scene::{Body, Drivable, Fibre, Scene, SharedDrive};
use crate::sketch::pattern::{Act, Laid, Pattern, Polyline};
use crate::solver::snapshot::Snapshot;
use crate::ui::clipboard::copied_pattern;
use crate::ui::context::{Context, PatternPreview, Severity, Step};
use crate::ui::thumbs::Thumbs;
use glam::DVec3;
use std::cell::RefCell;
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::Arc;

/// The patterns that there are, and what is done with them.
#[derive(Default)]
pub(crate) struct Patterns {
    /// The pattern that is shown with its numbers; the gallery is shown where there is none.
    pub chosen: Option<Chosen>,
    /// Values that were changed, by the pattern: they are there when it is chosen again.
    pub values: HashMap<&'static str, Vec<f64>>,
    /// What it is fitted to.
    pub fit: Fit,
    /// Least and greatest corner of the part of the body that is filled, model frame [m].
    pub region: Option<[DVec3; 2]>,
    /// Whether the fibres that are there make room.
    pub replaces: bool,
    /// A person's own.
    pub own: OwnPatterns,
    /// Pictures of what those do that come with the program.
    pub strips: Thumbs,
    /// The last layout in a solid, and of what: it takes longer than a picture may.
    laid: RefCell<Option<(Of, Laid)>>,
}

/// What a layout in a solid follows from.
struct Of {
    pattern: &'static str,
    values: Vec<f64>,
    filled: [DVec3; 2],
    model: Arc<Snapshot>,
}

impl Of {
    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.model, &other.model)
            && (self.pattern, &self.values, self.filled) == (other.pattern, &other.values, other.filled)
    }
}

/// A pattern.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Chosen {
    /// One that comes with the program, by its identifier.
    Shipped(&'static str),
    /// A person's own, by its file.
    Own(PathBuf),
}

/// What a pattern is fitted to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Fit {
    /// The whole body.
    #[default]
    Whole,
    /// A part of it.
    Region,
}

/// What takes the shared drives away that nothing but these fibres follows, and those that stay.
fn left_alone(scene: &Scene, body: &Body, gone: &[Fibre]) -> (Vec<Command>, Vec<SharedDrive>) {
    let of = |drive: &SharedDrive| Drivable::Shared { body: body.id.clone(), drive: drive.id.clone() };
    let is_gone =
        |one: &Drivable| matches!(one, Drivable::Fibre { fibre, .. } if gone.iter().any(|old| old.id == *fibre));
    let is_alone = |drive: &&SharedDrive| {
        let followers = of(drive).followers(scene);
        !followers.is_empty() && followers.iter().all(is_gone)
    };
    let (alone, stay): (Vec<_>, Vec<_>) = body.drives.iter().partition(is_alone);
    let remove = alone.into_iter().map(|drive| Command::SetDrive { of: of(drive), drive: None }).collect();
    (remove, stay.into_iter().cloned().collect())
}

impl Patterns {
    /// Keeps a person's own patterns in this folder; nowhere unless one is given.
    #[must_use]
    pub(crate) fn with_folder(self, folder: PathBuf) -> Self {
        Self { own: OwnPatterns::of(folder), ..self }
    }

    /// Fills this part of the body: least and greatest corner, model frame [m].
    pub(crate) fn fill_region(&mut self, region: [DVec3; 2]) {
        self.region = Some(region);
    }

    /// Fills the whole body again. To be called while boxes are dragged around a part of it.
    pub(crate) fn leave_region(&mut self) {
        self.fit = Fit::Whole;
        self.forget_region();
    }

    /// Forgets the region: it was a part of another body.
    pub(crate) fn forget_region(&mut self) {
        self.region = None;
    }

    /// Values of a pattern's parameters.
    pub(crate) fn values_of(&self, pattern: &Pattern) -> Vec<f64> {
        self.values.get(pattern.id).cloned().unwrap_or_else(|| pattern.defaults())
    }

    /// What the views show of the chosen pattern, by whether the patterns are shown.
    pub(crate) fn preview(&self, tab_is_shown: bool, cx: &Context) -> PatternPreview {
        let is_shown = tab_is_shown && self.chosen.is_some() && cx.active_body().is_some();
        PatternPreview {
            lines: if is_shown { self.lines(cx) } else { Vec::new() },
            bounds: self.filled_box(cx),
            is_shown,
            takes_region: is_shown && self.fit == Fit::Region,
        }
    }

    /// The box that the chosen pattern fills: least and greatest corner, model frame [m].
    pub(crate) fn filled_box(&self, cx: &Context) -> Option<[DVec3; 2]> {
        let whole = cx.active.corners()?;
        match self.fit {
            Fit::Whole => Some(whole),
            Fit::Region => Some(self.region.unwrap_or(whole)),
        }
    }

    /// The chosen pattern's fibres where they would be, model frame [m].
    pub(crate) fn lines(&self, cx: &Context) -> Vec<Polyline> {
        self.laid(cx).fibres
    }

    /// The chosen pattern as it lies in the solid.
    pub(super) fn laid(&self, cx: &Context) -> Laid {
        let Some(filled) = self.filled_box(cx) else { return Laid::default() };
        match &self.chosen {
            Some(Chosen::Shipped(id)) => {
                Pattern::by_id(id).map_or_else(Laid::default, |pattern| self.laid_into(pattern, filled, cx))
            }
            Some(Chosen::Own(path)) => {
                let fibres = self.own.get(path).map_or_else(Vec::new, |own| own.lay(filled[0], filled[1]));
                Laid { fibres, ..Laid::default() }
            }
            None => Laid::default(),
        }
    }

    fn laid_into(&self, pattern: &'static Pattern, filled: [DVec3; 2], cx: &Context) -> Laid {
        let of =
            Of { pattern: pattern.id, values: self.values_of(pattern), filled, model: Arc::clone(&cx.active.model) };
        let mut known = self.laid.borrow_mut();
        if let Some((before, laid)) = &*known
            && before.is(&of)
        {
            return laid.clone();
        }
        let particles = of.model.bodies.first().map_or(&[][..], |body| &body.particles);
        let laid = pattern.lay_into(&of.values, filled, particles);
        *known = Some((of, laid.clone()));
        laid
    }

    /// What each of so many fibres of the chosen pattern does by itself; empty where they only resist.
    fn acts(&self, fibres: usize) -> Vec<Option<Act>> {
        match &self.chosen {
            Some(Chosen::Shipped(id)) => {
                Pattern::by_id(id).map_or_else(Vec::new, |pattern| pattern.acts(&self.values_of(pattern), fibres))
            }
            Some(Chosen::Own(path)) => self.own.get(path).map_or_else(Vec::new, |own| own.acts().to_vec()),
            None => Vec::new(),
        }
    }

    /// Name of the chosen pattern, how the identifiers of its fibres begin, and how they bend.
    fn called(&self) -> Option<(String, String, f64)> {
        match self.chosen.as_ref()? {
            Chosen::Shipped(id) => {
                Pattern::by_id(id).map(|pattern| (pattern.title.to_owned(), pattern.id.to_owned(), pattern.bending))
            }
            Chosen::Own(path) => {
                let title = self.own.get(path)?.title().to_owned();
                Some((title, "pattern".to_owned(), BENDING))
            }
        }
    }

    /// Puts the chosen pattern on the clipboard.
    pub(super) fn copy(&self, ctx: &egui::Context, cx: &mut Context) {
        let Some((title, _, bending)) = self.called() else { return };
        let does = match &self.chosen {
            Some(Chosen::Shipped(id)) => Pattern::by_id(id).map_or("", |pattern| pattern.does),
            Some(Chosen::Own(path)) => self.own.get(path).map_or("", |own| own.does()),
            None => "",
        };
        let acts = self.acts(cx.pattern.lines.len());
        if let Some(text) = copied_pattern(&title, does, acts, bending, cx) {
            ctx.copy_text(text);
        }
    }

    /// Puts the chosen pattern's fibres into the body, in one step.
    pub(crate) fn add(&mut self, cx: &mut Context) {
        let lines = self.lines(cx);
        let (Some(body), Some((title, id, bending))) = (cx.active_body(), self.called()) else { return };
        let spacing = cx.sampling().spacing;
        let gone: &[Fibre] = if self.replaces { &body.fibres } else { &[] };
        let stay: &[Fibre] = if self.replaces { &[] } else { &body.fibres };
        let mut fibres = laid(Called { id: &id, title: &title, bending, spacing }, &lines, &body.material, stay);
        let (drives_gone, drives_left) = left_alone(cx.scene(), body, gone);
        let drives = made_to_act(&mut fibres, (&lines, &self.acts(lines.len())), &id, &drives_left);
        let added: Vec<String> = fibres.iter().map(|fibre| fibre.id.clone()).collect();
        let remove = gone.iter().map(|old| Command::RemoveFibre { body: body.id.clone(), fibre: old.id.clone() });
        let add = Command::additions(&body.id, drives, fibres);
        let name = match gone.len() {
            0 => format!("Add pattern {title}"),
            _ => format!("Replace fibres by pattern {title}"),
        };
        let command = Command::Many { name, commands: remove.chain(drives_gone).chain(add).collect() };
        let said = match added.len() {
            1 => format!("{title}: one fibre is in the solid"),
            count => format!("{title}: {count} fibres are in the solid"),
        };
        cx.say(Severity::Note, said);
        cx.edit(&command, Step::Own);
        cx.selection.set(added);
        // They are fibres like any other now; the gallery offers the next pattern.
        self.chosen = None;
    }
}
