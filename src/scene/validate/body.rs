//! Checks of the bodies: shape, material, regions, pins, fibres.

use super::brief;
use super::check::{
    At, Checked, Ids, direction, finite, fraction, increasing, not_negative, number, positive, require, vector, within,
};
use crate::geometry::lattice::points_looked_at;
use crate::scene::{
    Body, Dab, Distance, Fibre, FibreSource, Impulse, Initial, MAX_DABS, MAX_PARTICLES, Mass, Material, ModelFile,
    Motion, Pin, Region, Rotation, Selector, Shape, Stiffness, ViewStroke,
};
use glam::{DMat3, DVec3};

/// Range of D / h. Below it a particle has over 150 neighbours and costs more than it tells; above it fewer than
/// 20 are left, too few for a sound deformation gradient.
const SPACING_RATIO: (f64, f64) = (0.3, 0.6);

/// Greatest Poisson's ratio: at one half the material is incompressible and its stiffness infinite.
const MAX_POISSON: f64 = 0.49;

/// Fewest particles worth asking for: two along each axis.
const LEAST_PARTICLES: usize = 8;

/// Memory that a material particle takes with its neighbours [bytes].
const BYTES_PER_PARTICLE: f64 = 2500.0;

pub(super) fn bodies(at: &At<'_>, bodies: &[Body]) -> Checked {
    let mut ids = Ids::of("body");
    let mut particles = 0.0;
    for (index, body) in bodies.iter().enumerate() {
        let at = at.item(index);
        ids.add(&at.field("id"), &body.id)?;
        shape(&at.field("shape"), &body.shape)?;
        let placement = at.field("placement");
        vector(&placement.field("translation"), &body.placement.translation, "m")?;
        rotation(&placement.field("rotation"), &body.placement.rotation)?;
        material(&at.field("material"), &body.material)?;
        particles = count(&at, body, particles)?;
        initial(&at.field("initial"), &body.initial)?;
        parts(&at, body)?;
    }
    Ok(())
}

fn shape(at: &At<'_>, shape: &Shape) -> Checked {
    match shape {
        Shape::Box(shape) => {
            let at = at.field("box");
            vector(&at.field("center"), &shape.center, "m")?;
            for (axis, &size) in shape.size.iter().enumerate() {
                positive(&at.field("size").item(axis), size, "m")?;
            }
            rotation(&at.field("lattice_rotation"), &shape.lattice_rotation)
        }
        Shape::Mesh(shape) => {
            let at = at.field("mesh");
            model_file(&at, shape.into())?;
            let Some(count) = shape.particles else { return Ok(()) };
            let possible = (LEAST_PARTICLES..=MAX_PARTICLES).contains(&(count as usize));
            require(&at.field("particles"), &count, possible, "is no number of particles to fill a mesh with", || {
                format!("give {LEAST_PARTICLES} to {MAX_PARTICLES}")
            })
        }
    }
}

pub(super) fn model_file(at: &At<'_>, file: ModelFile<'_>) -> Checked {
    require(
        &at.field("path"),
        &file.path,
        !file.path.trim().is_empty(),
        "names no file",
        || "name an OBJ, STL, PLY, glTF or GLB file, relative to the scene file",
    )?;
    positive(&at.field("scale"), file.scale, "m")
}

pub(super) fn rotation(at: &At<'_>, rotation: &Rotation) -> Checked {
    direction(&at.field("axis"), &rotation.axis)?;
    finite(&at.field("degrees"), rotation.degrees, "degrees")
}

fn material(at: &At<'_>, material: &Material) -> Checked {
    positive(&at.field("young_modulus"), material.young_modulus, "Pa")?;
    within(&at.field("poisson_ratio"), material.poisson_ratio, 0.0, MAX_POISSON, "")?;
    let mass = at.field("mass");
    match material.mass {
        Mass::Density(density) => positive(&mass.field("density"), density, "kg/m³")?,
        Mass::PerParticle(mass_each) => positive(&mass.field("per_particle"), mass_each, "kg")?,
    }
    positive(&at.field("support_radius"), material.support_radius, "m")?;
    let (least, most) = SPACING_RATIO;
    within(&at.field("spacing_ratio"), material.spacing_ratio, least, most, "times the support radius")?;
    let damping = at.field("damping");
    not_negative(&damping.field("pair"), material.damping.pair, "1/s")?;
    not_negative(&damping.field("air"), material.damping.air, "1/s")
}

