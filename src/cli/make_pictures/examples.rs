//! When each scene that ships shows best what it is about.

/// A scene and the time of its picture, or pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ExamplePicture {
    /// Its file's name, without the ending.
    pub name: &'static str,
    /// When the picture is taken [s].
    pub at: f64,
    /// When the last one of a strip is taken [s]; none where there is one picture.
    pub until: Option<f64>,
    /// Whether the body as it started stands behind it, so that twins show how far each has moved.
    pub beside_start: bool,
}

const fn at(name: &'static str, at: f64) -> ExamplePicture {
    ExamplePicture { name, at, until: None, beside_start: false }
}

const fn beside_start(name: &'static str, at: f64) -> ExamplePicture {
    ExamplePicture { name, at, until: None, beside_start: true }
}

/// A strip from one time to another [s], over and over.
const fn strip(name: &'static str, at: f64, until: f64) -> ExamplePicture {
    ExamplePicture { name, at, until: Some(until), beside_start: false }
}

/// Every scene that ships.
pub(super) const EXAMPLES: [ExamplePicture; 92] = [
    strip("alive_ball", 0.5, 5.5),
    strip("alive_character", 0.4, 2.6),
    strip("alive_fish", 1.0, 3.0),
    strip("alive_gripper", 0.0, 2.4),
    strip("alive_heart", 0.8, 1.533),
    strip("alive_leaf", 2.5, 3.5),
    strip("alive_octopus", 0.0, 6.0),
    strip("alive_worm", 1.0, 2.1),
    strip("alive_worm_back", 1.0, 2.1),
    at("cantilever", 1.0),
    at("collider_carry", 2.0),
    beside_start("collider_steps", 0.4),
    at("figure_06_without", 0.002),
    at("figure_06_without_soft", 0.033),
    at("figure_06a", 0.002),
    at("figure_06a_soft", 0.033),
    at("figure_06b", 0.002),
    at("figure_06b_soft", 0.12),
    at("figure_06c", 0.002),
    at("figure_06c_soft", 0.12),
    at("figure_07_without", 0.008),
    at("figure_07_without_soft", 0.5),
    at("figure_07a", 0.008),
    at("figure_07a_soft", 0.5),
    at("figure_07b", 0.008),
    at("figure_07b_soft", 0.5),
    at("figure_07c", 0.008),
    at("figure_07c_soft", 0.5),
    at("figure_07d", 0.008),
    at("figure_07d_soft", 0.5),
    beside_start("figure_08a", 0.28),
    beside_start("figure_08a_soft", 1.0),
    beside_start("figure_08b", 0.28),
    beside_start("figure_08b_soft", 0.3),
    beside_start("figure_08c", 0.28),
    beside_start("figure_08c_soft", 0.35),
    beside_start("figure_08d", 0.28),
    beside_start("figure_08d_soft", 0.35),
    beside_start("figure_09a", 0.108),
    beside_start("figure_09a_soft", 0.6),
    beside_start("figure_09b", 0.07),
    beside_start("figure_09b_soft", 0.6),
    beside_start("figure_09c", 0.075),
    beside_start("figure_09c_soft", 0.6),
    beside_start("figure_10", 0.04),
    beside_start("figure_10_soft", 0.3),
    beside_start("figure_10_without", 0.02),
    beside_start("figure_10_without_soft", 0.3),
    at("free_flight", 0.05),
    at("leaf", 0.01),
    at("long_bar", 0.02),
    at("plant", 0.01),
    at("plastic_dent", 1.4),
    at("plastic_dent_without", 1.4),
    beside_start("plastic_wire", 2.3),
    beside_start("plastic_wire_without", 2.3),
    at("press_short_bar", 0.01),
    at("regions_belly", 0.02),
    at("regions_without", 0.02),
    at("seam_tear", 0.45),
    at("seam_without", 0.45),
    at("sheet_fin", 2.1),
    at("sheet_fin_without", 2.1),
    at("sheet_sandwich", 2.0),
    at("sheet_sandwich_without", 2.0),
    at("short_bar", 0.003),
    at("short_bar_mesh", 0.003),
    at("short_bar_soft", 0.16),
    at("two_layer_1d", 0.9),
    at("two_layer_2d", 1.2),
    at("two_layer_3d", 1.2),
    at("two_layer_ball_on_bar", 0.55),
    at("two_layer_balloon", 2.0),
    at("two_layer_collapse", 6.0),
    at("two_layer_collision", 1.5),
    at("two_layer_density", 1.0),
    at("two_layer_figure_10", 3.0),
    at("two_layer_figure_11", 3.0),
    at("two_layer_figure_12", 1.5),
    at("two_layer_figure_13", 1.5),
    at("two_layer_figure_14", 12.0),
    at("two_layer_figure_15", 1.0),
    at("two_layer_mesh", 0.9),
    at("two_layer_one_against_two", 5.0),
    at("two_layer_opposite_motion", 0.8),
    at("two_layer_stability_soft", 10.0),
    at("two_layer_stability_stiff", 1.0),
    at("two_layer_subdivisions", 0.9),
    at("viscous_block", 0.2),
    at("viscous_without", 0.2),
    at("void_bores", 0.45),
    at("void_without", 0.45),
];

#[cfg(test)]
mod tests {
    use super::EXAMPLES;
    use crate::cli::make_pictures::gallery::{EXAMPLE, EXAMPLE_FRAMES};
    use crate::io::load_scene;
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    #[test]
    fn every_scene_that_ships_has_its_picture_taken_while_it_runs() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
        let shipped: BTreeSet<String> = fs::read_dir(&folder)
            .expect("the scenes")
            .map(|entry| entry.expect("a file").path())
            .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
            .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
            .collect();
        assert_eq!(EXAMPLES.len(), shipped.len(), "each stands once");
        assert_eq!(EXAMPLES.iter().map(|example| example.name.to_owned()).collect::<BTreeSet<_>>(), shipped);
        for example in EXAMPLES {
            let scene = load_scene(&folder.join(format!("{}.json", example.name))).expect("a scene that loads");
            let last = example.until.unwrap_or(example.at);
            assert!(last > 0.0 && last <= scene.time.duration + 1e-9, "{} at {last} s", example.name);
            assert!((0.0..=last).contains(&example.at), "{} at {} s", example.name, example.at);
            let picture = folder.join(format!("../assets/examples/{}.png", example.name));
            let bytes = fs::read(picture).unwrap_or_else(|error| panic!("{}: {error}", example.name));
            // Width and height stand at the head of a PNG file.
            let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
            let frames = if example.until.is_some() { EXAMPLE_FRAMES } else { 1 };
            assert_eq!([number(16), number(20)], [EXAMPLE[0], frames * EXAMPLE[1]], "{}", example.name);
        }
    }
}
