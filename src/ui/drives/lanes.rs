//! The lanes below the timeline, one for each drive of the scene.

use super::actions::{counted, named, playhead};
use super::drag::{KeyBox, KeyDrag};
use super::fields::{add_menu, course_buttons, lane_fields};
use super::handle::{Handle, HandleDrag, handles};
use super::key_button::{key_button, point_at};
use super::keys::{first_key, on_frame, with_key};
use super::lane::{LOW, TALL, faint, key_places, paint_lane, words_at};
use super::value_scale::{REACH, ValueScale, round};
use super::wave_handle::{WaveDrag, WaveHandle};
use crate::scene::{Drivable, Drive, Scene};
use crate::text::number::{compact, moment};
use crate::ui::context::{Context, Severity, Step};
use crate::ui::theme::{self, GRID};
use crate::ui::timescale::TimeScale;
use egui::{
    Align, Key, Label, Layout, Pos2, Rangef, Rect, Response, RichText, ScrollArea, Sense, Stroke, Ui, UiBuilder,
};
use egui::{Role, StrokeKind, WidgetInfo};

/// Between lanes [points].
const BETWEEN: f32 = 2.0;

/// Where what stands in a lane lies from left to right: its name, its course, its fields [points].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Columns {
    pub(crate) names: Rangef,
    pub(crate) courses: Rangef,
    pub(crate) fields: Rangef,
}

/// The lanes, and what is done in them.
#[derive(Default)]
pub(crate) struct DriveLanes {
    drag: Option<KeyDrag>,
    turned: Option<HandleDrag>,
    swung: Option<WaveDrag>,
    boxed: Option<KeyBox>,
}

/// A lane as it is shown in a frame.
struct ShownLane {
    of: Drivable,
    values: ValueScale,
    keys: Vec<(f64, Pos2)>,
    handles: Vec<Handle>,
    wave: Option<WaveHandle>,
    response: Response,
}

impl DriveLanes {
    /// The drives of a scene, in the order of their lanes.
    fn listed(scene: &Scene) -> Vec<Drivable> {
        scene.drivables().into_iter().filter(|of| of.drive(scene).is_some()).collect()
    }

    /// How many there are.
    pub(crate) fn count(scene: &Scene) -> usize {
        Self::listed(scene).len()
    }

    /// The last time that must be seen [s]: that of the last key.
    pub(crate) fn last(scene: &Scene) -> f64 {
        let last = |of: Drivable| match of.drive(scene) {
            Some(Drive::Keyframes(keys)) => keys.keys.last().map_or(0.0, |key| key.time),
            _ => 0.0,
        };
        scene.drivables().into_iter().map(last).fold(0.0, f64::max)
    }

    /// The scale of time to be shown, where what is dragged has set one.
    pub(crate) fn held_scale(&self) -> Option<TimeScale> {
        let turned = self.turned.as_ref().map(HandleDrag::scale);
        self.drag.as_ref().map(KeyDrag::scale).or(turned).or(self.swung.as_ref().map(WaveDrag::scale))
    }

    /// Shows the lanes over what is left of the panel.
    pub(crate) fn show(&mut self, ui: &mut Ui, cx: &mut Context, scale: &TimeScale, columns: Columns) {
        ui.spacing_mut().item_spacing.y = BETWEEN;
        ScrollArea::vertical().id_salt("lanes").auto_shrink(false).show(ui, |ui| {
            let mut shown = Vec::new();
            for of in Self::listed(cx.scene()) {
                shown.extend(self.lane(ui, cx, of, scale, columns));
            }
            ui.horizontal(|ui| {
                ui.add_space((columns.names.min - ui.min_rect().left()).max(0.0));
                add_menu(ui, cx);
                course_buttons(ui, cx);
                if shown.is_empty() {
                    ui.weak("Nothing is driven yet: a key beside a field, or this menu, lets it change in time");
                }
            });
            self.take(ui, cx, scale, &shown);
        });
    }

