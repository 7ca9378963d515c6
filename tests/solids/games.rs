//! The advice of `ride`'s docs to a game: the follow of a standing walker, and what comes after a
//! body is squashed.

use tilesat::motion::escape;
use tilesat::{
    Aabb, Axis, Fx, Joined, MoveError, Mover, Solid, Solids, TileKind, TileKinds, TileMap, Vec2, Walker, motion::Ride,
};
use tilesat_judge::solids::{P, raw, rect, solid};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const UNIT: i64 = 1 << 16;
const MOVER: Mover = Mover::platformer(Axis::NEG_Y);

fn boxed(a: P, b: P) -> Aabb {
    rect((a.0 * UNIT, a.1 * UNIT), (b.0 * UNIT, b.1 * UNIT))
}

/// How often a lift carries a walker with a snap of 3 in 10 ticks by (2, 2), and its final position
/// on the lift.
fn on_a_lift(follow: i16) -> (u32, i64, bool) {
    let level = TileMap::from_ascii("  ", &KINDS).unwrap();
    let walker = Walker::new(MOVER).with_snap(Fx::from_num(3)).unwrap();
    let mut lift = [solid((0, 0), (12 * UNIT, 4 * UNIT), 5)];
    let mut body = boxed((8, -6), (12, 0));
    let here = Solids::new(&lift);
    let mut floor = walker.walk(&Joined::new(&level, &here), &body, Vec2::from_ints(0, 1), None).unwrap().floor;
    let mut carried = 0;
    for _ in 0..10 {
        lift[0] = lift[0].with_motion(Vec2::from_ints(2, 2)).unwrap();
        let ridden = MOVER.ride(&level, &lift, &body, Fx::from_num(follow)).unwrap();
        carried += u32::from(ridden.ride == Ride::Carried);
        Solid::move_all(&mut lift);
        let here = Solids::new(&lift);
        let walked = walker.walk(&Joined::new(&level, &here), &ridden.body, Vec2::ZERO, floor).unwrap();
        (body, floor) = (walked.moved.body, walked.floor);
    }
    (carried, raw(body.min()).0 - raw(lift[0].shape().min()).0, floor.is_some())
}

#[test]
fn a_walker_s_follow_is_its_snap() {
    assert_eq!(on_a_lift(3), (10, 8 * UNIT, true));
    // It stays where it is, and the lift leaves.
    let (carried, offset, stands) = on_a_lift(1);
    assert!(carried == 0 && offset == -12 * UNIT && !stands, "{carried} {offset} {stands}");
}

#[test]
fn a_squashed_body_is_stuck_until_the_crusher_has_passed() {
    let level = TileMap::from_ascii("    \n    \n####", &KINDS).unwrap(); // the floor is at 32
    let body = boxed((20, 22), (30, 32));
    let mut crusher = [solid((16 * UNIT, 4 * UNIT), (34 * UNIT, 20 * UNIT), 9)];
    let squashed = Ride::Squashed { by: 9, normal: Axis::Y };
    for (dy, ride, stuck) in [(1, Ride::Free, false), (4, squashed, true), (0, squashed, true), (-5, Ride::Free, false)]
    {
        crusher[0] = crusher[0].with_motion(Vec2::from_ints(0, dy)).unwrap();
        let ridden = MOVER.ride(&level, &crusher, &body, Fx::ONE).unwrap();
        assert_eq!((ridden.ride, ridden.body), (ride, body), "{dy}");
        Solid::move_all(&mut crusher);
        let here = Solids::new(&crusher);
        let joined = Joined::new(&level, &here);
        let moved = MOVER.move_and_slide(&joined, &body, Vec2::from_ints(3, 0));
        assert_eq!(matches!(moved, Err(MoveError::Stuck(_))), stuck, "{dy}");
    }
}

#[test]
fn half_a_unit_under_the_edge_is_squashed_and_escapes() {
    let level = TileMap::from_ascii("    \n    \n####", &KINDS).unwrap();
    let half = UNIT / 2;
    let crusher =
        |right: i64| [solid((4 * UNIT, 4 * UNIT), (right, 20 * UNIT), 9).with_motion(Vec2::from_ints(0, 4)).unwrap()];
    let body = boxed((20, 22), (30, 32));
    let mut edge = crusher(20 * UNIT + half);
    assert_eq!(MOVER.ride(&level, &edge, &body, Fx::ONE).unwrap().ride, Ride::Squashed { by: 9, normal: Axis::Y });
    assert_eq!(MOVER.ride(&level, &crusher(20 * UNIT), &body, Fx::ONE).unwrap().ride, Ride::Free);
    Solid::move_all(&mut edge);
    let here = Solids::new(&edge);
    assert_eq!(raw(escape(&Joined::new(&level, &here), &body).unwrap().min()), (20 * UNIT + half, 22 * UNIT));
    // A body under the middle has nowhere to go.
    let mut middle = crusher(34 * UNIT);
    Solid::move_all(&mut middle);
    let here = Solids::new(&middle);
    assert!(escape(&Joined::new(&level, &here), &body).is_err());
}
