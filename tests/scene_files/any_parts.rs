//! Any parts of a body.

use super::any_element::{above_zero, extra};
use super::round_trip::{direction, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use sinew::scene::*;

/// Of a skeleton or a cache, hard or by springs.
pub fn follow() -> impl Strategy<Value = Follow> {
    let leader = (above_zero(), proptest::option::of(any::<String>()), any::<bool>()).prop_map(
        |(scale, name, cached)| -> Leader {
            if cached {
                CacheLeader { scale, frames_per_second: Some(scale), ..CacheLeader::new("moved.mdd") }.into()
            } else {
                SkeletonLeader { scale, animation: name, ..SkeletonLeader::new("rig.glb") }.into()
            }
        },
    );
    let select = prop_oneof![
        Just(FollowSelect::Everything),
        above_zero().prop_map(FollowSelect::Distance),
        Just(FollowSelect::Region("region".to_owned())),
    ];
    let hold = prop_oneof![
        Just(Hold::Hard),
        above_zero().prop_map(|stiffness| Hold::Springs(FollowSprings {
            extra: Extra::new(),
            stiffness,
            damping: 0.1
        })),
    ];
    (leader, select, hold, above_zero(), extra()).prop_map(|(leader, select, hold, pre_roll, extra)| Follow {
        select,
        hold,
        pre_roll,
        extra,
        ..Follow::new("follow", leader)
    })
}

/// A sheet.
pub fn sheet() -> impl Strategy<Value = Sheet> {
    let rows = vec(vec(vector(), 3), 2..4).prop_map(SheetSource::Grid);
    let triangle = (vec(vector(), 3), extra()).prop_map(|(vertices, extra)| {
        SheetSource::Triangles(SheetTriangles { vertices, triangles: vec![[0, 1, 2]], extra })
    });
    let grain = (direction(), above_zero(), extra()).prop_map(|(axis, et, extra)| Grain {
        along: GrainAlong::Direction(axis),
        et,
        extra,
    });
    let stiffness = (above_zero(), above_zero(), proptest::option::of(grain), extra())
        .prop_map(|(et, bending, grain, extra)| SheetStiffness { et, poisson_ratio: 1.0 / 3.0, bending, grain, extra });
    let seam = proptest::option::of((1.001..10.0, extra()).prop_map(|(stretch, extra)| Seam { stretch, extra }));
    (prop_oneof![rows, triangle], stiffness, 0.0..=1.0, seam, extra()).prop_map(
        |(source, stiffness, volume_fraction, seam, extra)| {
            let sheet = Sheet::grid("sheet", Vec::new()).with_rest_shape(SheetRestShape::Flat);
            Sheet { source, stiffness, volume_fraction, seam, extra, ..sheet }
        },
    )
}
