//! The shapes with the suggested letters.

use std::error::Error;

use tilesat::{Aabb, AllShapes, Grid, TileKind, TileKinds, TileMap, TileShape, Vec2, fx};
use tilesat_tools::picture::ink::{COIN, FAINT, TEXT};
use tilesat_tools::picture::marks::Scene;

use super::draw::{View, middle, page};

const SHAPES: [(char, TileShape); 11] = [
    ('#', TileShape::Full),
    ('=', TileShape::OneWayUp),
    ('_', TileShape::HalfBottom),
    ('/', TileShape::SlopeBottomRight),
    ('\\', TileShape::SlopeBottomLeft),
    ('(', TileShape::ConcaveBottomLeft),
    (')', TileShape::ConcaveBottomRight),
    ('a', TileShape::MildLowBottomRight),
    ('b', TileShape::MildHighBottomRight),
    ('c', TileShape::MildHighBottomLeft),
    ('d', TileShape::MildLowBottomLeft),
];
const PANEL: (f32, f32) = (190.0, 104.0);
const COLUMNS: usize = 4;
const CHAPTER: &str = include_str!("../../tile_levels.md");

pub(crate) fn picture() -> Result<Scene, Box<dyn Error>> {
    let rows = SHAPES.len().div_ceil(COLUMNS);
    let mut scene = page(PANEL.0 * COLUMNS as f32, PANEL.1 * rows as f32);
    for (i, (letter, shape)) in SHAPES.into_iter().enumerate() {
        assert!(CHAPTER.contains(&format!("`{letter}`")), "the chapter has no letter {letter}");
        let at = ((i % COLUMNS) as f32 * PANEL.0, (i / COLUMNS) as f32 * PANEL.1);
        let view = View { at: (at.0 + (PANEL.0 - 64.0) / 2.0, at.1 + 12.0), scale: 4.0 };
        let kinds = TileKinds::EMPTY.with(1, TileKind::of(shape));
        let map = TileMap::<AllShapes>::of(&[1], Grid::new(1, 1, fx!(16), Vec2::ZERO)?, &kinds)?;
        let cell = map.bounds();
        view.body(&mut scene, &cell, FAINT.alpha(0.6), false);
        view.level(&mut scene, &map, &Aabb::new(cell.min(), cell.max())?);
        middle(&mut scene, (at.0 + PANEL.0 / 2.0, at.1 + 95.0), &format!("{shape:?}"));
        scene.text((view.at.0 - 24.0, view.at.1 + 38.0), letter.to_string(), COIN);
    }
    // The rest of the last row: the letters of a hill.
    let text = "ab#cd";
    let map_kinds =
        SHAPES.iter().fold(TileKinds::EMPTY, |kinds, &(letter, shape)| kinds.with(letter as u8, TileKind::of(shape)));
    let map = TileMap::<AllShapes>::of_ascii(text, &map_kinds)?;
    let at = (PANEL.0 * 3.0, PANEL.1 * 2.0);
    let view = View { at: (at.0 + 15.0, at.1 + 34.0), scale: 2.0 };
    view.level(&mut scene, &map, &map.bounds());
    for (i, letter) in text.chars().enumerate() {
        scene.text((view.at.0 + 11.0 + 32.0 * i as f32, at.1 + 24.0), letter.to_string(), COIN);
    }
    scene.text((at.0 + PANEL.0 / 2.0 - 58.0, at.1 + 95.0), "a level: ab#cd", TEXT);
    Ok(scene)
}
