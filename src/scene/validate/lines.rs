//! Checks of lines: where a fibre or a tube runs.

use super::brief;
use super::check::{At, Checked, require, vector};
use crate::scene::{FibreSource, ViewStroke};

pub(super) fn source(at: &At<'_>, source: &FibreSource) -> Checked {
    match source {
        FibreSource::Vertices(vertices) => {
            let at = at.field("vertices");
            require(&at, vertices, vertices.len() >= 3, "has too few vertices to bend", || "give 3 or more")?;
            for (index, point) in vertices.iter().enumerate() {
                vector(&at.item(index), point, "m")?;
                let repeated = index > 0 && *point == vertices[index - 1];
                require(&at.item(index), point, !repeated, "repeats the vertex before it", || "leave one of them out")?;
            }
            Ok(())
        }
        FibreSource::Strokes(pair) => {
            let at = at.field("strokes");
            stroke(&at.field("first"), &pair.first)?;
            let second = at.field("second");
            stroke(&second, &pair.second)?;
            let (one, other) = (pair.first.view, pair.second.view);
            require(&second.field("view"), &other, one != other, "is the view of the first stroke too", || {
                format!("draw the second stroke in another view than {}", brief(&one))
            })
        }
    }
}

pub(super) fn stroke(at: &At<'_>, stroke: &ViewStroke) -> Checked {
    let at = at.field("points");
    require(&at, &stroke.points, stroke.points.len() >= 2, "is no line", || "give 2 points or more")?;
    let points = stroke.points.iter().enumerate();
    points.into_iter().try_for_each(|(index, point)| vector(&at.item(index), point, "m"))
}
