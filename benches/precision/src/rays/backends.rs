//! The backends that walk a grid, or search a tree of its cells.

use super::classes::Ray;
use super::level::Level;
use super::trees;
use super::truth::Answer;
use crate::job::{Format, List};
use crate::peers::ours;
use crate::peers::ours::vec2;
use crate::peers::textbook::{Named, vector};
use std::rc::Rc;
use tilesat::{Fx, Grid, Inside, RangeError, RayHit, TileKind, TileKinds, TileMap, Vec2};
use tilesat_textbook::dda::{self, ExactHit, Hit};
use tilesat_textbook::shape::Vector;
use tilesat_textbook::{Q16, Wide};

pub fn all(level: &Rc<Level>) -> List<Ray, Answer> {
    let mut list = List(Vec::new());
    library(&mut list, level);
    plain(&mut list, level);
    walk::<Q16>(&mut list, level);
    walk::<Wide>(&mut list, level);
    walk::<f32>(&mut list, level);
    walk::<f64>(&mut list, level);
    trees::single::rays(&mut list, level);
    trees::double::rays(&mut list, level);
    trees::box2d(&mut list, level);
    trees::chipmunk(&mut list, level);
    list
}

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

type Cast = Result<Option<RayHit>, RangeError>;

fn library(list: &mut List<Ray, Answer>, level: &Rc<Level>) {
    let grid = Grid::new(256, 256, Fx::from_bits(1 << 20), Vec2::ZERO).expect("a legal grid");
    // A level is static data, as in flash.
    let map: TileMap<'static> = TileMap::on_grid(level.cells.clone().leak(), grid, &KINDS).expect("a legal map");
    list.add(
        (ours::NAME, "ray", Format::Parts(f64::from(1 << 30))),
        |r: &Ray| (vec2(r.o), vec2(r.d)),
        move |&(o, d)| map.cast_ray(o, d, Inside::Ignore),
        |hit: &Cast| hit.as_ref().ok().copied().flatten().map(|h| f64::from(h.toi.raw()) / f64::from(1 << 30)),
    );
}

/// The textbook's grid over cells that live as long as the loops.
fn grid(level: &Rc<Level>) -> dda::Grid<'static> {
    dda::Grid { cells: level.cells.clone().leak(), width: 256, height: 256 }
}

fn plain(list: &mut List<Ray, Answer>, level: &Rc<Level>) {
    let grid = grid(level);
    let raw = |(x, y): (i64, i64)| (x as i32, y as i32);
    list.add(
        ("plain integer DDA", "ray", Format::F64),
        move |r: &Ray| (raw(r.o), raw(r.d)),
        move |&(o, d)| dda::cast_exact(&grid, o, d),
        |hit: &Option<ExactHit>| hit.map(|h| f64::from(h.num) / f64::from(h.den)),
    );
}

fn walk<S: Named>(list: &mut List<Ray, Answer>, level: &Rc<Level>) {
    let grid = grid(level);
    list.add(
        (S::NAME, "ray", S::FORMAT),
        |r: &Ray| (vector::<S>(r.o), vector::<S>(r.d)),
        move |&(o, d): &(Vector<S>, Vector<S>)| dda::cast(&grid, o, d),
        |hit: &Option<Hit<S>>| hit.map(|h| h.t.px()),
    );
}
