//! Commands of every kind at random, some of which are refused.

use crate::every_field;
use crate::shapes::fibre;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::{select, subsequence};
use sinew::edit::{Command, Item};
use sinew::scene::{
    Body, Dab, Drivable, Drive, DriveKeys, Fibre, FibreSource, IntegratorKind, OwnedBody, Placement, Region,
    RegionMaterial, Room, Selector, Sheet, TwoLayer, Void, Wave, Wind,
};

/// Number of kinds of commands.
pub const KINDS: usize = 30;

/// Which kind a command is. Without a wildcard: a new kind is to be put in here and into [`any_command`].
pub fn kind(command: &Command) -> usize {
    match command {
        Command::Many { .. } => 0,
        Command::AddFibre { .. } => 1,
        Command::SetFibre { .. } => 2,
        Command::RemoveFibre { .. } => 3,
        Command::SetName { .. } => 4,
        Command::SetHidden { .. } => 5,
        Command::SetColor { .. } => 6,
        Command::SetPaint { .. } => 7,
        Command::SetMaterial { .. } => 8,
        Command::SetIntegrator { .. } => 9,
        Command::SetPins { .. } => 10,
        Command::SetTwoLayer(_) => 11,
        Command::SetTime(_) => 12,
        Command::SetGravity(_) => 13,
        Command::SetRoom(_) => 14,
        Command::SetPanels(_) => 15,
        Command::SetVoids { .. } => 16,
        Command::SetRegionMaterials { .. } => 17,
        Command::SetColliders(_) => 18,
        Command::AddBody(_) => 19,
        Command::SetBody { .. } => 20,
        Command::RemoveBody { .. } => 21,
        Command::SetPlacement { .. } => 22,
        Command::AddSheet { .. } => 23,
        Command::SetSheet { .. } => 24,
        Command::RemoveSheet { .. } => 25,
        Command::SetDrive { .. } => 26,
        Command::SetWind(_) => 27,
        Command::SetElements { .. } => 28,
        Command::SetFollows { .. } => 29,
    }
}

fn solid() -> impl Strategy<Value = String> {
    select(vec!["bar".to_owned(), "cube".to_owned()])
}

fn fibre_id() -> impl Strategy<Value = String> {
    select(["left", "right", "new-0", "new-1"].map(str::to_owned).to_vec())
}

fn item() -> impl Strategy<Value = Item> {
    let body = select(["bar", "cube", "balloon", "tube", "none"].map(str::to_owned).to_vec()).prop_map(Item::Body);
    prop_oneof![
        body,
        (solid(), fibre_id()).prop_map(|(body, fibre)| Item::Fibre { body, fibre }),
        (solid(), sheet_id()).prop_map(|(body, sheet)| Item::Sheet { body, sheet }),
    ]
}

fn any_fibre() -> impl Strategy<Value = Fibre> {
    let drawn = every_field().bodies[0].fibres[0].source.clone();
    let vertices = vec([-0.1..0.1f64, 0.0..0.4, -0.1..0.1], 2..6).prop_map(FibreSource::Vertices);
    let source = prop_oneof![Just(drawn), vertices];
    (fibre_id(), "[a-c]{0,2}", source, 0.0..1.1f64).prop_map(|(id, name, source, volume_fraction)| Fibre {
        id,
        name,
        volume_fraction,
        ..fibre(source)
    })
}

fn of_fibres() -> impl Strategy<Value = Command> {
    prop_oneof![
        (solid(), any_fibre()).prop_map(|(body, fibre)| Command::AddFibre { body, fibre }),
        (solid(), any_fibre()).prop_map(|(body, fibre)| Command::SetFibre { body, fibre }),
        (solid(), fibre_id()).prop_map(|(body, fibre)| Command::RemoveFibre { body, fibre }),
    ]
}

fn sheet_id() -> impl Strategy<Value = String> {
    select(["fin", "skin", "new-0", "new-1"].map(str::to_owned).to_vec())
}

fn any_sheet() -> impl Strategy<Value = Sheet> {
    let sheets = every_field().bodies[0].sheets.clone();
    (sheet_id(), select(sheets), 0.0..1.1f64).prop_map(|(id, sheet, share)| Sheet {
        id,
        activation: None,
        volume_fraction: share,
        ..sheet
    })
}

