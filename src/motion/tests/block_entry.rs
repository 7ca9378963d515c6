//! The part of a block that a motion enters.

use super::super::block_entry::{EnteredPart, entered};
use super::super::sweep_body::corner;
use super::super::sweep_face::{Face, sweep_face};
use super::super::sweep_round::{self, enter_quarter};
use crate::num::{Axis, Raw};
use crate::query::cast::crossing::Crossing;

const LO: Raw = Raw { x: 0, y: 0 };
const HI: Raw = Raw { x: 4, y: 3 };

fn face(along_x: bool, d: Raw) -> Face {
    let (a, dir, len) = match (along_x, d.x < 0, d.y < 0) {
        (true, false, _) => (Raw { x: 0, y: 3 }, Axis::NEG_Y, 3),
        (true, true, _) => (Raw { x: 4, y: 0 }, Axis::Y, 3),
        (false, _, false) => (LO, Axis::X, 4),
        (false, _, true) => (HI, Axis::NEG_X, 4),
    };
    Face { a, dir, len, joined: [false; 2] }
}

/// Boxes, discs and capsules at all places around a cell, by all short motions. Sweeps against
/// each side and each corner find what this one decision says, and nothing else. The disc of
/// the corner that it names is entered in that corner's quadrant, or not at all.
#[test]
fn one_part_is_entered_and_no_other() {
    let mut found = [0u32; 4];
    for (w, h, r) in [(1, 1, 0), (3, 5, 0), (6, 2, 0), (0, 0, 1), (0, 0, 2), (0, 0, 3), (0, 2, 2), (5, 0, 1)] {
        for (x, y) in (-11..10).flat_map(|x| (-11..10).map(move |y| (x, y))) {
            let (first, last) = (Raw { x, y }, Raw { x: x + w, y: y + h });
            for d in (-8..9).flat_map(|x| (-8..9).map(move |y| Raw { x, y })) {
                let part = entered((first, last), r, d, (LO, HI));
                let case = (first, last, r, d, part);
                for along_x in [true, false] {
                    let entry = sweep_face((first, last), r, d, &face(along_x, d));
                    let mine = if along_x { EnteredPart::X } else { EnteredPart::Y };
                    assert_eq!(entry.is_some(), part == Some(mine) || part == Some(EnteredPart::Both), "{case:?}");
                    assert!(entry.is_none_or(|entry| entry.at_end == (part == Some(EnteredPart::Both))), "{case:?}");
                }
                for (x, y) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
                    let side = Axis::new(x, y);
                    let m = corner(last, first, side).sub(corner(LO, HI, side));
                    let entry = enter_quarter(m, r, d, side, false);
                    if part == Some(EnteredPart::Corner(x, y)) {
                        let disc = Crossing::of(m, r, d).and_then(|hit| sweep_round::entry(&hit, m, d));
                        assert_eq!(disc.is_some(), entry.is_some(), "{case:?} {x} {y}");
                    } else {
                        assert!(r == 0 || entry.is_none(), "{case:?} {x} {y}");
                    }
                }
                match part {
                    Some(EnteredPart::X | EnteredPart::Y) => found[0] += 1,
                    Some(EnteredPart::Both) => found[1] += 1,
                    Some(EnteredPart::Corner(..)) => found[2] += 1,
                    None => found[3] += 1,
                }
            }
        }
    }
    assert!(found.iter().all(|&count| count > 300), "{found:?}");
}
