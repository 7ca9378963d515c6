//! The picture: one background of 32 x 32 tiles and up to 128 sprites, all of 8 x 8 pixels in 15
//! colours.

use crate::register::{read16, write16};

const DISPCNT: u32 = 0x0400_0000;
const VCOUNT: u32 = 0x0400_0006;
const BG0CNT: u32 = 0x0400_0008;
const COLOURS: u32 = 0x0500_0000;
const SPRITE_COLOURS: u32 = 0x0500_0200;
const TILES: u32 = 0x0600_0000;
/// The last of the four blocks of 16 KB for backgrounds.
const MAP: u32 = 0x0600_f800;
const SPRITE_TILES: u32 = 0x0601_0000;
const SPRITES: u32 = 0x0700_0000;

pub const WIDTH: i32 = 240;
pub const HEIGHT: i32 = 160;
/// The number of sprites of the console.
pub const MOST_SPRITES: u32 = 128;

/// A picture of 8 x 8: a word per row, four bits per pixel, the left one lowest. 0 is clear.
pub type Tile = [u32; 8];

/// Addresses of tiles and colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    Background,
    Sprites,
}

/// Shows the background and no sprite.
pub fn on() {
    for sprite in 0..MOST_SPRITES {
        hide_sprite(sprite);
    }
    // Tiles from the first block, the map from the last 2 KB.
    write16(BG0CNT, 31 << 8);
    // Mode 0, sprite tiles in one row, background 0 and sprites.
    write16(DISPCNT, 0x1140);
}

/// A colour of a palette from 0 to 15, with components from 0 to 31.
pub fn set_colour(layer: Layer, palette: u32, colour: u32, (red, green, blue): (u16, u16, u16)) {
    let base = if layer == Layer::Sprites { SPRITE_COLOURS } else { COLOURS };
    write16(base + ((palette & 15) * 16 + (colour & 15)) * 2, red | green << 5 | blue << 10);
}

pub fn set_tile(layer: Layer, number: u32, tile: &Tile) {
    let base = if layer == Layer::Sprites { SPRITE_TILES } else { TILES } + (number & 511) * 32;
    for (row, word) in (0..).zip(tile) {
        write16(base + row * 4, *word as u16);
        write16(base + row * 4 + 2, (*word >> 16) as u16);
    }
}

/// Shows a tile of the background. `x` and `y` count tiles.
pub fn set_cell(x: u32, y: u32, tile: u32, palette: u32) {
    write16(MAP + ((y & 31) * 32 + (x & 31)) * 2, (tile & 1023 | (palette & 15) << 12) as u16);
}

/// Shows a tile with its upper left pixel at this position, which may be off the screen.
pub fn set_sprite(sprite: u32, (x, y): (i32, i32), tile: u32, palette: u32) {
    let at = SPRITES + (sprite & (MOST_SPRITES - 1)) * 8;
    if x <= -8 || y <= -8 || x >= WIDTH || y >= HEIGHT {
        return hide_sprite(sprite);
    }
    write16(at, (y & 255) as u16);
    write16(at + 2, (x & 511) as u16);
    write16(at + 4, (tile & 1023 | (palette & 15) << 12) as u16);
}

pub fn hide_sprite(sprite: u32) {
    write16(SPRITES + (sprite & (MOST_SPRITES - 1)) * 8, 0x200);
}

/// Waits until the last line has been drawn.
pub fn wait() {
    while read16(VCOUNT) >= HEIGHT as u16 {}
    while read16(VCOUNT) < HEIGHT as u16 {}
}
