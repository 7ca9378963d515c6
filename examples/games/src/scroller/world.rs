//! The world: a hundred screens, of five drawn ones. A byte per tile in flash, in rooms of any
//! size.

use tilesat::{AllShapes, Fx, Room, Rooms, TileKind, TileKinds, TileMapError, TileShape, fx};

/// The side of a cell in pixels.
pub const CELL: Fx = fx!(16);
pub const WIDTH: u16 = SCREEN as u16 * 100;
pub const HEIGHT: u16 = ROWS as u16;
/// The tallest body, and the longest motion per frame with its step and snap, in pixels.
pub const BODY: Fx = fx!(14);
pub const MOTION: Fx = fx!(28);

const SCREEN: usize = 25;
const ROWS: usize = 8;
const SCREENS: [&[u8; SCREEN * ROWS]; 5] = [
    b"\
.........................\
.........................\
.........................\
.........................\
............##...........\
......#.....##......##...\
####################..###\
#########################",
    b"\
.........................\
.........................\
.........................\
........../###\\..........\
........./#####\\.........\
......../#######\\........\
#########################\
#########################",
    b"\
.........................\
.........................\
.........................\
.........====............\
.........................\
....ab#####cd....ab##cd..\
#########################\
#########################",
    b"\
.........................\
.........................\
.........................\
............#............\
..........###............\
.......######\\....####...\
##############....#######\
#########################",
    b"\
.........................\
.........................\
.........................\
.........................\
.........................\
...../\\../\\../\\../\\......\
#########################\
#########################",
];

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'=', TileKind::ONE_WAY_UP)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight))
    .with(b'c', TileKind::of(TileShape::MildHighBottomLeft))
    .with(b'd', TileKind::of(TileShape::MildLowBottomLeft));

/// 20 000 bytes, row by row. The compiler joins the screens.
#[expect(clippy::indexing_slicing, reason = "the compiler runs it, and would report the error")]
static TILES: [u8; WIDTH as usize * ROWS] = {
    let mut tiles = [b'.'; WIDTH as usize * ROWS];
    let mut at = 0;
    while at < tiles.len() {
        let (row, column) = (at / WIDTH as usize, at % WIDTH as usize);
        let (number, x) = (column / SCREEN, column % SCREEN);
        tiles[at] = SCREENS[number * 7 % 11 % 5][row * SCREEN + x];
        at += 1;
    }
    tiles
};

/// The world in rooms of this many columns. Their size makes no difference to the runner.
pub const fn rooms(columns: u16) -> Result<Rooms<'static>, TileMapError> {
    let apron = Room::<AllShapes>::apron_for(CELL, BODY, MOTION);
    Rooms::of(&TILES, (WIDTH, HEIGHT), CELL, &KINDS, (columns, HEIGHT), apron)
}
