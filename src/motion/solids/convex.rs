//! Convex solids carry and push bodies.
//!
//! As with boxes all pushes of a tick are combined, but as half-planes: a solid that the body runs
//! into, seen from the solid, sets the tangent there as a bound, and so does the level. The
//! displacement is the one within all bounds that is nearest to the carry. It is tried as a
//! straight way, which finds further bounds, until nothing is hit.

use super::push::Press;
use super::room::{HalfPlane, Room};
use super::{Carrier, Ridden, Ride};
use crate::error::{Quantity, RangeError};
use crate::motion::body::Body;
use crate::motion::contact::{Bend, touched};
use crate::motion::plane::{NEAR, SurfaceRole, way};
use crate::motion::response::Law;
use crate::motion::run::{Run, check_inside};
use crate::motion::search::{Around, check_cells};
use crate::motion::{MoveError, Moved, Mover, Stuck, Work};
use crate::num::{Axis, Fx, MOTION, Raw, Vec2, div_sqrt, less128, sqr64, toward};
use crate::query::cast::moment::{along, is_below, reach};
use crate::query::{Core, meet};
use crate::shape::Aabb;
use crate::world::{ConvexSolid, ConvexSolids, Feature, Geometry, SolidShape, World, ends, normal};
use core::slice;

impl<L: Law> Mover<L> {
    /// The most displacements of a body that one [`ride_convex`](Self::ride_convex) tries.
    pub const CONVEX_ROUNDS: u32 = 16;