fn of_sheets() -> impl Strategy<Value = Command> {
    prop_oneof![
        (solid(), any_sheet()).prop_map(|(body, sheet)| Command::AddSheet { body, sheet }),
        (solid(), any_sheet()).prop_map(|(body, sheet)| Command::SetSheet { verb: "Move".into(), body, sheet }),
        (solid(), sheet_id()).prop_map(|(body, sheet)| Command::RemoveSheet { body, sheet }),
    ]
}

fn of_looks() -> impl Strategy<Value = Command> {
    prop_oneof![
        (item(), "[a-c]{0,3}").prop_map(|(item, name)| Command::SetName { item, name }),
        (vec(item(), 0..3), any::<bool>()).prop_map(|(items, hidden)| Command::SetHidden { items, hidden }),
        (vec(item(), 0..3), option::of(any::<[u8; 3]>())).prop_map(|(items, color)| Command::SetColor { items, color }),
    ]
}

fn of_matter() -> impl Strategy<Value = Command> {
    let scene = every_field();
    let material = scene.bodies[0].material.clone();
    let layers = scene.two_layer.clone();
    let dab = ([-0.1..0.1f64, 0.0..0.4, -0.1..0.1], 0.0..0.1f64, 0.0..1.05f64)
        .prop_map(|(center, radius, value)| Dab::new(center, radius, value));
    let body = select(["bar", "ring", "none"].map(str::to_owned).to_vec());
    let integrator = select(vec![IntegratorKind::Rk4, IntegratorKind::Midpoint, IntegratorKind::LeapFrog]);
    let mut elements = scene.bodies[0].elements.clone();
    elements[0].activation = None;
    // Two of one name are refused.
    elements.push(elements[1].clone());
    let void = ([-0.1..0.1f64, 0.0..0.4, -0.1..0.1], -0.01..0.1f64)
        .prop_map(|(center, radius)| Void::sphere(format!("{radius}"), center, radius));
    prop_oneof![
        (solid(), select(vec!["top", "core", "bottom", "none"]), 0.0..0.1f64).prop_map(|(body, region, transition)| {
            let own = RegionMaterial { transition, ..RegionMaterial::of(region) };
            Command::SetRegionMaterials { body, materials: vec![own] }
        }),
        (solid(), vec(void, 0..3)).prop_map(|(body, voids)| Command::SetVoids { body, voids }),
        (solid(), subsequence(elements, 0..4)).prop_map(|(body, elements)| Command::SetElements { body, elements }),
        (solid(), vec(dab, 0..3)).prop_map(|(body, paint)| Command::SetPaint { body, paint }),
        (solid(), 1e4..1e8f64, 0.0..0.6f64).prop_map(move |(body, young_modulus, poisson_ratio)| {
            let mut material = material.clone();
            (material.young_modulus, material.poisson_ratio) = (young_modulus, poisson_ratio);
            Command::SetMaterial { body, material }
        }),
        (body, integrator)
            .prop_map(|(body, integrator)| Command::SetIntegrator { body, integrator: integrator.into() }),
        (select(layers), 1.0..900.0f64).prop_map(|(mut body, ks)| {
            body.ks = ks;
            Command::SetTwoLayer(Box::new(body))
        }),
    ]
}

fn of_world() -> impl Strategy<Value = Command> {
    let scene = every_field();
    let (time, panels, colliders) = (scene.time.clone(), scene.panels.clone(), scene.colliders.clone());
    prop_oneof![
        (0.0..3.0f64).prop_map(move |duration| {
            let mut time = time.clone();
            time.duration = duration;
            Command::SetTime(time)
        }),
        (-20.0..20.0f64).prop_map(|y| Command::SetGravity([0.0, y, 0.0])),
        (-0.1..1.0f64).prop_map(|friction| Command::SetRoom(Room { friction, ..Room::default() })),
        (0..=2usize, 0.5..0.9f64).prop_map(move |(count, height)| {
            let mut panels = panels[..count].to_vec();
            for panel in &mut panels {
                panel.height = height;
            }
            Command::SetPanels(panels)
        }),
        (0..=4usize, -0.1..1.0f64).prop_map(move |(count, friction)| {
            let colliders = colliders[..count].iter().cloned();
            Command::SetColliders(colliders.map(|collider| collider.with_friction(friction)).collect())
        }),
    ]
}

