//! Assembles the picture of a baked level.

use tilesat::{AllShapes, Grid, Inside, Joined, RangeError, RayHit, SegmentMap, TileMap};

use super::report::Owner;
use super::{Baked, picture};
use crate::fail::Result;
use crate::picture::ink::{EARTH, KILL, NIGHT};
use crate::picture::marks::{Image, Mark, Scene, Spot};

/// The image of the drawn level, for a picture with this origin.
pub(crate) type Drawn<'a> = dyn Fn(&Scene, Spot) -> Option<Image> + 'a;

impl Baked {
    /// Draws cells, segments with their normals, and vertices over an image of the drawn level.
    /// Without an image it draws rays as well. Lines of text are below.
    ///
    /// # Errors
    ///
    /// As [`map`](Self::map).
    pub fn picture(&self, lines: &[String], drawn: &dyn Fn(&Scene, Spot) -> Option<Image>) -> Result<Scene> {
        Ok(scene(self.map()?, self.segments()?, lines, drawn))
    }
}

fn scene(
    tiles: Option<(TileMap<'_, AllShapes>, Grid)>,
    segments: Option<SegmentMap<'_>>,
    lines: &[String],
    drawn: &Drawn<'_>,
) -> Scene {
    let grids: Vec<Grid> = tiles.iter().map(|(_, grid)| *grid).chain(segments.iter().map(SegmentMap::grid)).collect();
    let (mut scene, origin) = picture::scene(&grids);
    if let Some((map, grid)) = &tiles {
        picture::cells(&mut scene, map, *grid, Owner::Tile);
    }
    if let Some(map) = &segments {
        picture::cells(&mut scene, map, map.grid(), Owner::Square);
    }
    scene.backdrop = drawn(&scene, origin);
    let plain = scene.backdrop.is_some();
    if plain {
        let_through(&mut scene);
    }
    let point = |hit: std::result::Result<Option<RayHit>, RangeError>| hit.ok().flatten().map(|hit| hit.point);
    match (&tiles, &segments) {
        (Some((a, grid)), Some(b)) => {
            let both = Joined::new(a, b);
            picture::faces(&mut scene, &both, &grids);
            if !plain {
                picture::rays(&mut scene, &both, *grid, |from, motion| point(both.cast_ray(from, motion, Inside::Hit)));
            }
        }
        (Some((map, grid)), None) => {
            picture::faces(&mut scene, map, &grids);
            if !plain {
                picture::rays(&mut scene, map, *grid, |from, motion| point(map.cast_ray(from, motion, Inside::Hit)));
            }
        }
        (None, Some(map)) => {
            picture::faces(&mut scene, map, &grids);
            if !plain {
                picture::rays(&mut scene, map, map.grid(), |from, motion| {
                    point(map.cast_ray(from, motion, Inside::Hit))
                });
            }
        }
        (None, None) => {}
    }
    picture::finish(&mut scene, origin, lines);
    scene
}

/// The drawing shows through the solid.
fn let_through(scene: &mut Scene) {
    for mark in &mut scene.marks {
        if let Mark::Rect { fill, .. } = mark {
            *fill = match *fill {
                NIGHT => NIGHT.alpha(0.0),
                EARTH => KILL.alpha(0.45),
                other => other,
            };
        }
    }
}
