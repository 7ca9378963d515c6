//! Circles among tiles: does one overlap, and what does it hit within 128 pixels?

use super::Asked;
use crate::casts::classes::Case;
use crate::casts::truth::{Answer, Truth, judge};
use crate::job::{Format, List};
use crate::peers::ours::{self, Shape, vec2};
use crate::peers::textbook::{Named, Shape as Book, vector};
use crate::rays::level::{CELL, Level, MAPS, SIDE};
use crate::record::Row;
use crate::run::Sizes;
use tilesat::{Circle, Fx, Grid, Inside, RangeError, TileKind, TileKinds, TileMap, Vec2, motion::BodyHit};
use tilesat_judge::Random;
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::generate::UNIT;
use tilesat_judge::oracle::measure::Measure;
use tilesat_textbook::shape::Circle as Plain;
use tilesat_textbook::{Q16, cells, dda};

const OVERLAPS: &str = "tiles: overlaps";

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

/// The solid cells that a circle's box covers on its way, as figures.
fn near(level: &Level, case: &Case) -> Vec<Figure> {
    let Figure::Circle { centre, radius } = case.a else { return Vec::new() };
    let cells = |at: i64, d: i64| {
        let (lo, hi) = (at + d.min(0) - radius, at + d.max(0) + radius);
        lo.div_euclid(CELL) - 1..=hi.div_euclid(CELL)
    };
    let places = cells(centre.1, case.d.1).flat_map(|y| cells(centre.0, case.d.0).map(move |x| (x, y)));
    let solid = places.filter(|&(x, y)| level.solid(x, y));
    solid.map(|(x, y)| Figure::Aabb { min: (x * CELL, y * CELL), max: ((x + 1) * CELL, (y + 1) * CELL) }).collect()
}

fn overlaps(level: &Level, case: &Case) -> Truth {
    let still = Case { d: (0, 0), ..*case };
    let all: Vec<Measure> = near(level, &still).iter().map(|cell| Measure::new(&case.a, cell)).collect();
    Truth::at_once(all.iter().any(Measure::overlaps), all.iter().any(Measure::touches))
}

fn first(level: &Level, case: &Case) -> Truth {
    Truth::first(near(level, case).into_iter().map(|b| Truth::new(&Case { b, ..*case })))
}

/// Circles of 2 to 16 pixels: anywhere, or free and with a motion.
fn cases(level: &Level, moving: bool, n: usize) -> Vec<Case> {
    let (mut r, side) = (Random::new(0x711e5 + u64::from(moving)), SIDE as i64 * CELL);
    let mut cases = Vec::with_capacity(n);
    while cases.len() < n {
        let around = |r: &mut Random| if moving { (r.around(128 * UNIT), r.around(128 * UNIT)) } else { (0, 0) };
        let d: Point = around(&mut r);
        let a =
            Figure::Circle { centre: (r.within(0, side), r.within(0, side)), radius: r.within(2 * UNIT, 16 * UNIT) };
        let case = Case { a, b: a, d };
        let is_short = d.0 * d.0 + d.1 * d.1 <= (128 * UNIT) * (128 * UNIT);
        if is_short && (!moving || overlaps(level, &case).is_free()) {
            cases.push(case);
        }
    }
    cases
}

type Cast = Result<Option<BodyHit<Circle>>, RangeError>;

fn backends(level: &Level, moving: bool) -> List<Case, Answer> {
    let mut list = List(Vec::new());
    let cells: &'static [u8] = level.cells.clone().leak();
    let side = SIDE as u16;
    let grid = Grid::new(side, side, Fx::from_bits(CELL as i32), Vec2::ZERO).expect("a legal grid");
    let map: TileMap<'static> = TileMap::on_grid(cells, grid, &KINDS).expect("a legal map");
    if moving {
        list.add(
            (ours::NAME, "cast", Format::Parts(f64::from(1 << 30))),
            |c: &Case| (Circle::of(&c.a), vec2(c.d)),
            move |(a, d)| map.cast_shape(a, *d, Inside::Hit),
            |found: &Cast| {
                let hit = found.as_ref().ok().and_then(Option::as_ref);
                Answer { hit: hit.is_some(), toi: hit.map(|h| f64::from(h.hit.toi.raw()) / f64::from(1 << 30)) }
            },
        );
    } else {
        let circle = |c: &Case| Circle::of(&c.a);
        list.add((ours::NAME, "overlaps", Format::RAW), circle, move |a| map.overlaps(a), answer);
    }
    let grid = dda::Grid { cells, width: side.into(), height: side.into() };
    textbook::<Q16>(&mut list, grid, moving);
    textbook::<f32>(&mut list, grid, moving);
    textbook::<f64>(&mut list, grid, moving);
    single::circles(&mut list, level, moving);
    double::circles(&mut list, level, moving);
    list
}

