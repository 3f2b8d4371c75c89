//! What is loaded is what was saved.

use super::any_element::{above_zero, element, extra, number};
use super::any_parts::{follow, sheet};
use super::{EVERY_FIELD, every_field};
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::{Value, json};
use sinew::io::{scene_from_json, scene_to_json, unknown_fields};
use sinew::scene::*;
use sinew::sketch::View;

#[test]
fn every_field_survives() {
    let scene = every_field();
    assert_eq!(scene_from_json(&scene_to_json(&scene)).expect("valid"), scene);
    assert_eq!(unknown_fields(&scene), Vec::<String>::new());
}

/// Members that hold one of several alternatives.
const CHOICES: [&str; 17] = [
    "shape",
    "mass",
    "source",
    "stiffness",
    "along",
    "select",
    "motion",
    "leader",
    "hold",
    "drive",
    "gravity_drive",
    "pressure_drive",
    "distance",
    "inner_offset",
    "kind",
    "step",
    "law",
];

/// An object member added to every object of a scene that may hold one is kept and listed.
#[test]
fn unknown_fields_are_kept_and_listed_everywhere() {
    fn add(value: &mut Value, path: &str, added: &mut Vec<String>, is_choice: bool) {
        match value {
            Value::Object(members) => {
                for (name, member) in members.iter_mut() {
                    let choice = CHOICES.contains(&name.as_str());
                    add(member, &format!("{path}/{name}"), added, choice);
                }
                // The alternatives of a choice are its only members.
                if !is_choice {
                    members.insert("~new/er".to_owned(), json!({"deep": [1, {"x": null}]}));
                    added.push(format!("{path}/~0new~1er"));
                }
            }
            Value::Array(items) => {
                for (index, item) in items.iter_mut().enumerate() {
                    add(item, &format!("{path}/{index}"), added, false);
                }
            }
            _ => {}
        }
    }
    let mut value: Value = serde_json::from_str(EVERY_FIELD).expect("JSON");
    let mut added = Vec::new();
    add(&mut value, "", &mut added, false);
    let scene = scene_from_json(&value.to_string()).expect("valid");
    let again = scene_from_json(&scene_to_json(&scene)).expect("valid");
    assert_eq!(again, scene);
    let mut listed = unknown_fields(&again);
    listed.sort();
    added.sort();
    assert!(added.len() > 40, "{}", added.len());
    assert_eq!(listed, added);
}

#[test]
fn text_is_laid_out_for_people() {
    let text = scene_to_json(&every_field());
    assert!(text.contains("\"gravity\": [0.0, -9.81, 0.0],\n"), "{text}");
    assert!(text.contains("\"axes\": [\"x\", \"z\"],\n"), "{text}");
    assert!(text.starts_with("{\n  \"version\": 1,\n") && text.ends_with("}\n"));
}

pub fn vector() -> impl Strategy<Value = [f64; 3]> {
    [number(), number(), number()]
}

pub fn direction() -> impl Strategy<Value = [f64; 3]> {
    (above_zero(), number(), number()).prop_map(|(x, y, z)| [x, y, z])
}

fn rotation() -> impl Strategy<Value = Rotation> {
    (direction(), number(), extra()).prop_map(|(axis, degrees, extra)| Rotation { axis, degrees, extra })
}

