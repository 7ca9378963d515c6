//! One call of a mover: the first hit, the position at the hit, the rest of the motion, and the
//! chord along a quarter pipe.

use super::body::{Body, Entry};
use super::contact::Plane;
use super::order::First;
use super::plane::{into, long, part, project, way};
use super::response::Smooth;
use super::search::{Around, Search, box_here, hull, margin};
use super::{Hit, Moved};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, LONG, Raw, Toi};
use crate::shape::Aabb;
use crate::world::{Feature, World};

/// The state of one call.
#[expect(clippy::struct_excessive_bools, reason = "facts that are independent of each other")]
pub(super) struct Run<'m, B> {
    /// The result so far, stored where the caller wants it.
    pub(super) moved: &'m mut Moved<B>,
    around: &'m mut Around,
    pub(super) v: Raw,
    /// The rest of the motion.
    pub(super) motion: Raw,
    /// The part of the call's time that is left.
    pub(super) rest: Toi,
    /// The velocity to project at the next hit: the one that the body had before it met the
    /// surfaces that it still touches.
    pub(super) before: Raw,
    /// The plane that the motion runs along.
    pub(super) along: Option<Plane>,
    /// Whether it has moved farther than rounding can move it.
    pub(super) came: bool,
    /// Whether floors do not end the motion of a walker: it met one that does not carry it.
    pub(super) falls: bool,
    /// Whether it flew to the first of the surfaces that it touches. It then meets the next surface
    /// with the remaining velocity.
    pub(super) flew: bool,
    /// The velocity of the call, from a first hit to which the body came on a hop to the next hit.
    pub(super) hopped: Option<Raw>,
    /// The probe of the current way.
    pub(super) tried: Raw,
    /// The ways that led nowhere from this position.
    pub(super) shut: Shut,
    /// Whether no way is free, and the motion follows a bound way up to the surface that binds it.
    pub(super) creeps: bool,
    pub(super) pass_one_way: bool,
    /// Whether nothing has been hit yet. Placed between the others: clearing five adjacent flags
    /// would become a library call.
    pub(super) is_first: bool,
    /// Whether the body has been in the solid all the time.
    pub(super) inside: bool,
    /// Whether one-way faces that may be askew are near.
    pub(super) guarded: bool,
    /// Whether the motion is a chord of a quarter pipe, not the velocity times the time.
    pub(super) on_chord: bool,
    /// The part of the call's time that is left after it.
    pub(super) after: Toi,
}

/// A position to which a body can be put back. A position in the solid is allowed only for a body
/// that has been in the solid all the time.
#[derive(Clone, Copy)]
pub(super) struct Checkpoint<B> {
    body: B,
    inside: bool,
}

impl<B> Checkpoint<B> {
    pub(super) const fn body(&self) -> &B {
        &self.body
    }
}

impl<'m, B: Body> Run<'m, B> {
    /// The run of a body that has hit nothing yet. Parts of the level may already be known.
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
            falls: false,
            flew: false,
            hopped: None,
            is_first: true,
            tried: long(v),
            shut: Shut::none(v),
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
        !is_free(self.around, &body) && self.overlaps(world, &body)
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

    /// Moves up to the hit. Returns the displacement made.
    pub(super) fn advance<W: World>(&mut self, world: &W, d: Raw, entry: &Entry) -> Raw {
        self.place(world, d, entry.displacement(d), d)
    }

    /// The direction that a part of the motion must not oppose: the velocity, or a pipe's chord,
    /// because a pipe turns the velocity. Only bodies with several corners at a pipe meet it on its
    /// chord.
    #[inline]
    pub(super) fn course<W: World>(&self, d: Raw) -> Raw {
        if W::ROUND && B::ANGULAR && self.on_chord { d } else { self.before }
    }

    /// Moves by the displacement `q` up to a hit, not against `u`. Returns the displacement made.
    ///
    /// If a box meets blocks, the first displacement is certain. At the exact position of the hit
    /// the box is on the outer side of one face's line of each rectangle of solid. Those lines are
    /// integers, and rounding toward the integer start passes none.
    #[inline(never)]
    pub(super) fn place<W: World>(&mut self, world: &W, d: Raw, q: Raw, u: Raw) -> Raw {
        if q.is_zero() {
            return q;
        }
        if W::CERTAIN && W::BLOCKS && !B::MEETS_CORNERS {
            return if self.take(world, q, true) { q } else { Raw::ZERO };
        }
        // The compiler computes all steps before it tries the first. That takes 90 instructions on
        // a desktop, and 6 on a Cortex-M0, where a second copy of the test would take 100 bytes.
        let first = on_the_way(q, d);
        if LONG && self.places(world, first, u) {
            return first;
        }
        first_place(q, d, usize::from(LONG), |q| self.places(world, q, u))
    }

