//! Linear algebra over fields of one vector a particle: Krylov methods (Lanczos, Arnoldi, conjugate gradients), for
//! operators that are given by what they make of a field, and the eigenvalues of the small matrices that they end in.
//!
//! Every sum runs over the particles in their order and on one thread, so that results have the same bits anywhere.

pub mod arnoldi;
pub mod conjugate_gradients;
pub mod hessenberg;
pub mod lanczos;
pub mod vectors;
