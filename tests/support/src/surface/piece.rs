//! Features in plain integers, ordered.

use super::mosaic::FAR;
use super::polygon::Point;
use tilesat::{
    Axis, Vec2,
    world::{Feature, Geometry},
};

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Piece {
    pub cell: Point,
    pub index: u16,
    pub one_way: bool,
    pub flags: u8,
    pub kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Face { a: Point, b: Point, dir: Point, joined: [bool; 2] },
    Vertex { p: Point, e_in: Point, e_out: Point },
    Arc { centre: Point, radius: i64, quadrant: Point, convex: bool },
}

impl Piece {
    pub fn of(f: &Feature) -> Self {
        let point = |v: Vec2| (i64::from(v.raw().0), i64::from(v.raw().1));
        let axis = |a: Axis| (i64::from(a.x), i64::from(a.y));
        let kind = match f.geometry {
            Geometry::Face { a, dir, len, joined } => {
                let (a, dir, len) = (point(a), axis(dir), i64::from(len));
                let at_the_end = a.0.abs() == FAR || a.1.abs() == FAR;
                assert!(len > 0 || (len == 0 && at_the_end));
                Kind::Face { a, b: (a.0 + dir.0 * len, a.1 + dir.1 * len), dir, joined }
            }
            Geometry::Vertex { p, e_in, e_out } => Kind::Vertex { p: point(p), e_in: axis(e_in), e_out: axis(e_out) },
            Geometry::Arc { centre, radius, quadrant, convex } => {
                Kind::Arc { centre: point(centre), radius: i64::from(radius), quadrant: axis(quadrant), convex }
            }
            _ => panic!("a feature that no tile has"),
        };
        assert_eq!(f.source, 0);
        let cell = (i64::from(f.cell.x), i64::from(f.cell.y));
        Self { cell, index: f.index, one_way: f.one_way, flags: f.flags, kind }
    }

    /// Two opposite corners of the box around it.
    pub fn bounds(&self) -> (Point, Point) {
        match self.kind {
            Kind::Face { a, b, .. } => (a, b),
            Kind::Vertex { p, .. } => (p, p),
            Kind::Arc { centre, radius, quadrant, .. } => {
                (centre, (centre.0 + quadrant.0 * radius, centre.1 + quadrant.1 * radius))
            }
        }
    }
}
