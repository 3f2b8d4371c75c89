// A quiet gradient behind everything, between two colours that are near enough to each other to be mixed as they leave.

struct BackgroundOut {
    @builtin(position) at: vec4f,
    @location(0) @interpolate(flat) top: vec3f,
    @location(1) @interpolate(flat) bottom: vec3f,
}

@vertex
fn vs_background(@builtin(vertex_index) index: u32) -> BackgroundOut {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0;
    let top = encode(frame.background_top.rgb);
    return BackgroundOut(vec4f(corner, 0.0, 1.0), top, encode(frame.background_bottom.rgb));
}

@fragment
fn fs_background(in: BackgroundOut) -> @location(0) vec4f {
    let down = smoothstep(0.0, 1.0, in.at.y / frame.size.y);
    return vec4f(mix(in.top, in.bottom, down) + dither(in.at.xy), 1.0);
}
