//! Convex solids carry and push bodies.
//!
//! As with boxes, all pushes of a tick are combined, but as half-planes. A solid into which the
//! body runs, relative to the solid, sets the tangent there as a bound, and so does the level. The
//! displacement is the one within all bounds that is nearest to the carry. It is tried as a
//! straight motion, which finds further bounds, until nothing is hit.

use super::push::Press;
use super::room::{HalfPlane, RoomToMove};
use super::shove::Shove;
use super::turn::{Turn, lowest};
use super::{Carrier, Ridden, Ride};
use crate::error::{Quantity, RangeError};
use crate::motion::body::Body;
use crate::motion::contact::{Bend, touched_any};
use crate::motion::order::First;
use crate::motion::plane::{NEAR, way};
use crate::motion::response::Law;
use crate::motion::run::{Run, check_inside};
use crate::motion::search::{Around, Search, check_cells, hull};
use crate::motion::slope_limit::SurfaceRole;
use crate::motion::{MoveError, Moved, Mover, Stuck, Work};
use crate::num::{Axis, Fx, MOTION, Raw, Vec2, less128, sqr64};
use crate::query::cast::moment::{along, is_below, reach};
use crate::query::meet;
use crate::shape::Aabb;
use crate::world::{ConvexSolid, ConvexSolids, Feature, Geometry, SolidShape, World, ends, normal};
use core::slice;

impl<L: Law> Mover<L> {
    /// The most displacements of a body that one [`ride_convex`](Self::ride_convex) tries.
    pub const CONVEX_ROUNDS: u32 = 16;

