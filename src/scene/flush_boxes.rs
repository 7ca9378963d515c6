//! Round bodies on flush boxes.
//!
//! Gravity sinks a ball into the box below it and, near a seam, into the corner of the next box.
//! That contact is slanted: if it counted, each seam would slow the ball down. But the push
//! straight out of the box below leads out of the next one, too. So its corner does not count. A
//! corner that sticks out, or that has no box beside it, still overlaps the ball after that push.

use super::at_boxes::AtBoxes;
use super::body::Slot;
use super::farthest_pushes::FarthestPushes;
use super::kernel::BodyShape;
use crate::num::{Axis, Vec2};

/// Whether the pushes straight out of boxes lead a round shape out of another box. Exact: flush
/// boxes need no tolerance.
pub(super) fn clears<S: BodyShape>(out: FarthestPushes, round: &S, other: &S) -> bool {
    let by = out.sum();
    by != Vec2::ZERO && round.translated(by).is_ok_and(|moved| moved.contact(other).is_none())
}

/// Whether one body rolls, and the other is a box.
pub(super) fn rolls_on<S: BodyShape>(one: &Slot<S>, other: &Slot<S>) -> bool {
    one.body.mass.is_some() && one.body.shape.is_round() && !other.body.shape.is_round()
}

/// Whether a surface is slanted. Where a round body meets a box, it then meets a corner.
pub(super) fn is_slanted(axis: Axis) -> bool {
    axis.x != 0 && axis.y != 0
}

/// Whether a contact does not count, because it is at a corner of flush boxes.
pub(super) fn is_flush<S: BodyShape>(a: &Slot<S>, b: &Slot<S>, axis: Axis) -> bool {
    let flush = |one: &Slot<S>, other: &Slot<S>| one.tally.at_boxes.0 == AtBoxes::FLUSH && rolls_on(one, other);
    is_slanted(axis) && (flush(a, b) || flush(b, a))
}
