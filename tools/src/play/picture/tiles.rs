//! Draws the level: ground, planks and the meaning of flags.

use tilesat::TileShape;

use crate::bake::level::Level;
use crate::picture::ink::{
    COIN, EARTH, EARTH_DARK, Ink, KILL, LADDER, NIGHT, NIGHT_LOW, OTHER, PLANK, TEXT, WATER, WIN,
};
use crate::picture::marks::{Scene, Spot};
use crate::picture::surface;
use crate::play::flags;
use crate::play::outline::Outline;
use crate::play::run::Run;
use crate::rules::names;

/// The most cells drawn one by one. Larger levels are drawn as blocks of cells. No picture has more
/// marks than this.
const MOST: u32 = 1 << 16;

/// The side of the square of cells that is drawn as one block.
fn block(level: &Level) -> u16 {
    (1..u16::MAX)
        .find(|&k| u32::from(level.width.div_ceil(k)) * u32::from(level.height.div_ceil(k)) <= MOST)
        .unwrap_or(1)
}

/// From the first cell on, at the corner of the picture.
pub(super) fn draw(scene: &mut Scene, level: &Level, run: &Run) {
    sky(scene);
    let block = block(level);
    if block > 1 {
        return blocks(scene, level, block);
    }
    let tile = f32::from(level.tile);
    for y in 0..level.height {
        for x in 0..level.width {
            let at = (f32::from(x) * tile, f32::from(y) * tile);
            let kind = level.kind(x, y);
            // Two shades in a checkerboard show the cells without lines between them.
            solid(scene, at, tile, kind.shape, if (x + y) % 2 == 0 { EARTH } else { EARTH_DARK });
            let cell = usize::from(y) * usize::from(level.width) + usize::from(x);
            signs(scene, at, tile, kind.flags, level, run.taken.contains(&cell));
            plank(scene, at, tile, kind.shape);
        }
    }
}

/// The surface of the cells, at their position in the level.
pub(super) fn surfaces(scene: &mut Scene, level: &Level) {
    if block(level) == 1 {
        surface::draw(scene, &level.features(), f32::from(level.tile));
    }
}

/// Each square of `k` by `k` cells, as dark as its solid share.
fn blocks(scene: &mut Scene, level: &Level, k: u16) {
    let side = f32::from(level.tile) * f32::from(k);
    for y in (0..level.height).step_by(usize::from(k)) {
        for x in (0..level.width).step_by(usize::from(k)) {
            let cells = (y..level.height.min(y + k)).flat_map(|y| (x..level.width.min(x + k)).map(move |x| (x, y)));
            let solid = cells.filter(|&(x, y)| names::is_solid(level.kind(x, y).shape)).count();
            if solid > 0 {
                let at = (f32::from(x) * f32::from(level.tile), f32::from(y) * f32::from(level.tile));
                scene.rect(at, (side, side), EARTH.alpha(solid as f32 / (f32::from(k) * f32::from(k))));
            }
        }
    }
}

pub(super) fn solid(scene: &mut Scene, at: Spot, tile: f32, shape: TileShape, fill: Ink) {
    let place = |(x, y): Spot| (at.0 + x * tile, at.1 + y * tile);
    match Outline::of(shape) {
        Outline::Nothing => {}
        Outline::Polygon(_) if shape == TileShape::Full => scene.rect(at, (tile, tile), fill),
        Outline::Polygon(points) => {
            let points: Vec<Spot> = points.iter().map(|&(x, y)| place((x as f32 / 2.0, y as f32 / 2.0))).collect();
            scene.poly(&points, fill);
        }
        Outline::Quarter(centre) | Outline::Bite(centre) => {
            let corner = (centre.0 as f32 / 2.0, centre.1 as f32 / 2.0);
            let side = |v: f32| 1.0 - 2.0 * v;
            let arc = (0..=ARC).map(|i| {
                let (sin, cos) = (f32::from(i) / f32::from(ARC) * std::f32::consts::FRAC_PI_2).sin_cos();
                place((corner.0 + side(corner.0) * cos, corner.1 + side(corner.1) * sin))
            });
            let hollow = matches!(Outline::of(shape), Outline::Bite(_));
            let rest = if hollow { (1.0 - corner.0, 1.0 - corner.1) } else { corner };
            scene.poly(&arc.chain([place(rest)]).collect::<Vec<_>>(), fill);
        }
    }
}

