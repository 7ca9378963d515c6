//! Bytes that are no level: cut, changed, made up. All give an error, or a correct map.
//!
//! `TILESAT_CASES` sets the number of hostile levels (default 20 000).

use std::panic::catch_unwind;
use tilesat::PathKind::{Hole, OneWay, Solid, Wall};
use tilesat::{Cell, SegmentMap, SegmentMapError, TileMapError, world::SegmentFault};
use tilesat_judge::paths::generate;
use tilesat_judge::paths::level::{self, Level, NONE, ONE_WAY, Shape, decode, repair, shape};
use tilesat_judge::paths::oracle::check_refs;
use tilesat_judge::{Random, cases};

/// A house with a window, a wall and a platform.
fn house() -> Vec<Shape> {
    vec![
        shape(Solid, &[(0, 0), (1000, 0), (1000, 600), (500, 900), (0, 600)]),
        shape(Hole, &[(200, 200), (400, 200), (400, 400), (200, 400)]),
        shape(Wall, &[(1000, 600), (1200, 700), (1200, 100)]),
        shape(OneWay, &[(1000, 300), (1100, 300), (1200, 250)]),
    ]
}

fn levels() -> Vec<Vec<u8>> {
    let mut random = Random::new(77);
    let mut all = vec![level::bytes(&house(), 256).unwrap()];
    all.push(level::bytes(&[shape(Wall, &[(0, 0), (1, 0)])], 256).unwrap());
    all.extend((0..2).map(|_| level::bytes(&level::placed(&generate::heap(&mut random, 6), 60, (0, 0)), 258).unwrap()));
    all
}

#[test]
fn every_change_of_a_byte_is_refused() {
    for bytes in levels() {
        for at in 0..bytes.len() {
            for by in 1..=255u8 {
                let mut bytes = bytes.clone();
                bytes[at] ^= by;
                assert!(SegmentMap::from_bytes(&bytes).is_err(), "byte {at} ^ {by}");
            }
        }
    }
}

#[test]
fn every_other_length_is_refused() {
    for bytes in levels() {
        for to in 0..bytes.len() {
            let mut short = bytes[..to].to_vec();
            assert!(
                matches!(SegmentMap::from_bytes(&short), Err(SegmentMapError::Length { found, .. }) if found == to as u32)
            );
            repair(&mut short);
            assert!(SegmentMap::from_bytes(&short).is_err(), "{to}");
        }
        for more in [1, 2, 24] {
            let mut long = bytes.clone();
            long.resize(bytes.len() + more, 0);
            repair(&mut long);
            assert!(matches!(SegmentMap::from_bytes(&long), Err(SegmentMapError::Length { .. })));
        }
    }
}

/// The house's level with one change and a correct checksum, and the error.
fn said(change: impl Fn(&mut Vec<u8>)) -> SegmentMapError {
    let mut bytes = level::bytes(&house(), 256).unwrap();
    change(&mut bytes);
    repair(&mut bytes);
    SegmentMap::from_bytes(&bytes).unwrap_err()
}

