//! Refused paths, each with the position of the fault.

use tilesat::PathKind::{Hole, OneWay, Solid, Wall};
use tilesat::{Cell, Fx, Grid, Quantity, SegmentMap, SegmentMapError, TileMapError, Vec2, world::SegmentFault};
use tilesat_judge::paths;
use tilesat_judge::paths::level::{Point, Shape, bytes, bytes_on, shape, with_paths};

const SQUARE: [Point; 4] = [(0, 0), (500, 0), (500, 500), (0, 500)];

fn refused(shapes: &[Shape]) -> SegmentMapError {
    let e = bytes(shapes, 256).unwrap_err();
    // Nothing is written.
    with_paths(shapes, |paths| {
        let mut out = [0x5a; 4000];
        assert_eq!(SegmentMap::build_into(paths, Fx::from_bits(256), &mut out), Err(e));
        assert_eq!(out, [0x5a; 4000]);
    });
    e
}

#[test]
fn each_names_its_place() {
    let good = || shape(Solid, &SQUARE);
    assert_eq!(refused(&[]), SegmentMapError::Empty);
    assert_eq!(refused(&[good(), shape(Solid, &[])]), SegmentMapError::TooFewPoints { path: 1, points: 0 });
    assert_eq!(refused(&[shape(Hole, &SQUARE[..2])]), SegmentMapError::TooFewPoints { path: 0, points: 2 });
    assert_eq!(refused(&[good(), shape(Wall, &SQUARE[..1])]), SegmentMapError::TooFewPoints { path: 1, points: 1 });
    assert_eq!(refused(&[shape(OneWay, &SQUARE[..1])]), SegmentMapError::TooFewPoints { path: 0, points: 1 });
    let twice = [(0, 0), (500, 0), (500, 0), (500, 500)];
    assert_eq!(refused(&[good(), good(), shape(Wall, &twice)]), SegmentMapError::ZeroLength { path: 2, point: 1 });
    let ring = [(0, 0), (500, 0), (500, 500), (0, 0)];
    assert_eq!(refused(&[good(), shape(Solid, &ring)]), SegmentMapError::ZeroLength { path: 1, point: 3 });
    assert!(bytes(&[shape(Wall, &ring)], 256).is_ok());
    let end = 1 << 29;
    for (p, what, value) in [
        ((end, 0), Quantity::X, end),
        ((-end, 0), Quantity::X, -end),
        ((0, end), Quantity::Y, end),
        ((7, i64::from(i32::MIN)), Quantity::Y, i64::from(i32::MIN)),
        ((i64::from(i32::MAX), end), Quantity::X, i64::from(i32::MAX)),
    ] {
        let expected = SegmentMapError::OutOfDomain { path: 1, point: 2, what, value: value as i32 };
        assert_eq!(refused(&[good(), shape(OneWay, &[(0, 0), (1, 1), p])]), expected);
    }
    let line = [(0, 0), (500, 500), (300, 300)];
    assert_eq!(refused(&[good(), shape(Hole, &line)]), SegmentMapError::NoArea { path: 1 });
    // Two triangles, one against the other.
    let bow = [(0, 0), (500, 500), (500, 0), (0, 500)];
    assert_eq!(refused(&[shape(Solid, &bow)]), SegmentMapError::NoArea { path: 0 });
}

#[test]
fn grids_that_do_not_fit() {
    let good = [shape(Solid, &SQUARE)];
    for cell in [i32::MIN, -256, 0, 1, 254, 257, (1 << 24) + 2, i32::MAX] {
        let found = bytes(&good, i64::from(cell)).unwrap_err();
        assert_eq!(found, SegmentMapError::Grid(TileMapError::Cell(cell)));
    }
    let long = |x| bytes(&[shape(Wall, &[(0, 0), (x, 0)])], 256);
    assert!(long(32_767 * 256).is_ok());
    assert_eq!(long(32_767 * 256 + 1).unwrap_err(), SegmentMapError::Grid(TileMapError::TooManyCells(32_768)));
    let found = long((1 << 29) - 1).unwrap_err();
    assert_eq!(found, SegmentMapError::Grid(TileMapError::TooManyCells(u16::MAX)));
    // Near the end of the domain, the grid starts before the points.
    let end = (1 << 29) - 1;
    let corner = [shape(Wall, &[(end - 300, end - 256), (end, end)])];
    let level = paths::level::level(&corner, 256);
    assert_eq!((level.origin, level.width, level.height), ((end - 512, end - 256), 2, 1));

    let grid = |x, y| Grid::new(2, 2, Fx::from_bits(256), Vec2::from_raw(x, y)).unwrap();
    assert!(bytes_on(&good, grid(0, 0)).is_ok() && bytes_on(&good, grid(-12, -12)).is_ok());
    assert_eq!(bytes_on(&good, grid(1, 0)).unwrap_err(), SegmentMapError::OutsideGrid { path: 0, point: 0 });
    assert_eq!(bytes_on(&good, grid(-13, 0)).unwrap_err(), SegmentMapError::OutsideGrid { path: 0, point: 1 });
    assert_eq!(bytes_on(&good, grid(0, -13)).unwrap_err(), SegmentMapError::OutsideGrid { path: 0, point: 2 });
}

