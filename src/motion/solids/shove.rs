//! A displacement that a solid forces on a body: the bounds that the solids set, and the motion
//! through the level.

use crate::motion::body::Body;
use crate::motion::plane::{NEAR, into, way};
use crate::motion::run::{Run, check_inside};
use crate::motion::search::{Around, check_cells};
use crate::motion::{MoveError, Moved, Stuck, Work};
use crate::num::{Axis, MOTION, Raw};
use crate::world::{Solid, World};

/// Bounds of a body's displacement in one tick, axis by axis.
///
/// They only shrink, by a maximum and a minimum. The order of the solids therefore does not matter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clearance {
    pub(super) lo: Raw,
    pub(super) hi: Raw,
}

impl Clearance {
    const FAR: i32 = MOTION - 1;

    pub(super) const ALL: Self =
        Self { lo: Raw { x: -Self::FAR, y: -Self::FAR }, hi: Raw { x: Self::FAR, y: Self::FAR } };

    /// Adds the bound of a solid's face with the outward normal `n`. At the end of the motion the
    /// body may touch the face, and be no nearer.
    pub(super) fn behind<B: Body>(&mut self, body: &B, solid: &Solid, n: Axis) {
        let (lo, hi, motion, bounds) = (solid.lo(), solid.hi(), Raw::of(solid.motion()), body.bounds());
        // From the body's side to the solid's opposite one at its new position.
        let right = hi.add(motion).sub(bounds.lo());
        let left = lo.add(motion).sub(bounds.hi());
        match (n.x.signum(), n.y.signum()) {
            (1, _) => self.lo.x = self.lo.x.max(right.x),
            (-1, _) => self.hi.x = self.hi.x.min(left.x),
            (_, 1) => self.lo.y = self.lo.y.max(right.y),
            _ => self.hi.y = self.hi.y.min(left.y),
        }
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.lo.x > self.hi.x || self.lo.y > self.hi.y
    }

    /// The displacement within the bounds that is nearest to `d`.
    pub(super) fn nearest(&self, d: Raw) -> Raw {
        Raw { x: d.x.max(self.lo.x).min(self.hi.x), y: d.y.max(self.lo.y).min(self.hi.y) }
    }

    /// The axes on which a face determines the body's position.
    pub(super) const fn held(&self) -> (bool, bool) {
        (self.lo.x > -Self::FAR || self.hi.x < Self::FAR, self.lo.y > -Self::FAR || self.hi.y < Self::FAR)
    }

    /// These bounds for a body that should move by `d` and could only move by `made`: the level has
    /// no more room on that side.
    pub(super) fn in_level(&self, d: Raw, made: Raw) -> Self {
        let mut room = *self;
        if made.x < d.x {
            room.hi.x = room.hi.x.min(made.x);
        } else if made.x > d.x {
            room.lo.x = room.lo.x.max(made.x);
        }
        if made.y < d.y {
            room.hi.y = room.hi.y.min(made.y);
        } else if made.y > d.y {
            room.lo.y = room.lo.y.max(made.y);
        }
        room
    }
}

/// The most pieces of one shove.
const PIECES: u32 = 6;

/// A displacement, and how it yields.
pub(super) struct Shove {
    pub(super) d: Raw,
    /// The axes along which the body's position is determined.
    pub(super) held: (bool, bool),
    pub(super) passes_one_way: bool,
}

