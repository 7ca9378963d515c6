//! A motion that reports its path.

use super::response::Law;
use super::{Body, MoveError, Moved, Mover};
use crate::num::Vec2;
use crate::world::{Traced, Trail, World};

impl<S: Law> Mover<S> {
    /// Like [`move_and_slide`](Self::move_and_slide), and also writes the path of the body.
    ///
    /// Use it to list everything that a body passes. The level decides what the body passes
    /// ([`TileKinds::passing`](crate::TileKinds::passing), a shorter list of solids), and
    /// [`TileMap::tiles_on`](crate::TileMap::tiles_on) and [`Solids::on`](crate::Solids::on) list
    /// those tiles and solids.
    ///
    /// Cost: that of `move_and_slide`. A program that calls both links the mover twice.
    ///
    /// ```
    /// use tilesat::world::Trail;
    /// use tilesat::{Aabb, AllShapes, Cell, Mover, TileKind, TileKinds, TileMap, Vec2};
    /// const CURTAIN: u8 = 1;
    /// static KINDS: TileKinds =
    ///     TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'c', TileKind::FULL.with_flags(CURTAIN));
    /// static GHOSTS: TileKinds = KINDS.passing(CURTAIN);
    /// let level = TileMap::from_ascii("..c#\n..c#\ncccc", &KINDS)?;
    /// let of_ghosts = level.with_kinds::<AllShapes>(&GHOSTS)?;
    ///
    /// let ghost = Aabb::new(Vec2::from_ints(20, 4), Vec2::from_ints(28, 12))?;
    /// let mut trail = Trail::default();
    /// let moved = Mover::new().move_along(&of_ghosts, &ghost, Vec2::from_ints(30, 30), &mut trail)?;
    /// assert_eq!(moved.position(), Vec2::from_ints(40, 34)); // at the wall, and down along it
    /// let passed = of_ghosts.tiles_on(&ghost, &trail)?.filter(|tile| tile.kind.flag(CURTAIN));
    /// let cells: Vec<_> = passed.map(|tile| tile.cell).collect();
    /// assert_eq!(cells, [Cell::new(2, 0), Cell::new(2, 1), Cell::new(2, 2), Cell::new(3, 2)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of `move_and_slide`. The trail is then empty.
    #[doc(alias = "cross")]
    pub fn move_along<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        velocity: Vec2,
        trail: &mut Trail,
    ) -> Result<Moved<B>, MoveError> {
        let traced = Traced::new(world);
        let moved = self.move_and_slide(&traced, body, velocity);
        *trail = if moved.is_ok() { traced.trail() } else { Trail::default() };
        moved
    }
}
