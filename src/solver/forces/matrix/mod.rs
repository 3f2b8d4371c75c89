//! The matrix: corotated linear elasticity on meshfree particles (sec. 4.2), in a conservative form.
//!
//! The paper takes the rotation from eq. 15 and the strain from eq. 12 without correction; the force then is not the
//! gradient of any energy, and linear deformations are wrong by 3 % inside and up to 73 % at corners. Here, with
//! `x_ji = x_j - x_i`, capital letters at rest, and `w_ij = -V W'(r) / r`:
//!
//! - `F_i = (sum x_ji (x) w_ij X_ji) A_i^-1`, exact for linear deformations;
//! - `R_i = polar(F_i)`, `e = sym(R^T F) - I`, `P = R (2 mu e + lambda tr(e) I)`;
//! - residuals `d_ij = x_ji - F_i X_ji` and their sum `L_i = sum w_ij d_ij`, which no F sees (zero-energy modes);
//! - `E_i = s_i V [e : sigma / 2 + a/2 sum w_ij |d_ij|² + beta/2 |L_i|²]`, `s_i = 1 - l_i` the matrix fraction at i
//!   (eq. 18).
//!
//! Its exact gradient is the sum over pairs of `t_ij = s_i V w_ij [P A^-1 X + a d + beta (1 - b . X) L]` with
//! `b_i = A_i^-1 B_i`, added to i and taken from j: `sum_j w d (x) X = 0` makes every other term vanish.
//!
//! # Two passes over the neighbours
//!
//! The force is evaluated on the deviation `u = x - R_b X` from a rigid turn R_b of the whole body, because terms of
//! the size of the rest shape would otherwise cancel only to round-off and leak momentum. With `B_i = sum w_ij X_ji`
//! and `n_i = sum w_ij` from the rest shape, the first pass gathers at each particle
//!
//! ```text
//! S_i = sum_j w_ij u_ji              = sum_j w_ij u_j            - n_i u_i
//! M_i = sum_j w_ij u_ji (x) X_ji     = sum_j w_ij u_j (x) X_ji   - u_i (x) B_i
//! ```
//!
//! and makes of them `G = F - R_b = M A^-1`, `L = S - G B`, R, P, and what neighbours feel of the particle,
//!
//! ```text
//! Q = s V (P A^-1 - a G - beta L (x) b),     al = s V a,     Y = s V beta L.
//! ```
//!
//! With these `t_ij = w_ij (Q_i X_ji + al_i u_ji + Y_i)`, and `t_ji = -w_ij (Q_j X_ji + al_j u_ji - Y_j)`, so that the
//! second pass gathers
//!
//! ```text
//! f_i = sum_j (t_ij - t_ji)
//!     = Q_i B_i + al_i S_i + n_i Y_i + sum_j w_ij (Q_j X_ji + al_j u_ji - Y_j)
//!     = [Q_i B_i + al_i S_i + n_i Y_i - (sum_j w_ij al_j) u_i] + sum_j w_ij (Q_j X_ji + z_j),     z = al u - Y.
//! ```
//!
//! The bracket is the particle's own, known after the first pass. On the right, neighbours enter by constant weights
//! alone; u_ji is expanded like this only where that pays, by the stencil.
//!
//! # Evaluations
//!
//! They give the same forces up to round-off:
//!
//! - *stencil*, for particles on a lattice: an offset there has the same weight all over the body, so that whole rows
//!   of particles are added at a time, without looking any neighbour up. The one in use wherever it can be.
//! - *stencil in f32*, where a scene asks for it: positions, turns and strains are taken from the rigid motion of the
//!   body, R_b and its mean place, which stay f64, and forces are summed in its axes. So numbers are as small as the
//!   deformation, and so are their errors; a body that flies, spins or rests unstrained is exact.
//! - *pair list*: particle by particle through its neighbours, four to five times slower. It takes any spacing, says in
//!   few lines what is computed, and is what the stencil is held against. Beside seams it is that of the bonds that are
//!   left ([`seams`]), whatever the rest is computed by.
//!
//! The words of the stencil, on one layer of a lattice:
//!
//! ```text
//!           x -->                                                   o  a particle,  .  a place without one
//! row y + 1             [. o o o] [o o o o] [o o . .]               [       ]  a brick: four places along x, or eight
//! row y                 [o o o o] [o o o o] [o o o .]
//! row y - 1             [o o o o] [o . . .]
//!
//! site            0         1         2         3         4
//! row y       (. . . .) [o o o o] [o o o o] [o o o .] (. . . .)     its bricks and a site beside either end
//! line C_k    (c c c c) [c c c c] [c c c c] [c c c c] (c c c c)     a number a place, from all rows around it
//! at x - 1                    <c   c c c>                           what the brick at site 2 reads of C_1,
//! at x + 1                          <c c c   c>                     behind and ahead
//! ```
//!
//! A *chunk* is the bricks of some whole rows with all their *sites*, one after the other: what a thread works on at a
//! time. A *line* runs along the sites of a chunk and holds a combined row `C_k`: for every place the sum of what
//! stands there in all rows (dy, dz) around it, by the weights of offsets with |dx| = k. For the second pass, with
//! `Q X_ji = D (dx Q_x + dy Q_y + dz Q_z)` by the columns of Q, these are
//!
//! ```text
//! E_k = sum over (dy, dz) of w(k² + dy² + dz²) (z + D dy Q_y + D dz Q_z)
//! O_k = sum over (dy, dz) of w(k² + dy² + dz²) k D Q_x
//! sum_j w_ij (Q_j X_ji + z_j)  at x  =  E_0(x) + sum over k > 0 of (E_k + O_k)(x + k) + (E_k - O_k)(x - k).
//! ```

mod elasticity;
mod evaluation;
mod flow_rule;
mod force;
mod inelastic;
mod mean_rotation;
mod pair_list;
mod partial;
mod reference;
mod regions;
mod seams;
mod stencil;
mod thinning;
mod von_mises;

pub use elasticity::Elasticity;
pub use evaluation::EvaluationKind;
pub(crate) use flow_rule::{Plasticity, Viscosity};
pub use force::MatrixForce;
pub(crate) use inelastic::{Inelastic, InelasticLaw};
pub(crate) use seams::SeamBonds;
pub use seams::SeamTear;
pub(crate) use thinning::MatrixThinning;
