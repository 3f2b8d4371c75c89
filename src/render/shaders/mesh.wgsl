// Triangle meshes: lit, see-through, faint, or as numbers to pick.

struct MeshOut {
    @builtin(position) clip: vec4f,
    // Within the triangle: what is extrapolated beyond its edge makes bright specks along outlines.
    @location(0) @interpolate(perspective, centroid) local: vec3f,
    @location(1) @interpolate(perspective, centroid) normal: vec3f,
    @location(2) @interpolate(perspective, centroid) colour: vec4f,
    @location(3) @interpolate(flat) pick: u32,
    // Height above the plane that cuts the mesh open, or less than nothing for one that is not cut.
    @location(4) above: f32,
}

@vertex
fn vs_mesh(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) colour: vec4f,
    @location(3) pick: u32,
    // A colour of the vertex's own, sRGB; in w, 1 if it has one.
    @location(4) tint: vec4f,
    // 1 if it is cut open.
    @location(5) cut: u32,
) -> MeshOut {
    let linear = select(pow((tint.rgb + 0.055) / 1.055, vec3f(2.4)), tint.rgb / 12.92, tint.rgb <= vec3f(0.04045));
    let own = vec4f(mix(colour.rgb, linear, tint.w), colour.a);
    let above = select(-1.0, dot(frame.slice.xyz, position) - frame.slice.w, cut == 1u);
    return MeshOut(windowed(frame.clip_from_local * vec4f(position, 1.0)), position, normal, own, pick, above);
}

@fragment
fn fs_solid(in: MeshOut) -> @location(0) vec4f {
    if in.above > 0.0 {
        discard;
    }
    return out_colour(lit(in.colour.rgb, normalize(in.normal), in.local), 1.0, in.clip.xy);
}

// The far side of a mesh that is cut open, seen from within: even and dark, so that the cut itself stands out.
@fragment
fn fs_inside(in: MeshOut) -> @location(0) vec4f {
    if in.above > 0.0 {
        discard;
    }
    return out_colour(0.32 * in.colour.rgb, 1.0, in.clip.xy);
}

// Clear in the middle, dense towards the outline, as a thin wall of jelly is.
@fragment
fn fs_x_ray(in: MeshOut, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    if in.above > 0.0 {
        discard;
    }
    let normal = normalize(in.normal);
    let eye = toward_eye(in.local);
    let slant = 1.0 - abs(dot(normal, eye));
    let density = mix(0.13, 0.70, pow(slant, 2.2)) * select(0.55, 1.0, front);
    let colour = lit(in.colour.rgb, select(-normal, normal, dot(normal, eye) > 0.0), in.local);
    return out_colour(colour, density, in.clip.xy);
}

// A thin film: lit from the side that is seen, denser where it is seen aslant.
@fragment
fn fs_film(in: MeshOut) -> @location(0) vec4f {
    if in.above > 0.0 {
        discard;
    }
    let normal = normalize(in.normal);
    let eye = toward_eye(in.local);
    let slant = 1.0 - abs(dot(normal, eye));
    let density = mix(in.colour.a, 1.0, 0.5 * slant * slant);
    let colour = lit(in.colour.rgb, select(-normal, normal, dot(normal, eye) > 0.0), in.local);
    return out_colour(colour, density, in.clip.xy);
}

@fragment
fn fs_faint(in: MeshOut) -> @location(0) vec4f {
    if in.above > 0.0 {
        discard;
    }
    return out_colour(in.colour.rgb, in.colour.a, in.clip.xy);
}

@fragment
fn fs_mesh_pick(in: MeshOut) -> @location(0) vec2u {
    if in.above > 0.0 {
        discard;
    }
    return vec2u(in.pick, bitcast<u32>(view_depth(in.local)));
}
