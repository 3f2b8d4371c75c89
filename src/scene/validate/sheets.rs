//! Checks of sheets.

use super::brief;
use super::check::{At, Checked, Ids, direction, finite, fraction, not_negative, number, require, vector, within};
use super::drives::still;
use super::lines::stroke;
use crate::scene::drive::CONTRACTION;
use crate::scene::{
    Body, Drive, Fibre, GrainAlong, MAX_SHEET_VERTICES, MAX_SHEETS, SEAM_STRETCH, Seam, SharedDrive, Sheet,
    SheetActivation, SheetSource, SheetStiffness, SheetTriangles, SweptStrokes,
};
use std::collections::HashMap;

/// Greatest Poisson's ratio in the surface.
const MAX_POISSON: f64 = 0.49;

pub(super) fn sheets(at: &At<'_>, body: &Body) -> Checked {
    let (sheets, shared) = (&body.sheets, &body.drives);
    require(at, &[(); 0], sheets.len() <= MAX_SHEETS, &format!("has {} sheets", sheets.len()), || {
        format!("give at most {MAX_SHEETS}")
    })?;
    let mut ids = Ids::of("sheet");
    for (index, sheet) in sheets.iter().enumerate() {
        let at = at.item(index);
        ids.add(&at.field("id"), &sheet.id)?;
        source(&at.field("source"), &sheet.source)?;
        stiffness(&at.field("stiffness"), &sheet.stiffness, &sheet.source)?;
        fraction(&at.field("volume_fraction"), sheet.volume_fraction)?;
        if let Some(of) = &sheet.activation {
            activation(&at.field("activation"), of, sheet, shared)?;
        }
        if let Some(of) = &sheet.seam {
            seam(&at.field("seam"), of, sheet, body)?;
        }
    }
    Ok(())
}

fn seam(at: &At<'_>, of: &Seam, sheet: &Sheet, body: &Body) -> Checked {
    let [least, most] = SEAM_STRETCH;
    within(&at.field("stretch"), of.stretch, least, most, "")?;
    let problem = "is of a sheet that acts, and a seam carries nothing";
    require(at, of, sheet.activation.is_none(), problem, || "leave this or the sheet's activation out")?;
    let is_elastic = body.material.plasticity.is_none() && body.material.viscosity.is_none();
    let problem = "is of a body whose material flows or yields";
    require(at, of, is_elastic, problem, || "leave this or the material's `plasticity` and `viscosity` out")?;
    let thickens = |fibre: &Fibre| fibre.activation.as_ref().is_some_and(|of| of.volume_fraction.is_some());
    let problem = "is of a body with a fibre whose volume fraction is driven";
    require(at, of, !body.fibres.iter().any(thickens), problem, || "leave this or the fibre's `volume_fraction` out")
}

fn source(at: &At<'_>, source: &SheetSource) -> Checked {
    match source {
        SheetSource::Strokes(SweptStrokes { first, second, .. }) => {
            let at = at.field("strokes");
            stroke(&at.field("first"), first)?;
            let place = at.field("second");
            stroke(&place, second)?;
            let (one, other) = (first.view, second.view);
            require(&place.field("view"), &other, one != other, "is the view of the first stroke too", || {
                format!("draw the second stroke in another view than {}", brief(&one))
            })
        }
        SheetSource::Grid(rows) => grid(&at.field("grid"), rows),
        SheetSource::Triangles(of) => triangles(&at.field("triangles"), of),
    }
}

fn grid(at: &At<'_>, rows: &[Vec<[f64; 3]>]) -> Checked {
    require(at, &[(); 0], rows.len() >= 2, "has too few rows to be a surface", || "give 2 or more")?;
    let long = rows[0].len();
    let count = rows.len().saturating_mul(long);
    few(at, count)?;
    for (index, row) in rows.iter().enumerate() {
        let at = at.item(index);
        let problem = format!("has {} vertices, and the first row {long}", row.len());
        let holds = row.len() >= 2 && row.len() == long;
        require(&at, &[(); 0], holds, &problem, || "give 2 or more, as many in every row")?;
        row.iter().enumerate().try_for_each(|(index, point)| vector(&at.item(index), point, "m"))?;
    }
    Ok(())
}

