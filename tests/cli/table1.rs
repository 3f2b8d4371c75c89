//! The paper's Table 1, measured again.

use super::{Desk, pressed};
use std::path::Path;

#[test]
fn four_rows_stand_beside_the_papers() {
    let desk = Desk::new(&pressed());
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    // A name with a space in it would be split by the desk.
    let out = desk.done(&format!("table1 --scenes {} --report rows.json", scenes.display()));
    let rows = desk.json("rows.json");
    let rows = rows.as_array().unwrap();
    let expected =
        [("Short bar", 588, [4, 52]), ("Long bar", 375, [2, 28]), ("Plant", 2723, [5, 90]), ("Leaf", 1159, [5, 86])];
    assert_eq!(rows.len(), expected.len());
    for (row, (model, particles, fibres)) in rows.iter().zip(expected) {
        assert_eq!(row["model"], model);
        let share = row["particles"].as_f64().unwrap() / f64::from(particles);
        assert!((share - 1.0).abs() < 0.02, "{model}: {row}");
        assert_eq!([&row["fibres"], &row["structure_particles"]], fibres, "{model}: {row}");
        for name in ["matrix_ms", "fibre_ms", "dt", "real_time_factor"] {
            assert!(row[name].as_f64().unwrap() > 0.0, "{model}: {name} of {row}");
        }
    }
    for (model, chosen) in [(0, "leap_frog"), (1, "tr_bdf2"), (2, "fibres_implicit"), (3, "tr_bdf2")] {
        assert_eq!(rows[model]["integrator"], chosen);
        let shares = rows[model]["shares"].as_array().unwrap();
        let words: Vec<&str> = shares.iter().map(|share| share["integrator"].as_str().unwrap()).collect();
        assert!(words.contains(&"leap_frog") && words.contains(&chosen), "{words:?}");
        assert!(shares.iter().all(|share| share["real_time_factor"].as_f64().unwrap() > 0.0), "{shares:?}");
    }
    // Head, rule and two lines a model; what each integrator reaches; where the report went.
    let lines: Vec<&str> = out.lines().collect();
    assert!(lines.len() >= 12 + 3 + 4 * 2, "{out}");
    assert!(lines[2].starts_with("| Short bar | here | 588 | 4 / 52 |"), "{out}");
    assert_eq!(lines[3], "| | paper | 588 | 4 / 52 | 1.755 | 0.07200 | 4.1 % | | |");
}

#[test]
fn missing_scenes_are_named() {
    let desk = Desk::new(&pressed());
    let said = desk.refused("table1 --report rows.json");
    assert!(said.contains("short_bar.json") && said.contains("leaf.json") && said.contains("--scenes DIR"), "{said}");
}
