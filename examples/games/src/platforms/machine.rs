//! Machines that move by themselves, in the game's order.

use tilesat::Vec2;

/// A machine's box in pixels, how far it moves down or up (negative) and back at a pixel per frame,
/// and how long it rests at both ends.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    pub at: [i16; 4],
    pub way: i16,
    rest: u32,
}

pub const LIFT: Machine = Machine { at: [544, 208, 592, 216], way: -96, rest: 60 };
pub const CRUSHER: Machine = Machine { at: [448, 144, 480, 184], way: 20, rest: 56 };
pub const SHELF: Machine = Machine { at: [704, 96, 752, 102], way: -64, rest: 40 };
pub(super) const BELT: Machine = Machine { at: [272, 208, 368, 216], way: 0, rest: 1 };

pub const MACHINES: [Machine; 4] = [LIFT, CRUSHER, SHELF, BELT];

impl Machine {
    /// Whether it is on its way back in this frame, and since which frame it moves or rests.
    pub(super) fn phase(&self, frame: u32) -> (bool, u32) {
        let half = u32::from(self.way.unsigned_abs()) + self.rest;
        (frame / half % 2 == 1, frame % half)
    }

    pub(super) fn motion(&self, frame: u32) -> Vec2 {
        let (back, time) = self.phase(frame);
        let goes = time < u32::from(self.way.unsigned_abs());
        Vec2::from_ints(0, if goes { self.way.signum() * if back { -1 } else { 1 } } else { 0 })
    }
}
