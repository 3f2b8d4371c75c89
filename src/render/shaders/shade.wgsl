// From heights above the floor to the light that is hidden there: see shadow.wgsl.

struct Caster {
    slope: vec4f,
    window: vec4f,
    soft: vec4f,
}

@group(0) @binding(0) var<uniform> caster: Caster;
@group(0) @binding(1) var along_key: texture_2d<f32>;
@group(0) @binding(2) var from_above: texture_2d<f32>;

const SEARCH = 32u;
const TAPS = 64u;
// Cosine and sine of the golden angle, by which each point of a spread is turned against the one before.
const TURN = vec2f(-0.73736888, 0.67549029);

@vertex
fn vs_shade(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0;
    return vec4f(corner, 0.0, 1.0);
}

// The direction of the next point of a spread.
fn turned(direction: vec2f) -> vec2f {
    return vec2f(
        TURN.x * direction.x - TURN.y * direction.y,
        TURN.y * direction.x + TURN.x * direction.y,
    );
}

// Points spread evenly over a disc of radius 1 have these distances from its middle, the golden angle between them.
fn distance_of(k: u32, count: u32) -> f32 {
    return sqrt((f32(k) + 0.5) / f32(count));
}

fn clamped(at: vec2f) -> vec2i {
    let most = vec2f(textureDimensions(along_key)) - 1.0;
    return vec2i(clamp(at, vec2f(0.0), most));
}

@fragment
fn fs_shade(@builtin(position) at: vec4f) -> @location(0) vec2f {
    let texels = f32(textureDimensions(along_key).x);
    let texel = 2.0 * caster.window.z / texels;
    // How high is what stands in the way, as far away as the highest could be seen? What is too low to be seen from
    // here so far away counts less and less, so that the answer has no steps.
    let search = max(caster.soft.x * caster.slope.w / texel, 1.0);
    var height = 0.0;
    var found = 0.0;
    var direction = vec2f(1.0, 0.0);
    for (var k = 0u; k < SEARCH; k++) {
        let away = distance_of(k, SEARCH);
        let depth = textureLoad(along_key, clamped(at.xy + direction * away * search), 0).r;
        direction = turned(direction);
        let near = clamp((depth - away) * 6.0 + 1.0 + 3.0 / search, 0.0, 1.0);
        let weight = select(0.0, near, depth < 1.0);
        height += depth * weight;
        found += weight;
    }
    let penumbra = max(search * height / max(found, 1e-4), 1.5);
    var hidden = 0.0;
    var total = 0.0;
    direction = vec2f(1.0, 0.0);
    for (var k = 0u; k < TAPS; k++) {
        let away = distance_of(k, TAPS);
        let weight = 1.0 - 0.85 * away * away;
        let depth = textureLoad(along_key, clamped(at.xy + direction * away * penumbra * 1.3), 0).r;
        direction = turned(direction);
        hidden += select(0.0, weight, depth < 1.0);
        total += weight;
    }
    hidden = hidden / total * clamp(found * 4.0, 0.0, 1.0);
    // The sky is hidden most by what is low and near.
    let reach = caster.soft.y / texel;
    var closed = 0.0;
    var whole = 0.0;
    direction = vec2f(1.0, 0.0);
    for (var k = 0u; k < TAPS; k++) {
        let away = distance_of(k, TAPS);
        let weight = 1.0 - away;
        let depth = textureLoad(from_above, clamped(at.xy + direction * away * reach), 0).r;
        direction = turned(direction);
        closed += select(0.0, weight * exp(-depth * caster.slope.w / caster.soft.z), depth < 1.0);
        whole += weight;
    }
    return vec2f(hidden, closed / whole);
}