fn drive() -> impl Strategy<Value = Drive> {
    let between = prop_oneof![Just(Interpolation::Stepped), Just(Interpolation::Linear), Just(Interpolation::Smooth)];
    let after = prop_oneof![Just(AfterLast::Hold), Just(AfterLast::Repeat), Just(AfterLast::Mirror)];
    let otherwise = proptest::option::of((0.0..=1.0, proptest::option::of(above_zero()), extra()));
    let keys = (vec((0.0..=1.0, extra()), 2..4), between, after, otherwise, extra());
    let keys = keys.prop_map(|(keys, between, after, otherwise, extra)| {
        // What a smooth course overshoots is for other tests.
        let slope = if between == Interpolation::Smooth { 0.0 } else { 0.1 };
        let key = |(number, (value, extra)): (usize, (f64, _))| {
            let number = number as f64;
            DriveKey { slope: slope * number, extra, ..DriveKey::new(number / 3.0, value) }
        };
        let keys = keys.into_iter().enumerate().map(key).collect();
        let otherwise = otherwise.map(|(value, back_in, extra)| Otherwise {
            drive: Box::new(Drive::Constant(value)),
            back_in: back_in.filter(|_| after == AfterLast::Hold),
            extra,
        });
        Drive::Keyframes(DriveKeys { keys, between, after, otherwise, extra })
    });
    let wave = (above_zero(), number(), proptest::option::of(1e-6..1e6), above_zero(), extra()).prop_map(
        |(period, phase_degrees, wavelength, start, extra)| {
            Drive::Wave(Wave { period, phase_degrees, wavelength, start, extra, ..Wave::new(1.0) })
        },
    );
    prop_oneof![(0.0..=1.0).prop_map(Drive::Constant), keys, wave, Just(Drive::Shared("shared".to_owned()))]
}

fn activation() -> impl Strategy<Value = Activation> {
    let curl = (number(), direction(), extra()).prop_map(|(degrees_per_metre, axis, extra)| Curl {
        degrees_per_metre,
        axis,
        extra,
    });
    let muscle =
        (above_zero(), 0.1..=1.0, extra()).prop_map(|(force, width, extra)| MusclePull { force, width, extra });
    let thick = proptest::option::of(0.0..=1.0);
    (drive(), -0.5..=0.8, proptest::option::of(curl), proptest::option::of(muscle), thick, extra()).prop_map(
        |(drive, contract, curl, muscle, volume_fraction, extra)| Activation {
            drive,
            contract,
            curl,
            muscle,
            twist: None,
            volume_fraction,
            extra,
        },
    )
}

fn motion() -> impl Strategy<Value = Motion> {
    let easing = || prop_oneof![Just(Easing::Linear), Just(Easing::Smooth)];
    let distance = prop_oneof![number().prop_map(Distance::Metres), number().prop_map(Distance::Fraction)];
    let ramp = (direction(), distance, above_zero(), above_zero(), easing(), extra()).prop_map(
        |(direction, distance, start, duration, easing, extra)| {
            Motion::Ramp(Ramp { direction, distance, start, duration, easing, extra })
        },
    );
    let turn = (direction(), proptest::option::of(vector()), number(), above_zero(), easing()).prop_map(
        |(axis, origin, degrees, duration, easing)| {
            Motion::Turn(Turn { axis, origin, degrees, start: 0.0, duration, easing, extra: Extra::new() })
        },
    );
    let keys = vec((vector(), extra()), 1..4).prop_map(|keys| {
        let keys = keys.into_iter().enumerate();
        Motion::Keyframes(
            keys.map(|(time, (offset, extra))| Keyframe { time: time as f64 / 3.0, offset, extra }).collect(),
        )
    });
    prop_oneof![Just(Motion::Fixed), ramp, turn, keys]
}

fn selector() -> impl Strategy<Value = Selector> {
    let axis = prop_oneof![Just(Axis::X), Just(Axis::Y), Just(Axis::Z)];
    let side = prop_oneof![Just(Side::Min), Just(Side::Max)];
    prop_oneof![
        Just(Selector::Everything),
        (axis, side, 1..2_000_000_u32, extra()).prop_map(|(axis, side, count, extra)| Selector::Layers {
            axis,
            side,
            count,
            extra
        }),
        (vector(), extra()).prop_map(|(min, extra)| Selector::Box { min, max: min.map(f64::abs), extra }),
        (vector(), above_zero(), extra()).prop_map(|(center, radius, extra)| Selector::Sphere {
            center,
            radius,
            extra
        }),
    ]
}

fn look() -> impl Strategy<Value = (bool, Option<[u8; 3]>)> {
    (any::<bool>(), proptest::option::of(any::<[u8; 3]>()))
}

