//! Scenes built by calls: they are what files with the same content are, and bodies of both kinds stand in one row.

use crate::every_field;
use sinew::io::scene_from_json;
use sinew::scene::{
    AnyBody, AnyBodyMut, Axis, Body, Dab, Distance, Fibre, Grab, Impulse, IntegratorKind, Keyframe, Material, Measure,
    MeasureKind, MeshShape, Motion, Panel, PaperStiffness, Pin, Ramp, Region, RegionMass, RestShape, Rotation, Scene,
    Selector, Side, StrokePair, TimeStep, Turn, TwoLayer, ViewStroke,
};
use sinew::sketch::View;

/// Every default of a file is that of the call, and what a call is given is where the file has it.
#[test]
#[allow(clippy::too_many_lines, reason = "a line a field")]
fn what_calls_build_is_what_a_file_says() {
    let file = r#"{
        "version": 1,
        "name": "Built",
        "gravity": [0, -1, 0],
        "room": {"floor": 0.5},
        "time": {"frames_per_second": 30, "step": {"manual": {"dt": 0.001, "substeps_per_frame": 4}}},
        "panels": [
            {"id": "lid", "height": 2, "size": [1, 3], "motion": "falls"},
            {"id": "press", "height": 4, "size": [1, 3],
             "motion": {"driven": [{"time": 0, "height": 4}, {"time": 1, "height": 3}]}}
        ],
        "bodies": [
            {
                "id": "box", "name": "Box",
                "shape": {"box": {"size": [0.1, 0.2, 0.3]}},
                "placement": {"translation": [1, 2, 3], "rotation": {"axis": [0, 0, 1], "degrees": 90}},
                "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.015},
                "integrator": "rk4",
                "initial": {"velocity": [0, 0, -1]},
                "impulses": [{"region": "all", "impulse": [1, 0, 0]}],
                "fibres": [
                    {"id": "line", "source": {"vertices": [[0, 0, 0], [0, 0.1, 0], [0, 0.2, 0]]},
                     "stiffness": {"rigidity": {"ea": 140, "ei": 1e-4}}},
                    {"id": "drawn", "name": "Drawn", "volume_fraction": 0.5, "rest_shape": "straight",
                     "source": {"strokes": {"first": {"view": "front", "points": [[0, 0], [0, 1]]},
                                            "second": {"view": "side", "points": [[0, 0], [0.1, 1]]}}},
                     "stiffness": {"paper": {"kb": 5e5, "ks": 2.5e5}}}
                ],
                "paint": [{"center": [0, 0, 0], "radius": 0.01, "value": 1}],
                "regions": [
                    {"id": "all", "select": "everything"},
                    {"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 2}}},
                    {"id": "corner", "select": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}},
                    {"id": "core", "select": {"sphere": {"center": [0, 0, 0], "radius": 0.05}}}
                ],
                "pins": [
                    {"id": "held", "region": "core"},
                    {"id": "pressed", "region": "top", "axes": ["y"], "motion":
                     {"ramp": {"direction": [0, -1, 0], "distance": {"fraction": 0.1}, "duration": 0.5}}},
                    {"id": "turned", "region": "top", "motion":
                     {"turn": {"axis": [0, 1, 0], "origin": [0, 0, 0], "degrees": 30, "duration": 0.5}}},
                    {"id": "led", "region": "corner", "motion":
                     {"keyframes": [{"time": 0, "offset": [0, 0, 0]}, {"time": 1, "offset": [0, 1, 0]}]}}
                ]
            },
            {
                "id": "mesh", "shape": {"mesh": {"path": "a.obj", "scale": 0.001, "up": "z", "particles": 500}},
                "material": {"young_modulus": 2e5, "poisson_ratio": 0.4, "mass": {"per_particle": 4e-4},
                             "support_radius": 0.02, "damping": {"pair": 20, "air": 0.5}}
            }
        ],
        "two_layer": [
            {"id": "segment", "shape": {"segment": {}}},
            {"id": "ring", "shape": {"ring": {}}, "masses": [{"region": "inner", "mass": 2}], "pressure": 40},
            {"id": "ball", "shape": {"ball": {}}, "placement": {"translation": [0, 5, 0]},
             "drags": [{"target": [0, 9, 0]}]},
            {"id": "tube", "shape": {"mesh": {"path": "tube.obj"}}}
        ],
        "measures": [
            {"name": "a", "body": "box", "kind": {"mean_displacement": {"region": "top"}}},
            {"name": "b", "body": "box", "kind": {"tip_displacement": {"region": "top"}}, "over_time": "peak"},
            {"name": "c", "body": "box", "kind": {"height_loss": {"region": "top", "against": "core", "axis": "y"}}},
            {"name": "d", "body": "box", "kind": {"twist": {"region": "top", "against": "core", "axis": [0, 1, 0]}}},
            {"name": "e", "body": "box", "kind": {"shear": {"region": "top", "against": "core"}}},
            {"name": "f", "body": "box", "kind": {"reaction_force": {"region": "core", "along": [0, 1, 0]}}},
            {"name": "g", "body": "box", "kind": {"reaction_torque": {"region": "core", "along": [0, 1, 0]}}},
            {"name": "h", "body": "ring", "kind": {"size": {"axis": "x"}}}
        ]
    }"#;
    let strokes = StrokePair::new(
        ViewStroke::new(View::Front, [[0.0, 0.0], [0.0, 1.0]]),
        ViewStroke::new(View::Side, [[0.0, 0.0], [0.1, 1.0]]),
    );
    let solid = Body::cuboid("box", [0.1, 0.2, 0.3])
        .with_name("Box")
        .with_translation([1.0, 2.0, 3.0])
        .with_rotation(Rotation::about([0.0, 0.0, 1.0], 90.0))
        .with_integrator(IntegratorKind::Rk4)
        .with_velocity([0.0, 0.0, -1.0])
        .with_impulse(Impulse::new("all", [1.0, 0.0, 0.0]))
        .with_fibre(Fibre::through("line", [[0.0; 3], [0.0, 0.1, 0.0], [0.0, 0.2, 0.0]]))
        .with_fibre(
            Fibre::drawn("drawn", strokes)
                .with_name("Drawn")
                .with_stiffness(PaperStiffness::new(5e5, 2.5e5))
                .with_volume_fraction(0.5)
                .with_rest_shape(RestShape::Straight),
        )
        .with_dab(Dab::new([0.0; 3], 0.01, 1.0))
        .with_region(Region::new("all", Selector::Everything))
        .with_region(Region::layers("top", Axis::Y, Side::Max, 2))
        .with_region(Region::in_box("corner", [0.0; 3], [1.0; 3]))
        .with_region(Region::in_sphere("core", [0.0; 3], 0.05))
        .with_pin(Pin::new("held", "core"))
        .with_pin(Pin::new("pressed", "top").with_axes([Axis::Y]).with_motion(Ramp::new(
            [0.0, -1.0, 0.0],
            Distance::Fraction(0.1),
            0.5,
        )))
        .with_pin(Pin::new("turned", "top").with_motion(Turn::new([0.0, 1.0, 0.0], 30.0, 0.5).with_origin([0.0; 3])))
        .with_pin(
            Pin::new("led", "corner").with_motion(Motion::Keyframes(vec![
                Keyframe::new(0.0, [0.0; 3]),
                Keyframe::new(1.0, [0.0, 1.0, 0.0]),
            ])),
        );
    let mesh = Body::from_mesh("mesh", MeshShape::new("a.obj").with_scale(0.001).with_up(Axis::Z).with_particles(500))
        .with_material(
            Material::new(2e5, 0.4, 1.0).with_particle_mass(4e-4).with_support_radius(0.02).with_damping(20.0, 0.5),
        );
    let ring = TwoLayer { masses: vec![RegionMass::new("inner", 2.0)], pressure: 40.0, ..TwoLayer::ring("ring") };
    let measure = |name: &str, kind: MeasureKind| Measure::new(name, "box", kind);
    let up = [0.0, 1.0, 0.0];
    let built = Scene::new("Built")
        .with_gravity([0.0, -1.0, 0.0])
        .with_floor(0.5)
        .with_frame_rate(30.0)
        .with_time_step(TimeStep::manual(0.001, 4))
        .with_panel(Panel::falling("lid", 2.0, [1.0, 3.0]))
        .with_panel(Panel::driven("press", [1.0, 3.0], [(0.0, 4.0), (1.0, 3.0)]))
        .with_body(solid)
        .with_body(mesh)
        .with_two_layer(TwoLayer::segment("segment"))
        .with_two_layer(ring)
        .with_two_layer(TwoLayer::ball("ball").with_translation([0.0, 5.0, 0.0]).with_grab(Grab::to([0.0, 9.0, 0.0])))
        .with_two_layer(TwoLayer::from_mesh("tube", "tube.obj"))
        .with_measure(measure("a", MeasureKind::mean_displacement("top")))
        .with_measure(measure("b", MeasureKind::tip_displacement("top")).at_peak())
        .with_measure(measure("c", MeasureKind::height_loss("top", "core", Axis::Y)))
        .with_measure(measure("d", MeasureKind::twist("top", "core", up)))
        .with_measure(measure("e", MeasureKind::shear("top", "core")))
        .with_measure(measure("f", MeasureKind::reaction_force("core", up)))
        .with_measure(measure("g", MeasureKind::reaction_torque("core", up)))
        .with_measure(Measure::new("h", "ring", MeasureKind::size(Axis::X)));
    assert_eq!(built, scene_from_json(file).expect("a valid scene"));
}

