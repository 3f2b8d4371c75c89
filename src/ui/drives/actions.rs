//! What is done to drives by buttons and keys.

use super::keys::{as_keys, first_key, key_at, on_frame, with_key_on, with_keys, without_keys};
use crate::edit::Command;
use crate::scene::{Drivable, Drive, DriveKey};
use crate::text::number::{compact, moment};
use crate::ui::context::{Context, Severity, Step};
use serde::{Deserialize, Serialize};

/// What a text on the clipboard says that it holds.
pub(crate) const KEYS: &str = "keys";

/// How something that a drive can move stands at the time that is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum KeyState {
    /// It does not change in time.
    Still,
    /// It changes, and there is no key in this frame.
    Driven,
    /// It has a key in this frame, of this number.
    Keyed(usize),
}

/// The time that is shown [s], and the length of a frame [s].
pub(super) fn playhead(cx: &Context) -> (f64, f64) {
    (cx.simulation.published().status.time, cx.scene().time.frame_seconds())
}

/// How something stands at the time that is shown.
pub(super) fn key_state(of: &Drivable, cx: &Context) -> KeyState {
    let (time, frame) = playhead(cx);
    match of.resolved(cx.scene()) {
        None | Some(Drive::Constant(_)) => KeyState::Still,
        Some(Drive::Keyframes(keys)) => key_at(keys, time, frame).map_or(KeyState::Driven, KeyState::Keyed),
        Some(Drive::Wave(_) | Drive::Shared(_)) => KeyState::Driven,
    }
}

/// Sets a key at the time that is shown with the value that there is, or takes it away again.
pub(crate) fn toggle_key(of: &Drivable, cx: &mut Context) {
    let scene = cx.scene().clone();
    let (time, frame) = playhead(cx);
    let time = on_frame(time, frame);
    let source = of.source(&scene);
    let title = source.title(&scene);
    let at = moment(time, frame);
    let (name, drive, chosen) = match source.drive(&scene) {
        Some(Drive::Wave(_)) => {
            let said = format!("{title} follows a wave: choose Keys in its lane first (Drives, below the views)");
            cx.say(Severity::Note, said);
            return;
        }
        Some(Drive::Keyframes(keys)) => {
            if let Some(index) = key_at(keys, time, frame) {
                ("Remove key", without_keys(keys, &[index]), None)
            } else {
                let (keys, index) = with_key_on(keys, time, frame);
                ("Set key", keys.into(), Some(index))
            }
        }
        None => match source.course(&scene) {
            Some(Drive::Keyframes(course)) => {
                let (keys, index) = with_key_on(&course, time, frame);
                ("Set key", keys.into(), Some(index))
            }
            // What nothing drives yet is all there, or where it starts.
            _ => ("Set key", first_key(time, undriven(&source)).into(), Some(0)),
        },
        still => ("Set key", as_keys(still, &[], time, frame).into(), Some(0)),
    };
    let said = match (&drive, chosen) {
        (Drive::Keyframes(keys), Some(index)) => {
            format!("Key of {title} at {at}: {}. Drives, below the views, show it", compact(keys.keys[index].value))
        }
        _ => format!("Took the key of {title} at {at} away"),
    };
    cx.say(Severity::Note, said);
    cx.edit(&named(name, vec![(source.clone(), Some(drive))]), Step::Own);
    cx.keys.set(chosen.map(|index| (source, index)).into_iter().collect());
}

/// What the drive of something is before there is one.
pub(super) fn undriven(of: &Drivable) -> f64 {
    match of {
        Drivable::Panel(_) | Drivable::Collider(_) | Drivable::Pin { .. } => 0.0,
        _ => 1.0,
    }
}

/// Changes of drives as one step of undo.
pub(super) fn named(name: &str, drives: Vec<(Drivable, Option<Drive>)>) -> Command {
    let commands = drives.into_iter().map(|(of, drive)| Command::SetDrive { of, drive }).collect();
    Command::Many { name: name.to_owned(), commands }
}

/// "a key" or "3 keys", after a verb.
pub(super) fn counted(verb: &str, count: usize) -> String {
    if count == 1 { format!("{verb} key") } else { format!("{verb} {count} keys") }
}

