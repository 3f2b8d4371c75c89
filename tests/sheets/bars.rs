//! What sheets add to the stiffness of a bar: of a sandwich's two, of one in the middle, of one on edge.

use crate::common::*;
use crate::statics::Statics;
use glam::DVec3;
use sinew::scene::{Body, Sheet, SheetStiffness};

const E: f64 = 1e5;
/// Et [N/m], bending stiffness [N m] and volume fraction of the figures, in units of E and D.
const ET: f64 = 40.0 * E * D;
const SHARE: f64 = 0.25;
/// Layers across and along.
const ACROSS: u32 = 5;
const ALONG: u32 = 15;
/// Extent of a sheet's vertices across [m].
const WIDTH: f64 = 4.0 * D;

/// A sheet in a plane across x, as wide as the particles.
fn upright(x: f64, stiffness: &SheetStiffness) -> Sheet {
    let row = |k: u32| (0..ACROSS).map(|i| [x * D, D * (f64::from(k) + 0.5), D * (f64::from(i) - 2.0)]).collect();
    let sheet = Sheet::grid(format!("at {x}"), (0..ALONG).map(row).collect());
    sheet.with_stiffness(stiffness.clone()).with_volume_fraction(SHARE)
}

fn bar(at: &[f64], stiffness: &SheetStiffness) -> Body {
    let bar = block([ACROSS, ALONG, ACROSS], E);
    at.iter().fold(bar, |bar, &x| bar.with_sheet(upright(x, stiffness)))
}

/// What bending is about.
#[derive(Clone, Copy, Debug)]
enum Load {
    Pull,
    /// Fibres along y are longer where this axis is greater.
    Bend(usize),
}

/// Stiffness at mid bar between ends that are pulled [N], or turned against each other [N m²].
fn stiffness(body: Body, load: Load) -> f64 {
    let baked = baked(&in_space(body));
    let mut statics = Statics::of(&baked.world.bodies()[0]);
    let rest = statics.rest().to_vec();
    let layer = |x: &DVec3| (x.y / D).floor() as u32;
    let arm = |x: &DVec3| match load {
        Load::Pull => 1.0,
        Load::Bend(axis) => x[axis],
    };
    let scale = match load {
        Load::Pull => 1e-3 * D,
        Load::Bend(_) => 1e-3,
    };
    let is_end = |x: &DVec3| layer(x) == 0 || layer(x) == ALONG - 1;
    let side = |x: &DVec3| if layer(x) == 0 { -1.0 } else { 1.0 };
    let given: Vec<DVec3> =
        rest.iter().map(|x| if is_end(x) { DVec3::Y * side(x) * scale * arm(x) } else { DVec3::ZERO }).collect();
    let held: Vec<[bool; 3]> = rest.iter().map(|x| [false, is_end(x), false]).collect();
    let u = statics.solved(&given, &held);
    let resisted = statics.resisted(&u);
    let load: f64 = rest.iter().zip(&resisted).filter(|(x, _)| layer(x) == ALONG - 1).map(|(x, f)| arm(x) * f.y).sum();
    // Mean displacement or turn of a section.
    let section = |k: u32| {
        let of = rest.iter().zip(&u).filter(|(x, _)| layer(x) == k);
        let (sum, square) = of.fold((0.0, 0.0), |(sum, square), (x, u)| (sum + arm(x) * u.y, square + arm(x) * arm(x)));
        sum / square
    };
    let (from, to) = (5, ALONG - 6);
    load * D * f64::from(to - from) / (section(to) - section(from))
}

/// What sheets of a stiffness add to that of a bar in which they take their share and carry nothing.
fn added(at: &[f64], of: &SheetStiffness, load: Load) -> (f64, f64) {
    let without = stiffness(bar(at, &SheetStiffness::new(0.0, 0.0)), load);
    (stiffness(bar(at, of), load) - without, without)
}

#[test]
fn two_sheets_make_a_sandwich() {
    let of = SheetStiffness::new(ET, 0.0);
    let (at, d) = ([-1.5, 1.5], 1.5 * D);
    let (pull, _) = added(&at, &of, Load::Pull);
    let expected = 2.0 * SHARE * ET * WIDTH;
    println!("EA {:.4}", pull / expected);
    assert!((pull / expected - 1.0).abs() < 0.02, "EA: {pull} N, not {expected} N");
    let (bend, shared) = added(&at, &of, Load::Bend(0));
    println!("EI {:.4}", bend / (expected * d * d));
    assert!((bend / (expected * d * d) - 1.0).abs() < 0.02, "EI: {bend}, not {}", expected * d * d);
    let bare = stiffness(bar(&[], &of), Load::Bend(0));
    println!("EI {:.3} of the bare bar's, {:.3} of which is left to the matrix", (bend + shared) / bare, shared / bare);
    assert!((shared / bare - 0.80).abs() < 0.02, "{}", shared / bare);
    assert!((bend + shared) / bare > 4.2, "{}", (bend + shared) / bare);
}

#[test]
fn a_sheet_in_the_middle_pulls_and_does_not_bend() {
    let of = SheetStiffness::new(ET, 0.0);
    let expected = SHARE * ET * WIDTH;
    let (pull, _) = added(&[0.0], &of, Load::Pull);
    let (bend, matrix) = added(&[0.0], &of, Load::Bend(0));
    println!("EA {:.4}, EI {:+.5} of the matrix's", pull / expected, bend / matrix);
    assert!((pull / expected - 1.0).abs() < 0.02, "EA: {pull} N, not {expected} N");
    assert!(bend.abs() < 2e-3 * matrix, "EI: {bend} beside {matrix}");
}

#[test]
fn a_sheet_on_edge_bends_as_its_four_squares_do() {
    let of = SheetStiffness::new(ET, 0.0);
    let (bend, _) = added(&[0.0], &of, Load::Bend(2));
    let ratio = bend / (SHARE * ET * WIDTH.powi(3) / 12.0);
    println!("EI on edge {ratio:.4}");
    // Strain is constant over each of the four: 1.22.
    assert!((ratio - 1.22).abs() < 0.03, "{ratio}");
}

#[test]
fn hinges_alone_bend_as_a_plate() {
    let stiff = 20.0 * E * D.powi(3);
    let (bend, _) = added(&[0.0], &SheetStiffness::new(0.0, stiff), Load::Bend(0));
    let ratio = bend / (SHARE * stiff * WIDTH);
    println!("EI of hinges {ratio:.4}");
    assert!((ratio - 1.04).abs() < 0.03, "{ratio}");
}
