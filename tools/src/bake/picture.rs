//! The parts of a baked level's picture: cells, faces with their normals, vertices, and a fan of
//! rays.
#![allow(clippy::cast_precision_loss, reason = "drawing only; nothing here flows back into the level")]

use tilesat::world::World;
use tilesat::{
    Aabb, Fx, Grid, Vec2,
    world::{Feature, Geometry},
};

use super::report::{self, Class, Owner};
use crate::picture::ink::{COIN, CONTACT, EARTH, EDGE, FAINT, Ink, NIGHT, PLANK, SLIDE, TEXT, TOP};
use crate::picture::marks::{Scene, Spot};
use crate::picture::surface;

/// The greatest side of a picture, in output pixels.
const AIM: f32 = 1600.0;
const RAYS: u32 = 96;
/// The side of a picture without cells, in level pixels.
const BLANK: f32 = 64.0;
/// Squares along a boundary cell's side that shade the solid. Fewer if there are many cells.
const FINE: i32 = 16;

/// An empty picture of the levels on these grids, and the level's corner at which it begins.
pub(crate) fn scene(grids: &[Grid]) -> (Scene, Spot) {
    let corner = |p: Vec2| surface::pixel(p);
    let (mut lo, mut hi) = ((f32::MAX, f32::MAX), (f32::MIN, f32::MIN));
    for grid in grids {
        let (min, max) = (corner(grid.origin()), corner(grid.end()));
        lo = (lo.0.min(min.0), lo.1.min(min.1));
        hi = (hi.0.max(max.0), hi.1.max(max.1));
    }
    if grids.is_empty() {
        // A level without a solid.
        (lo, hi) = ((0.0, 0.0), (BLANK, BLANK));
    }
    let (width, height) = (hi.0 - lo.0, hi.1 - lo.1);
    let fits = |scale: &&f32| width.max(height) * **scale <= AIM;
    let scale = [8.0, 6.0, 4.0, 3.0, 2.0, 1.0, 0.5].iter().find(fits).copied().unwrap_or(0.25);
    let mut scene = Scene::new(width, height, scale, 1.0 / scale);
    scene.rect(lo, (width, height), NIGHT);
    (scene, lo)
}

/// The cells of a level and their grid. Solid parts are shaded.
pub(crate) fn cells<W: World>(scene: &mut Scene, world: &W, grid: Grid, owner: Owner) {
    let side = grid.cell().to_num::<f32>();
    let count = usize::from(grid.width()) * usize::from(grid.height());
    let fine = if count > 4096 { 4 } else { FINE };
    for (cell, square) in report::cells(grid) {
        let at = surface::pixel(square.min());
        let own = report::own(world, cell, &square, owner).len();
        match report::class(world, &square, own) {
            Class::Empty => {}
            Class::Interior => scene.rect(at, (side, side), EARTH),
            Class::Boundary => {
                scene.rect(at, (side, side), EDGE.alpha(0.12));
                shade(scene, world, &square, fine);
            }
        }
    }
    lattice(scene, grid);
}

/// The solid of a cell, as rows of squares whose middle is solid.
fn shade<W: World>(scene: &mut Scene, world: &W, square: &Aabb, fine: i32) {
    let ((x, y), (right, _)) = (square.min().raw(), square.max().raw());
    let step = (right - x) / fine;
    let solid = |column: i32, row: i32| {
        let middle = Vec2::from_raw(x + step * column + step / 2, y + step * row + step / 2);
        Aabb::new(middle, middle).is_ok_and(|point| world.overlaps_aabb(&point))
    };
    let pixels = |raw: i32| Fx::from_bits(raw).to_num::<f32>();
    for row in 0..fine {
        let mut column = 0;
        while column < fine {
            let run = (column..fine).take_while(|&c| solid(c, row)).count() as i32;
            if run > 0 {
                let at = surface::pixel(Vec2::from_raw(x + step * column, y + step * row));
                scene.rect(at, (pixels(step * run), pixels(step)), EARTH);
            }
            column += run + 1;
        }
    }
}

fn lattice(scene: &mut Scene, grid: Grid) {
    let ((left, top), (right, bottom)) = (surface::pixel(grid.origin()), surface::pixel(grid.end()));
    let side = grid.cell().to_num::<f32>();
    let (ink, width) = (FAINT.alpha(0.3), scene.unit);
    for column in 0..=grid.width() {
        let x = left + side * f32::from(column);
        scene.line(vec![(x, top), (x, bottom)], width, ink, false);
    }
    for row in 0..=grid.height() {
        let y = top + side * f32::from(row);
        scene.line(vec![(left, y), (right, y)], width, ink, false);
    }
}

