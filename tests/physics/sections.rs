//! Sections of any size, shape and turn bend and twist as theory says.
//!
//! A rod is bent, and twisted, by one end that is turned against the other; the moment there over the turn between two
//! sections well within the rod is its stiffness, whatever the ends do. `sections_of_every_kind` prints a table of
//! forty.

use crate::common::*;
use crate::section_shapes::{Kind, Turned, prism, theory};
use glam::{DMat3, DQuat, DVec3};
use sinew::bake::bake;
use sinew::scene::{Assets, Body, Mass, Material, MeasureKind, Motion, Region, Rotation, Scene, Turn};
use sinew::scene::{BoxShape, MeshShape};
use sinew::sim::Runner;
use sinew::solver::Body as SolverBody;
use sinew::test_support::solver::MatrixForce;

const E: f64 = 5e6;
const NU: f64 = 0.33;
const DENSITY: f64 = 4e-4 / (D * D * D);

/// Which side of a plane across the rod, as a ball so large that its surface is flat there.
fn beyond(id: &str, direction: DVec3, from: f64) -> Region {
    let radius = 1e3;
    Region::in_sphere(id, (direction * (from + radius)).to_array(), radius)
}

/// Bent about the first and the second principal axis, or twisted.
#[derive(Clone, Copy, Debug)]
enum Load {
    Bend(usize),
    Twist,
}

#[derive(Clone, Copy, Debug)]
struct Section {
    kind: Kind,
    /// Size [layers].
    t: f64,
    turned: Turned,
}

impl Section {
    fn scene(&self, load: Load) -> (Scene, Assets, f64) {
        let Self { kind, t, turned } = *self;
        let theory = theory(kind);
        let width = theory.width * t;
        let length = (3.5 * width + 5.0).max(14.0).round();
        let turn = turned.rotation();
        let material = Material::new(E, NU, DENSITY).with_support_radius(H);
        let mut assets = Assets::default();
        let mut rod = if kind == Kind::Square {
            // The box stays, the lattice is turned the other way.
            let (axis, degrees) = turn_of(turned);
            let shape = BoxShape::new([length, t, t].map(|n| n * D));
            Body::new("block", BoxShape { lattice_rotation: Rotation::about(axis, -degrees), ..shape })
        } else {
            let shape = MeshShape::from("rod");
            assets.insert_mesh(&shape, &prism(kind, t, length, turn)).expect("a solid");
            Body::from_mesh("block", shape)
        };
        rod.material = material;
        rod.material.mass = Mass::Density(DENSITY);
        let Frame { along, axis, middle } = self.frame(load);
        let half = 0.5 * length * D;
        let (apart, reach) = (0.5 * width * D, 0.62 * width * D + 0.5 * D);
        let ball = |id: &str, x: f64| Region::in_sphere(id, (middle + x * along).to_array(), reach);
        rod.regions = vec![
            beyond("bottom", -along, half - 2.1 * D),
            beyond("top", along, half - 2.1 * D),
            ball("low", -apart),
            ball("high", apart),
        ];
        // About the middle: then the moment is the same all along the rod.
        let speed = (E / (2.0 * (1.0 + NU)) / DENSITY).sqrt();
        let omega = match load {
            Load::Twist => {
                std::f64::consts::PI * speed / (length * D)
                    * (theory.torsion / (theory.bending[0] + theory.bending[1])).sqrt()
            }
            Load::Bend(k) => {
                22.4 * (E * theory.bending[k] / (DENSITY * theory.area)).sqrt() * t * D / (length * D).powi(2)
            }
        };
        rod.material.damping.air = 2.0 * omega;
        let turning = Turn::new(axis.to_array(), 0.2, 4.0 / omega).with_origin(middle.to_array());
        rod.pins = vec![pin("bottom", &ALL, Motion::Fixed), pin("top", &ALL, Motion::Turn(turning))];
        let mut scene = in_space(rod);
        scene.time.frames_per_second = omega;
        scene.measures = vec![
            measure("turn", MeasureKind::twist("high", "low", axis.to_array())),
            measure("moment", MeasureKind::reaction_torque("top", (-axis).to_array())),
            measure("volume", MeasureKind::Volume),
        ];
        (scene, assets, length)
    }

