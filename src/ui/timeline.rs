//! The timeline: what is kept of the motion, to be scrubbed, stepped through, replayed and gone on from.

use super::action::Action;
use super::context::{Context, Request, Severity};
use super::controls::{button, key_of};
use super::drives::{Columns, DriveLanes};
use super::preferences::{MEMORY, memory_name};
use super::theme::{self, GRID};
use super::timescale::TimeScale;
use crate::sim::{DEFAULT_MEMORY, Published, SimCommand};
use crate::text::number::{duration, memory, moment};
use egui::{Align2, FontId, Pos2, Rangef, Rect, Response, Sense, Shape, Stroke, Ui, Vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Height of the panel's content [points].
const HEIGHT: f32 = 8.0 * GRID;
/// Height of the bar that is dragged in, and how far its ends lie inside [points].
const BAR: f32 = 4.0 * GRID;
const INSET: f32 = 2.0 * GRID;
/// Buttons with a sign [points].
const BUTTON: Vec2 = Vec2::new(6.0 * GRID, 6.0 * GRID);
/// Room of the read-out of memory, so that its digits move nothing [points].
const MEMORY_WIDTH: f32 = 44.0 * GRID;
/// Height of the panel with the lanes of drives, and the least that it may be given [points].
const LANES: f32 = 52.0 * GRID;
const LEAST: f32 = 26.0 * GRID;
/// Half the width of a mark [points].
const MARK: f32 = GRID;
const MIB: usize = 1 << 20;

/// What is remembered of the timeline from one start to the next.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct RememberedTimeline {
    shown: bool,
    /// Memory that frames may take [MiB].
    memory: usize,
    /// Whether the lanes of drives are shown.
    #[serde(default)]
    drives: bool,
}

impl Default for RememberedTimeline {
    fn default() -> Self {
        Self { shown: true, memory: DEFAULT_MEMORY / MIB, drives: false }
    }
}

/// The bar below the views in which the motion is scrubbed, with its buttons.
#[derive(Default)]
pub(super) struct Timeline {
    remembered: RememberedTimeline,
    /// Time under the pointer while it drags [s]; the last one that was asked for, and what was shown then.
    held: Option<f64>,
    asked: Option<(f64, Arc<Published>)>,
    /// How many of the simulation's words on it have been passed on.
    said: u64,
    lanes: DriveLanes,
}

/// What a button shows.
#[derive(Clone, Copy)]
enum Sign {
    First,
    Back,
    Replay,
    Pause,
    Forward,
}

impl Timeline {
    /// What is to be remembered of it.
    pub(super) fn to_remember(&self) -> RememberedTimeline {
        self.remembered
    }

    /// Goes on with the timeline of the last time.
    pub(super) fn recall(&mut self, last: RememberedTimeline, cx: &Context) {
        (self.remembered.shown, self.remembered.drives) = (last.shown, last.drives);
        self.choose_memory(last.memory.clamp(MEMORY[0], MEMORY[MEMORY.len() - 1]), cx);
    }

    /// Whether it is shown rather than folded away.
    pub(super) fn is_shown(&self) -> bool {
        self.remembered.shown
    }

    /// Folds it away, or shows it again.
    pub(super) fn fold(&mut self) {
        self.remembered.shown = !self.remembered.shown;
    }

    /// Whether the lanes of drives are shown below it.
    pub(super) fn shows_drives(&self) -> bool {
        self.remembered.shown && self.remembered.drives
    }

    /// Folds the lanes away, or shows them again.
    pub(super) fn fold_drives(&mut self) {
        self.remembered.drives = !self.shows_drives();
        self.remembered.shown |= self.remembered.drives;
    }

    /// Memory that frames may take [MiB].
    pub(crate) fn memory(&self) -> usize {
        self.remembered.memory
    }

    /// Takes another.
    pub(crate) fn choose_memory(&mut self, mebibytes: usize, cx: &Context) {
        self.remembered.memory = mebibytes;
        cx.ask(SimCommand::Memory(mebibytes * MIB));
    }