    /// Moves by a displacement if there is room, and it is not against `u`. Each displacement is a
    /// part of the velocity. So with the same velocity no position repeats.
    #[inline]
    fn places<W: World>(&mut self, world: &W, q: Raw, u: Raw) -> bool {
        (q.is_zero() || u.dot(q) > 0) && self.take(world, q, false)
    }

    /// Takes the first displacement that the exact overlap test accepts; otherwise the body stays.
    /// Returns the displacement made. None leads beyond either end of the motion `d`, and so none
    /// out of the domain.
    pub(super) fn commit<W: World>(&mut self, world: &W, d: Raw, displacements: &[Raw]) -> Raw {
        let mut choices = displacements.iter().map(|&q| on_the_way(q, d));
        choices.find(|&q| self.take(world, q, false)).unwrap_or(Raw::ZERO)
    }

    /// Makes a motion that meets nothing.
    pub(super) fn arrive<W: World>(&mut self, world: &W, d: Raw) {
        let certain = is_certain::<W, B>(&self.moved.body);
        self.take(world, d, certain);
    }

    /// Moves by a displacement if the exact overlap test accepts its end. A `certain` or known end
    /// needs no test.
    #[inline(never)]
    fn take<W: World>(&mut self, world: &W, q: Raw, certain: bool) -> bool {
        let candidate = self.moved.body.shifted(q);
        let free = (certain && !self.inside) || is_free(self.around, &candidate) || !self.overlaps(world, &candidate);
        debug_assert!(!free || !candidate.overlaps_world(world), "a place was taken for free");
        let takes = (free || self.inside) && (W::BLOCKS || !self.guarded || !self.passes_one_way(world, q));
        if takes {
            (self.moved.body, self.inside) = (candidate, !free);
            world.made(q);
        }
        takes
    }

    /// Whether a rounded displacement leads through a one-way face. No overlap test would object,
    /// and the body would fall through. Faces along x and y do not need this test: rounding keeps a
    /// body on its side of them.
    #[inline(never)]
    fn passes_one_way<W: World>(&mut self, world: &W, q: Raw) -> bool {
        let mut features = world.features(&hull(&self.moved.body.bounds(), Raw::ZERO, q, 1));
        while let Some(feature) = &features.next() {
            self.moved.work.features += 1;
            if feature.one_way && !self.pass_one_way && self.moved.body.sweep_in::<W>(q, feature).is_some() {
                return true;
            }
        }
        false
    }

    /// The rest of the motion after the velocity changes.
    pub(super) fn turned(&self, to: Raw) -> Raw {
        turned(self.motion, self.v, to, self.rest)
    }

    /// The displacement that the velocity makes in a part of the call's time.
    #[inline(never)]
    pub(super) fn made_in(&self, time: Toi) -> Raw {
        Raw { x: time.of_raw(self.v.x), y: time.of_raw(self.v.y) }
    }

    /// After a whole motion: uses the time that a chord left, with the velocity at its end.
    pub(super) fn follow(&mut self) {
        (self.rest, self.after, self.on_chord) = (self.after, Toi::ZERO, false);
        self.motion = self.made_in(self.rest);
        (self.along, self.before) = (None, self.v);
    }

    /// The result, once the motion is made.
    pub(super) fn end<W: World>(&mut self) {
        let remaining = if W::ROUND { self.motion.add(self.made_in(self.after)) } else { self.motion };
        self.moved.remaining = remaining.vec2();
        self.moved.velocity = self.v.vec2();
    }

    pub(super) fn record(&mut self, normal: Axis, feature: &Feature, toi: Toi) {
        // A corner's time is a lower bound. It is set to no earlier than the previous hit.
        let last = self.moved.hits.last().map_or(toi, |hit| hit.toi);
        self.moved.flags |= feature.flags;
        self.moved.hits.push(Hit::of(normal, feature, toi.max(last)));
    }
}

/// Whether the end of a motion that meets nothing is certain.
///
/// Among tiles it is: the sweeps are exact and the surface surrounds the solid. A body that starts
/// outside and hits nothing therefore ends outside. If not all tiles are blocks, bodies without
/// area are an exception: they may pass between two features.
pub(super) fn is_certain<W: World, B: Body>(body: &B) -> bool {
    W::CERTAIN && (W::BLOCKS || margin(body.extent()) == 0)
}

