//! How many particles a solid takes so that its thin parts have two layers of them.

use super::fill::{FillError, try_filling};
use super::progress::Progress;
use super::solid::Solid;
use glam::DVec3;
use std::fmt;
use std::ops::ControlFlow;

/// How finely a solid is filled that nobody has said anything about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fineness {
    /// Number of particles.
    pub particles: u32,
    /// What is thinner than two layers of them, where the greatest number is not enough.
    pub given_up: Option<ThinParts>,
    /// Whether they are more than the greatest number, as fewer do not hold it together.
    pub is_forced: bool,
}

impl Fineness {
    /// What a person should know of it; none where every part has its layers.
    pub(crate) fn said(&self) -> Option<String> {
        let forced = "fewer would not hold it together, and so many do not run in real time";
        let many = "fewer would give most of it less than two layers, and so many do not run in real time";
        match self.given_up {
            _ if self.is_forced => Some(forced.to_owned()),
            None => (self.particles > BY_ITSELF[1]).then(|| many.to_owned()),
            Some(thin) if self.particles > BY_ITSELF[1] => Some(format!("{thin}; so many do not run in real time")),
            Some(thin) => Some(thin.to_string()),
        }
    }
}

/// Parts that have fewer than two layers of particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ThinParts {
    /// Share of the volume that they make up.
    pub share: f64,
    /// The thinnest place that was found [m].
    pub at: DVec3,
    /// Thickness there is no less than, but for rims and tips [m].
    pub thickness: f64,
    /// Particles with which they would have two layers.
    pub wanted: f64,
}

/// Numbers of particles with which a model opens that nobody has said anything about. The first does for most shapes;
/// up to the second, for thin parts, it runs in real time on one core; up to the last where much of it would be lost.
const BY_ITSELF: [u32; 3] = [800, 3000, 50_000];

/// Share of the matter that may be thinner than two layers without a word: rims and tips.
const RIMS: f64 = 0.01;

/// Layers that a thin part is to have.
const LAYERS: f64 = 2.0;

/// Share of the matter that has to be thinner than two layers for more than the usual particles to be taken.
const MUCH: f64 = 0.6;

/// Particles up to which a model is opened that falls apart in fewer, and how many it may have in all.
const MOST_FORCED: u32 = 1_000_000;
const MOST: usize = 2_000_000;

/// How finely a solid is filled that nobody has said anything about; `reach` is the support radius over the spacing.
pub(crate) fn by_itself(solid: &Solid, reach: f64) -> Fineness {
    match by_itself_unless(solid, reach, &mut |_, _| ControlFlow::Continue(())) {
        ControlFlow::Continue(found) => found,
        ControlFlow::Break(()) => unreachable!("nothing stops it"),
    }
}

/// [`by_itself`]; `progress` breaks off what is no longer wanted.
pub(crate) fn by_itself_unless(solid: &Solid, reach: f64, progress: &mut Progress<'_>) -> ControlFlow<(), Fineness> {
    progress(0, 1)?;
    let found = fineness(solid, BY_ITSELF);
    if found.given_up.is_none() {
        return ControlFlow::Continue(found);
    }
    match try_filling(solid, (found.particles, reach, MOST), progress) {
        Err(FillError::Cancelled) => ControlFlow::Break(()),
        Err(FillError::TooThin { suggested: Some(spacing), .. }) if solid.particles_at(spacing) <= MOST_FORCED => {
            ControlFlow::Continue(Fineness { particles: solid.particles_at(spacing), is_forced: true, ..found })
        }
        _ => ControlFlow::Continue(found),
    }
}

/// As few particles as give every part of a solid two layers: from `least` to `usual`, and up to `most` of them where
/// much of it would be lost otherwise.
fn fineness(solid: &Solid, [least, usual, most]: [u32; 3]) -> Fineness {
    let found = solid.thickness();
    let Some(thickness) = found.of_all_but(RIMS) else {
        return Fineness { particles: least, given_up: None, is_forced: false };
    };
    let wanted = (solid.volume / (thickness / LAYERS).powi(3)).ceil();
    let up_to = |most: u32| {
        // More than any integer holds is more than is allowed.
        let particles = (wanted.min(f64::from(most)) as u32).max(least);
        let spacing = (solid.volume / f64::from(particles)).cbrt();
        let thin = found.thinner_than(LAYERS * spacing).filter(|_| wanted > f64::from(most));
        let given_up = thin.map(|(share, at)| ThinParts { share, at, thickness, wanted });
        Fineness { particles, given_up, is_forced: false }
    };
    let usually = up_to(usual);
    if usually.given_up.is_some_and(|thin| thin.share > MUCH) { up_to(most) } else { usually }
}

