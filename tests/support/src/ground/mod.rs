//! Ground as a line of heights: its tiles and its polygon, and the way of a body that never leaves
//! it.
//!
//! The judge shares no code with the library: a body's height over the ground is the extreme of the
//! heights under it, in floating point with errors below a thousandth of a raw unit.

#![allow(clippy::cast_precision_loss, clippy::float_cmp, reason = "tests stop at the first surprise")]

pub mod way;

use crate::shapes::level::Level;
use tilesat::world::World;
use tilesat::{
    Aabb, AllShapes, Body, Circle, Fx, MoveError, Outside, Path, PathKind, SegmentMap, TileMap, Vec2, Walked, Walker,
    motion::Support,
};

pub type P = (i64, i64);
pub const PX: i64 = 1 << 16;
pub const CELL: i64 = 16 * PX;

/// A ground, left to right, y down. Nothing is beyond its ends.
#[derive(Clone, Debug)]
pub struct Ground {
    pub points: Vec<P>,
    rows: Vec<Vec<u8>>,
}

/// Width and rise in halves of cells, tiles by rows above the start.
type Column = (i64, i64, &'static [(i64, u8)]);

/// `_` level, `/` `\` 45 degrees, `m` `w` mild (two cells wide), `s` `z` steep (two cells high).
fn pieces(c: char) -> &'static [Column] {
    match c {
        '_' => &[(2, 0, &[])],
        '/' => &[(2, 2, &[(0, 8)])],
        '\\' => &[(2, -2, &[(-1, 9)])],
        'm' => &[(2, 1, &[(0, 20)]), (2, 1, &[(0, 24)])],
        'w' => &[(2, -1, &[(-1, 25)]), (2, -1, &[(-1, 21)])],
        's' => &[(2, 4, &[(0, 32), (1, 28)])],
        'z' => &[(2, -4, &[(-1, 29), (-2, 33)])],
        _ => panic!("no piece {c}"),
    }
}

impl Ground {
    /// From a picture, with `high` cells of rock under its start and `sky` above.
    pub fn of(picture: &str, high: i64, sky: i64) -> Self {
        let columns: Vec<_> = picture.chars().flat_map(|c| pieces(c).iter()).collect();
        let height = high + sky;
        let mut rows = vec![vec![0u8; columns.len()]; height as usize];
        let half = CELL / 2;
        let mut h = high * 2;
        let top = |h: i64| height * CELL - h * half;
        let mut points = vec![(0, top(h))];
        for (x, (_, rise, tiles)) in columns.iter().enumerate() {
            let base = h.div_euclid(2);
            // A falling slope has its tiles below its start. One of a half begins in its own cell.
            let base = if *rise == -1 && h % 2 != 0 { base + 1 } else { base };
            let lowest = tiles.iter().map(|t| base + t.0).min().unwrap_or(base);
            for y in 0..lowest {
                rows[(height - 1 - y) as usize][x] = 1;
            }
            for (dy, id) in *tiles {
                rows[(height - 1 - base - dy) as usize][x] = *id;
            }
            h += rise;
            points.push(((x as i64 + 1) * CELL, top(h)));
        }
        Self { points, rows }
    }

    /// The ground of the same picture from right to left.
    pub fn mirrored(picture: &str, high: i64, sky: i64) -> Self {
        let other: String = picture
            .chars()
            .rev()
            .map(|c| match c {
                '/' => '\\',
                '\\' => '/',
                'm' => 'w',
                'w' => 'm',
                's' => 'z',
                'z' => 's',
                c => c,
            })
            .collect();
        Self::of(&other, high, sky)
    }

    /// Any corners, for polygons only.
    pub fn corners(points: &[P]) -> Self {
        Self { points: points.to_vec(), rows: Vec::new() }
    }

    /// Another tile than the picture's.
    pub fn put(&mut self, x: usize, y: usize, id: u8) {
        self.rows[y][x] = id;
    }

    pub fn end(&self) -> i64 {
        self.points[self.points.len() - 1].0
    }

    pub fn level(&self) -> Level {
        let (width, height) = (self.rows[0].len() as i64, self.rows.len() as i64);
        Level { tiles: self.rows.concat(), width, height, cell: CELL, x: 0, y: 0, outside: Outside::Empty }
    }

    /// The polygon from the ground down.
    pub fn with_polygon<T>(&self, then: impl FnOnce(&SegmentMap<'_>) -> T) -> T {
        let deep = self.points.iter().map(|p| p.1).max().unwrap() + 4 * CELL;
        let corners = self.points.iter().copied().chain([(self.end(), deep), (self.points[0].0, deep)]);
        let corners: Vec<Vec2> = corners.map(vec2).collect();
        let paths = [Path::new(PathKind::Solid, &corners)];
        let cell = Fx::from_bits(CELL as i32);
        let mut bytes = vec![0; SegmentMap::measure(&paths, cell).unwrap().bytes()];
        SegmentMap::build_into(&paths, cell, &mut bytes).unwrap();
        then(&SegmentMap::from_bytes(&bytes).unwrap())
    }
}

pub fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}

pub fn point(v: Vec2) -> P {
    (v.raw().0.into(), v.raw().1.into())
}

pub fn fx(raw: i64) -> Fx {
    Fx::from_bits(i32::try_from(raw).unwrap())
}

/// A body by its middle: half width and half height, or a radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Rect(i64, i64),
    Disc(i64),
}

#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub at: P,
    pub v: P,
    pub floor: Option<Support>,
    pub stepped: i64,
    pub snapped: i64,
    pub hit_wall: bool,
    pub hit_ceiling: bool,
    pub work: u32,
}

fn frame<B: Body>(w: &Walked<B>, at: Vec2) -> Frame {
    Frame {
        at: point(at),
        v: point(w.moved.velocity),
        floor: w.floor,
        stepped: w.stepped.to_bits().into(),
        snapped: w.snapped.to_bits().into(),
        hit_wall: w.moved.wall,
        hit_ceiling: w.moved.ceiling,
        work: w.moved.work.iterations,
    }
}

impl Shape {
    pub fn step<W: World>(
        self,
        walker: &Walker,
        world: &W,
        at: P,
        v: P,
        floor: Option<Support>,
    ) -> Result<Frame, MoveError> {
        match self {
            Self::Rect(w, h) => {
                let body = Aabb::new(vec2((at.0 - w, at.1 - h)), vec2((at.0 + w, at.1 + h))).unwrap();
                let out = walker.walk(world, &body, vec2(v), floor)?;
                Ok(frame(&out, out.moved.body.centre()))
            }
            Self::Disc(r) => {
                let body = Circle::new(vec2(at), fx(r)).unwrap();
                let out = walker.walk(world, &body, vec2(v), floor)?;
                Ok(frame(&out, out.moved.body.centre()))
            }
        }
    }

    /// Half the height.
    pub fn half(self) -> i64 {
        match self {
            Self::Rect(_, h) => h,
            Self::Disc(r) => r,
        }
    }
}

/// The level as it is, for what takes a map.
pub fn tiles(level: &Level) -> TileMap<'_, AllShapes> {
    level.all()
}
