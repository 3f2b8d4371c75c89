//! A [`DrawList`](crate::draw::DrawList) becomes pixels, and a pixel becomes what was drawn there.
//!
//! # How it works
//!
//! A `Renderer` holds what does not change: shaders and pipelines, for one device. A [`Content`] is a list on that
//! device with the shadow it casts, whatever the point of view; a `Viewport` holds the targets of one view. So a
//! list is sent once and drawn in as many views as there are. The renderer draws into its own colour, depth and
//! multi-sample targets and hands out the colour as a texture, for a window to show or a file to keep.
//!
//! Colours are encoded as sRGB by the shaders, into a target that knows nothing of it: that is what a window's
//! toolkit blends with. Depth is reversed. Lines and marks keep their width in pixels: they are unfolded in screen
//! space and their edges are faded by distance, so they are smooth without multi-sampling too.
//!
//! Picking draws pick numbers and depths into a target of their own around one pixel only, with the same geometry as
//! the picture and so with the same things in front of others, and reads that back.

mod blit;
mod camera;
mod content;
pub(crate) mod device;
mod draw_calls;
mod encoding;
mod gif;
mod glyphs;
mod marks;
mod offscreen;
pub(crate) mod pick;
mod picture_pass;
mod pipelines;
mod renderer;
mod scale;
mod send;
mod shaders;
mod shadow;
mod shadow_pass;
mod skinning;
mod store;
mod targets;
mod uniforms;
mod viewport;

pub(crate) use blit::Blit;
pub use camera::{Camera, Facing, Projected, Projection, Ray};
pub use content::Content;
pub use device::NoDriver;
pub(crate) use gif::GifPictures;
#[cfg(feature = "gui")]
pub(crate) use offscreen::read_back;
pub use offscreen::{Offscreen, Picture, RenderError};
pub use renderer::Options;
pub(crate) use renderer::Renderer;
pub(crate) use viewport::Viewport;
