//! Drawing fibres and sheets: from the pointer's samples to a fibre or a sheet in the document.

use super::frame::ViewFrame;
use super::sketch_tool::{Makes, SHORTEST_STROKE, SketchTool, Stage, StrokeOutcome};
use crate::edit::Command;
use crate::edit::fibre_ops::{self, FibreEditError};
use crate::edit::sheet_ops;
use crate::scene::{Fibre, FibreSource, Mismatch, Sheet, StrokePair, SweptStrokes, ViewStroke};
use crate::sketch::{SketchError, View};
use crate::ui::context::{Context, Severity, Step};
use crate::ui::editing::set_fibres;
use egui::{CursorIcon, Event, PointerButton, Pos2, Response, Ui};

/// What is drawn and what becomes of it.
pub(crate) struct Sketching {
    /// The strokes so far.
    pub tool: SketchTool,
    /// What two strokes make.
    pub makes: Makes,
    /// Whether the next stroke takes the place of the selected fibre's in its view.
    pub redraws: bool,
    /// The stroke that was to take its place, and did not fit.
    refused: Option<ViewStroke>,
    /// Whether the coach still explains the first fibre.
    pub coach: bool,
}

impl Default for Sketching {
    fn default() -> Self {
        Self { tool: SketchTool::default(), makes: Makes::default(), redraws: false, refused: None, coach: true }
    }
}

impl Sketching {
    /// Forgets what is drawn so far: another body is drawn into.
    pub(crate) fn forget(&mut self) {
        self.tool = SketchTool::default();
        self.redraws = false;
        self.refused = None;
    }

    /// Takes the last stroke back.
    pub(crate) fn cancel(&mut self) {
        if self.refused.take().is_none() {
            self.tool.cancel();
        }
        self.redraws = false;
    }

    /// Has the next stroke take the place of the selected fibre's, or no longer.
    pub(crate) fn toggle_redraw(&mut self, cx: &mut Context) {
        self.redraws = !self.redraws;
        self.refused = None;
        if self.redraws {
            cx.say(Severity::Note, "Draw the stroke again in either of the fibre's two views");
        }
    }

    /// Takes every pointer sample of a stroke.
    pub(crate) fn draw(&mut self, ui: &Ui, response: &Response, view: View, frame: &ViewFrame, cx: &mut Context) {
        let primary = PointerButton::Primary;
        if response.drag_started_by(primary)
            && !ui.input(|input| input.modifiers.alt)
            && let Some(at) = ui.input(|input| input.pointer.press_origin())
        {
            self.refused = None;
            self.tool.press(view, frame.pixel(at), frame.drawn(view, at));
        }
        if !self.tool.draws_in(view) {
            if response.hovered() {
                ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
                cx.status.hint = match self.tool.first() {
                    Some(first) if first.view != view && self.makes == Makes::Sheet => {
                        "Draw the way along which the first stroke is swept; Escape takes the first one back"
                    }
                    Some(first) if first.view != view => {
                        "Draw the second stroke between the guides; Escape takes the first one back"
                    }
                    Some(_) => "Draw the second stroke in another view, or draw this one again",
                    None => "Drag to draw the first stroke",
                };
            }
            return;
        }
        cx.status.hint = "Escape cancels this stroke";
        // Moves come several to a frame, and each is a sample of the stroke.
        let moves: Vec<Pos2> = ui.input(|input| {
            input
                .events
                .iter()
                .filter_map(|event| match event {
                    Event::PointerMoved(at) => Some(*at),
                    _ => None,
                })
                .collect()
        });
        for at in moves {
            self.tool.drag(frame.pixel(at), frame.drawn(view, at));
        }
        if response.drag_stopped_by(primary)
            && let Some(outcome) = self.tool.release(cx.sampling(), self.makes)
        {
            self.released(outcome, cx);
        }
    }

    /// Takes refused strokes by stretching the second onto the first.
    pub(crate) fn stretch(&mut self, cx: &mut Context) {
        if let Some(stroke) = self.refused.take() {
            self.put_in_place(stroke, Mismatch::Stretch, cx);
        } else if self.is_refused()
            && let Some(outcome) = self.tool.stretch(cx.active.diagonal())
        {
            self.released(outcome, cx);
        }
    }

    /// Whether the strokes that are drawn were refused and can be stretched.
    pub(crate) fn is_refused(&self) -> bool {
        self.refused.is_some() || matches!(self.tool.stage(), Stage::Refused { .. })
    }

