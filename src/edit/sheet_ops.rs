//! What can be done to a sheet: pure functions from a sheet to the sheet as it is to be, for a
//! [`Command`](super::Command) to put into the document.
//!
//! As with fibres, strokes stay strokes where some pair of them gives what is asked for: under moves, scalings, and
//! turns and mirrorings that take axes to axes. Under any other they become the rows of vertices with which they were
//! simulated.

use super::fibre_ops::{FibreEditError, Sampling, Transform};
use crate::scene::{GrainAlong, Material, Sheet, SheetSource, SheetStiffness, SheetTriangles, SweptStrokes};
use glam::DVec3;

/// A new sheet is this many times as stiff as the material that it displaces, so that its effect is plain.
pub const STIFFER: f64 = 10.0;
/// Share of the material that is sheet in the surface of a new sheet.
pub const NEW_VOLUME_FRACTION: f64 = 0.5;
/// Thickness of the material that a sheet displaces, in support radii: twice the kernel's integral over its radius.
const DISPLACED: f64 = 0.8;
/// Bending stiffness of a new sheet over its Et, in particle spacings squared.
const BENDING: f64 = 0.02;

/// Et [N/m] of the material that a sheet displaces.
pub fn displaced(material: &Material) -> f64 {
    material.young_modulus * DISPLACED * material.support_radius
}

/// A stiffness so many times that of the material that a sheet displaces, without a grain.
pub fn stiffness_of(material: &Material, times: f64) -> SheetStiffness {
    let et = two_figures(times * displaced(material));
    SheetStiffness::new(et, two_figures(BENDING * et * material.spacing().powi(2)))
}

fn two_figures(value: f64) -> f64 {
    let scale = 10_f64.powf(value.log10().floor() - 1.0);
    (value / scale).round() * scale
}

/// Moves, turns, mirrors or scales a sheet, with the direction of its grain.
///
/// # Errors
/// Numbers that are not finite, or strokes that sweep no surface.
pub fn transform(sheet: &Sheet, by: &Transform, sampling: Sampling) -> Result<Sheet, FibreEditError> {
    let point = |at: &[f64; 3]| by.apply(DVec3::from_array(*at)).to_array();
    let source = match &sheet.source {
        SheetSource::Strokes(strokes) => {
            if let Some([first, second]) = by.carried([&strokes.first, &strokes.second]) {
                SheetSource::Strokes(SweptStrokes { first, second, extra: strokes.extra.clone() })
            } else {
                let swept = strokes.swept(sampling.model_diagonal, sampling.spacing)?;
                let rows = swept.vertices.chunks(swept.to_a_row);
                SheetSource::Grid(rows.map(|row| row.iter().map(|&at| by.apply(at).to_array()).collect()).collect())
            }
        }
        SheetSource::Grid(rows) => SheetSource::Grid(rows.iter().map(|row| row.iter().map(point).collect()).collect()),
        SheetSource::Triangles(of) => {
            let vertices = of.vertices.iter().map(point).collect();
            SheetSource::Triangles(SheetTriangles { vertices, ..of.clone() })
        }
    };
    if let Some(index) = numbers(&source).position(|at| !at.iter().all(|part| part.is_finite())) {
        return Err(FibreEditError::NotFinite { index });
    }
    let mut sheet = Sheet { source, ..sheet.clone() };
    if let Some(grain) = &mut sheet.stiffness.grain
        && let GrainAlong::Direction(axis) = &mut grain.along
    {
        // Adding zero turns -0 into 0.
        *axis = (by.direction(DVec3::from_array(*axis)) + DVec3::ZERO).to_array();
    }
    Ok(sheet)
}

/// The vertices with which a sheet is simulated, before what lies outside is left out, model frame [m].
///
/// # Errors
/// Strokes that sweep no surface.
pub fn vertices(sheet: &Sheet, sampling: Sampling) -> Result<Vec<DVec3>, FibreEditError> {
    Ok(match &sheet.source {
        SheetSource::Strokes(strokes) => strokes.swept(sampling.model_diagonal, sampling.spacing)?.vertices,
        given => numbers(given).map(DVec3::from_array).collect(),
    })
}

/// Points of strokes, or vertices.
fn numbers(source: &SheetSource) -> Box<dyn Iterator<Item = [f64; 3]> + '_> {
    match source {
        SheetSource::Strokes(SweptStrokes { first, second, .. }) => {
            let points = first.points.iter().chain(&second.points);
            Box::new(points.map(|&[a, b]| [a, b, 0.0]))
        }
        SheetSource::Grid(rows) => Box::new(rows.iter().flatten().copied()),
        SheetSource::Triangles(of) => Box::new(of.vertices.iter().copied()),
    }
}

