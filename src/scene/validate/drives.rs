//! Checks of drives, and of what they move.

use super::brief;
use super::check::{
    At, Checked, Ids, direction, finite, fraction, increasing, not_negative, number, positive, require,
};
use crate::scene::drive::CONTRACTION;
use crate::scene::{Activation, AfterLast, Drive, DriveKeys, Fibre, Otherwise, SharedDrive, Wave};

/// Checks the drives that a body shares.
pub(super) fn shared(at: &At<'_>, drives: &[SharedDrive]) -> Checked {
    let mut ids = Ids::of("drive");
    for (index, one) in drives.iter().enumerate() {
        let at = at.field("drives");
        let at = at.item(index);
        ids.add(&at.field("id"), &one.id)?;
        own(&at.field("drive"), &one.drive)?;
    }
    Ok(())
}

/// Checks a drive beside those that a body shares.
pub(super) fn drive(at: &At<'_>, drive: &Drive, shared: &[SharedDrive]) -> Checked {
    match drive {
        Drive::Constant(value) => finite(&at.field("constant"), *value, ""),
        Drive::Keyframes(keys) => keyframes(&at.field("keyframes"), keys),
        Drive::Wave(one) => wave(&at.field("wave"), one),
        Drive::Shared(id) => {
            let at = at.field("shared");
            let known = shared.iter().any(|one| one.id == *id);
            require(&at, id, known, "is no drive of this body", || {
                if shared.is_empty() {
                    return "add it to the body's `drives` first".to_owned();
                }
                let names: Vec<String> = shared.iter().map(|one| brief(&one.id)).collect();
                format!("use one of {}", names.join(", "))
            })
        }
    }
}

fn keyframes(at: &At<'_>, DriveKeys { keys, after, otherwise, .. }: &DriveKeys) -> Checked {
    let list = at.field("keys");
    increasing(&list, keys.iter().map(|key| key.time))?;
    for (index, key) in keys.iter().enumerate() {
        let at = list.item(index);
        finite(&at.field("value"), key.value, "")?;
        finite(&at.field("slope"), key.slope, "1/s")?;
    }
    let comes_again = *after == AfterLast::Hold || keys.len() > 1;
    require(&at.field("after"), after, comes_again, "has one key only to come again to", || "give two keys or more")?;
    let Some(Otherwise { drive, back_in, .. }) = otherwise else { return Ok(()) };
    let stays = *after == AfterLast::Hold || back_in.is_none();
    let problem = "comes again, and goes back to what it is otherwise";
    require(&at.field("after"), after, stays, problem, || "leave it or `back_in` out")?;
    let at = at.field("otherwise");
    if let Some(seconds) = back_in {
        positive(&at.field("back_in"), *seconds, "s")?;
    }
    own(&at.field("drive"), drive)
}

/// Checks a drive that cannot name one that a body shares.
fn own(at: &At<'_>, of: &Drive) -> Checked {
    let own = !matches!(of, Drive::Shared(_));
    require(at, of, own, "only names another drive", || "give it a constant, keyframes or a wave")?;
    drive(at, of, &[])
}

fn wave(at: &At<'_>, Wave { mean, amplitude, period, phase_degrees, wavelength, start, .. }: &Wave) -> Checked {
    finite(&at.field("mean"), *mean, "")?;
    finite(&at.field("amplitude"), *amplitude, "")?;
    positive(&at.field("period"), *period, "s")?;
    finite(&at.field("phase_degrees"), *phase_degrees, "degrees")?;
    if let Some(wavelength) = wavelength {
        let at = at.field("wavelength");
        finite(&at, *wavelength, "m")?;
        require(
            &at,
            wavelength,
            wavelength.abs() >= 1e-9,
            "is no length of a wave",
            || "give a number of metres other than 0, below 0 for a wave that runs the other way",
        )?;
    }
    not_negative(&at.field("start"), *start, "s")
}

/// Checks a drive of what is no fibre, along which nothing runs.
pub(super) fn still(at: &At<'_>, of: &Drive, shared: &[SharedDrive]) -> Checked {
    drive(at, of, shared)?;
    let wavelength = of.resolved(shared).and_then(Drive::wave).and_then(|wave| wave.wavelength);
    let problem = "runs along fibres, and this is none";
    require(at, of, wavelength.is_none(), problem, || "leave its wavelength out, or give a drive of its own")
}

