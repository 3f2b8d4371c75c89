//! Fibres as tubes, in their own colours or by what they carry, with the places where they are broken.

use super::body_drawer::{BodyDrawer, THROUGH};
use super::list::{DrawList, Faces, Line, Mesh, PickId, PickKind, Points, Size, SurfaceStyle};
use super::tube::{Tube, tube};
use super::{Colour, colour_map};
use crate::solver::snapshot::BreakPlace;
use glam::{DVec3, Vec3};
use std::ops::Range;

/// Radii in particle spacings D: fibres thin enough to stay apart when drawn a spacing from each other, structure
/// particles as beads on them, marks of breaks larger than either.
const FIBRE_RADIUS: f64 = 0.22;
const SELECTED_RADIUS: f64 = 0.32;
const STRUCTURE_RADIUS: f64 = 0.30;
const BREAK_RADIUS: f64 = 0.40;
/// Where a vertex has come apart both ends are drawn back so far, in particle spacings, and at most by this share of an
/// edge.
const BREAK_GAP: f64 = 0.55;
const MOST_GAP: f32 = 0.7;
/// Share by which a fibre is drawn as if it were shorter at most: it bulges to twice its radius.
const MOST_SHORTER: f64 = 0.75;
/// Share of a mark that shows through what is in front.
const BREAK_THROUGH: f32 = 0.7;

/// What there is to draw of a fibre.
pub(super) struct FibreShape<'a> {
    /// Structure particles [m].
    pub(super) vertices: &'a [DVec3],
    /// Where it is broken.
    pub(super) breaks: Vec<BreakPlace>,
    /// What its edges carry [N], with the end of the range; none where that is not asked for.
    pub(super) tensions: Option<(f64, &'a [f64])>,
    /// The drive of its edges and the share by which that has them want to be shorter; none where that is not asked
    /// for.
    pub(super) activations: Option<&'a [[f64; 2]]>,
    /// Its own colour.
    pub(super) colour: Colour,
}

impl FibreShape<'_> {
    /// The vertices of its unbroken parts. Parts that a vertex has come apart at share it, those that an edge has do
    /// not.
    fn parts(&self) -> Vec<Range<usize>> {
        let mut cuts: Vec<(usize, usize)> = self
            .breaks
            .iter()
            .map(|place| match *place {
                BreakPlace::Vertex(vertex) => (vertex as usize + 1, vertex as usize),
                BreakPlace::Edge(vertex) => (vertex as usize + 1, vertex as usize + 1),
            })
            .collect();
        cuts.sort_unstable();
        let ends = cuts.iter().map(|&(end, _)| end).chain([self.vertices.len()]);
        let starts = [0].into_iter().chain(cuts.iter().map(|&(_, start)| start));
        let whole = starts.zip(ends).map(|(start, end)| start..end.min(self.vertices.len()));
        whole.filter(|part| !part.is_empty()).collect()
    }

    /// Draws the ends of a part that are broken vertices back by `gap` [m].
    fn draw_back(&self, part: &Range<usize>, points: &mut [Vec3], gap: f32) {
        let broken = |vertex: usize| self.breaks.contains(&BreakPlace::Vertex(vertex as u32));
        let back = |end: Vec3, next: Vec3| {
            let edge = next - end;
            end + edge.clamp_length_max(gap.min(MOST_GAP * edge.length()))
        };
        if let [first, second, ..] = points
            && broken(part.start)
        {
            *first = back(*first, *second);
        }
        if let [.., second, last] = points
            && broken(part.end - 1)
        {
            *last = back(*last, *second);
        }
    }

    /// Where the breaks are [m].
    fn broken_at(&self) -> Vec<DVec3> {
        let vertex = |k: u32| self.vertices.get(k as usize).copied();
        let at = |place: &BreakPlace| match *place {
            BreakPlace::Vertex(k) => vertex(k),
            BreakPlace::Edge(k) => Some(vertex(k)?.midpoint(vertex(k + 1)?)),
        };
        self.breaks.iter().filter_map(at).collect()
    }

    /// Colours of points along its vertices, as [`Tube::along`] counts from vertex `first`: by what its edges carry, or
    /// by their drive from 0 to 1.
    fn tints(&self, along: &[f32], first: usize) -> Vec<[u8; 3]> {
        let of = |place: f32| match (self.tensions, self.activations) {
            (Some((range, tensions)), _) => {
                let force = between(tensions.len(), |edge| tensions[edge], place, first)?;
                Some(colour_map::bytes(colour_map::signed_colour((force / range) as f32)))
            }
            (None, Some(activations)) => {
                let value = between(activations.len(), |edge| activations[edge][0], place, first)?;
                Some(colour_map::bytes(colour_map::colour(value as f32)))
            }
            (None, None) => None,
        };
        along.iter().filter_map(|&place| of(place)).collect()
    }

    /// Has a tube of this radius [m] bulge where its edges want to be shorter, so that it keeps its volume: r /
    /// sqrt(1 - c).
    fn bulge(&self, tube: &mut Tube, radius: f32, first: usize) {
        let Some(activations) = self.activations else { return };
        for (vertex, &place) in tube.vertices.iter_mut().zip(&tube.along) {
            if let Some(shorter) = between(activations.len(), |edge| activations[edge][1], place, first) {
                vertex.position += ((1.0 - shorter.min(MOST_SHORTER)).powf(-0.5) as f32 - 1.0) * radius * vertex.normal;
            }
        }
    }
}

