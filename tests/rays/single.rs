//! Rays against single shapes: every one of a small lattice against the exact judge. Tiles and
//! walls of levels, which are the same sets. Cases of other engines' tests.

use tilesat::{
    Aabb, Axis, CastHit, Circle, Fx, Inside, Path, PathKind, Quantity, RangeError, Segment, SegmentMap, TileKind,
    TileKinds, TileMap, Vec2,
};
use tilesat_judge::casts::ask::is_out;
use tilesat_judge::casts::judge::{Forbidden, ONE};
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::kernel::{aabb, circle, point, segment, vec2};

const UNIT: i64 = 4096;

fn square(size: i64) -> impl Iterator<Item = Point> {
    (-size..=size).flat_map(move |x| (-size..=size).map(move |y| (x * UNIT, y * UNIT)))
}

fn cast(shape: &Figure, o: Point, d: Point, inside: Inside) -> Option<CastHit> {
    match *shape {
        Figure::Aabb { min, max } => aabb(min, max).cast_ray(vec2(o), vec2(d), inside),
        Figure::Circle { centre, radius } => circle(centre, radius).cast_ray(vec2(o), vec2(d), inside),
        Figure::Segment { a, b } => segment(a, b).cast_ray(vec2(o), vec2(d)),
    }
    .expect("inside the domain")
}

/// Whether the ray stops: it enters the closed set from outside, except for a tangent of a disc.
/// From the border it must go in. From a set without an inside, it must leave the set's line.
fn is_stopped(set: &Forbidden, d: Point) -> bool {
    let flat = set.radius == 0 && set.hull.len() < 3;
    if set.touched::<i128>(d, 0) {
        if !flat {
            return set.met::<i128>(d, ONE);
        }
        let e = (set.hull.last().unwrap().0 - set.hull[0].0, set.hull.last().unwrap().1 - set.hull[0].1);
        return d != (0, 0) && (e == (0, 0) || e.0 * d.1 != e.1 * d.0);
    }
    // A tangent does not go in, however far it leads.
    set.touched::<i128>(d, ONE) && (set.radius == 0 || set.met::<i128>((d.0 * 2, d.1 * 2), ONE))
}

fn check(shape: &Figure, o: Point, d: Point) -> bool {
    let case = || format!("{o:?} by {d:?} on {shape:?}");
    let set = Forbidden::new(&Figure::Segment { a: o, b: o }, shape);
    let hit = cast(shape, o, d, Inside::Ignore);
    if set.holds::<i128>((0, 0)) {
        assert_eq!(hit, None, "{}", case());
        let hit = cast(shape, o, d, Inside::Hit).unwrap();
        assert!(hit.inside && hit.toi.raw() == 0 && hit.displacement == Vec2::ZERO, "{}", case());
        return true;
    }
    assert_eq!(hit, cast(shape, o, d, Inside::Hit), "{}", case());
    assert_eq!(hit.is_some(), is_stopped(&set, d), "the judge on the right: {}", case());
    let Some(hit) = hit else { return false };
    let toi = i64::from(hit.toi.raw());
    assert!(toi <= ONE && (toi == 0 || !set.touched::<i128>(d, toi - 1)), "late: {}", case());
    let slack = if set.radius == 0 { 1 } else { 2 * ONE / UNIT };
    assert!(set.touched::<i128>(d, (toi + slack).min(ONE)), "early: {}", case());
    let p = point(hit.displacement);
    assert!(!set.holds::<i128>(p) && set.is_near::<i128>(p, set.radius + 2), "{hit:?}: {}", case());
    let along = |v: Point| i64::from(hit.axis.x) * v.0 + i64::from(hit.axis.y) * v.1;
    assert!(along(d) < 0, "{hit:?}: {}", case());
    let core = set.hull.iter().map(|&v| along(v)).max().unwrap();
    let square = i128::from(hit.axis.length_squared());
    assert!(is_out((along(p) - core).into(), square, set.radius, 3), "{hit:?}: {}", case());
    true
}

#[test]
fn every_ray_of_a_lattice() {
    let mut shapes = Vec::new();
    for (w, h) in (0..=2).flat_map(|w| (0..=2).map(move |h| (w * UNIT, h * UNIT))) {
        shapes.push(Figure::Aabb { min: (0, 0), max: (w, h) });
        shapes.push(Figure::Circle { centre: (0, 0), radius: w + h });
        shapes.push(Figure::Segment { a: (0, 0), b: (w, h) });
        shapes.push(Figure::Segment { a: (w, 0), b: (0, h) });
    }
    let mut stopped = 0;
    for shape in &shapes {
        for o in square(4) {
            for d in square(5) {
                stopped += u32::from(check(shape, o, d));
            }
        }
    }
    assert!(stopped > 40_000, "{stopped}");
}

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

