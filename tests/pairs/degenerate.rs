//! The table of degenerate cases in the documentation of `query`, row by row, in both argument
//! orders, at the origin and far from it.

use tilesat::Axis;
use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::kernel;
use tilesat_judge::oracle::verify::Pair;

/// Axis, depth in raw units, whether degenerate, and the same for B on A.
#[derive(Clone, Copy)]
enum Way {
    /// Geometry decides: from B the axis is reversed.
    Least(Point, i64),
    /// A choice between two axes, each with its own sign: for B on A the axis is reversed.
    Axes(Point, i64),
    /// Both signs are equally good: for B on A the axis is the same.
    Signs(Point, i64),
}
use Way::{Axes, Least, Signs};

struct Row {
    case: &'static str,
    a: Figure,
    b: Figure,
    touches: bool,
    contact: Option<Way>,
}

const fn aabb(x0: i64, y0: i64, x1: i64, y1: i64) -> Figure {
    Figure::Aabb { min: (x0, y0), max: (x1, y1) }
}

const fn circle(x: i64, y: i64, radius: i64) -> Figure {
    Figure::Circle { centre: (x, y), radius }
}

const fn segment(x0: i64, y0: i64, x1: i64, y1: i64) -> Figure {
    Figure::Segment { a: (x0, y0), b: (x1, y1) }
}

const BOX: Figure = aabb(0, 0, 10, 10);

const fn over(case: &'static str, a: Figure, b: Figure, way: Way) -> Row {
    Row { case, a, b, touches: true, contact: Some(way) }
}

const fn touch(case: &'static str, a: Figure, b: Figure) -> Row {
    Row { case, a, b, touches: true, contact: None }
}

const fn apart(case: &'static str, a: Figure, b: Figure) -> Row {
    Row { case, a, b, touches: false, contact: None }
}

