//! Motions made elsewhere that the active body follows.

use super::context::{Context, Request, Step};
use super::dialogs::{Dialog, PathPurpose};
use super::field::NumberField;
use super::theme::GRID;
use crate::edit::Command;
use crate::io::path_from;
use crate::scene::{
    AfterLast, AnyBody, Assets, CacheLeader, Follow, FollowSelect, FollowSprings, Hold, Leader, SkeletonLeader,
    TwoLayer,
};
use egui::{ComboBox, Ui};
use std::path::Path;

const START: NumberField = NumberField::new("Start", "s", 0.0..=1e6, Some(0.0), "When the body begins to follow");
const PRE_ROLL: NumberField = NumberField::new(
    "Pre-roll",
    "s",
    0.0..=1e6,
    Some(0.0),
    "How long the body is eased then from its rest pose into that of the first frame, before the motion begins",
);
const FROM: NumberField = NumberField::new(
    "From",
    "s",
    0.0..=1e6,
    Some(0.0),
    "Time in the motion of the frame that is the first to be played",
);
const SPEED: NumberField =
    NumberField::new("Speed", "", 1e-3..=1e3, Some(1.0), "How many times as fast as it was made the motion is played");
const WEIGHT: NumberField =
    NumberField::new("At least", "", 1e-3..=1.0, None, "By how much the chosen joints hold what follows");
const DISTANCE: NumberField =
    NumberField::new("Within", "m", 1e-6..=1e3, None, "How near to the bones, or to the cache's mesh, what follows is");
const STIFFNESS: NumberField = NumberField::new(
    "Stiffness",
    "N/m/kg",
    1e-6..=1e12,
    None,
    "Of the springs, for each kilogram: the square of the angular frequency of a swing about the motion",
);
const DAMPING: NumberField = NumberField::new(
    "Damping",
    "",
    0.0..=100.0,
    Some(0.5),
    "Against the motion's velocity: 1 lets nothing swing about it any more",
);

/// Stiffness of new springs [N/m to the kilogram]: three swings a second.
const FIRST_STIFFNESS: f64 = 400.0;
/// What follows a skeleton at first lies this near to its bones, as a share of the body's least extent.
const FIRST_DISTANCE: f64 = 0.3;

/// Shows what the active body follows.
pub(super) fn follows_section(ui: &mut Ui, cx: &mut Context) {
    let Some(body) = cx.scene().any_body(cx.active.index).map(AnyBody::owned) else { return };
    let body = body.view();
    ui.add_space(2.0 * GRID);
    ui.heading("Follows");
    let mut follows = body.follows().to_vec();
    let mut step = Step::Present;
    let mut gone = None;
    for (index, follow) in follows.iter_mut().enumerate() {
        ui.push_id(("follow", index), |ui| {
            ui.horizontal(|ui| {
                let file =
                    Path::new(follow.leader.path()).file_name().unwrap_or_default().to_string_lossy().into_owned();
                ui.label(format!("{}: {file}", follow.id)).on_hover_text(follow.leader.path());
                if ui.button("Stop following").on_hover_text("Lets go of this motion").clicked() {
                    gone = Some(index);
                }
            });
            show_follow(ui, cx, body, follow);
        });
        ui.separator();
    }
    if let Some(index) = gone {
        follows.remove(index);
        step = Step::Own;
    }
    if follows != body.follows() {
        cx.edit(&Command::SetFollows { body: body.id().to_owned(), follows }, step);
    }
    let tooltip = "A glTF or GLB file with a skin and an animation, or a PC2 or MDD cache of this body's vertices";
    if ui.button("Follow a motion…").on_hover_text(tooltip).clicked() {
        cx.request(Request::Open(Dialog::path(PathPurpose::Follow, cx.document.path.as_deref())));
    }
}

fn show_follow(ui: &mut Ui, cx: &Context, body: AnyBody<'_>, follow: &mut Follow) {
    if let Leader::Skeleton(leader) = &mut follow.leader {
        show_skeleton(ui, cx, leader);
    }
    select_fields(ui, body, follow);
    let is_soft = follow.hold != Hold::Hard;
    let chosen = choice(ui, "Held", ["hard", "by springs"], usize::from(is_soft));
    match (chosen, &mut follow.hold) {
        (0, hold) => *hold = Hold::Hard,
        (_, hold @ Hold::Hard) => *hold = Hold::Springs(FollowSprings::new(FIRST_STIFFNESS)),
        (_, Hold::Springs(springs)) => {
            STIFFNESS.show(ui, &mut springs.stiffness);
            DAMPING.show(ui, &mut springs.damping);
        }
    }
    if !follow.paint.is_empty() && follow.select != FollowSelect::Painted {
        ui.horizontal(|ui| {
            ui.label(format!("Painted by {} dabs", follow.paint.len()));
            if ui.button("Clear").on_hover_text("Springs pull everywhere alike").clicked() {
                follow.paint.clear();
            }
        });
    }
    START.show(ui, &mut follow.start);
    PRE_ROLL.show(ui, &mut follow.pre_roll);
    FROM.show(ui, &mut follow.from);
    SPEED.show(ui, &mut follow.speed);
    let afters = [AfterLast::Hold, AfterLast::Repeat, AfterLast::Mirror];
    let present = afters.iter().position(|after| *after == follow.after).unwrap_or(0);
    follow.after = afters[choice(ui, "Then", ["it stays", "it begins again", "it goes back and forth"], present)];
}

