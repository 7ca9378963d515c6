//! The common hobby form. Moves by the whole velocity, then pushes the body out of one wall after
//! the other.

use super::scalar::Scalar;
use crate::engine::{Engine, State};
use crate::scene::{Scene, Shape, Start};

/// Pushes a ball out of segments, or a box out of boxes.
pub struct Textbook<S> {
    body: Body<S>,
    obstacles: Vec<[[S; 2]; 2]>,
    gravity: S,
    /// 1 + restitution.
    kick: S,
    p: [S; 2],
    v: [S; 2],
}

enum Body<S> {
    Ball(S),
    Box([S; 2]),
}

impl<S: Scalar> Textbook<S> {
    /// Walls are at most `limit` long.
    pub fn new(scene: &Scene, start: &Start, limit: i32) -> Option<Self> {
        let point = |p: [i32; 2]| p.map(S::of_raw);
        Some(Self {
            body: match scene.shape {
                Shape::Ball(radius) => Body::Ball(S::of_raw(radius)),
                Shape::Box(half) => Body::Box(point(half)),
            },
            obstacles: scene.obstacles(limit)?.into_iter().map(|pair| pair.map(point)).collect(),
            gravity: S::of_raw(scene.gravity),
            kick: S::of_256(256 + scene.bounce),
            p: point(start.centre),
            v: point(start.velocity),
        })
    }
}

fn dot<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[0] + a[1] * b[1]
}

/// Outward normal and depth.
type Contact<S> = Option<([S; 2], S)>;

/// A ball and a segment: the closest point, by the projection on the segment.
fn ball<S: Scalar>(p: [S; 2], radius: S, [a, b]: [[S; 2]; 2]) -> Contact<S> {
    let outside =
        |i: usize| (p[i] + radius < a[i] && p[i] + radius < b[i]) || (p[i] - radius > a[i] && p[i] - radius > b[i]);
    if outside(0) || outside(1) {
        return None;
    }
    let (zero, one) = (S::of_raw(0), S::of_raw(1 << 16));
    let d = [b[0] - a[0], b[1] - a[1]];
    let t = dot([p[0] - a[0], p[1] - a[1]], d) / dot(d, d);
    let t = if t < zero {
        zero
    } else if t > one {
        one
    } else {
        t
    };
    let m = [p[0] - (a[0] + d[0] * t), p[1] - (a[1] + d[1] * t)];
    let square = dot(m, m);
    if square >= radius * radius {
        return None;
    }
    let distance = square.root();
    (distance > zero).then(|| ([m[0] / distance, m[1] / distance], radius - distance))
}

/// A box and a box: the side that is nearest.
fn cuboid<S: Scalar>(p: [S; 2], half: [S; 2], [lo, hi]: [[S; 2]; 2]) -> Contact<S> {
    let zero = S::of_raw(0);
    let one = S::of_raw(1 << 16);
    let before = [p[0] + half[0] - lo[0], p[1] + half[1] - lo[1]];
    let after = [hi[0] - (p[0] - half[0]), hi[1] - (p[1] - half[1])];
    if before[0] <= zero || before[1] <= zero || after[0] <= zero || after[1] <= zero {
        return None;
    }
    let nearest = |i: usize| if before[i] < after[i] { (-one, before[i]) } else { (one, after[i]) };
    let (x, y) = (nearest(0), nearest(1));
    Some(if x.1 < y.1 { ([x.0, zero], x.1) } else { ([zero, y.0], y.1) })
}

impl<S: Scalar> Engine for Textbook<S> {
    fn frame(&mut self) {
        self.v[1] = self.v[1] + self.gravity;
        self.p = [self.p[0] + self.v[0], self.p[1] + self.v[1]];
        for obstacle in &self.obstacles {
            let contact = match self.body {
                Body::Ball(radius) => ball(self.p, radius, *obstacle),
                Body::Box(half) => cuboid(self.p, half, *obstacle),
            };
            let Some((n, depth)) = contact else { continue };
            self.p = [self.p[0] + n[0] * depth, self.p[1] + n[1] * depth];
            let into = dot(self.v, n);
            if into < S::of_raw(0) {
                let push = into * self.kick;
                self.v = [self.v[0] - n[0] * push, self.v[1] - n[1] * push];
            }
        }
    }

    fn state(&self) -> State {
        State { centre: self.p.map(S::px), velocity: self.v.map(S::px) }
    }

    fn shift(&mut self, by: i32) {
        self.p[0] = self.p[0] + S::of_raw(by);
    }
}
