// The plane that carries the grid: the floor with its shadow, a grid in the air, or the paper of a drawing view.

struct GroundOut {
    @builtin(position) clip: vec4f,
    @location(0) local: vec3f,
    // Metres along u and v from the plane's middle.
    @location(1) plane: vec2f,
}

@vertex
fn vs_ground(@builtin(vertex_index) index: u32) -> GroundOut {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    let plane = corner * frame.plane_center.w;
    let local = frame.plane_center.xyz + frame.plane_u.xyz * plane.x + frame.plane_v.xyz * plane.y;
    return GroundOut(frame.clip_from_local * vec4f(local, 1.0), local, plane);
}

// Opacity of lines at multiples of `step`, `width` pixels wide; `at` [m], `pixel` metres a pixel.
fn lines(at: vec2f, step: f32, pixel: vec2f, width: f32) -> f32 {
    let distance = abs(fract(at / step - 0.5) - 0.5) * step / pixel;
    let cover = clamp(0.5 * width + 0.5 - distance, vec2f(0.0), vec2f(1.0));
    // Lines that come closer than a few pixels fade instead of becoming a moiré.
    let open = 1.0 - smoothstep(vec2f(0.06), vec2f(0.30), pixel / step);
    let seen = cover * open;
    return max(seen.x, seen.y);
}

fn grid(in: GroundOut, pixel: vec2f) -> vec4f {
    if frame.plane_v.w < 0.5 {
        return vec4f(0.0);
    }
    let at = in.plane + frame.plane_offset.xy;
    let thin = frame.size.z;
    let minor = lines(at, frame.steps.x, pixel, thin) * frame.steps.y * 0.38;
    let major = lines(at, frame.steps.z, pixel, thin);
    var colour = vec4f(frame.grid.rgb, frame.grid.a * max(minor, major));
    // The axes themselves: u runs where v is zero.
    let own = abs(in.plane + frame.plane_offset.zw) / pixel;
    let axis = clamp(0.75 * thin + 0.5 - own, vec2f(0.0), vec2f(1.0));
    colour = mix(colour, vec4f(frame.axis_u.rgb, 0.65), axis.y);
    colour = mix(colour, vec4f(frame.axis_v.rgb, 0.65), axis.x);
    return colour;
}

fn over(below: vec4f, above: vec4f) -> vec4f {
    let alpha = above.a + below.a * (1.0 - above.a);
    return vec4f(mix(below.rgb * below.a, above.rgb, above.a) / max(alpha, 1e-4), alpha);
}

@fragment
fn fs_ground(in: GroundOut) -> @location(0) vec4f {
    let pixel = max(fwidth(in.plane), vec2f(1e-12));
    let reach = length(in.plane) / frame.plane_center.w;
    var colour = vec4f(0.0);
    var lines = grid(in, pixel);
    if frame.plane_u.w > 0.5 {
        // Paper: what lies below the floor is darker, and the floor is a line.
        if frame.ground.x > 0.5 {
            let below = (frame.steps.w - in.local.y) / max(pixel.y, 1e-12);
            let shade = clamp(below + 0.5, 0.0, 1.0);
            let edge = clamp(frame.size.z + 0.5 - abs(below), 0.0, 1.0);
            colour = vec4f(frame.grid.rgb, max(0.16 * shade * frame.ground.x, 0.5 * edge));
        }
        colour = over(colour, lines);
        return out_colour(colour.rgb, colour.a, in.clip.xy);
    }
    let fade = 1.0 - smoothstep(0.12, 1.0, reach);
    if frame.ground.x > 0.5 {
        var floor = frame.floor.rgb;
        if frame.ground.w > 0.5 {
            let uv = (in.local.xz - frame.shadow.xy) / frame.shadow.z * 0.5 + 0.5;
            // Four taps smooth what is left of the shadow's texels, and none are needed beside it.
            let beside = any(abs(uv - 0.5) > vec2f(0.5));
            let texel = 0.75 / vec2f(textureDimensions(shadow_map));
            var shade = vec2f(0.0);
            for (var k = 0u; k < select(4u, 0u, beside); k++) {
                let corner = (vec2f(f32(k & 1u), f32(k >> 1u)) * 2.0 - 1.0) * texel;
                shade += 0.25 * textureSampleLevel(shadow_map, shadow_sampler, uv + corner, 0.0).rg;
            }
            let light = (1.0 - frame.ground.y * shade.r) * (1.0 - 0.75 * frame.ground.y * shade.g);
            floor *= light;
            lines.a *= mix(0.5, 1.0, light);
        }
        colour = over(vec4f(floor, 1.0), lines);
    } else {
        colour = lines;
    }
    let below = select(1.0, 0.35, frame.eye.w > 0.5 && frame.ground.x > 0.5);
    return out_colour(colour.rgb, colour.a * fade * below, in.clip.xy);
}
