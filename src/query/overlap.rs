//! Whether two shapes overlap (strict) or touch (closed), and whether one contains another.

use super::meet;
use super::meet::{corners, in_disc};
use crate::error::Truncated;
use crate::num::{Raw, Vec2};
use crate::shape::{Aabb, Circle, Segment};

/// Whether the interiors of two shapes meet; exact and strict.
///
/// Precisely: whether the origin is interior to the Minkowski sum A + (-B). So a small move of A in
/// any direction keeps the overlap. Shapes that only touch do not overlap. A point or a segment
/// overlaps a box or a circle if it reaches the inside. Two segments overlap only if they cross
/// properly. A circle of radius zero overlaps only shapes with area. The table of [degenerate
/// cases](crate::query#degenerate-cases) has a line for each of the other cases.
///
/// `a.overlaps(&b)` is `b.overlaps(&a)`, and is true exactly if
/// [`contact`](super::Contacts::contact) is `Some`. Cost on a Cortex-M0: boxes take 20
/// instructions. Two circles, or a circle and a box, take 20 if they are apart, and 35 if near.
/// Within a rounding error of touching, they take 85 to 97. A circle and a segment take 55 if apart
/// and 500 if near. There is no root and no division. It cannot fail.
///
/// ```text
///   +----+            +----+----+          +------+
///   |  +-|--+         |    |    |          |   o--|---o
///   +--|-+  |         +----+----+          +------+
///      +----+          touches            overlaps
///    overlaps
/// ```
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Circle, Fx, Vec2};
/// let wall = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(16, 16))?;
/// let ball = Circle::new(Vec2::from_ints(21, 8), Fx::from_num(5))?;
/// assert!(!ball.overlaps(&wall)); // it touches the wall
/// assert!(Circle::new(ball.centre(), Fx::from_bits((5 << 16) + 1))?.overlaps(&wall));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Overlaps<B: ?Sized> {
    /// Whether this shape overlaps `b`; strict and exact.
    #[doc(alias("intersects", "collides", "intersection_test"))]
    #[must_use]
    fn overlaps(&self, b: &B) -> bool;
}

/// Whether two shapes have a point in common, borders included; exact and closed.
///
/// True whenever [`overlaps`](Overlaps::overlaps) is. `a.touches(&b)` is `b.touches(&a)`. Cost: as
/// `overlaps`. It cannot fail.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Segment, Vec2};
/// let floor = Segment::new(Vec2::from_ints(0, 0), Vec2::from_ints(8, 0))?;
/// let wall = Segment::new(Vec2::from_ints(8, 0), Vec2::from_ints(8, 8))?;
/// assert!(floor.touches(&wall) && !floor.overlaps(&wall)); // a common end
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Touches<B: ?Sized> {
    /// Whether this shape and `b` have a point in common; closed and exact.
    #[doc(alias = "intersects")]
    #[must_use]
    fn touches(&self, b: &B) -> bool;
}

/// Implements both traits for one ordered pair, from one expression that is generic over strict and
/// closed.
macro_rules! meets {
    ($a:ty, $b:ty, |$x:ident, $y:ident, $closed:ident| $test:expr) => {
        impl Overlaps<$b> for $a {
            #[inline]
            fn overlaps(&self, b: &$b) -> bool {
                const fn test<const $closed: bool>($x: &$a, $y: &$b) -> bool {
                    $test
                }
                test::<false>(self, b)
            }
        }

        impl Touches<$b> for $a {
            #[inline]
            fn touches(&self, b: &$b) -> bool {
                const fn test<const $closed: bool>($x: &$a, $y: &$b) -> bool {
                    $test
                }
                test::<true>(self, b)
            }
        }
    };
}

meets!(Aabb, Aabb, |a, b, CLOSED| meet::aabb_aabb::<CLOSED>(a.lo(), a.hi(), b.lo(), b.hi()));
meets!(Circle, Circle, |a, b, CLOSED| meet::circle_circle::<CLOSED>(a.c(), b.c(), a.r().wrapping_add(b.r())));
meets!(Segment, Segment, |a, b, CLOSED| meet::segment_segment::<CLOSED>(a.ra(), a.rb(), b.ra(), b.rb()));
both_orders!(meets: Circle, Aabb, |a, b, CLOSED| meet::circle_aabb::<CLOSED>(a.c(), a.r(), b.lo(), b.hi()));
both_orders!(meets: Circle, Segment, |a, b, CLOSED| meet::circle_segment::<CLOSED>(a.c(), a.r(), b.ra(), b.rb()));
both_orders!(meets: Segment, Aabb, |a, b, CLOSED| meet::segment_aabb::<CLOSED>(a.ra(), a.rb(), b.lo(), b.hi()));

