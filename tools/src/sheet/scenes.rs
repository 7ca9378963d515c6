//! Many tiles together: their common surface, the rays in it, and the way of a ball.

use tilesat::motion::Response;
use tilesat::world::{Inside, Outside};
use tilesat::{
    Aabb, AllShapes, Axis, Circle, Fx, Grid, Mover, TileKind, TileKinds, TileMap, TileShape, Toi, Vec2, world::Feature,
};

use tilesat_games::platformer::ninja;

use super::glyphs::{self, Frame};
use super::shapes;
use crate::fail::{Fail, Result};
use crate::picture::ink::{BOUNCE, COIN, CONTACT, EARTH, Ink, PLAYER, TEXT};
use crate::picture::marks::{Scene, Spot};
use crate::picture::solid;

type Map<'a> = TileMap<'a, AllShapes>;

/// Rays per fan.
const RAYS: u16 = 240;
/// The start of the mosaic's fan, in halves of a cell. The cells around it are empty.
const EYE: (u16, u16) = (23, 13);

/// 24 x 14 random tiles, nearly half of them empty.
pub(super) fn mosaic() -> Result<Scene> {
    let (width, height, tile) = (24u16, 14u16, 32u16);
    let mut kinds = TileKinds::EMPTY;
    for shape in TileShape::ALL {
        kinds = kinds.with(shape as u8, TileKind::of(shape));
    }
    let mut state = 0x2545_f491u32;
    let tiles: Vec<u8> = (0..width * height)
        .map(|cell| {
            let (x, y) = (cell % width, cell / width);
            let near = x.abs_diff(EYE.0 / 2) < 2 && y.abs_diff(EYE.1 / 2) < 2;
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let (choice, solid) = (state >> 24, state >> 16 & 0xff);
            if near || solid < 116 { 0 } else { ((choice * 37) >> 8) as u8 + 1 }
        })
        .collect();
    let map = map(&tiles, width, height, tile, &kinds, Outside::Empty)?;
    let mut scene = Scene::new(f32::from(width * tile) * 2.0, f32::from(height * tile) * 2.0, 1.0, 1.0);
    let frame = Frame { at: (0.0, 0.0), scale: 2.0, arrow: 11.0, details: false };
    let size = (i32::from(width * tile) * 2, i32::from(height * tile) * 2);
    solid::fill(&mut scene, &map, frame.at, size, 2, EARTH);
    let half = |v: u16| i32::from(v) * i32::from(tile) * 32768;
    fan(&mut scene, &frame, &map, Vec2::from_raw(half(EYE.0), half(EYE.1)))?;
    let features = surface(&map);
    glyphs::draw(&mut scene, &frame, &features);
    let what = format!("{width} x {height} random tiles: {}", tally(&features));
    caption(&mut scene, &[&what, &format!("{RAYS} rays from a point: where they end, and the normal they meet")]);
    Ok(scene)
}

/// The level of all shapes.
pub(super) fn level() -> Result<Scene> {
    let map = map(ninja::TILES, ninja::WIDTH, ninja::HEIGHT, ninja::TILE, &ninja::KINDS, Outside::Solid)?;
    let (width, height) = (i32::from(ninja::WIDTH * ninja::TILE), i32::from(ninja::HEIGHT * ninja::TILE));
    let scale = 2;
    let mut scene = Scene::new((width * scale) as f32, (height * scale) as f32, 1.0, 1.0);
    let frame = Frame { at: (0.0, 0.0), scale: scale as f32, arrow: 9.0, details: false };
    solid::fill(&mut scene, &map, frame.at, (width * scale, height * scale), scale, EARTH);
    fan(&mut scene, &frame, &map, Vec2::from_ints(410, 250))?;
    let features = surface(&map);
    glyphs::draw(&mut scene, &frame, &features);
    path(&mut scene, &frame, &map, (Vec2::from_ints(270, 120), 9, BOUNCE), Response::Bounce)?;
    path(&mut scene, &frame, &map, (Vec2::from_ints(50, 470), 11, PLAYER), Response::Slide)?;
    let what = format!("level ninja: {}", tally(&features));
    caption(&mut scene, &[&what, &format!("{RAYS} rays; a ball that bounces (green) and one that slides (yellow)")]);
    Ok(scene)
}

