//! Where a box touches a point at which two solids meet corner to corner.

use super::body::{Body, Entry};
use super::plane::Bend;
use super::run::Run;
use crate::num::{Axis, Raw};
use crate::world::{Feature, World};

impl<B: Body> Run<'_, B> {
    /// Another hit instead of one at the end of a face that the body touches, where that stops it for good though it could slide.
    ///
    /// Corner to corner neither axis alone leads into the solid that is ahead, only both do, so either side of the corner could be what is hit. One of
    /// the two may be hidden by a second solid that ends in the same point, and no feature of the first tells that. So both ways along are tried:
    /// where the one along the side that was hit is blocked at once, by what leaves nothing of the velocity, and the other is not, the other side is the
    /// one to slide along. The sweep that
    /// follows proves the way as it proves every other.
    ///
    /// ```text
    ///       |###/     the box moves up and to the right; the underside of the upper tip opposes it most, but along it
    ///       |##/      the lower solid is in the way: it slides up along the left side
    ///       |#/
    ///   +---*
    ///   |box|\
    ///   +---+##\
    /// ```
    #[inline(never)]
    pub(super) fn past_pinch<W: World>(&mut self, world: &W, d: Raw, entry: &Entry) -> Option<(Entry, Feature)> {
        if !entry.at_end || entry.num != 0 || entry.step.is_some() || d.x == 0 || d.y == 0 {
            return None;
        }
        let (along_x, along_y) = (Raw { x: d.x, y: 0 }, Raw { x: 0, y: d.y });
        let (along, across, normal) = match entry.normal {
            Axis { x: 0, .. } => (along_x, along_y, Axis::new(d.x.signum().wrapping_neg(), 0)),
            Axis { y: 0, .. } => (along_y, along_x, Axis::new(0, d.y.signum().wrapping_neg())),
            _ => return None,
        };
        let (second, feature) = self.first_hit(world, along).filter(|(hit, _)| hit.num == 0)?;
        let mut both = self.planes;
        both.push(entry.normal, Bend::Flat);
        both.push(second.normal, Bend::Flat);
        if !both.slide::<B, W>(self.before_planes).is_zero() {
            return None;
        }
        let other = self.first_hit(world, across).is_some_and(|(hit, _)| hit.num == 0);
        (!other).then_some((Entry { normal, ..*entry }, feature))
    }
}
