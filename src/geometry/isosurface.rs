//! Surfaces of fields: the closed, smooth mesh on which a signed distance is zero.
//!
//! Naive surface nets: one vertex a cell that the surface passes through, one quad an edge that it cuts. Vertices are
//! then brought onto the surface and spread evenly over it, so that the mesh shows nothing of the grid.

use super::lattice::CORNERS;
use super::model::{MeshData, Model};
use glam::{DVec3, IVec3};
use rayon::prelude::*;
use std::collections::HashMap;

/// A signed distance: negative inside, with a slope near one around its zero.
pub(crate) type ScalarField<'a> = dyn Fn(DVec3) -> f64 + Sync + 'a;

/// Cells along the side of a block that is skipped as one where the surface is far.
const BLOCK: i32 = 8;

/// How much steeper than a distance the field may be.
const STEEPEST: f64 = 1.6;

/// Passes that spread the vertices over the surface.
const SPREADING: usize = 6;

/// Share of the way to the mean of its neighbours that a vertex goes in one pass.
const PACE: f64 = 0.6;

/// Meshes the zero of a field within the box from `min` to `max` [m], on a grid of cells of `cell` [m]. Features must
/// be at least two cells wide. Normals are the field's.
pub fn isosurface(field: &ScalarField<'_>, min: DVec3, max: DVec3, cell: f64) -> Model {
    let mut net = Net::new(field, min, max, cell);
    for _ in 0..SPREADING {
        net.spread(field, cell);
    }
    let triangles = net.triangles();
    let normals = net.vertices.par_iter().map(|&at| slope(field, at, 1e-3 * cell).normalize_or(DVec3::Y).as_vec3());
    let normals = normals.collect();
    let mut model = Model::default();
    model.add(MeshData { positions: net.vertices, normals, triangles, ..MeshData::default() });
    model
}

struct Net {
    vertices: Vec<DVec3>,
    quads: Vec<[u32; 4]>,
}

impl Net {
    fn new(field: &ScalarField<'_>, min: DVec3, max: DVec3, cell: f64) -> Self {
        let corner = |at: IVec3| min + cell * at.as_dvec3();
        let values = Self::sample(field, min, max, cell);
        // Corners in a fixed order, so that vertices are numbered the same in every run.
        let mut corners: Vec<IVec3> = values.keys().copied().collect();
        corners.par_sort_unstable_by_key(IVec3::to_array);
        // Vertices by their cells and the edges of those that they stand for.
        let mut index: HashMap<(IVec3, usize), u32> = HashMap::new();
        let mut this = Self { vertices: Vec::new(), quads: Vec::new() };
        for &at in &corners {
            for sheet in sheets(|k| values.get(&(at + CORNERS[k])).copied()) {
                let crossing = |&(edge, share): &(usize, f64)| {
                    let [a, b] = cell_edge(edge).map(|k| corner(at + CORNERS[k]));
                    a.lerp(b, share)
                };
                let sum: DVec3 = sheet.iter().map(crossing).sum();
                index.extend(sheet.iter().map(|(edge, _)| ((at, *edge), this.vertices.len() as u32)));
                this.vertices.push(sum / sheet.len() as f64);
            }
        }
        for &at in &corners {
            for axis in 0..3 {
                let (u, v) = (IVec3::AXES[(axis + 1) % 3], IVec3::AXES[(axis + 2) % 3]);
                let (Some(va), Some(vb)) = (values.get(&at), values.get(&(at + IVec3::AXES[axis]))) else { continue };
                if (*va < 0.0) == (*vb < 0.0) {
                    continue;
                }
                // The edge is another one in each of the cells around it.
                let around = [(at - u - v, 3), (at - v, 2), (at, 0), (at - u, 1)]
                    .map(|(cell, side)| index.get(&(cell, 4 * axis + side)).copied());
                if let [Some(a), Some(b), Some(c), Some(d)] = around {
                    this.quads.push(if *va < 0.0 { [a, b, c, d] } else { [d, c, b, a] });
                }
            }
        }
        this
    }

    /// Values at the corners of all blocks that the surface may pass through.
    fn sample(field: &ScalarField<'_>, min: DVec3, max: DVec3, cell: f64) -> HashMap<IVec3, f64> {
        let blocks = ((max - min) / (cell * f64::from(BLOCK))).ceil().as_ivec3();
        let reach = 0.5 * f64::from(BLOCK + 1) * cell * 3.0_f64.sqrt() * STEEPEST;
        let found: Vec<Vec<(IVec3, f64)>> = (0..blocks.element_product())
            .into_par_iter()
            .map(|k| {
                let block = BLOCK * IVec3::new(k % blocks.x, k / blocks.x % blocks.y, k / (blocks.x * blocks.y));
                let middle = min + cell * (block.as_dvec3() + 0.5 * f64::from(BLOCK));
                if field(middle).abs() > reach {
                    return Vec::new();
                }
                let corners =
                    (0..BLOCK.pow(3)).map(|k| block + IVec3::new(k % BLOCK, k / BLOCK % BLOCK, k / (BLOCK * BLOCK)));
                corners.map(|at| (at, field(min + cell * at.as_dvec3()))).collect()
            })
            .collect();
        found.into_iter().flatten().collect()
    }

