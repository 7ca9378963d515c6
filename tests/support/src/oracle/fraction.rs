//! Fractions of big integers that are never reduced. For numbers of a few operations, finding
//! common divisors costs more than carrying them.

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Sub};

/// `num / den` with `den > 0`.
#[derive(Clone, Debug)]
pub struct Fraction {
    num: BigInt,
    den: BigInt,
}

impl Fraction {
    pub fn whole(n: i64) -> Self {
        Self { num: n.into(), den: 1.into() }
    }

    pub fn reduced(self) -> BigRational {
        BigRational::new(self.num, self.den)
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Fraction {}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Fraction {
    fn cmp(&self, other: &Self) -> Ordering {
        (&self.num * &other.den).cmp(&(&other.num * &self.den))
    }
}

/// One operation of two fractions, each given away or lent.
macro_rules! operation {
    ($trait:ident $name:ident: |$a:ident, $b:ident| $result:expr) => {
        impl $trait<&Fraction> for &Fraction {
            type Output = Fraction;
            fn $name(self, other: &Fraction) -> Fraction {
                let ($a, $b) = (self, other);
                $result
            }
        }

        impl $trait<Fraction> for &Fraction {
            type Output = Fraction;
            fn $name(self, other: Fraction) -> Fraction {
                self.$name(&other)
            }
        }

        impl $trait<&Fraction> for Fraction {
            type Output = Fraction;
            fn $name(self, other: &Fraction) -> Fraction {
                (&self).$name(other)
            }
        }

        impl $trait for Fraction {
            type Output = Fraction;
            fn $name(self, other: Fraction) -> Fraction {
                (&self).$name(&other)
            }
        }
    };
}

operation!(Add add: |a, b| if a.den == b.den {
    Fraction { num: &a.num + &b.num, den: a.den.clone() }
} else {
    Fraction { num: &a.num * &b.den + &b.num * &a.den, den: &a.den * &b.den }
});
operation!(Sub sub: |a, b| if a.den == b.den {
    Fraction { num: &a.num - &b.num, den: a.den.clone() }
} else {
    Fraction { num: &a.num * &b.den - &b.num * &a.den, den: &a.den * &b.den }
});
operation!(Mul mul: |a, b| Fraction { num: &a.num * &b.num, den: &a.den * &b.den });
operation!(Div div: |a, b| {
    assert!(b.num.sign() != Sign::NoSign, "a fraction over zero");
    let (num, den) = (&a.num * &b.den, &a.den * &b.num);
    if den.sign() == Sign::Minus { Fraction { num: -num, den: -den } } else { Fraction { num, den } }
});
