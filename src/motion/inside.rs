//! Bodies that start in the solid: a door closed on them, or they were put there.

use super::Stuck;
use super::body::{Body, kernel::Kernel};
use super::run::check_inside;
use crate::num::Raw;
use crate::world::{OneWay, Pushable, World, contacts_of};

/// What a [`Mover`](super::Mover) does with a body that overlaps the level already. To push it out
/// first, see [`escape`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StartInside {
    /// Nothing moves: [`Stuck`].
    #[default]
    Report,
    /// What it overlaps does not stop it, so it can always leave, in any direction; all else does.
    /// Until the first place of a motion where it is free it may end in the solid again, after it
    /// never does. The next call asks anew.
    ///
    /// **No gravity while it is inside.** Where a door of tiles has closed on a body, the floor
    /// below it has no face any more (solid lies on solid), so nothing stops what falls there: it
    /// goes through the floor, and out of the world. Ask `overlaps` of the level before each call,
    /// and while that is true give the body a velocity across "up" alone.
    /// [Doors](crate::motion#doors) tells how it does not come to that.
    ///
    /// ```text
    ///        | door |
    ///        | [B]  |          B leaves to the left or right; and down as well,
    ///   _____|......|_____     for there is no face on the dotted line, nor below it
    /// ```
    Ignore,
}

/// How often [`escape`] pushes at most.
const PUSHES: u32 = 4;

/// The body at the free place that is found by pushing it out of the solid, at most four times; the
/// same body where it is free already.
///
/// Each push is out of the feature that its [contacts](crate::TileMap::contacts) tell first: the
/// nearest, by the depth rounded up to raw units, at most 4 raw more than that. So it never goes
/// farther than the surface that it reaches: deep inside of the solid, where it reaches none, and
/// in gaps narrower than the body, there is no way out. One-way faces do not count.
///
/// **It finds no way out of a door that is wider than the body** once the body is all between its
/// two sides: it reaches neither. Of a body 10 wide in a door of one tile, from x = 32 to 48, the
/// one at x = 31 goes 9 to the left, the one at 39 goes 9 to the right, and those from 32 to 38 are
/// [`Stuck`]. For doors see [there](crate::motion#doors).
///
/// Cost: an exact overlap test, and where that is true the [contacts](crate::TileMap::contacts) of
/// one body, each at most four times, and one test more. It links the contacts; a game that does
/// not call it does not.
///
/// ```
/// use tilesat::motion::escape;
/// use tilesat::{Aabb, TileKind, TileKinds, TileMap, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let map = TileMap::from_ascii("#...\n####", &KINDS)?;
/// let inside = Aabb::new(Vec2::from_ints(14, 9), Vec2::from_ints(24, 19)).unwrap(); // 2 in the wall, 3 in the floor
/// assert_eq!(escape(&map, &inside).unwrap().min(), Vec2::from_ints(16, 6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Stuck`] where no push is left that could free it, or a push would leave the domain.
pub fn escape<W: World, B: Body + Pushable>(world: &W, body: &B) -> Result<B, Stuck> {
    let stuck = Stuck { at: body.position().raw() };
    let mut body = *body;
    for _ in 0..PUSHES {
        if !body.overlaps_world(world) {
            return Ok(body);
        }
        let mut nearest = heapless::Vec::<_, 1>::new();
        // More than the one that is kept are no error here.
        let _ = contacts_of(world, &body, OneWay::Ignore, &mut nearest);
        let push = Raw::of(nearest.first().ok_or(stuck)?.push_out());
        check_inside(&Kernel::bounds(&body), push).map_err(|_| stuck)?;
        body = body.shifted(push);
    }
    if body.overlaps_world(world) { Err(stuck) } else { Ok(body) }
}