    /// [`ride`](Self::ride) for solids of any convex shape: sloped lifts, bumpers, platforms that
    /// turn.
    ///
    /// The solids are still at their old positions, and all go to their next ones at once. Call
    /// this for each body, then [`ConvexSolid::move_all`], then move the bodies in the level
    /// [joined](crate::Joined) with the [`ConvexSolids`].
    ///
    /// ```text
    ///              carried: it stands on    pushed: out along the       turned: the part of the
    ///        [B]   a slope that is floor    normal of what hits it      border that it touches
    ///       _.-'|                             .--.  _                   takes it along
    ///    .-'    |-> lift                     ( -->)(B)->       [B]__..--
    ///    '------'                             `--'             --''
    /// ```
    ///
    /// What differs from boxes:
    ///
    /// - **Carried** bodies go by exactly the motion of the solid. A solid that
    ///   [turns](ConvexSolid::with_turn) takes a body along by the motion of the point that the
    ///   body touches; the body itself does not turn.
    /// - **Pushed** bodies go the shortest way out that the level and all solids leave: along the
    ///   normal of the face, corner or arc that hits them, and along walls and slopes from there.
    /// - **Squashed** is a body without such a way, or one that is longer than eight times the
    ///   longest motion of a solid: between a wedge and a wall that nearly meet.
    /// - **A turn** keeps each body in front of the face or corner that was between them before,
    ///   by any angle. So none passes. The way between both positions is not looked at.
    ///
    /// A turn that must not squash is refused by the game: ask all bodies first, and turn the solid
    /// only if none is squashed. See the example.
    ///
    /// A polygon body that touches a turning solid with a slanted side of its own, and no face of
    /// the solid, may be squashed where it could be pushed.
    ///
    /// Cost: a few comparisons for each far solid. Otherwise at most [`Mover::CONVEX_ROUNDS`]
    /// displacements, each one sweep through the level and one for each near solid.
    ///
    /// ```
    /// use tilesat::motion::Ride;
    /// use tilesat::world::ConvexSolid;
    /// use tilesat::{Aabb, Axis, Fx, Mover, OrientedBox, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("######\n......\n......\n", &KINDS)?; // a ceiling, down to y = 16
    /// let mover = Mover::platformer(Axis::NEG_Y);
    /// let plank = |rise| OrientedBox::new(Vec2::from_ints(48, 40), Vec2::from_ints(30, 2), Axis::new(60, rise));
    /// let mut solids = [ConvexSolid::new(plank(0)?, 1)?];
    /// let mut hero = Aabb::new(Vec2::from_ints(64, 26), Vec2::from_ints(72, 38))?; // 10 below the ceiling
    ///
    /// for rise in [-6, -12, -30, -60, -120] { // the right end goes up
    ///     let turned = [solids[0].with_turn(plank(rise)?)?];
    ///     let ridden = mover.ride_convex(&level, &turned, &hero, Fx::ONE)?;
    ///     if matches!(ridden.ride, Ride::Squashed { .. }) {
    ///         assert_eq!(rise, -30);
    ///         break; // the turn is refused
    ///     }
    ///     (hero, solids) = (ridden.body, turned.map(ConvexSolid::moved));
    /// }
    /// assert!(hero.min().y < 22 && !solids[0].shape().aabb().min().y < 20);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`ride`](Self::ride).
    #[doc(alias("platform velocity", "moving platform", "AnimatableBody2D"))]
    pub fn ride_convex<W: World, S: SolidShape, B: Body>(
        &self,
        level: &W,
        solids: &[ConvexSolid<S>],
        body: &B,
        follow: Fx,
    ) -> Result<Ridden<B>, MoveError> {
        let value = follow.to_bits();
        if !(0..MOTION).contains(&value) {
            return Err(RangeError { what: Quantity::Follow, value }.into());
        }
        body.check_size()?;
        let carrier = self.convex_carrier(solids, body, value);
        let carry = carrier.map_or(Raw::ZERO, |c| c.carry);
        let mut ridden = Ridden {
            body: *body,
            ride: if carrier.is_some() { Ride::Carried } else { Ride::Free },
            motion: Vec2::ZERO,
            floor: carrier.map(|c| c.key),
            carry: carry.vec2(),
            work: Work::default(),
        };
        let mut room = Room::new(carry, solids.iter().map(Turn::longest).max().unwrap_or(0));
        let (mut press, mut d): (Option<Press>, Raw) = (None, carry);
        for round in 0..Self::CONVEX_ROUNDS {
            let mut clear = true;
            if let Some((feature, plane)) = self.hit_in(level, body, d, round == 0, &mut ridden.work)? {
                clear = false;
                room.add(None, &feature, plane);
            } else {
                for (i, solid) in solids.iter().enumerate() {
                    let Some(push) = Tick { solid, body }.ask(d) else { continue };
                    clear = false;
                    if press.is_none_or(|p| push.press.goes_before(&p)) {
                        press = Some(push.press);
                    }
                    match push.bound {
                        Some((feature, plane)) => room.add(Some(i as u16), &feature, plane),
                        // Nothing moves a body that is already inside.
                        None => room.close(),
                    }
                }
            }
            if clear {
                let to = body.shifted(d);
                // Rounding may have met what no sweep did.
                if !d.is_zero() && to.overlaps_world(level) {
                    break;
                }
                if let Some(press) = press.filter(|p| p.comes) {
                    ridden.ride = Ride::Pushed { by: press.key, normal: press.normal };
                }
                (ridden.body, ridden.motion) = (to, d.vec2());
                return Ok(ridden);
            }
            let Some(next) = room.nearest() else { break };
            d = next;
        }
        if let Some(press) = press {
            ridden.ride = Ride::Squashed { by: press.key, normal: press.normal };
        }
        Ok(ridden)
    }

