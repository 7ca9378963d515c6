//! Sequences of motions. A body starts at a free position and is steered in random directions.

use super::room::{Body, Room};
use tilesat_judge::Random;
use tilesat_judge::oracle::figure::{Figure, Kind, Point};
use tilesat_judge::oracle::generate::UNIT;

/// Frames of a sequence.
pub const FRAMES: usize = 32;

#[derive(Clone, Copy, Debug)]
pub struct Case {
    pub start: Figure,
    /// The wanted motion of each frame.
    pub motions: [Point; FRAMES],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Class {
    pub kind: Kind,
    /// Pixels per frame.
    pub speed: i64,
    /// The first corner of the level, in pixels.
    pub origin: i64,
}

const fn class(kind: Kind, speed: i64, origin: i64) -> Class {
    Class { kind, speed, origin }
}

pub const CLASSES: [Class; 6] = [
    class(Kind::Circle, 4, 0),
    class(Kind::Circle, 30, 0),
    class(Kind::Circle, 4, 7000),
    class(Kind::Aabb, 4, 0),
    class(Kind::Aabb, 30, 0),
    class(Kind::Aabb, 4, 7000),
];

impl Class {
    pub fn name(self) -> String {
        let body = if self.kind == Kind::Circle { "circle" } else { "box" };
        let place = if self.origin > 0 { format!(" {} px from the origin", self.origin) } else { String::new() };
        format!("{body} up to {} px{place}", self.speed)
    }

    pub fn cases(self, room: &Room, n: usize) -> Vec<Case> {
        let mut r = Random::new(0x6d6f_7665 ^ (self.kind as u64) << 32 ^ (self.speed as u64) << 40);
        (0..n).map(|_| Case { start: self.start(&mut r, room), motions: self.motions(&mut r) }).collect()
    }

    /// A body of about 10 pixels, at least a sixteenth of a pixel from all solids.
    fn start(self, r: &mut Random, room: &Room) -> Figure {
        let l = &room.level;
        loop {
            let c = (l.x + r.below(l.width * l.cell), l.y + r.below(l.height * l.cell));
            let half = |r: &mut Random| r.within(9 * UNIT / 2, 11 * UNIT / 2);
            let figure = if self.kind == Kind::Circle {
                Figure::Circle { centre: c, radius: half(r) }
            } else {
                let (w, h) = (half(r), half(r));
                Figure::Aabb { min: (c.0 - w, c.1 - h), max: (c.0 + w, c.1 + h) }
            };
            let body = exact(&figure);
            if !room.overlaps(&body.shrunk(-super::room::FINE_PIXEL / 16)) {
                return figure;
            }
        }
    }

    /// Each direction is kept for some frames.
    fn motions(self, r: &mut Random) -> [Point; FRAMES] {
        let (mut motions, mut left, mut now) = ([(0, 0); FRAMES], 0, (0, 0));
        for motion in &mut motions {
            if left == 0 {
                left = r.within(4, 16);
                let most = self.speed * UNIT;
                now = loop {
                    let d = (r.around(most), r.around(most));
                    if d.0 * d.0 + d.1 * d.1 <= most * most {
                        break d;
                    }
                };
            }
            left -= 1;
            *motion = now;
        }
        motions
    }
}

/// A figure of raw units at its exact position.
pub fn exact(figure: &Figure) -> Body {
    let fine = |v: i64| v * (super::room::FINE_PIXEL >> 16);
    let point = |p: Point| (fine(p.0), fine(p.1));
    match *figure {
        Figure::Circle { centre, radius } => Body::Circle { c: point(centre), r: fine(radius) },
        Figure::Aabb { min, max } => Body::Box { lo: point(min), hi: point(max) },
        Figure::Segment { .. } => panic!("no such body"),
    }
}