    /// What a released stroke leads to.
    fn released(&mut self, outcome: StrokeOutcome, cx: &mut Context) {
        match outcome {
            StrokeOutcome::Slip(length) => cx.say(
                Severity::Warning,
                format!("That stroke was only {length:.0} pixels long; draw at least {SHORTEST_STROKE:.0}"),
            ),
            StrokeOutcome::First if self.redraws => self.redraw(cx),
            StrokeOutcome::First if self.makes == Makes::Sheet => {
                cx.say(Severity::Note, "Now draw in another view along what it is to be swept");
            }
            StrokeOutcome::Swept(strokes) => self.add_sheet(strokes, cx),
            StrokeOutcome::First => cx.say(Severity::Note, "Now draw the same fibre as the other view sees it"),
            StrokeOutcome::Refused(error) => {
                let error: SketchError = error;
                cx.say(Severity::Error, error.to_string());
            }
            StrokeOutcome::Pair { strokes, lifted } => {
                let notes: Vec<String> = lifted.notes.iter().map(ToString::to_string).collect();
                self.add_fibre(strokes, cx);
                if !notes.is_empty() {
                    cx.say(Severity::Warning, notes.join(". "));
                }
            }
        }
    }

    /// The stroke that was just drawn takes the place of the selected fibre's in that view.
    fn redraw(&mut self, cx: &mut Context) {
        let Some(stroke) = self.tool.first().cloned() else { return };
        self.tool = SketchTool::default();
        self.put_in_place(ViewStroke::new(stroke.view, stroke.points), Mismatch::Clip, cx);
    }

    /// Puts a stroke in the place of the selected fibre's; one that does not fit can be stretched.
    fn put_in_place(&mut self, stroke: ViewStroke, mismatch: Mismatch, cx: &mut Context) {
        let Some((_, fibre)) = cx.selected_fibre() else { return };
        let mut fibre = fibre.clone();
        if let FibreSource::Strokes(pair) = &mut fibre.source
            && mismatch == Mismatch::Stretch
        {
            pair.mismatch = mismatch;
        }
        let edited = fibre_ops::redraw(&fibre, stroke.view, stroke.points.clone(), cx.sampling());
        self.redraws = edited.is_err();
        if matches!(edited, Err(FibreEditError::Sketch(SketchError::Overlap { .. }))) {
            self.refused = Some(stroke);
        }
        set_fibres(cx, "Redraw", edited.map(|edited| vec![edited]), Step::Own);
    }

    fn add_fibre(&mut self, strokes: StrokePair, cx: &mut Context) {
        let Some(body) = cx.active_body() else {
            cx.say(Severity::Error, "Fibres go into fibre solids: choose one in the list of bodies");
            return;
        };
        let taken = |n: &usize| body.fibres.iter().any(|fibre| fibre.id == format!("fibre-{n}"));
        let number = (1..=body.fibres.len() + 1).find(|n| !taken(n)).unwrap_or(1);
        let fibre = Fibre::drawn(format!("fibre-{number}"), strokes)
            .with_name(format!("Fibre {number}"))
            .with_stiffness(fibre_ops::rigidity_of(&body.material, fibre_ops::STIFFER))
            .with_volume_fraction(fibre_ops::NEW_VOLUME_FRACTION);
        let body = body.id.clone();
        let id = fibre.id.clone();
        cx.status.drawn_fibre = Some(id.clone());
        self.coach = false;
        cx.say(Severity::Note, format!("{} is in the solid", fibre.name));
        cx.edit(&Command::AddFibre { body, fibre }, Step::Own);
        cx.selection.only(id);
    }

    fn add_sheet(&mut self, strokes: SweptStrokes, cx: &mut Context) {
        let Some(body) = cx.active_body() else {
            cx.say(Severity::Error, "Sheets go into fibre solids: choose one in the list of bodies");
            return;
        };
        let sheet = Sheet::swept("sheet-0", strokes)
            .with_name("Sheet 0")
            .with_stiffness(sheet_ops::stiffness_of(&body.material, sheet_ops::STIFFER))
            .with_volume_fraction(sheet_ops::NEW_VOLUME_FRACTION);
        let sheet = sheet_ops::copy(&sheet, &body.sheets);
        let (body, id) = (body.id.clone(), sheet.id.clone());
        self.coach = false;
        cx.say(Severity::Note, format!("{} is in the solid", sheet.name));
        cx.edit(&Command::AddSheet { body, sheet }, Step::Own);
        cx.selection.choose_sheet(id);
    }
}
