//! The patterns that come with the program.

use super::{Parameter, Pattern, curves, lines, planes};

const fn share(id: &'static str, title: &'static str, default: f64, range: [f64; 2]) -> Parameter {
    Parameter { id, title, unit: "", default, range, whole: false }
}

const fn count(id: &'static str, title: &'static str, default: f64, range: [f64; 2]) -> Parameter {
    Parameter { id, title, unit: "", default, range, whole: true }
}

/// Of the box's least extent, kept free on every side.
const MARGIN: Parameter = share("margin", "Margin", 0.15, [0.02, 0.4]);
const VERTICES: Parameter = count("vertices", "Vertices", 13.0, [3.0, 64.0]);
const MANY_VERTICES: Parameter = count("vertices", "Vertices", 25.0, [3.0, 64.0]);
const ALONG_X: Parameter = count("along_x", "Fibres along x", 2.0, [1.0, 8.0]);
const ALONG_Z: Parameter = count("along_z", "Fibres along z", 2.0, [1.0, 8.0]);
const ROWS: Parameter = count("fibres", "Fibres", 2.0, [1.0, 8.0]);
const HELIX: [Parameter; 5] = [
    count("fibres", "Fibres", 4.0, [1.0, 12.0]),
    Parameter { id: "turns", title: "Turns", unit: "turns", default: 0.5, range: [0.1, 3.0], whole: false },
    share("radius", "Radius", 1.0, [0.2, 1.0]),
    VERTICES,
    MARGIN,
];

/// Every pattern that comes with the program.
pub static PATTERNS: [Pattern; 12] = [
    Pattern {
        id: "vertical",
        title: "Upright",
        does: "Stiffens the solid along its height; pressed or dropped, it keeps it.",
        parameters: &[ALONG_X, ALONG_Z, VERTICES, MARGIN],
        layout: lines::vertical,
    },
    Pattern {
        id: "slanted",
        title: "Slanted",
        does: "Shears the solid along the slant when it is pressed or lands.",
        parameters: &[ALONG_X, ALONG_Z, share("lean", "Lean", 0.5, [-0.9, 0.9]), VERTICES, MARGIN],
        layout: lines::slanted,
    },
    Pattern {
        id: "helix_left",
        title: "Helix, left-handed",
        does: "Twists the solid one way when it is pressed or lands.",
        parameters: &HELIX,
        layout: curves::helix_left,
    },
    Pattern {
        id: "helix_right",
        title: "Helix, right-handed",
        does: "Twists the solid the other way when it is pressed or lands.",
        parameters: &HELIX,
        layout: curves::helix_right,
    },
    Pattern {
        id: "cross",
        title: "Cross",
        does: "Braces the solid: it resists shear in the plane of the cross and bends across it.",
        parameters: &[
            count("planes", "Planes", 2.0, [1.0, 6.0]),
            share("reach", "Width", 1.0, [0.2, 1.0]),
            VERTICES,
            MARGIN,
        ],
        layout: lines::cross,
    },
    Pattern {
        id: "frame",
        title: "Frame",
        does: "Stiffens the edges: the faces bulge between them.",
        parameters: &[VERTICES, MARGIN],
        layout: lines::frame,
    },
    Pattern {
        id: "c_shape",
        title: "C",
        does: "Bends the solid once when it is pressed.",
        parameters: &[ROWS, share("bulge", "Bulge", 0.8, [-1.0, 1.0]), VERTICES, MARGIN],
        layout: curves::c_shape,
    },
    Pattern {
        id: "s_shape",
        title: "S",
        does: "Bends the solid twice when it is pressed, one half each way.",
        parameters: &[ROWS, share("swing", "Swing", 0.8, [-1.0, 1.0]), VERTICES, MARGIN],
        layout: curves::s_shape,
    },
    Pattern {
        id: "radial",
        title: "Rays",
        does: "Stiffens a disc or plate from its middle to its rim; it cups instead of folding.",
        parameters: &[
            count("rays", "Rays", 8.0, [2.0, 24.0]),
            share("hub", "Hub", 0.15, [0.05, 0.6]),
            count("vertices", "Vertices", 7.0, [3.0, 64.0]),
            MARGIN,
        ],
        layout: planes::radial,
    },
    Pattern {
        id: "vein",
        title: "Veins",
        does: "Carries a leaf along its midrib and veins, and leaves it soft between them.",
        parameters: &[
            count("pairs", "Pairs", 4.0, [0.0, 12.0]),
            share("reach", "Width", 0.9, [0.2, 1.0]),
            Parameter {
                id: "angle",
                title: "Angle",
                unit: "degrees",
                default: 50.0,
                range: [20.0, 90.0],
                whole: false,
            },
            VERTICES,
            MARGIN,
        ],
        layout: planes::vein,
    },
    Pattern {
        id: "spiral",
        title: "Spiral",
        does: "Lets a plate stretch in its plane and turn about its middle as it does.",
        parameters: &[
            count("arms", "Arms", 1.0, [1.0, 6.0]),
            Parameter { id: "turns", title: "Turns", unit: "turns", default: 2.0, range: [0.25, 4.0], whole: false },
            share("hub", "Hub", 0.15, [0.05, 0.6]),
            MANY_VERTICES,
            MARGIN,
        ],
        layout: planes::spiral,
    },
    Pattern {
        id: "short_fibres",
        title: "Short fibres",
        does: "Strengthens the solid evenly, in no direction more than in others.",
        parameters: &[
            count("fibres", "Fibres", 30.0, [1.0, 500.0]),
            share("length", "Length", 0.6, [0.1, 1.0]),
            count("seed", "Seed", 1.0, [0.0, 1e6]),
            count("vertices", "Vertices", 4.0, [3.0, 16.0]),
            MARGIN,
        ],
        layout: lines::short_fibres,
    },
];
