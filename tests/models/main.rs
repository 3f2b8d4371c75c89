//! Models: import, check, fill, skin.

mod checks;
mod damage;
mod filling;
mod formats;
mod scenes;
mod shapes;
mod shipped;
mod skin;
