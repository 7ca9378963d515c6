//! What a bouncing body should have under gravity.

use super::Speed;
use crate::num::Vec2;

/// Twice the energy of a body of mass one, in square raw units, exact: `|v|^2 + g.v - 2 g.x`.
///
/// Bodies move by `v += g; x += v`. In free flight that keeps this number to the last bit; the middle term is what the velocity's being half a
/// frame late amounts to. A bounce within a frame does not keep it: it turns a velocity that has the whole frame's gravity already, however much of
/// the frame is left, and the errors add up to many times the energy (in every engine that we know). So remember the energy, and let the
/// reference speed be what the body should have where it is: the next bounce puts it right, up to what the part of a frame after it is worth,
/// which does not add up. So no two bounces are equally high, and one may be higher than the start by about one frame's way at the speed of
/// the bounce. A ball on one flat floor comes out as even without this; it is for valleys, boxes and tables, where the errors would grow.
///
/// ```
/// use tilesat::{Energy, Mover, Response, Surface, Vec2};
/// # use tilesat::{AllShapes, Circle, Fx, TileKind, TileKinds, TileMap, TileShape};
/// # static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL)
/// #     .with(b'/', TileKind::of(TileShape::SlopeBottomRight)).with(b'L', TileKind::of(TileShape::SlopeBottomLeft));
/// # let map: TileMap<'_, AllShapes> = TileMap::of_ascii("######\n#    #\n#    #\n#L  /#\n##L/##\n######\n", &KINDS)?;
/// # let mut ball = Circle::new(Vec2::from_ints(40, 30), Fx::from_num(5))?;
/// const GRAVITY: Vec2 = Vec2::from_raw(0, 16_384);
/// let mut v = Vec2::from_ints(1, 0);
/// let energy = Energy::of(ball.centre(), v, GRAVITY);
/// for frame in 0..10_000 {
///     let speed = energy.speed(ball.centre(), v, GRAVITY).changed(v, v + GRAVITY);
///     let mover = Mover::new().with_response(Response::Bounce).with_surface(Surface::ELASTIC.with_speed(speed));
///     let moved = mover.move_and_slide(&map, &ball, v + GRAVITY)?;
///     (ball, v) = (moved.body, moved.velocity);
/// }
/// let now = Energy::of(ball.centre(), v, GRAVITY);
/// # let highest = Energy::of(Vec2::from_ints(40, 80), Vec2::ZERO, GRAVITY); // at the bottom of the valley
/// # let (all, off) = (energy.raw() - highest.raw(), (now.raw() - energy.raw()).abs());
/// # assert!(off < all / 5, "{off} of {all}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Energy(i64);

impl Energy {
    /// The energy of a body at a place, with a velocity, under a gravity in units per frame and frame; all three inside the
    /// [domain](crate::num::DOMAIN).
    #[must_use]
    pub const fn of(position: Vec2, velocity: Vec2, gravity: Vec2) -> Self {
        Self((velocity.length_squared() as i64).wrapping_add(potential(position, velocity, gravity)))
    }

    /// In square raw units; only differences mean anything.
    #[must_use]
    pub const fn raw(self) -> i64 {
        self.0
    }

    /// The speed that a body of this energy should have at a place, zero where it should not be there at all; the velocity is the one it has.
    #[must_use]
    pub const fn speed(self, position: Vec2, velocity: Vec2, gravity: Vec2) -> Speed {
        let square = self.0.wrapping_sub(potential(position, velocity, gravity));
        Speed::from_square(if square < 0 { 0 } else { square as u64 })
    }
}

/// `g.v - 2 g.x`: below 2^60 in size.
const fn potential(position: Vec2, velocity: Vec2, gravity: Vec2) -> i64 {
    gravity.dot(velocity).wrapping_sub(gravity.dot(position).wrapping_mul(2))
}