    /// How the rod lies, and about which axis it is bent or twisted.
    fn frame(&self, load: Load) -> Frame {
        let theory = theory(self.kind);
        let turn = if self.kind == Kind::Square { DMat3::IDENTITY } else { self.turned.rotation() };
        let along = turn * DVec3::X;
        let axis = match load {
            Load::Twist => along,
            Load::Bend(k) => {
                let angle = theory.principal.to_radians() + 0.5 * std::f64::consts::PI * k as f64;
                turn * DVec3::new(0.0, angle.cos(), angle.sin())
            }
        };
        Frame { along, axis, middle: turn * (D * self.t * DVec3::new(0.0, theory.center[0], theory.center[1])) }
    }

    /// What it is found to be over theory, and how many particles there are.
    fn over_theory(&self) -> (Found, usize) {
        let theory = theory(self.kind);
        let size = self.t * D;
        let loads = [Load::Bend(0), Load::Bend(1), Load::Twist];
        let [area, i, j] = self.moments_over_theory();
        let (mut found, mut particles) = (Found { area, moments: [i, j], ..Found::default() }, 0);
        for (k, load) in loads.into_iter().enumerate() {
            let (scene, assets, _) = self.scene(load);
            scene.validate().expect("a valid scene");
            let baked = bake(&scene, &assets).expect("a scene that bakes");
            let frame = self.frame(load);
            let [low, high] =
                ["low", "high"].map(|id| frame.turn(&baked.regions[0][id], &baked.world.bodies()[0].state().positions));
            let mut runner = Runner::new(baked);
            particles = runner.world().bodies()[0].state().len();
            for _ in 0..400 {
                runner.advance_frame();
                assert!(runner.world().divergence().is_none());
                if runner.at_rest() {
                    break;
                }
            }
            assert!(runner.at_rest(), "{:?} of {} layers under {load:?}", self.kind, self.t);
            let (turn, moment) = (scalar(&runner, 0).to_radians(), scalar(&runner, 1));
            let rigidity = match load {
                Load::Bend(k) => E * theory.bending[k],
                Load::Twist => E / (2.0 * (1.0 + NU)) * theory.torsion,
            } * size.powi(4);
            found.stiffness[k] = moment * (high - low) / turn / rigidity;
        }
        (found, particles)
    }

    /// Area and second moments over theory, of the particles as they lie.
    fn moments_over_theory(&self) -> [f64; 3] {
        let (theory, size) = (theory(self.kind), self.t * D);
        let (scene, assets, length) = self.scene(Load::Bend(0));
        let baked = bake(&scene, &assets).expect("a scene that bakes");
        let body = &baked.world.bodies()[0];
        let [i, j] = [0, 1].map(|k| {
            let frame = self.frame(Load::Bend(k));
            let moment = self.second_moment(body, frame.axis.cross(frame.along)) / (length * D);
            moment / (theory.bending[k] * size.powi(4))
        });
        [scalar(&Runner::new(baked), 2) / (theory.area * size * size * length * D), i, j]
    }

    /// Second moment of a body's particles along a direction, as they count in the stiffness [m^5].
    fn second_moment(&self, body: &SolverBody, direction: DVec3) -> f64 {
        let force = body.parts().forces.iter().find_map(|force| force.downcast_ref::<MatrixForce>());
        let volumes = force.expect("a matrix").volumes();
        let at = || body.parts().rest.iter().zip(&volumes);
        let whole: f64 = volumes.iter().sum();
        let mean = at().map(|(x, volume)| volume * x.dot(direction)).sum::<f64>() / whole;
        // Cells have a second moment of their own.
        let axes = if self.kind == Kind::Square { self.turned.rotation().transpose() } else { DMat3::IDENTITY };
        let own: f64 = (0..3)
            .map(|k| {
                let mut along: Vec<f64> = body.parts().rest.iter().map(|x| x.dot(axes.col(k))).collect();
                along.sort_by(f64::total_cmp);
                let gaps = along.windows(2).map(|pair| pair[1] - pair[0]).filter(|gap| *gap > 1e-3 * D);
                (axes.col(k).dot(direction) * gaps.fold(f64::INFINITY, f64::min)).powi(2) / 12.0
            })
            .sum();
        at().map(|(x, volume)| volume * ((x.dot(direction) - mean).powi(2) + own)).sum()
    }

