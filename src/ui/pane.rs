//! The three views: two to draw in, one to watch.

use super::app::{App, Pull};
use super::theme;
use crate::draw::{Bounds, Display, SkinStyle, Subject, draw};
use crate::geometry::mesh::nearest_hit;
use crate::render::{Camera, Facing, Projection};
use crate::sim::SimCommand;
use crate::sketch::View;
use crate::solver::snapshot::{BodySnapshot, Snapshot};
use egui::{Color32, Event, Key, PointerButton, Pos2, Rect, Response, Sense, Ui};
use egui_tiles::{Behavior, Container, Linear, LinearDir, TileId, Tiles, Tree, UiResponse};
use glam::{DVec2, DVec3};

/// What a view is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// Whether its camera has been fitted to what is there.
    pub(super) framed: bool,
    pub(super) picture: super::picture::Picture,
}

impl Pane {
    fn new(kind: PaneKind) -> Self {
        let camera = match kind {
            PaneKind::Drawing(View::Front) => Camera::facing(Facing::Front),
            PaneKind::Drawing(View::Side) => Camera::facing(Facing::Side),
            PaneKind::Drawing(View::Top) => Camera::facing(Facing::Top),
            PaneKind::Result => Camera::perspective(),
        };
        Self { kind, camera, framed: false, picture: super::picture::Picture::default() }
    }

    /// Front and side stacked beside the result.
    pub(super) fn layout() -> Tree<Self> {
        let mut tiles = Tiles::default();
        let front = tiles.insert_pane(Self::new(PaneKind::Drawing(View::Front)));
        let side = tiles.insert_pane(Self::new(PaneKind::Drawing(View::Side)));
        let drawing = tiles.insert_vertical_tile(vec![front, side]);
        let result = tiles.insert_pane(Self::new(PaneKind::Result));
        let mut row = Linear::new(LinearDir::Horizontal, vec![drawing, result]);
        row.shares.set_share(drawing, 0.75);
        row.shares.set_share(result, 1.25);
        let root = tiles.insert_container(Container::Linear(row));
        Tree::new(egui::Id::unique("views"), root, tiles)
    }

    pub(super) fn title(&self) -> &'static str {
        match self.kind {
            PaneKind::Drawing(View::Front) => "Front",
            PaneKind::Drawing(View::Side) => "Side",
            PaneKind::Drawing(View::Top) => "Top",
            PaneKind::Result => "Result",
        }
    }
}

/// Shows the views of an application.
pub(super) struct Layout<'a> {
    pub(super) app: &'a mut App,
}

impl Behavior<Pane> for Layout<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _tile: TileId, pane: &mut Pane) -> UiResponse {
        View3d { app: self.app, pane }.show(ui);
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> egui::WidgetText {
        pane.title().into()
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        2.0
    }

