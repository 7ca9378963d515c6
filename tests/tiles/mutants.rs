//! Levels, each in one scene with a known answer. Changes of the sources that no other test noticed
//! led to them.

use tilesat::{
    Aabb, AllShapes, Axis, Cell, Circle, Fx, Grid, Inside, Joined, Mover, Path, PathKind, Quantity, SegmentMap,
    SegmentMapError, Side, Solid, Solids, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2, World,
    world::{Feature, Geometry, OneWay},
};

static BLOCKS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
static KINDS: TileKinds = BLOCKS.with(b'L', TileKind::of(TileShape::ConcaveBottomLeft));

fn rect(x0: i16, y0: i16, x1: i16, y1: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x0, y0), Vec2::from_ints(x1, y1)).unwrap()
}

fn features(level: &impl World) -> Vec<Feature> {
    level.features(&rect(-500, -500, 500, 500)).collect()
}

/// The number of faces and of corners.
fn pieces(level: &impl World) -> (usize, usize) {
    let all = features(level);
    let count = |f: fn(&Geometry) -> bool| all.iter().filter(|of| f(&of.geometry)).count();
    (count(|g| matches!(g, Geometry::Face { .. })), count(|g| matches!(g, Geometry::Vertex { .. })))
}

fn block(x: i16, y: i16) -> TileMap<'static> {
    TileMap::on_grid(b"#", Grid::new(1, 1, Fx::from_num(16), Vec2::from_ints(x, y)).unwrap(), &BLOCKS).unwrap()
}

/// Blocks far from each other have four faces and four corners each, in pairs of pairs too.
#[test]
fn pairs_of_pairs_hide_nothing_that_stands_alone() {
    let (a, b, c, d) = (block(0, 0), block(100, 0), block(0, 100), block(100, 100));
    let (ab, cd) = (Joined::new(&a, &b), Joined::new(&c, &d));
    assert_eq!(pieces(&Joined::new(&ab, &c)), (12, 12));
    assert_eq!(pieces(&Joined::new(&c, &ab)), (12, 12));
    assert_eq!(pieces(&Joined::new(&ab, &cd)), (16, 16));
}

/// A ball of 20 units, 5 from the centre of a pipe of 16, is 9 too deep in it. It is pushed by that
/// toward the centre, (4, -3) / 5 of it.
#[test]
fn a_ball_larger_than_a_pipe_is_pushed_toward_its_centre() {
    let map = TileMap::<AllShapes>::of(b"L", Grid::new(1, 1, Fx::from_num(16), Vec2::ZERO).unwrap(), &KINDS).unwrap();
    let ball = Circle::new(Vec2::from_ints(12, 3), Fx::from_num(20)).unwrap();
    let mut found = tilesat::heapless::Vec::<_, 8>::new();
    map.contacts(&ball, OneWay::Ignore, &mut found).unwrap();
    let arc = found.iter().find(|c| matches!(c.feature().geometry, Geometry::Arc { .. })).unwrap();
    let (x, y) = arc.push_out().raw();
    assert!((x - 9 * 4 * 65_536 / 5).abs() <= 4 && (y + 9 * 3 * 65_536 / 5).abs() <= 4, "{x} {y}");
}

/// The sides of a cell are 0 to 3 from the top on, clockwise.
#[test]
fn rays_tell_the_side_that_they_meet() {
    let map = TileMap::from_ascii("...\n.#.\n...", &BLOCKS).unwrap();
    for (from, by, side) in
        [((24, 4), (0, 40), 0), ((44, 24), (-40, 0), 1), ((24, 44), (0, -40), 2), ((4, 24), (40, 0), 3)]
    {
        let (from, by) = (Vec2::from_ints(from.0, from.1), Vec2::from_ints(by.0, by.1));
        let hit = map.cast_ray(from, by, Inside::Hit).unwrap().unwrap();
        assert_eq!((hit.index, hit.cell), (side, Cell::new(1, 1)));
    }
}

