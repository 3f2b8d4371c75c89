//! Fibres of a layout that act: what a pattern says of them as activations and the drives that they follow.

use super::layout::is_laid;
use crate::geometry::curve::arc_length;
use crate::scene::{Activation, Drive, Fibre, FibreSource, SharedDrive, Wave};
use crate::sketch::pattern::Act;
use glam::DVec3;

/// Has fibres that were [laid](super::laid) along `lines` do the acts of these, those of one muscle by one shared
/// drive, and gives the drives that the body needs for it beside those that are `there`. A drive is called by `id` and
/// the muscle; one that is there already and is the same is followed.
pub fn made_to_act(
    fibres: &mut [Fibre],
    (lines, acts): (&[Vec<DVec3>], &[Option<Act>]),
    id: &str,
    there: &[SharedDrive],
) -> Vec<SharedDrive> {
    // Lines along which nothing was laid have no part in it.
    let acts = lines.iter().zip(acts).filter(|(line, _)| is_laid(line)).map(|(_, act)| act);
    let mut added: Vec<SharedDrive> = Vec::new();
    let mut muscles: Vec<(&str, String)> = Vec::new();
    for (fibre, act) in fibres.iter_mut().zip(acts) {
        let Some(act) = act else { continue };
        let known = muscles.iter().find(|(muscle, _)| *muscle == act.muscle).map(|(_, drive)| drive.clone());
        let drive = known.unwrap_or_else(|| {
            let drive = Drive::Wave(wave(act, length(fibre)));
            let wanted = format!("{id}-{}", act.muscle);
            let names = (1..).map(|n| if n == 1 { wanted.clone() } else { format!("{wanted}-{n}") });
            let taken = |name: &String| there.iter().chain(&added).find(|one| one.id == *name).map(|one| &one.drive);
            let free = names.into_iter().find(|name| taken(name).is_none_or(|other| *other == drive));
            let name = free.unwrap_or(wanted);
            if taken(&name).is_none() {
                added.push(SharedDrive::new(name.clone(), drive));
            }
            muscles.push((&act.muscle, name.clone()));
            name
        });
        fibre.activation = Some(Activation::contracting(act.contract, Drive::Shared(drive)));
    }
    added
}

/// What a fibre of this length [m] in a body with these shared drives does by itself, as far as a pattern can say it: a
/// contraction that swings between nothing and all of it. None where it only resists, or acts otherwise.
pub fn act_of(fibre: &Fibre, length: f64, drives: &[SharedDrive]) -> Option<Act> {
    let activation = fibre.activation.as_ref()?;
    let Some(Drive::Wave(wave)) = activation.drive.resolved(drives) else { return None };
    let swings_from_nothing = wave.mean == wave.amplitude && wave.start == 0.0;
    let only_contracts = activation.curl.is_none()
        && activation.muscle.is_none()
        && activation.twist.is_none()
        && activation.volume_fraction.is_none();
    let muscle = match &activation.drive {
        Drive::Shared(id) => id.clone(),
        _ => fibre.id.clone(),
    };
    (swings_from_nothing && only_contracts).then(|| Act {
        muscle,
        contract: 2.0 * wave.amplitude * activation.contract,
        period: wave.period,
        phase_degrees: wave.phase_degrees,
        waves: wave.wavelength.map_or(0.0, |wavelength| length / wavelength),
    })
}

fn wave(act: &Act, length: f64) -> Wave {
    let all_at_once = Wave::new(act.period).with_phase(act.phase_degrees);
    if act.waves == 0.0 { all_at_once } else { all_at_once.with_wavelength(length / act.waves) }
}

/// Length of a fibre that is given by its vertices [m].
fn length(fibre: &Fibre) -> f64 {
    let FibreSource::Vertices(vertices) = &fibre.source else { return 0.0 };
    arc_length(&vertices.iter().copied().map(DVec3::from_array).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::super::{BENDING, Called, laid};
    use super::*;
    use crate::scene::Material;

    fn act(muscle: &str, phase_degrees: f64) -> Act {
        Act { muscle: muscle.to_owned(), contract: 0.3, period: 2.0, phase_degrees, waves: 1.0 }
    }

    #[test]
    fn each_fibre_has_its_own_act_where_some_lines_are_left_out() {
        let line = |x: f64| vec![DVec3::new(x, 0.0, 0.0), DVec3::new(x, 0.05, 0.0)];
        let lines = [line(0.0), vec![DVec3::X; 3], line(0.01), line(0.02)];
        let acts = [Some(act("below", 0.0)), Some(act("none", 10.0)), None, Some(act("above", 180.0))];
        let called = Called { id: "worm", title: "Worm", bending: BENDING, spacing: 0.006 };
        let mut fibres = laid(called, &lines, &Material::default(), &[]);
        let drives = made_to_act(&mut fibres, (&lines, &acts), "worm", &[]);
        let followed = |fibre: &Fibre| match &fibre.activation {
            Some(Activation { drive: Drive::Shared(id), .. }) => id.clone(),
            _ => String::new(),
        };
        assert_eq!(fibres.iter().map(followed).collect::<Vec<_>>(), ["worm-below", "", "worm-above"]);
        assert_eq!(drives.iter().map(|drive| drive.id.as_str()).collect::<Vec<_>>(), ["worm-below", "worm-above"]);
        // The same is followed where it is, another has another name.
        let mut again = laid(called, &lines, &Material::default(), &fibres);
        assert!(made_to_act(&mut again, (&lines, &acts), "worm", &drives).is_empty());
        let slower = [Some(act("below", 90.0))];
        let more = made_to_act(&mut again[..1], (&lines[..1], &slower), "worm", &drives);
        assert_eq!((more.len(), more[0].id.as_str()), (1, "worm-below-2"));
        // And it is told again what they do.
        let length = arc_length(&lines[3]);
        let found = act_of(&fibres[2], length, &drives).expect("it acts");
        assert!((found.waves - 1.0).abs() < 1e-12 && found.phase_degrees == 180.0 && found.muscle == "worm-above");
    }
}
