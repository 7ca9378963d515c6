//! The hash of a family, and how plain values enter it.

use core::fmt;

/// 32 bits over a stream of 32-bit words.
///
/// A step is a bijection of the state for each word and of the word for each state, so one word
/// that changes always changes the hash. A word costs a rotation, an exclusive or and a
/// multiplication on every core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hash(u32);

impl Hash {
    pub const fn new() -> Self {
        Self(0x811c_9dc5)
    }

    pub const fn word(&mut self, word: u32) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b1);
    }

    pub fn add(&mut self, value: impl Encode) {
        value.encode(self);
    }

    pub const fn value(self) -> u32 {
        self.0
    }
}

impl From<u32> for Hash {
    fn from(state: u32) -> Self {
        Self(state)
    }
}

impl fmt::Display for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:08x}", self.0)
    }
}

/// A value as words in a fixed order: all of its fields, and for a choice first a number for the
/// variant. It uses mostly the public interface of a type, so it hashes what a game can see.
pub trait Encode {
    fn encode(self, hash: &mut Hash);
}

/// Values that fit a word.
macro_rules! words {
    ($($small:ty),+) => {
        $(impl Encode for $small {
            #[inline]
            fn encode(self, hash: &mut Hash) {
                hash.word(self as u32);
            }
        })+
    };
}
words!(bool, u8, u16, u32, i32, usize);

impl Encode for i16 {
    fn encode(self, hash: &mut Hash) {
        hash.word(i32::from(self) as u32);
    }
}

impl Encode for u64 {
    #[inline]
    fn encode(self, hash: &mut Hash) {
        hash.word(self as u32);
        hash.word((self >> 32) as u32);
    }
}

impl Encode for i64 {
    #[inline]
    fn encode(self, hash: &mut Hash) {
        (self as u64).encode(hash);
    }
}

impl Encode for () {
    fn encode(self, _: &mut Hash) {}
}

impl<A: Encode, B: Encode> Encode for (A, B) {
    #[inline]
    fn encode(self, hash: &mut Hash) {
        self.0.encode(hash);
        self.1.encode(hash);
    }
}

impl<T: Encode, const N: usize> Encode for [T; N] {
    #[inline]
    fn encode(self, hash: &mut Hash) {
        for value in self {
            value.encode(hash);
        }
    }
}

impl<T: Encode> Encode for Option<T> {
    #[inline]
    fn encode(self, hash: &mut Hash) {
        hash.word(u32::from(self.is_some()));
        if let Some(value) = self {
            value.encode(hash);
        }
    }
}

impl<T: Encode, E: Encode> Encode for Result<T, E> {
    #[inline]
    fn encode(self, hash: &mut Hash) {
        hash.word(u32::from(self.is_ok()));
        match self {
            Ok(value) => value.encode(hash),
            Err(error) => error.encode(hash),
        }
    }
}
