//! Rays from one side of an empty map to the other. Cells of a pixel, so that a motion can cross
//! the largest map.

use super::Asked;
use crate::job::{Format, List};
use crate::peers::ours::{self, vec2};
use crate::peers::textbook::{Named, vector};
use crate::record::Row;
use tilesat::{Fx, Grid, Inside, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::Random;
use tilesat_judge::oracle::figure::Point;
use tilesat_textbook::dda;
use tilesat_textbook::shape::Vector;

/// A start and a motion, raw.
pub type Ray = (Point, Point);

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

pub fn all(n: usize) -> Vec<Asked<Ray, bool>> {
    let maps = [64, 256, 1024, 2048, 4096].into_iter();
    maps.map(|side| Asked {
        workload: "rays: empty map",
        class: format!("{side} x {side} cells"),
        list: backends(side),
        inputs: rays(side, n),
    })
    .collect()
}

/// From the first column to the last one.
fn rays(side: i64, n: usize) -> Vec<Ray> {
    let (mut r, last) = (Random::new(0xe3 + side as u64), (side << 16) - 1);
    let mut ray = || {
        let (from, to) = ((r.within(1, 65535), r.within(1, last)), (last - r.within(1, 65535), r.within(1, last)));
        (from, (to.0 - from.0, to.1 - from.1))
    };
    (0..n).map(|_| ray()).collect()
}

fn backends(side: i64) -> List<Ray, bool> {
    let mut list = List(Vec::new());
    let cells: &'static [u8] = vec![0; (side * side) as usize].leak();
    let grid = Grid::new(side as u16, side as u16, Fx::ONE, Vec2::ZERO).expect("a legal grid");
    let map: TileMap<'static> = TileMap::on_grid(cells, grid, &KINDS).expect("a legal map");
    list.add(
        (ours::NAME, "ray", Format::RAW),
        |&(o, d): &Ray| (vec2(o), vec2(d)),
        move |&(o, d)| map.cast_ray(o, d, Inside::Ignore),
        |hit| !matches!(hit, Ok(None)),
    );
    let grid = dda::Grid::<1> { cells, width: side as i32, height: side as i32 };
    let raw = |(x, y): Point| (x as i32, y as i32);
    list.add(
        ("plain integer DDA", "ray", Format::F64),
        move |&(o, d): &Ray| (raw(o), raw(d)),
        move |&(o, d)| dda::cast_exact(&grid, o, d),
        |hit| hit.is_some(),
    );
    walk::<tilesat_textbook::Q16>(&mut list, grid);
    walk::<f32>(&mut list, grid);
    walk::<f64>(&mut list, grid);
    list
}

fn walk<S: Named>(list: &mut List<Ray, bool>, grid: dda::Grid<'static, 1>) {
    list.add(
        (S::NAME, "ray", S::FORMAT),
        |&(o, d): &Ray| (vector::<S>(o), vector::<S>(d)),
        move |&(o, d): &(Vector<S>, Vector<S>)| dda::cast(&grid, o, d),
        |hit| hit.is_some(),
    );
}

/// There is nothing to hit.
pub fn judge(row: &mut Row, answers: &[bool], _: &str) {
    row.set("queries", answers.len() as f64).set("wrong", answers.iter().filter(|&&hit| hit).count() as f64);
}
