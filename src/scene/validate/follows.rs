//! Checks of what bodies follow.

use super::check::{At, Checked, Ids, fraction, not_negative, positive, require};
use super::paint::paint;
use super::parts::model_file;
use crate::scene::{Follow, FollowSelect, Hold, Leader, ModelFile};

/// What the body here follows; `regions` are those that it may name.
pub(super) fn follows(at: &At<'_>, all: &[Follow], regions: &Ids<'_>) -> Checked {
    let mut ids = Ids::of("motion that is followed");
    for (index, one) in all.iter().enumerate() {
        let at = at.item(index);
        ids.add(&at.field("id"), &one.id)?;
        follow(&at, one, regions)?;
    }
    Ok(())
}

fn follow(at: &At<'_>, of: &Follow, regions: &Ids<'_>) -> Checked {
    leader(&at.field("leader"), &of.leader)?;
    not_negative(&at.field("start"), of.start, "s")?;
    not_negative(&at.field("pre_roll"), of.pre_roll, "s")?;
    not_negative(&at.field("from"), of.from, "s")?;
    positive(&at.field("speed"), of.speed, "")?;
    select(&at.field("select"), of, regions)?;
    if let Hold::Springs(springs) = &of.hold {
        let at = at.field("hold");
        let at = at.field("springs");
        positive(&at.field("stiffness"), springs.stiffness, "N/m to the kilogram")?;
        not_negative(&at.field("damping"), springs.damping, "")?;
    }
    paint(&at.field("paint"), &of.paint)
}

fn leader(at: &At<'_>, leader: &Leader) -> Checked {
    let (scale, up) = leader.units();
    match leader {
        Leader::Skeleton(of) => {
            let at = at.field("skeleton");
            let holds = !of.path.trim().is_empty();
            let remedy = || "name a glTF or GLB file with a skin, relative to the scene file";
            require(&at.field("path"), &of.path, holds, "names no file", remedy)?;
            positive(&at.field("scale"), scale, "m")?;
            let mut ids = Ids::of("joint");
            let at = at.field("joints");
            of.joints.iter().enumerate().try_for_each(|(index, joint)| ids.add(&at.item(index), joint))
        }
        Leader::Cache(of) => {
            let at = at.field("cache");
            let holds = !of.path.trim().is_empty();
            let remedy = || "name a PC2 or MDD file, relative to the scene file";
            require(&at.field("path"), &of.path, holds, "names no file", remedy)?;
            positive(&at.field("scale"), scale, "m")?;
            of.frames_per_second.map_or(Ok(()), |rate| positive(&at.field("frames_per_second"), rate, "1/s"))?;
            of.rest.as_ref().map_or(Ok(()), |rest| {
                let problem = "names no file";
                let remedy = || "name the model whose vertices the cache moves, or leave this out";
                require(&at.field("rest"), rest, !rest.trim().is_empty(), problem, remedy)?;
                model_file(&at, ModelFile { path: rest, scale, up })
            })
        }
    }
}

fn select(at: &At<'_>, of: &Follow, regions: &Ids<'_>) -> Checked {
    match &of.select {
        FollowSelect::Everything => Ok(()),
        FollowSelect::SkinWeight(least) => {
            let at = at.field("skin_weight");
            positive(&at, *least, "")?;
            fraction(&at, *least)?;
            let has_skin = matches!(of.leader, Leader::Skeleton(_));
            let remedy = || "choose by \"distance\", a \"region\" or what is \"painted\"";
            require(&at, least, has_skin, "asks for a skin, which a cache has none of", remedy)
        }
        FollowSelect::Distance(distance) => positive(&at.field("distance"), *distance, "m"),
        FollowSelect::Region(region) => regions.resolve(&at.field("region"), region),
        FollowSelect::Painted => {
            let problem = "chooses what is painted, and nothing is";
            require(at, &of.select, !of.paint.is_empty(), problem, || "add dabs to `paint`")
        }
    }
}
