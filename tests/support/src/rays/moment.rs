//! Moments of a motion, exactly: fractions, and quadratic irrationals compared by squaring.

use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

/// `(p + s sqrt(root)) / q`, with q > 0 and root >= 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Moment {
    p: BigInt,
    s: BigInt,
    root: BigInt,
    q: BigInt,
}

fn signum(v: &BigInt) -> i32 {
    match v.sign() {
        Sign::Minus => -1,
        Sign::NoSign => 0,
        Sign::Plus => 1,
    }
}

/// The sign of `a + b sqrt(c)`.
fn sign_of_one(a: &BigInt, b: &BigInt, c: &BigInt) -> i32 {
    let (first, second) = (signum(a), signum(b) * signum(c));
    if first == second || second == 0 {
        return first;
    }
    if first == 0 {
        return second;
    }
    // Of opposite signs: the larger square wins.
    first * signum(&(a * a - b * b * c))
}

/// The sign of `a + b sqrt(c) + e sqrt(f)`.
fn sign_of_two(a: &BigInt, b: &BigInt, c: &BigInt, e: &BigInt, f: &BigInt) -> i32 {
    let (first, second) = (sign_of_one(a, b, c), signum(e) * signum(f));
    if first == second || second == 0 {
        return first;
    }
    if first == 0 {
        return second;
    }
    first * sign_of_one(&(a * a + b * b * c - e * e * f), &(a * b * 2), c)
}

impl Moment {
    pub fn fraction(num: i128, den: i128) -> Self {
        assert!(den > 0);
        Self { p: num.into(), s: 0.into(), root: 0.into(), q: den.into() }
    }

    /// `(p + s sqrt(root)) / q`.
    pub fn quadratic(p: i128, s: i128, root: BigInt, q: i128) -> Self {
        assert!(q > 0 && root.sign() != Sign::Minus);
        Self { p: p.into(), s: s.into(), root, q: q.into() }
    }

    /// The sign of `u + d t` at this moment t.
    pub fn sign_at(&self, u: i64, d: i64) -> i32 {
        sign_of_one(&(&self.p * d + &self.q * u), &(&self.s * d), &self.root)
    }

    pub fn is_zero(&self) -> bool {
        self.sign_at(0, 1) == 0
    }

    /// The floor of `size t`, for t from 0 to 1.
    pub fn floor_of(&self, size: i64) -> i64 {
        let (mut low, mut high) = (0, size);
        while low < high {
            let middle = (low + high + 1) / 2;
            if self.sign_at(-middle, size) >= 0 { low = middle } else { high = middle - 1 }
        }
        low
    }
}

impl PartialOrd for Moment {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Moment {
    fn cmp(&self, other: &Self) -> Ordering {
        let a = &self.p * &other.q - &other.p * &self.q;
        let (b, e) = (&self.s * &other.q, -(&other.s * &self.q));
        sign_of_two(&a, &b, &self.root, &e, &other.root).cmp(&0)
    }
}