/// Particles of the bodies so far, this one included, as their volumes and spacings have it.
fn count(at: &At<'_>, body: &Body, before: f64) -> Result<f64, crate::scene::SceneError> {
    // The volume of a mesh is not in the document: baking counts its particles.
    let Shape::Box(shape) = &body.shape else { return Ok(before) };
    let material = &body.material;
    let turn = &shape.lattice_rotation;
    let axes = if turn.degrees == 0.0 {
        DMat3::IDENTITY
    } else {
        let axis = DVec3::from_array(turn.axis).normalize_or(DVec3::Y);
        DMat3::from_axis_angle(axis, turn.degrees.to_radians())
    };
    let particles = before + points_looked_at(DVec3::from_array(shape.size), material.spacing(), axes);
    let most = MAX_PARTICLES as f64;
    let rounded = |value: f64| if value < 1e6 { format!("{value:.1}") } else { format!("{value:.1e}") };
    let problem = format!(
        "makes about {} million particles ({} GB of memory) where {:.0} million are allowed",
        rounded(particles * 1e-6),
        rounded(particles * BYTES_PER_PARTICLE * 1e-9),
        most * 1e-6
    );
    let material_at = at.field("material");
    let radius_at = material_at.field("support_radius");
    require(&radius_at, &material.support_radius, particles <= most, &problem, || {
        if before >= most * 0.5 {
            return "give the bodies larger support radii or make them smaller".to_owned();
        }
        // A little above the radius that would just do, so that three digits suffice.
        let radius = 1.01 * material.support_radius * ((particles - before) / (most - before)).cbrt();
        format!("give {radius:.2e} m or more, or make the body smaller")
    })?;
    Ok(particles)
}

pub(super) fn initial(at: &At<'_>, initial: &Initial) -> Checked {
    vector(&at.field("velocity"), &initial.velocity, "m/s")?;
    vector(&at.field("angular_velocity"), &initial.angular_velocity, "degrees/s")?;
    let at = at.field("deformation");
    for (row, components) in initial.deformation.iter().enumerate() {
        vector(&at.item(row), components, "")?;
    }
    let [a, b, c] = initial.deformation.map(DVec3::from);
    require(
        &at,
        &initial.deformation,
        a.cross(b).dot(c) > 0.0,
        "turns the body inside out or flattens it",
        || "give three rows of positive determinant, such as [[1,0,0],[0,1,0],[0,0,1]]",
    )
}

/// What a body's regions are made of and what refers to them.
fn parts(at: &At<'_>, body: &Body) -> Checked {
    // In the order of the file impulses come first, but they refer to regions, which must be sound for that.
    let mut known = Ids::of("region");
    regions(at, &body.regions, &mut known)?;
    impulses(at, &body.impulses, &known)?;
    let mut fibres = Ids::of("fibre");
    for (index, one) in body.fibres.iter().enumerate() {
        let at = at.field("fibres");
        let at = at.item(index);
        fibres.add(&at.field("id"), &one.id)?;
        fibre(&at, one)?;
    }
    paint(&at.field("paint"), &body.paint)?;
    pins(at, &body.pins, &known)
}

fn paint(at: &At<'_>, paint: &[Dab]) -> Checked {
    require(at, &[(); 0], paint.len() <= MAX_DABS, &format!("has {} dabs", paint.len()), || {
        format!("give at most {MAX_DABS}, with larger radii")
    })?;
    for (index, dab) in paint.iter().enumerate() {
        let at = at.item(index);
        vector(&at.field("center"), &dab.center, "m")?;
        positive(&at.field("radius"), dab.radius, "m")?;
        fraction(&at.field("value"), dab.value)?;
        fraction(&at.field("strength"), dab.strength)?;
    }
    Ok(())
}

/// The regions of the body here, added to those that are known.
pub(super) fn regions<'a>(at: &At<'_>, regions: &'a [Region], known: &mut Ids<'a>) -> Checked {
    for (index, region) in regions.iter().enumerate() {
        let at = at.field("regions");
        let at = at.item(index);
        known.add(&at.field("id"), &region.id)?;
        selector(&at.field("select"), &region.select)?;
    }
    Ok(())
}

/// The impulses of the body here.
pub(super) fn impulses(at: &At<'_>, impulses: &[Impulse], regions: &Ids<'_>) -> Checked {
    for (index, impulse) in impulses.iter().enumerate() {
        let at = at.field("impulses");
        let at = at.item(index);
        regions.resolve(&at.field("region"), &impulse.region)?;
        vector(&at.field("impulse"), &impulse.impulse, "N s")?;
    }
    Ok(())
}

/// The pins of the body here.
pub(super) fn pins(at: &At<'_>, all: &[Pin], regions: &Ids<'_>) -> Checked {
    let mut ids = Ids::of("pin");
    for (index, one) in all.iter().enumerate() {
        let at = at.field("pins");
        let at = at.item(index);
        ids.add(&at.field("id"), &one.id)?;
        regions.resolve(&at.field("region"), &one.region)?;
        pin(&at, one)?;
    }
    Ok(())
}