    /// Shows one lane; gives what can be done to its course.
    fn lane(
        &self,
        ui: &mut Ui,
        cx: &mut Context,
        of: Drivable,
        scale: &TimeScale,
        columns: Columns,
    ) -> Option<ShownLane> {
        let drive = of.resolved(cx.scene())?.clone();
        let follows = matches!(of.drive(cx.scene()), Some(Drive::Shared(_)));
        let height = if follows { LOW } else { TALL };
        let (row, _) = ui.allocate_exact_size([ui.available_width(), height].into(), Sense::hover());
        let is_idle = self.held_scale().is_none() && self.boxed.is_none();
        // Passes that are not drawn take hold of keys, too.
        if !ui.clip_rect().intersects(row) && is_idle {
            return None;
        }
        let place = Rect::from_x_y_ranges(columns.courses, row.y_range());
        let values = self.drag.as_ref().and_then(|drag| drag.values(&of));
        let values = values.or_else(|| self.turned.as_ref().and_then(|turned| turned.values(&of)));
        let values = values.or_else(|| self.swung.as_ref().and_then(|swung| swung.values(&of)));
        let values = values.unwrap_or_else(|| ValueScale::of(&drive, place.shrink2([0.0, 2.0].into()).y_range()));
        let title = of.title(cx.scene());
        let part = |columns: Rangef| UiBuilder::new().max_rect(Rect::from_x_y_ranges(columns, row.y_range()));
        ui.push_id(of.clone(), |ui| {
            let builder = part(columns.names).layout(Layout::right_to_left(Align::Center));
            let named = ui.scope_builder(builder, |ui| {
                key_button(ui, cx, &of);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    if follows {
                        ui.add_space(2.0 * GRID);
                    }
                    let text = RichText::new(&title).small();
                    ui.add(Label::new(if follows { text.weak() } else { text }).truncate())
                        .on_hover_text(told(&of, cx));
                });
            });
            point_at(ui, cx, named.response.rect, &of);
            let response = ui.interact(place, ui.scope_id().with("course"), Sense::click_and_drag());
            let (time, _) = playhead(cx);
            let spoken = format!("Lane of {title}");
            response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &spoken));
            paint_lane(ui, cx, (&of, &drive), place, (scale, &values), time);
            ui.scope_builder(part(columns.fields).layout(Layout::top_down(Align::Min)), |ui| lane_fields(ui, cx, &of));
            if follows {
                return None;
            }
            let mut shown = ShownLane { of, values, keys: Vec::new(), handles: Vec::new(), wave: None, response };
            match &drive {
                Drive::Keyframes(keys) => {
                    let places = keys.keys.iter().map(|key| key.time).zip(key_places(keys, scale, &values));
                    shown.keys = places.collect();
                    shown.handles = handles(keys, &cx.keys.of(&shown.of), scale, &values);
                }
                Drive::Wave(wave) => shown.wave = Some(WaveHandle::of(wave, scale, &values)),
                Drive::Constant(_) | Drive::Shared(_) => {}
            }
            Some(shown)
        })
        .inner
    }

    /// Does what the pointer does in the lanes.
    fn take(&mut self, ui: &Ui, cx: &mut Context, scale: &TimeScale, shown: &[ShownLane]) {
        let (pointer, shift, command) =
            ui.input(|input| (input.pointer.interact_pos(), input.modifiers.shift, input.modifiers.command));
        for lane in shown {
            let at = lane.response.hover_pos().or_else(|| lane.response.interact_pointer_pos());
            if let Some(at) = at.filter(|_| lane.response.hovered()) {
                cx.status.hint = "Double click: another key. Drag: keys and the crest of a wave, on frames but for Shift, handles, or a box. Delete, Ctrl+C, V";
                cx.pointed = Some(lane.of.clone());
                hint_at(lane, cx, scale, at);
            }
            if lane.response.drag_started() {
                let origin = ui.input(|input| input.pointer.press_origin()).or(at).unwrap_or_default();
                let turned = lane.handles.iter().find_map(|handle| Some((*handle, handle.hit(origin)?)));
                let wave = lane.wave.filter(|wave| wave.is_hit(origin));
                match hit(lane, origin) {
                    None if wave.is_some() => {
                        let with = (scale, &lane.values);
                        self.swung = wave.and_then(|wave| WaveDrag::begin(cx, &lane.of, (wave, origin), with));
                    }
                    None if turned.is_some() => {
                        let with = (scale, &lane.values);
                        self.turned = turned.and_then(|turned| HandleDrag::begin(cx, &lane.of, turned, with));
                    }
                    Some(index) => {
                        if !cx.keys.contains(&lane.of, index) {
                            // Shift is for places off the frames here.
                            if !command {
                                cx.keys.clear();
                            }
                            cx.keys.add([(lane.of.clone(), index)]);
                        }
                        let lanes: Vec<_> = shown.iter().map(|lane| (lane.of.clone(), lane.values)).collect();
                        self.drag = Some(KeyDrag::begin(cx, origin, lane.keys[index].0, scale, &lanes));
                    }
                    None => self.boxed = Some(KeyBox { origin, adding: shift || command }),
                }
            } else if lane.response.double_clicked() {
                if let Some(at) = lane.response.interact_pointer_pos().filter(|at| hit(lane, *at).is_none()) {
                    add_key(lane, cx, scale, at);
                }
            } else if lane.response.clicked() {
                let key = lane.response.interact_pointer_pos().and_then(|at| hit(lane, at));
                match key {
                    Some(index) if shift || command => cx.keys.toggle(&lane.of, index),
                    Some(index) => cx.keys.set(vec![(lane.of.clone(), index)]),
                    None if shift || command => {}
                    None => cx.keys.clear(),
                }
            }
        }
        self.go_on(ui, cx, pointer, shift, shown);
    }

    /// Goes on with what is dragged.
    fn go_on(&mut self, ui: &Ui, cx: &mut Context, pointer: Option<Pos2>, shift: bool, shown: &[ShownLane]) {
        let (is_down, escaped) = ui.input(|input| (input.pointer.primary_down(), input.key_pressed(Key::Escape)));
        if escaped {
            if let Some(drag) = self.drag.take() {
                drag.abandon(cx);
            }
            if let Some(turned) = self.turned.take() {
                turned.abandon(cx);
            }
            if let Some(swung) = self.swung.take() {
                swung.abandon(cx);
            }
            self.boxed = None;
            cx.keys.clear();
        }
        if let (Some(turned), Some(pointer)) = (&self.turned, pointer) {
            turned.follow(cx, pointer, shift);
            cx.status.gesture = Some("Turning the handle".to_owned());
        }
        if let (Some(swung), Some(pointer)) = (&self.swung, pointer) {
            swung.follow(cx, pointer, shift);
            cx.status.gesture = Some("Changing the wave".to_owned());
        }
        if let (Some(drag), Some(pointer)) = (&self.drag, pointer) {
            drag.follow(cx, pointer, shift);
            cx.status.gesture = Some(counted("Moving", cx.keys.len()));
        }
        if let (Some(boxed), Some(pointer)) = (self.boxed, pointer) {
            let reach = boxed.reach(pointer);
            let accent = theme::color(cx.tone.pictures().accent);
            ui.painter().rect(reach, 0.0, faint(accent), Stroke::new(1.0, accent), StrokeKind::Inside);
            if !is_down {
                let within = |lane: &ShownLane| {
                    let hits = lane.keys.iter().enumerate().filter(|(_, (_, at))| reach.contains(*at));
                    hits.map(|(index, _)| (lane.of.clone(), index)).collect::<Vec<_>>()
                };
                if !boxed.adding {
                    cx.keys.clear();
                }
                cx.keys.add(shown.iter().flat_map(within));
            }
        }
        if !is_down {
            (self.drag, self.turned, self.swung, self.boxed) = (None, None, None, None);
        }
    }
}

