//! Checks of elements.

use super::check::{At, Checked, Ids, finite, fraction, not_negative, number, positive, require, vector};
use super::drives::{excitation, share, still};
use crate::scene::element::{BENT, MOST_TURNED};
use crate::scene::{
    Drive, Element, ElementActivation, ElementLaw, ElementMeasure, MAX_ELEMENTS, MAX_TABLE_POINTS, SharedDrive,
};
use glam::DVec3;

/// Length, area and volume, over those of the points' extent, below which there is nothing to measure.
const LEAST: f64 = 1e-6;

pub(super) fn elements(at: &At<'_>, elements: &[Element], shared: &[SharedDrive]) -> Checked {
    require(at, &[(); 0], elements.len() <= MAX_ELEMENTS, &format!("has {} elements", elements.len()), || {
        format!("give at most {MAX_ELEMENTS}")
    })?;
    let mut ids = Ids::of("element");
    for (index, element) in elements.iter().enumerate() {
        let at = at.item(index);
        ids.add(&at.field("id"), &element.id)?;
        points(&at.field("points"), element)?;
        law(&at.field("law"), element)?;
        if let Some(of) = &element.activation {
            activation(&at.field("activation"), of, element, shared)?;
        }
    }
    Ok(())
}

fn points(at: &At<'_>, element: &Element) -> Checked {
    let (count, measure) = (element.measure.points(), element.measure);
    let given = element.points.len();
    let problem = format!("has {given} points, and {} is of {count}", measure.word());
    require(at, &[(); 0], given == count, &problem, || format!("give {count} points"))?;
    element.points.iter().enumerate().try_for_each(|(index, point)| vector(&at.item(index), point, "m"))?;
    let x: Vec<DVec3> = element.points.iter().map(|&x| DVec3::from_array(x)).collect();
    let extent = x.iter().map(|at| at.distance(x[0])).fold(0.0, f64::max);
    let apart = |a: usize, b: usize| x[a].distance(x[b]) > LEAST * extent;
    let area = |a: usize, b: usize, c: usize| (x[b] - x[a]).cross(x[c] - x[a]).length() > LEAST * extent * extent;
    let measures = match measure {
        ElementMeasure::Length | ElementMeasure::Twist => apart(0, 1),
        ElementMeasure::Turn => apart(0, 1) && apart(1, 2),
        ElementMeasure::Area => area(0, 1, 2),
        ElementMeasure::Volume => {
            (x[1] - x[0]).dot((x[2] - x[0]).cross(x[3] - x[0])).abs() > LEAST * extent * extent * extent
        }
        ElementMeasure::Dihedral => area(0, 1, 2) && area(0, 1, 3),
    };
    let problem = "leave nothing to measure: some lie on each other, on one line or in one plane";
    require(at, &element.points, measures, problem, || "move them apart")
}

fn law(at: &At<'_>, element: &Element) -> Checked {
    let unit = element.measure.unit();
    match &element.law {
        ElementLaw::Spring(of) => not_negative(&at.field("spring").field("stiffness"), of.stiffness, unit),
        ElementLaw::TensionOnly(of) => not_negative(&at.field("tension_only").field("stiffness"), of.stiffness, unit),
        ElementLaw::Muscle(of) => {
            let at = at.field("muscle");
            not_negative(&at.field("force"), of.force, unit)?;
            positive(&at.field("width"), of.width, "")?;
            fraction(&at.field("width"), of.width)
        }
        ElementLaw::Table(points) => table(&at.field("table"), points, unit),
    }
}

fn table(at: &At<'_>, points: &[[f64; 2]], unit: &str) -> Checked {
    let count = points.len();
    let holds = (2..=MAX_TABLE_POINTS).contains(&count);
    require(at, &[(); 0], holds, &format!("has {count} points"), || format!("give 2 to {MAX_TABLE_POINTS}"))?;
    let mut last = None;
    for (index, &[s, force]) in points.iter().enumerate() {
        let at = at.item(index);
        finite(&at.item(0), s, "")?;
        finite(&at.item(1), force, unit)?;
        if let Some(last) = last {
            require(&at.item(0), &s, s > last, "does not come after the point before it", || {
                format!("give points in the order of their first number, this one above {}", number(last))
            })?;
        }
        last = Some(s);
    }
    Ok(())
}

/// Checks how far a drive turns what measures an angle, and that a bend stays one.
fn turned(at: &At<'_>, degrees: f64, element: &Element, range: [f64; 2]) -> Checked {
    let farthest = range.map(|value| (value * degrees).abs()).into_iter().fold(0.0, f64::max);
    let problem = format!("is to turn by {} degrees", number(farthest));
    let [least, most] = element.turn_limits(degrees);
    let within = least <= range[0] && range[1] <= most;
    require(at, &degrees, farthest <= MOST_TURNED || within, &problem, || {
        format!("keep it from -{MOST_TURNED} to {MOST_TURNED}, times its drive")
    })?;
    let Some(drawn) = element.drawn_bend() else { return Ok(()) };
    let turned = range.map(|value| drawn + value * degrees);
    let (least, most) = (drawn.min(turned[0]).min(turned[1]), drawn.max(turned[0]).max(turned[1]));
    let problem = format!("turns a bend of {} degrees from {} to {}", number(drawn), number(least), number(most));
    let bent = (BENT[0]..=BENT[1]).contains(&drawn);
    require(
        at,
        &degrees,
        bent && within,
        &problem,
        || "keep it above 0 and below 180, or measure a `dihedral`, which goes both ways",
    )
}

fn activation(at: &At<'_>, of: &ElementActivation, element: &Element, shared: &[SharedDrive]) -> Checked {
    let place = at.field("drive");
    still(&place, &of.drive, shared)?;
    if matches!(element.law, ElementLaw::Muscle(_)) {
        excitation(&place, &of.drive, shared)?;
    }
    let place = at.field("turn_degrees");
    finite(&place, of.turn_degrees, "degrees")?;
    let range = of.drive.resolved(shared).and_then(Drive::range).unwrap_or([0.0; 2]);
    if of.turn_degrees != 0.0 {
        turned(&place, of.turn_degrees, element, range)?;
    }
    let angle = element.measure.is_angle();
    let problem = format!("is of a measure of {}, which is no angle", element.measure.word());
    require(&place, &of.turn_degrees, angle || of.turn_degrees == 0.0, &problem, || "give `contract`")?;
    let place = at.field("contract");
    let problem = format!("is of a measure of {}, which is an angle", element.measure.word());
    require(&place, &of.contract, !angle || of.contract == 0.0, &problem, || "give `turn_degrees`")?;
    share(&place, of.contract, "element smaller by {} of its size", range)
}