    /// Passes on what the simulation says of going on from an earlier frame, and shows the timeline unless it is folded
    /// away.
    pub(super) fn show(&mut self, ui: &mut Ui, cx: &mut Context) {
        let (count, said) = &cx.simulation.published().status.recording.continued;
        if *count != self.said {
            self.said = *count;
            let said = said.clone();
            cx.say(Severity::Note, said);
            ui.ctx().request_repaint();
        }
        if !self.remembered.shown {
            return;
        }
        let frame = theme::panel(ui);
        if !self.remembered.drives {
            egui::Panel::bottom("timeline").exact_size(HEIGHT + GRID).frame(frame).show(ui, |ui| {
                self.row(ui, cx);
            });
            return;
        }
        let most = (0.5 * ui.ctx().content_rect().height()).max(LEAST);
        // Where nothing is driven yet, one line says how something is.
        let panel = if DriveLanes::count(cx.scene()) == 0 {
            egui::Panel::bottom("timeline without drives").exact_size(LEAST)
        } else {
            egui::Panel::bottom("timeline with drives").resizable(true).default_size(LANES).size_range(LEAST..=most)
        };
        let shown = panel.frame(frame).show(ui, |ui| {
            let (scale, columns) = self.row(ui, cx);
            self.lanes.show(ui, cx, &scale, columns);
        });
        // What is pressed elsewhere in the window is done to something else than the selected keys.
        let pressed = ui.input(|input| input.pointer.any_pressed().then(|| input.pointer.interact_pos()).flatten());
        let is_elsewhere = |at: Pos2| {
            let is_over = ui.ctx().layer_id_at(at).is_some_and(|layer| layer.order != egui::Order::Background);
            !is_over && !shown.response.rect.contains(at)
        };
        if pressed.is_some_and(is_elsewhere) {
            cx.keys.clear();
        }
    }

