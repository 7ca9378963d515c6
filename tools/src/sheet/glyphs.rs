//! Draws features: faces and arcs as lines with arrows along their normals, vertices as the fan of
//! normals between their edges.

use tilesat::{
    Axis,
    world::{Feature, Geometry},
};

use crate::picture::ink::{CONTACT, EDGE, Ink, PLANK, SLIDE, TOUCH};
use crate::picture::marks::{Scene, Spot};
use crate::picture::surface;

/// The position of a map in the picture, and the size of its signs.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub at: Spot,
    pub scale: f32,
    /// Length of an arrow, in pixels.
    pub arrow: f32,
    /// Whether it also shows centres of arcs and indices of pieces.
    pub details: bool,
}

impl Frame {
    fn stroke(&self) -> f32 {
        (self.arrow / 8.0).max(1.8)
    }

    pub(super) fn place(&self, p: Spot) -> Spot {
        (self.at.0 + p.0 * self.scale, self.at.1 + p.1 * self.scale)
    }
}

pub(super) const FACE: Ink = EDGE;
pub(super) const ARC: Ink = SLIDE;
pub(super) const VERTEX: Ink = TOUCH;
pub(super) const ONE_WAY: Ink = PLANK;

/// Fans first: lines cover them.
pub(super) fn draw(scene: &mut Scene, frame: &Frame, features: &[Feature]) {
    for feature in features {
        if let Geometry::Vertex { p, e_in, e_out } = feature.geometry {
            fan(scene, frame, frame.place(surface::pixel(p)), e_in, e_out);
        }
    }
    for feature in features {
        match feature.geometry {
            Geometry::Face { dir, .. } => face(scene, frame, feature, normal(dir)),
            Geometry::Arc { centre, quadrant, convex, .. } => {
                let centre = frame.place(surface::pixel(centre));
                arc(scene, frame, feature, centre, quadrant, convex);
            }
            _ => {}
        }
    }
}

fn face(scene: &mut Scene, frame: &Frame, feature: &Feature, normal: Spot) {
    let ink = if feature.one_way { ONE_WAY } else { FACE };
    for (a, b) in surface::lines(&feature.geometry) {
        let (a, b) = (frame.place(a), frame.place(b));
        scene.line(vec![a, b], frame.stroke(), ink, false);
        let tip = arrow(scene, frame, (a.0.midpoint(b.0), a.1.midpoint(b.1)), normal, ink);
        if frame.details {
            label(scene, tip, normal, feature.index);
        }
    }
}

fn arc(scene: &mut Scene, frame: &Frame, feature: &Feature, centre: Spot, quadrant: Axis, convex: bool) {
    let lines = surface::lines(&feature.geometry);
    let points: Vec<Spot> =
        lines.iter().map(|l| l.0).chain(lines.last().map(|l| l.1)).map(|p| frame.place(p)).collect();
    if frame.details {
        // The quadrant: the radii to the two ends, and a cross at the centre.
        for end in [points.first(), points.last()].into_iter().flatten() {
            dashes(scene, centre, *end, ARC.alpha(0.45));
        }
        let c = 4.0;
        scene.line(vec![(centre.0 - c, centre.1), (centre.0 + c, centre.1)], 1.5, ARC, false);
        scene.line(vec![(centre.0, centre.1 - c), (centre.0, centre.1 + c)], 1.5, ARC, false);
    }
    scene.line(points, frame.stroke(), ARC, false);
    let side = if convex { 1.0 } else { -1.0 };
    for part in [0.17f32, 0.5, 0.83] {
        let (sin, cos) = (part * std::f32::consts::FRAC_PI_2).sin_cos();
        let out = (quadrant.x as f32 * cos, quadrant.y as f32 * sin);
        let Geometry::Arc { radius, .. } = feature.geometry else { return };
        let r = radius as f32 / 65536.0 * frame.scale;
        let normal = (out.0 * side, out.1 * side);
        let tip = arrow(scene, frame, (centre.0 + out.0 * r, centre.1 + out.1 * r), normal, ARC);
        if frame.details && (0.4..0.6).contains(&part) {
            label(scene, tip, normal, feature.index);
        }
    }
}

/// All directions from the normal of the edge that ends in a vertex to that of the edge that starts
/// there.
fn fan(scene: &mut Scene, frame: &Frame, p: Spot, e_in: Axis, e_out: Axis) {
    let (from, to) = (normal(e_in), normal(e_out));
    let start = from.1.atan2(from.0);
    // With y down, the turn is to the right, by up to half a turn. It is half a turn if the two
    // edges are on one line.
    let turn = (to.1.atan2(to.0) - start).rem_euclid(std::f32::consts::TAU);
    let turn = if turn < 0.001 { std::f32::consts::PI } else { turn };
    let (steps, reach) = (12u8, frame.arrow * 0.9);
    let rim = (0..=steps).map(|i| {
        let (sin, cos) = (start + turn * f32::from(i) / f32::from(steps)).sin_cos();
        (p.0 + cos * reach, p.1 + sin * reach)
    });
    let rim: Vec<Spot> = rim.collect();
    scene.poly(&[&[p], &rim[..]].concat(), VERTEX.alpha(0.35));
    scene.line(rim, 1.2, VERTEX.alpha(0.9), false);
    scene.disc(p, frame.arrow / 6.0, VERTEX);
}

/// A line along a normal and its head. Returns the tip.
pub(super) fn arrow(scene: &mut Scene, frame: &Frame, from: Spot, normal: Spot, ink: Ink) -> Spot {
    let (length, head) = (frame.arrow, frame.arrow * 0.3);
    let along = |t: f32, side: f32| (from.0 + normal.0 * t - normal.1 * side, from.1 + normal.1 * t + normal.0 * side);
    scene.line(vec![from, along(length - head, 0.0)], (frame.arrow / 14.0).max(1.0), ink, false);
    scene.poly(&[along(length, 0.0), along(length - head, head * 0.5), along(length - head, -head * 0.5)], ink);
    along(length, 0.0)
}

/// A piece's index, beyond the tip of its arrow.
fn label(scene: &mut Scene, tip: Spot, normal: Spot, index: u16) {
    let middle = (tip.0 + normal.0 * 8.0, tip.1 + normal.1 * 8.0);
    scene.text((middle.0 - 4.0, middle.1 + 4.0), index.to_string(), CONTACT);
}

fn dashes(scene: &mut Scene, a: Spot, b: Spot, ink: Ink) {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let pieces = (dx.hypot(dy) / 8.0).max(1.0) as u16;
    for i in 0..pieces {
        let at = |t: f32| (a.0 + dx * t, a.1 + dy * t);
        let t = f32::from(i) / f32::from(pieces);
        scene.line(vec![at(t), at(t + 0.5 / f32::from(pieces))], 1.2, ink, false);
    }
}

/// The unit normal of a direction: its right hand, with the solid on its left.
fn normal(dir: Axis) -> Spot {
    let (x, y) = (dir.y as f32, -dir.x as f32);
    let length = x.hypot(y).max(f32::MIN_POSITIVE);
    (x / length, y / length)
}
