//! What stands beside the course of a drive: what kind it is, its numbers, and those of the selected key.

use super::actions::{named, playhead, undriven};
use super::keys::{as_keys, as_wave, first_key, on_frame, value_of};
use crate::edit::Command;
use crate::scene::{
    Activation, AfterLast, Drivable, Drive, DriveKeys, ElementActivation, Interpolation, Scene, Sheet, SheetActivation,
    Wave,
};
use crate::text::number::compact;
use crate::text::quantity::typed;
use crate::ui::context::{Context, Step};
use crate::ui::motion_fields::drive_words;
use crate::ui::theme::GRID;
use egui::{ComboBox, DragValue, TextStyle, Ui};

/// Share by which a fibre, a sheet or an element that begins to act shortens.
const FIRST_CONTRACTION: f64 = 0.2;
/// Angle by which an element of one that begins to act turns [degrees].
const FIRST_TURN: f64 = 20.0;
/// Width of a choice [points].
const CHOICE: f32 = 76.0;

/// Shows the kind of a drive and its numbers.
pub(super) fn lane_fields(ui: &mut Ui, cx: &mut Context, of: &Drivable) {
    let scene = cx.scene().clone();
    let Some(drive) = of.drive(&scene) else { return };
    ui.style_mut().override_text_style = Some(TextStyle::Small);
    ui.style_mut().drag_value_text_style = TextStyle::Small;
    ui.spacing_mut().item_spacing = [GRID, 0.75 * GRID].into();
    ui.spacing_mut().button_padding = [GRID, 1.0].into();
    ui.spacing_mut().interact_size = [24.0, 20.0].into();
    let mut changed = drive.clone();
    let mut step = Step::Present;
    ui.add_space(if matches!(drive, Drive::Shared(_)) { 2.0 } else { GRID });
    ui.horizontal(|ui| {
        if let Some(command) = kind_menu(ui, cx, of, drive) {
            cx.edit(&command, Step::Own);
            return;
        }
        match &mut changed {
            Drive::Constant(value) => {
                number(ui, value, "value ", "", of.limits(&scene), "What it is at all times");
            }
            Drive::Keyframes(keys) => {
                if key_choices(ui, keys) {
                    step = Step::Own;
                }
            }
            Drive::Wave(wave) => wave_values(ui, wave),
            Drive::Shared(_) => {}
        }
    });
    let mut chosen = None;
    match &mut changed {
        Drive::Keyframes(keys) => {
            ui.horizontal(|ui| {
                chosen = key_values(ui, cx, of, keys);
                if takes_otherwise_away(ui, keys) {
                    step = Step::Own;
                }
            });
        }
        Drive::Wave(wave) => {
            ui.horizontal(|ui| wave_times(ui, wave, of.runs_along(&scene)));
        }
        Drive::Constant(_) | Drive::Shared(_) => {}
    }
    if changed != *drive && cx.scene().as_ref() == scene.as_ref() {
        cx.edit(&Command::SetDrive { of: of.clone(), drive: Some(changed) }, step);
        if let Some(index) = chosen {
            cx.keys.set_of(of, &[index]);
        }
    }
}

