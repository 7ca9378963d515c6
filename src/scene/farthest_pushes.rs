//! The pushes on a body that count: of all to one side, only the farthest.

use crate::num::Vec2;

/// The farthest push to each side. Two floors push a body no higher than one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FarthestPushes {
    pub(super) low: Vec2,
    pub(super) high: Vec2,
}

impl FarthestPushes {
    pub(super) const NONE: Self = Self { low: Vec2::ZERO, high: Vec2::ZERO };

    pub(super) fn add(&mut self, by: Vec2) {
        (self.low, self.high) = (self.low.min(by), self.high.max(by));
    }

    pub(super) fn sum(self) -> Vec2 {
        self.low + self.high
    }
}
