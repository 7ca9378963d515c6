//! How far a body has come since it rests.

use crate::num::Vec2;

/// A displacement of up to a unit on each axis, in steps of 32 raw.
///
/// Coarser steps do not do: of 512 raw a fast fall has many and a slow rise none, and a body in a
/// heap that hops on one spot would seem to drift. Two times 12 bits leave a slot of a snapshot at
/// 88 bytes, and so a snapshot of 64 bodies below 8 KB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Drift([u8; 3]);

impl Drift {
    pub(super) const NONE: Self = Self([0; 3]);

    /// The longest displacement that is distinguished from longer ones.
    const MOST: i32 = (1 << 11) - 1;

    fn steps(self) -> (i32, i32) {
        let Self([a, b, c]) = self;
        let bits = u32::from_le_bytes([a, b, c, 0]);
        ((bits << 20) as i32 >> 20, (bits << 8) as i32 >> 20)
    }

    fn of(x: i32, y: i32) -> Self {
        let bits = |c: i32| c.clamp(-Self::MOST, Self::MOST) as u32 & 0xfff;
        let [a, b, c, _] = (bits(x) | bits(y) << 12).to_le_bytes();
        Self([a, b, c])
    }

    pub(super) fn plus(self, by: Vec2) -> Self {
        let ((x, y), (dx, dy)) = (self.steps(), by.raw());
        Self::of(x.saturating_add(dx / 32), y.saturating_add(dy / 32))
    }

    /// Takes back a displacement that was added, unless that led too far.
    pub(super) fn minus(self, by: Vec2) -> Self {
        let ((x, y), (dx, dy)) = (self.steps(), by.raw());
        Self::of(x.saturating_sub(dx / 32), y.saturating_sub(dy / 32))
    }

    /// Whether it is at most this long on both axes, in raw units.
    pub(super) fn is_within(self, raw: u32) -> bool {
        let (x, y) = self.steps();
        let most = (raw >> 5).min(Self::MOST as u32 - 1);
        x.unsigned_abs().max(y.unsigned_abs()) <= most
    }
}