/// Chooses another kind of drive, or none.
fn kind_menu(ui: &mut Ui, cx: &Context, of: &Drivable, drive: &Drive) -> Option<Command> {
    let scene = cx.scene();
    let (time, frame) = playhead(cx);
    let shared = of.shared(scene);
    let title = match drive {
        Drive::Shared(id) => format!("Shared: {id}"),
        other => other.word().to_owned(),
    };
    let set = |drive: Drive| Some(Command::SetDrive { of: of.clone(), drive: Some(drive) });
    let mut asked = None;
    let width = if matches!(drive, Drive::Shared(_)) { 2.0 * CHOICE } else { CHOICE };
    let menu = ComboBox::from_id_salt("kind").width(width).selected_text(title).show_ui(ui, |ui| {
        let mut choice = |ui: &mut Ui, is: bool, name: &str, tooltip: &str, to: &dyn Fn() -> Option<Command>| {
            if ui.selectable_label(is, name).on_hover_text(tooltip).clicked() && !is {
                asked = to();
            }
        };
        let is = |word: &str| drive.word() == word;
        choice(ui, is("Constant"), "Constant", "The same at all times: what it is now", &|| {
            set(Drive::Constant(value_of(drive, shared, time)))
        });
        choice(ui, is("Keys"), "Keys", "From key to key; of a wave, one swing over and over", &|| {
            set(as_keys(Some(drive), shared, time, frame).into())
        });
        choice(ui, is("Wave"), "Wave", "Up and down, between the least and the greatest that it is", &|| {
            set(as_wave(Some(drive), shared).into())
        });
        if !matches!(of, Drivable::Shared { .. }) {
            for one in shared {
                let follows = *drive == Drive::Shared(one.id.clone());
                let name = format!("Shared: {}", one.id);
                choice(ui, follows, &name, "Follows this drive of the body, with others", &|| {
                    set(Drive::Shared(one.id.clone()))
                });
            }
            if of.body().is_some() && !matches!(drive, Drive::Shared(_)) {
                choice(ui, false, "Share it", "Makes a drive of the body of it, for other parts to follow", &|| {
                    Some(share(of, drive, scene))
                });
            }
        }
        choice(ui, false, "Remove", "Takes the drive away", &|| Some(removed(of, drive, scene)));
    });
    menu.response.on_hover_text("What kind of drive it is");
    asked
}

/// Takes a drive away; what followed it has one of its own then.
fn removed(of: &Drivable, drive: &Drive, scene: &Scene) -> Command {
    let followers = of.followers(scene).into_iter().map(|one| (one, Some(drive.clone())));
    let drives = followers.chain([(of.clone(), None)]).collect();
    named("Remove drive", drives)
}

/// Makes a shared drive of one.
fn share(of: &Drivable, drive: &Drive, scene: &Scene) -> Command {
    let known = of.shared(scene);
    let is_free = |id: &String| known.iter().all(|one| one.id != *id);
    let id = (1..=known.len() + 1).map(|k| format!("drive-{k}")).find(is_free).unwrap_or_default();
    let body = of.body().unwrap_or_default().to_owned();
    let shared = Drivable::Shared { body, drive: id.clone() };
    named("Share drive", vec![(shared, Some(drive.clone())), (of.clone(), Some(Drive::Shared(id)))])
}

/// How a drive goes from key to key and from the last one on; whether another way was chosen.
fn key_choices(ui: &mut Ui, keys: &mut DriveKeys) -> bool {
    let before = (keys.between, keys.after);
    let between = [
        (Interpolation::Smooth, "Smooth", "From rest to rest, or as the handles of its keys say"),
        (Interpolation::Linear, "Linear", "At a steady rate"),
        (Interpolation::Stepped, "Stepped", "Keeps its value up to the next key"),
    ];
    choice(ui, "between", &mut keys.between, &between, "From one key to the next");
    let after = [
        (AfterLast::Hold, "Hold", "Keeps the last value"),
        (AfterLast::Repeat, "Repeat", "Begins again with the first key, over and over"),
        (AfterLast::Mirror, "Mirror", "Goes back to the first key and comes again, over and over"),
    ];
    let comes_again = keys.keys.len() > 1;
    ui.add_enabled_ui(comes_again, |ui| choice(ui, "after", &mut keys.after, &after, "From the last key on"));
    before != (keys.between, keys.after)
}

/// Shows what keys are otherwise, if anything; whether it was taken away.
fn takes_otherwise_away(ui: &mut Ui, keys: &mut DriveKeys) -> bool {
    let Some(otherwise) = &keys.otherwise else { return false };
    let back =
        otherwise.back_in.map_or(String::new(), |seconds| format!(", and again {} s after the last", compact(seconds)));
    ui.weak("on top").on_hover_text(format!("Before the first key it is {}{back}", drive_words(&otherwise.drive)));
    let taken = ui.small_button("×").on_hover_text("Takes away what it is before its first key").clicked();
    if taken {
        keys.otherwise = None;
    }
    taken
}

