//! Exact answers about boxes and circles in plain integers, without the library's code.

use super::{P, raw};
use tilesat::{Aabb, Body, Capsule, Circle, Solid};

/// A box from `lo` to `hi`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    pub lo: P,
    pub hi: P,
}

impl Block {
    pub fn of(b: &Aabb) -> Self {
        Self { lo: raw(b.min()), hi: raw(b.max()) }
    }

    pub fn moved(self, d: P) -> Self {
        Self { lo: (self.lo.0 + d.0, self.lo.1 + d.1), hi: (self.hi.0 + d.0, self.hi.1 + d.1) }
    }

    /// All places on a straight way.
    pub fn swept(self, d: P) -> Self {
        let to = self.moved(d);
        Self {
            lo: (self.lo.0.min(to.lo.0), self.lo.1.min(to.lo.1)),
            hi: (self.hi.0.max(to.hi.0), self.hi.1.max(to.hi.1)),
        }
    }

    pub fn meets(self, o: Self) -> bool {
        self.lo.0 < o.hi.0 && o.lo.0 < self.hi.0 && self.lo.1 < o.hi.1 && o.lo.1 < self.hi.1
    }

    /// Whether it passes through the inside of `o` on a straight way: the times at which both axes
    /// overlap, as fractions.
    pub fn passes(self, d: P, o: Self) -> bool {
        // Open times (num, den) after which / before which an axis overlaps; None: never.
        let axis = |lo: i64, hi: i64, d: i64, a: i64, b: i64| -> Option<((i128, i128), (i128, i128))> {
            let all = ((0, 1), (1, 1));
            if d == 0 {
                return (lo < b && a < hi).then_some(all);
            }
            let (first, last) = if d > 0 { (a - hi, b - lo) } else { (lo - b, hi - a) };
            let den = i128::from(d.abs());
            Some(((i128::from(first), den), (i128::from(last), den)))
        };
        let x = axis(self.lo.0, self.hi.0, d.0, o.lo.0, o.hi.0);
        let y = axis(self.lo.1, self.hi.1, d.1, o.lo.1, o.hi.1);
        let (Some(x), Some(y)) = (x, y) else { return false };
        let less = |a: (i128, i128), b: (i128, i128)| a.0 * b.1 < b.0 * a.1;
        let from = [x.0, y.0, (0, 1)].into_iter().reduce(|a, b| if less(a, b) { b } else { a }).unwrap();
        let to = [x.1, y.1, (1, 1)].into_iter().reduce(|a, b| if less(b, a) { b } else { a }).unwrap();
        less(from, to)
    }
}

/// The questions about both kinds of bodies.
pub trait Judged: Body + Copy + PartialEq + std::fmt::Debug {
    const IS_BOX: bool;
    fn block(&self) -> Block;

    fn show(&self) -> String {
        format!("{:?} {:?}", self.block(), raw(self.position()))
    }

    fn in_block(&self, block: Block) -> bool;
    fn at(&self, d: P) -> Self;
    fn mirrored(&self) -> Self;
    /// Whether it passes through a block's inside on a straight way. For circles, whether a disc a
    /// raw unit smaller would.
    fn goes_through(&self, d: P, block: Block) -> bool;

    fn overlaps_solid(&self, solid: &Solid) -> bool {
        solid.one_way().is_none() && self.in_block(Block::of(&solid.shape()))
    }
}

impl Judged for Aabb {
    const IS_BOX: bool = true;

    fn block(&self) -> Block {
        Block::of(self)
    }

    fn in_block(&self, block: Block) -> bool {
        self.block().meets(block)
    }

    fn at(&self, d: P) -> Self {
        let b = self.block().moved(d);
        super::rect(b.lo, b.hi)
    }

    fn mirrored(&self) -> Self {
        let b = self.block();
        super::rect((-b.lo.0, b.lo.1), (-b.hi.0, b.hi.1))
    }

    fn goes_through(&self, d: P, block: Block) -> bool {
        self.block().passes(d, block)
    }
}

