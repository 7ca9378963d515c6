//! When a moving shape first hits another one.

mod boxes;
pub(crate) mod kernel;
pub(crate) mod moment;
pub(crate) mod offset;
pub(super) mod ray;
pub(super) mod segments;

use super::Overlaps;
use crate::error::RangeError;
use crate::num::{Axis, LONG, MOTION, Raw, Toi, Vec2, check_motion, mul_div};
use crate::shape::kernel::Movable;
use crate::shape::{Aabb, Circle, Segment};
use boxes::{Rounded, SideMoment, enter_box};
use kernel::{Course, Enter, Exchanged, InDomain, Moment, exchanged};
use moment::{Disc, enter_disc, hit_disc};
use segments::{CapsuleMoment, EdgeMoment, enter_crossing, enter_segment};

// Motion uses these through this path.
pub(crate) use moment as crossing;
pub(crate) use moment as side;

pub(crate) use boxes::Span;
pub use kernel::{CastHit, Inside, MovingHit};

/// Moves a shape until it hits another one.
///
/// A hit is the start of an overlap, in the strict sense of [`Overlaps`](super::Overlaps). Whether
/// there is one is decided exactly. A shape that touches and moves in hits at 0. One that slides
/// along, moves away, only grazes, or touches at the very end does not hit. Without motion there is
/// no hit.
///
/// You choose the result for shapes that overlap before the motion. [`Inside::Ignore`] lets A leave
/// B without a hit, and [`Inside::Hit`] is a hit at 0. The normal is that of
/// [`motion::Hit`](crate::motion::Hit) and of rays: out of B, toward the moving shape.
///
/// ```text
///    +----+  motion  +----+
///    | A -|----------|->  | +-----+      toi          the part of the motion until A touches B
///    +----+          +----+ |  B  |      displacement A's way there
///         <----------->     +-----+      axis         <-, out of B
/// ```
///
/// If two sides are hit at the same moment (corner to corner), the hit is on the side that opposes
/// the motion more. On a tie it is on the side whose axis is more along x. Exchanging A and B and
/// reversing the motion gives the same time, and displacement and axis reversed. Translated scenes
/// give the same bits.
///
/// Mirrored scenes give mirrored bits, with one exception. A motion along x or y may meet two sides
/// or corners at one moment, whose axes mirror each other at it. The hit is then on the one whose
/// axis points to the left of the motion (y up). In a mirrored scene it is on the other one, and
/// the axis may have another length.
///
/// Cost on a Cortex-M0, in instructions for a yes and for a whole hit: boxes take 140 and 340,
/// circles 315 and 1300. A circle and a box take 450 and 1130. A circle and a segment take 1200 and
/// 2410, a box and a segment 1230 and 2220. There is one root if a circle meets a circle, a corner
/// or a slanted side, else none, and no division instruction.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Axis, Inside, Vec2, fx};
/// let player = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(10, 10))?;
/// let crate_ = Aabb::new(Vec2::from_ints(30, 5), Vec2::from_ints(40, 15))?;
/// let hit = player.cast_shape(&crate_, Vec2::from_ints(40, 4), Inside::Hit)?.unwrap();
/// assert_eq!((hit.toi.to_fx(), hit.axis), (fx!(0.5), Axis::NEG_X));
/// assert_eq!(hit.displacement, Vec2::from_ints(20, 2));
/// assert!(!player.translated(hit.displacement)?.overlaps(&crate_));
///
/// // A motion exactly up to it is no hit, but one raw unit more is.
/// assert!(!player.would_hit(&crate_, Vec2::from_ints(20, 0), Inside::Hit)?);
/// assert!(player.would_hit(&crate_, Vec2::from_raw((20 << 16) + 1, 0), Inside::Hit)?);
/// # Ok::<(), tilesat::RangeError>(())
/// ```
///
/// # Errors
/// All methods: [`RangeError`] if a component of a motion is not below 2^28 raw (4096 units), or a
/// point is outside the [domain](crate::num::DOMAIN). A motion may leave the domain, and so may the
/// displacement; `translated` then returns an error.
pub trait CastShape<B: ?Sized>: Enter<B> {
    /// The hit of this shape (A), moved by `motion`, on `b` (B); `None` if it does not start to
    /// overlap.
    ///
    /// # Errors
    /// See the trait.
    #[inline]
    #[doc(alias("sweep", "swept AABB", "shapecast", "time_of_impact"))]
    fn cast_shape(&self, b: &B, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
        check(self, motion)?;
        Ok(first(self, b, Raw::of(motion), inside))
    }

