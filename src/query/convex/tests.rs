//! The ways that frequent pairs take, against the general ones.

#![allow(clippy::unwrap_used, reason = "a test")]

use super::box_pair::BoxPair;
use super::margins::all_meet;
use super::{box_contact, contact, distance, float_margins, short, short_boxes};
use crate::num::Raw;
use crate::{Axis, Capsule, Circle, Fx, OrientedBox, Vec2};
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
    let at = |t: i64| b.translated(vec(((way.0 * t) >> 30, (way.1 * t) >> 30))).unwrap();
    let (mut inside, mut outside) = (0, 1 << 30);
    while outside - inside > 1 {
        let middle = (inside + outside) >> 1;
        let is_inside = all_meet::<true>(BoxPair::of(&a, &at(middle)).unwrap().sides());
        *(if is_inside { &mut inside } else { &mut outside }) = middle;
    }
    (a, at(inside).translated(vec((r.around(3), r.around(3)))).unwrap())
}

/// Of all sizes, the answers by floats and by leading bits are those of exact products, or none.
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

/// Of long sides, a margin of a few square units: floats are off by more, and must not settle it.
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
