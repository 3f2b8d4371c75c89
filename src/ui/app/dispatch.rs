//! What becomes of every action: why it cannot be asked for just now, and what performs it, side by side.
//!
//! How it works. `App::entry` answers for each action with an [`Entry`]. Its match has no branch for the rest,
//! so that an action that is listed in [`crate::ui::action`] and has no branch here does not compile.

use super::App;
use crate::draw::SkinStyle;
use crate::scene::AnyBody;
use crate::sim::SimCommand;
use crate::ui::action::{Action, ActionState, ActionStates};
use crate::ui::ahead::AheadQuestion;
use crate::ui::autosave::Question;
use crate::ui::bodies::{self, Layers, NewBody};
use crate::ui::clipboard;
use crate::ui::context::Severity;
use crate::ui::dialogs::{Dialog, PathPurpose};
use crate::ui::drives;
use crate::ui::editing::{self, Kind};
use crate::ui::export;
use crate::ui::next::Next;
use crate::ui::report;
use crate::ui::right_panel::PropertyTab;
use crate::ui::transfer::{ClipKind, Transfer};
use crate::ui::unpin::remove_pin;
use crate::ui::views::{DrawingTool, ViewOptions};
use egui::ViewportCommand;
use glam::DVec3;

/// What performs an action.
type ActionFn = fn(&mut App, &egui::Context);

/// What there is to know of an action just now.
struct Entry {
    state: ActionState,
    run: ActionFn,
}

impl Entry {
    /// Whether the switch is on.
    fn on(mut self, on: bool) -> Self {
        self.state.on = Some(on);
        self
    }

    /// What exactly would be done.
    fn detail(mut self, detail: Option<&str>) -> Self {
        self.state.detail = detail.map(str::to_owned);
        self
    }
}

/// An action that can always be asked for.
fn always(run: ActionFn) -> Entry {
    Entry { state: ActionState::default(), run }
}

/// An action that can be asked for where a condition is met; elsewhere it is greyed and says why.
fn when(met: bool, why: &'static str, run: ActionFn) -> Entry {
    unless((!met).then_some(why), run)
}

/// An action that can be asked for unless something speaks against it.
fn unless(disabled: Option<&'static str>, run: ActionFn) -> Entry {
    Entry { state: ActionState { disabled, ..ActionState::default() }, run }
}