/// The key of a lane that is hit.
fn hit(lane: &ShownLane, at: Pos2) -> Option<usize> {
    let near = lane.keys.iter().enumerate().map(|(index, (_, key))| (index, key.distance(at)));
    near.filter(|(_, far)| *far <= REACH).min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
}

/// Adds a key where a lane was clicked.
fn add_key(lane: &ShownLane, cx: &mut Context, scale: &TimeScale, at: Pos2) {
    let scene = cx.scene().clone();
    let frame = scene.time.frame_seconds();
    let time = on_frame(scale.time(at.x), frame);
    let [least, most] = lane.values.within(lane.of.limits(&scene));
    let value = round(lane.values.value(at.y).clamp(least, most.max(least)), lane.values.step());
    let (keys, index) = match lane.of.drive(&scene) {
        Some(Drive::Keyframes(keys)) => with_key(keys, time, value, frame),
        Some(Drive::Wave(_)) => {
            cx.say(Severity::Note, "A wave has no keys: drag its crest, or choose Keys in its lane first");
            return;
        }
        _ => (first_key(time, value), 0),
    };
    cx.edit(&named("Add key", vec![(lane.of.clone(), Some(keys.into()))]), Step::Own);
    cx.keys.set(vec![(lane.of.clone(), index)]);
}

/// What is said of a lane under the pointer.
fn hint_at(lane: &ShownLane, cx: &Context, scale: &TimeScale, at: Pos2) {
    let scene = cx.scene();
    let Some(drive) = lane.of.resolved(scene) else { return };
    let time = scale.time(at.x).max(0.0);
    let words = format!("{}: {}", moment(time, scene.time.frame_seconds()), words_at(&lane.of, drive, scene, time));
    let mut tip = egui::Tooltip::for_enabled(&lane.response);
    let place = lane.response.rect;
    tip.popup = tip.popup.anchor(Rect::from_x_y_ranges(at.x..=at.x, place.y_range())).align(egui::RectAlign::TOP);
    tip.show(|ui| ui.label(words));
}

/// What a lane's name stands for.
fn told(of: &Drivable, cx: &Context) -> String {
    let scene = cx.scene();
    let follow: Vec<String> = of.followers(scene).iter().map(|one| one.title(scene)).collect();
    let amount = of.at_one(scene).map(|(amount, unit)| format!("where 1 is {} {unit}", compact(amount)));
    let followed = (!follow.is_empty()).then(|| format!("followed by {}", follow.join("; ")));
    let follows = match of.drive(scene) {
        Some(Drive::Shared(id)) => Some(format!("follows \"{id}\"")),
        _ => None,
    };
    let lines: Vec<String> = [Some(of.title(scene)), amount, followed, follows].into_iter().flatten().collect();
    lines.join("\n")
}