/// One tile is a box.
#[test]
fn a_tile_is_a_box() {
    let map = TileMap::from_ascii("#", &KINDS).unwrap().with_cell(Fx::from_bits(2 * UNIT as i32)).unwrap();
    let shape = aabb((0, 0), (2 * UNIT, 2 * UNIT));
    for (o, d) in square(4).flat_map(|o| square(7).map(move |d| (vec2(o) + Vec2::from_raw(1, 0), vec2(d)))) {
        for (o, inside) in [(o, Inside::Ignore), (o, Inside::Hit), (o - Vec2::from_raw(1, 0), Inside::Hit)] {
            let ours = shape.cast_ray(o, d, inside).unwrap().map(|h| (h.toi, h.axis, o + h.displacement, h.inside));
            let theirs = map.cast_ray(o, d, inside).unwrap().map(|h| (h.toi, h.axis, h.point, h.inside));
            assert_eq!(ours, theirs, "{o:?} by {d:?}");
        }
    }
}

/// One wall is a segment, except that a level has no face that stops a ray along the wall.
#[test]
fn a_wall_is_a_segment() {
    let ends = [(0, 0), (2 * UNIT, UNIT)];
    let points = ends.map(vec2);
    let paths = [Path::new(PathKind::Wall, &points)];
    let mut bytes = heapless::Vec::<u8, 4096>::new();
    let map = SegmentMap::build_vec(&paths, Fx::ONE, &mut bytes).unwrap();
    let shape = segment(ends[0], ends[1]);
    for (o, d) in square(4).flat_map(|o| square(6).map(move |d| (o, d))) {
        if d.0 == 2 * d.1 {
            continue;
        }
        let ours = shape.cast_ray(vec2(o), vec2(d)).unwrap();
        let theirs = map.cast_ray(vec2(o), vec2(d), Inside::Ignore).unwrap();
        assert_eq!(ours.map(|h| h.toi), theirs.map(|h| h.toi), "{o:?} by {d:?}");
        if let (Some(a), Some(b)) = (ours, theirs) {
            assert_eq!(vec2(o) + a.displacement, b.point, "{o:?} by {d:?}");
            assert!(
                a.axis.perp_dot(b.axis) == 0 && a.axis.dot(b.axis) > 0,
                "{o:?} by {d:?}: {:?} {:?}",
                a.axis,
                b.axis
            );
        }
    }
}