    /// The first hit of a displacement in the level, and its tangent.
    #[inline(never)]
    fn hit_in<W: World, B: Body>(
        &self,
        level: &W,
        body: &B,
        d: Raw,
        is_first: bool,
        work: &mut Work,
    ) -> Result<Option<(Feature, HalfPlane)>, MoveError> {
        if d.is_zero() {
            return Ok(None);
        }
        check_cells(level, &body.bounds(), d)?;
        check_inside(&body.bounds(), d)?;
        let mut moved = Moved::freely(*body, d.vec2(), 0);
        let mut around = Around::nothing();
        let mut run = Run::new(&mut moved, &mut around);
        run.pass_one_way = self.passes_one_way();
        run.moved.work = *work;
        let stuck = is_first && run.is_stuck(level);
        run.moved.work.iterations += 1;
        let hit = run.first_hit(level, d);
        *work = run.moved.work;
        if stuck {
            return Err(MoveError::Stuck(Stuck { at: body.position().raw() }));
        }
        Ok(hit.map(|(entry, feature)| (feature, HalfPlane { normal: entry.normal, at: entry.displacement(d) })))
    }

    /// The solid that carries a body: of several the one that rises most, then by the key.
    fn convex_carrier<S: SolidShape, B: Body>(
        &self,
        solids: &[ConvexSolid<S>],
        body: &B,
        follow: i32,
    ) -> Option<Carrier> {
        let up = self.up?;
        let (bounds, near) = (body.bounds(), Raw { x: NEAR as i32, y: NEAR as i32 });
        let (lo, hi) = (bounds.lo().sub(near), bounds.hi().add(near));
        let mut best: Option<Carrier> = None;
        for solid in solids {
            let extent = solid.shape().extent();
            if !meet::aabb_aabb::<true>(lo, hi, extent.lo(), extent.hi()) {
                continue;
            }
            for feature in (0..solid.pieces()).filter_map(|index| solid.piece(index)) {
                let Some(n) = foot(body, &feature) else { continue };
                let carry = Turn::of(solid).of_contact(body, &feature, n);
                let sinks = along(n, carry).min(0).unsigned_abs();
                if self.side(n) != SurfaceRole::Floor || less128(reach(follow, n), sqr64(sinks)) {
                    continue;
                }
                let carrier = Carrier { key: solid.key(), carry, rise: up.dot(Axis::new(carry.x, carry.y)) };
                if best.is_none_or(|b| carrier.goes_before(&b)) {
                    best = Some(carrier);
                }
            }
        }
        best
    }
}

/// The normal at which a body touches a piece of a solid with more than the end of a side.
///
/// A face along x or y is touched exactly, others within the rounding of a motion that ends there.
fn foot<B: Body>(body: &B, feature: &Feature) -> Option<Axis> {
    match feature.geometry {
        Geometry::Face { a, dir, len, .. } => {
            let ((a, b), n) = (ends(Raw::of(a), dir, len), normal(dir));
            let (first, last, r) = lowest(body, n);
            let gap = along(n, first.sub(a));
            let is_flat = n.x == 0 || n.y == 0;
            let far = reach(if is_flat { r } else { r.wrapping_add(NEAR as i32) }, n);
            let touches = gap >= 0 && !less128(far, sqr64(gap as u64)) && !(is_flat && is_below(gap as u64, far));
            // A sharp end on an end is no foot.
            let least = i64::from(is_flat && r == 0);
            let over = along(dir, last.sub(a)) >= least && along(dir, first.sub(b)) <= -least;
            (touches && over).then_some(n)
        }
        // A side of a box on a peak, or on the top of an arc.
        Geometry::Vertex { p, .. } if !B::MEETS_CORNERS => on_peak(body, Raw::of(p)),
        Geometry::Arc { centre, radius, quadrant, .. } if !B::MEETS_CORNERS => {
            let end = |x: i32, y: i32| Raw { x: x.wrapping_mul(radius), y: y.wrapping_mul(radius) };
            let at = |way: Raw| on_peak(body, Raw::of(centre).add(way));
            at(end(quadrant.x, 0)).or_else(|| at(end(0, quadrant.y))).or_else(|| at_corner(body, feature))
        }
        _ => at_corner(body, feature),
    }
}

fn at_corner<B: Body>(body: &B, feature: &Feature) -> Option<Axis> {
    let mut found = None;
    touched(body, feature, |plane| {
        if plane.bend != Bend::End {
            found = Some(plane.normal);
        }
    });
    found
}