fn fibre() -> impl Strategy<Value = Fibre> {
    let stroke = |view| {
        (vec([number(), number()], 2..6), extra()).prop_map(move |(points, extra)| ViewStroke { view, points, extra })
    };
    let strokes = (stroke(View::Front), stroke(View::Top), any::<bool>(), extra()).prop_map(
        |(first, second, flip_second, extra)| {
            FibreSource::Strokes(StrokePair { first, second, flip_second, mismatch: Mismatch::Stretch, extra })
        },
    );
    let source = prop_oneof![strokes, vec(vector(), 3..6).prop_map(FibreSource::Vertices)];
    let stiffness = prop_oneof![
        (above_zero(), above_zero(), extra()).prop_map(|(ea, ei, extra)| Stiffness::Rigidity(Rigidity {
            ea,
            ei,
            gj: 0.0,
            extra
        })),
        (above_zero(), above_zero(), extra()).prop_map(|(kb, ks, extra)| Stiffness::Paper(PaperStiffness {
            kb,
            ks,
            extra
        })),
    ];
    let past = proptest::option::of(
        (proptest::option::of(1.0..=180.0), proptest::option::of(above_zero()), extra())
            .prop_map(|(angle, tension, extra)| BreakPast { angle, tension, extra }),
    );
    let acts = (past, proptest::option::of(activation()));
    (any::<String>(), look(), source, stiffness, 0.0..=1.0, acts, extra()).prop_map(
        |(name, (hidden, color), source, stiffness, share, (past, activation), extra)| Fibre {
            id: "fibre".to_owned(),
            name,
            hidden,
            color,
            source,
            stiffness,
            volume_fraction: share,
            rest_shape: RestShape::Straight,
            break_past: past,
            yields: activation.is_none().then(|| YieldPast::curvature(300.0)),
            activation,
            extra,
        },
    )
}

fn body() -> impl Strategy<Value = Body> {
    let material = (above_zero(), 0.0..0.49, above_zero(), 0.3..0.6, extra()).prop_map(
        |(young_modulus, poisson_ratio, density, spacing_ratio, extra)| Material {
            young_modulus,
            poisson_ratio,
            mass: Mass::Density(density),
            support_radius: 0.05,
            spacing_ratio,
            damping: Damping { pair: 1.0 / 3.0, air: 0.1, extra: Extra::new() },
            viscosity: Some(Viscosity::new(1.0 / 3.0, 0.1)),
            plasticity: Some(Plasticity::new(2e4 / 3.0)),
            volume_fraction_falloff: Falloff::Constant,
            fibre_embedding: FibreEmbedding::All,
            precision: Precision::Fast,
            extra,
        },
    );
    let cuboid = ([0.1..0.5, 0.1..0.5, 0.1..0.5], vector(), rotation(), extra()).prop_map(
        |(size, center, lattice_rotation, extra)| Shape::Box(BoxShape { center, size, lattice_rotation, extra }),
    );
    let round = (0..4, 0.1..0.5, 0.01..0.09, extra()).prop_map(|(kind, radius, less, extra)| match kind {
        0 => Shape::Ball(BallShape { radius, extra }),
        1 => Shape::Cylinder(CylinderShape { radius, height: less, extra }),
        2 => Shape::Capsule(CapsuleShape { radius, height: less, extra }),
        _ => Shape::Torus(TorusShape { radius, tube_radius: less, extra }),
    });
    let shape = prop_oneof![cuboid, round];
    let placement = (vector(), rotation(), extra()).prop_map(|(translation, rotation, extra)| Placement {
        translation,
        rotation,
        extra,
    });
    let initial = (vector(), vector(), extra()).prop_map(|(velocity, angular_velocity, extra)| Initial {
        velocity,
        angular_velocity,
        extra,
        ..Initial::default()
    });
    let pin = (motion(), extra()).prop_map(|(motion, extra)| Pin {
        id: "pin".to_owned(),
        region: "region".to_owned(),
        axes: vec![Axis::Z],
        motion,
        extra,
    });
    let dab = (vector(), above_zero(), 0.0..=1.0, 0.0..=1.0, extra())
        .prop_map(|(center, radius, value, strength, extra)| Dab { center, radius, value, strength, extra });
    let parts = (fibre(), vec(dab, 0..3), pin, sheet(), (element(), follow()));
    (any::<String>(), look(), shape, placement, material, initial, selector(), parts, extra()).prop_map(
        |(
            name,
            (hidden, color),
            shape,
            placement,
            mut material,
            initial,
            select,
            (fibre, paint, pin, mut sheet, (element, follow)),
            extra,
        )| {
            // A matrix that flows or yields keeps its share.
            if fibre.activation.as_ref().is_some_and(|acts| acts.volume_fraction.is_some()) {
                (material.plasticity, material.viscosity) = (None, None);
                sheet.seam = None;
            }
            // One that does does not tear.
            if material.plasticity.is_some() || material.viscosity.is_some() {
                sheet.seam = None;
            }
            Body {
                id: "body \"\\ \u{1F9B4}\n".to_owned(),
                name,
                hidden,
                color,
                kind: BodyKind::FibreSolid,
                shape,
                placement,
                material,
                self_contact: hidden,
                integrator: IntegratorKind::Midpoint.into(),
                initial,
                impulses: Vec::new(),
                drives: vec![SharedDrive::new("shared", Wave::new(0.7).with_wavelength(0.1))],
                fibres: vec![fibre],
                sheets: vec![sheet],
                elements: vec![element],
                paint,
                regions: vec![Region { id: "region".to_owned(), select, extra: Extra::new() }],
                region_materials: vec![RegionMaterial::of("region")],
                voids: vec![Void::sphere("void", [0.0; 3], 1.0 / 3.0)],
                pins: vec![pin],
                follows: vec![follow],
                extra,
            }
        },
    )
}

