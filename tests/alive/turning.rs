//! How far fibres that curl and twist turn what they lie in, and under which steps.

use crate::common::*;
use crate::fibres::{F, center, rod, section_of, sections, settled, upright};
use glam::DVec3;
use sinew::scene::{Activation, DriveKeys, RestShape, Rigidity};
use sinew::solver::Body as Simulated;

#[test]
fn twisting_stiffness_takes_shorter_steps_as_measured() {
    let step = |gj: f64| {
        let mut bar = rod([3, 13, 3]);
        let vertices = (0..=24).map(|k| [0.0, D * (0.5 + 0.5 * f64::from(k)), 0.0]).collect();
        let mut fibre = fibre("muscle", vertices, rigidity(0.0, 0.0), 0.25, RestShape::Straight);
        fibre.stiffness = Rigidity::new(0.0, 0.0).with_twisting(4.0 * gj * F * D * D).into();
        bar.fibres.push(fibre);
        baked(&in_space(bar)).world.bodies()[0].parts().stable_dt
    };
    // With twice or half as many vertices it is a tenth more or less.
    let matrix = step(1e-6);
    for (gj, slower) in [(5.0, 1.0), (50.0, 1.14), (500.0, 3.1)] {
        let found = matrix / step(gj);
        println!("{gj}: {found:.3}");
        assert!((found / slower - 1.0).abs() < 0.12, "{gj}: {found}, not {slower}");
    }
}

/// Turn [rad] of one layer across Y against another about an axis.
fn turned_between(body: &Simulated, [from, to]: [usize; 2], axis: DVec3) -> f64 {
    let all = sections(body);
    let turn = |k: usize| {
        let (rest, now) = (&body.parts().rest, &body.state().positions);
        let (before, after) = (center(&all[k], rest), center(&all[k], now));
        let (mut sine, mut cosine) = (0.0, 0.0);
        for &i in &all[k] {
            let (a, b) = (rest[i] - before, now[i] - after);
            sine += a.cross(b).dot(axis);
            cosine += a.dot(b) - a.dot(axis) * b.dot(axis);
        }
        sine.atan2(cosine)
    };
    turn(to) - turn(from)
}

#[test]
fn a_curling_fibre_bends_a_rod_by_its_share_of_the_stiffness() {
    let mut bar = rod([5, 15, 5]);
    let wanted = 600.0_f64;
    let drive = DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]);
    let mut fibre = upright(15, 0.0, 0.0, Activation::curling(wanted, [0.0, 0.0, 1.0], drive));
    fibre.stiffness = rigidity(0.0, 40.0 * F * D * D);
    bar.fibres.push(fibre);
    let (baked, runner) = settled(bar);
    let [_, inertia, _] = section_of(&baked);
    // Right-handed about the axis, along the fibre.
    let found = turned_between(&runner.world().bodies()[0], [3, 11], DVec3::Z) / (8.0 * D);
    let expected = wanted.to_radians() * 10.0 / (inertia + 10.0);
    println!("curl {:.4}", found / expected);
    assert!((found / expected - 0.986).abs() < 0.02, "{found} of {expected}");
}

#[test]
fn a_twisting_fibre_twists_a_rod_by_its_share_of_the_stiffness() {
    let mut bar = rod([5, 15, 5]);
    let wanted = 800.0_f64;
    let drive = DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]);
    let mut fibre = upright(15, 0.0, 0.0, Activation::twisting(wanted, drive));
    fibre.stiffness = Rigidity::new(0.0, 0.0).with_twisting(100.0 * F * D * D).into();
    bar.fibres.push(fibre);
    let (_, runner) = settled(bar);
    // Right-handed along the fibre; the middle of the rod twists by the fibre's share of `mu J + l_f GJ`.
    let found = turned_between(&runner.world().bodies()[0], [5, 9], DVec3::Y) / (4.0 * D);
    let matrix = 0.140_577 * 625.0 / (2.0 * 1.33);
    let expected = wanted.to_radians() * 25.0 / (matrix + 25.0);
    println!("twist {:.4}", found / expected);
    assert!((found / expected - 1.0).abs() < 0.02, "{found} of {expected}");
}
