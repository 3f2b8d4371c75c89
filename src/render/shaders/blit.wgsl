// A finished picture, pixel by pixel, into a target of the same size.

@group(0) @binding(0) var picture: texture_2d<f32>;

struct BlitOut {
    @builtin(position) clip: vec4f,
    @location(0) at: vec2f,
}

@vertex
fn vs_blit(@builtin(vertex_index) index: u32) -> BlitOut {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0;
    return BlitOut(vec4f(corner.x * 2.0 - 1.0, 1.0 - corner.y * 2.0, 0.0, 1.0), corner);
}

fn texel(at: vec2f) -> vec3f {
    let size = vec2i(textureDimensions(picture));
    return textureLoad(picture, clamp(vec2i(at * vec2f(size)), vec2i(0), size - 1), 0).rgb;
}

@fragment
fn fs_blit(in: BlitOut) -> @location(0) vec4f {
    return vec4f(texel(in.at), 1.0);
}

// Into a target that applies the curve of sRGB itself.
@fragment
fn fs_blit_linear(in: BlitOut) -> @location(0) vec4f {
    let c = texel(in.at);
    return vec4f(select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045)), 1.0);
}
