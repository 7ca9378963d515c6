//! Pairs of shapes. The exact judge checks every verb, on the tests' adversarial classes.

use tilesat::{CastHit, Inside, Vec2};
use tilesat_judge::Random;
use tilesat_judge::casts::ask;
use tilesat_judge::casts::judge::{Forbidden, ONE};
use tilesat_judge::casts::motions::{Motion, moving, through, views};
use tilesat_judge::oracle::figure::{Figure, LIMIT, PAIRS, Point};
use tilesat_judge::oracle::generate::{CLASSES, Class, Pairs};
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::oracle::kernel::{self, aabb, circle, point, segment, vec2};
use tilesat_judge::oracle::verify::{self, Pair};

/// A pair in either order, and its origin.
fn pair(data: &[u8]) -> (Figure, Figure, Pairs, Class) {
    let mut r = Random::steered(data);
    let kinds = PAIRS[r.below(6) as usize];
    let class = CLASSES[r.below(6) as usize];
    let exchanged = r.one_in(2);
    let mut pairs = Pairs::new(kinds, class, 0);
    let (a, b) = pairs.next();
    if exchanged { (b, a, pairs, class) } else { (a, b, pairs, class) }
}

pub(crate) fn overlap(data: &[u8]) {
    let (a, b, ..) = pair(data);
    Pair::new(&a, &b).booleans();
}

pub(crate) fn contact(data: &[u8]) {
    let (a, b, ..) = pair(data);
    let pair = Pair::new(&a, &b);
    pair.booleans();
    pair.contact();
    for (a, b) in [(&a, &b), (&b, &a)] {
        tie(a, b);
    }
}

/// Two opposite exits can be equally short. The documented one wins, whichever shape is A: to +x,
/// else to +y. Over the line of a segment: to the left of its edge from the first end.
fn tie(a: &Figure, b: &Figure) {
    let Some(contact) = kernel::contact(a, b).filter(tilesat::Contact::is_degenerate) else { return };
    let (pair, axis) = (Pair::new(a, b), contact.axis());
    let (x, y) = (i64::from(axis.x), i64::from(axis.y));
    if pair.exact.is_shortest_exit(&pair.sum, (-x, -y)) {
        let line = [a, b].iter().any(|f| matches!(f, Figure::Segment { a, b } if a != b));
        let flat = [a, b].iter().any(|f| matches!(f, Figure::Aabb { .. })) || !line;
        let first = y > 0 || (y == 0 && (x > 0) == flat);
        assert!(first, "of two exits {axis:?} was taken: {a:?} {b:?}");
    }
}

pub(crate) fn distance(data: &[u8]) {
    let (a, b, ..) = pair(data);
    Pair::new(&a, &b).distances();
    let back = kernel::closest_points(&b, &a).map(|(q, p)| (p, q));
    assert_eq!(kernel::closest_points(&a, &b), back, "closest points exchanged: {a:?} {b:?}");
    for p in b.vertices() {
        verify::point(&a, p);
    }
    let r = &mut Random::new(0);
    let any = (i64::from(r.next() as i32), i64::from(r.next() as i32));
    verify::point(&b, any);
}

pub(crate) fn cast_shape(data: &[u8]) {
    let (a, b, mut pairs, class) = pair(data);
    let r = &mut pairs.random;
    let most = if matches!(class, Class::Domain) { (1 << 28) - 1 } else { 64 << 16 };
    let most = r.magnitude(most).max(1);
    let Some(Motion { a, d }) = through(r, &a, &b, most) else { return };
    ask::check::<Int256>(&a, &b, d, 4);
    views(&a, &b, d);
    moving(r, &a, &b, d);
}

fn ray(shape: &Figure, o: Point, d: Point, inside: Inside) -> Option<CastHit> {
    match *shape {
        Figure::Aabb { min, max } => aabb(min, max).cast_ray(vec2(o), vec2(d), inside),
        Figure::Circle { centre, radius } => circle(centre, radius).cast_ray(vec2(o), vec2(d), inside),
        Figure::Segment { a, b } => segment(a, b).cast_ray(vec2(o), vec2(d)),
    }
    .expect("inside the domain")
}

/// Checks whether it hits, and that the hit is never late and never inside. The contact is as near
/// to the exact point as the contract promises.
pub(crate) fn cast_ray(data: &[u8]) {
    let (shape, other, mut pairs, _) = pair(data);
    let r = &mut pairs.random;
    let (from, to) = (other.vertices(), shape.vertices());
    let o = from[r.below(from.len() as i64) as usize];
    let goal = to[r.below(to.len() as i64) as usize];
    let far = r.within(0, 3);
    let off = r.magnitude(1 << 20);
    let off = (r.around(off), r.around(off));
    let d = ((goal.0 - o.0) * far + off.0, (goal.1 - o.1) * far + off.1);
    let d = (d.0.clamp(1 - LIMIT - o.0, LIMIT - 1 - o.0), d.1.clamp(1 - LIMIT - o.1, LIMIT - 1 - o.1));
    let case = || format!("{o:?} by {d:?} on {shape:?}");
    let set = Forbidden::new(&Figure::Segment { a: o, b: o }, &shape);
    let hit = ray(&shape, o, d, Inside::Ignore);
    if set.holds::<Int256>((0, 0)) {
        assert_eq!(hit, None, "{}", case());
        let hit = ray(&shape, o, d, Inside::Hit).expect("the start is inside");
        assert!(hit.inside && hit.toi.raw() == 0 && hit.displacement == Vec2::ZERO, "{}", case());
        return;
    }
    assert_eq!(hit, ray(&shape, o, d, Inside::Hit), "{}", case());
    assert_eq!(hit.is_some(), stops(&set, d), "the judge on the right: {}", case());
    let Some(hit) = hit else { return };
    let toi = i64::from(hit.toi.raw());
    assert!(toi <= ONE && (toi == 0 || !set.touched::<Int256>(d, toi - 1)), "late: {}", case());
    let p = point(hit.displacement);
    assert!(!set.holds::<Int256>(p) && set.is_near::<Int256>(p, set.radius + 4), "{hit:?}: {}", case());
    let along = |v: Point| i128::from(hit.axis.x) * i128::from(v.0) + i128::from(hit.axis.y) * i128::from(v.1);
    // A disc that is grazed: its centre is across the motion, within the rounding of the position.
    let with = along(d).max(0);
    let square = i128::from(d.0).pow(2) + i128::from(d.1).pow(2);
    assert!(along(d) < 0 || (set.radius > 0 && with * with <= 2 * square), "{hit:?}: {}", case());
}

/// A ray hits where it enters the closed set from outside; tangents of discs do not count. From the
/// border, it hits if it goes in. From a set without an inside, it hits where it leaves the set's
/// line.
fn stops(set: &Forbidden, d: Point) -> bool {
    if set.touched::<Int256>(d, 0) {
        if set.radius > 0 || set.hull.len() > 2 {
            return set.met::<Int256>(d, ONE);
        }
        let (p, q) = (set.hull[0], set.hull[set.hull.len() - 1]);
        let e = (q.0 - p.0, q.1 - p.1);
        let turn = i128::from(e.0) * i128::from(d.1) - i128::from(e.1) * i128::from(d.0);
        return d != (0, 0) && (e == (0, 0) || turn != 0);
    }
    set.touched::<Int256>(d, ONE) && (set.radius == 0 || set.met::<Int256>((d.0 * 2, d.1 * 2), ONE))
}
