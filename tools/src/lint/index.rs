//! Which edges are near each other: a grid.

use std::collections::HashMap;

use super::geometry::Edge;

/// Squares of a side that gives each edge about one.
pub(super) struct Index {
    side: i64,
    cells: HashMap<(i64, i64), Vec<usize>>,
}

impl Index {
    pub(super) fn new(edges: &[Edge]) -> Self {
        let (mut lo, mut hi) = ((i64::MAX, i64::MAX), (i64::MIN, i64::MIN));
        for p in edges.iter().flat_map(|edge| [edge.a, edge.b]) {
            lo = (lo.0.min(p.0), lo.1.min(p.1));
            hi = (hi.0.max(p.0), hi.1.max(p.1));
        }
        let area = if edges.is_empty() { 0 } else { (hi.0 - lo.0) * (hi.1 - lo.1) / edges.len() as i64 };
        let mut index = Self { side: area.isqrt().max(1 << 16), cells: HashMap::new() };
        for (i, edge) in edges.iter().enumerate() {
            walk(edge, 0, index.side, |cell| index.cells.entry(cell).or_default().push(i));
        }
        index
    }

    /// All edges within `margin` of this one, in order, and some further away.
    pub(super) fn near(&self, edge: &Edge, margin: i64) -> Vec<usize> {
        let mut found = Vec::new();
        walk(edge, margin, self.side, |cell| found.extend(self.cells.get(&cell).into_iter().flatten()));
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// The cells that an edge meets when it is fattened by a margin.
fn walk(edge: &Edge, margin: i64, side: i64, mut visit: impl FnMut((i64, i64))) {
    let (top, bottom) = if edge.a.1 <= edge.b.1 { (edge.a, edge.b) } else { (edge.b, edge.a) };
    let first = (top.1 - margin).div_euclid(side);
    let last = (bottom.1 + margin).div_euclid(side);
    let (dx, dy) = (i128::from(bottom.0 - top.0), i128::from(bottom.1 - top.1));
    for row in first..=last {
        // Where the edge is at the row's ends; one raw more for the rounding.
        let at = |y: i64| match dy {
            0 => None,
            _ => Some(top.0 + (dx * i128::from(y.clamp(top.1, bottom.1) - top.1)).div_euclid(dy) as i64),
        };
        let ends = [at(row * side - margin).unwrap_or(top.0), at((row + 1) * side + margin).unwrap_or(bottom.0)];
        let from = (ends[0].min(ends[1]) - margin - 1).div_euclid(side);
        let to = (ends[0].max(ends[1]) + margin + 1).div_euclid(side);
        (from..=to).for_each(|column| visit((column, row)));
    }
}