#[test]
fn what_is_wrong_and_where() {
    let house = decode(&level::bytes(&house(), 256).unwrap());
    let count = house.segs.len();
    let offsets = 32 + 24 * count;
    let refs = offsets + 2 * (house.refs.len() + 1);
    let winding = refs + 2 * house.refs.iter().map(Vec::len).sum::<usize>();
    let put = |at: usize, new: &'static [u8]| move |b: &mut Vec<u8>| b[at..at + new.len()].copy_from_slice(new);
    let segment = |index, fault| SegmentMapError::Segment { index, fault };
    assert_eq!(said(put(3, b"X")), SegmentMapError::NotSegments);
    assert_eq!(said(put(4, &[2])), SegmentMapError::Version(2));
    assert_eq!(said(put(5, &[1])), SegmentMapError::Reserved);
    assert_eq!(said(put(26, &[1])), SegmentMapError::Reserved);
    assert_eq!(said(put(16, &[1])), SegmentMapError::Grid(TileMapError::Cell(257)));
    assert_eq!(said(put(20, &[0, 0])), SegmentMapError::Grid(TileMapError::EmptyMap));
    assert_eq!(said(put(20, &[0, 0x80])), SegmentMapError::Grid(TileMapError::TooManyCells(0x8000)));
    let at = |i: usize, field: usize| 32 + 24 * i + field;
    assert_eq!(said(put(at(3, 16), &[0; 4])), segment(3, SegmentFault::Length));
    assert_eq!(said(put(at(3, 16), &[0xff; 4])), segment(3, SegmentFault::Length));
    assert_eq!(said(put(at(2, 8), &[0; 8])), segment(2, SegmentFault::Direction));
    assert_eq!(said(put(at(0, 8), &[2])), segment(0, SegmentFault::Direction));
    assert_eq!(said(put(at(1, 8), &[0, 0, 0, 0x80, 0, 0, 0, 0x80])), segment(1, SegmentFault::Direction));
    assert_eq!(said(put(at(1, 8), &[0, 0, 0, 0x80, 1])), segment(1, SegmentFault::OffGrid));
    assert_eq!(said(put(at(0, 0), &[0xff; 4])), segment(0, SegmentFault::OffGrid));
    assert_eq!(said(put(at(0, 16), &[0, 6])), segment(0, SegmentFault::OffGrid));
    assert_eq!(said(put(at(4, 22), &[3])), segment(4, SegmentFault::Attributes));
    assert_eq!(said(put(at(4, 22), &[16])), segment(4, SegmentFault::Attributes));
    // A vertex and joined, neither, and a vertex of a one-way chain that is elsewhere.
    let (vertex, one_way) = (0, house.segs.iter().position(|s| s.kind == ONE_WAY).unwrap());
    assert!(!house.segs[vertex].end_joined);
    assert_eq!(said(put(at(vertex, 22), &[8])), segment(0, SegmentFault::Attributes));
    assert_eq!(said(put(at(vertex, 20), &[0xff; 2])), segment(0, SegmentFault::Attributes));
    assert_eq!(said(put(at(one_way, 20), &[0; 2])), segment(one_way as u16, SegmentFault::Next));
    // The next segment: missing, elsewhere, ending there, at a concave corner.
    assert_eq!(said(put(at(vertex, 20), &[200, 0])), segment(0, SegmentFault::Next));
    assert_eq!(said(put(at(vertex, 20), &[2, 0])), segment(0, SegmentFault::Next));
    assert_eq!(said(put(at(vertex, 20), &[0, 0])), segment(0, SegmentFault::Next));
    let window = house.segs.iter().position(|s| s.len == 200).unwrap();
    assert_eq!((house.segs[window].next, house.segs[window].end_joined), (NONE, true));
    let before = (window - 5 + 3) % 4 + 5;
    assert_eq!(house.segs[before].a, house.segs[window].b(), "a hole runs against its points");
    let concave = move |b: &mut Vec<u8>| {
        b[at(window, 20)..][..3].copy_from_slice(&[before as u8, 0, 0]);
        b[at(before, 22)] = 8;
    };
    assert_eq!(said(concave), segment(window as u16, SegmentFault::Next));
    // Offsets, references, winding numbers.
    assert_eq!(said(put(offsets, &[1])), SegmentMapError::Refs(Cell::new(0, 0)));
    assert_eq!(said(put(offsets + 4, &[0])), SegmentMapError::Refs(Cell::new(1, 0)));
    assert_eq!(said(put(offsets + 2, &[0xff; 2])), SegmentMapError::Refs(Cell::new(0, 0)));
    assert_eq!(said(put(refs - 2, &[0])), SegmentMapError::Refs(Cell::new(4, 3)));
    assert_eq!(said(put(refs, &[200])), SegmentMapError::Refs(Cell::new(0, 0)));
    assert_eq!(said(put(refs, &[4, 0, 4, 0])), SegmentMapError::Refs(Cell::new(0, 0)));
    assert_eq!(said(put(winding + 1, &[7])), SegmentMapError::Winding(Cell::new(1, 0)));
}

#[test]
fn a_reference_too_many_or_too_few() {
    let bytes = level::bytes(&house(), 256).unwrap();
    let house = decode(&bytes);
    let (cells, offsets) = (house.refs.len(), 32 + 24 * house.segs.len());
    let refs = offsets + 2 * (cells + 1);
    let total: usize = house.refs.iter().map(Vec::len).sum();
    let shifted = |from: usize, by: i32| {
        let mut b = bytes.clone();
        b[24..26].copy_from_slice(&((total as i32 + by) as u16).to_le_bytes());
        for i in from..=cells {
            let at = offsets + 2 * i;
            let old = u16::from_le_bytes([b[at], b[at + 1]]);
            b[at..at + 2].copy_from_slice(&((i32::from(old) + by) as u16).to_le_bytes());
        }
        b
    };
    for cell in 0..cells {
        let start = refs + 2 * house.refs[..cell].iter().map(Vec::len).sum::<usize>();
        for i in 0..house.refs[cell].len() {
            let mut fewer = shifted(cell + 1, -1);
            fewer.drain(start + 2 * i..start + 2 * i + 2);
            repair(&mut fewer);
            assert!(SegmentMap::from_bytes(&fewer).is_err());
        }
        for extra in 0..house.segs.len() as u16 {
            if let Err(i) = house.refs[cell].binary_search(&extra) {
                let mut more = shifted(cell + 1, 1);
                more.splice(start + 2 * i..start + 2 * i, extra.to_le_bytes());
                repair(&mut more);
                assert!(SegmentMap::from_bytes(&more).is_err());
            }
        }
    }
}

