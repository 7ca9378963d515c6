//! What one call of the mover does to its body: the first hit of a motion, the place at the hit, the rest of the motion, the way along a
//! quarter pipe.

use super::body::{Body, Entry};
use super::order::First;
use super::plane::{Planes, Side, across, into, may_be_askew, tangent, tangential, way};
use super::response::Law;
use super::search::{Around, Search, hull};
use super::{Hit, Moved};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, Raw, Toi, div_sqrt, isqrt64_ceil, mul_div, umul};
use crate::shape::Aabb;
use crate::world::{Feature, Geometry, World};

/// The state of one call.
#[expect(clippy::struct_excessive_bools, reason = "facts that are independent of each other")]
pub(super) struct Run<'m, B> {
    /// The result so far, where the caller wants it.
    pub(super) moved: &'m mut Moved<B>,
    around: &'m mut Around,
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
    /// Where it was before the call, if not in the solid.
    pub(super) start: Option<B>,
    /// Whether the body only creeps along what it has hit, and what else it is pushed against is to be found before it goes on.
    pub(super) creeps: bool,
    /// Whether the body has been in the solid all the time.
    pub(super) inside: bool,
    /// Whether one-way faces are near that may be askew.
    pub(super) guarded: bool,
    /// Whether the motion is a chord of a quarter pipe, not the velocity times the time.
    pub(super) on_chord: bool,
    /// The part of the call's time that is left after it.
    pub(super) after: Toi,
}

/// Where a body was, to be put back to: a place in the solid is one only for what has been there all the time.
#[derive(Clone, Copy)]
pub(super) struct Place<B> {
    body: B,
    inside: bool,
}

impl<'m, B: Body> Run<'m, B> {
    /// Of a body that has hit nothing yet; something may be known of the level already.
    #[inline]
    pub(super) fn new(moved: &'m mut Moved<B>, around: &'m mut Around) -> Self {
        let v = Raw::of(moved.velocity);
        Self {
            moved,
            around,
            v,
            motion: v,
            rest: Toi::ONE,
            planes: Planes::NONE,
            before_planes: v,
            pass_one_way: false,
            start: None,
            creeps: false,
            inside: false,
            guarded: false,
            on_chord: false,
            after: Toi::ZERO,
        }
    }

    pub(super) fn overlaps<W: World>(&mut self, world: &W, body: &B) -> bool {
        self.moved.work.checks += 1;
        body.overlaps_world(world)
    }

    /// Whether the body overlaps the level.
    pub(super) fn is_stuck<W: World>(&mut self, world: &W) -> bool {
        let body = self.moved.body;
        !is_free(self.around, &body.bounds()) && self.overlaps(world, &body)
    }

    pub(super) fn here(&self) -> Place<B> {
        Place { body: self.moved.body, inside: self.inside }
    }

    pub(super) fn put_back(&mut self, place: Place<B>) {
        (self.moved.body, self.inside) = (place.body, place.inside);
    }

    /// The first hit of the motion.
    pub(super) fn first_hit<W: World>(&mut self, world: &W, d: Raw) -> Option<(Entry, Feature)> {
        let mut first = First::none();
        self.find_first(world, d, &mut first);
        first.hit::<B, W>(&self.moved.body, d).map(|(entry, feature)| (*entry, *feature))
    }