#[test]
fn occupancy_is_a_bit_a_tile() {
    let map = || TileMap::from_ascii("..#\n...\n##.", &BLOCKS).unwrap();
    assert!(map().with_occupancy(&[0b100, 0, 0b011, 1]).is_ok());
    for (row, words) in [[0b110, 0, 0b011, 1], [0b100, 1, 0b011, 1], [0b100, 0, 0b001, 1]].iter().enumerate() {
        assert_eq!(map().with_occupancy(words).unwrap_err(), TileMapError::Occupancy { row: row as u16 });
    }
}

/// The tops of a floor's tiles continue at both ends, except at the ends of the floor.
#[test]
fn faces_of_a_floor_are_joined() {
    let map = TileMap::<AllShapes>::of(b"###", Grid::new(3, 1, Fx::from_num(16), Vec2::ZERO).unwrap(), &KINDS).unwrap();
    let tops = features(&map).into_iter().filter_map(|f| match f.geometry {
        Geometry::Face { dir: Axis::X, joined, .. } => Some(joined),
        _ => None,
    });
    assert_eq!(tops.collect::<Vec<_>>(), [[false, true], [true, true], [true, false]]);
}

/// Two boxes side by side have no sides there, and no corners at their ends.
#[test]
fn flush_boxes_are_one() {
    for (second, hidden) in [(rect(16, 0, 32, 16), [1, 3]), (rect(0, 16, 16, 32), [2, 0])] {
        let list = [Solid::new(rect(0, 0, 16, 16), 0).unwrap(), Solid::new(second, 1).unwrap()];
        let level = Solids::new(&list);
        assert_eq!(pieces(&level), (6, 4));
        let shown = |key: usize, face: u16| {
            features(&level).iter().any(|f| Solids::key_of(f.cell) == Some(key as u16) && f.index == face)
        };
        for (key, gone) in hidden.into_iter().enumerate() {
            assert!((0..4).all(|face| shown(key, face) == (face != gone)), "{key}");
        }
    }
}

/// A box that blocks on one side is only that side for bodies, and nothing from the other sides.
#[test]
fn a_one_way_box_is_one_face() {
    let list = [Solid::new(rect(0, 0, 32, 8), 7).unwrap().with_one_way(Side::Up)];
    let level = Solids::new(&list);
    assert_eq!(pieces(&level), (1, 0));
    let below = rect(8, 20, 16, 30);
    let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&level, &below, Vec2::from_ints(0, -40)).unwrap();
    assert_eq!((moved.position(), moved.hits.len()), (Vec2::from_ints(8, -20), 0));
    let above = rect(8, -20, 16, -10);
    let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&level, &above, Vec2::from_ints(0, 40)).unwrap();
    assert_eq!((moved.position(), moved.floor), (Vec2::from_ints(8, -10), true));
}

