//! Draws a level below a picture of its solid, with the images of its tiles if they exist.

use std::collections::HashMap;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use png::{Decoder, Limits, Transformations};

use super::marks::{Image, Scene, Spot};
use crate::model::flip::Flip;
use crate::model::map::{Map, Placed};
use crate::rules::ground::Ground;

/// The most bytes of an image file, and of its pixels.
const MAX_BYTES: u64 = 64 << 20;

/// The tiles of a map for a picture with this origin. `None` without images.
pub fn image(scene: &Scene, corner: Spot, map: &Map, ground: &Ground, scale: Option<(u32, u32)>) -> Option<Image> {
    let zoom = scale.map_or(1.0, |(n, d)| n as f32 / d as f32) * scene.scale;
    let (width, height) = ((scene.level.0 * scene.scale) as usize, (scene.level.1 * scene.scale) as usize);
    let mut image = Image { width, height, pixels: vec![[0; 4]; width * height] };
    let mut sources = Sources::default();
    let start = (corner.0 - ground.shift.0 as f32, corner.1 - ground.shift.1 as f32);
    for layer in &map.layers {
        let Some(tiles) = layer.tiles() else { continue };
        let offset = (layer.offset.0.to_f64() as f32, layer.offset.1.to_f64() as f32);
        for (x, y, cell) in tiles.drawn() {
            let Placed::Tile { tileset, id, flip, moved } = &map.palette[cell as usize] else { continue };
            let Some((source, from, size)) = sources.tile(map, *tileset, *id) else { continue };
            let side = f32::from(tiles.tile);
            let set = &map.tilesets[*tileset];
            // A cell of the file. Its tile is in the lower left one of the cells that it is here.
            let cell = (side * map.grid.0 as f32, side * map.grid.1 as f32);
            let (wide, high) = match (set.fits_grid, set.keeps_aspect) {
                (false, _) => (size.0 as f32, size.1 as f32),
                (true, false) => cell,
                (true, true) => {
                    let along = |cell: f32, size: u32| cell / size.max(1) as f32;
                    let scale = along(cell.0, size.0).min(along(cell.1, size.1));
                    (size.0 as f32 * scale, size.1 as f32 * scale)
                }
            };
            // In a cell, it is in the middle. Otherwise LDtk draws it downward, and Tiled upward.
            let (right, down) = match (set.fits_grid, map.values) {
                (true, _) => ((cell.0 - wide) / 2.0, side - cell.1 + (cell.1 - high) / 2.0),
                (false, true) => (0.0, 0.0),
                (false, false) => (0.0, side - high),
            };
            let drawn = set.offset;
            // The offset is scaled with the picture.
            let scaled = |by: i32, to: f32, from: u32| by as f32 * to / from.max(1) as f32;
            let moved = (moved.0.to_f64() as f32, moved.1.to_f64() as f32);
            let left = x as f32 * side + right + offset.0 + moved.0 + scaled(drawn.0, wide, size.0);
            let top = y as f32 * side + down + offset.1 + moved.1 + scaled(drawn.1, high, size.1);
            let place = |v: f32, start: f32| v * zoom - start * scene.scale;
            let at = (place(left, start.0), place(top, start.1));
            blit(&mut image, at, (wide * zoom, high * zoom), source, from, size, *flip);
        }
    }
    sources.images.values().any(Option::is_some).then_some(image)
}

/// An image, the position of a tile in it, and the tile's size.
type Part<'a> = (&'a Image, (u32, u32), (u32, u32));

/// The images that were read. `None` for a file that is not a PNG.
#[derive(Default)]
struct Sources {
    images: HashMap<PathBuf, Option<Image>>,
}

impl Sources {
    /// The image of a tile, its position there and its size.
    fn tile(&mut self, map: &Map, tileset: usize, id: u32) -> Option<Part<'_>> {
        let set = &map.tilesets[tileset];
        let own = set.tiles.get(&id).and_then(|tile| tile.image.as_ref());
        let path = own.map(|(path, _)| path).or(set.image.as_ref())?;
        if !self.images.contains_key(path) {
            self.images.insert(path.clone(), read(path));
        }
        let image = self.images.get(path)?.as_ref()?;
        if let Some((_, part)) = own {
            // Files of other programs may not give the size of the image.
            let all = (image.width as u32, image.height as u32);
            let size = if part.size.0 == 0 || part.size.1 == 0 { all } else { part.size };
            return Some((image, part.at, size));
        }
        let along =
            |index: u32, size: u32| set.margin.saturating_add(index.saturating_mul(size.saturating_add(set.spacing)));
        let from = (along(id % set.columns, set.size.0), along(id / set.columns, set.size.1));
        Some((image, from, set.size))
    }
}

fn read(path: &Path) -> Option<Image> {
    fs::metadata(path).ok().filter(|known| known.is_file() && known.len() <= MAX_BYTES)?;
    let mut decoder = Decoder::new_with_limits(Cursor::new(fs::read(path).ok()?), Limits { bytes: MAX_BYTES as usize });
    decoder.set_transformations(Transformations::normalize_to_color8() | Transformations::ALPHA);
    let mut reader = decoder.read_info().ok()?;
    let size = reader.output_buffer_size().filter(|size| *size as u64 <= MAX_BYTES)?;
    let mut bytes = vec![0; size];
    let info = reader.next_frame(&mut bytes).ok()?;
    let samples = info.color_type.samples();
    let pixel = |p: &[u8]| match *p {
        [v, a] => [v, v, v, a],
        [r, g, b, a] => [r, g, b, a],
        _ => [0; 4],
    };
    let pixels = bytes[..info.buffer_size()].chunks_exact(samples).map(pixel).collect();
    Some(Image { width: info.width as usize, height: info.height as usize, pixels })
}

/// Draws a part of an image into a box, with the nearest pixels.
fn blit(
    to: &mut Image,
    at: (f32, f32),
    size: (f32, f32),
    from: &Image,
    corner: (u32, u32),
    part: (u32, u32),
    flip: Flip,
) {
    let span = |at: f32, length: f32, end: usize| {
        (at.round().max(0.0) as usize).min(end)..((at + length).round().max(0.0) as usize).min(end)
    };
    for y in span(at.1, size.1, to.height) {
        for x in span(at.0, size.0, to.width) {
            let (u, v) = (
                ((x as f32 + 0.5 - at.0) / size.0).clamp(0.0, 0.999),
                ((y as f32 + 0.5 - at.1) / size.1).clamp(0.0, 0.999),
            );
            let u = if flip.horizontal { 0.999 - u } else { u };
            let v = if flip.vertical { 0.999 - v } else { v };
            let (u, v) = if flip.diagonal { (v, u) } else { (u, v) };
            let (sx, sy) =
                (corner.0 as usize + (u * part.0 as f32) as usize, corner.1 as usize + (v * part.1 as f32) as usize);
            if sx < from.width && sy < from.height {
                let [r, g, b, alpha] = from.pixels[sy * from.width + sx];
                let below = &mut to.pixels[y * to.width + x];
                let mix = |below: u8, over: u8| {
                    ((u32::from(below) * (255 - u32::from(alpha)) + u32::from(over) * u32::from(alpha)) / 255) as u8
                };
                *below = [mix(below[0], r), mix(below[1], g), mix(below[2], b), below[3].max(alpha)];
            }
        }
    }
}
