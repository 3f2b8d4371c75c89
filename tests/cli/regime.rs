//! Values that no solid has, or for which small strains do not hold, are warned of; sane ones are not.

use super::{Desk, pressed};

/// What is warned of in the material of the pressed block, which is 0.036 m high along y and 0.024 m wide, of
/// 1852 kg/m³ and 1e4 Pa, with these values set.
fn said(sets: &[&str]) -> Vec<String> {
    let desk = Desk::new(&pressed());
    let sets: Vec<&str> =
        ["check", "scene.json"].into_iter().chain(sets.iter().flat_map(|set| ["--set", set])).collect();
    let said = desk.run(&sets.join(" "));
    assert_eq!(said.code, Some(0), "{sets:?}: {said:?}");
    let of_material = |line: &&str| line.starts_with("warning: /bodies/0/material/");
    said.err.lines().filter(of_material).map(str::to_owned).collect()
}

const MODULUS: &str = "/bodies/0/material/young_modulus";
const MASS: &str = "/bodies/0/material/mass";
const FALLING: &str = "/gravity=[0,-9.81,0]";

#[test]
fn a_sane_scene_is_silent() {
    let sane: [&[&str]; 5] = [
        &[],
        &[FALLING],
        &["/bodies/0/initial={\"velocity\":[2,0,0]}"],
        &["/bodies/0/material/young_modulus=10"],
        &["/bodies/0/material/mass={\"density\":20000}"],
    ];
    assert_eq!(Desk::new(&pressed()).run("check scene.json").err, "");
    for sets in sane {
        assert_eq!(said(sets), Vec::<String>::new(), "{sets:?}");
    }
}

#[test]
fn a_modulus_that_no_solid_has_is_warned_of() {
    for (value, told) in [
        ("1", "1.000 Pa is less than any solid has (10.00 Pa); is it meant in pascals?"),
        ("2e12", "2.000e12 Pa is more than any solid has (1.300e12 Pa); is it meant in pascals?"),
    ] {
        let said = said(&[&format!("{MODULUS}={value}")]);
        assert_eq!(said, [format!("warning: {MODULUS}: {told}")]);
    }
}

#[test]
fn a_density_that_no_solid_has_is_warned_of() {
    for (value, told) in [
        ("{\"density\":0.05}", "the body has 0.05000 kg/m³, less than any solid (0.1000 kg/m³)"),
        ("{\"density\":1e6}", "the body has 1.000e6 kg/m³, more than any solid (23000 kg/m³)"),
        ("{\"per_particle\":1e-13}", "the body has 4.630e-7 kg/m³, less than any solid (0.1000 kg/m³)"),
    ] {
        let said = said(&[&format!("{MASS}={value}")]);
        assert_eq!(said, [format!("warning: {MASS}: {told}; is it meant in kilograms and metres?")]);
    }
}

#[test]
fn a_body_that_its_weight_crushes_is_warned_of_by_how_high_it_stands() {
    // 1852 kg/m³ x 9.81 m/s² x 0.036 m are 654 Pa.
    let soft = format!("{MODULUS}=600");
    let crushed = said(&[FALLING, &soft]);
    let told =
        "the body's own weight strains it by about 109.0 %: it cannot stand; strains of a few per cent are meant";
    assert_eq!(crushed, [format!("warning: {MODULUS}: {told}")]);
    // On its side it is 0.024 m high, and under half of the pull it is lighter.
    let lying = "/bodies/0/placement={\"rotation\":{\"axis\":[0,0,1],\"degrees\":90}}";
    for other in [&[FALLING, &soft, lying] as &[&str], &["/gravity=[0,-4.9,0]", &soft], &[&soft]] {
        assert_eq!(said(other), Vec::<String>::new(), "{other:?}");
    }
}

#[test]
fn a_body_that_is_faster_than_its_waves_is_warned_of() {
    let said = said(&["/bodies/0/initial={\"velocity\":[0,-3,0]}"]);
    let told = "the body starts at 3.000 m/s, faster than waves run in it (2.324 m/s): whatever it strikes crushes it";
    assert_eq!(said, [format!("warning: {MODULUS}: {told}")]);
}
