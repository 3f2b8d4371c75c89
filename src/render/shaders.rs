//! The shaders' sources. WGSL has no includes: what they share is put in front of each.

macro_rules! with_common {
    ($file:literal) => {
        concat!(include_str!("shaders/common.wgsl"), "\n", include_str!($file))
    };
}

pub(super) const BLIT: &str = include_str!("shaders/blit.wgsl");
pub(super) const BACKGROUND: &str = with_common!("shaders/background.wgsl");
pub(super) const GROUND: &str = with_common!("shaders/ground.wgsl");
pub(super) const LINE: &str = with_common!("shaders/line.wgsl");
pub(super) const MESH: &str = with_common!("shaders/mesh.wgsl");
pub(super) const POINT: &str = with_common!("shaders/point.wgsl");
pub(super) const SHADOW: &str = include_str!("shaders/shadow.wgsl");
pub(super) const SHADE: &str = include_str!("shaders/shade.wgsl");
pub(super) const SKIN: &str = include_str!("shaders/skin.wgsl");

#[cfg(test)]
mod tests {
    use super::*;
    use naga::valid::{Capabilities, ValidationFlags, Validator};
    use std::fs;
    use std::path::Path;

    #[test]
    fn every_shader_is_valid_and_its_frame_is_as_large_as_the_one_that_is_sent() {
        let sources = [BLIT, BACKGROUND, GROUND, LINE, MESH, POINT, SHADOW, SHADE, SKIN];
        for source in sources {
            let module =
                naga::front::wgsl::parse_str(source).unwrap_or_else(|error| panic!("{}", error.emit_to_string(source)));
            let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
                .validate(&module)
                .unwrap_or_else(|error| panic!("{}", error.emit_to_string(source)));
            assert!(!module.entry_points.is_empty());
            drop(info);
            let size = |name: &str| {
                module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name)).map(|(_, ty)| match &ty.inner {
                    naga::TypeInner::Struct { span, .. } => *span as usize,
                    other => panic!("{name} is {other:?}"),
                })
            };
            let frame = size("FrameUniforms").unwrap_or(size_of::<crate::render::uniforms::FrameUniforms>());
            assert_eq!(frame, size_of::<crate::render::uniforms::FrameUniforms>());
            let caster = size("Caster").unwrap_or(size_of::<crate::render::shadow::Caster>());
            assert_eq!(caster, size_of::<crate::render::shadow::Caster>());
        }
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/render/shaders");
        let files = fs::read_dir(folder).unwrap().count();
        assert_eq!(files, sources.len() + 1, "a file is not among those that are checked");
    }
}
