//! Every hit of a ray through a map of all shapes, against the exact judge.

use crate::Random;
use crate::rays::cast::{Hit, Line, Scene};
use crate::rays::level::Level;
use crate::rays::moment::Moment;
use crate::rays::solid::Point;
use tilesat::{AllShapes, Axis, Inside, RayHit, TileMap, Vec2, world::RayRules};

pub fn vec2(p: Point) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

pub fn point_of(v: Vec2) -> Point {
    let (x, y) = v.raw();
    (i64::from(x), i64::from(y))
}

/// Compares everything that a hit reports with the equally good hits.
pub fn agrees(hit: &RayHit, expected: &[Hit], o: Point, d: Point) -> Result<(), &'static str> {
    let first = &expected[0];
    let p = point_of(hit.point);
    let toi = |k: u32| Moment::fraction(i128::from(hit.toi.raw() + k), 1 << 30);
    if first.moment < toi(0) {
        return Err("late");
    }
    if let Some(n) = first.normal {
        if first.moment >= toi(1) {
            return Err("toi");
        }
        if hit.axis != Axis::new(n.0 as i32, n.1 as i32) {
            return Err("axis");
        }
        let place = |o: i64, d: i64, n: i64| {
            let part = first.moment.floor_of(d.abs());
            // Up if that is the normal's side and something remains.
            let more = n * d > 0 && first.moment.sign_at(-part, d.abs()) > 0;
            o + d.signum() * (part + i64::from(more))
        };
        if p != (place(o.0, d.0, n.0), place(o.1, d.1, n.1)) {
            return Err("point");
        }
    } else {
        let Line::Round { centre, radius, convex, .. } = first.piece.line else { unreachable!() };
        // Less than one raw of way, of motions above 4096 units four.
        let way = (d.0.pow(2) + d.1.pow(2)).isqrt() + 1;
        let room = if d.0.abs().max(d.1.abs()) < 1 << 28 { 1 } else { 4 };
        let toi = i128::from(hit.toi.raw());
        if first.moment >= Moment::fraction(toi * i128::from(way) + (room << 30), i128::from(way) << 30) {
            return Err("early");
        }
        let (x, y) = (p.0 - centre.0, p.1 - centre.1);
        let square = i128::from(x).pow(2) + i128::from(y).pow(2) - i128::from(radius).pow(2);
        if (convex && square < 0) || (!convex && square > 0) {
            return Err("beyond the arc");
        }
        // As near as the time allows, and one raw.
        for (p, o, d) in [(p.0, o.0, d.0), (p.1, o.1, d.1)] {
            let room = room as i64 + 1;
            if first.moment.sign_at(o - p - room, d) >= 0 || first.moment.sign_at(o - p + room, d) <= 0 {
                return Err("point of an arc");
            }
        }
        let sign = if convex { 1 } else { -1 };
        if hit.axis != Axis::new((sign * x) as i32, (sign * y) as i32) {
            return Err("axis of an arc");
        }
    }
    let owns = |e: &Hit| {
        (i64::from(hit.cell.x), i64::from(hit.cell.y), hit.index) == (e.piece.owner.0, e.piece.owner.1, e.piece.index)
    };
    let Some(owner) = expected.iter().find(|e| owns(e)) else { return Err("owner") };
    if hit.one_way != (owner.piece.id >= 34) || hit.inside || hit.source != 0 {
        return Err("marks");
    }
    Ok(())
}

