//! Which particles follow, and what is refused of motions to follow.

use crate::common::*;
use crate::follows::{scene, skeleton, solid};
use crate::rig::{Rig, write_cache};
use glam::DVec3;
use sinew::bake::bake;
use sinew::io::load_assets;
use sinew::scene::{Assets, CacheLeader, Dab, Follow, FollowSelect, Region, Scene, SkeletonLeader};
use sinew::sim::Runner;

/// How many particles are held from the start, and how many there are: those keep still that the others leave behind.
fn held(follow: Follow, rig: &Rig) -> Result<(usize, usize), String> {
    let body = solid(Follow { start: 100.0, ..follow }).with_velocity([0.01, 0.0, 0.0]);
    let body = body.with_region(Region::in_box("foot", [-1.0, 0.0, -1.0], [1.0, 0.02, 1.0]));
    let mut scene = scene(body);
    scene.time.frames_per_second = 1000.0;
    let assets = load_assets(&scene, rig.path(), &mut |_| {}).map_err(|error| error.to_string())?;
    let mut runner = Runner::new(bake(&scene, &assets).map_err(|error| error.to_string())?);
    runner.advance_frame();
    let velocities = &runner.world().bodies()[0].state().velocities;
    Ok((velocities.iter().filter(|v| **v == DVec3::ZERO).count(), velocities.len()))
}

#[test]
fn particles_are_chosen_by_weight_distance_region_and_paint() {
    let rig = Rig::column();
    let of = |leader: SkeletonLeader, select: FollowSelect| {
        held(Follow::new("bones", leader).with_select(select), &rig).expect("some follow")
    };
    let tip = || skeleton().with_joints(["tip"]);
    let base = || skeleton().with_joints(["base"]);
    let (all, count) = of(skeleton(), FollowSelect::Everything);
    assert_eq!(all, count);
    assert_eq!(of(skeleton(), FollowSelect::SkinWeight(1.0)).0, count);
    let [upper, lower] = [tip(), base()].map(|leader| of(leader, FollowSelect::SkinWeight(0.5)).0);
    assert!(upper + lower >= count && (upper as f64 / count as f64 - 0.5).abs() < 0.1, "{upper} {lower} of {count}");
    // The bone of the base leads to the tip, and the tip has none but itself.
    let near = of(base(), FollowSelect::Distance(0.012)).0;
    let point = of(tip(), FollowSelect::Distance(0.012)).0;
    assert!(point > 0 && near > 2 * point && near < lower, "{near} {point}");
    let foot = of(tip(), FollowSelect::Region("foot".to_owned())).0;
    assert!(foot > 0 && foot < lower, "{foot}");
    let dab = Dab::new([0.0, 0.12, 0.0], 0.04, 1.0);
    let painted = Follow { paint: vec![dab.clone()], ..Follow::new("bones", skeleton()) };
    let only = held(painted.clone().with_select(FollowSelect::Painted), &rig).expect("some follow").0;
    assert!(only > 0 && only < upper, "{only}");
    let out = Follow { paint: vec![Dab { value: 0.0, ..dab }], ..painted };
    assert_eq!(held(out, &rig).expect("some follow").0, count - only);
}

