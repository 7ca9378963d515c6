//! What one call of the mover does to its body: the first hit of a motion, the place at the hit,
//! the rest of the motion, the way along a quarter pipe.

use super::body::{Body, Entry};
use super::contact::Plane;
use super::order::First;
use super::plane::{SurfaceRole, way};
use super::search::{Around, Search, hull};
use super::ways::long;
use super::{Hit, Moved};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, Raw, Toi, mul_div};
use crate::shape::Aabb;
use crate::world::{Feature, World};

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
    /// The velocity that is projected at the next hit: the one that the body had before all that it
    /// still touches.
    pub(super) before: Raw,
    /// What the motion runs along.
    pub(super) along: Option<Plane>,
    /// Whether it has come farther than roundings take it.
    pub(super) came: bool,
    /// Whether it came flying to the first of what it touches: then what it comes to next is met
    /// with the velocity that is left.
    pub(super) flew: bool,
    /// Whether nothing has been hit yet.
    pub(super) is_first: bool,
    /// The probe of the way that the motion is along.
    pub(super) tried: Raw,
    /// What led nowhere from this place.
    pub(super) shut: Shut,
    /// Whether the motion is along a way that is bound, up to what binds it, because no way is
    /// free.
    pub(super) creeps: bool,
    pub(super) pass_one_way: bool,
    /// Whether the body has been in the solid all the time.
    pub(super) inside: bool,
    /// Whether one-way faces are near that may be askew.
    pub(super) guarded: bool,
    /// Whether the motion is a chord of a quarter pipe, not the velocity times the time.
    pub(super) on_chord: bool,
    /// The part of the call's time that is left after it.
    pub(super) after: Toi,
}

/// Where a body was, to be put back to: a place in the solid is one only for what has been there
/// all the time.
#[derive(Clone, Copy)]
pub(super) struct Checkpoint<B> {
    body: B,
    inside: bool,
}

impl<'m, B: Body> Run<'m, B> {
    /// How far back from a hit a place is looked for, raw.
    const FARTHEST: u32 = 64;

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
            before: v,
            along: None,
            came: false,
            flew: false,
            is_first: true,
            tried: long(v),
            shut: Shut::NONE,
            creeps: false,
            pass_one_way: false,
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

    pub(super) fn here(&self) -> Checkpoint<B> {
        Checkpoint { body: self.moved.body, inside: self.inside }
    }

    pub(super) fn put_back(&mut self, place: Checkpoint<B>) {
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
        search.find_first(world, d, first);
        self.moved.work.features += search.features;
        self.guarded |= search.guarded;
    }

    /// Moves up to the hit; returns the displacement made.
    pub(super) fn advance<W: World>(&mut self, world: &W, d: Raw, entry: &Entry) -> Raw {
        self.place(world, d, entry, d)
    }

    /// Moves up to the hit, not against `u`; returns the displacement made.
    ///
    /// Where a box meets blocks the first displacement is certain: at the exact place of the hit it
    /// is on the outer side of one face's line of each rectangle of solid, those lines are
    /// integers, and rounding toward the integer start passes none.
    #[inline(never)]
    pub(super) fn place<W: World>(&mut self, world: &W, d: Raw, entry: &Entry, u: Raw) -> Raw {
        // Corners: rounding away from one corner may graze another. Lattice neighbours toward the
        // start, then aside, then two back.
        const STEPS: [(i32, i32); 7] = [(0, 0), (-1, -1), (1, 0), (0, 1), (-1, 0), (0, -1), (-2, -2)];
        let q = entry.displacement(d);
        if q.is_zero() {
            return q;
        }
        // In a gap that closes slowly the room for that is farther back.
        let mut back = 0;
        while back < way(q).min(2 * Self::FARTHEST) {
            let q = q.sub(back_on(d, back));
            for (x, y) in STEPS {
                let step = Raw { x: x * d.x.signum(), y: y * d.y.signum() };
                let q = on_the_way(q.add(step), d);
                // Each way made is a part of the velocity, so with the same velocity no place comes
                // again.
                if (q.is_zero() || u.dot(q) > 0) && self.take(world, q, W::CERTAIN && W::BLOCKS && !B::MEETS_CORNERS) {
                    return q;
                }
            }
            back = (back << 1).max(4);
        }
        Raw::ZERO
    }