/// The sides of up to `N` boxes in columns, to test one box against all of them at once.
///
/// A compiler can test several boxes per instruction in columns, but not in a slice of boxes. On
/// x86-64 a box takes 5 instructions here, and 11 in a loop over a slice. Other answers about many
/// shapes gain less than a third in columns, so a loop of plain calls is as good for them. For the
/// boxes near each of many bodies, [`LooseGrid`](crate::broad::LooseGrid) tests fewer of them.
///
/// It takes 16 bytes per place. On a chip without vectors, a box takes as long as in a loop.
///
/// ```
/// use tilesat::{Aabb, Vec2, query::BoxColumns};
/// let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8));
/// let enemies = BoxColumns::<4>::of(&[at(0)?, at(8)?, at(20)?])?;
/// let bullet = Aabb::new(Vec2::from_ints(6, 3), Vec2::from_ints(8, 5))?;
/// assert_eq!(enemies.overlaps(&bullet), [true, false, false, false]);
/// assert_eq!(enemies.touches(&bullet), [true, true, false, false]); // the last place has no box
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("batch", "SIMD", "structure of arrays"))]
pub struct BoxColumns<const N: usize> {
    min_x: [i32; N],
    min_y: [i32; N],
    max_x: [i32; N],
    max_y: [i32; N],
}

impl<const N: usize> BoxColumns<N> {
    /// The columns of some boxes, in their order.
    ///
    /// Places after the last box are empty.
    ///
    /// Cost: four stores per box.
    ///
    /// # Errors
    /// [`Truncated`] if there are more than N boxes.
    pub fn of(boxes: &[Aabb]) -> Result<Self, Truncated> {
        if boxes.len() > N {
            return Err(Truncated { seen: u32::try_from(boxes.len()).unwrap_or(u32::MAX), kept: 0 });
        }
        // No box begins before the first place where it ends.
        let (first, last) = ([i32::MAX; N], [i32::MIN; N]);
        let mut all = Self { min_x: first, min_y: first, max_x: last, max_y: last };
        let sides = all.min_x.iter_mut().zip(&mut all.min_y).zip(all.max_x.iter_mut().zip(&mut all.max_y));
        for (b, ((min_x, min_y), (max_x, max_y))) in boxes.iter().zip(sides) {
            (*min_x, *min_y) = (b.lo().x, b.lo().y);
            (*max_x, *max_y) = (b.hi().x, b.hi().y);
        }
        Ok(all)
    }

    /// Whether a box [overlaps](Overlaps) each of the boxes; exact and strict.
    ///
    /// False for places without a box. It cannot fail.
    #[must_use]
    pub fn overlaps(&self, b: &Aabb) -> [bool; N] {
        self.meets::<false>(b)
    }

    /// Whether a box [touches](Touches) each of the boxes; exact and closed.
    ///
    /// False for places without a box. It cannot fail.
    #[must_use]
    pub fn touches(&self, b: &Aabb) -> [bool; N] {
        self.meets::<true>(b)
    }

    #[inline]
    fn meets<const CLOSED: bool>(&self, b: &Aabb) -> [bool; N] {
        let (lo, hi) = (b.lo(), b.hi());
        let mut answers = [false; N];
        let sides = self.min_x.iter().zip(&self.min_y).zip(self.max_x.iter().zip(&self.max_y));
        for (answer, ((&min_x, &min_y), (&max_x, &max_y))) in answers.iter_mut().zip(sides) {
            *answer = meet::aabb_aabb::<CLOSED>(Raw { x: min_x, y: min_y }, Raw { x: max_x, y: max_y }, lo, hi);
        }
        answers
    }
}

