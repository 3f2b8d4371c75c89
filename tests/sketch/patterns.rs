//! Patterns hold what they promise, whatever box and numbers they are given.

use glam::DVec3;
use proptest::prelude::*;
use sinew::sketch::pattern::{Act, OwnPattern, PATTERNS, Pattern, PatternError, Polyline};
use std::collections::BTreeSet;

const LOW: DVec3 = DVec3::new(-0.021, 0.0, -0.021);
const HIGH: DVec3 = DVec3::new(0.021, 0.072, 0.021);

fn laid(id: &str, values: &[(&str, f64)]) -> Vec<Polyline> {
    let pattern = Pattern::by_id(id).expect("a pattern of that name");
    let mut all = pattern.defaults();
    for (name, value) in values {
        let index = pattern.parameters.iter().position(|parameter| parameter.id == *name);
        all[index.expect("a parameter of that name")] = *value;
    }
    pattern.lay(&all, LOW, HIGH)
}

/// Sum of the signed volumes that three consecutive edges span: above zero where a curve winds to the right.
fn winding(fibre: &Polyline) -> f64 {
    let edges: Vec<DVec3> = fibre.windows(2).map(|pair| pair[1] - pair[0]).collect();
    edges.windows(3).map(|e| e[0].cross(e[1]).dot(e[2])).sum()
}

/// Fibres as a set, rounded, either way along.
fn set(fibres: &[Polyline]) -> BTreeSet<Vec<[i64; 3]>> {
    fibres
        .iter()
        .map(|fibre| {
            let rounded: Vec<[i64; 3]> =
                fibre.iter().map(|at| at.to_array().map(|x| (x * 1e9).round() as i64)).collect();
            let back = rounded.iter().rev().copied().collect();
            rounded.min(back)
        })
        .collect()
}

#[test]
fn there_are_ten_and_more_each_with_its_words() {
    assert!(PATTERNS.len() >= 10);
    let ids: BTreeSet<&str> = PATTERNS.iter().map(|pattern| pattern.id).collect();
    assert_eq!(ids.len(), PATTERNS.len());
    for pattern in &PATTERNS {
        assert!(!pattern.title.is_empty() && pattern.does.ends_with('.'), "{}", pattern.id);
        assert_eq!(pattern.parameters.last().unwrap().id, "margin", "{}", pattern.id);
        for parameter in pattern.parameters {
            assert_eq!(parameter.held(parameter.default), parameter.default, "{}: {}", pattern.id, parameter.id);
            assert_eq!(parameter.held(f64::NAN), parameter.default);
        }
        let fibres = pattern.lay(&[], LOW, HIGH).len();
        assert!(fibres > 0, "{}", pattern.id);
        let acts = pattern.acts(&[], fibres);
        assert_eq!(acts.len(), if pattern.is_acting() { fibres } else { 0 }, "{}", pattern.id);
        for act in acts.iter().flatten() {
            assert!(act.contract > 0.0 && act.period > 0.0 && !act.muscle.is_empty(), "{}: {act:?}", pattern.id);
        }
        assert!(pattern.lay(&[], LOW, LOW.with_x(0.1)).is_empty(), "{}: a flat box", pattern.id);
    }
}

#[test]
fn counts_are_those_asked_for() {
    let lengths = |fibres: Vec<Polyline>| fibres.iter().map(Vec::len).collect::<Vec<_>>();
    assert_eq!(lengths(laid("vertical", &[("along_x", 3.0), ("vertices", 7.0)])), [7; 6]);
    assert_eq!(lengths(laid("slanted", &[])), [13; 4]);
    assert_eq!(lengths(laid("helix_left", &[("fibres", 3.0), ("vertices", 20.0)])), [20; 3]);
    assert_eq!(lengths(laid("cross", &[("planes", 3.0)])), [13; 6]);
    assert_eq!(lengths(laid("frame", &[("vertices", 5.0)])), [5; 12]);
    assert_eq!(lengths(laid("c_shape", &[("fibres", 1.0)])), [13]);
    assert_eq!(lengths(laid("s_shape", &[])), [13; 2]);
    assert_eq!(lengths(laid("radial", &[("rays", 5.0)])), [7; 5]);
    assert_eq!(lengths(laid("vein", &[("pairs", 2.0), ("vertices", 13.0)])), [13, 7, 7, 7, 7]);
    assert_eq!(lengths(laid("spiral", &[("arms", 2.0)])), [25; 2]);
    assert_eq!(lengths(laid("short_fibres", &[("fibres", 9.0)])), [4; 9]);
}