    fn min_size(&self) -> f32 {
        120.0
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
    fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.rect.width()), f64::from(self.rect.height()))
    }

    fn pixel(&self, at: Pos2) -> DVec2 {
        DVec2::new(f64::from(at.x - self.rect.min.x), f64::from(at.y - self.rect.min.y))
    }

    pub(super) fn screen(&self, point: DVec3) -> Option<Pos2> {
        let pixel = self.camera.project(point, self.size())?.pixel;
        Some(self.rect.min + egui::vec2(pixel.x as f32, pixel.y as f32))
    }

    /// The point of a drawing view's plane under a pixel, in the view's own coordinates [m].
    fn drawn(&self, view: View, at: Pos2) -> DVec2 {
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
    fn show(&mut self, ui: &mut Ui) {
        let rect = ui.available_rect_before_wrap();
        let response = ui.allocate_rect(rect, Sense::click_and_drag());
        let label = format!("{} view", self.pane.title());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, &label));
        self.frame_once(rect);
        self.move_camera(ui, &response);
        let frame = Frame { rect, camera: self.pane.camera };
        match self.pane.kind {
            PaneKind::Drawing(view) => self.draw_strokes(ui, &response, view, frame),
            PaneKind::Result => self.pull(ui, &response, frame),
        }
        self.paint_picture(ui, rect);
        match self.pane.kind {
            PaneKind::Drawing(view) => self.paint_strokes(ui, view, frame),
            PaneKind::Result => self.paint_result(ui, frame),
        }
        self.paint_title(ui, rect);
    }

    /// What this view shows of the bodies: the model at rest, or the simulation.
    fn snapshot(&self) -> Snapshot {
        match self.pane.kind {
            PaneKind::Result => self.app.published.snapshot.clone(),
            PaneKind::Drawing(_) => {
                let bodies = self.app.published.at_rest.bodies.iter().take(1).cloned().collect();
                Snapshot { bodies, ..Snapshot::default() }
            }
        }
    }

    fn frame_once(&mut self, rect: Rect) {
        if self.pane.framed {
            return;
        }
        let points = |bodies: &[BodySnapshot]| Bounds::of(bodies.iter().flat_map(|body| body.skin.iter().copied()));
        let bounds = match self.pane.kind {
            PaneKind::Drawing(_) => points(&self.app.published.at_rest.bodies),
            // The whole fall is to be seen, from the start down to the floor.
            PaneKind::Result => points(&self.app.published.snapshot.bodies).map(|bounds| {
                let floor = self.app.scene().room.floor.unwrap_or(bounds.min.y).min(bounds.min.y);
                Bounds { min: bounds.min.with_y(floor), ..bounds }
            }),
        };
        if let Some(bounds) = bounds {
            self.pane.camera.frame(&bounds, f64::from(rect.width() / rect.height().max(1.0)));
            if matches!(self.pane.kind, PaneKind::Drawing(_)) {
                self.pane.camera.height *= 1.15;
            }
            self.pane.framed = true;
        }
    }

    fn move_camera(&mut self, ui: &Ui, response: &Response) {
        let rect = response.rect;
        let size = DVec2::new(f64::from(rect.width()), f64::from(rect.height()));
        let before = self.pane.camera;
        let (delta, modifiers, wheel) =
            ui.input(|input| (input.pointer.delta(), input.modifiers, input.smooth_scroll_delta().y));
        let by = DVec2::new(f64::from(delta.x), f64::from(delta.y));
        let held = |button| response.dragged_by(button);
        let middle = held(PointerButton::Middle);
        let pans = middle && (modifiers.shift || modifiers.alt);
        let turns = middle || (modifiers.alt && held(PointerButton::Primary));
        let result = self.pane.kind == PaneKind::Result;
        if pans || (turns && !result) {
            self.pane.camera.pan(by, size);
        } else if turns {
            self.pane.camera.orbit(-0.008 * by.x, 0.008 * by.y);
        } else if modifiers.alt && held(PointerButton::Secondary) {
            self.pane.camera.zoom((0.005 * by.y).exp(), 0.5 * size, size);
        }
        if response.hovered() && wheel != 0.0 {
            let at = ui.input(|input| input.pointer.hover_pos()).unwrap_or(rect.center());
            let pixel = DVec2::new(f64::from(at.x - rect.min.x), f64::from(at.y - rect.min.y));
            self.pane.camera.zoom((-0.002 * f64::from(wheel)).exp(), pixel, size);
        }
        if result && response.hovered() && !ui.ctx().egui_wants_keyboard_input() {
            self.turn_by_keys(ui);
        }
        if let PaneKind::Drawing(view) = self.pane.kind
            && self.pane.camera != before
        {
            self.app.moved = Some((view, self.pane.camera));
        }
    }

    fn turn_by_keys(&mut self, ui: &Ui) {
        let (opposite, pressed) = ui.input(|input| {
            let keys = [Key::Num1, Key::Num3, Key::Num7, Key::Num5];
            (input.modifiers.command, keys.into_iter().find(|&key| input.key_pressed(key)))
        });
        let facing = match (pressed, opposite) {
            (Some(Key::Num1), false) => Facing::Front,
            (Some(Key::Num1), true) => Facing::Back,
            (Some(Key::Num3), false) => Facing::Side,
            (Some(Key::Num3), true) => Facing::OtherSide,
            (Some(Key::Num7), false) => Facing::Top,
            (Some(Key::Num7), true) => Facing::Bottom,
            (Some(Key::Num5), _) => {
                let perspective = Camera::perspective().projection;
                let camera = &mut self.pane.camera;
                let parallel = camera.projection == Projection::Parallel;
                camera.projection = if parallel { perspective } else { Projection::Parallel };
                return;
            }
            _ => return,
        };
        let turned = Camera::facing(facing);
        self.pane.camera = Camera { yaw: turned.yaw, pitch: turned.pitch, ..self.pane.camera };
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

    /// Pulls a body by the point under the pointer.
    fn pull(&mut self, ui: &Ui, response: &Response, frame: Frame) {
        let primary = PointerButton::Primary;
        let (origin, now, alt, pin) = ui.input(|input| {
            let pointer = &input.pointer;
            (pointer.press_origin(), pointer.latest_pos(), input.modifiers.alt, input.key_pressed(Key::P))
        });
        let starts = response.drag_started_by(primary) || response.drag_started_by(PointerButton::Secondary);
        if starts
            && !alt
            && let Some(at) = origin
        {
            self.app.pull = self.hit(frame, at);
            if let Some(Pull { body, vertex, target, .. }) = self.app.pull {
                self.app.ask(SimCommand::Grab { body, vertex, target });
            }
        }
        let size = frame.size();
        if let (Some(mut pull), Some(at)) = (self.app.pull, now) {
            self.app.hint = "Release to let go; P leaves the point pinned here";
            let target = frame.camera.point_at(frame.pixel(at), pull.depth, size);
            if target != pull.target {
                pull.target = target;
                self.app.pull = Some(pull);
                self.app.ask(SimCommand::MoveGrab(target));
            }
            if pin {
                self.app.ask(SimCommand::PinGrab);
                self.app.pull = None;
            } else if response.drag_stopped() {
                self.app.ask(SimCommand::Release);
                self.app.pull = None;
            }
        } else if response.hovered() {
            self.app.hint = "Drag a body to pull it; middle drag turns the view, the wheel comes closer";
        }
    }

    /// The vertex of a skin that lies nearest to what is seen at a pixel.
    fn hit(&self, frame: Frame, at: Pos2) -> Option<Pull> {
        let ray = frame.camera.ray(frame.pixel(at), frame.size());
        let bodies = self.app.published.snapshot.bodies.iter().enumerate();
        let hits = bodies.filter_map(|(body, shown)| {
            let hit = nearest_hit(&shown.skin, &shown.triangles, ray.origin, ray.direction)?;
            Some((body, shown, hit))
        });
        let (body, shown, hit) = hits.min_by(|a, b| a.2.distance.total_cmp(&b.2.distance))?;
        let point = ray.origin + hit.distance * ray.direction;
        let near = |&vertex: &u32| shown.skin[vertex as usize].distance_squared(point);
        let vertex = *shown.triangles[hit.triangle].iter().min_by(|a, b| near(a).total_cmp(&near(b)))? as usize;
        let held = shown.skin[vertex];
        let depth = frame.camera.project(held, frame.size())?.depth;
        Some(Pull { body, vertex, depth, target: held })
    }

    fn paint_picture(&mut self, ui: &Ui, rect: Rect) {
        let snapshot = self.snapshot();
        let scene = std::sync::Arc::clone(self.app.scene());
        let selected = self.selected(&snapshot);
        let display = match self.pane.kind {
            PaneKind::Drawing(_) => {
                Display { skin: SkinStyle::XRay, grid: true, room: false, selected, ..Display::default() }
            }
            PaneKind::Result => Display { selected, ..self.app.display.clone() },
        };
        let theme = self.app.tone.pictures();
        let background = theme::color(theme.background_bottom);
        ui.painter().rect_filled(rect, 0.0, background);
        let Some(painter) = &self.app.painter else { return };
        let list = draw(&Subject { scene: &scene, snapshot: &snapshot, ghost: None }, &display, &theme);
        let scale = ui.ctx().pixels_per_point();
        let size = [(rect.width() * scale).round() as u32, (rect.height() * scale).round() as u32];
        if let Some(texture) = painter.paint(&mut self.pane.picture, list, &self.pane.camera, size, scale) {
            let whole = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
            ui.painter().image(texture, rect, whole, Color32::WHITE);
        }
    }

    /// Selected fibre as the picture counts it.
    fn selected(&self, snapshot: &Snapshot) -> Vec<[u32; 2]> {
        let Some(id) = &self.app.selected else { return Vec::new() };
        let fibres = snapshot.bodies.first().into_iter().flat_map(|body| body.fibres.iter().enumerate());
        fibres.filter(|(_, fibre)| fibre.id == *id).map(|(k, _)| [0, k as u32]).collect()
    }
}
