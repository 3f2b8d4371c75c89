//! Models: import, check, fill, skin.

mod filling;
mod shapes;
