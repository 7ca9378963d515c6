//! Moving solids carry bodies that stand on them, push bodies in their way, and squash bodies that
//! cannot yield.
//!
//! A tick has three steps. Only the first and the last are calls per body, and no step depends on
//! the order of bodies or solids:
//!
//! ```text
//!   1 ride       where do the solids' motions take this body?   (solids are still at their old places)
//!   2 move_all   all solids go to their new places at once
//!   3 move       bodies move by themselves, in the level joined with the solids
//! ```

mod convex;
mod push;
mod room;
mod shove;
mod turn;

use crate::error::{Quantity, RangeError};
use crate::motion::body::Body;
use crate::motion::response::Law;
use crate::motion::slope_limit::SurfaceRole;
use crate::motion::walk::CONTACT;
use crate::motion::{MoveError, Mover, Work};
use crate::num::{Axis, Fx, MOTION, Raw, Vec2, usqr};
use crate::query::meet;
use crate::world::{Solid, World};
use push::Pushes;
use shove::{Clearance, Shove};

/// How the solids' motions of one tick affect a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Ride {
    /// It stands on no solid, and no solid moves into it.
    Free,
    /// It stands on a solid and moved with it, as far as the level and the other solids allow.
    Carried,
    /// It was in the way of a moving solid, and yielded.
    Pushed {
        /// The key of the solid that approaches it fastest; on a tie, the smaller key.
        by: u16,
        /// Out of that solid, toward the body; not reduced at a corner.
        normal: Axis,
    },
    /// It was in the way and could not yield: the level or another solid is behind it. It stays
    /// where it is, and overlaps the solid once that moves.
    Squashed {
        /// The key of the solid that approaches it fastest; on a tie, the smaller key.
        by: u16,
        /// Out of that solid, toward the body.
        normal: Axis,
    },
}

/// Where the solids' motions of one tick take a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[must_use = "the body moves only if you keep `Ridden::body`"]
pub struct Ridden<B> {
    /// The body at its new position. It does not overlap the level. Unless it is squashed, it does
    /// not overlap any solid at its new position either.
    pub body: B,
    /// How the solids affected it.
    pub ride: Ride,
    /// How far it was moved.
    pub motion: Vec2,
    /// The key of the solid that it stood on.
    pub floor: Option<u16>,
    /// The motion that this solid and its conveyor gave it in this tick.
    ///
    /// Use it for a body that leaves the solid, by a jump or over the edge. In this tick the ride
    /// has already made the solid's part, so move the body by its own speed. Then add the carry to
    /// its velocity. Relative to a solid that keeps its motion, the flight is the same as from
    /// still ground.
    pub carry: Vec2,
    /// The work of the call.
    pub work: Work,
}

impl<S: Law> Mover<S> {
    /// The most displacements of a body that one [`ride`](Self::ride) tries.
    pub const ROUNDS: u32 = 8;