fn choice<T: PartialEq + Copy>(ui: &mut Ui, salt: &str, value: &mut T, all: &[(T, &str, &str)], tooltip: &str) {
    let name = all.iter().find(|(known, ..)| known == value).map_or("", |(_, name, _)| name);
    let menu = ComboBox::from_id_salt(salt).width(CHOICE).selected_text(name).show_ui(ui, |ui| {
        for (known, name, tooltip) in all {
            ui.selectable_value(value, *known, *name).on_hover_text(*tooltip);
        }
    });
    menu.response.on_hover_text(tooltip);
}

/// Time and value of the selected key, if it is one; gives its number after a change.
fn key_values(ui: &mut Ui, cx: &Context, of: &Drivable, keys: &mut DriveKeys) -> Option<usize> {
    let chosen = cx.keys.of(of);
    let &[index] = chosen.as_slice() else {
        let text = match chosen.len() {
            0 if keys.keys.len() == 1 => "1 key".to_owned(),
            0 => format!("{} keys", keys.keys.len()),
            count => format!("{count} of {} keys selected", keys.keys.len()),
        };
        ui.weak(text);
        return None;
    };
    let frame = cx.scene().time.frame_seconds();
    let before = keys.keys.get(index)?.clone();
    let mut key = before.clone();
    let (earlier, later) = (index.checked_sub(1).map(|k| keys.keys[k].time), keys.keys.get(index + 1).map(|k| k.time));
    // Between its neighbours: it goes past them in its lane.
    let span = [earlier.map_or(0.0, |time| time + 0.5 * frame), later.map_or(1e6, |time| time - 0.5 * frame)];
    if span[0] <= span[1] {
        number(ui, &mut key.time, "key at ", " s", span, "Time of the selected key, between its neighbours");
    }
    number(ui, &mut key.value, "is ", "", of.limits(cx.scene()), "Value of the selected key");
    if keys.between == Interpolation::Smooth && keys.keys.len() > 1 {
        let any = [f64::NEG_INFINITY, f64::INFINITY];
        number(
            ui,
            &mut key.slope,
            "slope ",
            " 1/s",
            any,
            "How steeply the course goes through it, as its handle shows",
        );
    }
    keys.keys[index] = key;
    Some(index)
}

/// What a wave swings between.
fn wave_values(ui: &mut Ui, wave: &mut Wave) {
    const ANY: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    number(ui, &mut wave.mean, "mean ", "", ANY, "What the wave swings around");
    number(ui, &mut wave.amplitude, "± ", "", ANY, "How far it swings to either side");
    number(ui, &mut wave.period, "every ", " s", [1e-3, 1e6], "Time of one swing");
}

/// When a wave swings, and along what.
fn wave_times(ui: &mut Ui, wave: &mut Wave, runs_along: bool) {
    number(ui, &mut wave.phase_degrees, "phase ", "°", [-3600.0, 3600.0], "How late it is in time: 360° is a period");
    if runs_along {
        let mut length = wave.wavelength.unwrap_or(0.0);
        let drag = DragValue::new(&mut length).speed(1e-3).prefix("length ");
        let drag =
            drag.custom_formatter(
                |value, _| if value == 0.0 { "none".to_owned() } else { format!("{} m", compact(value)) },
            );
        let tooltip = "Length of the wave along the fibre from its first point on; below 0 it runs the other way, 0 for all of \
                       the fibre at once";
        if ui.add(drag.custom_parser(|text| typed(text, "m"))).on_hover_text(tooltip).changed() {
            wave.wavelength = (length.abs() >= 1e-6).then_some(length);
        }
    }
    number(ui, &mut wave.start, "from ", " s", [0.0, 1e6], "When it starts: it rises from 0 within its first period");
}

