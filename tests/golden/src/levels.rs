//! The levels: tiles of each set, polygons, boxes that move.

use tilesat::num::DOMAIN;
use tilesat::world::{Outside, ShapeSet, Side, Solid};
use tilesat::{
    AllShapes, Blocks, Fx, Grid, Path, PathKind, SegmentMap, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2,
    segment_map,
};

use super::random::{Draw, Random, UNIT};

const WIDTH: u16 = 24;
const HEIGHT: u16 = 16;
const CELLS: usize = WIDTH as usize * HEIGHT as usize;
const CELL: Fx = Fx::const_from_int(16);
/// Half cells of the tile maps, and of the polygons.
pub(crate) const SIZE: (u32, u32) = (2 * WIDTH as u32, 2 * HEIGHT as u32);

/// An id for each shape, then flags alone.
static KINDS: [TileKinds; 3] = [kinds(false, false), kinds(true, false), kinds(true, true)];

/// The table of all shapes; where a set has none of a shape, the tile is full.
const fn kinds(slopes: bool, arcs: bool) -> TileKinds {
    let mut kinds = TileKinds::EMPTY;
    let mut i = 0;
    while i < TileShape::ALL.len() {
        let shape = TileShape::ALL[i];
        let id = i as u8;
        let round = shape as u8 >= TileShape::ConvexTopLeft as u8 && shape as u8 <= TileShape::ConcaveBottomLeft as u8;
        let plain = matches!(shape, TileShape::Empty | TileShape::Full | TileShape::OneWayUp);
        let fits = if round { arcs } else { slopes || plain };
        let kind = TileKind::of(if fits { shape } else { TileShape::Full });
        kinds = kinds.with(id, kind.with_flags(id.wrapping_mul(37)));
        i += 1;
    }
    kinds
}

/// A third of the tiles empty, a third full, the rest of every shape. So every possible
/// neighbourhood occurs.
static TILES: [u8; CELLS] = {
    let (mut tiles, mut random, mut i) = ([0; CELLS], Random::new(5), 0);
    while i < CELLS {
        tiles[i] = match random.below(6) {
            0..2 => 0,
            2 => 1,
            _ => random.below(TileShape::ALL.len() as u32) as u8,
        };
        // Room for bodies: a row and a column in four are free.
        if i / WIDTH as usize % 4 == 2 || i % WIDTH as usize % 5 == 3 {
            tiles[i] = 0;
        }
        i += 1;
    }
    tiles
};

/// The positions of distant tile maps.
const FAR: i32 = DOMAIN - (1 << 25);

/// The map of a set, at one of five positions, with one of three surroundings.
pub(crate) fn tiles<S: ShapeSet>(number: u32, kinds: &'static TileKinds) -> Option<TileMap<'static, S>> {
    let at = match number / 6 % 8 {
        4 => Vec2::from_raw(FAR, FAR),
        5 => Vec2::from_raw(-FAR, FAR),
        6 => Vec2::from_raw(FAR, -FAR),
        7 => Vec2::from_raw(-FAR, -FAR),
        _ => Vec2::ZERO,
    };
    let outside = match number / 48 % 3 {
        0 => Outside::Empty,
        1 => Outside::Solid,
        _ => Outside::Edge,
    };
    Some(TileMap::of(&TILES, Grid::new(WIDTH, HEIGHT, CELL, at).ok()?, kinds).ok()?.with_outside(outside))
}

pub(crate) fn blocks(number: u32) -> Option<TileMap<'static, Blocks>> {
    tiles(number, &KINDS[0])
}

pub(crate) fn slopes(number: u32) -> Option<TileMap<'static, Slopes>> {
    tiles(number, &KINDS[1])
}

pub(crate) fn shapes(number: u32) -> Option<TileMap<'static, AllShapes>> {
    tiles(number, &KINDS[2])
}