    /// [`ride`](Self::ride) for solids of any convex shape: sloped lifts, bumpers, platforms that
    /// turn.
    ///
    /// The solids are still at their old positions, and all move to their next ones at once. Call
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
    /// - **Carried** bodies move by exactly the motion of the solid. A solid that
    ///   [turns](ConvexSolid::with_turn) carries a body by the motion of the point that the body
    ///   touches; the body itself does not turn.
    /// - **Pushed** bodies take the shortest way out that the level and all solids leave. It leads
    ///   along the normal of the face, corner or arc that hits them, and along walls and slopes
    ///   from there.
    /// - **Squashed**: the body has no such way out, or it is longer than eight times the longest
    ///   motion of a solid. That happens between a wedge and a wall that nearly meet. If the solids
    ///   pass the body at its position, it stays there.
    /// - **A turn** by any angle keeps each body in front of the face or corner that was between
    ///   the two before. So no body passes to the other side. The positions between are not tested.
    ///   Take an arm of 100 units that turns by 10 degrees. Its tip passes over bodies that are in
    ///   its reach by less than 0.4 units.
    ///
    /// If a turn must not squash a body, your game has to refuse it. Call this for all bodies
    /// first, and turn the solid only if none is squashed. See the example.
    ///
    /// Cost: a few comparisons for each far solid (100 instructions on a Cortex-M0). Otherwise at
    /// most [`Mover::CONVEX_ROUNDS`] displacements, each one sweep through the level and one for
    /// each near solid. A circle on a plank that turns takes 24 000 instructions.
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
        let room = RoomToMove::new(carry, solids.iter().map(ConvexSolid::longest).max().unwrap_or(0));
        let mut pushes = ConvexPushes { solids, body, floor: ridden.floor, room, press: None };
        let (mut d, mut made, mut starts) = (carry, Raw::ZERO, true);
        let mut done = None;
        for _ in 0..Self::CONVEX_ROUNDS {
            let hit = if d.is_zero() { None } else { self.hit_in(level, body, d, &mut starts, &mut ridden.work)? };
            if let Some(hit) = hit {
                made = hit.made;
                pushes.room.add(None, &hit.feature, hit.plane);
            } else if pushes.is_clear(d) {
                // Rounding may have met what no sweep did.
                done = (d.is_zero() || !body.shifted(d).overlaps_world(level)).then_some(d);
                break;
            }
            let mut next = pushes.room.nearest();
            if next.is_none() && pushes.room.forget_level() {
                // The bounds of the level hold only on straight motions. The push of the solids on
                // a body that the level stops leads elsewhere.
                if pushes.is_clear(made) {
                    done = Some(made);
                    break;
                }
                next = pushes.room.nearest().filter(|next| *next != d);
            }
            let Some(next) = next else { break };
            d = next;
        }
        if done.is_none() {
            // If no straight motion is free, try a bent one along the level. Or the solids pass a
            // body that the level stops, or that stays.
            let shove = Shove { d, held: pushes.room.held(), passes_one_way: self.passes_one_way() };
            let bent = if d.is_zero() { *body } else { shove.of(body, level, &mut ridden.work)? };
            let bent = Raw::of(bent.position()).sub(Raw::of(body.position()));
            done = [bent, made, Raw::ZERO].into_iter().find(|&d| pushes.is_clear(d));
        }
        match (done, pushes.press) {
            (None, Some(press)) => ridden.ride = Ride::Squashed { by: press.key, normal: press.normal },
            (Some(d), press) => {
                if let Some(press) = press.filter(|p| p.comes && !d.is_zero()) {
                    ridden.ride = Ride::Pushed { by: press.key, normal: press.normal };
                }
                (ridden.body, ridden.motion) = (body.shifted(d), d.vec2());
            }
            (None, None) => {}
        }
        Ok(ridden)
    }

    /// The first hit of a displacement in the level.
    #[inline(never)]
    fn hit_in<W: World, B: Body>(
        &self,
        level: &W,
        body: &B,
        d: Raw,
        starts: &mut bool,
        work: &mut Work,
    ) -> Result<Option<LevelHit>, MoveError> {
        check_cells(level, body.extent(), d)?;
        check_inside(&body.bounds(), d)?;
        let mut moved = Moved::freely(*body, d.vec2(), 0);
        let mut around = Around::nothing();
        let mut run = Run::new(&mut moved, &mut around);
        run.pass_one_way = self.passes_one_way();
        run.moved.work = *work;
        if core::mem::take(starts) && run.is_stuck(level) {
            return Err(MoveError::Stuck(Stuck { at: body.position().raw() }));
        }
        run.moved.work.iterations += 1;
        let hit = run.first_hit(level, d).map(|(entry, feature)| {
            let plane = HalfPlane { normal: entry.normal, at: entry.displacement(d) };
            LevelHit { feature, plane, made: run.advance(level, d, &entry) }
        });
        *work = run.moved.work;
        Ok(hit)
    }

    /// The solid that carries a body. If there are several, the one that rises most, then by the
    /// key.
    fn convex_carrier<S: SolidShape, B: Body>(
        &self,
        solids: &[ConvexSolid<S>],
        body: &B,
        follow: i32,
    ) -> Option<Carrier> {
        let up = self.up?;
        let (bounds, near) = (body.bounds(), Raw { x: NEAR as i32, y: NEAR as i32 });
        let (lo, hi) = (bounds.lo().sub(near), bounds.hi().add(near));
        // Over the end of a face, a side that is nearly parallel to it may be higher: see `lowest`.
        let rise = (way(hi.sub(lo)) >> 9).wrapping_add(2) as i32;
        let rise = Raw { x: rise, y: rise };
        let region = Aabb::from_raw_unchecked(lo.sub(rise), hi.add(rise));
        let mut best: Option<Carrier> = None;
        let is_near = |solid: &&ConvexSolid<S>| {
            let meets = |b: &Aabb| meet::aabb_aabb::<true>(lo, hi, b.lo(), b.hi());
            meets(solid.whole()) && meets(&solid.shape().extent())
        };
        for solid in solids.iter().filter(is_near) {
            let corners = solid.outline();
            let (border, mut next) = (solid.border(&corners), 0);
            while let Some(feature) = border.next_in(&mut next, &region) {
                let mut stands: Option<Raw> = None;
                feet(body, &feature, &mut |n| {
                    let (first, last) = lowest(body, n);
                    let turn = || Turn::of(solid).of_contact(&feature, first, last);
                    let carry = solid.motion().map_or_else(turn, Raw::of);
                    let sinks = along(n, carry).min(0).unsigned_abs();
                    if self.side(n) == SurfaceRole::Floor && !less128(reach(follow, n), sqr64(sinks)) {
                        stands = Some(carry);
                    }
                });
                let Some(carry) = stands else { continue };
                let carrier = Carrier { key: solid.key(), carry, rise: up.dot(Axis::new(carry.x, carry.y)) };
                if best.is_none_or(|b| carrier.goes_before(&b)) {
                    best = Some(carrier);
                }
            }
        }
        best
    }
}

