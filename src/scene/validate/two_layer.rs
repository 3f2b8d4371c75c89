//! Checks of the two-layer bodies.

use super::SceneError;
use super::check::{At, Checked, Ids, finite, not_negative, number, ordered, positive, require, vector};
use super::drives;
use super::follows::follows;
use super::parts::{impulses, initial, model_file, pins, placement, regions};
use super::solid::too_many;
use crate::scene::{Drive, InnerOffset, MAX_PARTICLES, Region, Selector, TwoLayer, TwoLayerShape};

/// More subdivisions of the octahedron than this are refused.
const MOST_SUBDIVISIONS: u32 = 5;

/// More sides of a ring than this are refused: its steps get shorter with each.
const MOST_SIDES: u32 = 20_000;

/// Checks a two-layer body but for its identifier. `before` are the particles of the bodies before it; gives those with
/// its own.
pub(super) fn two_layer(at: &At<'_>, body: &TwoLayer, before: f64) -> Result<f64, SceneError> {
    shape(&at.field("shape"), &body.shape)?;
    // Those of a mesh are counted when it is read.
    let particles = before + body.about_particles(None).unwrap_or_default();
    let (problem, few) = (too_many(particles), || "give fewer sides or subdivisions, or take bodies away");
    require(&at.field("shape"), &body.title(), particles <= MAX_PARTICLES as f64, &problem, few)?;
    rest(at, body)?;
    Ok(particles)
}

fn rest(at: &At<'_>, body: &TwoLayer) -> Checked {
    placement(&at.field("placement"), &body.placement)?;
    parameters(at, body)?;
    initial(&at.field("initial"), &body.initial)?;
    let known = known_regions(at, body)?;
    for (index, of) in body.masses.iter().enumerate() {
        let at = at.field("masses");
        let at = at.item(index);
        known.resolve(&at.field("region"), &of.region)?;
        positive(&at.field("mass"), of.mass, "kg")?;
    }
    impulses(at, &body.impulses, &known)?;
    drives::shared(at, &body.drives)?;
    let mut ids = Ids::of("active spring");
    for (index, of) in body.active_springs.iter().enumerate() {
        let at = at.field("active_springs");
        let at = at.item(index);
        ids.add(&at.field("id"), &of.id)?;
        known.resolve(&at.field("region"), &of.region)?;
        drives::still(&at.field("drive"), &of.drive, &body.drives)?;
        let range = of.drive.resolved(&body.drives).and_then(Drive::range).unwrap_or([0.0; 2]);
        drives::share(&at.field("contract"), of.contract, "springs shorter by {} of their length", range)?;
    }
    pins(at, &body.pins, &known, &body.drives)?;
    follows(&at.field("follows"), &body.follows, &known)?;
    for (index, grab) in body.grabs.iter().enumerate() {
        let at = at.field("drags");
        let at = at.item(index);
        vector(&at.field("target"), &grab.target, "m")?;
        grab.until.map_or(Ok(()), |until| finite(&at.field("until"), until, "s"))?;
    }
    Ok(())
}

fn shape(at: &At<'_>, shape: &TwoLayerShape) -> Checked {
    match shape {
        TwoLayerShape::Segment(segment) => positive(&at.field("segment").field("length"), segment.length, "m"),
        TwoLayerShape::Ring(ring) => {
            let at = at.field("ring");
            let possible = (3..=MOST_SIDES).contains(&ring.sides);
            require(&at.field("sides"), &ring.sides, possible, "sides make no polygon that fits", || {
                format!("give 3 to {MOST_SIDES}")
            })?;
            radii(&at, ring.outer_radius, ring.inner_radius, ring.single_layer)
        }
        TwoLayerShape::Ball(ball) => {
            let at = at.field("ball");
            let possible = ball.subdivisions <= MOST_SUBDIVISIONS;
            require(&at.field("subdivisions"), &ball.subdivisions, possible, "subdivisions are too many", || {
                format!("give 0 to {MOST_SUBDIVISIONS}")
            })?;
            radii(&at, ball.outer_radius, ball.inner_radius, ball.single_layer)
        }
        TwoLayerShape::Mesh(mesh) => {
            let at = at.field("mesh");
            model_file(&at, mesh.into())?;
            let at = at.field("inner_offset");
            // Whether the offset fits is a matter of the mesh, which is not in the document: baking finds out.
            match mesh.inner_offset {
                InnerOffset::Metres(metres) => positive(&at.field("metres"), metres, "m"),
                InnerOffset::Fraction(share) => {
                    let at = at.field("fraction");
                    positive(&at, share, "of half the least extent")?;
                    require(&at, &share, share < 1.0, "leaves no room inside", || "give a number below 1")
                }
            }
        }
    }
}

fn radii(at: &At<'_>, outer: f64, inner: f64, single: bool) -> Checked {
    positive(&at.field("outer_radius"), outer, "m")?;
    if single {
        return Ok(());
    }
    positive(&at.field("inner_radius"), inner, "m")?;
    ordered(&at.field("outer_radius"), inner, outer, &format!("inner_radius ({} m)", number(inner)))
}

fn parameters(at: &At<'_>, body: &TwoLayer) -> Checked {
    positive(&at.field("ks"), body.ks, "N/m")?;
    for (name, value, unit) in [
        ("kd", body.kd, "N s/m"),
        ("rks", body.rks, "N/m"),
        ("rkd", body.rkd, "N s/m"),
        ("mks", body.mks, "N/m"),
        ("mkd", body.mkd, "N s/m"),
        ("pressure", body.pressure, "J"),
        ("air_drag", body.air_drag, "1/s"),
    ] {
        not_negative(&at.field(name), value, unit)?;
    }
    if let Some(drive) = &body.pressure_drive {
        drives::not_below_zero(&at.field("pressure_drive"), drive, &body.drives)?;
    }
    positive(&at.field("mass"), body.mass, "kg")?;
    body.inner_mass.map_or(Ok(()), |mass| positive(&at.field("inner_mass"), mass, "kg"))?;
    let at = at.field("contact");
    positive(&at.field("kc"), body.contact.kc, "N/m")?;
    not_negative(&at.field("cc"), body.contact.cc, "N s/m")?;
    not_negative(&at.field("ct"), body.contact.ct, "N s/m")
}

/// The regions of a body, its own and those that each has.
pub(super) fn known_regions<'a>(at: &At<'_>, body: &'a TwoLayer) -> Result<Ids<'a>, SceneError> {
    let mut known = Ids::of("region");
    for id in TwoLayer::REGIONS {
        known.add(at, id)?;
    }
    regions(at, &body.regions, &mut known)?;
    body.regions.iter().enumerate().try_for_each(|(index, region)| no_layers(at, index, region))?;
    Ok(known)
}

fn no_layers(at: &At<'_>, index: usize, region: &Region) -> Checked {
    let off_lattice = !matches!(region.select, Selector::Layers { .. });
    let at = at.field("regions");
    require(
        &at.item(index).field("select"),
        &region.select,
        off_lattice,
        "counts layers of a lattice",
        || "choose by a box or a sphere: a two-layer body has no lattice",
    )
}
