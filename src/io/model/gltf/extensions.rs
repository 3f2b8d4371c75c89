//! What a glTF file says that a reader must know of.

use super::super::failure::Failure;
use super::super::notes::note;
use super::buffers::compressed;
use crate::geometry::model_report::Finding;
use crate::scene::one_line;

/// Extensions that are read.
const READ: [&str; 2] = ["KHR_mesh_quantization", "EXT_mesh_gpu_instancing"];

/// How the names of those begin that change how a surface looks, or what stands beside it, and not its shape.
const LOOKS: [&str; 11] = [
    "KHR_materials_",
    "EXT_materials_",
    "MSFT_packing_",
    "KHR_texture_",
    "EXT_texture_",
    "MSFT_texture_",
    "KHR_lights_",
    "EXT_lights_",
    "KHR_animation_",
    "KHR_xmp",
    "AGI_",
];

/// Notes on what is left out.
///
/// # Errors
/// An extension without which the shape would be another.
pub(super) fn left_out(required: &[String]) -> Result<Vec<Finding>, Failure> {
    let mut notes = Vec::new();
    for name in required.iter().filter(|name| !READ.contains(&name.as_str())) {
        let shown = one_line(name);
        if name.contains("draco") || name.contains("meshopt") {
            return Err(compressed(&shown));
        }
        if !LOOKS.iter().any(|start| name.starts_with(start)) {
            return Err(Failure::with(
                format_args!("it needs the extension {shown}, which is not read here"),
                "export it without that",
            ));
        }
        notes.push(note(format!("{shown} is left out: it changes how the model looks, not its shape")));
    }
    Ok(notes)
}