impl App {
    /// How an action stands, and what performs it.
    #[allow(clippy::too_many_lines, reason = "one branch an action")]
    fn entry(&self, action: Action) -> Entry {
        let (document, simulation) = (&self.cx.document, &self.cx.simulation);
        let display = &self.views.options.display;
        let replay = |run| unless(self.no_replay(), run);
        let selected = |run| when(self.cx.selection.active().is_some(), "Select a fibre first", run);
        let is_body = self.cx.selection.is_body();
        let has_keys = !self.cx.keys.is_empty();
        let has_part = self.cx.selection.active().is_some() || self.cx.selection.sheet().is_some();
        let mirrored = |run| when(has_part, "Select a fibre or a sheet first", run);
        let is_sheet = self.cx.selection.sheet().is_some();
        let has_thing = is_body || has_part;
        let thing = |run| when(has_thing, "Select a fibre, a sheet or a body first", run);
        match action {
            Action::New => always(|app, ctx| app.leave(ctx, Next::New)),
            Action::NewEmpty => always(|app, ctx| app.leave(ctx, Next::Empty)),
            Action::Open => always(|app, _| {
                app.dialog = Some(Dialog::path(PathPurpose::Open, app.cx.document.path.as_deref()));
            }),
            Action::Examples => always(|app, _| app.dialog = Some(Dialog::Examples)),
            Action::Reload => when(document.path.is_some(), "The scene has no file yet", Self::reload),
            Action::Save => always(|app, ctx| app.save_then(ctx, None)),
            Action::SaveAs => always(|app, _| app.ask_where(None)),
            Action::Export => always(|app, _| export::ask_where_to_export(&mut app.cx)),
            Action::ExportMotion => self.with_transfer(|app, ctx| {
                let look = app.views.look(&app.cx, ctx.pixels_per_point());
                app.transfer.ask_motion(&look, &mut app.cx);
            }),
            Action::SaveClip => self.with_transfer(|app, ctx| app.ask_clip(ctx, ClipKind::Motion)),
            Action::SaveTurntable => self.with_transfer(|app, ctx| app.ask_clip(ctx, ClipKind::Turntable)),
            Action::CopyPicture => {
                when(self.views.has_picture(), "Nothing is drawn yet", |app, ctx| match app.views.result_picture() {
                    Some(Ok(picture)) => {
                        let [width, height] = picture.size.map(|extent| extent as usize);
                        ctx.copy_image(egui::ColorImage::from_rgba_unmultiplied([width, height], &picture.rgba));
                        app.cx.say(Severity::Note, format!("Copied the picture, {width} × {height}"));
                    }
                    Some(Err(error)) => app.cx.say(Severity::Error, error.to_string()),
                    None => {}
                })
            }
            Action::Report => always(|app, _| {
                let place = report::usual_place(&app.cx);
                app.dialog = Some(Dialog::path(PathPurpose::Report, Some(&place)));
            }),
            Action::SaveJournal => {
                when(document.path.is_some(), "Save the scene first", |app, _| export::save_journal(&mut app.cx))
            }
            Action::Recover => {
                let any = !self.autosave.offers().is_empty() || !self.autosave.recordings().is_empty();
                when(any, "Nothing was left unsaved", |app, _| app.dialog = Some(Dialog::Question(Question::Recover)))
            }
            Action::Quit => always(|app, ctx| app.leave(ctx, Next::Quit)),
            Action::Undo => {
                let step = document.undo_name();
                when(step.is_some(), "There is nothing to undo", |app, _| app.cx.undo()).detail(step)
            }
            Action::Redo => {
                let step = document.redo_name();
                when(step.is_some(), "There is nothing to redo", |app, _| app.cx.redo()).detail(step)
            }
            Action::Delete if has_keys => always(|app, _| drives::delete_keys(&mut app.cx)),
            Action::Cut if has_keys => always(|app, ctx| {
                app.copy(ctx);
                drives::delete_keys(&mut app.cx);
            }),
            Action::Copy if has_keys => always(Self::copy),
            Action::Delete => unless(self.nothing_to_delete(), |app, _| match app.cx.selection.pin().cloned() {
                Some(pin) => remove_pin(&pin, &mut app.cx),
                None if app.cx.selection.is_body() => bodies::delete(&mut app.cx),
                None => editing::delete(&mut app.cx),
            }),
            Action::Duplicate if is_body => always(|app, ctx| {
                app.views.begin_at_pointer(ctx, Kind::Move, &mut app.cx);
                editing::move_copy(app.views.editing_mut());
            }),
            Action::Duplicate if is_sheet => always(|app, _| editing::duplicate_sheet(&mut app.cx)),
            Action::Duplicate => thing(|app, ctx| {
                let (gesture, of) = editing::duplicate(&mut app.cx);
                app.views.begin_at_pointer(ctx, Kind::Move, &mut app.cx);
                editing::moves_copies(app.views.editing_mut(), gesture, of);
            }),
            Action::Cut => thing(|app, ctx| {
                app.copy(ctx);
                if app.cx.selection.is_body() {
                    bodies::delete(&mut app.cx);
                } else {
                    editing::delete(&mut app.cx);
                }
            }),
            Action::Copy => thing(Self::copy),
            Action::Paste => always(|_, ctx| ctx.send_viewport_cmd(ViewportCommand::RequestPaste)),
            Action::SelectAll => self.with_fibres(|app, _| editing::select_all(&mut app.cx)),
            Action::BoxSelect => self.with_fibres(|app, _| app.views.editing_mut().begin_box()),
            Action::Preferences => always(|app, ctx| app.dialog = Some(Dialog::Preferences(app.preferences(ctx)))),
            Action::AddBox => always(|app, _| bodies::add(NewBody::Box, &mut app.cx)),
            Action::AddBall => always(|app, _| bodies::add(NewBody::Ball, &mut app.cx)),
            Action::AddCylinder => always(|app, _| bodies::add(NewBody::Cylinder, &mut app.cx)),
            Action::AddCapsule => always(|app, _| bodies::add(NewBody::Capsule, &mut app.cx)),
            Action::AddTorus => always(|app, _| bodies::add(NewBody::Torus, &mut app.cx)),
            Action::AddModel => {
                always(|app, _| app.dialog = Some(Dialog::path(PathPurpose::Add(Layers::Filled), None)))
            }
            Action::AddSegment => always(|app, _| bodies::add(NewBody::Segment, &mut app.cx)),
            Action::AddRing => always(|app, _| bodies::add(NewBody::Ring, &mut app.cx)),
            Action::AddBalloon => always(|app, _| bodies::add(NewBody::Balloon, &mut app.cx)),
            Action::AddLayered => always(|app, _| app.dialog = Some(Dialog::path(PathPurpose::Add(Layers::Two), None))),
            Action::DrawTool => {
                let is_in_hand = self.views.drawing_tool(&self.cx) == DrawingTool::Draw;
                always(|app, _| app.views.take_in_hand(DrawingTool::Draw, &mut app.cx)).on(is_in_hand)
            }
            Action::SheetTool => {
                let is_in_hand = self.views.drawing_tool(&self.cx) == DrawingTool::Sheet;
                always(|app, _| app.views.take_in_hand(DrawingTool::Sheet, &mut app.cx)).on(is_in_hand)
            }
            Action::SelectTool => {
                let is_in_hand = self.views.drawing_tool(&self.cx) == DrawingTool::Select;
                always(|app, _| app.views.take_in_hand(DrawingTool::Select, &mut app.cx)).on(is_in_hand)
            }
            Action::Vertices => selected(|app, _| app.toggle_vertices()).on(self.cx.selection.vertices().is_some()),
            Action::Move => thing(|app, ctx| app.views.begin_at_pointer(ctx, Kind::Move, &mut app.cx)),
            Action::Turn => thing(|app, ctx| app.views.begin_at_pointer(ctx, Kind::Turn, &mut app.cx)),
            Action::Scale => thing(|app, ctx| app.views.begin_at_pointer(ctx, Kind::Scale, &mut app.cx)),
            Action::MirrorX => mirrored(|app, _| editing::mirror(&mut app.cx, DVec3::X)),
            Action::MirrorY => mirrored(|app, _| editing::mirror(&mut app.cx, DVec3::Y)),
            Action::MirrorZ => mirrored(|app, _| editing::mirror(&mut app.cx, DVec3::Z)),
            Action::MirrorCopyX => mirrored(|app, _| editing::mirror_copies(&mut app.cx, DVec3::X)),
            Action::MirrorCopyY => mirrored(|app, _| editing::mirror_copies(&mut app.cx, DVec3::Y)),
            Action::MirrorCopyZ => mirrored(|app, _| editing::mirror_copies(&mut app.cx, DVec3::Z)),
            Action::Reverse => selected(|app, _| editing::reverse(&mut app.cx)),
            Action::Smooth => selected(|app, _| editing::smooth(&mut app.cx)),
            Action::Resample => selected(|app, _| editing::resample(&mut app.cx)),
            Action::SnapToSurface => selected(|app, _| editing::snap(&mut app.cx)),
            Action::Detach => selected(|app, _| editing::detach(&mut app.cx)),
            Action::InsertVertex => {
                let met = self.cx.selection.vertices().is_some_and(|chosen| chosen.len() > 1);
                when(met, "Select two vertices of a fibre first", |app, _| editing::insert_vertices(&mut app.cx))
            }
            Action::Split => {
                let met = self.cx.selection.vertices().is_some_and(|chosen| chosen.len() == 1);
                when(met, "Select one vertex of a fibre first", |app, _| editing::split(&mut app.cx))
            }
            Action::Redraw => {
                let met = !self.cx.selected_views().is_empty();
                when(met, "Select a fibre that was drawn by strokes first", |app, _| {
                    app.views.take_in_hand(DrawingTool::Draw, &mut app.cx);
                    app.views.sketching().toggle_redraw(&mut app.cx);
                })
                .on(self.views.redraws())
            }
            Action::Paint => {
                let met = editing::can_paint(&self.cx);
                when(met, "Only fibre solids are painted, and bodies that follow a motion", |app, _| {
                    editing::toggle_brush(app.views.editing_mut(), &app.cx);
                })
                .on(self.views.editing().paints())
            }
            Action::Patterns => always(|app, _| app.right_panel.show_tab(PropertyTab::Patterns)),
            Action::KeepPattern => self.with_fibres(|app, _| app.patterns.ask_to_keep(&mut app.cx)),
            Action::ImportFibres => {
                let met = self.cx.active_body().is_some();
                when(met, "Fibres go into fibre solids", |app, _| Transfer::ask_import(&mut app.cx))
            }
            Action::ExportFibres => self.with_fibres(|app, _| Transfer::ask_export(&mut app.cx)),
            Action::Hide if is_body => always(|app, _| bodies::hide(&mut app.cx)),
            Action::Hide => thing(|app, _| editing::hide(&mut app.cx)),
            Action::ShowAll => {
                let fibres = self.cx.active_body().is_some_and(|body| body.fibres.iter().any(|fibre| fibre.hidden));
                let sheets = self.cx.active_body().is_some_and(|body| body.sheets.iter().any(|sheet| sheet.hidden));
                let met = fibres || sheets || self.cx.scene().all_bodies().any(AnyBody::hidden);
                when(met, "No body, and no fibre or sheet of the body, is hidden", |app, _| {
                    editing::show_all(&mut app.cx);
                })
            }
            Action::PlayPause => always(|app, _| {
                let playing = app.cx.simulation.is_playing();
                app.cx.ask(if playing { SimCommand::Pause } else { SimCommand::Play });
            }),
            Action::ComputeAhead => {
                let is_live = !simulation.is_comparing();
                when(is_live, "Integrators are being compared", |app, _| {
                    app.dialog = Some(Dialog::Ahead(AheadQuestion::default()));
                })
            }
            Action::Step => always(|app, _| app.cx.ask(SimCommand::Step)),
            Action::StepBack => replay(|app, _| app.cx.simulation.replay(SimCommand::StepBack)),
            Action::FirstFrame => replay(|app, _| app.cx.simulation.show_first()),
            Action::Replay => replay(|app, _| app.cx.simulation.replay(SimCommand::Replay)),
            Action::GoOn => when(simulation.is_replaying(), "The present is shown already", |app, _| {
                app.cx.ask(SimCommand::ContinueHere);
            }),
            Action::Live => when(simulation.is_replaying(), "The present is shown already", |app, _| {
                app.cx.ask(SimCommand::Live);
            }),
            Action::Reset => always(|app, _| app.cx.ask(SimCommand::Reset)),
            Action::ReleasePins => always(|app, _| app.cx.ask(SimCommand::ReleaseAll)),
            Action::Frame => always(|app, _| app.views.reframe(true)),
            Action::FrameAll => always(|app, _| app.views.reframe(false)),
            Action::Follow => always(|app, _| flip(&mut app.views.options.follow)).on(self.views.options.follow),
            Action::XRay => always(|app, _| app.views.options.toggle_see_through()).on(display.skin == SkinStyle::XRay),
            Action::Particles => always(|app, _| app.views.options.toggle_particles()).on(display.particles),
            Action::Springs => always(|app, _| flip(&mut app.views.options.display.springs)).on(display.springs),
            Action::Strokes => always(|app, _| flip(&mut app.views.options.display.strokes)).on(display.strokes),
            Action::Grid => always(|app, _| flip(&mut app.views.options.display.grid)).on(display.grid),
            Action::ColourMap => always(|app, _| app.views.options.next_field(&app.cx)),
            Action::Tension => {
                always(|app, _| app.views.options.toggle_tension(&mut app.cx)).on(self.views.options.tension)
            }
            Action::Activation => {
                always(|app, _| app.views.options.toggle_activation(&mut app.cx)).on(self.views.options.activation)
            }
            Action::Slice => always(|app, _| app.views.options.next_slice(&app.cx)),
            Action::ShowEffect => {
                let why = match document.undo_name() {
                    None => Some("Nothing was changed yet"),
                    Some(_) => simulation.is_comparing().then_some("Integrators are being compared"),
                };
                unless(why, |app, _| app.effect.begin(&mut app.cx, &mut app.top_bar)).on(self.effect.plays())
            }
            Action::Ghost => always(|app, _| ViewOptions::next_ghost(&mut app.cx)),
            Action::Timeline => always(|app, _| app.timeline.fold()).on(self.timeline.is_shown()),
            Action::Drives => always(|app, _| app.timeline.fold_drives()).on(self.timeline.shows_drives()),
            Action::Plots => always(|app, _| flip(&mut app.time_series.open)).on(self.time_series.open),
            Action::Theme => always(|app, ctx| {
                app.cx.tone = app.cx.tone.other();
                app.cx.tone.apply(ctx);
            }),
            Action::Palette => always(|app, _| app.dialog = Some(Dialog::palette())),
            Action::FirstScene => always(|app, _| app.dialog = Some(Dialog::FirstScene)),
            Action::Help => always(|app, _| app.dialog = Some(Dialog::Help)),
        }
    }

