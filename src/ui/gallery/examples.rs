//! The scenes that ship, within the program, so that they are there from whatever folder it is started.

use crate::io::{IoError, load_assets_by, scene_from_json};
use crate::scene::{Assets, Scene};

/// A scene that ships.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// Its file's name, without the ending.
    pub name: &'static str,
    /// Name a person reads.
    pub title: &'static str,
    /// The figure or table of the paper that it shows; empty where it shows none.
    pub source: &'static str,
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
    /// Fibres that act.
    Alive,
    /// Matter with holes or sheets, that yields or flows, and what it touches.
    Matter,
    /// The fibre paper.
    Fibres,
    /// The two-layer paper.
    TwoLayer,
}

impl Group {
    /// All groups in their order.
    pub const ALL: [Self; 5] = [Self::Start, Self::Alive, Self::Matter, Self::Fibres, Self::TwoLayer];

    /// What it is called.
    pub fn title(self) -> &'static str {
        match self {
            Self::Start => "Start",
            Self::Alive => "Fibres that act",
            Self::Matter => "Matter and colliders",
            Self::Fibres => "Fibres",
            Self::TwoLayer => "Two-layer bodies",
        }
    }
}

/// The models that the scenes name, by their files' names.
const MODELS: [(&str, &[u8]); 8] = [
    ("character.glb", include_bytes!("../../../assets/character.glb")),
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

    /// The scene and the models that it names. Those lie in no folder: the scene names them by their files' names
    /// alone.
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
    load_assets_by(scene, &|path| path.to_str().and_then(shipped).map(<[u8]>::to_vec).ok_or(IoError::Missing))
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
    ($($group:ident $name:literal, $title:literal, $source:literal: $line:literal;)*) => {
        /// Every example, in the order in which they are shown.
        pub static EXAMPLES: &[Example] = &[$(Example {
            name: $name,
            title: $title,
            source: $source,
            line: $line,
            group: Group::$group,
            scene: include_str!(concat!("../../../scenes/", $name, ".json")),
            picture: include_bytes!(concat!("../../../assets/examples/", $name, ".png")),
        },)*];
    };
}

