//! Levels, bodies and arrows in a picture.

use tilesat::{Aabb, Vec2, World, world::Feature};
use tilesat_tools::picture::ink::{EARTH, EDGE, Ink, PLANK, TEXT};
use tilesat_tools::picture::marks::{Scene, Spot};
use tilesat_tools::picture::surface;

/// An empty picture of this size in pixels.
pub(crate) fn page(width: f32, height: f32) -> Scene {
    Scene::new(width, height, 1.0, 1.0)
}

/// Where a level is in the picture.
#[derive(Clone, Copy)]
pub(crate) struct View {
    /// The position of the level's origin.
    pub(crate) at: Spot,
    /// Pixels per unit.
    pub(crate) scale: f32,
}

impl View {
    pub(crate) fn spot(self, p: Vec2) -> Spot {
        self.place(surface::pixel(p))
    }

    fn place(self, (x, y): Spot) -> Spot {
        (self.at.0 + x * self.scale, self.at.1 + y * self.scale)
    }

    /// A part of a level: the solid, its surface, and one-way faces.
    pub(crate) fn level(self, scene: &mut Scene, level: &impl World, part: &Aabb) {
        let features: Vec<Feature> = level.features(part).collect();
        let of = |one_way| features.iter().filter(move |it| it.one_way == one_way);
        for border in borders(of(false).flat_map(|it| surface::lines(&it.geometry)).collect()) {
            let border: Vec<Spot> = border.into_iter().map(|p| self.place(p)).collect();
            scene.poly(&border, EARTH);
            scene.line(border, 1.5, EDGE, false);
        }
        for (a, b) in of(true).flat_map(|it| surface::lines(&it.geometry)) {
            scene.line(vec![self.place(a), self.place(b)], 4.0, PLANK, false);
        }
    }

    /// A body: filled, or only its line.
    pub(crate) fn body(self, scene: &mut Scene, body: &Aabb, ink: Ink, filled: bool) {
        let (lo, hi) = (self.spot(body.min()), self.spot(body.max()));
        if filled {
            scene.rect(lo, (hi.0 - lo.0, hi.1 - lo.1), ink);
        } else {
            scene.line(vec![lo, (hi.0, lo.1), hi, (lo.0, hi.1), lo], 1.2, ink, false);
        }
    }

    pub(crate) fn path(self, scene: &mut Scene, points: &[Vec2], ink: Ink) {
        scene.line(points.iter().map(|&p| self.spot(p)).collect(), 2.0, ink, false);
    }

    pub(crate) fn arrow(self, scene: &mut Scene, from: Vec2, way: Vec2, ink: Ink) {
        let (a, b) = (self.spot(from), self.spot(from + way));
        let (x, y) = (b.0 - a.0, b.1 - a.1);
        let long = x.hypot(y);
        let along = |t: f32, side: f32| (b.0 - (x * t + y * side) / long, b.1 - (y * t - x * side) / long);
        scene.line(vec![a, along(9.0, 0.0)], 2.0, ink, false);
        scene.poly(&[b, along(10.0, 4.5), along(10.0, -4.5)], ink);
    }
}

/// A line of text around the middle.
pub(crate) fn middle(scene: &mut Scene, (x, y): Spot, text: &str) {
    let wide = text.chars().count() as f32 * Scene::LETTER.0;
    scene.text((x - wide / 2.0, y), text, TEXT);
}

/// Joins the lines of a surface to closed borders. A point in the middle of a straight line is left
/// out.
fn borders(mut lines: Vec<(Spot, Spot)>) -> Vec<Vec<Spot>> {
    let near = |a: Spot, b: Spot| (a.0 - b.0).hypot(a.1 - b.1) < 0.01;
    let mut borders = Vec::new();
    while let Some((start, mut end)) = lines.pop() {
        let mut border = vec![start, end];
        while let Some(next) = lines.iter().position(|line| near(line.0, end)) {
            end = lines.swap_remove(next).1;
            if let [.., a, b] = border[..]
                && ((b.0 - a.0) * (end.1 - b.1) - (b.1 - a.1) * (end.0 - b.0)).abs() < 0.01
            {
                border.pop();
            }
            border.push(end);
        }
        borders.push(border);
    }
    borders
}
