//! An independent judge of motion: levels as plain cells, bodies as plain integers, and the exact
//! answer to "when does this motion first start to overlap the solid".
//!
//! It shares no code with the library. A level is the union of its full cells. It judges a motion
//! cell by cell, in 128-bit integers.

pub mod body;
pub mod disc;
pub mod judge;
pub mod level;
pub mod path;
pub mod point;
pub mod rect;
pub mod scene;
pub mod ways;

/// A pair of raw coordinates.
pub type P = (i64, i64);

pub fn add(a: P, b: P) -> P {
    (a.0 + b.0, a.1 + b.1)
}

pub fn dot(a: P, b: P) -> i128 {
    i128::from(a.0) * i128::from(b.0) + i128::from(a.1) * i128::from(b.1)
}

pub fn len2(a: P) -> i128 {
    dot(a, a)
}

/// A moment `num / den` of a motion, `den > 0`.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    pub num: i64,
    pub den: i64,
}

impl Time {
    pub const START: Self = Self { num: 0, den: 1 };
    pub const END: Self = Self { num: 1, den: 1 };

    /// `a / b` for any `b` but zero.
    pub fn new(a: i64, b: i64) -> Self {
        if b < 0 { Self { num: -a, den: -b } } else { Self { num: a, den: b } }
    }

    /// Of parts in 2^30.
    pub fn parts(raw: u32) -> Self {
        Self { num: i64::from(raw), den: 1 << 30 }
    }

    /// In parts of 2^30, rounded down.
    pub fn floor(self) -> i64 {
        ((i128::from(self.num) << 30).div_euclid(i128::from(self.den))) as i64
    }

    /// The displacement so far of a motion, rounded toward the start.
    pub fn part_of(self, d: P) -> P {
        let part = |d: i64| (i128::from(d) * i128::from(self.num) / i128::from(self.den)) as i64;
        (part(d.0), part(d.1))
    }
}

impl PartialEq for Time {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Time {}

impl PartialOrd for Time {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Time {
    fn cmp(&self, other: &Self) -> core::cmp::Ordering {
        (i128::from(self.num) * i128::from(other.den)).cmp(&(i128::from(other.num) * i128::from(self.den)))
    }
}
