//! Building a map of segments: sloping ground in one chain. Beside it parry2d's polyline, which is
//! a tree of the same segments.

use super::Asked;
use crate::job::{Format, List};
use crate::peers::ours;
use crate::peers::parry::{double, single};
use crate::record::Row;
use tilesat::{Fx, Path, PathKind, SegmentMap, Vec2};
use tilesat_judge::Random;
use tilesat_judge::oracle::figure::Point;

type Chain = Vec<Point>;

/// At most this many segments.
pub fn all(largest: usize) -> Vec<Asked<Chain, bool>> {
    let sizes = [10, 100, 1_000, 10_000].into_iter().filter(|&n| n <= largest);
    sizes
        .map(|n| Asked {
            workload: "building of a segment map",
            class: format!("{n} segments"),
            list: backends(),
            inputs: vec![chain(n)],
        })
        .collect()
}

/// Slopes of a pixel to a pixel and a half in width. They run forth and back over the domain in
/// rows of 8 pixels.
fn chain(n: usize) -> Chain {
    let (mut r, mut at, mut ahead) = (Random::new(0xb11d), (-4000i64 << 16, -4000i64 << 16), 1);
    let mut points = vec![at];
    while points.len() <= n {
        let x = at.0 + ahead * r.within(1 << 16, 3 << 15);
        at = if x.abs() < 4000 << 16 {
            (x, (at.1 >> 19 << 19) + r.within(0, 1 << 17))
        } else {
            ahead = -ahead;
            (at.0, at.1 + (8 << 16))
        };
        points.push(at);
    }
    points
}

const CELL: Fx = Fx::lit("32");

macro_rules! parry {
    ($list:ident, $module:ident, $parry:ident, $name:literal) => {
        $list.add(
            ($name, "build", $module::FORMAT),
            |chain: &Chain| chain.iter().map(|&p| $module::vector(p)).collect::<Vec<_>>(),
            |points| $parry::shape::Polyline::new(points.clone(), None),
            |_| true,
        );
    };
}

fn backends() -> List<Chain, bool> {
    let mut list = List(Vec::new());
    list.add(
        (ours::NAME, "build", Format::RAW),
        |chain: &Chain| {
            let points: Vec<Vec2> = chain.iter().map(|&p| ours::vec2(p)).collect();
            let size = SegmentMap::measure(&[Path::new(PathKind::Wall, &points)], CELL);
            (points, size.map_or(0, |size| size.bytes()))
        },
        |(points, bytes)| {
            let mut out = vec![0; *bytes];
            let built = SegmentMap::build_into(&[Path::new(PathKind::Wall, points)], CELL, &mut out);
            (built.is_ok(), out)
        },
        |(built, _)| *built,
    );
    parry!(list, single, parry2d, "parry2d");
    parry!(list, double, parry2d_f64, "parry2d-f64");
    list
}

/// Counts missing segments as wrong.
pub fn judge(row: &mut Row, answers: &[bool], _: &str) {
    row.set("queries", answers.len() as f64).set("wrong", answers.iter().filter(|&&built| !built).count() as f64);
}
