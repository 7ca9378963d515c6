//! Seeded pseudo-random numbers (`SplitMix64`), so that a failure is found again by its seed.

#[derive(Clone, Copy, Debug)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `0..n`; the bias of the high product is below 2^-32 for the `n` used here.
    pub(crate) const fn below(&mut self, n: i64) -> i64 {
        ((self.next() as u128 * n as u128) >> 64) as i64
    }

    /// Uniform in `low..=high`.
    pub(crate) const fn within(&mut self, low: i64, high: i64) -> i64 {
        low + self.below(high - low + 1)
    }

    /// Uniform in `-n..=n`.
    pub(crate) const fn around(&mut self, n: i64) -> i64 {
        self.within(-n, n)
    }

    /// True once in `n` times.
    pub(crate) const fn one_in(&mut self, n: i64) -> bool {
        self.below(n) == 0
    }

    pub(crate) const fn sign(&mut self) -> i64 {
        if self.one_in(2) { 1 } else { -1 }
    }

    /// Every magnitude up to `n` equally likely: lengths of one raw unit and of the whole domain in one stream.
    pub(crate) fn magnitude(&mut self, n: i64) -> i64 {
        let bits = i64::from(64 - n.leading_zeros());
        let cap = (1i64 << self.below(bits + 1)).min(n);
        self.within(0, cap)
    }
}
