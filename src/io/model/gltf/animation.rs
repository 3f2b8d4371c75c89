//! The animations of a glTF document, as clips of its nodes.

use super::super::failure::Failure;
use super::accessor::{Accessors, Whole};
use crate::geometry::skeleton::{Channel, Clip, Moves};
use crate::geometry::track::{Between, Track};
use crate::io::json::pointer_of;
use crate::scene::brief;
use glam::DVec4;
use serde::Deserialize;

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Animation {
    name: String,
    channels: Vec<AnimationChannel>,
    samplers: Vec<Sampler>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct AnimationChannel {
    sampler: usize,
    target: Target,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Target {
    node: Option<usize>,
    path: String,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Sampler {
    input: usize,
    output: usize,
    interpolation: Option<String>,
}

/// The clips of a document that move nodes; `order` says where each of its nodes stands in the skeleton.
pub(super) fn clips(accessors: &Accessors<'_>, order: &[usize]) -> Result<Vec<Clip>, Failure> {
    let value = &accessors.document.animations;
    if value.is_null() {
        return Ok(Vec::new());
    }
    let animations: Vec<Animation> = serde_path_to_error::deserialize(value).map_err(|error| {
        let pointer = pointer_of(error.path());
        let found = value.pointer(&pointer).map_or_else(|| "what is there".to_owned(), brief);
        Failure::new(format_args!("/animations{pointer}: {found} is not what glTF has there"))
    })?;
    let mut clips: Vec<Clip> = Vec::new();
    for (index, animation) in animations.iter().enumerate() {
        let name = format!("animations[{index}]");
        let mut channels = Vec::new();
        for (number, channel) in animation.channels.iter().enumerate() {
            channels.extend(read(accessors, order, animation, channel, &format!("{name}.channels[{number}]"))?);
        }
        let span = channels.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[first, last], channel: &Channel| {
            let times = &channel.track.times;
            [first.min(times[0]), last.max(times[times.len() - 1])]
        });
        if !channels.is_empty() {
            let name = if animation.name.trim().is_empty() { name } else { animation.name.clone() };
            clips.push(Clip { name, channels, span });
        }
    }
    Ok(clips)
}

/// What a channel moves; nothing where that is no node's place.
fn read(
    accessors: &Accessors<'_>,
    order: &[usize],
    animation: &Animation,
    channel: &AnimationChannel,
    name: &str,
) -> Result<Option<Channel>, Failure> {
    let (moves, kind, width) = match channel.target.path.as_str() {
        "translation" => (Moves::Shift, "VEC3", 3),
        "scale" => (Moves::Scale, "VEC3", 3),
        "rotation" => (Moves::Turn, "VEC4", 4),
        _ => return Ok(None),
    };
    let Some(node) = channel.target.node else { return Ok(None) };
    let Some(&node) = order.get(node) else {
        return Err(Failure::new(format_args!("{name} moves nodes[{node}], which is not there")));
    };
    let Some(sampler) = animation.samplers.get(channel.sampler) else {
        let problem = format_args!("{name} refers to samplers[{}], which is not there", channel.sampler);
        return Err(Failure::new(problem));
    };
    let times = accessors.read(sampler.input, &["SCALAR"], Whole::AsSaid, &format!("times of {name}"))?.values;
    if times.is_empty() {
        return Err(Failure::new(format_args!("{name} has no keys")));
    }
    let sound = times.iter().all(|time| time.is_finite()) && times.windows(2).all(|pair| pair[0] < pair[1]);
    if !sound {
        return Err(Failure::new(format_args!("{name}: the times of its keys are no ascending numbers")));
    }
    let rows = accessors.read(sampler.output, &[kind], Whole::AsSaid, &format!("values of {name}"))?;
    if !rows.values.iter().all(|value| value.is_finite()) {
        return Err(Failure::new(format_args!("{name}: a value of its keys is no number")));
    }
    let vector = |row: &[f64]| DVec4::new(row[0], row[1], row[2], if width == 4 { row[3] } else { 0.0 });
    let all: Vec<DVec4> = rows.rows().map(vector).collect();
    // A key takes two thirds of the memory of a vertex, the reading of it included.
    accessors.keep(2 * all.len() / 3)?;
    let is_cubic = sampler.interpolation.as_deref() == Some("CUBICSPLINE");
    let expected = if is_cubic { 3 * times.len() } else { times.len() };
    if all.len() != expected {
        return Err(Failure::new(format_args!("{name} has {} values where {expected} belong to its keys", all.len())));
    }
    let (mut values, between) = match sampler.interpolation.as_deref() {
        None | Some("LINEAR") => (all, Between::Linear),
        Some("STEP") => (all, Between::Stepped),
        Some("CUBICSPLINE") => {
            let values = all.chunks_exact(3).map(|key| key[1]).collect();
            (values, Between::Cubic(all.chunks_exact(3).map(|key| [key[0], key[2]]).collect()))
        }
        Some(other) => {
            let problem = format_args!("{name} has the interpolation {}, which is none", brief(&other));
            return Err(Failure::new(problem));
        }
    };
    if moves == Moves::Turn {
        for value in &mut values {
            *value = value.try_normalize().ok_or_else(|| {
                Failure::new(format_args!("{name}: a rotation of its keys is of no length, which turns nowhere"))
            })?;
        }
    }
    Ok(Some(Channel { node, moves, track: Track { times, values, between } }))
}