    /// Looks for the first hit of the motion.
    pub(super) fn find_first<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
        let mut search = Search::new(&self.moved.body, self.around);
        search.pass_one_way = self.pass_one_way;
        search.pressed = if self.creeps { Some(self.v) } else { None };
        search.find_first(world, d, first);
        self.moved.work.features += search.features;
        self.guarded |= search.guarded;
    }

    /// Moves up to the hit; returns the displacement made.
    ///
    /// Where a box meets blocks the first displacement is certain: at the exact place of the hit it is on the outer side of one face's line of
    /// each rectangle of solid, those lines are integers, and rounding toward the integer start passes none.
    #[inline(never)]
    pub(super) fn advance<W: World>(&mut self, world: &W, d: Raw, entry: &Entry) -> Raw {
        // Corners: rounding away from one corner may graze another. Lattice neighbours toward the start, then aside, then two back.
        const STEPS: [(i32, i32); 7] = [(0, 0), (-1, -1), (1, 0), (0, 1), (-1, 0), (0, -1), (-2, -2)];
        // In a gap that closes slowly the room for that is farther back: of 1.5 * 10^6 frames of balls among all shapes 26 found a place 8 raw units
        // back that had found none, a unit and more from where the piece began. Farther back there is room for flat boxes only, by parts of a pixel.
        const BACK: [u32; 2] = [0, 8];
        let q = entry.displacement(d);
        for back in BACK {
            if back >= way(q) {
                break;
            }
            let q = q.sub(back_on(d, back));
            for (x, y) in STEPS {
                let step = Raw { x: x * d.x.signum(), y: y * d.y.signum() };
                let q = on_the_way(q.add(step), d);
                if self.take(world, q, W::CERTAIN && W::BLOCKS && !B::MEETS_CORNERS) {
                    return q;
                }
            }
        }
        Raw::ZERO
    }

    /// Takes the first displacement that the exact overlap test accepts, else stays; returns the displacement made. None leads beyond either
    /// end of the motion `d`, and so none out of the domain.
    pub(super) fn commit<W: World>(&mut self, world: &W, d: Raw, displacements: &[Raw]) -> Raw {
        let mut choices = displacements.iter().map(|&q| on_the_way(q, d));
        choices.find(|&q| self.take(world, q, false)).unwrap_or(Raw::ZERO)
    }

    /// Makes a motion that meets nothing.
    ///
    /// Among tiles its end is certain: the sweeps are exact and the surface is all around the solid, so what starts outside and hits nothing ends
    /// outside. Where not all tiles are blocks that is not so of bodies without area, which may go in between two features.
    pub(super) fn arrive<W: World>(&mut self, world: &W, d: Raw) {
        let certain = W::CERTAIN && (W::BLOCKS || margin(&self.moved.body.bounds()) == 0);
        self.take(world, d, certain);
    }

    /// Moves by a displacement if the exact overlap test accepts its end; what is `certain` or known needs no test.
    #[inline(never)]
    fn take<W: World>(&mut self, world: &W, q: Raw, certain: bool) -> bool {
        let candidate = self.moved.body.shifted(q);
        let free =
            (certain && !self.inside) || is_free(self.around, &candidate.bounds()) || !self.overlaps(world, &candidate);
        debug_assert!(!free || !candidate.overlaps_world(world), "a place was taken for free");
        let takes = (free || self.inside) && (W::BLOCKS || !self.guarded || !self.passes_one_way(world, q));
        if takes {
            (self.moved.body, self.inside) = (candidate, !free);
        }
        takes
    }

    /// Whether a rounded displacement leads through a one-way face: no overlap test would object, and the body would fall through. Faces
    /// along x and y need no such care, rounding keeps a body on its side of them.
    #[inline(never)]
    fn passes_one_way<W: World>(&mut self, world: &W, q: Raw) -> bool {
        let mut features = world.features(&hull(&self.moved.body.bounds(), Raw::ZERO, q, 1));
        while let Some(feature) = &features.next() {
            self.moved.work.features += 1;
            if feature.one_way && !self.pass_one_way && self.moved.body.sweep(q, feature).is_some() {
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
        if may_be_askew::<B, W>() {
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
    pub(super) fn roll<S: Law>(&mut self, geometry: &Geometry, surface: &S) -> bool {
        let Geometry::Arc { centre, radius, quadrant, convex: false } = *geometry else { return false };
        let (at, r) = self.moved.body.toward(quadrant);
        let pipe = Pipe { m: at.sub(Raw::of(centre)), r: radius.wrapping_sub(r), quadrant };
        let Some(chord) = pipe.chord(self.before_planes, self.rest, surface) else { return false };
        if !self.planes.allow(chord.velocity) || !self.planes.allow(chord.way) {
            return false;
        }
        (self.v, self.motion, self.after) = (chord.velocity, chord.way, chord.after);
        self.on_chord = !self.motion.is_zero();
        if !self.on_chord && self.after != Toi::ZERO {
            // At the end of the pipe already.
            self.follow();
        }
        true
    }

    pub(super) fn meet(&mut self, side: Side) {
        match side {
            Side::Floor => self.moved.floor = true,
            Side::Wall => self.moved.wall = true,
            Side::Ceiling => self.moved.ceiling = true,
        }
    }

    /// The result, once the motion is made.
    pub(super) fn end<W: World>(self) -> &'m mut Moved<B> {
        let remaining = if W::ROUND { self.motion.add(self.made_in(self.after)) } else { self.motion };
        self.moved.remaining = remaining.vec2();
        self.moved.velocity = self.v.vec2();
        self.moved
    }

    pub(super) fn record(&mut self, normal: Axis, feature: &Feature, toi: Toi) {
        self.moved.flags |= feature.flags;
        self.moved.hits.push(Hit::of(normal, feature, toi));
    }
}

/// Whether the level is known to leave these bounds free.
pub(super) fn is_free(around: &Around, bounds: &Aabb) -> bool {
    around.is_free(&hull(bounds, Raw::ZERO, Raw::ZERO, margin(bounds)))
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

/// So much of the longest component of a motion, and of the other in proportion.
fn back_on(d: Raw, back: u32) -> Raw {
    let of = |c: i32| {
        let part = mul_div(c.unsigned_abs(), back, way(d)) as i32;
        if c < 0 { part.wrapping_neg() } else { part }
    };
    Raw { x: of(d.x), y: of(d.y) }
}

/// The displacement nearest to another that leads beyond neither end of a motion.
fn on_the_way(q: Raw, d: Raw) -> Raw {
    Raw { x: q.x.clamp(d.x.min(0), d.x.max(0)), y: q.y.clamp(d.y.min(0), d.y.max(0)) }
}

/// By how much bounds without area are grown, so that they have an inside.
pub(super) fn margin(bounds: &Aabb) -> i32 {
    let size = Raw::of(bounds.size());
    i32::from(size.x == 0 || size.y == 0)
}

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
