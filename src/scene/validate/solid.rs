//! Checks of the fibre solids: shape, material, fibres, paint.

use super::check::{At, Checked, Ids, fraction, not_negative, positive, require, vector, within};
use super::drives;
use super::elements::elements;
use super::follows::follows;
use super::lines::source;
use super::paint::paint;
use super::parts::{impulses, initial, model_file, pins, placement, regions, rotation};
use super::sheets::sheets;
use super::voids::voids;
use super::{SceneError, brief};
use crate::scene::{
    BYTES_PER_PARTICLE, Body, CapsuleShape, CylinderShape, Fibre, IntegratorChoice, IntegratorKind, MAX_PARTICLES,
    Mass, Material, MeshShape, Shape, Stiffness, TorusShape,
};

/// Range of D / h. Below it a particle has over 150 neighbours and costs more than it tells; above it fewer than
/// 20 are left, too few for a sound deformation gradient.
const SPACING_RATIO: (f64, f64) = (0.3, 0.6);

/// Greatest Poisson's ratio: at one half the material is incompressible and its stiffness infinite.
const MAX_POISSON: f64 = 0.49;

/// Fewest particles worth asking for: two along each axis.
const LEAST_PARTICLES: usize = 8;

/// Checks a fibre solid but for its identifier. `before` are the particles of the bodies before it; gives those with
/// its own.
pub(super) fn solid(at: &At<'_>, body: &Body, before: f64) -> Result<f64, SceneError> {
    shape(&at.field("shape"), &body.shape)?;
    placement(&at.field("placement"), &body.placement)?;
    material(&at.field("material"), &body.material)?;
    let particles = count(at, body, before)?;
    integrator(&at.field("integrator"), body)?;
    initial(&at.field("initial"), &body.initial)?;
    parts(at, body)?;
    Ok(particles)
}

