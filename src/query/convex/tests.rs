//! The short tests of frequent pairs, against the general code.

#![allow(clippy::unwrap_used, reason = "a test")]

use super::box_pair::BoxPair;
use super::box_point::BoxPoint;
use super::exit::Exit;
use super::margins::all_meet;
use super::place::sharp;
use super::short_sides::shortly;
use super::walk::Core;
use super::{box_contact, contact, distance, each_side, float_margins, float_quads, gaps, short, short_boxes};
use crate::num::Raw;
use crate::shape::Convex;
use crate::{Axis, Capsule, Circle, ConvexPolygon, Fx, OrientedBox, Vec2};
use tilesat_judge::{Random, cases, enough};

fn vec((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// A box around the origin, in a whole direction of length five or in any.
fn turned(r: &mut Random, size: i64) -> OrientedBox {
    let direction = if r.one_in(2) { Axis::new(3, 4) } else { Axis::new(r.around(99) as i32 | 1, r.around(99) as i32) };
    OrientedBox::new(Vec2::ZERO, vec((r.within(0, size) / 5 * 5, r.within(1, size))), direction).unwrap()
}

/// Two boxes of one size class that touch, within three raw units.
fn near(r: &mut Random, size: i64) -> (OrientedBox, OrientedBox) {
    let (a, b, way) = (turned(r, size), turned(r, size), (r.around(4 * size) | 1, r.around(4 * size)));
    let at = |t: i64| b.translated(vec(part(way, t, (0, 0)))).unwrap();
    let touch = last(|t| all_meet::<true>(BoxPair::of(&a, &at(t)).unwrap().sides()));
    (a, at(touch).translated(vec((r.around(3), r.around(3)))).unwrap())
}

/// For boxes of all sizes, floats and leading bits give the answers of exact products, or none.
#[test]
fn near_boxes_by_floats_and_by_leading_bits() {
    let mut r = Random::new(83);
    let (mut hits, mut by_floats, mut long, mut by_bits) = (0u64, 0u64, 0u64, 0u64);
    for _ in 0..cases(40_000) {
        let size = 1 << r.within(2, 26);
        let (a, b) = near(&mut r, size);
        let sides = BoxPair::of(&a, &b).unwrap().sides();
        if sides.iter().take(4).any(|e| e.is_zero()) {
            // Without area, they may be apart by another side.
            let short = [float_margins::meet::<false>(sides), short_boxes::meet(sides)];
            assert!(short.iter().all(|meet| *meet != Some(true)), "{a:?} {b:?}");
            continue;
        }
        let (open, closed) = (all_meet::<false>(sides), all_meet::<true>(sides));
        let (strict, touch) = (float_margins::meet::<false>(sides), float_margins::meet::<true>(sides));
        assert!(strict.is_none_or(|meet| meet == open) && touch.is_none_or(|meet| meet == closed), "{a:?} {b:?}");
        hits += u64::from(open);
        by_floats += u64::from(touch.is_some());
        long += u64::from(touch.is_none());
        // Leading bits settle none of these: the other box is moved by up to a 256th of the size.
        let [u, v, s, t, d] = sides;
        let by = |r: &mut Random| r.around(size >> 8) as i32;
        let sides = [u, v, s, t, Raw { x: d.x + by(&mut r), y: d.y + by(&mut r) }];
        let short = short_boxes::meet(sides);
        assert!(short.is_none_or(|meet| meet == all_meet::<false>(sides) && meet == all_meet::<true>(sides)));
        by_bits += u64::from(short.is_some());
    }
    let few = cases(40_000) / 40;
    let is_seen = [hits, by_floats, by_bits].iter().all(|n| *n > few) && long > 0;
    assert!(enough(is_seen), "{hits} {by_floats} {long} {by_bits}");
}

/// The vector across a side of coprime components by one, by Euclid's algorithm: `e x v = 1`.
fn across_by_one(e: Raw) -> Option<(i64, i64)> {
    let ((mut a, mut p), (mut b, mut q)) = ((i64::from(e.x), (0, 1)), (i64::from(e.y), (-1, 0)));
    while b != 0 {
        let n = a / b;
        (a, p, b, q) = (b, q, a - n * b, (p.0 - n * q.0, p.1 - n * q.1));
    }
    (a.abs() == 1).then_some((p.0 * a, p.1 * a))
}

/// Long sides with a margin of a few square units: floats are off by more, and must not settle it.
#[test]
fn least_margins_of_large_boxes() {
    let mut r = Random::new(85);
    let (mut open, mut apart, mut seen) = (0u64, 0u64, 0u64);
    for _ in 0..cases(20_000) {
        let (a, b) = near(&mut r, 1 << 26);
        // Nearly as long as sides can be, and with components that are mostly coprime.
        let mut longer = |e: Raw| Raw { x: e.x * 4 + r.around(2) as i32, y: e.y * 4 + r.around(2) as i32 };
        let [u, v, s, t, d] = BoxPair::of(&a, &b).unwrap().sides().map(&mut longer);
        let Some(by) = across_by_one(u) else { continue };
        let width = u.cross(v) + u.cross(s).abs() + u.cross(t).abs();
        let sign = u.cross(d).signum();
        // Across the side by all that it overlaps and up to nine more, and along it to the nearest
        // such point.
        let more = i128::from(sign * (width + r.around(2)) - u.cross(d));
        let (x, y) = (more * i128::from(by.0), more * i128::from(by.1));
        let turns = if u.x.abs() > u.y.abs() { x / i128::from(u.x) } else { y / i128::from(u.y) };
        let (x, y) = (x - turns * i128::from(u.x), y - turns * i128::from(u.y));
        let inside = |n: i128| i32::try_from(n).ok().filter(|n| n.unsigned_abs() < 1 << 31);
        let ends = (inside(i128::from(d.x) + x), inside(i128::from(d.y) + y));
        let (Some(x), Some(y)) = ends else { continue };
        let d = Raw { x, y };
        let sides = [u, v, s, t, d];
        let (meet, touch) = (all_meet::<false>(sides), all_meet::<true>(sides));
        assert!(float_margins::meet::<false>(sides).is_none_or(|answer| answer == meet), "{sides:?}");
        assert!(float_margins::meet::<true>(sides).is_none_or(|answer| answer == touch), "{sides:?}");
        seen += u64::from(float_margins::meet::<true>(sides).is_none());
        open += u64::from(meet);
        apart += u64::from(!touch);
    }
    assert!(enough(seen > 0 && open > 0 && apart > 0), "{seen} {open} {apart}");
}

/// Distances by floats are those of integers, and so are contacts of boxes.
#[test]
fn distances_and_contacts_by_floats() {
    let mut r = Random::new(84);
    let (mut told, mut whole, mut deep) = (0u64, 0u64, 0u64);
    for _ in 0..cases(40_000) {
        let size = 1 << r.within(2, 25);
        let (a, b) = near(&mut r, size);
        let by = (r.around(size), r.around(size));
        let b = if r.one_in(2) { b } else { b.translated(vec(by)).unwrap() };
        let same = |gap: Option<u32>, exact: u32| {
            assert!(gap.is_none_or(|gap| gap == exact), "{gap:?} {exact} {a:?} {b:?}");
            u64::from(gap.is_some())
        };
        let ([p, _, q, _], [s, _, t, _]) = (a.corners(), b.corners());
        let line = |p: Vec2, q: Vec2| Capsule::new(p, q, Fx::ZERO).unwrap();
        let dot = |p: Vec2| Circle::new(p, Fx::ZERO).unwrap();
        let (e, f) = (line(p, q), line(s, t));
        told += same(short::gap(&a, &b), distance(&a, &b));
        told += same(short::gap(&e, &f), distance(&e, &f));
        for (end, other) in [(line(p, p), &f), (line(s, s), &e)] {
            // Without a length there is no line from which to measure.
            same(short::gap(&end, other), distance(&end, other));
            same(short::gap(other, &end), distance(other, &end));
        }
        told += same(short::gap(&a, &dot(s)), distance(&a, &dot(s)));
        // A point before the first side, which is a whole length away, or nearly.
        let far = r.within(1, size / 5 + 1);
        let beside = dot(a.along() + vec((3 * far + r.within(0, 1), 4 * far)));
        whole += same(short::gap(&a, &beside), distance(&a, &beside));
        let upright = b.aabb();
        told += same(short::gap(&a, &upright), distance(&a, &upright));
        let pairs = [
            (box_contact::contact(&a, &b), contact(&a, &b)),
            (box_contact::contact(&a, &upright), contact(&a, &upright)),
            (box_contact::contact(&upright, &a), contact(&upright, &a)),
        ];
        for (by_floats, exact) in pairs {
            if let Ok(by_floats) = by_floats {
                assert_eq!(by_floats, exact, "{a:?} {b:?}");
                deep += u64::from(exact.is_some());
            }
        }
    }
    let few = cases(40_000) / 20;
    assert!(enough(told > few && whole > few && deep > few), "{told} {whole} {deep}");
}

/// The given number of 2^30ths of a path, and some more.
fn part(way: (i64, i64), t: i64, by: (i64, i64)) -> (i64, i64) {
    (((way.0 * t) >> 30) + by.0, ((way.1 * t) >> 30) + by.1)
}

/// The number of the last point on a line of 2^30 points at which something is true.
fn last(holds: impl Fn(i64) -> bool) -> i64 {
    let (mut inside, mut outside) = (0, 1 << 30);
    while outside - inside > 1 {
        let middle = (inside + outside) >> 1;
        *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
    }
    inside
}

/// A circle that nearly touches a box overlaps it by floats exactly if it does by integers.
#[test]
fn circles_near_boxes_by_floats() {
    let mut r = Random::new(86);
    let (mut told, mut hits, mut unsure) = (0u64, 0u64, 0u64);
    for _ in 0..cases(100_000) {
        let size = 1 << r.within(2, 26);
        let (a, way) = (turned(&mut r, size), (r.around(3 * size) | 1, r.around(3 * size)));
        let radius = Fx::from_bits(r.within(0, size) as i32);
        let at = |t: i64, by: (i64, i64)| Circle::new(vec(part(way, t, by)), radius).unwrap();
        let touch = last(|t| BoxPoint::of(&a, &at(t, (0, 0))).is_some_and(|both| both.meets::<true>()));
        let circle = at(touch, (r.around(3), r.around(3)));
        let Some(both) = BoxPoint::of(&a, &circle) else { continue };
        let (open, closed) = (both.meets::<false>(), both.meets::<true>());
        for by_floats in [gaps::box_point_meet(&a, &circle), gaps::box_point_meet(&circle, &a)] {
            assert!(by_floats.is_none_or(|meet| meet == open && meet == closed), "{a:?} {circle:?}");
            told += u64::from(by_floats.is_some());
            unsure += u64::from(by_floats.is_none());
        }
        hits += u64::from(open);
    }
    let few = cases(100_000) / 20;
    assert!(enough(told > few && hits > few && unsure > few), "{told} {hits} {unsure}");
}

/// Four corners, one in each quadrant.
fn quad(r: &mut Random, size: i64) -> Option<ConvexPolygon<4>> {
    let corners =
        [(1, 1), (-1, 1), (-1, -1), (1, -1)].map(|(x, y)| vec((x * r.within(1, size), y * r.within(1, size))));
    ConvexPolygon::new(&corners).ok()
}

/// Checks that floats and leading bits agree with integers about two quads.
///
/// Returns whether the quads overlap, whether leading bits decide, and whether floats find a
/// contact.
fn same_of_quads(a: &ConvexPolygon<4>, b: &ConvexPolygon<4>) -> (bool, bool, bool) {
    let [p, q] = [a, b].map(|of| Core { corners: of.outline(), radius: 0 });
    let (open, closed) = (each_side::meet::<false>(p, q), each_side::meet::<true>(p, q));
    let [c, d] = [a, b].map(|of| <&[Vec2; 4]>::try_from(of.outline()).unwrap());
    assert_eq!((float_quads::meet::<false>(c, d), float_quads::meet::<true>(c, d)), (open, closed), "{a:?} {b:?}");
    let by_bits = shortly(p, q);
    assert!(by_bits.is_none_or(|meet| meet == open && meet == closed), "{a:?} {b:?}");
    // The copy for any number of corners.
    let half = Core { corners: p.corners.split_at(3).0, radius: 0 };
    let (open_half, closed_half) = (each_side::meet::<false>(half, q), each_side::meet::<true>(half, q));
    assert!(shortly(half, q).is_none_or(|meet| meet == open_half && meet == closed_half), "{a:?} {b:?}");
    let mut is_deep = false;
    if let Ok(contact) = float_quads::contact(p, q) {
        assert_eq!(contact, Exit::of(p, q).map(|exit| exit.contact), "{a:?} {b:?}");
        is_deep = contact.is_some();
    }
    (open, by_bits.is_some(), is_deep)
}

/// Quads of all sizes and depths. Leading bits settle those that do not nearly touch.
#[test]
fn near_quads_by_floats_and_by_leading_bits() {
    let mut r = Random::new(87);
    let (mut told, mut deep, mut unsure) = (0u64, 0u64, 0u64);
    for _ in 0..cases(60_000) {
        let size = 1 << r.within(2, 26);
        let (Some(a), Some(b)) = (quad(&mut r, size), quad(&mut r, size)) else { continue };
        let way = (r.around(4 * size) | 1, r.around(4 * size));
        let at = |t: i64, by: (i64, i64)| b.translated(vec(part(way, t, by))).unwrap();
        let touch = last(|t| {
            let (p, q) = (a.outline(), at(t, (0, 0)));
            let q = q.outline();
            each_side::meet::<true>(Core { corners: p, radius: 0 }, Core { corners: q, radius: 0 })
        });
        let t = if r.one_in(2) { touch } else { r.within(0, 1 << 30) };
        let (_, by_bits, is_deep) = same_of_quads(&a, &at(t, (r.around(3), r.around(3))));
        told += u64::from(by_bits);
        unsure += u64::from(!by_bits);
        deep += u64::from(is_deep);
    }
    let few = cases(60_000) / 40;
    assert!(enough(told > few && deep > few && unsure > few), "{told} {deep} {unsure}");
}

/// Two quads around nearly the same point that are their own images after a half turn or a quarter.
/// Two sides are equally near, or nearly so, and floats must not choose between them.
#[test]
fn tied_sides_of_quads() {
    let mut r = Random::new(89);
    let (mut told, mut tied) = (0u64, 0u64);
    for _ in 0..cases(40_000) {
        let size = 1 << r.within(2, 27);
        let is_quarter = r.one_in(2);
        let turned = |r: &mut Random| {
            let (x, y) = (r.within(1, size), r.within(0, size));
            let (p, q) = ((x, y), if is_quarter { (-y, x) } else { (-r.within(0, size), r.within(1, size)) });
            ConvexPolygon::<4>::new(&[p, q, (-p.0, -p.1), (-q.0, -q.1)].map(vec)).ok()
        };
        let (Some(a), Some(b)) = (turned(&mut r), turned(&mut r)) else { continue };
        let b = b.translated(vec((r.around(1), r.around(1)))).unwrap();
        let (.., is_deep) = same_of_quads(&a, &b);
        told += u64::from(is_deep);
        tied += u64::from(!is_deep);
    }
    let few = cases(40_000) / 40;
    assert!(enough(told > few && tied > few), "{told} {tied}");
}

/// Compares the ways for these pairs of quads, of which some overlap and some do not.
fn both_answers(seed: u64, count: u64, pair: impl Fn(&mut Random) -> Option<(ConvexPolygon<4>, ConvexPolygon<4>)>) {
    let mut r = Random::new(seed);
    let (mut hits, mut apart) = (0u64, 0u64);
    for _ in 0..cases(count) {
        let Some((a, b)) = pair(&mut r) else { continue };
        let (open, ..) = same_of_quads(&a, &b);
        hits += u64::from(open);
        apart += u64::from(!open);
    }
    let few = cases(count) / 40;
    assert!(enough(hits > few && apart > few), "{hits} {apart}");
}

/// Long sides with a height of a few thousand square units.
#[test]
fn least_heights_of_large_quads() {
    both_answers(88, 60_000, |r| {
        let most = (1 << 28) - 1;
        let (x, y) = (r.within(1 << 27, most) * r.sign(), r.within(1 << 26, most) * r.sign());
        let e = Raw { x: x as i32, y: y as i32 };
        let by = across_by_one(e)?;
        // A corner near the middle of the side, a little on the left of it or on the right.
        let height = r.around(8000);
        let across = (i128::from(by.0) * i128::from(height), i128::from(by.1) * i128::from(height));
        let turns = (across.0 * i128::from(x) + across.1 * i128::from(y))
            / (i128::from(x) * i128::from(x) + i128::from(y) * i128::from(y));
        let corner = ((across.0 - turns * i128::from(x)) as i64, (across.1 - turns * i128::from(y)) as i64);
        let right = (y / 2, -x / 2);
        let (from, to) = ((-x, -y), (x, y));
        let a = [from, to, (to.0 / 2 - right.0, to.1 / 2 - right.1), (from.0 / 2 - right.0, from.1 / 2 - right.1)];
        let next = |k: i64, l: i64| (corner.0 + right.0 / 2 + x / k, corner.1 + right.1 / 2 + y / l);
        let b = [corner, next(-4, -4), (corner.0 + right.0, corner.1 + right.1), next(4, 4)];
        Some((ConvexPolygon::new(&a.map(vec)).ok()?, ConvexPolygon::new(&b.map(vec)).ok()?))
    });
}

/// Corners of two quads nearly on one line, on both sides of it: floats cannot tell the side.
#[test]
fn corners_nearly_on_a_long_side() {
    both_answers(90, 60_000, |r| {
        let most = (1 << 27) - 1;
        let (x, y) = (r.within(1 << 26, most) * r.sign(), r.within(1 << 25, most) * r.sign());
        let (s, t) = across_by_one(Raw { x: x as i32, y: y as i32 })?;
        // On the left of the line by a few square units, and after so many lengths of the edge.
        let at = |height: i64, steps: i64| {
            let back = (height * s * x + height * t * y) / (x * x + y * y);
            (height * s + (steps - back) * x, height * t + (steps - back) * y)
        };
        let few = |r: &mut Random| r.within(0, 3);
        let (from, to) = (at(0, -4), at(0, 4));
        let (third, fourth) = if r.one_in(2) { ((-y, x), at(few(r), -2)) } else { (at(few(r), 2), at(few(r), -2)) };
        let beyond = at(r.around(1), 0);
        let far = if r.one_in(2) { (y, -x) } else { at(-few(r) - 4, 0) };
        let b = [at(-few(r), -3), beyond, at(-few(r), 2), far];
        let a = [from, to, third, fourth];
        Some((ConvexPolygon::new(&a.map(vec)).ok()?, ConvexPolygon::new(&b.map(vec)).ok()?))
    });
}

/// The point between two images in a half turn is on a side of both, or nearly. Leading bits do not
/// show whether they have it in common.
#[test]
fn images_in_a_half_turn_around_a_side() {
    both_answers(91, 20_000, |r| {
        let size = 1 << r.within(4, 26);
        let (p, q) = ((r.within(1, size), r.within(0, size)), (-r.within(0, size), r.within(1, size)));
        let a = ConvexPolygon::<4>::new(&[p, q, (-p.0, -p.1), (-q.0, -q.1)].map(vec)).ok()?;
        let by = (p.0 + q.0 + r.around(3), p.1 + q.1 + r.around(3));
        Some((a, a.translated(vec(by)).unwrap()))
    });
}

/// Leading bits have room for eight corners. They must not settle a pair of polygons with more.
#[test]
fn polygons_of_many_corners_by_leading_bits() {
    let mut r = Random::new(92);
    let (mut told, mut many) = (0u64, 0u64);
    for _ in 0..cases(20_000) {
        let size = 1 << r.within(4, 26);
        let hull = |r: &mut Random, at: (i64, i64)| {
            let points = [(); 16].map(|()| vec((at.0 + r.around(size), at.1 + r.around(size))));
            ConvexPolygon::<16>::hull(&points).ok()
        };
        let by = (r.around(3 * size), r.around(3 * size));
        let (Some(a), Some(b)) = (hull(&mut r, (0, 0)), hull(&mut r, by)) else { continue };
        let [p, q] = [&a, &b].map(|of| Core { corners: of.outline(), radius: 0 });
        let (open, closed) = (sharp::<false>(p, q).is_ok(), sharp::<true>(p, q).is_ok());
        let by_bits = shortly(p, q);
        assert!(by_bits.is_none_or(|meet| meet == open && meet == closed), "{a:?} {b:?}");
        told += u64::from(by_bits.is_some());
        many += u64::from(p.corners.len().max(q.corners.len()) > 8 && !closed);
    }
    let few = cases(20_000) / 40;
    assert!(enough(told > few && many > few), "{told} {many}");
}