    fn print(&self) -> Found {
        let (found, particles) = self.over_theory();
        let Found { area, moments: [i, j], stiffness: [first, second, torsion] } = found;
        let (name, turned) = (format!("{:?}", self.kind), format!("{:?}", self.turned));
        println!(
            "{name:7} {:5.2} {turned:12} {particles:6} {area:7.3} {i:7.3} {j:7.3} {first:7.3} {second:7.3} {torsion:7.3}",
            self.t
        );
        found
    }
}

/// What a section is found to be over theory.
#[derive(Clone, Copy, Debug, Default)]
struct Found {
    area: f64,
    /// Second moments of its particles along both principal axes; their sum is that about the rod, which is J of round
    /// sections and tubes. Of others no sum over particles is.
    moments: [f64; 2],
    /// Resistance to bending about both axes and to twist.
    stiffness: [f64; 3],
}

/// How a rod lies: along which direction, bent or twisted about which axis, through which place of its middle [m].
struct Frame {
    along: DVec3,
    axis: DVec3,
    middle: DVec3,
}

impl Frame {
    /// Where a place goes, to first order, by a turn of one for each length along the rod.
    fn moved(&self, place: DVec3) -> DVec3 {
        let Self { along, axis, middle } = *self;
        let from_middle = place - middle;
        let x = from_middle.dot(along);
        let aside = axis.cross(along);
        0.5 * x * x * aside + x * axis.cross(from_middle - x * along)
    }

    /// By how much that turns particles [m], as `MeasureKind::twist` measures turns: its regions are as long as they
    /// are wide, and hold more particles on one side or the other by where the lattice falls.
    fn turn(&self, particles: &[u32], positions: &[DVec3]) -> f64 {
        let at = || particles.iter().map(|&i| positions[i as usize]);
        let count = particles.len() as f64;
        let [mean, mean_moved] = [at().sum::<DVec3>() / count, at().map(|x| self.moved(x)).sum::<DVec3>() / count];
        let across = |x: DVec3| x - self.axis * x.dot(self.axis);
        let turn = |x: DVec3| across(x - mean).cross(self.moved(x) - mean_moved).dot(self.axis);
        at().map(turn).sum::<f64>() / at().map(|x| across(x - mean).length_squared()).sum::<f64>()
    }
}

/// Axis and angle of the turn of a rod along x.
fn turn_of(turned: Turned) -> ([f64; 3], f64) {
    let (axis, angle) = DQuat::from_mat3(&turned.rotation()).to_axis_angle();
    (axis.to_array(), angle.to_degrees())
}

const TURNS: [Turned; 4] = [Turned::Not, Turned::About(22.5), Turned::Askew(30.0), Turned::About(45.0)];

/// Sections of every kind, of 3 to 6 layers in steps of a quarter; large ones of fewer layers, since they have many
/// particles.
fn forty() -> Vec<Section> {
    let mut all = Vec::new();
    for (kind, most) in [(Kind::Square, 13), (Kind::Round, 13), (Kind::L, 7), (Kind::Tube, 4), (Kind::Leaf, 5)] {
        for k in 0..8 {
            // No two of them alike.
            let quarters = if most > 5 { 5 * k % most } else { (k + 2 * (k / 4)) % most };
            all.push(Section { kind, t: 3.0 + 0.25 * f64::from(quarters), turned: TURNS[k as usize % 4] });
        }
    }
    all
}

