//! Shapes, read by their constructors: a shape that exists is inside the domain.

use super::{Aabb, Capsule, Circle, Compound, CompoundError, ConvexPolygon, OrientedBox, Segment, Single};
use crate::error::{PolygonError, RangeError};
use crate::num::{Fx, Vec2};
use crate::stored::{StoredForm, stored};
use core::fmt;
use heapless::Vec;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct MinMax {
    min: Vec2,
    max: Vec2,
}

impl StoredForm<Aabb> for MinMax {
    type Fault = RangeError;

    fn of(aabb: &Aabb) -> Self {
        Self { min: aabb.min(), max: aabb.max() }
    }

    fn check(self) -> Result<Aabb, RangeError> {
        Aabb::new(self.min, self.max)
    }
}

#[derive(Serialize, Deserialize)]
struct Round {
    centre: Vec2,
    radius: Fx,
}

impl StoredForm<Circle> for Round {
    type Fault = RangeError;

    fn of(circle: &Circle) -> Self {
        Self { centre: circle.centre(), radius: circle.radius() }
    }

    fn check(self) -> Result<Circle, RangeError> {
        Circle::new(self.centre, self.radius)
    }
}

#[derive(Serialize, Deserialize)]
struct Ends {
    a: Vec2,
    b: Vec2,
}

impl StoredForm<Segment> for Ends {
    type Fault = RangeError;

    fn of(segment: &Segment) -> Self {
        Self { a: segment.a(), b: segment.b() }
    }

    fn check(self) -> Result<Segment, RangeError> {
        Segment::new(self.a, self.b)
    }
}

#[derive(Serialize, Deserialize)]
struct RoundEnds {
    a: Vec2,
    b: Vec2,
    radius: Fx,
}

impl StoredForm<Capsule> for RoundEnds {
    type Fault = RangeError;

    fn of(capsule: &Capsule) -> Self {
        Self { a: capsule.a(), b: capsule.b(), radius: capsule.radius() }
    }

    fn check(self) -> Result<Capsule, RangeError> {
        Capsule::new(self.a, self.b, self.radius)
    }
}

/// The half sides as they were rounded: a direction that gives them is not unique.
#[derive(Serialize, Deserialize)]
struct BoxSides {
    centre: Vec2,
    along: Vec2,
    across: Vec2,
    radius: Fx,
}

impl StoredForm<OrientedBox> for BoxSides {
    type Fault = RangeError;

    fn of(turned: &OrientedBox) -> Self {
        let (centre, along, across) = (turned.centre(), turned.along(), turned.across());
        Self { centre, along, across, radius: turned.radius() }
    }

    fn check(self) -> Result<OrientedBox, RangeError> {
        OrientedBox::from_sides(self.centre, self.along, self.across)?.with_radius(self.radius)
    }
}

stored!(Aabb as MinMax);
stored!(Circle as Round);
stored!(Segment as Ends);
stored!(Capsule as RoundEnds);
stored!(OrientedBox as BoxSides);

#[derive(Serialize, Deserialize)]
struct RoundedCorners<const N: usize> {
    corners: Vec<Vec2, N>,
    radius: Fx,
}

/// The corners, or what is around them.
enum PolygonFault {
    Corners(PolygonError),
    Radius(RangeError),
}

impl fmt::Display for PolygonFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Corners(e) => e.fmt(f),
            Self::Radius(e) => e.fmt(f),
        }
    }
}

impl<const N: usize> StoredForm<ConvexPolygon<N>> for RoundedCorners<N> {
    type Fault = PolygonFault;

    fn of(polygon: &ConvexPolygon<N>) -> Self {
        let mut corners = Vec::new();
        let all = corners.extend_from_slice(polygon.vertices());
        debug_assert!(all.is_ok(), "a polygon has at most N corners");
        Self { corners, radius: polygon.radius() }
    }

    fn check(self) -> Result<ConvexPolygon<N>, PolygonFault> {
        let sharp = ConvexPolygon::new(&self.corners).map_err(PolygonFault::Corners)?;
        sharp.with_radius(self.radius).map_err(PolygonFault::Radius)
    }
}

stored!([const N: usize] ConvexPolygon<N> as RoundedCorners<N>;);

#[derive(Serialize, Deserialize)]
struct CompoundParts<S, const M: usize> {
    parts: Vec<S, M>,
}

impl<S: Single, const M: usize> StoredForm<Compound<S, M>> for CompoundParts<S, M> {
    type Fault = CompoundError;

    fn of(compound: &Compound<S, M>) -> Self {
        let mut parts = Vec::new();
        let all = parts.extend_from_slice(compound.parts());
        debug_assert!(all.is_ok(), "a compound has at most M parts");
        Self { parts }
    }

    fn check(self) -> Result<Compound<S, M>, CompoundError> {
        Compound::new(&self.parts)
    }
}

stored!([S: Single, const M: usize] Compound<S, M> as CompoundParts<S, M>; S);