const WORDS: [i32; 12] =
    [0, 1, -1, 2, i32::MIN, i32::MAX, 1 << 29, -(1 << 29), 1 << 30, 256, (1 << 24) - 2, i32::MIN + 1];

/// Changes the parts of the byte form: fields to extremes or to other fields, tables slightly,
/// lengths with the header's counts.
fn damage(random: &mut Random, bytes: &mut Vec<u8>) {
    let words = bytes.len() as i64 / 4;
    let segments = i64::from(u16::from_le_bytes([bytes[6], bytes[7]]));
    match random.below(9) {
        0 => {
            let at = 4 * random.below(words) as usize;
            bytes[at..at + 4].copy_from_slice(&WORDS[random.below(12) as usize].to_le_bytes());
        }
        1 | 2 => {
            // A field of a segment, by a little or from another one.
            let field = 4 * random.below(6) as usize;
            let at = 32 + 24 * random.below(segments.max(1)) as usize + field;
            let from = 32 + 24 * random.below(segments.max(1)) as usize + field;
            if at + 4 <= bytes.len() && from + 4 <= bytes.len() {
                let word = i32::from_le_bytes(bytes[from..from + 4].try_into().unwrap());
                let word = word.wrapping_add(random.around(2) as i32);
                bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
            }
        }
        3 => {
            // Next, attributes and flags.
            let at = 32 + 24 * random.below(segments.max(1)) as usize + 20 + random.below(4) as usize;
            if at < bytes.len() {
                bytes[at] = [0, 1, 2, 3, 4, 8, 255, random.below(256) as u8][random.below(8) as usize];
            }
        }
        4 => {
            let at = random.below(bytes.len() as i64) as usize;
            bytes[at] = bytes[at].wrapping_add(random.sign() as u8);
        }
        5 => {
            let at = 4 + random.below(24) as usize;
            bytes[at] = random.below(256) as u8;
        }
        6 => {
            let (at, from) =
                (random.below(bytes.len() as i64 - 1) as usize, random.below(bytes.len() as i64 - 1) as usize);
            let half = [bytes[from], bytes[from + 1]];
            bytes[at..at + 2].copy_from_slice(&half);
        }
        7 => {
            let len = (bytes.len() as i64 + random.around(30)).max(40);
            bytes.resize(len as usize, random.below(256) as u8);
        }
        _ => {
            // Only the user's flags: still a level.
            if segments > 0 && bytes.len() as i64 > 32 + 24 * segments {
                bytes[32 + 24 * random.below(segments) as usize + 23] = random.below(256) as u8;
            }
        }
    }
}

/// The conditions on which queries rely, for an accepted level.
fn check_taken(level: &Level) {
    check_refs(level);
    for s in level.segs.iter().filter(|s| s.next != NONE) {
        let (n, p) = (level.segs[usize::from(s.next)], s.b());
        assert!((0..n.len).any(|t| n.at(t) == p), "{s:?} {n:?}");
    }
}

#[test]
fn hostile_bytes_are_an_error_or_a_level() {
    let mut random = Random::new(20_261);
    let sources = levels();
    let (mut taken, mut refused) = (0, 0);
    for case in 0..cases(20_000) {
        let mut bytes = sources[random.below(sources.len() as i64) as usize].clone();
        for _ in 0..=random.below(3) {
            damage(&mut random, &mut bytes);
        }
        repair(&mut bytes);
        let found = catch_unwind(|| SegmentMap::from_bytes(&bytes).is_ok());
        if found.unwrap_or_else(|_| panic!("case {case} panics: {bytes:?}")) {
            check_taken(&decode(&bytes));
            taken += 1;
        } else {
            refused += 1;
        }
    }
    assert!(taken > refused / 100, "{taken} of {refused} are levels");
}

#[test]
fn noise_is_refused() {
    let mut random = Random::new(4);
    for _ in 0..cases(20_000) {
        let mut bytes: Vec<u8> = (0..random.below(300)).map(|_| random.below(256) as u8).collect();
        if random.one_in(2) && bytes.len() > 8 {
            bytes[..8].copy_from_slice(b"TSEG\x01\0\x02\0");
        }
        repair(&mut bytes);
        assert!(SegmentMap::from_bytes(&bytes).is_err());
    }
}