fn map<'a>(
    tiles: &'a [u8],
    width: u16,
    height: u16,
    tile: u16,
    kinds: &'a TileKinds,
    outside: Outside,
) -> Result<Map<'a>> {
    let grid = Grid::new(width, height, Fx::from_num(tile), Vec2::ZERO);
    let map = grid.and_then(|grid| TileMap::of(tiles, grid, kinds));
    Ok(map.map_err(|e| Fail::new(e.to_string()))?.with_outside(outside))
}

fn surface(map: &Map<'_>) -> Vec<Feature> {
    let region = Aabb::new(map.grid().origin(), map.grid().end());
    let all = region.iter().flat_map(|region| map.features(region));
    all.filter(|feature| map.tile(feature.cell).is_some()).collect()
}

fn tally(features: &[Feature]) -> String {
    let (faces, vertices, arcs) = shapes::counts(features);
    format!("{faces} faces, {vertices} vertices, {arcs} arcs")
}

/// Rays to all sides, up to their first hit.
fn fan(scene: &mut Scene, frame: &Frame, map: &Map<'_>, eye: Vec2) -> Result<()> {
    let at = frame.place(spot(eye));
    for i in 0..RAYS {
        let (sin, cos) = (f32::from(i) / f32::from(RAYS) * std::f32::consts::TAU).sin_cos();
        let length = 900.0 * 65536.0;
        let way = Vec2::from_raw((cos * length) as i32, (sin * length) as i32);
        let hit = map.cast_ray(eye, way, Inside::Hit).map_err(|e| Fail::new(e.to_string()))?;
        let end = frame.place(spot(hit.map_or(eye + way, |hit| hit.point)));
        scene.line(vec![at, end], 1.0, COIN.alpha(0.28), false);
        if let Some(hit) = hit {
            let (x, y) = (hit.axis.x as f32, hit.axis.y as f32);
            let tick = 7.0 / x.hypot(y).max(1.0);
            scene.line(vec![end, (end.0 + x * tick, end.1 + y * tick)], 1.6, COIN.alpha(0.9), false);
            scene.disc(end, 2.2, COIN);
        }
    }
    scene.disc(at, 6.0, COIN);
    Ok(())
}

/// A ball that falls for ten seconds. Draws it every fifth frame, and its hits.
fn path(
    scene: &mut Scene,
    frame: &Frame,
    map: &Map<'_>,
    (start, radius, ink): (Vec2, i32, Ink),
    response: Response,
) -> Result<()> {
    let fail = |e: &dyn std::fmt::Display| Fail::new(format!("the ball: {e}"));
    let mut ball = Circle::new(start, Fx::from_num(radius)).map_err(|e| fail(&e))?;
    let mover = Mover::platformer(Axis::NEG_Y).with_response(response);
    let mut velocity = Vec2::from_ints(3, 0);
    let mut line = vec![frame.place(spot(start))];
    for step in 0..600 {
        if step % 5 == 0 {
            scene.ring(frame.place(spot(ball.centre())), radius as f32 * frame.scale, 1.0, ink.alpha(0.3));
        }
        velocity += Vec2::from_raw(0, 12_000);
        let moved = mover.move_and_slide(map, &ball, velocity).map_err(|e| fail(&e))?;
        if let Some(hit) = moved.hits.first() {
            // The ball's position then, and its point against the normal.
            let part = hit.toi.raw() as f32 / Toi::ONE.raw() as f32;
            let (from, way) = (spot(ball.centre()), spot(velocity));
            let (x, y) = (hit.axis.x as f32, hit.axis.y as f32);
            let reach = radius as f32 / x.hypot(y).max(1.0);
            let at = (from.0 + way.0 * part - x * reach, from.1 + way.1 * part - y * reach);
            scene.disc(frame.place(at), 2.2, CONTACT.alpha(0.8));
            line.push(frame.place((from.0 + way.0 * part, from.1 + way.1 * part)));
        }
        (ball, velocity) = (moved.body, moved.velocity);
        line.push(frame.place(spot(ball.centre())));
    }
    scene.line(line, 2.0, ink, false);
    scene.ring(frame.place(spot(ball.centre())), radius as f32 * frame.scale, 2.5, ink);
    Ok(())
}

fn caption(scene: &mut Scene, lines: &[&str]) {
    let mut y = scene.level.1 + 20.0;
    for line in lines {
        scene.text((10.0, y), *line, TEXT);
        y += 18.0;
    }
    scene.size.1 = y - 4.0;
}

fn spot(p: Vec2) -> Spot {
    (p.x.to_num(), p.y.to_num())
}
