//! Draws the level as tiles, the bodies as sprites, and the cost of a frame as a bar. Pixels are
//! two units wide.

use tilesat::{Aabb, Cell, TileShape, Vec2};
use tilesat_gba::cycles::FRAME;
use tilesat_gba::screen::{Layer, Tile, set_cell, set_colour, set_sprite, set_tile};

use crate::crowd::{BALLS, BOXES, Crowd, Shape};
use crate::level::{HEIGHT, Level, WIDTH};
use tilesat_games::ninja::{Ninja, State};

/// Colours of the background, and of the palettes of sprites.
const SKY: (u16, u16, u16) = (3, 4, 7);
const EARTH: (u16, u16, u16) = (14, 15, 20);
const PLANK: (u16, u16, u16) = (27, 19, 8);
const GOOD: (u16, u16, u16) = (9, 26, 12);
const REST: (u16, u16, u16) = (8, 14, 28);
const LATE: (u16, u16, u16) = (30, 7, 7);
const TEXT: (u16, u16, u16) = (29, 29, 28);
const PALETTES: [(u16, u16, u16); 4] = [(31, 29, 12), (9, 26, 12), (12, 18, 31), (27, 12, 27)];

/// Tiles of the background. The tile ids of the level are ASCII, and these follow them.
const DIGITS: u32 = 128;
const BAR: u32 = 144;
const CLEAR: u32 = b'.' as u32;
/// Tiles of sprites: boxes, balls, the ninja.
const BALL_TILES: u32 = BOXES.len() as u32;
const NINJA_TILE: u32 = BALL_TILES + BALLS.len() as u32;
const NINJA_RADIUS: i32 = 6;

/// A bar of this many pixels is one frame.
const BAR_WIDTH: u32 = 192;
const BAR_ROW: u32 = HEIGHT as u32;

/// 3 x 5 pixels, three bits per row from the top.
const FONT: [u16; 10] = [0o75557, 0o26227, 0o71747, 0o71717, 0o55711, 0o74717, 0o74757, 0o71111, 0o75757, 0o75717];

/// The tile whose pixels have this colour (0 is clear).
fn tile(colour: impl Fn(i32, i32) -> u32) -> Tile {
    let mut tile = [0; 8];
    for (y, row) in (0..).zip(&mut tile) {
        *row = (0..8).fold(0, |row, x| row | colour(x, y) << (4 * x));
    }
    tile
}

pub fn prepare(level: &Level) {
    for (colour, rgb) in (0..).zip([SKY, EARTH, PLANK, GOOD, REST, LATE, TEXT]) {
        set_colour(Layer::Background, 0, colour, rgb);
    }
    for (palette, rgb) in (0..).zip(PALETTES) {
        set_colour(Layer::Sprites, palette, 1, rgb);
    }
    for (digit, rows) in (0..).zip(FONT) {
        let bit = |x: i32, y: i32| rows >> (14 - (3 * (y - 1) + x - 2)) & 1 != 0;
        let on = |x, y| (2..5).contains(&x) && (1..6).contains(&y) && bit(x, y);
        set_tile(Layer::Background, DIGITS + digit, &tile(|x, y| if on(x, y) { 6 } else { 0 }));
    }
    // Eight widths of each of three colours.
    for step in 0..24 {
        let (width, colour) = (step as i32 % 8 + 1, step / 8 + 3);
        let on = |x, y| x < width && (2..7).contains(&y);
        set_tile(Layer::Background, BAR + step, &tile(|x, y| if on(x, y) { colour } else { 0 }));
    }
    prepare_sprites();
    prepare_level(level);
}

fn prepare_sprites() {
    // From the middle of the tile to the middle of the pixel, in units.
    let at = |x: i32| 2 * x - 7;
    for (number, (w, h)) in (0..).zip(BOXES) {
        let inside = |x, y| at(x).abs() <= i32::from(w) && at(y).abs() <= i32::from(h);
        set_tile(Layer::Sprites, number, &tile(|x, y| inside(x, y).into()));
    }
    let disc = |r: i32| tile(move |x, y| u32::from(at(x) * at(x) + at(y) * at(y) <= r * r));
    for (number, radius) in (BALL_TILES..).zip(BALLS) {
        set_tile(Layer::Sprites, number, &disc(radius.into()));
    }
    set_tile(Layer::Sprites, NINJA_TILE, &disc(NINJA_RADIUS));
}

