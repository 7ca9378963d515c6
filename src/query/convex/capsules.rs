//! Two segments with a radius around each, for pairs of capsules.

use super::across::across;
use super::nearness::Unsure;
use super::place::NearestPart;
use super::two_segments::{TwoSegments, end_of};
use super::walk::Corner;
use crate::num::Raw;
use crate::query::contact::Contact;
use crate::shape::Convex;

/// The segments and the radii.
pub(super) struct Capsules {
    a: [Raw; 2],
    b: [Raw; 2],
    radii: (i32, i32),
}

impl Capsules {
    #[inline(always)]
    pub(super) fn of(a: &impl Convex, b: &impl Convex) -> Option<Self> {
        let has_length = a.point().is_none() && b.point().is_none();
        let (p, q) = (a.ends()?, b.ends()?);
        has_length.then_some(Self { a: p, b: q, radii: (a.rounding(), b.rounding()) })
    }

    const fn radius(&self) -> i32 {
        self.radii.0.wrapping_add(self.radii.1)
    }

    /// Whether they overlap, or touch. None if the segments are parallel.
    #[inline(always)]
    pub(super) fn meet<const CLOSED: bool>(&self) -> Option<bool> {
        TwoSegments::of(self.a, self.b).map(|both| both.meet::<CLOSED>(self.radius()))
    }

    #[inline(always)]
    fn place(&self) -> Option<NearestPart> {
        TwoSegments::of(self.a, self.b)?.place()
    }

    /// The distance of the segments, rounded down.
    #[inline(always)]
    pub(super) fn distance(&self) -> Option<u32> {
        self.place().map(|place| place.distance())
    }

    /// How they overlap; an error if the segments cross, are parallel or touch.
    #[inline(always)]
    pub(super) fn contact(&self) -> Result<Option<Contact>, Unsure> {
        let place = self.place().ok_or(Unsure)?;
        if !place.within::<false>(self.radius()) {
            return Ok(None);
        }
        let contact = match place {
            NearestPart::Inside => return Err(Unsure),
            NearestPart::Side(side, _) => across(&side, end_of(self.a, side.a), end_of(self.b, side.b)),
            NearestPart::Corner(Corner { at, a, .. }) => Contact::radial(end_of(self.a, a), at.reversed()),
        };
        Ok(Some(contact.with_radii(self.radii.0, self.radii.1)))
    }
}