const fn at<const N: usize>(points: [(i16, i16); N]) -> [Vec2; N] {
    let (mut out, mut i) = ([Vec2::ZERO; N], 0);
    while i < N {
        out[i] = Vec2::from_ints(points[i].0 * 8, points[i].1 * 8);
        i += 1;
    }
    out
}

/// In half cells: hills, a cave with a hole, teeth, walls that cross, one-way chains, a joint of
/// two polygons.
const GROUND: [Vec2; 9] = at([(0, 32), (0, 26), (8, 26), (12, 22), (18, 25), (26, 25), (30, 29), (36, 26), (36, 32)]);
const BESIDE: [Vec2; 4] = at([(36, 32), (36, 26), (48, 26), (48, 32)]);
const CAVE: [Vec2; 6] = at([(4, 2), (16, 2), (20, 6), (18, 12), (8, 14), (2, 8)]);
const HOLE: [Vec2; 4] = at([(7, 5), (13, 5), (14, 10), (8, 10)]);
const TEETH: [Vec2; 9] = at([(26, 2), (46, 2), (46, 5), (43, 9), (40, 4), (37, 11), (34, 5), (30, 7), (28, 5)]);
const WALL: [Vec2; 3] = at([(24, 12), (30, 18), (30, 24)]);
const ACROSS: [Vec2; 2] = at([(26, 17), (34, 15)]);
const CHAIN: [Vec2; 4] = at([(36, 18), (40, 17), (44, 19), (47, 19)]);
const BACK: [Vec2; 2] = at([(10, 19), (2, 19)]);
const PATHS: [Path<'static>; 9] = [
    Path::new(PathKind::Solid, &GROUND),
    Path::new(PathKind::Solid, &BESIDE).with_flags(1),
    Path::new(PathKind::Solid, &CAVE).with_flags(2),
    Path::new(PathKind::Hole, &HOLE).with_flags(4),
    Path::new(PathKind::Solid, &TEETH).with_flags(8),
    Path::new(PathKind::Wall, &WALL).with_flags(16),
    Path::new(PathKind::Wall, &ACROSS).with_flags(32),
    Path::new(PathKind::OneWay, &CHAIN).with_flags(64),
    Path::new(PathKind::OneWay, &BACK).with_flags(128),
];
segment_map!(static SEGMENTS: PATHS, Fx::const_from_int(32));

pub(crate) fn segments() -> &'static SegmentMap<'static> {
    &SEGMENTS
}

/// Moving boxes, drawn again from time to time.
pub(crate) fn solids(r: &mut Random, at: Vec2) -> [Solid; 4] {
    [0, 1, 2, 3].map(|key| {
        let (ox, oy) = at.raw();
        let (x, y) = (ox + r.below(40) as i32 * 8 * UNIT, oy + r.below(28) as i32 * 8 * UNIT);
        let size = (8 * UNIT + r.below(6) as i32 * 4 * UNIT, 8 * UNIT + r.below(4) as i32 * 8 * UNIT);
        let shape = tilesat::Aabb::spread(Vec2::from_raw(x, y), size);
        let solid = Solid::new(shape, key).unwrap_or(SOLID).with_flags(1 << key);
        let solid = match r.below(8) {
            0 => solid.with_one_way(Side::Up),
            1 => solid.with_one_way(Side::Left),
            2 => solid.with_conveyor(Vec2::from_raw(r.signed(16), 0)).unwrap_or(solid),
            _ => solid,
        };
        solid.with_motion(Vec2::from_raw(r.signed(18), r.signed(18))).unwrap_or(solid)
    })
}

pub(crate) const SOLID: Solid = match Solid::new(
    match tilesat::Aabb::new(Vec2::ZERO, Vec2::from_ints(16, 16)) {
        Ok(shape) => shape,
        Err(_) => panic!("a box"),
    },
    0,
) {
    Ok(solid) => solid,
    Err(_) => panic!("a solid"),
};
