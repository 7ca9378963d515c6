//! All shapes, each in a map of one tile.

use tilesat::{
    Aabb, AllShapes, Fx, Grid, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2,
    world::{Feature, Geometry},
};

use super::glyphs::{self, Frame};
use crate::fail::{Fail, Result};
use crate::picture::ink::{CONTACT, EARTH, FAINT, Ink, TEXT};
use crate::picture::marks::Scene;
use crate::picture::solid;
use crate::rules::names;

/// Side of a tile in units, which are pixels here.
const TILE: u16 = 96;
const PANEL: (f32, f32) = (240.0, 214.0);
const COLUMNS: usize = 8;

pub(super) fn sheet() -> Result<Scene> {
    let rows = TileShape::ALL.len().div_ceil(COLUMNS);
    let (width, height) = (PANEL.0 * COLUMNS as f32, PANEL.1 * rows as f32 + 20.0);
    let mut scene = Scene::new(width, height, 1.0, 1.0);
    for (i, &shape) in TileShape::ALL.iter().enumerate() {
        let corner = ((i % COLUMNS) as f32 * PANEL.0, (i / COLUMNS) as f32 * PANEL.1);
        panel(&mut scene, corner, shape).map_err(|e| Fail::new(format!("{shape:?}: {e}")))?;
    }
    legend(&mut scene, (PANEL.0 * 6.0 + 16.0, PANEL.1 * (rows as f32 - 1.0) + 34.0));
    Ok(scene)
}

fn panel(scene: &mut Scene, corner: (f32, f32), shape: TileShape) -> std::result::Result<(), TileMapError> {
    let kinds = TileKinds::EMPTY.with(1, TileKind::of(shape));
    let grid = Grid::new(1, 1, Fx::from_num(TILE), Vec2::ZERO)?;
    let map = TileMap::<AllShapes>::of(&[1], grid, &kinds)?;
    let side = f32::from(TILE);
    let at = ((corner.0 + (PANEL.0 - side) / 2.0).round(), corner.1 + 46.0);
    let frame = Frame { at, scale: 1.0, arrow: 22.0, details: true };
    // The cell, then its solid.
    let square = vec![at, (at.0 + side, at.1), (at.0 + side, at.1 + side), (at.0, at.1 + side), at];
    scene.line(square, 1.0, FAINT.alpha(0.5), false);
    solid::fill(scene, &map, at, (i32::from(TILE), i32::from(TILE)), 1, EARTH);
    let region = Aabb::new(grid.origin(), grid.end());
    let features: Vec<Feature> = region.iter().flat_map(|region| map.features(region)).collect();
    glyphs::draw(scene, &frame, &features);
    let title = format!("{} {}", shape as u8, names::name(shape));
    let middle = |text: &str| corner.0 + (PANEL.0 - text.len() as f32 * Scene::LETTER.0) / 2.0;
    scene.text((middle(&title), at.1 + side + 50.0), title.clone(), TEXT);
    Ok(())
}

fn legend(scene: &mut Scene, mut pen: (f32, f32)) {
    let lines: [(&str, Ink); 8] = [
        ("face, its outward normal, index", glyphs::FACE),
        ("arc, three of its normals;", glyphs::ARC),
        ("  its centre and end radii dashed", glyphs::ARC),
        ("vertex, the normals it can have", glyphs::VERTEX),
        ("face of a one-way tile", glyphs::ONE_WAY),
        ("solid, from overlaps at points", EARTH),
        ("0-3 sides, 8 slope, arc, inner face", CONTACT),
        ("tile ids 0-33 as in N++", TEXT),
    ];
    for (text, ink) in lines {
        let shown = if ink == EARTH { FAINT } else { ink };
        if ink != CONTACT && ink != TEXT && !text.starts_with(' ') {
            scene.disc((pen.0 + 5.0, pen.1 - 5.0), 5.0, ink);
        }
        scene.text((pen.0 + 18.0, pen.1), text, shown);
        pen.1 += 21.0;
    }
}

/// Faces, vertices and arcs of some features.
pub(super) fn counts(features: &[Feature]) -> (usize, usize, usize) {
    let faces = features.iter().filter(|f| matches!(f.geometry, Geometry::Face { .. })).count();
    let vertices = features.iter().filter(|f| matches!(f.geometry, Geometry::Vertex { .. })).count();
    (faces, vertices, features.len() - faces - vertices)
}