/// Passes the normals to `each` at which a body touches a piece of a solid with more than the end
/// of a side.
///
/// A face along x or y is touched exactly, others within the rounding of a motion that ends there.
fn feet<B: Body>(body: &B, feature: &Feature, each: &mut dyn FnMut(Axis)) {
    match feature.geometry {
        Geometry::Face { a, dir, len, .. } if !B::ANGULAR || dir.x == 0 || dir.y == 0 => {
            let ((a, b), n) = (ends(Raw::of(a), dir, len), normal(dir));
            let ((foot, r), (first, last)) = (body.toward(n.reversed()), lowest(body, n));
            let gap = along(n, foot.sub(a));
            let is_flat = n.x == 0 || n.y == 0;
            let far = reach(if is_flat { r } else { r.wrapping_add(NEAR as i32) }, n);
            let touches = gap >= 0 && !less128(far, sqr64(gap as u64)) && !(is_flat && is_below(gap as u64, far));
            // A sharp end on an end is no foot.
            let least = i64::from(is_flat && r == 0);
            if touches && along(dir, last.sub(a)) >= least && along(dir, first.sub(b)) <= -least {
                each(n);
            }
        }
        // A side of a box on a peak, or on the top of an arc.
        Geometry::Vertex { p, .. } if !B::MEETS_CORNERS => on_peak(body, Raw::of(p), each),
        Geometry::Arc { centre, radius, quadrant, .. } if !B::MEETS_CORNERS => {
            let end = |x: i32, y: i32| Raw { x: x.wrapping_mul(radius), y: y.wrapping_mul(radius) };
            for way in [end(quadrant.x, 0), end(0, quadrant.y)] {
                on_peak(body, Raw::of(centre).add(way), each);
            }
            at_corner(body, feature, each);
        }
        _ => at_corner(body, feature, each),
    }
}

fn at_corner<B: Body>(body: &B, feature: &Feature, each: &mut dyn FnMut(Axis)) {
    touched_any(body, feature, &mut |plane| {
        if plane.bend != Bend::End {
            each(plane.normal);
        }
    });
}

/// The normal at which a side of a box lies on a point.
fn on_peak<B: Body>(body: &B, p: Raw, each: &mut dyn FnMut(Axis)) {
    let (lo, hi) = (body.bounds().lo(), body.bounds().hi());
    if lo.x < p.x && p.x < hi.x && (p.y == hi.y || p.y == lo.y) {
        each(Axis::new(0, if p.y == hi.y { -1 } else { 1 }));
    } else if lo.y < p.y && p.y < hi.y && (p.x == hi.x || p.x == lo.x) {
        each(Axis::new(if p.x == hi.x { -1 } else { 1 }, 0));
    }
}

/// Where a displacement meets the level.
struct LevelHit {
    feature: Feature,
    plane: HalfPlane,
    /// How far the body moves, verified.
    made: Raw,
}

/// The pushes of one tick on one body.
struct ConvexPushes<'a, S, B> {
    solids: &'a [ConvexSolid<S>],
    body: &'a B,
    floor: Option<u16>,
    room: RoomToMove,
    press: Option<Press>,
}

