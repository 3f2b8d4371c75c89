//! The work that drives do on fibres.
//!
//! An edge that wants to be shorter by a share c rests at `l0 (1 - c)`; its energy is still divided by the drawn
//! length, `l_f (EA / 2 l0) (|e| - l0 (1 - c))²`. So its Hessian is at most `l_f EA / l0` times unity, whatever the
//! edge does and however it is driven, and that is what the stable step is measured with. Bending gets stiffer as edges
//! get shorter, by `(1 - c)^-2`, with the greatest c among the drive's, and so is it measured.
//!
//! The work of a step is half of what the change of all drives adds to the energy where the step began and half of what
//! it adds where it ended. The sum of all energies less that work is kept to second order, as it is without drives.

use super::breaking::Breakage;
use super::corner::{Corner, straight_energy};
use super::material_turn::turn_of_material;
use super::rest::FibreRest;
use glam::{DQuat, DVec3};

/// The work that drives have done on the fibres of a body.
#[derive(Clone, Debug, Default)]
pub(super) struct Activity {
    /// Work done up to the last booking [J].
    pub(super) work: f64,
    booked: Option<Booked>,
}

/// The fibres of a body at one time.
#[derive(Clone, Copy)]
pub(super) struct Now<'a> {
    pub(super) fibres: &'a [FibreRest],
    /// Warm starts of the turns at all bends and at the vertices of all fibres that are twisted.
    pub(super) turns: &'a [DQuat],
    pub(super) ends: &'a [DQuat],
    /// [s]
    pub(super) time: f64,
    /// Positions of the particles [m].
    pub(super) positions: &'a [DVec3],
}

/// What the energies of the fibres that act hang on, at the last booking.
#[derive(Clone, Debug, Default)]
struct Booked {
    time: f64,
    /// Lengths of the edges [m].
    lengths: Vec<f64>,
    /// Curvature binormals of fibres that curl or get thicker, in the frame of the material around; where that is not
    /// read, some vector whose square is the energy of a bend of stiffness one.
    binormals: Vec<DVec3>,
    /// Angles of twist [rad].
    angles: Vec<f64>,
}

impl Booked {
    fn now(of: Now<'_>) -> Self {
        let mut booked = Self { time: of.time, ..Self::default() };
        let (mut first_bend, mut first_end) = (0, 0);
        for fibre in of.fibres {
            if let Some(activation) = &fibre.activation {
                let x: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(of.positions)).collect();
                booked.lengths.extend(x.windows(2).map(|edge| edge[0].distance(edge[1])));
                if activation.curls() || activation.thickens() {
                    booked.binormals.extend((0..fibre.bends.len()).map(|k| {
                        let Some(corner) = Corner::at(&x, k) else { return DVec3::ZERO };
                        let Some(rest) = &fibre.bends[k].curved else {
                            // By round-off a cosine may be above one.
                            return DVec3::X * (4.0 * straight_energy(corner.cosine)).max(0.0).sqrt();
                        };
                        let mut warm = of.turns[first_bend + k];
                        let (r, _) = turn_of_material(&rest.turn, of.positions, &mut warm);
                        r.transpose() * corner.binormal()
                    }));
                }
                if let Some(twist) = &fibre.twist {
                    booked.angles.extend(twist.angles(of.positions, &of.ends[first_end..]));
                }
            }
            first_bend += fibre.bends.len();
            first_end += fibre.twisted_ends();
        }
        booked
    }
}

impl Activity {
    /// Takes note of where the booking begins, unless it has begun.
    pub(super) fn begin(&mut self, now: Now<'_>) {
        self.booked.get_or_insert_with(|| Booked::now(now));
    }

    /// Books the work of the step that ended now.
    pub(super) fn book(&mut self, now: Now<'_>, broken: &Breakage) {
        let booked = Booked::now(now);
        if let Some(before) = &self.booked {
            self.work += work_between(now.fibres, broken, [before, &booked]);
        }
        self.booked = Some(booked);
    }

    /// The time [s] of the last booking.
    pub(super) fn time(&self) -> f64 {
        self.booked.as_ref().map_or(0.0, |booked| booked.time)
    }

