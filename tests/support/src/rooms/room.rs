//! A level as regions, for exact questions at exact places.

use super::P;
use super::body::Body;
use crate::shapes::level::Level;
use crate::shapes::region::Region;

/// Parts of a raw unit that positions are asked in; even ones, because slopes are cut at even
/// places only.
pub const FINE: i64 = 512;

pub struct Room {
    level: Level,
    /// The solid of each cell, the band outside (all solid) included, in parts of a raw unit.
    solids: Vec<Option<Region>>,
}

impl Room {
    pub fn new(level: &Level) -> Self {
        let solids: Vec<_> = level.pieces(FINE.into()).into_iter().map(|p| p.solid).collect();
        assert_eq!(solids.len() as i64, (level.width + 2) * (level.height + 2));
        Self { level: level.clone(), solids }
    }

    /// Whether the body overlaps the solid after `num / FINE` of a motion.
    pub fn overlaps(&self, body: Body, d: P, num: i64) -> bool {
        if let Some(parts) = body.parts() {
            return parts.into_iter().any(|part| self.overlaps(part, d, num));
        }
        let (lo, hi) = body.bounds();
        let l = &self.level;
        // One raw unit more: the place may be a fraction.
        assert_eq!(num % 2, 0);
        let cells = |lo: i64, hi: i64, d: i64, origin: i64, count: i64| {
            let by = (d * num).div_euclid(FINE);
            let cell = |x: i64| (x - origin).div_euclid(l.cell).clamp(-1, count);
            cell(lo + by - 1)..=cell(hi + by + 2)
        };
        let scaled =
            |p: P| (i128::from(p.0 * FINE) + i128::from(d.0 * num), i128::from(p.1 * FINE) + i128::from(d.1 * num));
        let (p, q) = (scaled(lo), scaled(hi));
        let end = (l.x + l.width * l.cell, l.y + l.height * l.cell);
        let fine = |x: i64| i128::from(x * FINE);
        // All is solid outside.
        if p.0 < fine(l.x) || p.1 < fine(l.y) || q.0 > fine(end.0) || q.1 > fine(end.1) {
            return true;
        }
        cells(lo.1, hi.1, d.1, l.y, l.height).any(|row| {
            cells(lo.0, hi.0, d.0, l.x, l.width).any(|column| {
                if row < 0 || column < 0 || row >= l.height || column >= l.width {
                    return false;
                }
                let k = (row + 1) * (l.width + 2) + column + 1;
                self.solids[k as usize].as_ref().is_some_and(|solid| match body {
                    Body::Disc(c, r) => {
                        let (c, r) = (scaled(c), i128::from(r * FINE));
                        solid.contains(c) || solid.border_within(c, r, false)
                    }
                    Body::Rect(..) | Body::Pill(..) => solid.meets_box(p, q, true),
                })
            })
        })
    }
}
