//! Pushes boxes and circles out of tiles. As in hobby code, one contact per kind of tile, and no
//! knowledge of neighbouring tiles.

use crate::Scalar;
use crate::pair::{contact_aabb_aabb, contact_circle_aabb};
use crate::shape::{Aabb, Circle, Vector};

/// A convex polygon with unit normals that face out. y is down, and corners run from x to y.
#[derive(Clone, Copy, Debug)]
pub struct Polygon<S> {
    pub corners: [Vector<S>; 5],
    pub normals: [Vector<S>; 5],
    pub count: usize,
}

/// The content of a tile, from its first corner.
#[derive(Clone, Copy, Debug)]
pub enum Tile<S> {
    Empty,
    Full,
    Polygon(Polygon<S>),
    /// A quarter disc: its centre is a corner of the cell, and `toward` (1 or -1 each) leads into
    /// the cell.
    Disc {
        centre: Vector<S>,
        toward: Vector<S>,
    },
    /// The rest of the cell beside a quarter disc.
    Hollow {
        centre: Vector<S>,
        toward: Vector<S>,
    },
}

/// The way out: how far, and along which unit vector.
#[derive(Clone, Copy, Debug)]
pub struct Exit<S> {
    pub depth: S,
    pub along: Vector<S>,
}

/// A body to push out of tiles. Positions are relative to the tile's first corner, and its side is
/// `cell`.
pub trait Body<S>: Copy {
    fn moved(&self, by: Vector<S>) -> Self;
    fn bounds(&self) -> Aabb<S>;
    fn out_of_full(&self, cell: S) -> Option<Exit<S>>;
    fn out_of_polygon(&self, polygon: &Polygon<S>) -> Option<Exit<S>>;
    fn out_of_disc(&self, centre: Vector<S>, toward: Vector<S>, cell: S) -> Option<Exit<S>>;
    fn out_of_hollow(&self, centre: Vector<S>, toward: Vector<S>, cell: S) -> Option<Exit<S>>;
}

impl<S: Scalar> Tile<S> {
    pub fn exit<B: Body<S>>(&self, body: &B, cell: S) -> Option<Exit<S>> {
        match *self {
            Self::Empty => None,
            Self::Full => body.out_of_full(cell),
            Self::Polygon(ref polygon) => body.out_of_polygon(polygon),
            Self::Disc { centre, toward } => body.out_of_disc(centre, toward, cell),
            Self::Hollow { centre, toward } => body.out_of_hollow(centre, toward, cell),
        }
    }
}

fn square<S: Scalar>(cell: S) -> Aabb<S> {
    Aabb { lo: Vector { x: S::ZERO, y: S::ZERO }, hi: Vector { x: cell, y: cell } }
}

fn negated<S: Scalar>(v: Vector<S>) -> Vector<S> {
    Vector { x: -v.x, y: -v.y }
}

/// `v` along the axes that lead into the cell, and back. `toward` is its own inverse.
fn mirrored<S: Scalar>(v: Vector<S>, toward: Vector<S>) -> Vector<S> {
    Vector { x: v.x * toward.x, y: v.y * toward.y }
}

fn shorter<S: Scalar>(a: Exit<S>, b: Exit<S>) -> Exit<S> {
    if b.depth < a.depth { b } else { a }
}

/// Away from a point that is nearer than `r`.
fn away<S: Scalar>(d: Vector<S>, r: S) -> Option<Exit<S>> {
    let square = d.dot(d);
    if square >= r * r {
        return None;
    }
    let distance = square.root();
    (distance > S::ZERO).then(|| Exit { depth: r - distance, along: Vector { x: d.x / distance, y: d.y / distance } })
}

/// The exits through the two straight sides that meet in the centre, for a body that reaches `(x,
/// y)` beyond them.
fn through_sides<S: Scalar>(reach: Vector<S>) -> Exit<S> {
    let x = Exit { depth: reach.x, along: Vector { x: -S::ONE, y: S::ZERO } };
    shorter(x, Exit { depth: reach.y, along: Vector { x: S::ZERO, y: -S::ONE } })
}

impl<S: Scalar> Body<S> for Circle<S> {
    fn moved(&self, by: Vector<S>) -> Self {
        Self { c: self.c + by, r: self.r }
    }

    fn bounds(&self) -> Aabb<S> {
        let r = Vector { x: self.r, y: self.r };
        Aabb { lo: self.c - r, hi: self.c + r }
    }

    fn out_of_full(&self, cell: S) -> Option<Exit<S>> {
        contact_circle_aabb(self, &square(cell)).map(|c| Exit { depth: c.depth, along: negated(c.normal) })
    }

    fn out_of_polygon(&self, polygon: &Polygon<S>) -> Option<Exit<S>> {
        let (mut side, mut most) = (0, -S::NEVER);
        for i in 0..polygon.count {
            let beyond = polygon.normals[i].dot(self.c - polygon.corners[i]);
            if beyond > most {
                (side, most) = (i, beyond);
            }
        }
        if most >= self.r {
            return None;
        }
        let (a, b) = (polygon.corners[side], polygon.corners[(side + 1) % polygon.count]);
        if most > S::ZERO && (self.c - a).dot(b - a) < S::ZERO {
            return away(self.c - a, self.r);
        }
        if most > S::ZERO && (self.c - b).dot(a - b) < S::ZERO {
            return away(self.c - b, self.r);
        }
        Some(Exit { depth: self.r - most, along: polygon.normals[side] })
    }