impl fmt::Display for ThinParts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{:.0} % of it is thinner than two layers of them, the thinnest around {:.4?} m, and bends too easily: {:.1e} \
             particles would give it two",
            100.0 * self.share,
            self.at.to_array(),
            self.wanted
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::fill::{FillResolution, fill};
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use crate::geometry::model::{MeshData, Model};

    fn plate(thickness: f64) -> Solid {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::new(0.1, thickness, 0.07) }, 0.01);
        let mut model = Model::default();
        model.add(MeshData { positions: mesh.positions, triangles: mesh.triangles, ..MeshData::default() });
        Solid::new(&model).expect("an inside")
    }

    #[test]
    fn a_thin_plate_gets_two_layers_or_it_is_said() {
        // Two layers of 0.1 m by 0.07 m at 2.5 mm.
        let found = fineness(&plate(0.005), [800, 3000, 10_000]);
        assert!((2240..=2260).contains(&found.particles) && found.given_up.is_none(), "{found:?}");
        let filling = fill(&plate(0.005), FillResolution::Particles(found.particles), 2.5, 100_000).expect("a filling");
        assert_eq!(filling.thinness.single, 0);
        // A thick one takes no more than it has to.
        assert_eq!(
            fineness(&plate(0.04), [800, 3000, 10_000]),
            Fineness { particles: 800, given_up: None, is_forced: false }
        );
        // Where all of it is thin more are taken, and then no more.
        let found = fineness(&plate(0.002), [800, 3000, 50_000]);
        assert!((13_990..=14_010).contains(&found.particles) && found.given_up.is_none(), "{found:?}");
        assert!(found.said().is_some_and(|text| text.contains("do not run in real time")), "{found:?}");
        assert_eq!(fineness(&plate(0.005), [800, 3000, 10_000]).said(), None);
        let given_up = fineness(&plate(0.002), [800, 3000, 10_000]).given_up.expect("too thin");
        assert!(given_up.share > 0.97 && (given_up.thickness - 0.002).abs() < 1e-6, "{given_up:?}");
        assert!((given_up.wanted / 14_000.0 - 1.0).abs() < 0.01, "{given_up:?}");
    }

    #[test]
    fn what_is_filled_to_look_at_it_is_not_filled_twice() {
        let solid = plate(0.000_8);
        let found = by_itself(&solid, 2.5);
        assert!(found.given_up.is_some() && !found.is_forced, "{found:?}");
        let known = solid.known_filling.get().expect("it was filled").filling.clone();
        let asked =
            |particles, reach| fill(&solid, FillResolution::Particles(particles), reach, MOST).expect("a filling");
        assert_eq!(asked(found.particles, 2.5), known);
        // It is what filling it anew gives, and what is asked for otherwise is filled otherwise.
        let anew = fill(&plate(0.000_8), FillResolution::Particles(found.particles), 2.5, MOST).expect("a filling");
        assert_eq!(anew, known);
        let more = asked(2 * found.particles, 2.5).sample.points.len();
        assert!(more > 3 * known.sample.points.len() / 2, "{more}");
    }

    #[test]
    fn what_falls_apart_in_the_most_gets_as_many_as_hold_it_together() {
        // One layer of 50,000 particles is 0.5 mm thick.
        let found = by_itself(&plate(0.000_58), 2.5);
        assert!(found.is_forced && (100_000..MOST_FORCED).contains(&found.particles), "{found:?}");
        let filling = fill(&plate(0.000_58), FillResolution::Particles(found.particles), 2.5, MOST).expect("a filling");
        assert_eq!(filling.thinness.single, 0);
        assert!(filling.volume_error.abs() < 0.02, "{}", filling.volume_error);
        // A thick one is left as it is.
        assert!(by_itself(&plate(0.04), 2.5) == fineness(&plate(0.04), BY_ITSELF));
    }
}