    /// Takes the first displacement that the exact overlap test accepts, else stays; returns the
    /// displacement made. None leads beyond either end of the motion `d`, and so none out of the
    /// domain.
    pub(super) fn commit<W: World>(&mut self, world: &W, d: Raw, displacements: &[Raw]) -> Raw {
        let mut choices = displacements.iter().map(|&q| on_the_way(q, d));
        choices.find(|&q| self.take(world, q, false)).unwrap_or(Raw::ZERO)
    }

    /// Makes a motion that meets nothing.
    ///
    /// Among tiles its end is certain: the sweeps are exact and the surface is all around the
    /// solid, so what starts outside and hits nothing ends outside. Where not all tiles are blocks
    /// that is not so of bodies without area, which may go in between two features.
    pub(super) fn arrive<W: World>(&mut self, world: &W, d: Raw) {
        let certain = W::CERTAIN && (W::BLOCKS || margin(&self.moved.body.bounds()) == 0);
        self.take(world, d, certain);
    }

    /// Moves by a displacement if the exact overlap test accepts its end; what is `certain` or
    /// known needs no test.
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

    /// Whether a rounded displacement leads through a one-way face: no overlap test would object,
    /// and the body would fall through. Faces along x and y need no such care, rounding keeps a
    /// body on its side of them.
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

    /// What is left of the motion where the velocity becomes another.
    ///
    /// A component that is kept, dropped or reversed (all that faces along the axes do) acts on the
    /// rest of the motion exactly, so nothing is lost by rounding; any other is the new velocity
    /// times the time that is left.
    pub(super) fn turned(&self, to: Raw) -> Raw {
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
        Raw { x: component(self.motion.x, self.v.x, to.x), y: component(self.motion.y, self.v.y, to.y) }
    }

    /// What the velocity makes in a part of the call's time.
    pub(super) fn made_in(&self, time: Toi) -> Raw {
        Raw { x: time.of_raw(self.v.x), y: time.of_raw(self.v.y) }
    }

    /// After a whole motion: the time that a chord left, for the velocity at its end.
    pub(super) fn follow(&mut self) {
        (self.rest, self.after, self.on_chord) = (self.after, Toi::ZERO, false);
        self.motion = self.made_in(self.rest);
        (self.along, self.before) = (None, self.v);
    }

    pub(super) fn meet(&mut self, side: SurfaceRole) {
        match side {
            SurfaceRole::Floor => self.moved.floor = true,
            SurfaceRole::Wall => self.moved.wall = true,
            SurfaceRole::Ceiling => self.moved.ceiling = true,
        }
    }

    /// The result, once the motion is made.
    pub(super) fn end<W: World>(&mut self) -> &mut Moved<B> {
        let remaining = if W::ROUND { self.motion.add(self.made_in(self.after)) } else { self.motion };
        self.moved.remaining = remaining.vec2();
        self.moved.velocity = self.v.vec2();
        self.moved
    }

    pub(super) fn record(&mut self, normal: Axis, feature: &Feature, toi: Toi) {
        // A corner's time is a lower bound: it is not before that of what was hit before it.
        let last = self.moved.hits.iter().last().map_or(toi, |hit| hit.toi);
        self.moved.flags |= feature.flags;
        self.moved.hits.push(Hit::of(normal, feature, toi.max(last)));
    }
}

/// The probes of the ways that led nowhere from a place.
#[derive(Clone, Copy)]
pub(super) struct Shut {
    probes: [Raw; 4],
    len: u8,
}

impl Shut {
    pub(super) const NONE: Self = Self { probes: [Raw::ZERO; 4], len: 0 };

    pub(super) fn push(&mut self, probe: Raw) {
        if self.holds(probe) {
            return;
        }
        if let Some(slot) = self.probes.get_mut(usize::from(self.len)) {
            *slot = probe;
            self.len += 1;
        }
    }

    pub(super) fn iter(self) -> impl Iterator<Item = Raw> {
        self.probes.into_iter().take(usize::from(self.len))
    }

    pub(super) fn holds(&self, probe: Raw) -> bool {
        self.iter().any(|shut| shut == probe)
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
