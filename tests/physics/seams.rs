//! Seams: a body tears along them, and nowhere else; what is torn is as if it had been cut; momentum stays, and what is
//! released is booked.

use crate::common::*;
use glam::DVec3;
use sinew::scene::{Automatic, Axis, Body, Distance, MeasureKind, Motion, Scene, Sheet, Side, TimeStep, Void};
use sinew::sim::{Report, Runner};
use sinew::solver::{SeamTear, World};

const E: f64 = 1e5;

/// A flat seam across a body at a height [m], from `from` [m] on along x.
fn seam(height: f64, from: f64, stretch: f64) -> Sheet {
    let row = |z: f64| vec![[from, height, z], [9.0 * D, height, z]];
    Sheet::grid("seam", vec![row(-9.0 * D), row(9.0 * D)]).tearing_past(stretch)
}

fn with(mut body: Body, sheet: Sheet) -> Body {
    body.sheets = vec![sheet];
    body
}

/// A block of which both ends are drawn apart by so many of its length in so many seconds, from rest.
fn drawn(layers_of: [u32; 3], seam: Sheet, share: f64, seconds: f64) -> Scene {
    let mut bar = with(block(layers_of, E), seam);
    let length = f64::from(layers_of[1]) * D;
    bar.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    let pull = |way: f64| ramp([0.0, way, 0.0], Distance::Metres(0.5 * share * length), seconds);
    bar.pins = vec![pin("bottom", &ALL, pull(-1.0)), pin("top", &ALL, pull(1.0))];
    in_space(bar)
}

fn tear(world: &World) -> SeamTear {
    world.bodies()[0].tears()[0]
}

/// Energy of all, and what was lost for good [J].
fn energy(world: &World) -> f64 {
    world.bodies()[0].energies(world.time()).total()
}

#[test]
fn a_seam_that_holds_is_as_if_it_were_not_there() {
    // Right through particles, slanting, and short of one face.
    let slanting = Sheet::grid(
        "seam",
        vec![vec![[-0.1, 0.02, -0.1], [0.1, 0.045, -0.1]], vec![[-0.1, 0.02, 0.1], [0.1, 0.045, 0.1]]],
    );
    for sheet in [seam(5.5 * D, -9.0 * D, 9.0), seam(5.0 * D, 0.2 * D, 9.0), slanting.tearing_past(9.0)] {
        let mut bar = block([5, 11, 6], E);
        bar.initial.deformation = [[1.1, 0.2, 0.0], [0.0, 0.9, 0.1], [0.05, 0.0, 1.0]];
        bar.initial.angular_velocity = [300.0, 100.0, -200.0];
        let run = |body: Body| {
            let mut runner = runner(&in_space(body));
            (0..3).for_each(|_| runner.advance_frame());
            runner
        };
        let (plain, seamed) = (run(bar.clone()), run(with(bar, sheet)));
        let positions = |of: &Runner| of.world().bodies()[0].state().positions.clone();
        let apart = positions(&plain).iter().zip(positions(&seamed)).map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
        assert_eq!(tear(seamed.world()).torn, 0);
        assert!(tear(seamed.world()).bonds > 300, "{:?}", tear(seamed.world()));
        assert!(apart < 1e-9 * D, "{apart} m apart");
        let [a, b] = [&plain, &seamed].map(|of| energy(of.world()));
        assert!((a / b - 1.0).abs() < 1e-9, "{a} and {b} J");
    }
}