/// Sections of whole layers, which are filled exactly.
fn of_whole_layers() -> impl Iterator<Item = Section> {
    let kinds = [Kind::Square, Kind::L, Kind::Leaf].into_iter();
    kinds.flat_map(|kind| [2.0, 3.0, 4.0].map(|t| Section { kind, t, turned: Turned::Not }))
}

const HEAD: &str = "section layers turn     particles    area     I 1     I 2  bend 1  bend 2  torsion";

/// Minutes: `cargo test --release --test physics -- --ignored --nocapture sections_of_every_kind`.
#[test]
#[ignore = "takes minutes: cargo test --release --test physics -- --ignored --nocapture sections_of_every_kind"]
fn sections_of_every_kind() {
    println!("{HEAD}");
    let mut far_off = Vec::new();
    let mut worst = [0.0_f64; 4];
    for section in forty() {
        let Found { area, moments: [i, j], stiffness: [first, second, torsion] } = section.print();
        let off = [[area; 2], [i, j], [first, second], [torsion; 2]].map(|[a, b]| (a - 1.0).abs().max((b - 1.0).abs()));
        let most = [0.02, 0.1, 0.5 / section.t, 0.45 / section.t];
        for k in 0..4 {
            worst[k] = worst[k].max(off[k]);
            if off[k] > most[k] {
                far_off.push(format!("{section:?}: {off:.3?}"));
            }
        }
    }
    println!("furthest off in area, I, bending, torsion: {worst:.3?}");
    println!("{HEAD}");
    for section in of_whole_layers() {
        section.print();
    }
    assert!(far_off.is_empty(), "{far_off:#?}");
}

#[test]
fn particles_have_the_area_and_nearly_the_second_moments_of_their_sections() {
    // Round rods of three layers have the most: steps of their surface are as high as a third of them.
    for (kind, t, turned, most) in [
        (Kind::Square, 4.75, Turned::Not, 1e-9),
        (Kind::Square, 4.25, Turned::About(22.5), 0.02),
        (Kind::Square, 4.0, Turned::Askew(30.0), 0.03),
        (Kind::Round, 3.0, Turned::Not, 0.1),
        (Kind::Round, 4.25, Turned::About(22.5), 0.045),
        (Kind::L, 4.5, Turned::Not, 1e-9),
        (Kind::L, 3.25, Turned::About(45.0), 0.02),
    ] {
        let [area, i, j] = Section { kind, t, turned }.moments_over_theory();
        println!("{kind:?} {t} {turned:?}: {area:.4} {i:.4} {j:.4}");
        assert!((area - 1.0).abs() < 1e-3, "{kind:?} {t} {turned:?}: {area}");
        let off = (i - 1.0).abs().max((j - 1.0).abs());
        assert!(off < most, "{kind:?} {t} {turned:?}: {i} {j}");
    }
}

#[test]
fn boxes_of_any_thickness_bend_and_twist_alike() {
    // As those of three and four whole layers do, which is what the formulation gives.
    for t in [3.25, 3.5] {
        let Found { area, stiffness: [first, second, torsion], .. } =
            Section { kind: Kind::Square, t, turned: Turned::Not }.print();
        assert!((area - 1.0).abs() < 1e-9, "{area}");
        assert!((first - 0.965).abs() < 0.03 && (second - 0.965).abs() < 0.03, "{t} layers: {first}, {second}");
        assert!((torsion - 1.03).abs() < 0.03, "{t} layers: {torsion}");
    }
}
#[test]
fn a_turned_lattice_hardly_changes_how_a_box_bends() {
    // With whole particles it bent at 0.89 to 1.13 by the direction.
    let Found { area, stiffness: [first, second, torsion], .. } =
        Section { kind: Kind::Square, t: 3.5, turned: Turned::About(22.5) }.print();
    assert!((area - 1.0).abs() < 0.02, "{area}");
    assert!((first - 1.0).abs() < 0.05 && (second - 1.0).abs() < 0.05, "{first}, {second}");
    assert!((torsion - 1.06).abs() < 0.06, "{torsion}");
}

