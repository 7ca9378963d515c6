//! A way on from a position: a velocity, or its projection on a surface that the body touches. It
//! knows how far it leads before a surface binds it.

use super::body::{Body, Entry, by_size};
use super::contact::{Bend, Plane, touched};
use super::plane::{FAR, NEAR, across, into, part, rounding, way};
use crate::num::{Axis, Raw, cmp_squares, mul_div};
use crate::query::cast::side::{along, is_below, reach};
use crate::world::{Feature, Geometry, World, ends, normal};
use core::cmp::Ordering;

/// A way on.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(super) struct FreeWay {
    /// The plane that it is along; `None` for the velocity itself.
    pub(super) along: Option<Plane>,
    /// The velocity at its start.
    pub(super) v: Raw,
    /// A displacement in its direction, long enough to find what blocks it.
    probe: Raw,
    /// Whether the projected velocity leads into the plane. Behind the words, as in a
    /// [`Hit`](super::Hit).
    presses: bool,
    /// How far it leads before a surface binds it: up to [`FAR`], [`FREE`](Self::FREE), or
    /// [`UNKNOWN`](Self::UNKNOWN).
    room: u8,
}

impl FreeWay {
    const FREE: u8 = u8::MAX;
    const UNKNOWN: u8 = u8::MAX - 1;

    pub(super) const fn of(along: Option<Plane>, v: Raw, probe: Raw, presses: bool) -> Self {
        Self { along, v, probe, presses, room: Self::UNKNOWN }
    }

    pub(super) fn is_free(&self) -> bool {
        self.room == Self::FREE
    }

    pub(super) fn is_settled(&self) -> bool {
        self.room != Self::UNKNOWN
    }

    /// Frees it, until something [binds](Self::bind_by) it.
    pub(super) fn free(&mut self) {
        self.room = Self::FREE;
    }

    /// Whether it leads on by at least a raw unit, though it is bound.
    pub(super) fn can_creep(&self) -> bool {
        self.room > 0 && u32::from(self.room) <= FAR
    }

    pub(super) fn probe(&self) -> Raw {
        self.probe
    }

    /// Binds it if it leads into a feature.
    pub(super) fn bind_by<W: World, B: Body>(&mut self, body: &B, feature: &Feature) {
        // The face that a way is along is the most frequent one.
        let leaves = matches!(feature.geometry, Geometry::Face { dir, .. } if into(self.probe, normal(dir)) >= 0);
        if self.room == 0 || leaves {
            return;
        }
        if self.leads_into::<W, B>(body, feature) {
            self.room = 0;
            return;
        }
        let Some(entry) = &body.sweep_in::<W>(self.probe, feature) else { return };
        if let Some(room) = room_to(self.probe, entry) {
            self.room = self.room.min(room);
        }
    }

    /// Whether it leads into a touched surface, though its probe does not show that.
    ///
    /// The gap to a pipe opens with the square of the way. The pipe's normal shows it. Faces of the
    /// same side that differ by less than four degrees meet beyond [`FAR`].
    ///
    /// The body must touch the second face here and [`NEAR`] ahead, and be [before](faces) it.
    /// Before it touches that face, there is no way along it yet. If it is about to pass that
    /// face's end, nothing is in the way.
    fn leads_into<W: World, B: Body>(&self, body: &B, feature: &Feature) -> bool {
        let (is_face, ahead) = match feature.geometry {
            Geometry::Arc { convex: false, .. } if W::ROUND => (false, Raw::ZERO),
            Geometry::Face { a, dir, len, .. } if W::WIDE && self.is_beside(normal(dir)) => {
                if !faces(body, Raw::of(a), dir, len) {
                    return false;
                }
                (true, part(self.probe, NEAR, way(self.probe)))
            }
            _ => return false,
        };
        let mut at = Raw::ZERO;
        loop {
            let mut leads_in = false;
            touched::<W, B>(&body.shifted(at), feature, &mut |plane| {
                leads_in |= match plane.bend {
                    Bend::Flat => is_face,
                    Bend::Concave { .. } => W::ROUND && self.along != Some(plane) && plane.is_pipe_ahead(self.v),
                    Bend::End | Bend::Convex => false,
                };
            });
            if !leads_in || at == ahead {
                return leads_in;
            }
            at = ahead;
        }
    }

    /// Whether it is along a face of the same side as one with this normal.
    fn is_beside(&self, n: Axis) -> bool {
        let along = self.along.as_ref().filter(|plane| matches!(plane.bend, Bend::Flat | Bend::End));
        along.is_some_and(|plane| plane.normal.dot(n) > 0)
    }

    /// The length of its part of a velocity, before rounding: `along / |normal|`. Computed when
    /// needed, which makes a list of ten 160 bytes of stack shorter.
    fn length(&self, of: Raw) -> (u64, u64) {
        self.along.as_ref().map_or((u64::MAX, 1), |p| (across(of, p.normal).unsigned_abs(), p.normal.length_squared()))
    }

    /// Whether it is longer than another projection, if the rounded velocities show that. They
    /// differ from the lengths before rounding by less than 32 raw, see [`project`]. With `|v| <=
    /// |v.x| + |v.y|`, squares then need no root: `(|v| + 64)^2`.
    fn is_clearly_longer(&self, other: &Self) -> Option<bool> {
        let above = |v: Raw, square: u64| {
            let sum = u64::from(v.x.unsigned_abs()).wrapping_add(v.y.unsigned_abs().into());
            square.wrapping_add(sum << 7).wrapping_add(1 << 12)
        };
        let (a, b) = (self.v.len2(), other.v.len2());
        let longer = a > above(other.v, b);
        (longer || b > above(self.v, a)).then_some(longer)
    }

