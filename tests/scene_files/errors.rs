//! Every class of bad input: its path, its value, what is wrong and what to do.

use super::{EVERY_FIELD, every_field, is_one_line};
use serde_json::{Value, json};
use sinew::io::{IoError, scene_from_json};
use sinew::scene::{FibreSource, Scene, SceneError};

/// What a scene is refused with after one of its values was replaced; `None` where it is accepted.
fn refusal(pointer: &str, value: &Value) -> Option<IoError> {
    let mut scene: Value = serde_json::from_str(EVERY_FIELD).expect("JSON");
    *scene.pointer_mut(pointer).expect(pointer) = value.clone();
    let error = scene_from_json(&scene.to_string()).err();
    if let Some(error) = &error {
        assert!(is_one_line(&error.to_string()), "{error}");
    }
    error
}

/// Replaces the value at a pointer and expects the error to name that place, that value and these words.
fn refused(pointer: &str, value: &Value, words: &[&str]) {
    refused_at(pointer, value, pointer, words);
}

fn refused_at(pointer: &str, value: &Value, path: &str, words: &[&str]) {
    let error = refusal(pointer, value).unwrap_or_else(|| panic!("{pointer} = {value} is accepted"));
    let message = error.to_string();
    let (IoError::Invalid(found) | IoError::Type(found) | IoError::Version(found)) = error else {
        panic!("{pointer} = {value}: {message}");
    };
    assert_eq!(found.path, path, "{message}");
    assert!(!found.problem.is_empty() && !found.remedy.is_empty(), "{message}");
    assert!(message.contains(&found.value), "{message}");
    for word in words {
        assert!(message.contains(word), "{word} is missing in: {message}");
    }
}

