//! The surroundings of a body: a convex room, as segments and, if it fits, as tiles. Whole numbers,
//! 65536 raw per pixel, y down.

/// A pixel.
pub const PX: i32 = 1 << 16;

/// A position or a velocity, in raw units.
pub type Point = [i32; 2];

/// A ball by its radius, a box by its half extents, raw.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Ball(i32),
    Box(Point),
}

/// A body's start position and velocity.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    pub centre: Point,
    pub velocity: Point,
}

/// Rows of characters. `#` is solid, `\` and `/` have 45 degrees, `, ;` and `_ -` have 26.57
/// degrees (low and high part). The border continues outside.
#[derive(Clone, Copy, Debug)]
pub struct Tiles {
    pub rows: &'static str,
    /// The side of a cell, raw.
    pub cell: i32,
    /// The corner with the smallest coordinates.
    pub origin: Point,
}

/// The form of the walls for engines that meet them one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    Forward,
    Backward,
}

#[derive(Clone, Debug)]
pub struct Scene {
    pub name: &'static str,
    /// The corners of the convex room. A wall joins each to the next.
    pub room: Vec<Point>,
    /// The longest wall, in raw units. Longer walls are cut into equal pieces.
    pub piece: i32,
    pub order: Order,
    pub tiles: Option<Tiles>,
    pub shape: Shape,
    /// Restitution in 1/256. At 0 bodies slide.
    pub bounce: i32,
    /// Raw units per frame per frame, downward.
    pub gravity: i32,
    /// How far the scene moves the body back, once it is this far right or left, in raw units. It
    /// makes an endless floor. 0: never.
    pub period: i32,
    /// The height (y) of the centre at rest, which has energy zero, in pixels.
    pub lowest: f64,
}

impl Scene {
    /// The walls, none longer than the limits of the scene and the caller.
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

    /// Obstacles for engines without a level: segments for a ball, solid tiles for a box.
    pub fn obstacles(&self, limit: i32) -> Option<Vec<[Point; 2]>> {
        match self.shape {
            Shape::Ball(_) => Some(self.walls(limit)),
            Shape::Box(_) => self.tiles.map(|tiles| tiles.boxes(self.order)),
        }
    }

    /// The corners, and the ends of the pieces between them.
    pub fn outline(&self) -> Vec<Point> {
        let mut walls = self.walls(i32::MAX);
        if self.order == Order::Backward {
            walls.reverse();
        }
        walls.iter().map(|wall| wall[0]).collect()
    }
}

impl Tiles {
    /// The solid cells as boxes: two opposite corners each.
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