    /// Moves every vertex towards the mean of its neighbours, then back onto the surface.
    fn spread(&mut self, field: &ScalarField<'_>, cell: f64) {
        let mut sums = vec![(DVec3::ZERO, 0.0); self.vertices.len()];
        for quad in &self.quads {
            for k in 0..4 {
                let [a, b] = [quad[k], quad[(k + 1) % 4]].map(|i| i as usize);
                for (from, to) in [(a, b), (b, a)] {
                    sums[to].0 += self.vertices[from];
                    sums[to].1 += 1.0;
                }
            }
        }
        self.vertices.par_iter_mut().zip(sums).for_each(|(vertex, (sum, count))| {
            let mean = if count > 0.0 { sum / count } else { *vertex };
            *vertex = vertex.lerp(mean, PACE);
            for _ in 0..2 {
                let slope = slope(field, *vertex, 1e-3 * cell);
                let step = field(*vertex) * slope / slope.length_squared().max(0.1);
                // Never far: at a crease the slope may point anywhere.
                *vertex -= step.clamp_length_max(cell);
            }
        });
    }

    /// Quads cut along their shorter diagonals.
    fn triangles(&self) -> Vec<[u32; 3]> {
        let at = |i: u32| self.vertices[i as usize];
        self.quads
            .iter()
            .flat_map(|&[a, b, c, d]| {
                if at(a).distance_squared(at(c)) <= at(b).distance_squared(at(d)) {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, b, d], [b, c, d]]
                }
            })
            .collect()
    }
}

/// The corners at the ends of an edge of a cell: four edges along each axis, the side given by the two bits of the
/// other axes in turn.
fn cell_edge(edge: usize) -> [usize; 2] {
    let (axis, side) = (edge / 4, edge % 4);
    let from = (side % 2) << ((axis + 1) % 3) | (side / 2) << ((axis + 2) % 3);
    [from, from | 1 << axis]
}

/// The sheets of the surface within a cell, each by the edges that it cuts and where. Two sheets that pass through one
/// cell get a vertex each, so that they do not grow together.
fn sheets(value: impl Fn(usize) -> Option<f64>) -> Vec<Vec<(usize, f64)>> {
    let mut values = [0.0; 8];
    for (k, place) in values.iter_mut().enumerate() {
        let Some(value) = value(k) else { return Vec::new() };
        *place = value;
    }
    let inside = values.map(|value| value < 0.0);
    if inside == [true; 8] || inside == [false; 8] {
        return Vec::new();
    }
    // Corners on the same side that are connected along edges.
    let mut group = [0, 1, 2, 3, 4, 5, 6, 7];
    for _ in 0..7 {
        for [a, b] in (0..12).map(cell_edge) {
            if inside[a] == inside[b] {
                let least = group[a].min(group[b]);
                (group[a], group[b]) = (least, least);
            }
        }
    }
    let mut found: Vec<(usize, Vec<(usize, f64)>)> = Vec::new();
    for edge in 0..12 {
        let [a, b] = cell_edge(edge);
        if inside[a] == inside[b] {
            continue;
        }
        let crossing = (edge, values[a] / (values[a] - values[b]));
        // By their inside corners, in every cell: cells that share a face must agree on who belongs to whom there.
        let label = group[if inside[a] { a } else { b }];
        match found.iter_mut().find(|(other, _)| *other == label) {
            Some((_, sheet)) => sheet.push(crossing),
            None => found.push((label, vec![crossing])),
        }
    }
    found.into_iter().map(|(_, sheet)| sheet).collect()
}

/// Slope of a field by central differences.
fn slope(field: &ScalarField<'_>, at: DVec3, step: f64) -> DVec3 {
    let along = |axis: DVec3| (field(at + step * axis) - field(at - step * axis)) / (2.0 * step);
    DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::solid::Solid;
    use std::f64::consts::PI;

    #[test]
    fn a_ball_comes_out_round_closed_and_of_its_volume() {
        let model = isosurface(&|p: DVec3| p.length() - 1.0, DVec3::splat(-1.3), DVec3::splat(1.3), 0.1);
        let solid = Solid::new(&model).unwrap();
        assert!(solid.report.findings().is_empty(), "{:?}", solid.report);
        assert!((solid.volume / (4.0 * PI / 3.0) - 1.0).abs() < 0.01, "{}", solid.volume);
        for (position, normal) in model.positions.iter().zip(&model.normals) {
            assert!((position.length() - 1.0).abs() < 1e-9);
            assert!(position.as_vec3().dot(*normal) > 0.999);
        }
    }
}