/// Fibres that act, yield or resist twist cannot be stepped implicitly.
fn integrator(at: &At<'_>, body: &Body) -> Checked {
    let acts = body
        .fibres
        .iter()
        .any(|fibre| fibre.activation.is_some() || fibre.yields.is_some() || fibre.stiffness.twisting() > 0.0);
    let implicit = body.integrator == IntegratorChoice::Given(IntegratorKind::FibresImplicit);
    let problem = "cannot step a body with fibres that act, yield or resist twist";
    require(at, &body.integrator, !(acts && implicit), problem, || "give \"automatic\" or \"leap_frog\"")
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
        Shape::Ball(shape) => positive(&at.field("ball").field("radius"), shape.radius, "m"),
        Shape::Cylinder(CylinderShape { radius, height, .. }) => {
            positive(&at.field("cylinder").field("radius"), *radius, "m")?;
            positive(&at.field("cylinder").field("height"), *height, "m")
        }
        Shape::Capsule(CapsuleShape { radius, height, .. }) => {
            positive(&at.field("capsule").field("radius"), *radius, "m")?;
            positive(&at.field("capsule").field("height"), *height, "m")
        }
        Shape::Torus(TorusShape { radius, tube_radius, .. }) => {
            let at = at.field("torus");
            positive(&at.field("radius"), *radius, "m")?;
            positive(&at.field("tube_radius"), *tube_radius, "m")?;
            require(&at.field("tube_radius"), tube_radius, tube_radius < radius, "leaves the torus no hole", || {
                format!("give less than its radius of {} m", brief(radius))
            })
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
    not_negative(&damping.field("air"), material.damping.air, "1/s")?;
    if let Some(viscosity) = &material.viscosity {
        let at = at.field("viscosity");
        not_negative(&at.field("shear"), viscosity.shear, "Pa s")?;
        not_negative(&at.field("bulk"), viscosity.bulk, "Pa s")?;
    }
    if let Some(plasticity) = &material.plasticity {
        let at = at.field("plasticity");
        positive(&at.field("yield_stress"), plasticity.yield_stress, "Pa")?;
        not_negative(&at.field("hardening"), plasticity.hardening, "Pa")?;
        not_negative(&at.field("creep_time"), plasticity.creep_time, "s")?;
    }
    Ok(())
}

/// What is said of so many particles.
pub(super) fn too_many(particles: f64) -> String {
    let rounded = |value: f64| if value < 1e6 { format!("{value:.1}") } else { format!("{value:.1e}") };
    format!(
        "makes about {} million particles ({} GB of memory) where {:.0} million are allowed",
        rounded(particles * 1e-6),
        rounded(particles * BYTES_PER_PARTICLE * 1e-9),
        MAX_PARTICLES as f64 * 1e-6
    )
}

/// Particles of the bodies so far, this one included, as their volumes and spacings have it.
fn count(at: &At<'_>, body: &Body, before: f64) -> Result<f64, SceneError> {
    // The volume of a mesh is not in the document: what fills it is counted when it is read.
    let Some(own) = body.about_particles(None) else { return Ok(before) };
    let particles = before + own;
    let most = MAX_PARTICLES as f64;
    let problem = too_many(particles);
    let (material, material_at) = (&body.material, at.field("material"));
    if let Shape::Mesh(MeshShape { particles: Some(count), .. }) = &body.shape {
        let (shape_at, few) = (at.field("shape"), || "give fewer, or take bodies away");
        let mesh_at = shape_at.field("mesh");
        require(&mesh_at.field("particles"), count, particles <= most, &problem, few)?;
        return Ok(particles);
    }
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

/// What a body's regions are made of and what refers to them.
fn parts(at: &At<'_>, body: &Body) -> Checked {
    // In the order of the file impulses come first, but they refer to regions, which must be sound for that.
    let mut known = Ids::of("region");
    regions(at, &body.regions, &mut known)?;
    impulses(at, &body.impulses, &known)?;
    drives::shared(at, &body.drives)?;
    let mut fibres = Ids::of("fibre");
    for (index, one) in body.fibres.iter().enumerate() {
        let at = at.field("fibres");
        let at = at.item(index);
        fibres.add(&at.field("id"), &one.id)?;
        fibre(&at, one)?;
        if let Some(activation) = &one.activation {
            drives::activation(&at.field("activation"), (activation, one), &body.drives)?;
            if let Some(fraction) = activation.volume_fraction {
                let (at, problem) = (at.field("activation"), "changes the share of a matrix that flows or yields");
                let is_elastic = body.material.plasticity.is_none() && body.material.viscosity.is_none();
                require(
                    &at.field("volume_fraction"),
                    &fraction,
                    is_elastic,
                    problem,
                    || "leave this or the material's `plasticity` and `viscosity` out",
                )?;
            }
        }
    }
    sheets(&at.field("sheets"), body)?;
    elements(&at.field("elements"), &body.elements, &body.drives)?;
    paint(&at.field("paint"), &body.paint)?;
    voids(&at.field("voids"), &body.voids)?;
    region_materials(&at.field("region_materials"), body, &known)?;
    pins(at, &body.pins, &known, &body.drives)?;
    follows(&at.field("follows"), &body.follows, &known)
}

fn region_materials(at: &At<'_>, body: &Body, regions: &Ids<'_>) -> Checked {
    for (index, of) in body.region_materials.iter().enumerate() {
        let at = at.item(index);
        regions.resolve(&at.field("region"), &of.region)?;
        of.young_modulus.map_or(Ok(()), |value| positive(&at.field("young_modulus"), value, "Pa"))?;
        of.density.map_or(Ok(()), |value| positive(&at.field("density"), value, "kg/m³"))?;
        of.damping.map_or(Ok(()), |value| not_negative(&at.field("damping"), value, "1/s"))?;
        not_negative(&at.field("transition"), of.transition, "m")?;
    }
    Ok(())
}

fn fibre(at: &At<'_>, fibre: &Fibre) -> Checked {
    source(&at.field("source"), &fibre.source)?;
    let stiffness = at.field("stiffness");
    let (kind, values) = match &fibre.stiffness {
        Stiffness::Rigidity(of) => ("rigidity", vec![("ea", of.ea, "N"), ("ei", of.ei, "N m²"), ("gj", of.gj, "N m²")]),
        Stiffness::Paper(of) => ("paper", vec![("kb", of.kb, ""), ("ks", of.ks, "")]),
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
    if let Some(past) = &fibre.yields {
        let at = at.field("yield");
        if let Some(tension) = past.tension {
            positive(&at.field("tension"), tension, "N")?;
        }
        if let Some(curvature) = past.curvature_degrees_per_metre {
            positive(&at.field("curvature_degrees_per_metre"), curvature, "degrees/m")?;
        }
        let is_still = fibre.activation.is_none();
        require(
            &at,
            past,
            is_still,
            "is of a fibre that acts, which cannot yield",
            || "leave this or its activation out",
        )?;
    }
    fraction(&at.field("volume_fraction"), fibre.volume_fraction)
}
