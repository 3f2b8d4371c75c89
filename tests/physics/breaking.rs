//! Fibres that break into two: what is lost, where, and what a reset gives back.

use crate::common::*;
use glam::{DQuat, DVec3};
use sinew::scene::{Body, BreakPast, Fibre, FibreSource, RestShape};
use sinew::sim::Runner;
use sinew::solver::EmbeddingWeights;
use sinew::solver::Energies;
use sinew::solver::Force;
use sinew::solver::ParticleState;
use sinew::solver::{BreakPlace, FibreBreak};
use sinew::test_support::solver::BreakLimits;
use sinew::test_support::solver::{FibreForce, FibreRest};
use std::sync::Arc;

const EDGE: f64 = 0.006;
const EI: f64 = 0.1;

/// Six vertices along x at rest, then turned by these angles [degrees] at the inner ones and stretched along one edge.
fn rod(limits: BreakLimits, turns: [f64; 4], stretched: Option<(usize, f64)>) -> (FibreForce, ParticleState) {
    let at: Vec<DVec3> = (0..6).map(|k| DVec3::X * EDGE * f64::from(k)).collect();
    let vertices = (0..6).map(|k| EmbeddingWeights { weights: vec![(k, 1.0)] }).collect();
    let rest = FibreRest::new(vertices, &at, 1e4, EI, 0.5, vec![None; 4]).on_line(2, 3).breaking(limits);
    let mut heading: f64 = 0.0;
    let mut positions = vec![DVec3::ZERO];
    for k in 0..5 {
        if k > 0 {
            heading += turns[k - 1].to_radians();
        }
        let length = EDGE * stretched.filter(|&(edge, _)| edge == k).map_or(1.0, |(_, by)| by);
        positions.push(positions[k] + length * DVec3::new(heading.cos(), heading.sin(), 0.0));
    }
    let state = ParticleState { velocities: vec![DVec3::ZERO; 6], masses: vec![1.0; 6], positions };
    (FibreForce::new(Arc::new([rest]), DQuat::IDENTITY), state)
}

fn energies(force: &FibreForce, state: &ParticleState) -> Energies {
    let mut energies = Energies::default();
    force.add_energy(0.0, state, &mut energies);
    energies
}

#[test]
fn a_break_removes_exactly_the_bending_energy_of_its_vertex() {
    let limits = BreakLimits { angle: 30_f64.to_radians(), ..BreakLimits::default() };
    let (mut force, state) = rod(limits, [10.0, 35.0, -50.0, 20.0], Some((0, 1.01)));
    let whole = force.clone();
    let before = energies(&force, &state);
    assert!(force.end_step(0.25, &state), "it is past its limit");
    let after = energies(&force, &state);
    // l_f (4 EI / L0) tan²(phi / 2): an inner vertex, so without the factor for ends.
    let expected = 0.5 * 4.0 * EI / (2.0 * EDGE) * 25_f64.to_radians().tan().powi(2);
    let lost = before.bending - after.bending;
    assert!((lost / expected - 1.0).abs() < 1e-12, "{lost} J, not {expected} J");
    assert_eq!(after.stretching, before.stretching);
    // The furthest past its limit goes first, and only it; counted along the whole centre line.
    assert_eq!(force.breaks(), [FibreBreak { fibre: 2, place: BreakPlace::Vertex(6), time: 0.25 }]);
    // The other one past the limit is next, then nothing is.
    assert!(force.end_step(0.5, &state));
    assert_eq!(force.breaks()[1], FibreBreak { fibre: 2, place: BreakPlace::Vertex(5), time: 0.5 });
    assert!(!force.end_step(0.75, &state));
    // A copy made before is whole.
    assert_eq!(energies(&whole, &state).bending, before.bending);
    assert!(whole.breaks().is_empty());
}

