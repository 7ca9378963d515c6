//! Where segments are joined, by the angles of all rays around a point.
//!
//! Directions of the levels here have components of at most 2^12: two of them differ by more than
//! 2^-25, and an angle's error is below 2^-50.

use super::level::{Level, NONE, ONE_WAY, Point, Seg};
use std::f64::consts::{PI, TAU};

const NEAR: f64 = 1e-9;

fn angle(d: Point) -> f64 {
    f64::from(d.1 as i32).atan2(f64::from(d.0 as i32))
}

fn holds(s: &Seg, p: Point) -> bool {
    let (mx, my) = (i128::from(p.0 - s.a.0), i128::from(p.1 - s.a.1));
    let (dx, dy) = (i128::from(s.dir.0), i128::from(s.dir.1));
    let along = mx * dx + my * dy;
    mx * dy == my * dx && along >= 0 && along <= i128::from(s.len) * (dx * dx + dy * dy)
}

/// The free angle at an end of a segment, the first segment that continues from there (at the
/// start: that arrives), and whether one of those is one-way.
fn free(level: &Level, s: &Seg, at_end: bool) -> (f64, u16, bool) {
    let p = if at_end { s.b() } else { s.a };
    let base = if at_end { angle((-s.dir.0, -s.dir.1)) } else { angle(s.dir) };
    let mut rays: Vec<(f64, bool, u16, bool)> = Vec::new();
    for (i, other) in level.segs.iter().enumerate() {
        let one_way = other.kind == ONE_WAY;
        if !holds(other, p) || one_way && s.kind != ONE_WAY {
            continue;
        }
        for (dir, leaves) in [(other.dir, true), ((-other.dir.0, -other.dir.1), false)] {
            let there = if leaves { p != other.b() } else { p != other.a };
            if !there || one_way && leaves != at_end {
                continue;
            }
            let turn = if at_end { angle(dir) - base } else { base - angle(dir) };
            let turn = turn.rem_euclid(TAU);
            let turn = if turn < NEAR { TAU } else { turn };
            rays.push((turn, leaves == at_end, i as u16, one_way));
        }
    }
    let first = rays.iter().map(|r| r.0).fold(TAU, f64::min);
    let group = || rays.iter().filter(|r| r.0 < first + NEAR);
    let index = group().filter(|r| r.1).map(|r| r.2).min().unwrap_or(NONE);
    (first, index, group().any(|r| r.3))
}

pub fn check_joints(level: &Level) {
    for (i, s) in level.segs.iter().enumerate() {
        let (end, next, end_one_way) = free(level, s, true);
        let (start, before, start_one_way) = free(level, s, false);
        let expected = if s.kind == ONE_WAY {
            let goes_on = |turn: f64, one_way: bool| turn < PI + NEAR || one_way && turn < TAU - NEAR;
            let kink = end > PI + NEAR && end < TAU - NEAR && end_one_way;
            (if kink { next } else { NONE }, goes_on(start, start_one_way), goes_on(end, end_one_way))
        } else {
            let next = if end > PI + NEAR { next } else { NONE };
            (next, start < PI + NEAR || before == NONE, next == NONE)
        };
        assert_eq!((s.next, s.start_joined, s.end_joined), expected, "segment {i} of {level:?}");
    }
}
