//! Surfaces of rows of vertices.

/// Triangles of a grid of rows of `to_a_row` vertices, row after row. Diagonals alternate with the sum of column and
/// row, so that no direction is favoured. The first two vertices of every triangle are neighbours in a row; both others
/// stand across from one of them.
pub(crate) fn grid_triangles(to_a_row: usize, rows: usize) -> Vec<[u32; 3]> {
    let at = |column: usize, row: usize| (row * to_a_row + column) as u32;
    let mut triangles = Vec::new();
    for row in 0..rows.saturating_sub(1) {
        for column in 0..to_a_row.saturating_sub(1) {
            let [a, b] = [at(column, row), at(column + 1, row)];
            let [c, d] = [at(column, row + 1), at(column + 1, row + 1)];
            if (column + row).is_multiple_of(2) {
                triangles.extend([[a, b, d], [d, c, a]]);
            } else {
                triangles.extend([[a, b, c], [d, c, b]]);
            }
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_look_one_way_and_diagonals_alternate() {
        let triangles = grid_triangles(4, 3);
        assert_eq!(triangles.len(), 12);
        let place = |k: u32| (i64::from(k) % 4, i64::from(k) / 4);
        for [a, b, c] in &triangles {
            let [(ax, ay), (bx, by), (cx, cy)] = [*a, *b, *c].map(place);
            assert_eq!((bx - ax) * (cy - ay) - (cx - ax) * (by - ay), 1, "{a} {b} {c}");
            assert_eq!((ay, (ax - bx).abs()), (by, 1), "{a} {b} {c}");
        }
        // A vertex whose column and row make an even sum has a diagonal to every cell around it, any other has none.
        let diagonals = |k: u32| {
            let (x, y) = place(k);
            let away = |&l: &u32| (place(l).0 - x).abs() == 1 && (place(l).1 - y).abs() == 1;
            triangles.iter().filter(|of| of.contains(&k)).flatten().filter(|l| away(l)).count()
        };
        assert_eq!([5, 6, 9, 10].map(diagonals), [8, 0, 0, 4]);
    }
}
