//! The kernels of circles and capsules against exact algebra that shares nothing with them.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    reason = "tests stop at the first surprise"
)]

extern crate std;

mod ahead;
mod arcs;
mod block_entry;
mod block_lines;
mod boxes;
mod convex;
mod convex_arcs;
mod only_hit;
mod order;
mod polygons;
mod sides;
mod symmetry;

use self::std::vec::Vec;
use super::body::{Body, Entry, kernel::Kernel};
use super::order::First;
use crate::num::{Axis, Fx, Raw, Vec2};
use crate::shape::{AnyShape, Capsule, Circle, ConvexPolygon};
use crate::world::{Cell, Feature, Geometry, SegmentMap};
use tilesat_judge::{Random, cases, enough};

type P = (i64, i64);

const fn raw(p: P) -> Raw {
    Raw { x: p.0 as i32, y: p.1 as i32 }
}

const fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

fn axis(p: P) -> Axis {
    let gcd = gcd(p.0.unsigned_abs(), p.1.unsigned_abs()) as i64;
    Axis::new((p.0 / gcd) as i32, (p.1 / gcd) as i32)
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

const fn feature(geometry: Geometry) -> Feature {
    Feature { geometry, cell: Cell { x: 0, y: 0 }, index: 0, flags: 0, one_way: false, source: 0 }
}

fn circle(c: P, r: i64) -> Circle {
    Circle::from_raw_unchecked(raw(c), r as i32)
}

/// A capsule whose core is as long as `size`, which is along x or y.
fn capsule(c: P, size: P, r: i64) -> Capsule {
    Capsule::from_raw_unchecked(raw(c), raw((c.0 + size.0, c.1 + size.1)), Fx::from_bits(r as i32))
}

/// The first hit of all, as the mover takes it.
fn first<B: Body>(body: &B, d: P, features: &[Feature]) -> Option<Entry> {
    let (d, mut first) = (raw(d), First::none());
    for feature in features {
        if let Some(entry) = body.sweep(d, feature) {
            first.add::<B, SegmentMap<'_>>(&entry, feature, d);
        }
    }
    first.hit::<B, SegmentMap<'_>>(body, d).map(|hit| *hit.0)
}

/// The boundary of a polygon that turns from x toward y, so its solid is on the left. It has a face
/// per edge, and a vertex where it is convex.
fn outline(points: &[P]) -> Vec<Feature> {
    let n = points.len();
    let edge = |i: usize| {
        let (a, b) = (points[i % n], points[(i + 1) % n]);
        let d = (b.0 - a.0, b.1 - a.1);
        (d, axis(d), gcd(d.0.unsigned_abs(), d.1.unsigned_abs()) as i32)
    };
    let convex = |i: usize| {
        let ((p, ..), (q, ..)) = (edge(i + n - 1), edge(i));
        let cross = i128::from(p.0) * i128::from(q.1) - i128::from(p.1) * i128::from(q.0);
        cross > 0 || (cross == 0 && i128::from(p.0) * i128::from(q.0) + i128::from(p.1) * i128::from(q.1) < 0)
    };
    let mut out = Vec::new();
    for i in 0..n {
        let (_, dir, len) = edge(i);
        let joined = [!convex(i), !convex(i + 1)];
        out.push(feature(Geometry::Face { a: vec2(points[i]), dir, len, joined }));
        if convex(i + 1) {
            let p = vec2(points[(i + 1) % n]);
            out.push(feature(Geometry::Vertex { p, e_in: dir, e_out: edge(i + 1).1 }));
        }
    }
    out
}
