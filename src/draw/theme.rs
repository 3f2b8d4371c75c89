//! Colours and lights of the pictures: one plain struct, two themes, everything else refers to them.

use super::Colour;

/// Colours and lights of the pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theme {
    /// Background at the top of the picture.
    pub background_top: Colour,
    /// Background at the bottom.
    pub background_bottom: Colour,
    /// The floor, where it is lit.
    pub floor: Colour,
    /// Lines of the grid; their opacity is that of the major ones.
    pub grid: Colour,
    /// X, Y and Z.
    pub axes: [Colour; 3],
    /// Skins.
    pub skin: Colour,
    /// Material particles: cool.
    pub material: Colour,
    /// Structure particles: warm.
    pub structure: Colour,
    /// Strokes.
    pub stroke: Colour,
    /// Where a stroke starts.
    pub stroke_start: Colour,
    /// Where it ends.
    pub stroke_end: Colour,
    /// Where a fibre is broken.
    pub broken: Colour,
    /// A shape that is not there: neutral, at a quarter.
    pub ghost: Colour,
    /// Panels.
    pub panel: Colour,
    /// Walls and ceiling.
    pub wall: Colour,
    /// Words and marks.
    pub text: Colour,
    /// What is selected.
    pub accent: Colour,
    /// The key light.
    pub key: Colour,
    /// Strength of the key light.
    pub key_strength: f32,
    /// Fill from above.
    pub sky: Colour,
    /// Fill from below.
    pub bounce: Colour,
    /// Strength of the fill.
    pub fill_strength: f32,
    /// Light along outlines.
    pub rim: Colour,
    /// Strength of the light along outlines.
    pub rim_strength: f32,
    /// How dark a shadow is, 0 to 1.
    pub shadow: f32,
    /// Lightness and chroma (OKLCH) of the fibres' palette.
    pub fibre_tone: [f32; 2],
}

/// Turn from one fibre's hue to the next's [turns]: the golden angle keeps any number of neighbours apart.
const HUE_STEP: f32 = 0.381_966;
/// Hue of the first fibre [turns]: warm, against the cool material.
const FIRST_HUE: f32 = 0.05;

impl Theme {
    /// For bright surroundings.
    pub const fn light() -> Self {
        Self {
            background_top: Colour::hex(0xf4_f5f7),
            background_bottom: Colour::hex(0xdf_e2e6),
            floor: Colour::hex(0xee_eff1),
            grid: Colour::hex(0x5c_6470).with_alpha(0.42),
            axes: [Colour::hex(0xd6_3b3b), Colour::hex(0x3f_9a3a), Colour::hex(0x2f_6fd6)],
            skin: Colour::hex(0x8f_b4e3),
            material: Colour::hex(0x4c_8fd0),
            structure: Colour::hex(0xf0_7f2c),
            stroke: Colour::hex(0x26_2b33),
            stroke_start: Colour::hex(0x2f_9e44),
            stroke_end: Colour::hex(0xd9_3636),
            broken: Colour::hex(0xcc_1414),
            ghost: Colour::hex(0x6b_717b).with_alpha(0.25),
            panel: Colour::hex(0xb9_bec6),
            wall: Colour::hex(0x7a_8494).with_alpha(0.10),
            text: Colour::hex(0x3c_434e),
            accent: Colour::hex(0x1f_6feb),
            key: Colour::hex(0xff_f6ea),
            key_strength: 0.92,
            sky: Colour::hex(0xe9_f1ff),
            bounce: Colour::hex(0xd8_d2cc),
            fill_strength: 0.56,
            rim: Colour::hex(0xff_ffff),
            rim_strength: 0.16,
            shadow: 0.55,
            fibre_tone: [0.67, 0.20],
        }
    }

    /// For dark surroundings.
    pub const fn dark() -> Self {
        Self {
            background_top: Colour::hex(0x2a_2d33),
            background_bottom: Colour::hex(0x1a_1c20),
            floor: Colour::hex(0x2c_2f35),
            grid: Colour::hex(0xa8_b2c2).with_alpha(0.24),
            axes: [Colour::hex(0xe8_5a5a), Colour::hex(0x6c_c05f), Colour::hex(0x5b_94f0)],
            skin: Colour::hex(0x86_aee2),
            material: Colour::hex(0x5b_a0e0),
            structure: Colour::hex(0xff_9447),
            stroke: Colour::hex(0xf0_f2f5),
            stroke_start: Colour::hex(0x57_c768),
            stroke_end: Colour::hex(0xff_6a64),
            broken: Colour::hex(0xff_2d2d),
            ghost: Colour::hex(0xb4_bac4).with_alpha(0.25),
            panel: Colour::hex(0x6c_727c),
            wall: Colour::hex(0xa8_b2c2).with_alpha(0.08),
            text: Colour::hex(0xc9_cfd8),
            accent: Colour::hex(0x5a_a2ff),
            key: Colour::hex(0xff_f1e0),
            key_strength: 0.90,
            sky: Colour::hex(0xa9_bcd8),
            bounce: Colour::hex(0x5a_5450),
            fill_strength: 0.42,
            rim: Colour::hex(0xcf_e0ff),
            rim_strength: 0.38,
            shadow: 0.72,
            fibre_tone: [0.74, 0.17],
        }
    }

    /// A colour of the fibres' lightness and chroma with this hue [turns].
    pub(crate) fn hue(&self, turns: f32) -> Colour {
        Colour::oklch(self.fibre_tone[0], self.fibre_tone[1], turns)
    }

    /// For small pictures in galleries: before one ground that looks well in bright and in dark surroundings, and with
    /// ghosts that leave what they cover its colour.
    pub const fn gallery() -> Self {
        let ground = Colour::hex(0x3a_414b);
        let ghost = Colour::hex(0xd0_d6de).with_alpha(0.13);
        Self { background_top: ground, background_bottom: ground, floor: ground, ghost, ..Self::dark() }
    }

    /// Hue of the fibre with this number: one lightness and chroma, hues apart.
    pub fn fibre(&self, number: usize) -> Colour {
        let hue = (FIRST_HUE + HUE_STEP * number as f32).fract();
        self.hue(hue)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_dozen_fibres_are_told_apart() {
        for theme in [Theme::light(), Theme::dark()] {
            let colours: Vec<[f32; 3]> = (0..12).map(|k| theme.fibre(k)).map(|c| [c.red, c.green, c.blue]).collect();
            for (k, a) in colours.iter().enumerate() {
                for b in &colours[..k] {
                    let apart: f32 = a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum();
                    assert!(apart.sqrt() > 0.08, "{a:?} {b:?}");
                }
            }
        }
    }
}