/// What is `left` of a motion after the velocity changes, in the `rest` of the time.
///
/// A component that is kept, dropped or reversed (by any face along the axes) changes the rest of
/// the motion exactly, without rounding. Any other component is the new velocity times the
/// remaining time.
#[inline(never)]
pub(super) fn turned(left: Raw, was: Raw, now: Raw, rest: Toi) -> Raw {
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
    Raw { x: component(left.x, was.x, now.x), y: component(left.y, was.y, now.y) }
}

/// A motion along a plane. Along a slope of tiles it is exact to the last bit, and it enters no
/// plane.
///
/// A motion enters a plane only because it was rounded toward zero, by less than a raw unit on each
/// axis. It is moved back that far.
pub(super) fn straightened<B: Body, W: World>(d: Raw, n: Axis) -> Raw {
    if n.x == 0 || n.y == 0 {
        return d;
    }
    if n.x.unsigned_abs() <= 2 && n.y.unsigned_abs() <= 2 && !W::BLOCKS {
        return project::<B, W, _>(d, n, &Smooth);
    }
    if into(d, n) < 0 { d.add(Raw { x: n.x.signum(), y: n.y.signum() }) } else { d }
}

/// The probes of the ways that led nowhere from a position.
#[derive(Clone, Copy)]
pub(super) struct Shut {
    probes: [Raw; 4],
    len: u8,
}

impl Shut {
    /// No probes. The unused slots hold a value at hand: clearing them would become a library call.
    pub(super) fn none(unused: Raw) -> Self {
        Self { probes: [unused; 4], len: 0 }
    }

    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

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

/// Whether the level is known to leave a body free.
pub(super) fn is_free<B: Body>(around: &Around, body: &B) -> bool {
    around.is_free(&box_here(body))
}

/// Refuses a motion that would leave the domain.
pub(super) fn check_inside(bounds: &Aabb, d: Raw) -> Result<(), RangeError> {
    let (lo, hi) = (bounds.lo().add(d), bounds.hi().add(d));
    for (what, low, high) in [(Quantity::EndX, lo.x, hi.x), (Quantity::EndY, lo.y, hi.y)] {
        let value = if d.x < 0 && what == Quantity::EndX || d.y < 0 && what == Quantity::EndY { low } else { high };
        if low <= -DOMAIN || high >= DOMAIN {
            return Err(RangeError { what, value });
        }
    }
    Ok(())
}

/// The first displacement that `takes` accepts, at `q` or near it; otherwise zero. `q` is the
/// displacement up to a hit of the motion `d`. The first `tried` positions are left out.
///
/// In a gap that closes slowly, there is room only farther back. Positions there are on the
/// motion's own line: the hit's is rounded away from one surface, which may be into another.
///
/// The gap decides how far. Take two corners as far apart as the body is wide. At a distance `s`
/// before them the body has `s^2 / rho` to spare: less than a raw unit over `sqrt rho`. So the
/// search goes back to the start, in steps that double: 27 below 2^29, of seven positions each.
/// Otherwise a way that is free for hundreds of raw units could lead nowhere.
#[inline]
pub(crate) fn first_place(q: Raw, d: Raw, mut tried: usize, mut takes: impl FnMut(Raw) -> bool) -> Raw {
    // Corners: rounding away from one corner may graze another. Tries lattice neighbours toward the
    // start, then aside, then two back.
    const STEPS: [(i32, i32); 7] = [(0, 0), (-1, -1), (1, 0), (0, 1), (-1, 0), (0, -1), (-2, -2)];
    let mut back = 0;
    while back < way(q) {
        let q = if back == 0 { q } else { part(d, way(q).wrapping_sub(back), way(d)) };
        for (x, y) in STEPS.into_iter().skip(tried) {
            let step = Raw { x: x * d.x.signum(), y: y * d.y.signum() };
            let q = on_the_way(q.add(step), d);
            if takes(q) {
                return q;
            }
        }
        (back, tried) = ((back << 1).max(4), 0);
    }
    Raw::ZERO
}

/// The displacement nearest to another that leads beyond neither end of a motion.
pub(super) fn on_the_way(q: Raw, d: Raw) -> Raw {
    Raw { x: q.x.clamp(d.x.min(0), d.x.max(0)), y: q.y.clamp(d.y.min(0), d.y.max(0)) }
}