#[test]
fn too_much() {
    // Two segments per edge of a wall, and at most 32768.
    let zigzag: Vec<Point> = (0..32_769).map(|i| (i, i & 1)).collect();
    assert!(matches!(
        bytes(&[shape(Wall, &zigzag)], 1 << 16),
        Err(SegmentMapError::TooManySegments { path: 0, point: 16_384 })
    ));
    let twice = [shape(OneWay, &zigzag), shape(OneWay, &zigzag)];
    assert_eq!(bytes(&twice, 1 << 16).unwrap_err(), SegmentMapError::TooManySegments { path: 1, point: 0 });
    // Each passes 1000 cells of one row, inside them.
    let long: Vec<Point> = (0..70).map(|i| (i % 2 * 256_000 + 1 - i % 2 * 2, 100 + i)).collect();
    assert_eq!(bytes(&[shape(OneWay, &long)], 256).unwrap_err(), SegmentMapError::TooManyRefs { path: 0, point: 65 });

    let pile = |n: usize| vec![shape(Solid, &SQUARE); n];
    assert!(bytes(&pile(127), 256).is_ok());
    let holes = vec![shape(Hole, &SQUARE); 129];
    for (shapes, cell) in [(pile(128), Cell::new(0, 0)), (holes, Cell::new(0, 0))] {
        let found = with_paths(&shapes, |paths| {
            let cell = Fx::from_bits(256);
            let mut out = vec![0x5a; SegmentMap::measure(paths, cell).unwrap().bytes()];
            let found = SegmentMap::build_into(paths, cell, &mut out).unwrap_err();
            assert!(SegmentMap::from_bytes(&out).is_err());
            found
        });
        assert_eq!(found, SegmentMapError::TooDeep(cell));
    }
}

#[test]
fn too_little_room() {
    let good = [shape(Solid, &SQUARE)];
    let needed = bytes(&good, 256).unwrap().len();
    with_paths(&good, |paths| {
        let cell = Fx::from_bits(256);
        for found in [0, 1, 31, needed - 1] {
            let mut out = vec![0x5a; found];
            let e = SegmentMap::build_into(paths, cell, &mut out).unwrap_err();
            assert_eq!(e, SegmentMapError::TooSmall { needed: needed as u32, found: found as u32 });
            assert!(out.iter().all(|&b| b == 0x5a));
        }
        let mut small = heapless::Vec::<u8, 100>::from_slice(&[7; 3]).unwrap();
        let e = SegmentMap::build_vec(paths, cell, &mut small).unwrap_err();
        assert_eq!(e, SegmentMapError::TooSmall { needed: needed as u32, found: 100 });
        assert_eq!(small, [7; 3]);
        let mut room = heapless::Vec::<u8, 400>::from_slice(&[7; 300]).unwrap();
        let map = SegmentMap::build_vec(paths, cell, &mut room).unwrap();
        assert_eq!((map.count(), map.width(), map.cell()), (4, 2, cell));
        assert_eq!(room[..], bytes(&good, 256).unwrap());
    });
}

#[test]
fn errors_say_what_and_where() {
    let text = |e: SegmentMapError| e.to_string();
    assert_eq!(
        text(SegmentMapError::ZeroLength { path: 2, point: 9 }),
        "path 2: point 9 is the same as the next: remove one of them"
    );
    assert_eq!(text(SegmentMapError::NoArea { path: 3 }), "path 3 is a polygon without area: draw it as a wall");
    let e = SegmentMapError::OutOfDomain { path: 1, point: 2, what: Quantity::X, value: 1 << 29 };
    assert_eq!(
        text(e),
        "path 1, point 2: X = 536870912 raw is out of range: keep points less than 8192 units from the origin"
    );
    let e = SegmentMapError::TooFewPoints { path: 4_294_967_295, points: 1 };
    assert_eq!(text(e), "path 4294967295 has 1 point: a polygon needs 3, a chain 2");
    assert_eq!(
        text(SegmentMapError::TooSmall { needed: 9, found: 8 }),
        "the buffer has 8 bytes, but the map needs 9: lend at least 9"
    );
    assert_eq!(
        text(SegmentMapError::Winding(Cell::new(1, 2))),
        "the winding number of cell (1, 2) is wrong: bake the level again"
    );
    let fault = SegmentFault::Direction;
    assert_eq!(
        text(SegmentMapError::Segment { index: 3, fault }),
        "segment 3 has a direction that is zero or has a common divisor: bake the level again"
    );
}