#[test]
fn a_fibre_pulled_too_hard_loses_the_edge_and_the_bends_at_its_ends() {
    // The edge carries l_f EA strain = 100 N.
    let pulled = |tension| rod(BreakLimits { tension, ..BreakLimits::default() }, [10.0; 4], Some((2, 1.02)));
    let (mut force, state) = pulled(101.0);
    assert!(!force.end_step(0.0, &state));
    let (mut force, state) = pulled(99.0);
    let before = energies(&force, &state);
    assert!(force.end_step(0.0, &state));
    let after = energies(&force, &state);
    assert_eq!(force.breaks()[0].place, BreakPlace::Edge(5));
    assert!(before.stretching > 0.0 && after.stretching < 1e-12 * before.stretching, "{after:?}");
    // Both end vertices keep theirs, with their factor of 3/2; two of the four are lost.
    assert!((after.bending / before.bending - 3.0 / 5.0).abs() < 1e-9, "{before:?} {after:?}");
    // Nothing joins the two parts any more: each part's forces sum to zero.
    let mut forces = vec![DVec3::ZERO; 6];
    force.add_forces(0.0, &state, &mut forces);
    let part: DVec3 = forces[..3].iter().sum();
    assert!(part.length() < 1e-9 && forces[0].length() > 0.1, "{forces:?}");
}

#[test]
fn a_scene_says_what_a_fibre_breaks_past_and_a_runner_from_the_start_is_whole() {
    let mut bar = short_bar(2e5);
    let vertices = (0..12).map(|k| [0.0, 0.003 + D * f64::from(k), 0.0]).collect();
    let mut brittle = fibre("f", vertices, rigidity(3000.0, 0.01), 0.5, RestShape::AsDrawn);
    brittle.break_past = Some(BreakPast { tension: Some(20.0), ..BreakPast::default() });
    bar.fibres = vec![brittle];
    bar.initial.deformation[1][1] = 1.1;
    let start = runner(&in_space(bar));
    let mut run = start.clone();
    run.advance_frame();
    assert!(run.world().bodies()[0].breaks().count() > 0);
    assert_eq!(start.snapshot().bodies[0].breaks, []);
    assert!(matches!(run.snapshot().bodies[0].breaks[0], FibreBreak { fibre: 0, place: BreakPlace::Edge(_), .. }));
}

#[test]
fn what_is_broken_stays_so_through_edits_until_the_fibre_itself_is_moved() {
    let column = |x: f64| (0..12).map(|k| [x, 0.003 + D * f64::from(k), 0.0]).collect();
    let mut bar = short_bar(2e5);
    let mut brittle = fibre("f", column(0.0), rigidity(3000.0, 0.01), 0.5, RestShape::AsDrawn);
    brittle.break_past = Some(BreakPast { tension: Some(20.0), ..BreakPast::default() });
    bar.fibres = vec![brittle.clone()];
    bar.initial.deformation[1][1] = 1.1;
    let mut run = runner(&in_space(bar.clone()));
    run.advance_frame();
    let breaks = run.snapshot().bodies[0].breaks.clone();
    assert!(!breaks.is_empty());
    let edited = |fibres: Vec<Fibre>| {
        let mut next = runner(&in_space(Body { fibres, ..bar.clone() }));
        next.adopt(&run);
        next
    };
    // Softer, tougher, and second in the list: the same fibre.
    let mut other = brittle.clone();
    other.stiffness = rigidity(1500.0, 0.01);
    other.break_past = None;
    let whole = fibre("g", column(0.006), rigidity(1500.0, 0.01), 0.5, RestShape::AsDrawn);
    let kept = edited(vec![whole, other.clone()]);
    let moved: Vec<FibreBreak> = breaks.iter().map(|one| FibreBreak { fibre: 1, ..*one }).collect();
    assert_eq!(kept.snapshot().bodies[0].breaks, moved);
    other.source = FibreSource::Vertices(column(0.001));
    assert_eq!(edited(vec![other]).snapshot().bodies[0].breaks, [], "one that was moved is whole");
    // What is broken pulls no more than it did: an edit of nothing changes nothing of the motion.
    let mut same = edited(vec![brittle]);
    let mut whole = edited(vec![]);
    for next in [&mut run, &mut same, &mut whole] {
        next.advance_frame();
    }
    let apart = |next: &Runner| {
        let [a, b] = [next, &run].map(|runner| &runner.world().bodies()[0].state().positions);
        a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
    };
    assert!(apart(&same) < 1e-9 && apart(&whole) > 1e-5, "{} and {} m", apart(&same), apart(&whole));
}
