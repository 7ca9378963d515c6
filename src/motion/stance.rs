//! What a character stands on, and the wall that it is at.

use super::{Character, Support};
use crate::num::Axis;

impl<B> Character<B> {
    /// The floor that it stands on. A round body that goes over an edge may already have the floor
    /// ahead. That floor is lower by up to the [snap](crate::Feel::snap), or higher by up to the
    /// [step](crate::Feel::step).
    #[must_use]
    pub const fn floor(&self) -> Option<Support> {
        self.floor
    }

    /// Whether it stands on a floor.
    #[doc(alias = "is_on_floor")]
    #[doc(alias = "grounded")]
    #[must_use]
    pub const fn on_floor(&self) -> bool {
        self.floor.is_some()
    }

    /// The key of the solid that it stands on. Also `None` if the character stands on a solid and
    /// on other floor at the same height. The solid may still carry it.
    #[must_use]
    pub const fn ridden(&self) -> Option<u16> {
        match self.floor {
            Some(floor) => floor.solid(),
            None => None,
        }
    }

    /// The normal of the wall that it ran against in the last [`coyote`](crate::Feel::coyote)
    /// frames, if it has not jumped off it since. It is [`Axis::NEG_X`] if the wall is on its
    /// right, and [`Axis::X`] if it is on its left.
    ///
    /// A [wall jump](crate::Feel::wall_jump) off it leads along this direction, and is possible
    /// while this is `Some` and the character is in the air. For a steep slope it is the nearer of
    /// the two axes; the exact normal is among the hits of that frame. It slides down the wall now
    /// if [`Step::wall`](crate::Step::wall) is true as well, and it falls.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Character, Feel, Input, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..#\n..#\n..#\n..#\n", &KINDS)?; // a wall from x = 32
    /// let body = Aabb::new(Vec2::from_ints(20, 4), Vec2::from_ints(30, 18))?;
    /// let mut hero = Character::new(body, level.bounds(), Feel { wall_slide: Some(fx!(1)), ..Feel::DEFAULT });
    /// assert_eq!(hero.wall(), None);
    /// for _ in 0..8 {
    ///     let _ = hero.step(&level, Input::running(fx!(1)))?;
    /// }
    /// assert_eq!(hero.wall(), Some(Axis::NEG_X)); // draw it sliding, with its hands to the right
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("get_wall_normal", "wall slide", "is_on_wall"))]
    #[must_use]
    pub const fn wall(&self) -> Option<Axis> {
        // The next step counts one frame more, and lets it jump up to one more than these.
        if self.memory.wall_age > self.feel.grace() {
            return None;
        }
        match self.memory.wall {
            0 => None,
            1.. => Some(Axis::NEG_X),
            _ => Some(Axis::X),
        }
    }
}