/// The faces with their normals, and the vertices, on these grids.
pub(crate) fn faces<W: World>(scene: &mut Scene, world: &W, grids: &[Grid]) {
    let unit = scene.unit;
    let wholes = grids.iter().filter_map(|grid| Aabb::new(grid.origin(), grid.end()).ok());
    let features: Vec<Feature> = match wholes.reduce(|a, b| a.union(&b)) {
        Some(whole) => world.features(&whole).collect(),
        None => Vec::new(),
    };
    for feature in &features {
        let ink = if feature.one_way { PLANK } else { TOP };
        let lines = surface::lines(&feature.geometry);
        for (i, &(a, b)) in lines.iter().enumerate() {
            scene.line(vec![a, b], 2.5 * unit, ink, false);
            if i == lines.len() / 2 {
                normal(scene, a, b, ink);
            }
        }
    }
    for feature in &features {
        if let Geometry::Vertex { p, .. } = feature.geometry {
            scene.disc(surface::pixel(p), 3.0 * unit, COIN);
        }
    }
}

/// A tick in front of the middle of a face.
fn normal(scene: &mut Scene, a: Spot, b: Spot, ink: Ink) {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let reach = 9.0 * scene.unit / dx.hypot(dy).max(f32::MIN_POSITIVE);
    let middle = (a.0.midpoint(b.0), a.1.midpoint(b.1));
    let tip = (middle.0 + dy * reach, middle.1 - dx * reach);
    scene.line(vec![middle, tip], 1.5 * scene.unit, ink.alpha(0.8), false);
}

/// Rays in all directions from a free point near the middle of a grid. `cast` gets a start and a
/// motion.
pub(crate) fn rays<W: World>(scene: &mut Scene, world: &W, grid: Grid, cast: impl Fn(Vec2, Vec2) -> Option<Vec2>) {
    let ((x0, y0), (x1, y1)) = (grid.origin().raw(), grid.end().raw());
    let side = grid.cell().to_bits();
    let middle = Vec2::from_raw(x0.midpoint(x1), y0.midpoint(y1));
    let far = |p: Vec2| (p - middle).length_squared();
    // The most open free cell: nothing touches a square of three cells around it, or else of one.
    let free = |around: i32| {
        let places = report::cells(grid).filter_map(move |(_, square)| {
            let ((x, y), wide) = (square.min().raw(), side / 2 * around);
            let at = Vec2::from_raw(x + side / 2, y + side / 2);
            let room = Aabb::from_centre(at, Vec2::from_raw(wide, wide)).ok()?;
            (!world.touches_aabb(&room)).then_some(at)
        });
        places.min_by_key(|&at| far(at))
    };
    let Some(start) = free(3).or_else(|| free(1)) else { return };
    let unit = scene.unit;
    let (x, y) = start.raw();
    // How many steps fit the way to the border.
    let room = |at: i32, lo: i32, hi: i32, step: f64| match step {
        s if s > 0.0 => f64::from(hi - at) / s,
        s if s < 0.0 => f64::from(lo - at) / s,
        _ => f64::MAX,
    };
    for k in 0..RAYS {
        let (sin, cos) = (f64::from(k) / f64::from(RAYS) * std::f64::consts::TAU).sin_cos();
        let reach = room(x, x0, x1, cos).min(room(y, y0, y1, sin));
        let end = Vec2::from_raw((f64::from(x) + cos * reach) as i32, (f64::from(y) + sin * reach) as i32);
        let met = cast(start, end - start);
        scene.line(vec![surface::pixel(start), surface::pixel(met.unwrap_or(end))], unit, SLIDE.alpha(0.45), false);
        if let Some(met) = met {
            scene.disc(surface::pixel(met), 2.5 * unit, CONTACT);
        }
    }
    scene.disc(surface::pixel(start), 4.0 * unit, SLIDE);
}

/// Moves the level into the picture and adds lines of text below it.
pub(crate) fn finish(scene: &mut Scene, origin: Spot, lines: &[String]) {
    scene.shift(0, (-origin.0, -origin.1));
    let unit = scene.unit;
    let mut pen = (10.0 * unit, scene.level.1 + 4.0 * unit);
    for line in lines {
        pen.1 += 18.0 * unit;
        // The letters are ASCII. Others show as '?'.
        let plain = |c: char| if c.is_ascii_graphic() || c == ' ' { c } else { '?' };
        scene.text(pen, line.chars().map(plain).collect::<String>(), TEXT);
    }
    scene.size.1 = pen.1 + 10.0 * unit;
}
