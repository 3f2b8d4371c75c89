//! Fibres that get thicker and thinner: what they and the matrix around do then.

use crate::common::*;
use crate::fibres::{E, F, rod, upright};
use glam::DVec3;
use sinew::scene::{
    Activation, Axis, Body, Curl, Dab, Drive, DriveKeys, Extra, Fibre, Material, Motion, Plasticity, RestShape,
    Rigidity, SharedDrive, Side, Stiffness, TimeStep, TwistRate, Viscosity, Wave,
};
use sinew::solver::{BodyParts, Energies, FieldKind};

/// A bow across the rod of fibres that resist all there is, and a straight one beside it.
fn arched(activation: Option<Activation>, fraction: f64) -> Body {
    let mut body = rod([4, 9, 4]);
    let bow = (0..9).map(|k| {
        let s = f64::from(k) / 8.0;
        [D * (6.0 * s * (1.0 - s) - 0.8), D * (0.5 + 8.0 * s), 0.4 * D]
    });
    let stiffness = Stiffness::from(Rigidity::new(20.0 * F, 3.0 * F * D * D).with_twisting(2.0 * F * D * D));
    let mut arch = fibre("arch", bow.collect(), stiffness, fraction, RestShape::AsDrawn);
    arch.activation = activation;
    // One that is straight and askew, so that its turns are zero only up to round-off.
    let slant = (0..7).map(|k| f64::from(k) - 3.0).map(|s| [0.3 * s * D, (4.5 + s) * D, -0.35 * s * D]);
    let mut rib = fibre("rib", slant.collect(), rigidity(8.0 * F, F * D * D), fraction, RestShape::Straight);
    rib.activation = arch.activation.clone().map(|of| Activation { curl: None, twist: None, ..of });
    let muscle = upright(9, -1.1 * D, 15.0 * F, Activation::contracting(0.2, 0.5));
    body.fibres = vec![arch, rib, muscle];
    body.paint = vec![Dab { strength: 0.5, ..Dab::new([0.5 * D, 4.0 * D, 0.0], 2.5 * D, 0.6) }];
    body
}

/// All that a drive can do to a fibre, and a fraction of 0.8.
fn everything(drive: impl Into<Drive>) -> Activation {
    Activation {
        contract: 0.1,
        curl: Some(Curl { degrees_per_metre: 900.0, axis: [0.0, 0.0, 1.0], extra: Extra::new() }),
        twist: Some(TwistRate { degrees_per_metre: 1200.0, extra: Extra::new() }),
        ..Activation::thickening(0.8, drive)
    }
}

/// Positions after some steps of a fraction of the stable one.
fn moved(body: Body) -> Vec<DVec3> {
    let mut scene = in_space(body);
    scene.time.step = TimeStep::manual(1.5e-4, 40);
    let mut runner = runner(&scene);
    (0..3).for_each(|_| runner.advance_frame());
    runner.world().bodies()[0].state().positions.clone()
}

#[test]
fn a_fibre_of_a_driven_fraction_is_one_of_that_fraction() {
    for (own, drive) in [(0.2, 0.5), (0.0, 1.0), (0.2, 0.0), (0.7, -2.0)] {
        let fraction = own + (0.8 - own) * drive;
        let with_fraction = |at_one: Option<f64>| Activation { volume_fraction: at_one, ..everything(drive) };
        let driven = moved(arched(Some(with_fraction(Some(0.8))), own));
        let drawn = moved(arched(Some(with_fraction(None)), fraction));
        let other = moved(arched(Some(with_fraction(None)), 0.45));
        let off = |a: &[DVec3]| a.iter().zip(&driven).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        println!("{own} {drive}: {:.1e} D, another fraction {:.1e} D", off(&drawn) / D, off(&other) / D);
        assert!(off(&drawn) < 1e-9 * D && off(&other) > 1e-4 * D, "{own} {drive}");
    }
}

