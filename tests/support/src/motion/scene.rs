//! Random levels and bodies that fit into them.

use super::P;
use super::body::{Body, px};
use super::level::{COIN, DEADLY, Level, ONE_WAY, SOLID};
use crate::Random;
use tilesat::Outside;

/// A level of random blocks: `solid` and `one_way` in percent.
pub fn blocks(r: &mut Random, size: P, cell: i64, solid: i64, one_way: i64) -> Level {
    let tiles = (0..size.0 * size.1)
        .map(|_| {
            let k = r.below(100);
            if k < solid {
                if r.one_in(8) { DEADLY } else { SOLID }
            } else if k < solid + one_way {
                ONE_WAY
            } else if r.one_in(20) {
                COIN
            } else {
                b'.'
            }
        })
        .collect();
    Level { tiles, width: size.0, height: size.1, cell, origin: (0, 0), outside: Outside::Solid }
}

/// A body of random kind and size with area, half of them in whole units; up to `largest` units
/// wide.
pub fn any_body(r: &mut Random, largest: i64) -> Body {
    let size = |r: &mut Random| {
        if r.one_in(2) { px(r.within(2, largest)) } else { r.within(2, px(largest)) }
    };
    match r.below(5) {
        0 | 1 => Body::rect((0, 0), (size(r), size(r))),
        2 | 3 => Body::disc((0, 0), (size(r) / 2).max(1)),
        _ => {
            let (long, radius) = (size(r), (size(r) / 2).max(1));
            Body::Disc { c: (0, 0), core: if r.one_in(2) { (long, 0) } else { (0, long) }, r: radius }
        }
    }
}

/// The body at a free place of the map, if one is found soon; in whole units half of the time.
pub fn placed(r: &mut Random, level: &Level, body: Body) -> Option<Body> {
    for _ in 0..200 {
        let (mut x, mut y) = (r.below(level.width * level.cell), r.below(level.height * level.cell));
        if r.one_in(2) {
            (x, y) = (x & !0xffff, y & !0xffff);
        }
        let there = body.moved((level.origin.0 + x, level.origin.1 + y));
        if !level.overlaps(&there) {
            return Some(there);
        }
    }
    None
}

/// A velocity with components up to `fastest` units: any, whole, along an axis, or diagonal.
pub fn any_velocity(r: &mut Random, fastest: i64) -> P {
    let raw = px(fastest);
    match r.below(6) {
        0 => (px(r.around(fastest)), px(r.around(fastest))),
        1 => (r.around(raw), 0),
        2 => (0, r.around(raw)),
        3 => {
            let v = r.around(raw);
            (v, v * r.sign())
        }
        4 => (r.sign() * r.magnitude(raw), r.sign() * r.magnitude(raw)),
        _ => (r.around(raw), r.around(raw)),
    }
}
