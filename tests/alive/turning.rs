//! How far fibres that curl and twist turn what they lie in, and under which steps.

use crate::common::*;
use crate::fibres::{F, all_at_once, center, rod, section_of, sections, settled, upright};
use glam::DVec3;
use sinew::scene::{
    Activation, Axis, Distance, DriveKeys, MeasureKind, Motion, Region, RestShape, Rigidity, Side, Turn,
};
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
    // In the middle, and from one end to the other.
    for (n, layers, inner, ends) in [(5, 15, 0.99, 0.82), (4, 13, 0.99, 0.828)] {
        let mut bar = rod([n, layers, n]);
        let wanted = 600.0_f64;
        let drive = DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]);
        let mut fibre = upright(layers, 0.0, 0.0, Activation::curling(wanted, [0.0, 0.0, 1.0], drive));
        fibre.stiffness = rigidity(0.0, 40.0 * F * D * D);
        bar.fibres.push(fibre);
        let (baked, runner) = settled(bar);
        let [_, inertia, _] = section_of(&baked);
        // Right-handed about the axis, along the fibre.
        let last = layers as usize - 1;
        let [found, whole] = [[last / 2 - 4, last / 2 + 4], [0, last]].map(|[from, to]| {
            turned_between(&runner.world().bodies()[0], [from, to], DVec3::Z) / ((to - from) as f64 * D)
        });
        let expected = wanted.to_radians() * 10.0 / (inertia + 10.0);
        println!("{n} x {n}: curl {:.4}, end to end {:.3}", found / expected, whole / expected);
        assert!((found / expected - inner).abs() < 0.004, "{n}: {found} of {expected}");
        assert!((whole / expected - ends).abs() < 0.01, "{n}: {whole} of {expected}");
    }
}

#[test]
fn a_twisting_fibre_twists_a_rod_by_its_share_of_the_stiffness() {
    for (n, gj, inner, ends) in [(4, 10.0, 1.0008, 0.943), (5, 25.0, 0.9936, 0.889)] {
        let by = |wanted: f64| {
            let mut bar = rod([n, 15, n]);
            let drive = DriveKeys::new([(0.0, 0.0), (0.02, 1.0)]);
            let mut fibre = upright(15, 0.0, 0.0, Activation::twisting(wanted, drive));
            fibre.stiffness = Rigidity::new(0.0, 0.0).with_twisting(4.0 * gj * F * D * D).into();
            bar.fibres.push(fibre);
            let (_, runner) = settled(bar);
            [[5, 9], [0, 14]].map(|[from, to]| {
                let found = turned_between(&runner.world().bodies()[0], [from, to], DVec3::Y);
                found / ((to - from) as f64 * D) / wanted.to_radians()
            })
        };
        // Right-handed along the fibre; the middle of the rod twists by the fibre's share of `mu J + l_f GJ`.
        let [middle, whole] = by(800.0);
        let matrix = 0.140_577 * f64::from(n).powi(4) / (2.0 * 1.33);
        let expected = gj / (matrix + gj);
        println!("{n} x {n}: twist {:.4}, end to end {:.3}", middle / expected, whole / expected);
        assert!((middle / expected - inner).abs() < 2e-3, "{n}: {middle} of {expected}");
        assert!((whole / expected - ends).abs() < 0.01, "{n}: {whole} of {expected}");
        // An eighth of it, and it is hardly another share: what is left is that of large turns.
        let [less, _] = by(100.0);
        println!("linear to {:.1e}", middle / less - 1.0);
        assert!((middle / less - 1.0).abs() < 3e-4, "{middle} and {less}");
    }
}

/// Of what a rod resists.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Load {
    Pull,
    Bend,
    Twist,
}

/// What a rod with a straight fibre along its axis resists [E D² and E D⁴] well within it.
fn resistance(n: u32, load: Load, apart: f64, stiffness: [f64; 3]) -> f64 {
    let layers = 21_u32;
    let mut bar = rod([n, layers, n]);
    let vertices = (0..=(20.0 / apart) as u32).map(|k| [0.0, D * (0.5 + apart * f64::from(k)), 0.0]).collect();
    let mut fibre = fibre("strand", vertices, rigidity(0.0, 0.0), 0.25, RestShape::Straight);
    let [ea, ei, gj] = stiffness.map(|of| 4.0 * of * F);
    fibre.stiffness = Rigidity::new(ea, ei * D * D).with_twisting(gj * D * D).into();
    bar.fibres.push(fibre);
    bar.regions = vec![layers_of("foot", Side::Min), layers_of("head", Side::Max)];
    let middle = [0.0, 0.5 * f64::from(layers) * D, 0.0];
    let turn = |axis: [f64; 3]| Motion::Turn(Turn::new(axis, 1.0, 0.05).with_origin(middle));
    let (axes, motion): (&[Axis], _) = match load {
        Load::Pull => (&[Axis::Y], ramp([0.0, 1.0, 0.0], Distance::Fraction(0.01), 0.05)),
        Load::Bend => (&ALL, turn([0.0, 0.0, 1.0])),
        Load::Twist => (&ALL, turn([0.0, 1.0, 0.0])),
    };
    bar.pins = vec![pin("foot", axes, Motion::Fixed), pin("head", axes, motion)];
    bar.material.damping.air = 200.0;
    let mut scene = in_space(bar);
    scene.time.frames_per_second = 100.0;
    let (along, about) = ([0.0, -1.0, 0.0], [0.0, 0.0, -1.0]);
    scene.measures = vec![match load {
        Load::Pull => measure("force", MeasureKind::reaction_force("head", along)),
        Load::Bend => measure("moment", MeasureKind::reaction_torque("head", about)),
        Load::Twist => measure("moment", MeasureKind::reaction_torque("head", along)),
    }];
    let mut runner = runner(&scene);
    (0..25).for_each(|_| runner.advance_frame());
    let body = &runner.world().bodies()[0];
    let all = sections(body);
    let (from, to) = (8, 12);
    let apart = |x: &[DVec3]| center(&all[to], x).distance(center(&all[from], x));
    let deformed = match load {
        Load::Pull => apart(&body.state().positions) - apart(&body.parts().rest),
        Load::Bend => turned_between(body, [from, to], DVec3::Z),
        Load::Twist => turned_between(body, [from, to], DVec3::Y),
    };
    let unit = if load == Load::Pull { F } else { F * D * D };
    scalar(&runner, 0) * (to - from) as f64 * D / deformed / unit
}

