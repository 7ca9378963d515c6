//! Constructors and their refusals, cells and regions of tile maps.

use heapless::Vec;
use tilesat::world::ShapeSet;
use tilesat::{
    Aabb, AllShapes, Blocks, Cell, Circle, Fx, Grid, Outside, Quantity, Slopes, TileKind, TileKinds, TileMap,
    TileMapError, TileShape, Vec2, error::Truncated,
};
use tilesat_judge::Random;
use tilesat_judge::blocks::build::CELLS;

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'-', TileKind::ONE_WAY_UP)
    .with(b'$', TileKind::EMPTY.with_flags(1))
    .with(b'^', TileKind::FULL.with_flags(2))
    .with(1, TileKind::FULL);

static LEVEL: TileMap = match TileMap::from_ascii("...$\n.--.\n####\n", &KINDS) {
    Ok(map) => map,
    Err(_) => panic!("bad level"),
};

#[test]
fn a_level_is_a_constant() {
    assert_eq!((LEVEL.width(), LEVEL.height(), LEVEL.cell(), LEVEL.origin()), (4, 3, Fx::lit("16"), Vec2::ZERO));
    assert_eq!(LEVEL.outside(), Outside::Empty);
    assert_eq!(LEVEL.tile(Cell::new(3, 0)), Some(b'$'));
    assert_eq!(LEVEL.kind(Cell::new(1, 1)).shape, TileShape::OneWayUp);
    for (x, y) in [(-1, 0), (4, 0), (0, -1), (0, 3), (i16::MIN, i16::MIN), (i16::MAX, i16::MAX)] {
        assert_eq!(LEVEL.tile(Cell::new(x, y)), None);
        assert_eq!(LEVEL.kind(Cell::new(x, y)), TileKind::EMPTY);
        assert_eq!(LEVEL.with_outside(Outside::Solid).kind(Cell::new(x, y)), TileKind::FULL);
    }
    let edge = LEVEL.with_outside(Outside::Edge);
    assert_eq!(edge.kind(Cell::new(-7, 2)), TileKind::FULL);
    assert_eq!(edge.kind(Cell::new(9, -9)), TileKind::EMPTY.with_flags(1));
    // One-way tiles continue to the sides, not upward.
    let platform = TileMap::from_ascii("--", &KINDS).unwrap().with_outside(Outside::Edge);
    assert_eq!(platform.kind(Cell::new(-1, 0)), TileKind::ONE_WAY_UP);
    assert_eq!(platform.kind(Cell::new(0, -1)), TileKind::EMPTY);
}

/// The box of each cell holds the points that the grid puts into it, at all sizes and ends of the
/// domain; no other cell has one.
#[test]
fn every_cell_has_its_box() {
    let last = (1 << 29) - 1;
    for (cell, (width, height), (x, y)) in [
        (256, (3, 5), (0, 0)),
        (1 << 20, (4, 2), (-7, 9)),
        (1_048_574, (7, 3), (-last, 12_345)),
        (1 << 24, (31, 1), (last - 31 * (1 << 24), -last)),
        (256, (32_767, 2), (1 - (1 << 22), last - 512)),
    ] {
        let grid = Grid::new(width, height, Fx::from_bits(cell), Vec2::from_raw(x, y)).unwrap();
        let columns = [0, 1, i32::from(width) / 2, i32::from(width) - 2, i32::from(width) - 1];
        for column in columns.into_iter().filter(|&column| 0 <= column && column < i32::from(width)) {
            for row in 0..i32::from(height) {
                let of = Cell::new(column as i16, row as i16);
                let bounds = grid.bounds_of(of).unwrap();
                let (lo, hi) = ((x + column * cell, y + row * cell), (x + column * cell + cell, y + row * cell + cell));
                assert_eq!((bounds.min().raw(), bounds.max().raw()), (lo, hi), "{grid:?} {of:?}");
                assert_eq!(Aabb::new(bounds.min(), bounds.max()), Ok(bounds));
                for (px, py) in [lo, (hi.0 - 1, lo.1), (lo.0, hi.1 - 1), (hi.0 - 1, hi.1 - 1)] {
                    assert_eq!(grid.cell_at(Vec2::from_raw(px, py)), of);
                }
            }
        }
        let (w, h) = (width as i16, height as i16);
        for (x, y) in [(-1, 0), (0, -1), (w, 0), (0, h), (i16::MIN, i16::MIN), (i16::MIN, 0), (i16::MAX, i16::MAX)] {
            assert_eq!(grid.bounds_of(Cell::new(x, y)), None, "{x} {y}");
        }
    }
}

