//! Nudges past corners and into gaps that a body narrowly misses.

use super::ground::{Ground, Look, along, within};
use super::walker::checked;
use crate::error::Quantity;
use crate::motion::plane::{SurfaceRole, into, way};
use crate::motion::response::Law;
use crate::motion::run::Run;
use crate::motion::search::{Around, check_cells};
use crate::motion::{Body, MoveError, Moved, Mover};
use crate::num::{Fx, Raw, Vec2};
use crate::world::World;

impl<S: Law> Mover<S> {
    /// Moves a body aside by at most `reach`, if it would otherwise hit something that its motion
    /// just misses from there.
    ///
    /// ```text
    ///     ________            ________        a head under a corner, a foot under a ledge
    ///     |______|            |______|
    ///          ^      ->              ^       ####  ####     ####  ####
    ///         [o]                    [o]      [o]->       ->    [o]      a gap as wide as the body
    /// ```
    ///
    /// Call it before the motion, with the same velocity. It does nothing if the motion hits no
    /// face along x or y, or hits a floor. The way aside is the shortest, exactly, from which the
    /// motion comes farther, and it is free. Of two equally short ways it chooses the one that the
    /// velocity leads to, then the one to the right of the motion.
    ///
    /// A body that moves sideways faster than `reach` per call can pass a gap within one frame. A
    /// `reach` as large as the speed finds every gap.
    ///
    /// Cost: one sweep along the motion. If that hits, up to six more, of `reach`.
    ///
    /// ```
    /// use tilesat::{Aabb, Mover, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("# #\n# #\n   \n", &KINDS)?; // a gap from x = 16 to 32
    /// let (mover, up) = (Mover::new(), Vec2::from((0, -4)));
    ///
    /// let body = Aabb::new(Vec2::from((15, 32)), Vec2::from((31, 48)))?; // as wide, and a unit beside it
    /// assert_eq!(mover.move_and_slide(&level, &body, up)?.body, body);
    /// let aside = mover.assist(&level, &body, up, fx!(2))?;
    /// assert_eq!(mover.move_and_slide(&level, &aside, up)?.position(), Vec2::from((16, 28)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`move_and_slide`](Self::move_and_slide), and [`MoveError::Range`] if `reach` is negative
    /// or not below 2^28 raw.
    #[doc(alias = "corner_correction")]
    pub fn assist<W: World, B: Body>(&self, world: &W, body: &B, velocity: Vec2, reach: Fx) -> Result<B, MoveError> {
        let reach = checked(reach, Quantity::Assist)?;
        let mut moved = Moved::freely(*body, velocity, 0);
        let mut around = Around::nothing();
        let mut run = self.start(world, &mut moved, &mut around)?;
        check_cells(world, &body.bounds(), Raw { x: reach, y: reach })?;
        run.pass_one_way = self.passes_one_way();
        let aside = self.aside(world, &mut run, reach).map_or(*body, |d| body.shifted(d));
        Ok(if aside.overlaps_world(world) { *body } else { aside })
    }

    /// The shortest way aside from which the motion of a run comes farther.
    fn aside<W: World, B: Body>(&self, world: &W, run: &mut Run<'_, B>, reach: i32) -> Option<Raw> {
        let d = run.motion;
        let hit = run.look(world, d)?;
        let normal = hit.entry.normal;
        let straight = hit.entry.step.is_none() && (normal.x == 0 || normal.y == 0);
        if !straight || (self.up.is_some() && self.side(normal) == SurfaceRole::Floor) {
            return None;
        }
        let mut best = None;
        let side = along(normal.perp(), reach);
        let first = if side.dot(d) < 0 { [side.reversed(), side] } else { [side, side.reversed()] };
        for side in first {
            let Some((least, free)) = past(world, run, &hit, side) else { continue };
            // The position at the hit was rounded: a surface that the motion comes nearer to may
            // need one more unit.
            let next = least.add(Raw { x: side.x.signum(), y: side.y.signum() });
            let passes = [least, next].into_iter().filter(|aside| !aside.is_zero() && way(*aside) <= way(free));
            let found = passes.filter(|&aside| best.is_none_or(|best| way(aside) < way(best)));
            best = found.into_iter().find(|&aside| farther(world, run, &hit, aside)).or(best);
        }
        best
    }
}

/// Whether the motion comes farther into the face from a position aside. There it may also lead
/// along the side of a gap.
fn farther<W: World, B: Body>(world: &W, run: &mut Run<'_, B>, hit: &Ground, aside: Raw) -> bool {
    let n = hit.entry.normal;
    let Some(next) = run.look_from(world, aside, hit.d) else { return true };
    let to = next.drop();
    let (depth, was) = (into(to, n), into(hit.drop(), n));
    let beside = n.dot(next.entry.normal) == 0 && depth == was;
    let ahead = Raw { x: n.x.signum().wrapping_neg(), y: n.y.signum().wrapping_neg() };
    depth < was || (beside && run.look_from(world, aside.add(to), ahead).is_none())
}

/// The shortest way aside past the hit surface: from the end of the free way back to the surface's
/// side, a raw unit into its face.
fn past<W: World, B: Body>(world: &W, run: &mut Run<'_, B>, hit: &Ground, side: Raw) -> Option<(Raw, Raw)> {
    let free = match run.look(world, side) {
        Some(ground) => ground.drop(),
        None => within(&run.moved.body.bounds(), side),
    };
    let n = hit.entry.normal;
    let ahead = hit.drop().sub(Raw { x: n.x.signum(), y: n.y.signum() });
    // One raw unit beyond the current position: a surface that is only touched is no hit.
    let back = free.reversed().sub(Raw { x: side.x.signum(), y: side.y.signum() });
    let edge = run.look_from(world, ahead.add(free), back)?;
    Some((free.add(edge.drop()), free))
}
