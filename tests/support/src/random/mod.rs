//! The only generator of choices: seeded pseudo-random numbers, or bytes that steer every choice.
//!
//! Its seed reproduces a seeded failure, and its bytes a steered one.

mod bytes;

/// A stream of choices.
///
/// Seeded generators (`SplitMix64`) are independent of each other. A steered one is a handle to the
/// bytes of its thread. Copies of it, and every generator that this thread makes afterwards,
/// continue where the last one stopped.
#[derive(Clone, Copy, Debug)]
pub struct Random(Source);

#[derive(Clone, Copy, Debug)]
enum Source {
    Seed(u64),
    Bytes,
}

impl Random {
    /// The generator of a seed. If bytes [steer](Self::steered) this thread, the next part of the
    /// bytes.
    pub fn new(seed: u64) -> Self {
        Self(if bytes::steer() { Source::Bytes } else { Source::Seed(seed) })
    }

    /// The choices that bytes encode, for everything that this thread chooses from now on.
    ///
    /// Each choice takes as few bytes as its range needs, low bytes first. So a changed byte
    /// changes one choice, and a small change of it is a small change of the case. After the last
    /// byte the choices continue pseudo-randomly, with a seed made of all bytes. So generators that
    /// retry until something fits end, and the same bytes are the same case.
    pub fn steered(bytes: &[u8]) -> Self {
        bytes::start(bytes);
        Self(Source::Bytes)
    }

    /// Whether this thread is steered and has bytes left.
    pub fn is_left() -> bool {
        bytes::steer() && bytes::is_left()
    }

    #[allow(clippy::should_implement_trait, reason = "it never ends, and is no iterator")]
    pub fn next(&mut self) -> u64 {
        match &mut self.0 {
            Source::Seed(state) => split_mix(state),
            Source::Bytes => bytes::take(8),
        }
    }

    /// Uniform in `0..n`; the bias of the seeded high product is below 2^-32 for the `n` used here.
    pub fn below(&mut self, n: i64) -> i64 {
        match &mut self.0 {
            Source::Seed(state) => ((split_mix(state) as u128 * n as u128) >> 64) as i64,
            Source::Bytes => bytes::below(n),
        }
    }

    /// Uniform in `low..=high`.
    pub fn within(&mut self, low: i64, high: i64) -> i64 {
        low + self.below(high - low + 1)
    }

    /// Uniform in `-n..=n`.
    pub fn around(&mut self, n: i64) -> i64 {
        match self.0 {
            Source::Seed(_) => self.within(-n, n),
            // 0, -1, 1, -2, 2 ...: small bytes are small numbers.
            Source::Bytes => {
                let k = self.below(2 * n + 1);
                (k >> 1) ^ -(k & 1)
            }
        }
    }

    /// True once in `n` times.
    pub fn one_in(&mut self, n: i64) -> bool {
        self.below(n) == 0
    }

    /// Puts a list into a uniformly chosen order.
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.below(i as i64 + 1) as usize);
        }
    }

    pub fn sign(&mut self) -> i64 {
        if self.one_in(2) { 1 } else { -1 }
    }

    /// Every magnitude up to `n` equally likely: lengths of one raw unit and of the whole domain in
    /// one stream.
    pub fn magnitude(&mut self, n: i64) -> i64 {
        let bits = i64::from(64 - n.leading_zeros());
        let cap = (1i64 << self.below(bits + 1)).min(n);
        self.within(0, cap)
    }
}

fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
