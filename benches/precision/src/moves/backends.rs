//! The backends that move bodies through tiles.

use super::classes::{Case, FRAMES};
use super::engines;
use super::room::{Body, FINE_PIXEL, Room};
use super::truth::Answer;
use crate::job::{Format, List};
use crate::peers::ours;
use crate::peers::textbook::{Named, Shape as Book, vector};
use tilesat::world::World;
use tilesat::{Axis, Mover, Vec2};
use tilesat_judge::oracle::figure::Kind;
use tilesat_judge::shapes::level::{Level, shape};
use tilesat_judge::shapes::region::Region;
use tilesat_textbook::shape::{Aabb, Circle, Vector};
use tilesat_textbook::tile::Body as Pushed;
use tilesat_textbook::tile_set::{DISC, EMPTY, FULL, HOLLOW, POLYGON, RawTile, tile};
use tilesat_textbook::{Q16, walk};

pub fn all(room: &Room, kind: Kind) -> List<Case, Answer> {
    let mut list = List(Vec::new());
    // A level is static data, as in flash.
    let level: &'static Level = Box::leak(Box::new(room.level.clone()));
    match (level.blocks(), kind) {
        (Some(map), Kind::Circle) => library::<tilesat::Circle>(&mut list, map),
        (Some(map), _) => library::<tilesat::Aabb>(&mut list, map),
        (None, Kind::Circle) => library::<tilesat::Circle>(&mut list, level.all()),
        (None, _) => library::<tilesat::Aabb>(&mut list, level.all()),
    }
    textbook::<Q16>(&mut list, level, kind);
    textbook::<f32>(&mut list, level, kind);
    textbook::<f64>(&mut list, level, kind);
    engines::rapier(&mut list, level);
    if kind == Kind::Circle {
        engines::box2d(&mut list, level);
    }
    list
}

/// A length in pixels, in the backend's own type.
pub fn fine(px: f64) -> i64 {
    (px * FINE_PIXEL as f64).round() as i64
}

/// The exact body that a backend's numbers mean.
trait Exact {
    fn exact(&self) -> Body;
}

impl Exact for tilesat::Circle {
    fn exact(&self) -> Body {
        let c = self.centre();
        Body::Circle { c: (fine(ours::px(c.x)), fine(ours::px(c.y))), r: fine(ours::px(self.radius())) }
    }
}

impl Exact for tilesat::Aabb {
    fn exact(&self) -> Body {
        let point = |p: Vec2| (fine(ours::px(p.x)), fine(ours::px(p.y)));
        Body::Box { lo: point(self.min()), hi: point(self.max()) }
    }
}

impl<S: Named> Exact for Circle<S> {
    fn exact(&self) -> Body {
        Body::Circle { c: (fine(self.c.x.px()), fine(self.c.y.px())), r: fine(self.r.px()) }
    }
}

impl<S: Named> Exact for Aabb<S> {
    fn exact(&self) -> Body {
        // Boxes are judged at even positions: the nearest one if a format is finer.
        let even = |v: S| 2 * fine(v.px() / 2.0);
        let point = |p: Vector<S>| (even(p.x), even(p.y));
        Body::Box { lo: point(self.lo), hi: point(self.hi) }
    }
}

const MOVER: Mover = Mover::platformer(Axis::NEG_Y);

fn library<B: ours::Shape + tilesat::Body + Exact>(list: &mut List<Case, Answer>, world: impl World + Copy + 'static) {
    list.add(
        (ours::NAME, "move", Format::RAW),
        |c: &Case| (B::of(&c.start), c.motions.map(ours::vec2)),
        move |(body, motions)| {
            let mut body = *body;
            motions.map(|v| {
                if let Ok(moved) = MOVER.move_and_slide(&world, &body, v) {
                    body = moved.body;
                }
                body
            })
        },
        |ends: &[B; FRAMES]| ends.map(|b| b.exact()),
    );
}

/// The tiles by their ids, in a cell of this many pixels.
pub fn tiles(cell: i64) -> [RawTile; 34] {
    let half = |p: (i128, i128)| (p.0 as i64 * (cell << 15), p.1 as i64 * (cell << 15));
    std::array::from_fn(|id| match shape(id as u8).0 {
        None => raw(EMPTY, 0, &[]),
        Some(_) if id == 1 => raw(FULL, 0, &[]),
        Some(Region::Polygon(points)) => {
            let count = points.len();
            let place = |i: usize| half(points[i % count]);
            let normal = |i: usize| {
                let (a, b, inner) = (place(i), place(i + 1), place(i + 2));
                let (x, y) = ((b.1 - a.1) as f64, (a.0 - b.0) as f64);
                let side = (x * (inner.0 - a.0) as f64 + y * (inner.1 - a.1) as f64).signum();
                let unit = |v: f64| (-side * v / x.hypot(y) * 65536.0).round() as i64;
                (unit(x), unit(y))
            };
            let corners = (0..5).map(place);
            raw(POLYGON, count, &corners.chain((0..5).map(normal)).collect::<Vec<_>>())
        }
        Some(Region::Arc { centre, far, outside }) => {
            let toward = (((far.0 - centre.0) as i64) << 15, ((far.1 - centre.1) as i64) << 15);
            raw(if outside { HOLLOW } else { DISC }, 0, &[half(centre), toward])
        }
    })
}

fn raw(kind: i32, corners: usize, vectors: &[(i64, i64)]) -> RawTile {
    let mut raw = [0; 22];
    (raw[0], raw[1]) = (kind, corners as i32);
    for (place, v) in raw[2..].iter_mut().zip(vectors.iter().flat_map(|v| [v.0, v.1])) {
        *place = v as i32;
    }
    raw
}

/// Boxes among blocks move by axes, to their goal and along all that they cross. Everything else
/// moves in steps.
fn textbook<S: Named>(list: &mut List<Case, Answer>, level: &'static Level, kind: Kind) {
    let cell = level.cell >> 16;
    let world = walk::Level {
        cells: &level.tiles,
        width: level.width as i32,
        height: level.height as i32,
        cell: cell as i32,
        origin: vector::<S>((level.x, level.y)),
        tiles: Box::leak(Box::new(tiles(cell).map(|raw| tile::<S>(&raw)))),
    };
    if kind == Kind::Circle {
        walked::<S, Circle<S>>(list, "move", move |body, d| walk::by_steps(&world, body, d));
    } else if level.blocks().is_some() {
        walked::<S, Aabb<S>>(list, "move", move |body, d| walk::by_axes(&world, body, d));
        walked::<S, Aabb<S>>(list, "move (columns)", move |body, d| walk::by_columns(&world, body, d));
    } else {
        walked::<S, Aabb<S>>(list, "move", move |body, d| walk::by_steps(&world, body, d));
    }
}

fn walked<S: Named, B: Book + Pushed<S> + Exact>(
    list: &mut List<Case, Answer>,
    asked: &'static str,
    go: impl Fn(&B, Vector<S>) -> B + Copy + 'static,
) {
    list.add(
        (S::NAME, asked, S::FORMAT),
        |c: &Case| (B::of(&c.start), c.motions.map(vector::<S>)),
        move |(body, motions)| {
            let mut body = *body;
            motions.map(|d| {
                body = go(&body, d);
                body
            })
        },
        |ends: &[B; FRAMES]| ends.map(|b| b.exact()),
    );
}
