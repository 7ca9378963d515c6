//! A small random number generator with the same numbers on every machine.

/// Marsaglia's xorshift with 32 bits of state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rng(u32);

impl Rng {
    pub(super) fn new(seed: u32) -> Self {
        // Spreads small seeds over all bits. xorshift must not start from 0.
        let state = seed.wrapping_add(6).wrapping_mul(0x9e37_79b9) ^ 0x5851_f42d;
        let mut rng = Self(if state == 0 { 1 } else { state });
        for _ in 0..8 {
            rng.next();
        }
        rng
    }

    pub(super) fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// A number from 0 to `n - 1`; 0 when `n` is 0.
    pub(super) fn below(&mut self, n: u32) -> u32 {
        ((u64::from(self.next()) * u64::from(n)) >> 32) as u32
    }

    /// A number from `-n` to `n`, for `n` in 0..2^30.
    pub(super) fn within(&mut self, n: i32) -> i32 {
        self.below(n.unsigned_abs() * 2 + 1) as i32 - n
    }

    /// True once in `n` times.
    pub(super) fn once_in(&mut self, n: u32) -> bool {
        self.below(n) == 0
    }
}
