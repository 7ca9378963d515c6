//! The room of a position, its coordinates there, and refused worlds.

use tilesat::{
    AllShapes, Blocks, Cell, Fx, Grid, Outside, Quantity, Room, Rooms, TileKind, TileKinds, TileMap, TileMapError,
    TileShape, Vec2,
};

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
const CELL: Fx = Fx::lit("16");

/// Every position on a lattice around every room, far and near: its room and the way there.
#[test]
fn every_place_has_its_room() {
    let tiles: Vec<u8> = (0..7 * 5).map(|k| k % 3 % 2).collect();
    for (width, height) in (1..=8).flat_map(|w| (1..=6).map(move |h| (w, h))) {
        let world = Rooms::<Blocks>::of(&tiles, (7, 5), CELL, &KINDS, (width, height), 2).unwrap();
        assert_eq!((world.columns(), world.rows()), (7u16.div_ceil(width), 5u16.div_ceil(height)));
        assert!(world.room(world.columns(), 0).is_none() && world.room(0, world.rows()).is_none());
        // Every cell of the world and the ones around it: its room, and the way back.
        for (x, y) in (-2..9).flat_map(|x| (-2..7).map(move |y| (x, y))) {
            let inside = (0..7).contains(&x) && (0..5).contains(&y);
            let at = world.at((x, y));
            assert_eq!(at.is_some(), inside, "{x} {y}");
            if let Some((room, cell)) = at {
                let home = world.room(x as u16 / width, y as u16 / height).unwrap();
                assert_eq!((room.first(), room.in_world(cell)), (home.first(), (x, y)));
                let bounds = room.map().grid().bounds_of(cell).unwrap();
                assert!(room.holds(bounds.min()) && room.holds(bounds.max() - Vec2::from_raw(1, 1)));
                assert_eq!(room.map().tile(cell), Some(tiles[(y * 7 + x) as usize]));
            }
        }
        for (column, row) in (0..world.columns()).flat_map(|c| (0..world.rows()).map(move |r| (c, r))) {
            let room = world.room(column, row).unwrap();
            assert_eq!(room.first(), (i32::from(column * width), i32::from(row * height)));
            assert_eq!(room.width(), width.min(7 - column * width));
            assert_eq!(room.height(), height.min(5 - row * height));
            for (x, y) in (-3..10).flat_map(|x| (-3..8).map(move |y| (x, y))) {
                // A cell of the world, and its first and last raw unit.
                let (dx, dy) = (x - room.first().0, y - room.first().1);
                for raw in [0, (1 << 20) - 1] {
                    let place = Vec2::from_raw((dx << 20) + raw, (dy << 20) + raw);
                    let own = (0..room.width().into()).contains(&dx) && (0..room.height().into()).contains(&dy);
                    assert_eq!(room.holds(place), own);
                    // Beyond the world, the room of the nearest cell.
                    let near = (x.clamp(0, 6), y.clamp(0, 4));
                    let home = (near.0 / i32::from(width), near.1 / i32::from(height));
                    let next = world.next(&room, place);
                    assert_eq!(next.is_some(), home != (column.into(), row.into()), "{x} {y}");
                    if let Some((next, by)) = next {
                        let (there, (first_x, first_y)) = (place + by, next.first());
                        assert_eq!((first_x, first_y), (home.0 * i32::from(width), home.1 * i32::from(height)));
                        assert!(!own && next.holds(there) == ((x, y) == near));
                        assert_eq!(there, Vec2::from_raw(((x - first_x) << 20) + raw, ((y - first_y) << 20) + raw));
                    }
                    let cell = room.map().cell_at(place);
                    if let Some(tile) = room.map().tile(cell) {
                        assert_eq!((room.in_world(cell), tile), ((x, y), tiles[(y * 7 + x) as usize]));
                    }
                }
            }
        }
    }
}

