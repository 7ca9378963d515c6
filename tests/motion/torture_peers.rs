//! Cases of other engines' tests that no other file here covers. Torture scenes 25, 34, 35 and 36
//! for the remaining bodies and levels.

use tilesat::motion::escape;
use tilesat::prelude::*;
use tilesat::{
    Aabb, Axis, Circle, Fx, Inside, Joined, Mover, Path, PathKind, Segment, SegmentMap, Side, Solid, Solids, TileKind,
    TileKinds, TileMap, Vec2, World, motion::Ride, world::RayRules,
};

static SENSOR: TileKinds = TileKinds::EMPTY.with(b's', TileKind::EMPTY.with_flags(1));
static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'-', TileKind::ONE_WAY_UP);
const MOVER: Mover = Mover::platformer(Axis::NEG_Y);
const EMPTY: &str = "   \n   \n   ";

fn at(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

fn rect(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(at(x, y), at(x + w, y + h)).unwrap()
}

fn disc(x: i16, y: i16, r: i16) -> Circle {
    Circle::new(at(x, y), Fx::from_num(r)).unwrap()
}

fn bytes(paths: &[(PathKind, &[Vec2])]) -> Vec<u8> {
    let paths: Vec<_> = paths.iter().map(|(kind, points)| Path::new(*kind, points)).collect();
    let mut out = vec![0; SegmentMap::measure(&paths, Fx::from_num(16)).unwrap().bytes()];
    SegmentMap::build_into(&paths, Fx::from_num(16), &mut out).unwrap();
    out
}

/// parry's rays at the triangle (0,-10), (0,10), (10,0): from outside, from inside, from its side.
#[test]
fn parry_triangle() {
    let bytes = bytes(&[(PathKind::Solid, &[at(0, -10), at(0, 10), at(10, 0)])]);
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    let right = |x, inside| map.cast_ray(at(x, 0), at(40, 0), inside).unwrap();
    let hit = right(-10, Inside::Hit).unwrap();
    assert_eq!((hit.toi.raw(), hit.point, hit.axis, hit.inside), (1 << 28, at(0, 0), Axis::NEG_X, false));
    let hit = right(2, Inside::Hit).unwrap();
    assert!(hit.inside && hit.toi.raw() == 0);
    assert_eq!(right(2, Inside::Ignore), None);
    let hit = right(0, Inside::Hit).unwrap();
    assert_eq!((hit.toi.raw(), hit.inside, hit.axis), (0, false, Axis::NEG_X));
    assert_eq!(right(11, Inside::Hit), None);
}

/// parry's `ball_cuboid_contact` and its segment without length; box2d's `PointInShapeTest` and
/// `SegmentDistanceTest`.
#[test]
fn parry_and_box2d_pairs() {
    let (ball, cube) = (disc(1, 1, 1), rect(-1, -1, 2, 2));
    let contact = ball.contact(&cube).unwrap();
    assert_eq!((contact.depth(), ball.overlaps(&cube)), (Fx::ONE, true));
    assert!(!ball.translated(contact.push_out()).unwrap().overlaps(&cube));
    // Ball of 0.5 at (.0517938, 3.05178815), unit box around (0, 4): the depth is .05178815, along
    // y, rounded up.
    let raw = |x: f64| (x * 65536.0).round() as i32;
    let centre = Vec2::from_raw(raw(0.051_793_8), raw(3.051_788_15));
    let ball = Circle::new(centre, Fx::lit("0.5")).unwrap();
    let cube = Aabb::new(Vec2::from_raw(-1 << 15, 7 << 15), Vec2::from_raw(1 << 15, 9 << 15)).unwrap();
    let (one, other) = (ball.contact(&cube).unwrap(), cube.contact(&ball).unwrap());
    assert_eq!((one.axis(), other.axis()), (Axis::Y, Axis::NEG_Y));
    assert_eq!((one.depth().to_bits(), other.depth()), (raw(0.051_788_15), one.depth()));
    let (none, bar) = (Segment::new(at(3, 3), at(3, 3)).unwrap(), Segment::new(at(0, 0), at(9, 0)).unwrap());
    assert!(!none.overlaps(&bar) && !none.touches(&bar) && !bar.touches(&none));
    let half = Vec2::from_raw(1 << 15, 1 << 15);
    assert!(disc(0, 0, 1).contains(&half) && rect(-1, -1, 2, 2).contains(&half));
    assert!(!disc(0, 0, 1).contains(&at(4, -4)) && !rect(-1, -1, 2, 2).contains(&at(4, -4)));
    let (p, q) = (Segment::new(at(-1, -1), at(-1, 1)).unwrap(), Segment::new(at(2, 0), at(1, 0)).unwrap());
    assert_eq!((p.distance(&q), q.distance(&p)), (Fx::from_num(2), Fx::from_num(2)));
}

/// box2d's large worlds: the same contact, cast and motion far from the origin, bit for bit. Boxes
/// .9 apart overlap by .1, and a ray reaches -.5.
#[test]
fn box2d_large_world() {
    let tenth = Fx::lit("0.1").to_bits();
    let ask = |o: Vec2| {
        let cube = |dx: i32| {
            let c = o + Vec2::from_raw(dx, 0);
            let half = Vec2::from_raw(1 << 15, 1 << 15);
            Aabb::new(c - half, c + half).unwrap()
        };
        let (a, b) = (cube(0), cube((1 << 16) - tenth));
        let contact = a.contact(&b).unwrap();
        let ray = a.cast_ray(o + at(-4, 0), at(8, 0), Inside::Hit).unwrap().unwrap();
        let ball = Circle::new(o + at(-4, 0), Fx::lit("0.25")).unwrap();
        let cast = ball.cast_shape(&a, at(8, 0), Inside::Hit).unwrap().unwrap();
        (contact.axis(), contact.depth(), contact.push_out(), ray.displacement, ray.toi, cast)
    };
    let here = ask(Vec2::ZERO);
    assert_eq!((here.0, here.1.to_bits(), here.3), (Axis::X, tenth, Vec2::from_raw(7 << 15, 0)));
    for (x, y) in [(1, 0), (-1, 1), (8000 << 16, -8000 << 16), (12_345_678, 499_999_999), (-500_000_001, 3)] {
        assert_eq!(ask(Vec2::from_raw(x, y)), here);
    }
}

/// bump's `toCell`, `toWorld`, `queryRect` of a rectangle of negative size, and a segment that only
/// touches a border.
#[test]
fn bump_grid_and_queries() {
    let map = TileMap::from_ascii("##", &KINDS).unwrap().with_cell(Fx::from_num(64)).unwrap();
    let cell = |x: Fx| map.cell_at(Vec2::new(x, Fx::ZERO)).x;
    // bump counts from one.
    assert_eq!((cell(Fx::lit("63.9")), cell(Fx::from_num(64)), cell(Fx::from_num(-1))), (0, 1, -1));
    assert!(Aabb::new(at(0, 0), at(-1, -1)).is_err());
    let along = Segment::new(at(10, 0), at(30, 0)).unwrap();
    let tile = rect(0, 0, 64, 64);
    assert!(!along.overlaps(&tile) && along.touches(&tile));
}

/// box2d's circle of .5 that is dropped on a chain, and its bullet that passes a sensor in one
/// begin and one end.
#[test]
fn box2d_chain_and_sensor() {
    let points = [at(30, 0), at(10, 0), at(-10, 0), at(-30, 0)]; // y up: its front is above
    let bytes = bytes(&[(PathKind::OneWay, &points)]);
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    let mover = Mover::platformer(Axis::Y);
    let (mut ball, mut v) = (Circle::new(at(0, 4), Fx::lit("0.5")).unwrap(), Vec2::ZERO);
    for _ in 0..600 {
        let moved = mover.move_and_slide(&map, &ball, v + Vec2::from_raw(0, -182)).unwrap();
        (ball, v) = (moved.body, moved.velocity);
    }
    assert_eq!((ball.centre(), v), (Vec2::from_raw(0, 1 << 15), Vec2::ZERO));
    // From 7.4 by -20 / 60 per frame past a sensor from 1 to 2.
    let row = TileMap::from_ascii(".s.......", &SENSOR).unwrap().with_cell(Fx::ONE).unwrap();
    let mut bullet = Circle::new(Vec2::new(Fx::lit("7.4"), Fx::lit("0.5")), Fx::lit("0.1")).unwrap();
    let (mut begins, mut ends, mut was) = (0, 0, false);
    for _ in 0..40 {
        let moved = MOVER.move_and_slide(&row, &bullet, Vec2::new(-Fx::ONE / 3, Fx::ZERO)).unwrap();
        bullet = moved.body;
        let on = row.flags_touched(&bullet) == 1;
        (begins, ends) = (begins + u32::from(on && !was), ends + u32::from(was && !on));
        was = on;
    }
    assert_eq!((begins, ends), (1, 1));
}

/// 25: a centre exactly on a wall, on its end, on a tile's side and corner, and in its middle. Out
/// in one step, and never by nothing.
#[test]
fn scene_25_centre_on_the_surface() {
    let bytes = bytes(&[(PathKind::Wall, &[at(0, 0), at(30, 40)]), (PathKind::Wall, &[at(200, 0), at(300, 0)])]);
    let walls = SegmentMap::from_bytes(&bytes).unwrap();
    for centre in [at(15, 20), at(0, 0), at(30, 40), at(250, 0), at(200, 0), at(300, 0)] {
        let ball = Circle::new(centre, Fx::from_num(5)).unwrap();
        let free = escape(&walls, &ball).unwrap_or_else(|e| panic!("{centre:?}: {e:?}"));
        assert!(!walls.overlaps(&free) && free.centre() != centre, "{centre:?}");
        let way = free.centre() - centre;
        let far = way.raw().0.abs().max(way.raw().1.abs());
        assert!(far <= (5 << 16) + 4, "{centre:?}: {way:?}");
    }
    let tile = TileMap::from_ascii("#", &KINDS).unwrap();
    // On its sides by the radius; on its corners along a side as well.
    for (x, y) in [(0, 8), (16, 8), (8, 0), (8, 16), (0, 0), (16, 0), (16, 16), (0, 16)] {
        let ball = disc(x, y, 5);
        let free = escape(&tile, &ball).unwrap();
        let (a, b) = (free.centre() - ball.centre()).raw();
        let far = a.abs().max(b.abs());
        assert!(!tile.overlaps(&free) && (3 << 16..=(5 << 16) + 4).contains(&far), "{x} {y}: {a} {b}");
    }
    // In its middle there are four equally short ways out. The side with the smaller coordinates is
    // reported first. None if no side is within reach.
    let free = escape(&tile, &disc(8, 8, 9)).unwrap();
    let (a, b) = (free.centre() - at(8, 8)).raw();
    assert!(!tile.overlaps(&free) && (17 << 16..=(17 << 16) + 4).contains(&-b) && a == 0, "{a} {b}");
    let mut all = tilesat::heapless::Vec::<_, 8>::new();
    tile.contacts(&disc(8, 8, 9), tilesat::world::OneWay::Ignore, &mut all).unwrap();
    assert!(all.len() == 4 && all.iter().all(|c| c.depth() == Fx::from_num(17)));
    assert!(escape(&tile, &disc(8, 8, 5)).is_err());
}

/// 34: circles, as `solids_carry` tests boxes. A one-way that rises faster than the body falls
/// carries it. One that sinks faster leaves it.
#[test]
fn scene_34_one_way_that_moves() {
    let level = TileMap::from_ascii(EMPTY, &KINDS).unwrap();
    for one_way in [false, true] {
        let lift = |v: i16| {
            let s = Solid::new(rect(0, 0, 20, 1), 5).unwrap();
            let s = if one_way { s.with_one_way(Side::Up) } else { s };
            s.with_motion(at(0, v)).unwrap()
        };
        for speed in [5, 900] {
            let ride = MOVER.ride(&level, &[lift(-speed)], &disc(10, -6, 4), Fx::ONE).unwrap();
            assert_eq!((ride.ride, ride.body), (Ride::Pushed { by: 5, normal: Axis::NEG_Y }, disc(10, -4 - speed, 4)));
            let stands = MOVER.ride(&level, &[lift(-speed)], &disc(10, -4, 4), Fx::ZERO).unwrap();
            assert_eq!((stands.ride, stands.body), (Ride::Carried, disc(10, -4 - speed, 4)));
            let left = MOVER.ride(&level, &[lift(speed)], &disc(10, -4, 4), Fx::ONE).unwrap();
            assert_eq!((left.ride, left.body), (Ride::Free, disc(10, -4, 4)));
            // No false hit: one frame later it falls freely.
            let mut list = [lift(speed)];
            Solid::move_all(&mut list);
            let solids = Solids::new(&list);
            let moved = MOVER.move_and_slide(&Joined::new(&level, &solids), &left.body, at(0, 1)).unwrap();
            assert_eq!((moved.body, moved.hits.len()), (disc(10, -3, 4), 0));
            // From below, half through it.
            let inside = MOVER.ride(&level, &[lift(-speed)], &disc(10, 2, 4), Fx::ONE);
            assert!(!one_way || inside.unwrap().body == disc(10, 2, 4));
        }
    }
}

/// 35: rays, circles and boxes at one-way tiles and chains, from above and from below, included and
/// excluded.
#[test]
fn scene_35_casts_at_one_ways() {
    let tiles = TileMap::from_ascii("....\n....\n.--.\n....\n", &KINDS).unwrap(); // the top is y = 32
    let bytes = bytes(&[(PathKind::OneWay, &[at(16, 32), at(32, 32), at(48, 32)])]);
    casts_at_a_one_way(&tiles, |a, b, c, r| {
        (tiles.cast_shape(a, c, r).unwrap().is_some(), tiles.cast_shape(b, c, r).unwrap().is_some())
    });
    let chain = SegmentMap::from_bytes(&bytes).unwrap();
    casts_at_a_one_way(&chain, |a, b, c, r| {
        (chain.cast_shape(a, c, r).unwrap().is_some(), chain.cast_shape(b, c, r).unwrap().is_some())
    });
    for one_way in [false, true] {
        let rules = RayRules { inside: Inside::Hit, one_way };
        assert_eq!(tiles.cast_ray(at(32, 12), at(0, 40), rules).unwrap().is_some(), one_way);
        assert_eq!(chain.cast_ray(at(32, 12), at(0, 40), rules).unwrap().is_some(), one_way);
        assert!(tiles.cast_ray(at(30, 52), at(0, -40), rules).unwrap().is_none());
        assert!(chain.cast_ray(at(30, 52), at(0, -40), rules).unwrap().is_none());
    }
}

fn casts_at_a_one_way<W: World>(world: &W, cast: impl Fn(&Circle, &Aabb, Vec2, RayRules) -> (bool, bool)) {
    // The lower side, the motion, and whether it stops a moving body.
    for (low, motion, stops) in [(26, 40, true), (32, 40, true), (33, 40, false), (66, -40, false), (26, 6, false)] {
        let (ball, cube) = (disc(32, low - 6, 6), rect(26, low - 12, 12, 12));
        for one_way in [false, true] {
            let rules = RayRules { inside: Inside::Hit, one_way };
            assert_eq!(
                cast(&ball, &cube, at(0, motion), rules),
                (stops && one_way, stops && one_way),
                "{low} {motion}"
            );
        }
        let moved = MOVER.move_and_slide(world, &ball, at(0, motion)).unwrap();
        assert_eq!(moved.floor, stops);
        let moved = MOVER.move_and_slide(world, &cube, at(0, motion)).unwrap();
        assert_eq!(moved.floor, stops);
    }
}

/// 36: under a ceiling of segments, from a platform, and at a wall of them: exactly the available
/// room, with the platforms in either order.
#[test]
fn scene_36_squashed_at_segments() {
    let bytes = bytes(&[(PathKind::Wall, &[at(-50, 0), at(90, 0), at(90, 90)])]);
    let level = SegmentMap::from_bytes(&bytes).unwrap();
    let lift = |up: i16| Solid::new(rect(0, 18, 60, 4), 7).unwrap().with_motion(at(0, -up)).unwrap();
    let other = Solid::new(rect(-40, 40, 8, 8), 3).unwrap().with_motion(at(1, -2)).unwrap();
    let press = |by: i16| Solid::new(rect(60, 20, 12, 40), 7).unwrap().with_motion(at(by, 0)).unwrap();
    for order in [false, true] {
        let list = |s: Solid| if order { [other, s] } else { [s, other] };
        // 16 high, 2 of room; then a gap of 15.
        let go = |s: Solid, b: Aabb| MOVER.ride(&level, &list(s), &b, Fx::ONE).unwrap();
        let pushed = go(lift(2), rect(10, 1, 16, 16));
        assert_eq!((pushed.ride, pushed.body), (Ride::Pushed { by: 7, normal: Axis::NEG_Y }, rect(10, 0, 16, 16)));
        let squashed = go(lift(3), rect(10, 1, 16, 16));
        assert_eq!(squashed.ride, Ride::Squashed { by: 7, normal: Axis::NEG_Y });
        assert_eq!(squashed.body, rect(10, 1, 16, 16));
        let ball = |s: Solid, b: Circle| MOVER.ride(&level, &list(s), &b, Fx::ONE).unwrap();
        assert_eq!(ball(lift(2), disc(20, 9, 8)).body, disc(20, 8, 8));
        assert_eq!(ball(lift(3), disc(20, 9, 8)).ride, Ride::Squashed { by: 7, normal: Axis::NEG_Y });
        assert_eq!(go(press(2), rect(73, 30, 16, 16)).body, rect(74, 30, 16, 16));
        assert_eq!(go(press(3), rect(73, 30, 16, 16)).ride, Ride::Squashed { by: 7, normal: Axis::X });
        assert_eq!(ball(press(2), disc(81, 40, 8)).body, disc(82, 40, 8));
        assert_eq!(ball(press(3), disc(81, 40, 8)).ride, Ride::Squashed { by: 7, normal: Axis::X });
    }
}