impl<S: SolidShape, B: Body> ConvexPushes<'_, S, B> {
    /// Whether the body keeps clear of all solids by `d`. Otherwise adds the bounds that they set.
    fn is_clear(&mut self, d: Raw) -> bool {
        let mut clear = true;
        for (i, solid) in self.solids.iter().enumerate() {
            let Some(mut push) = (Tick { solid, body: self.body }).ask(d) else { continue };
            clear = false;
            // A turn comes, even where the point that touches goes away. What it takes along it
            // does not push.
            if solid.motion().is_none() {
                push.press.comes = self.floor != Some(solid.key());
            }
            let new = push.press;
            let goes_before = |p: Press| if new.comes == p.comes { new.goes_before(&p) } else { new.comes };
            if self.press.is_none_or(goes_before) {
                self.press = Some(new);
            }
            match push.bound {
                Some((feature, plane)) => self.room.add(Some(i as u16), &feature, plane),
                // Nothing moves a body that is already inside.
                None => self.room.close(),
            }
        }
        clear
    }
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
    /// `None` if the body keeps clear of the solid by `d`.
    fn ask(&self, d: Raw) -> Option<Push> {
        let (solid, body) = (self.solid, self.body);
        let (whole, bounds) = (solid.whole(), body.bounds());
        let trail = bounds.union(&Aabb::from_raw_unchecked(bounds.lo().add(d), bounds.hi().add(d)));
        if !meet::aabb_aabb::<false>(whole.lo(), whole.hi(), trail.lo(), trail.hi()) {
            return None;
        }
        let overlaps =
            |solid: &ConvexSolid<S>, body: &B| body.overlaps_world(&ConvexSolids::new(slice::from_ref(solid)));
        let ends_inside = || overlaps(&solid.moved(), &body.shifted(d));
        if overlaps(solid, body) {
            return ends_inside().then(|| self.inside());
        }
        let push = if let Some(motion) = solid.motion() {
            let motion = Raw::of(motion);
            self.first_hit(d.sub(motion)).map(|(feature, plane)| {
                let press = Press::of::<true>(solid.key(), motion, plane.normal);
                Push { press, bound: Some((feature, HalfPlane { at: plane.at.add(motion), ..plane })) }
            })
        } else {
            let held = Turn::of(solid).held(body, d);
            held.map(|(feature, plane, press)| Push { press, bound: Some((feature, plane)) })
        };
        push.or_else(|| ends_inside().then(|| self.inside()))
    }

    /// The first piece that the body hits on its way past the solid, and the tangent there.
    fn first_hit(&self, d: Raw) -> Option<(Feature, HalfPlane)> {
        if d.is_zero() {
            return None;
        }
        // All pieces of one solid are swept against at once. So the search that levels need, in
        // pieces of the motion, is not linked for another level.
        let solids = ConvexSolids::new(slice::from_ref(self.solid));
        let mut pieces = solids.features(&hull(&self.body.bounds(), Raw::ZERO, d, 1));
        let (mut around, mut first) = (Around::nothing(), First::none());
        let mut search = Search::new(self.body, &mut around);
        search.meet_all(&solids, &mut pieces, d, &mut first);
        search.find_cusp(&solids, d, &mut first);
        let (entry, feature) = first.hit::<B, ConvexSolids<'_, S>>(self.body, d)?;
        Some((*feature, HalfPlane { normal: entry.normal, at: entry.displacement(d) }))
    }

    /// The push on a body in the solid, from the middle of the solid's bounds to that of the
    /// body's.
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
}

#[cfg(test)]
mod tests {
    use super::{Aabb, Axis, Raw, on_peak};

    /// The inside of each side lies on a point there, and no corner does.
    #[test]
    fn a_side_lies_on_a_peak_in_front_of_it() {
        let body = Aabb::from_raw_unchecked(Raw { x: 0, y: 0 }, Raw { x: 8, y: 8 });
        let normal = |x, y| {
            let mut found = None;
            on_peak(&body, Raw { x, y }, &mut |n| found = Some(n));
            found
        };
        for (x, y, n) in [(8, 3, Axis::NEG_X), (0, 3, Axis::X), (3, 8, Axis::NEG_Y), (3, 0, Axis::Y)] {
            assert_eq!(normal(x, y), Some(n), "{x} {y}");
        }
        assert!(normal(8, 8).is_none() && normal(3, 3).is_none() && normal(9, 3).is_none());
    }
}
