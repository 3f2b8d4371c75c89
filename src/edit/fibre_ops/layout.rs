//! Layouts of fibres, such as patterns give, as fibres of a body.

use super::edited::LEAST_VERTICES;
use crate::geometry::curve::{arc_length, resample};
use crate::scene::{Fibre, Material, Rigidity, Stiffness};
use glam::DVec3;
use std::f64::consts::PI;

/// A new fibre is this many times as stiff as the material that it displaces, so that its effect is plain.
pub const STIFFER: f64 = 10.0;
/// Share of the material that is fibre at the centre line of a new fibre.
pub const NEW_VOLUME_FRACTION: f64 = 0.5;
/// Bending stiffness of a new fibre over its axial rigidity, in particle spacings squared.
pub const BENDING: f64 = 0.02;

/// Axial rigidity [N] of the material that a fibre displaces.
pub fn displaced(material: &Material) -> f64 {
    material.young_modulus * 0.2 * PI * material.support_radius.powi(2)
}

/// A fibre so many times as stiff as the material that it displaces.
pub fn rigidity_of(material: &Material, times: f64) -> Rigidity {
    bending_rigidity(material, times, BENDING)
}

/// As [`rigidity_of`], with another bending stiffness over the axial rigidity, in particle spacings squared.
fn bending_rigidity(material: &Material, times: f64, bending: f64) -> Rigidity {
    let ea = round_to_two_figures(times * displaced(material));
    let ei = round_to_two_figures(bending * ea * material.spacing().powi(2));
    Rigidity::new(ea, ei)
}

/// Whether a fibre can be laid along a line without points that follow their like.
fn is_course(vertices: &[DVec3]) -> bool {
    vertices.len() >= 2 && vertices.iter().all(|vertex| vertex.is_finite())
}

/// Whether [`laid`] lays a fibre along a line.
pub(super) fn is_laid(line: &[DVec3]) -> bool {
    let mut vertices = line.to_vec();
    vertices.dedup();
    is_course(&vertices)
}

fn round_to_two_figures(value: f64) -> f64 {
    let scale = 10_f64.powf(value.log10().floor() - 1.0);
    (value / scale).round() * scale
}

/// What new fibres of a layout are called and how they bend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Called<'a> {
    /// How their identifiers begin.
    pub id: &'a str,
    /// What their names begin with.
    pub title: &'a str,
    /// Bending stiffness over axial rigidity, in particle spacings squared; usually [`BENDING`].
    pub bending: f64,
    /// Spacing of the body's particles [m].
    pub spacing: f64,
}

/// New fibres along `lines`, vertices in the model frame [m], as stiff along themselves as new fibres are in this
/// material, with a number in their names where they are several. Their identifiers are unlike those of `others`, the
/// fibres that stay in the body. Vertices lie as far apart as the particles at least: closer ones would only shrink the
/// time step. Lines of less than two different points are left out.
pub fn laid(called: Called<'_>, lines: &[Vec<DVec3>], material: &Material, others: &[Fibre]) -> Vec<Fibre> {
    let Called { id, title, bending, spacing } = called;
    let stiffness = Stiffness::Rigidity(bending_rigidity(material, STIFFER, bending));
    let taken = |id: &str| others.iter().any(|fibre| fibre.id == id);
    let mut numbers = (1..).map(|n| (n, format!("{id}-{n}"))).filter(|(_, id)| !taken(id));
    let mut fibres = Vec::new();
    for line in lines {
        let mut vertices = line.clone();
        vertices.dedup();
        if !is_course(&vertices) {
            continue;
        }
        let most = (arc_length(&vertices) / spacing) as usize + 1;
        let count = vertices.len().min(most).max(LEAST_VERTICES);
        if count != vertices.len() {
            vertices = resample(&vertices, count);
        }
        let Some((number, id)) = numbers.next() else { break };
        let name = if lines.len() == 1 && number == 1 { title.to_owned() } else { format!("{title} {number}") };
        fibres.push(
            Fibre::through(id, vertices)
                .with_name(name)
                .with_stiffness(stiffness.clone())
                .with_volume_fraction(NEW_VOLUME_FRACTION),
        );
    }
    fibres
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::FibreSource;

    #[test]
    fn laid_fibres_have_names_and_identifiers_of_their_own_and_vertices_enough() {
        let line = |x: f64| vec![DVec3::new(x, 0.0, 0.0), DVec3::new(x, 0.0, 0.0), DVec3::new(x, 0.07, 0.0)];
        let lines = [line(0.0), vec![DVec3::X], line(0.01), vec![DVec3::NAN, DVec3::X]];
        let called = Called { id: "ray", title: "Rays", bending: BENDING, spacing: 0.006 };
        let first = laid(called, &lines, &Material::default(), &[]);
        assert_eq!(first.iter().map(|fibre| fibre.id.as_str()).collect::<Vec<_>>(), ["ray-1", "ray-2"]);
        assert_eq!(first[1].name, "Rays 2");
        let FibreSource::Vertices(vertices) = &first[0].source else { panic!("vertices") };
        assert_eq!(vertices.len(), LEAST_VERTICES);
        // As many vertices as there is room for between particles, and no more.
        let fine: Vec<DVec3> = (0..=60).map(|k| DVec3::new(0.0, 0.001 * f64::from(k), 0.0)).collect();
        let FibreSource::Vertices(sparse) = &laid(called, &[fine], &Material::default(), &[])[0].source else {
            panic!("vertices")
        };
        assert_eq!((sparse.len(), sparse[10]), (11, [0.0, 0.06, 0.0]));
        let Stiffness::Rigidity(rigidity) = &first[0].stiffness else { panic!("a rod's") };
        assert_eq!(*rigidity, rigidity_of(&Material::default(), STIFFER));
        let second = laid(called, &lines, &Material::default(), &first);
        assert_eq!(second.iter().map(|fibre| fibre.id.as_str()).collect::<Vec<_>>(), ["ray-3", "ray-4"]);
        assert_eq!(laid(called, &[line(0.0)], &Material::default(), &[])[0].name, "Rays");
    }

    #[test]
    fn a_fibre_is_as_stiff_unless_told_otherwise_as_a_new_one_in_the_default_material() {
        assert_eq!(Stiffness::default(), Stiffness::Rigidity(rigidity_of(&Material::default(), STIFFER)));
    }
}