fn layers_of(id: &str, side: Side) -> Region {
    layers(id, Axis::Y, side, 1)
}

/// In the middle of a rod of 21 layers, which its ends do not reach; in one of 13 it is up to 4 % less.
#[test]
fn a_passive_fibre_adds_its_own_stiffness() {
    for n in [4, 5] {
        let bare = [Load::Twist, Load::Pull, Load::Bend].map(|load| resistance(n, load, 1.0, [1e-9, 0.0, 0.0]));
        for (load, apart, own, bare, within) in [
            (Load::Twist, 1.0, [1e-9, 0.0, 5.0], bare[0], 1e-3),
            (Load::Pull, 1.0, [5.0, 0.0, 0.0], bare[1], 1e-3),
            (Load::Bend, 1.0, [1e-9, 10.0, 0.0], bare[2], 5e-3),
            // Vertices twice as dense do it alike.
            (Load::Bend, 0.5, [1e-9, 10.0, 0.0], bare[2], 0.02),
        ] {
            let with = resistance(n, load, apart, own);
            let added = (with - bare) / own.into_iter().fold(0.0, f64::max);
            println!("{n} x {n}, {apart}: {load:?} {added:.4} of {with:.3}, bare {bare:.3}");
            assert!((added - 1.0).abs() < within, "{n} x {n}, {apart} D apart, {load:?}: {added}");
        }
    }
}

#[test]
fn what_turns_takes_shorter_steps_the_more_it_turns() {
    let step = |[ei, gj]: [f64; 2], activation: Option<Activation>| {
        let mut bar = rod([3, 13, 3]);
        let mut fibre = upright(13, 0.0, 0.0, Activation::contracting(0.0, 0.0));
        fibre.stiffness = Rigidity::new(1e-6, 4.0 * ei * F * D * D).with_twisting(4.0 * gj * F * D * D).into();
        fibre.activation = activation;
        bar.fibres.push(fibre);
        baked(&in_space(bar)).world.bodies()[0].parts().stable_dt
    };
    let matrix = step([1e-6, 0.0], None);
    // Up to a bend `2 tan(kappa L0 / 4)` of 1 at every vertex, where L0 is 2 D.
    let rate = (4.0 * 0.5_f64.atan() / (2.0 * D)).to_degrees();
    let passive = matrix / step([50.0, 0.0], None);
    let curled = matrix / step([50.0, 0.0], Some(Activation::curling(rate, [0.0, 0.0, 1.0], 1.0)));
    println!("EI: {passive:.3} as long, curled {curled:.3}");
    assert!((passive - 1.83).abs() < 0.02 && (curled / passive - 1.16).abs() < 0.01, "{passive}, {curled}");
    // Both extremes count: one that only sometimes curls takes the step of the other.
    let never = matrix / step([50.0, 0.0], Some(Activation::curling(rate, [0.0, 0.0, 1.0], 0.0)));
    assert!((never / passive - 1.0).abs() < 1e-3, "{never}");
    // Half a radian from vertex to vertex.
    let twisted = |rate: f64| step([0.0, 500.0], Some(Activation::twisting(rate, 1.0)));
    let longer = twisted(1e-3) / twisted((0.5 / D).to_degrees());
    println!("GJ: {longer:.4} as long");
    assert!((1.005..1.02).contains(&longer), "{longer}");
}

#[test]
fn what_acts_by_itself_goes_nowhere_and_turns_nowhere() {
    let mut body = all_at_once();
    body.fibres[0].rest_shape = RestShape::AsDrawn;
    let mut runner = runner(&in_space(body));
    let (mut most, mut handled) = ([0.0_f64; 2], [0.0_f64; 2]);
    for _ in 0..12 {
        runner.advance_frame();
        let state = runner.world().bodies()[0].state();
        let momenta = [state.linear_momentum(), state.angular_momentum()].map(DVec3::length);
        let of = |arm: &dyn Fn(DVec3) -> f64| {
            let particles = state.positions.iter().zip(&state.velocities).zip(&state.masses);
            particles.map(|((x, v), m)| arm(*x) * m * v.length()).sum::<f64>()
        };
        let sizes = [of(&|_| 1.0), of(&DVec3::length)];
        for k in 0..2 {
            (most[k], handled[k]) = (most[k].max(momenta[k]), handled[k].max(sizes[k]));
        }
    }
    println!("{:.1e} of momentum, {:.1e} of angular momentum", most[0] / handled[0], most[1] / handled[1]);
    assert!(
        handled[0] > 0.0 && most[0] < 1e-12 * handled[0] && most[1] < 1e-12 * handled[1],
        "{most:?} of {handled:?}"
    );
}
