//! Skeletons: nodes within nodes, of which some are the joints that a skin hangs on, and clips that move them.

use super::track::{Track, slerp};
use glam::{DMat4, DQuat, DVec3, DVec4};

/// A skeleton with its skin and its clips, in the file's unit and axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Skeleton {
    /// Parents before their children.
    pub(crate) nodes: Vec<Node>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) clips: Vec<Clip>,
    pub(crate) skin: SkinMesh,
}

/// A frame within another.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) parent: Option<usize>,
    pub(crate) place: Place,
}

/// Where a node stands in its parent's frame while nothing moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Place {
    /// By a map that nothing moves.
    Map(DMat4),
    /// By parts that clips move.
    Parts(Parts),
}

/// Scaled, turned, then shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Parts {
    pub(crate) shift: DVec3,
    pub(crate) turn: DQuat,
    pub(crate) scale: DVec3,
}

/// A node that a skin hangs on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) node: usize,
    /// From the mesh's frame to that of the node, as they were bound.
    pub(crate) inverse_bind: DMat4,
}

/// Nodes moved over a time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Clip {
    pub(crate) name: String,
    pub(crate) channels: Vec<Channel>,
    /// Times of its first and its last key [s].
    pub(crate) span: [f64; 2],
}

/// A part of a node's place that a clip moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Channel {
    pub(crate) node: usize,
    pub(crate) moves: Moves,
    pub(crate) track: Track,
}

/// Which part that is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Moves {
    Shift,
    Turn,
    Scale,
}

/// The mesh that hangs on the joints, where the file shows it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SkinMesh {
    pub(crate) points: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Joints that hold each point, and by how much; the shares of a point make one.
    pub(crate) held: Vec<Vec<(u32, f64)>>,
}

/// What of a clip is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Moment {
    /// A share of the way from where the file shows the skeleton to a time since the clip's first frame [s], and its
    /// rate [1/s].
    Eased { to: f64, share: f64, rate: f64 },
    /// A time since the first frame [s], and how fast that goes by.
    Played { time: f64, rate: f64 },
}

/// A map and its rate [1/s].
pub(crate) type Moving = [DMat4; 2];

/// The product of two maps, with its rate.
pub(crate) fn product(a: &Moving, b: &Moving) -> Moving {
    [a[0] * b[0], a[1] * b[0] + a[0] * b[1]]
}

impl Parts {
    fn map(&self) -> DMat4 {
        DMat4::from_scale_rotation_translation(self.scale, self.turn, self.shift)
    }
}

/// Parts of a place with their rates [1/s].
#[derive(Clone, Copy)]
struct MovingParts {
    shift: [DVec3; 2],
    turn: [DQuat; 2],
    scale: [DVec3; 2],
}

const STILL: DQuat = DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0);

impl MovingParts {
    fn still(parts: &Parts) -> Self {
        Self { shift: [parts.shift, DVec3::ZERO], turn: [parts.turn, STILL], scale: [parts.scale, DVec3::ZERO] }
    }

    /// On the way to others, which are still, by a share that changes at a rate [1/s].
    fn eased(parts: &Parts, to: &Self, [share, rate]: [f64; 2]) -> Self {
        let way = |a: DVec3, b: DVec3| [a + share * (b - a), rate * (b - a)];
        let [turn, by_share] = slerp(parts.turn, to.turn[0], share);
        Self {
            shift: way(parts.shift, to.shift[0]),
            turn: [turn, by_share * rate],
            scale: way(parts.scale, to.scale[0]),
        }
    }

    fn map(&self) -> Moving {
        let turn = columns_of(self.turn);
        let column = |k: usize| {
            let value = turn[0][k] * self.scale[0][k];
            let rate = turn[1][k] * self.scale[0][k] + turn[0][k] * self.scale[1][k];
            [value.extend(0.0), rate.extend(0.0)]
        };
        let columns = [column(0), column(1), column(2), [self.shift[0].extend(1.0), self.shift[1].extend(0.0)]];
        [0, 1].map(|of| DMat4::from_cols(columns[0][of], columns[1][of], columns[2][of], columns[3][of]))
    }
}