#[rustfmt::skip]
const TABLE: &[Row] = &[
    touch("boxes share part of a side", BOX, aabb(10, 3, 12, 20)),
    touch("boxes share a corner", BOX, aabb(10, 10, 12, 20)),
    touch("circles touch in one point", circle(0, 0, 5), circle(6, 8, 5)),
    touch("a circle touches a side", circle(-3, 5, 3), BOX),
    touch("a circle touches a corner", circle(-3, -4, 5), BOX),
    touch("a circle touches a segment", circle(1, 4, 4), segment(-3, -4, 13, 8)),
    touch("a circle touches an end", circle(-3, -4, 5), segment(0, 0, 7, 1)),
    touch("a segment touches a corner", segment(-3, 3, 3, -3), BOX),

    over("a point circle in a box", circle(2, 5, 0), BOX, Least((1, 0), 2)),
    over("a point segment in a box", segment(5, 9, 5, 9), BOX, Least((0, -1), 1)),
    over("a point box in a box", aabb(8, 5, 8, 5), BOX, Least((-1, 0), 2)),
    over("a segment reaches into a box", segment(-5, 5, 3, 5), BOX, Least((1, 0), 3)),
    over("a segment crosses a box", segment(-5, 2, 50, 2), BOX, Least((0, 1), 2)),
    over("a flat box crosses a box", aabb(-5, 8, 50, 8), BOX, Least((0, -1), 2)),
    touch("a point circle on a side", circle(0, 5, 0), BOX),
    touch("a point circle on a corner", circle(0, 0, 0), BOX),
    touch("a point segment on a side", segment(10, 5, 10, 5), BOX),
    touch("a point box on a corner", aabb(10, 10, 10, 10), BOX),
    touch("a segment within a side", segment(0, 2, 0, 8), BOX),
    touch("a segment beyond a side", segment(-4, 10, 18, 10), BOX),

    touch("flat boxes on one line", aabb(0, 0, 10, 0), aabb(5, 0, 15, 0)),
    touch("a flat box ends on another", aabb(0, 0, 10, 0), aabb(5, 0, 5, 10)),
    touch("equal point boxes", aabb(1, 1, 1, 1), aabb(1, 1, 1, 1)),
    touch("a point box on a flat one", aabb(3, 0, 3, 0), aabb(0, 0, 10, 0)),
    over("flat boxes cross", aabb(0, 5, 10, 5), aabb(3, 0, 3, 11), Least((-1, 0), 3)),
    over("a flat box and a segment cross", aabb(0, 5, 10, 5), segment(3, 3, 3, 11), Least((0, 1), 2)),

    touch("equal point segments", segment(1, 2, 1, 2), segment(1, 2, 1, 2)),
    touch("equal point circles", circle(1, 2, 0), circle(1, 2, 0)),
    touch("a point segment on a segment", segment(3, 4, 3, 4), segment(0, 0, 6, 8)),
    apart("a point segment on the line of a segment", segment(9, 12, 9, 12), segment(0, 0, 6, 8)),
    touch("a point box on a segment", aabb(3, 4, 3, 4), segment(0, 0, 6, 8)),
    apart("a point box beside a segment", aabb(3, 5, 3, 5), segment(0, 0, 6, 8)),

    over("segments cross", segment(0, 0, 10, 0), segment(2, -1, 2, 5), Least((0, 1), 1)),
    over("sloped segments cross", segment(-6, -8, 6, 8), segment(-5, 0, 50, 0), Least((16, -12), 4)),
    touch("segments form a T", segment(0, 0, 10, 0), segment(2, 0, 2, 5)),
    touch("segments share an end", segment(0, 0, 6, 8), segment(6, 8, 9, -3)),
    touch("segments overlap on one line", segment(0, 0, 6, 8), segment(3, 4, 9, 12)),
    touch("equal segments", segment(0, 0, 6, 8), segment(6, 8, 0, 0)),
    apart("segments apart on one line", segment(0, 0, 3, 4), segment(6, 8, 9, 12)),
    apart("parallel segments", segment(0, 0, 6, 8), segment(0, 1, 6, 9)),

    over("a point circle in a circle", circle(3, 0, 0), circle(0, 0, 5), Least((-1, 0), 2)),
    touch("a point circle on a circle", circle(3, 4, 0), circle(0, 0, 5)),
    touch("a point circle on a segment", circle(3, 4, 0), segment(0, 0, 6, 8)),
    touch("a point circle on an end", circle(6, 8, 0), segment(0, 0, 6, 8)),
    touch("a point circle on a point", circle(6, 8, 0), segment(6, 8, 6, 8)),
    apart("a point circle beside a segment", circle(4, 4, 0), segment(0, 0, 6, 8)),

    over("equal centres", circle(4, -4, 2), circle(4, -4, 3), Signs((1, 0), 5)),
    over("equal centres, one a point", circle(4, -4, 0), circle(4, -4, 3), Signs((1, 0), 3)),
    over("centre on the left side", circle(0, 5, 2), BOX, Least((1, 0), 2)),
    over("centre on the right side", circle(10, 5, 2), BOX, Least((-1, 0), 2)),
    over("centre on the lower side", circle(5, 0, 2), BOX, Least((0, 1), 2)),
    over("centre on the upper side", circle(5, 10, 2), BOX, Least((0, -1), 2)),
    over("centre on the first corner", circle(0, 0, 2), BOX, Axes((1, 0), 2)),
    over("centre on the second corner", circle(10, 0, 2), BOX, Axes((-1, 0), 2)),
    over("centre on the third corner", circle(10, 10, 2), BOX, Axes((-1, 0), 2)),
    over("centre on the fourth corner", circle(0, 10, 2), BOX, Axes((1, 0), 2)),
    over("centre on a flat box", circle(5, 0, 2), aabb(0, 0, 10, 0), Signs((0, 1), 2)),
    over("centre on the end of a flat box", circle(10, 0, 2), aabb(0, 0, 10, 0), Axes((-1, 0), 2)),
    over("centre on a point box", circle(7, 7, 2), aabb(7, 7, 7, 7), Signs((1, 0), 2)),
    over("centre on a sloped segment", circle(3, 4, 2), segment(6, 8, 0, 0), Signs((-8, 6), 2)),
    over("centre on an end", circle(0, 0, 2), segment(0, 0, 6, 8), Signs((-8, 6), 2)),
    over("centre on a falling segment", circle(3, 4, 2), segment(0, 8, 6, 0), Signs((8, 6), 2)),
    over("centre on a level segment", circle(3, 0, 2), segment(9, 0, -9, 0), Signs((0, 1), 2)),
    over("centre on an upright segment", circle(0, 3, 2), segment(0, 9, 0, -9), Signs((-1, 0), 2)),
    over("centre on a point segment", circle(7, 7, 2), segment(7, 7, 7, 7), Signs((1, 0), 2)),

    over("left and right exit equal", aabb(4, -20, 6, 20), BOX, Signs((1, 0), 6)),
    over("upper and lower exit equal", aabb(-20, 4, 20, 6), BOX, Signs((0, 1), 6)),
    over("all four exits equal", aabb(4, 4, 6, 6), BOX, Signs((1, 0), 6)),
    over("all four exits equal, a circle", circle(5, 5, 2), BOX, Signs((1, 0), 7)),
    over("all four exits equal, a point", segment(5, 5, 5, 5), BOX, Signs((1, 0), 5)),
    over("equal boxes", BOX, BOX, Signs((1, 0), 10)),
    over("x and y exit equal", aabb(-4, -4, 1, 1), BOX, Axes((1, 0), 1)),
    over("x and y exit equal, other signs", aabb(9, -4, 14, 1), BOX, Axes((-1, 0), 1)),
    over("x and y exit equal, a circle", circle(1, 9, 3), BOX, Axes((1, 0), 4)),
    over("axis and normal exit equal", aabb(0, 0, 6, 5), segment(-2, 1, 2, 4), Axes((-1, 0), 2)),
    over("both sides of a segment equal", aabb(-2, -2, 2, 2), segment(10, 10, -10, -10), Signs((-20, 20), 3)),
    over("both sides of a falling segment equal", aabb(-2, -2, 2, 2), segment(10, -10, -10, 10), Signs((20, 20), 3)),
    over("both halves of a segment equal", segment(-10, 0, 10, 0), segment(3, 2, 3, -2), Signs((0, 1), 2)),
    over("exits over both lines equal", segment(-3, 0, 10, 0), segment(0, -3, 0, 10), Axes((-1, 0), 3)),
];