/// Straight pieces per quarter circle.
const ARC: u8 = 16;

/// The edge of a one-way tile, and a fainter line behind it.
fn plank(scene: &mut Scene, at: Spot, tile: f32, shape: TileShape) {
    for (from, to, alpha) in [(0.0, 0.2, 1.0), (0.2, 0.3, 0.35)] {
        let (lo, hi) = match shape {
            TileShape::OneWayUp => ((0.0, from), (1.0, to)),
            TileShape::OneWayDown => ((0.0, 1.0 - to), (1.0, 1.0 - from)),
            TileShape::OneWayLeft => ((from, 0.0), (to, 1.0)),
            TileShape::OneWayRight => ((1.0 - to, 0.0), (1.0 - from, 1.0)),
            _ => return,
        };
        let corner = (at.0 + lo.0 * tile, at.1 + lo.1 * tile);
        scene.rect(corner, ((hi.0 - lo.0) * tile, (hi.1 - lo.1) * tile), PLANK.alpha(alpha));
    }
}

fn sky(scene: &mut Scene) {
    let (width, height) = scene.level;
    let bands = 24u8;
    for band in 0..bands {
        let (t, step) = (f32::from(band) / f32::from(bands - 1), height / f32::from(bands));
        let mix = |a: u8, b: u8| (f32::from(a) * (1.0 - t) + f32::from(b) * t) as u8;
        let rgb = [0, 1, 2].map(|i| mix(NIGHT.rgb[i], NIGHT_LOW.rgb[i]));
        scene.rect((0.0, step * f32::from(band)), (width, step), Ink { rgb, alpha: 1.0 });
    }
}

fn signs(scene: &mut Scene, at: Spot, t: f32, flags: u8, level: &Level, taken: bool) {
    let (rules, water) = (flags::rules(level), level.mask("Water"));
    let middle = (at.0 + t / 2.0, at.1 + t / 2.0);
    let bottom = at.1 + t;
    if flags & water != 0 {
        scene.rect(at, (t, t), WATER.alpha(0.35));
    }
    if flags & rules.ladder != 0 {
        for x in [0.22, 0.68] {
            scene.rect((at.0 + t * x, at.1), (t * 0.1, t), LADDER);
        }
        for y in [0.12, 0.62] {
            scene.rect((at.0 + t * 0.22, at.1 + t * y), (t * 0.56, t * 0.1), LADDER);
        }
    }
    if flags & rules.kill != 0 {
        for k in [0.0, 1.0, 2.0] {
            let left = at.0 + t * k / 3.0;
            let peak = (left + t / 6.0, bottom - t * 0.7);
            scene.poly(&[(left, bottom), (left + t / 3.0, bottom), peak], KILL);
        }
    }
    if flags & rules.win != 0 {
        scene.rect((at.0 + t * 0.2, at.1 - t * 0.5), (t * 0.09, t * 1.5), TEXT);
        let (x, y) = (at.0 + t * 0.29, at.1 - t * 0.5);
        scene.poly(&[(x, y), (x + t * 0.8, y + t * 0.32), (x, y + t * 0.64)], WIN);
    }
    if flags & rules.coin != 0 {
        if taken {
            scene.ring(middle, t * 0.24, t * 0.06, COIN.alpha(0.45));
        } else {
            scene.disc(middle, t * 0.28, COIN);
            scene.ring(middle, t * 0.18, t * 0.05, NIGHT.alpha(0.35));
        }
    }
    let other = flags & !(rules.ladder | rules.kill | rules.win | rules.coin | water);
    if other != 0 {
        let ink = OTHER[other.trailing_zeros() as usize % OTHER.len()];
        scene.rect((at.0 + t * 0.2, at.1 + t * 0.2), (t * 0.6, t * 0.6), ink.alpha(0.6));
    }
}