/// The normal at which a side of a box lies on a point.
fn on_peak<B: Body>(body: &B, p: Raw) -> Option<Axis> {
    let (lo, hi) = (body.bounds().lo(), body.bounds().hi());
    if lo.x < p.x && p.x < hi.x {
        let (above, below) = (p.y == hi.y, p.y == lo.y);
        (above || below).then_some(Axis::new(0, if above { -1 } else { 1 }))
    } else if lo.y < p.y && p.y < hi.y {
        let (left, right) = (p.x == hi.x, p.x == lo.x);
        (left || right).then_some(Axis::new(if left { -1 } else { 1 }, 0))
    } else {
        None
    }
}

/// The points of a body that are lowest over a face with the normal `n`, in the direction of the
/// face, and the radius around them.
fn lowest<B: Body>(body: &B, n: Axis) -> (Raw, Raw, i32) {
    if n.x != 0 && n.y != 0 {
        let (p, r) = body.toward(n.reversed());
        return (p, p, r);
    }
    // A side of a box, or of a capsule: both ends.
    let (x, y) = (n.x.signum(), n.y.signum());
    let ((first, r), (last, _)) = (
        body.toward(Axis::new(y.wrapping_sub(x), x.wrapping_neg().wrapping_sub(y))),
        body.toward(Axis::new(y.wrapping_neg().wrapping_sub(x), x.wrapping_sub(y))),
    );
    (first, last, r)
}

/// How a solid's corners go to those of its next shape.
struct Turn<'a, S> {
    solid: &'a ConvexSolid<S>,
    /// The corner of the next shape that the first one goes to.
    shift: usize,
}

impl<'a, S: SolidShape> Turn<'a, S> {
    /// By the least turn: the sides agree best.
    fn of(solid: &'a ConvexSolid<S>) -> Self {
        if solid.motion().is_some() {
            return Self { solid, shift: 0 };
        }
        let (here, there) = (solid.shape(), solid.next());
        let (p, q) = (here.outline(), there.outline());
        let (p, q) = (Core { corners: &p, radius: 0 }, Core { corners: &q, radius: 0 });
        let side = |core: &Core<'_>, i: usize| core.corner(core.after(i)).sub(core.corner(i));
        let agreement = |shift: usize| {
            let all = (0..p.corners.len()).map(|i| side(&p, i).dot(side(&q, wrapped(i.wrapping_add(shift), &q))) >> 6);
            all.fold(0i64, i64::saturating_add)
        };
        let shift = (0..q.corners.len()).max_by_key(|&shift| agreement(shift));
        Self { solid, shift: shift.unwrap_or(0) }
    }

    /// The longest displacement of a corner, along x or y.
    fn longest(solid: &ConvexSolid<S>) -> u32 {
        let turn = Turn::of(solid);
        (0..solid.shape().outline().len()).map(|i| way(turn.of_corner(i))).max().unwrap_or(0)
    }

    fn of_corner(&self, corner: usize) -> Raw {
        if let Some(motion) = self.solid.motion() {
            return Raw::of(motion);
        }
        let (here, there) = (self.solid.shape(), self.solid.next());
        let (p, q) = (here.outline(), there.outline());
        let (p, q) = (Core { corners: &p, radius: 0 }, Core { corners: &q, radius: 0 });
        q.corner(wrapped(corner.wrapping_add(self.shift), &q)).sub(p.corner(corner))
    }