/// Deletes the selected keys.
pub(crate) fn delete_keys(cx: &mut Context) {
    let scene = cx.scene().clone();
    let without = |of: Drivable| match of.drive(&scene) {
        Some(Drive::Keyframes(keys)) => {
            let drive = without_keys(keys, &cx.keys.of(&of));
            Some((of, Some(drive)))
        }
        _ => None,
    };
    let drives: Vec<_> = cx.keys.drives().into_iter().filter_map(without).collect();
    let name = counted("Delete", cx.keys.len());
    cx.keys.clear();
    cx.edit(&named(&name, drives), Step::Own);
}

/// What is put on the clipboard.
#[derive(Serialize, Deserialize)]
struct Clipping {
    sinew: String,
    keys: Vec<CopiedKey>,
}

/// A key away from its drive.
#[derive(Serialize, Deserialize)]
struct CopiedKey {
    /// Pointer to the drive that it is from.
    of: String,
    /// After the first of them [s].
    time: f64,
    value: f64,
    #[serde(default)]
    slope: f64,
}

/// The selected keys as text.
pub(crate) fn copied_keys(cx: &mut Context) -> Option<String> {
    let scene = cx.scene().clone();
    let mut keys = Vec::new();
    for of in cx.keys.drives() {
        let (Some(pointer), Some(Drive::Keyframes(list))) = (of.pointer(&scene), of.drive(&scene)) else { continue };
        let chosen = cx.keys.of(&of).into_iter().filter_map(|index| list.keys.get(index));
        keys.extend(chosen.map(|key| CopiedKey {
            of: pointer.clone(),
            time: key.time,
            value: key.value,
            slope: key.slope,
        }));
    }
    let first = keys.iter().map(|key| key.time).fold(f64::INFINITY, f64::min);
    for key in &mut keys {
        key.time -= first;
    }
    let count = keys.len();
    let text = serde_json::to_string_pretty(&Clipping { sinew: KEYS.to_owned(), keys }).ok()?;
    cx.say(Severity::Note, format!("{}: Ctrl+V puts them at the time that is shown", counted("Copied", count)));
    Some(text)
}

/// Puts the keys of a text at the time that is shown, selected: those of one drive into the drive of the selected keys,
/// where there is one, and else all into the drives that they are from. False where the text holds none.
pub(crate) fn paste_keys(text: &str, cx: &mut Context) -> bool {
    let clipping = serde_json::from_str::<Clipping>(text).ok().filter(|clipping| !clipping.keys.is_empty());
    let Some(Clipping { keys, .. }) = clipping else { return false };
    let scene = cx.scene().clone();
    let (now, frame) = playhead(cx);
    let now = on_frame(now, frame);
    let one = keys.iter().all(|key| key.of == keys[0].of).then(|| cx.keys.drives()).filter(|drives| drives.len() == 1);
    let mut drives: Vec<(Drivable, Option<Drive>)> = Vec::new();
    let mut chosen = Vec::new();
    for of in scene.drivables() {
        let is_meant = |key: &&CopiedKey| match &one {
            Some(drives) => drives[0] == of,
            None => of.pointer(&scene).as_deref() == Some(&key.of),
        };
        let key = |key: &CopiedKey| DriveKey { slope: key.slope, ..DriveKey::new(now + key.time, key.value) };
        let put: Vec<DriveKey> = keys.iter().filter(is_meant).map(key).collect();
        if put.is_empty() {
            continue;
        }
        let (keys, which) = match of.drive(&scene) {
            Some(Drive::Keyframes(keys)) => with_keys(keys, &put, frame),
            _ => with_keys(&first_key(put[0].time, put[0].value), &put, frame),
        };
        chosen.extend(which.into_iter().map(|index| (of.clone(), index)));
        drives.push((of, Some(keys.into())));
    }
    if drives.is_empty() {
        cx.say(
            Severity::Warning,
            "Nothing here is called as what these keys were copied from: select a key of a drive",
        );
        return true;
    }
    cx.say(Severity::Note, format!("{} at {}", counted("Pasted", chosen.len()), moment(now, frame)));
    cx.edit(&named(&counted("Paste", chosen.len()), drives), Step::Own);
    cx.keys.set(chosen);
    true
}
