//! Compact `defmt::Format` for the types that hold fixed-point numbers; the others derive it.
//!
//! A level logs its size and position, never its tiles; a cursor logs which level it belongs to.
//! Broad phases, scenes and walkers log how full they are and their settings, never each body. They
//! log only the pairs that exist.

mod levels;

use crate::broad::{BroadPhase, BruteForce, Exceptions, LooseGrid, Nearest, PairEvents, SortSweep, SpatialHash, Tag};
use crate::motion::response::{Particle, Split, Stick, Surface};
use crate::motion::{Body, BodyHit, Character, Feel, Hit, Hits, Input, Moved, Step, Walked, Walker};
use crate::num::{Fx, Ratio, Toi, UnitVec2, Vec2};
use crate::query::{CastHit, Contact, MovingHit};
use crate::scene::{Scene, SceneCharacter, SceneEvent, Sleep, Snapshot};
use crate::shape::{Aabb, Capsule, Circle, ConvexPolygon, OrientedBox, Segment};
use crate::world::{Near, RayHit, WorldContact};
use defmt::{Format, Formatter, write};

struct Decimal(Fx);

impl Format for Decimal {
    fn format(&self, f: Formatter<'_>) {
        let raw = self.0.to_bits();
        let size = raw.unsigned_abs();
        if raw < 0 {
            write!(f, "-");
        }
        write!(f, "{=u16}.{=u16:04}", (size >> 16) as u16, (((size & 0xffff) * 10_000) >> 16) as u16);
    }
}

impl Format for Vec2 {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "({}, {})", Decimal(self.x), Decimal(self.y));
    }
}

impl Format for UnitVec2 {
    fn format(&self, f: Formatter<'_>) {
        let (x, y) = self.raw();
        write!(f, "({}, {})", Decimal(Fx::from_bits(x >> 14)), Decimal(Fx::from_bits(y >> 14)));
    }
}

impl Format for Toi {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{}", Decimal(self.to_fx()));
    }
}

impl Format for Ratio {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{}", Decimal(Fx::from_bits((self.raw() >> 14) as i32)));
    }
}

impl Format for Aabb {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Aabb {}..{}", self.min(), self.max());
    }
}

impl Format for Circle {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Circle {} r {}", self.centre(), Decimal(self.radius()));
    }
}

impl Format for Segment {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Segment {}-{}", self.a(), self.b());
    }
}

impl Format for Capsule {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Capsule {}-{} r {}", self.a(), self.b(), Decimal(self.radius()));
    }
}

impl Format for OrientedBox {
    fn format(&self, f: Formatter<'_>) {
        let (along, across) = (self.along(), self.across());
        write!(f, "OrientedBox {} along {} across {} r {}", self.centre(), along, across, Decimal(self.radius()));
    }
}

impl<const N: usize> Format for ConvexPolygon<N> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "ConvexPolygon {} r {}", self.vertices(), Decimal(self.radius()));
    }
}

impl Format for SceneEvent<'_> {
    fn format(&self, f: Formatter<'_>) {
        match self {
            Self::Touch { pair, contact } => write!(f, "Touch {{ pair: {}, contact: {} }}", pair, contact),
            Self::Meet { pair, toi, axis, speed } => {
                write!(f, "Meet {{ pair: {}, toi: {}, axis: {}, speed: {} }}", pair, toi, axis, Decimal(*speed));
            }
            Self::Level { body, hits, flags, velocity } => {
                write!(f, "Level {{ body: {}, hits: {}, flags: {}, velocity: {} }}", body, hits, flags, velocity);
            }
            Self::Held { body, fault } => write!(f, "Held {{ body: {}, fault: {} }}", body, fault),
        }
    }
}

impl Format for Contact {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Contact axis {} depth {}", self.axis(), Decimal(self.depth()));
    }
}

impl Format for CastHit {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "CastHit {} axis {} after {} inside {}", self.toi, self.axis, self.displacement, self.inside);
    }
}

impl Format for MovingHit {
    fn format(&self, f: Formatter<'_>) {
        let (a, b) = (self.displacement, self.displacement_b);
        write!(f, "MovingHit {} axis {} after {} and {} inside {}", self.toi, self.axis, a, b, self.inside);
    }
}

impl Format for RayHit {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "RayHit {} at {} axis {} cell {}", self.toi, self.point, self.axis, self.cell);
    }
}

impl Format for Near {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Near {} at {} axis {} inside {}", Decimal(self.distance), self.point, self.axis, self.inside);
    }
}

impl Format for WorldContact {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "WorldContact axis {} depth {} cell {}", self.axis(), Decimal(self.depth()), self.feature().cell);
    }
}

impl Format for Hit {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Hit {} axis {} cell {} flags {=u8:#x}", self.toi, self.axis, self.cell, self.flags);
    }
}