fn show_skeleton(ui: &mut Ui, cx: &Context, leader: &mut SkeletonLeader) {
    let Some(skeleton) = cx.document.assets().skeleton(&leader.path) else { return };
    let names: Vec<&str> = skeleton.clips.iter().map(|clip| clip.name.as_str()).collect();
    let present = leader.animation.as_deref().and_then(|name| names.iter().position(|one| *one == name)).unwrap_or(0);
    let chosen = choice(ui, "Animation", names.iter().copied(), present);
    if chosen != present {
        leader.animation = Some(names[chosen].to_owned());
    }
    let count = leader.joints.len();
    let said = if count == 0 { "all joints".to_owned() } else { format!("{count} joints") };
    ui.horizontal(|ui| {
        ui.label("Joints");
        ui.menu_button(said, |ui| {
            for joint in &skeleton.joints {
                let mut is_chosen = leader.joints.contains(&joint.name);
                if ui.checkbox(&mut is_chosen, &joint.name).changed() {
                    leader.joints.retain(|name| *name != joint.name);
                    if is_chosen {
                        leader.joints.push(joint.name.clone());
                    }
                }
            }
        });
    });
}

fn select_fields(ui: &mut Ui, body: AnyBody<'_>, follow: &mut Follow) {
    let has_skin = matches!(follow.leader, Leader::Skeleton(_));
    let mut offered: Vec<(String, FollowSelect)> = vec![("everything".to_owned(), FollowSelect::Everything)];
    if has_skin {
        offered.push(("what the joints hold".to_owned(), FollowSelect::SkinWeight(0.7)));
    }
    offered.push(("what is near".to_owned(), FollowSelect::Distance(0.01)));
    // The first that every two-layer body has is everything.
    let built_in = body.two_layer().map_or(&[][..], |_| &TwoLayer::REGIONS[1..]);
    let own = body.regions().iter().map(|region| region.id.as_str());
    offered.extend(
        built_in
            .iter()
            .copied()
            .chain(own)
            .map(|region| (format!("region \"{region}\""), FollowSelect::Region(region.to_owned()))),
    );
    if !follow.paint.is_empty() {
        offered.push(("what is painted".to_owned(), FollowSelect::Painted));
    }
    let is_same = |one: &FollowSelect, other: &FollowSelect| match (one, other) {
        (FollowSelect::SkinWeight(_), FollowSelect::SkinWeight(_))
        | (FollowSelect::Distance(_), FollowSelect::Distance(_)) => true,
        (one, other) => one == other,
    };
    let present = offered.iter().position(|(_, select)| is_same(select, &follow.select)).unwrap_or(0);
    let chosen = choice(ui, "What follows", offered.iter().map(|(name, _)| name.as_str()), present);
    if chosen != present {
        follow.select = offered.swap_remove(chosen).1;
    }
    match &mut follow.select {
        FollowSelect::SkinWeight(least) => {
            WEIGHT.show(ui, least);
        }
        FollowSelect::Distance(greatest) => {
            DISTANCE.show(ui, greatest);
        }
        FollowSelect::Everything | FollowSelect::Region(_) | FollowSelect::Painted => {}
    }
}

/// A list of which one is chosen.
fn choice<'a>(ui: &mut Ui, label: &str, names: impl IntoIterator<Item = &'a str>, present: usize) -> usize {
    let names: Vec<&str> = names.into_iter().collect();
    let mut chosen = present;
    ui.horizontal(|ui| {
        let title = ui.label(label);
        let shown = names.get(present).copied().unwrap_or_default();
        let list = ComboBox::from_id_salt(label).selected_text(shown).show_ui(ui, |ui| {
            for (index, name) in names.iter().enumerate() {
                ui.selectable_value(&mut chosen, index, *name);
            }
        });
        list.response.labelled_by(title.id);
    });
    chosen
}

/// The motion of a file as what the active body is to follow; none where there is no body.
pub(super) fn leader_of(cx: &Context, file: &Path) -> Option<Leader> {
    let body = cx.scene().any_body(cx.active.index)?;
    let path = path_from(&cx.document.folder, file);
    let ending = file.extension().unwrap_or_default().to_ascii_lowercase();
    // Its own model's motion is in its own unit and axes.
    let (scale, up) = body.model().map_or((1.0, crate::scene::Axis::Y), |model| (model.scale, model.up));
    Some(if ending == "pc2" || ending == "mdd" {
        Leader::from(CacheLeader { scale, up, ..CacheLeader::new(path) })
    } else {
        Leader::from(SkeletonLeader { scale, up, ..SkeletonLeader::new(path) })
    })
}

/// Has the active body follow a motion that was read.
pub(super) fn add_follow(cx: &mut Context, leader: Leader, read: Assets) {
    let Some(body) = cx.scene().any_body(cx.active.index).map(AnyBody::owned) else { return };
    let body = body.view();
    cx.take_in_models(read);
    let mut follows = body.follows().to_vec();
    let taken = |n: &usize| follows.iter().any(|follow| follow.id == format!("motion-{n}"));
    let number = (1..=follows.len() + 1).find(|n| !taken(n)).unwrap_or(1);
    let least = cx.active.bounds().map(|bounds| (bounds.max - bounds.min).min_element());
    let select = match (&leader, least) {
        (Leader::Skeleton(_), Some(least)) if least > 0.0 => FollowSelect::Distance(FIRST_DISTANCE * least),
        _ => FollowSelect::Everything,
    };
    follows.push(Follow::new(format!("motion-{number}"), leader).with_select(select));
    cx.edit(&Command::SetFollows { body: body.id().to_owned(), follows }, Step::Own);
}
