//! Bodies of both kinds behind one view.
//!
//! Why. A file keeps fibre solids under `bodies` and two-layer bodies under `two_layer`. Whatever lists, steps, records
//! or draws bodies numbers them in one row: the solids first, then the two-layer bodies. This is that row.

use super::{
    Body, ColliderMesh, ColliderShape, Fibre, Follow, Impulse, Initial, IntegratorChoice, Leader, ModelFile, Pin,
    Placement, Region, Scene, Shape, SharedDrive, Sheet, TwoLayer, TwoLayerShape, VoidMesh, VoidShape,
};

/// A body of either kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyBody<'a> {
    /// A fibre solid.
    Solid(&'a Body),
    /// A two-layer body.
    TwoLayer(&'a TwoLayer),
}

/// A body of either kind, to be changed.
#[derive(Debug, PartialEq)]
pub enum AnyBodyMut<'a> {
    /// A fibre solid.
    Solid(&'a mut Body),
    /// A two-layer body.
    TwoLayer(&'a mut TwoLayer),
}

/// A body of either kind by itself.
#[derive(Clone, Debug, PartialEq)]
pub enum OwnedBody {
    /// A fibre solid.
    Solid(Box<Body>),
    /// A two-layer body.
    TwoLayer(Box<TwoLayer>),
}

impl OwnedBody {
    /// As one that is looked at.
    pub fn view(&self) -> AnyBody<'_> {
        match self {
            Self::Solid(body) => AnyBody::Solid(body),
            Self::TwoLayer(body) => AnyBody::TwoLayer(body),
        }
    }

    /// As one to be changed.
    pub fn view_mut(&mut self) -> AnyBodyMut<'_> {
        match self {
            Self::Solid(body) => AnyBodyMut::Solid(body),
            Self::TwoLayer(body) => AnyBodyMut::TwoLayer(body),
        }
    }
}

impl From<Body> for OwnedBody {
    fn from(body: Body) -> Self {
        Self::Solid(Box::new(body))
    }
}

impl From<TwoLayer> for OwnedBody {
    fn from(body: TwoLayer) -> Self {
        Self::TwoLayer(Box::new(body))
    }
}

/// What both kinds have under the same name.
macro_rules! either {
    ($this:expr, $body:ident => $value:expr) => {
        match $this {
            Self::Solid($body) => $value,
            Self::TwoLayer($body) => $value,
        }
    };
}

impl<'a> AnyBody<'a> {
    /// Stable identifier, unique among the bodies of both kinds.
    pub fn id(self) -> &'a str {
        either!(self, body => &body.id)
    }

    /// Its name, or its identifier where it has none.
    pub fn title(self) -> &'a str {
        either!(self, body => body.title())
    }

    /// Whether it is left out of what is seen.
    pub fn hidden(self) -> bool {
        either!(self, body => body.hidden)
    }

    /// Colour in which it is drawn, red, green and blue from 0 to 255; the theme's unless given.
    pub fn color(self) -> Option<[u8; 3]> {
        either!(self, body => body.color)
    }

    /// Where the model frame stands in the world.
    pub fn placement(self) -> &'a Placement {
        either!(self, body => &body.placement)
    }

    /// How it is stepped through time.
    pub fn integrator(self) -> IntegratorChoice {
        either!(self, body => body.integrator)
    }

    /// Motion and deformation at the start.
    pub fn initial(self) -> &'a Initial {
        either!(self, body => &body.initial)
    }

    /// Impulses given to regions at the start.
    pub fn impulses(self) -> &'a [Impulse] {
        either!(self, body => &body.impulses)
    }

    /// Named sets of particles, without those that every two-layer body has.
    pub fn regions(self) -> &'a [Region] {
        either!(self, body => &body.regions)
    }

    /// Regions whose motion is prescribed.
    pub fn pins(self) -> &'a [Pin] {
        either!(self, body => &body.pins)
    }

    /// Motions made elsewhere that its particles follow.
    pub fn follows(self) -> &'a [Follow] {
        either!(self, body => &body.follows)
    }

    /// Numbers that change in time, for several of its parts to follow.
    pub fn drives(self) -> &'a [SharedDrive] {
        either!(self, body => &body.drives)
    }

    /// Embedded fibres; a two-layer body has none.
    pub fn fibres(self) -> &'a [Fibre] {
        self.solid().map_or(&[], |body| &body.fibres)
    }

    /// Embedded sheets; a two-layer body has none.
    pub fn sheets(self) -> &'a [Sheet] {
        self.solid().map_or(&[], |body| &body.sheets)
    }

    /// The model that its shape names, if it does.
    pub fn model(self) -> Option<ModelFile<'a>> {
        match self {
            Self::Solid(Body { shape: Shape::Mesh(shape), .. }) => Some(shape.into()),
            Self::TwoLayer(TwoLayer { shape: TwoLayerShape::Mesh(shape), .. }) => Some(shape.into()),
            _ => None,
        }
    }

    /// A copy of it.
    pub fn owned(self) -> OwnedBody {
        match self {
            Self::Solid(body) => body.clone().into(),
            Self::TwoLayer(body) => body.clone().into(),
        }
    }

    /// The fibre solid, if it is one.
    pub fn solid(self) -> Option<&'a Body> {
        if let Self::Solid(body) = self { Some(body) } else { None }
    }

    /// The two-layer body, if it is one.
    pub fn two_layer(self) -> Option<&'a TwoLayer> {
        if let Self::TwoLayer(body) = self { Some(body) } else { None }
    }
}

