//! Models: import, check, fill, skin.

mod cases;
mod checks;
mod damage;
mod filling;
mod formats;
mod gltf;
mod gltf_document;
#[path = "../alive/greeting.rs"]
#[allow(dead_code, reason = "the tests of scenes use the rest of it")]
mod greeting;
mod obj;
mod odd_files;
mod overlaps;
mod ply;
mod progress;
mod random;
mod random_formats;
mod random_meshes;
mod round_trip;
mod scenes;
mod shapes;
mod shipped;
mod skin;
mod stl;
mod tips;
mod writers;
