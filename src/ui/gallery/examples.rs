//! The scenes that ship, within the program, so that they are there from whatever folder it is started.

use crate::io::{IoError, load_assets_by, read_model, scene_from_json};
use crate::scene::{Assets, Scene};

/// A scene that ships.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// Its file's name, without the ending.
    pub name: &'static str,
    /// Name a person reads.
    pub title: &'static str,
    /// What to look at.
    pub line: &'static str,
    /// The group in which it stands.
    pub group: Group,
    scene: &'static str,
    /// A picture of it as a PNG file.
    pub(super) picture: &'static [u8],
}

/// What examples are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// What to see first.
    Start,
    /// The fibre paper.
    Fibres,
    /// The two-layer paper.
    TwoLayer,
}

impl Group {
    /// All groups in their order.
    pub const ALL: [Self; 3] = [Self::Start, Self::Fibres, Self::TwoLayer];

    /// What it is called.
    pub fn title(self) -> &'static str {
        match self {
            Self::Start => "Start",
            Self::Fibres => "Fibres (figures 6-10, Table 1)",
            Self::TwoLayer => "Two-layer bodies",
        }
    }
}

/// The models that the scenes name, by their files' names.
const MODELS: [(&str, &[u8]); 7] = [
    ("leaf.glb", include_bytes!("../../../assets/leaf.glb")),
    ("long_bar.glb", include_bytes!("../../../assets/long_bar.glb")),
    ("plant.glb", include_bytes!("../../../assets/plant.glb")),
    ("short_bar.glb", include_bytes!("../../../assets/short_bar.glb")),
    ("thick_leaf.glb", include_bytes!("../../../assets/thick_leaf.glb")),
    ("thick_plant.glb", include_bytes!("../../../assets/thick_plant.glb")),
    ("tube.glb", include_bytes!("../../../assets/tube.glb")),
];

impl Example {
    /// The example of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        EXAMPLES.iter().find(|example| example.name == name)
    }

    /// The scene and the models that it names. Those lie in no folder: the scene names them by their files' names alone.
    ///
    /// # Errors
    /// None for what ships.
    pub fn load(&self) -> Result<(Scene, Assets), IoError> {
        let mut scene = scene_from_json(self.scene)?;
        for path in scene.model_paths_mut() {
            *path = file_name(path).to_owned();
        }
        let assets = shipped_assets(&scene)?;
        Ok((scene, assets))
    }
}

/// The models of a scene that names none but those that ship, by their files' names.
///
/// # Errors
/// Another one is named.
pub(crate) fn shipped_assets(scene: &Scene) -> Result<Assets, IoError> {
    load_assets_by(scene, &|path| {
        let bytes = path.to_str().and_then(shipped).ok_or(IoError::Missing)?;
        read_model(path, bytes)
    })
}

/// The bytes of a model that ships, by its file's name.
pub(super) fn shipped(name: &str) -> Option<&'static [u8]> {
    MODELS.iter().find(|(known, _)| *known == name).map(|(_, bytes)| *bytes)
}

/// What follows the last slash.
fn file_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

macro_rules! examples {
    ($($group:ident $name:literal, $title:literal: $line:literal;)*) => {
        /// Every example, in the order in which they are shown.
        pub static EXAMPLES: &[Example] = &[$(Example {
            name: $name,
            title: $title,
            line: $line,
            group: Group::$group,
            scene: include_str!(concat!("../../../scenes/", $name, ".json")),
            picture: include_bytes!(concat!("../../../assets/examples/", $name, ".png")),
        },)*];
    };
}

