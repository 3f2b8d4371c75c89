//! Moving pictures as APNG, which grows by a picture at a time: browsers play it, and what knows only PNG shows its
//! first.
//!
//! Pictures come as PNG files, whose data goes over as it is. The next one is written behind the file's end; then it
//! takes the place of that end, and then it is counted at the head: the file is whole whatever ends the run, and
//! wherever it does.

use super::IoError;
use super::atomic::Draft;
use super::door::OpenFile;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// What every file begins with, and the bytes of the first piece behind it.
const SIGNATURE: &[u8; 8] = b"\x89PNG\r\n\x1a\n";
const HEAD: usize = 25;

/// Bytes around the data of a piece: length, kind, check.
const AROUND: usize = 12;

/// A moving picture that is written.
pub(crate) struct AnimatedPng {
    path: PathBuf,
    /// Time of a picture as a fraction of a second.
    delay: [u16; 2],
    /// None until the first picture is there.
    file: Option<OpenFile>,
    pictures: u32,
    /// Pieces that are counted so far.
    sequence: u32,
    /// Where the next picture goes.
    end: u64,
}

impl AnimatedPng {
    /// No pictures yet, each of them to be shown for so long [s].
    pub(crate) fn new(path: PathBuf, seconds: f64) -> Self {
        Self { path, delay: fraction(seconds), file: None, pictures: 0, sequence: 0, end: 0 }
    }

    /// Number of pictures.
    pub(crate) fn pictures(&self) -> u32 {
        self.pictures
    }

    /// Where it is written.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Adds a picture, a PNG file; all of them are of the same size and kind.
    ///
    /// # Errors
    /// [`IoError::Write`] within [`IoError::InFile`].
    pub(crate) fn push(&mut self, png: &[u8]) -> Result<(), IoError> {
        self.add(png).map_err(|error| IoError::Write(error).within(&self.path))
    }

    fn add(&mut self, png: &[u8]) -> io::Result<()> {
        let damaged = || io::Error::new(io::ErrorKind::InvalidData, "a picture is no PNG");
        let body = png.strip_prefix(SIGNATURE).ok_or_else(damaged)?;
        let head = body.get(..HEAD).ok_or_else(damaged)?;
        let size: [u8; 8] = head[8..16].try_into().map_err(|_| damaged())?;
        let data = data_of(body);
        match &mut self.file {
            None => {
                let mut draft = Draft::begin(&self.path)?;
                draft.write_all(SIGNATURE)?;
                draft.write_all(head)?;
                draft.write_all(&piece(*b"acTL", &counted(1)))?;
                let mut picture = piece(*b"fcTL", &control(0, size, self.delay));
                picture.extend(piece(*b"IDAT", &data));
                draft.write_all(&picture)?;
                draft.write_all(&piece(*b"IEND", &[]))?;
                self.end = (SIGNATURE.len() + HEAD + AROUND + 8 + picture.len()) as u64;
                self.file = Some(draft.replace()?);
                self.sequence = 1;
            }
            Some(file) => {
                let mut picture = piece(*b"fcTL", &control(self.sequence, size, self.delay));
                picture.extend(piece(*b"fdAT", &[&(self.sequence + 1).to_be_bytes()[..], &data].concat()));
                let length = picture.len() as u64;
                picture.extend(piece(*b"IEND", &[]));
                for (at, bytes) in writes(self.end, &picture, self.pictures + 1) {
                    file.seek(SeekFrom::Start(at))?;
                    file.write_all(&bytes)?;
                    // Before what counts on it: not even a power cut turns them about.
                    file.sync()?;
                }
                self.end += length;
                self.sequence += 2;
            }
        }
        self.pictures += 1;
        Ok(())
    }
}

/// What is written where, one after another, to add a picture with a new end at the old end, so that there are so many
/// then. After each, and within the first, the file is whole: the old end stays until all but what it hides is there.
fn writes(end: u64, picture: &[u8], pictures: u32) -> [(u64, Vec<u8>); 3] {
    let (first, rest) = picture.split_at(AROUND);
    [
        (end + AROUND as u64, rest.to_vec()),
        (end, first.to_vec()),
        ((SIGNATURE.len() + HEAD) as u64, piece(*b"acTL", &counted(pictures))),
    ]
}