#[test]
fn a_bar_drawn_apart_tears_along_its_seam_into_two_equal_halves() {
    let mut scene = drawn([4, 12, 5], seam(6.0 * D, -9.0 * D, 1.3), 0.5, 0.2);
    scene.measures = vec![measure("torn", MeasureKind::Torn)];
    let mut runner = runner(&scene);
    assert_eq!(scalar(&runner, 0), 0.0);
    let mut frames = 0;
    let (mut least, mut before) = (0.0_f64, 0.0);
    while tear(runner.world()).torn < tear(runner.world()).bonds {
        runner.advance_frame();
        let lost = runner.world().bodies()[0].dissipated();
        least = least.min(lost - before);
        before = lost;
        frames += 1;
        assert!(frames < 60, "{:?}", tear(runner.world()));
    }
    println!("{frames} frames, {:?}, {before} J released, least change {least}", tear(runner.world()));
    let body = &runner.world().bodies()[0];
    assert_eq!(scalar(&runner, 0), 1.0, "all of it is torn");
    // It was whole for a while: the ends have drawn it by what the seam stands, about.
    assert!(tear(runner.world()).first.expect("a time") > 0.05);
    // Every particle has its mirror image in the other half, and has moved as that has.
    let rest = body.parts().rest.clone();
    let moved = |i: usize| body.state().positions[i] - rest[i];
    let greatest = (0..rest.len()).map(|i| moved(i).length()).fold(0.0, f64::max);
    for (i, at) in rest.iter().enumerate() {
        let image = DVec3::new(at.x, 12.0 * D - at.y, at.z);
        let other = rest.iter().position(|x| x.distance(image) < 1e-9).expect("a mirror image");
        let [here, there] = [moved(i), moved(other)];
        let off = here.distance(DVec3::new(there.x, -there.y, there.z));
        assert!(off < 0.02 * greatest, "{i}: {off} of {greatest} m");
    }
    // Nothing holds the halves together: what is left between them is more than they were apart.
    let gap = |of: &[DVec3]| {
        let (mut above, mut below) = (f64::INFINITY, 0.0_f64);
        for (x, at) in of.iter().zip(rest.iter()) {
            if at.y > 6.0 * D {
                above = above.min(x.y);
            } else {
                below = below.max(x.y);
            }
        }
        above - below
    };
    let before = gap(&body.state().positions);
    (0..20).for_each(|_| runner.advance_frame());
    let body = &runner.world().bodies()[0];
    assert!(body.divergence().is_none());
    let after = gap(&body.state().positions);
    println!("gap {} D, then {} D", before / D, after / D);
    assert!(after > 3.0 * D, "{after} m");
}

#[test]
fn tearing_keeps_momentum_and_what_it_releases_is_booked() {
    // A bar that swings from drawn to pressed in flight: its seam tears at the first step.
    let mut bar = with(block([4, 12, 5], E), seam(6.0 * D, -9.0 * D, 1.1));
    bar.initial.deformation[1][1] = 1.25;
    bar.initial.angular_velocity = [0.0, 0.0, 500.0];
    bar.initial.velocity = [0.3, 0.2, -0.1];
    let momenta = |world: &World| {
        let state = world.bodies()[0].state();
        [state.linear_momentum(), state.angular_momentum()]
    };
    // Leap-frog's energy is off by the square of the step.
    let mut greatest = Vec::new();
    for safety in [0.2, 0.1] {
        let mut scene = in_space(bar.clone());
        scene.time.step = TimeStep::Automatic(Automatic { safety, ..Automatic::default() });
        scene.time.frames_per_second = 1000.0;
        let mut runner = runner(&scene);
        let (start, at_start) = (momenta(runner.world()), energy(runner.world()));
        let (mut off, mut released) = (0.0_f64, 0.0);
        for _ in 0..8 {
            runner.advance_frame();
            let lost = runner.world().bodies()[0].dissipated();
            assert!(lost >= released, "{lost} and {released} J");
            released = lost;
            off = off.max((energy(runner.world()) + released - at_start).abs() / at_start);
        }
        println!("{safety}: {:?}, {released} of {at_start} J, off by {off}", tear(runner.world()));
        assert!(tear(runner.world()).torn > 400 && released > 0.01 * at_start);
        let (end, mass) = (momenta(runner.world()), runner.world().bodies()[0].state().mass());
        assert!(start[0].distance(end[0]) < 1e-11 * mass, "{} and {}", start[0], end[0]);
        assert!(start[1].distance(end[1]) < 1e-9 * start[1].length(), "{} and {}", start[1], end[1]);
        assert!(runner.world().unbalanced().is_empty());
        greatest.push(off);
    }
    assert!(greatest[1] < 3e-3 && greatest[1] < 0.35 * greatest[0], "{greatest:?}");
}