impl<'a> AnyBodyMut<'a> {
    /// Stable identifier, unique among the bodies of both kinds.
    pub fn id(&self) -> &str {
        either!(self, body => &body.id)
    }

    /// Whether it is left out of what is seen.
    pub fn hidden_mut(&mut self) -> &mut bool {
        either!(self, body => &mut body.hidden)
    }

    /// Stable identifier.
    pub fn id_mut(&mut self) -> &mut String {
        either!(self, body => &mut body.id)
    }

    /// Name a person reads.
    pub fn name_mut(&mut self) -> &mut String {
        either!(self, body => &mut body.name)
    }

    /// Where the model frame stands in the world.
    pub fn placement_mut(&mut self) -> &mut Placement {
        either!(self, body => &mut body.placement)
    }

    /// Numbers that change in time, for several of its parts to follow.
    pub fn drives_mut(&mut self) -> &mut Vec<SharedDrive> {
        either!(self, body => &mut body.drives)
    }

    /// Colour in which it is drawn.
    pub fn color_mut(&mut self) -> &mut Option<[u8; 3]> {
        either!(self, body => &mut body.color)
    }

    /// How it is stepped through time.
    pub fn integrator_mut(&mut self) -> &mut IntegratorChoice {
        either!(self, body => &mut body.integrator)
    }

    /// Named sets of particles.
    pub fn regions_mut(&mut self) -> &mut Vec<Region> {
        either!(self, body => &mut body.regions)
    }

    /// Regions whose motion is prescribed.
    pub fn pins_mut(&mut self) -> &mut Vec<Pin> {
        either!(self, body => &mut body.pins)
    }

    /// Motions made elsewhere that its particles follow.
    pub fn follows_mut(&mut self) -> &mut Vec<Follow> {
        either!(self, body => &mut body.follows)
    }

    /// The paths of the files that its shape, its voids and what it follows name.
    pub(crate) fn into_model_paths(self) -> Vec<&'a mut String> {
        let led = |follows: &'a mut Vec<Follow>| follows.iter_mut().flat_map(|of| of.leader.paths_mut());
        match self {
            Self::Solid(Body { shape, voids, follows, .. }) => {
                let own = if let Shape::Mesh(shape) = shape { Some(&mut shape.path) } else { None };
                let of_voids = voids.iter_mut().filter_map(|void| match &mut void.shape {
                    VoidShape::Mesh(VoidMesh { path, .. }) => Some(path),
                    _ => None,
                });
                own.into_iter().chain(of_voids).chain(led(follows)).collect()
            }
            Self::TwoLayer(TwoLayer { shape, follows, .. }) => {
                let own = if let TwoLayerShape::Mesh(shape) = shape { Some(&mut shape.path) } else { None };
                own.into_iter().chain(led(follows)).collect()
            }
        }
    }
}

