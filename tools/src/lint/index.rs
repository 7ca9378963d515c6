//! Finds edges that are near each other: a tree of boxes, with a limit on the work.

use crate::geometry::{Edge, Point, orient};

/// A closed box.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    lo: Point,
    hi: Point,
}

impl Bounds {
    const NOTHING: Self = Self { lo: (i64::MAX, i64::MAX), hi: (i64::MIN, i64::MIN) };

    pub(super) fn of([p, q]: [Point; 2]) -> Self {
        Self { lo: (p.0.min(q.0), p.1.min(q.1)), hi: (p.0.max(q.0), p.1.max(q.1)) }
    }

    /// From a point of doubled coordinates along x without end.
    pub(super) fn ray((x, y): Point) -> Self {
        Self { lo: (x.div_euclid(2), y.div_euclid(2)), hi: (i64::MAX, (y + 1).div_euclid(2)) }
    }

    fn with(self, other: &Self) -> Self {
        let lo = (self.lo.0.min(other.lo.0), self.lo.1.min(other.lo.1));
        Self { lo, hi: (self.hi.0.max(other.hi.0), self.hi.1.max(other.hi.1)) }
    }

    fn fattened(self, margin: i64) -> Self {
        Self { lo: (self.lo.0 - margin, self.lo.1 - margin), hi: (self.hi.0 + margin, self.hi.1 + margin) }
    }

    fn meets(&self, other: &Self) -> bool {
        self.lo.0 <= other.hi.0 && other.lo.0 <= self.hi.0 && self.lo.1 <= other.hi.1 && other.lo.1 <= self.hi.1
    }

    /// Whether all of it lies strictly on one side of an edge's line.
    fn is_beside(&self, edge: &Edge) -> bool {
        let ((x0, y0), (x1, y1)) = (self.lo, self.hi);
        let sides = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|corner| orient(edge.a, edge.b, corner).signum());
        sides.iter().sum::<i128>().abs() == 4
    }
}

/// The boxes that a check may look at. They suffice for every carefully drawn level. If many things
/// overlap, all pairs are too many, and this allows n log n of them.
#[derive(Debug)]
pub(super) struct Work(u64);

impl Work {
    /// Levels of real games need less than 100 boxes per edge. A twentieth of the factor would
    /// suffice.
    pub(super) fn for_edges(count: usize) -> Self {
        let count = count as u64;
        Self(128 * (count + 1024) * u64::from(count.max(2).ilog2()))
    }

    pub(super) fn is_spent(&self) -> bool {
        self.0 == 0
    }

    fn spend(&mut self) -> bool {
        self.0 = self.0.saturating_sub(1);
        !self.is_spent()
    }
}

const CHILDREN: usize = 8;

/// The edges in the order of the tree's leaves. The boxes of each edge, of each eight of these, and
/// so on up to one.
pub(super) struct Index {
    order: Vec<usize>,
    boxes: Vec<Vec<Bounds>>,
}

impl Index {
    /// As many strips along x as edges per strip, each sorted along y.
    pub(super) fn new(edges: &[Edge]) -> Self {
        let mut order: Vec<usize> = (0..edges.len()).collect();
        order.sort_by_key(|&i| edges[i].middle().0);
        let strip = CHILDREN * (edges.len() / CHILDREN).isqrt().max(1);
        for strip in order.chunks_mut(strip) {
            strip.sort_by_key(|&i| edges[i].middle().1);
        }
        let mut boxes = vec![order.iter().map(|&i| Bounds::of([edges[i].a, edges[i].b])).collect::<Vec<_>>()];
        while let Some(below) = boxes.last().filter(|level| level.len() > 1) {
            let around = |children: &[Bounds]| children.iter().fold(Bounds::NOTHING, Bounds::with);
            boxes.push(below.chunks(CHILDREN).map(around).collect());
        }
        Self { order, boxes }
    }

    /// All edges within `margin` of this one, and some that are farther. Fewer once the work is
    /// used up.
    pub(super) fn near<'a>(&'a self, edge: &Edge, margin: i64, work: &'a mut Work) -> Near<'a> {
        let window = Bounds::of([edge.a, edge.b]).fattened(margin);
        Near { along: Some((*edge, margin)), ..self.within(window, work) }
    }

    /// All edges whose box meets another. Fewer once the work is used up.
    pub(super) fn within<'a>(&'a self, window: Bounds, work: &'a mut Work) -> Near<'a> {
        let top = self.boxes.len() - 1;
        let stack = self.boxes[top].iter().map(|_| (top, 0)).collect();
        Near { index: self, window, along: None, stack, work }
    }
}

/// A walk through the tree.
pub(super) struct Near<'a> {
    index: &'a Index,
    window: Bounds,
    /// The edge whose neighbours it looks for, and the distance.
    along: Option<(Edge, i64)>,
    /// Boxes to look at: their level and index.
    stack: Vec<(usize, usize)>,
    work: &'a mut Work,
}

impl Iterator for Near<'_> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        while let Some((level, at)) = self.stack.pop() {
            if !self.work.spend() {
                return None;
            }
            let bounds = self.index.boxes[level][at];
            let beside = |(edge, margin): &(Edge, i64)| bounds.fattened(*margin).is_beside(edge);
            if !bounds.meets(&self.window) || self.along.as_ref().is_some_and(beside) {
                continue;
            }
            let Some(below) = level.checked_sub(1) else { return Some(self.index.order[at]) };
            let end = (CHILDREN * (at + 1)).min(self.index.boxes[below].len());
            self.stack.extend((CHILDREN * at..end).map(|child| (below, child)));
        }
        None
    }
}