    /// Whether [`cast_shape`](Self::cast_shape) hits, without the time, the position and the
    /// normal.
    ///
    /// # Errors
    /// See the trait.
    #[inline]
    #[doc(alias = "test_move")]
    fn would_hit(&self, b: &B, motion: Vec2, inside: Inside) -> Result<bool, RangeError> {
        check(self, motion)?;
        Ok(match self.hits(b, Raw::of(motion)) {
            Course::Free => false,
            Course::Inside => matches!(inside, Inside::Hit),
            Course::Meets(()) => true,
        })
    }

    /// The exact floor of the time of the hit, in 2^-30 of the motion.
    ///
    /// Any other [`CastHit::toi`] is exact already. If a circle meets a circle, a corner or a
    /// slanted segment, exact comparisons find it. They take some 400 instructions on a Cortex-M0
    /// for each bit that the bound is short.
    ///
    /// ```
    /// use tilesat::prelude::*;
    /// use tilesat::{Circle, Fx, Inside, Vec2};
    /// let a = Circle::new(Vec2::from_ints(0, 0), Fx::from_num(3))?;
    /// let b = Circle::new(Vec2::from_ints(16, 3), Fx::from_num(2))?; // they touch where A is at (12, 0)
    /// assert_eq!(a.exact_toi(&b, Vec2::from_ints(32, 0), Inside::Hit)?.unwrap().raw(), 3 << 27);
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// See the trait.
    #[inline]
    fn exact_toi(&self, b: &B, motion: Vec2, inside: Inside) -> Result<Option<Toi>, RangeError> {
        check(self, motion)?;
        let d = Raw::of(motion);
        Ok(match self.enter(b, d) {
            Course::Free => None,
            Course::Inside => matches!(inside, Inside::Hit).then_some(Toi::ZERO),
            Course::Meets(moment) => Some(moment.exact_toi(d)),
        })
    }

    /// The part of the motion in which this shape overlaps `b`: the times of entry and exit.
    ///
    /// It is `None` if they overlap at no time. The entry is 0 if they overlap before the motion,
    /// and the exit is 1 if they do after it. The entry is the exact floor, in 2^-30 of the motion,
    /// and the exit the exact ceiling. A [`Compound`](crate::shape::Compound) may be free of `b`
    /// between the two. Cost: two calls of [`exact_toi`](Self::exact_toi).
    ///
    /// ```
    /// use tilesat::prelude::*;
    /// use tilesat::{Aabb, Vec2, fx};
    /// let bullet = Aabb::new(Vec2::from_ints(0, 4), Vec2::from_ints(2, 6))?;
    /// let gate = Aabb::new(Vec2::from_ints(10, 0), Vec2::from_ints(14, 10))?;
    /// // It enters after 8 units of 32, and has left after 14.
    /// let (entry, exit) = bullet.contact_interval(&gate, Vec2::from_ints(32, 0))?.unwrap();
    /// assert_eq!((entry.to_fx(), exit.to_fx()), (fx!(0.25), fx!(0.4375)));
    /// assert_eq!(bullet.contact_interval(&gate, Vec2::from_ints(8, 0))?, None); // it only touches
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// See the trait, and [`RangeError`] if the motion ends outside of the domain.
    #[doc(alias("exit time", "interval of contact", "swept SAT"))]
    fn contact_interval(&self, b: &B, motion: Vec2) -> Result<Option<(Toi, Toi)>, RangeError>
    where
        Self: Movable,
    {
        // The exit is the entry of the way back.
        let back = self.moved(motion)?.exact_toi(b, Vec2::ZERO - motion, Inside::Hit)?;
        let entry = self.exact_toi(b, motion, Inside::Hit)?;
        Ok(entry.zip(back.map(|back| Toi::clamped(Toi::ONE.raw().wrapping_sub(back.raw())))))
    }

