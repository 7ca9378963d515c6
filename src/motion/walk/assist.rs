//! Nudges a body past corners and into gaps that it narrowly misses.

use super::ground::{Ground, Look, along, within};
use super::walker::checked;
use crate::error::Quantity;
use crate::motion::plane::{into, way};
use crate::motion::response::Law;
use crate::motion::run::Run;
use crate::motion::search::{Around, check_cells};
use crate::motion::slope_limit::SurfaceRole;
use crate::motion::{Body, MoveError, Moved, Mover};
use crate::num::{Axis, Fx, Raw, Vec2};
use crate::shape::Aabb;
use crate::world::{Geometry, World, corners_of};

impl<S: Law> Mover<S> {
    /// Moves a body aside by at most `reach`, if its motion would hit something that it misses from
    /// there.
    ///
    /// ```text
    ///     ________            ________        a head under a corner, a foot under a ledge
    ///     |______|            |______|
    ///          ^      ->              ^       ####  ####     ####  ####
    ///         [o]                    [o]      [o]->       ->    [o]      a gap as wide as the body
    /// ```
    ///
    /// Call it before the motion, with the same velocity. It does nothing if the motion hits
    /// neither a face along x or y nor a corner, or hits a floor. The step aside is the shortest
    /// one, exactly, that lets the motion lead farther, and it is free. It never leads against the
    /// velocity, so no call undoes another one. Along x or y there are two sides: the nearer one,
    /// on a tie the one to the left of the motion (y down).
    ///
    /// A round or pointed body could come a little farther beside a corner before it hits it again.
    /// It steps as far aside as the box around it, which passes as a whole, or not at all.
    ///
    /// A box that slides along a wall at a speed of at most `reach` enters every gap, also one
    /// exactly as wide. Then it steps a raw unit into the gap, too. A faster body can pass a gap
    /// within one frame. So can one that was not at the wall yet.
    ///
    /// Cost: one sweep along the motion. If that hits, up to six more for each side, one of them of
    /// `reach`, and two for each face that the body passes.
    ///
    /// ```
    /// use tilesat::{Aabb, Mover, TileKind, TileKinds, TileMap, Vec2, fx};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("# #\n# #\n   \n", &KINDS)?; // a gap from x = 16 to 32
    /// let (mover, up) = (Mover::new(), Vec2::from((0, -4)));
    ///
    /// let body = Aabb::new(Vec2::from((15, 32)), Vec2::from((31, 48)))?; // as wide as the gap, and a unit beside it
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
        check_cells(world, body.extent(), Raw { x: reach, y: reach })?;
        run.pass_one_way = self.passes_one_way();
        let aside = self.aside(world, &mut run, reach).map_or(*body, |d| body.shifted(d));
        Ok(if aside.overlaps_world(world) { *body } else { aside })
    }

    /// The shortest step aside that lets the motion of a run lead farther.
    fn aside<W: World, B: Body>(&self, world: &W, run: &mut Run<'_, B>, reach: i32) -> Option<Raw> {
        let d = run.motion;
        let hit = run.look(world, d)?;
        if self.up.is_some() && self.side(hit.entry.normal) == SurfaceRole::Floor {
            return None;
        }
        let n = face_of(&hit)?;
        let mut best = None;
        let side = along(n.perp(), reach);
        // Never against the velocity: the next call could undo that step, and the body would stay.
        for side in [side, side.reversed()].into_iter().filter(|side| side.dot(d) >= 0) {
            let Some((least, free)) = past(world, run, (&hit, n), side) else { continue };
            // The position at the hit was rounded: a surface that the motion comes nearer to may
            // need one more unit.
            let next = least.add(Raw { x: side.x.signum(), y: side.y.signum() });
            let passes = [least, next].into_iter().filter(|aside| !aside.is_zero() && way(*aside) <= way(free));
            let found = passes.filter(|&aside| best.is_none_or(|(best, _)| way(aside) < way(best)));
            let leads = |aside| farther(world, run, (&hit, n), aside).ok().map(|from| (aside, from));
            best = found.into_iter().find_map(leads).or(best);
        }
        best.map(|(_, from)| from)
    }
}