#[test]
fn text_that_is_no_level() {
    let refuse = |text| TileMap::from_ascii(text, &KINDS).unwrap_err();
    assert_eq!(refuse(""), TileMapError::EmptyMap);
    assert_eq!(refuse("\n"), TileMapError::EmptyMap);
    assert_eq!(refuse("\n\n"), TileMapError::EmptyMap);
    assert_eq!(refuse("##\n#"), TileMapError::RowLength { row: 1, expected: 2, found: 1 });
    assert_eq!(refuse("##\n##\n###\n"), TileMapError::RowLength { row: 2, expected: 2, found: 3 });
    assert_eq!(refuse("##\n\n"), TileMapError::RowLength { row: 1, expected: 2, found: 0 });
    assert_eq!(refuse("\n##"), TileMapError::RowLength { row: 1, expected: 0, found: 2 });
    assert_eq!(refuse("##\r\n##"), TileMapError::CarriageReturn { row: 0 });
    assert_eq!(refuse("..\n.é"), TileMapError::NotAscii { row: 1, column: 1 });
    assert_eq!(TileMap::from_ascii("#", &KINDS).unwrap().height(), 1);
    let wide = "#".repeat(40_000);
    assert_eq!(refuse(&wide), TileMapError::TooManyCells(40_000));
    let wide = "#".repeat(70_000);
    assert_eq!(refuse(&wide), TileMapError::TooManyCells(u16::MAX));
    let tall = "#\n".repeat(40_000);
    assert_eq!(refuse(&tall), TileMapError::TooManyCells(40_000));
    let wide = "#".repeat(512);
    assert_eq!(refuse(&wide), TileMapError::OutOfDomain { what: Quantity::X, value: 1 << 29 });
    assert_eq!(TileMap::from_ascii(&wide[1..], &KINDS).unwrap().width(), 511);
}

#[test]
fn hostile_sizes() {
    let tiles = [1u8; 64];
    let new = |w, h| TileMap::new(&tiles, w, h, &KINDS);
    assert_eq!(new(0, 4).unwrap_err(), TileMapError::EmptyMap);
    assert_eq!(new(4, 0).unwrap_err(), TileMapError::EmptyMap);
    assert_eq!(new(u16::MAX, 1).unwrap_err(), TileMapError::TooManyCells(u16::MAX));
    assert_eq!(new(1, 32_768).unwrap_err(), TileMapError::TooManyCells(32_768));
    assert_eq!(new(32_767, 32_767).unwrap_err(), TileMapError::OutOfDomain { what: Quantity::X, value: i32::MAX });
    assert_eq!(new(8, 9).unwrap_err(), TileMapError::TooShort { needed: 72, found: 64 });
    assert!(new(8, 8).is_ok() && new(7, 9).is_ok());
    let map = new(4, 4).unwrap();
    assert_eq!(map.with_stride(3).unwrap_err(), TileMapError::Stride(3));
    assert_eq!(map.with_stride(21).unwrap_err(), TileMapError::TooShort { needed: 67, found: 64 });
    assert_eq!(map.with_stride(u16::MAX).unwrap_err(), TileMapError::TooShort { needed: 3 * 65_535 + 4, found: 64 });
    assert!(map.with_stride(20).is_ok());
    for cell in [i32::MIN, -256, -1, 0, 1, 255, 254, 257, (1 << 24) + 2, i32::MAX] {
        assert_eq!(map.with_cell(Fx::from_bits(cell)).unwrap_err(), TileMapError::Cell(cell));
    }
    let end = 1 << 29;
    let at = |x, y| map.with_origin(Vec2::from_raw(x, y));
    let bad = |what, value| TileMapError::OutOfDomain { what, value };
    assert_eq!(at(i32::MIN, 0).unwrap_err(), bad(Quantity::X, i32::MIN));
    assert_eq!(at(-end, 0).unwrap_err(), bad(Quantity::X, -end));
    assert_eq!(at(0, end - (64 << 16)).unwrap_err(), bad(Quantity::Y, end));
    assert_eq!(at(0, i32::MAX).unwrap_err(), bad(Quantity::Y, i32::MAX));
    assert!(at(1 - end, end - (64 << 16) - 1).is_ok());
    let bits = |w, h| TileMap::from_bits(&[0xff; 8], w, h, &KINDS);
    assert!(bits(8, 8).is_ok() && bits(7, 9).is_ok());
    assert_eq!(bits(5, 13).unwrap_err(), TileMapError::TooShort { needed: 9, found: 8 });
    assert!(bits(8, 4).unwrap().with_stride(18).is_ok());
    assert_eq!(bits(8, 4).unwrap().with_stride(19).unwrap_err(), TileMapError::TooShort { needed: 9, found: 8 });
}

