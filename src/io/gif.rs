//! Moving pictures as GIF, which grows by a picture at a time: what plays nothing else plays it.
//!
//! Pictures come as GIF files of one picture each. The next one is written behind the file's end; then its first byte
//! takes the place of that end: the file is whole whatever ends the run, and wherever it does.

use super::IoError;
use super::atomic::Draft;
use super::door::OpenFile;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The byte that ends a file.
const END: u8 = 0x3b;

/// Bytes of the head: the signature, and what holds for the whole.
const HEAD: usize = 13;

/// Where the head says whether there are colours for the whole.
const FLAGS: usize = 10;

/// What says that the pictures are shown again and again: a block of an application's own, with a count of zero.
const FOREVER: &[u8; 19] = b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00";

/// Time in which a second has this many units.
const UNITS: f64 = 100.0;

/// Least units for which a picture is shown: browsers take any time below for a tenth of a second.
const LEAST: u64 = 2;

/// A moving picture that is written.
pub(crate) struct AnimatedGif {
    path: PathBuf,
    /// Time of a frame [s].
    seconds: f64,
    /// None until the first picture is there.
    file: Option<OpenFile>,
    frames: u64,
    pictures: u64,
    /// Where the byte is that ends the file.
    end: u64,
}

impl AnimatedGif {
    /// No pictures yet, of frames that last so long [s].
    pub(crate) fn new(path: PathBuf, seconds: f64) -> Self {
        Self { path, seconds, file: None, frames: 0, pictures: 0, end: 0 }
    }

    /// Number of pictures.
    pub(crate) fn pictures(&self) -> u64 {
        self.pictures
    }

    /// Number of frames that they are of: the format shows fifty pictures a second at most, so that some may be left
    /// out.
    pub(crate) fn frames(&self) -> u64 {
        self.frames
    }

    /// Where it is written.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Goes on to the next frame: for how long it is to be shown [s/100], or none where it is left out.
    pub(crate) fn next_frame(&mut self) -> Option<u16> {
        let number = self.frames;
        self.frames += 1;
        delay(number, self.seconds)
    }

    /// Adds a picture, a GIF file of one; all of them are of the same size.
    ///
    /// # Errors
    /// [`IoError::Write`] within [`IoError::InFile`].
    pub(crate) fn push(&mut self, gif: &[u8]) -> Result<(), IoError> {
        self.add(gif).map_err(|error| IoError::Write(error).within(&self.path))
    }

    fn add(&mut self, gif: &[u8]) -> io::Result<()> {
        let (head, picture) =
            parts(gif).ok_or_else(|| io::Error::new(io::ErrorKind::InvalidData, "a picture is no GIF"))?;
        if let Some(file) = &mut self.file {
            for (at, bytes) in writes(self.end, picture) {
                file.seek(SeekFrom::Start(at))?;
                file.write_all(&bytes)?;
                // Before what counts on it: not even a power cut turns them about.
                file.sync()?;
            }
        } else {
            let mut draft = Draft::begin(&self.path)?;
            draft.write_all(head)?;
            draft.write_all(FOREVER)?;
            draft.write_all(picture)?;
            draft.write_all(&[END])?;
            self.end = (head.len() + FOREVER.len()) as u64;
            self.file = Some(draft.replace()?);
        }
        self.end += picture.len() as u64;
        self.pictures += 1;
        Ok(())
    }
}

/// The head of a file with the colours that stand there for the whole, and its picture, which has others of its own.
fn parts(gif: &[u8]) -> Option<(&[u8], &[u8])> {
    let flags = *gif.get(FLAGS)?;
    // The highest bit says whether colours follow, the lowest three how many.
    let colours = if flags & 0x80 == 0 { 0 } else { 2 << (flags & 7) };
    let (head, rest) = gif.split_at_checked(HEAD + 3 * colours)?;
    let picture = rest.strip_suffix(&[END]).filter(|picture| !picture.is_empty())?;
    head.starts_with(b"GIF89a").then_some((head, picture))
}

/// What is written where, one after another, to add a picture: the old end stays until all behind it is there.
fn writes(end: u64, picture: &[u8]) -> [(u64, Vec<u8>); 2] {
    let (first, rest) = picture.split_at(1);
    [(end + 1, [rest, &[END]].concat()), (end, first.to_vec())]
}

/// For how long the frame of this number, from 0, is shown: until the next that is. Times are rounded, not their
/// differences, so that the motion as a whole is as fast as it is.
fn delay(number: u64, seconds: f64) -> Option<u16> {
    let units = UNITS * seconds;
    if units >= LEAST as f64 {
        let at = |number: u64| (units * number as f64).round();
        return Some((at(number + 1) - at(number)) as u16);
    }
    // The frame that is nearest to the slot of every two units.
    let slot = |number: u64| (units * number as f64 / LEAST as f64).floor();
    let is_first = number == 0 || slot(number) > slot(number - 1);
    is_first.then_some(LEAST as u16)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One picture, as large as can be counted by eye: the table of two colours of its own, and data that need not be
    /// sound.
    fn picture(grey: u8) -> Vec<u8> {
        let mut gif = b"GIF89a\x01\0\x01\0\x80\0\0\0\0\0\0\0\0".to_vec();
        gif.extend(b"\x21\xf9\x04\0\x05\0\0\0");
        gif.extend([0x2c, 0, 0, 0, 0, 1, 0, 1, 0, 0x80, grey, grey, grey, 0, 0, 0, 2, 2, 0x44, 1, 0, END]);
        gif
    }

    #[test]
    fn a_picture_that_is_half_written_is_none() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.gif");
        let mut animated = AnimatedGif::new(path.clone(), 0.1);
        animated.push(&picture(10)).unwrap();
        let one = std::fs::read(&path).unwrap();
        animated.push(&picture(20)).unwrap();
        let two = std::fs::read(&path).unwrap();
        let (_, body) = parts(&two).unwrap();
        assert!(
            two.starts_with(&one[..one.len() - 1]) && body.ends_with(&picture(20)[HEAD + 6..picture(20).len() - 1])
        );
        let put = |file: &mut Vec<u8>, at: u64, bytes: &[u8]| {
            file.resize(file.len().max(at as usize + bytes.len()), 0);
            file[at as usize..at as usize + bytes.len()].copy_from_slice(bytes);
        };
        let next = picture(30);
        let steps = writes(two.len() as u64 - 1, parts(&next).unwrap().1);
        let mut half = two.clone();
        put(&mut half, steps[0].0, &steps[0].1[..9]);
        // A reader stops at the end that it meets.
        assert!(half.starts_with(&two));
        let mut whole = two.clone();
        for (at, bytes) in &steps {
            put(&mut whole, *at, bytes);
        }
        animated.push(&next).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), whole);
        assert!(animated.push(b"no picture").is_err());
        assert_eq!(animated.pictures(), 3);
    }

    #[test]
    fn the_motion_is_as_fast_as_it_is() {
        for frames_per_second in [10.0, 24.0, 30.0, 50.0, 60.0, 240.0] {
            let delays: Vec<u16> = (0..1200).filter_map(|k| delay(k, 1.0 / frames_per_second)).collect();
            let shown: f64 = delays.iter().map(|&delay| f64::from(delay) / UNITS).sum();
            assert!((shown - 1200.0 / frames_per_second).abs() < 0.03, "{frames_per_second} {shown}");
            assert!(delays.iter().all(|&delay| u64::from(delay) >= LEAST));
            assert_eq!(delays.len() == 1200, frames_per_second <= 50.0);
        }
    }
}