/// The columns of a rotation's matrix, and their rates: both are quadratic in its numbers.
fn columns_of([q, rate]: [DQuat; 2]) -> [[DVec3; 3]; 2] {
    // What the matrix is beside the identity, bilinear in the numbers of a and b.
    let form = |a: DQuat, b: DQuat| {
        let [x, y, z, w] = [a.x, a.y, a.z, a.w];
        let off = |i: f64, j: f64| 2.0 * (i + j);
        [
            DVec3::new(-2.0 * (y * b.y + z * b.z), off(x * b.y, w * b.z), off(x * b.z, -w * b.y)),
            DVec3::new(off(x * b.y, -w * b.z), -2.0 * (x * b.x + z * b.z), off(y * b.z, w * b.x)),
            DVec3::new(off(x * b.z, w * b.y), off(y * b.z, -w * b.x), -2.0 * (x * b.x + y * b.y)),
        ]
    };
    let (own, one, other) = (form(q, q), form(q, rate), form(rate, q));
    [[DVec3::X + own[0], DVec3::Y + own[1], DVec3::Z + own[2]], [0, 1, 2].map(|k| one[k] + other[k])]
}

impl Skeleton {
    /// The maps of its joints at a moment of a clip: from where the skin was bound to the file's space.
    pub(crate) fn joint_maps(&self, clip: usize, moment: Moment) -> Vec<Moving> {
        let worlds = self.worlds(clip, moment);
        let of = |joint: &Joint| worlds[joint.node].map(|world| world * joint.inverse_bind);
        self.joints.iter().map(of).collect()
    }

    /// Where the frames of its nodes are at a moment of a clip, in the file's space.
    pub(crate) fn worlds(&self, clip: usize, moment: Moment) -> Vec<Moving> {
        let parts = self.parts_at(clip, moment);
        let mut worlds: Vec<Moving> = Vec::with_capacity(self.nodes.len());
        for (node, parts) in self.nodes.iter().zip(parts) {
            let own = match (node.place, parts) {
                (Place::Map(map), _) => [map, DMat4::ZERO],
                (Place::Parts(still), None) => [still.map(), DMat4::ZERO],
                (Place::Parts(_), Some(parts)) => parts.map(),
            };
            worlds.push(match node.parent {
                Some(parent) => product(&worlds[parent], &own),
                None => own,
            });
        }
        worlds
    }

    /// The parts of the nodes that a clip moves.
    fn parts_at(&self, clip: usize, moment: Moment) -> Vec<Option<MovingParts>> {
        let mut found: Vec<Option<MovingParts>> = vec![None; self.nodes.len()];
        let Some(clip) = self.clips.get(clip) else { return found };
        let (time, speed) = match moment {
            Moment::Eased { to, .. } => (clip.span[0] + to, 0.0),
            Moment::Played { time, rate } => (clip.span[0] + time, rate),
        };
        let vector = |track: &Track| track.vector(time).map(DVec4::truncate);
        for Channel { node, moves, track } in &clip.channels {
            let Place::Parts(still) = self.nodes[*node].place else { continue };
            let parts = found[*node].get_or_insert_with(|| MovingParts::still(&still));
            match moves {
                Moves::Shift => parts.shift = with_speed(vector(track), speed),
                Moves::Scale => parts.scale = with_speed(vector(track), speed),
                Moves::Turn => {
                    let [turn, rate] = track.rotation(time);
                    parts.turn = [turn, rate * speed];
                }
            }
        }
        if let Moment::Eased { share, rate, .. } = moment {
            for (node, parts) in self.nodes.iter().zip(&mut found) {
                if let (Place::Parts(still), Some(to)) = (node.place, parts.as_mut()) {
                    *to = MovingParts::eased(&still, to, [share, rate]);
                }
            }
        }
        found
    }

    /// The bones of a joint: from where the file shows it to where it shows the joints that hang on it, or to itself
    /// where none does.
    pub(crate) fn bones(&self, joint: usize, worlds: &[Moving]) -> Vec<[DVec3; 2]> {
        let at = |joint: &Joint| worlds[joint.node][0].w_axis.truncate();
        let own = &self.joints[joint];
        // Between two joints there may be nodes that are none.
        let above = |node: usize| {
            let up = std::iter::successors(self.nodes[node].parent, |&node| self.nodes[node].parent);
            up.into_iter().find(|&node| self.joints.iter().any(|joint| joint.node == node))
        };
        let hanging = self.joints.iter().filter(|other| above(other.node) == Some(own.node));
        let bones: Vec<[DVec3; 2]> = hanging.map(|other| [at(own), at(other)]).collect();
        if bones.is_empty() { vec![[at(own); 2]] } else { bones }
    }