#[test]
fn helices_wind_by_their_hand_and_mirror_each_other() {
    let (left, right) = (laid("helix_left", &[]), laid("helix_right", &[]));
    assert!(right.iter().all(|fibre| winding(fibre) > 1e-10), "{}", winding(&right[0]));
    assert!(left.iter().all(|fibre| winding(fibre) < -1e-10));
    let mirrored: Vec<Polyline> = left.iter().map(|fibre| fibre.iter().map(|at| at.with_z(-at.z)).collect()).collect();
    assert_eq!(set(&mirrored), set(&right));
}

#[test]
fn what_should_be_symmetrical_is() {
    let mirrored = |fibres: &[Polyline]| -> Vec<Polyline> {
        fibres.iter().map(|fibre| fibre.iter().map(|at| at.with_x(-at.x)).collect()).collect()
    };
    for id in ["vertical", "cross", "frame", "vein", "radial"] {
        let fibres = laid(id, &[]);
        assert_eq!(set(&mirrored(&fibres)), set(&fibres), "{id}");
    }
    // A lean, a bulge and a swing to the other side are the mirror image.
    for (id, name) in [("slanted", "lean"), ("c_shape", "bulge"), ("s_shape", "swing")] {
        let [one, other] = [0.4, -0.4].map(|value| laid(id, &[(name, value)]));
        assert_eq!(set(&mirrored(&one)), set(&other), "{id}");
        assert_ne!(set(&one), set(&other), "{id}");
    }
}

#[test]
fn a_lean_leads_right_and_a_c_bulges_left() {
    for fibre in laid("slanted", &[("lean", 0.5)]) {
        assert!(fibre[12].x > fibre[0].x && fibre[12].y > fibre[0].y);
    }
    for fibre in laid("c_shape", &[("bulge", 0.8)]) {
        assert!(fibre[6].x < fibre[0].x && (fibre[0].x - fibre[12].x).abs() < 1e-12);
    }
    for fibre in laid("s_shape", &[("swing", 0.8)]) {
        assert!(fibre[3].x > 0.0 && fibre[9].x < 0.0);
    }
}

#[test]
fn veins_lie_across_the_thinnest_axis_at_their_angle() {
    let (low, high) = (DVec3::new(0.0, -0.01, -0.05), DVec3::new(0.3, 0.01, 0.05));
    let fibres = Pattern::by_id("vein").unwrap().lay(&[3.0, 0.9, 40.0], low, high);
    assert!(fibres.iter().flatten().all(|at| at.y.abs() < 1e-12));
    assert!((fibres[0][12] - fibres[0][0]).normalize_or_zero().x > 0.999_999);
    for vein in &fibres[1..] {
        let way = vein[vein.len() - 1] - vein[0];
        assert!((way.z.abs().atan2(way.x).to_degrees() - 40.0).abs() < 1e-9, "{way}");
    }
}