    /// The row of buttons with the bar between them; gives the scale of time, and where the columns of lanes below lie.
    fn row(&mut self, ui: &mut Ui, cx: &mut Context) -> (TimeScale, Columns) {
        let place = Rect::from_min_size(ui.max_rect().min, Vec2::new(ui.available_width(), HEIGHT + GRID));
        let layout = egui::Layout::left_to_right(egui::Align::Center);
        let scale = ui.scope_builder(egui::UiBuilder::new().max_rect(place).layout(layout), |ui| {
            ui.spacing_mut().item_spacing.x = 0.5 * GRID;
            sign_button(ui, cx, Action::FirstFrame, Sign::First);
            sign_button(ui, cx, Action::StepBack, Sign::Back);
            if cx.simulation.is_playing() {
                sign_button(ui, cx, Action::PlayPause, Sign::Pause);
            } else {
                sign_button(ui, cx, Action::Replay, Sign::Replay);
            }
            sign_button(ui, cx, Action::Step, Sign::Forward);
            drives_switch(ui, cx);
            ui.spacing_mut().item_spacing.x = 2.0 * GRID;
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                self.memory_menu(ui, cx);
                button(ui, cx, Action::Live, "Live");
                button(ui, cx, Action::GoOn, "Go on from here");
                self.track(ui, cx)
            })
            .inner
        });
        let (scale, bar) = scale.inner;
        ui.advance_cursor_after_rect(place);
        let courses = bar.shrink(INSET);
        let columns = Columns {
            names: Rangef::new(place.left(), bar.min),
            courses,
            fields: Rangef::new(bar.max + 2.0 * GRID, place.right() - 2.0 * GRID),
        };
        (scale, columns)
    }

    /// How much is kept; opens what may be.
    fn memory_menu(&mut self, ui: &mut Ui, cx: &Context) {
        let recording = &cx.simulation.published().status.recording;
        let length = recording.span.map_or(0.0, |[first, last]| last - first);
        let text = format!("{} kept, {}", duration(length), memory(recording.bytes, recording.limit));
        let tooltip = format!(
            "{} frames of the motion are kept in {} of memory; the oldest make room for new ones. Click to change how much",
            recording.frames,
            memory(recording.bytes, recording.limit)
        );
        let size = Vec2::new(MEMORY_WIDTH, HEIGHT);
        ui.allocate_ui_with_layout(size, egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.set_min_width(MEMORY_WIDTH);
            let menu = ui.menu_button(egui::RichText::new(text).small(), |ui| {
                ui.label(egui::RichText::new("Memory for the motion").weak());
                for choice in MEMORY {
                    if ui.selectable_label(self.remembered.memory == choice, memory_name(choice)).clicked() {
                        self.choose_memory(choice, cx);
                        ui.close();
                    }
                }
            });
            menu.response.on_hover_text(tooltip);
        });
    }

    /// The bar in which the motion is scrubbed; gives its scale of time and where it lies.
    fn track(&mut self, ui: &mut Ui, cx: &mut Context) -> (TimeScale, Rangef) {
        let place = Rect::from_min_size(ui.max_rect().min, Vec2::new(ui.available_width(), HEIGHT));
        let response = ui.allocate_rect(place, Sense::click_and_drag());
        let bar = Rect::from_min_size(place.min + Vec2::new(0.0, 0.5 * GRID), Vec2::new(place.width(), BAR));
        let span = cx.simulation.published().status.recording.span.filter(|_| !cx.simulation.is_comparing());
        let frame = cx.scene().time.frame_seconds();
        let until = if self.remembered.drives { DriveLanes::last(cx.scene()) } else { 0.0 };
        let places = bar.shrink2(Vec2::new(INSET, 0.0)).x_range();
        let scale = TimeScale::new(span.unwrap_or([0.0; 2]), until, frame, places);
        let scale = self.lanes.held_scale().unwrap_or(scale);
        let Some(span) = span.filter(|_| bar.width() > 4.0 * INSET) else {
            let why = if cx.simulation.is_comparing() {
                "Nothing is recorded while integrators are compared"
            } else {
                "Nothing is kept yet"
            };
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, why));
            ui.painter().rect_filled(bar, 4.0, ui.visuals().extreme_bg_color);
            let ink = ui.visuals().weak_text_color();
            ui.painter().text(bar.center(), Align2::CENTER_CENTER, why, FontId::proportional(11.0), ink);
            return (scale, bar.x_range());
        };
        self.scrub(&response, &scale, span, cx);
        let shown = self.held.unwrap_or(cx.simulation.published().status.time).clamp(span[0], span[1]);
        let spoken = format!("Timeline from {} to {}", moment(span[0], frame), moment(span[1], frame));
        response.widget_info(|| egui::WidgetInfo::slider(true, shown, &spoken));
        paint_track(ui, cx, bar, &scale, span, shown);
        if let Some(at) = response.hover_pos() {
            cx.status.hint = "Drag to see the motion at another time; pulls, strikes and edits go on from there";
            // Above the pointer, where it hides neither labels nor the hint.
            let under = scale.time(at.x).clamp(span[0], span[1]);
            let mut tip = egui::Tooltip::for_enabled(&response);
            tip.popup = tip.popup.anchor(Rect::from_x_y_ranges(at.x..=at.x, bar.y_range())).align(egui::RectAlign::TOP);
            tip.show(|ui| ui.label(words_at(cx, &scale, at.x, under)));
        }
        (scale, bar.x_range())
    }

    /// Asks for the frame under the pointer while it is pressed: one at a time, the newest.
    fn scrub(&mut self, response: &Response, scale: &TimeScale, span: [f64; 2], cx: &mut Context) {
        let pressed = response.is_pointer_button_down_on().then(|| response.interact_pointer_pos()).flatten();
        if let Some(at) = pressed {
            self.held = Some(scale.time(at.x).clamp(span[0], span[1]));
        }
        let Some(time) = self.held else { return };
        let waits = self.asked.as_ref().filter(|(asked, _)| *asked == time);
        match waits {
            None => {
                cx.simulation.replay(SimCommand::Show(time));
                self.asked = Some((time, Arc::clone(cx.simulation.published())));
            }
            // The head stays under the pointer until what was asked for last has come.
            Some((_, shown)) if pressed.is_none() && !Arc::ptr_eq(shown, cx.simulation.published()) => {
                (self.held, self.asked) = (None, None);
            }
            Some(_) => {}
        }
    }
}

/// The switch of the lanes below.
fn drives_switch(ui: &mut Ui, cx: &mut Context) {
    let is_on = cx.actions[Action::Drives].on == Some(true);
    let tooltip = format!("{} ({})", Action::Drives.tooltip(), key_of(ui, Action::Drives));
    let text = match DriveLanes::count(cx.scene()) {
        0 => "Drives".to_owned(),
        count => format!("Drives {count}"),
    };
    if ui.selectable_label(is_on, egui::RichText::new(text).small()).on_hover_text(tooltip).clicked() {
        cx.request(Request::Do(Action::Drives));
    }
}

/// A button for an action that shows a sign in place of its name.
fn sign_button(ui: &mut Ui, cx: &mut Context, action: Action, sign: Sign) {
    let name = match sign {
        Sign::Pause => "Hold the motion",
        _ => action.name(),
    };
    let disabled = cx.actions[action].disabled;
    let response = ui.add_enabled_ui(disabled.is_none(), |ui| {
        let (place, response) = ui.allocate_exact_size(BUTTON, Sense::click());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, ui.is_enabled(), name));
        let visuals = ui.style().interact(&response);
        if response.hovered() || response.has_focus() {
            ui.painter().rect_filled(place, visuals.corner_radius, visuals.weak_bg_fill);
        }
        for shape in sign.shapes(place.center(), visuals.text_color()) {
            ui.painter().add(shape);
        }
        response
    });
    let response = response.inner.on_hover_text(format!("{} ({})", action.tooltip(), key_of(ui, action)));
    if response.on_disabled_hover_text(disabled.unwrap_or_default()).clicked() {
        cx.request(Request::Do(action));
    }
}