#[test]
fn bodies_of_both_kinds_stand_in_one_row() {
    let scene = every_field();
    let document = serde_json::to_value(&scene).expect("a document");
    let (solids, layered) = (scene.bodies.len(), scene.two_layer.len());
    assert!(solids > 1 && layered > 0);
    assert_eq!(scene.all_bodies().count(), solids + layered);
    for (index, body) in scene.all_bodies().enumerate() {
        assert_eq!(scene.any_body(index), Some(body));
        assert_eq!(scene.find_body(body.id()), Some(body));
        assert_eq!(body.solid().is_some(), index < solids);
        assert_eq!(body.two_layer().is_some(), index >= solids);
        let at = document.pointer(&scene.body_pointer(index)).expect("the pointer leads to something");
        assert_eq!(at["id"], body.id());
        assert_eq!(at["integrator"], serde_json::to_value(body.integrator()).expect("a word"));
        assert_eq!(at["placement"], serde_json::to_value(body.placement()).expect("a placement"));
        assert_eq!(at["initial"], serde_json::to_value(body.initial()).expect("a start"));
        assert_eq!(at.get("pins").map_or(0, |pins| pins.as_array().map_or(0, Vec::len)), body.pins().len());
        assert_eq!(at.get("regions").map_or(0, |all| all.as_array().map_or(0, Vec::len)), body.regions().len());
        assert_eq!(at.get("fibres").map_or(0, |all| all.as_array().map_or(0, Vec::len)), body.fibres().len());
    }
    assert_eq!(scene.any_body(solids + layered), None);
    assert_eq!(scene.find_body("none"), None);
    for (pointer, model) in scene.meshes() {
        let at = document.pointer(&pointer).expect("the pointer leads to a mesh");
        assert_eq!(at["path"], model.path);
    }
}

#[test]
fn bodies_of_both_kinds_change_alike() {
    let mut scene = every_field();
    for mut body in scene.all_bodies_mut() {
        *body.integrator_mut() = IntegratorKind::Verlet.into();
        *body.hidden_mut() = true;
        *body.color_mut() = Some([1, 2, 3]);
        body.pins_mut().clear();
        body.regions_mut().truncate(1);
    }
    for body in scene.all_bodies() {
        assert_eq!((body.integrator(), body.hidden()), (IntegratorKind::Verlet.into(), true));
        assert_eq!((body.color(), body.pins().len()), (Some([1, 2, 3]), 0));
        assert!(body.regions().len() <= 1);
    }
    let last = scene.two_layer.len() - 1;
    let id = scene.two_layer[last].id.clone();
    assert!(matches!(scene.find_body_mut(&id), Some(AnyBodyMut::TwoLayer(body)) if body.id == id));
    assert!(matches!(scene.find_body(&id), Some(AnyBody::TwoLayer(body)) if body.id == id));
    assert!(scene.find_body_mut("none").is_none());
}
