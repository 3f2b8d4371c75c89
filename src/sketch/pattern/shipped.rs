//! The patterns that come with the program.

use super::parametric::{Parameter, Pattern};
use super::{acting, curves, lines, planes};

/// Bending stiffness over axial rigidity of most fibres, in particle spacings squared: as of those that are drawn.
const SLENDER: f64 = 0.02;
/// That of fibres which carry something flat.
const STOUT: f64 = 3.0;

const fn share(id: &'static str, title: &'static str, default: f64, range: [f64; 2], tip: &'static str) -> Parameter {
    Parameter { id, title, tip, unit: "", default, range, whole: false }
}

const fn count(id: &'static str, title: &'static str, default: f64, range: [f64; 2], tip: &'static str) -> Parameter {
    Parameter { id, title, tip, unit: "", default, range, whole: true }
}

const fn turns(default: f64, range: [f64; 2], tip: &'static str) -> Parameter {
    Parameter { id: "turns", title: "Turns", tip, unit: "turns", default, range, whole: false }
}

const MARGIN: Parameter =
    share("margin", "Margin", 0.15, [0.02, 0.4], "Kept free on every side, as a share of the box's least extent");
const VERTICES: Parameter = count(
    "vertices",
    "Vertices",
    13.0,
    [3.0, 64.0],
    "Of each fibre, at most one a particle spacing; more follow a curve more closely",
);
const MANY_VERTICES: Parameter = Parameter { default: 25.0, ..VERTICES };
const FEW_VERTICES: Parameter = Parameter { default: 7.0, ..VERTICES };
const ALONG_X: Parameter = count("along_x", "Fibres along X", 2.0, [1.0, 8.0], "How many stand side by side");
const ALONG_Z: Parameter = count("along_z", "Fibres along Z", 2.0, [1.0, 8.0], "How many stand one behind the other");
const ROWS: Parameter = count("fibres", "Fibres", 2.0, [1.0, 8.0], "How many stand one behind the other");
const HUB: Parameter = share("hub", "Hub", 0.15, [0.05, 0.6], "Where they begin, as a share of the way to the rim");
const HELIX: [Parameter; 5] = [
    count("fibres", "Fibres", 4.0, [1.0, 12.0], "How many wind about the axis, evenly spaced"),
    turns(0.5, [0.1, 3.0], "How often each winds about the axis; less lean means more twist to the height lost"),
    share("radius", "Radius", 1.0, [0.2, 1.0], "As a share of the half width"),
    VERTICES,
    MARGIN,
];

const CONTRACT: Parameter = share(
    "contract",
    "Contraction",
    0.5,
    acting::CONTRACTION,
    "Share by which the fibres want to be shorter at most; below zero longer",
);
const PERIOD: Parameter = Parameter {
    id: "period",
    title: "Period",
    tip: "Time from one contraction to the next",
    unit: "s",
    default: 0.8,
    range: [0.05, 60.0],
    whole: false,
};
const WAVES: Parameter =
    share("waves", "Waves", 1.0, [-4.0, 4.0], "How many run along it at a time; below zero the other way");
const WINDING: Parameter = turns(0.5, [0.1, 3.0], "How often each fibre winds about the axis");

