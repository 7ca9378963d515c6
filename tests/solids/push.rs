//! A body in the way of a moving solid yields as far as there is room, and is squashed if there is
//! none. It never enters the level.

use tilesat::{
    Aabb, AllShapes, Axis, Body, Circle, Fx, Joined, MoveError, Mover, Solid, Solids, TileKind, TileKinds, TileMap,
    TileShape, World, motion::Ride,
};
use tilesat_judge::solids::{P, disc, raw, rect, solid, vec2};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
static SHAPES: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'C', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'L', TileKind::of(TileShape::SlopeTopLeft));
const UNIT: i64 = 1 << 16;
const MOVER: Mover = Mover::platformer(Axis::NEG_Y);

/// A ball under a ceiling, on the corner of a lift that goes away sideways and a little up. The
/// ceiling keeps it from going along, and the lift passes it where it is.
#[test]
fn a_ball_that_its_lift_leaves_is_not_squashed() {
    let level = TileMap::from_ascii("########\n........\n........\n", &KINDS).unwrap(); // down to y = 16
    let ball = disc((76 * UNIT, 24 * UNIT), 8 * UNIT);
    let mut left = 0;
    for (x, y) in (1..7).flat_map(|x| (1..40).map(move |y| (-x * UNIT / 2, -y * UNIT / 64))) {
        // Its corner at the lower left of the ball, outside of it by less than a raw unit.
        let triples = [(3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25)];
        for (dx, dy) in triples.map(|(a, b, c)| (8 * UNIT * a / c, 8 * UNIT * b / c + 1)) {
            let corner = (76 * UNIT - dx, 24 * UNIT + dy);
            let lift = solid((corner.0 - 30 * UNIT, corner.1), (corner.0, corner.1 + 8 * UNIT), 3);
            let lift = lift.with_motion(vec2((x, y))).unwrap();
            // The corner goes away from the centre: it does not come nearer.
            if x * -dx + y * dy < 0 {
                continue;
            }
            left += 1;
            let (ride, after) = ride(&level, &[lift], &ball);
            assert_eq!(ride, Ride::Carried, "{x} {y} {dx} {dy}");
            assert!(!Solids::new(&[lift.moved()]).overlaps(&after) && !level.overlaps(&after));
        }
    }
    assert!(left > 100, "{left}");
}

fn ride<W: World, B: Body + PartialEq + std::fmt::Debug>(level: &W, solids: &[Solid], body: &B) -> (Ride, B) {
    let first = MOVER.ride(level, solids, body, Fx::ONE).unwrap();
    // The order of the list does not matter.
    let mut list = solids.to_vec();
    for _ in 0..list.len() {
        list.rotate_left(1);
        for reversed in [false, true] {
            if reversed {
                list.reverse();
            }
            assert_eq!(MOVER.ride(level, &list, body, Fx::ONE).unwrap().body, first.body);
            assert_eq!(MOVER.ride(level, &list, body, Fx::ONE).unwrap().ride, first.ride);
        }
    }
    (first.ride, first.body)
}

const fn pushed(by: u16, normal: Axis) -> Ride {
    Ride::Pushed { by, normal }
}

fn moving(a: P, b: P, key: u16, motion: P) -> Solid {
    solid((a.0 * UNIT, a.1 * UNIT), (b.0 * UNIT, b.1 * UNIT), key).with_motion(vec2(motion)).unwrap()
}

fn boxed(a: P, b: P) -> Aabb {
    rect((a.0 * UNIT, a.1 * UNIT), (b.0 * UNIT, b.1 * UNIT))
}

/// Free columns and rows 1 and 2, walls around.
fn room() -> TileMap<'static> {
    TileMap::from_ascii("####\n#  #\n#  #\n####", &KINDS).unwrap()
}