/// Whether all of another shape, or a point, is in this shape, borders included; exact and closed.
///
/// Both are closed sets: a shape contains itself, its corners and its border. A segment contains
/// only points, segments along it, and boxes and circles without width. Cost: comparisons for
/// boxes, two or three squares for a circle, two products per end for a segment. It cannot fail;
/// points outside the [domain](crate::num::DOMAIN) are in no shape.
///
/// ```
/// use tilesat::prelude::*;
/// use tilesat::{Aabb, Circle, Fx, Vec2};
/// let room = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(16, 16))?;
/// let ball = Circle::new(Vec2::from_ints(8, 8), Fx::from_num(8))?;
/// assert!(room.contains(&ball) && !ball.contains(&room));
/// assert!(ball.contains(&Vec2::from_ints(8, 16)));
/// # Ok::<(), tilesat::RangeError>(())
/// ```
pub trait Contains<B: ?Sized> {
    /// Whether every point of `b` is a point of this shape; closed and exact.
    #[must_use]
    #[doc(alias("hit test", "point in polygon", "TestPoint"))]
    fn contains(&self, b: &B) -> bool;
}

/// Box in box, each by its corners; a point is a box.
const fn box_in_box(alo: Raw, ahi: Raw, blo: Raw, bhi: Raw) -> bool {
    alo.x <= blo.x && alo.y <= blo.y && bhi.x <= ahi.x && bhi.y <= ahi.y
}

impl Contains<Vec2> for Aabb {
    #[inline]
    fn contains(&self, b: &Vec2) -> bool {
        let p = Raw::of(*b);
        box_in_box(self.lo(), self.hi(), p, p)
    }
}

/// A box is convex with sides along the axes, so it contains a shape if it contains the bounding
/// box.
macro_rules! by_bounding_box {
    ($($shape:ty),*) => {$(
        impl Contains<$shape> for Aabb {
            #[inline]
            fn contains(&self, b: &$shape) -> bool {
                let b = b.aabb();
                box_in_box(self.lo(), self.hi(), b.lo(), b.hi())
            }
        }
    )*};
}

by_bounding_box!(Aabb, Circle, Segment);

/// The distances to the farthest coordinates of a box, against a disc. A point is a box; any point
/// is allowed.
const fn box_in_disc(c: Raw, r: i32, lo: Raw, hi: Raw) -> bool {
    let (x, y) = (farthest(c.x, lo.x, hi.x), farthest(c.y, lo.y, hi.y));
    in_disc::<true>(x, y, r as u32)
}

const fn farthest(c: i32, lo: i32, hi: i32) -> u32 {
    let (left, right) = (c.abs_diff(lo), c.abs_diff(hi));
    if left > right { left } else { right }
}

impl Contains<Vec2> for Circle {
    #[inline]
    fn contains(&self, b: &Vec2) -> bool {
        box_in_disc(self.c(), self.r(), Raw::of(*b), Raw::of(*b))
    }
}

impl Contains<Aabb> for Circle {
    #[inline]
    fn contains(&self, b: &Aabb) -> bool {
        box_in_disc(self.c(), self.r(), b.lo(), b.hi())
    }
}

impl Contains<Circle> for Circle {
    #[inline]
    fn contains(&self, b: &Circle) -> bool {
        // |d| + r_b <= r_a.
        let rest = self.r().wrapping_sub(b.r());
        rest >= 0 && box_in_disc(self.c(), rest, b.c(), b.c())
    }
}

impl Contains<Segment> for Circle {
    #[inline]
    fn contains(&self, b: &Segment) -> bool {
        self.contains(&b.a()) && self.contains(&b.b())
    }
}

/// Whether `p` is on the segment. Beyond the bounding box nothing is multiplied, so any point is
/// allowed.
fn on_segment(s: &Segment, p: Raw) -> bool {
    let (lo, hi) = corners(s.ra(), s.rb());
    box_in_box(lo, hi, p, p) && s.edge().cross(p.sub(s.ra())) == 0
}

impl Contains<Vec2> for Segment {
    #[inline]
    fn contains(&self, b: &Vec2) -> bool {
        on_segment(self, Raw::of(*b))
    }
}

impl Contains<Segment> for Segment {
    #[inline]
    fn contains(&self, b: &Segment) -> bool {
        on_segment(self, b.ra()) && on_segment(self, b.rb())
    }
}

impl Contains<Aabb> for Segment {
    #[inline]
    fn contains(&self, b: &Aabb) -> bool {
        // Three corners of a box with area are not on one line; those of a flat box are two points.
        let (lo, hi) = (b.lo(), b.hi());
        on_segment(self, lo) && on_segment(self, hi) && on_segment(self, Raw { x: lo.x, y: hi.y })
    }
}

impl Contains<Circle> for Segment {
    #[inline]
    fn contains(&self, b: &Circle) -> bool {
        b.r() == 0 && on_segment(self, b.c())
    }
}