    /// The hit of two shapes that both move: this one by `motion`, `b` by `motion_b`.
    ///
    /// It is as exact as [`cast_shape`](Self::cast_shape) with the difference of the motions.
    ///
    /// ```
    /// use tilesat::prelude::*;
    /// use tilesat::{Aabb, Inside, Vec2};
    /// let a = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(6, 6))?;
    /// let b = Aabb::new(Vec2::from_ints(20, 2), Vec2::from_ints(26, 8))?;
    /// let hit = a.cast_moving(Vec2::from_ints(20, 0), &b, Vec2::from_ints(-8, 0), Inside::Hit)?.unwrap();
    /// assert_eq!((hit.displacement, hit.displacement_b), (Vec2::from_ints(10, 0), Vec2::from_ints(-4, 0)));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// See the trait.
    #[doc(alias("swept", "relative velocity"))]
    fn cast_moving(&self, motion: Vec2, b: &B, motion_b: Vec2, inside: Inside) -> Result<Option<MovingHit>, RangeError>
    where
        B: Enter<Self>,
    {
        check(self, motion)?;
        check(b, motion_b)?;
        let (by_a, by_b) = (Raw::of(motion), Raw::of(motion_b));
        // Below 2^29.
        let d = by_a.sub(by_b);
        Ok(first(self, b, d, inside).map(|hit| {
            let apart = Raw::of(hit.displacement);
            let of_b = Raw { x: share(by_b.x, apart.x, d.x), y: share(by_b.y, apart.y, d.y) };
            MovingHit {
                toi: hit.toi,
                axis: hit.axis,
                displacement: apart.add(of_b).vec2(),
                displacement_b: of_b.vec2(),
                inside: hit.inside,
            }
        }))
    }
}

/// The component `d` times `made / whole`, toward zero, which is a part of the motion between 0 and
/// 1.
///
/// With it A moves `made` farther, which is its own component times the same fraction, rounded to
/// an integer. So neither leaves its motion.
pub(super) const fn share(d: i32, made: i32, whole: i32) -> i32 {
    if made == 0 {
        return 0;
    }
    let part = mul_div(d.unsigned_abs(), made.unsigned_abs(), whole.unsigned_abs()) as i32;
    if d < 0 { part.wrapping_neg() } else { part }
}

#[inline]
fn first<A: Enter<B> + ?Sized, B: ?Sized>(a: &A, b: &B, d: Raw, inside: Inside) -> Option<CastHit> {
    let met = |(toi, step, axis): (Toi, Raw, Axis)| {
        let displacement = a.led_back(b, d, step).vec2();
        CastHit { toi, axis, displacement, inside: false }
    };
    // In two steps on a chip, which has the stack of the first one back in the second.
    let course = if LONG { a.first_contact(b, d).map(met) } else { a.enter(b, d).map(|moment| met(moment.contact(d))) };
    match course {
        Course::Free => None,
        Course::Inside => matches!(inside, Inside::Hit).then(|| CastHit::at_start(d.vec2())),
        Course::Meets(hit) => Some(hit),
    }
}

/// Refuses motions that are too large, and points that are outside the domain.
#[inline]
fn check<S: InDomain + ?Sized>(shape: &S, motion: Vec2) -> Result<(), RangeError> {
    shape.check()?;
    let (x, y) = motion.raw();
    // A test against half of the limit decides both components at once. On a chip without long
    // immediates, its constant costs more than that saves.
    let half = |d: i32| d.wrapping_add(MOTION / 2) as u32;
    let fits = |d: i32| (d.wrapping_add(MOTION - 1) as u32) < (2 * MOTION - 1) as u32;
    let small = if LONG { half(x) | half(y) < MOTION as u32 } else { fits(x) && fits(y) };
    if small { Ok(()) } else { check_motion(motion, MOTION) }
}