impl<B: Format> Format for BodyHit<B> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "BodyHit {} at {} inside {}", self.hit, self.body, self.inside);
    }
}

impl Format for Hits {
    fn format(&self, f: Formatter<'_>) {
        for hit in self.iter() {
            write!(f, "[{}]", hit);
        }
    }
}

impl<B: Format> Format for Moved<B> {
    fn format(&self, f: Formatter<'_>) {
        let (floor, wall, ceiling) = (self.floor, self.wall, self.ceiling);
        write!(
            f,
            "Moved {} v {} floor {} wall {} ceiling {} {}",
            self.body, self.velocity, floor, wall, ceiling, self.hits
        );
    }
}

impl<B: Format> Format for Walked<B> {
    fn format(&self, f: Formatter<'_>) {
        let (up, down) = (Decimal(self.stepped), Decimal(self.snapped));
        let Self { moved, floor, met_floor, .. } = self;
        write!(f, "Walked {} on {} met floor {} stepped {} snapped {}", moved, floor, met_floor, up, down);
    }
}

impl Format for Input {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Input run {} jump {} drop {}", Decimal(self.run), self.jump, self.drop);
    }
}

impl Format for Feel {
    fn format(&self, f: Formatter<'_>) {
        let (gravity, jump, snap, step) = (self.gravity, self.jump, self.snap, self.step);
        let (coyote, buffer) = (self.coyote, self.buffer);
        write!(f, "Feel gravity {} jump {} ", Decimal(gravity), Decimal(jump));
        write!(f, "snap {} step {} coyote {} buffer {}", Decimal(snap), Decimal(step), coyote, buffer);
    }
}

impl Format for Step {
    fn format(&self, f: Formatter<'_>) {
        let (jumped, landed, wall, ceiling) = (self.jumped, self.landed, self.wall, self.ceiling);
        write!(f, "{} jumped {} landed {} wall {} ceiling {}", self.outcome, jumped, landed, wall, ceiling);
    }
}

impl<B: Format + Body> Format for SceneCharacter<B> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "SceneCharacter {} as {} on {}", self.character, self.handle(), self.stands_on());
    }
}

impl<B: Format + Body> Format for Character<B> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Character {} v {} on {}", self.body(), self.velocity, self.floor());
    }
}

impl Format for Split {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Split normal {} tangent {}", self.normal, self.tangent);
    }
}

impl Format for Surface {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Surface restitution {} friction {}", self.restitution(), self.friction());
    }
}

impl Format for Particle {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Particle {} from {}", self.position, self.previous);
    }
}

impl Format for Stick {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Stick {}", Decimal(self.length()));
    }
}

macro_rules! phases {
    ($($text:literal: $phase:ty, [$($parameter:tt)+];)+) => {$(
        impl<$($parameter)+> Format for $phase {
            fn format(&self, f: Formatter<'_>) {
                write!(f, $text, self.len(), N);
            }
        }
    )+};
}

phases! {
    "BruteForce {=usize} of {=usize}": BruteForce<N, T>, [const N: usize, T: Tag];
    "SortSweep {=usize} of {=usize}": SortSweep<N, T>, [const N: usize, T: Tag];
    "LooseGrid {=usize} of {=usize}": LooseGrid<C, N, T, L>, [const C: usize, const N: usize, T: Tag, const L: bool];
    "SpatialHash {=usize} of {=usize}": SpatialHash<C, N, T, L>, [const C: usize, const N: usize, T: Tag, const L: bool];
}

impl Format for Nearest {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Nearest {} at {}", self.handle, Decimal(self.distance));
    }
}

impl<const M: usize, P: Copy + Ord + Format> Format for PairEvents<M, P> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "PairEvents ");
        for event in self.iter() {
            write!(f, "[{}]", event);
        }
    }
}

impl<const M: usize> Format for Exceptions<M> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Exceptions ");
        for (pair, ignore) in self.iter() {
            write!(f, "[{} {}]", pair, ignore);
        }
    }
}

impl Format for Sleep {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Sleep below {} for {=u8}", Decimal(self.still), self.steps);
    }
}

impl<B: Format, const N: usize, const M: usize, S> Format for Scene<B, N, M, S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Scene {} awake {=usize} {}", self.near, self.count, self.sleep.sleep());
    }
}

impl<B: Format, const N: usize, S> Format for Snapshot<B, N, S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Snapshot {} awake {=u16} {}", self.near, self.count, self.sleep.sleep());
    }
}

impl Format for Walker {
    fn format(&self, f: Formatter<'_>) {
        let (snap, step) = (Decimal(Fx::from_bits(self.snap)), Decimal(Fx::from_bits(self.step)));
        write!(f, "Walker {} snap {} step {} {}", self.mover, snap, step, self.speed);
    }
}
