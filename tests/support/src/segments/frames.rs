//! Frames of motion among polygons, walls and one-way chains. The original polygons judge them.

use crate::segments::{Body, P, Piece, Scene};
use tilesat::{Aabb, Circle, Fx, MoveError, Moved, Mover, PathKind, Response, SegmentMap, Vec2};

pub fn at(body: Body, by: P) -> Body {
    let add = |p: P| (p.0 + by.0, p.1 + by.1);
    match body {
        Body::Box { lo, hi } => Body::Box { lo: add(lo), hi: add(hi) },
        Body::Circle { c, r } => Body::Circle { c: add(c), r },
    }
}

pub fn place(body: Body) -> P {
    match body {
        Body::Box { lo, .. } => lo,
        Body::Circle { c, .. } => c,
    }
}

pub fn len2(v: P) -> i128 {
    v.0 * v.0 + v.1 * v.1
}

/// The end of a call, its velocity, whether it hit something solid or anything, and the part of the
/// motion before.
pub struct Step {
    pub body: Body,
    pub v: P,
    pub solid: bool,
    pub free: bool,
    pub toi: i128,
}

pub fn step(scene: &Scene, map: &SegmentMap, mover: &Mover, body: Body, v: P) -> Result<Step, MoveError> {
    let velocity = Vec2::from_raw(v.0 as i32, v.1 as i32);
    match body {
        Body::Box { lo, hi } => {
            let b = Aabb::new(scene.vec2(lo), scene.vec2(hi)).unwrap();
            mover.move_and_slide(map, &b, velocity).map(|m| made(scene, body, &m))
        }
        Body::Circle { c, r } => {
            let b = Circle::new(scene.vec2(c), Fx::from_bits(r as i32)).unwrap();
            mover.move_and_slide(map, &b, velocity).map(|m| made(scene, body, &m))
        }
    }
}

pub fn made<B: tilesat::Body>(scene: &Scene, body: Body, m: &Moved<B>) -> Step {
    let (p, q) = (place(body), scene.local(m.position()));
    let (x, y) = m.velocity.raw();
    let first = m.hits.first();
    Step {
        body: at(body, (q.0 - p.0, q.1 - p.1)),
        v: (x.into(), y.into()),
        solid: first.is_some_and(|h| !h.one_way),
        free: first.is_none(),
        toi: first.map_or(1 << 30, |h| h.toi.raw().into()),
    }
}

#[derive(Debug, Default)]
pub struct Tally {
    pub frames: u64,
    pub hits: u64,
    pub refused: u64,
    pub unconfirmed: u64,
    pub at_rest: u64,
}

/// The first contact: sixteenths of the way are free, and a little farther it overlaps.
pub fn judge_way(scene: &Scene, blocking: &[Piece], map: &SegmentMap, body: Body, v: P, tally: &mut Tally) {
    let touch = step(scene, map, &Mover::new().with_response(Response::Touch), body, v).unwrap();
    for k in (0..=16).filter(|k| k << 26 <= touch.toi) {
        // Sixteenths are places of the lattice.
        let there = at(body, (v.0 / 16 * k, v.1 / 16 * k));
        assert!(!scene.overlaps(blocking, there), "passes through: {scene:?} {body:?} by {v:?}");
    }
    if touch.solid {
        let length = len2(v).isqrt().max(1);
        let confirmed = [2, 4, 8, 32, 128].iter().any(|k| {
            let far = |d: i128| (d * k * 2 + d.signum() * length) / (2 * length);
            scene.overlaps(blocking, at(touch.body, (far(v.0), far(v.1))))
        });
        tally.unconfirmed += u64::from(!confirmed);
    }
}

/// Whether there is solid behind every edge. A polygon that crosses itself, or a hole in nothing,
/// has edges that stop a body only from one side, and on which none can rest.
pub fn is_proper(scene: &Scene) -> bool {
    let cross = |o: P, a: P, b: P| (a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0);
    let apart = |p: P, q: P, a: P, b: P| cross(a, b, p).signum() * cross(a, b, q).signum() > 0;
    let between = |p: P, a: P, b: P| {
        let inside = |p: i128, a: i128, b: i128| a.min(b) <= p && p <= a.max(b);
        cross(a, b, p) == 0 && inside(p.0, a.0, b.0) && inside(p.1, a.1, b.1)
    };
    scene.shapes.iter().all(|s| match s.kind {
        PathKind::Solid => {
            let edges = s.edges();
            let n = edges.len();
            (0..n).all(|i| {
                (0..n).filter(|j| *j != i).all(|j| {
                    let ((a, b), (p, q)) = (edges[i], edges[j]);
                    // Neighbours share an end, and nothing else.
                    let (next, before) = (j == (i + 1) % n, i == (j + 1) % n);
                    if next || before {
                        let far = if next { q } else { p };
                        return !between(far, a, b) && !between(if next { a } else { b }, p, q);
                    }
                    let meet = !apart(p, q, a, b) && !apart(a, b, p, q);
                    !meet || (cross(a, b, p) == 0 && cross(a, b, q) == 0 && !between(p, a, b) && !between(q, a, b))
                })
            })
        }
        PathKind::Hole => false,
        _ => true,
    })
}
