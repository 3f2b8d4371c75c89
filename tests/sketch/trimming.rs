//! What is left of a fibre that leaves the solid.

use glam::DVec3;
use sinew::sketch::{Placed, SketchError, trim};

const H: f64 = 0.1;

/// Particles 0.4 h apart on a line: '#' embedded, '.' not.
fn placed(pattern: &str) -> Vec<Placed> {
    let particle = |(i, mark)| Placed {
        point: DVec3::new(0.4 * H * i as f64, 0.0, 0.0),
        embedded: mark == '#',
        distance: if mark == '#' { 0.2 } else { 3.12 },
    };
    pattern.chars().enumerate().map(particle).collect()
}

/// The runs as indices, and the notes as text.
fn trimmed(pattern: &str) -> (Vec<Vec<usize>>, Vec<String>) {
    let trimmed = trim(&placed(pattern), H).unwrap_or_else(|error| panic!("{error}"));
    let indices = |run: &Vec<DVec3>| run.iter().map(|point| (point.x / (0.4 * H)).round() as usize).collect();
    (trimmed.runs.iter().map(indices).collect(), trimmed.notes.iter().map(ToString::to_string).collect())
}

#[test]
fn a_fibre_inside_stays_whole() {
    assert_eq!(trimmed("####"), (vec![vec![0, 1, 2, 3]], vec![]));
}

#[test]
fn ends_outside_are_trimmed() {
    let (runs, notes) = trimmed("...#########....");
    assert_eq!(runs, [(3..12).collect::<Vec<_>>()]);
    assert_eq!(notes, ["7 of 16 points outside the solid were trimmed"]);
    assert_eq!(trimmed("###.").1, ["1 of 4 points outside the solid was trimmed"]);
}

#[test]
fn a_gap_up_to_h_is_bridged_and_a_wider_one_splits() {
    // One particle missing leaves 0.8 h, two leave 1.2 h.
    assert_eq!(trimmed("###.###").0, [vec![0, 1, 2, 4, 5, 6]]);
    let (runs, notes) = trimmed("###..####");
    assert_eq!(runs, [vec![0, 1, 2], vec![5, 6, 7, 8]]);
    assert_eq!(
        notes,
        ["2 of 9 points outside the solid were trimmed", "The fibre leaves the solid on its way and was split into 2"]
    );
}

#[test]
fn embedded_neighbours_never_part_however_far() {
    let mut particles = placed("#####");
    for particle in &mut particles {
        particle.point *= 10.0;
    }
    assert_eq!(trim(&particles, H).map(|trimmed| trimmed.runs.len()), Ok(1));
}

#[test]
fn short_runs_are_dropped_with_their_figure() {
    let (runs, notes) = trimmed("####..##");
    assert_eq!(runs, [vec![0, 1, 2, 3]]);
    assert_eq!(notes[1..], ["1 piece of 2 points was dropped: a fibre needs 3"]);
    let notes = trimmed("#..####..##").1;
    assert_eq!(notes[1..], ["2 pieces, 3 points in all, were dropped: a fibre needs 3 points in a row"]);
}

#[test]
fn a_fibre_outside_is_discarded_with_its_distance() {
    let message = |particles: &[Placed]| trim(particles, H).expect_err("discarded").to_string();
    assert_eq!(message(&placed("......")), "Fibre discarded: nearest material 3.1 h away");
    let mut near = placed("....");
    near[2].distance = 0.3;
    assert_eq!(message(&near), "Fibre discarded: too little material around it (nearest 0.3 h away). Draw it deeper");
    assert_eq!(message(&[]), "Fibre discarded: there is no material at all");
    assert_eq!(
        message(&placed("##..##..")),
        "Fibre discarded: only 4 of 8 points lie in enough material, and no 3 in a row. Draw it deeper"
    );
    assert_eq!(trim(&placed("#..#"), H), Err(SketchError::Stranded { embedded: 2, total: 4 }));
}
