//! Bends whose rest shape turns with the material, four at a time.

use super::corner::FOLD;
use super::fibre_embedding::FibreEmbedding;
use super::packed_rods::PackedRods;
use super::soa::{SoaVectors, zeros};
use super::strip::BlockVectors;
use crate::solver::wide::{
    LANES, Lanes, Lanes4, Mat3x, Quatx, Vec3x, Wide, load_all, nearest_rotations, quaternion_of, vector_of,
};
use fearless_simd::{Simd, f64x4, prelude::*};
use glam::{DQuat, DVec3};

/// The curved bends of all fibres of a body.
#[derive(Debug)]
pub(super) struct CurvedBends {
    packs: Vec<BendPack>,
    /// What turns the particles around every bend, by the components of `om_k Z_k` [N m].
    spins: [SoaVectors; 3],
}

/// Four of them.
#[derive(Debug, Default)]
struct BendPack {
    /// Curvature binormals at rest, model frame.
    rest: [Lanes4; 3],
    /// Stiffnesses [N m]; zero of those that are broken, and where the last pack has no bend.
    stiffness: Lanes4,
}

/// What four of them do about their edges.
struct Bent<V> {
    /// Gradients by the edges before and after [N].
    by_edges: [Vec3x<V>; 2],
    /// [`CurvedBends::spins`].
    spins: [Vec3x<V>; 3],
}

impl CurvedBends {
    /// As drawn, and whole but for those that are `broken`, of all bends.
    pub(super) fn new(embedding: &FibreEmbedding, broken: &[bool]) -> Self {
        let count = embedding.curved.len().div_ceil(LANES);
        let mut this = Self {
            packs: (0..count).map(|_| BendPack::default()).collect(),
            spins: [0, 1, 2].map(|_| zeros(LANES * count)),
        };
        for (k, bend) in embedding.curved.iter().enumerate() {
            this.rest_at(k, bend.binormal);
            this.packs[k / LANES].stiffness.0[k % LANES] = bend.stiffness;
        }
        this.release(embedding, broken);
        this
    }

    /// Releases what is broken of all bends: it carries nothing any more.
    pub(super) fn release(&mut self, embedding: &FibreEmbedding, broken: &[bool]) {
        for (k, _) in embedding.curved.iter().enumerate().filter(|(_, bend)| broken[bend.bend]) {
            self.packs[k / LANES].stiffness.0[k % LANES] = 0.0;
        }
    }

    /// Gives curved bend `k` another curvature binormal at rest, model frame.
    pub(super) fn rest_at(&mut self, k: usize, binormal: DVec3) {
        for (c, lanes) in self.packs[k / LANES].rest.iter_mut().enumerate() {
            lanes.0[k % LANES] = binormal[c];
        }
    }

    /// Gives curved bend `k` another stiffness [N m].
    pub(super) fn stiffen(&mut self, k: usize, stiffness: f64) {
        self.packs[k / LANES].stiffness.0[k % LANES] = stiffness;
    }

    /// Adds their gradients by edges to the rods, from the particles of the blocks; gives what turns the particles
    /// around them.
    #[inline(always)]
    pub(super) fn bend<S: Simd>(
        &mut self,
        simd: S,
        embedding: &FibreEmbedding,
        blocks: &[BlockVectors],
        (turns, rods): (&mut [DQuat], &mut PackedRods),
    ) -> &[SoaVectors; 3] {
        for (pack, of) in self.packs.iter().enumerate() {
            let first = LANES * pack;
            let bends = &embedding.curved[first..embedding.curved.len().min(first + LANES)];
            // Where there is no bend nothing is turned, and edges have a length.
            let (mut gradients, mut starts) = ([[Lanes4::default(); 3]; 3], [Lanes4::default(); 4]);
            let (mut tangents, mut lengths) = ([[Lanes4::default(); 3]; 2], [Lanes4::splat(1.0); 2]);
            embedding.turns.gather_four(simd, first, blocks, &mut gradients);
            for lane in 0..LANES {
                let Some(bend) = bends.get(lane) else {
                    (0..3).for_each(|c| gradients[c][c].0[lane] = 1.0);
                    starts[3].0[lane] = 1.0;
                    continue;
                };
                let start = turns[bend.bend].to_array();
                for c in 0..4 {
                    starts[c].0[lane] = start[c];
                }
                for side in 0..2 {
                    let edge = rods.edge(bend.corner + side);
                    lengths[side].0[lane] = edge.length;
                    for c in 0..3 {
                        tangents[side][c].0[lane] = edge.tangent[c];
                    }
                }
            }
            let gradient: Mat3x<f64x4<S>> = Mat3x([
                Vec3x::load(simd, &gradients[0]),
                Vec3x::load(simd, &gradients[1]),
                Vec3x::load(simd, &gradients[2]),
            ]);
            let turn = nearest_rotations(gradient, Quatx::load(simd, &starts));
            let tangents = [Vec3x::load(simd, &tangents[0]), Vec3x::load(simd, &tangents[1])];
            let bent = of.bent(simd, (gradient, turn), tangents, load_all(simd, &lengths));
            let turned = turn.store();
            let [before, after] = [bent.by_edges[0].store(), bent.by_edges[1].store()];
            for (lane, bend) in bends.iter().enumerate() {
                turns[bend.bend] = quaternion_of(&turned, lane);
                rods.add(bend.corner, (vector_of(&before, lane), vector_of(&after, lane)));
            }
            for axis in 0..3 {
                let spin = bent.spins[axis].store();
                for c in 0..3 {
                    self.spins[axis][c][first..first + LANES].copy_from_slice(&spin[c].0);
                }
            }
        }
        &self.spins
    }
}

