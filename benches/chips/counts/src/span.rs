//! Mean and range of counts.

use core::fmt;

/// Mean and range, printed with one decimal digit.
pub struct Span {
    n: u32,
    sum: u64,
    min: u32,
    max: u32,
}

impl Span {
    pub const EMPTY: Self = Self { n: 0, sum: 0, min: u32::MAX, max: 0 };

    pub fn add(&mut self, count: u32) {
        self.n += 1;
        self.sum += u64::from(count);
        self.min = self.min.min(count);
        self.max = self.max.max(count);
    }

    pub fn len(&self) -> u32 {
        self.n
    }

    pub fn is_empty(&self) -> bool {
        self.n == 0
    }
}

impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let n = u64::from(self.n.max(1));
        let tenths = (self.sum * 10 + n / 2) / n;
        write!(f, "{}.{} ({}..{})", tenths / 10, tenths % 10, self.min, self.max)
    }
}