fn few(at: &At<'_>, vertices: usize) -> Checked {
    require(at, &[(); 0], vertices <= MAX_SHEET_VERTICES, &format!("has {vertices} vertices"), || {
        format!("give at most {MAX_SHEET_VERTICES}")
    })
}

fn triangles(at: &At<'_>, of: &SheetTriangles) -> Checked {
    let vertices = at.field("vertices");
    few(&vertices, of.vertices.len())?;
    of.vertices.iter().enumerate().try_for_each(|(index, point)| vector(&vertices.item(index), point, "m"))?;
    let at = at.field("triangles");
    require(&at, &[(); 0], !of.triangles.is_empty(), "is empty", || "give one triangle at least")?;
    let mut edges: HashMap<[u32; 2], u32> = HashMap::new();
    for (index, triangle) in of.triangles.iter().enumerate() {
        let at = at.item(index);
        let [a, b, c] = *triangle;
        let there = triangle.iter().all(|&corner| (corner as usize) < of.vertices.len());
        require(&at, triangle, there, "names a vertex that is not there", || {
            format!("give numbers below {}", of.vertices.len())
        })?;
        require(&at, triangle, a != b && b != c && c != a, "names a vertex twice", || "give three of them")?;
        for edge in [[a, b], [b, c], [c, a]] {
            let met = edges.entry([edge[0].min(edge[1]), edge[0].max(edge[1])]).or_default();
            *met += 1;
            let problem = "has an edge that two triangles before it share";
            require(&at, triangle, *met <= 2, problem, || "give branches of a surface as sheets of their own")?;
        }
    }
    Ok(())
}

fn stiffness(at: &At<'_>, of: &SheetStiffness, source: &SheetSource) -> Checked {
    not_negative(&at.field("et"), of.et, "N/m")?;
    within(&at.field("poisson_ratio"), of.poisson_ratio, 0.0, MAX_POISSON, "")?;
    not_negative(&at.field("bending"), of.bending, "N m")?;
    let Some(grain) = &of.grain else { return Ok(()) };
    let at = at.field("grain");
    let place = at.field("along");
    match &grain.along {
        GrainAlong::Direction(axis) => direction(&place.field("direction"), axis)?,
        along => {
            let has_rows = !matches!(source, SheetSource::Triangles(_));
            let problem = "is no way of a sheet of triangles, which has no strokes or rows";
            require(&place, along, has_rows, problem, || "give a {\"direction\": [x, y, z]}")?;
        }
    }
    not_negative(&at.field("et"), grain.et, "N/m")
}

fn activation(at: &At<'_>, of: &SheetActivation, sheet: &Sheet, shared: &[SharedDrive]) -> Checked {
    // A wave runs along a line, which a sheet is not.
    still(&at.field("drive"), &of.drive, shared)?;
    let has_ways = !matches!(sheet.source, SheetSource::Triangles(_)) || sheet.stiffness.grain.is_some();
    let problem = "is of triangles without a grain, along which they could become shorter";
    require(at, of, has_ways, problem, || "give the sheet's stiffness a grain with a direction")?;
    let curl = at.field("curl_degrees_per_metre");
    of.curl_degrees_per_metre.iter().enumerate().try_for_each(|(k, &rate)| finite(&curl.item(k), rate, "degrees/m"))?;
    let bends = sheet.stiffness.bending > 0.0 || of.curl_degrees_per_metre == [0.0; 2];
    let problem = "is of a sheet that does not resist bending";
    require(&curl, &of.curl_degrees_per_metre, bends, problem, || "give the sheet's stiffness a `bending` above 0")?;
    let [least, greatest] = of.drive.resolved(shared).and_then(Drive::range).unwrap_or([0.0; 2]);
    let [low, high] = CONTRACTION;
    for (axis, &contract) in of.contract.iter().enumerate() {
        let place = at.field("contract");
        let at = place.item(axis);
        finite(&at, contract, "")?;
        for value in [least, greatest] {
            let share = contract * value;
            let holds = (low..=high).contains(&share);
            let problem = format!(
                "makes the sheet shorter by {} of its size, where its drive is {}",
                number(share),
                number(value)
            );
            require(&at, &contract, holds, &problem, || {
                format!("keep contraction times drive from {} to {}", number(low), number(high))
            })?;
        }
    }
    Ok(())
}
