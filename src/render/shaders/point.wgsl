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
    // Depth of the square.
    @location(6) @interpolate(flat) flat_depth: f32,
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
    return PointOut(windowed(out), corner * reach / pixels, colour, centre, vec2f(pixels, metres), pick, through, out.z / out.w);
}

// How much of a pixel at this distance from the centre, in radii, is covered.
fn cover(in: PointOut) -> f32 {
    return clamp((1.0 - length(in.corner)) * in.radius.x + 0.5, 0.0, 1.0);
}

// The direction from the ball's centre to what is seen of it here.
fn bulge(in: PointOut) -> vec3f {
    let toward = sqrt(max(1.0 - dot(in.corner, in.corner), 0.0));
    let axes = mat3x3f(frame.view_right.xyz, frame.view_up.xyz, frame.view_back.xyz);
    return axes * normalize(vec3f(in.corner, toward));
}

struct PointSeen {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
}

fn seen(in: PointOut, through: f32) -> PointSeen {
    let alpha = cover(in) * in.colour.a * through;
    if alpha < 0.02 {
        discard;
    }
    if in.radius.y <= 0.0 {
        return PointSeen(out_colour(in.colour.rgb, alpha, in.clip.xy), in.clip.z);
    }
    let normal = bulge(in);
    let local = in.centre + normal * in.radius.y;
    let at = frame.clip_from_local * vec4f(local, 1.0);
    return PointSeen(out_colour(lit(in.colour.rgb, normal, local), alpha, in.clip.xy), at.z / at.w);
}

@fragment
fn fs_point(in: PointOut) -> PointSeen {
    return seen(in, 1.0);
}

// Where something is in front.
@fragment
fn fs_point_through(in: PointOut) -> PointSeen {
    return seen(in, in.through);
}

struct PointPicked {
    @location(0) pick: vec2u,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fs_point_pick(in: PointOut) -> PointPicked {
    if dot(in.corner, in.corner) > 1.0 {
        discard;
    }
    let local = in.centre + bulge(in) * in.radius.y;
    let at = frame.clip_from_local * vec4f(local, 1.0);
    // Depths of picks lie in the near half: see pick.rs.
    let depth = 0.5 + 0.5 * select(in.flat_depth, at.z / at.w, in.radius.y > 0.0);
    return PointPicked(vec2u(in.pick, bitcast<u32>(view_depth(local))), depth);
}
