//! A level of tiles and one of segments, both built by the compiler: they must lie in flash alone.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::world::{AllShapes, Grid, Joined, Path, PathKind, TileKind, TileKinds, TileMap, TileShape, World};
use tilesat::{Aabb, Fx, Vec2, segment_map};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'(', TileKind::of(TileShape::ConcaveBottomLeft));

static TILES: TileMap<AllShapes> = match Grid::new(4, 2, Fx::lit("16"), Vec2::ZERO) {
    Ok(grid) => match TileMap::of(b"(../####", grid, &KINDS) {
        Ok(map) => map,
        Err(_) => panic!("bad tiles"),
    },
    Err(_) => panic!("bad grid"),
};

const HILL: [Vec2; 3] = [Vec2::from_ints(64, 32), Vec2::from_ints(128, 0), Vec2::from_ints(192, 32)];
segment_map!(static HILLS: [Path::new(PathKind::Solid, &HILL)], Fx::lit("32"));

tilesat_flash::program!(|body: Aabb, other: Aabb| {
    let level = Joined::new(&TILES, &HILLS);
    (level.overlaps_aabb(body), level.overlaps_aabb(other))
});