/// What stands in the middles of edges, at a place along vertices that [`Tube::along`] counts from vertex `first`: from
/// middle to middle it changes evenly. Nothing of no edges.
fn between(count: usize, value: impl Fn(usize) -> f64, place: f32, first: usize) -> Option<f64> {
    let last = count.checked_sub(1)?;
    let at = (f64::from(place) + first as f64 - 0.5).clamp(0.0, last as f64);
    let (before, share) = (at as usize, at.fract());
    let after = (before + 1).min(last);
    Some(value(before) + share * (value(after) - value(before)))
}

impl BodyDrawer<'_> {
    pub(super) fn fibre(&self, index: u32, shape: &FibreShape<'_>, [has_skin, clear]: [bool; 2], list: &mut DrawList) {
        let selected = self.display.selected.contains(&[self.index, index]);
        // Inside an opaque skin that nothing cuts open there is nothing to see of them but ends that stick out.
        let tubes = self.display.fibres && (!has_skin || clear || self.display.slice.is_some());
        let radius = self.spacing * if selected { SELECTED_RADIUS } else { FIBRE_RADIUS };
        let mut pick = None;
        for part in shape.parts() {
            let mut points: Vec<Vec3> = shape.vertices[part.clone()].iter().map(|&at| list.local(at)).collect();
            shape.draw_back(&part, &mut points, (BREAK_GAP * self.spacing) as f32);
            let mut tube = tube(&points, radius as f32);
            shape.bulge(&mut tube, radius as f32, part.start);
            let Tube { vertices, indices, along } = tube;
            if tubes && !indices.is_empty() {
                let id = PickId { body: self.index, kind: PickKind::Fibre, index };
                list.meshes.push(Mesh {
                    faces: Faces::Free(vertices, indices),
                    colour: shape.colour,
                    tints: shape.tints(&along, part.start),
                    surface: SurfaceStyle::Solid,
                    casts_shadow: !has_skin,
                    pick: *pick.get_or_insert_with(|| list.picks.register(id, 1)),
                });
            }
            if selected {
                let points = points.into_iter().filter(|point| point.is_finite()).collect();
                list.lines.push(Line { points, width: 1.5, colour: self.theme.accent, through: THROUGH, pick: 0 });
            }
        }
        if self.display.fibres {
            self.breaks(shape, list);
        }
        if self.display.structure {
            let pick = self.number(PickKind::StructureVertex { fibre: index }, shape.vertices.len(), list);
            self.balls(shape.vertices, STRUCTURE_RADIUS, self.theme.structure, pick, list);
        }
    }

    /// Marks the places where a fibre is broken, faintly where something is in front.
    fn breaks(&self, shape: &FibreShape<'_>, list: &mut DrawList) {
        let centres: Vec<Vec3> = shape.broken_at().into_iter().map(|point| list.local(point)).collect();
        if !centres.is_empty() {
            let size = Size::Metres((BREAK_RADIUS * self.spacing) as f32);
            let colour = self.theme.broken;
            list.points.push(Points { centres, size, colour, tints: Vec::new(), through: BREAK_THROUGH, pick: 0 });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape<'a>(vertices: &'a [DVec3], breaks: &[BreakPlace], tensions: Option<(f64, &'a [f64])>) -> FibreShape<'a> {
        FibreShape { vertices, breaks: breaks.to_vec(), tensions, activations: None, colour: Colour::hex(0x80_8080) }
    }

    #[test]
    fn parts_share_a_broken_vertex_and_leave_out_a_broken_edge() {
        let line: Vec<DVec3> = (0..8).map(|k| DVec3::X * f64::from(k)).collect();
        assert_eq!(shape(&line, &[], None).parts().first(), Some(&(0..8)));
        let broken = shape(&line, &[BreakPlace::Edge(5), BreakPlace::Vertex(2)], None);
        assert_eq!(broken.parts(), [0..3, 2..6, 6..8]);
        assert_eq!(broken.broken_at(), [5.5 * DVec3::X, 2.0 * DVec3::X]);
        // A place that the fibre does not have does no harm.
        assert_eq!(shape(&line, &[BreakPlace::Edge(40)], None).broken_at(), []);
    }

    #[test]
    fn the_ends_at_a_broken_vertex_leave_a_gap() {
        let line: Vec<DVec3> = (0..5).map(|k| DVec3::X * f64::from(k)).collect();
        let shape = shape(&line, &[BreakPlace::Vertex(2)], None);
        let ends = shape.parts().into_iter().map(|part| {
            let mut points: Vec<Vec3> = shape.vertices[part.clone()].iter().map(|at| at.as_vec3()).collect();
            shape.draw_back(&part, &mut points, 0.25);
            [points[0].x, points[points.len() - 1].x]
        });
        assert_eq!(ends.collect::<Vec<_>>(), [[0.0, 1.75], [2.25, 4.0]]);
    }

    #[test]
    fn colours_go_from_middle_to_middle_of_the_edges() {
        let line: Vec<DVec3> = (0..3).map(|k| DVec3::X * f64::from(k)).collect();
        let byte = |place: f32| colour_map::bytes(colour_map::signed_colour(place));
        let shape = shape(&line, &[], Some((2.0, &[-2.0, 1.0])));
        assert_eq!(shape.tints(&[0.0, 0.5, 1.0, 1.5, 2.0], 0), [-1.0, -1.0, -0.25, 0.5, 0.5].map(byte));
        assert_eq!(shape.tints(&[0.0, 1.0], 1), [-0.25, 0.5].map(byte));
    }

    #[test]
    fn what_acts_is_coloured_by_its_drive_and_bulges_by_what_it_is_shorter() {
        let line: Vec<DVec3> = (0..4).map(|k| DVec3::X * f64::from(k)).collect();
        let activations = [[0.0, 0.0], [0.5, 0.36], [1.0, 0.75]];
        let acting = FibreShape { activations: Some(&activations), ..shape(&line, &[], None) };
        let byte = |value: f32| colour_map::bytes(colour_map::colour(value));
        assert_eq!(acting.tints(&[0.0, 1.5, 2.0, 3.0], 0), [0.0, 0.5, 0.75, 1.0].map(byte));
        let points: Vec<Vec3> = line.iter().map(|at| at.as_vec3()).collect();
        let mut bulged = tube(&points, 0.1);
        acting.bulge(&mut bulged, 0.1, 0);
        // Volume of a short piece: pi r² l, l shorter by its share.
        let mut seen = 0;
        for (vertex, place) in bulged.vertices.iter().zip(&bulged.along) {
            let radius = vertex.position.y.hypot(vertex.position.z);
            for (middle, shorter) in [(0.5, 0.0), (1.5, 0.36), (2.5, 0.75)] {
                if *place == middle {
                    seen += 1;
                    assert!((radius * radius * (1.0 - shorter) - 0.01).abs() < 1e-5, "{radius} at {place}");
                }
            }
        }
        assert!(seen > 20, "{seen}");
        let mut still = tube(&points, 0.1);
        shape(&line, &[], None).bulge(&mut still, 0.1, 0);
        assert_eq!(still, tube(&points, 0.1));
    }
}
