//! The level: ground, planks and what the flags mean.

use super::super::level::{Block, Level};
use super::super::play::Run;
use super::super::sim::Rules;
use super::ink::{COIN, EARTH, EARTH_DARK, EDGE, Ink, KILL, LADDER, NIGHT, NIGHT_LOW, OTHER, PLANK, TEXT, TOP, WIN};
use super::marks::{Scene, Spot};

pub fn draw(scene: &mut Scene, level: &Level, run: &Run) {
    sky(scene);
    let tile = f32::from(level.tile);
    let rules = level.rules();
    for y in 0..level.height {
        for x in 0..level.width {
            let at = (f32::from(x) * tile, f32::from(y) * tile);
            if level.block(x, y) == Block::All {
                // Two shades in a checkerboard show the cells without lines between them.
                let fill = if (x + y) % 2 == 0 { EARTH } else { EARTH_DARK };
                scene.rect(at, (tile, tile), fill);
            }
            let cell = usize::from(y) * usize::from(level.width) + usize::from(x);
            let taken = run.taken.contains(&cell);
            flags(scene, at, tile, level.flags_at(x, y), rules, taken);
            if level.block(x, y) == Block::FromAbove {
                scene.rect(at, (tile, tile / 5.0), PLANK);
                scene.rect((at.0, at.1 + tile / 5.0), (tile, tile / 10.0), PLANK.alpha(0.35));
            }
        }
    }
    edges(scene, level, tile);
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

/// The outline of the solid: exactly the sides that a body can meet.
fn edges(scene: &mut Scene, level: &Level, tile: f32) {
    let solid = |x: i32, y: i32| {
        let inside = x >= 0 && y >= 0 && x < i32::from(level.width) && y < i32::from(level.height);
        !inside || level.block(x as u16, y as u16) == Block::All
    };
    let (thin, thick) = (tile / 14.0, tile / 8.0);
    for y in 0..i32::from(level.height) {
        for x in 0..i32::from(level.width) {
            if !solid(x, y) || level.block(x as u16, y as u16) != Block::All {
                continue;
            }
            let (left, top) = (x as f32 * tile, y as f32 * tile);
            if !solid(x, y + 1) {
                scene.rect((left, top + tile - thin), (tile, thin), EDGE.alpha(0.7));
            }
            if !solid(x - 1, y) {
                scene.rect((left, top), (thin, tile), EDGE.alpha(0.7));
            }
            if !solid(x + 1, y) {
                scene.rect((left + tile - thin, top), (thin, tile), EDGE.alpha(0.7));
            }
            if !solid(x, y - 1) {
                scene.rect((left, top), (tile, thick), TOP);
            }
        }
    }
}

fn flags(scene: &mut Scene, at: Spot, t: f32, flags: u8, rules: Rules, taken: bool) {
    let middle = (at.0 + t / 2.0, at.1 + t / 2.0);
    let bottom = at.1 + t;
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
    let other = flags & !(rules.ladder | rules.kill | rules.win | rules.coin);
    if other != 0 {
        let ink = OTHER[other.trailing_zeros() as usize % OTHER.len()];
        scene.rect((at.0 + t * 0.2, at.1 + t * 0.2), (t * 0.6, t * 0.6), ink.alpha(0.6));
    }
}
