//! Small pictures that come with the program, decoded when they are first seen.

use egui::{ColorImage, Context, CornerRadius, Image, Rect, TextureHandle, TextureOptions, Ui};
use std::collections::HashMap;
use std::io::Cursor;

/// Pictures decoded in one frame at most, so that none is held up by them.
const A_FRAME: u32 = 3;
/// Frames of a strip lie one below the other, each of the form of the place into which it is painted.
const FRAMES_PER_SECOND: f64 = 11.0;

/// How a strip plays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Runs {
    /// To its end and back: what comes once, and has come furthest at the end.
    ForthAndBack,
    /// From its start again after its end: what comes over and over, furthest half-way.
    Round,
}

impl Runs {
    /// Which of the frames 0 to `last` is shown after so many have gone by; none where it does not play.
    fn shown(self, frames: Option<f64>, last: usize) -> usize {
        match (self, frames) {
            (Self::ForthAndBack, Some(frames)) => swing(frames, last),
            (Self::ForthAndBack, None) => last,
            (Self::Round, Some(frames)) => frames.max(0.0) as usize % (last + 1),
            (Self::Round, None) => last.div_ceil(2),
        }
    }
}

/// How many frames of this width over their height a strip of this size has, one at least.
fn frames([width, height]: [usize; 2], form: f32) -> usize {
    let high = (width as f32 / form).max(1.0);
    ((height as f32 / high).round() as usize).max(1)
}

/// How many frames of this width over their height a strip has; none where it is no picture.
#[cfg(test)]
pub(super) fn frames_of(png: &[u8], form: f32) -> Option<usize> {
    decode(png).map(|image| frames(image.size, form))
}

/// Pictures by name, as far as they have been seen.
#[derive(Default)]
pub(super) struct Thumbs {
    known: HashMap<&'static str, Option<TextureHandle>>,
    /// Frame in which pictures were decoded last, and how many.
    decoded: (u64, u32),
}

impl Thumbs {
    /// The picture of this name, of which `png` is the file; none for now where enough was decoded in this frame, and
    /// for ever where the file is no picture.
    fn get(&mut self, ctx: &Context, name: &'static str, png: &[u8]) -> Option<TextureHandle> {
        if let Some(known) = self.known.get(name) {
            return known.clone();
        }
        let frame = ctx.cumulative_frame_nr();
        if self.decoded.0 != frame {
            self.decoded = (frame, 0);
        }
        if self.decoded.1 >= A_FRAME {
            ctx.request_repaint();
            return None;
        }
        self.decoded.1 += 1;
        let texture = decode(png).map(|image| ctx.load_texture(name, image, TextureOptions::LINEAR));
        self.known.insert(name, texture.clone());
        texture
    }

    /// Whether the picture of this name has been decoded.
    pub(super) fn has(&self, name: &str) -> bool {
        self.known.contains_key(name)
    }

    /// Paints a strip, or one picture, into a place; a strip that does not play, where it has come furthest.
    pub(super) fn paint_strip(
        &mut self,
        ui: &Ui,
        name: &'static str,
        png: &[u8],
        place: Rect,
        runs: Runs,
        plays: bool,
    ) {
        let Some(texture) = self.get(ui.ctx(), name, png) else { return };
        let height = texture.size()[1];
        let last = frames(texture.size(), place.width() / place.height()) - 1;
        if plays && last > 0 {
            ui.ctx().request_repaint_after_secs(1.0 / FRAMES_PER_SECOND as f32);
        }
        let frames = ui.input(|input| input.time) * FRAMES_PER_SECOND;
        let frame = runs.shown(plays.then_some(frames), last);
        // Half a pixel of each side is left out: what lies above and below is another frame.
        let half = 0.5 / height as f32;
        let share = |k: usize| k as f32 / (last + 1) as f32;
        let part = Rect::from_x_y_ranges(0.0..=1.0, share(frame) + half..=share(frame + 1) - half);
        Image::from_texture(&texture).uv(part).corner_radius(CornerRadius::same(4)).paint_at(ui, place);
    }
}

/// Which of the frames 0 to `last` is shown after so many, forth and back.
fn swing(frames: f64, last: usize) -> usize {
    let period = (2 * last).max(1);
    let at = frames.max(0.0) as usize % period;
    if at <= last { at } else { period - at }
}

/// Red, green and blue from a PNG file; none where it is none of eight bits each.
fn decode(bytes: &[u8]) -> Option<ColorImage> {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().ok()?;
    let mut pixels = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut pixels).ok()?;
    let size = [info.width as usize, info.height as usize];
    let plain = info.color_type == png::ColorType::Rgb && info.bit_depth == png::BitDepth::Eight;
    (plain && pixels.len() == 3 * size[0] * size[1]).then(|| ColorImage::from_rgb(size, &pixels))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_go_forth_and_back() {
        let shown: Vec<usize> = (0..8).map(|k| swing(f64::from(k), 3)).collect();
        assert_eq!(shown, [0, 1, 2, 3, 2, 1, 0, 1]);
        assert_eq!(swing(5.0, 0), 0);
    }

    #[test]
    fn what_goes_round_begins_again_after_its_last_frame_and_stands_half_way() {
        let shown: Vec<usize> = (0..8).map(|k| Runs::Round.shown(Some(f64::from(k)), 3)).collect();
        assert_eq!(shown, [0, 1, 2, 3, 0, 1, 2, 3]);
        assert_eq!([9, 0].map(|last| Runs::Round.shown(None, last)), [5, 0]);
        let shown: Vec<usize> = (0..5).map(|k| Runs::ForthAndBack.shown(Some(f64::from(k)), 2)).collect();
        assert_eq!((shown.as_slice(), Runs::ForthAndBack.shown(None, 9)), ([0, 1, 2, 1, 0].as_slice(), 9));
    }

    #[test]
    fn a_strip_has_as_many_frames_as_its_form_says() {
        let found = [[128, 1280], [128, 128], [240, 150], [240, 1800]];
        assert_eq!(found.map(|size| frames(size, if size[0] == 128 { 1.0 } else { 1.6 })), [10, 1, 1, 12]);
    }

    #[test]
    fn what_is_no_picture_is_none() {
        assert!(decode(b"nothing").is_none());
    }
}