fn answer(&hit: &bool) -> Answer {
    Answer { hit, toi: None }
}

fn textbook<S: Named>(list: &mut List<Case, Answer>, grid: dda::Grid<'static>, moving: bool) {
    let circle = |c: &Case| (Plain::<S>::of(&c.a), vector::<S>(c.d));
    if moving {
        let read = |t: &Option<S>| Answer { hit: t.is_some(), toi: t.map(S::px) };
        list.add((S::NAME, "cast", S::FORMAT), circle, move |(a, d)| cells::first(&grid, a, *d), read);
    } else {
        list.add((S::NAME, "overlaps", S::FORMAT), circle, move |(a, _)| cells::overlaps(&grid, a), answer);
    }
}

macro_rules! parry {
    ($module:ident, $parry:ident, $compound:literal, $voxels:literal) => {
        mod $module {
            use super::*;
            use crate::peers::parry::$module::{FORMAT, Placed, vector};
            use crate::rays::trees::$module::{compound, voxels};
            use $parry::math::{Pose, Vector};
            use $parry::query::{ShapeCastHit, ShapeCastOptions, cast_shapes, intersection_test};
            use $parry::shape::{Ball, Shape};

            pub fn circles(list: &mut List<Case, Answer>, level: &Level, moving: bool) {
                among(list, $compound, compound(level), moving);
                among(list, $voxels, voxels(level), moving);
            }

            fn among(list: &mut List<Case, Answer>, name: &'static str, world: impl Shape, moving: bool) {
                // The loops may live as long as the program.
                let world: &'static _ = Box::leak(Box::new(world));
                let shape = |c: &Case| (Ball::of(&c.a), vector(c.d));
                if moving {
                    let read = |hit: &Option<ShapeCastHit>| Answer {
                        hit: hit.is_some(),
                        toi: hit.map(|h| f64::from(h.time_of_impact)),
                    };
                    let ask = move |((p, a), d): &((Pose, Ball), Vector)| {
                        let options = ShapeCastOptions { max_time_of_impact: 1.0, ..ShapeCastOptions::default() };
                        cast_shapes(p, *d, a, &Pose::identity(), Vector::ZERO, world, options).ok().flatten()
                    };
                    list.add((name, "cast", FORMAT), shape, ask, read);
                } else {
                    let ask = move |((p, a), _): &((Pose, Ball), Vector)| {
                        intersection_test(p, a, &Pose::identity(), world).is_ok_and(|i| i.intersecting)
                    };
                    list.add((name, "overlaps", FORMAT), shape, ask, answer);
                }
            }
        }
    };
}

parry!(single, parry2d, "parry2d", "parry2d Voxels");
parry!(double, parry2d_f64, "parry2d-f64", "parry2d-f64 Voxels");

fn asked(level: &Level, class: &str, moving: bool, n: usize) -> Asked<Case, Answer> {
    Asked {
        workload: if moving { "tiles: casts" } else { OVERLAPS },
        class: class.to_owned(),
        list: backends(level, moving),
        inputs: cases(level, moving, n),
    }
}

pub fn all(n: usize) -> Vec<Asked<Case, Answer>> {
    let both = [false, true].into_iter().flat_map(|moving| MAPS.map(|map| (map, moving)));
    both.map(|(map, moving)| asked(&Level::new(map), map.name(), moving, n)).collect()
}

pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    for (i, asked) in all(sizes.rays).iter().enumerate() {
        let level = Level::new(MAPS[i % MAPS.len()]);
        let truth = if asked.workload == OVERLAPS { overlaps } else { first };
        let truths: Vec<Truth> = asked.inputs.iter().map(|case| truth(&level, case)).collect();
        asked.measure(sizes, rows, |row, answers, name| {
            let format = asked.list.0.iter().find(|b| b.name == name).map_or(Format::RAW, |b| b.format);
            judge(row, &truths, answers, format);
        });
    }
}