fn moved(row: &Row, by: Point) -> Row {
    Row { a: row.a.moved(by), b: row.b.moved(by), ..*row }
}

fn check(row: &Row) {
    let Row { case, a, b, touches, contact } = row;
    let pair = Pair::new(a, b);
    assert_eq!(
        (pair.exact.overlaps(), pair.exact.touches()),
        (contact.is_some(), *touches),
        "{case}: the judge disagrees with the table"
    );
    pair.booleans();
    pair.contact();
    pair.distances();
    let Some(way) = contact else { return };
    let (axis, depth, degenerate, back) = match *way {
        Least(n, depth) => (n, depth, false, (-n.0, -n.1)),
        Axes(n, depth) => (n, depth, true, (-n.0, -n.1)),
        Signs(n, depth) => (n, depth, true, n),
    };
    for (first, second, expected) in [(a, b, axis), (b, a, back)] {
        let Some(contact) = kernel::contact(first, second) else { panic!("{case}: no contact") };
        let Axis { x, y } = contact.axis();
        assert_eq!((i64::from(x), i64::from(y)), expected, "{case}: axis of {first:?} and {second:?}");
        assert_eq!(i64::from(contact.depth().to_bits()), depth, "{case}: depth");
        assert_eq!(contact.is_degenerate(), degenerate, "{case}: degenerate");
    }
}

#[test]
fn documented_outcomes() {
    for row in TABLE {
        check(row);
        for by in [(500_000_000, -500_000_000), (-536_870_000, 536_870_000), (-7, 65_536)] {
            check(&moved(row, by));
        }
    }
    println!("{} rows", TABLE.len());
}