#[test]
fn the_fractions_that_are_seen_are_those_of_now() {
    let body = arched(Some(everything(DriveKeys::new([(0.0, 0.0), (0.05, 1.0)]))), 0.2);
    let mut runner = runner(&in_space(body));
    let seen = |runner: &sinew::sim::Runner| runner.world().bodies()[0].field(FieldKind::VolumeFraction);
    let first = seen(&runner);
    (0..6).for_each(|_| runner.advance_frame());
    let drawn = baked(&in_space(arched(None, 0.8)));
    let off = |a: &[f64]| a.iter().zip(&drawn.fractions[0]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off(&seen(&runner)) < 1e-12 && off(&first) > 0.3, "{} {}", off(&seen(&runner)), off(&first));
}

fn energies(parts: &BodyParts, time: f64) -> f64 {
    let mut energies = Energies::default();
    parts.forces.iter().for_each(|force| force.add_energy(time, &parts.state, &mut energies));
    energies.total()
}

#[test]
fn forces_are_the_slopes_of_the_energy_while_fractions_change() {
    let wave = Wave::new(0.4).with_wavelength(7.0 * D);
    let mut parts = baked(&in_space(arched(Some(everything(wave)), 0.1))).world.bodies()[0].parts().clone();
    for (i, x) in parts.state.positions.iter_mut().enumerate() {
        *x += 0.05 * D * wobble(i, 3) + DVec3::new(0.1 * x.y, 0.0, -0.05 * x.x);
    }
    let (time, step) = (0.57, 1e-6 * D);
    let mut forces = vec![DVec3::ZERO; parts.state.positions.len()];
    // Rotations are warm after the first.
    for _ in 0..2 {
        forces.fill(DVec3::ZERO);
        let state = parts.state.clone();
        parts.forces.iter_mut().for_each(|force| force.add_forces(time, &state, &mut forces));
    }
    let largest = forces.iter().map(|force| force.length()).fold(0.0, f64::max);
    for i in [0, 17, 40, 63, 71, 100, 143] {
        for axis in 0..3 {
            let mut at = |by: f64| {
                parts.state.positions[i][axis] += by;
                let energy = energies(&parts, time);
                parts.state.positions[i][axis] -= by;
                energy
            };
            let slope = (at(step) - at(-step)) / (2.0 * step);
            assert!((slope + forces[i][axis]).abs() < 2e-6 * largest, "{i} {axis}: {slope}, {}", forces[i][axis]);
        }
    }
    let sum: DVec3 = forces.iter().sum();
    let moment: DVec3 = parts.state.positions.iter().zip(&forces).map(|(x, force)| x.cross(*force)).sum();
    assert!(sum.length() < 1e-11 * largest && moment.length() < 1e-12 * largest, "{sum} {moment} of {largest}");
}

#[test]
fn the_work_of_thickening_closes_the_balance_to_second_order() {
    let period = 30.0 * D / (E / 1852.0_f64).sqrt();
    let mut body = arched(Some(everything(Wave::new(period).with_wavelength(20.0 * D))), 0.1);
    // Something to thicken against.
    body.initial.deformation = [[0.98, 0.05, 0.0], [0.0, 1.06, 0.02], [0.0, 0.0, 0.99]];
    let mut scene = in_space(body);
    let stable = baked(&scene).world.bodies()[0].parts().stable_dt;
    let mut off = |halvings: i32| {
        scene.time.step = TimeStep::manual(0.6 * stable * 0.5_f64.powi(halvings), 10 << halvings);
        let mut runner = runner(&scene);
        let start = runner.world().bodies()[0].energies(0.0).total();
        (0..10).for_each(|_| runner.advance_frame());
        let energies = runner.world().bodies()[0].energies(runner.world().time());
        (energies.total() - start, -energies.activation)
    };
    let found = [0, 1, 2].map(&mut off);
    println!("{found:?}");
    assert!(found[2].1.abs() > 0.0 && found[0].0.abs() < 0.05 * found[2].1.abs(), "{found:?}");
    for pair in found.windows(2) {
        assert!((pair[1].0 / pair[0].0 - 0.25).abs() < 0.08, "{found:?}");
    }
}

