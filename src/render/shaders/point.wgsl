// Balls and dots: a square that faces the eye, shaded as the ball that it stands for.

struct PointOut {
    @builtin(position) clip: vec4f,
    @location(0) corner: vec2f,
    @location(1) @interpolate(flat) colour: vec4f,
    @location(2) @interpolate(flat) centre: vec3f,
    // Radius [pixels], radius [m]; the latter is 0 for a dot of constant size.
    @location(3) @interpolate(flat) radius: vec2f,
    @location(4) @interpolate(flat) pick: u32,
    @location(5) @interpolate(flat) through: f32,
}

@vertex
fn vs_point(
    @builtin(vertex_index) index: u32,
    @location(0) centre: vec3f,
    @location(1) radius: f32,
    @location(2) colour: vec4f,
    @location(3) through: f32,
    @location(4) pick: u32,
) -> PointOut {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    let clip = frame.clip_from_local * vec4f(centre, 1.0);
    // Pixels a metre at the centre: how far a step upwards moves on the screen.
    let step = (frame.clip_from_local * vec4f(frame.view_up.xyz, 0.0)).y;
    let scale = abs(step) / clip.w * frame.size.y * 0.5;
    let metres = max(radius, 0.0);
    let pixels = select(-radius * frame.size.z, radius * scale, radius > 0.0);
    // One pixel more than the radius, for the soft edge.
    let reach = pixels + 1.0;
    let offset = corner * reach * 2.0 / frame.size.xy;
    var out = vec4f(clip.xy + offset * clip.w, clip.zw);
    // Strokes' dots stand a little before what they lie on.
    if radius < 0.0 {
        out.z = nearer(out.z / out.w) * out.w;
    }
    return PointOut(windowed(out), corner * reach / pixels, colour, centre, vec2f(pixels, metres), pick, through);
}

// How much of a pixel at this distance from the centre, in radii, is covered.
fn cover(in: PointOut) -> f32 {
    return clamp((1.0 - length(in.corner)) * in.radius.x + 0.5, 0.0, 1.0);
}

fn ball(in: PointOut) -> vec3f {
    let flat_part = min(dot(in.corner, in.corner), 1.0);
    let toward = sqrt(1.0 - flat_part);
    let axes = mat3x3f(frame.view_right.xyz, frame.view_up.xyz, frame.view_back.xyz);
    let normal = axes * normalize(vec3f(in.corner, toward));
    if in.radius.y > 0.0 {
        return lit(in.colour.rgb, normal, in.centre + normal * in.radius.y);
    }
    return in.colour.rgb;
}

@fragment
fn fs_point(in: PointOut) -> @location(0) vec4f {
    let alpha = cover(in) * in.colour.a;
    if alpha < 0.02 {
        discard;
    }
    return out_colour(ball(in), alpha, in.clip.xy);
}

// Where something is in front.
@fragment
fn fs_point_through(in: PointOut) -> @location(0) vec4f {
    let alpha = cover(in) * in.colour.a * in.through;
    if alpha < 0.02 {
        discard;
    }
    return out_colour(ball(in), alpha, in.clip.xy);
}

@fragment
fn fs_point_pick(in: PointOut) -> @location(0) vec2u {
    let rise = 1.0 - dot(in.corner, in.corner);
    if rise < 0.0 {
        discard;
    }
    return vec2u(in.pick, bitcast<u32>(view_depth(in.centre) - in.radius.y * sqrt(rise)));
}
