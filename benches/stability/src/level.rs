//! The scene's level, as the library reads it.

use crate::scene::{Scene, Tiles};
use tilesat::{
    AllShapes, Blocks, Fx, Grid, Outside, Path, PathKind, SegmentMap, TileKind, TileKinds, TileMap, TileShape, Vec2,
};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'_', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'-', TileKind::of(TileShape::MildHighBottomRight));

/// A level in both forms, as bytes.
pub struct Levels {
    tiles: Option<(Grid, Vec<u8>)>,
    segments: Vec<u8>,
}

impl Levels {
    /// # Panics
    /// If the scene is no level, which is a mistake in this program.
    pub fn new(scene: &Scene) -> Self {
        let points: Vec<Vec2> = scene.outline().iter().map(|p| Vec2::from_raw(p[0], p[1])).collect();
        let closed: Vec<Vec2> = points.iter().chain(points.first()).copied().collect();
        let paths = [Path::new(PathKind::Wall, &closed)];
        let size = SegmentMap::measure(&paths, Fx::from_num(32)).expect("walls that are no level");
        let mut segments = vec![0; size.bytes()];
        SegmentMap::build_on(&paths, size.grid(), &mut segments).expect("walls that are no level");
        Self { tiles: scene.tiles.as_ref().map(bytes), segments }
    }

    /// # Panics
    /// Never: the bytes are the map's own.
    pub fn segments(&self) -> SegmentMap<'_> {
        SegmentMap::from_bytes(&self.segments).expect("bytes of a segment map")
    }

    /// The tiles, if all are full or empty.
    pub fn blocks(&self) -> Option<TileMap<'_, Blocks>> {
        static FULL: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
        let (grid, bytes) = self.tiles.as_ref().filter(|(_, bytes)| bytes.iter().all(|c| b"#.".contains(c)))?;
        TileMap::on_grid(bytes, *grid, &FULL).ok().map(|map| map.with_outside(Outside::Edge))
    }

    /// The tiles, of any shape.
    pub fn shapes(&self) -> Option<TileMap<'_, AllShapes>> {
        let (grid, bytes) = self.tiles.as_ref()?;
        TileMap::of(bytes, *grid, &KINDS).ok().map(|map| map.with_outside(Outside::Edge))
    }
}

fn bytes(tiles: &Tiles) -> (Grid, Vec<u8>) {
    let rows: Vec<&[u8]> = tiles.rows.lines().map(str::as_bytes).collect();
    let (width, height) = (rows[0].len() as u16, rows.len() as u16);
    let origin = Vec2::from_raw(tiles.origin[0], tiles.origin[1]);
    (Grid::new(width, height, Fx::from_bits(tiles.cell), origin).expect("a grid"), rows.concat())
}