/// One ordered pair and its kernel, another one for a yes or no, and one for the contact. Large
/// kernels are calls, so their stack and flash stay out of the caller.
macro_rules! casts {
    ($a:ty, $b:ty, $moment:ty, |$x:ident, $y:ident, $d:ident| $course:expr $(, #[$call:meta] $hits:expr $(, $contact:expr)?)?) => {
        impl Enter<$b> for $a {
            type Moment = $moment;

            #[inline]
            fn enter(&self, b: &$b, $d: Raw) -> Course<$moment> {
                let ($x, $y) = (self, b);
                $course
            }

            $(#[$call]
            fn hits(&self, b: &$b, $d: Raw) -> Course<()> {
                let ($x, $y) = (self, b);
                $hits
            }

            $(#[inline]
            fn first_contact(&self, b: &$b, $d: Raw) -> Course<(Toi, Raw, Axis)> {
                let ($x, $y) = (self, b);
                $contact
            })?)?
        }

        impl CastShape<$b> for $a {}
    };
}

/// A pair of different shapes, in both orders. The second one casts the other way, so `both_orders`
/// is not enough.
macro_rules! casts_both {
    ($a:ty, $b:ty, $moment:ty, |$x:ident, $y:ident, $d:ident| $course:expr $(, #[$call:meta] $hits:expr $(, $contact:expr)?)?) => {
        casts!($a, $b, $moment, |$x, $y, $d| $course $(, #[$call] $hits $(, $contact)?)?);
        casts!(
            $b,
            $a,
            Exchanged<$moment>,
            |$y, $x, d| {
                let $d = d.reversed();
                $course.map(Exchanged)
            },
            #[inline]
            $x.hits($y, d.reversed()),
            $x.first_contact($y, d.reversed()).map(exchanged)
        );
    };
}

/// The kernel's answer, unless the shapes overlap already.
#[inline]
fn unless<M>(overlap: bool, enter: impl FnOnce() -> Option<M>) -> Course<M> {
    if overlap { Course::Inside } else { Course::of(enter()) }
}

casts!(
    Aabb,
    Aabb,
    SideMoment,
    |a, b, d| enter_box(a.lo(), a.hi(), b.lo(), b.hi(), d),
    #[inline]
    enter_box(a.lo(), a.hi(), b.lo(), b.hi(), d).map(|_| ())
);
casts!(
    Circle,
    Circle,
    Disc,
    |a, b, d| enter_disc(a.c(), b.c(), a.r().wrapping_add(b.r()), d),
    #[inline(never)]
    hit_disc(a.c(), b.c(), a.r().wrapping_add(b.r()), d)
);
casts!(Segment, Segment, EdgeMoment, |a, b, d| enter_crossing((a.ra(), a.rb()), (b.ra(), b.rb()), d));
casts_both!(
    Circle,
    Aabb,
    Rounded,
    |a, b, d| unless(a.overlaps(b), || boxes::gate(a, b, d)?.enter(a, d)),
    #[inline(never)]
    unless(a.overlaps(b), || boxes::gate_here(a, b, d)?.hits(a, d).then_some(())),
    unless(a.overlaps(b), || boxes::gate(a, b, d)?.contact(a, d))
);
casts_both!(
    Circle,
    Segment,
    CapsuleMoment,
    |a, b, d| segments::gate(a, b, d).then(|gate| gate.enter(a, d)),
    #[inline(never)]
    segments::gate(a, b, d).then(|gate| gate.hits(a, d).then_some(())),
    segments::contact(a, b, d)
);
casts_both!(Aabb, Segment, EdgeMoment, |a, b, d| enter_segment(a.lo(), a.hi(), b.ra(), b.rb(), d));
// A point is a box or a circle of size zero.
casts!(Vec2, Aabb, SideMoment, |p, b, d| enter_box(Raw::of(*p), Raw::of(*p), b.lo(), b.hi(), d));
casts!(
    Vec2,
    Circle,
    Disc,
    |p, b, d| enter_disc(Raw::of(*p), b.c(), b.r(), d),
    #[inline(never)]
    hit_disc(Raw::of(*p), b.c(), b.r(), d)
);
