//! The picture of a baked level, put together.

use tilesat::{AllShapes, Grid, Inside, Joined, RangeError, RayHit, SegmentMap, TileMap};

use super::picture;
use super::report::Owner;
use crate::picture::marks::Scene;

pub(crate) fn scene(
    tiles: Option<(TileMap<'_, AllShapes>, Grid)>,
    segments: Option<SegmentMap<'_>>,
    lines: &[String],
) -> Scene {
    let grids: Vec<Grid> = tiles.iter().map(|(_, grid)| *grid).chain(segments.iter().map(SegmentMap::grid)).collect();
    let (mut scene, origin) = picture::scene(&grids);
    if let Some((map, grid)) = &tiles {
        picture::cells(&mut scene, map, *grid, Owner::Tile);
    }
    if let Some(map) = &segments {
        picture::cells(&mut scene, map, map.grid(), Owner::Square);
    }
    let point = |hit: Result<Option<RayHit>, RangeError>| hit.ok().flatten().map(|hit| hit.point);
    match (&tiles, &segments) {
        (Some((a, grid)), Some(b)) => {
            let both = Joined::new(a, b);
            picture::faces(&mut scene, &both, &grids);
            picture::rays(&mut scene, &both, *grid, |from, motion| point(both.cast_ray(from, motion, Inside::Hit)));
        }
        (Some((map, grid)), None) => {
            picture::faces(&mut scene, map, &grids);
            picture::rays(&mut scene, map, *grid, |from, motion| point(map.cast_ray(from, motion, Inside::Hit)));
        }
        (None, Some(map)) => {
            picture::faces(&mut scene, map, &grids);
            picture::rays(&mut scene, map, map.grid(), |from, motion| point(map.cast_ray(from, motion, Inside::Hit)));
        }
        (None, None) => {}
    }
    picture::finish(&mut scene, origin, lines);
    scene
}
