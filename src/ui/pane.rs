//! One of the three views: two to draw in, one to watch.

use super::app::App;
use super::camera::{Ease, facing};
use super::picture::{Picture, Shown, Sight};
use super::theme;
use crate::draw::{Display, SkinStyle};
use crate::render::Camera;
use crate::sketch::View;
use egui::{Event, PointerButton, Pos2, Rect, Response, Sense, Ui};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::sync::Arc;

/// What a view is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum PaneKind {
    /// Strokes are drawn into the model at rest.
    Drawing(View),
    /// The simulation is watched and pulled.
    Result,
}

/// One view.
pub struct Pane {
    pub(super) kind: PaneKind,
    pub(super) camera: Camera,
    /// Where its camera was sent, until it arrives.
    pub(super) ease: Option<Ease>,
    /// Whether its camera has been fitted to what is there.
    pub(super) framed: bool,
    /// Whether it has been fitted before.
    pub(super) shown: bool,
    /// Where it lay in the last frame.
    pub(super) rect: Rect,
    pub(super) picture: Picture,
}

impl Pane {
    pub(super) fn new(kind: PaneKind) -> Self {
        let camera = match kind {
            PaneKind::Drawing(view) => Camera::facing(facing(view)),
            PaneKind::Result => Camera::perspective(),
        };
        Self { kind, camera, ease: None, framed: false, shown: false, rect: Rect::NOTHING, picture: Picture::default() }
    }

    pub(super) fn title(&self) -> &'static str {
        match self.kind {
            PaneKind::Drawing(view) => view_name(view),
            PaneKind::Result => "Result",
        }
    }
}

pub(super) fn view_name(view: View) -> &'static str {
    match view {
        View::Front => "Front",
        View::Side => "Side",
        View::Top => "Top",
    }
}

/// Only what a view is for is remembered: where its camera stands follows from what there is to see.
impl Serialize for Pane {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.kind.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Pane {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        PaneKind::deserialize(deserializer).map(Self::new)
    }
}

/// One view while it is shown.
pub(super) struct View3d<'a> {
    pub(super) app: &'a mut App,
    pub(super) pane: &'a mut Pane,
}

/// The rectangle of a view and the camera in it.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) rect: Rect,
    pub(super) camera: Camera,
}

impl Frame {
    pub(super) fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.rect.width()), f64::from(self.rect.height()))
    }

    pub(super) fn pixel(&self, at: Pos2) -> DVec2 {
        DVec2::new(f64::from(at.x - self.rect.min.x), f64::from(at.y - self.rect.min.y))
    }

    pub(super) fn screen(&self, point: DVec3) -> Option<Pos2> {
        let pixel = self.camera.project(point, self.size())?.pixel;
        Some(self.rect.min + egui::vec2(pixel.x as f32, pixel.y as f32))
    }

    /// The point of a drawing view's plane under a pixel, in the view's own coordinates [m].
    pub(super) fn drawn(&self, view: View, at: Pos2) -> DVec2 {
        view.project(self.camera.ray(self.pixel(at), self.size()).origin)
    }

    /// Where a drawing view shows a point of its plane.
    pub(super) fn shown(&self, view: View, point: DVec2) -> Option<Pos2> {
        let mut space = self.camera.target;
        let [horizontal, vertical] = view.axes();
        space[horizontal] = point.x;
        space[vertical] = point.y;
        self.screen(space)
    }
}

