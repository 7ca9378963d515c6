//! Compact `defmt::Format` for the types that hold fixed-point numbers; the others derive it.
//!
//! Lengths print as decimals with four places, rounded toward zero: `-0.7500`. The number goes out as two integers, the sign as an
//! interned string, and nothing of `core::fmt` is linked.

mod bodies;
mod levels;

use crate::motion::response::{Particle, Split, Stick, Surface};
use crate::motion::{BodyHit, Hit, Hits, Moved, Walked};
use crate::num::{Fx, Ratio, Toi, UnitVec2, Vec2};
use crate::query::{CastHit, Contact, MovingHit};
use crate::shape::{Aabb, Circle, Segment};
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
        write!(f, "Walked {} on {} stepped {} snapped {}", self.moved, self.floor, up, down);
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
