//! Rides, each in one scene with a known answer. Changes of the sources that no other test noticed
//! led to them.

use tilesat::world::ConvexSolid;
use tilesat::{Axis, Fx, Mover, TileKinds, TileMap, Vec2, motion::Ride};
use tilesat_judge::solids::{disc, rect, solid};

static KINDS: TileKinds = TileKinds::EMPTY;
const UNIT: i64 = 1 << 16;

/// A ball whose middle is beyond an end of a platform stands on the corner there, at the left end
/// as at the right one.
#[test]
fn a_ball_on_a_corner_of_a_platform_is_carried() {
    let level = TileMap::from_ascii("   \n   \n   ", &KINDS).unwrap();
    let platform = solid((0, 0), (40 * UNIT, 5 * UNIT), 1).with_motion(Vec2::from_ints(3, 0)).unwrap();
    for x in [-6, 46] {
        let ball = disc((x * UNIT, -8 * UNIT), 10 * UNIT);
        let ridden = Mover::platformer(Axis::NEG_Y).ride(&level, &[platform], &ball, Fx::ONE).unwrap();
        assert_eq!((ridden.ride, ridden.motion), (Ride::Carried, Vec2::from_ints(3, 0)), "{x}");
        assert_eq!(ridden.body, disc(((x + 3) * UNIT, -8 * UNIT), 10 * UNIT));
    }
}

/// A body that stays in a convex solid is squashed out of it, away from the solid's middle, along
/// the axis on which it is farther from that.
#[test]
fn a_body_in_a_convex_solid_is_squashed_away_from_its_middle() {
    let level = TileMap::from_ascii("   \n   \n   ", &KINDS).unwrap();
    let block = rect((0, 0), (40 * UNIT, 40 * UNIT));
    let block = ConvexSolid::new(block, 1).unwrap().with_motion(Vec2::from_ints(1, 0)).unwrap();
    for (x, y, normal) in
        [(3, -9, Axis::NEG_Y), (-3, 9, Axis::Y), (9, -3, Axis::X), (-9, 3, Axis::NEG_X), (5, 5, Axis::X)]
    {
        let ball = disc(((20 + x) * UNIT, (20 + y) * UNIT), UNIT);
        let ridden = Mover::platformer(Axis::NEG_Y).ride_convex(&level, &[block], &ball, Fx::ONE).unwrap();
        assert_eq!(ridden.ride, Ride::Squashed { by: 1, normal }, "{x} {y}");
    }
}
