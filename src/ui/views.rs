//! How the three views lie beside each other, what links them, and what of them is remembered.

use super::app::App;
use super::pane::{Frame, Pane, PaneKind, View3d};
use crate::sketch::View;
use egui::{Pos2, Rect, Ui};
use egui_tiles::{Behavior, Container, Linear, LinearDir, Tile, TileId, Tiles, Tree, UiResponse};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Under this name the layout is remembered.
const KEY: &str = "window";

/// What is remembered from one start to the next.
#[derive(Serialize, Deserialize)]
struct Remembered {
    views: Tree<Pane>,
    light: bool,
    coach: bool,
    #[serde(default)]
    timeline: super::timeline::Kept,
    #[serde(default)]
    plots: bool,
}

/// Front and side stacked beside the result.
pub(super) fn usual_layout() -> Tree<Pane> {
    let mut tiles = Tiles::default();
    let front = tiles.insert_pane(Pane::new(PaneKind::Drawing(View::Front)));
    let side = tiles.insert_pane(Pane::new(PaneKind::Drawing(View::Side)));
    let drawing = tiles.insert_vertical_tile(vec![front, side]);
    let result = tiles.insert_pane(Pane::new(PaneKind::Result));
    let mut row = Linear::new(LinearDir::Horizontal, vec![drawing, result]);
    row.shares.set_share(drawing, 0.75);
    row.shares.set_share(result, 1.25);
    let root = tiles.insert_container(Container::Linear(row));
    Tree::new(egui::Id::unique("views"), root, tiles)
}

/// Whether there are two different drawing views and a result, as there must be.
fn is_whole(views: &Tree<Pane>) -> bool {
    let kinds: Vec<PaneKind> = panes(views).map(|pane| pane.kind).collect();
    let drawn = |kind: &&PaneKind| matches!(kind, PaneKind::Drawing(_));
    let drawing: Vec<&PaneKind> = kinds.iter().filter(drawn).collect();
    kinds.len() == 3 && drawing.len() == 2 && drawing[0] != drawing[1]
}

fn panes(views: &Tree<Pane>) -> impl Iterator<Item = &Pane> {
    views.tiles.iter().filter_map(|(_, tile)| match tile {
        Tile::Pane(pane) => Some(pane),
        Tile::Container(_) => None,
    })
}

/// The drawing views and where they lay in the last frame; none before the first.
fn drawing_views(views: &Tree<Pane>) -> Vec<(View, Rect)> {
    let drawing = panes(views).filter_map(|pane| match pane.kind {
        PaneKind::Drawing(view) => Some((view, pane.rect)),
        PaneKind::Result => None,
    });
    drawing.filter(|(_, rect)| rect.is_positive()).collect()
}

impl App {
    /// Goes on with the views, colours and files of the last time.
    pub fn recall(&mut self, ctx: &egui::Context, storage: &dyn eframe::Storage) {
        self.recall_recent(storage);
        self.recall_welcome(storage);
        let Some(last) = eframe::get_value::<Remembered>(storage, KEY) else { return };
        if is_whole(&last.views) {
            self.panes = last.views;
        }
        self.coach = last.coach;
        self.recall_timeline(last.timeline);
        self.readings.open = last.plots;
        if last.light != (self.tone == super::theme::Tone::Light) {
            self.tone = self.tone.other();
            self.tone.apply(ctx);
        }
    }

    pub(super) fn remember(&mut self, storage: &mut dyn eframe::Storage) {
        self.remember_welcome(storage);
        let views = std::mem::replace(&mut self.panes, Tree::empty(egui::Id::unique("no panes")));
        let (light, plots) = (self.tone == super::theme::Tone::Light, self.readings.open);
        let now = Remembered { views, light, coach: self.coach, timeline: self.timeline_kept(), plots };
        eframe::set_value(storage, KEY, &now);
        self.panes = now.views;
        self.remember_recent(storage);
    }

    pub(super) fn views(&mut self, ui: &mut Ui) {
        egui::CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| {
            let mut panes = std::mem::replace(&mut self.panes, Tree::empty(egui::Id::unique("no panes")));
            self.drawing = drawing_views(&panes);
            panes.ui(&mut Layout { app: self }, ui);
            self.panes = panes;
        });
        self.turn_views();
        self.link_views();
        if self.published.status.playing {
            // Should a notification be missed, the next picture still comes.
            ui.ctx().request_repaint_after_secs(0.1);
        }
    }

    /// Where the result view shows a point of the world [m]; none behind its eye.
    pub fn shown_at(&self, point: DVec3) -> Option<Pos2> {
        let result = panes(&self.panes).find(|pane| pane.kind == PaneKind::Result)?;
        Frame { rect: result.rect, camera: result.camera }.screen(point)
    }

    /// The views, where they lay in the last frame and from where they look.
    pub(super) fn view_frames(&self) -> Vec<(PaneKind, Frame)> {
        panes(&self.panes).map(|pane| (pane.kind, Frame { rect: pane.rect, camera: pane.camera })).collect()
    }

    fn panes_mut(&mut self) -> impl Iterator<Item = &mut Pane> {
        self.panes.tiles.iter_mut().filter_map(|(_, tile)| match tile {
            Tile::Pane(pane) => Some(pane),
            Tile::Container(_) => None,
        })
    }

    /// Fits every view again as soon as there is something to fit: the selected fibre or everything.
    pub(super) fn reframe(&mut self, selected: bool) {
        self.fit_selected = selected;
        for pane in self.panes_mut() {
            pane.framed = false;
        }
    }

    /// A drawing view shows another side; where the other one shows that already, they change places.
    fn turn_views(&mut self) {
        let Some((old, new)) = self.turned.take() else { return };
        for pane in self.panes_mut() {
            let kind = match pane.kind {
                PaneKind::Drawing(view) if view == old => PaneKind::Drawing(new),
                PaneKind::Drawing(view) if view == new => PaneKind::Drawing(old),
                // Both are fitted anew, to one scale.
                PaneKind::Drawing(view) => PaneKind::Drawing(view),
                PaneKind::Result => continue,
            };
            *pane = Pane { rect: pane.rect, ..Pane::new(kind) };
        }
    }

    /// The drawing views are linked along the axis that they share: what one has moved, the other follows.
    fn link_views(&mut self) {
        let Some((view, from)) = self.moved.take() else { return };
        for pane in self.panes_mut() {
            if let PaneKind::Drawing(other) = pane.kind
                && let Some(axis) = view.shared_axis(other)
            {
                pane.camera.height = from.height;
                pane.camera.target[axis] = from.target[axis];
            }
        }
    }
}

/// Shows the views of an application.
struct Layout<'a> {
    app: &'a mut App,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layout_is_remembered_and_a_broken_one_is_not_used() {
        let mut views = usual_layout();
        assert!(is_whole(&views));
        let text = serde_json::to_string(&views).expect("a layout is text");
        let back: Tree<Pane> = serde_json::from_str(&text).expect("and back");
        assert_eq!(
            panes(&back).map(|pane| pane.kind).collect::<Vec<_>>().len(),
            panes(&views).map(|pane| pane.kind).collect::<Vec<_>>().len()
        );
        for (_, tile) in views.tiles.iter_mut() {
            if let Tile::Pane(pane) = tile {
                *pane = Pane::new(PaneKind::Result);
            }
        }
        assert!(!is_whole(&views));
    }
}
