//! What is said of what a drive moves: where it stands in the file, what people call it, what the drive's number comes
//! to there, and between which numbers that may lie.

use super::drive::CONTRACTION;
use super::{
    Activation, AnyBody, Drivable, Drive, Element, ElementLaw, Fibre, Motion, PanelMotion, Scene, SheetActivation,
};
use glam::DVec3;

/// Any number.
const ANY: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl Drivable {
    /// RFC 6901 pointer to the drive in the scene's file, or to where it would be; none where what it moves is not
    /// there.
    pub fn pointer(&self, scene: &Scene) -> Option<String> {
        let body = || {
            let index = scene.all_bodies().position(|body| Some(body.id()) == self.body())?;
            Some((scene.body_pointer(index), scene.any_body(index)?))
        };
        Some(match self {
            Self::Gravity => "/gravity_drive".to_owned(),
            Self::Wind => scene.wind.as_ref().map(|_| "/wind/drive".to_owned())?,
            Self::Panel(id) => {
                format!("/panels/{}/motion/follows/drive", scene.panels.iter().position(|panel| panel.id == *id)?)
            }
            Self::Collider(id) => {
                let index = scene.colliders.iter().position(|collider| collider.id == *id)?;
                format!("/colliders/{index}/motion/driven/drive")
            }
            Self::Shared { drive, .. } => {
                let (at, body) = body()?;
                format!("{at}/drives/{}/drive", body.drives().iter().position(|one| one.id == *drive)?)
            }
            Self::Fibre { fibre, .. } => {
                let (at, body) = body()?;
                format!("{at}/fibres/{}/activation/drive", body.fibres().iter().position(|one| one.id == *fibre)?)
            }
            Self::Sheet { sheet, .. } => {
                let (at, body) = body()?;
                format!("{at}/sheets/{}/activation/drive", body.sheets().iter().position(|one| one.id == *sheet)?)
            }
            Self::Element { element, .. } => {
                let (at, body) = body()?;
                let elements = &body.solid()?.elements;
                format!("{at}/elements/{}/activation/drive", elements.iter().position(|one| one.id == *element)?)
            }
            Self::Pin { pin, .. } => {
                let (at, body) = body()?;
                format!("{at}/pins/{}/motion/driven/drive", body.pins().iter().position(|one| one.id == *pin)?)
            }
            Self::Pressure(_) => {
                let (at, body) = body()?;
                body.two_layer().map(|_| format!("{at}/pressure_drive"))?
            }
            Self::Springs { springs, .. } => {
                let (at, body) = body()?;
                let index = body.two_layer()?.active_springs.iter().position(|one| one.id == *springs)?;
                format!("{at}/active_springs/{index}/drive")
            }
        })
    }

    /// What people call it.
    pub fn title(&self, scene: &Scene) -> String {
        let of_body = || self.body().and_then(|id| scene.find_body(id));
        let several = scene.all_bodies().nth(1).is_some();
        // Bodies of one make often have parts of one name.
        let of = |name: &str| match of_body() {
            Some(body) if several => format!("{name}, {}", body.title()),
            _ => name.to_owned(),
        };
        match self {
            Self::Gravity => "Gravity".to_owned(),
            Self::Wind => "Wind".to_owned(),
            Self::Panel(id) => {
                let panel = scene.panels.iter().find(|panel| panel.id == *id);
                panel.map_or(id.as_str(), |panel| panel.title()).to_owned()
            }
            Self::Collider(id) => {
                let collider = scene.colliders.iter().find(|collider| collider.id == *id);
                collider.map_or(id.as_str(), |collider| collider.title()).to_owned()
            }
            Self::Shared { drive, .. } => {
                let one = self.shared(scene).iter().find(|one| one.id == *drive);
                of(one.filter(|one| !one.name.is_empty()).map_or(drive.as_str(), |one| &one.name))
            }
            Self::Fibre { fibre, .. } => {
                let one = of_body().map_or(&[][..], AnyBody::fibres).iter().find(|one| one.id == *fibre);
                of(one.map_or(fibre.as_str(), |one| one.title()))
            }
            Self::Sheet { sheet, .. } => {
                let one = of_body().map_or(&[][..], AnyBody::sheets).iter().find(|one| one.id == *sheet);
                of(one.map_or(sheet.as_str(), |one| one.title()))
            }
            Self::Element { element, .. } => of(self.element(scene).map_or(element.as_str(), |one| one.title())),
            Self::Pin { pin, .. } => of(&format!("Pin {pin}")),
            Self::Springs { springs, .. } => of(&format!("Springs {springs}")),
            Self::Pressure(id) => format!("Gas in {}", of_body().map_or(id.as_str(), AnyBody::title)),
        }
    }

    /// What it comes to where the drive is 1, with its unit; none where that is no single number.
    pub fn at_one(&self, scene: &Scene) -> Option<(f64, &'static str)> {
        let body = || scene.find_body(self.body()?);
        match self {
            Self::Gravity => Some((DVec3::from_array(scene.gravity).length(), "m/s²")),
            Self::Wind => Some((DVec3::from_array(scene.wind.as_ref()?.velocity).length(), "m/s")),
            Self::Panel(id) => match &scene.panels.iter().find(|panel| panel.id == *id)?.motion {
                PanelMotion::Follows(of) => Some((of.travel, "m")),
                _ => None,
            },
            Self::Collider(id) => way(&scene.colliders.iter().find(|collider| collider.id == *id)?.motion),
            Self::Shared { .. } => None,
            Self::Fibre { .. } => act(self.acting_fibre(scene)?.1),
            Self::Sheet { .. } => bend(self.sheet_activation(scene)?),
            Self::Element { .. } => pull(self.element(scene)?),
            Self::Pin { pin, .. } => way(&body()?.pins().iter().find(|one| one.id == *pin)?.motion),
            Self::Pressure(_) => Some((body()?.two_layer()?.pressure, "J")),
            Self::Springs { .. } => Some((100.0 * self.springs_contract(scene)?, "%")),
        }
    }

    /// Least and greatest number that its drive may take, as [`validate`](Scene::validate) has it.
    pub fn limits(&self, scene: &Scene) -> [f64; 2] {
        match self {
            Self::Pressure(_) => [0.0, f64::INFINITY],
            Self::Fibre { .. } => self.acting_fibre(scene).map_or(ANY, |(fibre, of)| {
                let pulls = if of.muscle.is_some() { [0.0, 1.0] } else { ANY };
                both(both(pulls, shortening(of.contract)), of.thickening_limits(fibre.volume_fraction))
            }),
            Self::Sheet { .. } => self.sheet_activation(scene).map_or(ANY, |of| {
                let [along, across] = of.contract.map(shortening);
                both(along, across)
            }),
            Self::Springs { .. } => self.springs_contract(scene).map_or(ANY, shortening),
            Self::Element { .. } => self.element(scene).map_or(ANY, of_element),
            Self::Shared { .. } => self.followers(scene).iter().map(|one| one.limits(scene)).fold(ANY, both),
            Self::Gravity | Self::Wind | Self::Panel(_) | Self::Collider(_) | Self::Pin { .. } => ANY,
        }
    }

    /// Whether a wave may run along it: along a fibre, and in a drive that nothing but fibres follows.
    pub fn runs_along(&self, scene: &Scene) -> bool {
        match self {
            Self::Fibre { .. } => true,
            Self::Shared { .. } => self.followers(scene).iter().all(|one| matches!(one, Self::Fibre { .. })),
            _ => false,
        }
    }

    fn acting_fibre<'a>(&self, scene: &'a Scene) -> Option<(&'a Fibre, &'a Activation)> {
        let Self::Fibre { body, fibre } = self else { return None };
        let fibre = scene.body(body)?.fibres.iter().find(|one| one.id == *fibre)?;
        Some((fibre, fibre.activation.as_ref()?))
    }

    fn springs_contract(&self, scene: &Scene) -> Option<f64> {
        let Self::Springs { body, springs } = self else { return None };
        let active = &scene.find_body(body)?.two_layer()?.active_springs;
        Some(active.iter().find(|one| one.id == *springs)?.contract)
    }

    fn sheet_activation<'a>(&self, scene: &'a Scene) -> Option<&'a SheetActivation> {
        let Self::Sheet { body, sheet } = self else { return None };
        scene.body(body)?.sheets.iter().find(|one| one.id == *sheet)?.activation.as_ref()
    }
}

