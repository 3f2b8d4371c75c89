//! Closed meshes made at random, the same for the same seed: dents, tips, blades, needles, combs, tubes, cavities,
//! blocks that share edges, and several shells in one another, each with a volume that is found another way than by the
//! crate.

use glam::{DQuat, DVec3};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// How many kinds there are: seeds that follow each other go through all of them.
pub const KINDS: u64 = 10;

/// A closed mesh, its faces counter-clockwise seen from outside: vertices [m], faces, and what kind of thing it is.
/// Half of them lie along the axes; the greatest extent is between 0.02 and 2 m.
pub fn mesh(seed: u64) -> (Vec<[f64; 3]>, Vec<[u32; 3]>, &'static str) {
    let made = made(seed);
    let whole = made.shells.iter().fold(Shell::default(), Shell::joined);
    (whole.points.iter().map(DVec3::to_array).collect(), whole.faces, made.kind)
}

/// What [`mesh`] encloses [m³]: the sum of signed tetrahedra, or of shells that overlap the length of many rows through
/// their half spaces, or of boxes along the axes the sum of the cells that their planes divide space into.
pub fn volume(seed: u64) -> f64 {
    let made = made(seed);
    match made.overlap {
        Overlap::None => made.shells.iter().map(Shell::volume).sum(),
        Overlap::Convex => union_of_convex(&made.shells),
        Overlap::Boxes(volume) => volume,
    }
}

/// One closed surface.
#[derive(Clone, Default)]
struct Shell {
    points: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
}

enum Overlap {
    None,
    Convex,
    Boxes(f64),
}

struct Made {
    shells: Vec<Shell>,
    kind: &'static str,
    overlap: Overlap,
}

fn made(seed: u64) -> Made {
    let mut random = Random(seed);
    let one = |shell: Shell, kind| Made { shells: vec![shell], kind, overlap: Overlap::None };
    let mut made = match seed % KINDS {
        0 => one(dented(&mut random), "dented ball"),
        1 => one(tip(&mut random), "tip"),
        2 => one(blade(&mut random), "blade"),
        3 => one(needle(&mut random), "needle"),
        4 => one(comb(&mut random), "comb"),
        5 => one(tube(&mut random), "tube"),
        6 => Made { shells: hollow(&mut random), kind: "box with a cavity", overlap: Overlap::None },
        7 => one(blocks(&mut random), "blocks"),
        8 => boxes(&mut random),
        _ => Made { shells: balls(&mut random), kind: "overlapping balls", overlap: Overlap::Convex },
    };
    let turn = if random.below(2) == 0 {
        DQuat::IDENTITY
    } else {
        let axis = DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        DQuat::from_axis_angle(axis.normalize_or(DVec3::Y), random.between(0.1, 3.0))
    };
    let every = || made.shells.iter().flat_map(|shell| &shell.points);
    let least = every().copied().fold(DVec3::INFINITY, DVec3::min);
    let greatest = every().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    let scale = 0.02 * 100.0_f64.powf(random.between(0.0, 1.0)) / (greatest - least).max_element();
    let shift = scale * DVec3::new(random.between(-2.0, 2.0), random.between(-2.0, 2.0), random.between(-2.0, 2.0));
    for point in made.shells.iter_mut().flat_map(|shell| &mut shell.points) {
        *point = shift + turn * (scale * *point);
    }
    if let Overlap::Boxes(volume) = &mut made.overlap {
        *volume *= scale.powi(3);
    }
    made
}

/// Numbers that follow from a seed (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, least: f64, greatest: f64) -> f64 {
        least + (greatest - least) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// From 0 to `count - 1`.
    fn below(&mut self, count: u64) -> i32 {
        (self.bits() % count) as i32
    }
}

/// A cross section: its height, both half widths, and by how much its centre is moved along x.
struct Ring {
    z: f64,
    half: [f64; 2],
    shift: f64,
}

impl Ring {
    fn round(z: f64, radius: f64) -> Self {
        Self { z, half: [radius, radius], shift: 0.0 }
    }
}

