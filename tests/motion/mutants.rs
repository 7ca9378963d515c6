//! Motions, each in one scene with a known answer. Changes of the sources that no other test
//! noticed led to them.

use tilesat::motion::Support;
use tilesat::{Aabb, AllShapes, Axis, Circle, Fx, Grid, Mover, TileKind, TileKinds, TileMap, TileShape, Vec2, Walker};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'a', TileKind::of(TileShape::ConcaveTopLeft))
    .with(b'b', TileKind::of(TileShape::ConcaveTopRight))
    .with(b'c', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'd', TileKind::of(TileShape::ConcaveBottomLeft))
    .with(b'e', TileKind::of(TileShape::ConvexTopLeft))
    .with(b'f', TileKind::of(TileShape::ConvexTopRight))
    .with(b')', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b's', TileKind::of(TileShape::SteepHighBottomLeft));

fn level(tiles: &'static [u8], width: u16) -> TileMap<'static, AllShapes> {
    let height = tiles.len() as u16 / width;
    TileMap::of(tiles, Grid::new(width, height, Fx::from_num(16), Vec2::ZERO).unwrap(), &KINDS).unwrap()
}

/// A ball as wide as a half-round niche reaches the niche's centre, where it touches all of it, and
/// is pushed straight back. The niche is symmetric about the line of its motion, so there is no
/// other direction.
#[test]
fn a_ball_that_fills_a_niche_is_pushed_straight_back() {
    for (tiles, width, centre, back) in [
        (b"..b..c", 3, (32, 16), Axis::NEG_X),
        (b"a..d..", 3, (16, 16), Axis::X),
        (b"....dc", 2, (16, 32), Axis::NEG_Y),
        (b"ab....", 2, (16, 16), Axis::Y),
    ] {
        let map = level(tiles, width);
        let centre = Vec2::from_ints(centre.0, centre.1);
        for (before, by) in [(12, 30), (1, 2), (40, 77)] {
            let along = |n: i16| Vec2::from_ints(back.x as i16 * n, back.y as i16 * n);
            let ball = Circle::new(centre + along(before), Fx::from_num(16)).unwrap();
            let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &ball, along(-by)).unwrap();
            assert_eq!((moved.body.centre(), moved.velocity), (centre, Vec2::ZERO));
            assert!(moved.hits.iter().all(|hit| hit.axis == back) && !moved.hits.is_empty(), "{:?}", moved.hits);
        }
    }
}

/// The gap between a dome and the floor that it touches ends in a point. A body along the floor
/// stops there, and a body in it stays: on both sides of that line is solid.
#[test]
fn a_point_stops_where_a_dome_touches_the_floor() {
    for (tiles, right, way) in [(b"#e##", 16, -1), (b"f###", 16, 1)] {
        let map = level(tiles, 2);
        let end = Vec2::from_ints(right, 16);
        for before in [0, 1, 7] {
            let start = end - Vec2::from_ints(way * before, 0);
            let mover = Mover::platformer(Axis::NEG_Y);
            let motion = Vec2::from_ints(way * 9, 0);
            let ball = mover.move_and_slide(&map, &Circle::new(start, Fx::ZERO).unwrap(), motion).unwrap();
            assert_eq!((ball.body.centre(), ball.velocity), (end, Vec2::ZERO), "{before}");
            let point = mover.move_and_slide(&map, &Aabb::new(start, start).unwrap(), motion).unwrap();
            assert_eq!((point.body.min(), point.velocity), (end, Vec2::ZERO), "{before}");
        }
    }
}

/// A point that moves along x or y also looks for an end of an arc on its way. These looks count as
/// work.
#[test]
fn a_look_for_the_end_of_an_arc_counts() {
    let map = level(b"#e##", 2);
    let point = Circle::new(Vec2::from_ints(30, 16), Fx::ZERO).unwrap();
    let features = |up: Fx| {
        let motion = Vec2::new(Fx::from_num(-3), -up);
        let moved = Mover::new().move_and_slide(&map, &point, motion).unwrap();
        assert_eq!(moved.velocity, motion);
        moved.work.features
    };
    assert_eq!((features(Fx::ZERO), features(Fx::DELTA)), (2, 0));
}

/// A walker between a dome and a steep wall slips down along the wall, to the floor beside it. The
/// way down is a length.
#[test]
fn a_slip_beside_a_dome_is_a_length() {
    let map = level(b"....##s.###)####", 4);
    let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_snap(Fx::from_num(5)).unwrap();
    let step = |body, run: Fx, floor: Option<Support>| {
        let fall = Fx::from_num(u8::from(floor.is_none()));
        walker.walk(&map, &body, Vec2::new(run, fall), floor).unwrap()
    };
    let centre = Vec2::new(Fx::from_num(45.25), Fx::from_num(15));
    let (mut body, mut floor) = (Circle::new(centre, Fx::from_num(5)).unwrap(), None);
    for _ in 0..40 {
        let walked = step(body, Fx::ZERO, floor);
        (body, floor) = (walked.moved.body, walked.floor);
    }
    let walked = step(body, Fx::from_num(-0.5), floor);
    assert!(walked.moved.wall && walked.floor.is_some() && walked.stepped == 0);
    assert_eq!(walked.snapped.to_bits(), 161);
}
