//! A box in any direction and a point, for the queries of circles.

use super::across::over;
use super::nearness::{Least, Nearness, Unsure};
use crate::num::{Raw, div_sqrt, isqrt64, usqr};
use crate::query::contact::Contact;
use crate::query::meet::{Offset, is_within, near_line};
use crate::shape::Convex;

/// A point relative to the middle of a box with area.
pub(super) struct BoxPoint {
    /// Half of the sides, the second one on the left of the first (y up).
    u: Offset,
    v: Offset,
    /// A quarter of the box's.
    area: i64,
    /// The way from the middle to the point.
    d: Offset,
    point: Raw,
    /// Whether the box is A.
    of_a: bool,
    radii: (i32, i32),
}

/// The part of the box that is nearest to the point.
enum BoxPart {
    /// The point is inside or on the border: how far behind the nearer one of each two sides, times
    /// half of its length.
    Inside(i64, i64),
    /// A side, at this distance times half of its length.
    Side(BoxSide, i64),
    /// The way to the point from a corner.
    Corner(Offset),
}

struct BoxSide {
    /// Half of it: `v` or `u`.
    half: Offset,
    /// From the middle of the box to the middle of the side.
    out: Offset,
    /// Whether the box is on the right of `half`.
    reversed: bool,
}

impl BoxPart {
    /// Whether the point is nearer than a radius, or as near.
    #[inline(always)]
    const fn is_within<const CLOSED: bool>(&self, radius: i32) -> bool {
        match self {
            Self::Inside(u, v) => CLOSED || radius > 0 || (*u > 0 && *v > 0),
            Self::Side(side, height) => near_line::<CLOSED>(*height, radius, side.half.len2()),
            Self::Corner(way) => is_within::<CLOSED>(way.len2(), usqr(radius as u32)),
        }
    }
}

impl BoxPoint {
    #[inline(always)]
    pub(super) fn of(a: &impl Convex, b: &impl Convex) -> Option<Self> {
        let radii = (a.rounding(), b.rounding());
        if let (Some(of), Some(point)) = (a.half_sides(), b.point()) {
            Self::new(of, point, true, radii)
        } else if let (Some(point), Some(of)) = (a.point(), b.half_sides()) {
            Self::new(of, point, false, radii)
        } else {
            None
        }
    }

    #[inline(always)]
    const fn new([u, v, middle]: [Raw; 3], point: Raw, of_a: bool, radii: (i32, i32)) -> Option<Self> {
        let (u, v, d) = (Offset::of_raw(u), Offset::of_raw(v), Offset::between(middle, point));
        let area = u.cross(v);
        if area == 0 { None } else { Some(Self { u, v, area, d, point, of_a, radii }) }
    }

    const fn radius(&self) -> i32 {
        self.radii.0.wrapping_add(self.radii.1)
    }

    /// Half sides are below 2^29, and `d` is below 2^30: products of three terms are below 2^61.
    #[inline(always)]
    const fn part(&self) -> BoxPart {
        let (along_u, along_v) = (self.d.cross(self.v), self.u.cross(self.d));
        let beyond_u = along_u.wrapping_abs().wrapping_sub(self.area);
        let beyond_v = along_v.wrapping_abs().wrapping_sub(self.area);
        // Beyond a side, its foot is nearest if the side has it. Else one of its ends is, or a
        // point of the other side.
        if beyond_u <= 0 {
            if beyond_v <= 0 {
                return BoxPart::Inside(beyond_u.wrapping_neg(), beyond_v.wrapping_neg());
            }
            return match self.foot(self.side_v(along_v)) {
                Ok(side) => BoxPart::Side(side, beyond_v),
                Err(way) => BoxPart::Corner(way),
            };
        }
        let end = match self.foot(self.side_u(along_u)) {
            Ok(side) => return BoxPart::Side(side, beyond_u),
            Err(way) => way,
        };
        if beyond_v <= 0 {
            return BoxPart::Corner(end);
        }
        match self.foot(self.side_v(along_v)) {
            Ok(side) => BoxPart::Side(side, beyond_v),
            Err(way) => BoxPart::Corner(if way.len2() < end.len2() { way } else { end }),
        }
    }

    /// A side if it has the foot of the point, or the way to the point from its nearer end.
    #[inline(always)]
    const fn foot(&self, side: BoxSide) -> Result<BoxSide, Offset> {
        let from = self.d.sub(side.out);
        let foot = from.dot(side.half);
        if foot.unsigned_abs() <= side.half.len2() {
            Ok(side)
        } else {
            Err(if foot < 0 { from.add(side.half) } else { from.sub(side.half) })
        }
    }

    /// The side of the half plane that the point is in, `along` the first half side.
    #[inline(always)]
    const fn side_u(&self, along: i64) -> BoxSide {
        let reversed = along < 0;
        BoxSide { half: self.v, out: if reversed { self.u.reversed() } else { self.u }, reversed }
    }

    #[inline(always)]
    const fn side_v(&self, along: i64) -> BoxSide {
        let reversed = along < 0;
        BoxSide { half: self.u, out: if reversed { self.v.reversed() } else { self.v }, reversed: !reversed }
    }

    /// Whether the point is nearer than the radii, or as near.
    #[inline]
    pub(super) const fn meets<const CLOSED: bool>(&self) -> bool {
        self.part().is_within::<CLOSED>(self.radius())
    }

    /// The distance of the point, rounded down.
    #[inline]
    pub(super) const fn distance(&self) -> u32 {
        match self.part() {
            BoxPart::Inside(..) => 0,
            BoxPart::Side(side, height) => div_sqrt(height.unsigned_abs(), side.half.len2()),
            BoxPart::Corner(way) => isqrt64(way.len2()),
        }
    }

    /// How they overlap; [`Unsure`] if two sides are equally near, or nearly so.
    #[inline]
    pub(super) fn contact(&self) -> Result<Option<Contact>, Unsure> {
        let part = self.part();
        if !part.is_within::<false>(self.radius()) {
            return Ok(None);
        }
        let contact = match part {
            BoxPart::Side(side, _) => self.across(&side),
            BoxPart::Inside(u, v) => self.across(&self.nearest(u, v)?),
            BoxPart::Corner(way) => {
                let way = way.raw();
                if self.of_a {
                    Contact::radial(self.point.sub(way), way)
                } else {
                    Contact::radial(self.point, way.reversed())
                }
            }
        };
        Ok(Some(contact.with_radii(self.radii.0, self.radii.1)))
    }

    /// The side nearest to a point that is inside, at these heights.
    fn nearest(&self, u: i64, v: i64) -> Result<BoxSide, Unsure> {
        let (along_u, along_v) = (self.d.cross(self.v), self.u.cross(self.d));
        if self.radius() == 0 {
            return Err(Unsure);
        }
        let mut best = Least::new();
        best.add(Nearness::of(u, self.v.len2()), || (along_u, self.side_u(along_u)))?;
        best.add(Nearness::of(v, self.u.len2()), || (along_v, self.side_v(along_v)))?;
        // In the middle, two opposite sides are equally near.
        best.get().and_then(|(along, side)| if along == 0 { Err(Unsure) } else { Ok(side) })
    }

    /// The contact across a side.
    #[inline(always)]
    const fn across(&self, side: &BoxSide) -> Contact {
        let half = side.half.raw();
        let edge = half.add(half);
        let (axis, overlap) = over(if side.reversed { edge.reversed() } else { edge }, side.out.sub(self.d).raw());
        if self.of_a {
            Contact::new(axis, overlap, self.point).on_b()
        } else {
            Contact::new(axis.reversed(), overlap, self.point)
        }
    }
}