    /// Where it is shown while nothing moves.
    pub(crate) const AT_REST: Moment = Moment::Eased { to: 0.0, share: 0.0, rate: 0.0 };
}

fn with_speed([value, rate]: [DVec3; 2], speed: f64) -> [DVec3; 2] {
    [value, speed * rate]
}

#[cfg(test)]
mod tests {
    use super::super::track::Between;
    use super::*;

    fn parts(shift: DVec3, turn: DQuat, scale: DVec3) -> Place {
        Place::Parts(Parts { shift, turn, scale })
    }

    fn arm() -> Skeleton {
        let turns = [DQuat::from_rotation_z(0.4), DQuat::from_rotation_x(1.3), DQuat::from_rotation_z(0.4)];
        let turn = Channel {
            node: 1,
            moves: Moves::Turn,
            track: Track {
                times: vec![0.5, 1.0, 1.5],
                values: turns.map(DVec4::from).to_vec(),
                between: Between::Linear,
            },
        };
        let times = vec![0.5, 1.5];
        let grow = [DVec3::ONE, DVec3::new(1.2, 0.8, 1.5)].map(|scale| scale.extend(0.0)).to_vec();
        let scale = Channel {
            node: 1,
            moves: Moves::Scale,
            track: Track { times: times.clone(), values: grow, between: Between::Linear },
        };
        let rise = [DVec3::Y, DVec3::new(0.3, 1.5, 0.0)].map(|shift| shift.extend(0.0)).to_vec();
        let shift =
            Channel { node: 2, moves: Moves::Shift, track: Track { times, values: rise, between: Between::Linear } };
        let joint = |node| Joint { name: format!("joint {node}"), node, inverse_bind: DMat4::IDENTITY };
        Skeleton {
            nodes: vec![
                Node { parent: None, place: Place::Map(DMat4::from_translation(DVec3::X)) },
                Node { parent: Some(0), place: parts(DVec3::Y, DQuat::IDENTITY, DVec3::ONE) },
                Node { parent: Some(1), place: parts(DVec3::Y, DQuat::from_rotation_y(0.2), DVec3::ONE) },
            ],
            joints: vec![joint(1), joint(2)],
            clips: vec![Clip { name: "wave".to_owned(), channels: vec![turn, scale, shift], span: [0.5, 1.5] }],
            skin: SkinMesh::default(),
        }
    }

    #[test]
    fn rates_of_maps_are_those_of_the_maps() {
        let skeleton = arm();
        let d = 1e-6;
        let played = |time| Moment::Played { time, rate: 3.0 };
        let eased = |share| Moment::Eased { to: 0.3, share, rate: 3.0 };
        for (at, moments) in [0.1, 0.45, 0.8].into_iter().flat_map(|at| {
            let pair = [[played(at - d), played(at), played(at + d)], [eased(at - d), eased(at), eased(at + d)]];
            pair.map(|moments| (at, moments))
        }) {
            let [before, here, after] = moments.map(|moment| skeleton.joint_maps(0, moment));
            for k in 0..2 {
                let slope = (after[k][0] - before[k][0]) * (3.0 / (2.0 * d));
                assert!(slope.abs_diff_eq(here[k][1], 1e-7), "{at}: {slope:?}, not {:?}", here[k][1]);
            }
        }
    }

    #[test]
    fn a_skeleton_at_rest_is_where_its_file_shows_it() {
        let skeleton = arm();
        let worlds = skeleton.worlds(0, Skeleton::AT_REST);
        assert!(worlds[2][0].w_axis.truncate().distance(DVec3::new(1.0, 2.0, 0.0)) < 1e-15);
        assert_eq!(skeleton.bones(0, &worlds), [[DVec3::new(1.0, 1.0, 0.0), DVec3::new(1.0, 2.0, 0.0)]]);
        assert_eq!(skeleton.bones(1, &worlds), [[DVec3::new(1.0, 2.0, 0.0); 2]]);
        for to in [0.0, 0.7] {
            let eased = skeleton.worlds(0, Moment::Eased { to, share: 1.0, rate: 0.0 });
            let first = skeleton.worlds(0, Moment::Played { time: to, rate: 1.0 });
            for (a, b) in eased.iter().zip(&first) {
                assert!(a[0].abs_diff_eq(b[0], 1e-14));
            }
        }
    }
}
