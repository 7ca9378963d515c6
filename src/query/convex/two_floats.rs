//! Two floats, which the compiler keeps in one register: for 64-bit processors.

use crate::num::Raw;

#[derive(Clone, Copy)]
pub(super) struct TwoFloats(pub(super) [f64; 2]);

#[expect(clippy::float_arithmetic, reason = "errors are bounded where results are compared")]
impl TwoFloats {
    #[inline(always)]
    pub(super) fn of(v: Raw) -> Self {
        Self([f64::from(v.x), f64::from(v.y)])
    }

    #[inline(always)]
    pub(super) const fn both(x: f64) -> Self {
        Self([x, x])
    }

    #[inline(always)]
    pub(super) fn add(self, Self([x, y]): Self) -> Self {
        Self([self.0[0] + x, self.0[1] + y])
    }

    #[inline(always)]
    pub(super) fn sub(self, Self([x, y]): Self) -> Self {
        Self([self.0[0] - x, self.0[1] - y])
    }

    #[inline(always)]
    pub(super) fn times(self, Self([x, y]): Self) -> Self {
        Self([self.0[0] * x, self.0[1] * y])
    }

    #[inline(always)]
    pub(super) fn over(self, Self([x, y]): Self) -> Self {
        Self([self.0[0] / x, self.0[1] / y])
    }

    #[inline(always)]
    pub(super) const fn size(self) -> Self {
        Self([self.0[0].abs(), self.0[1].abs()])
    }

    /// Zero where it is negative.
    #[inline(always)]
    pub(super) fn positive(self) -> Self {
        let [x, y] = self.0;
        Self([if x > 0.0 { x } else { 0.0 }, if y > 0.0 { y } else { 0.0 }])
    }

    /// Negated where the other one is negative.
    #[inline(always)]
    pub(super) const fn signed_by(self, sign: Self) -> Self {
        const SIGN: u64 = 1 << 63;
        let ([x, y], [s, t]) = (self.0, sign.0);
        Self([f64::from_bits(x.to_bits() ^ (s.to_bits() & SIGN)), f64::from_bits(y.to_bits() ^ (t.to_bits() & SIGN))])
    }

    #[inline(always)]
    pub(super) const fn reversed(self) -> Self {
        Self([-self.0[0], -self.0[1]])
    }

    #[inline(always)]
    pub(super) fn cross(self, Self([x, y]): Self) -> f64 {
        self.0[0] * y - self.0[1] * x
    }

    #[inline(always)]
    pub(super) fn dot(self, Self([x, y]): Self) -> f64 {
        self.0[0] * x + self.0[1] * y
    }

    /// The cross products of two vectors with a third one.
    #[inline(always)]
    pub(super) fn crosses([e, f]: [Self; 2], g: Self) -> Self {
        Self([e.cross(g), f.cross(g)])
    }

    #[inline(always)]
    pub(super) fn dots([e, f]: [Self; 2], g: Self) -> Self {
        Self([e.dot(g), f.dot(g)])
    }

    #[inline(always)]
    pub(super) const fn least(self) -> f64 {
        let [x, y] = self.0;
        if x < y { x } else { y }
    }

    #[inline(always)]
    pub(super) const fn most(self) -> f64 {
        let [x, y] = self.0;
        if x > y { x } else { y }
    }

    /// The larger one of each two.
    #[inline(always)]
    pub(super) const fn greater(self, o: Self) -> Self {
        Self([Self([self.0[0], o.0[0]]).most(), Self([self.0[1], o.0[1]]).most()])
    }

    /// The smaller one of each two.
    #[inline(always)]
    pub(super) const fn less(self, o: Self) -> Self {
        Self([Self([self.0[0], o.0[0]]).least(), Self([self.0[1], o.0[1]]).least()])
    }
}