/// Drives of everything that a drive can move, and of some things that are not there; some name no drive, or leave what
/// they move no room.
fn of_drives() -> impl Strategy<Value = Command> {
    let mut all = every_field().drivables();
    all.push(Drivable::Fibre { body: "bar".into(), fibre: "none".into() });
    all.push(Drivable::Shared { body: "bar".into(), drive: "new".into() });
    let keys = vec((0.0..2.0f64, -0.5..1.2f64), 1..4).prop_map(|mut keys| {
        keys.sort_by(|a, b| a.0.total_cmp(&b.0));
        Drive::from(DriveKeys::new(keys))
    });
    let wave = (-0.1..2.0f64, option::of(0.01..0.1f64))
        .prop_map(|(period, wavelength)| Drive::from(Wave { wavelength, ..Wave::new(period) }));
    let named = select(vec!["slow", "breath", "new"]).prop_map(|id| Drive::Shared(id.to_owned()));
    let drive = option::weighted(0.8, prop_oneof![(-0.2..1.0f64).prop_map(Drive::Constant), keys, wave, named]);
    let wind = option::of((-2.0..2.0f64, -0.1..2.0f64))
        .prop_map(|wind| Command::SetWind(wind.map(|(x, drag)| Wind { drag, ..Wind::new([x, 0.0, 0.0]) })));
    prop_oneof![4 => (select(all), drive).prop_map(|(of, drive)| Command::SetDrive { of, drive }), 1 => wind]
}

/// Motions that bodies of either kind follow; the balloon has no region "core".
fn of_follows() -> impl Strategy<Value = Command> {
    let follows = every_field().bodies[0].follows.clone();
    (select(vec!["bar", "balloon"]), 0..=follows.len()).prop_map(move |(body, count)| Command::SetFollows {
        body: body.to_owned(),
        follows: follows[..count].to_vec(),
    })
}

/// Pins of either kind of body. The measures refer to regions of the bar: those without one of them are refused.
fn of_pins() -> impl Strategy<Value = Command> {
    let scene = every_field();
    let (bar, balloon) = (scene.bodies[0].clone(), scene.two_layer[0].clone());
    let everything = Region::new("everything", Selector::Everything);
    (0..5usize, 0..=5usize).prop_map(move |(which, count)| match which {
        0 | 1 => Command::SetPins {
            body: "bar".into(),
            regions: bar.regions[..4 - which].to_vec(),
            pins: bar.pins[..count].to_vec(),
        },
        2 | 3 => Command::SetPins {
            body: "balloon".into(),
            regions: balloon.regions.clone(),
            pins: balloon.pins[..count.min(1)].to_vec(),
        },
        _ => {
            Command::SetPins { body: "cube".into(), regions: vec![everything.clone(); count.min(2)], pins: Vec::new() }
        }
    })
}

/// Bodies come and go; one of an identifier that is taken, or not there, is refused.
fn of_bodies() -> impl Strategy<Value = Command> {
    let known = || select(["cube", "tube", "new-body", "none"].map(str::to_owned).to_vec());
    let body = || {
        (known(), [-0.2..0.2f64, 0.1..0.4, -0.2..0.2], any::<bool>()).prop_map(|(id, at, solid)| -> OwnedBody {
            if solid {
                Body::cuboid(id, [0.1; 3]).with_translation(at).into()
            } else {
                TwoLayer::ring(id).with_translation(at).into()
            }
        })
    };
    prop_oneof![
        body().prop_map(Command::AddBody),
        body().prop_map(|body| Command::SetBody { verb: "Scale".into(), body }),
        known().prop_map(|body| Command::RemoveBody { body }),
        (known(), [-0.2..0.2f64, 0.1..0.4, -0.2..0.2]).prop_map(|(body, translation)| {
            Command::SetPlacement { body, placement: Placement { translation, ..Placement::default() } }
        }),
    ]
}

fn single() -> impl Strategy<Value = Command> {
    prop_oneof![3 => of_fibres(), 3 => of_sheets(), 2 => of_looks(), 3 => of_matter(), 3 => of_world(), 1 => of_pins(),
        1 => of_follows(), 2 => of_bodies(), 2 => of_drives()]
}

/// A command for the scene with every field.
pub fn any_command() -> impl Strategy<Value = Command> {
    let many = ("[a-b]", vec(single(), 0..4)).prop_map(|(name, commands)| Command::Many { name, commands });
    prop_oneof![8 => single(), 1 => many]
}