fn ints(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

/// box2d's `AABBRayCastTest`.
#[test]
fn box2d_boxes() {
    let square = Aabb::new(ints(-1, -1), ints(1, 1)).unwrap();
    let between = |from: Vec2, to: Vec2| square.cast_ray(from, to - from, Inside::Ignore).unwrap();
    let third = (1 << 30) / 3;
    for (from, to, axis) in [
        (ints(-3, 0), ints(3, 0), Axis::NEG_X),
        (ints(3, 0), ints(-3, 0), Axis::X),
        (ints(0, -3), ints(0, 3), Axis::NEG_Y),
        (ints(0, 3), ints(0, -3), Axis::Y),
    ] {
        let hit = between(from, to).unwrap();
        assert_eq!((hit.toi.raw(), hit.axis), (third, axis));
        assert_eq!(from + hit.displacement, ints(axis.x as i16, axis.y as i16));
    }
    assert_eq!(between(ints(-3, 2), ints(3, 2)), None);
    assert_eq!(between(ints(2, -3), ints(2, 3)), None);
    assert_eq!(between(ints(0, 0), ints(3, 0)), None); // from inside
    let corner = between(ints(-2, -2), ints(2, 2)).unwrap();
    assert_eq!((corner.toi.raw(), corner.axis), (1 << 28, Axis::NEG_X));
    assert_eq!(between(Vec2::from_raw(-3 << 16, 3 << 15), Vec2::from_raw(3 << 16, 3 << 15)), None);
    let along = between(ints(-2, 1), ints(2, 1)).unwrap();
    assert_eq!((along.toi.raw(), along.axis), (1 << 28, Axis::NEG_X));
    assert_eq!(between(ints(-5, 0), ints(-2, 0)), None);
    assert_eq!(between(ints(-2, 0), ints(-2, 0)), None);
    assert_eq!(between(ints(-2, 0), ints(-1, 0)).unwrap().toi.raw(), 1 << 30);
    let offset = Aabb::new(ints(99, -51), ints(101, -49)).unwrap();
    let hit = offset.cast_ray(ints(97, -50), ints(6, 0), Inside::Ignore).unwrap().unwrap();
    assert_eq!((hit.toi.raw(), hit.axis), (third, Axis::NEG_X));
}

/// parry's segment cases, and box2d's circle, box and segment.
#[test]
fn rays_of_other_engines() {
    let up = |a, b, from| Segment::new(a, b).unwrap().cast_ray(from, ints(0, 4)).unwrap().map(|h| h.toi.raw());
    assert_eq!(up(ints(2, 1), ints(2, 0), ints(0, 0)), None); // parallel
    assert_eq!(up(ints(2, 1), ints(2, -1), ints(0, 0)), None);
    assert_eq!(up(ints(0, 1), ints(0, -1), ints(0, -2)), Some(1 << 28)); // on its own line, from before it
    assert_eq!(up(ints(0, 1), ints(0, -1), ints(0, 2)), None); // pointing away
    // Ours: a ray along the segment does not leave its line (parry: at 0).
    assert_eq!(up(ints(0, 1), ints(0, -1), ints(0, 0)), None);
    let wall = Segment::new(ints(0, -10), ints(0, 10)).unwrap();
    let right = |from: Vec2| wall.cast_ray(from, ints(4, 0)).unwrap().map(|h| h.toi.raw());
    assert_eq!(right(ints(-1, 0)), Some(1 << 28));
    assert_eq!(right(ints(1, 0)), None);
    assert_eq!(right(ints(0, 3)), Some(0));
    assert_eq!((right(ints(-1, 11)), right(ints(-1, -11))), (None, None));
    assert_eq!(right(ints(-1, 10)), Some(1 << 28)); // an end
    let ball = Circle::new(ints(1, 0), Fx::ONE).unwrap();
    let hit = ball.cast_ray(ints(-4, 0), ints(8, 0), Inside::Ignore).unwrap().unwrap();
    assert_eq!(hit.axis, Axis::NEG_X);
    assert!((1i64 << 29) - i64::from(hit.toi.raw()) < 16 && hit.displacement.x <= 4, "{hit:?}");
    let square = Aabb::new(ints(-1, -1), ints(1, 1)).unwrap();
    assert_eq!(square.cast_ray(ints(-4, 0), ints(8, 0), Inside::Ignore).unwrap().unwrap().toi.raw(), 3 << 27);
    assert_eq!(
        Segment::new(ints(0, -1), ints(0, 1)).unwrap().cast_ray(ints(-4, 0), ints(8, 0)).unwrap().unwrap().toi.raw(),
        1 << 29
    );
}

/// Torture scene 21 with bare segments: a ray through the common end of two segments meets both
/// there.
#[test]
fn common_end() {
    for (x, y) in [(-16, 8), (-16, -8), (-16, 0), (-4, 16)] {
        let one = Segment::new(ints(16, 40), ints(16 + x, 40 + y)).unwrap();
        let other = Segment::new(ints(16, 40), ints(16 - x, 40 + y)).unwrap();
        let hits = [one, other].map(|s| s.cast_ray(ints(16, 0), ints(0, 64)).unwrap().map(|h| h.toi.raw()));
        assert_eq!(hits, [Some(40 << 24); 2], "{x} {y}");
    }
}

#[test]
fn refusals() {
    let ball = Circle::new(ints(0, 0), Fx::ONE).unwrap();
    let far = Vec2::from_raw((1 << 29) - 1, 0);
    assert!(ball.cast_ray(far, -far - far, Inside::Ignore).unwrap().is_some()); // across the domain
    let over = ball.cast_ray(far, Vec2::from_raw(1, 0), Inside::Ignore);
    assert_eq!(over, Err(RangeError { what: Quantity::EndX, value: 1 << 29 }));
    let outside = ball.cast_ray(Vec2::from_raw(0, 1 << 29), Vec2::ZERO, Inside::Ignore);
    assert_eq!(outside, Err(RangeError { what: Quantity::Y, value: 1 << 29 }));
    for d in [i32::MIN, i32::MAX, -(1 << 30), 1 << 30] {
        assert!(ball.cast_ray(far, Vec2::from_raw(d, 0), Inside::Ignore).is_err());
    }
}
