//! How the solids answer one displacement of a body.

use super::shove::{Clearance, out_of};
use crate::motion::body::{Body, Entry};
use crate::num::{Axis, Raw, div_sqrt, mul_div_wide};
use crate::query::meet;
use crate::world::{Solid, Solids};
use core::slice;

/// The solid that presses a body: the one that approaches fastest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Press {
    /// How far it moves in this tick, along the normal, rounded toward zero.
    speed: i32,
    /// Whether it approaches at all.
    pub(super) comes: bool,
    pub(super) key: u16,
    pub(super) normal: Axis,
}

impl Press {
    /// The press of a solid that moves by `m`. Whether the normal may be askew is known at compile
    /// time.
    pub(super) fn of<const ASKEW: bool>(key: u16, m: Raw, n: Axis) -> Self {
        let along = n.dot(Axis::new(m.x, m.y));
        let speed = if !ASKEW || n.x == 0 || n.y == 0 {
            m.x.wrapping_mul(n.x).wrapping_add(m.y.wrapping_mul(n.y))
        } else {
            let size = div_sqrt(along.unsigned_abs(), n.length_squared()) as i32;
            if along < 0 { size.wrapping_neg() } else { size }
        };
        Self { speed, comes: along > 0, key, normal: n }
    }

    /// Orders by speed, then by the smaller key, then by geometry: the same for mirrored normals as
    /// far as possible. A solid that moves by less than a raw unit is faster than one at rest.
    pub(super) fn goes_before(&self, other: &Self) -> bool {
        let key = |p: &Self| {
            let n = p.normal;
            (p.speed, p.comes, u16::MAX - p.key, n.x.unsigned_abs(), n.y.unsigned_abs(), n.x, n.y)
        };
        key(self) > key(other)
    }
}

/// The pushes of one tick on one body.
pub(super) struct Pushes<'a, B> {
    pub(super) solids: &'a [Solid],
    pub(super) body: &'a B,
    pub(super) passes_one_way: bool,
    pub(super) room: Clearance,
    pub(super) press: Option<Press>,
}

/// Whether a face of a solid makes this hit. Boxes meet nothing else. A slanted side of a turned
/// body meets a corner, because a solid has no slanted face.
fn is_face<B: Body>(entry: &Entry, normal: Axis) -> bool {
    if B::ANGULAR {
        entry.step.is_none() && (normal.x == 0 || normal.y == 0)
    } else {
        !B::MEETS_CORNERS || entry.step.is_none()
    }
}

impl<B: Body> Pushes<'_, B> {
    /// Returns `None` if the body keeps clear of all solids by `made`, the part of `d` that the
    /// level allowed. Otherwise returns the displacement to try instead of `d`.
    ///
    /// A solid moves straight by its motion while the body moves straight by `made`. Relative to
    /// the solid, the body moves by the difference. A hit of that motion is a push, at any speed.
    /// Faces set bounds, and all of them together decide. If no face is hit, corners push a circle
    /// off along their normals.
    #[inline(never)]
    pub(super) fn ask(&mut self, d: Raw, made: Raw) -> Option<Raw> {
        let (mut clear, mut corners) = (true, Shift::default());
        let mut faces = false;
        for solid in self.solids {
            if self.passes_one_way && solid.one_way().is_some() {
                continue;
            }
            let relative = made.sub(Raw::of(solid.motion()));
            let Some((normal, entry)) = self.hit(solid, made, relative) else { continue };
            clear = false;
            let motion = Raw::of(solid.motion());
            let press = if B::MEETS_CORNERS {
                Press::of::<true>(solid.key(), motion, normal)
            } else {
                Press::of::<false>(solid.key(), motion, normal)
            };
            if self.press.is_none_or(|p| press.goes_before(&p)) {
                self.press = Some(press);
            }
            match entry {
                Some(entry) if is_face::<B>(&entry, normal) => {
                    faces = true;
                    self.room.behind(self.body, solid, normal);
                }
                Some(entry) => {
                    let rest = relative.sub(entry.displacement(relative));
                    corners.add(off(rest, made, normal, &self.room.in_level(d, made)));
                }
                // Nothing moves a body that is already inside.
                None => {}
            }
        }
        if clear {
            return None;
        }
        Some(self.room.nearest(if faces { d } else { corners.from(made) }))
    }

    /// The normal of the face or corner that the body hits as it moves past a solid, and the entry.
    /// No entry if the body is in the solid from the start to the end.
    fn hit(&self, solid: &Solid, made: Raw, relative: Raw) -> Option<(Axis, Option<Entry>)> {
        let (body, bounds) = (self.body, self.body.bounds());
        let (lo, hi) = (bounds.lo(), bounds.hi());
        let zero = |v: i32| (v.min(0), v.max(0));
        let ((x0, x1), (y0, y1)) = (zero(relative.x), zero(relative.y));
        let (from, to) = (lo.add(Raw { x: x0, y: y0 }), hi.add(Raw { x: x1, y: y1 }));
        if !meet::aabb_aabb::<false>(from, to, solid.lo(), solid.hi()) {
            return None;
        }
        let overlaps = |solid: &Solid, body: &B| body.overlaps_world(&Solids::new(slice::from_ref(solid)));
        let ends_inside = || overlaps(&solid.moved(), &body.shifted(made));
        if overlaps(solid, body) {
            return ends_inside().then(|| (way_out(solid, lo, hi), None));
        }
        match first(solid, body, relative) {
            Some(entry) => Some((entry.normal, Some(entry))),
            None => ends_inside().then(|| (way_out(solid, lo, hi), None)),
        }
    }
}

