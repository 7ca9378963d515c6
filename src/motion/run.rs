//! What one call of the mover does to its body: the first hit of a motion, the place at the hit, the rest of the motion.

use super::body::{Body, Entry};
use super::pipe::Pipe;
use super::plane::Planes;
use super::{Hit, Hits, Moved, Work};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, Raw, Toi, Vec2, mul_div, umul};
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, World};

/// The state of one call.
pub(super) struct Run<B> {
    pub(super) moved: Moved<B>,
    pub(super) v: Raw,
    /// The motion that is left to make.
    pub(super) motion: Raw,
    /// The part of the call's time that is left.
    pub(super) rest: Toi,
    pub(super) planes: Planes,
    /// The velocity that the body had when it came to this place. A body that has come flying to one plane and then slides to another one
    /// comes there with what the first has left; one that lay on the first already is pressed against both by the same push, and rests between them.
    pub(super) before_planes: Raw,
    pub(super) pass_one_way: bool,
    /// Whether one-way faces are near that may be askew.
    guarded: bool,
    /// Whether the motion is a chord of a quarter pipe, not the velocity times the time.
    pub(super) on_chord: bool,
    /// The part of the call's time that is left after it.
    pub(super) after: Toi,
}

impl<B: Body> Run<B> {
    pub(super) fn new(body: B, v: Raw) -> Self {
        let moved = Moved {
            body,
            velocity: Vec2::ZERO,
            remaining: Vec2::ZERO,
            hits: Hits::NONE,
            floor: false,
            wall: false,
            ceiling: false,
            flags: 0,
            work: Work::default(),
        };
        Self {
            moved,
            v,
            motion: v,
            rest: Toi::ONE,
            planes: Planes::NONE,
            before_planes: v,
            pass_one_way: false,
            guarded: false,
            on_chord: false,
            after: Toi::ZERO,
        }
    }

    pub(super) fn overlaps<W: World>(&mut self, world: &W, body: &B) -> bool {
        self.moved.work.checks += 1;
        body.overlaps_world(world)
    }

    /// The first hit of the motion. Cells are visited piece by piece so that the work is linear in the motion's length; the sweeps
    /// themselves always see the whole motion.
    pub(super) fn first_hit<W: World>(&mut self, world: &W, d: Raw) -> Option<(Entry, Feature)> {
        let bounds = self.moved.body.bounds();
        let longest = d.x.unsigned_abs().max(d.y.unsigned_abs());
        // No shorter than the body either, or each piece would visit the body's own cells again.
        let side = Raw::of(bounds.size());
        let length = world.cell_size().max(side.x.max(side.y) as u32);
        let pieces = if longest <= length { 1 } else { mul_div(longest, 1, length) + 1 };
        let mut best: Option<(Entry, Feature)> = None;
        for piece in 0..pieces {
            let region = hull(&bounds, part(d, piece, pieces), part(d, piece + 1, pieces));
            for feature in world.features(&region) {
                self.moved.work.features += 1;
                if feature.one_way && self.pass_one_way {
                    continue;
                }
                self.guarded |= !W::BLOCKS && feature.one_way;
                let body = &self.moved.body;
                let entry = if W::BLOCKS {
                    body.sweep_block(d, &feature)
                } else if W::ROUND || !matches!(feature.geometry, Geometry::Arc { .. }) {
                    body.sweep(d, &feature)
                } else {
                    None
                };
                let Some(entry) = entry else { continue };
                let before =
                    |first: &Entry| if W::BLOCKS { entry.before(first, d) } else { entry.before_askew(first, d) };
                match &mut best {
                    Some((first, of)) if entry.same_as(first) => merge(of, &feature),
                    Some((first, _)) if !before(first) => {}
                    _ => best = Some((entry, feature)),
                }
            }
            // Later pieces hold only later hits.
            if best.is_some_and(|(e, _)| umul(e.num, pieces) <= umul(e.den, piece + 1)) {
                break;
            }
        }
        best
    }

    /// Moves up to the hit; returns the displacement made.
    pub(super) fn advance<W: World>(&mut self, world: &W, d: Raw, entry: &Entry) -> Raw {
        let q = entry.displacement(d);
        if q.is_zero() {
            return q;
        }
        // Corners: rounding away from one corner may graze another. Lattice neighbours toward the start, then aside, then two back.
        let (sx, sy) = (d.x.signum(), d.y.signum());
        let at = |x: i32, y: i32| Raw { x: q.x.wrapping_add(x), y: q.y.wrapping_add(y) };
        self.commit(world, d, &[q, at(-sx, -sy), at(sx, 0), at(0, sy), at(-sx, 0), at(0, -sy), at(-2 * sx, -2 * sy)])
    }

    /// Takes the first displacement that the exact overlap test accepts, else stays; returns the displacement made. None leads beyond either
    /// end of the motion `d`, and so none out of the domain.
    pub(super) fn commit<W: World>(&mut self, world: &W, d: Raw, displacements: &[Raw]) -> Raw {
        for q in displacements {
            let q = Raw { x: q.x.clamp(d.x.min(0), d.x.max(0)), y: q.y.clamp(d.y.min(0), d.y.max(0)) };
            let candidate = self.moved.body.shifted(q);
            if !self.overlaps(world, &candidate) && (W::BLOCKS || !self.guarded || !self.passes_one_way(world, q)) {
                self.moved.body = candidate;
                return q;
            }
        }
        Raw { x: 0, y: 0 }
    }