#[test]
#[allow(clippy::too_many_lines, reason = "one row for each field")]
fn numbers_out_of_range_are_refused() {
    for (pointer, value, words) in [
        ("/gravity/1", json!(1e16), ["1e16", "-1e15 to 1e15 m/s²"]),
        ("/room/floor", json!(-1e300), ["-1e300", "m"]),
        ("/room/ceiling", json!(-2), ["leaves no room", "above floor (0 m)"]),
        ("/room/x_max", json!(-1), ["leaves no room", "above x_min (-1 m)"]),
        ("/room/z_max", json!(-5), ["leaves no room", "above z_min (-1.5 m)"]),
        ("/room/friction", json!(-0.1), ["-0.1", "from 0"]),
        ("/room/contact_damping", json!(1.5), ["1.5", "from 0 to 1"]),
        ("/panels/0/height", json!(1e20), ["1e20", "m"]),
        ("/panels/0/size/1", json!(0), ["is not above zero", "above 0 m"]),
        ("/panels/0/mass", json!(0), ["is not above zero", "above 0 kg"]),
        ("/panels/0/friction", json!(-1), ["-1", "from 0"]),
        ("/panels/1/motion/driven", json!([]), ["[]", "one key at least"]),
        ("/panels/1/motion/driven/1/time", json!(0), ["order of time", "above 0 s"]),
        ("/panels/1/motion/driven/0/time", json!(-1), ["-1", "from 0"]),
        ("/time/frames_per_second", json!(0), ["is not above zero", "frames a second"]),
        ("/time/frames_per_second", json!(1e6), ["1000000", "100000 frames a second"]),
        ("/time/duration", json!(-1), ["-1", "from 0 to 1000000 s"]),
        ("/time/step/manual/dt", json!(0), ["is not above zero", "above 0 s"]),
        ("/time/step/manual/dt", json!(1e-300), ["1e-300", "from 1e-15"]),
        ("/time/step/manual/substeps_per_frame", json!(0), ["takes no step", "1 or more"]),
        ("/bodies/0/shape/box/size/2", json!(-0.1), ["is not above zero", "above 0 m"]),
        ("/bodies/0/shape/box/lattice_rotation/axis", json!([0, 0, 0]), ["points nowhere", "any length but zero"]),
        ("/bodies/0/placement/rotation/axis", json!([1e-200, 0, 0]), ["points nowhere", "any length but zero"]),
        ("/bodies/0/material/young_modulus", json!(-5), ["is not above zero", "above 0 Pa"]),
        ("/bodies/0/material/poisson_ratio", json!(0.5), ["0.5", "0 to 0.49"]),
        ("/bodies/0/material/poisson_ratio", json!(-0.1), ["-0.1", "0 to 0.49"]),
        ("/bodies/0/material/mass/density", json!(0), ["is not above zero", "kg/m³"]),
        ("/bodies/1/material/mass/per_particle", json!(0), ["is not above zero", "above 0 kg"]),
        ("/bodies/0/material/support_radius", json!(0), ["is not above zero", "above 0 m"]),
        ("/bodies/0/material/spacing_ratio", json!(0.25), ["0.25", "0.3 to 0.6"]),
        ("/bodies/0/material/spacing_ratio", json!(0.7), ["0.7", "0.3 to 0.6"]),
        ("/bodies/0/material/damping/pair", json!(-1), ["-1", "1/s"]),
        ("/bodies/0/material/damping/air", json!(-1), ["-1", "1/s"]),
        ("/bodies/0/initial/velocity/0", json!(1e16), ["1e16", "m/s"]),
        ("/bodies/0/impulses/0/impulse/2", json!(1e16), ["1e16", "N s"]),
        ("/bodies/0/fibres/0/stiffness/paper/kb", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/fibres/0/stiffness/paper/ks", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/fibres/1/stiffness/rigidity/ea", json!(-1), ["-1", "N"]),
        ("/bodies/0/fibres/1/stiffness/rigidity/ei", json!(-1), ["-1", "N m²"]),
        ("/two_layer/0/ks", json!(-1), ["is not above zero", "above 0 N/m"]),
        ("/two_layer/0/ks", json!(0), ["is not above zero", "above 0 N/m"]),
        ("/two_layer/0/kd", json!(-1), ["-1", "N s/m"]),
        ("/two_layer/0/rks", json!(-1), ["-1", "N/m"]),
        ("/two_layer/0/rkd", json!(-1), ["-1", "N s/m"]),
        ("/two_layer/0/mks", json!(-1), ["-1", "N/m"]),
        ("/two_layer/0/mkd", json!(-1), ["-1", "N s/m"]),
        ("/two_layer/0/pressure", json!(-1), ["-1", "J"]),
        ("/two_layer/0/mass", json!(0), ["is not above zero", "kg"]),
        ("/two_layer/0/inner_mass", json!(0), ["is not above zero", "kg"]),
        ("/two_layer/0/masses/0/mass", json!(0), ["is not above zero", "kg"]),
        ("/two_layer/0/air_drag", json!(-1), ["-1", "1/s"]),
        ("/two_layer/0/contact/kc", json!(0), ["is not above zero", "N/m"]),
        ("/two_layer/0/contact/cc", json!(-1), ["-1", "N s/m"]),
        ("/two_layer/0/contact/ct", json!(-1), ["-1", "N s/m"]),
        ("/two_layer/0/shape/ball/subdivisions", json!(6), ["too many", "0 to 5"]),
        ("/two_layer/0/shape/ball/outer_radius", json!(1), ["leaves no room", "inner_radius (1 m)"]),
        ("/two_layer/0/initial/deformation", json!([[1, 0, 0], [0, -1, 0], [0, 0, 1]]), ["inside out", "determinant"]),
        ("/two_layer/0/drags/0/target/1", json!(1e16), ["1e16", "m"]),
        ("/two_layer/1/shape/ring/sides", json!(2), ["no polygon", "3 to"]),
        ("/two_layer/2/shape/segment/length", json!(0), ["is not above zero", "m"]),
        ("/two_layer/3/shape/mesh/path", json!(" "), ["names no file", "relative to the scene"]),
        ("/two_layer/3/shape/mesh/scale", json!(0), ["is not above zero", "m"]),
        ("/two_layer/3/shape/mesh/inner_offset/metres", json!(0), ["is not above zero", "m"]),
        ("/two_layer/4/shape/mesh/inner_offset/fraction", json!(-1), ["is not above zero", "half the least extent"]),
        ("/two_layer/4/shape/mesh/inner_offset/fraction", json!(1), ["leaves no room", "below 1"]),
        ("/two_layer/2/id", json!("bar"), ["is taken by another body", "name of its own"]),
        ("/two_layer/0/pins/0/region", json!("lid"), ["is no region", "water"]),
        ("/bodies/0/fibres/0/volume_fraction", json!(1.1), ["1.1", "0 to 1"]),
        ("/bodies/0/paint/0/center/1", json!(1e16), ["1e16", "m"]),
        ("/bodies/0/paint/0/radius", json!(0), ["is not above zero", "above 0 m"]),
        ("/bodies/0/paint/0/value", json!(1.5), ["1.5", "0 to 1"]),
        ("/bodies/0/paint/1/strength", json!(-0.5), ["-0.5", "0 to 1"]),
        ("/bodies/0/voids/0/shape/sphere/radius", json!(0), ["is not above zero", "above 0 m"]),
        ("/bodies/0/voids/1/shape/box/max/1", json!(0.2), ["leaves no room", "the least corner's 0.2 m"]),
        ("/bodies/0/voids/2/shape/tube/radius", json!(-1), ["is not above zero", "above 0 m"]),
        ("/bodies/0/voids/3/shape/mesh/path", json!(""), ["names no file", "relative to the scene"]),
        ("/bodies/0/voids/3/id", json!("hole"), ["is taken by another void", "name of its own"]),
        ("/bodies/0/elements/0/law/table/2/0", json!(1), ["after the point before it", "above 1"]),
        ("/bodies/0/elements/0/law/table/1/1", json!(1e16), ["1e16", "N"]),
        ("/bodies/0/elements/0/law/table", json!([[1, 0]]), ["has 1 points", "2 to 1000"]),
        ("/bodies/0/elements/0/points", json!([[0, 0.1, 0]]), ["has 1 points, and length is of 2", "give 2 points"]),
        ("/bodies/0/elements/0/points/1/1", json!(1e16), ["1e16", "m"]),
        ("/bodies/0/elements/0/activation/contract", json!(0.9), ["makes the element smaller", "-0.5 to 0.8"]),
        ("/bodies/0/elements/1/activation/turn_degrees", json!(400), ["is to turn by 200 degrees", "-170 to 170"]),
        ("/bodies/2/sheets/0/seam/stretch", json!(1), ["1", "from 1.001 to 10"]),
        ("/bodies/0/elements/1/law/spring/stiffness", json!(-1), ["-1", "N m"]),
        ("/bodies/0/elements/2/law/tension_only/stiffness", json!(-1), ["-1", "N/m"]),
        ("/bodies/0/elements/3/law/muscle/width", json!(0), ["is not above zero", "above 0"]),
        ("/bodies/0/elements/3/law/muscle/force", json!(-1), ["-1", "Pa"]),
        ("/bodies/0/elements/5/id", json!("rope"), ["is taken by another element", "name of its own"]),
        ("/bodies/0/region_materials/0/young_modulus", json!(0), ["is not above zero", "Pa"]),
        ("/bodies/0/region_materials/0/transition", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/material/viscosity/shear", json!(-1), ["-1", "Pa s"]),
        ("/bodies/0/material/plasticity/yield_stress", json!(0), ["is not above zero", "above 0 Pa"]),
        ("/bodies/0/fibres/2/yield/curvature_degrees_per_metre", json!(0), ["is not above zero", "degrees/m"]),
        ("/bodies/0/regions/1/select/layers/count", json!(0), ["0 is no number of layers", "1 to 2000000"]),
        ("/bodies/0/regions/1/select/layers/count", json!(u32::MAX), ["4294967295", "1 to 2000000"]),
        ("/bodies/0/regions/2/select/box/max/1", json!(0.3), ["below the least corner", "0.35 m or more"]),
        ("/bodies/0/regions/3/select/sphere/radius", json!(0), ["is not above zero", "above 0 m"]),
        ("/bodies/0/pins/1/motion/ramp/direction", json!([0, 0, 0]), ["points nowhere", "any length but zero"]),
        ("/bodies/0/pins/1/motion/ramp/duration", json!(0), ["is not above zero", "above 0 s"]),
        ("/bodies/0/pins/1/motion/ramp/start", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/pins/3/motion/turn/axis", json!([0, 0, 0]), ["points nowhere", "any length but zero"]),
        ("/bodies/0/pins/3/motion/turn/duration", json!(-1), ["is not above zero", "above 0 s"]),
        ("/bodies/0/follows/0/leader/skeleton/path", json!(" "), ["names no file", "with a skin"]),
        ("/bodies/0/follows/0/leader/skeleton/scale", json!(0), ["is not above zero", "above 0 m"]),
        ("/bodies/0/follows/0/leader/skeleton/joints/1", json!("Hips"), ["is taken by another joint", "of its own"]),
        ("/bodies/0/follows/0/start", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/follows/0/pre_roll", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/follows/0/from", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/follows/0/speed", json!(0), ["is not above zero", "above 0"]),
        ("/bodies/0/follows/0/select/skin_weight", json!(1.5), ["1.5", "from 0 to 1"]),
        ("/bodies/0/follows/1/select/distance", json!(0), ["is not above zero", "above 0 m"]),
        ("/bodies/0/follows/1/id", json!("bones"), ["is taken by another motion", "of its own"]),
        ("/bodies/0/follows/2/leader/cache/path", json!(""), ["names no file", "PC2 or MDD"]),
        ("/bodies/0/follows/2/leader/cache/rest", json!(""), ["names no file", "leave this out"]),
        ("/bodies/0/follows/2/leader/cache/frames_per_second", json!(0), ["is not above zero", "above 0 1/s"]),
        ("/bodies/0/follows/2/hold/springs/stiffness", json!(0), ["is not above zero", "to the kilogram"]),
        ("/bodies/0/follows/2/hold/springs/damping", json!(-1), ["-1", "from 0"]),
        ("/bodies/0/follows/2/paint/0/value", json!(2), ["2", "from 0 to 1"]),
        ("/bodies/0/follows/3/select/region", json!("tail"), ["is no region", "core"]),
        ("/bodies/0/pins/4/motion/keyframes", json!([]), ["[]", "one key at least"]),
        ("/bodies/0/pins/4/motion/keyframes/2/time", json!(0.5), ["order of time", "above 0.5 s"]),
        ("/measures/3/kind/twist/axis", json!([0, 0, 0]), ["points nowhere", "any length but zero"]),
        ("/measures/5/kind/reaction_force/along", json!([0, 0, 0]), ["points nowhere", "any length but zero"]),
    ] {
        refused(pointer, &value, &words);
    }
    refused("/bodies/0/initial/deformation", &json!([[1, 0, 0], [0, 1, 0], [0, 0, -1]]), &["inside out"]);
    refused("/bodies/0/initial/deformation", &json!([[1, 0, 0], [2, 0, 0], [0, 0, 1]]), &["flattens"]);
    refused("/bodies/0/fibres/1/source/vertices", &json!([[0, 0, 0], [0, 1, 0]]), &["to bend", "3 or more"]);
    refused("/bodies/0/fibres/0/source/strokes/first/points", &json!([[0, 0]]), &["no line", "2 points"]);
    refused("/bodies/0/fibres/0/source/strokes/second/view", &json!("front"), &["another view than \"front\""]);
    refused("/bodies/0/pins/1/axes", &json!([]), &["along no axis"]);
    let (act, share) = ("/bodies/0/elements/0/activation", json!({"drive": {"constant": 1}, "turn_degrees": 9}));
    refused_at(act, &share, &format!("{act}/turn_degrees"), &["which is no angle", "give `contract`"]);
    let (act, angle) = ("/bodies/0/elements/1/activation", json!({"drive": {"constant": 1}, "contract": 0.1}));
    refused_at(act, &angle, &format!("{act}/contract"), &["which is an angle", "give `turn_degrees`"]);
    let bend = json!([{"id": "bend", "measure": "turn", "points": [[0, 0, 0], [0.01, 0, 0], [0.02, 0, 0]],
        "law": {"spring": {"stiffness": 1}}, "activation": {"drive": {"constant": 1}, "turn_degrees": 20}}]);
    let place = "/bodies/0/elements/0/activation/turn_degrees";
    refused_at("/bodies/0/elements", &bend, place, &["turns a bend of 0 degrees", "dihedral"]);
    let flat = json!([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]);
    refused("/bodies/0/elements/3/points", &flat, &["leave nothing to measure", "move them apart"]);
    let weight = "/bodies/0/follows/2/select/skin_weight";
    refused_at("/bodies/0/follows/2/select", &json!({"skin_weight": 0.5}), weight, &["a cache has none"]);
    refused_at("/bodies/0/follows/2/paint", &json!([]), "/bodies/0/follows/2/select", &["nothing is", "dabs"]);
    let mut seamed = every_field();
    seamed.bodies[0].sheets[1].seam = seamed.bodies[2].sheets[0].seam.clone();
    let message = seamed.validate().expect_err("it yields").to_string();
    assert!(message.starts_with("/bodies/0/sheets/1/seam") && message.contains("flows or yields"), "{message}");
    let mut scene = every_field();
    let dab = scene.bodies[0].paint[0].clone();
    scene.bodies[0].paint = vec![dab; 10_001];
    let message = scene.validate().expect_err("too many").to_string();
    assert_eq!(message, "/bodies/0/paint: [] has 10001 dabs; give at most 10000, with larger radii");
}

#[test]
fn bounds_are_in_range() {
    for (pointer, value) in [
        ("/time/duration", json!(0)),
        ("/time/step", json!({"automatic": {"safety": 1}})),
        ("/room/contact_damping", json!(1)),
        ("/bodies/0/material/poisson_ratio", json!(0.49)),
        ("/bodies/0/material/poisson_ratio", json!(0)),
        ("/bodies/0/material/spacing_ratio", json!(0.3)),
        ("/bodies/0/material/spacing_ratio", json!(0.6)),
        ("/bodies/0/fibres/0/volume_fraction", json!(0)),
        ("/bodies/0/fibres/0/volume_fraction", json!(1)),
        ("/bodies/0/fibres/1/stiffness/rigidity/ei", json!(0)),
        ("/bodies/0/regions/2/select/box/max/1", json!(0.35)),
        ("/room/floor", json!(null)),
    ] {
        let refusal = refusal(pointer, &value);
        assert!(refusal.is_none(), "{refusal:?}");
    }
}

#[test]
fn safety_is_a_share_above_zero() {
    let path = "/time/step/automatic/safety";
    for (safety, words) in [(0.0, "above 0"), (-1.0, "above 0"), (1.1, "from 0 to 1")] {
        refused_at("/time/step", &json!({"automatic": {"safety": safety}}), path, &[words]);
    }
}

#[test]
fn names_are_given_and_unique() {
    for pointer in ["/panels/1/id", "/bodies/1/id", "/bodies/0/regions/1/id", "/bodies/0/fibres/1/id"] {
        refused(pointer, &json!(""), &["names nothing"]);
    }
    refused("/measures/1/name", &json!("  "), &["names nothing"]);
    refused("/panels/1/id", &json!("lid"), &["\"lid\" is taken by another panel"]);
    refused("/bodies/1/id", &json!("bar"), &["\"bar\" is taken by another body"]);
    refused("/bodies/0/regions/1/id", &json!("all"), &["\"all\" is taken by another region"]);
    refused("/bodies/0/fibres/1/id", &json!("left"), &["\"left\" is taken by another fibre"]);
    refused("/bodies/0/pins/1/id", &json!("hold"), &["\"hold\" is taken by another pin"]);
    refused("/measures/1/name", &json!("drift"), &["\"drift\" is taken by another measure"]);
}

#[test]
fn references_lead_somewhere() {
    let words = ["\"nowhere\" is no region", "use one of \"all\", \"bottom\", \"core\", \"top\""];
    for pointer in [
        "/bodies/0/impulses/0/region",
        "/bodies/0/pins/0/region",
        "/bodies/0/region_materials/0/region",
        "/measures/0/kind/mean_displacement/region",
        "/measures/1/kind/tip_displacement/region",
        "/measures/2/kind/height_loss/against",
        "/measures/3/kind/twist/region",
        "/measures/4/kind/shear/against",
        "/measures/5/kind/reaction_force/region",
        "/measures/6/kind/reaction_torque/region",
    ] {
        refused(pointer, &json!("nowhere"), &words);
    }
    refused("/measures/0/body", &json!("nobody"), &["\"nobody\" is no body", "\"bar\", \"cube\""]);
    refused_at("/measures/0/body", &json!("cube"), "/measures/0/kind/mean_displacement/region", &["add a region"]);
    refused("/measures/4/kind/shear/against", &json!("top"), &["the measured region itself"]);
}

#[test]
fn too_many_particles_are_said_with_their_memory() {
    let path = "/bodies/1/material/support_radius";
    refused(path, &json!(0.003), &["0.003", "4.7 million particles", "11.7 GB", "2 million", "give 4.02e-3 m or more"]);
    assert!(refusal(path, &json!(0.00401)).is_none());
    // What is suggested holds for a body that shares the budget with another.
    refused_at(
        "/bodies/0/shape/box/size",
        &json!([50, 50, 50]),
        "/bodies/0/material/support_radius",
        &["GB of memory"],
    );
    refused_at(
        "/bodies/0/shape/box/size",
        &json!([1e15, 1e15, 1e15]),
        "/bodies/0/material/support_radius",
        &["2.3e44 million"],
    );
}

#[test]
fn wrong_types_are_said_with_their_place() {
    for (pointer, value, words) in [
        ("/gravity", json!("down"), ["expected an array", "Gravitational acceleration [m/s²]"]),
        ("/gravity", json!([0, 1]), ["array of length 3", "Gravitational acceleration"]),
        ("/bodies/0/material/young_modulus", json!("soft"), ["expected a number", "Young's modulus E [Pa]"]),
        ("/bodies/0/material/young_modulus", json!(null), ["null has the wrong type", "expected a number"]),
        ("/bodies/0/regions/1/select/layers/count", json!(1.5), ["1.5 has", "a whole number"]),
        ("/bodies/0/regions/1/select/layers/count", json!(-1), ["-1 has", "a whole number"]),
        ("/bodies/0/hidden", json!("yes"), ["expected a boolean", "left out of what is seen"]),
        ("/bodies/0/paint/0", json!([0, 0, 0, 1]), ["expected an object (Dab)", "One dab of a brush"]),
        ("/bodies/0/fibres/0/color/1", json!(256), ["256 has", "a whole number from 0 to 255"]),
        ("/two_layer/0/color", json!([1, 2]), ["array of length 3", "Colour in which it is drawn"]),
        ("/bodies/0/integrator", json!("velvet"), ["\"velvet\" is unknown here", "`leap_frog`"]),
        ("/bodies/0/shape", json!({"pyramid": {}}), ["is unknown here", "`box`"]),
        ("/bodies/0/material/mass", json!({"density": 1, "per_particle": 1}), ["a single member", "Density or mass"]),
        ("/bodies/0/material", json!([]), ["expected an object (Material)", "What it is made of"]),
        ("/bodies", json!({}), ["expected an array", "The soft bodies"]),
        ("/units", json!("cgs"), ["\"cgs\" is unknown here", "`SI`"]),
        ("/time/step", json!("manual"), ["with this name as its only member", "How the time step is chosen"]),
    ] {
        refused(pointer, &value, &words);
    }
    refused_at(
        "/bodies/0/fibres/1/source/vertices/1/2",
        &json!(true),
        "/bodies/0/fibres/1/source/vertices/1/2",
        &["true has the wrong type"],
    );
    refused("/name", &json!(["line\nbreak"]), &["Name a person reads"]);
    refused("/bodies/0/integrator", &json!("line\nbreak"), &["\\n"]);
}

#[test]
fn missing_members_are_named_and_misspelt_ones_found() {
    refused("/bodies/1", &json!({"id": "cube"}), &["lacks the member \"shape\"", "add it: Rest shape"]);
    let misspelt = json!({"youngs_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.05});
    refused("/bodies/1/material", &misspelt, &["\"young_modulus\"", "is \"youngs_modulus\" a misspelling of it?"]);
}

#[test]
fn other_versions_are_refused_before_anything_else() {
    let newer = json!({"version": 7, "bodies": "of a newer program"});
    let error = scene_from_json(&newer.to_string()).expect_err("too new");
    let message = "/version: 7 is newer than this program reads (1); use a newer sinew for this scene";
    assert_eq!(error.to_string(), message);
    for (scene, words) in [
        (json!({}), "has no version; add \"version\": 1"),
        (json!({"version": 0}), "/version: 0 is no version of the format; give \"version\": 1"),
        (json!({"version": "1"}), "/version: \"1\" is no version"),
        (json!({"version": 1.5}), "/version: 1.5 is no version"),
        (json!([1]), "the scene: [1] is not an object"),
    ] {
        let error = scene_from_json(&scene.to_string()).expect_err("no version");
        assert!(matches!(error, IoError::Version(_)), "{error:?}");
        assert!(error.to_string().contains(words), "{error}");
    }
}

#[test]
fn text_that_is_no_json_is_located() {
    for (text, line, column, path, words) in [
        ("", 1, 0, "", "EOF"),
        ("{", 1, 1, "", "EOF"),
        ("{\"version\": 1,\n \"gravity\": [0, 1e999, 0]}", 2, 21, "/gravity/1", "number out of range near `1e999`"),
        ("{\"version\": 1,\n \"gravity\": [0, NaN, 0]}", 2, 17, "/gravity/1", "near `NaN`"),
        ("{\"version\": 1}\n}", 2, 1, "", "trailing characters"),
        ("{\"version\": 1, \"name\": \"a\", \"name\": \"b\"}", 1, 40, "", "\"name\" is there twice"),
        ("{\"version\": 1, \"name\": 'x'}", 1, 24, "/name", "near `'x'`"),
    ] {
        let error = scene_from_json(text).expect_err(text);
        let message = error.to_string();
        assert!(is_one_line(&message) && message.contains(words), "{message}");
        let IoError::Syntax { line: at_line, column: at_column, path: at, .. } = error else { panic!("{message}") };
        assert_eq!((at_line, at.as_str()), (line, path), "{message}");
        assert!(at_column.abs_diff(column) <= 1, "{message}");
    }
    let deep = format!("{{\"version\": 1, \"deep\": {}{}}}", "[".repeat(100_000), "]".repeat(100_000));
    let message = scene_from_json(&deep).expect_err("too deep").to_string();
    assert!(message.contains("recursion limit") && message.len() < 1000 && is_one_line(&message), "{message}");
}

#[test]
fn a_byte_order_mark_is_passed_over() {
    assert_eq!(scene_from_json(&format!("\u{feff}{EVERY_FIELD}")).expect("valid"), every_field());
}

/// Numbers that JSON cannot hold but a program can.
#[test]
fn numbers_that_are_none_are_refused() {
    let mut scene = Scene { gravity: [0.0, f64::NAN, 0.0], ..Scene::default() };
    let message = scene.validate().expect_err("NaN").to_string();
    assert!(message.starts_with("/gravity/1: NaN is out of range"), "{message}");
    scene.gravity[1] = f64::NEG_INFINITY;
    assert!(scene.validate().expect_err("infinite").to_string().starts_with("/gravity/1: -inf is"));

    let mut scene = every_field();
    scene.bodies[0].material.young_modulus = f64::NAN;
    let SceneError { path, value, .. } = scene.validate().expect_err("NaN");
    assert_eq!((path.as_str(), value.as_str()), ("/bodies/0/material/young_modulus", "NaN"));

    let mut scene = every_field();
    if let FibreSource::Vertices(vertices) = &mut scene.bodies[0].fibres[1].source {
        vertices[2][1] = f64::INFINITY;
    }
    assert_eq!(scene.validate().expect_err("infinite").path, "/bodies/0/fibres/1/source/vertices/2/1");

    let scene = Scene { version: 2, ..Scene::default() };
    assert_eq!(scene.validate().expect_err("newer").to_string(), "/version: 2 is not a known version; give 1");
}