/// The first piece of a solid that a motion hits.
fn first<B: Body>(solid: &Solid, body: &B, d: Raw) -> Option<Entry> {
    let last = if B::MEETS_CORNERS { 8 } else { 4 };
    let mut best: Option<Entry> = None;
    for index in (0..last).filter(|i| solid.pieces() >> i & 1 != 0) {
        let Some(entry) = body.sweep_block(d, &solid.piece(index, [false; 2])) else { continue };
        if best.is_none_or(|b| entry.before(&b, d)) {
            best = Some(entry);
        }
    }
    best
}

/// The side of a solid nearest to a box that overlaps it. On a tie, the one toward which the solid
/// moves, then the one along x, then +.
fn way_out(solid: &Solid, lo: Raw, hi: Raw) -> Axis {
    let (a, b, motion) = (solid.lo(), solid.hi(), Raw::of(solid.motion()));
    let sides = [
        (b.x.wrapping_sub(lo.x), motion.x, Axis::X),
        (hi.x.wrapping_sub(a.x), motion.x.wrapping_neg(), Axis::NEG_X),
        (b.y.wrapping_sub(lo.y), motion.y, Axis::Y),
        (hi.y.wrapping_sub(a.y), motion.y.wrapping_neg(), Axis::NEG_Y),
    ];
    let mut best = (i32::MAX, 0, Axis::X);
    for side in sides {
        if side.0 < best.0 || (side.0 == best.0 && side.1 > best.1) {
            best = side;
        }
    }
    best.2
}

/// Takes a body off a corner after the rest of its motion. It goes along the normal, or along one
/// axis if the bounds stop it on the other.
fn off(rest: Raw, made: Raw, n: Axis, room: &Clearance) -> Raw {
    let into = n.dot(Axis::new(rest.x, rest.y));
    if into >= 0 {
        return Raw { x: 0, y: 0 };
    }
    // The part of `rest` against the normal: |n_i| v / n.n, below |rest|, plus one for the
    // rounding.
    let part = |component: i32| {
        let size = mul_div_wide(into.unsigned_abs(), component.unsigned_abs(), n.length_squared()) as i32;
        size.wrapping_add(1).wrapping_mul(component.signum())
    };
    let shift = Raw { x: part(n.x), y: part(n.y) };
    let to = made.add(shift);
    let fits = room.nearest(to);
    let (nx, ny) = (n.x.unsigned_abs(), n.y.unsigned_abs());
    if fits.x != to.x && fits.y == to.y && nx >> 1 <= ny {
        Raw { x: 0, y: out_of(rest, n, n.y) }
    } else if fits.y != to.y && fits.x == to.x && ny >> 1 <= nx {
        Raw { x: out_of(rest, n, n.x), y: 0 }
    } else {
        shift
    }
}

/// The largest of several shifts in each direction, axis by axis.
#[derive(Default)]
struct Shift {
    x: (i32, i32),
    y: (i32, i32),
}

impl Shift {
    fn add(&mut self, by: Raw) {
        self.x = (self.x.0.min(by.x), self.x.1.max(by.x));
        self.y = (self.y.0.min(by.y), self.y.1.max(by.y));
    }

    /// Opposite shifts meet in the middle.
    fn from(&self, d: Raw) -> Raw {
        Raw {
            x: d.x.wrapping_add(self.x.0).wrapping_add(self.x.1),
            y: d.y.wrapping_add(self.y.0).wrapping_add(self.y.1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Clearance, Entry, Raw, is_face, off};
    use crate::shape::{Aabb, Circle, ConvexPolygon};

    /// A turned body meets faces along x and y, and corners: these have a step, or a slanted
    /// normal.
    #[test]
    fn a_turned_body_meets_faces_along_the_axes() {
        let hit = |step| Entry { num: 0, den: 1, normal: Axis::X, at_end: false, step };
        for (x, y, face) in [(1, 0, true), (0, -1, true), (1, 2, false), (-1, 1, false)] {
            let n = Axis::new(x, y);
            assert_eq!(is_face::<ConvexPolygon<4>>(&hit(None), n), face, "{n:?}");
            assert!(!is_face::<ConvexPolygon<4>>(&hit(Some(Raw { x: 0, y: 0 })), n), "{n:?}");
        }
        assert!(is_face::<Circle>(&hit(None), Axis::X) && !is_face::<Circle>(&hit(Some(Raw { x: 0, y: 0 })), Axis::X));
        assert!(is_face::<Aabb>(&hit(None), Axis::Y));
    }

    /// Without room along one axis, a corner of 45 degrees pushes along the other one, by both
    /// parts of the motion into it.
    #[test]
    fn beside_a_wall_a_corner_pushes_along_it() {
        for (x, y) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
            let (n, made) = (Axis::new(x, y), Raw { x: 40 * x, y: 7 * y });
            let rest = Raw { x: -30 * x, y: -20 * y };
            let mut wall = Clearance::ALL;
            if x > 0 {
                wall.hi.x = made.x;
            } else {
                wall.lo.x = made.x;
            }
            assert_eq!(off(rest, made, n, &wall), Raw { x: 0, y: 50 * y });
            let mut floor = Clearance::ALL;
            if y > 0 {
                floor.hi.y = made.y;
            } else {
                floor.lo.y = made.y;
            }
            assert_eq!(off(rest, made, n, &floor), Raw { x: 50 * x, y: 0 });
        }
    }
}
