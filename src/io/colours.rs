//! Colours as files have them, which are meant for the screen, and as light is computed, linearly.

/// A colour of a file, linear and opaque; what is no number counts as the brightest.
pub(super) fn linear(colour: [f64; 3]) -> [f32; 4] {
    let [r, g, b] = colour.map(|c| {
        let c = if c.is_finite() { c } else { 1.0 };
        (if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }) as f32
    });
    [r, g, b, 1.0]
}

/// A linear colour as a file has it.
pub(super) fn for_screen(colour: [f32; 4]) -> [f64; 3] {
    [0, 1, 2].map(|channel| {
        let c = f64::from(colour[channel]);
        if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_read_is_what_is_written() {
        for byte in 0..=255_u8 {
            let share = f64::from(byte) / 255.0;
            let back = for_screen(linear([share; 3]));
            assert!(back.iter().all(|c| (c - share).abs() < 1e-6), "{byte} {back:?}");
        }
    }
}
