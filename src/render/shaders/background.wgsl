// A quiet gradient behind everything.

@vertex
fn vs_background(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0;
    return vec4f(corner, 0.0, 1.0);
}

@fragment
fn fs_background(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let down = smoothstep(0.0, 1.0, at.y / frame.size.y);
    let colour = mix(frame.background_top.rgb, frame.background_bottom.rgb, down);
    return out_colour(colour, 1.0, at.xy);
}
