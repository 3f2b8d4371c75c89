//! Pictures of a moving picture as GIF: 255 colours each, and of what did not change nothing at all.

use super::offscreen::{Picture, RenderError};
use color_quant::NeuQuant;
use std::collections::BTreeMap;
use std::iter;

/// Colours of a picture, and the number behind them, which stands for what was there before.
const COLOURS: usize = 255;

/// Makes pictures out of pictures, one after another.
#[derive(Clone, Debug, Default)]
pub(crate) struct GifPictures {
    last: Option<Picture>,
}

impl GifPictures {
    /// The next picture as a GIF file of its own, to be shown for so long [s/100] on those before it, which are of the
    /// same size. Only the rectangle is there in which something changed, and what did not change in it is left
    /// through.
    ///
    /// # Errors
    /// [`RenderError::Gif`].
    pub(crate) fn next(&mut self, picture: &Picture, delay: u16) -> Result<Vec<u8>, RenderError> {
        let last = self.last.as_ref().filter(|last| last.size == picture.size);
        let [width, height] = picture.size;
        let has_changed = |pixel: usize| last.is_none_or(|last| at(last, pixel) != at(picture, pixel));
        let [left, top, right, bottom] = changed_rectangle(picture.size, has_changed);
        let inside = (top..bottom).flat_map(|row| (left..right).map(move |column| (row * width + column) as usize));
        let pixels: Vec<Option<[u8; 3]>> = inside.map(|pixel| has_changed(pixel).then(|| at(picture, pixel))).collect();
        let (indices, palette) = in_colours(&pixels);
        let [width, height] = [width, height].map(|extent| extent as u16);
        let [w, h] = [right - left, bottom - top].map(|extent| extent as u16);
        let transparent = pixels.contains(&None).then_some(COLOURS as u8);
        let frame = gif::Frame {
            delay,
            left: left as u16,
            top: top as u16,
            ..gif::Frame::from_palette_pixels(w, h, indices, palette, transparent)
        };
        let mut file = Vec::new();
        // No colours for the whole: every picture has its own.
        let mut encoder = gif::Encoder::new(&mut file, width, height, &[])?;
        encoder.write_frame(&frame)?;
        drop(encoder);
        self.last = Some(picture.clone());
        Ok(file)
    }
}

/// Red, green and blue of a pixel by its number.
fn at(picture: &Picture, pixel: usize) -> [u8; 3] {
    [0, 1, 2].map(|channel| picture.rgba[4 * pixel + channel])
}

/// Left, top, right and bottom around what has changed, the last two not in it; of one pixel at least.
fn changed_rectangle([width, height]: [u32; 2], has_changed: impl Fn(usize) -> bool) -> [u32; 4] {
    let [mut left, mut top, mut right, mut bottom] = [width, height, 0, 0];
    for row in 0..height {
        for column in (0..width).filter(|column| has_changed((row * width + column) as usize)) {
            left = left.min(column);
            right = right.max(column + 1);
            top = top.min(row);
            bottom = row + 1;
        }
    }
    if right == 0 { [0, 0, 1, 1] } else { [left, top, right, bottom] }
}

/// Numbers of colours, and the colours; what there is none of has the number behind them.
fn in_colours(pixels: &[Option<[u8; 3]>]) -> (Vec<u8>, Vec<u8>) {
    let mut counts = BTreeMap::new();
    pixels.iter().flatten().for_each(|&colour| *counts.entry(colour).or_insert(0_u32) += 1);
    let (numbers, mut palette): (BTreeMap<[u8; 3], usize>, Vec<u8>) = if counts.len() <= COLOURS {
        let numbered = counts.keys().zip(0..).map(|(&colour, number)| (colour, number));
        (numbered.collect(), counts.keys().flatten().copied().collect())
    } else {
        let opaque = |[r, g, b]: [u8; 3]| [r, g, b, u8::MAX];
        // By the root of how many there are: a thin line counts for something beside all of the background.
        let samples =
            counts.iter().flat_map(|(&colour, &count)| iter::repeat_n(opaque(colour), count.isqrt() as usize));
        let chosen = NeuQuant::new(1, COLOURS, samples.flatten().collect::<Vec<u8>>().as_slice());
        let numbered = counts.keys().map(|&colour| (colour, chosen.index_of(&opaque(colour))));
        (numbered.collect(), chosen.color_map_rgb())
    };
    palette.resize(3 * (COLOURS + 1), 0);
    let number = |colour: &Option<[u8; 3]>| colour.map_or(COLOURS, |colour| numbers[&colour]) as u8;
    (pixels.iter().map(number).collect(), palette)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As a reader shows them one after another.
    fn shown(files: &[Vec<u8>], size: [u32; 2]) -> Vec<Vec<[u8; 3]>> {
        let mut canvas = vec![[0; 3]; (size[0] * size[1]) as usize];
        let show = |file: &Vec<u8>| {
            let mut options = gif::DecodeOptions::new();
            options.set_color_output(gif::ColorOutput::RGBA);
            let mut reader = options.read_info(&file[..]).unwrap();
            let frame = reader.read_next_frame().unwrap().unwrap();
            for (index, pixel) in frame.buffer.as_chunks::<4>().0.iter().enumerate().filter(|(_, pixel)| pixel[3] > 0) {
                let (row, column) = (index / usize::from(frame.width), index % usize::from(frame.width));
                let place = (row + usize::from(frame.top)) * size[0] as usize + column + usize::from(frame.left);
                canvas[place] = [pixel[0], pixel[1], pixel[2]];
            }
            canvas.clone()
        };
        files.iter().map(show).collect()
    }

    #[test]
    fn what_is_shown_is_what_was_drawn_and_only_what_changed_is_there() {
        let size = [64, 40];
        // More colours than a picture has, and a spot that moves over them.
        let picture = |frame: u32| {
            let colour = |k: u32| {
                let (x, y) = (k % 64, k / 64);
                let is_spot = x.abs_diff(10 + frame) < 4 && y.abs_diff(20) < 4;
                if is_spot { [250, 10, 10, 255] } else { [4 * x as u8, 6 * y as u8, 128, 255] }
            };
            Picture { size, rgba: (0..64 * 40).flat_map(colour).collect() }
        };
        let pictures: Vec<Picture> = [0, 1, 1, 5].map(picture).to_vec();
        let mut maker = GifPictures::default();
        let files: Vec<Vec<u8>> = pictures.iter().map(|picture| maker.next(picture, 4).unwrap()).collect();
        for (canvas, picture) in shown(&files, size).iter().zip(&pictures) {
            let off = |k: usize| (0..3).map(|c| canvas[k][c].abs_diff(at(picture, k)[c])).max().unwrap();
            let all: Vec<u8> = (0..canvas.len()).map(off).collect();
            let sum: usize = all.iter().map(|&off| usize::from(off)).sum();
            assert!(sum < 16 * all.len() && all.iter().all(|&off| off < 120), "{sum} {:?}", all.iter().max());
        }
        assert!(files[1].len() < files[0].len() / 2 && files[2].len() < files[1].len(), "{:?}", files[1].len());
    }
}