/// A tile's picture shows the level's answer for each pixel, at the first cell with this tile.
fn prepare_level(level: &Level) {
    let mut known = [false; 128];
    for (x, y) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))) {
        let cell = Cell::new(x as i16, y as i16);
        let Some(id) = level.tile(cell).filter(|id| *id < 128) else { continue };
        if !core::mem::replace(&mut known[usize::from(id)], true) {
            let solid = |px, py| is_solid(level, x * 16 + px * 2, y * 16 + py * 2);
            let plank = edge(level.kind(cell).shape);
            let colour = |px, py| if plank(px, py) { 2 } else { solid(px, py).into() };
            set_tile(Layer::Background, id.into(), &tile(colour));
        }
        set_cell(x as u32, y as u32, id.into(), 0);
    }
    for x in 0..WIDTH as u32 {
        set_cell(x, BAR_ROW, CLEAR, 0);
    }
}

/// Whether the middle of the pixel two units from here is solid.
fn is_solid(level: &Level, x: i32, y: i32) -> bool {
    let centre = Vec2::from_ints(x as i16 + 1, y as i16 + 1);
    Aabb::from_centre(centre, Vec2::from_raw(1 << 15, 1 << 15)).is_ok_and(|pixel| level.overlaps(&pixel))
}

/// The pixels of a one-way edge, which is not solid.
fn edge(shape: TileShape) -> impl Fn(i32, i32) -> bool {
    move |x, y| match shape {
        TileShape::OneWayUp => y == 0,
        TileShape::OneWayRight => x == 7,
        TileShape::OneWayDown => y == 7,
        TileShape::OneWayLeft => x == 0,
        _ => false,
    }
}

pub fn bodies(ninja: &Ninja, crowd: &Crowd) {
    let palette = match ninja.state {
        State::Floor | State::Ceiling => 0,
        State::Wall => 2,
        State::Air => 0,
    };
    set_sprite(0, corner(ninja.body.centre()), NINJA_TILE, palette);
    for (i, body) in (0..).zip(crowd.bodies()) {
        let size = i / 2 % 4;
        let (tile, palette) = match body.shape {
            Shape::Box(_) => (size, 1 + (i & 2)),
            Shape::Ball(_) => (BALL_TILES + size, 1 + (i & 2)),
        };
        set_sprite(i + 1, corner(body.shape.centre()), tile, palette);
    }
}

/// The upper left pixel of a sprite around a position.
fn corner(centre: Vec2) -> (i32, i32) {
    let (x, y) = centre.raw();
    // Half a pixel is a unit.
    (((x + (1 << 16)) >> 17) - 4, ((y + (1 << 16)) >> 17) - 4)
}

/// Green for the collision, blue for the rest of the work, red beyond one frame. Also the number of
/// bodies, and the percentage of a frame.
pub fn bar(collision: u32, all: u32, count: usize) {
    let pixels = |cycles: u32| (cycles.min(2 * FRAME) * BAR_WIDTH).div_ceil(FRAME).min(BAR_WIDTH);
    let (first, second) = (pixels(collision), pixels(all));
    let over = all > FRAME;
    for x in 0..BAR_WIDTH / 8 {
        let part = |until: u32| until.saturating_sub(x * 8).min(8);
        let (tile, width) = match (part(first), part(second)) {
            (0, width) => (BAR + 8, width),
            (width, _) => (BAR + if over { 16 } else { 0 }, width),
        };
        set_cell(x, BAR_ROW, if width == 0 { CLEAR } else { tile + width - 1 }, 0);
    }
    let percent = collision / (FRAME / 100);
    let bodies = [count as u32 / 10, count as u32];
    let part = [percent / 100, percent / 10, percent];
    for (x, digit) in (24..).zip(bodies).chain((27..).zip(part)) {
        set_cell(x, BAR_ROW, DIGITS + digit % 10, 0);
    }
}
