//! Levels of polygons, walls and chains in all views, with the same query in each.

use crate::rooms::body::{Body, Outcome, vec2};
use crate::rooms::view::View;
use crate::rooms::{P, PX};
use tilesat::{Axis, Fx, Mover, Path, PathKind, SegmentMap};

/// The eight orientations of a square, and one far from the origin.
pub const VIEWS: [&[View]; 9] = [
    &[],
    &[View::MirrorX],
    &[View::MirrorY],
    &[View::MirrorX, View::MirrorY],
    &[View::Transpose],
    &[View::Transpose, View::MirrorX],
    &[View::Transpose, View::MirrorY],
    &[View::Transpose, View::MirrorX, View::MirrorY],
    &[View::Moved((123_456_789, -234_567_891))],
];

/// Whole units.
pub fn at(x: i64, y: i64) -> P {
    (x * PX, y * PX)
}

pub fn disc(x: i64, y: i64, r: i64) -> Body {
    Body::Disc(at(x, y), r * PX)
}

pub fn rect(x: i64, y: i64, w: i64, h: i64) -> Body {
    Body::Rect(at(x, y), at(w, h))
}

pub fn direction(views: &[View], v: P) -> P {
    views.iter().fold(v, |v, view| view.direction(v))
}

/// The inverse of [`direction`].
pub fn back(views: &[View], v: P) -> P {
    views.iter().rev().fold(v, |v, view| view.direction(v))
}

pub fn place(views: &[View], body: Body) -> Body {
    views.iter().fold(body, |b, view| view.body(b))
}

pub fn mover(views: &[View]) -> Mover {
    let up = direction(views, (0, -1));
    Mover::platformer(Axis::new(up.0 as i32, up.1 as i32))
}

/// Paths in building order.
#[derive(Clone, Debug)]
pub struct Drawing {
    pub paths: Vec<(PathKind, Vec<P>)>,
    pub cell: i64,
}

impl Drawing {
    pub fn new(cell: i64, paths: &[(PathKind, &[P])]) -> Self {
        Self { paths: paths.iter().map(|(kind, points)| (*kind, points.to_vec())).collect(), cell }
    }

    /// A box of solid, by its corners.
    pub fn block(a: P, b: P) -> (PathKind, Vec<P>) {
        (PathKind::Solid, vec![a, (b.0, a.1), b, (a.0, b.1)])
    }

    pub fn of(cell: i64, paths: Vec<(PathKind, Vec<P>)>) -> Self {
        Self { paths, cell }
    }

    pub fn seen(&self, views: &[View]) -> Self {
        let turns = views.iter().filter(|v| !matches!(v, View::Moved(_))).count() % 2 == 1;
        let paths = self.paths.iter().map(|(kind, points)| {
            let mut points: Vec<P> = points.iter().map(|p| place(views, Body::Disc(*p, 0)).position()).collect();
            // The front of a chain is to one side of its direction.
            if turns {
                points.reverse();
            }
            (*kind, points)
        });
        Self { paths: paths.collect(), cell: self.cell }
    }

    pub fn bytes(&self) -> Vec<u8> {
        let points: Vec<Vec<_>> = self.paths.iter().map(|(_, p)| p.iter().map(|p| vec2(*p)).collect()).collect();
        let paths: Vec<_> = self.paths.iter().zip(&points).map(|((kind, _), p)| Path::new(*kind, p)).collect();
        let cell = Fx::from_bits(self.cell as i32);
        let mut bytes = vec![0; SegmentMap::measure(&paths, cell).unwrap().bytes()];
        SegmentMap::build_into(&paths, cell, &mut bytes).unwrap();
        bytes
    }

    /// One call, in all views and with the paths in reverse order. They must agree to the last bit.
    /// Returns it upright.
    pub fn step(&self, body: Body, v: P, change: fn(Mover) -> Mover) -> Outcome {
        self.step_in(&VIEWS, body, v, change)
    }

    /// The same in some of the views: x wins a full tie between x and y, in transposed views too.
    pub fn step_in(&self, all: &[&[View]], body: Body, v: P, change: fn(Mover) -> Mover) -> Outcome {
        let mut first = None;
        for &views in all {
            let mut drawing = self.seen(views);
            for _ in 0..2 {
                let bytes = drawing.bytes();
                let map = SegmentMap::from_bytes(&bytes).unwrap();
                let out = place(views, body).step(&change(mover(views)), &map, direction(views, v)).unwrap();
                let out = upright(views, out);
                let first = first.get_or_insert(out);
                assert_eq!(bits(&out), bits(first), "{views:?}: {body:?} by {v:?} in {:?}", self.paths);
                drawing.paths.reverse();
            }
        }
        first.unwrap()
    }
}

fn upright(views: &[View], out: Outcome) -> Outcome {
    let body = views.iter().rev().fold(out.body, |b, view| match view {
        View::Moved(by) => b.moved((-by.0, -by.1)),
        _ => view.body(b),
    });
    Outcome { body, v: back(views, out.v), remaining: back(views, out.remaining), ..out }
}

/// Everything except the names of what was hit and the order of hits of one moment.
type Bits = (Body, P, P, [bool; 3], Option<u32>, usize);

fn bits(out: &Outcome) -> Bits {
    let first = out.hits.first().map(|h| h.toi.raw());
    (out.body, out.v, out.remaining, [out.floor, out.wall, out.ceiling], first, out.hits.len())
}

/// The directions of the hits, of the upright view.
pub fn axes(out: &Outcome) -> Vec<P> {
    out.hits.iter().map(|h| (h.axis.x.into(), h.axis.y.into())).collect()
}

/// `num / den` in parts of 2^30, rounded down.
pub fn parts(num: i64, den: i64) -> u32 {
    ((num << 30) / den) as u32
}