fn selector(at: &At<'_>, selector: &Selector) -> Checked {
    match selector {
        Selector::Everything => Ok(()),
        Selector::Layers { count, .. } => {
            let at = at.field("layers");
            let possible = (1..=MAX_PARTICLES).contains(&(*count as usize));
            require(&at.field("count"), count, possible, "is no number of layers", || {
                format!("give 1 to {MAX_PARTICLES}")
            })
        }
        Selector::Box { min, max, .. } => {
            let at = at.field("box");
            vector(&at.field("min"), min, "m")?;
            vector(&at.field("max"), max, "m")?;
            for (axis, (least, greatest)) in min.iter().zip(max).enumerate() {
                let at = at.field("max");
                require(&at.item(axis), greatest, least <= greatest, "is below the least corner", || {
                    format!("give {} m or more", number(*least))
                })?;
            }
            Ok(())
        }
        Selector::Sphere { center, radius, .. } => {
            let at = at.field("sphere");
            vector(&at.field("center"), center, "m")?;
            positive(&at.field("radius"), *radius, "m")
        }
    }
}

fn fibre(at: &At<'_>, fibre: &Fibre) -> Checked {
    source(&at.field("source"), &fibre.source)?;
    let stiffness = at.field("stiffness");
    let (kind, values) = match &fibre.stiffness {
        Stiffness::Rigidity(of) => ("rigidity", [("ea", of.ea, "N"), ("ei", of.ei, "N m²")]),
        Stiffness::Paper(of) => ("paper", [("kb", of.kb, ""), ("ks", of.ks, "")]),
    };
    for (name, value, unit) in values {
        not_negative(&stiffness.field(kind).field(name), value, unit)?;
    }
    if let Some(past) = &fibre.break_past {
        let at = at.field("break_past");
        if let Some(angle) = past.angle {
            positive(&at.field("angle"), angle, "degrees")?;
            within(&at.field("angle"), angle, 0.0, 180.0, "degrees")?;
        }
        if let Some(tension) = past.tension {
            positive(&at.field("tension"), tension, "N")?;
        }
    }
    fraction(&at.field("volume_fraction"), fibre.volume_fraction)
}

fn source(at: &At<'_>, source: &FibreSource) -> Checked {
    match source {
        FibreSource::Vertices(vertices) => {
            let at = at.field("vertices");
            require(&at, vertices, vertices.len() >= 3, "has too few vertices to bend", || "give 3 or more")?;
            for (index, point) in vertices.iter().enumerate() {
                vector(&at.item(index), point, "m")?;
                let repeated = index > 0 && *point == vertices[index - 1];
                require(&at.item(index), point, !repeated, "repeats the vertex before it", || "leave one of them out")?;
            }
            Ok(())
        }
        FibreSource::Strokes(pair) => {
            let at = at.field("strokes");
            stroke(&at.field("first"), &pair.first)?;
            let second = at.field("second");
            stroke(&second, &pair.second)?;
            let (one, other) = (pair.first.view, pair.second.view);
            require(&second.field("view"), &other, one != other, "is the view of the first stroke too", || {
                format!("draw the second stroke in another view than {}", brief(&one))
            })
        }
    }
}

fn stroke(at: &At<'_>, stroke: &ViewStroke) -> Checked {
    let at = at.field("points");
    require(&at, &stroke.points, stroke.points.len() >= 2, "is no line", || "give 2 points or more")?;
    let points = stroke.points.iter().enumerate();
    points.into_iter().try_for_each(|(index, point)| vector(&at.item(index), point, "m"))
}

fn pin(at: &At<'_>, pin: &Pin) -> Checked {
    require(
        &at.field("axes"),
        &pin.axes,
        !pin.axes.is_empty(),
        "holds the region along no axis",
        || "name an axis at least, such as [\"x\", \"y\", \"z\"]",
    )?;
    let at = at.field("motion");
    match &pin.motion {
        Motion::Fixed => Ok(()),
        Motion::Ramp(ramp) => {
            let at = at.field("ramp");
            direction(&at.field("direction"), &ramp.direction)?;
            let distance = at.field("distance");
            match ramp.distance {
                Distance::Metres(metres) => finite(&distance.field("metres"), metres, "m")?,
                Distance::Fraction(fraction) => finite(&distance.field("fraction"), fraction, "of the extent")?,
            }
            not_negative(&at.field("start"), ramp.start, "s")?;
            positive(&at.field("duration"), ramp.duration, "s")
        }
        Motion::Turn(turn) => {
            let at = at.field("turn");
            direction(&at.field("axis"), &turn.axis)?;
            turn.origin.map_or(Ok(()), |origin| vector(&at.field("origin"), &origin, "m"))?;
            finite(&at.field("degrees"), turn.degrees, "degrees")?;
            not_negative(&at.field("start"), turn.start, "s")?;
            positive(&at.field("duration"), turn.duration, "s")
        }
        Motion::Keyframes(keys) => {
            let at = at.field("keyframes");
            increasing(&at, keys.iter().map(|key| key.time))?;
            for (index, key) in keys.iter().enumerate() {
                vector(&at.item(index).field("offset"), &key.offset, "m")?;
            }
            Ok(())
        }
    }
}
