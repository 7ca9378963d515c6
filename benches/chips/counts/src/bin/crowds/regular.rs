//! A regular grid, which the library does not have, for comparison. Every body is in each cell that
//! its box touches, up to four of them.
//!
//! Every cell that holds both bodies finds the pair. The cell with the lower corner of the boxes'
//! intersection reports it.

use tilesat::Aabb;

/// Cells of 32 units in the room of 1024 x 768.
const COLUMNS: usize = 32;
const ROWS: usize = 24;
/// From raw units to cells.
const SHIFT: u32 = 21;
const NIL: u16 = u16::MAX;

/// An entry of one body in one cell.
#[derive(Clone, Copy)]
struct Node {
    next: u16,
    prev: u16,
    cell: u16,
}

/// N bodies with four nodes each: 24 bytes per body beside its box.
pub struct Regular<const N: usize> {
    boxes: [Aabb; N],
    nodes: [[Node; 4]; N],
    heads: [u16; COLUMNS * ROWS],
    occupied: [u32; ROWS],
}

impl<const N: usize> Regular<N> {
    pub fn new(blank: Aabb) -> Self {
        Self {
            boxes: [blank; N],
            nodes: [[Node { next: NIL, prev: NIL, cell: NIL }; 4]; N],
            heads: [NIL; COLUMNS * ROWS],
            occupied: [0; ROWS],
        }
    }

    /// Moves every body and adds up all pairs.
    pub fn frame(&mut self, boxes: &[Aabb; N], mut each: impl FnMut(usize, usize)) {
        for (body, bounds) in boxes.iter().enumerate() {
            self.move_to(body, bounds);
        }
        for row in 0..ROWS {
            let mut cells = self.occupied[row];
            while cells != 0 {
                let cell = row * COLUMNS + cells.trailing_zeros() as usize;
                cells &= cells - 1;
                self.pairs_in(cell, &mut each);
            }
        }
    }

    fn pairs_in(&self, cell: usize, each: &mut impl FnMut(usize, usize)) {
        let mut first = self.heads[cell];
        while first != NIL {
            let a = &self.boxes[usize::from(first) >> 2];
            let mut second = self.node(first).next;
            while second != NIL {
                let b = &self.boxes[usize::from(second) >> 2];
                let (low, high) = (a.min().max(b.min()), a.max().min(b.max()));
                if low.x <= high.x && low.y <= high.y && cell_of(low.x.to_bits(), low.y.to_bits()) == cell {
                    each(usize::from(first) >> 2, usize::from(second) >> 2);
                }
                second = self.node(second).next;
            }
            first = self.node(first).next;
        }
    }

    fn move_to(&mut self, body: usize, bounds: &Aabb) {
        self.boxes[body] = *bounds;
        let ((x0, y0), (x1, y1)) = (bounds.min().raw(), bounds.max().raw());
        let (wide, high) = (x0 >> SHIFT != x1 >> SHIFT, y0 >> SHIFT != y1 >> SHIFT);
        let wanted =
            [Some((x0, y0)), wide.then_some((x1, y0)), high.then_some((x0, y1)), (wide && high).then_some((x1, y1))];
        for (k, corner) in wanted.into_iter().enumerate() {
            let cell = corner.map_or(NIL, |(x, y)| cell_of(x, y) as u16);
            if self.nodes[body][k].cell != cell {
                let node = (body << 2 | k) as u16;
                self.unlink(node);
                self.link(node, cell);
            }
        }
    }

    fn unlink(&mut self, node: u16) {
        let Node { next, prev, cell } = self.node(node);
        if cell == NIL {
            return;
        }
        if next != NIL {
            self.node_mut(next).prev = prev;
        }
        if prev != NIL {
            self.node_mut(prev).next = next;
            return;
        }
        self.heads[usize::from(cell)] = next;
        if next == NIL {
            self.occupied[usize::from(cell) / COLUMNS] &= !(1 << (usize::from(cell) % COLUMNS));
        }
    }

    fn link(&mut self, node: u16, cell: u16) {
        *self.node_mut(node) = Node { next: NIL, prev: NIL, cell };
        if cell == NIL {
            return;
        }
        let next = self.heads[usize::from(cell)];
        self.node_mut(node).next = next;
        if next != NIL {
            self.node_mut(next).prev = node;
        }
        self.heads[usize::from(cell)] = node;
        self.occupied[usize::from(cell) / COLUMNS] |= 1 << (usize::from(cell) % COLUMNS);
    }

    fn node(&self, node: u16) -> Node {
        self.nodes[usize::from(node) >> 2][usize::from(node) & 3]
    }

    fn node_mut(&mut self, node: u16) -> &mut Node {
        &mut self.nodes[usize::from(node) >> 2][usize::from(node) & 3]
    }
}

/// Clamped to the room: bodies touch its walls.
fn cell_of(x: i32, y: i32) -> usize {
    let column = ((x >> SHIFT).max(0) as usize).min(COLUMNS - 1);
    let row = ((y >> SHIFT).max(0) as usize).min(ROWS - 1);
    row * COLUMNS + column
}
