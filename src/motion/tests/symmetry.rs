//! Mirrored, transposed and moved features give mirrored, transposed and the same bits.

use super::super::body::{Entry, kernel::Kernel};
use super::polygons::SOLIDS;
use super::std::vec::Vec;
use super::{P, Random, cases, circle, feature, outline, raw, vec2};
use crate::num::Axis;
use crate::world::{Feature, Geometry};

/// A view of directions; those that turn the plane over turn the order of edges.
const VIEWS: [fn(P) -> P; 4] = [|p| (-p.0, p.1), |p| (p.0, -p.1), |p| (p.1, p.0), |p| (p.0, p.1)];

fn seen(f: &Feature, view: fn(P) -> P, by: P) -> Feature {
    let point = |p: crate::num::Vec2| {
        let (x, y) = p.raw();
        let q = view((x.into(), y.into()));
        (q.0 + by.0, q.1 + by.1)
    };
    let axis = |a: Axis| {
        let q = view((a.x.into(), a.y.into()));
        Axis::new(q.0 as i32, q.1 as i32)
    };
    let turns = {
        let (x, y) = (view((1, 0)), view((0, 1)));
        x.0 * y.1 - x.1 * y.0 < 0
    };
    feature(match f.geometry {
        Geometry::Face { a, dir, len, joined } if turns => {
            let (p, e) = (point(a), axis(dir));
            let end = (p.0 + i64::from(e.x) * i64::from(len), p.1 + i64::from(e.y) * i64::from(len));
            Geometry::Face { a: vec2(end), dir: e.reversed(), len, joined: [joined[1], joined[0]] }
        }
        Geometry::Face { a, dir, len, joined } => Geometry::Face { a: vec2(point(a)), dir: axis(dir), len, joined },
        Geometry::Vertex { p, e_in, e_out } if turns => {
            Geometry::Vertex { p: vec2(point(p)), e_in: axis(e_out).reversed(), e_out: axis(e_in).reversed() }
        }
        Geometry::Vertex { p, e_in, e_out } => {
            Geometry::Vertex { p: vec2(point(p)), e_in: axis(e_in), e_out: axis(e_out) }
        }
        Geometry::Arc { centre, radius, quadrant, convex } => {
            Geometry::Arc { centre: vec2(point(centre)), radius, quadrant: axis(quadrant), convex }
        }
    })
}

type Bits = (u32, u32, P, P);

fn bits(entry: Entry, d: P, view: fn(P) -> P) -> Bits {
    let q = entry.displacement(raw(d));
    (entry.num, entry.den, view((entry.normal.x.into(), entry.normal.y.into())), view((q.x.into(), q.y.into())))
}

#[test]
fn every_view() {
    let (mut r, mut hits) = (Random::new(5), 0);
    for _ in 0..cases(20_000) {
        let scale = 1 + r.magnitude(1 << 22);
        let solid: Vec<P> = SOLIDS[r.below(12) as usize].iter().map(|p| (p.0 * scale, p.1 * scale)).collect();
        let mut features = outline(&solid);
        for convex in [true, false] {
            let quadrant = Axis::new(r.sign() as i32, r.sign() as i32);
            let centre = vec2((r.around(4) * scale, r.around(4) * scale));
            features.push(feature(Geometry::Arc { centre, radius: 4 * scale as i32, quadrant, convex }));
        }
        let longest = 4 * scale;
        let d = (r.sign() * r.magnitude(longest), r.sign() * r.magnitude(longest));
        let (c, radius) = ((r.around(8 * scale), r.around(8 * scale)), 1 + r.magnitude(4 * scale));
        // Half of them toward the middle.
        let d = if r.one_in(2) { d } else { (2 * scale - c.0 + r.around(scale), 2 * scale - c.1 + r.around(scale)) };
        let by = (r.around(1 << 27), r.around(1 << 27));
        for f in &features {
            let here = circle(c, radius).sweep(raw(d), f);
            hits += u64::from(here.is_some());
            for view in VIEWS {
                let at = view(c);
                let other = circle((at.0 + by.0, at.1 + by.1), radius).sweep(raw(view(d)), &seen(f, view, by));
                assert_eq!(
                    other.map(|e| bits(e, view(d), |p| p)),
                    here.map(|e| bits(e, d, view)),
                    "{f:?} circle {c:?} {radius} by {d:?}"
                );
            }
        }
    }
    assert!(hits > cases(20_000) / 8, "{hits}");
}
