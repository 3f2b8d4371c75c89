//! Editing fibres that are there: choosing them and their vertices, moving and turning them, and what menus do to them.

mod actions;
mod brush;
mod gizmo;
mod looks;
mod moving;
mod picking;
mod selection;

use super::app::{App, Gravity};
use super::pane::PaneKind;
use crate::edit::Command;
use crate::edit::fibre_ops::{self, Edited, FibreEditError, Sampling};
use crate::scene::Fibre;
use brush::Brush;
use egui::{Event, Key, Pos2};
use gizmo::Handle;
use glam::DVec3;
use moving::{Kind, Moving, step_for};
use selection::Selection;

/// What is selected and what is being done to it.
#[derive(Clone, Debug, Default)]
pub(super) struct Editing {
    pub(super) selection: Selection,
    /// A move or turn under way, and the view in which it goes on.
    moving: Option<(Moving, PaneKind)>,
    /// What the last move asked for and is not in the document yet.
    pending: Option<fibre_ops::Transform>,
    /// A box that is to be drawn around what is to be selected.
    boxed: Option<BoxDrag>,
    /// The next stroke takes the place of the selected fibre's in its view.
    pub(super) redraws: bool,
    /// The handle under the pointer.
    hovered: Option<Handle>,
    /// The brush, while it is in use.
    brush: Option<Brush>,
    /// Tab was pressed for a command.
    tabbed: bool,
}

/// A box around what is to be selected.
#[derive(Clone, Copy, Debug, Default)]
struct BoxDrag {
    /// Where it began; none before the button is pressed.
    from: Option<Pos2>,
}

impl Editing {
    /// What goes on, for the status bar; none while nothing does.
    pub(super) fn hint(&self) -> Option<String> {
        self.moving.as_ref().map(|(moving, _)| moving.hint())
    }

    /// Whether the brush is in use.
    pub(super) fn paints(&self) -> bool {
        self.brush.is_some()
    }

    /// Tab is a command here, and must not leave the keys with some button.
    pub(super) fn keep_keys(&mut self, ctx: &egui::Context) {
        if std::mem::take(&mut self.tabbed) {
            ctx.memory_mut(egui::Memory::stop_text_input);
        }
    }

    /// Whether a move, a turn or a box is under way.
    pub(super) fn has_gesture(&self) -> bool {
        self.moving.is_some() || self.boxed.is_some()
    }

    /// Whether the pointer belongs to a gesture of editing, so that it neither draws nor pulls.
    pub(super) fn has_pointer(&self, view: PaneKind) -> bool {
        let paints = self.brush.is_some() && view == PaneKind::Result;
        self.moving.is_some() || self.boxed.is_some() || self.hovered.is_some() || paints
    }
}

impl App {
    /// How strokes of the active body become vertices.
    pub(super) fn sampling(&self) -> Sampling {
        // Of a mesh that is filled with a number of particles, the spacing that came out.
        let body = self.model.bodies.first();
        let filled = body.map(|body| self.model_diagonal() / (body.particles.len().max(1) as f64).cbrt());
        let spacing = match self.active_body() {
            Some(body) => match &body.shape {
                crate::scene::Shape::Mesh(mesh) if mesh.particles.is_some() => {
                    filled.unwrap_or_else(|| body.material.spacing())
                }
                _ => body.material.spacing(),
            },
            None => filled.unwrap_or(1e-2),
        };
        Sampling { model_diagonal: self.model_diagonal(), spacing }
    }

    /// The selected fibres of the active body, in the order in which they were chosen.
    pub(super) fn selected_fibres(&self) -> Vec<&Fibre> {
        let Some(body) = self.active_body() else { return Vec::new() };
        let find = |id: &String| body.fibres.iter().find(|fibre| fibre.id == *id);
        self.editing.selection.fibres().iter().filter_map(find).collect()
    }

    /// Vertices of the active fibre in the model frame [m].
    pub(super) fn active_vertices(&self) -> Vec<DVec3> {
        let Some((_, fibre)) = self.selected_fibre() else { return Vec::new() };
        fibre_ops::vertices(fibre, self.sampling()).unwrap_or_default()
    }

    /// The middle of what is selected, in the model frame [m]; none if nothing is.
    pub(super) fn pivot(&self) -> Option<DVec3> {
        let points: Vec<DVec3> = if let Some(chosen) = self.editing.selection.vertices() {
            let vertices = self.active_vertices();
            chosen.iter().filter_map(|&k| vertices.get(k).copied()).collect()
        } else {
            let sampling = self.sampling();
            let courses = self.selected_fibres().into_iter().map(|fibre| fibre_ops::vertices(fibre, sampling));
            courses.flat_map(Result::unwrap_or_default).collect()
        };
        (!points.is_empty()).then(|| points.iter().sum::<DVec3>() / points.len() as f64)
    }