#[test]
fn errors_say_what_and_where() {
    let text = |e: TileMapError| e.to_string();
    assert_eq!(text(TileMapError::EmptyMap), "the map has no cells: width and height must be at least 1");
    assert_eq!(
        text(TileMapError::TooManyCells(40_000)),
        "a side of 40000 cells is longer than 32767: use larger cells, or cut the world into rooms"
    );
    assert_eq!(
        text(TileMapError::Cell(3)),
        "a cell of 3 raw is refused: its side must be even, from 256 to 16777216 raw (256 units)"
    );
    assert_eq!(text(TileMapError::Stride(2)), "a stride of 2 is less than the width, so rows would overlap: raise it");
    assert_eq!(
        text(TileMapError::TooShort { needed: 9, found: 8 }),
        "the tiles have 8 bytes, but the map needs 9: pass more, or lower its size or stride"
    );
    assert_eq!(
        text(TileMapError::RowLength { row: 1, expected: 2, found: 3 }),
        "row 1 has 3 characters where row 0 has 2: make them equal"
    );
    let said = |level| text(TileMap::from_ascii(level, &TileKinds::EMPTY).unwrap_err());
    assert_eq!(said("..\n."), "row 1 has 1 character where row 0 has 2: make them equal");
    assert_eq!(said("..\n\n"), "row 1 is empty where row 0 has 2: remove it, or fill it");
    assert_eq!(said("\n.."), "row 0 is empty: begin the text behind the quote, or open it with \"\\");
    assert_eq!(
        text(TileMapError::NotAscii { row: 1, column: 2 }),
        "the character at row 1, column 2 is not ASCII: use one byte per tile"
    );
    assert_eq!(
        text(TileMapError::CarriageReturn { row: 1 }),
        "row 1 has a carriage return: end each row with only a line feed"
    );
    let of_another = "a shape that is not in the map's set: choose another set with `of`, `of_ascii` or `of_bytes`";
    assert_eq!(text(TileMapError::ShapeNotInSet { id: 7 }), format!("the table gives tile 7 {of_another}"));
    assert_eq!(text(TileMapError::ShapeNotInSet { id: b'/' }), format!("the table gives tile 47 '/' {of_another}"));
    let out = TileMapError::OutOfDomain { what: Quantity::X, value: 5 };
    assert_eq!(text(out), "the map ends at X = 5 raw, out of range: move its origin, or cut it into rooms");
}

/// All coordinates within two raw of every line, and some between, against plain division.
#[test]
fn cells_of_coordinates() {
    let mut random = Random::new(1);
    for cell in CELLS.into_iter().chain([510, 512, 514, 65_538, 11_184_812, (1 << 23) + 2]) {
        let count = (((1i64 << 30) - 2) / cell).min(32_767);
        for origin in [-(count * cell / 2), 1 - (1 << 29), (1 << 29) - 1 - count * cell] {
            let grid =
                Grid::new(count as u16, 1, Fx::from_bits(cell as i32), Vec2::from_raw(origin as i32, 0)).unwrap();
            let check = |v: i64| {
                if let Ok(raw) = i32::try_from(v) {
                    let expected = (v - origin).div_euclid(cell).clamp(-1, count);
                    assert_eq!(i64::from(grid.cell_at(Vec2::from_raw(raw, 0)).x), expected, "{v} in {grid:?}");
                }
            };
            for line in 0..=count {
                for beside in -2..=2 {
                    check(origin + line * cell + beside);
                }
            }
            for _ in 0..2_000 {
                check(random.within(origin, origin + count * cell));
            }
            for v in [i64::from(i32::MIN), i64::from(i32::MAX), 0, 1 - (1 << 29), (1 << 29) - 1] {
                check(v);
            }
        }
    }
}

