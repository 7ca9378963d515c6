//! Edges that cross, cover or touch each other.

use std::collections::HashSet;

use super::finding::Severity::{Error, Note, Warning};
use super::finding::{Severity, Who};
use super::index::Work;
use super::scene::Scene;
use crate::geometry::{Edge, Meeting, Point, Side, meet};
use crate::rules::kind::Kind;

/// Returns the outlines that cross another one or themselves, and those that were not checked to
/// the end.
pub(super) fn check(scene: &mut Scene<'_>) -> HashSet<usize> {
    let mut crossed = HashSet::new();
    let mut work = Work::for_edges(scene.edges.len());
    for i in 0..scene.edges.len() {
        let s = scene.edges[i];
        let near: Vec<usize> = scene.index.near(&s, 0, &mut work).filter(|&j| j > i).collect();
        for j in near {
            let t = scene.edges[j];
            let meeting = meet(&s, &t);
            if let Meeting::Cross(_) = meeting {
                crossed.extend([s.outline, t.outline].into_iter().flatten());
            }
            say(scene, [&s, &t], meeting);
        }
        if work.is_spent() {
            scene.say_unfinished(&s, "the linter did not compare the edges from here on");
            crossed.extend(scene.edges[i..].iter().filter_map(|edge| edge.outline));
            break;
        }
    }
    crossed
}

fn say(scene: &mut Scene<'_>, [s, t]: [&Edge; 2], meeting: Meeting) {
    let who = |scene: &Scene<'_>| vec![scene.who(s), scene.who(t)];
    match meeting {
        Meeting::Apart => {}
        Meeting::SharedEnd(at) => shared_end(scene, [s, t], at),
        Meeting::Cross(at) => crossing(scene, [s, t], who(scene), at),
        Meeting::Tee(at) if s.outline == t.outline => touches_itself(scene, who(scene), at),
        Meeting::Tee(at) => {
            let why = "the solids are joined there, and bodies meet no corner";
            scene.say((Note, "t-junction"), who(scene), at, "one ends within the other", why);
        }
        Meeting::Overlap { at, reversed, whole } => overlap(scene, [s, t], who(scene), (at, reversed, whole)),
    }
}

fn kinds(scene: &Scene<'_>, edges: [&Edge; 2]) -> [Kind; 2] {
    edges.map(|edge| edge.outline.map_or(Kind::Solid, |outline| scene.drawing.outlines[outline].kind))
}

fn touches_itself(scene: &mut Scene<'_>, who: Vec<Who>, at: Point) {
    let why = "two parts of one outline meet in a point that bodies cannot pass";
    scene.say((Warning, "self-touch"), who, at, "the outline touches itself", why);
}

/// Only corners that occur twice. Neighbours share a corner anyway.
fn shared_end(scene: &mut Scene<'_>, [s, t]: [&Edge; 2], at: Point) {
    let Some(outline) = s.outline.filter(|_| s.outline == t.outline) else { return };
    let points = &scene.drawing.outlines[outline].points;
    let apart = s.number.abs_diff(t.number);
    // Another check reports points that repeat the one before.
    let repeats = points[s.number.min(t.number)..=s.number.max(t.number)].iter().all(|&p| p == at);
    if apart > 0 && !repeats && points[s.number] == at && points[t.number] == at {
        touches_itself(scene, vec![scene.who(s), scene.who(t)], at);
    }
}

fn crossing(scene: &mut Scene<'_>, edges: [&Edge; 2], who: Vec<Who>, at: Point) {
    let [s, t] = edges;
    if s.outline == t.outline {
        // Their union keeps what lies over each other.
        if s.outline.is_some_and(|outline| scene.drawing.outlines[outline].title.is_tiles()) {
            let why = "a body may catch where they cross: no corner is there; move one, or cut it off at the other";
            return scene.say((Warning, "crossing"), who, at, "collision shapes of tiles cross", why);
        }
        let why = "inside and outside change places there";
        let severity = if s.side == Side::Solid { Error } else { Warning };
        return scene.say((severity, "self-crossing"), who, at, "the outline crosses itself", why);
    }
    let kinds = kinds(scene, edges);
    let (severity, why): (Severity, _) = if kinds.contains(&Kind::OneWay) {
        (Note, "a one-way edge continues within")
    } else if kinds.contains(&Kind::Hole) {
        (Error, "a hole in nothing keeps an edge that bodies meet from one side")
    } else {
        (
            Warning,
            "a body may catch where they cross: no corner is there; put one on the other's edge, or draw one polygon",
        )
    };
    scene.say((severity, "crossing"), who, at, "they cross", why);
}

fn overlap(scene: &mut Scene<'_>, edges: [&Edge; 2], who: Vec<Who>, (at, reversed, whole): (Point, bool, bool)) {
    let [s, t] = edges;
    let sides = (s.side, t.side);
    let extent = if whole { "they are the same edge" } else { "they lie on each other for a part of their length" };
    // Walls have no direction.
    let reversed = reversed && s.side != Side::Wall && t.side != Side::Wall;
    if s.side != t.side {
        let why = "bodies meet both, and one can hide the other if that has one side";
        return scene.say((Note, "overlap"), who, at, extent, why);
    }
    if !reversed {
        let why = "each query meets the same face twice";
        return scene.say((Error, "duplicate"), who, at, extent, why);
    }
    let what = format!("{extent}, the other way round");
    match sides {
        (Side::Solid, _) if s.outline == t.outline => {
            let why = "the outline doubles back: a spike without area";
            scene.say((Error, "reversed"), who, at, what, why);
        }
        (Side::Solid, _) => {
            let why = "the two cancel and the solids are joined; draw them as one to save the work";
            scene.say((Note, "reversed"), who, at, what, why);
        }
        _ => scene.say((Warning, "reversed"), who, at, what, "two one-way edges back to back are a wall: draw a wall"),
    }
}
