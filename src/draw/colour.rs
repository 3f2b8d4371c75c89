//! Colours: sRGB as people write them, linear light as shaders want them, and one perceptual palette.

use std::f32::consts::TAU;

/// A colour: sRGB with straight opacity, each channel from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour {
    /// Red.
    pub red: f32,
    /// Green.
    pub green: f32,
    /// Blue.
    pub blue: f32,
    /// Opacity.
    pub alpha: f32,
}

impl Colour {
    /// An opaque colour from 0xRRGGBB.
    pub const fn hex(rgb: u32) -> Self {
        Self {
            red: (rgb >> 16 & 0xff) as f32 / 255.0,
            green: (rgb >> 8 & 0xff) as f32 / 255.0,
            blue: (rgb & 0xff) as f32 / 255.0,
            alpha: 1.0,
        }
    }

    /// An opaque colour from red, green and blue, 0 to 255.
    pub fn from_rgb([red, green, blue]: [u8; 3]) -> Self {
        let [red, green, blue] = [red, green, blue].map(|channel| f32::from(channel) / 255.0);
        Self { red, green, blue, alpha: 1.0 }
    }

    /// The same colour with another opacity.
    #[must_use]
    pub const fn with_alpha(self, alpha: f32) -> Self {
        Self { alpha, ..self }
    }

    /// Linear light with straight opacity.
    pub fn linear(self) -> [f32; 4] {
        let channel = |c: f32| if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
        [channel(self.red), channel(self.green), channel(self.blue), self.alpha]
    }

    /// An opaque colour from OKLCH (Ottosson 2020): lightness 0 to 1, chroma, hue [turns]. What lies outside sRGB loses
    /// chroma, never lightness or hue.
    pub(crate) fn oklch(lightness: f32, chroma: f32, hue_turns: f32) -> Self {
        let (sin, cos) = (TAU * hue_turns).sin_cos();
        let mut chroma = chroma;
        loop {
            let linear = oklab_to_linear(lightness, chroma * cos, chroma * sin);
            if chroma <= 0.0 || linear.iter().all(|c| (-1e-4..=1.0001).contains(c)) {
                let encode = |c: f32| {
                    let c = c.clamp(0.0, 1.0);
                    if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
                };
                let [red, green, blue] = linear.map(encode);
                return Self { red, green, blue, alpha: 1.0 };
            }
            chroma = (chroma - 0.005).max(0.0);
        }
    }
}

#[allow(clippy::excessive_precision, reason = "the matrices as published")]
fn oklab_to_linear(lightness: f32, a: f32, b: f32) -> [f32; 3] {
    let l = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
    let m = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
    let s = (lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b).powi(3);
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grey_is_grey_and_red_is_where_it_is_said_to_be() {
        let grey = Colour::oklch(0.6, 0.0, 0.3);
        assert!((grey.red - grey.green).abs() < 1e-3 && (grey.green - grey.blue).abs() < 1e-3);
        // sRGB red in OKLCH as published.
        let red = Colour::oklch(0.627_955, 0.257_683, 29.2339 / 360.0);
        assert!(red.red > 0.99 && red.green < 0.06 && red.blue < 0.06, "{red:?}");
        assert_eq!(Colour::hex(0x00ff_8000).red, 1.0);
    }

    #[test]
    fn every_hue_stays_a_colour() {
        for k in 0..360 {
            let colour = Colour::oklch(0.7, 0.4, k as f32 / 360.0);
            assert!([colour.red, colour.green, colour.blue].iter().all(|c| (0.0..=1.0).contains(c)));
        }
    }
}
