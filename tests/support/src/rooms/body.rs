//! Bodies as plain integers, and the call under test.

use super::P;
use tilesat::world::World;
use tilesat::{
    Aabb, Capsule, Circle, Fx, MoveError, Moved, Mover, Surface, Vec2,
    motion::{Hits, Work},
};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// Corner with the smaller coordinates, size.
    Rect(P, P),
    /// Centre, radius.
    Disc(P, i64),
    /// An end of the core, how far the other end is along x or y, radius.
    Pill(P, P, i64),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    pub body: Body,
    pub v: P,
    pub remaining: P,
    pub hits: Hits,
    pub floor: bool,
    pub wall: bool,
    pub ceiling: bool,
    pub work: Work,
}

pub fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}

pub fn point(v: Vec2) -> P {
    let (x, y) = v.raw();
    (x.into(), y.into())
}

impl Body {
    pub fn at(self, p: P) -> Self {
        match self {
            Self::Rect(_, size) => Self::Rect(p, size),
            Self::Disc(_, r) => Self::Disc(p, r),
            Self::Pill(_, core, r) => Self::Pill(p, core, r),
        }
    }

    pub fn position(self) -> P {
        match self {
            Self::Rect(p, _) | Self::Disc(p, _) | Self::Pill(p, ..) => p,
        }
    }

    /// A point of the inside.
    pub fn middle(self) -> P {
        match self {
            Self::Rect(p, size) | Self::Pill(p, size, _) => (p.0 + size.0 / 2, p.1 + size.1 / 2),
            Self::Disc(p, _) => p,
        }
    }

    pub fn moved(self, d: P) -> Self {
        let p = self.position();
        self.at((p.0 + d.0, p.1 + d.1))
    }

    pub fn bounds(self) -> (P, P) {
        match self {
            Self::Rect(p, s) => (p, (p.0 + s.0, p.1 + s.1)),
            Self::Disc(p, r) => ((p.0 - r, p.1 - r), (p.0 + r, p.1 + r)),
            Self::Pill(p, e, r) => {
                let q = (p.0 + e.0, p.1 + e.1);
                ((p.0.min(q.0) - r, p.1.min(q.1) - r), (p.0.max(q.0) + r, p.1.max(q.1) + r))
            }
        }
    }

    /// The parts of a capsule: the discs around its ends, and the box between them.
    pub fn parts(self) -> Option<[Self; 3]> {
        let Self::Pill(p, e, r) = self else { return None };
        let (lo, hi) = ((p.0 + e.0.min(0), p.1 + e.1.min(0)), (e.0.abs(), e.1.abs()));
        let between = if e.0 == 0 {
            Self::Rect((lo.0 - r, lo.1), (2 * r, hi.1))
        } else {
            Self::Rect((lo.0, lo.1 - r), (hi.0, 2 * r))
        };
        Some([Self::Disc(p, r), Self::Disc((p.0 + e.0, p.1 + e.1), r), between])
    }

    /// The crate's capsule.
    pub fn capsule(p: P, e: P, r: i64) -> Capsule {
        Capsule::new(vec2(p), vec2((p.0 + e.0, p.1 + e.1)), Fx::from_bits(r as i32)).unwrap()
    }
}

/// The call under test, of each kind of mover.
macro_rules! steps {
    ($name:ident, $mover:ty) => {
        impl Body {
            pub fn $name<W: World>(self, mover: &$mover, world: &W, v: P) -> Result<Outcome, MoveError> {
                match self {
                    Self::Rect(..) => {
                        let (lo, hi) = self.bounds();
                        let body = Aabb::new(vec2(lo), vec2(hi)).unwrap();
                        let moved = mover.move_and_slide(world, &body, vec2(v))?;
                        Ok(outcome(self.at(point(moved.position())), &moved))
                    }
                    Self::Disc(c, r) => {
                        let body = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
                        let moved = mover.move_and_slide(world, &body, vec2(v))?;
                        Ok(outcome(self.at(point(moved.position())), &moved))
                    }
                    Self::Pill(p, e, r) => {
                        let moved = mover.move_and_slide(world, &Self::capsule(p, e, r), vec2(v))?;
                        Ok(outcome(self.at(point(moved.position())), &moved))
                    }
                }
            }
        }
    };
}

steps!(step, Mover);
steps!(step_on, Mover<Surface>);

fn outcome<B>(body: Body, m: &Moved<B>) -> Outcome {
    let (v, remaining) = (point(m.velocity), point(m.remaining));
    Outcome { body, v, remaining, hits: m.hits, floor: m.floor, wall: m.wall, ceiling: m.ceiling, work: m.work }
}