fn segments(paths: &[Path<'_>], cell: i16) -> Vec<u8> {
    let mut out = vec![0; 4000];
    let length = SegmentMap::build_into(paths, Fx::from_num(cell), &mut out).unwrap();
    out.truncate(length);
    out
}

/// A point on the border of a polygon and in the inside of another is in the inside: on edges of
/// all directions.
#[test]
fn inner_borders_are_inside() {
    let square = [(0, 0), (96, 0), (96, 96), (0, 96)].map(|(x, y)| Vec2::from_ints(x, y));
    for quad in [
        [(48, 16), (80, 48), (48, 80), (16, 48)],
        [(32, 16), (80, 32), (64, 80), (16, 64)],
        [(16, 16), (80, 16), (80, 80), (16, 80)],
    ] {
        let mut quad = quad.map(|(x, y)| Vec2::from_ints(x, y));
        for _ in 0..2 {
            for cell in [16, 24, 128] {
                let paths = [Path::new(PathKind::Solid, &square), Path::new(PathKind::Solid, &quad)];
                let bytes = segments(&paths, cell);
                let map = SegmentMap::from_bytes(&bytes).unwrap();
                for i in 0..4 {
                    // Even sums: the middles are exact.
                    let (a, b) = (quad[i].raw(), quad[(i + 1) % 4].raw());
                    for part in 0..4 {
                        let at = |a: i32, b: i32| a + (b - a) / 4 * part;
                        let p = Vec2::from_raw(at(a.0, b.0), at(a.1, b.1));
                        assert!(map.overlaps(&Aabb::new(p, p).unwrap()), "{p:?} {cell}");
                    }
                }
                let border = Vec2::from_ints(0, 48);
                assert!(!map.overlaps(&Aabb::new(border, border).unwrap()));
            }
            quad.reverse();
        }
    }
}

/// The format's checksum: 32-bit FNV-1a with its own bytes as zero.
fn signed(mut bytes: Vec<u8>) -> Vec<u8> {
    bytes[28..32].fill(0);
    let sum = bytes.iter().fold(0x811c_9dc5u32, |hash, &byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193));
    bytes[28..32].copy_from_slice(&sum.to_le_bytes());
    bytes
}

/// Both sides of a wall through a row of cells are in each of them. A falling offset takes them out
/// of the cell before.
#[test]
fn offsets_that_fall_name_their_cell() {
    let wall = [(4, 8), (60, 8)].map(|(x, y)| Vec2::from_ints(x, y));
    let bytes = segments(&[Path::new(PathKind::Wall, &wall)], 16);
    let half = |at: usize| usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
    let (offsets, columns, rows) = (32 + 24 * 2, half(20), half(22));
    assert!(half(6) == 2 && rows == 1 && columns >= 3);
    assert!(SegmentMap::from_bytes(&signed(bytes.clone())).is_ok());
    for column in 1..columns {
        let (begin, end) = (half(offsets + 2 * column), offsets + 2 * (column + 1));
        assert_eq!((begin, half(end)), (2 * column, 2 * column + 2));
        let mut bytes = bytes.clone();
        bytes[end] = begin as u8 - 1;
        let refused = SegmentMap::from_bytes(&signed(bytes)).unwrap_err();
        assert_eq!(refused, SegmentMapError::Refs(Cell::new(column as i16, 0)));
    }
}

/// In a constant, the compiler names a path as the program does.
#[test]
fn refusals_in_constants_name_the_path() {
    let (path, point) = (12, 345);
    for (error, text) in [
        (SegmentMapError::ZeroLength { path, point }, "path 12: point 345 is the same as the next: remove one of them"),
        (SegmentMapError::OutsideGrid { path, point }, "path 12, point 345 is outside the grid: enlarge the grid"),
        (SegmentMapError::NoArea { path }, "path 12 is a polygon without area: draw it as a wall"),
    ] {
        assert_eq!(error.__text().as_str(), text);
    }
    let (what, value) = (Quantity::Y, i32::MIN);
    for error in [
        SegmentMapError::Empty,
        SegmentMapError::TooFewPoints { path: u32::MAX, points: 1 },
        SegmentMapError::TooFewPoints { path: 0, points: 2 },
        SegmentMapError::OutOfDomain { path, point, what: Quantity::X, value: 1 << 29 },
        SegmentMapError::OutOfDomain { path: u32::MAX, point: u32::MAX, what, value },
        SegmentMapError::TooManySegments { path: u32::MAX, point: u32::MAX },
        SegmentMapError::TooManyRefs { path: u32::MAX, point: u32::MAX },
        SegmentMapError::Grid(TileMapError::Cell(value)),
        SegmentMapError::Grid(TileMapError::TooManyCells(40_000)),
        SegmentMapError::TooDeep(Cell::new(-1, 7)),
    ] {
        assert_eq!(error.__text().as_str(), error.to_string());
    }
}