/// A ray along a line of the grid leaves the open and enters the solid without a piece in its way:
/// between an arc and the solid that it touches.
pub fn gaps(level: &Level, scene: &Scene, o: Point, d: Point, expected: &[Vec<Hit>]) -> Vec<Point> {
    let along_x = d.1 == 0;
    let (from, way) = if along_x { (o.0, d.0) } else { (o.1, d.1) };
    let (across, origin, count) = if along_x {
        (o.1 - level.origin.1, level.origin.0, level.width)
    } else {
        (o.0 - level.origin.0, level.origin.1, level.height)
    };
    if way == 0 || (d.0 != 0 && d.1 != 0) || across % level.cell != 0 {
        return Vec::new();
    }
    let lines = (0..=count).map(|k| origin + k * level.cell).filter(|&at| (at - from) * way >= 0);
    let mut found: Vec<i64> = lines.filter(|&at| (at - from).abs() <= way.abs()).collect();
    found.sort_by_key(|at| (at - from).abs());
    let places = found.into_iter().map(|at| (at, if along_x { (at, o.1) } else { (o.0, at) }));
    let gap = |&(at, p): &(i64, Point)| {
        let moment = Moment::fraction(i128::from((at - from).abs()), i128::from(way.abs()));
        let met = expected.iter().any(|hits| hits[0].moment >= moment && moment >= hits[0].moment);
        !met && scene.enters(p, d) && !scene.enters(p, (-d.0, -d.1))
    };
    places.filter(gap).map(|(_, p)| p).collect()
}

pub fn check(
    level: &Level,
    scene: &Scene,
    map: &TileMap<'_, AllShapes>,
    o: Point,
    d: Point,
    random: &mut Random,
) -> usize {
    let one_way = random.one_in(2);
    let expected = scene.cast(o, d, one_way);
    let rules = |inside| RayRules { inside, one_way };
    let mut all: Vec<RayHit> = map.cast_ray_all(vec2(o), vec2(d), rules(Inside::Ignore)).unwrap().collect();
    let first_of_all = all.first().copied();
    for p in gaps(level, scene, o, d, &expected) {
        let back = Axis::new(-d.0.signum() as i32, -d.1.signum() as i32);
        let gap = all.iter().position(|hit| hit.point == vec2(p) && hit.axis == back);
        all.remove(
            gap.unwrap_or_else(|| panic!("no hit in the gap at {p:?}: {level:?}\nfrom {o:?} by {d:?}\n{all:#?}")),
        );
    }
    let case = |what: &str| {
        format!("{what}: {level:?}\nfrom {o:?} by {d:?}, one_way {one_way}\ngot {all:#?}\nexpected {expected:#?}")
    };
    assert_eq!(all.len(), expected.len(), "{}", case("number"));
    for (hit, expected) in all.iter().zip(&expected) {
        if let Err(what) = agrees(hit, expected, o, d) {
            panic!("{}", case(what));
        }
        let kind = map.kind(hit.cell);
        assert_eq!(hit.flags, kind.flags, "{}", case("flags"));
        assert!(i64::from(hit.cells) <= level.width + level.height + 4, "{}", case("work"));
    }
    let first = map.cast_ray(vec2(o), vec2(d), rules(Inside::Ignore)).unwrap();
    assert_eq!(first, first_of_all, "{}", case("first"));
    let inside = map.cast_ray(vec2(o), vec2(d), rules(Inside::Hit)).unwrap();
    if scene.inside(o) {
        let hit = inside.unwrap();
        let axis = if d.1.abs() > d.0.abs() {
            (0, -d.1.signum())
        } else if d.0 > 0 {
            (-1, 0)
        } else {
            (1, 0)
        };
        assert!(hit.inside && hit.toi.raw() == 0 && hit.point == vec2(o), "{}", case("inside"));
        assert_eq!((i64::from(hit.axis.x), i64::from(hit.axis.y)), axis, "{}", case("inside"));
    } else {
        assert_eq!(inside, first, "{}", case("not inside"));
    }
    let end = (o.0 + d.0, o.1 + d.1);
    let solid = map.cast_ray(vec2(o), vec2(d), Inside::Hit).unwrap();
    assert_eq!(map.line_of_sight(vec2(o), vec2(end)).unwrap(), solid.is_none(), "{}", case("sight"));
    expected.len()
}
