//! Bodies as plain integers, and the call under test.

use super::{P, Time, add};
use tilesat::{
    Aabb, Capsule, Circle, Fx, MoveError, Mover, Response, TileMap, Vec2,
    motion::{Hits, Work},
};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    Rect {
        lo: P,
        hi: P,
    },
    /// A circle, or a capsule: the end of the core with the smaller coordinates, how far along x or
    /// y the other end is, and the radius.
    Disc {
        c: P,
        core: P,
        r: i64,
    },
}

/// A result of the mover, in plain integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    pub body: Body,
    pub v: P,
    pub remaining: P,
    pub hits: Hits,
    pub floor: bool,
    pub wall: bool,
    pub ceiling: bool,
    pub flags: u8,
    pub work: Work,
}

pub fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}

pub fn point(v: Vec2) -> P {
    let (x, y) = v.raw();
    (i64::from(x), i64::from(y))
}

/// Whole units.
pub fn px(x: i64) -> i64 {
    x << 16
}

/// Whole units.
pub fn at(x: i64, y: i64) -> P {
    (px(x), px(y))
}

impl Body {
    /// A box from its corner and size.
    pub fn rect(corner: P, size: P) -> Self {
        Self::Rect { lo: corner, hi: add(corner, size) }
    }

    pub fn disc(c: P, r: i64) -> Self {
        Self::Disc { c, core: (0, 0), r }
    }

    /// The corner of a box with the smaller coordinates, the centre of a circle.
    pub fn position(&self) -> P {
        match *self {
            Self::Rect { lo, .. } => lo,
            Self::Disc { c, .. } => c,
        }
    }

    pub fn bounds(&self) -> (P, P) {
        match *self {
            Self::Rect { lo, hi } => (lo, hi),
            Self::Disc { c, core, r } => ((c.0 - r, c.1 - r), (c.0 + core.0 + r, c.1 + core.1 + r)),
        }
    }

    /// A point inside of every body with area.
    pub fn middle(&self) -> P {
        let (lo, hi) = self.bounds();
        ((lo.0 + hi.0).div_euclid(2), (lo.1 + hi.1).div_euclid(2))
    }

    pub fn has_area(&self) -> bool {
        let (lo, hi) = self.bounds();
        lo.0 < hi.0 && lo.1 < hi.1
    }

    pub fn moved(&self, d: P) -> Self {
        match *self {
            Self::Rect { lo, hi } => Self::Rect { lo: add(lo, d), hi: add(hi, d) },
            Self::Disc { c, core, r } => Self::Disc { c: add(c, d), core, r },
        }
    }

    /// Each coordinate by a rule that may turn the axes.
    pub fn mapped(&self, f: impl Fn(P) -> P) -> Self {
        match *self {
            Self::Rect { lo, hi } => {
                let (a, b) = (f(lo), f(hi));
                Self::Rect { lo: (a.0.min(b.0), a.1.min(b.1)), hi: (a.0.max(b.0), a.1.max(b.1)) }
            }
            Self::Disc { c, core, r } => {
                let (a, b) = (f(c), f(add(c, core)));
                let (lo, hi) = ((a.0.min(b.0), a.1.min(b.1)), (a.0.max(b.0), a.1.max(b.1)));
                Self::Disc { c: lo, core: (hi.0 - lo.0, hi.1 - lo.1), r }
            }
        }
    }

    /// The library's motion of this body.
    pub fn step(&self, mover: &Mover, map: &TileMap<'_>, v: P) -> Result<Outcome, MoveError> {
        match *self {
            Self::Rect { lo, hi } => {
                let body = Aabb::new(vec2(lo), vec2(hi)).unwrap();
                let moved = mover.move_and_slide(map, &body, vec2(v))?;
                assert_eq!(moved.position(), moved.body.min());
                let body = Self::Rect { lo: point(moved.body.min()), hi: point(moved.body.max()) };
                Ok(outcome(body, &moved))
            }
            Self::Disc { c, core: (0, 0), r } => {
                let body = Circle::new(vec2(c), Fx::from_bits(i32::try_from(r).unwrap())).unwrap();
                let moved = mover.move_and_slide(map, &body, vec2(v))?;
                assert_eq!(moved.position(), moved.body.centre());
                let r = i64::from(moved.body.radius().to_bits());
                Ok(outcome(Self::disc(point(moved.body.centre()), r), &moved))
            }
            Self::Disc { c, core, r } => {
                let radius = Fx::from_bits(i32::try_from(r).unwrap());
                let body = Capsule::new(vec2(c), vec2(add(c, core)), radius).unwrap();
                let moved = mover.move_and_slide(map, &body, vec2(v))?;
                assert_eq!(moved.position(), moved.body.a());
                let (c, end) = (point(moved.body.a()), point(moved.body.b()));
                let core = (end.0 - c.0, end.1 - c.1);
                Ok(outcome(Self::Disc { c, core, r: i64::from(moved.body.radius().to_bits()) }, &moved))
            }
        }
    }
}

fn outcome<B>(body: Body, moved: &tilesat::Moved<B>) -> Outcome {
    Outcome {
        body,
        v: point(moved.velocity),
        remaining: point(moved.remaining),
        hits: moved.hits,
        floor: moved.floor,
        wall: moved.wall,
        ceiling: moved.ceiling,
        flags: moved.flags,
        work: moved.work,
    }
}

impl Outcome {
    pub fn axes(&self) -> Vec<P> {
        self.hits.iter().map(|h| (i64::from(h.axis.x), i64::from(h.axis.y))).collect()
    }

    pub fn times(&self) -> Vec<Time> {
        self.hits.iter().map(|h| Time::parts(h.toi.raw())).collect()
    }
}

pub const RESPONSES: [Response; 4] = [Response::Slide, Response::Touch, Response::DropThrough, Response::Bounce];