impl View3d<'_> {
    pub(super) fn show(&mut self, ui: &mut Ui) {
        let rect = ui.available_rect_before_wrap();
        let response = ui.allocate_rect(rect, Sense::click_and_drag());
        let label = format!("{} view", self.pane.title());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, &label));
        self.pane.rect = rect;
        self.settle_camera(ui, rect);
        self.move_camera(ui, &response);
        let frame = Frame { rect, camera: self.pane.camera };
        let takes_region = !self.app.editing.has_gesture() && self.region(ui, &response, frame);
        if !takes_region {
            self.edit(ui, &response, frame);
        }
        match self.pane.kind {
            _ if takes_region => {}
            _ if self.app.editing.has_pointer(self.pane.kind) => {}
            PaneKind::Drawing(view) => self.draw_strokes(ui, &response, view, frame),
            PaneKind::Result => self.pull(ui, &response, frame),
        }
        self.paint_picture(ui, rect);
        match self.pane.kind {
            PaneKind::Drawing(view) => self.paint_strokes(ui, view, frame),
            PaneKind::Result => self.paint_result(ui, frame),
        }
        self.paint_editing(ui, frame);
        self.paint_pattern(ui, frame);
        self.paint_title(ui, rect);
        self.corner(ui, rect);
    }

    /// What this view shows of the bodies: the model at rest, or the simulation.
    pub(super) fn snapshot(&self) -> Shown {
        match self.pane.kind {
            PaneKind::Result => Shown::Running(Arc::clone(&self.app.published)),
            PaneKind::Drawing(_) => Shown::Model(Arc::clone(&self.app.model)),
        }
    }

    /// Takes every pointer sample of a stroke.
    fn draw_strokes(&mut self, ui: &Ui, response: &Response, view: View, frame: Frame) {
        let primary = PointerButton::Primary;
        if response.drag_started_by(primary)
            && !ui.input(|input| input.modifiers.alt)
            && let Some(at) = ui.input(|input| input.pointer.press_origin())
        {
            self.app.tool.press(view, frame.pixel(at), frame.drawn(view, at));
        }
        if !self.app.tool.draws_in(view) {
            if response.hovered() {
                self.app.hint = match self.app.tool.first() {
                    Some(first) if first.view != view => {
                        "Draw the second stroke between the guides; Escape takes the first one back"
                    }
                    Some(_) => "Draw the second stroke in another view, or draw this one again",
                    None => "Drag to draw the first stroke",
                };
            }
            return;
        }
        self.app.hint = "Escape cancels this stroke";
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
            self.app.tool.drag(frame.pixel(at), frame.drawn(view, at));
        }
        if response.drag_stopped_by(primary) {
            let diagonal = self.app.model_diagonal();
            if let Some(outcome) = self.app.tool.release(diagonal) {
                self.app.sketched(outcome);
            }
        }
    }

    fn paint_picture(&mut self, ui: &Ui, rect: Rect) {
        let shown = self.snapshot();
        let selected = self.selected(&shown);
        let display = match self.pane.kind {
            PaneKind::Drawing(_) => {
                let first_body = self.app.active;
                Display { skin: SkinStyle::XRay, room: false, selected, first_body, ..Display::default() }
            }
            PaneKind::Result => Display { selected, tints: self.app.tints(), ..self.app.display.clone() },
        };
        let theme = self.app.tone.pictures();
        let empty = || ui.painter().rect_filled(rect, 0.0, theme::color(theme.background_bottom));
        let sight = Sight { shown, scene: Arc::clone(self.app.scene()), display, tone: self.app.tone };
        let Some(painter) = &self.app.painter else {
            empty();
            return;
        };
        let scale = ui.ctx().pixels_per_point();
        let picture = &mut self.pane.picture;
        if let Some(shown) = painter.paint(picture, sight, &self.pane.camera, rect, scale) {
            ui.painter().add(shown);
        } else {
            empty();
        }
    }

    /// Selected fibre as the picture counts it.
    fn selected(&self, shown: &Shown) -> Vec<[u32; 2]> {
        let selection = &self.app.editing.selection;
        let body = match shown {
            Shown::Model(_) => 0,
            Shown::Running(_) => self.app.active,
        };
        let fibres = shown.bodies.get(body).into_iter().flat_map(|body| body.fibres.iter().enumerate());
        fibres.filter(|(_, fibre)| selection.contains(&fibre.id)).map(|(k, _)| [body as u32, k as u32]).collect()
    }
}