#[test]
fn round_rods_of_any_size_bend_as_theory_says() {
    // With whole particles rods of 3.25 and 3.5 layers bent at 0.92 to 1.31 and twisted at 0.83 to 0.97.
    for (t, turned) in [(3.25, Turned::Not), (3.5, Turned::About(22.5))] {
        let Found { area, stiffness: [first, second, torsion], .. } = Section { kind: Kind::Round, t, turned }.print();
        assert!((area - 1.0).abs() < 0.01, "{area}");
        assert!((first - 1.0).abs() < 0.05 && (second - 1.0).abs() < 0.05, "{t} layers: {first}, {second}");
        assert!((torsion - 0.92).abs() < 0.08, "{t} layers: {torsion}");
    }
}

#[test]
fn meshes_askew_to_the_lattice_have_their_area() {
    for (kind, t, turned) in [
        (Kind::L, 3.25, Turned::About(22.5)),
        (Kind::Leaf, 3.5, Turned::About(45.0)),
        (Kind::Leaf, 3.0, Turned::Askew(30.0)),
        (Kind::Tube, 3.0, Turned::Not),
        (Kind::Round, 4.5, Turned::Askew(30.0)),
    ] {
        let (scene, assets, length) = Section { kind, t, turned }.scene(Load::Twist);
        let runner = Runner::new(bake(&scene, &assets).expect("a scene that bakes"));
        let area = scalar(&runner, 2) / (length * D) / (t * D).powi(2);
        assert!((area / theory(kind).area - 1.0).abs() < 0.01, "{kind:?} of {t} layers: {area}");
        // The masses' second moments along both directions across, with those of their cells.
        let state = runner.world().bodies()[0].state();
        let theory = theory(kind);
        let across = turned.rotation()
            * DVec3::new(0.0, theory.principal.to_radians().cos(), theory.principal.to_radians().sin());
        let over = turned.rotation() * DVec3::X;
        for (direction, bending) in [(over.cross(across), theory.bending[0]), (across, theory.bending[1])] {
            let mean = state.positions.iter().zip(&state.masses).map(|(x, m)| m * x.dot(direction)).sum::<f64>()
                / state.mass();
            let each = state.positions.iter().zip(&state.masses).map(|(x, m)| m * (x.dot(direction) - mean).powi(2));
            let found = each.sum::<f64>() / state.mass() + D * D / 12.0;
            let ratio = found / (bending / theory.area * (t * D).powi(2));
            assert!((ratio - 1.0).abs() < 0.06, "{kind:?} of {t} layers, {turned:?}: {ratio}");
        }
    }
}

#[test]
fn meshes_with_faces_along_the_lattice_are_filled_exactly() {
    for (kind, t) in
        [(Kind::L, 3.0), (Kind::L, 3.25), (Kind::L, 3.5), (Kind::Leaf, 3.25), (Kind::Leaf, 4.0), (Kind::Leaf, 4.5)]
    {
        let (scene, assets, length) = Section { kind, t, turned: Turned::Not }.scene(Load::Twist);
        let runner = Runner::new(bake(&scene, &assets).expect("a scene that bakes"));
        let area = scalar(&runner, 2) / (length * D) / (t * D).powi(2);
        assert!((area / theory(kind).area - 1.0).abs() < 1e-9, "{kind:?} of {t} layers: {area}");
        // As far out as the shape, less half a layer: not by which side of a face the lattice falls.
        let state = runner.world().bodies()[0].state();
        let [low, high] =
            [f64::min, f64::max].map(|of| state.positions.iter().map(|x| x.z / D).reduce(of).expect("some"));
        let half = if kind == Kind::L { t } else { 0.5 * t };
        assert!((low + high).abs() < 1e-9, "{kind:?} of {t} layers: {low} to {high}");
        assert!((0.35..0.65).contains(&(half - high)), "{kind:?} of {t} layers: up to {high}");
    }
}