/// A rod held at its foot under its weight with four fibres whose fraction goes from 0.05 to 0.9, by its tip's sag [D].
fn sag(drive: impl Into<Drive>) -> f64 {
    let mut body = block([4, 14, 4], 2e4);
    body.material.damping.air = 40.0;
    body.drives = vec![SharedDrive::new("stiffen", drive)];
    body.regions = vec![layers("foot", Axis::Y, Side::Min, 2)];
    body.pins = vec![pin("foot", &ALL, Motion::Fixed)];
    let act = Activation::thickening(0.9, Drive::Shared("stiffen".into()));
    body.fibres = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]]
        .into_iter()
        .enumerate()
        .map(|(k, [x, z])| {
            let vertices = (0..14).map(|k| [x * D, D * (f64::from(k) + 0.5), z * D]).collect();
            fibre(&format!("rib {k}"), vertices, rigidity(12.0 * F, 0.0), 0.05, RestShape::Straight)
        })
        .map(|rib: Fibre| rib.with_activation(act.clone()))
        .collect();
    let scene = in_space(body).with_gravity([-9.81, 0.0, 0.0]);
    let mut runner = runner(&scene);
    (0..60).for_each(|_| runner.advance_frame());
    assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    let body = &runner.world().bodies()[0];
    let tip = |x: &[DVec3]| {
        x.iter().zip(body.parts().model.iter()).filter(|(_, at)| at.y > 13.0 * D).map(|(x, _)| x.x).sum::<f64>()
    };
    (tip(&body.parts().rest) - tip(&body.state().positions)) / 16.0 / D
}

#[test]
fn a_bar_that_sags_rises_as_its_fibres_get_thicker() {
    let (soft, stiff, risen) = (sag(0.0), sag(1.0), sag(DriveKeys::new([(0.0, 0.0), (0.3, 0.0), (0.5, 1.0)])));
    println!("{soft:.3} {stiff:.3} {risen:.3}");
    assert!(stiff < 0.7 * soft && stiff > 0.05, "{soft} {stiff}");
    assert!((risen / stiff - 1.0).abs() < 0.02, "{risen} {stiff}");
}

#[test]
fn the_stable_step_holds_however_thick_fibres_get() {
    let period = 40.0 * D / (E / 1852.0_f64).sqrt();
    // Thicker, thinner; stiffer than the matrix that they take the place of, and softer.
    for (ea, own, at_one) in [(60.0, 0.05, 0.95), (60.0, 0.95, 0.05), (15.0, 0.05, 0.95), (0.2, 0.95, 0.0)] {
        for drive in [
            Drive::from(Wave::new(period).with_wavelength(9.0 * D)),
            Drive::from(DriveKeys::new([(0.0, 0.0), (0.02, 1.0)])),
        ] {
            let mut body = rod([3, 7, 3]);
            let act = Activation { contract: 0.3, ..Activation::thickening(at_one, drive.clone()) };
            body.fibres = vec![upright(7, 0.5 * D, ea * F, act)];
            body.fibres[0].volume_fraction = own;
            assert!(crate::fibres::holds(&body, 0.98), "{ea} {own} {drive:?}");
            assert!(!crate::fibres::holds(&body, 1.25), "{ea} {own} {drive:?}");
        }
    }
}

#[test]
fn a_matrix_that_flows_or_yields_keeps_its_share() {
    let changes: [fn(&mut Material); 2] = [
        |material| material.plasticity = Some(Plasticity::new(1e4)),
        |material| material.viscosity = Some(Viscosity::new(30.0, 0.0)),
    ];
    for change in changes {
        let mut body = arched(Some(everything(0.5)), 0.2);
        change(&mut body.material);
        let error = in_space(body).validate().expect_err("it cannot do both");
        assert!(error.to_string().contains("/bodies/0/fibres/0/activation/volume_fraction"), "{error}");
        assert!(error.to_string().contains("`plasticity` and `viscosity`"), "{error}");
    }
}

#[test]
fn threads_change_no_bit_of_what_gets_thicker() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut body = arched(Some(everything(Wave::new(0.1).with_wavelength(8.0 * D))), 0.1);
            body.shape = block([8, 12, 8], E).shape;
            moved(body)
        })
    };
    let one = run(1);
    assert!([2, 5].into_iter().all(|threads| run(threads) == one));
}