impl Shove {
    /// Moves a body, and never into the level. `d` is not zero.
    ///
    /// At a slope, a corner or an arc it keeps the motion along the `held` axis. It yields along
    /// the other one, at most twice as far. At a wall across the axis it stops. So a body that a
    /// lift pushes up along a slanted ceiling rises as far as the lift does.
    ///
    /// ```text
    ///         \ ceiling                held: y. The slope makes the body yield to the left,
    ///      <-o \                       and it rises by all of d.
    ///      lift^
    /// ```
    ///
    /// A separate function: its run takes about a hundred bytes of stack.
    #[inline(never)]
    pub(super) fn of<W: World, B: Body>(&self, body: &B, level: &W, work: &mut Work) -> Result<B, MoveError> {
        let mut d = self.d;
        check_cells(level, body.extent(), d)?;
        let mut moved = Moved::freely(*body, d.vec2(), 0);
        let mut around = Around::nothing();
        let mut run = Run::new(&mut moved, &mut around);
        run.pass_one_way = self.passes_one_way;
        run.moved.work = *work;
        if run.is_stuck(level) {
            return Err(MoveError::Stuck(Stuck { at: body.position().raw() }));
        }
        // The surfaces that have pressed the body at this position.
        let mut planes = [None; PIECES as usize];
        let mut pressed = 0;
        for piece in 0..PIECES as usize {
            check_inside(&run.moved.body.bounds(), d)?;
            run.moved.work.iterations += 1;
            let Some((entry, _)) = run.first_hit(level, d) else {
                run.arrive(level, d);
                break;
            };
            let made = run.advance(level, d, &entry);
            let rest = d.sub(made);
            if way(made) <= NEAR.max(way(d) >> 3) {
                pressed += 1;
            } else {
                (planes, pressed) = ([None; PIECES as usize], 0);
            }
            if let Some(plane) = planes.get_mut(piece) {
                *plane = Some(entry.normal);
            }
            d = yielding(rest, entry.normal, self.held);
            // A tangent of a quarter pipe leads into it again. The body takes a steeper direction,
            // through the inside of the pipe.
            if W::ROUND && pressed > 0 && entry.step.is_some() {
                d = steeper(d, rest, entry.normal, pressed);
            }
            if d.is_zero() || planes.iter().flatten().any(|&n| into(d, n) < 0) {
                break;
            }
        }
        *work = run.moved.work;
        Ok(run.moved.body)
    }
}

/// `rest`, plus the least motion along one axis that takes it out of the plane with the normal `n`.
///
/// With v = -rest . n > 0 that motion is `v / |n_i|`, on axis i. It is below 2^31, since the other
/// component of n is at most twice as large.
fn yielding(rest: Raw, n: Axis, held: (bool, bool)) -> Raw {
    if n.x == 0 || n.y == 0 {
        return Raw { x: if n.x == 0 { rest.x } else { 0 }, y: if n.y == 0 { rest.y } else { 0 } };
    }
    let holds_x = match held {
        (true, false) => true,
        (false, true) => false,
        _ => rest.x.unsigned_abs() >= rest.y.unsigned_abs(),
    };
    // `steep`: the held axis runs into a wall.
    let (nx, ny) = (n.x.unsigned_abs(), n.y.unsigned_abs());
    let steep = if holds_x { nx >> 1 > ny } else { ny >> 1 > nx };
    if steep {
        let kept = if holds_x { Raw { x: 0, ..rest } } else { Raw { y: 0, ..rest } };
        let leaves = i64::from(kept.x) * i64::from(n.x) + i64::from(kept.y) * i64::from(n.y) >= 0;
        return if leaves { kept } else { Raw { x: 0, y: 0 } };
    }
    let out = out_of(rest, n, if holds_x { n.y } else { n.x });
    if holds_x { Raw { y: rest.y.wrapping_add(out), ..rest } } else { Raw { x: rest.x.wrapping_add(out), ..rest } }
}

/// The motion along the axis of the component `along` of the normal that takes `rest` out of the
/// plane.
pub(super) fn out_of(rest: Raw, n: Axis, along: i32) -> i32 {
    let into = n.dot(Axis::new(rest.x, rest.y));
    if into >= 0 {
        return 0;
    }
    let (v, a) = (into.unsigned_abs(), along.unsigned_abs());
    let part = quotient_up(v, a) as i32;
    if along < 0 { part.wrapping_neg() } else { part }
}

/// `v / a`, rounded up, for quotients below 2^32.
///
/// Computed bit by bit, because it is rare: a fast quotient of a double word takes 500 bytes of
/// flash.
fn quotient_up(v: u64, a: u32) -> u32 {
    let (mut rest, mut part, mut quotient) = (v, u64::from(a) << 32, 0u32);
    for _ in 0..32 {
        (part, quotient) = (part >> 1, quotient << 1);
        if rest >= part {
            (rest, quotient) = (rest - part, quotient | 1);
        }
    }
    quotient.wrapping_add(u32::from(rest != 0))
}