#[test]
fn a_seed_gives_the_same_bits_and_another_others() {
    let bits = |seed: f64| -> Vec<u64> {
        let fibres = laid("short_fibres", &[("seed", seed)]);
        fibres.iter().flatten().flat_map(DVec3::to_array).map(f64::to_bits).collect()
    };
    assert_eq!(bits(5.0), bits(5.0));
    assert_ne!(bits(5.0), bits(6.0));
    // In no direction more than in others: a third of the squares along each axis.
    let fibres = Pattern::by_id("short_fibres").unwrap().lay(&[500.0, 0.3], DVec3::ZERO, DVec3::ONE);
    let ways: Vec<DVec3> = fibres.iter().map(|fibre| (fibre[3] - fibre[0]).normalize_or_zero()).collect();
    let squares: DVec3 = ways.iter().map(|way| *way * *way).sum::<DVec3>() / ways.len() as f64;
    assert!((squares - 1.0 / 3.0).abs().max_element() < 0.05, "{squares}");
}

#[test]
fn own_layouts_come_back_as_they_were_and_fit_other_boxes() {
    let drawn = laid("helix_right", &[]);
    let own = OwnPattern::new("Mine", "Twists.", &drawn, LOW, HIGH).unwrap();
    let text = serde_json::to_string(&own).unwrap();
    let read: OwnPattern = serde_json::from_str(&text).unwrap();
    assert_eq!(read, own);
    assert_eq!((read.title(), read.does()), ("Mine", "Twists."));
    for (a, b) in read.lay(LOW, HIGH).iter().flatten().zip(drawn.iter().flatten()) {
        assert!(a.distance(*b) < 1e-15, "{a} and {b}");
    }
    // Twice the box, twice the layout.
    for (a, b) in read.lay(2.0 * LOW, 2.0 * HIGH).iter().flatten().zip(drawn.iter().flatten()) {
        assert!(a.distance(2.0 * *b) < 1e-15, "{a} and {b}");
    }
}

