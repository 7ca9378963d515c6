//! The marks of a picture, in level pixels with y down. The back ends only scale them.

use super::ink::Ink;

/// A point in level pixels.
pub type Spot = (f32, f32);

/// One item of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    Rect {
        at: Spot,
        size: Spot,
        fill: Ink,
    },
    Disc {
        centre: Spot,
        radius: f32,
        fill: Ink,
    },
    Ring {
        centre: Spot,
        radius: f32,
        width: f32,
        ink: Ink,
    },
    /// A polygon that does not cross itself.
    Poly {
        points: Vec<Spot>,
        fill: Ink,
    },
    /// A line through the points. With fading, it goes from nothing at the first point to full at
    /// the last.
    Line {
        points: Vec<Spot>,
        width: f32,
        ink: Ink,
        fade: bool,
    },
    /// Starts at `at`, the left end of its baseline. Its cells are `Scene::LETTER` output pixels.
    Text {
        at: Spot,
        text: String,
        ink: Ink,
    },
}

/// A picture before it becomes a file.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Size of the level, and of the whole picture with its footer.
    pub level: Spot,
    pub size: Spot,
    /// Output pixels per level pixel.
    pub scale: f32,
    /// A sixteenth of a tile: the unit of line widths.
    pub unit: f32,
    pub marks: Vec<Mark>,
    /// An image below all marks, at output resolution. Only a PNG has it.
    pub backdrop: Option<Image>,
}

/// Colours with their opacity, row by row.
#[derive(Debug, Clone, Default)]
pub struct Image {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<[u8; 4]>,
}

impl Scene {
    /// Width and height of a letter in output pixels.
    pub const LETTER: Spot = (9.0, 15.0);

    /// An empty picture of a level of this size, without a footer.
    pub fn new(width: f32, height: f32, scale: f32, unit: f32) -> Self {
        Self { level: (width, height), size: (width, height), scale, unit, marks: Vec::new(), backdrop: None }
    }

    /// Moves the marks from this one on.
    pub fn shift(&mut self, first: usize, by: Spot) {
        let shifted = |p: &mut Spot| *p = (p.0 + by.0, p.1 + by.1);
        for mark in self.marks.iter_mut().skip(first) {
            match mark {
                Mark::Rect { at, .. } | Mark::Text { at, .. } => shifted(at),
                Mark::Disc { centre, .. } | Mark::Ring { centre, .. } => shifted(centre),
                Mark::Poly { points, .. } | Mark::Line { points, .. } => points.iter_mut().for_each(shifted),
            }
        }
    }

    /// Adds a filled box.
    pub fn rect(&mut self, at: Spot, size: Spot, fill: Ink) {
        self.marks.push(Mark::Rect { at, size, fill });
    }

    /// Adds a filled circle.
    pub fn disc(&mut self, centre: Spot, radius: f32, fill: Ink) {
        self.marks.push(Mark::Disc { centre, radius, fill });
    }

    /// Adds a circle's line.
    pub fn ring(&mut self, centre: Spot, radius: f32, width: f32, ink: Ink) {
        self.marks.push(Mark::Ring { centre, radius, width, ink });
    }

    /// Adds a filled polygon.
    pub fn poly(&mut self, points: &[Spot], fill: Ink) {
        self.marks.push(Mark::Poly { points: points.to_vec(), fill });
    }

    /// Adds a line through points.
    pub fn line(&mut self, points: Vec<Spot>, width: f32, ink: Ink, fade: bool) {
        self.marks.push(Mark::Line { points, width, ink, fade });
    }

    /// Adds a line of text.
    pub fn text(&mut self, at: Spot, text: impl Into<String>, ink: Ink) {
        self.marks.push(Mark::Text { at, text: text.into(), ink });
    }
}
