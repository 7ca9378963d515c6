//! How a body goes on along a quarter pipe.

use super::plane::{across, into, tangent, tangential};
use super::response::Law;
use crate::num::{Axis, Raw, Toi, div_sqrt, isqrt64_ceil, mul_div, umul};

/// A point that has met a concave arc from inside.
pub(super) struct Pipe {
    /// The point as seen from the centre.
    pub(super) m: Raw,
    /// What it must not be farther than.
    pub(super) r: i32,
    pub(super) quadrant: Axis,
}

/// A straight way inside of a pipe, from rim to rim.
pub(super) struct Chord {
    pub(super) way: Raw,
    /// Along the pipe at the end of the way.
    pub(super) velocity: Raw,
    /// The part of the time that is left there.
    pub(super) after: Toi,
}

impl Pipe {
    /// The way of a body of velocity `v` in the time `rest`; none where it is pressed straight into the pipe.
    ///
    /// Its end is the end of the way along the tangent, drawn to the disc, which brings nothing farther apart; not beyond the
    /// end of the arc, where the time that the chord takes decides what is left. The speed along the pipe stays what it is, less a few raw and what friction takes.
    pub(super) fn chord<S: Law>(&self, v: Raw, rest: Toi, surface: &S) -> Option<Chord> {
        let n = inward(self.m);
        let along = across(v, n);
        let along = if S::SMOOTH { along } else { surface.surface().rub(along, into(v, n)) };
        if along == 0 {
            return None;
        }
        let (speed, against) = (tangential(along, n), along < 0);
        let leg = tangent(speed, n, against);
        let far = self.m.add(Raw { x: rest.of_raw(leg.x), y: rest.of_raw(leg.y) });
        let (beyond_y, beyond_x) = (far.x.wrapping_mul(self.quadrant.x) < 0, far.y.wrapping_mul(self.quadrant.y) < 0);
        let end = if beyond_y {
            Raw { x: 0, y: self.r.wrapping_mul(self.quadrant.y) }
        } else if beyond_x {
            Raw { x: self.r.wrapping_mul(self.quadrant.x), y: 0 }
        } else {
            self.drawn_in(far)
        };
        let way = end.sub(self.m);
        let after = if beyond_x || beyond_y {
            let time = mul_div(isqrt64_ceil(way.len2()), Toi::ONE.raw(), speed).saturating_add(1);
            Toi::clamped(rest.raw().saturating_sub(time))
        } else {
            Toi::ZERO
        };
        let speed = if S::SMOOTH { speed } else { surface.surface().turned(speed, way, self.r) };
        let velocity = tangent(speed, inward(end), against);
        (velocity.len2() <= v.len2()).then_some(Chord { way, velocity, after })
    }

    /// The nearest point of the disc, each component rounded toward the centre.
    fn drawn_in(&self, m: Raw) -> Raw {
        let square = m.len2();
        let r = self.r.unsigned_abs();
        if square <= umul(r, r) {
            return m;
        }
        let part = |c: i32| {
            let size = div_sqrt(umul(c.unsigned_abs(), r), square) as i32;
            if c < 0 { size.wrapping_neg() } else { size }
        };
        Raw { x: part(m.x), y: part(m.y) }
    }
}

fn inward(m: Raw) -> Axis {
    Axis::new(m.x.wrapping_neg(), m.y.wrapping_neg())
}
