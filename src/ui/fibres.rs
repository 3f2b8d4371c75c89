//! From released strokes to a fibre in the document, and what can be chosen about it after.

use super::app::{App, Gravity};
use super::sketch_tool::{Outcome, SHORTEST_STROKE, SketchTool};
use crate::edit::{Command, fibre_ops};
use crate::scene::{Body, Extra, Fibre, FibreSource, Mismatch, RestShape, Stiffness, StrokePair};
use crate::sketch::{Lifted, View};
use egui::Ui;

impl App {
    /// What a released stroke leads to.
    pub(super) fn sketched(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Slip(length) => self.say(
                Gravity::Warning,
                format!("That stroke was only {length:.0} pixels long; draw at least {SHORTEST_STROKE:.0}"),
            ),
            Outcome::First if self.editing.redraws => self.redraw(),
            Outcome::First => self.say(Gravity::Note, "Now draw the same fibre as the other view sees it"),
            Outcome::Refused(error) => self.say(Gravity::Error, error.to_string()),
            Outcome::Pair { strokes, lifted } => {
                let notes: Vec<String> = lifted.notes.iter().map(ToString::to_string).collect();
                self.add_fibre(strokes);
                if !notes.is_empty() {
                    self.say(Gravity::Warning, notes.join(". "));
                }
            }
        }
    }

    /// The stroke that was just drawn takes the place of the selected fibre's in that view.
    fn redraw(&mut self) {
        let Some(stroke) = self.tool.first().cloned() else { return };
        self.tool = SketchTool::default();
        let Some((_, fibre)) = self.selected_fibre() else { return };
        let points = stroke.points.iter().map(glam::DVec2::to_array).collect();
        let edited = fibre_ops::redraw(fibre, stroke.view, points, self.sampling());
        self.editing.redraws = edited.is_err();
        self.set_fibres("Redraw", edited.map(|edited| vec![edited]), None);
    }

    fn add_fibre(&mut self, strokes: StrokePair) {
        let Some(body) = self.active_body() else {
            self.say(Gravity::Error, "Fibres go into fibre solids: choose one in the list of bodies");
            return;
        };
        let taken = |n: &usize| body.fibres.iter().any(|fibre| fibre.id == format!("fibre-{n}"));
        let number = (1..=body.fibres.len() + 1).find(|n| !taken(n)).unwrap_or(1);
        let fibre = Fibre {
            id: format!("fibre-{number}"),
            name: format!("Fibre {number}"),
            hidden: false,
            color: None,
            source: FibreSource::Strokes(strokes),
            stiffness: Stiffness::Rigidity(fibre_ops::rigidity_of(&body.material, fibre_ops::STIFFER)),
            volume_fraction: fibre_ops::NEW_VOLUME_FRACTION,
            rest_shape: RestShape::AsDrawn,
            break_past: None,
            extra: Extra::new(),
        };
        let body = body.id.clone();
        self.drawn_last = Some(fibre.id.clone());
        let id = fibre.id.clone();
        self.coach = false;
        self.say(Gravity::Note, format!("{} is in the solid", fibre.name));
        self.gesture += 1;
        self.apply(&Command::AddFibre { body, fibre });
        self.editing.selection.only(id);
    }

    /// The selected fibre and the body that it lies in.
    pub(super) fn selected_fibre(&self) -> Option<(&Body, &Fibre)> {
        let body = self.active_body()?;
        let id = self.editing.selection.active()?;
        Some((body, body.fibres.iter().find(|fibre| fibre.id == *id)?))
    }

    /// How the selected fibre's strokes are lifted now; none for a fibre without strokes.
    pub(super) fn selected_lift(&self) -> Option<(&StrokePair, Lifted)> {
        let (_, fibre) = self.selected_fibre()?;
        let FibreSource::Strokes(pair) = &fibre.source else { return None };
        Some((pair, pair.lifted(self.model_diagonal()).ok()?))
    }

    /// Views in which the selected fibre's strokes were drawn.
    pub(super) fn selected_views(&self) -> Vec<View> {
        match self.selected_fibre().map(|(_, fibre)| &fibre.source) {
            Some(FibreSource::Strokes(pair)) => vec![pair.first.view, pair.second.view],
            _ => Vec::new(),
        }
    }

    /// Buttons that take the selected fibre's strokes another way.
    pub(super) fn stroke_choices(&mut self, ui: &mut Ui) {
        let Some((pair, lifted)) = self.selected_lift() else { return };
        let mut changed = pair.clone();
        let tooltip = "Takes the second stroke from its other end: the start dots are green";
        if ui.button("Flip second stroke").on_hover_text(tooltip).clicked() {
            changed.flip_second = !changed.flip_second;
        }
        let clipped = lifted.clipped.iter().any(|parts| !parts.is_empty());
        if pair.mismatch == Mismatch::Stretch || clipped {
            let (text, tooltip, mismatch) = match pair.mismatch {
                Mismatch::Clip => ("Stretch instead", "Stretches the second stroke onto the first", Mismatch::Stretch),
                Mismatch::Stretch => ("Clip instead", "Cuts both strokes to what they share", Mismatch::Clip),
            };
            if ui.button(text).on_hover_text(tooltip).clicked() {
                changed.mismatch = mismatch;
            }
        }
        let Some((body, fibre)) = self.selected_fibre().filter(|_| changed != *pair) else { return };
        let fibre = Fibre { source: FibreSource::Strokes(changed), ..fibre.clone() };
        let body = body.id.clone();
        self.gesture += 1;
        self.apply(&Command::SetFibre { body, fibre });
    }
}