impl Judged for Circle {
    const IS_BOX: bool = false;

    fn block(&self) -> Block {
        Block::of(&self.aabb())
    }

    fn in_block(&self, block: Block) -> bool {
        let (c, r) = (raw(self.centre()), i64::from(self.radius().to_bits()));
        let gap = |c: i64, lo: i64, hi: i64| i128::from((lo - c).max(c - hi).max(0));
        let (x, y) = (gap(c.0, block.lo.0, block.hi.0), gap(c.1, block.lo.1, block.hi.1));
        x * x + y * y < i128::from(r) * i128::from(r)
    }

    fn at(&self, d: P) -> Self {
        let c = raw(self.centre());
        super::disc((c.0 + d.0, c.1 + d.1), i64::from(self.radius().to_bits()))
    }

    fn mirrored(&self) -> Self {
        let c = raw(self.centre());
        super::disc((-c.0, c.1), i64::from(self.radius().to_bits()))
    }

    fn goes_through(&self, d: P, block: Block) -> bool {
        let (c, r) = (raw(self.centre()), i64::from(self.radius().to_bits()) - 1);
        if r <= 0 {
            return false;
        }
        let centre = Block { lo: c, hi: c };
        let grown =
            |x: i64, y: i64| Block { lo: (block.lo.0 - x, block.lo.1 - y), hi: (block.hi.0 + x, block.hi.1 + y) };
        let near = |p: P| {
            // The distance of p from the way, against r: all in integers.
            let (m, dd) =
                ((p.0 - c.0, p.1 - c.1), i128::from(d.0) * i128::from(d.0) + i128::from(d.1) * i128::from(d.1));
            let dot = i128::from(m.0) * i128::from(d.0) + i128::from(m.1) * i128::from(d.1);
            let cross = i128::from(m.0) * i128::from(d.1) - i128::from(m.1) * i128::from(d.0);
            let len2 = |p: P| i128::from(p.0) * i128::from(p.0) + i128::from(p.1) * i128::from(p.1);
            let rr = i128::from(r) * i128::from(r);
            if dot <= 0 {
                len2(m) < rr
            } else if dot >= dd {
                len2((m.0 - d.0, m.1 - d.1)) < rr
            } else {
                cross * cross < rr * dd
            }
        };
        let corners = [block.lo, (block.hi.0, block.lo.1), block.hi, (block.lo.0, block.hi.1)];
        centre.passes(d, grown(r, 0)) || centre.passes(d, grown(0, r)) || corners.into_iter().any(near)
    }
}

/// A capsule meets a block if the disc around the end of its core with the smaller coordinates
/// meets the block stretched by the core.
struct End {
    disc: Circle,
    core: P,
}

impl End {
    fn of(capsule: &Capsule) -> Self {
        let core = capsule.core().aabb();
        let (lo, hi) = (raw(core.min()), raw(core.max()));
        Self { disc: super::disc(lo, capsule.radius().to_bits().into()), core: (hi.0 - lo.0, hi.1 - lo.1) }
    }

    fn drawn_out(&self, block: Block) -> Block {
        Block { lo: (block.lo.0 - self.core.0, block.lo.1 - self.core.1), hi: block.hi }
    }
}

impl Judged for Capsule {
    const IS_BOX: bool = false;

    fn block(&self) -> Block {
        Block::of(&self.aabb())
    }

    fn in_block(&self, block: Block) -> bool {
        let end = End::of(self);
        end.disc.in_block(end.drawn_out(block))
    }

    fn at(&self, d: P) -> Self {
        self.translated(super::vec2(d)).unwrap()
    }

    fn mirrored(&self) -> Self {
        let turn = |p: tilesat::Vec2| super::vec2((-raw(p).0, raw(p).1));
        Self::new(turn(self.a()), turn(self.b()), self.radius()).unwrap()
    }

    fn goes_through(&self, d: P, block: Block) -> bool {
        let end = End::of(self);
        end.disc.goes_through(d, end.drawn_out(block))
    }
}