/// Seconds as a fraction of whole numbers.
fn fraction(seconds: f64) -> [u16; 2] {
    let rate = 1.0 / seconds;
    if (rate - rate.round()).abs() < 1e-6 * rate && (1.0..=f64::from(u16::MAX)).contains(&rate.round()) {
        return [1, rate.round() as u16];
    }
    // A float becomes the nearest number that there is.
    [(1000.0 * seconds).round() as u16, 1000]
}

/// How many pictures there are; they are shown again and again.
fn counted(pictures: u32) -> [u8; 8] {
    let mut data = [0; 8];
    data[..4].copy_from_slice(&pictures.to_be_bytes());
    data
}

/// What is said of a picture: its number, size, place, time; it takes the place of the one before.
fn control(sequence: u32, size: [u8; 8], [time, of]: [u16; 2]) -> Vec<u8> {
    let mut data = sequence.to_be_bytes().to_vec();
    data.extend(size);
    data.extend([0; 8]);
    data.extend(time.to_be_bytes());
    data.extend(of.to_be_bytes());
    data.extend([0; 2]);
    data
}

/// The data of a picture, of all its pieces.
fn data_of(mut body: &[u8]) -> Vec<u8> {
    let mut data = Vec::new();
    while let Some((length, rest)) = body.split_first_chunk::<4>() {
        let length = u32::from_be_bytes(*length) as usize;
        let (Some(kind), Some(content)) = (rest.get(..4), rest.get(4..4 + length)) else { break };
        if kind == b"IDAT" {
            data.extend(content);
        }
        body = rest.get(8 + length..).unwrap_or_default();
    }
    data
}

fn piece(kind: [u8; 4], data: &[u8]) -> Vec<u8> {
    let mut piece = (data.len() as u32).to_be_bytes().to_vec();
    piece.extend(kind);
    piece.extend(data);
    let check = crc32fast::hash(&piece[4..]);
    piece.extend(check.to_be_bytes());
    piece
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(grey: u8) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 3, 2);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&[grey; 18]).unwrap();
        writer.finish().unwrap();
        bytes
    }

    #[test]
    fn after_every_picture_the_file_is_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.apng");
        let mut animated = AnimatedPng::new(path.clone(), 1.0 / 60.0);
        for count in 1..5 {
            animated.push(&picture(10 * count as u8)).unwrap();
            let mut reader =
                png::Decoder::new(io::BufReader::new(std::fs::File::open(&path).unwrap())).read_info().unwrap();
            let said = reader.info().animation_control().unwrap();
            assert_eq!((said.num_frames, said.num_plays), (count, 0));
            let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
            for number in 1..=count {
                reader.next_frame(&mut pixels).unwrap();
                assert_eq!(pixels, [10 * number as u8; 18]);
                let control = reader.info().frame_control().unwrap();
                assert_eq!((control.delay_num, control.delay_den), (1, 60));
            }
            reader.finish().unwrap();
        }
        let file = std::fs::read(&path).unwrap();
        let end = file.len() - AROUND;
        let mut next = piece(*b"fcTL", &control(7, [0, 0, 0, 3, 0, 0, 0, 2], [1, 60]));
        next.extend(piece(*b"fdAT", &[&8_u32.to_be_bytes()[..], &data_of(&picture(50)[8..])].concat()));
        next.extend(piece(*b"IEND", &[]));
        let put = |file: &mut Vec<u8>, at: u64, bytes: &[u8]| {
            file.resize(file.len().max(at as usize + bytes.len()), 0);
            file[at as usize..at as usize + bytes.len()].copy_from_slice(bytes);
        };
        let steps = writes(end as u64, &next, 5);
        let mut states = vec![];
        for whole in 0..=3 {
            let mut state = file.clone();
            steps[..whole].iter().for_each(|(at, bytes)| put(&mut state, *at, bytes));
            states.push((if whole == 3 { 5 } else { 4 }, state));
        }
        let mut half = file;
        put(&mut half, steps[0].0, &steps[0].1[..20]);
        states.push((4, half));
        for (count, state) in states {
            let mut reader = png::Decoder::new(io::Cursor::new(state)).read_info().unwrap();
            assert_eq!(reader.info().animation_control().unwrap().num_frames, count);
            let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
            for number in 1..=count {
                reader.next_frame(&mut pixels).unwrap();
                assert_eq!(pixels, [10 * number as u8; 18]);
            }
            reader.finish().unwrap();
        }
        assert!(animated.push(b"no picture").is_err());
        assert_eq!(fraction(0.03), [30, 1000]);
    }
}