/// A copy under the first free identifier and name: "sheet-2" and "Sheet 2" after "sheet-1". `among` are the sheets of
/// the body that it goes into.
pub fn copy(sheet: &Sheet, among: &[Sheet]) -> Sheet {
    let stem = |text: &str, joint: char| {
        text.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches(joint).trim().to_owned()
    };
    let id = stem(&sheet.id, '-');
    let id = if id.is_empty() { "sheet".to_owned() } else { id };
    let is_free = |number: &usize| among.iter().all(|known| known.id != format!("{id}-{number}"));
    let number = (1..=among.len() + 1).find(is_free).unwrap_or(1);
    let name = if sheet.name.is_empty() { String::new() } else { format!("{} {number}", stem(&sheet.name, ' ')) };
    Sheet { id: format!("{id}-{number}"), name: name.trim_start().to_owned(), ..sheet.clone() }
}

/// A sheet of the same material in a body that is larger by a factor.
///
/// # Errors
/// A factor that leaves nothing.
pub(in crate::edit) fn scaled(sheet: &Sheet, factor: f64) -> Result<Sheet, FibreEditError> {
    let by = Transform::scaling(DVec3::ZERO, factor)?;
    // Strokes stay strokes and vertices vertices: nothing is sampled.
    let mut sheet = transform(sheet, &by, Sampling { model_diagonal: 1.0, spacing: 1.0 })?;
    let SheetStiffness { et, bending, grain, .. } = &mut sheet.stiffness;
    // As thick as before for its size.
    *et *= factor;
    *bending *= factor.powi(3);
    if let Some(grain) = grain {
        grain.et *= factor;
    }
    if let Some(of) = &mut sheet.activation {
        of.curl_degrees_per_metre = of.curl_degrees_per_metre.map(|rate| rate / factor);
    }
    Ok(sheet)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::ViewStroke;
    use crate::sketch::View;
    use std::f64::consts::{FRAC_PI_2, PI};

    const SAMPLING: Sampling = Sampling { model_diagonal: 0.1, spacing: 0.01 };

    fn drawn() -> Sheet {
        let first = ViewStroke::new(View::Front, [[-0.02, 0.01], [0.02, 0.02]]);
        let second = ViewStroke::new(View::Side, [[-0.03, 0.0], [0.0, 0.01], [0.03, 0.0]]);
        Sheet::swept("sheet-1", SweptStrokes::new(first, second)).with_name("Sheet 1")
    }

    fn points(sheet: &Sheet) -> Vec<DVec3> {
        match &sheet.source {
            SheetSource::Strokes(strokes) => strokes.swept(0.1, 0.01).expect("a surface").vertices,
            SheetSource::Grid(rows) => rows.iter().flatten().map(|&at| DVec3::from_array(at)).collect(),
            SheetSource::Triangles(_) => panic!("no grid"),
        }
    }

    #[test]
    fn strokes_go_along_where_axes_stay_axes_and_become_rows_elsewhere() {
        let pivot = DVec3::new(0.01, -0.02, 0.005);
        let cases = [
            (Transform::translation(pivot), true),
            (Transform::rotation(pivot, DVec3::Z, FRAC_PI_2).expect("an axis"), true),
            (Transform::rotation(pivot, DVec3::Y, -FRAC_PI_2).expect("an axis"), true),
            (Transform::rotation(pivot, DVec3::X, PI).expect("an axis"), true),
            (Transform::reflection(pivot, DVec3::X).expect("a normal"), true),
            (Transform::rotation(pivot, DVec3::new(1.0, 2.0, 0.5), 0.4).expect("an axis"), false),
        ];
        for (by, stays) in cases {
            let moved = transform(&drawn(), &by, SAMPLING).expect("a sheet");
            assert_eq!(matches!(moved.source, SheetSource::Strokes(_)), stays, "{by:?}");
            for (found, before) in points(&moved).into_iter().zip(points(&drawn())) {
                assert!(found.distance(by.apply(before)) < 1e-12, "{by:?}: {found}");
            }
        }
    }

    #[test]
    fn a_sheet_is_as_stiff_unless_told_otherwise_as_a_new_one_in_the_default_material() {
        assert_eq!(SheetStiffness::default(), stiffness_of(&Material::default(), STIFFER));
    }

    #[test]
    fn directions_turn_along_and_copies_have_names_of_their_own() {
        let stiffness = SheetStiffness::new(1.0, 1.0).with_grain(GrainAlong::Direction([1.0, 0.0, 0.0]), 2.0);
        let by = Transform::rotation(DVec3::ONE, DVec3::Z, FRAC_PI_2).expect("an axis");
        let turned = transform(&drawn().with_stiffness(stiffness), &by, SAMPLING).expect("a sheet");
        let grain = turned.stiffness.grain.expect("a grain");
        assert_eq!(grain.along, GrainAlong::Direction([0.0, 1.0, 0.0]));
        let second = copy(&drawn(), &[drawn()]);
        assert_eq!((second.id.as_str(), second.name.as_str()), ("sheet-2", "Sheet 2"));
        assert_eq!(copy(&Sheet { id: "fin".into(), ..drawn() }, &[]).id, "fin-1");
        let larger = scaled(&drawn(), 2.0).expect("a sheet");
        let of = SheetStiffness::default();
        assert_eq!((larger.stiffness.et, larger.stiffness.bending), (2.0 * of.et, 8.0 * of.bending));
        assert!(points(&larger)[3].distance(2.0 * points(&drawn())[3]) > 0.0);
    }
}