    /// Carries a body with the solid that it stands on, for one tick. Also pushes it out of the
    /// path of solids that move against it.
    ///
    /// The solids are still at their old positions. All go by their [motions](Solid::with_motion)
    /// at once, and straight. Call this for each body, then [`Solid::move_all`], then move the
    /// bodies in the level [joined](crate::Joined) with the solids.
    ///
    /// ```text
    ///         ceiling                 floor, wall: the mover's "up" and slope limit
    ///   _____________________         carried: it touches a floor of the solid
    ///        [squashed]               pushed: the solid's motion would enter it, seen from
    ///        =====^=====   wall       the solid, so no speed passes through a body
    ///                       ||        squashed: there is no place behind it
    ///   [carried]  |->[pushed]||
    ///   ====->===  |           ||
    /// ```
    ///
    /// - **Carried**: the body stands on a floor face of the solid, or is a circle on its corner.
    ///   It moves by exactly the motion of the solid and its conveyor, so it never drifts. The
    ///   level can stop it. `follow` is how far it goes down with a floor that sinks in this tick.
    ///   For a body in the air, pass its fall per tick: a lift that sinks faster leaves it there.
    ///   For a [`Walker`](crate::Walker) that stands, pass at least its
    ///   [snap](crate::Walker::with_snap), see below. On two solids at once it goes with the one
    ///   that rises most, then with the smaller key.
    /// - **Pushed**: a solid runs into the body, from any side. A [one-way](Solid::with_one_way)
    ///   solid pushes only bodies in front of it. All pushes of a tick are combined axis by axis:
    ///   the body goes no farther than to where it touches the solid. At slopes of the level up to
    ///   2 : 1 it yields along the other axis. A corner pushes a circle off along its normal. If
    ///   several solids push, the result names the fastest. A body that stands on one solid and is
    ///   pushed by another is `Pushed`, and its `floor` is the first.
    /// - **Squashed**: two solids push the body against each other, or one pushes it against the
    ///   level, with no room left. The body stays where it is. A body that overlaps a solid before
    ///   the tick (a door put there) and still does after it is squashed too. A one-way solid
    ///   squashes as well; then [`Character::ride`](crate::Character::ride) asks again with a mover
    ///   that drops through, which lets the solid pass.
    ///
    /// **A walker's snap.** If a floor sinks by more than `follow`, the body is `Free` and does not
    /// move with it, down or sideways. Take `follow` 1, a lift that moves by (2, 2), and a walker
    /// with a snap of 3. The walker is pulled down to the lift in each following tick, stands all
    /// the time, and slides off its side. With `follow` 3 it is carried.
    ///
    /// **After `Squashed`** the body usually overlaps the solid. A solid that moves diagonally past
    /// a corner of the body may already have passed it. Every move in the level joined with the
    /// solids is [`MoveError::Stuck`](crate::MoveError::Stuck) until the solid has passed it. The
    /// game decides what happens. It may end the body, push it out with
    /// [`escape`](crate::motion::escape), or let it wait: a move that is stuck leaves it where it
    /// is. Any overlap counts: a body half a unit under the edge of a crusher is squashed, too. A
    /// game that forgives such edges escapes first, and then tests which bodies are still stuck.
    ///
    /// No result depends on the order of the list. Bodies do not push each other, so their order
    /// does not matter either. Solids do not push solids. A mover that drops through one-way faces
    /// is neither carried nor pushed by one-way solids. Mirrored scenes give mirrored results if
    /// keys are unique, except for the `normal` of a body exactly in the middle of a solid.
    /// Translated scenes give the same bits.
    ///
    /// Each type of level that a program moves through links its own code. If your game moves its
    /// bodies in a joined level, pass that type here too, which saves 3.5 KB:
    /// `Joined::new(&level, &Solids::new(&[]))`.
    ///
    /// Cost: a few comparisons for each far solid (130 instructions on a Cortex-M0). Otherwise at
    /// most [`Mover::ROUNDS`] displacements, each of up to 6 sweeps over the cells under it. For
    /// each near solid, up to 8 sweeps against its pieces. If no solid touches the body, the call
    /// does not look at the level.
    ///
    /// # Errors
    /// - [`MoveError::Range`] if a half extent or radius is not below 2^28 raw, or `follow` is
    ///   negative or not below that.
    /// - [`MoveError::Range`] if the body would leave the domain, or a motion visits more than
    ///   [`Mover::CELLS`] cells.
    /// - [`MoveError::Stuck`] if the body is to be moved and already overlaps the level.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Fx, Mover, Solid, TileKind, TileKinds, TileMap, Vec2, motion::Ride};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("####\n    \n    \n    ", &KINDS)?; // a ceiling, down to y = 16
    /// let boxed = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
    /// let mover = Mover::platformer(Axis::NEG_Y);
    ///
    /// let mut solids = [Solid::new(boxed(0, 40, 30, 8)?, 7)?];
    /// let mut player = boxed(10, 20, 8, 20)?; // stands on the platform
    /// solids[0] = solids[0].with_motion(Vec2::from_ints(2, -3))?;
    /// let ridden = mover.ride(&level, &solids, &player, Fx::ONE)?;
    /// assert_eq!((ridden.ride, ridden.motion), (Ride::Carried, Vec2::from_ints(2, -3)));
    /// player = ridden.body;
    /// Solid::move_all(&mut solids);
    ///
    /// solids[0] = solids[0].with_motion(Vec2::from_ints(0, -2))?; // the player's head is 1 below the ceiling
    /// let ridden = mover.ride(&level, &solids, &player, Fx::ONE)?;
    /// assert_eq!(ridden.ride, Ride::Squashed { by: 7, normal: Axis::NEG_Y });
    /// assert_eq!(ridden.body, player);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("platform velocity", "moving platform", "AnimatableBody2D"))]
    pub fn ride<W: World, B: Body>(
        &self,
        level: &W,
        solids: &[Solid],
        body: &B,
        follow: Fx,
    ) -> Result<Ridden<B>, MoveError> {
        let value = follow.to_bits();
        if !(0..MOTION).contains(&value) {
            return Err(RangeError { what: Quantity::Follow, value }.into());
        }
        body.check_size()?;
        let carrier = self.carrier(solids, body, value);
        let carry = carrier.map_or(Raw { x: 0, y: 0 }, |c| c.carry);
        let mut ridden = Ridden {
            body: *body,
            ride: if carrier.is_some() { Ride::Carried } else { Ride::Free },
            motion: Vec2::ZERO,
            floor: carrier.map(|c| c.key),
            carry: carry.vec2(),
            work: Work::default(),
        };
        let asking =
            || Pushes { solids, body, passes_one_way: self.passes_one_way(), room: Clearance::ALL, press: None };
        let mut pushes = asking();
        let mut d = carry;
        for _ in 0..Self::ROUNDS {
            let held = pushes.room.held();
            let shove = Shove { d, held, passes_one_way: self.passes_one_way() };
            let to = if d.is_zero() { *body } else { shove.of(body, level, &mut ridden.work)? };
            let made = Raw::of(to.position()).sub(Raw::of(body.position()));
            let Some(next) = pushes.ask(d, made) else {
                if let Some(press) = pushes.press.filter(|p| p.comes) {
                    ridden.ride = Ride::Pushed { by: press.key, normal: press.normal };
                }
                (ridden.body, ridden.motion) = (to, made.vec2());
                return Ok(ridden);
            };
            if pushes.room.is_empty() || (next, pushes.room.held()) == (d, held) {
                break;
            }
            d = next;
        }
        // If the level keeps a body from moving along, the solids may pass it at its position.
        let zero = Raw { x: 0, y: 0 };
        if let Some(press) = pushes.press.filter(|_| asking().ask(zero, zero).is_some()) {
            ridden.ride = Ride::Squashed { by: press.key, normal: press.normal };
        }
        Ok(ridden)
    }
}

