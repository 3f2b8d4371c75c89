//! The published schema against real scenes.

use super::{EVERY_FIELD, every_field};
use serde_json::{Value, json};
use sinew::io::{scene_schema, scene_to_json};
use sinew::scene::Scene;

fn is_valid(scene: &Value) -> bool {
    jsonschema::validator_for(scene_schema()).expect("the schema is sound").is_valid(scene)
}

fn value(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn schema_accepts_valid_scenes() {
    assert!(jsonschema::meta::is_valid(scene_schema()));
    assert!(is_valid(&value(EVERY_FIELD)));
    assert!(is_valid(&value(&scene_to_json(&every_field()))));
    assert!(is_valid(&value(&scene_to_json(&Scene::default()))));
    assert!(is_valid(&json!({"version": 1, "of_a_newer_program": {"x": 1}})));
}

#[test]
fn schema_refuses_wrong_types() {
    for (pointer, wrong) in [
        ("/version", json!("1")),
        ("/units", json!("cgs")),
        ("/gravity", json!([0.0, 1.0])),
        ("/room/floor", json!("low")),
        ("/time/step", json!("fast")),
        ("/time/step/manual/substeps_per_frame", json!(-1)),
        ("/bodies", json!({})),
        ("/bodies/0/shape", json!({"pyramid": {"height": 1.0}})),
        ("/bodies/0/material/young_modulus", json!("soft")),
        ("/bodies/0/material/mass", json!({"density": 1.0, "per_particle": 1.0})),
        ("/bodies/0/hidden", json!(1)),
        ("/bodies/0/paint/0/radius", json!("wide")),
        ("/bodies/0/drives/0/drive", json!({"constant": 1, "wave": {"period": 1}})),
        ("/bodies/0/fibres/0/activation/contract", json!("much")),
        ("/bodies/0/sheets/0/stiffness/et", json!("thick")),
        ("/bodies/0/sheets/0/stiffness/grain/along", json!("third")),
        ("/bodies/0/sheets/0/activation/contract", json!([0.1])),
        ("/bodies/0/sheets/1/source/grid/0/0", json!([1.0, 2.0])),
        ("/bodies/0/sheets/2/source/triangles/triangles/0", json!([0, 1])),
        ("/bodies/0/fibres/0/color", json!([0, 128, 256])),
        ("/two_layer/0/color", json!("red")),
        ("/bodies/0/integrator", json!("symplectic")),
        ("/bodies/0/fibres/0/source/strokes/first/view", json!("back")),
        ("/bodies/0/fibres/1/source/vertices/0", json!([1.0, 2.0])),
        ("/bodies/0/regions/1/select/layers/count", json!(1.5)),
        ("/two_layer/3/shape/mesh/inner_offset", json!({"metres": 1.0, "fraction": 0.5})),
        ("/two_layer/3/shape/mesh/up", json!("w")),
        ("/measures/0/kind", json!({"colour": {"region": "top"}})),
    ] {
        let mut scene = value(EVERY_FIELD);
        *scene.pointer_mut(pointer).expect(pointer) = wrong;
        assert!(!is_valid(&scene), "{pointer}");
    }
}

#[test]
fn schema_requires_what_has_no_default() {
    for (parent, member) in [
        ("", "version"),
        ("/bodies/0", "id"),
        ("/bodies/0", "shape"),
        ("/bodies/0/material", "support_radius"),
        ("/bodies/0/paint/0", "value"),
        ("/bodies/0/pins/1/motion/ramp", "duration"),
        ("/panels/0", "motion"),
        ("/two_layer/3/shape/mesh", "path"),
    ] {
        let mut scene = value(EVERY_FIELD);
        let parent = scene.pointer_mut(parent).and_then(Value::as_object_mut).expect(parent);
        parent.remove(member);
        assert!(!is_valid(&scene), "{member}");
    }
}