impl Drive {
    /// What people call its kind.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Constant(_) => "Constant",
            Self::Keyframes(_) => "Keys",
            Self::Wave(_) => "Wave",
            Self::Shared(_) => "Shared",
        }
    }
}

fn both(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].min(b[1])]
}

/// Least and greatest drive of what makes something shorter by this share where it is 1.
fn shortening(contract: f64) -> [f64; 2] {
    if contract == 0.0 {
        return ANY;
    }
    let [a, b] = CONTRACTION.map(|share| share / contract);
    [a.min(b), a.max(b)]
}

/// What a sheet does most.
fn bend(of: &SheetActivation) -> Option<(f64, &'static str)> {
    let greatest = |[along, across]: [f64; 2]| if along.abs() < across.abs() { across } else { along };
    let (shorter, curls) = (greatest(of.contract), greatest(of.curl_degrees_per_metre));
    let shortens = (shorter != 0.0).then_some((100.0 * shorter, "%"));
    shortens.or((curls != 0.0).then_some((curls, "°/m")))
}

/// Least and greatest drive of an element.
fn of_element(element: &Element) -> [f64; 2] {
    let Some(of) = &element.activation else { return ANY };
    let pulls = if matches!(element.law, ElementLaw::Muscle(_)) { [0.0, 1.0] } else { ANY };
    both(both(pulls, shortening(of.contract)), element.turn_limits(of.turn_degrees))
}

/// What an element does most.
fn pull(element: &Element) -> Option<(f64, &'static str)> {
    let of = element.activation.as_ref()?;
    match &element.law {
        _ if of.contract != 0.0 => Some((100.0 * of.contract, "%")),
        _ if of.turn_degrees != 0.0 => Some((of.turn_degrees, "°")),
        ElementLaw::Muscle(muscle) => Some((muscle.force, element.measure.unit())),
        _ => None,
    }
}

/// The greatest of what a fibre does.
fn act(of: &Activation) -> Option<(f64, &'static str)> {
    let shorter = (of.contract != 0.0).then_some((100.0 * of.contract, "%"));
    let curls = of.curl.as_ref().map(|curl| (curl.degrees_per_metre, "°/m"));
    let twists = of.twist.as_ref().map(|twist| (twist.degrees_per_metre, "°/m"));
    let pulls = of.muscle.as_ref().map(|muscle| (muscle.force, "N"));
    shorter.or(pulls).or(curls).or(twists)
}

fn way(motion: &Motion) -> Option<(f64, &'static str)> {
    let Motion::Driven(of) = motion else { return None };
    let offset = DVec3::from_array(of.offset).length();
    match &of.turn {
        Some(turn) if offset == 0.0 => Some((turn.degrees, "°")),
        _ => Some((offset, "m")),
    }
}
