//! The rows (dy, dz) around a site in the order in which a stencil reads them, and the groups that share their weights.

/// Greatest |o|² that a stencil may have: D / h from 0.289 on.
pub(in super::super) const MAX_NORM_SQUARED: usize = 11;

/// Values of |dx|: 0 to 3.
pub(super) const DISTANCES: usize = 4;

/// Groups of rows (±a, ±b) in order of a² + b².
const GROUPS: [(usize, usize); 13] =
    [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (2, 1), (1, 2), (2, 2), (3, 0), (0, 3), (3, 1), (1, 3)];

/// Rows (dy, dz), group after group, so that a smaller stencil uses the first of them: 21 up to |o|² = 6.
#[allow(clippy::cast_possible_wrap, reason = "groups are a few cells away")]
pub(super) const ROWS: [(i32, i32); rows_within(MAX_NORM_SQUARED)] = {
    let mut rows = [(0, 0); rows_within(MAX_NORM_SQUARED)];
    let (mut n, mut g) = (0, 0);
    while g < GROUPS.len() {
        let (a, b) = (GROUPS[g].0 as i32, GROUPS[g].1 as i32);
        // (a, b), (-a, b), (a, -b), (-a, -b), as far as they differ.
        let mut k = 0;
        while k < 4 {
            let (y, z) = (k % 2 == 1, k / 2 == 1);
            if !(y && a == 0 || z && b == 0) {
                rows[n] = (if y { -a } else { a }, if z { -b } else { b });
                n += 1;
            }
            k += 1;
        }
        g += 1;
    }
    rows
};

/// Number of rows with dy² + dz² up to this.
pub(super) const fn rows_within(norm_squared: usize) -> usize {
    let (mut count, mut y) = (0, 0);
    while y * y <= norm_squared {
        let mut z = 0;
        while y * y + z * z <= norm_squared {
            count += rows_in_group(y, z);
            z += 1;
        }
        y += 1;
    }
    count
}

/// Number of different rows (±a, ±b).
const fn rows_in_group(a: usize, b: usize) -> usize {
    (if a == 0 { 1 } else { 2 }) * (if b == 0 { 1 } else { 2 })
}

/// What is known of a group by its number in the table.
pub(super) struct Group<const G: usize>;

impl<const G: usize> Group<G> {
    /// |dy| of its rows.
    pub(super) const A: usize = GROUPS[G].0;
    /// |dz| of its rows.
    pub(super) const B: usize = GROUPS[G].1;
    /// dy² + dz² of its rows.
    pub(super) const NORM_SQUARED: usize = Self::A * Self::A + Self::B * Self::B;
    /// Where its rows begin in [`ROWS`].
    pub(super) const FIRST: usize = first_row(G);
}

/// Where the rows of a group begin.
const fn first_row(group: usize) -> usize {
    let (mut first, mut g) = (0, 0);
    while g < group {
        first += rows_in_group(GROUPS[g].0, GROUPS[g].1);
        g += 1;
    }
    first
}

/// Calls a method for every group, by its number as a constant.
macro_rules! for_every_group {
    ($stencil:ident . $method:ident ( $($argument:expr),* )) => {
        $stencil.$method::<0>($($argument),*);
        $stencil.$method::<1>($($argument),*);
        $stencil.$method::<2>($($argument),*);
        $stencil.$method::<3>($($argument),*);
        $stencil.$method::<4>($($argument),*);
        $stencil.$method::<5>($($argument),*);
        $stencil.$method::<6>($($argument),*);
        $stencil.$method::<7>($($argument),*);
        $stencil.$method::<8>($($argument),*);
        $stencil.$method::<9>($($argument),*);
        $stencil.$method::<10>($($argument),*);
        $stencil.$method::<11>($($argument),*);
        $stencil.$method::<12>($($argument),*);
    };
}
pub(super) use for_every_group;

#[allow(clippy::cast_possible_wrap, reason = "groups are a few cells away")]
const _: () = {
    let (mut g, mut norm_squared) = (0, 0);
    while g < GROUPS.len() {
        let (a, b) = GROUPS[g];
        assert!(a * a + b * b >= norm_squared, "groups stand in order of their distance");
        norm_squared = a * a + b * b;
        let (first, a, b) = (first_row(g), a as i32, b as i32);
        assert!(is_row(first, a, b), "a group begins with its row (a, b)");
        if a != 0 && b != 0 {
            assert!(is_row(first + 1, -a, b) && is_row(first + 2, a, -b) && is_row(first + 3, -a, -b));
        } else if a != 0 || b != 0 {
            assert!(is_row(first + 1, -a, -b), "the other row of a pair follows");
        }
        g += 1;
    }
    assert!(norm_squared <= MAX_NORM_SQUARED && first_row(g) == ROWS.len(), "no row is missing");
    assert!(DISTANCES * DISTANCES > MAX_NORM_SQUARED, "no distance along x is missing");
};

/// Whether a row of the table is (dy, dz).
const fn is_row(row: usize, y: i32, z: i32) -> bool {
    ROWS[row].0 == y && ROWS[row].1 == z
}
