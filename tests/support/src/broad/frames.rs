//! Scenes of moving boxes: the changes from frame to frame, and the pairs of each frame.

use super::reference::{DOMAIN, Rect};
use super::{Cells, Mark};
use crate::Random;
use tilesat::broad::Tag;

/// How bodies are placed and how they move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// All over the grid and a little beyond it; slow.
    Uniform,
    /// Within two cells; slow.
    Cluster,
    /// In one cell: everything touches almost everything.
    OneCell,
    /// Sides on lines and middles of cells, up to 2 raw off, also at the borders of the grid.
    Lines,
    /// All at new places in every frame, in the whole domain or near each other.
    Teleport,
    /// All at one x or all at one y.
    Row,
    /// One in four is wider or higher than a cell, up to the whole grid.
    Large,
    /// Half of them come and go in every frame.
    Churn,
}

pub const KINDS: [Kind; 8] =
    [Kind::Uniform, Kind::Cluster, Kind::OneCell, Kind::Lines, Kind::Teleport, Kind::Row, Kind::Large, Kind::Churn];

#[derive(Clone, Copy, Debug)]
pub enum Change {
    Insert(u32, Rect, Mark),
    Move(u32, Rect),
    Remove(u32),
}

#[derive(Clone, Debug)]
pub struct Frame {
    pub changes: Vec<Change>,
    /// The keys of all pairs, the smaller one first, in order.
    pub pairs: Vec<(u32, u32)>,
    /// The bodies to remove in the middle of an enumeration, and the pairs without them.
    pub leave: Vec<u32>,
    pub left: Vec<(u32, u32)>,
}

/// A number of bodies that never exceeds `most`, and their frames. Keys are never reused.
pub fn scene(kind: Kind, cells: Cells, most: i64, frames: usize, random: &mut Random) -> Vec<Frame> {
    let mut scene = Scene { kind, cells, bodies: Vec::new(), next: 0 };
    let many = random.within(2, most);
    (0..frames).map(|frame| scene.frame(frame, many, random)).collect()
}

struct Scene {
    kind: Kind,
    cells: Cells,
    bodies: Vec<(u32, Rect, Mark)>,
    next: u32,
}

impl Scene {
    fn frame(&mut self, frame: usize, many: i64, random: &mut Random) -> Frame {
        let mut changes = Vec::new();
        let churn = if self.kind == Kind::Churn { 2 } else { 40 };
        if frame > 0 {
            for i in 0..self.bodies.len() {
                let (key, rect, _) = self.bodies[i];
                // One in ten rests.
                if !random.one_in(10) {
                    let to = self.moved(rect, random);
                    self.bodies[i].1 = to;
                    changes.push(Change::Move(key, to));
                }
            }
            let (gone, here) = std::mem::take(&mut self.bodies).into_iter().partition(|_| random.one_in(churn));
            self.bodies = here;
            changes.extend(<Vec<(u32, Rect, Mark)>>::into_iter(gone).map(|body| Change::Remove(body.0)));
        }
        while (self.bodies.len() as i64) < many {
            let mark = Mark::new(self.next, if random.one_in(4) { random.within(1, 3) as u8 } else { 0 });
            let rect = self.placed(random);
            changes.push(Change::Insert(self.next, rect, mark));
            self.bodies.push((self.next, rect, mark));
            self.next += 1;
        }
        let pairs = self.pairs();
        let many = if random.one_in(3) { random.within(1, 4).min(self.bodies.len() as i64) } else { 0 };
        let leave =
            (0..many).map(|_| self.bodies.swap_remove(random.below(self.bodies.len() as i64) as usize).0).collect();
        Frame { changes, pairs, leave, left: self.pairs() }
    }

    fn pairs(&self) -> Vec<(u32, u32)> {
        let mut pairs = Vec::new();
        for (i, (a, one, own)) in self.bodies.iter().enumerate() {
            for (b, other, its) in &self.bodies[i + 1..] {
                if one.touches(other) && own.pairs_with(its) {
                    pairs.push((*a.min(b), *a.max(b)));
                }
            }
        }
        pairs.sort_unstable();
        pairs
    }

    fn placed(&self, random: &mut Random) -> Rect {
        let side = i64::from(self.cells.side);
        let wide = 16 * side;
        let spread = match self.kind {
            Kind::Uniform | Kind::Churn | Kind::Large | Kind::Row => (-side, wide),
            Kind::Cluster => (3 * side, 5 * side),
            Kind::OneCell => (4 * side, 5 * side - 1),
            Kind::Lines => (-2 * side, 18 * side),
            Kind::Teleport if random.one_in(2) => (-2 * DOMAIN, 2 * DOMAIN),
            Kind::Teleport => (0, 3 * side),
        };
        let mut centre = [random.within(spread.0, spread.1), random.within(spread.0, spread.1)];
        let mut size = [0, 0].map(|_: i64| random.within(side / 5, 3 * side / 4));
        match self.kind {
            Kind::Row => centre[usize::from(self.cells.origin.0 & 1 == 0)] = 2 * side,
            Kind::Large if random.one_in(4) => size[random.below(2) as usize] = random.within(side, wide),
            Kind::Lines => {
                centre = centre.map(|v| v - v.rem_euclid((side / 2).max(1)) + random.around(2));
                size = [0, 0].map(|_: i64| (side * random.below(3) / 2 + random.around(2)).clamp(0, side));
            }
            _ => {}
        }
        self.inside([0, 1].map(|i| {
            let origin = [self.cells.origin.0, self.cells.origin.1][i];
            let lo = i64::from(origin) + centre[i] - size[i] / 2;
            (lo, lo + size[i])
        }))
    }

    /// Moved into the domain, sizes kept.
    fn inside(&self, spans: [(i64, i64); 2]) -> Rect {
        let [x, y] = spans.map(|(lo, hi)| {
            let shift = (1 - DOMAIN - lo).max(0) + (DOMAIN - 1 - hi).min(0);
            (lo + shift, hi + shift)
        });
        let rect = Rect { lo: (x.0, y.0), hi: (x.1, y.1) };
        assert!(rect.in_domain() && (self.kind == Kind::Large || rect.side() <= i64::from(self.cells.side)));
        rect
    }

    fn moved(&self, rect: Rect, random: &mut Random) -> Rect {
        if self.kind == Kind::Teleport || random.one_in(50) {
            return self.placed(random);
        }
        let step = (i64::from(self.cells.side) / 16).max(1);
        let d = match self.kind {
            Kind::Lines => (random.around(2), random.around(2)),
            Kind::Row if self.cells.origin.0 & 1 == 0 => (random.around(step), 0),
            Kind::Row => (0, random.around(step)),
            _ => (random.around(step), random.around(step)),
        };
        let to = rect.moved(d);
        self.inside([(to.lo.0, to.hi.0), (to.lo.1, to.hi.1)])
    }
}
