//! What a body moves in: a convex room, as segments and, where it fits, as tiles. Whole numbers,
//! 65536 raw to a pixel, y down.

/// A pixel.
pub const PX: i32 = 1 << 16;

/// A place or a velocity, raw.
pub type Point = [i32; 2];

/// A ball by its radius, a box by its half extents, raw.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Ball(i32),
    Box(Point),
}

/// Where a body begins, and how fast.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    pub centre: Point,
    pub velocity: Point,
}

/// Rows of characters: `#` solid, `\` and `/` 45 degrees, `, ;` and `_ -` 26.57 degrees (low and
/// high part); the border goes on outside.
#[derive(Clone, Copy, Debug)]
pub struct Tiles {
    pub rows: &'static str,
    /// The side of a cell, raw.
    pub cell: i32,
    /// The corner with the smallest coordinates.
    pub origin: Point,
}

/// How the walls are given to those that meet them one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    Forward,
    Backward,
}

#[derive(Clone, Debug)]
pub struct Scene {
    pub name: &'static str,
    /// The corners of the room, which is convex; walls run from each to the next.
    pub room: Vec<Point>,
    /// The longest wall, raw: longer ones are cut into equal pieces.
    pub piece: i32,
    pub order: Order,
    pub tiles: Option<Tiles>,
    pub shape: Shape,
    /// Restitution in 1/256: 0 slides.
    pub bounce: i32,
    /// Raw a frame a frame, downward.
    pub gravity: i32,
    /// The body is put back by this much when it is as far to the right or to the left, raw: a
    /// floor without end. 0: never.
    pub period: i32,
    /// The height (y) of the centre at rest, where energy is zero, in pixels.
    pub lowest: f64,
}

impl Scene {
    /// The walls, none longer than the scene's and the caller's limit.
    pub fn walls(&self, limit: i32) -> Vec<[Point; 2]> {
        let longest = self.piece.min(limit);
        let mut walls = Vec::new();
        for (i, &a) in self.room.iter().enumerate() {
            let b = self.room[(i + 1) % self.room.len()];
            let size = [b[0] - a[0], b[1] - a[1]];
            let length = f64::from(size[0]).hypot(f64::from(size[1]));
            let n = (length / f64::from(longest) - 1e-6).ceil().max(1.0) as i64;
            let at = |k: i64| [0, 1].map(|i| a[i] + (i64::from(size[i]) * k / n) as i32);
            walls.extend((0..n).map(|k| [at(k), at(k + 1)]));
        }
        if self.order == Order::Backward {
            walls.reverse();
        }
        walls
    }

    /// What engines without a level meet: segments for a ball, solid tiles for a box.
    pub fn obstacles(&self, limit: i32) -> Option<Vec<[Point; 2]>> {
        match self.shape {
            Shape::Ball(_) => Some(self.walls(limit)),
            Shape::Box(_) => self.tiles.map(|tiles| tiles.boxes(self.order)),
        }
    }

    /// The corners with those of the pieces between them.
    pub fn outline(&self) -> Vec<Point> {
        let mut walls = self.walls(i32::MAX);
        if self.order == Order::Backward {
            walls.reverse();
        }
        walls.iter().map(|wall| wall[0]).collect()
    }
}

impl Tiles {
    /// The solid cells, as boxes: corner and opposite corner.
    pub fn boxes(&self, order: Order) -> Vec<[Point; 2]> {
        let mut boxes = Vec::new();
        for (y, row) in (0..).zip(self.rows.lines()) {
            for (x, _) in (0..).zip(row.chars()).filter(|(_, c)| *c == '#') {
                let lo = [self.origin[0] + x * self.cell, self.origin[1] + y * self.cell];
                boxes.push([lo, [lo[0] + self.cell, lo[1] + self.cell]]);
            }
        }
        if order == Order::Backward {
            boxes.reverse();
        }
        boxes
    }
}
