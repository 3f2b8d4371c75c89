//! Values set by pointer.

use super::{every_field, is_one_line};
use serde_json::{Value, json};
use sinew::io::{IoError, apply_sets, scene_from_json};
use sinew::scene::{Scene, TimeStep};

/// A scene that leaves to its defaults what it can.
fn sparse() -> Scene {
    let text = r#"{"version": 1, "bodies": [{"id": "cube", "shape": {"box": {"size": [0.2, 0.2, 0.2]}},
        "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.05}}]}"#;
    scene_from_json(text).expect("valid")
}

fn set(scene: &Scene, pointer: &str, text: &str) -> Result<Value, IoError> {
    apply_sets(scene, [(pointer, text)]).map(|scene| serde_json::to_value(scene).expect("serialises"))
}

#[test]
fn values_are_replaced_and_defaults_filled_in() {
    for (pointer, text) in [
        ("/bodies/0/material/young_modulus", "2e5"),
        ("/time/duration", "0.25"),
        ("/time/step/automatic/safety", "0.5"),
        ("/gravity/1", "-1.62"),
        ("/gravity", "[0.0, 0.0, 0.0]"),
        ("/room/floor", "-0.5"),
        ("/bodies/0/material/poisson_ratio", "0.0"),
        ("/bodies/0/placement/rotation/degrees", "45.0"),
        ("/bodies/0/integrator", "\"rk4\""),
        ("/description", "\"a / b ~ c\""),
    ] {
        let value = set(&sparse(), pointer, text).expect(pointer);
        assert_eq!(value.pointer(pointer), Some(&serde_json::from_str(text).expect("JSON")), "{pointer}");
    }
    // Several, in order; the scene itself is as it was.
    let scene = apply_sets(&sparse(), [("/time/duration", "3"), ("/time/duration", "4")]).expect("set");
    assert_eq!((scene.time.duration, sparse().time.duration), (4.0, 1.0));
}

#[test]
fn members_and_items_are_added_where_a_scene_may_have_them() {
    let region = r#"{"id": "all", "select": "everything"}"#;
    let value = set(&sparse(), "/bodies/0/regions", &format!("[{region}]")).expect("set");
    assert_eq!(value["bodies"][0]["regions"][0]["id"], "all");
    let value = set(&sparse(), "/bodies/0/regions/-", region).expect("set");
    assert_eq!(value["bodies"][0]["regions"].as_array().map(Vec::len), Some(1));
    let value = set(&every_field(), "/bodies/0/regions/-", r#"{"id": "new", "select": "everything"}"#).expect("set");
    assert_eq!(value["bodies"][0]["regions"][4]["id"], "new");
}

#[test]
fn another_alternative_replaces_the_one_before() {
    let manual = r#"{"dt": 1e-5, "substeps_per_frame": 10}"#;
    let scene = apply_sets(&sparse(), [("/time/step/manual", manual)]).expect("set");
    assert!(matches!(scene.time.step, TimeStep::Manual(_)));
    // From a name to an object as well.
    let turn = r#"{"axis": [0, 1, 0], "degrees": 10, "duration": 1}"#;
    let value = set(&every_field(), "/bodies/0/pins/0/motion/turn", turn).expect("set");
    assert_eq!(value["bodies"][0]["pins"][0]["motion"]["turn"]["degrees"], json!(10.0));
}

#[test]
fn pointers_into_nothing_and_misspelt_ones_are_refused() {
    for (pointer, text, words) in [
        (
            "/bodies/0/material/youngs_modulus",
            "2e5",
            ["no member of /bodies/0/material", "did you mean \"young_modulus\"?"],
        ),
        (
            "/bodies/0/material/colour",
            "\"red\"",
            ["\"colour\" is no member", "it has damping, fibre_embedding, mass, plasticity"],
        ),
        ("/duration", "1", ["no member of the scene", "it has bodies, colliders, description"]),
        ("/bodies/7/name", "\"x\"", ["leads to no item of /bodies, which has 1", "from 0 to 0"]),
        ("/panels/0/mass", "1", ["leads to no item of /panels, which has 0", "/panels/- first"]),
        ("/bodies/00/name", "\"x\"", ["leads to no item of /bodies", "index"]),
        ("/bodies/x/name", "\"x\"", ["leads to no item of /bodies", "index"]),
        ("/nowhere/at/all", "1", ["no member of the scene", "panels"]),
        (
            "/time/step/manual/dt",
            "1e-4",
            ["not what /time/step holds, which is automatic", "set /time/step/manual as a whole"],
        ),
        ("/time/duration/seconds", "1", ["leads into /time/duration, which is 1.0", "set /time/duration itself"]),
        ("bodies/0/name", "\"x\"", ["is not a pointer", "write /bodies/0/name"]),
        ("/name", "hello", ["\"hello\" is not JSON", "double quotes"]),
        ("/name", "", ["is not JSON", "double quotes"]),
        ("/room", r#"{"flor": 0}"#, ["/room/flor", "did you mean \"floor\"?"]),
        ("/bodies/-", r#"{"id": "x", "wrong": 1}"#, ["/bodies/1/wrong", "is no member of /bodies/1"]),
    ] {
        let error = set(&sparse(), pointer, text).expect_err(pointer);
        let message = error.to_string();
        assert!(matches!(error, IoError::Pointer(_)) && is_one_line(&message), "{message}");
        for word in words {
            assert!(message.contains(word), "{word} is missing in: {message}");
        }
    }
}

#[test]
fn a_field_of_a_newer_program_cannot_be_set() {
    let scene = scene_from_json(r#"{"version": 1, "new": {"deep": 1}}"#).expect("valid");
    for pointer in ["/new", "/new/deep", "/new/other"] {
        assert!(matches!(set(&scene, pointer, "2"), Err(IoError::Pointer(_))), "{pointer}");
    }
    // It is no obstacle to setting another, and is kept.
    assert_eq!(set(&scene, "/time/duration", "2").expect("set")["new"], json!({"deep": 1}));
}

#[test]
fn what_is_set_is_checked() {
    assert!(
        matches!(set(&sparse(), "/time/duration", "\"long\""), Err(IoError::Type(error)) if error.path == "/time/duration")
    );
    assert!(
        matches!(set(&sparse(), "/time/duration", "-1"), Err(IoError::Invalid(error)) if error.path == "/time/duration")
    );
    assert!(matches!(set(&sparse(), "/version", "7"), Err(IoError::Version(_))));
    assert!(matches!(set(&sparse(), "", "{\"version\": 7}"), Err(IoError::Version(_))));
    assert!(matches!(set(&sparse(), "/time/duration", "1e999"), Err(IoError::Pointer(_))));
}