/// Checks a drive of what is no body's.
pub(super) fn of_scene(at: &At<'_>, of: &Drive) -> Checked {
    let own = !matches!(of, Drive::Shared(_));
    let problem = "names a drive that bodies share, and this is no part of a body";
    require(at, of, own, problem, || "give it a constant, keyframes or a wave")?;
    still(at, of, &[])
}

/// Checks a drive that must not fall below zero.
pub(super) fn not_below_zero(at: &At<'_>, of: &Drive, shared: &[SharedDrive]) -> Checked {
    still(at, of, shared)?;
    let [least, _] = of.resolved(shared).and_then(Drive::range).unwrap_or([0.0; 2]);
    let problem = format!("falls to {}", number(least));
    require(at, of, least >= 0.0, &problem, || "keep it from 0 on")
}

/// Checks how a fibre acts.
pub(super) fn activation(at: &At<'_>, (of, fibre): (&Activation, &Fibre), shared: &[SharedDrive]) -> Checked {
    drive(&at.field("drive"), &of.drive, shared)?;
    contraction(&at.field("contract"), of, shared)?;
    if let Some(at_one) = of.volume_fraction {
        thickening(&at.field("volume_fraction"), (at_one, fibre.volume_fraction), of, shared)?;
    }
    if let Some(curl) = &of.curl {
        let at = at.field("curl");
        finite(&at.field("degrees_per_metre"), curl.degrees_per_metre, "degrees/m")?;
        direction(&at.field("axis"), &curl.axis)?;
    }
    if let Some(muscle) = &of.muscle {
        let place = at.field("muscle");
        not_negative(&place.field("force"), muscle.force, "N")?;
        positive(&place.field("width"), muscle.width, "")?;
        fraction(&place.field("width"), muscle.width)?;
        excitation(&at.field("drive"), &of.drive, shared)?;
    }
    let Some(twist) = &of.twist else { return Ok(()) };
    let at = at.field("twist");
    let rate = at.field("degrees_per_metre");
    finite(&rate, twist.degrees_per_metre, "degrees/m")?;
    let resists = fibre.stiffness.twisting() > 0.0;
    require(
        &at,
        twist,
        resists,
        "needs a fibre that resists twist",
        || "give the fibre a `gj` above 0 in its `stiffness/rigidity`",
    )
}

/// Checks a drive that excites a muscle.
pub(super) fn excitation(at: &At<'_>, of: &Drive, shared: &[SharedDrive]) -> Checked {
    let [least, greatest] = of.resolved(shared).and_then(Drive::range).unwrap_or([0.0; 2]);
    let problem = format!("excites a muscle from {} to {}", number(least), number(greatest));
    require(at, of, least >= 0.0 && greatest <= 1.0, &problem, || "keep it from 0 to 1")
}

/// Checks that a fibre has a volume fraction from 0 to 1 whatever its drive is.
fn thickening(at: &At<'_>, (at_one, own): (f64, f64), of: &Activation, shared: &[SharedDrive]) -> Checked {
    fraction(at, at_one)?;
    let range = of.drive.resolved(shared).and_then(Drive::range).unwrap_or([0.0; 2]);
    let [least, greatest] = of.thickening_limits(own);
    let reached = range.map(|value| own + (at_one - own) * value);
    let (low, high) = (reached[0].min(reached[1]), reached[0].max(reached[1]));
    let problem = format!("takes a fibre of {} from {} to {}", number(own), number(low), number(high));
    let within = least <= range[0] && range[1] <= greatest;
    require(at, &at_one, within, &problem, || "keep its drive from 0 to 1, or where it stays from 0 to 1")
}

fn contraction(at: &At<'_>, of: &Activation, shared: &[SharedDrive]) -> Checked {
    let range = of.drive.resolved(shared).and_then(Drive::range).unwrap_or([0.0; 2]);
    share(at, of.contract, "fibre shorter by {} of its length", range)
}

/// Checks a share by which something wants to be smaller, times a drive of this range; `what` it makes of what, with
/// `{}` for the share.
pub(super) fn share(at: &At<'_>, contract: f64, what: &str, range: [f64; 2]) -> Checked {
    finite(at, contract, "")?;
    let [low, high] = CONTRACTION;
    for value in range {
        let share = contract * value;
        let holds = (low..=high).contains(&share);
        let made = what.replace("{}", &number(share));
        let problem = format!("makes the {made}, where its drive is {}", number(value));
        require(at, &contract, holds, &problem, || {
            format!("keep contraction times drive from {} to {}", number(low), number(high))
        })?;
    }
    Ok(())
}