/// A solid that a body stands on.
#[derive(Clone, Copy)]
pub(super) struct Carrier {
    pub(super) key: u16,
    /// Its motion plus the conveyor's.
    pub(super) carry: Raw,
    /// How far it rises in this tick, scaled by the length of "up".
    rise: i64,
}

impl Carrier {
    /// Of two solids, prefers the one that rises more, because it lifts the body off the other.
    /// Then the smaller key decides, then geometry. The order of the list does not matter.
    fn goes_before(&self, other: &Self) -> bool {
        let key = |c: &Self| {
            let Raw { x, y } = c.carry;
            (c.rise, u16::MAX - c.key, x.unsigned_abs(), y.unsigned_abs(), x, y)
        };
        key(self) > key(other)
    }
}

impl<S: Law> Mover<S> {
    /// The solid that carries a body: it touches that solid's floor, unless the floor sinks by more
    /// than `follow`.
    #[inline(never)]
    pub(super) fn carrier<B: Body>(&self, solids: &[Solid], body: &B, follow: i32) -> Option<Carrier> {
        let up = self.up?;
        // A solid farther than a contact carries nothing.
        let (bounds, near) = (body.bounds(), Raw { x: CONTACT, y: CONTACT });
        let (lo, hi) = (bounds.lo().sub(near), bounds.hi().add(near));
        let mut best: Option<Carrier> = None;
        for solid in solids.iter().filter(|s| !(self.passes_one_way() && s.one_way().is_some())) {
            if !meet::aabb_aabb::<true>(lo, hi, solid.lo(), solid.hi()) {
                continue;
            }
            let motion = Raw::of(solid.motion());
            // Along an axis: below 2^28.
            let rises = |n: Axis| motion.x.wrapping_mul(n.x).wrapping_add(motion.y.wrapping_mul(n.y));
            let stands = SIDES.iter().any(|&(bit, n)| {
                solid.pieces() & bit != 0 && rises(n).wrapping_neg() <= follow && self.lies_on(solid, n, body)
            });
            if !stands {
                continue;
            }
            let carrier = Carrier {
                key: solid.key(),
                carry: motion.add(Raw::of(solid.conveyor())),
                rise: up.dot(Axis::new(motion.x, motion.y)),
            };
            if best.is_none_or(|b| carrier.goes_before(&b)) {
                best = Some(carrier);
            }
        }
        best
    }

    /// Whether a body touches that side of a solid, at a part of the side that is floor.
    ///
    /// A face is touched exactly. A circle beyond the end of the side stands on the corner, within
    /// the rounding of a motion that ends there.
    fn lies_on<B: Body>(&self, solid: &Solid, n: Axis, body: &B) -> bool {
        let (lo, hi, bounds) = (solid.lo(), solid.hi(), body.bounds());
        let (b_lo, b_hi) = (bounds.lo(), bounds.hi());
        let (gap, along) = if n.x == 0 {
            (if n.y > 0 { b_lo.y - hi.y } else { lo.y - b_hi.y }, (b_lo.x, b_hi.x, lo.x, hi.x))
        } else {
            (if n.x > 0 { b_lo.x - hi.x } else { lo.x - b_hi.x }, (b_lo.y, b_hi.y, lo.y, hi.y))
        };
        let (from, to, start, end) = along;
        if !B::MEETS_CORNERS {
            return gap == 0 && from < end && start < to && self.side(n) == SurfaceRole::Floor;
        }
        // How far the core is beyond the nearer end of the side; 0 over the side itself.
        let radius = body.rounding();
        let (before, after) = (start - (to - radius), from + radius - end);
        let beyond = before.max(after).max(0);
        if beyond == 0 || solid.one_way().is_some() {
            return beyond == 0 && gap == 0 && self.side(n) == SurfaceRole::Floor;
        }
        let (above, reach) = (gap + radius, radius + CONTACT);
        if above <= 0 || beyond > reach || above > reach {
            return false;
        }
        let aside = if before > 0 { beyond.wrapping_neg() } else { beyond };
        let normal = if n.x == 0 { Axis::new(aside, n.y * above) } else { Axis::new(n.x * above, aside) };
        let square = |v: i32| usqr(v.unsigned_abs());
        square(above) + square(beyond) <= square(reach) && self.side(normal) == SurfaceRole::Floor
    }
}

/// The faces of a box as [`Solid::pieces`] counts them, and their normals.
const SIDES: [(u8, Axis); 4] = [(1, Axis::NEG_Y), (2, Axis::X), (4, Axis::Y), (8, Axis::NEG_X)];