/// What is to be said of a place of the bar, at which a time [s] lies.
fn words_at(cx: &Context, scale: &TimeScale, x: f32, time: f64) -> String {
    let recording = &cx.simulation.published().status.recording;
    let near = |marks: &[f64]| marks.iter().any(|mark| (scale.place(*mark) - x).abs() <= MARK);
    let mut words = moment(time, cx.scene().time.frame_seconds());
    if near(&recording.edits) {
        words.push_str("\nThe scene was changed");
    }
    if near(&recording.breaks) {
        words.push_str("\nA fibre broke, or a seam began to tear");
    }
    words
}

/// Paints the bar with what is kept of the motion and the time that is shown.
fn paint_track(ui: &Ui, cx: &Context, bar: Rect, scale: &TimeScale, span: [f64; 2], shown: f64) {
    let painter = ui.painter();
    let visuals = ui.visuals();
    let accent = theme::color(cx.tone.pictures().accent);
    painter.rect_filled(bar, 4.0, visuals.extreme_bg_color);
    let [first, last, head] = [span[0], span[1], shown].map(|time| scale.place(time));
    let kept = Rect::from_x_y_ranges(first..=last.max(first + 1.0), bar.y_range());
    painter.rect_filled(kept, 2.0, accent.gamma_multiply(0.25));
    let played = Rect::from_x_y_ranges(first..=head.max(first + 1.0), bar.y_range());
    painter.rect_filled(played, 2.0, accent.gamma_multiply(0.35));
    let ink = visuals.weak_text_color();
    for (time, text) in scale.ticks() {
        let x = scale.place(time);
        painter.vline(x, bar.bottom()..=bar.bottom() + GRID, Stroke::new(1.0, ink.gamma_multiply(0.6)));
        let at = Pos2::new(x, bar.bottom() + GRID);
        painter.text(at, Align2::CENTER_TOP, text, FontId::proportional(10.0), ink);
    }
    let recording = &cx.simulation.published().status.recording;
    for time in &recording.edits {
        let top = Pos2::new(scale.place(*time), bar.top());
        painter.add(wedge(top, visuals.text_color()));
    }
    for time in &recording.breaks {
        let at = Pos2::new(scale.place(*time), bar.bottom() - 1.5 * GRID);
        painter.circle_filled(at, 0.75 * MARK, cx.tone.error());
    }
    painter.vline(head, bar.y_range(), Stroke::new(2.0, accent));
    let knob = Pos2::new(head, bar.center().y);
    painter.circle(knob, 1.5 * GRID, accent, Stroke::new(1.5, visuals.panel_fill));
}

/// A small mark that points down from the upper edge of the bar.
fn wedge(top: Pos2, colour: egui::Color32) -> Shape {
    let points = vec![top + Vec2::new(-MARK, 0.0), top + Vec2::new(MARK, 0.0), top + Vec2::new(0.0, 1.5 * MARK)];
    Shape::convex_polygon(points, colour, Stroke::NONE)
}

impl Sign {
    /// The sign about a point.
    fn shapes(self, at: Pos2, colour: egui::Color32) -> Vec<Shape> {
        let triangle = |x: f32, toward: f32| {
            let tip = at + Vec2::new(x + 4.0 * toward, 0.0);
            let base = x - 4.0 * toward;
            let points = vec![tip, at + Vec2::new(base, -5.0), at + Vec2::new(base, 5.0)];
            Shape::convex_polygon(points, colour, Stroke::NONE)
        };
        let upright = |x: f32| {
            let place = Rect::from_center_size(at + Vec2::new(x, 0.0), Vec2::new(2.0, 10.0));
            Shape::rect_filled(place, 0.0, colour)
        };
        match self {
            Self::First => vec![upright(-5.0), triangle(1.0, -1.0)],
            Self::Back => vec![triangle(-1.0, -1.0), upright(5.0)],
            Self::Replay => vec![triangle(0.0, 1.0)],
            Self::Pause => vec![upright(-3.0), upright(3.0)],
            Self::Forward => vec![upright(-5.0), triangle(1.0, 1.0)],
        }
    }
}
