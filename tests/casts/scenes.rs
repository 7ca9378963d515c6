//! Casts in named scenes: torture scenes, cases from other engines' tests, one-way faces, starts
//! inside.

use tilesat::prelude::*;
use tilesat::{
    Aabb, Axis, Circle, Fx, Inside, Joined, Path, PathKind, Segment, SegmentMap, TileKind, TileKinds, TileMap, Toi,
    Vec2, world::RayRules,
};

static KINDS: TileKinds =
    TileKinds::EMPTY.with(b'#', TileKind::FULL.with_flags(4)).with(b'-', TileKind::ONE_WAY_UP.with_flags(2));

fn at(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

/// Tenths of units.
fn tenths(x: i32, y: i32) -> Vec2 {
    assert!(x * 65536 % 10 == 0 && y * 65536 % 10 == 0 || x % 5 == 0 && y % 5 == 0);
    Vec2::from_raw(x * 65536 / 10, y * 65536 / 10)
}

fn rect(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(at(x, y), at(x + w, y + h)).unwrap()
}

fn disc(centre: Vec2, r: i16) -> Circle {
    Circle::new(centre, Fx::from_num(r)).unwrap()
}

/// Parts of a motion.
fn parts(num: u64, den: u64) -> Toi {
    Toi::from_raw(((num << 30) / den) as u32).unwrap()
}

fn map(rows: &str) -> TileMap<'_> {
    TileMap::from_ascii(rows, &KINDS).unwrap()
}

/// 6: the outside corner is round.
#[test]
fn outside_corner() {
    let (wall, ball, d) = (rect(20, 3, 20, 27), disc(at(0, 0), 5), at(40, 0));
    let hit = ball.cast_shape(&wall, d, Inside::Hit).unwrap().unwrap();
    assert_eq!(ball.exact_toi(&wall, d, Inside::Hit).unwrap(), Some(parts(4, 10)));
    let (x, y) = (hit.displacement.x.to_bits(), hit.axis.unit().raw());
    assert!((16 << 16) - x < 2 && x <= 16 << 16, "{hit:?}");
    let (exact_x, exact_y) = (-(4i64 << 30) / 5, -(3i64 << 30) / 5);
    assert!((i64::from(y.0) - exact_x).abs() < 1 << 15 && (i64::from(y.1) - exact_y).abs() < 1 << 15, "{hit:?}");
    assert!(!ball.translated(hit.displacement).unwrap().overlaps(&wall));
}

/// 7: past an outside corner.
#[test]
fn outside_corner_miss() {
    let (wall, ball) = (rect(20, 20, 40, 40), disc(tenths(55, 255), 5));
    assert_eq!(ball.cast_shape(&wall, at(20, -20), Inside::Hit).unwrap(), None);
    assert!(!ball.would_hit(&wall, at(20, -20), Inside::Hit).unwrap());
}

/// 9: a vertex head-on, as bare segments and as a level.
#[test]
fn peak() {
    let ball = disc(at(16, 0), 8);
    let points = [at(0, 56), at(16, 40), at(32, 56)];
    for side in [Segment::new(points[0], points[1]).unwrap(), Segment::new(points[2], points[1]).unwrap()] {
        let hit = ball.cast_shape(&side, at(0, 64), Inside::Hit).unwrap().unwrap();
        assert_eq!((hit.axis, hit.displacement.x), (Axis::NEG_Y, Fx::ZERO));
        assert_eq!(ball.exact_toi(&side, at(0, 64), Inside::Hit).unwrap(), Some(parts(1, 2)));
    }
    let mut bytes = heapless::Vec::<u8, 1024>::new();
    let level = SegmentMap::build_vec(&[Path::new(PathKind::Solid, &points)], Fx::lit("16"), &mut bytes).unwrap();
    let found = level.cast_shape(&ball, at(0, 64), Inside::Hit).unwrap().unwrap();
    assert_eq!((found.hit.axis, found.body.centre().x), (Axis::NEG_Y, Fx::from_num(16)));
    assert!((32 << 16) - found.body.centre().y.to_bits() <= 2 && found.hit.toi <= parts(1, 2), "{found:?}");
}

/// 21: a ray through the common end of two faces stops at one of them.
#[test]
fn common_end() {
    let points = [at(0, 56), at(16, 40), at(32, 56)];
    let mut bytes = heapless::Vec::<u8, 1024>::new();
    for (kind, points) in
        [(PathKind::Solid, &points[..]), (PathKind::Wall, &points[..]), (PathKind::Wall, &points[..2])]
    {
        let level = SegmentMap::build_vec(&[Path::new(kind, points)], Fx::lit("16"), &mut bytes).unwrap();
        let hit = level.cast_ray(at(16, 0), at(0, 64), Inside::Hit).unwrap().unwrap();
        assert_eq!((hit.point, hit.toi), (at(16, 40), parts(40, 64)));
        let point = Circle::new(at(16, 0), Fx::ZERO).unwrap();
        let found = level.cast_shape(&point, at(0, 64), Inside::Hit).unwrap();
        // At the free end of a wall a point may pass.
        assert!(found.is_none_or(|f| f.hit.toi == parts(40, 64)) && (found.is_some() || points.len() == 2), "{kind:?}");
        bytes.clear();
    }
}

