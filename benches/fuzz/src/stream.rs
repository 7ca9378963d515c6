//! The fuzzer's bytes as the stream of choices that the tests' generators take.
//!
//! Each choice takes as few bytes as its range needs, low bytes first, so that a changed byte changes one choice and a small change of it is a
//! small change of the case. After the last byte the stream goes on pseudo-randomly, by a seed made of all bytes: generators that try
//! again until something fits come to an end, and the same bytes are the same case.

use std::cell::RefCell;

struct Stream {
    bytes: Vec<u8>,
    at: usize,
    rest: u64,
}

thread_local! {
    static STREAM: RefCell<Stream> = const { RefCell::new(Stream { bytes: Vec::new(), at: 0, rest: 0 }) };
}

/// A handle to the thread's stream; all of them read on where the last one stopped. Its name and methods are those of the tests' generator.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Random(());

impl Random {
    /// The stream of these bytes, from their beginning.
    pub(crate) fn of(bytes: &[u8]) -> Self {
        // FNV-1a.
        let rest =
            bytes.iter().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3));
        STREAM.with_borrow_mut(|stream| *stream = Stream { bytes: bytes.to_vec(), at: 0, rest });
        Self(())
    }

    /// Where a test would begin a sequence of its own.
    pub(crate) fn new(_: u64) -> Self {
        Self(())
    }

    /// Whether there are bytes left.
    pub(crate) fn is_left() -> bool {
        STREAM.with_borrow(|stream| stream.at < stream.bytes.len())
    }

    fn take(count: usize) -> u64 {
        STREAM.with_borrow_mut(|stream| {
            (0..count).fold(0, |word, i| {
                let byte = stream.bytes.get(stream.at).copied().unwrap_or_else(|| {
                    stream.rest = stream.rest.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
                    (stream.rest >> 56) as u8
                });
                stream.at += 1;
                word | u64::from(byte) << (8 * i)
            })
        })
    }

    pub(crate) fn next(&mut self) -> u64 {
        Self::take(8)
    }

    pub(crate) fn below(&mut self, n: i64) -> i64 {
        match n {
            ..=1 => 0,
            2..=0x100 => Self::take(1) as i64 % n,
            0x101..=0x1_0000 => Self::take(2) as i64 % n,
            0x1_0001..=0x1_0000_0000 => Self::take(4) as i64 % n,
            _ => (Self::take(8) % n as u64) as i64,
        }
    }

    pub(crate) fn within(&mut self, low: i64, high: i64) -> i64 {
        low + self.below(high - low + 1)
    }

    /// 0, -1, 1, -2, 2 ...
    pub(crate) fn around(&mut self, n: i64) -> i64 {
        let k = self.below(2 * n + 1);
        (k >> 1) ^ -(k & 1)
    }

    pub(crate) fn one_in(&mut self, n: i64) -> bool {
        self.below(n) == 0
    }

    pub(crate) fn sign(&mut self) -> i64 {
        if self.one_in(2) { 1 } else { -1 }
    }

    pub(crate) fn magnitude(&mut self, n: i64) -> i64 {
        let bits = i64::from(64 - n.leading_zeros());
        let cap = (1i64 << self.below(bits + 1)).min(n);
        self.within(0, cap)
    }
}
