// What every shader of a picture shares: the frame, light, and how colours leave. Put in front of the other files.

struct FrameUniforms {
    // From the list's own coordinates to clip space; depth is 1 near and 0 far.
    clip_from_local: mat4x4f,
    // The view's axes in the world; in w of the last, 1 for a perspective and 0 for a parallel view.
    view_right: vec4f,
    view_up: vec4f,
    view_back: vec4f,
    // Where the eye is; in w, whether it is below the ground.
    eye: vec4f,
    // Width and height [pixels], pixels a unit of line width.
    size: vec4f,
    // Scale and offset in clip space, with which a pick looks at its pixel only.
    window: vec4f,
    // Towards the key light; in w its strength.
    key_direction: vec4f,
    key: vec4f,
    // In w the strength of the fill.
    sky: vec4f,
    bounce: vec4f,
    // In w the strength of the rim.
    rim: vec4f,
    background_top: vec4f,
    background_bottom: vec4f,
    floor: vec4f,
    grid: vec4f,
    // Colours of the plane's own axes, along u and along v.
    axis_u: vec4f,
    axis_v: vec4f,
    // The plane that carries the grid: middle and directions; in w its reach, 1 if it faces the eye, 1 if it is drawn.
    plane_center: vec4f,
    plane_u: vec4f,
    plane_v: vec4f,
    // Offset of the coordinates along u and v from the nearest line, and the coordinates of the middle themselves [m].
    plane_offset: vec4f,
    // Distance of minor lines [m], their opacity, distance of major lines [m], height of the ground.
    steps: vec4f,
    // 1 for a floor, strength of its shadow, length over which it darkens what stands on it [m], 1 if it has a shadow.
    ground: vec4f,
    // Middle of the shadow in X and Z, and half its extent.
    shadow: vec4f,
    // Out of what is left of bodies that are cut open, and the height along it of the cut.
    slice: vec4f,
}

@group(0) @binding(0) var<uniform> frame: FrameUniforms;
@group(0) @binding(1) var shadow_map: texture_2d<f32>;
@group(0) @binding(2) var shadow_sampler: sampler;

// Clip coordinates as seen through the window of a pick.
fn windowed(clip: vec4f) -> vec4f {
    return vec4f(clip.xy * frame.window.xy + frame.window.zw * clip.w, clip.zw);
}

// A depth a hair nearer to the eye, for what is drawn upon something else.
fn nearer(z: f32) -> f32 {
    return select(z + 5e-7, z * 1.0002, frame.view_back.w > 0.5);
}

fn toward_eye(local: vec3f) -> vec3f {
    if frame.view_back.w > 0.5 {
        return normalize(frame.eye.xyz - local);
    }
    return frame.view_back.xyz;
}

// Distance from the eye along its line of view.
fn view_depth(local: vec3f) -> f32 {
    return dot(frame.eye.xyz - local, frame.view_back.xyz);
}

// The curve of sRGB, its power by a sum of roots fitted to a hundredth of a step of eight bits: a power costs a driver
// without a graphics card more than all else that a floor's pixel needs.
fn encode(linear: vec3f) -> vec3f {
    let c = clamp(linear, vec3f(0.0), vec3f(1.0));
    let second = sqrt(c);
    let fourth = sqrt(second);
    let power = 0.642388 * second + 0.712085 * fourth - 0.336859 * sqrt(fourth) - 0.017571 * c;
    return select(power, 12.92 * c, c <= vec3f(0.0031308));
}

// Half a step of eight bits, up or down, so that slow gradients show no bands.
fn dither(pixel: vec2f) -> f32 {
    return (fract(52.9829189 * fract(dot(pixel, vec2f(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

fn out_colour(linear: vec3f, alpha: f32, pixel: vec2f) -> vec4f {
    return vec4f(encode(linear) + dither(pixel), alpha);
}

// A soft material: a key light that wraps round it, fill from sky and ground, a sheen, a rim, and less light close to
// the floor, where the body itself stands in the way.
fn lit(albedo: vec3f, normal: vec3f, local: vec3f) -> vec3f {
    let eye = toward_eye(local);
    let facing = dot(normal, frame.key_direction.xyz);
    let wrap = 0.42;
    let fall = clamp((facing + wrap) / (1.0 + wrap), 0.0, 1.0);
    let key = fall * fall * (3.0 - 2.0 * fall) * frame.key_direction.w;
    let up = 0.5 + 0.5 * normal.y;
    let fill = mix(frame.bounce.rgb, frame.sky.rgb, up) * frame.sky.w * mix(0.72, 1.0, up);
    // Light that entered elsewhere comes out warmer and deeper where the key light fades.
    let depth = fall * (1.0 - fall) * 4.0;
    let inner = mix(albedo, albedo * albedo * 1.25, 0.35 * depth);
    var above = 1.0;
    if frame.ground.x > 0.5 {
        let height = clamp((local.y - frame.steps.w) / frame.ground.z, 0.0, 1.0);
        above = mix(mix(0.50, 0.80, up), 1.0, sqrt(height));
    }
    // A faint cool light from the other side keeps the shape of what the key light leaves.
    let other = clamp(dot(normal, normalize(vec3f(0.75, 0.25, 0.55))), 0.0, 1.0) * 0.30 * frame.sky.w;
    var colour = inner * (frame.key.rgb * key + fill * above + frame.sky.rgb * other);
    let half_way = normalize(frame.key_direction.xyz + eye);
    let sheen = pow(max(dot(normal, half_way), 0.0), 26.0) * 0.10 + pow(max(dot(normal, half_way), 0.0), 6.0) * 0.05;
    colour += frame.key.rgb * sheen * smoothstep(0.0, 0.3, facing + 0.2);
    let edge = pow(1.0 - clamp(dot(normal, eye), 0.0, 1.0), 3.5);
    colour += frame.rim.rgb * edge * frame.rim.w * above * mix(0.45, 1.0, up);
    return colour;
}
