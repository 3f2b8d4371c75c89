// The shadow on the floor, whatever the point of view. First how high the lowest part of anything is above each place
// of the floor, seen along the light; then how much of the light, which is wide, is hidden there: a thing that stands
// on the floor has a crisp dark shadow, one in the air a wide faint one.

struct Caster {
    // Offset a metre of height in X and Z, ground height, greatest height [m].
    slope: vec4f,
    // Middle in X and Z, half extent.
    window: vec4f,
    // Width of the light a metre of distance, reach of the contact shadow [m], its height [m].
    soft: vec4f,
}

@group(0) @binding(0) var<uniform> caster: Caster;

fn fallen(local: vec3f, spread: vec2f) -> vec4f {
    let height = max(local.y - caster.slope.z, 0.0);
    let at = (local.xz + spread - caster.slope.xy * height - caster.window.xy) / caster.window.z;
    return vec4f(at.x, -at.y, min(height / caster.slope.w, 1.0) * 0.999, 1.0);
}

@vertex
fn vs_cast_mesh(@location(0) position: vec3f) -> @builtin(position) vec4f {
    return fallen(position, vec2f(0.0));
}

@vertex
fn vs_cast_point(
    @builtin(vertex_index) index: u32,
    @location(0) centre: vec3f,
    @location(1) radius: f32,
) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    // A square as large as the ball's disc.
    return fallen(centre - vec3f(0.0, max(radius, 0.0), 0.0), corner * max(radius, 0.0) * 0.886);
}