#[test]
fn a_torn_seam_is_a_cut() {
    // Blown up past its limit at the start, it is torn all over; then it is pulled by a little. No pair of neighbours
    // crosses just where the seam ends.
    let length = 11.0 * D;
    let pulled = |mut block: Body| {
        let omega = std::f64::consts::PI * (E / (4e-4 / D.powi(3))).sqrt() / length;
        block.material.damping.air = 1.2 * omega;
        block.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
        let pull =
            ramp([0.0, 1.0, 0.0], Distance::Metres((1.001 - block.initial.deformation[1][1]) * length), 3.0 / omega);
        block.pins = vec![pin("bottom", &[Axis::Y], Motion::Fixed), pin("top", &[Axis::Y], pull)];
        let mut scene = in_space(block);
        scene.time.frames_per_second = omega;
        scene.measures = vec![measure("pull", MeasureKind::reaction_force("bottom", [0.0, 1.0, 0.0]))];
        scene
    };
    let whole = block([6, 12, 6], E);
    let crack = Void::in_box("crack", [0.12 * D, 5.99 * D, -9.0 * D], [9.0 * D, 6.01 * D, 9.0 * D]);
    let mut torn = with(whole.clone(), seam(6.0 * D, 0.12 * D, 1.05));
    torn.initial.deformation = [[1.1, 0.0, 0.0], [0.0, 1.1, 0.0], [0.0, 0.0, 1.1]];
    let cut = settle(&pulled(whole.with_void(crack)), 400);
    let torn = settle(&pulled(torn), 400);
    let SeamTear { bonds, torn: count, .. } = tear(torn.world());
    let [cut, torn] = [cut, torn].map(|of| scalar(&of, 0));
    println!("{torn} N torn ({count} of {bonds} bonds), {cut} N cut");
    assert!((torn / cut - 1.0).abs() < 0.02, "{torn} and {cut} N");
}

#[test]
fn what_is_torn_goes_back_with_a_checkpoint_bit_for_bit_and_is_in_the_hash() {
    let scene = drawn([4, 12, 5], seam(6.0 * D, -9.0 * D, 1.2), 0.6, 0.1);
    let mut runner = runner(&scene);
    let whole = runner.world().checkpoint();
    let hash = |of: &Runner| Report::new(&scene, of, 0.0, Vec::new()).bodies[0].state_hash.clone();
    let mut seen = Vec::new();
    for _ in 0..12 {
        runner.advance_frame();
        seen.push((runner.world().checkpoint(), hash(&runner), tear(runner.world())));
    }
    assert!(seen[0].2.torn == 0 && seen[11].2.torn > 100, "{:?}", seen[11].2);
    for from in [0, 6, 9] {
        let mut world = runner.world().clone();
        world.go_back(&seen[from].0);
        for (kept, _, tears) in &seen[from + 1..] {
            world.advance_frame();
            assert_eq!(tear(&world), *tears);
            let mut there = world.clone();
            there.go_back(kept);
            assert_eq!(world.bodies()[0].state().positions, there.bodies()[0].state().positions);
        }
    }
    let mut start = runner.world().clone();
    start.go_back(&whole);
    assert_eq!(tear(&start).torn, 0, "a reset mends it");
    // The same bits on any number of threads.
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut again = crate::common::runner(&scene);
            for (_, expected, _) in &seen {
                again.advance_frame();
                assert_eq!(hash(&again), *expected, "on {threads} threads");
            }
        });
    }
}

