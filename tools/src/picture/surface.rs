//! Draws the surface of a level: exactly the faces and arcs that the library reports, which a body
//! can meet.

use tilesat::{
    Axis, Vec2,
    world::{Feature, Geometry},
};

use super::ink::{EDGE, Ink, TOP};
use super::marks::{Scene, Spot};

/// Pieces per arc, each coloured by its slope.
const PIECES: u8 = 12;

pub fn draw(scene: &mut Scene, features: &[Feature], tile: f32) {
    let lines: Vec<Vec<(Spot, Spot)>> = features.iter().filter(|f| !f.one_way).map(|f| lines(&f.geometry)).collect();
    // Floors come last, on top.
    for (floor, ink, width) in [(false, EDGE.alpha(0.7), tile / 14.0), (true, TOP, tile / 8.0)] {
        for runs in lines.iter().map(|line| line.chunk_by(|&a, &b| is_floor(a) == is_floor(b))) {
            for run in runs.filter(|run| is_floor(run[0]) == floor) {
                band(scene, run, width, ink);
            }
        }
    }
}

/// A band of some width on the solid's side of a line, which is the left one.
fn band(scene: &mut Scene, run: &[(Spot, Spot)], width: f32, ink: Ink) {
    let inward = |(a, b): (Spot, Spot), p: Spot| {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let length = dx.hypot(dy).max(f32::MIN_POSITIVE);
        (p.0 - dy / length * width, p.1 + dx / length * width)
    };
    let outer = run.first().map(|line| line.0).into_iter().chain(run.iter().map(|line| line.1));
    let inner = run.iter().rev().flat_map(|&line| [inward(line, line.1), inward(line, line.0)]);
    scene.poly(&outer.chain(inner).collect::<Vec<_>>(), ink);
}

/// Steeper than one to one is a wall.
fn is_floor((a, b): (Spot, Spot)) -> bool {
    b.0 - a.0 >= (b.1 - a.1).abs() * 0.99
}

/// A face or an arc as lines with the solid on their left, in pixels.
pub fn lines(geometry: &Geometry) -> Vec<(Spot, Spot)> {
    match *geometry {
        Geometry::Face { a, dir, len, .. } => {
            let (x, y) = pixel(a);
            let reach = |v: i32| v as f32 * len as f32 / 65536.0;
            vec![((x, y), (x + reach(dir.x), y + reach(dir.y)))]
        }
        Geometry::Arc { centre, radius, quadrant, convex } => {
            let points = arc(centre, radius, quadrant, convex);
            points.windows(2).map(|pair| (pair[0], pair[1])).collect()
        }
        _ => Vec::new(),
    }
}

/// Points along an arc, with the solid on the left of the way.
pub fn arc(centre: Vec2, radius: i32, quadrant: Axis, convex: bool) -> Vec<Spot> {
    let ((x, y), r) = (pixel(centre), radius as f32 / 65536.0);
    let (sx, sy) = (quadrant.x as f32, quadrant.y as f32);
    let mut points: Vec<Spot> = (0..=PIECES)
        .map(|i| (f32::from(i) / f32::from(PIECES) * std::f32::consts::FRAC_PI_2).sin_cos())
        .map(|(sin, cos)| (x + sx * cos * r, y + sy * sin * r))
        .collect();
    // From the x axis to the y axis, the centre is on the left if the signs agree.
    if (sx * sy > 0.0) != convex {
        points.reverse();
    }
    points
}

pub fn pixel(p: Vec2) -> Spot {
    (p.x.to_num(), p.y.to_num())
}