/// The largest possible world: its last room, and the way there.
#[test]
fn sixty_five_thousand_cells() {
    let tiles = vec![0; 65_535 * 3];
    let world = Rooms::<Blocks>::of(&tiles, (65_535, 3), CELL, &KINDS, (400, 3), 50).unwrap();
    let (mut room, mut steps) = (world.room(0, 0).unwrap(), 0);
    while let Some((next, by)) = world.next(&room, Vec2::from_ints(6400, 20)) {
        assert_eq!(by, Vec2::from_ints(-6400, 0));
        (room, steps) = (next, steps + 1);
    }
    assert_eq!((room.first(), room.width(), steps), ((65_200, 0), 335, 163));
    let wide = Rooms::<Blocks>::of(&tiles, (65_535, 3), Fx::lit("0.0625"), &KINDS, (32_767, 3), 0).unwrap();
    assert!(wide.room(u16::MAX, 0).is_none() && wide.room(2, 0).is_some_and(|room| room.width() == 1));
    let last = world.at((65_534, 2)).map(|(room, cell)| (room.first(), room.in_world(cell), cell));
    assert_eq!(last, Some(((65_200, 0), (65_534, 2), Cell::new(334 + 50, 2))));
    for beyond in [(65_535, 0), (0, 3), (-1, 0), (0, -1), (i32::MIN, i32::MIN), (i32::MAX, i32::MAX), (65_536, 0)] {
        assert!(world.at(beyond).is_none() && wide.at(beyond).is_none());
    }
    assert_eq!(wide.at((65_534, 1)).map(|(room, cell)| (room.first(), cell)), Some(((65_534, 0), Cell::new(0, 1))));
    // All coordinates, those beyond the domain too.
    for x in [i32::MIN, -(1 << 29), 1 << 29, i32::MAX] {
        let at = |place| world.next(&room, place).map(|(next, by)| next.holds(place + by));
        // This is the last room, and no coordinate reaches 2048 cells back.
        assert_eq!(at(Vec2::from_raw(x, 0)), (x == -(1 << 29)).then_some(true), "{x}");
    }
}

#[test]
fn no_worlds() {
    let of = |world, cell, room, apron| {
        Rooms::<AllShapes>::of(&[0; 40], world, Fx::from_num(cell), &KINDS, room, apron).map(|_| ()).unwrap_err()
    };
    assert_eq!(of((0, 5), 16, (2, 2), 1), TileMapError::EmptyMap);
    assert_eq!(of((8, 5), 16, (2, 0), 1), TileMapError::EmptyMap);
    assert_eq!(of((8, 6), 16, (2, 2), 1), TileMapError::TooShort { needed: 48, found: 40 });
    assert_eq!(of((8, 5), 0, (2, 2), 1), TileMapError::Cell(0));
    assert!(matches!(of((8, 5), 16, (500, 2), 6), TileMapError::OutOfDomain { what: Quantity::X, .. }));
    assert!(matches!(of((8, 5), 16, (2, 2), u16::MAX), TileMapError::TooManyCells(_)));
    let slopes = TileKinds::EMPTY.with(7, TileKind::of(TileShape::SlopeTopLeft));
    let refused = Rooms::<Blocks>::of(&[0; 40], (8, 5), CELL, &slopes, (2, 2), 1).map(|_| ());
    assert_eq!(refused, Err(TileMapError::ShapeNotInSet { id: 7 }));

    // A room with a separate map.
    let grid = Grid::new(5, 4, CELL, Vec2::from_ints(99, 99)).unwrap();
    let map = TileMap::<Blocks>::of(&[0; 20], grid, &KINDS).unwrap().with_outside(Outside::Solid);
    assert_eq!(Room::new(map, 0, 0, 2).map(|_| ()), Err(TileMapError::EmptyMap));
    assert_eq!(Room::new(map, 0, 0, u16::MAX).map(|_| ()), Err(TileMapError::EmptyMap));
    let room = Room::new(map, -3, 70_000, 1).unwrap();
    assert_eq!((room.width(), room.height(), room.map().origin()), (3, 2, Vec2::from_ints(-16, -16)));
    assert_eq!((room.in_world(Cell::new(0, 0)), room.map().outside()), ((-4, 69_999), Outside::Solid));
}

/// Rooms of a table that are far from each other.
#[test]
fn a_table_of_rooms() {
    let grid = Grid::new(4, 4, CELL, Vec2::ZERO).unwrap();
    let map = TileMap::<Blocks>::of(&[0; 16], grid, &KINDS).unwrap();
    let rooms =
        [(0, 0), (2, 0), (0, 2), (1 << 30, i32::MIN), (500, -500)].map(|(x, y)| Room::new(map, x, y, 1).unwrap());
    let next = |from: usize, x, y| {
        let found = rooms[from].next_of(&rooms, Vec2::from_ints(x, y));
        found.map(|(room, by)| (room.first(), Vec2::from_ints(x, y) + by))
    };
    assert_eq!(next(0, 33, 31), Some(((2, 0), Vec2::from_ints(1, 31))));
    assert_eq!(next(1, -1, 32), Some(((0, 2), Vec2::from_ints(31, 0))));
    assert_eq!(next(1, 1, 32), None);
    assert_eq!(next(0, -1, 0), None);
    assert_eq!(next(0, 8000, -8000), Some(((500, -500), Vec2::ZERO)));
    // Over the top of the first two, and below the third: the nearest room.
    assert_eq!(next(0, 31, -40), None);
    assert_eq!(next(0, 33, -40), Some(((2, 0), Vec2::from_ints(1, -40))));
    assert_eq!(next(1, -1, -40), Some(((0, 0), Vec2::from_ints(31, -40))));
    assert_eq!(next(1, -1, 200), Some(((0, 2), Vec2::from_ints(31, 168))));
    assert_eq!(next(3, -1, 0), None);
}