fn scene() -> impl Strategy<Value = Scene> {
    let room = (proptest::option::of(number()), above_zero(), extra()).prop_map(|(floor, friction, extra)| Room {
        floor,
        friction,
        extra,
        ..Room::default()
    });
    (vector(), room, vec(body(), 0..=1), any::<String>(), extra()).prop_map(
        |(gravity, room, bodies, description, extra)| Scene {
            gravity,
            room,
            bodies,
            description,
            extra,
            ..Scene::default()
        },
    )
}

/// The bits of every number in a value tree, in order: equality of floats takes 0 and -0 for the same.
fn bits(value: &Value, out: &mut Vec<u64>) {
    match value {
        Value::Number(number) => out.extend(number.as_f64().map(f64::to_bits)),
        Value::Array(items) => items.iter().for_each(|item| bits(item, out)),
        Value::Object(members) => members.values().for_each(|member| bits(member, out)),
        _ => {}
    }
}

fn bits_of(scene: &Scene) -> Vec<u64> {
    let mut out = Vec::new();
    bits(&serde_json::to_value(scene).expect("serialises"), &mut out);
    out
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn random_scenes_survive(scene in scene()) {
        let text = scene_to_json(&scene);
        let again = scene_from_json(&text).map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert_eq!(&again, &scene);
        prop_assert_eq!(bits_of(&again), bits_of(&scene));
        prop_assert_eq!(scene_to_json(&again), text);
    }

    /// Any bit pattern of an f64 in the accepted range, -0 and subnormals included.
    #[test]
    fn numbers_keep_their_bits(pattern in any::<u64>()) {
        let number = f64::from_bits(pattern);
        prop_assume!(number.abs() <= 1e15);
        let scene = Scene { gravity: [number, -number, 0.1], ..Scene::default() };
        let again = scene_from_json(&scene_to_json(&scene)).map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert_eq!(again.gravity.map(f64::to_bits), scene.gravity.map(f64::to_bits));
    }
}