    fn out_of_disc(&self, centre: Vector<S>, toward: Vector<S>, cell: S) -> Option<Exit<S>> {
        let d = mirrored(self.c - centre, toward);
        let exit = if d.x >= S::ZERO && d.y >= S::ZERO {
            let sides = through_sides(Vector { x: d.x + self.r, y: d.y + self.r });
            shorter(away(d, cell + self.r)?, sides)
        } else {
            let nearest = d.clamped(Vector { x: S::ZERO, y: S::ZERO }, Vector { x: cell, y: cell });
            away(d - nearest, self.r)?
        };
        Some(Exit { depth: exit.depth, along: mirrored(exit.along, toward) })
    }

    fn out_of_hollow(&self, centre: Vector<S>, toward: Vector<S>, cell: S) -> Option<Exit<S>> {
        let d = mirrored(self.c - centre, toward);
        let zero = S::ZERO;
        let exit = if d.x > cell || d.y > cell {
            // From behind: the sides of the solid there.
            away(d - d.clamped(Vector { x: zero, y: zero }, Vector { x: cell, y: cell }), self.r)?
        } else if d.x >= zero && d.y >= zero {
            let distance = d.dot(d).root();
            let depth = distance + self.r - cell;
            if depth <= zero || distance <= zero {
                return None;
            }
            Exit { depth, along: Vector { x: -d.x / distance, y: -d.y / distance } }
        } else {
            // From beside: its tips.
            let tips = [Vector { x: cell, y: zero }, Vector { x: zero, y: cell }];
            let [a, b] = tips.map(|tip| away(d - tip, self.r));
            a.or(b)?
        };
        Some(Exit { depth: exit.depth, along: mirrored(exit.along, toward) })
    }
}

impl<S: Scalar> Body<S> for Aabb<S> {
    fn moved(&self, by: Vector<S>) -> Self {
        Self { lo: self.lo + by, hi: self.hi + by }
    }

    fn bounds(&self) -> Aabb<S> {
        *self
    }

    fn out_of_full(&self, cell: S) -> Option<Exit<S>> {
        contact_aabb_aabb(self, &square(cell)).map(|c| Exit { depth: c.depth, along: negated(c.normal) })
    }

    fn out_of_polygon(&self, polygon: &Polygon<S>) -> Option<Exit<S>> {
        let (mut lo, mut hi) = (polygon.corners[0], polygon.corners[0]);
        for p in &polygon.corners[1..polygon.count] {
            lo = Vector { x: lo.x.least(p.x), y: lo.y.least(p.y) };
            hi = Vector { x: hi.x.most(p.x), y: hi.y.most(p.y) };
        }
        let flat = contact_aabb_aabb(self, &Aabb { lo, hi })?;
        let mut exit = Exit { depth: flat.depth, along: negated(flat.normal) };
        for (n, a) in polygon.normals.iter().zip(&polygon.corners).take(polygon.count) {
            // The corner that is deepest below this side.
            let x = if n.x > S::ZERO { self.lo.x } else { self.hi.x };
            let y = if n.y > S::ZERO { self.lo.y } else { self.hi.y };
            let depth = n.dot(*a - Vector { x, y });
            if depth <= S::ZERO {
                return None;
            }
            exit = shorter(exit, Exit { depth, along: *n });
        }
        Some(exit)
    }

    fn out_of_disc(&self, centre: Vector<S>, toward: Vector<S>, cell: S) -> Option<Exit<S>> {
        let (near, far) = corners(self, centre, toward);
        let zero = Vector { x: S::ZERO, y: S::ZERO };
        if far.x <= S::ZERO || far.y <= S::ZERO || near.x >= cell || near.y >= cell {
            return None;
        }
        let nearest = near.clamped(zero, Vector { x: cell, y: cell });
        let sides = through_sides(far);
        // Over the centre it has no direction of its own.
        let exit = if nearest.dot(nearest) > S::ZERO { shorter(away(nearest, cell)?, sides) } else { sides };
        Some(Exit { depth: exit.depth, along: mirrored(exit.along, toward) })
    }

    fn out_of_hollow(&self, centre: Vector<S>, toward: Vector<S>, cell: S) -> Option<Exit<S>> {
        let (near, far) = corners(self, centre, toward);
        if far.x <= S::ZERO || far.y <= S::ZERO || near.x >= cell || near.y >= cell {
            return None;
        }
        if near.x + far.x > cell + cell || near.y + far.y > cell + cell {
            // From behind.
            return self.out_of_full(cell);
        }
        let corner = Vector { x: far.x.least(cell), y: far.y.least(cell) };
        let distance = corner.dot(corner).root();
        let depth = distance - cell;
        if depth <= S::ZERO {
            return None;
        }
        let along = Vector { x: -corner.x / distance, y: -corner.y / distance };
        Some(Exit { depth, along: mirrored(along, toward) })
    }
}

/// A box's corners nearest to and farthest into a cell, seen from a corner of it.
fn corners<S: Scalar>(b: &Aabb<S>, centre: Vector<S>, toward: Vector<S>) -> (Vector<S>, Vector<S>) {
    let (p, q) = (mirrored(b.lo - centre, toward), mirrored(b.hi - centre, toward));
    (Vector { x: p.x.least(q.x), y: p.y.least(q.y) }, Vector { x: p.x.most(q.x), y: p.y.most(q.y) })
}