    /// The motion of the point that a body touches: of a face between those of its ends.
    fn of_contact<B: Body>(&self, body: &B, feature: &Feature, n: Axis) -> Raw {
        let corner = usize::from(feature.index / 5);
        let from = self.of_corner(corner);
        let Geometry::Face { a, dir, len, .. } = feature.geometry else { return from };
        if self.solid.motion().is_some() {
            return from;
        }
        let (a, b) = ends(Raw::of(a), dir, len);
        let corners = self.solid.shape().outline().len();
        let next = corner.wrapping_add(1);
        let change = self.of_corner(if next < corners { next } else { 0 }).sub(from);
        let (first, last, _) = lowest(body, n);
        let part = |p: Raw| {
            let (far, whole) = (b.sub(a).dot(p.sub(a)), b.sub(a).len2());
            Raw { x: part_of(change.x, far, whole), y: part_of(change.y, far, whole) }
        };
        let sum = part(first).add(part(last));
        from.add(Raw { x: sum.x / 2, y: sum.y / 2 })
    }
}

/// `v far / whole`, with `far` between 0 and `whole`, rounded toward zero.
fn part_of(v: i32, far: i64, whole: u64) -> i32 {
    let size = crate::num::mul_div_wide((far.max(0) as u64).min(whole), v.unsigned_abs(), whole) as i32;
    if v < 0 { size.wrapping_neg() } else { size }
}

fn wrapped(index: usize, core: &Core<'_>) -> usize {
    let count = core.corners.len();
    if index < count { index } else { index.wrapping_sub(count) }
}

/// How a solid answers a displacement of a body.
struct Push {
    press: Press,
    /// The bound that it sets; none if the body is in the solid from the start to the end.
    bound: Option<(Feature, HalfPlane)>,
}

struct Tick<'a, S, B> {
    solid: &'a ConvexSolid<S>,
    body: &'a B,
}