impl Scene {
    /// Every body in the order in which the world numbers them: the fibre solids, then the two-layer bodies.
    pub fn all_bodies(&self) -> impl Iterator<Item = AnyBody<'_>> {
        self.bodies.iter().map(AnyBody::Solid).chain(self.two_layer.iter().map(AnyBody::TwoLayer))
    }

    /// [`Scene::all_bodies`], to be changed.
    pub fn all_bodies_mut(&mut self) -> impl Iterator<Item = AnyBodyMut<'_>> {
        self.bodies.iter_mut().map(AnyBodyMut::Solid).chain(self.two_layer.iter_mut().map(AnyBodyMut::TwoLayer))
    }

    /// The body with this number among [`Scene::all_bodies`].
    pub fn any_body(&self, index: usize) -> Option<AnyBody<'_>> {
        let (list, index) = self.body_place(index);
        self.listed_body(list, index)
    }

    /// The body of either kind with this identifier.
    pub fn find_body(&self, id: &str) -> Option<AnyBody<'_>> {
        self.all_bodies().find(|body| body.id() == id)
    }

    /// [`Scene::find_body`], to be changed.
    pub fn find_body_mut(&mut self, id: &str) -> Option<AnyBodyMut<'_>> {
        self.all_bodies_mut().find(|body| body.id() == id)
    }

    /// RFC 6901 pointer to the body with this number among [`Scene::all_bodies`].
    pub fn body_pointer(&self, index: usize) -> String {
        let (list, index) = self.body_place(index);
        format!("/{list}/{index}")
    }

    /// The list that holds the body with this number among [`Scene::all_bodies`], and its number there.
    pub(super) fn body_place(&self, index: usize) -> (&'static str, usize) {
        match index.checked_sub(self.bodies.len()) {
            None => ("bodies", index),
            Some(index) => ("two_layer", index),
        }
    }

    /// The body with this number in the list with this name.
    pub(super) fn listed_body(&self, list: &str, index: usize) -> Option<AnyBody<'_>> {
        match list {
            "bodies" => self.bodies.get(index).map(AnyBody::Solid),
            "two_layer" => self.two_layer.get(index).map(AnyBody::TwoLayer),
            _ => None,
        }
    }

    /// The models that the scene's shapes and voids name, each with the JSON pointer of the shape.
    pub fn meshes(&self) -> impl Iterator<Item = (String, ModelFile<'_>)> {
        let models = self.all_bodies().enumerate().flat_map(|(index, body)| {
            let own = body.model().map(|model| ("/shape/mesh".to_owned(), model));
            let voids = body.solid().map_or(&[][..], |body| &body.voids).iter().enumerate();
            let voids = voids.filter_map(|(k, void)| match &void.shape {
                VoidShape::Mesh(mesh) => Some((format!("/voids/{k}/shape/mesh"), mesh.into())),
                _ => None,
            });
            own.into_iter().chain(voids).map(move |(pointer, model)| (index, pointer, model))
        });
        models.map(|(index, pointer, model)| (self.body_pointer(index) + &pointer, model))
    }

    /// The models that colliders are made of, each with the pointer to the mesh that names it.
    pub fn collider_meshes(&self) -> impl Iterator<Item = (String, &ColliderMesh)> {
        self.colliders.iter().enumerate().filter_map(|(index, collider)| match &collider.shape {
            ColliderShape::Mesh(mesh) => Some((format!("/colliders/{index}/shape/mesh"), mesh)),
            _ => None,
        })
    }

    /// The motions that the bodies follow, each with the pointer to what is followed.
    pub fn leaders(&self) -> impl Iterator<Item = (String, &Leader)> {
        self.all_bodies().enumerate().flat_map(|(index, body)| {
            let pointer = self.body_pointer(index);
            let follows = body.follows().iter().enumerate();
            follows.map(move |(k, of)| (format!("{pointer}/follows/{k}/leader"), &of.leader))
        })
    }

    /// Where the scene names its models and the motions that its bodies follow.
    pub fn model_paths_mut(&mut self) -> impl Iterator<Item = &mut String> {
        let solids = self.bodies.iter_mut().map(AnyBodyMut::Solid);
        let bodies = solids.chain(self.two_layer.iter_mut().map(AnyBodyMut::TwoLayer));
        let colliders = self.colliders.iter_mut().filter_map(|collider| match &mut collider.shape {
            ColliderShape::Mesh(mesh) => Some(&mut mesh.path),
            _ => None,
        });
        bodies.flat_map(AnyBodyMut::into_model_paths).chain(colliders)
    }
}