#[test]
fn a_window_into_a_wider_level() {
    let wide = b"......##..\n..........\n.$..####..";
    let map = TileMap::new(&wide[5..], 3, 3, &KINDS).unwrap().with_stride(11).unwrap();
    let rows: std::vec::Vec<std::vec::Vec<u8>> =
        (0..3).map(|y| (0..3).map(|x| map.tile(Cell::new(x, y)).unwrap()).collect()).collect();
    assert_eq!(rows, [b".##", b"...", b"###"]);
}

#[test]
fn tiles_that_fit_are_kept_in_order() {
    let region = Aabb::new(Vec2::from_ints(8, 8), Vec2::from_ints(40, 24)).unwrap();
    let mut all: Vec<_, 8> = Vec::new();
    assert_eq!(LEVEL.collect_tiles(&region, &mut all), Ok(()));
    assert!(all.iter().copied().eq(LEVEL.tiles_in(&region)));
    assert_eq!(all.len(), 6);
    let mut some: Vec<_, 4> = Vec::new();
    assert_eq!(LEVEL.collect_tiles(&region, &mut some), Err(Truncated { seen: 6, kept: 4 }));
    assert_eq!(some, all[..4]);
    let mut none: Vec<_, 0> = Vec::new();
    assert_eq!(LEVEL.collect_tiles(&region, &mut none), Err(Truncated { seen: 6, kept: 0 }));
    // A region of exactly one tile is that tile; a point on a corner touches four.
    let one = Aabb::new(Vec2::from_ints(16, 16), Vec2::from_ints(32, 32)).unwrap();
    assert_eq!(LEVEL.tiles_in(&one).map(|t| t.cell).collect::<std::vec::Vec<_>>(), [Cell::new(1, 1)]);
    let corner = Aabb::new(Vec2::from_ints(16, 16), Vec2::from_ints(16, 16)).unwrap();
    assert_eq!(LEVEL.tiles_in(&corner).count(), 4);
    let far = Aabb::new(Vec2::from_ints(1000, 0), Vec2::from_ints(1010, 32)).unwrap();
    assert_eq!(LEVEL.tiles_in(&far).count(), 0);
}

/// Torture scene 26 on a level: a circle at a distance of exactly its radius, and one raw more or
/// less.
#[test]
fn a_circle_at_a_corner() {
    let map = TileMap::from_ascii("#.\n..", &KINDS).unwrap();
    let ball = |r: i32| Circle::new(Vec2::from_ints(19, 20), Fx::from_bits(r)).unwrap();
    let five = 5 << 16;
    let answers = |r| (map.touches(&ball(r)), map.overlaps(&ball(r)));
    assert_eq!([answers(five - 1), answers(five), answers(five + 1)], [(false, false), (true, false), (true, true)]);
}

/// A body exactly as wide as a gap fits. One raw more does not (torture scene 30, the resting
/// part).
#[test]
fn a_body_as_wide_as_the_gap() {
    let map = TileMap::from_ascii("#.#\n#.#", &KINDS).unwrap();
    let body = |w| Aabb::new(Vec2::from_ints(16, 4), Vec2::from_raw(w, 20 << 16)).unwrap();
    assert!(!map.overlaps(&body(32 << 16)) && map.touches(&body(32 << 16)));
    assert!(map.overlaps(&body((32 << 16) + 1)));
}

/// Bodies without area: inside the union also on the lines between full tiles, not on its border
/// (torture scene 25's kin).
#[test]
fn points_and_lines() {
    let map = TileMap::from_ascii("##\n##\n.-", &KINDS).unwrap();
    let segment = |x0, y0, x1, y1| Aabb::new(Vec2::from_ints(x0, y0), Vec2::from_ints(x1, y1)).unwrap();
    let point = |x, y| segment(x, y, x, y);
    assert!(map.overlaps(&point(16, 16)) && map.overlaps(&point(16, 8)) && map.overlaps(&point(8, 8)));
    for p in [point(0, 0), point(16, 0), point(32, 16), point(16, 32), point(24, 40)] {
        assert!(!map.overlaps(&p));
    }
    assert!(map.overlaps(&segment(16, -10, 16, 40)));
    assert!(!map.overlaps(&segment(0, -10, 0, 40)) && map.touches(&segment(0, -10, 0, 40)));
    assert!(!map.overlaps(&segment(-10, 32, 40, 32)));
    let solid = map.with_outside(Outside::Solid);
    assert!(solid.overlaps(&segment(0, -10, 0, 40)) && solid.overlaps(&point(0, 0)) && !solid.overlaps(&point(16, 32)));
    // One-way tiles are never overlapped nor touched.
    assert!(!map.touches(&segment(20, 36, 28, 44)));
}

