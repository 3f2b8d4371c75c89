//! A scene and a snapshot of its world become a draw list.

use super::body_drawer::BodyDrawer;
use super::cut_face::cut_face;
use super::fibre::FibreShape;
use super::list::{DrawList, Faces, Mesh, PickKind, SkinnedFaces, SurfaceStyle};
use super::options::{Display, SkinStyle};
use super::surroundings;
use super::{Bounds, Colour, Theme, colour_map};
use crate::scene::{AnyBody, Fibre, Scene, Sheet};
use crate::solver::snapshot::{BodySnapshot, Snapshot};
use glam::{DVec3, Vec3};
use std::sync::Arc;

/// What is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The document.
    pub scene: &'a Scene,
    /// A state of its world; its bodies are those of the scene, in order.
    pub snapshot: &'a Snapshot,
    /// Another state, shown as a pale shape: where everything began, or would be.
    pub ghost: Option<&'a Snapshot>,
}

/// Everything that is to be seen.
pub fn draw(subject: &Subject<'_>, display: &Display, theme: &Theme) -> DrawList {
    let Subject { scene, snapshot, ghost } = *subject;
    let bounds = surroundings::bounds(scene, snapshot);
    let origin = bounds.map_or(DVec3::ZERO, |bounds| bounds.center());
    let mut list = DrawList::new(origin, surroundings::ground(scene, display), *theme);
    list.bounds = bounds;
    list.slice = display.slice;
    // Fibres are numbered through all bodies, so that no two in sight share a hue.
    let mut hue = 0;
    for (index, body) in snapshot.bodies.iter().enumerate() {
        let number = display.first_body + index;
        let drawer = BodyDrawer { index: index as u32, spacing: spacing(scene, number, body), display, theme };
        let looks = Looks::of(scene, number);
        if looks.hidden {
            hue += body.fibres.len() + body.sheets.len();
            continue;
        }
        let values = snapshot.field.as_ref().and_then(|field| Some((field.range, field.bodies.get(index)?.as_slice())));
        let values = values.filter(|(_, values)| values.len() == body.particles.len());
        let tensions = snapshot.tension.as_ref();
        let tensions = tensions.and_then(|tension| Some((tension.range, tension.bodies.get(index)?.as_slice())));
        let activations = snapshot.activation.as_ref().and_then(|of| of.bodies.get(index)).map(Vec::as_slice);
        drawer.body(body, &looks, Values { field: values, tensions, activations }, &mut list, &mut hue);
        if let (true, Some(body)) = (display.strokes, scene.bodies.get(number)) {
            surroundings::strokes(body, &mut list);
        }
    }
    let ghosts = ghost.iter().flat_map(|ghost| ghost.bodies.iter().enumerate());
    for (_, body) in ghosts.filter(|(index, _)| !Looks::of(scene, display.first_body + index).hidden) {
        let mesh = skin_mesh(&list, body, SurfaceStyle::Faint);
        list.meshes.extend(mesh.map(|mesh| Mesh { colour: theme.ghost, casts_shadow: false, ..mesh }));
    }
    surroundings::panels(scene, snapshot, &mut list);
    surroundings::colliders(snapshot, &mut list);
    if display.room {
        surroundings::walls(scene, &mut list);
    }
    list
}

/// Particle spacing D [m]; for a body that the document does not have (any more), what its particles fill.
fn spacing(scene: &Scene, index: usize, body: &BodySnapshot) -> f64 {
    if let Some(body) = scene.bodies.get(index) {
        return body.material.spacing();
    }
    let radius = Bounds::of(body.particles.iter().copied()).map_or(1.0, |bounds| bounds.radius());
    radius / (body.particles.len().max(1) as f64).cbrt()
}

/// The skin of a body as a mesh that nothing picks; none where it has none or is no longer made of numbers.
fn skin_mesh(list: &DrawList, body: &BodySnapshot, surface: SurfaceStyle) -> Option<Mesh> {
    let rig = body.rig()?;
    if rig.triangles.is_empty() || body.particles.iter().any(|point| !point.is_finite()) {
        return None;
    }
    let mut particles: Vec<Vec3> = body.particles.iter().map(|&point| list.local(point)).collect();
    // They have no place that the list's origin could be taken from.
    particles.extend(body.directions().into_iter().map(DVec3::as_vec3));
    let faces = Faces::Skinned(SkinnedFaces { rig: Arc::clone(rig), particles });
    Some(Mesh { faces, colour: list.theme.skin, tints: Vec::new(), surface, casts_shadow: true, pick: 0 })
}