    /// How every action stands just now.
    pub(super) fn action_states(&self) -> ActionStates {
        ActionStates::new(|action| self.entry(action).state)
    }

    /// Does what was asked for, or says why that cannot be done just now.
    pub fn dispatch(&mut self, ctx: &egui::Context, action: Action) {
        let Entry { state, run } = self.entry(action);
        match state.disabled {
            None => run(self, ctx),
            Some(why) => self.cx.say(Severity::Note, format!("{}: {why}", action.name())),
        }
    }

    /// An action on what the fibres of the body are.
    fn with_fibres(&self, run: ActionFn) -> Entry {
        let met = self.cx.active_body().is_some_and(|body| !body.fibres.is_empty());
        when(met, "The body has no fibres", run)
    }

    /// An action that writes something beside the window, one thing at a time.
    fn with_transfer(&self, run: ActionFn) -> Entry {
        unless(self.transfer.is_busy(), run)
    }

    fn ask_clip(&mut self, ctx: &egui::Context, kind: ClipKind) {
        let look = self.views.look(&self.cx, ctx.pixels_per_point());
        Transfer::ask_clip(kind, &look, &mut self.cx);
    }

    /// Why no earlier frame can be shown.
    fn no_replay(&self) -> Option<&'static str> {
        if self.cx.simulation.is_comparing() {
            return Some("Nothing is recorded while integrators are compared");
        }
        (!self.cx.simulation.has_frames()).then_some("There are no earlier frames yet")
    }

    /// Why nothing can be deleted.
    fn nothing_to_delete(&self) -> Option<&'static str> {
        match self.cx.selection.vertices() {
            _ if self.cx.selection.pin().is_some() || self.cx.selection.is_body() => None,
            Some(chosen) => chosen.is_empty().then_some("Select vertices first"),
            None => {
                let any = self.cx.selection.active().is_some() || self.cx.selection.sheet().is_some();
                (!any).then_some("Select a fibre, a sheet, a pin or a body first")
            }
        }
    }

    /// Puts the selected fibres or body on the clipboard.
    fn copy(&mut self, ctx: &egui::Context) {
        if let Some(text) = clipboard::copied(&mut self.cx) {
            ctx.copy_text(text);
        }
    }

    /// Goes into the vertices of the active fibre, or back to whole fibres.
    fn toggle_vertices(&mut self) {
        let enter = self.cx.selection.vertices().is_none();
        self.cx.selection.enter_vertices(enter);
        self.views.editing_mut().note_tab();
    }
}

fn flip(switch: &mut bool) {
    *switch = !*switch;
}
