//! Finds the shape of the library that a drawn shape resembles.

use tilesat::world::World;
use tilesat::{
    Aabb, AllShapes, Fx, Grid, TileKind, TileKinds, TileMap, TileShape, Vec2,
    world::{Feature, Geometry},
};

use super::names;
use super::place;

type Point = (f64, f64);
type Line = (Point, Point);

/// The greatest distance between a drawn shape and a shape of the library, in pixels.
const NEAR: f64 = 1.0 / 8.0;
/// Pieces per arc. Its chords are nearer than a hundredth of that.
const PIECES: u32 = 64;
/// Points to test on each line.
const PLACES: u32 = 16;

/// The shapes of the library in a cell, as lines.
#[derive(Debug)]
pub(super) struct Likeness {
    shapes: Vec<(TileShape, Vec<Line>)>,
}

impl Likeness {
    /// For cells of this side in pixels.
    pub(super) fn new(tile: u16) -> Self {
        let shapes = TileShape::ALL.into_iter().skip(1).map(|shape| (shape, outline(shape, tile)));
        Self { shapes: shapes.collect() }
    }

    /// The solid shape that this polygon resembles.
    pub(super) fn solid(&self, points: &[Point]) -> Option<TileShape> {
        let mut lines: Vec<Line> = points.windows(2).map(|pair| (pair[0], pair[1])).collect();
        lines.extend(points.last().copied().zip(points.first().copied()));
        self.find(&lines, names::is_solid)
    }

    /// The one-way edge that this chain resembles, in either direction.
    pub(super) fn one_way(&self, points: &[Point]) -> Option<TileShape> {
        let lines: Vec<Line> = points.windows(2).map(|pair| (pair[0], pair[1])).collect();
        self.find(&lines, names::is_one_way)
    }

    fn find(&self, lines: &[Line], wanted: fn(TileShape) -> bool) -> Option<TileShape> {
        let like = |(shape, outline): &&(TileShape, Vec<Line>)| {
            wanted(*shape) && covers(outline, lines) && covers(lines, outline)
        };
        self.shapes.iter().find(like).map(|(shape, _)| *shape)
    }
}

/// Whether all points on some lines are near other lines.
fn covers(outline: &[Line], lines: &[Line]) -> bool {
    let near = |p: Point| outline.iter().any(|&line| distance(p, line) <= NEAR);
    let place = |(a, b): Line, k: u32| {
        let t = f64::from(k) / f64::from(PLACES);
        (a.0 + (b.0 - a.0) * t, a.1 + (b.1 - a.1) * t)
    };
    !lines.is_empty() && lines.iter().all(|&line| (0..=PLACES).all(|k| near(place(line, k))))
}

fn distance(p: Point, (a, b): Line) -> f64 {
    let (d, e) = ((b.0 - a.0, b.1 - a.1), (p.0 - a.0, p.1 - a.1));
    let square = d.0 * d.0 + d.1 * d.1;
    let t = if square > 0.0 { ((d.0 * e.0 + d.1 * e.1) / square).clamp(0.0, 1.0) } else { 0.0 };
    (e.0 - d.0 * t).hypot(e.1 - d.1 * t)
}

/// The surface of a single tile, from the library.
pub(super) fn outline(shape: TileShape, tile: u16) -> Vec<Line> {
    let kinds = TileKinds::EMPTY.with(1, TileKind::of(shape));
    // The library has no larger cells. Their shapes are enlarged.
    let side = u32::from(tile).min(place::LARGEST);
    let grid = Grid::new(1, 1, Fx::from_num(side), Vec2::ZERO);
    let map = grid.and_then(|grid| TileMap::<AllShapes>::of(&[1], grid, &kinds));
    let whole = grid.ok().and_then(|grid| Aabb::new(grid.origin(), grid.end()).ok());
    let (Ok(map), Some(whole)) = (map, whole) else { return Vec::new() };
    let times = f64::from(tile) / f64::from(side);
    let enlarged = |(x, y): Point| (x * times, y * times);
    let lines = World::features(&map, &whole).flat_map(|feature| lines(&feature));
    lines.map(|(a, b)| (enlarged(a), enlarged(b))).collect()
}

fn lines(feature: &Feature) -> Vec<Line> {
    let pixel = |p: Vec2| (p.x.to_num::<f64>(), p.y.to_num::<f64>());
    match feature.geometry {
        Geometry::Face { a, dir, len, .. } => {
            let (x, y) = pixel(a);
            let reach = |v: i32| f64::from(v) * f64::from(len) / 65536.0;
            vec![((x, y), (x + reach(dir.x), y + reach(dir.y)))]
        }
        Geometry::Arc { centre, radius, quadrant, .. } => {
            let ((x, y), r) = (pixel(centre), f64::from(radius) / 65536.0);
            let at = |k: u32| {
                let (sin, cos) = (f64::from(k) / f64::from(PIECES) * std::f64::consts::FRAC_PI_2).sin_cos();
                (x + f64::from(quadrant.x) * cos * r, y + f64::from(quadrant.y) * sin * r)
            };
            (0..PIECES).map(|k| (at(k), at(k + 1))).collect()
        }
        _ => Vec::new(),
    }
}