/// Every pattern that comes with the program.
pub static PATTERNS: [Pattern; 20] = [
    Pattern {
        id: "vertical",
        title: "Upright",
        does: "Stiffens the solid along its height; dropped, it keeps it.",
        parameters: &[ALONG_X, ALONG_Z, VERTICES, MARGIN],
        bending: SLENDER,
        layout: lines::vertical,
        acting: None,
    },
    Pattern {
        id: "slanted",
        title: "Slanted",
        does: "Shears the solid along the slant when it is pressed or lands.",
        parameters: &[
            ALONG_X,
            ALONG_Z,
            share("lean", "Lean", 0.5, [-0.9, 0.9], "How far aside the upper ends stand, as a share of the width"),
            VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: lines::slanted,
        acting: None,
    },
    Pattern {
        id: "helix_left",
        title: "Helix, left-handed",
        does: "Twists the solid one way when it is pressed or lands.",
        parameters: &HELIX,
        bending: SLENDER,
        layout: curves::helix_left,
        acting: None,
    },
    Pattern {
        id: "helix_right",
        title: "Helix, right-handed",
        does: "Twists the solid the other way when it is pressed or lands.",
        parameters: &HELIX,
        bending: SLENDER,
        layout: curves::helix_right,
        acting: None,
    },
    Pattern {
        id: "cross",
        title: "Cross",
        does: "Braces the solid: pushed aside it gives way less, least in the plane of the cross.",
        parameters: &[
            count("planes", "Planes", 2.0, [1.0, 6.0], "How many crosses stand one behind the other"),
            share("reach", "Width", 1.0, [0.2, 1.0], "Of each cross, as a share of that of the box"),
            VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: lines::cross,
        acting: None,
    },
    Pattern {
        id: "frame",
        title: "Frame",
        does: "Stiffens the edges; dropped, the solid keeps its shape.",
        parameters: &[VERTICES, MARGIN],
        bending: SLENDER,
        layout: lines::frame,
        acting: None,
    },
    Pattern {
        id: "c_shape",
        title: "C",
        does: "Bends the solid once when it is pressed.",
        parameters: &[
            ROWS,
            share("bulge", "Bulge", 0.8, [-1.0, 1.0], "To the left, as a share of the width; below zero to the right"),
            VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: curves::c_shape,
        acting: None,
    },
    Pattern {
        id: "s_shape",
        title: "S",
        does: "Bends the solid twice when it is pressed, one half each way.",
        parameters: &[
            ROWS,
            share(
                "swing",
                "Swing",
                0.8,
                [-1.0, 1.0],
                "Of the lower half to the right, as a share of the half width; below zero to the left",
            ),
            VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: curves::s_shape,
        acting: None,
    },
    Pattern {
        id: "radial",
        title: "Rays",
        does: "Stiffens a disc or plate from its middle to its rim, so that it hardly hangs.",
        parameters: &[
            count("rays", "Rays", 8.0, [2.0, 24.0], "How many run from the middle to the rim"),
            HUB,
            FEW_VERTICES,
            MARGIN,
        ],
        bending: STOUT,
        layout: planes::radial,
        acting: None,
    },
    Pattern {
        id: "vein",
        title: "Veins",
        does: "Carries a leaf along its midrib and veins, and leaves it soft between them.",
        parameters: &[
            count("pairs", "Pairs", 4.0, [0.0, 12.0], "Side veins that leave the midrib, one to each side"),
            share("reach", "Width", 0.9, [0.2, 1.0], "Of the side veins, as a share of the half width"),
            Parameter {
                id: "angle",
                title: "Angle",
                tip: "Between the midrib and its side veins",
                unit: "degrees",
                default: 50.0,
                range: [20.0, 90.0],
                whole: false,
            },
            VERTICES,
            MARGIN,
        ],
        bending: STOUT,
        layout: planes::vein,
        acting: None,
    },
    Pattern {
        id: "spiral",
        title: "Spiral",
        does: "Lets a plate stretch in its plane and turn about its middle as it does.",
        parameters: &[
            count("arms", "Arms", 1.0, [1.0, 6.0], "How many spirals wind out of the middle, evenly spaced"),
            turns(2.0, [0.25, 4.0], "How often each winds about the middle on its way to the rim"),
            HUB,
            MANY_VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: planes::spiral,
        acting: None,
    },
    Pattern {
        id: "short_fibres",
        title: "Short fibres",
        does: "Strengthens the solid evenly, in no direction more than in others.",
        parameters: &[
            count("fibres", "Fibres", 30.0, [1.0, 500.0], "How many lie in the solid; more make it stiffer"),
            share("length", "Length", 0.6, [0.1, 1.0], "Of each, as a share of the box's least extent"),
            count("seed", "Seed", 1.0, [0.0, 1e6], "Another number lays them otherwise, the same number the same"),
            count("vertices", "Vertices", 4.0, [3.0, 16.0], "Of each fibre"),
            MARGIN,
        ],
        bending: SLENDER,
        layout: lines::short_fibres,
        acting: None,
    },
    Pattern {
        id: "worm",
        title: "Worm",
        does: "Crawls on a floor: a wave along its fibres lifts one part after the other and sets it down further on.",
        parameters: &[CONTRACT, PERIOD, WAVES, VERTICES, MARGIN],
        bending: SLENDER,
        layout: acting::worm,
        acting: Some(acting::acts_of_worm),
    },
    Pattern {
        id: "tail",
        title: "Fish",
        does: "Beats from side to side by a wave from head to tail; in water it swims.",
        parameters: &[CONTRACT, PERIOD, WAVES, VERTICES, MARGIN],
        bending: SLENDER,
        layout: acting::tail,
        acting: Some(acting::acts_of_tail),
    },
    Pattern {
        id: "finger",
        title: "Finger",
        does: "Curls to one side and straightens again: one of a gripper's.",
        parameters: &[
            CONTRACT,
            PERIOD,
            count("fibres", "Fibres", 2.0, [1.0, 8.0], "How many lie side by side on the face to which it curls"),
            VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: acting::finger,
        acting: Some(acting::acts_of_finger),
    },
    Pattern {
        id: "rings",
        title: "Heart",
        does: "Beats: its rings make it narrower and taller, and let it go again.",
        parameters: &[
            CONTRACT,
            PERIOD,
            count("rings", "Rings", 2.0, [1.0, 12.0], "How many lie one above the other"),
            VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: acting::rings,
        acting: Some(acting::acts_of_rings),
    },
    Pattern {
        id: "starfish",
        title: "Starfish",
        does: "Bends the arms of something flat downwards, one after the other, round and round.",
        parameters: &[
            CONTRACT,
            PERIOD,
            count("arms", "Arms", 5.0, [2.0, 24.0], "How many run from the middle to the rim"),
            HUB,
            FEW_VERTICES,
            MARGIN,
        ],
        bending: SLENDER,
        layout: acting::starfish,
        acting: Some(acting::acts_of_starfish),
    },
    Pattern {
        id: "tentacle",
        title: "Tentacle",
        does: "Twists one way, then the other, then curls to one side.",
        parameters: &[CONTRACT, PERIOD, WINDING, VERTICES, MARGIN],
        bending: SLENDER,
        layout: acting::tentacle,
        acting: Some(acting::acts_of_tentacle),
    },
    Pattern {
        id: "trunk",
        title: "Trunk",
        does: "Twists to and fro by helices of both hands that pull in turns.",
        parameters: &[CONTRACT, PERIOD, WINDING, VERTICES, MARGIN],
        bending: SLENDER,
        layout: acting::trunk,
        acting: Some(acting::acts_of_trunk),
    },
    Pattern {
        id: "spokes",
        title: "Breath",
        does: "Draws the solid in from all sides and lets it go, as a ball that breathes.",
        parameters: &[CONTRACT, PERIOD, FEW_VERTICES, MARGIN],
        bending: SLENDER,
        layout: acting::spokes,
        acting: Some(acting::acts_of_spokes),
    },
];

impl Pattern {
    /// The pattern with this identifier.
    pub fn by_id(id: &str) -> Option<&'static Self> {
        PATTERNS.iter().find(|pattern| pattern.id == id)
    }
}