    /// The velocity itself comes first, then its longer projections. If lengths are equal, mirrored
    /// or not, the one longer along x comes first, then +. Then the planes decide in the same way.
    /// The order of visits never decides.
    pub(super) fn goes_before(&self, other: &Self, of: Raw) -> bool {
        let (Some(p), Some(q)) = (&self.along, &other.along) else { return self.along.is_none() };
        let (n, m) = (p.normal, q.normal);
        // Sides of a box and ends of faces often have a face's normal. Their lengths are equal.
        let lengths = if n == m || n == m.reversed() {
            Ordering::Equal
        } else if let Some(longer) = self.is_clearly_longer(other) {
            return longer;
        } else {
            let ((a, n), (b, m)) = (self.length(of), other.length(of));
            cmp_squares((a, m), (b, n))
        };
        // A plane that presses back goes first: it has the friction.
        lengths
            .then_with(|| by_size(Axis::new(self.v.x, self.v.y), Axis::new(other.v.x, other.v.y)))
            .then_with(|| self.presses.cmp(&other.presses))
            .then_with(|| by_size(n, m))
            .then_with(|| p.bend.rank().cmp(&q.bend.rank()))
            .is_gt()
    }
}

/// Whether a body is in front of a face and over it, to the rounding distance.
///
/// It also touches a face beside it: the top of a wall that is lower than itself, or a one-way face
/// that it is passing.
#[inline(never)]
fn faces<B: Body>(body: &B, a: Raw, dir: Axis, len: i32) -> bool {
    let n = normal(dir);
    let (p, r) = body.toward(n.reversed());
    let gap = along(n, p.sub(a)).wrapping_add(rounding(n) as i64);
    if gap < 0 || is_below(gap as u64, reach(r, dir)) {
        return false;
    }
    // Of a slope it touches only what it faces, and of a round body the middle decides.
    if r != 0 || (dir.x != 0 && dir.y != 0) {
        return true;
    }
    let (_, end) = ends(a, dir, len);
    let ((first, _), (last, _)) = (body.toward(dir.reversed()), body.toward(dir));
    along(dir, last.sub(a)) > 0 && along(dir, first.sub(end)) < 0
}

/// The way of a probe up to its hit, if that binds it. It does if the way is at most the rounding
/// distance. It does, too, if the way is at most [`FAR`] and the gap along the normal is at most
/// the rounding distance. The answer does not depend on how a face is cut.
pub(super) fn room_to(probe: Raw, entry: &Entry) -> Option<u8> {
    let room = mul_div(way(probe), entry.num, entry.den);
    let gap = into(part(probe, entry.num, entry.den), entry.normal).unsigned_abs();
    (room <= NEAR || (room <= FAR && gap <= rounding(entry.normal))).then_some(room as u8)
}

#[cfg(test)]
mod tests {
    use super::{FreeWay, Plane, across};
    use crate::motion::plane::project;
    use crate::motion::response::Smooth;
    use crate::num::{Axis, Raw};
    use crate::shape::Circle;
    use crate::world::{AllShapes, TileMap};
    use core::cmp::Ordering;
    use tilesat_judge::{Random, cases, enough};

    fn way(v: Raw, n: Axis) -> FreeWay {
        let v = project::<Circle, TileMap<'static, AllShapes>, _>(v, n, &Smooth);
        FreeWay::of(Some(Plane::flat(n)), v, v, false)
    }

    /// Rounded lengths never say the opposite of the exact ones. The second normal is often the
    /// first one, turned by little or mirrored.
    #[test]
    fn rounded_lengths_agree_with_exact_ones() {
        let (mut random, mut told) = (Random::new(17), 0u32);
        for _ in 0..cases(400_000) {
            let (speed, size) = (1 << random.within(1, 24), 1 << random.within(1, 17));
            let part = |random: &mut Random, most: i64| random.around(most) as i32;
            let v = Raw { x: part(&mut random, speed), y: part(&mut random, speed) };
            let n = Axis::new(part(&mut random, size), part(&mut random, size));
            let turned = [Axis::new(n.y, n.x), Axis::new(n.x.wrapping_add(1), n.y), Axis::new(-n.x, n.y)];
            let other = Axis::new(part(&mut random, size), part(&mut random, size));
            for m in turned.into_iter().chain([other]) {
                if n.is_zero() || m.is_zero() {
                    continue;
                }
                let (a, b) = (i128::from(across(v, n)), i128::from(across(v, m)));
                let square = |n: Axis| i128::from(n.length_squared());
                let exact = (a * a * square(m)).cmp(&(b * b * square(n)));
                let (one, two) = (way(v, n), way(v, m));
                if one.v.is_zero() || two.v.is_zero() {
                    continue;
                }
                if let Some(longer) = one.is_clearly_longer(&two) {
                    assert_eq!(longer, exact == Ordering::Greater, "{v:?} along {n:?} and {m:?}");
                    assert_ne!(exact, Ordering::Equal, "{v:?} along {n:?} and {m:?}");
                    told += 1;
                }
            }
        }
        assert!(enough(told > 10_000), "{told}");
    }
}