impl BendPack {
    /// `S |kb - R kb0|²` of four corners between edges with these tangents and lengths [m], around which the material
    /// is deformed by a gradient, turned by R; the scalar forms are those of `corner` and `material_turn`.
    #[inline(always)]
    fn bent<V: Wide<Memory = Lanes4>>(
        &self,
        simd: V::Set,
        (gradient, turn): (Mat3x<V>, Quatx<V>),
        [before, after]: [Vec3x<V>; 2],
        lengths: [V; 2],
    ) -> Bent<V> {
        let (zero, one) = (V::constant(simd, 0.0), V::constant(simd, 1.0));
        let (two, four) = (one + one, V::constant(simd, 4.0));
        let whole = lengths[0].simd_gt(zero) & lengths[1].simd_gt(zero);
        let stiffness = whole.select(V::load(simd, &self.stiffness), zero);
        let (inverse_before, inverse_after) =
            (whole.select(one / lengths[0], zero), whole.select(one / lengths[1], zero));
        let r = Mat3x::from_quat(turn);
        let rest = Vec3x::load(simd, &self.rest);
        // The binormal `2 g t x u` with `g = 1 / (1 + c)`, and its derivative dg by the cosine c, continued where it
        // folds.
        let cosine = before.dot(after);
        let folds = cosine.simd_lt(V::constant(simd, FOLD));
        let inverse = one / (one + cosine);
        let g = folds.select(four - four * (one + cosine), inverse);
        let dg = folds.select(-four, -(inverse * inverse));
        let cross = before.cross(after);
        let by_binormal = (cross * (two * g) - r * rest) * (two * stiffness);
        let along = two * dg * by_binormal.dot(cross);
        let by_before = after * along + after.cross(by_binormal) * (two * g);
        let by_after = before * along + by_binormal.cross(before) * (two * g);
        // From gradients by the unit tangents to gradients by the edges.
        let by_edges = [
            (by_before - before * before.dot(by_before)) * inverse_before,
            (by_after - after * after.dot(by_after)) * inverse_after,
        ];
        // The moment in the model frame, and p = (tr S I - S)^-1 of it by the adjugate of that symmetric matrix.
        let back = Vec3x([r[0].dot(by_binormal), r[1].dot(by_binormal), r[2].dot(by_binormal)]);
        let moment = back.cross(rest);
        let s = r.transpose_mul(gradient);
        let minus_half = V::constant(simd, -0.5);
        let (k00, k11, k22) = (s[1][1] + s[2][2], s[0][0] + s[2][2], s[0][0] + s[1][1]);
        let k01 = minus_half * (s[0][1] + s[1][0]);
        let k02 = minus_half * (s[0][2] + s[2][0]);
        let k12 = minus_half * (s[1][2] + s[2][1]);
        let adjugate = [
            k11.mul_sub(k22, k12 * k12),
            k02.mul_sub(k12, k01 * k22),
            k01.mul_sub(k12, k02 * k11),
            k00.mul_sub(k22, k02 * k02),
            k01.mul_sub(k02, k00 * k12),
            k00.mul_sub(k11, k01 * k01),
        ];
        let determinant = Vec3x([k00, k01, k02]).dot(Vec3x([adjugate[0], adjugate[1], adjugate[2]]));
        let scale = determinant.simd_eq(zero).select(zero, one / determinant);
        let Vec3x([x, y, z]) = Mat3x::symmetric(adjugate) * moment * scale;
        // R of the axes crossed with p.
        Bent { by_edges, spins: [r[2] * y - r[1] * z, r[0] * z - r[2] * x, r[1] * x - r[0] * y] }
    }
}