/// A direction that rises half as far again for each time that the body was pressed.
fn steeper(d: Raw, rest: Raw, n: Axis, pressed: i32) -> Raw {
    let more = |rest: i32, n: i32| ((rest.abs() >> 2) + 1).wrapping_mul(pressed).wrapping_mul(n.signum());
    if d.x == rest.x {
        Raw { y: d.y.wrapping_add(more(rest.x, n.y)), ..d }
    } else {
        Raw { x: d.x.wrapping_add(more(rest.y, n.x)), ..d }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Clearance, Raw, quotient_up, yielding};

    /// A room without width or height still holds one displacement.
    #[test]
    fn only_crossed_bounds_leave_no_room() {
        let room = |x: i32, y: i32| Clearance { lo: Raw { x: 3, y: 5 }, hi: Raw { x, y } };
        for (x, y, empty) in [(3, 5, false), (9, 9, false), (2, 9, true), (9, 4, true)] {
            assert_eq!(room(x, y).is_empty(), empty, "{x} {y}");
        }
    }

    /// A level that shortens a motion along one axis bounds that axis alone, on that side.
    #[test]
    fn a_level_bounds_only_what_it_shortens() {
        let bounds = |d: (i32, i32), made: (i32, i32)| {
            let room = Clearance::ALL.in_level(Raw { x: d.0, y: d.1 }, Raw { x: made.0, y: made.1 });
            (room.lo.x, room.hi.x, room.lo.y, room.hi.y)
        };
        let far = Clearance::FAR;
        assert_eq!(bounds((5, 7), (5, 7)), (-far, far, -far, far));
        assert_eq!(bounds((5, 7), (3, 7)), (-far, 3, -far, far));
        assert_eq!(bounds((-5, 7), (-3, 7)), (-3, far, -far, far));
        assert_eq!(bounds((5, 7), (5, 4)), (-far, far, -far, 4));
        assert_eq!(bounds((5, -7), (5, -4)), (-far, far, -4, far));
    }

    /// Against the division of the processor, at both ends of the range and around each multiple.
    #[test]
    fn quotients_round_up() {
        for a in [1u32, 2, 3, 5, 7, 0xffff, 0x1_0000, 0x7fff_ffff, 0xffff_ffff] {
            for times in [0u64, 1, 2, 3, 0xffff, 0x7fff_ffff, 0xffff_fffe] {
                for beside in [-1i64, 0, 1] {
                    let Some(v) = (u64::from(a) * times).checked_add_signed(beside) else { continue };
                    assert_eq!(u64::from(quotient_up(v, a)), v.div_ceil(u64::from(a)), "{v} / {a}");
                }
            }
        }
    }

    /// The motion along the held axis stays, even if it is the shorter one.
    #[test]
    fn what_yields_keeps_the_held_axis() {
        let (rest, n) = (Raw { x: 10, y: -4 }, Axis::new(-1, 1));
        assert_eq!(yielding(rest, n, (true, false)), Raw { x: 10, y: 10 });
        assert_eq!(yielding(rest, n, (false, true)), Raw { x: -4, y: -4 });
    }

    /// The rest leads out of the plane or along it, and not back.
    #[test]
    fn what_yields_does_not_lead_in() {
        let steps = || [-70i32, -9, -1, 0, 1, 9, 70].into_iter();
        for (nx, ny) in steps().flat_map(|x| steps().map(move |y| (x, y))).filter(|n| *n != (0, 0)) {
            let n = if nx == 0 || ny == 0 { Axis::new(nx.signum(), ny.signum()) } else { Axis::new(nx, ny) };
            let into = |v: Raw| i64::from(v.x) * i64::from(n.x) + i64::from(v.y) * i64::from(n.y);
            for rest in steps().flat_map(|x| steps().map(move |y| Raw { x: x * 3, y: y * 2 })) {
                for held in [(true, false), (false, true), (true, true)] {
                    let left = yielding(rest, n, held);
                    assert!(into(left) >= 0 || into(rest) >= 0, "{rest:?} {n:?} {held:?} {left:?}");
                }
            }
        }
    }
}
