//! Casts that meet two things at one moment: corners of a shape, and parts of a compound.

use tilesat::prelude::*;
use tilesat::shape::{Compound, ConvexParts};
use tilesat::{Aabb, Capsule, CastHit, Circle, ConvexPolygon, Fx, Inside, Segment, Vec2};
use tilesat_judge::{Random, cases};

const UNIT: i64 = 1 << 16;

fn raw((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

fn reversed(v: Vec2) -> Vec2 {
    Vec2::ZERO - v
}

fn mirrored(v: Vec2) -> Vec2 {
    let (x, y) = v.raw();
    Vec2::from_raw(-x, y)
}

/// Time and displacement. Normals are not compared, because two may be equally good.
fn course(hit: Option<CastHit>) -> Option<(u32, Vec2)> {
    hit.map(|hit| (hit.toi.raw(), hit.displacement))
}

/// A circle that comes to a thin capsule from the front meets both ends within a part in 2^30.
#[test]
fn two_corners_at_one_moment_are_met_alike_from_both_sides() {
    let mut hits = 0;
    let mut r = Random::new(77);
    for _ in 0..cases(300_000) {
        let wide = [3, UNIT][r.below(2) as usize];
        let end = (r.within(0, wide), r.within(0, wide));
        let at = (r.within(-200, 200) * UNIT, r.within(-200, 200) * UNIT);
        let radius = Fx::from_bits(r.within(UNIT, 50 * UNIT) as i32);
        let ends = (raw((-end.0, end.1)), raw((end.0, -end.1)));
        let (Ok(ball), Ok(capsule)) = (Circle::new(raw(at), radius), Capsule::new(ends.0, ends.1, Fx::ZERO)) else {
            continue;
        };
        let d = raw((r.within(-2, 2) - at.0, r.within(-2, 2) - at.1));
        let hit = course(ball.cast_shape(&capsule, d, Inside::Ignore).unwrap());
        let back = course(capsule.cast_shape(&ball, reversed(d), Inside::Ignore).unwrap());
        assert_eq!(hit, back.map(|(toi, by)| (toi, reversed(by))), "{ball:?} {capsule:?} by {d:?}");
        let twin = Circle::new(mirrored(ball.centre()), radius).unwrap();
        let other = Capsule::new(mirrored(ends.0), mirrored(ends.1), Fx::ZERO).unwrap();
        let seen = course(twin.cast_shape(&other, mirrored(d), Inside::Ignore).unwrap());
        assert_eq!(hit, seen.map(|(toi, by)| (toi, mirrored(by))), "{ball:?} {capsule:?} by {d:?}");
        hits += u64::from(hit.is_some());
    }
    assert!(hits > cases(300_000) / 2, "{hits}");
}

/// Moved by the displacement, a shape overlaps no part, and the order of the parts does not matter.
fn judge<A, S, const M: usize>(a: &A, parts: [S; M], d: Vec2) -> bool
where
    A: CastShape<Compound<S, M>>
        + Overlaps<Compound<S, M>>
        + Contacts<Compound<S, M>>
        + Manifolds<Compound<S, M>>
        + Moved
        + core::fmt::Debug,
    S: tilesat::shape::Single + core::fmt::Debug,
{
    let Ok(whole) = Compound::<S, M>::new(&parts) else { return false };
    let mut turned = parts;
    turned.reverse();
    let other = Compound::<S, M>::new(&turned).unwrap();
    assert_eq!(a.contact(&whole), a.contact(&other), "{a:?} {parts:?}");
    assert_eq!(a.manifold(&whole), a.manifold(&other), "{a:?} {parts:?}");
    let hit = a.cast_shape(&whole, d, Inside::Hit).unwrap();
    assert_eq!(hit, a.cast_shape(&other, d, Inside::Hit).unwrap(), "{a:?} {parts:?} by {d:?}");
    let Some(hit) = hit.filter(|hit| !hit.inside) else { return false };
    let ((x, y), (to_x, to_y)) = (hit.displacement.raw(), d.raw());
    let within = |made: i32, to: i32| (0..=to).contains(&made) || (to..=0).contains(&made);
    assert!(within(x, to_x) && within(y, to_y), "{a:?} {parts:?} by {d:?}: {hit:?}");
    assert!(!a.moved(hit.displacement).overlaps(&whole), "{a:?} {parts:?} by {d:?}: {hit:?}");
    true
}

trait Moved {
    fn moved(&self, by: Vec2) -> Self;
}

macro_rules! moved {
    ($([$($n:tt)*] $shape:ty),*) => {$(
        impl<$($n)*> Moved for $shape {
            fn moved(&self, by: Vec2) -> Self {
                self.translated(by).unwrap()
            }
        }
    )*};
}
moved!([] Circle, [] Segment, [const N: usize] ConvexPolygon<N>);

#[test]
fn what_is_cast_at_a_compound_ends_outside_of_all_parts() {
    let mut r = Random::new(11);
    let mut hits = [0; 5];
    for k in 0..cases(300_000) {
        let wide = [4, 30, 300][(k % 3) as usize];
        let d = raw((r.within(-3 * wide, 3 * wide), r.within(-3 * wide, 3 * wide)));
        let mut point = |wide: i64| raw((r.within(-wide, wide), r.within(-wide, wide)));
        let far = point(2 * wide);
        let (p, q, s) = (point(wide), point(wide), point(wide));
        let triangle = |p, q, s| ConvexPolygon::<3>::hull(&[p, q, s]);
        let radius = Fx::from_bits((wide / 2) as i32);
        let ball = |at| Circle::new(at, radius).unwrap();
        let boxed = |p: Vec2, q: Vec2| Aabb::new(p.min(q), p.max(q)).unwrap();
        let case = (k % 5) as usize;
        let hit = match case {
            0 => {
                let (t, u, v) = (point(wide), point(wide), point(wide));
                let mover = triangle(t, u, v).map(|a| a.moved(far));
                match (mover, triangle(p, q, s), triangle(q, s, t)) {
                    (Ok(a), Ok(b), Ok(c)) => judge(&a, [b, c], d),
                    _ => false,
                }
            }
            1 => judge(&ball(far), [boxed(p, q), boxed(q, s)], d),
            2 => Segment::new(far, point(2 * wide)).is_ok_and(|a| judge(&a, [boxed(p, q), boxed(q, s)], d)),
            3 => judge(&ball(far), [ball(p), ball(q)], d),
            _ => match (ConvexParts::<4, 3>::of(&[p, q, s, point(wide)]), triangle(point(9), point(9), point(9))) {
                (Ok(parts), Ok(a)) if parts.parts().len() == 2 => {
                    judge(&a.moved(far), [parts.parts()[0], parts.parts()[1]], d)
                }
                _ => false,
            },
        };
        hits[case] += u64::from(hit);
    }
    assert!(hits.iter().all(|hits| *hits > cases(300_000) / 400), "{hits:?}");
}