/// The normal of the face that a motion goes past. It hits that face, or its corner: then it is the
/// side to which the motion is faster. `None` for slopes and arcs.
fn face_of(hit: &Ground) -> Option<Axis> {
    let (normal, d) = (hit.entry.normal, hit.d);
    if hit.entry.step.is_none() && (normal.x == 0 || normal.y == 0) {
        return Some(normal);
    }
    let Geometry::Vertex { .. } = hit.feature.geometry else { return None };
    let along = |n: i32, d: i32| (n ^ d < 0).then_some(d.unsigned_abs()).filter(|_| n != 0);
    let (x, y) = (along(normal.x, d.x), along(normal.y, d.y));
    Some(if x > y { Axis::new(normal.x.signum(), 0) } else { Axis::new(0, normal.y.signum()) })
}

/// The way aside, if the motion comes farther into the face from there or along the side of a gap.
/// Otherwise the hit that stops it. If the body touches the face, both sides of a gap of its width
/// stop it at once. The way then ends a raw unit inside.
fn farther<W: World, B: Body>(
    world: &W,
    run: &mut Run<'_, B>,
    (hit, n): (&Ground, Axis),
    aside: Raw,
) -> Result<Raw, Ground> {
    let Some(next) = run.look_from(world, aside, hit.d) else { return Ok(aside) };
    let to = next.drop();
    let (depth, was) = (into(to, n), into(hit.drop(), n));
    if depth < was {
        return Ok(aside);
    }
    let ahead = Raw { x: n.x.signum().wrapping_neg(), y: n.y.signum().wrapping_neg() };
    let (mouth, from) = if was == 0 { (aside, aside.add(ahead)) } else { (aside.add(to), aside) };
    let may_enter = depth == was && (was == 0 || n.dot(next.entry.normal) == 0);
    if may_enter && run.look_from(world, mouth, ahead).is_none() { Ok(from) } else { Err(next) }
}

/// The shortest way aside past the hit surface, and the way that is free. The search goes from
/// where the motion first comes farther back to the surface's side, a raw unit into its face.
fn past<W: World, B: Body>(
    world: &W,
    run: &mut Run<'_, B>,
    (hit, n): (&Ground, Axis),
    side: Raw,
) -> Option<(Raw, Raw)> {
    let bounds = run.moved.body.bounds();
    let free = match run.look(world, side) {
        Some(ground) => ground.drop(),
        None => within(&bounds, side),
    };
    // The bounds pass as a whole, or nothing does.
    let whole = beyond(&bounds, hit, side);
    if way(whole) > way(free) {
        return None;
    }
    // Past the ends of one obstacle after the other: from the far end of the free way back, the
    // first one would be the last. A round body may come farther before its bounds do.
    let (mut start, mut aside, mut ground) = (free, Raw::ZERO, *hit);
    loop {
        let end = beyond(&bounds, &ground, side);
        // The way to the hit was rounded.
        let more = i32::from(end == aside);
        let end = end.add(Raw { x: side.x.signum().wrapping_mul(more), y: side.y.signum().wrapping_mul(more) });
        if way(end) <= way(aside) || way(end) >= way(free) {
            break;
        }
        aside = end;
        match farther(world, run, (hit, n), aside) {
            Ok(_) => {
                start = aside;
                break;
            }
            Err(next) => ground = next,
        }
    }
    let ahead = hit.drop().sub(Raw { x: n.x.signum(), y: n.y.signum() });
    // One raw unit beyond the current position: a surface that is only touched is no hit.
    let back = start.reversed().sub(Raw { x: side.x.signum(), y: side.y.signum() });
    let edge = run.look_from(world, ahead.add(start), back)?;
    let least = start.add(edge.drop());
    Some((if way(whole) > way(least) { whole } else { least }, free))
}

/// The way to a side, along x or y, from which bounds pass all of what they hit.
fn beyond(bounds: &Aabb, ground: &Ground, side: Raw) -> Raw {
    let ((a, b), drop) = (corners_of(&ground.feature.geometry), ground.drop());
    let (lo, hi) = (bounds.lo().add(drop), bounds.hi().add(drop));
    let along = |side: i32, (a, b): (i32, i32), lo: i32, hi: i32| match side.signum() {
        1 => a.max(b).wrapping_sub(lo).max(0),
        -1 => a.min(b).wrapping_sub(hi).min(0),
        _ => 0,
    };
    Raw { x: along(side.x, (a.x, b.x), lo.x, hi.x), y: along(side.y, (a.y, b.y), lo.y, hi.y) }
}