#[test]
fn what_does_not_fit_is_refused_with_what_there_is() {
    let mut rig = Rig::column();
    let error = |follow: Follow, rig: &Rig| held(follow, rig).expect_err("it is refused");
    let unknown = error(Follow::new("f", skeleton().with_animation("walk")), &rig);
    assert_eq!(
        unknown,
        "/bodies/0/follows/0/leader/skeleton/animation: animation \"walk\" does not exist; there are: nod"
    );
    let unknown = error(Follow::new("f", skeleton().with_joints(["tip", "toe"])), &rig);
    assert!(unknown.starts_with("/bodies/0/follows/0/leader/skeleton/joints/1: joint \"toe\""), "{unknown}");
    assert!(unknown.ends_with("there are: base, tip"), "{unknown}");
    let none = error(Follow::new("f", skeleton()).with_select(FollowSelect::Distance(1e-9)), &rig);
    assert!(none.starts_with("/bodies/0/follows/0/select: none of the"), "{none}");
    write_cache(rig.path(), "still.pc2", &[0.0], |at, _| at);
    let mut alone = in_space(block([3, 5, 3], 1e5).with_follow(Follow::new("f", CacheLeader::new("still.pc2"))));
    let load = |scene: &Scene, rig: &Rig| load_assets(scene, rig.path(), &mut |_| {});
    let assets = load(&alone, &rig).expect("files that are there");
    let error_of = |scene: &Scene, assets: &Assets| match bake(scene, assets) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("it is refused"),
    };
    let no_rest = error_of(&alone, &assets);
    assert!(no_rest.contains("/follows/0/leader/cache: ") && no_rest.contains("`rest`"), "{no_rest}");
    std::fs::write(rig.path().join("other.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("a file");
    alone.bodies[0].follows[0].leader = CacheLeader::new("still.pc2").with_rest("other.obj").into();
    let assets = load(&alone, &rig).expect("files that are there");
    let count = error_of(&alone, &assets);
    let points = crate::rig::column().positions.len();
    assert!(count.contains(&format!("has {points} points")) && count.contains("3 vertices"), "{count}");
    let far = SkeletonLeader { scale: 100.0, ..skeleton() };
    let mut apart = in_space(block([3, 5, 3], 1e5).with_follow(Follow::new("f", far)));
    apart.bodies[0].shape = sinew::scene::BoxShape::new([0.02, 0.03, 0.02]).with_center([0.0, -0.1, 0.0]).into();
    let baked = bake(&apart, &load(&apart, &rig).expect("files")).expect("a scene that bakes");
    let note = baked.notes.iter().find(|note| note.text.contains("lies apart")).expect("it is said");
    assert_eq!(note.path, "/bodies/0/follows/0/leader/skeleton/path");
    // Files that hold no motion, each with the file and the reason.
    let damaged = |rig: &mut Rig, pointer: &str, value: serde_json::Value| {
        let before = rig.json.clone();
        let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
        let parent = rig.json.pointer_mut(parent).expect("a place that is there");
        match name.parse::<usize>() {
            Ok(index) if parent.is_array() => parent[index] = value,
            _ => parent[name] = value,
        }
        rig.write();
        let said = error(Follow::new("f", skeleton()), rig);
        rig.json = before;
        rig.write();
        said
    };
    let skinless = damaged(&mut rig, "/skins", serde_json::json!([]));
    assert!(skinless.contains("rig.gltf"), "{skinless}");
    let nan = rig.numbers("SCALAR", 2, [0.0, f64::NAN]);
    let back = rig.numbers("SCALAR", 2, [0.2, 0.1]);
    let flat = rig.numbers("VEC4", 2, [0.0; 8]);
    let sampler = "/animations/0/samplers/0";
    for (pointer, value, said) in [
        ("/animations".to_owned(), serde_json::json!([]), "no animation"),
        ("/animations".to_owned(), serde_json::json!(7), "/animations"),
        ("/animations/0/channels/0/target/node".to_owned(), serde_json::json!(9), "nodes[9]"),
        ("/animations/0/channels/0/sampler".to_owned(), serde_json::json!(4), "samplers[4]"),
        (format!("{sampler}/input"), serde_json::json!(nan), "ascending"),
        (format!("{sampler}/input"), serde_json::json!(back), "ascending"),
        (format!("{sampler}/output"), serde_json::json!(flat), "no length"),
        (format!("{sampler}/output"), serde_json::json!(2), "values where 2"),
        (format!("{sampler}/interpolation"), serde_json::json!("WOBBLE"), "WOBBLE"),
        ("/skins/0/joints/1".to_owned(), serde_json::json!(77), "nodes[77]"),
        ("/nodes/1/children".to_owned(), serde_json::json!([0]), "contain each other"),
    ] {
        let error = damaged(&mut rig, &pointer, value);
        assert!(error.contains(said) && error.contains("rig.gltf") && !error.contains('\n'), "{pointer}: {error}");
    }
    for name in ["rig.bin", "other.obj"] {
        let wrong = error(Follow::new("f", SkeletonLeader::new(name)), &rig);
        assert!(wrong.contains("glTF or GLB file with a skin"), "{wrong}");
    }
    let wrong = error(Follow::new("f", CacheLeader::new("rig.bin")), &rig);
    assert!(wrong.contains("/leader/cache/path: ") && wrong.contains("PC2 or MDD"), "{wrong}");
}

#[test]
fn damaged_rigs_are_refused_in_a_line_or_followed() {
    let rig = Rig::column();
    let whole = [rig.json.to_string().into_bytes(), rig.bin.clone()];
    let names = ["rig.gltf", "rig.bin"];
    let mut scene = in_space(block([3, 5, 3], 1e5).with_follow(Follow::new("f", skeleton())));
    scene.bodies[0].follows[0].after = sinew::scene::AfterLast::Repeat;
    let (mut refused, mut followed) = (0, 0);
    for salt in 0..300 {
        let random = wobble(salt, 11);
        let file = usize::from(random.x > 0.2);
        let mut bytes = whole[file].clone();
        let at = ((0.5 + 0.499 * random.y) * bytes.len() as f64) as usize;
        match salt % 4 {
            0 => bytes.truncate(at),
            1 => bytes[at] ^= 1 << (salt % 7),
            2 => bytes[at] = b'9',
            _ => drop(bytes.drain(at..(at + 3).min(whole[file].len()))),
        }
        std::fs::write(rig.path().join(names[file]), bytes).expect("a file");
        match load_assets(&scene, rig.path(), &mut |_| {}) {
            Err(error) => {
                let error = error.to_string();
                assert!(error.contains("rig.") && !error.contains('\n') && !error.contains("panic"), "{error}");
                refused += 1;
            }
            Ok(assets) => {
                if let Ok(baked) = bake(&scene, &assets) {
                    let state = baked.world.bodies()[0].state();
                    assert!(state.positions.iter().all(|x| x.is_finite()), "damage {salt}");
                }
                followed += 1;
            }
        }
        std::fs::write(rig.path().join(names[file]), &whole[file]).expect("a file");
    }
    println!("{refused} refused, {followed} followed");
    assert!(refused > 50 && followed > 20, "{refused} refused, {followed} followed");
}
