//! From the split vertices of a picture to the points of a surface, in an order that does not depend on the file's.

use super::model::Model;
use super::neighbours::PointGrid;
use glam::DVec3;
use rayon::prelude::*;

/// Points and faces of a surface, sorted: the same for every order of the vertices and faces of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Welded {
    /// Different positions, by x, then y, then z [m].
    pub points: Vec<DVec3>,
    /// Point of every vertex of the model.
    pub point_of: Vec<u32>,
    /// Point indices of every face, its least index first; by those indices.
    pub faces: Vec<[u32; 3]>,
    /// Faces of the model that came to have fewer than three points.
    pub collapsed: usize,
}

impl Welded {
    /// Welds vertices at the same position. Every position must be finite.
    pub fn new(model: &Model) -> Self {
        // Minus zero is the same place as zero.
        let positions: Vec<DVec3> = model.positions.iter().map(|&position| position + 0.0).collect();
        let mut order: Vec<u32> = (0..positions.len() as u32).collect();
        let by_place = |&a: &u32, &b: &u32| {
            let [a, b] = [a, b].map(|i| positions[i as usize].to_array());
            a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
        };
        order.par_sort_unstable_by(by_place);
        let mut points: Vec<DVec3> = Vec::new();
        let mut point_of = vec![0; positions.len()];
        for vertex in order {
            let position = positions[vertex as usize];
            if points.last() != Some(&position) {
                points.push(position);
            }
            point_of[vertex as usize] = points.len() as u32 - 1;
        }
        let faces = model.triangles.iter().map(|t| t.map(|i| point_of[i as usize])).collect();
        let mut this = Self { points, point_of, faces, collapsed: 0 };
        this.sort_faces();
        this
    }

    /// Welds `loose` points that lie within `distance` [m] of each other, onto the first of them. Returns how many
    /// points went.
    pub(crate) fn weld_near(&mut self, loose: &[u32], distance: f64) -> usize {
        let places: Vec<DVec3> = loose.iter().map(|&i| self.points[i as usize]).collect();
        let grid = PointGrid::new(&places, distance);
        let mut target: Vec<u32> = (0..self.points.len() as u32).collect();
        for (&point, &place) in loose.iter().zip(&places) {
            // Neighbours come in ascending order, and so do the loose points: the first that stays takes the rest.
            let near = grid.within(place).into_iter().map(|k| loose[k as usize]);
            if let Some(first) = near.into_iter().find(|&other| other < point && target[other as usize] == other) {
                target[point as usize] = first;
            }
        }
        let mut new_index = vec![0; self.points.len()];
        let mut kept = Vec::with_capacity(self.points.len());
        for (old, &point) in self.points.iter().enumerate() {
            if target[old] == old as u32 {
                new_index[old] = kept.len() as u32;
                kept.push(point);
            }
        }
        let index = |old: u32| new_index[target[old as usize] as usize];
        let gone = self.points.len() - kept.len();
        self.points = kept;
        self.point_of.iter_mut().for_each(|point| *point = index(*point));
        self.faces.iter_mut().for_each(|face| *face = face.map(index));
        self.sort_faces();
        gone
    }

    fn sort_faces(&mut self) {
        let before = self.faces.len();
        self.faces.retain(|[a, b, c]| a != b && b != c && c != a);
        self.collapsed += before - self.faces.len();
        for [a, b, c] in &mut self.faces {
            if b < a && b < c {
                (*a, *b, *c) = (*b, *c, *a);
            } else if c < a && c < b {
                (*a, *b, *c) = (*c, *a, *b);
            }
        }
        self.faces.par_sort_unstable();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_a_file_leaves_no_trace() {
        let positions =
            vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(-0.0, 0.0, -0.0), DVec3::Y, DVec3::X, DVec3::Z];
        let model = Model { positions, triangles: vec![[0, 1, 2], [3, 4, 6], [5, 1, 6]], ..Model::default() };
        let welded = Welded::new(&model);
        assert_eq!(welded.points.len(), 4);
        assert_eq!(welded.collapsed, 1);
        let mut turned = model.clone();
        turned.positions.reverse();
        turned.triangles = vec![[2, 0, 3], [6, 5, 4], [0, 1, 5]];
        let again = Welded::new(&turned);
        assert_eq!((&again.points, &again.faces), (&welded.points, &welded.faces));
    }

    #[test]
    fn loose_points_are_welded_onto_the_first() {
        let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1e-7, 0.0, 0.0), DVec3::Z];
        let model = Model { positions, triangles: vec![[0, 1, 2], [3, 4, 2]], ..Model::default() };
        let mut welded = Welded::new(&model);
        let all: Vec<u32> = (0..5).collect();
        assert_eq!(welded.weld_near(&all, 1e-6), 1);
        assert_eq!(welded.points.len(), 4);
        assert_eq!(welded.point_of[0], welded.point_of[3]);
    }
}