    /// Begins to move or turn what is selected.
    fn begin_moving(&mut self, kind: Kind, axis: Option<usize>, view: PaneKind, start: Pos2, by_drag: bool) {
        let Some(pivot) = self.pivot() else {
            self.say(Gravity::Warning, "Select a fibre first: click it in a view or in the list");
            return;
        };
        let vertices = self.editing.selection.vertices().map(<[usize]>::to_vec);
        let originals = match vertices {
            Some(_) => self.selected_fibre().map(|(_, fibre)| fibre.clone()).into_iter().collect(),
            None => self.selected_fibres().into_iter().cloned().collect(),
        };
        self.gesture += 1;
        let (gesture, step) = (self.gesture, step_for(self.model_diagonal()));
        let typed = String::new();
        let moving = Moving { kind, axis, typed, by_drag, start, pivot, originals, vertices, gesture, step };
        self.editing.moving = Some((moving, view));
    }

    /// Puts the fibres where a gesture has them now, once the simulation has taken up where they were before.
    fn follow_moving(&mut self) {
        let taken_up = self.is_up_to_date();
        let Some(by) = self.editing.pending.take_if(|_| taken_up) else { return };
        let Some((moving, _)) = &self.editing.moving else { return };
        let sampling = self.sampling();
        let moved: Result<Vec<Edited>, FibreEditError> = moving
            .originals
            .iter()
            .map(|fibre| match &moving.vertices {
                Some(chosen) => fibre_ops::transform_vertices(fibre, chosen, &by, sampling),
                None => fibre_ops::transform(fibre, &by, sampling),
            })
            .collect();
        let verb = match moving.kind {
            Kind::Move => "Move",
            Kind::Turn => "Turn",
        };
        let gesture = moving.gesture;
        self.set_fibres(verb, moved, Some(gesture));
    }

    /// Puts edited fibres in the place of those with their identifiers, and says what they lost.
    pub(super) fn set_fibres(&mut self, verb: &str, edited: Result<Vec<Edited>, FibreEditError>, gesture: Option<u64>) {
        let Some(body) = self.active_body().map(|body| body.id.clone()) else { return };
        match edited {
            Ok(edited) => {
                let note = edited.iter().find_map(|edited| edited.note.clone());
                let fibres = edited.into_iter().map(|edited| edited.fibre).collect();
                if gesture.is_none() {
                    self.gesture += 1;
                }
                self.apply_in(&Command::set_fibres(verb, &body, fibres), gesture.unwrap_or(self.gesture));
                if let Some(note) = note {
                    self.say(Gravity::Note, note);
                }
            }
            Err(error) => self.say(Gravity::Error, error.to_string()),
        }
    }

    /// Ends a gesture: what it has come to stays, or everything is as it was.
    pub(super) fn end_moving(&mut self, keep: bool) {
        if keep {
            // What waits for the simulation is not lost.
            self.sent_edits = self.sent_edits.min(self.published.status.edits);
            self.follow_moving();
        }
        self.editing.pending = None;
        let Some((moving, _)) = self.editing.moving.take() else { return };
        if !keep && self.editor.abandon(moving.gesture) {
            self.hand_over();
        }
        self.gesture += 1;
    }

    /// Keys while something is moved, or a box is drawn; whether they were taken.
    pub(super) fn editing_keys(&mut self, ctx: &egui::Context) -> bool {
        if self.editing.brush.is_some() && ctx.input(|input| input.key_pressed(Key::Escape)) {
            self.editing.brush = None;
            return true;
        }
        if self.editing.boxed.is_some() && ctx.input(|input| input.key_pressed(Key::Escape)) {
            self.editing.boxed = None;
            return true;
        }
        let Some((moving, _)) = &mut self.editing.moving else { return false };
        let (mut keep, mut back) = (false, false);
        let events = ctx.input(|input| input.events.clone());
        for event in events {
            match event {
                Event::Text(text) => {
                    moving.typed.extend(text.chars().filter(|c| c.is_ascii_digit() || "-.ecm ".contains(*c)));
                }
                Event::Key { key, pressed: true, .. } => match key {
                    Key::X | Key::Y | Key::Z => {
                        let axis = [Key::X, Key::Y, Key::Z].iter().position(|known| *known == key);
                        moving.axis = if moving.axis == axis { None } else { axis };
                    }
                    Key::Backspace => {
                        moving.typed.pop();
                    }
                    Key::Enter => keep = true,
                    Key::Escape => back = true,
                    _ => {}
                },
                _ => {}
            }
        }
        if back {
            self.end_moving(false);
        } else if keep {
            self.end_moving(true);
        }
        true
    }

    /// Forgets what is selected and no longer there.
    pub(super) fn keep_selection_true(&mut self) {
        let ids: Vec<String> =
            self.active_body().into_iter().flat_map(|body| &body.fibres).map(|fibre| fibre.id.clone()).collect();
        self.editing.selection.retain(|id| ids.iter().any(|known| known == id));
        if let Some(chosen) = self.editing.selection.vertices().map(<[usize]>::to_vec) {
            let count = self.active_vertices().len();
            if chosen.iter().any(|&k| k >= count) {
                self.editing.selection.set_vertices(chosen.into_iter().filter(|&k| k < count).collect());
            }
        }
    }
}
