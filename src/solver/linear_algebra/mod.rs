//! Linear algebra over fields of one vector a particle: Krylov methods (Lanczos, Arnoldi), for
//! operators that are given by what they make of a field, and the eigenvalues of small matrices.
//!
//! Every sum runs over the particles in their order and on one thread, so that results have the same bits anywhere.

pub(crate) mod arnoldi;
pub(crate) mod hessenberg;
pub(crate) mod lanczos;
pub(crate) mod symmetric;
pub(crate) mod vectors;
