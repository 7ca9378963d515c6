//! The keys that a player holds in a frame: one byte. Machines exchange nothing else.

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

/// The script of a player, who holds keys for at least a third of a second.
pub fn script(player: usize, frame: u32) -> Keys {
    // The players change their keys at different times.
    let time = frame + 11 * player as u32;
    let whim = mix(u64::from(time / 20) << 1 | player as u64);
    // Some keys are held twice as long, as a rest.
    Keys(if whim & 8 == 0 { 0 } else { whim as u8 & 7 })
}

/// A number that looks random and depends only on another one.
pub(super) const fn mix(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}