#[test]
fn what_is_no_layout_is_refused_in_plain_words() {
    let line = vec![DVec3::ZERO, DVec3::Y];
    let own = |fibres: &[Polyline], max: DVec3| OwnPattern::new("", "", fibres, DVec3::ZERO, max);
    assert_eq!(own(&[], DVec3::ONE), Err(PatternError::Empty));
    assert_eq!(own(&[line.clone(), vec![DVec3::X]], DVec3::ONE), Err(PatternError::Short { fibre: 1, vertices: 1 }));
    assert_eq!(own(&[vec![DVec3::NAN; 2]], DVec3::ONE), Err(PatternError::NotFinite { fibre: 0 }));
    assert_eq!(own(std::slice::from_ref(&line), DVec3::X), Err(PatternError::Flat));
    let said =
        serde_json::from_str::<OwnPattern>(r#"{"title": "a", "fibres": [[[0, 0, 0]]]}"#).unwrap_err().to_string();
    assert!(said.contains("fibre 0 of the pattern has 1 vertices; it needs 2 or more"), "{said}");
    // What sticks out is brought to the faces.
    let out = own(&[vec![DVec3::splat(-3.0), DVec3::splat(3.0)]], DVec3::ONE).unwrap();
    assert_eq!(out.lay(DVec3::ZERO, DVec3::ONE), [vec![DVec3::ZERO, DVec3::ONE]]);
}

#[test]
fn what_fibres_do_is_kept_with_a_layout_and_what_none_can_do_is_refused() {
    let worm = Pattern::by_id("worm").unwrap();
    let lines = worm.lay(&[], LOW, HIGH);
    let mut acts = worm.acts(&[0.4, 2.0, -1.5], lines.len());
    assert_eq!(acts.len(), 4);
    acts[3] = None;
    let own = OwnPattern::new("Mine", "", &lines, LOW, HIGH).unwrap();
    let acting = own.clone().with_acts(acts.clone()).unwrap();
    let read: OwnPattern = serde_json::from_str(&serde_json::to_string(&acting).unwrap()).unwrap();
    assert_eq!(read.acts(), acts);
    let below = read.acts()[0].as_ref().unwrap();
    assert_eq!((below.contract, below.period, below.waves), (0.4, 2.0, -1.5));
    // Those that only resist say nothing of it.
    assert!(!serde_json::to_string(&own).unwrap().contains("acts"));
    assert_eq!(own.clone().with_acts(vec![None; 4]).unwrap(), own);
    let still = acts[0].clone().map(|act| Act { period: 0.0, ..act });
    assert_eq!(own.with_acts(vec![None, still]), Err(PatternError::Act { fibre: 1 }));
}

/// Particles 4 mm apart in a box of 0.1 x 0.14 x 0.1 m, where `is_in` says so.
fn lattice(is_in: impl Fn(DVec3) -> bool) -> Vec<DVec3> {
    let at = |k: u32| {
        let [x, y, z] = [k % 25, k / 25 % 35, k / 875].map(f64::from);
        4e-3 * (DVec3::new(x, y, z) - DVec3::new(12.0, 17.0, 12.0))
    };
    (0..25 * 35 * 25).map(at).filter(|at| is_in(*at)).collect()
}

#[test]
fn a_layout_goes_as_far_into_a_solid_as_it_needs_to() {
    let half = DVec3::new(0.05, 0.07, 0.05);
    let (full, round) = (lattice(|_| true), lattice(|at| (at / half).length() < 1.0));
    for pattern in &PATTERNS {
        let values = pattern.defaults();
        let plain = pattern.lay(&values, -half, half);
        let laid = pattern.lay_into(&values, [-half, half], &full);
        assert_eq!((&laid.fibres, laid.further_in, laid.outside), (&plain, None, 0), "{}", pattern.id);
        // What is round leaves the corners of its box empty.
        let laid = pattern.lay_into(&values, [-half, half], &round);
        let far = |fibres: &[Polyline]| fibres.iter().flatten().map(|at| (*at / half).length()).fold(0.0, f64::max);
        assert!(laid.outside == 0 && far(&laid.fibres) < 1.06, "{}: {}", pattern.id, far(&laid.fibres));
        assert_eq!(laid.further_in.is_some(), far(&plain) > far(&laid.fibres), "{}", pattern.id);
        // Nothing is known of a solid without particles.
        assert_eq!(pattern.lay_into(&values, [-half, half], &[]).fibres, plain);
    }
    // Where nothing holds all of them, it is told.
    let speck = lattice(|at| at.distance(half) < 0.02);
    let worm = PATTERNS.iter().find(|pattern| pattern.id == "worm").expect("a worm");
    let laid = worm.lay_into(&worm.defaults(), [-half, half], &speck);
    assert!(laid.outside > 0 && laid.fibres.len() == 4, "{laid:?}");
}

proptest! {
    #[test]
    fn every_fibre_lies_inside_by_the_margin(
        which in 0..PATTERNS.len(),
        values in prop::collection::vec(-20.0..600.0_f64, 0..6),
        low in prop::array::uniform3(-2.0..2.0_f64),
        size in prop::array::uniform3(0.01..3.0_f64),
        margin in 0.02..0.4_f64,
    ) {
        let pattern = &PATTERNS[which];
        let mut values = values;
        let last = pattern.parameters.len() - 1;
        values.truncate(last);
        values.extend(pattern.defaults().into_iter().skip(values.len()));
        values[last] = margin;
        let (low, size) = (DVec3::from_array(low), DVec3::from_array(size));
        let fibres = pattern.lay(&values, low, low + size);
        prop_assert!(!fibres.is_empty());
        let free = margin * size.min_element() - 1e-12;
        for fibre in &fibres {
            prop_assert!(fibre.len() >= 3);
            for at in fibre {
                prop_assert!((*at - low).min_element() >= free && (low + size - *at).min_element() >= free, "{at}");
            }
            // No two vertices in one place.
            prop_assert!(fibre.windows(2).all(|pair| pair[0].distance(pair[1]) > 0.0), "{}", pattern.id);
        }
    }
}
