//! Motions through a position where two shapes touch. Mirrored, exchanged and translated scenes
//! give the same answers, and so does the motion of both shapes.

use crate::Random;
use crate::casts::ask::{Answer, cast, cast_moving};
use crate::casts::judge::Forbidden;
use crate::oracle::figure::{Figure, Point};
use crate::oracle::int256::Int256;
use crate::oracle::kernel::{point, vec2};
use tilesat::{Axis, Inside};

/// Motions are smaller than this.
pub const MOST: i64 = 1 << 28;

/// A motion of A that is `made` at the pair's position.
pub struct Motion {
    pub a: Figure,
    pub d: Point,
}

/// Moves A back along a motion, so that it passes the pair's position after some part of it, or
/// ends or starts there.
pub fn through(r: &mut Random, a: &Figure, b: &Figure, most: i64) -> Option<Motion> {
    let u = match r.below(6) {
        0 => (r.sign() * r.magnitude(most), 0),
        1 => (0, r.sign() * r.magnitude(most)),
        // Along a side of the sum, or across it: grazing.
        2 | 3 => {
            let set = Forbidden::new(a, b).hull;
            let (p, q) = (set[r.below(set.len() as i64) as usize], set[r.below(set.len() as i64) as usize]);
            let e = (q.0 - p.0, q.1 - p.1);
            let e = if r.one_in(2) { e } else { (-e.1, e.0) };
            let k = 1 + (e.0.abs().max(e.1.abs()) / most.max(1)).max(r.below(8));
            (e.0 / k, e.1 / k)
        }
        _ => (r.sign() * r.magnitude(most), r.sign() * r.magnitude(most)),
    };
    let n = r.within(1, 9);
    let i = r.within(0, n);
    let (u, d) = if u.0.abs().max(u.1.abs()) * n < MOST { (u, (u.0 * n, u.1 * n)) } else { ((u.0 / n, u.1 / n), u) };
    // Sometimes not quite there.
    let off = if r.one_in(2) { (0, 0) } else { (r.around(2), r.around(2)) };
    let a = a.moved((off.0 - u.0 * i, off.1 - u.1 * i));
    // Where it ends does not matter.
    (a.in_domain() && d.0.abs().max(d.1.abs()) < MOST).then_some(Motion { a, d })
}

pub fn mirrored(p: Point) -> Point {
    (-p.0, p.1)
}

pub fn exchanged(p: Point) -> Point {
    (p.1, p.0)
}

/// The answer in another view of the scene.
pub fn seen(answer: Answer, view: impl Fn(Point) -> Point) -> Answer {
    let hit = answer.hit.map(|hit| {
        let (x, y) = view((i64::from(hit.axis.x), i64::from(hit.axis.y)));
        tilesat::CastHit {
            axis: Axis::new(x as i32, y as i32),
            displacement: vec2(view(point(hit.displacement))),
            ..hit
        }
    });
    Answer { hit, ..answer }
}

pub fn views(a: &Figure, b: &Figure, d: Point) {
    let answer = |a: &Figure, b: &Figure, d: Point| cast(a, b, d, Inside::Ignore).expect("inside the domain");
    let here = answer(a, b, d);
    let there = answer(&a.map(mirrored), &b.map(mirrored), mirrored(d));
    if is_symmetric(&here, &there, d) {
        assert_eq!((there.yes, there.exact), (here.yes, here.exact), "mirrored {a:?} {b:?} {d:?}");
    } else {
        assert_eq!(there, seen(here, mirrored), "mirrored {a:?} {b:?} {d:?}");
    }
    let turned = |p: Point| (-p.0, -p.1);
    assert_eq!(answer(&a.map(turned), &b.map(turned), turned(d)), seen(here, turned), "turned {a:?} {b:?} {d:?}");
    let by = (12_345, -54_321);
    let (a_there, b_there) = (a.moved(by), b.moved(by));
    if a_there.in_domain() && b_there.in_domain() && a_there.moved(d).in_domain() {
        assert_eq!(answer(&a_there, &b_there, d), here, "translated {a:?} {b:?} {d:?}");
    }
    let transposed = answer(&a.map(exchanged), &b.map(exchanged), exchanged(d));
    // x wins a tie between x and y. The time and the position are the same.
    let flat =
        |answer: Answer| Answer { hit: answer.hit.map(|hit| tilesat::CastHit { axis: Axis::X, ..hit }), ..answer };
    let time = |answer: Answer| answer.hit.map(|hit| hit.toi);
    assert_eq!(
        (transposed.yes, time(transposed), transposed.exact),
        (here.yes, time(here), here.exact),
        "transposed {a:?} {b:?} {d:?}"
    );
    if d.0.abs() != d.1.abs() && !corner_to_corner(&here) {
        assert_eq!(flat(transposed), flat(seen(here, exchanged)), "transposed {a:?} {b:?} {d:?}");
    }
}

/// Whether the two scenes' normals, in one frame, oppose the motion equally: a full tie.
pub fn is_symmetric(here: &Answer, there: &Answer, d: Point) -> bool {
    let (Some(here), Some(there)) = (here.hit, there.hit) else { return false };
    let (p, q) = (Axis::new(d.0 as i32, d.1 as i32), Axis::new(-there.axis.x, there.axis.y));
    let part = |n: Axis| (Int256::new(n.dot(p)).squared(), Int256::product(n.length_squared() as i64, 1));
    let ((a, b), (e, f)) = (part(here.axis), part(q));
    here.axis.perp_dot(q) != 0 && a * f == e * b
}

/// Ties of a slanted normal and another one are not only ties of x and y.
pub fn corner_to_corner(answer: &Answer) -> bool {
    answer.hit.is_some_and(|hit| hit.axis.x != 0 && hit.axis.y != 0)
}

/// Both shapes move: the same as one by the difference, and they end apart.
pub fn moving(r: &mut Random, a: &Figure, b: &Figure, d: Point) {
    let by_b = (r.around(MOST / 2), r.around(MOST / 2));
    let by_a = (d.0 + by_b.0, d.1 + by_b.1);
    let fits = by_a.0.abs().max(by_a.1.abs()) < MOST && b.moved(by_b).in_domain() && a.moved(by_a).in_domain();
    if !fits {
        return;
    }
    let one = cast(a, b, d, Inside::Ignore).expect("inside the domain").hit;
    let both = cast_moving(a, by_a, b, by_b).expect("inside the domain");
    assert_eq!(one.is_some(), both.is_some(), "{a:?} by {by_a:?}, {b:?} by {by_b:?}");
    let (Some(one), Some(both)) = (one, both) else { return };
    assert_eq!((both.toi, both.axis, both.inside), (one.toi, one.axis, one.inside));
    let (p, q) = (point(both.displacement), point(both.displacement_b));
    assert_eq!((p.0 - q.0, p.1 - q.1), point(one.displacement));
    for (made, d) in [(p.0, by_a.0), (p.1, by_a.1), (q.0, by_b.0), (q.1, by_b.1)] {
        assert!((0..=d.abs()).contains(&(made * d.signum())) && (d != 0 || made == 0), "{made} of {d}: {a:?} {b:?}");
    }
}