impl<S: SolidShape, B: Body> Tick<'_, S, B> {
    /// `None` if the body gets clear of the solid by `d`.
    fn ask(&self, d: Raw) -> Option<Push> {
        let (solid, body) = (self.solid, self.body);
        let (from, to) = (solid.shape().extent(), solid.next().extent());
        let (whole, bounds) = (from.union(&to), body.bounds());
        let way = bounds.union(&Aabb::from_raw_unchecked(bounds.lo().add(d), bounds.hi().add(d)));
        if !meet::aabb_aabb::<false>(whole.lo(), whole.hi(), way.lo(), way.hi()) {
            return None;
        }
        let moved = solid.moved();
        let overlaps =
            |solid: &ConvexSolid<S>, body: &B| body.overlaps_world(&ConvexSolids::new(slice::from_ref(solid)));
        let ends_inside = || overlaps(&moved, &body.shifted(d));
        if overlaps(solid, body) {
            return ends_inside().then(|| self.inside());
        }
        match solid.motion() {
            Some(motion) => {
                let motion = Raw::of(motion);
                match self.first_hit(d.sub(motion)) {
                    Some((feature, plane)) => {
                        let at = plane.at.add(motion);
                        let press = Press::of::<true>(solid.key(), motion, plane.normal);
                        Some(Push { press, bound: Some((feature, HalfPlane { at, ..plane })) })
                    }
                    None => ends_inside().then(|| self.inside()),
                }
            }
            None => self.turned(d).or_else(|| ends_inside().then(|| self.inside())),
        }
    }

    /// The first piece that the body hits on its way past the solid, and the tangent there.
    fn first_hit(&self, d: Raw) -> Option<(Feature, HalfPlane)> {
        if d.is_zero() {
            return None;
        }
        let mut moved = Moved::freely(*self.body, d.vec2(), 0);
        let mut around = Around::nothing();
        let mut run = Run::new(&mut moved, &mut around);
        let (entry, feature) = run.first_hit(&ConvexSolids::new(slice::from_ref(self.solid)), d)?;
        Some((feature, HalfPlane { normal: entry.normal, at: entry.displacement(d) }))
    }

    /// Of a body in the solid: the way from the middle of its bounds to that of the body's.
    fn inside(&self) -> Push {
        let (a, b) = (self.solid.shape().extent(), self.body.bounds());
        let twice = |a: &Aabb| (i64::from(a.lo().x) + i64::from(a.hi().x), i64::from(a.lo().y) + i64::from(a.hi().y));
        let ((ax, ay), (bx, by)) = (twice(&a), twice(&b));
        let (x, y) = (bx - ax, by - ay);
        let normal = if y.unsigned_abs() > x.unsigned_abs() {
            Axis::new(0, y.signum() as i32)
        } else {
            Axis::new(if x < 0 { -1 } else { 1 }, 0)
        };
        let motion = self.solid.motion().map_or(Raw::ZERO, Raw::of);
        Push { press: Press::of::<true>(self.solid.key(), motion, normal), bound: None }
    }

    /// A turn: the body stays in front of what is between it and the solid before.
    ///
    /// That is a face of the solid, or a corner with a normal of the body's own: along x or y, or
    /// from the corner to a round part of the body. Of several the one that leaves most room
    /// counts, and none if another one still is between them at the end.
    fn turned(&self, d: Raw) -> Option<Push> {
        let (turn, shape, next) = (Turn::of(self.solid), self.solid.shape(), self.solid.next());
        let (p, q) = (shape.outline(), next.outline());
        let (p, q) = (Core { corners: &p, radius: 0 }, Core { corners: &q, radius: 0 });
        let mut best: Option<((u32, u32, u32), Push)> = None;
        let mut clear = false;
        let mut consider = |corner: usize, n: Axis, next_n: Axis, index: u16| {
            let here = p.corner(corner);
            let (foot, r) = self.body.toward(n.reversed());
            let gap = along(n, foot.sub(here));
            if gap < 0 || is_below(gap as u64, reach(r, n)) {
                return;
            }
            let there = q.corner(wrapped(corner.wrapping_add(turn.shift), &q));
            let (next_foot, _) = self.body.toward(next_n.reversed());
            // In front of the next plane by the radius.
            let to = there.sub(next_foot);
            let gap_then = along(next_n, d.sub(to));
            clear |= gap_then >= 0 && !is_below(gap_then as u64, reach(r, next_n));
            let room = div_sqrt(gap as u64, n.length_squared()).saturating_sub(r.unsigned_abs());
            let rank = (room, n.x.unsigned_abs(), n.y.unsigned_abs());
            if best.as_ref().is_some_and(|(kept, _)| *kept >= rank) {
                return;
            }
            let out = if r == 0 {
                Raw::ZERO
            } else {
                let out = toward(Raw { x: next_n.x, y: next_n.y }, r);
                out.add(Raw { x: out.x.signum(), y: out.y.signum() })
            };
            let Some(feature) = self.solid.piece((corner as u16).wrapping_mul(5).wrapping_add(index)) else { return };
            let press = Press::of::<true>(self.solid.key(), there.sub(here), next_n);
            let plane = HalfPlane { normal: next_n, at: to.add(out) };
            best = Some((rank, Push { press, bound: Some((feature, plane)) }));
        };
        for i in 0..p.corners.len() {
            let there = wrapped(i.wrapping_add(turn.shift), &q);
            consider(i, p.facing_normal(i).reversed(), q.facing_normal(there).reversed(), 0);
            let here = p.corner(i);
            let is_outmost = |n: Axis| p.corners.iter().all(|c| along(n, Raw::of(*c).sub(here)) <= 0);
            for n in [Axis::X, Axis::NEG_X, Axis::Y, Axis::NEG_Y].into_iter().filter(|n| is_outmost(*n)) {
                consider(i, n, n, 1);
            }
            let (lo, hi) = self.body.core_box();
            let m = Raw { x: here.x.clamp(lo.x, hi.x), y: here.y.clamp(lo.y, hi.y) }.sub(here);
            let n = Axis::new(m.x, m.y);
            if B::MEETS_CORNERS && !B::ANGULAR && !n.is_zero() && is_outmost(n) {
                consider(i, n, n, 1);
            }
        }
        if clear { None } else { best.map(|(_, push)| push) }
    }
}