#[test]
fn a_lift_squashes_at_the_ceiling_and_a_wall_at_the_wall() {
    let level = room(); // free from (16, 16) to (48, 48)
    let body = boxed((20, 17), (36, 33)); // 16 high, 1 below the ceiling
    let lift = |up: i64| moving((16, 34), (48, 40), 7, (0, -up));
    // 2 of room: pushed by 1, and by all of it. With half a unit less, the gap would be 15.5.
    assert_eq!(ride(&level, &[lift(UNIT)], &body), (Ride::Free, body));
    let (r, b) = ride(&level, &[lift(2 * UNIT)], &body);
    assert_eq!((r, raw(b.min()).1), (pushed(7, Axis::NEG_Y), 16 * UNIT));
    let squashed = Ride::Squashed { by: 7, normal: Axis::NEG_Y };
    for more in [1, UNIT / 2, UNIT, 100 * UNIT] {
        let up = (2 * UNIT + more).min(40 * UNIT);
        assert_eq!(ride(&level, &[lift(up)], &body), (squashed, body), "{more}");
        // Others in the list change nothing.
        let others = [lift(up), moving((40, 18), (44, 20), 1, (UNIT, 3)), moving((16, 40), (48, 44), 2, (0, -up + 1))];
        assert_eq!(ride(&level, &others, &body), (squashed, body));
    }
    // The same across.
    let body = boxed((17, 20), (33, 36));
    let wall = |left: i64| moving((34, 16), (40, 48), 7, (-left, 0));
    assert_eq!(ride(&level, &[wall(UNIT)], &body), (Ride::Free, body));
    let (r, b) = ride(&level, &[wall(2 * UNIT)], &body);
    assert_eq!((r, raw(b.min()).0), (pushed(7, Axis::NEG_X), 16 * UNIT));
    assert_eq!(ride(&level, &[wall(2 * UNIT + 1)], &body), (Ride::Squashed { by: 7, normal: Axis::NEG_X }, body));
    // A circle, in both directions.
    let ball = disc((25 * UNIT, 25 * UNIT), 8 * UNIT);
    assert_eq!(ride(&level, &[lift(2 * UNIT)], &ball).1.centre(), vec2((25 * UNIT, 24 * UNIT)));
    assert_eq!(ride(&level, &[lift(2 * UNIT + 1)], &ball), (squashed, ball));
    assert_eq!(ride(&level, &[wall(2 * UNIT)], &ball).1.centre(), vec2((24 * UNIT, 25 * UNIT)));
}

#[test]
fn two_crushers_leave_the_room_between_them_or_squash() {
    let level = TileMap::from_ascii("   ", &KINDS).unwrap();
    let body = boxed((0, 0), (10, 10));
    let crushers = |a: i64, b: i64| [moving((-20, -5), (-2, 15), 3, (a, 0)), moving((13, -5), (20, 15), 4, (-b, 0))];
    let (r, b) = ride(&level, &crushers(4 * UNIT, UNIT), &body);
    assert_eq!((r, raw(b.min()).0), (pushed(3, Axis::X), 2 * UNIT));
    // 15 between them, 5 to go.
    let (r, b) = ride(&level, &crushers(4 * UNIT, UNIT), &body);
    assert_eq!((r, raw(b.max()).0), (pushed(3, Axis::X), 12 * UNIT));
    assert_eq!(ride(&level, &crushers(4 * UNIT, UNIT + 1), &body), (Ride::Squashed { by: 3, normal: Axis::X }, body));
    assert_eq!(ride(&level, &crushers(UNIT, 5 * UNIT), &body), (Ride::Squashed { by: 4, normal: Axis::NEG_X }, body));
    // The faster solid is named, even if there is room. A solid that is away names nobody.
    let (r, b) = ride(&level, &crushers(UNIT, 4 * UNIT), &body);
    assert_eq!((r, raw(b.min()).0), (pushed(4, Axis::NEG_X), -UNIT));
    // Equally fast: the smaller key.
    let even = Ride::Squashed { by: 3, normal: Axis::X };
    assert_eq!(ride(&level, &crushers(3 * UNIT, 3 * UNIT), &body), (even, body));
    // One of them stands.
    assert_eq!(ride(&level, &crushers(6 * UNIT, 0), &body), (even, body));
    assert_eq!(ride(&level, &crushers(0, 6 * UNIT), &body), (Ride::Squashed { by: 4, normal: Axis::NEG_X }, body));
}