examples! {
    Start "short_bar_soft", "A twisting bar", "": "Four helices twist it as it lands, and it swings back.";
    Start "figure_08c_soft", "A plant that is struck", "Figure 8c":
        "Fibres up the stem and into the leaves let it stand and swing.";
    Start "figure_10_soft", "A snapping stalk", "Figure 10":
        "The fibre breaks where it turns too far, and the leaf hangs.";
    Start "two_layer_ball_on_bar", "A ball on the bar", "":
        "A gas-filled ball comes to rest on a fibre solid: both give.";
    Alive "alive_character", "A figure on a skeleton", "": "It bows and waves, and its soft ears lag and settle.";
    Alive "alive_worm", "A worm", "": "A wave along its fibres lets it crawl to the right by friction.";
    Alive "alive_worm_back", "A worm that crawls back", "": "The wave turned round: it crawls to the left, as far.";
    Alive "alive_heart", "A heart", "": "Rings of fibres contract in a beat that repeats.";
    Alive "alive_gripper", "A gripper", "": "Two fingers curl round a ball, lift it and hold it by friction.";
    Alive "alive_octopus", "An arm", "": "Oblique fibres twist it both ways, and others curl it up.";
    Alive "alive_ball", "A rolling ball", "": "Its springs shorten in turns, and it rolls by friction.";
    Alive "alive_leaf", "A leaf in the wind", "": "Held by its stalk in a steady wind, it flutters.";
    Alive "alive_fish", "A fish", "": "A wave from head to tail pushes water aside, and it swims.";
    Matter "collider_steps", "A bar on steps", "": "It falls on a ball and tumbles down three steps.";
    Matter "collider_carry", "A bar that is carried", "": "Two fingers lift it and carry it along by friction alone.";
    Matter "void_bores", "A bored bar", "": "Two bores cross in it: landing, it is squeezed further.";
    Matter "void_without", "The bar without bores", "": "Solid, it keeps more of its height.";
    Matter "sheet_sandwich", "A sandwich", "": "A sheet above and one below let it sag a third as far.";
    Matter "sheet_sandwich_without", "The bar without sheets", "": "Alone it hangs down.";
    Matter "sheet_fin", "A beating fin", "": "Two sheets carry it and pull in turns: it beats up and down.";
    Matter "sheet_fin_without", "The fin without sheets", "": "Nothing carries it: it hangs down.";
    Matter "seam_tear", "A strip that tears", "": "It is torn off along a wavy line that was drawn through it.";
    Matter "seam_without", "The strip without a seam", "": "Bent as far, it stays whole.";
    Matter "regions_belly", "A soft belly", "": "Under a hard shell: it lands, bulges, and the shell holds.";
    Matter "regions_without", "A block of one material", "": "It lands as fast and is squeezed evenly.";
    Matter "plastic_dent", "A dent in clay", "": "A stamp leaves a dent that stays.";
    Matter "plastic_dent_without", "No dent in rubber", "": "The same stamp: all of it springs back.";
    Matter "plastic_wire", "A bent wire", "": "The wire in the arm yields: the arm keeps its pose.";
    Matter "plastic_wire_without", "A springy wire", "": "The same arm springs back up.";
    Matter "viscous_block", "A block like dough", "": "It lands and hardly bounces.";
    Matter "viscous_without", "A block like rubber", "": "It lands as fast and bounces.";
    Fibres "figure_06_without_soft", "A bar without fibres", "Figure 6":
        "Squeezed as it lands, and neither sheared nor twisted.";
    Fibres "figure_06a_soft", "A bar that keeps its height", "Figure 6a":
        "Upright fibres: it lands and keeps its height.";
    Fibres "figure_06b_soft", "A shearing bar", "Figure 6b": "Slanted fibres: its top slides to the right.";
    Fibres "figure_06c_soft", "A bar that turns its top", "Figure 6c":
        "Helical fibres: its top turns against its foot.";
    Fibres "figure_07_without_soft", "A pressed bar without fibres", "Figure 7": "Under the panel it is only squeezed.";
    Fibres "figure_07a_soft", "A bar that bends away", "Figure 7a":
        "A fibre on the right: it bends to the left, away from it.";
    Fibres "figure_07b_soft", "A leaning bar", "Figure 7b": "The top goes to the right, along the lean.";
    Fibres "figure_07c_soft", "A bar that bends like a C", "Figure 7c":
        "It bends once, and its top goes far to the right.";
    Fibres "figure_07d_soft", "A bar that bends like an S", "Figure 7d":
        "The lower half bends one way, the upper half the other.";
    Fibres "figure_08a_soft", "A limp plant", "Figure 8a": "Without fibres it cannot carry its leaves and falls.";
    Fibres "figure_08b_soft", "A plant too stiff", "Figure 8b":
        "It shakes as a whole, and its leaves keep their shape.";
    Fibres "figure_08d_soft", "A plant with a firm foot", "Figure 8d": "Upright at its foot: the swing begins above.";
    Fibres "figure_09a_soft", "A limp leaf", "Figure 9a": "Without fibres the leaf hangs straight down.";
    Fibres "figure_09b_soft", "A leaf too stiff", "Figure 9b": "It hardly moves, and it moves as a whole.";
    Fibres "figure_09c_soft", "A veined leaf", "Figure 9c": "The veins carry it, and between them it stays soft.";
    Fibres "figure_10_without_soft", "A stalk that holds", "Figure 10": "Struck alike, it nods and swings back up.";
    Fibres "short_bar", "A short stiff bar", "Table 1": "588 particles and four fibres: it hardly shortens.";
    Fibres "long_bar", "A long bar pushed down", "Table 1":
        "Pushed down from above, it bends away from its two fibres.";
    Fibres "plant", "A plant that is pushed", "Table 1": "2724 particles and five fibres: a push makes it swing.";
    Fibres "leaf", "A leaf on its stalk", "Table 1": "1159 particles and five fibres, held by its stalk.";
    Fibres "short_bar_mesh", "A bar with round edges", "Table 1, from a mesh":
        "The same bar, filled from a mesh with round edges.";
    Fibres "figure_06_without", "A stiff bar without fibres", "Figure 6, as printed":
        "Table 1's stiffness: all is over within milliseconds.";
    Fibres "figure_06a", "A stiff bar, strengthened", "Figure 6a, as printed":
        "Height lost: 2.7 %, where it is 8.1 % without fibres.";
    Fibres "figure_06b", "A stiff bar, sheared", "Figure 6b, as printed": "Sheared by 10 mm along the slant.";
    Fibres "figure_06c", "A stiff bar, twisted", "Figure 6c, as printed": "Twisted by 16 degrees.";
    Fibres "figure_07_without", "A stiff bar pressed, without fibres", "Figure 7, as printed":
        "Tip and middle stay on the axis.";
    Fibres "figure_07a", "A stiff bar, straight fibre", "Figure 7a, as printed":
        "The tip goes 1.2 mm away from the fibre.";
    Fibres "figure_07b", "A stiff bar, slanted fibre", "Figure 7b, as printed": "The tip goes 3.2 mm along the lean.";
    Fibres "figure_07c", "A stiff bar, fibre like a C", "Figure 7c, as printed":
        "The middle gives way along the bulge.";
    Fibres "figure_07d", "A stiff bar, fibre like an S", "Figure 7d, as printed": "Both halves bend.";
    Fibres "figure_08a", "A plant that goes down", "Figure 8a, as printed":
        "Table 1's matrix alone: it goes down within 0.3 s.";
    Fibres "figure_08b", "A plant that hardly moves", "Figure 8b, as printed":
        "A thousand times as stiff: it hardly moves.";
    Fibres "figure_08c", "A plant that swings", "Figure 8c, as printed":
        "Three strands side by side hold the stem: it swings.";
    Fibres "figure_08d", "A plant braced at its foot", "Figure 8d, as printed":
        "Crossed helices around its foot: that stays upright.";
    Fibres "figure_09a", "A nodding leaf", "Figure 9a, as printed": "Table 1's leaf without fibres nods by 37 mm.";
    Fibres "figure_09b", "A leaf like a board", "Figure 9b, as printed":
        "Ten times as stiff: 3.7 mm, and nothing bends.";
    Fibres "figure_09c", "A leaf on two strands", "Figure 9c, as printed":
        "Two strands, one above the other, carry it: 4.8 mm.";
    Fibres "figure_10", "A stalk that tears", "Figure 10, as printed":
        "Its upper strand tears: the leaf goes down twice as far.";
    Fibres "figure_10_without", "A stalk that nods", "Figure 10, as printed": "Struck alike, it nods half as far.";
    Fibres "press_short_bar", "A press", "": "The force at 2 %: 1950 N at rest.";
    Fibres "cantilever", "A sagging beam", "": "Sags under its own weight, within 5 % of Timoshenko.";
    Fibres "free_flight", "Free flight", "": "Spins and rings in nothing: momenta stay to round-off.";
    TwoLayer "two_layer_1d", "A segment", "": "The body of one dimension: two particles and a spring.";
    TwoLayer "two_layer_2d", "A ring in a box", "": "Ten particles a layer and gas inside, dropped in a box.";
    TwoLayer "two_layer_3d", "A ball in a box", "": "An octahedron subdivided once, dropped in a box.";
    TwoLayer "two_layer_mesh", "An inner tube", "": "Any closed mesh as a two-layer body: it bounces and stays round.";
    TwoLayer "two_layer_figure_10", "A ring that is dragged", "Figure 10":
        "Pulled to a point, let go at 4 s, at rest by 12 s.";
    TwoLayer "two_layer_figure_11", "A ball that is dragged", "Figure 11": "The same in three dimensions.";
    TwoLayer "two_layer_figure_12", "Three integrators that hold", "Figure 12":
        "A step of 0.003 s: Euler, midpoint, Runge-Kutta are stable.";
    TwoLayer "two_layer_figure_13", "One that blows up", "Figure 13":
        "A step of 0.03 s: under Euler the body is stopped.";
    TwoLayer "two_layer_figure_14", "One that holds", "Figure 14":
        "A step of 0.3 s: only under Runge-Kutta does it not blow up.";
    TwoLayer "two_layer_figure_15", "A finer ball", "Figure 15": "Subdivided twice: 132 particles.";
    TwoLayer "two_layer_subdivisions", "Balls coarse and fine", "": "The same springs and mass in 12 to 516 particles.";
    TwoLayer "two_layer_collapse", "A collapse without gas", "": "Two layers stand, a single one falls flat.";
    TwoLayer "two_layer_density", "Heavy cores and heavy skins", "":
        "A heavy core has half the inertia of a heavy skin.";
    TwoLayer "two_layer_opposite_motion", "Opposite motion", "":
        "The heavy inner layer goes on as the outer one stops.";
    TwoLayer "two_layer_one_against_two", "One layer against two", "": "Under Euler one layer blows up where two hold.";
    TwoLayer "two_layer_collision", "Two balls collide", "": "They meet and part, and their momentum stays.";
    TwoLayer "two_layer_balloon", "A balloon half filled", "":
        "Released on its side, it rolls until the heavy half is below.";
    TwoLayer "two_layer_stability_soft", "Soft and light", "": "For comparing integrators: Euler blows up at 0.03 s.";
    TwoLayer "two_layer_stability_stiff", "Stiff and heavy", "":
        "For comparing integrators: all are stable at 0.003 s.";
}