/// A table remembers the shapes that it names, and a set's definition looks at all ids. Kinds come
/// and are replaced, in any order.
#[test]
fn a_table_knows_the_shapes_that_it_names() {
    fn refused<S: ShapeSet>(kinds: &TileKinds) -> Option<u8> {
        let map = TileMap::<S>::of(&[0], Grid::new(1, 1, Fx::from_num(16), Vec2::ZERO).unwrap(), kinds);
        map.err().map(|e| if let TileMapError::ShapeNotInSet { id } = e { id } else { unreachable!("{e}") })
    }
    fn defined<S: ShapeSet>(kinds: &TileKinds) -> Option<u8> {
        (0..=u8::MAX).find(|&id| S::SHAPES >> kinds.get(id).shape as u64 & 1 == 0)
    }
    let mut random = Random::new(77);
    for _ in 0..200 {
        let (mut kinds, mut sorted) = (TileKinds::EMPTY, TileKinds::EMPTY);
        for _ in 0..40 {
            // Few ids, so that many are replaced; the last one too.
            let id = [0, 3, 47, 200, 255][random.below(5) as usize];
            let most = [2, 10, 38][random.below(3) as usize];
            kinds = kinds.with(id, TileKind::of(TileShape::ALL[random.below(most) as usize]));
            assert_eq!(refused::<Blocks>(&kinds), defined::<Blocks>(&kinds));
            assert_eq!(refused::<Slopes>(&kinds), defined::<Slopes>(&kinds));
            assert_eq!(refused::<AllShapes>(&kinds), None);
        }
        for id in 0..=u8::MAX {
            sorted = sorted.with(id, kinds.get(id));
        }
        assert_eq!(kinds, sorted);
    }
}

/// Tiles with any of the flags become passable and keep their flags. The others stay. The new table
/// knows its shapes: a set may contain the rest.
#[test]
fn tables_for_bodies_that_pass_flags() {
    let (mut kinds, mut left) = (TileKinds::EMPTY, [TileKinds::EMPTY; 4]);
    for (id, shape) in (0..=u8::MAX).zip(TileShape::ALL.into_iter().cycle()) {
        let flags = id / 38 % 4;
        kinds = kinds.with(id, TileKind::of(shape).with_flags(flags));
        for (passed, left) in (0..).zip(&mut left) {
            let shape = if flags & passed == 0 { shape } else { TileShape::Empty };
            *left = left.with(id, TileKind::of(shape).with_flags(flags));
        }
    }
    for (passed, left) in (0..).zip(left) {
        assert_eq!(kinds.passing(passed), left, "{passed}");
    }
    let mixed = TileKinds::EMPTY.with(1, TileKind::FULL).with(2, TileKind::of(TileShape::SlopeTopLeft).with_flags(8));
    let grid = Grid::new(1, 1, Fx::from_num(16), Vec2::ZERO).unwrap();
    assert!(TileMap::<Blocks>::of(&[0], grid, &mixed).is_err());
    assert!(TileMap::<Blocks>::of(&[0], grid, &mixed.passing(4)).is_err());
    assert!(TileMap::<Blocks>::of(&[0], grid, &mixed.passing(12)).is_ok());
}

#[test]
fn bounds_are_those_of_all_cells() {
    let grid = Grid::new(3, 2, Fx::from_num(8), Vec2::from_ints(-5, 7)).unwrap();
    let map = TileMap::on_grid(&[0; 6], grid, &KINDS).unwrap();
    assert_eq!(map.bounds(), Aabb::new(Vec2::from_ints(-5, 7), Vec2::from_ints(19, 23)).unwrap());
}