fn number(ui: &mut Ui, value: &mut f64, prefix: &str, suffix: &str, [least, most]: [f64; 2], tooltip: &str) {
    let speed = (value.abs() * 0.01).max(1e-3);
    let unit = suffix.trim().to_owned();
    let drag = DragValue::new(value).range(least..=most).clamp_existing_to_range(false).speed(speed);
    let drag = drag.prefix(prefix).suffix(suffix).custom_formatter(|value, _| compact(value));
    ui.add(drag.custom_parser(move |text| typed(text, &unit))).on_hover_text(tooltip);
}

/// Offers everything that could be driven and is not.
pub(super) fn add_menu(ui: &mut Ui, cx: &mut Context) {
    let scene = cx.scene().clone();
    let menu = ui.menu_button(egui::RichText::new("Add a drive").small(), |ui| {
        egui::ScrollArea::vertical().max_height(300.0).show(ui, |ui| {
            for of in scene.drivables().into_iter().filter(|of| of.drive(&scene).is_none()) {
                if ui.button(of.title(&scene)).clicked() {
                    cx.edit(&first_drive(&of, cx), Step::Own);
                    ui.close();
                }
            }
        });
    });
    menu.response.on_hover_text("Lets something change in time: a key at the time that is shown is its first");
}

/// A first key of something, which leaves it as it is.
fn first_drive(of: &Drivable, cx: &Context) -> Command {
    let scene = cx.scene();
    let (time, frame) = playhead(cx);
    let key = |value: f64| Drive::from(first_key(on_frame(time, frame), value));
    if let Drivable::Fibre { body, fibre } = of
        && let Some(one) = scene.body(body).and_then(|body| body.fibres.iter().find(|one| one.id == *fibre))
    {
        // One that yields does not act.
        let fibre = crate::scene::Fibre { yields: None, ..one.clone() };
        let fibre = fibre.with_activation(Activation::contracting(FIRST_CONTRACTION, key(0.0)));
        return Command::set_fibres("Let act", body, vec![fibre]);
    }
    if let Drivable::Sheet { body, sheet } = of
        && let Some(one) = scene.body(body).and_then(|body| body.sheets.iter().find(|one| one.id == *sheet))
    {
        let acts = SheetActivation::contracting([FIRST_CONTRACTION, 0.0], key(0.0));
        let sheet = Sheet { activation: Some(acts), ..one.clone() };
        return Command::SetSheet { verb: "Let act".to_owned(), body: body.clone(), sheet };
    }
    if let Drivable::Element { body, element } = of
        && let Some(one) = scene.body(body)
    {
        let mut elements = one.elements.clone();
        for one in elements.iter_mut().filter(|one| one.id == *element) {
            let acts = if one.measure.is_angle() {
                ElementActivation::turning(FIRST_TURN, key(0.0))
            } else {
                ElementActivation::contracting(FIRST_CONTRACTION, key(0.0))
            };
            one.activation = Some(acts);
        }
        return Command::SetElements { body: body.clone(), elements };
    }
    of_course(of, scene).unwrap_or_else(|| Command::SetDrive { of: of.clone(), drive: Some(key(undriven(of))) })
}

/// Makes keys of the course of its own that something follows, which stays as it is.
fn of_course(of: &Drivable, scene: &Scene) -> Option<Command> {
    Some(named("Make keys of its course", vec![(of.clone(), Some(of.course(scene)?))]))
}

/// Offers keys for everything that follows a course of its own.
pub(super) fn course_buttons(ui: &mut Ui, cx: &mut Context) {
    let scene = cx.scene().clone();
    for of in scene.drivables() {
        let Some(command) = of_course(&of, &scene) else { continue };
        let title = format!("{} as keys", of.title(&scene));
        let tooltip = "It moves by numbers of its own now, and in the same way after: they become keys in a lane";
        if ui.small_button(title).on_hover_text(tooltip).clicked() {
            cx.edit(&command, Step::Own);
        }
    }
}
