//! What a step notes of a round body that touches boxes.

/// How a round body meets boxes at the start of a step: bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AtBoxes(pub(super) u8);

impl AtBoxes {
    pub(super) const NONE: Self = Self(0);
    pub(super) const SIDE: u8 = 1;
    pub(super) const CORNER: u8 = 2;
    /// The way straight out leads out of all corners, too: they do not count.
    pub(super) const FLUSH: u8 = 4;
}
