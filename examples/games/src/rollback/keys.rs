//! What a player holds down in a frame: one byte, and all that two machines have to exchange.

/// The keys of one player in one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keys(pub u8);

impl Keys {
    pub const LEFT: Self = Self(1);
    pub const RIGHT: Self = Self(2);
    pub const JUMP: Self = Self(4);

    pub const fn holds(self, key: Self) -> bool {
        self.0 & key.0 != 0
    }
}

/// What a player does: keys are held for a third of a second or longer.
pub fn script(player: usize, frame: u32) -> Keys {
    // Both players change their minds at different times.
    let time = frame + 11 * player as u32;
    let whim = mix(u64::from(time / 20) << 1 | player as u64);
    // Some are held twice as long, as a rest is.
    Keys(if whim & 8 == 0 { 0 } else { whim as u8 & 7 })
}

/// A number that looks random and depends on another one alone.
pub(super) const fn mix(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}