#[test]
fn the_fastest_of_several_pushers_is_named() {
    let level = TileMap::from_ascii("   ", &KINDS).unwrap();
    let body = boxed((0, 0), (10, 10));
    let side = |key: u16, speed: i64| moving((-5, -5), (-1, 15), key, (speed, 0));
    let below = |key: u16, speed: i64| moving((-5, 11), (15, 15), key, (0, -speed));
    let named = |a: u16, fast: i64, b: u16, slow: i64| ride(&level, &[side(a, fast), below(b, slow)], &body).0;
    assert_eq!(named(8, 3 * UNIT, 4, 3 * UNIT - 1), pushed(8, Axis::X));
    assert_eq!(named(8, 3 * UNIT - 1, 4, 3 * UNIT), pushed(4, Axis::NEG_Y));
    assert_eq!(named(8, 3 * UNIT, 4, 3 * UNIT), pushed(4, Axis::NEG_Y));
    assert_eq!(named(3, 3 * UNIT, 4, 3 * UNIT), pushed(3, Axis::X));
    // A solid that does not get there is not named, however fast the other is.
    assert_eq!(named(8, 2 * UNIT, 4, UNIT), pushed(8, Axis::X));
    // A solid that passes a body without coming nearer does not push it.
    let by = moving((0, 11), (10, 15), 1, (3 * UNIT, 0));
    assert_eq!(ride(&level, &[side(8, 2 * UNIT), by], &body).0, pushed(8, Axis::X));
    // A circle on a corner that passes by less than a raw unit, against one that stands and has the
    // smaller key.
    let ball = disc((4 * UNIT, -3 * UNIT), 5 * UNIT);
    let (slow, stands) = (moving((-9, 0), (0, 9), 6, (1, 0)), moving((9, -20), (12, 20), 2, (0, 0)));
    assert_eq!(ride(&level, &[slow, stands], &ball).0, pushed(6, Axis::new(4 << 16, -3 << 16)));
}

#[test]
fn no_speed_passes_through_a_body() {
    let level = TileMap::from_ascii("   ", &KINDS).unwrap();
    for k in 1..400 {
        // A wall of one raw unit, at any speed.
        let speed = k * k * 600 + k;
        for (dx, dy) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
            let (a, b) = if dx != 0 { ((0, -9 * UNIT), (1, 9 * UNIT)) } else { ((-9 * UNIT, 0), (9 * UNIT, 1)) };
            let wall = solid(a, b, 1).with_motion(vec2((dx * speed, dy * speed))).unwrap();
            let at = (dx * 5 * UNIT, dy * 5 * UNIT);
            let body = rect((at.0 - UNIT, at.1 - UNIT), (at.0 + UNIT, at.1 + UNIT));
            let ball = disc(at, UNIT);
            let front = if dx + dy > 0 { speed + 1 + UNIT } else { -speed - UNIT };
            let along = |p: P| if dx != 0 { p } else { (p.1, p.0) };
            let (r, b) = ride(&level, &[wall], &body);
            let (s, c) = ride(&level, &[wall], &ball);
            let n = Axis::new(dx as i32, dy as i32);
            let near = if dx + dy > 0 { speed < 4 * UNIT } else { speed <= 4 * UNIT };
            assert_eq!((r, s), if near { (Ride::Free, Ride::Free) } else { (pushed(1, n), pushed(1, n)) }, "{speed}");
            if !near {
                assert_eq!(along((raw(b.min()).0 + UNIT, raw(b.min()).1 + UNIT)), (front, 0));
                assert_eq!(along(raw(c.centre())), (front, 0));
            }
        }
    }
}