examples! {
    Start "short_bar_soft", "Soft bar": "Four helices twist it as it lands, and it swings back.";
    Start "figure_08c_soft", "A plant that is struck": "Fibres up the stem and into the leaves let it stand and swing.";
    Start "figure_10_soft", "A snapping stalk": "The fibre breaks where it turns too far, and the leaf hangs.";
    Start "two_layer_ball_on_bar", "A ball on the bar": "A gas-filled ball comes to rest on a fibre solid: both give.";
    Fibres "figure_06_without_soft", "Figure 6, without fibres":
        "Squeezed as it lands, and neither sheared nor twisted.";
    Fibres "figure_06a_soft", "Figure 6, strengthened": "Upright fibres: it lands and keeps its height.";
    Fibres "figure_06b_soft", "Figure 6, sheared": "Slanted fibres: its top slides to the right.";
    Fibres "figure_06c_soft", "Figure 6, twisted": "Helical fibres: its top turns against its foot.";
    Fibres "figure_07_without_soft", "Figure 7, without fibres": "Under the panel it is only squeezed.";
    Fibres "figure_07a_soft", "Figure 7, straight": "A fibre on the right: it bends to the left, away from it.";
    Fibres "figure_07b_soft", "Figure 7, slanted": "The top goes to the right, along the lean.";
    Fibres "figure_07c_soft", "Figure 7, C": "It bends once, and its top goes far to the right.";
    Fibres "figure_07d_soft", "Figure 7, S": "The lower half bends one way, the upper half the other.";
    Fibres "figure_08a_soft", "Figure 8, over-compliant": "Without fibres it cannot carry its leaves and falls.";
    Fibres "figure_08b_soft", "Figure 8, over-stiff": "It shakes as a whole, and its leaves keep their shape.";
    Fibres "figure_08d_soft", "Figure 8, more at the foot": "Upright at its foot: the swing begins above.";
    Fibres "figure_09a_soft", "Figure 9, over-compliant": "Without fibres the leaf hangs straight down.";
    Fibres "figure_09b_soft", "Figure 9, over-stiff": "It hardly moves, and it moves as a whole.";
    Fibres "figure_09c_soft", "Figure 9, veined": "The veins carry it, and between them it stays soft.";
    Fibres "figure_10_without_soft", "Figure 10, a stalk that holds": "Struck alike, it nods and swings back up.";
    Fibres "short_bar", "Table 1, short bar": "588 particles and four fibres: it hardly shortens.";
    Fibres "long_bar", "Table 1, long bar": "Pushed down from above, it bends away from its two fibres.";
    Fibres "plant", "Table 1, plant": "2724 particles and five fibres: a push makes it swing.";
    Fibres "leaf", "Table 1, leaf": "1159 particles and five fibres, held by its stalk.";
    Fibres "short_bar_mesh", "Short bar from a mesh": "The same bar, filled from a mesh with round edges.";
    Fibres "figure_06_without", "Figure 6, without, as printed":
        "Table 1's stiffness: all is over within milliseconds.";
    Fibres "figure_06a", "Figure 6, strengthened, as printed": "Height lost: 2.7 %, where it is 8.1 % without fibres.";
    Fibres "figure_06b", "Figure 6, sheared, as printed": "Sheared by 10 mm along the slant.";
    Fibres "figure_06c", "Figure 6, twisted, as printed": "Twisted by 16 degrees.";
    Fibres "figure_07_without", "Figure 7, without, as printed": "Tip and middle stay on the axis.";
    Fibres "figure_07a", "Figure 7, straight, as printed": "The tip goes 1.2 mm away from the fibre.";
    Fibres "figure_07b", "Figure 7, slanted, as printed": "The tip goes 3.2 mm along the lean.";
    Fibres "figure_07c", "Figure 7, C, as printed": "The middle gives way along the bulge.";
    Fibres "figure_07d", "Figure 7, S, as printed": "Both halves bend.";
    Fibres "figure_08a", "Figure 8, over-compliant, as printed": "Table 1's matrix alone: it goes down within 0.3 s.";
    Fibres "figure_08b", "Figure 8, over-stiff, as printed": "A thousand times as stiff: it hardly moves.";
    Fibres "figure_08c", "Figure 8, with fibres, as printed": "Three strands side by side hold the stem: it swings.";
    Fibres "figure_08d", "Figure 8, more at the foot, as printed":
        "Crossed helices around its foot: that stays upright.";
    Fibres "figure_09a", "Figure 9, over-compliant, as printed": "Table 1's leaf without fibres nods by 37 mm.";
    Fibres "figure_09b", "Figure 9, over-stiff, as printed": "Ten times as stiff: 3.7 mm, and nothing bends.";
    Fibres "figure_09c", "Figure 9, veined, as printed": "Two strands, one above the other, carry it: 4.8 mm.";
    Fibres "figure_10", "Figure 10, a snapping stalk, as printed":
        "Its upper strand tears: the leaf goes down twice as far.";
    Fibres "figure_10_without", "Figure 10, a stalk that holds, as printed": "Struck alike, it nods half as far.";
    Fibres "press_short_bar", "Press of the short bar": "The force at 2 %: 1950 N at rest.";
    Fibres "cantilever", "Cantilever": "Sags under its own weight, within 5 % of Timoshenko.";
    Fibres "free_flight", "Free flight": "Spins and rings in nothing: momenta stay to round-off.";
    TwoLayer "two_layer_1d", "Segment": "The body of one dimension: two particles and a spring.";
    TwoLayer "two_layer_2d", "Ring": "Ten particles a layer and gas inside, dropped in a box.";
    TwoLayer "two_layer_3d", "Ball": "An octahedron subdivided once, dropped in a box.";
    TwoLayer "two_layer_mesh", "An inner tube": "Any closed mesh as a two-layer body: it bounces and stays round.";
    TwoLayer "two_layer_figure_10", "Figure 10, the ring dragged": "Pulled to a point, let go at 4 s, at rest by 12 s.";
    TwoLayer "two_layer_figure_11", "Figure 11, the ball dragged": "The same in three dimensions.";
    TwoLayer "two_layer_figure_12", "Figure 12, a step of 0.003 s":
        "Euler, midpoint and Runge-Kutta: all three are stable.";
    TwoLayer "two_layer_figure_13", "Figure 13, a step of 0.03 s": "Under Euler the body blows up and is stopped.";
    TwoLayer "two_layer_figure_14", "Figure 14, a step of 0.3 s": "Only under Runge-Kutta does it not blow up.";
    TwoLayer "two_layer_figure_15", "Figure 15, subdivided twice": "A finer ball: 132 particles.";
    TwoLayer "two_layer_subdivisions", "Subdivisions 0 to 3": "The same springs and mass in 12 to 516 particles.";
    TwoLayer "two_layer_collapse", "Collapse without gas": "Two layers stand, a single one falls flat.";
    TwoLayer "two_layer_density", "Density of the layers": "A heavy core has half the inertia of a heavy skin.";
    TwoLayer "two_layer_opposite_motion", "Opposite motion": "The heavy inner layer goes on as the outer one stops.";
    TwoLayer "two_layer_one_against_two", "One layer against two": "Under Euler one layer blows up where two hold.";
    TwoLayer "two_layer_collision", "Two balls collide": "They meet and part, and their momentum stays.";
    TwoLayer "two_layer_balloon", "A balloon half filled":
        "Released on its side, it rolls until the heavy half is below.";
    TwoLayer "two_layer_stability_soft", "Stability, soft and light":
        "For comparing integrators: Euler blows up at 0.03 s.";
    TwoLayer "two_layer_stability_stiff", "Stability, stiff and heavy":
        "For comparing integrators: all are stable at 0.003 s.";
}