/// Cross sections joined; those of no width are points. `factor` widens them by ring and side. Rings in the order of
/// their heights cannot run into each other; a `cyclic` row of them closes to a tube.
fn loft(rings: &[Ring], sides: u32, cyclic: bool, factor: impl Fn(usize, u32) -> f64) -> Shell {
    let mut shell = Shell::default();
    let mut first = Vec::new();
    for (i, ring) in rings.iter().enumerate() {
        first.push(shell.points.len() as u32);
        for j in 0..if ring.half == [0.0; 2] { 1 } else { sides } {
            let (sine, cosine) = (TAU * f64::from(j) / f64::from(sides)).sin_cos();
            let [x, y] = ring.half.map(|half| half * factor(i, j));
            shell.points.push(DVec3::new(ring.shift + x * cosine, y * sine, ring.z));
        }
    }
    let index = |i: usize, j: u32| first[i] + if rings[i].half == [0.0; 2] { 0 } else { j % sides };
    for i in 0..if cyclic { rings.len() } else { rings.len() - 1 } {
        let next = (i + 1) % rings.len();
        for j in 0..sides {
            let [a, b, c, d] = [index(i, j), index(next, j), index(next, j + 1), index(i, j + 1)];
            shell.faces.extend([[a, b, c], [a, c, d]].into_iter().filter(|[a, b, c]| a != b && b != c && c != a));
        }
    }
    shell.outwards()
}

/// A ball with dents and bumps.
fn dented(random: &mut Random) -> Shell {
    let (count, sides) = (random.below(8) + 6, random.below(10) as u32 + 8);
    let rings: Vec<_> = (0..=count)
        .map(|k| 0.5 * TAU * f64::from(k) / f64::from(count))
        .enumerate()
        .map(|(k, angle)| {
            let pole = k == 0 || k == count as usize;
            Ring::round(-angle.cos(), if pole { 0.0 } else { angle.sin() })
        })
        .collect();
    let rough: Vec<f64> = (0..rings.len() * sides as usize).map(|_| random.between(0.35, 1.2)).collect();
    loft(&rings, sides, false, |i, j| rough[i * sides as usize + j as usize])
}

/// A drop that runs out into a point, at times a hooked one.
fn tip(random: &mut Random) -> Shell {
    let (count, sides) = (12, random.below(9) as u32 + 5);
    let (sharp, length, hook) = (random.between(1.0, 3.5), random.between(1.0, 5.0), random.between(0.0, 1.0));
    let rings: Vec<_> = (0..=count)
        .map(|k| {
            let t = f64::from(k) / f64::from(count);
            let radius = if k == 0 || k == count { 0.0 } else { (4.0 * t).min(1.0) * (1.0 - t).powf(sharp) };
            Ring { z: length * t, half: [radius; 2], shift: hook * t * t }
        })
        .collect();
    loft(&rings, sides, false, |_, _| 1.0)
}

/// A long flat diamond with two edges and a point at each end.
fn blade(random: &mut Random) -> Shell {
    let (thick, length) = (random.between(0.02, 0.3), random.between(2.0, 8.0));
    let (bend, count) = (random.between(-1.0, 1.0), 9);
    let rings: Vec<_> = (0..=count)
        .map(|k| {
            let t = f64::from(k) / f64::from(count);
            let width = if k == 0 || k == count { 0.0 } else { (0.5 * TAU * t).sin().powf(0.6) };
            Ring { z: length * t, half: [width, thick * width], shift: bend * t * t }
        })
        .collect();
    loft(&rings, 4, false, |_, _| 1.0)
}

/// A ball with a spike of some ten times its size.
fn needle(random: &mut Random) -> Shell {
    let (thin, length) = (random.between(0.01, 0.15), random.between(4.0, 12.0));
    let sides = random.below(6) as u32 + 3;
    let ball = (1..6).map(|k| 0.5 * TAU * f64::from(k) / 6.5).map(|angle| Ring::round(-angle.cos(), angle.sin()));
    let mut rings = vec![Ring::round(-1.0, 0.0)];
    rings.extend(ball);
    rings.extend([Ring::round(1.1, thin), Ring::round(1.0 + 0.5 * length, thin), Ring::round(1.0 + length, 0.0)]);
    loft(&rings, sides, false, |_, _| 1.0)
}

/// A tube or a ring, its wall between a fiftieth and a third of its radius.
fn tube(random: &mut Random) -> Shell {
    let (sides, wall, length) = (random.below(24) as u32 + 6, random.between(0.02, 0.35), random.between(0.2, 4.0));
    let rings = [(1.0, 0.0), (1.0, length), (1.0 - wall, length), (1.0 - wall, 0.0)];
    loft(&rings.map(|(radius, z)| Ring::round(z, radius)), sides, true, |_, _| 1.0)
}

