//! What several parts share counts once, and what encloses nothing is left out, whatever else is in the file.

use crate::shapes::{joined, moved, single, solid, sphere};
use glam::DVec3;
use sinew::geometry::{Cuboid, FillResolution, Model, box_surface, fill};

fn cube(center: [f64; 3], size: f64) -> Model {
    let shape = Cuboid { center: DVec3::from_array(center), size: DVec3::splat(size) };
    let mesh = box_surface(&shape, size);
    single(mesh.positions, mesh.triangles)
}

fn inside_out(mut model: Model) -> Model {
    model.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    model
}

/// Volume, particles and extents agree with what is known.
fn holds(model: &Model, expected: f64) -> String {
    let solid = solid(model);
    assert!((solid.volume / expected - 1.0).abs() < 0.005, "{} m³ instead of {expected}", solid.volume);
    let filling = fill(&solid, FillResolution::Particles(2000), 2.5, 100_000).expect("a filling");
    let held = filling.sample.points.len() as f64 * filling.sample.spacing.powi(3);
    assert!((held / expected - 1.0).abs() < 0.02, "the particles hold {held} m³ instead of {expected}");
    solid.report.findings().iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

#[test]
fn parts_in_one_another_count_once_however_they_touch() {
    let unit = cube([0.0; 3], 1.0);
    // Half in one another, sides in one plane and edges on edges; the same but for a hair; within, on one side.
    let said = holds(&joined(&[&unit, &cube([0.5, 0.0, 0.0], 1.0)]), 1.5);
    assert!(said.contains("parts share 33.33 % of the volume inside, which is filled once"), "{said}");
    holds(&joined(&[&unit, &cube([1e-7, 0.0, 0.0], 1.0)]), 1.0);
    holds(&joined(&[&unit, &cube([0.25, 0.0, 0.0], 0.5)]), 1.0);
    // With a side in common, of the whole and of a part.
    holds(&joined(&[&unit, &cube([1.0, 0.0, 0.0], 1.0)]), 2.0);
    holds(&joined(&[&unit, &cube([0.75, 0.1, 0.1], 0.5)]), 1.125);
    // One through the wall of another, which has a cavity.
    let cavity = inside_out(cube([-0.2, -0.2, -0.2], 0.4));
    holds(&joined(&[&unit, &cube([0.4, 0.2, 0.2], 0.4), &cavity]), 1.0 - 0.064 + 0.1 * 0.16);
}

#[test]
fn sheets_and_strays_are_left_out_and_named() {
    let ball = sphere(12, 0.5);
    let volume = solid(&ball).volume;
    let plane = |half: f64, at: DVec3| {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|[x, z]| at + half * DVec3::new(x, 0.0, z));
        single(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]])
    };
    for (other, at) in [
        (plane(9.0, DVec3::new(0.0, -0.5, 0.0)), "[0.0000, -0.5000, 0.0000]"),
        (plane(0.01, DVec3::new(1e3, 0.0, 0.0)), "[1000.0000, 0.0000, 0.0000]"),
    ] {
        let mut model = joined(&[&ball, &other]);
        model.parts[1].name = "ground".to_owned();
        let said = holds(&model, volume);
        let expected =
            format!("1 piece (\"ground\") of 2 faces encloses nothing and is left out, the first around {at} m");
        assert!(said.contains(&expected), "{said}");
        // Nor does it count for the extents.
        assert!((solid(&model).size().x - solid(&ball).size().x).abs() < 1e-12);
        // The same where the ball itself has a hole.
        model.triangles.remove(100);
        model.parts[0].triangles.end -= 1;
        model.parts[1].triangles = model.parts[0].triangles.end..model.triangles.len();
        let said = holds(&model, volume);
        assert!(said.contains(&expected) && said.contains("1 hole with 3 open edges"), "{said}");
    }
}

#[test]
fn pieces_far_apart_count_by_themselves() {
    let ball = sphere(8, 0.01);
    holds(&joined(&[&ball, &moved(&ball, DVec3::new(1e4, 0.0, 300.0))]), 2.0 * solid(&ball).volume);
}

#[test]
fn patches_with_gaps_between_them_enclose_something_together() {
    let ball = sphere(16, 0.5);
    let shrunk = ball.triangles.iter().flat_map(|t| {
        let corners = t.map(|i| ball.positions[i as usize]);
        let middle = corners.iter().sum::<DVec3>() / 3.0;
        corners.map(|corner| middle + 0.97 * (corner - middle))
    });
    let positions: Vec<DVec3> = shrunk.collect();
    let triangles = (0..ball.triangles.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    holds(&single(positions, triangles), solid(&ball).volume);
}

/// Many pieces in a row along each axis: a place is inside if it is in any of them, however many lie before and behind
/// it.
#[test]
fn places_in_a_long_row_of_pieces_are_told_from_those_beside_it() {
    let corner = |k: u32, axis: usize, apart: f64| {
        let mut at = [0.0, 0.01 * f64::from(k % 5), 0.0];
        at[axis] += apart * f64::from(k);
        DVec3::from_array(at)
    };
    for axis in 0..3 {
        for apart in [0.8, 1.3] {
            let one = cube([0.5; 3], 1.0);
            let cubes: Vec<_> = (0..120).map(|k| moved(&one, corner(k, axis, apart))).collect();
            let solid = solid(&joined(&cubes.iter().collect::<Vec<_>>()));
            let mut inside = 0;
            for k in 0..3000_u32 {
                let share = |step: f64| (f64::from(k + 1) * step).fract();
                let mut at = DVec3::new(share(0.618), share(0.754_87), share(0.569_84)) * 1.2 - 0.1;
                at[axis] += apart * 119.0 * share(0.831_43);
                let expected = (0..120).any(|k| {
                    let within = at - corner(k, axis, apart);
                    within.cmpgt(DVec3::ZERO).all() && within.cmplt(DVec3::ONE).all()
                });
                assert_eq!(solid.contains(at), expected, "{axis} {apart}: {at}");
                inside += u32::from(expected);
            }
            assert!((500..2900).contains(&inside), "{inside}");
        }
    }
}