    /// Begins to book anew, from wherever the body is next, and goes on with the work of what stood here before.
    pub(super) fn adopt(&mut self, before: Option<&Self>) {
        *self = Self { work: before.map_or(0.0, |before| before.work), booked: None };
    }

    /// Memory of the lists [bytes].
    pub(super) fn bytes(&self) -> usize {
        let bytes = |of: &Booked| size_of_val(&*of.lengths) + size_of_val(&*of.binormals) + size_of_val(&*of.angles);
        self.booked.as_ref().map_or(0, bytes)
    }
}

fn work_between(fibres: &[FibreRest], broken: &Breakage, [before, now]: [&Booked; 2]) -> f64 {
    let (mut work, mut first_edge, mut first_bend) = (0.0, 0, 0);
    let (mut length, mut binormal, mut angle) = (0, 0, 0);
    for fibre in fibres {
        if let Some(activation) = &fibre.activation {
            let whole = |edge: &usize| !broken.edges[first_edge + *edge];
            let (was, is) = (fibre.lengths_at(before.time), fibre.lengths_at(now.time));
            let muscles = activation.excitations(before.time).zip(activation.excitations(now.time));
            let ([thin, thin_bend], [thick, thick_bend]) =
                (fibre.thicknesses_at(before.time), fibre.thicknesses_at(now.time));
            for edge in (0..fibre.edges.len()).filter(whole) {
                let (stiffness, drawn) = fibre.edges[edge];
                let lengths = [before.lengths[length + edge], now.lengths[length + edge]];
                // Half of `(k/2) ((L - to)² - (L - from)²)` at both lengths L.
                let (from, to) = (was(edge), is(edge));
                work += 0.5 * thick(edge) * stiffness * (to - from) * (to + from - lengths[0] - lengths[1]);
                let thicker = thick(edge) - thin(edge);
                work += 0.25 * thicker * stiffness * lengths.map(|length| (length - from).powi(2)).iter().sum::<f64>();
                if let Some(((muscle, was), (_, is))) = &muscles {
                    let more = thick(edge) * is(edge) - thin(edge) * was(edge);
                    work += 0.5 * lengths.map(|length| muscle.energy(more, length / drawn, drawn)).iter().sum::<f64>();
                }
            }
            length += fibre.edges.len();
            if activation.curls() || activation.thickens() {
                let (was, is) = (fibre.binormals_at(before.time), fibre.binormals_at(now.time));
                for bend in (0..fibre.bends.len()).filter(|bend| !broken.bends[first_bend + bend]) {
                    // Where the turn of the material cannot be read, nothing curls.
                    let curls = fibre.bends[bend].curved.is_some();
                    let (from, to) = if curls { (was(bend), is(bend)) } else { (DVec3::ZERO, DVec3::ZERO) };
                    let found = [before, now].map(|of| of.binormals[binormal + bend]);
                    let stiffness = fibre.bends[bend].stiffness;
                    work += thick_bend(bend) * stiffness * (to - from).dot(to + from - found[0] - found[1]);
                    let thicker = thick_bend(bend) - thin_bend(bend);
                    work +=
                        0.5 * thicker * stiffness * found.map(|kb| (kb - from).length_squared()).iter().sum::<f64>();
                }
                binormal += fibre.bends.len();
            }
            if let Some(twist) = &fibre.twist {
                let (was, is) = (activation.twists(before.time), activation.twists(now.time));
                for edge in (0..twist.edges.len()).filter(whole) {
                    let (from, to) = (was(edge), is(edge));
                    let found = [before, now].map(|of| of.angles[angle + edge]);
                    let stiffness = twist.edges[edge].stiffness;
                    work += 0.5 * thick(edge) * stiffness * (to - from) * (to + from - found[0] - found[1]);
                    let thicker = thick(edge) - thin(edge);
                    work += 0.25 * thicker * stiffness * found.map(|angle| (angle - from).powi(2)).iter().sum::<f64>();
                }
                angle += twist.edges.len();
            }
        }
        first_edge += fibre.edges.len();
        first_bend += fibre.bends.len();
    }
    work
}