/// A back with teeth, in boxes of one piece.
fn comb(random: &mut Random) -> Shell {
    let (teeth, long) = (random.below(8) + 2, random.below(6) + 1);
    let mut cells: Vec<[i32; 3]> = (0..2 * teeth - 1).map(|x| [x, 0, 0]).collect();
    cells.extend((0..teeth).flat_map(|tooth| (1..=long).map(move |y| [2 * tooth, y, 0])));
    let edges = DVec3::new(random.between(0.1, 1.0), 1.0, random.between(0.05, 1.0));
    cubes(&cells, edges)
}

/// Cubes at random, edge on edge and corner on corner at times, some around a hole.
fn blocks(random: &mut Random) -> Shell {
    let mut cells = vec![[0; 3]];
    while cells.len() < 14 {
        let mut next = cells[random.below(cells.len() as u64) as usize];
        // Now and then a step along two axes, so that only an edge is shared.
        for _ in 0..=random.below(5) / 4 {
            next[random.below(3) as usize] += 2 * random.below(2) - 1;
        }
        if !cells.contains(&next) {
            cells.push(next);
        }
    }
    cubes(&cells, DVec3::new(1.0, random.between(0.5, 1.0), random.between(0.5, 1.0)))
}

/// The surface of boxes on a grid: what two of them share is left out.
fn cubes(cells: &[[i32; 3]], edges: DVec3) -> Shell {
    let mut seen: BTreeMap<[i32; 3], u32> = BTreeMap::new();
    let mut shell = Shell::default();
    for cell in cells {
        for axis in 0..3 {
            for side in [0, 1] {
                let mut beside = *cell;
                beside[axis] += 2 * side - 1;
                if cells.contains(&beside) {
                    continue;
                }
                let corner = |(u, v): (i32, i32)| {
                    let mut at = *cell;
                    at[axis] += side;
                    at[(axis + 1) % 3] += u;
                    at[(axis + 2) % 3] += v;
                    at
                };
                let mut quad = [(0, 0), (1, 0), (1, 1), (0, 1)].map(corner);
                if side == 0 {
                    quad.reverse();
                }
                let [a, b, c, d] = quad.map(|at| {
                    *seen.entry(at).or_insert_with(|| {
                        shell.points.push(edges * DVec3::from_array(at.map(f64::from)));
                        shell.points.len() as u32 - 1
                    })
                });
                shell.faces.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    shell
}

/// A box around one to three empty ones.
fn hollow(random: &mut Random) -> Vec<Shell> {
    let count = 1 + random.below(3);
    let mut shells = vec![cuboid([DVec3::ZERO, DVec3::new(f64::from(count), 1.0, 1.0)])];
    for k in 0..count {
        let near = DVec3::new(random.between(0.02, 0.4), random.between(0.02, 0.4), random.between(0.02, 0.4));
        let far = DVec3::new(random.between(0.6, 0.98), random.between(0.6, 0.98), random.between(0.6, 0.98));
        let mut cavity = cuboid([near, far].map(|corner| corner + f64::from(k) * DVec3::X));
        cavity.faces.iter_mut().for_each(|face| face.swap(1, 2));
        shells.push(cavity);
    }
    shells
}

/// Boxes on a coarse grid: sides in one plane, edges on edges, one within another, the same one twice.
fn boxes(random: &mut Random) -> Made {
    let grid = 4;
    let corners: Vec<[[i32; 3]; 2]> = (0..2 + random.below(4))
        .map(|_| {
            let least = [0; 3].map(|_: i32| random.below(grid));
            [least, least.map(|at| at + 1 + random.below(grid))]
        })
        .collect();
    let inside = |cell: [i32; 3]| {
        corners.iter().any(|[least, greatest]| (0..3).all(|k| least[k] <= cell[k] && cell[k] < greatest[k]))
    };
    let span = 2 * grid as i32;
    let cells = (0..span * span * span).filter(|k| inside([k % span, k / span % span, k / (span * span)])).count();
    let shells = corners.iter().map(|pair| cuboid(pair.map(|at| DVec3::from_array(at.map(f64::from)))));
    Made { shells: shells.collect(), kind: "overlapping boxes", overlap: Overlap::Boxes(cells as f64) }
}

fn cuboid([least, greatest]: [DVec3; 2]) -> Shell {
    let mut shell = cubes(&[[0; 3]], DVec3::ONE);
    shell.points.iter_mut().for_each(|point| *point = least + *point * (greatest - least));
    shell
}

/// Two to four round things half in one another.
fn balls(random: &mut Random) -> Vec<Shell> {
    let count = 2 + random.below(3);
    let mut shells = Vec::new();
    for k in 0..count {
        let (rings, sides) = (random.below(4) + 4, random.below(8) as u32 + 5);
        let half = DVec3::new(random.between(0.3, 1.0), random.between(0.3, 1.0), random.between(0.3, 1.0));
        let rings: Vec<_> = (0..=rings)
            .map(|ring| (ring == 0 || ring == rings, 0.5 * TAU * f64::from(ring) / f64::from(rings)))
            .map(|(pole, angle)| Ring::round(-angle.cos(), if pole { 0.0 } else { angle.sin() }))
            .collect();
        let mut shell = loft(&rings, sides, false, |_, _| 1.0);
        let shift = DVec3::new(0.6 * f64::from(k), random.between(-0.3, 0.3), random.between(-0.3, 0.3));
        shell.points.iter_mut().for_each(|point| *point = shift + half * *point);
        shells.push(shell);
    }
    shells
}

impl Shell {
    fn joined(mut self, other: &Self) -> Self {
        let base = self.points.len() as u32;
        self.points.extend(&other.points);
        self.faces.extend(other.faces.iter().map(|face| face.map(|i| base + i)));
        self
    }

    fn corners(&self) -> impl Iterator<Item = [DVec3; 3]> {
        self.faces.iter().map(|face| face.map(|i| self.points[i as usize]))
    }

    /// Signed volume, about a point of its own.
    fn volume(&self) -> f64 {
        let origin = self.points[0];
        self.corners().map(|t| t.map(|point| point - origin)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    }

    fn outwards(mut self) -> Self {
        if self.volume() < 0.0 {
            self.faces.iter_mut().for_each(|face| face.swap(1, 2));
        }
        self
    }
}

/// Rows along each axis on which shells that overlap are measured.
const ROWS: usize = 96;

/// Volume of what lies in any of several convex shells: each is as many half spaces as it has faces, and a row through
/// them an interval.
fn union_of_convex(shells: &[Shell]) -> f64 {
    let every = || shells.iter().flat_map(|shell| &shell.points);
    let least = every().copied().fold(DVec3::INFINITY, DVec3::min);
    let step = (every().copied().fold(DVec3::NEG_INFINITY, DVec3::max) - least) / ROWS as f64;
    let planes: Vec<Vec<(DVec3, f64)>> = shells
        .iter()
        .map(|shell| shell.corners().map(|[a, b, c]| ((b - a).cross(c - a), a)).map(|(n, a)| (n, n.dot(a))).collect())
        .collect();
    let mut length = 0.0;
    for k in 0..ROWS * ROWS {
        let (y, z) = ((k % ROWS) as f64 + 0.5, (k / ROWS) as f64 + 0.5);
        let row = least + step * DVec3::new(0.0, y, z);
        let mut intervals: Vec<[f64; 2]> = planes.iter().map(|planes| along(planes, row)).collect();
        intervals.retain(|[from, to]| from < to);
        intervals.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut reached = f64::NEG_INFINITY;
        for [from, to] in intervals {
            length += (to - reached.max(from)).max(0.0);
            reached = reached.max(to);
        }
    }
    length * step.y * step.z
}

/// Where the row along x from a point runs within all half spaces.
fn along(planes: &[(DVec3, f64)], row: DVec3) -> [f64; 2] {
    planes.iter().fold([f64::NEG_INFINITY, f64::INFINITY], |[from, to], (normal, offset)| {
        let room = offset - normal.dot(row);
        if normal.x > 0.0 {
            [from, to.min(room / normal.x)]
        } else if normal.x < 0.0 {
            [from.max(room / normal.x), to]
        } else if room < 0.0 {
            [0.0, 0.0]
        } else {
            [from, to]
        }
    })
}