#[test]
fn a_push_goes_up_a_slope_and_a_lift_along_a_slanted_ceiling() {
    let level = TileMap::<AllShapes>::of_ascii("L  \n   \n /#\n###", &SHAPES).unwrap();
    // A slope from (16, 48) to (32, 32), pushed by a wall from the left.
    let ball = disc((12 * UNIT, 44 * UNIT), 4 * UNIT);
    let wall = moving((2, 20), (8, 48), 1, (6 * UNIT, 0));
    let (r, b) = ride(&level, &[wall], &ball);
    assert_eq!((r, raw(b.centre()).0), (pushed(1, Axis::X), 18 * UNIT));
    assert!(raw(b.centre()).1 < 42 * UNIT && !level.overlaps(&b));
    let body = boxed((8, 40), (14, 48));
    let (r, b) = ride(&level, &[wall], &body);
    assert_eq!((r, raw(b.max())), (pushed(1, Axis::X), (20 * UNIT, 44 * UNIT)));
    // The slanted ceiling from (0, 16) to (16, 0): the lift raises the box by 5, and it yields to
    // the right.
    let (r, b) = ride(&level, &[moving((0, 26), (30, 30), 1, (0, -5 * UNIT))], &boxed((4, 14), (10, 26)));
    assert_eq!((r, raw(b.min())), (Ride::Carried, (7 * UNIT, 9 * UNIT)));
}

#[test]
fn a_push_rolls_a_ball_up_a_quarter_pipe() {
    let level = TileMap::<AllShapes>::of_ascii("  \n C\n##", &SHAPES).unwrap();
    let mut ball = disc((14 * UNIT, 28 * UNIT), 4 * UNIT);
    let mut wall = [moving((2, 10), (10, 32), 1, (0, 0))];
    for n in 0..12 {
        wall[0] = wall[0].with_motion(vec2((UNIT, 0))).unwrap();
        let (r, b) = ride(&level, &wall, &ball);
        assert_eq!(
            (r, raw(b.centre()).0 >= raw(wall[0].moved().shape().max()).0 + 4 * UNIT),
            (pushed(1, Axis::X), true),
            "{n} {b:?}"
        );
        ball = b;
        Solid::move_all(&mut wall);
    }
    // It is steeper than 2 : 1 now.
    wall[0] = wall[0].with_motion(vec2((UNIT, 0))).unwrap();
    assert_eq!(ride(&level, &wall, &ball).0, Ride::Squashed { by: 1, normal: Axis::X });
}

/// Four bodies and a corner: a box pushes all of them into it, tick by tick.
#[test]
fn four_bodies_in_a_corner_end_where_their_order_does_not_say() {
    let level = room();
    let bodies =
        [boxed((20, 20), (24, 24)), boxed((22, 21), (30, 27)), boxed((30, 30), (31, 31)), boxed((17, 30), (21, 34))];
    let balls = bodies.map(|b| Circle::new(b.centre(), Fx::from_num(2)).unwrap());
    let mut solids = [
        moving((16, 16), (19, 19), 1, (0, 0)),
        moving((16, 12), (17, 48), 2, (0, 0)),
        moving((10, 16), (48, 17), 3, (0, 0)),
    ];
    let (mut bodies, mut balls) = (bodies, balls);
    let mut squashed = 0;
    for _ in 0..400 {
        for s in &mut solids {
            *s = s.with_motion(vec2((UNIT / 13, UNIT / 13))).unwrap();
        }
        for b in &mut bodies {
            let (r, to) = ride(&level, &solids, b);
            *b = to;
            squashed += u32::from(matches!(r, Ride::Squashed { .. }));
            assert!(!level.overlaps(b));
        }
        for b in &mut balls {
            let (r, to) = ride(&level, &solids, b);
            *b = to;
            squashed += u32::from(matches!(r, Ride::Squashed { .. }));
            assert!(!level.overlaps(b));
        }
        Solid::move_all(&mut solids);
    }
    assert!(squashed > 0);
    // Each was pushed to a wall, and was squashed there.
    for b in bodies {
        assert!(b.max().x > 47 || b.max().y > 47, "{b:?}");
    }
}

