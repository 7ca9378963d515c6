//! A small anti-aliasing rasteriser: coverage from distances, straight alpha blending.

use super::ink::Ink;
use super::marks::{Image, Spot};

pub(super) struct Canvas {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<[u8; 3]>,
}

impl Canvas {
    pub(super) fn new(width: usize, height: usize, fill: Ink) -> Self {
        Self { width, height, pixels: vec![fill.rgb; width * height] }
    }

    /// Puts an image at the upper left corner.
    pub(super) fn image(&mut self, image: &Image) {
        for (row, line) in image.pixels.chunks(image.width.max(1)).enumerate().take(self.height) {
            for (x, &[r, g, b, alpha]) in line.iter().enumerate().take(self.width) {
                self.blend(x, row, Ink { rgb: [r, g, b], alpha: 1.0 }, f32::from(alpha) / 255.0);
            }
        }
    }

    pub(super) fn rect(&mut self, at: Spot, size: Spot, fill: Ink) {
        let (right, bottom) = (at.0 + size.0, at.1 + size.1);
        let along = |p: f32, lo: f32, hi: f32| (hi.min(p + 0.5) - lo.max(p - 0.5)).clamp(0.0, 1.0);
        self.cover((at, (right, bottom)), fill, |(x, y)| along(x, at.0, right) * along(y, at.1, bottom));
    }

    pub(super) fn disc(&mut self, c: Spot, radius: f32, fill: Ink) {
        let bounds = ((c.0 - radius, c.1 - radius), (c.0 + radius, c.1 + radius));
        self.cover(bounds, fill, |p| radius - distance(p, c) + 0.5);
    }

    pub(super) fn ring(&mut self, c: Spot, radius: f32, width: f32, ink: Ink) {
        let r = radius + width / 2.0;
        let bounds = ((c.0 - r, c.1 - r), (c.0 + r, c.1 + r));
        self.cover(bounds, ink, |p| width / 2.0 - (distance(p, c) - radius).abs() + 0.5);
    }

    /// A polygon that does not cross itself, in either direction.
    pub(super) fn poly(&mut self, points: &[Spot], fill: Ink) {
        let sides: Vec<(Spot, Spot)> = points.iter().copied().zip(points.iter().copied().cycle().skip(1)).collect();
        self.cover(bounds(points, 0.0), fill, |p| {
            let off = sides.iter().map(|&(a, b)| to_segment(p, a, b)).fold(f32::MAX, f32::min);
            // A point is inside if a ray to the right crosses the sides an odd number of times.
            let crossed =
                sides.iter().filter(|(a, b)| (a.1 > p.1) != (b.1 > p.1) && crossing(p.1, *a, *b) > p.0).count();
            0.5 + if crossed % 2 == 1 { off } else { -off }
        });
    }

    /// Blends the whole line once, so that its joints do not show.
    pub(super) fn line(&mut self, points: &[Spot], width: f32, ink: Ink, fade: bool) {
        let (lo, hi) = self.clip(bounds(points, width));
        let (columns, rows) = (hi.0.saturating_sub(lo.0), hi.1.saturating_sub(lo.1));
        let mut mask = vec![0.0f32; columns * rows];
        for (i, pair) in points.windows(2).enumerate() {
            let strength = if fade { (i + 1) as f32 / points.len() as f32 } else { 1.0 };
            let (from, to) = self.clip(bounds(pair, width));
            for y in from.1..to.1 {
                for x in from.0..to.0 {
                    let off = to_segment((x as f32 + 0.5, y as f32 + 0.5), pair[0], pair[1]);
                    let cover = (width / 2.0 - off + 0.5).clamp(0.0, 1.0) * strength;
                    let slot = &mut mask[(y - lo.1) * columns + x - lo.0];
                    *slot = slot.max(cover);
                }
            }
        }
        for y in lo.1..hi.1 {
            for x in lo.0..hi.0 {
                self.blend(x, y, ink, mask[(y - lo.1) * columns + x - lo.0]);
            }
        }
    }

    fn cover(&mut self, bounds: (Spot, Spot), ink: Ink, coverage: impl Fn(Spot) -> f32) {
        let (lo, hi) = self.clip(bounds);
        for y in lo.1..hi.1 {
            for x in lo.0..hi.0 {
                self.blend(x, y, ink, coverage((x as f32 + 0.5, y as f32 + 0.5)));
            }
        }
    }

    fn blend(&mut self, x: usize, y: usize, ink: Ink, coverage: f32) {
        let alpha = coverage.clamp(0.0, 1.0) * ink.alpha;
        let pixel = &mut self.pixels[y * self.width + x];
        for (below, &over) in pixel.iter_mut().zip(&ink.rgb) {
            let mixed = f32::from(*below) * (1.0 - alpha) + f32::from(over) * alpha;
            *below = (mixed + 0.5) as u8;
        }
    }

    /// The pixels that a shape with these bounds can touch, half-open.
    fn clip(&self, (min, max): (Spot, Spot)) -> ((usize, usize), (usize, usize)) {
        // Casts from floating point saturate, so negative values become 0.
        let (x0, y0) = ((min.0 - 1.0).floor() as usize, (min.1 - 1.0).floor() as usize);
        let (x1, y1) = ((max.0 + 1.0).ceil() as usize, (max.1 + 1.0).ceil() as usize);
        ((x0.min(self.width), y0.min(self.height)), (x1.min(self.width), y1.min(self.height)))
    }
}

fn bounds(points: &[Spot], margin: f32) -> (Spot, Spot) {
    let mut lo = (f32::MAX, f32::MAX);
    let mut hi = (f32::MIN, f32::MIN);
    for p in points {
        lo = (lo.0.min(p.0 - margin), lo.1.min(p.1 - margin));
        hi = (hi.0.max(p.0 + margin), hi.1.max(p.1 + margin));
    }
    (lo, hi)
}

/// The x of the line through `a` and `b` at this height. The line is not level.
fn crossing(y: f32, a: Spot, b: Spot) -> f32 {
    a.0 + (y - a.1) * (b.0 - a.0) / (b.1 - a.1)
}

fn distance(a: Spot, b: Spot) -> f32 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn to_segment(p: Spot, a: Spot, b: Spot) -> f32 {
    let (d, e) = ((b.0 - a.0, b.1 - a.1), (p.0 - a.0, p.1 - a.1));
    let square = d.0 * d.0 + d.1 * d.1;
    let t = if square > 0.0 { ((d.0 * e.0 + d.1 * e.1) / square).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, (a.0 + d.0 * t, a.1 + d.1 * t))
}
