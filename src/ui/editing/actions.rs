//! What the menu does to the selected fibres and vertices.

use super::BoxDrag;
use super::moving::Kind;
use crate::edit::fibre_ops::{self, Edited, FibreEditError, ResampleTo, Transform};
use crate::edit::{Command, Item};
use crate::scene::Fibre;
use crate::ui::action::Action;
use crate::ui::app::{App, Gravity};
use crate::ui::pane::{Frame, PaneKind};
use egui::Pos2;
use glam::DVec3;

/// Passes of smoothing that one command makes.
const SMOOTHING: usize = 4;
/// Depth under the surface to which fibres are snapped, in particle spacings: at the surface itself they would carry
/// little.
const SNAP_DEPTH: f64 = 0.5;
/// Where a vertex is inserted on its edge.
const MIDDLE: f64 = 0.5;

impl App {
    /// Why the selected fibres cannot be edited so; none where they can.
    pub(in crate::ui) fn editing_obstacle(&self, action: Action) -> Option<&'static str> {
        let unless = |met: bool, why: &'static str| (!met).then_some(why);
        let selection = &self.editing.selection;
        let body = self.active_body();
        let vertices = selection.vertices();
        match action {
            Action::SelectAll | Action::BoxSelect => {
                unless(body.is_some_and(|body| !body.fibres.is_empty()), "The body has no fibres")
            }
            Action::Paint => unless(body.is_some(), "Only fibre solids are painted"),
            Action::InsertVertex => {
                unless(vertices.is_some_and(|chosen| chosen.len() > 1), "Select two vertices of a fibre first")
            }
            Action::Split => {
                unless(vertices.is_some_and(|chosen| chosen.len() == 1), "Select one vertex of a fibre first")
            }
            Action::Redraw => {
                unless(!self.selected_views().is_empty(), "Select a fibre that was drawn by strokes first")
            }
            Action::ShowAll => unless(
                body.is_some_and(|body| body.fibres.iter().any(|fibre| fibre.hidden)),
                "No fibre of the body is hidden",
            ),
            Action::Delete if vertices.is_some() => {
                unless(vertices.is_some_and(|chosen| !chosen.is_empty()), "Select vertices first")
            }
            _ => unless(selection.active().is_some(), "Select a fibre first"),
        }
    }

    /// Does what was asked of the selected fibres.
    pub(in crate::ui) fn edit_fibres(&mut self, ctx: &egui::Context, action: Action) {
        let sampling = self.sampling();
        match action {
            Action::Move => self.begin_at_pointer(ctx, Kind::Move),
            Action::Turn => self.begin_at_pointer(ctx, Kind::Turn),
            Action::BoxSelect => self.editing.boxed = Some(BoxDrag::default()),
            Action::SelectAll => self.select_all(),
            Action::Vertices => {
                let enter = self.editing.selection.vertices().is_none();
                self.editing.selection.enter_vertices(enter);
                self.editing.tabbed = true;
            }
            Action::Duplicate => self.duplicate(ctx),
            Action::Delete => self.delete(),
            Action::MirrorX => self.mirror(DVec3::X),
            Action::MirrorY => self.mirror(DVec3::Y),
            Action::MirrorZ => self.mirror(DVec3::Z),
            Action::Reverse => self.each("Reverse", fibre_ops::reverse),
            Action::Smooth => self.each("Smooth", |fibre| fibre_ops::smooth(fibre, SMOOTHING, sampling)),
            Action::Resample => {
                let fineness = ResampleTo::Spacing(sampling.spacing);
                self.each("Resample", |fibre| fibre_ops::resample(fibre, fineness, sampling));
            }
            Action::SnapToSurface => self.snap(),
            Action::Detach => self.each("Detach", |fibre| fibre_ops::detach(fibre, sampling)),
            Action::InsertVertex => self.insert_vertices(),
            Action::Split => self.split(),
            Action::Redraw => {
                self.editing.redraws = !self.editing.redraws;
                if self.editing.redraws {
                    self.say(Gravity::Note, "Draw the stroke again in either of the fibre's two views");
                }
            }
            Action::Paint => self.toggle_brush(),
            Action::Hide => self.hide(),
            Action::ShowAll => self.show_all(),
            _ => {}
        }
    }

    /// Changes every selected fibre in one step.
    fn each(&mut self, verb: &str, change: impl Fn(&Fibre) -> Result<Edited, FibreEditError>) {
        let edited = self.selected_fibres().into_iter().map(change).collect();
        self.set_fibres(verb, edited, None);
    }

    /// Begins a gesture under the pointer, in the view where that is, or else in the result.
    fn begin_at_pointer(&mut self, ctx: &egui::Context, kind: Kind) {
        let pointer = ctx.input(|input| input.pointer.latest_pos());
        let views = self.view_frames();
        let under = |(_, frame): &&(PaneKind, Frame)| pointer.is_some_and(|at| frame.rect.contains(at));
        let result = || views.iter().find(|(view, _)| *view == PaneKind::Result);
        let Some((view, rect)) = views.iter().find(under).or_else(result).map(|(view, frame)| (*view, frame.rect))
        else {
            return;
        };
        let start: Pos2 = pointer.filter(|at| rect.contains(*at)).unwrap_or_else(|| rect.center());
        self.begin_moving(kind, None, view, start, false);
    }

    fn select_all(&mut self) {
        if self.editing.selection.vertices().is_some() {
            let count = self.active_vertices().len();
            self.editing.selection.set_vertices((0..count).collect());
            return;
        }
        let Some(body) = self.active_body() else { return };
        let shown: Vec<String> = body.fibres.iter().filter(|f| !f.hidden).map(|fibre| fibre.id.clone()).collect();
        self.editing.selection.set(shown);
    }

    /// Copies that can be moved away at once.
    fn duplicate(&mut self, ctx: &egui::Context) {
        let Some(body) = self.active_body() else { return };
        let copies = fibre_ops::copies(self.selected_fibres(), &body.fibres);
        let (id, chosen) = (body.id.clone(), copies.iter().map(|fibre| fibre.id.clone()).collect::<Vec<_>>());
        self.gesture += 1;
        self.apply(&Command::add_fibres("Duplicate", &id, copies));
        self.editing.selection.set(chosen);
        self.begin_at_pointer(ctx, Kind::Move);
    }

    fn delete(&mut self) {
        self.gesture += 1;
        if let Some(chosen) = self.editing.selection.vertices().map(<[usize]>::to_vec) {
            let sampling = self.sampling();
            self.each("Delete vertices of", |fibre| fibre_ops::delete_vertices(fibre, &chosen, sampling));
            self.editing.selection.enter_vertices(true);
            return;
        }
        let Some(body) = self.active_body().map(|body| body.id.clone()) else { return };
        let command = Command::remove_fibres(&body, self.editing.selection.fibres().iter().map(String::as_str));
        self.editing.selection.clear();
        self.apply(&command);
    }

    /// Mirrors in the plane through the middle of the body.
    fn mirror(&mut self, normal: DVec3) {
        let body = self.model.bodies.first();
        let points = body.into_iter().flat_map(|body| if body.skin.is_empty() { &body.particles } else { &body.skin });
        let middle = crate::draw::Bounds::of(points.copied()).map_or(DVec3::ZERO, |bounds| bounds.center());
        let sampling = self.sampling();
        match Transform::reflection(middle, normal) {
            Ok(by) => self.each("Mirror", |fibre| fibre_ops::transform(fibre, &by, sampling)),
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    fn snap(&mut self) {
        let sampling = self.sampling();
        let surface = self.active_body().and_then(|body| fibre_ops::surface(body, &self.assets));
        let Some(surface) = surface else {
            self.say(Gravity::Warning, "This body has no surface to snap to");
            return;
        };
        let chosen = self.editing.selection.vertices().map(<[usize]>::to_vec);
        let depth = -SNAP_DEPTH * sampling.spacing;
        self.each("Snap", |fibre| fibre_ops::snap(fibre, chosen.as_deref(), &surface, depth, sampling));
    }

    /// A vertex in the middle of every edge between selected ones.
    fn insert_vertices(&mut self) {
        let Some(chosen) = self.editing.selection.vertices().map(<[usize]>::to_vec) else { return };
        let sampling = self.sampling();
        let edges: Vec<usize> = chosen.windows(2).filter(|ends| ends[1] == ends[0] + 1).map(|ends| ends[0]).collect();
        if edges.is_empty() {
            self.say(Gravity::Warning, "Select two vertices beside each other: a third is put between them");
            return;
        }
        self.each("Insert vertices into", |fibre| {
            let mut edited = Edited { fibre: fibre.clone(), note: None };
            // From the end, so that the edges before keep their numbers.
            for &edge in edges.iter().rev() {
                let next = fibre_ops::insert_vertex(&edited.fibre, edge, MIDDLE, sampling)?;
                edited = Edited { note: edited.note.or(next.note), fibre: next.fibre };
            }
            Ok(edited)
        });
        let last = chosen.last().copied().unwrap_or_default() + edges.len();
        self.editing.selection.set_vertices((chosen[0]..=last).collect());
    }

    /// The knife: two fibres that meet at the selected vertex.
    fn split(&mut self) {
        let Some((body, fibre)) = self.selected_fibre() else { return };
        let Some(&[vertex]) = self.editing.selection.vertices() else { return };
        match fibre_ops::split(fibre, vertex, &body.fibres, self.sampling()) {
            Ok((first, second)) => {
                let (body, ids) = (body.id.clone(), [first.fibre.id.clone(), second.id.clone()]);
                let name = format!("Split {}", fibre.title());
                let commands = vec![
                    Command::SetFibre { body: body.clone(), fibre: first.fibre },
                    Command::AddFibre { body, fibre: second },
                ];
                self.gesture += 1;
                self.apply(&Command::Many { name, commands });
                self.editing.selection.set(ids);
                if let Some(note) = first.note {
                    self.say(Gravity::Note, note);
                }
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    fn hide(&mut self) {
        let Some(body) = self.active_body().map(|body| body.id.clone()) else { return };
        let item = |fibre: &String| Item::Fibre { body: body.clone(), fibre: fibre.clone() };
        let items: Vec<Item> = self.editing.selection.fibres().iter().map(item).collect();
        self.editing.selection.clear();
        self.gesture += 1;
        self.apply(&Command::SetHidden { items, hidden: true });
    }

    fn show_all(&mut self) {
        let Some(body) = self.active_body() else { return };
        let hidden = body.fibres.iter().filter(|fibre| fibre.hidden);
        let items = hidden.map(|fibre| Item::Fibre { body: body.id.clone(), fibre: fibre.id.clone() }).collect();
        self.gesture += 1;
        self.apply(&Command::SetHidden { items, hidden: false });
    }
}