    /// Whether a rounded displacement leads through a one-way face: no overlap test would object, and the body would fall through. Faces
    /// along x and y need no such care, rounding keeps a body on its side of them.
    #[inline(never)]
    fn passes_one_way<W: World>(&mut self, world: &W, q: Raw) -> bool {
        let body = self.moved.body;
        let region = hull(&body.bounds(), Raw { x: 0, y: 0 }, q);
        for feature in world.features(&region) {
            self.moved.work.features += 1;
            if feature.one_way && !self.pass_one_way && body.sweep(q, &feature).is_some() {
                return true;
            }
        }
        false
    }

    /// Gives the velocity another direction, and the rest of the motion with it.
    ///
    /// A component that is kept, dropped or reversed (all that faces along the axes do) acts on the rest of the motion exactly, so nothing is
    /// lost by rounding; any other is the new velocity times the time that is left.
    pub(super) fn turn<W: World>(&mut self, to: Raw) {
        let rest = self.rest;
        let component = |left: i32, was: i32, now: i32| {
            if now == was {
                left
            } else if now == 0 {
                0
            } else if now == was.wrapping_neg() {
                left.wrapping_neg()
            } else {
                rest.of_raw(now)
            }
        };
        self.motion = Raw { x: component(self.motion.x, self.v.x, to.x), y: component(self.motion.y, self.v.y, to.y) };
        if !W::BLOCKS {
            self.motion = self.planes.keep::<B, W>(to, self.motion);
        }
        self.v = to;
    }

    /// What the velocity makes in a part of the call's time.
    pub(super) fn made_in(&self, time: Toi) -> Raw {
        Raw { x: time.of_raw(self.v.x), y: time.of_raw(self.v.y) }
    }

    /// After a whole motion: the time that a chord left, for the velocity at its end.
    pub(super) fn follow(&mut self) {
        (self.rest, self.after, self.on_chord) = (self.after, Toi::ZERO, false);
        self.motion = self.made_in(self.rest);
        (self.planes, self.before_planes) = (Planes::NONE, self.v);
    }

    /// Goes on along a quarter pipe that was hit, if that is one, by a chord; the velocity is then along the pipe at the chord's end, and
    /// as fast as it was along the pipe at its start.
    #[inline(never)]
    pub(super) fn roll(&mut self, geometry: &Geometry) -> bool {
        let Geometry::Arc { centre, radius, quadrant, convex: false } = *geometry else { return false };
        let (at, r) = self.moved.body.toward(quadrant);
        let pipe = Pipe { m: at.sub(Raw::of(centre)), r: radius.wrapping_sub(r), quadrant };
        let Some(chord) = pipe.chord(self.before_planes, self.rest) else { return false };
        if !self.planes.allow(chord.velocity) || !self.planes.allow(chord.way) {
            return false;
        }
        (self.v, self.motion, self.after) = (chord.velocity, chord.way, chord.after);
        self.on_chord = true;
        if self.motion.is_zero() {
            // At the end of the pipe already.
            self.follow();
        }
        true
    }

    /// Up to 45 degrees from up is floor: n.up >= |n x up|, exact.
    pub(super) fn classify(&mut self, up: Option<Axis>, normal: Axis) {
        let (along, across) = up.map_or((0, 1), |up| (normal.dot(up), normal.perp_dot(up).abs()));
        if along >= across {
            self.moved.floor = true;
        } else if -along >= across {
            self.moved.ceiling = true;
        } else {
            self.moved.wall = true;
        }
    }

    pub(super) fn record(&mut self, normal: Axis, feature: &Feature, toi: Toi) {
        self.moved.flags |= feature.flags;
        self.moved.hits.push(Hit {
            toi,
            axis: normal,
            cell: feature.cell,
            index: feature.index,
            flags: feature.flags,
            one_way: feature.one_way,
            source: feature.source,
        });
    }
}

/// Two features that are one surface at the moment of the hit: the solid one stands for both, with the flags of both.
fn merge(into: &mut Feature, other: &Feature) {
    let flags = into.flags | other.flags;
    if into.one_way && !other.one_way {
        *into = *other;
    }
    into.flags = flags;
}

/// Refuses a motion that would leave the domain.
pub(super) fn check_inside(bounds: &Aabb, d: Raw) -> Result<(), RangeError> {
    let (lo, hi) = (bounds.lo().add(d), bounds.hi().add(d));
    for (what, low, high) in [(Quantity::X, lo.x, hi.x), (Quantity::Y, lo.y, hi.y)] {
        let value = if d.x < 0 && what == Quantity::X || d.y < 0 && what == Quantity::Y { low } else { high };
        if low <= -DOMAIN || high >= DOMAIN {
            return Err(RangeError { what, value });
        }
    }
    Ok(())
}

/// `d * k / n`, rounded toward zero; all of `d` for k = n.
fn part(d: Raw, k: u32, n: u32) -> Raw {
    if k == n {
        return d;
    }
    let of = |c: i32| {
        let size = mul_div(c.unsigned_abs(), k, n) as i32;
        if c < 0 { size.wrapping_neg() } else { size }
    };
    Raw { x: of(d.x), y: of(d.y) }
}

/// What the bounds cover between two displacements, one raw unit larger on every side because the displacements are rounded.
fn hull(bounds: &Aabb, from: Raw, to: Raw) -> Aabb {
    let (a, b) = (bounds.lo(), bounds.hi());
    let lo = Raw { x: a.x + from.x.min(to.x) - 1, y: a.y + from.y.min(to.y) - 1 };
    let hi = Raw { x: b.x + from.x.max(to.x) + 1, y: b.y + from.y.max(to.y) + 1 };
    Aabb::from_raw_unchecked(lo, hi)
}