#[test]
fn a_door_that_closes_on_a_body_and_on_its_edge() {
    let level = room();
    let door = moving((24, 16), (32, 48), 5, (0, 0));
    let (inside, edge) = (boxed((28, 20), (36, 28)), boxed((32, 20), (40, 28)));
    // It was put there: it squashes the body inside as long as it is there, and touches the one at
    // its edge.
    assert_eq!(ride(&level, &[door], &inside), (Ride::Squashed { by: 5, normal: Axis::X }, inside));
    assert_eq!(ride(&level, &[door], &edge), (Ride::Free, edge));
    let solids = [door];
    let here = Solids::new(&solids);
    let joined = Joined::new(&level, &here);
    assert!(matches!(MOVER.move_and_slide(&joined, &inside, vec2((0, 1))), Err(MoveError::Stuck(_))));
    let moved = MOVER.move_and_slide(&joined, &edge, vec2((-5 * UNIT, 0))).unwrap();
    assert_eq!((moved.body, moved.wall), (edge, true));
    // It goes away: who was inside is free again.
    let gone = [door.with_motion(vec2((-4 * UNIT, 0))).unwrap()];
    assert_eq!(ride(&level, &gone, &inside).0, Ride::Free);
    // The door's ends lie in the floor's and the ceiling's plane. The joined level has no edge of
    // them, but those at the door's sides.
    let at = |x: i64, y: i64| rect((x * UNIT, y * UNIT), (x * UNIT, y * UNIT));
    let corners =
        |p: &Aabb| joined.features(p).filter(|f| matches!(f.geometry, tilesat::world::Geometry::Vertex { .. })).count();
    for (x, y) in [(24, 16), (32, 16), (24, 48), (32, 48)] {
        assert_eq!(corners(&at(x, y)), 0);
        assert_eq!(here.features(&at(x, y)).filter(|f| f.index >= 4).count(), 1);
    }
}

#[test]
fn what_overlaps_the_level_is_stuck_only_where_it_is_to_move() {
    let level = room();
    let body = boxed((10, 20), (20, 30));
    let lift = moving((16, 34), (48, 40), 7, (0, -9 * UNIT));
    assert_eq!(ride(&level, &[], &body), (Ride::Free, body));
    assert!(matches!(MOVER.ride(&level, &[lift], &body, Fx::ONE), Err(MoveError::Stuck(_))));
    // Out of the domain.
    let far = boxed((8180, 0), (8190, 10));
    let pusher = moving((8170, 0), (8179, 10), 1, (5 * UNIT, 0));
    assert!(matches!(
        MOVER.ride(&TileMap::from_ascii(" ", &KINDS).unwrap(), &[pusher], &far, Fx::ONE),
        Err(MoveError::Range(_))
    ));
}

#[test]
fn a_corner_pushes_a_circle_aside() {
    let level = TileMap::from_ascii("   ", &KINDS).unwrap();
    // The box's corner at (0, 0) rises beside the circle's lowest point; 3-4-5.
    let ball = disc((4 * UNIT, -3 * UNIT), 5 * UNIT);
    let lift = moving((-9, 0), (0, 9), 1, (0, -UNIT));
    let (r, b) = ride(&level, &[lift], &ball);
    let (x, y) = raw(b.centre());
    assert_eq!(r, pushed(1, Axis::new(4 << 16, -3 << 16)));
    // Along (4, -3) by 3/5: within two raw units, and clear. That is too steep to stand on.
    assert!((x - 4 * UNIT - UNIT * 12 / 25).abs() <= 2 && (y + 3 * UNIT + UNIT * 9 / 25).abs() <= 2, "{x} {y}");
    // With a wall on that side it goes up by all of it.
    let wall = solid((9 * UNIT, -20 * UNIT), (10 * UNIT, 20 * UNIT), 2);
    let (r, b) = ride(&level, &[lift, wall], &ball);
    assert_eq!((r, raw(b.centre()).0), (pushed(1, Axis::new(4 << 16, -3 << 16)), 4 * UNIT));
    assert!((raw(b.centre()).1 + 4 * UNIT).abs() <= 2, "{b:?}");
    // A shallow corner is floor: it carries.
    let ball = disc((3 * UNIT, -4 * UNIT), 5 * UNIT);
    assert_eq!(ride(&level, &[lift], &ball), (Ride::Carried, disc((3 * UNIT, -5 * UNIT), 5 * UNIT)));
}