#[test]
fn what_is_torn_stays_so_through_edits_until_the_seam_is_moved() {
    let mut bar = with(block([4, 12, 5], E), seam(6.0 * D, -9.0 * D, 1.1));
    bar.initial.deformation[1][1] = 1.25;
    let mut run = runner(&in_space(bar.clone()));
    run.advance_frame();
    let torn = tear(run.world());
    assert!(torn.torn > 0);
    let edited = |sheet: Sheet| {
        let mut next = runner(&in_space(with(bar.clone(), sheet)));
        next.adopt(&run);
        tear(next.world())
    };
    assert_eq!(edited(seam(6.0 * D, -9.0 * D, 2.0)), torn);
    assert_eq!(edited(seam(8.0 * D, -9.0 * D, 2.0)).torn, 0);
}

#[test]
fn a_seam_that_leaves_a_single_layer_is_refused_and_one_outside_is_said() {
    let at = |height: f64| in_space(with(block([4, 12, 5], E), seam(height, -9.0 * D, 1.1)));
    let error = sinew::bake::bake(&at(11.0 * D), &sinew::scene::Assets::default()).err();
    let text = error.expect("a single layer").to_string();
    assert!(text.starts_with("/bodies/0/sheets/0/seam: 20 particles") && text.contains("0.012"), "{text}");
    assert!(sinew::bake::bake(&at(10.0 * D), &sinew::scene::Assets::default()).is_ok());
    let notes = baked(&at(20.0 * D)).notes;
    assert!(notes.iter().any(|note| note.warning && note.text.contains("outside the body")), "{notes:?}");
}

#[test]
fn the_skin_splits_along_what_is_torn_and_shows_its_walls() {
    let scene = drawn([4, 12, 5], seam(6.0 * D, 0.3 * D, 1.3), 0.5, 0.1);
    let mut bar = scene.bodies[0].clone();
    bar.sheets.clear();
    let plain = runner(&in_space(bar)).snapshot().bodies[0].clone();
    let mut runner = runner(&scene);
    let whole = runner.snapshot().bodies[0].clone();
    assert_eq!((&whole.skin, &whole.triangles), (&plain.skin, &plain.triangles), "nobody sees a seam that holds");
    let start = runner.world().checkpoint();
    while tear(runner.world()).torn < tear(runner.world()).bonds {
        runner.advance_frame();
        assert!(runner.world().frame() < 40, "{:?}", tear(runner.world()));
    }
    let torn = runner.snapshot().bodies[0].clone();
    let corners = |of: [u32; 3]| of.map(|k| torn.skin[k as usize]);
    let longest = |of: [u32; 3]| {
        let [a, b, c] = corners(of);
        a.distance(b).max(b.distance(c)).max(c.distance(a))
    };
    let most = torn.triangles.iter().map(|&of| longest(of)).fold(0.0, f64::max);
    println!(
        "{} faces, of a whole one {}; the longest edge {} D",
        torn.triangles.len(),
        whole.triangles.len(),
        most / D
    );
    // Nothing is drawn across the gap, which is several spacings wide.
    assert!(most < 3.0 * D, "{most} m");
    // It is closed up to the slit that nobody sees: what it encloses is the body, which pulls itself together again.
    let volume: f64 = torn.triangles.iter().map(|&of| corners(of)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum();
    let of_body = 4.0 * 12.0 * 5.0 * D.powi(3);
    println!("{volume} m³ of {of_body} m³");
    assert!((volume / of_body - 1.0).abs() < 0.15, "{volume} of {of_body} m³");
    assert!(torn.triangles.len() > whole.triangles.len());
    let mut back = runner.world().clone();
    back.go_back(&start);
    assert_eq!(sinew::solver::Snapshot::of(&back).bodies[0].triangles, whole.triangles, "a reset mends it");
}
