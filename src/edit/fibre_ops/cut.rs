//! From one fibre to several: copies and halves.

use super::edited::{Edited, LEAST_VERTICES, Sampling, with_vertices};
use super::error::FibreEditError;
use super::vertices::vertices;
use crate::geometry::curve::arc_length;
use crate::scene::{Fibre, SharedDrive};

/// Copies of fibres under new identifiers and names. `among` are the fibres of the body that the copies go into.
pub fn copies<'a>(of: impl IntoIterator<Item = &'a Fibre>, among: &[Fibre]) -> Vec<Fibre> {
    let mut taken: Vec<String> = among.iter().map(|fibre| fibre.id.clone()).collect();
    let mut made = Vec::new();
    for fibre in of {
        let copy = renamed(fibre, &taken);
        taken.push(copy.id.clone());
        made.push(copy);
    }
    made
}

/// The fibre under the first free number: "fibre-4" and "Fibre 4" after three of them, "rib-2" and "Rib 2" after "rib".
fn renamed(fibre: &Fibre, taken: &[String]) -> Fibre {
    let stem_of = |text: &str, joint: char| {
        let stem = text.trim_end_matches(|c: char| c.is_ascii_digit());
        (stem.trim_end_matches(joint).to_owned(), stem.len() < text.len())
    };
    let (stem, numbered) = stem_of(&fibre.id, '-');
    let stem = if stem.trim().is_empty() { "fibre".to_owned() } else { stem };
    let first = if numbered { 1 } else { 2 };
    let is_free = |number: &usize| !taken.contains(&format!("{stem}-{number}"));
    let number = (first..=first + taken.len()).find(is_free).unwrap_or(first);
    let name = match fibre.name.as_str() {
        "" => String::new(),
        name => format!("{} {number}", stem_of(name, ' ').0).trim_start().to_owned(),
    };
    Fibre { id: format!("{stem}-{number}"), name, ..fibre.clone() }
}

/// Cuts a fibre in two at a vertex, which ends the first half and begins the second. The first half stays under the
/// fibre's identifier; the second is new among the fibres of the body. Nothing carries bending or tension from half
/// to half. A wave that runs along the fibre goes on along the second half as it did: where that is one of the `shared`
/// drives of the body, the half has one of its own from then on.
///
/// # Errors
/// No such vertex, a half of fewer than 3 vertices, or strokes that give no curve.
pub fn split(
    fibre: &Fibre,
    vertex: usize,
    among: &[Fibre],
    shared: &[SharedDrive],
    sampling: Sampling,
) -> Result<(Edited, Fibre), FibreEditError> {
    let vertices = vertices(fibre, sampling)?;
    let count = vertices.len();
    if vertex >= count {
        return Err(FibreEditError::NoVertex { index: vertex, count });
    }
    let left = (vertex + 1).min(count - vertex);
    if left < LEAST_VERTICES {
        return Err(FibreEditError::Stub { index: vertex, left });
    }
    let first = with_vertices(fibre, &vertices[..=vertex])?;
    let second = with_vertices(fibre, &vertices[vertex..])?.fibre;
    let mut second = copies([&second], among).remove(0);
    if let Some(activation) = &mut second.activation
        && let Some(mut drive) = activation.drive.resolved(shared).cloned()
        && let Some(wave) = drive.wave_mut()
        && let Some(wavelength) = wave.wavelength
    {
        wave.phase_degrees += 360.0 * (arc_length(&vertices[..=vertex]) / wavelength).fract();
        activation.drive = drive;
    }
    Ok((first, second))
}