/// 35: a one-way face for rays and bodies from above and from below.
#[test]
fn one_way() {
    let level = map("....\n....\n.--.\n....\n"); // its top is at y = 32
    let rules = |one_way| RayRules { inside: Inside::Hit, one_way };
    let ball = |y| disc(at(32, y), 6);
    for (one_way, expected) in [(true, Some(parts(6, 40))), (false, None)] {
        let down = level.cast_shape(&ball(20), at(0, 40), rules(one_way)).unwrap();
        assert_eq!(down.map(|f| f.hit.toi), expected);
        assert!(down.is_none_or(|f| f.hit.one_way && f.hit.flags == 2 && f.body.centre() == at(32, 26)));
        assert_eq!(level.cast_shape(&ball(60), at(0, -40), rules(one_way)).unwrap(), None);
        // Half through it already.
        assert_eq!(level.cast_shape(&ball(30), at(0, 40), rules(one_way)).unwrap(), None);
        let ray = level.cast_ray(at(32, 12), at(0, 40), rules(one_way)).unwrap();
        assert_eq!(ray.is_some(), one_way);
        assert_eq!(level.cast_ray(at(32, 52), at(0, -40), rules(one_way)).unwrap(), None);
    }
}

#[test]
fn start_inside() {
    let level = map("#...#\n#...#\n");
    // Half in the left wall.
    let (ball, player) = (disc(at(16, 16), 6), rect(10, 10, 12, 12));
    let found = level.cast_shape(&ball, at(60, 1), Inside::Hit).unwrap().unwrap();
    assert!(found.inside && found.hit.toi == Toi::ZERO && found.hit.axis == Axis::NEG_X && found.body == ball);
    let found = level.cast_shape(&player, at(0, 2), Inside::Hit).unwrap().unwrap();
    assert!(found.inside && found.hit.axis == Axis::NEG_Y && found.body == player);
    // Even without a motion. Outside, no motion meets nothing.
    assert!(level.cast_shape(&player, Vec2::ZERO, Inside::Hit).unwrap().is_some());
    assert_eq!(level.cast_shape(&player, Vec2::ZERO, Inside::Ignore).unwrap(), None);
    assert_eq!(level.cast_shape(&rect(20, 10, 8, 8), Vec2::ZERO, Inside::Hit).unwrap(), None);
    // Out of one wall into the other.
    let found = level.cast_shape(&ball, at(60, 1), Inside::Ignore).unwrap().unwrap();
    assert_eq!((found.hit.toi, found.hit.axis, found.inside), (parts(42, 60), Axis::NEG_X, false));
    assert_eq!((found.body.centre().x, level.overlaps(&found.body)), (Fx::from_num(58), false));
    let found = level.cast_shape(&player, at(60, 1), Inside::Ignore).unwrap().unwrap();
    assert_eq!((found.hit.toi, found.hit.axis, found.body.max().x), (parts(42, 60), Axis::NEG_X, Fx::from_num(64)));
    // Wider than the way between: it still overlaps the first wall when it hits the second one.
    let wide = rect(10, 10, 50, 12);
    let found = level.cast_shape(&wide, at(20, 0), Inside::Ignore).unwrap().unwrap();
    assert_eq!((found.hit.toi, found.body), (parts(4, 20), rect(14, 10, 50, 12)));
    // It also passes corners that it overlaps.
    let block = map("#....#\n......\n");
    let found = block.cast_shape(&disc(at(20, 20), 8), at(80, -20), Inside::Ignore).unwrap().unwrap();
    assert_eq!((found.hit.cell.x, found.hit.axis), (5, Axis::NEG_X));
    assert_eq!(block.cast_shape(&disc(at(20, 20), 8), at(-10, -1), Inside::Ignore).unwrap(), None);
}

/// Two levels as one: the nearer hit, and no seam between them.
#[test]
fn joined() {
    let near = map("....\n####\n");
    let far = map("...#\n####\n").with_origin(at(64, 0)).unwrap();
    let level = Joined::new(&near, &far);
    let found = level.cast_shape(&disc(at(8, 8), 8), at(120, 0), Inside::Hit).unwrap().unwrap();
    assert_eq!((found.hit.source, found.hit.toi, found.body.centre()), (1, parts(96, 120), at(104, 8)));
    assert_eq!(found.hit.flags, 4);
}