/// How the document wants a body to be drawn.
#[derive(Default)]
struct Looks<'a> {
    hidden: bool,
    color: Option<[u8; 3]>,
    fibres: &'a [Fibre],
    sheets: &'a [Sheet],
}

impl<'a> Looks<'a> {
    /// Looks of the body with this number in the snapshot: solids first, then two-layer bodies.
    fn of(scene: &'a Scene, index: usize) -> Self {
        let looks = |body: AnyBody<'a>| Self {
            hidden: body.hidden(),
            color: body.color(),
            fibres: body.fibres(),
            sheets: body.sheets(),
        };
        scene.any_body(index).map_or_else(Self::default, looks)
    }

    fn fibre(&self, id: &str) -> Option<&Fibre> {
        self.fibres.iter().find(|fibre| fibre.id == id)
    }
}

/// Values that colours stand for, with their ranges.
struct Values<'a> {
    /// At every particle.
    field: Option<([f64; 2], &'a [f64])>,
    /// At every edge of every fibre [N].
    tensions: Option<(f64, &'a [Vec<f64>])>,
    /// At every edge of every fibre: its drive, and by what share that has it want to be shorter.
    activations: Option<&'a [Vec<[f64; 2]>]>,
}

impl BodyDrawer<'_> {
    fn body(
        &self,
        body: &BodySnapshot,
        looks: &Looks<'_>,
        Values { field, tensions, activations }: Values<'_>,
        list: &mut DrawList,
        hue: &mut usize,
    ) {
        let mut has_skin = false;
        // Colours that stand for values can be told from each other only where nothing shines through them.
        let clear = self.display.skin == SkinStyle::XRay && field.is_none();
        let surface = if clear { SurfaceStyle::XRay } else { SurfaceStyle::Solid };
        if let (true, Some(mut mesh)) = (self.display.skin != SkinStyle::Hidden, skin_mesh(list, body, surface)) {
            mesh.pick = self.number(PickKind::Skin, 1, list);
            mesh.colour = self.tint().or(looks.color.map(Colour::from_rgb)).unwrap_or(mesh.colour);
            if let (Some((range, values)), Some(rig)) = (field, body.rig()) {
                mesh.tints = colour_map::over(rig, values, range);
            }
            let opened = if clear { None } else { cut_face(body, &mesh, self.spacing, field, list) };
            list.meshes.push(mesh);
            list.meshes.extend(opened);
            has_skin = true;
        }
        for (index, fibre) in body.fibres.iter().enumerate() {
            let own = looks.fibre(&fibre.id);
            let colour = own.and_then(|own| own.color).map_or_else(|| self.theme.fibre(*hue), Colour::from_rgb);
            *hue += 1;
            if !own.is_some_and(|own| own.hidden) {
                let tensions = tensions.and_then(|(range, fibres)| Some((range, fibres.get(index)?.as_slice())));
                let breaks = body.breaks.iter().filter(|at| at.fibre as usize == index).map(|at| at.place).collect();
                let activations = activations.and_then(|fibres| fibres.get(index)).map(Vec::as_slice);
                let shape = FibreShape { vertices: &fibre.vertices, breaks, tensions, activations, colour };
                self.fibre(index as u32, &shape, [has_skin, clear], list);
            }
        }
        for (index, sheet) in body.sheets.iter().enumerate() {
            let own = looks.sheets.iter().find(|own| own.id == sheet.id);
            let colour = own.and_then(|own| own.color).map_or_else(|| self.theme.fibre(*hue), Colour::from_rgb);
            *hue += 1;
            if !own.is_some_and(|own| own.hidden) {
                self.sheet(index as u32, sheet, colour, [has_skin, clear], list);
            }
        }
        for element in &body.elements {
            self.element(element, [has_skin, clear], list);
        }
        self.particles(body, has_skin, field, list);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::snapshot::{FibreSnapshot, SkinEmbedding};

    const TRIANGLES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

    /// A tetrahedron with two fibres and four particles, far from home.
    fn snapshot() -> Snapshot {
        let at = DVec3::new(1e4, 0.5, -1e4);
        let body = BodySnapshot {
            name: "body".to_owned(),
            particles: vec![at, at + DVec3::X, at + DVec3::Y, at + DVec3::Z],
            fibres: ["a", "b"]
                .map(|id| FibreSnapshot { id: id.to_owned(), vertices: vec![at, at + 0.5 * DVec3::Y, at + DVec3::Y] })
                .to_vec(),
            skin: vec![at, at + DVec3::X, at + DVec3::Y, at + DVec3::Z],
            triangles: TRIANGLES.to_vec().into(),
            embedding: SkinEmbedding::of_particles(4, &TRIANGLES),
            ..BodySnapshot::default()
        };
        Snapshot { bodies: vec![body], ..Snapshot::default() }
    }

    fn drawn(snapshot: &Snapshot, display: &Display) -> DrawList {
        let scene = Scene::default();
        draw(&Subject { scene: &scene, snapshot, ghost: None }, display, &Theme::light())
    }

    fn picked(list: &DrawList, number: u32) -> Option<PickKind> {
        list.picks.find(number).map(|id| id.kind)
    }

    #[test]
    fn an_opaque_skin_hides_its_fibres_and_a_clear_one_shows_them() {
        let list = drawn(&snapshot(), &Display::default());
        assert_eq!((list.meshes.len(), list.meshes[0].surface), (1, SurfaceStyle::Solid));
        assert_eq!(picked(&list, list.meshes[0].pick), Some(PickKind::Skin));
        let list = drawn(&snapshot(), &Display::x_ray());
        assert_eq!(list.meshes.iter().filter(|mesh| mesh.surface == SurfaceStyle::XRay).count(), 1);
        let fibres: Vec<&Mesh> =
            list.meshes.iter().filter(|mesh| picked(&list, mesh.pick) == Some(PickKind::Fibre)).collect();
        assert_eq!(fibres.len(), 2);
        assert_ne!(fibres[0].colour, fibres[1].colour);
        assert!(list.points.is_empty());
    }

    #[test]
    fn figure_three_has_cool_particles_and_warm_structure_and_no_skin() {
        let list = drawn(&snapshot(), &Display::particles());
        assert!(list.meshes.iter().all(|mesh| picked(&list, mesh.pick) == Some(PickKind::Fibre)));
        let kinds: Vec<_> = list.points.iter().map(|set| picked(&list, set.pick + 1)).collect();
        let structure = |fibre| Some(PickKind::StructureVertex { fibre });
        assert_eq!(kinds, [structure(0), structure(1), Some(PickKind::Particle)]);
        let [warm, cool] = [list.points[0].colour, list.points[2].colour];
        assert!(warm.red > warm.blue && cool.blue > cool.red);
    }

    #[test]
    fn a_body_without_a_skin_shows_its_particles_and_a_broken_one_does_no_harm() {
        let mut bare = snapshot();
        bare.bodies[0].triangles = [].into();
        bare.bodies[0].embedding = SkinEmbedding::default();
        assert_eq!(drawn(&bare, &Display::default()).points.len(), 1);
        let mut broken = snapshot();
        broken.bodies[0].skin.fill(DVec3::NAN);
        broken.bodies[0].particles.fill(DVec3::NAN);
        broken.bodies[0].fibres[0].vertices.fill(DVec3::INFINITY);
        let list = drawn(&broken, &Display::x_ray());
        assert_eq!(list.bounds, None);
        assert!(
            list.meshes.iter().all(|mesh| mesh.faces.worked_out().0.iter().all(|vertex| vertex.position.is_finite()))
        );
        assert_eq!(drawn(&Snapshot::default(), &Display::default()).bounds, None);
    }

    #[test]
    fn positions_are_as_fine_far_away_as_at_home() {
        let list = drawn(&snapshot(), &Display::default());
        let reach =
            list.meshes[0].faces.worked_out().0.iter().map(|vertex| vertex.position.length()).fold(0.0, f32::max);
        assert!(reach < 1.0, "{reach}");
        assert!(list.bounds.unwrap().center().distance(list.origin) < 1e-6);
    }

    #[test]
    fn what_is_selected_is_thicker_and_marked() {
        let width = |selected: Vec<[u32; 2]>| {
            let list = drawn(&snapshot(), &Display { selected, ..Display::x_ray() });
            let fibre = list.meshes.iter().find(|mesh| picked(&list, mesh.pick) == Some(PickKind::Fibre)).unwrap();
            let (vertices, _) = fibre.faces.worked_out();
            let low = vertices.iter().map(|vertex| vertex.position.x).fold(f32::INFINITY, f32::min);
            let high = vertices.iter().map(|vertex| vertex.position.x).fold(f32::NEG_INFINITY, f32::max);
            (high - low, list.lines.len())
        };
        let (plain, chosen) = (width(vec![]), width(vec![[0, 0]]));
        assert!(chosen.0 > 1.3 * plain.0 && (plain.1, chosen.1) == (0, 1));
    }

    #[test]
    fn a_broken_fibre_is_two_tubes_with_one_number_and_a_red_ball() {
        use crate::solver::snapshot::{BreakPlace, FibreBreak};
        let mut broken = snapshot();
        let place = BreakPlace::Vertex(1);
        broken.bodies[0].breaks.push(FibreBreak { fibre: 1, place, time: 0.5 });
        for theme in [Theme::light(), Theme::dark()] {
            let scene = Scene::default();
            let list = draw(&Subject { scene: &scene, snapshot: &broken, ghost: None }, &Display::x_ray(), &theme);
            let tubes: Vec<u32> = list.meshes.iter().filter(|mesh| mesh.pick > 1).map(|mesh| mesh.pick).collect();
            assert!(tubes.len() == 3 && tubes[1] == tubes[2] && tubes[0] != tubes[1], "{tubes:?}");
            let [ball] = list.points.as_slice() else { panic!("{:?}", list.points) };
            let at = broken.bodies[0].fibres[1].vertices[1];
            assert_eq!((ball.centres.as_slice(), ball.colour), (&[list.local(at)][..], theme.broken));
            assert!(ball.through > 0.0 && ball.colour.red > 2.0 * ball.colour.blue.max(ball.colour.green));
        }
        assert!(drawn(&snapshot(), &Display::x_ray()).points.is_empty());
    }

    #[test]
    fn fibres_have_the_colours_of_what_they_carry() {
        use crate::solver::snapshot::TensionSnapshot;
        let mut pulled = snapshot();
        let bodies = vec![vec![vec![3.0, 3.0], vec![-3.0, -3.0]]];
        pulled.tension = Some(TensionSnapshot { range: 3.0, bodies });
        let list = drawn(&pulled, &Display::x_ray());
        let tints: Vec<[u8; 3]> = list.meshes.iter().filter(|mesh| mesh.pick > 1).map(|mesh| mesh.tints[0]).collect();
        assert_eq!(tints, [1.0, -1.0].map(|place| colour_map::bytes(colour_map::signed_colour(place))));
        assert!(drawn(&snapshot(), &Display::x_ray()).meshes.iter().all(|mesh| mesh.tints.is_empty()));
    }

    #[test]
    fn what_is_cut_away_is_neither_drawn_nor_numbered_otherwise() {
        let middle = snapshot().bodies[0].particles[0] + 0.5 * DVec3::Y;
        let slice = Some(crate::draw::Slice { axis: crate::scene::Axis::Y, at: middle.y, flipped: false });
        let list = drawn(&snapshot(), &Display { slice, ..Display::particles() });
        let particles = list.points.last().expect("particles");
        let seen: Vec<bool> = particles.centres.iter().map(|centre| centre.is_finite()).collect();
        assert_eq!(seen, [true, true, false, true], "only the third lies above");
        // An opaque skin that is cut open shows the fibres in it, through the face that the cut opens.
        let meshes = |display: &Display| drawn(&snapshot(), display).meshes.len();
        assert_eq!((meshes(&Display::default()), meshes(&Display { slice, ..Display::default() })), (1, 4));
    }

    #[test]
    fn a_ghost_is_pale_and_cannot_be_picked() {
        let (scene, snapshot) = (Scene::default(), snapshot());
        let subject = Subject { scene: &scene, snapshot: &snapshot, ghost: Some(&snapshot) };
        let list = draw(&subject, &Display::default(), &Theme::dark());
        let ghost = list.meshes.iter().find(|mesh| mesh.surface == SurfaceStyle::Faint).unwrap();
        assert_eq!((ghost.colour.alpha, ghost.pick, ghost.casts_shadow), (0.25, 0, false));
    }
}
