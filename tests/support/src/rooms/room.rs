//! A level as regions, for exact tests at exact positions.

use super::P;
use super::body::Body;
use crate::gcd;
use crate::shapes::level::Level;
use crate::shapes::region::Region;

/// Parts of a raw unit for positions. Even ones, because slopes are cut at even positions only.
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
        // One raw unit more: the position may be a fraction.
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

    /// Whether all of a motion is free, including its start. Tests `samples` positions of equal
    /// distance. Also where a centre or a corner of the body is level with a corner or the centre
    /// of an arc.
    ///
    /// Between two of the latter positions, a body of boxes and discs only approaches a piece, or
    /// only leaves it. So it finds even a bite of a raw unit out of a corner. These positions are
    /// rounded to the grain of a room. Along an axis or a slope of tiles they stay on the line.
    pub fn is_free(&self, body: Body, d: P, samples: i64) -> bool {
        let step = gcd(d.0.abs(), d.1.abs());
        let abreast = |from: P| {
            let from = (i128::from(from.0 * FINE), i128::from(from.1 * FINE));
            let (x, y) = (i128::from(d.0), i128::from(d.1));
            let square = x * x + y * y;
            self.solids.iter().flatten().flat_map(Region::marks).filter_map(move |mark| {
                let along = (mark.0 - from.0) * x + (mark.1 - from.1) * y;
                // Even positions, as the grain requires.
                let at = |c: i128| (along * c + square).div_euclid(2 * square) as i64;
                let on_the_line = ((d.0 / step, d.1 / step), 2 * at(step.into()));
                let place = if step < 64 { ((at(x), at(y)), 2) } else { on_the_line };
                (along > 0 && along < square * i128::from(FINE)).then_some(place)
            })
        };
        let parts = body.parts().map_or(vec![body], Vec::from);
        let marks = parts.into_iter().flat_map(|part| {
            if let Body::Disc(c, _) = part {
                return vec![c];
            }
            let (lo, hi) = part.bounds();
            vec![lo, (hi.0, lo.1), hi, (lo.0, hi.1)]
        });
        (0..=samples).all(|k| !self.overlaps(body, d, k * FINE / samples))
            && marks.flat_map(abreast).all(|(d, num)| !self.overlaps(body, d, num))
    }
}