/// bump.lua's `rect_spec` and `responses_spec`.
#[test]
fn bump() {
    let cast = |from: [i16; 4], other: [i16; 4], goal: (i16, i16)| {
        let [x, y, w, h] = from;
        let motion = at(goal.0 - x, goal.1 - y);
        let other = rect(other[0], other[1], other[2], other[3]);
        let hit = rect(x, y, w, h).cast_shape(&other, motion, Inside::Hit).unwrap();
        hit.map(|hit| (hit.toi, hit.axis, at(x, y) + hit.displacement))
    };
    let spec = |hit: Option<(Toi, Axis, Vec2)>| hit.map(|(toi, axis, _)| (toi, axis));
    assert_eq!(spec(cast([1, 1, 1, 1], [5, 0, 1, 1], (6, 0))), Some((parts(6, 10), Axis::NEG_X)));
    assert_eq!(spec(cast([6, 0, 1, 1], [1, 0, 1, 1], (1, 1))), Some((parts(8, 10), Axis::X)));
    assert_eq!(spec(cast([0, 0, 1, 1], [0, 4, 1, 1], (0, 5))), Some((parts(6, 10), Axis::NEG_Y)));
    assert_eq!(spec(cast([0, 4, 1, 1], [0, 0, 1, 1], (0, -1))), Some((parts(6, 10), Axis::Y)));
    assert_eq!(cast([0, 16, 16, 16], [16, 0, 16, 16], (-1, 15)), None); // nasty corner
    let touch = |goal| cast([10, 10, 2, 2], [0, 0, 8, 8], goal).map(|(_, axis, place)| (axis, place));
    assert_eq!(touch((1, 4)), Some((Axis::Y, at(7, 8))));
    assert_eq!(touch((4, 1)), Some((Axis::X, at(8, 7))));
    assert_eq!(touch((1, 1)), Some((Axis::X, at(8, 8)))); // perfect corner
}

/// box2d's shape cast and time of impact, and its bullet through a sensor; `PixelRoot32`'s swept
/// circle and corner touch.
#[test]
fn other_engines() {
    let (square, bar) = (rect(-1, -1, 2, 2), Segment::new(at(2, -1), at(2, 1)).unwrap());
    assert_eq!(bar.cast_shape(&square, at(-2, 0), Inside::Hit).unwrap().map(|h| h.toi), Some(parts(1, 2)));
    assert_eq!(square.cast_shape(&bar, at(2, 0), Inside::Hit).unwrap().map(|h| h.toi), Some(parts(1, 2)));
    let (wall, bullet) = (rect(1, -8, 1, 16), disc(at(7, 0), 1));
    let hit = bullet.cast_shape(&wall, at(-20, 0), Inside::Hit).unwrap().unwrap();
    assert_eq!((hit.toi, hit.axis), (parts(4, 20), Axis::X));
    let after = disc(at(-13, 0), 1);
    assert!(!after.would_hit(&wall, at(-20, 0), Inside::Hit).unwrap());
    let (block, ball) = (rect(0, 0, 10, 10), disc(at(-20, 5), 5));
    assert_eq!(ball.cast_shape(&block, at(40, 0), Inside::Hit).unwrap().map(|h| h.toi), Some(parts(375, 1000)));
    let started = disc(at(5, 5), 5).cast_shape(&block, at(40, 0), Inside::Hit).unwrap().unwrap();
    assert!(started.inside && started.toi == Toi::ZERO);
    let corner = rect(5, 5, 5, 5);
    assert!(corner.cast_ray(at(0, 0), at(5, 5), Inside::Hit).unwrap().is_some());
    assert!(!at(0, 0).would_hit(&corner, at(5, 5), Inside::Hit).unwrap());
    assert!(at(0, 0).would_hit(&corner, at(6, 6), Inside::Hit).unwrap());
}

/// A point is stopped by the inside of boxes and circles.
#[test]
fn points() {
    let block = rect(10, -5, 10, 10);
    let hit = at(0, 0).cast_shape(&block, at(20, 0), Inside::Hit).unwrap().unwrap();
    assert_eq!((hit.toi, hit.axis, hit.displacement), (parts(1, 2), Axis::NEG_X, at(10, 0)));
    assert!(!at(0, 5).would_hit(&block, at(20, 0), Inside::Hit).unwrap()); // along its side
    let ball = disc(at(20, 3), 5);
    assert_eq!(at(0, 0).exact_toi(&ball, at(32, 0), Inside::Hit).unwrap(), Some(parts(16, 32)));
    assert!(!at(0, -2).would_hit(&ball, at(40, 0), Inside::Hit).unwrap()); // a tangent
    assert!(Vec2::from_raw(i32::MAX, 0).would_hit(&ball, at(1, 0), Inside::Hit).is_err());
}
