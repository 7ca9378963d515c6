//! The keys.

use crate::register::read16;

const KEYINPUT: u32 = 0x0400_0130;

/// The keys that are down.
#[derive(Clone, Copy, Debug)]
pub struct Pad(u16);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    A = 0,
    B = 1,
    Select = 2,
    Start = 3,
    Right = 4,
    Left = 5,
    Up = 6,
    Down = 7,
    R = 8,
    L = 9,
}

impl Pad {
    /// The current state.
    #[must_use]
    pub fn read() -> Self {
        Self(!read16(KEYINPUT))
    }

    #[must_use]
    pub fn is_down(self, key: Key) -> bool {
        self.0 >> key as u16 & 1 != 0
    }
}
