// The skin of a body from its particles: sums of points, then normals from the faces around each vertex.

// Where the terms of every point start, and one more.
@group(0) @binding(0) var<storage, read> starts: array<u32>;
// A source and its weight; for normals, the other two corners of a face.
@group(0) @binding(1) var<storage, read> terms: array<vec2u>;
@group(0) @binding(2) var<storage, read> source: array<f32>;
@group(0) @binding(3) var<storage, read_write> target_words: array<f32>;

fn point(index: u32) -> vec3f {
    return vec3f(source[3u * index], source[3u * index + 1u], source[3u * index + 2u]);
}

@compute @workgroup_size(64)
fn sum_points(@builtin(global_invocation_id) id: vec3u) {
    let index = id.x;
    if index + 1u >= arrayLength(&starts) {
        return;
    }
    var sum = vec3f(0.0);
    for (var k = starts[index]; k < starts[index + 1u]; k += 1u) {
        sum += bitcast<f32>(terms[k].y) * point(terms[k].x);
    }
    target_words[3u * index] = sum.x;
    target_words[3u * index + 1u] = sum.y;
    target_words[3u * index + 2u] = sum.z;
}

// A vertex's row: its position, then the mean of the faces around it, weighed by their angle there.
@compute @workgroup_size(64)
fn shade_vertices(@builtin(global_invocation_id) id: vec3u) {
    let index = id.x;
    if index + 1u >= arrayLength(&starts) {
        return;
    }
    let here = point(index);
    var sum = vec3f(0.0);
    for (var k = starts[index]; k < starts[index + 1u]; k += 1u) {
        let b = point(terms[k].x) - here;
        let c = point(terms[k].y) - here;
        let area = cross(b, c);
        let size = length(area);
        if size > 0.0 {
            sum += area / size * atan2(size, dot(b, c));
        }
    }
    let size = length(sum);
    var normal = vec3f(0.0, 1.0, 0.0);
    if size > 0.0 {
        normal = sum / size;
    }
    target_words[6u * index] = here.x;
    target_words[6u * index + 1u] = here.y;
    target_words[6u * index + 2u] = here.z;
    target_words[6u * index + 3u] = normal.x;
    target_words[6u * index + 4u] = normal.y;
    target_words[6u * index + 5u] = normal.z;
}
