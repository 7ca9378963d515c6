//! Finds one-way edges that nothing can land on.

use super::finding::Severity::Warning;
use super::index::{Index, Work};
use super::nesting;
use super::scene::{Body, Scene};
use crate::geometry::{Edge, Point, Side};

const WHY: &str = "a one-way edge stops only bodies entirely in front of it, and none can be there";

pub(super) fn check(scene: &mut Scene<'_>) {
    let hidden: Vec<_> = scene
        .surface
        .iter()
        .flat_map(|surface| surface.hidden.iter().map(|&cell| (cell, surface.middle(cell))))
        .collect();
    for (cell, at) in hidden {
        let what = format!("the one-way tile in column {}, row {} has a solid on its edge", cell.0, cell.1);
        scene.say((Warning, "unreachable"), vec![scene.tiles()], at, what, WHY);
    }
    let tiles = scene.surface.iter().flat_map(|surface| &surface.edges);
    let all: Vec<Edge> = scene.edges.iter().chain(tiles).copied().collect();
    let blockers: Vec<Edge> = all.iter().filter(|edge| edge.side != Side::OneWay).copied().collect();
    let index = Index::new(&blockers);
    let mut work = Work::for_edges(all.len());
    for edge in all.iter().filter(|edge| edge.side == Side::OneWay) {
        let blocked = blocked(scene, edge, &blockers, &index, &mut work);
        if work.is_spent() {
            return scene.say_unfinished(edge, "the linter did not check one-way edges from here on");
        }
        if let Some(what) = blocked {
            scene.say((Warning, "unreachable"), vec![scene.who(edge)], edge.middle(), what, WHY);
        }
    }
}

fn blocked(scene: &Scene<'_>, edge: &Edge, blockers: &[Edge], index: &Index, work: &mut Work) -> Option<&'static str> {
    let (reach, room) = room(scene.rules.body, edge);
    let near = index.near(edge, reach, work);
    let mut covered: Vec<(i128, i128)> = near.filter_map(|i| cover(edge, &blockers[i], room)).collect();
    covered.sort_unstable();
    let mut done = 0;
    for (from, to) in covered {
        if from <= done {
            done = done.max(to);
        }
    }
    if done >= edge.length_squared() {
        return Some(match scene.rules.body {
            None => "a solid lies along its whole front",
            Some(_) => "a solid along its whole front is nearer than the size of the body",
        });
    }
    let mut buried = |p: Point| {
        nesting::depth(scene, p, None, work) > 0 || scene.surface.as_ref().is_some_and(|surface| surface.is_full(p))
    };
    let doubled =
        [(2 * edge.a.0, 2 * edge.a.1), (2 * edge.b.0, 2 * edge.b.1), (edge.a.0 + edge.b.0, edge.a.1 + edge.b.1)];
    doubled.into_iter().all(&mut buried).then_some("it lies within the solid")
}

/// How far in front of the edge a body that stands on it reaches: in raw units, rounded up, and in
/// lengths of the edge's normal.
fn room(body: Option<Body>, edge: &Edge) -> (i64, i128) {
    let (x, y) = edge.normal();
    match body {
        // Only points on the edge itself.
        None => (0, 1),
        Some(Body::Box { width, height }) => {
            (width + height, i128::from(width) * x.abs() + i128::from(height) * y.abs())
        }
        Some(Body::Circle { radius }) => {
            let diameter = i128::from(2 * radius);
            let square = diameter * diameter * edge.length_squared();
            let root = square.isqrt();
            (2 * radius, root + i128::from(root * root < square))
        }
    }
}

/// The part of the edge in front of which a blocker is closer than `room`, as dot products with its
/// direction.
fn cover(edge: &Edge, blocker: &Edge, room: i128) -> Option<(i128, i128)> {
    let (d, n) = (edge.dir(), edge.normal());
    let frame = |p: Point| {
        let (x, y) = (i128::from(p.0 - edge.a.0), i128::from(p.1 - edge.a.1));
        (x * d.0 + y * d.1, x * n.0 + y * n.1)
    };
    let (mut from, mut to) = (frame(blocker.a), frame(blocker.b));
    if from.0 > to.0 {
        std::mem::swap(&mut from, &mut to);
    }
    let (u, v) = (to.0 - from.0, to.1 - from.1);
    if u == 0 || from.1.max(to.1) < 0 || from.1.min(to.1) >= room {
        return None;
    }
    // The position of the blocker at a height. u and v are below 2^62. Rounds into the covered
    // part.
    let at = |height: i128, up: bool| {
        let numerator = (height - from.1) * u;
        from.0 + if up { -(-numerator).div_euclid(v) } else { numerator.div_euclid(v) }
    };
    let enters = match from.1 {
        low if low < 0 => at(0, v > 0),
        high if high >= room => at(room - 1, v > 0),
        _ => from.0,
    };
    let leaves = match to.1 {
        low if low < 0 => at(0, v < 0),
        high if high >= room => at(room - 1, v < 0),
        _ => to.0,
    };
    (enters <= leaves).then_some((enters, leaves))
}
