// Lines of constant width in pixels. A segment is unfolded on the screen into a rectangle half a pixel larger all
// round, and fades by its distance from the middle. Where segments meet, each keeps to its own side of the line that
// halves the bend: no pixel is drawn twice, so that a faint line is faint at its joints too, and none is left out.

struct LineOut {
    @builtin(position) clip: vec4f,
    // Where [pixels], up.
    @location(0) at: vec2f,
    // The segment's ends [pixels].
    @location(1) @interpolate(flat) ends: vec4f,
    // Directions across the joints at its ends; zero where it is free.
    @location(2) @interpolate(flat) joints: vec4f,
    @location(3) @interpolate(flat) colour: vec4f,
    // Half the width [pixels], share that shows through.
    @location(4) @interpolate(flat) style: vec2f,
    @location(5) depth: f32,
    @location(6) @interpolate(flat) pick: u32,
}

const HAS_PREVIOUS = 1u;
const HAS_NEXT = 2u;
const ON_SCREEN = 4u;
const NEAR = 1e-6;

fn clip_of(local: vec3f, on_screen: bool) -> vec4f {
    if on_screen {
        return vec4f(local.xy / frame.size.xy * 2.0 - 1.0, 1.0, 1.0);
    }
    return frame.clip_from_local * vec4f(local, 1.0);
}

// A point that lies behind the eye is moved along its segment to just before it.
fn before_eye(clip: vec4f, other: vec4f) -> vec4f {
    if clip.w >= NEAR || other.w <= NEAR {
        return clip;
    }
    return mix(clip, other, (NEAR - clip.w) / (other.w - clip.w));
}

fn pixel_of(clip: vec4f) -> vec2f {
    return (clip.xy / max(clip.w, NEAR) * 0.5 + 0.5) * frame.size.xy;
}

fn direction(a: vec2f, b: vec2f) -> vec2f {
    let step = b - a;
    let long = length(step);
    return select(vec2f(0.0), step / long, long > 1e-4);
}

@vertex
fn vs_line(
    @builtin(vertex_index) index: u32,
    @location(0) start: vec3f,
    @location(1) end: vec3f,
    @location(2) previous: vec3f,
    @location(3) next: vec3f,
    @location(4) colour: vec4f,
    @location(5) style: vec2f,
    @location(6) flags: u32,
    @location(7) pick: u32,
) -> LineOut {
    let on_screen = (flags & ON_SCREEN) != 0u;
    let raw_a = clip_of(start, on_screen);
    let raw_b = clip_of(end, on_screen);
    let clip_a = before_eye(raw_a, raw_b);
    let clip_b = before_eye(raw_b, raw_a);
    let a = pixel_of(clip_a);
    let b = pixel_of(clip_b);
    var along = direction(a, b);
    if all(along == vec2f(0.0)) {
        along = vec2f(1.0, 0.0);
    }
    let across = vec2f(-along.y, along.x);
    let half_width = 0.5 * style.x * frame.size.z;
    let reach = half_width + 1.0;
    let far = (index & 1u) != 0u;
    let side = f32(index >> 1u) * 2.0 - 1.0;
    let at = select(a - along * reach, b + along * reach, far) + across * side * reach;
    let end_clip = select(clip_a, clip_b, far);
    let z = clamp(nearer(end_clip.z / end_clip.w), 0.0, 1.0);
    var joints = vec4f(0.0);
    if (flags & HAS_PREVIOUS) != 0u {
        joints = vec4f(direction(pixel_of(clip_of(previous, on_screen)), a) + along, joints.zw);
    }
    if (flags & HAS_NEXT) != 0u {
        joints = vec4f(joints.xy, direction(b, pixel_of(clip_of(next, on_screen))) + along);
    }
    var out: LineOut;
    out.clip = windowed(vec4f(at / frame.size.xy * 2.0 - 1.0, z, 1.0));
    // Both ends behind the eye: nothing.
    if raw_a.w < NEAR && raw_b.w < NEAR {
        out.clip = vec4f(2.0, 2.0, 2.0, 1.0);
    }
    out.at = at;
    out.ends = vec4f(a, b);
    out.joints = joints;
    out.colour = colour;
    out.style = vec2f(half_width, style.y);
    out.depth = view_depth(select(start, end, far));
    out.pick = pick;
    return out;
}

fn cover(in: LineOut) -> f32 {
    let a = in.ends.xy;
    let b = in.ends.zw;
    if dot(in.at - a, in.joints.xy) < 0.0 || (any(in.joints.zw != vec2f(0.0)) && dot(in.at - b, in.joints.zw) >= 0.0) {
        return 0.0;
    }
    let step = b - a;
    let share = clamp(dot(in.at - a, step) / max(dot(step, step), 1e-8), 0.0, 1.0);
    let distance = length(in.at - a - step * share);
    // A line thinner than a pixel is drawn a pixel wide and fainter.
    let half_width = max(in.style.x, 0.5);
    return clamp(half_width + 0.5 - distance, 0.0, 1.0) * min(2.0 * in.style.x, 1.0);
}

@fragment
fn fs_line(in: LineOut) -> @location(0) vec4f {
    let alpha = cover(in) * in.colour.a;
    if alpha <= 0.0 {
        discard;
    }
    return out_colour(in.colour.rgb, alpha, in.clip.xy);
}

// Where something is in front.
@fragment
fn fs_line_through(in: LineOut) -> @location(0) vec4f {
    let alpha = cover(in) * in.colour.a * in.style.y;
    if alpha <= 0.0 {
        discard;
    }
    return out_colour(in.colour.rgb, alpha, in.clip.xy);
}

@fragment
fn fs_line_pick(in: LineOut) -> @location(0) vec2u {
    if cover(in) < 0.5 {
        discard;
    }
    return vec2u(in.pick, bitcast<u32>(in.depth));
}
