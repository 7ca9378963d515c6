//! The pairs of shapes that have separate kernels for contacts and distances.

use super::box_pair::BoxPair;
use super::box_point::BoxPoint;
use super::boxes::{self, Parallelogram};
use super::capsules::Capsules;
use super::nearness::Unsure;
use super::{float_margins, gaps};
use crate::query::contact::Contact;
use crate::shape::Convex;

/// The pair that two shapes are. It is known when the code is compiled, except that a box without
/// area makes none.
pub(super) enum Short {
    /// A box in any direction and a circle.
    BoxPoint(BoxPoint),
    Capsules(Capsules),
    /// Two boxes with sharp corners.
    Boxes(Parallelogram, Parallelogram),
}

impl Short {
    #[inline(always)]
    pub(super) fn of(a: &impl Convex, b: &impl Convex) -> Option<Self> {
        if let Some(both) = BoxPoint::of(a, b) {
            Some(Self::BoxPoint(both))
        } else if let Some(both) = Capsules::of(a, b) {
            Some(Self::Capsules(both))
        } else {
            let (p, q) = (a.box_sides()?, b.box_sides()?);
            Some(Self::Boxes(Parallelogram::new(p), Parallelogram::new(q)))
        }
    }

    /// How they overlap; an error if the general code has to decide.
    #[inline(always)]
    pub(super) fn contact(&self) -> Result<Option<Contact>, Unsure> {
        match self {
            Self::BoxPoint(both) => both.contact(),
            Self::Capsules(both) => both.contact(),
            Self::Boxes(a, b) => boxes::contact(a, b),
        }
    }

    /// The distance of the cores, rounded down; none if the general code has to decide.
    #[inline(always)]
    pub(super) fn distance(&self) -> Option<u32> {
        match self {
            Self::BoxPoint(both) => Some(both.distance()),
            Self::Capsules(both) => both.distance(),
            Self::Boxes(a, b) => boxes::place(a, b).map(|place| place.distance()),
        }
    }
}

/// The distance of the cores by floats, rounded down; none for other shapes.
#[inline(always)]
pub(super) fn gap(a: &impl Convex, b: &impl Convex) -> Option<u32> {
    if let Some(gaps) = gaps::of_box_point(a, b) {
        Some(gaps.distance())
    } else if let Some(gaps) = gaps::of_capsules(a, b) {
        Some(gaps.distance())
    } else {
        // Whole sides make twice the distance. Half of that rounded down is the same number.
        let pair = BoxPair::of(a, b)?;
        let sides = pair.sides();
        let far = if float_margins::meet::<true>(sides)? { 0 } else { gaps::of_boxes(sides)?.distance() };
        Some(if pair.is_half { far } else { far >> 1 })
    }
}
