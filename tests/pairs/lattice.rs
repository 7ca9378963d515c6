//! Every pair of shapes over a lattice of nine by nine points with seven radii, judged
//! exhaustively.
//!
//! Small integers contain every possible tie and touch. The same pairs run again enlarged to the
//! size of the domain, where the products are largest. Of pairs that differ by a translation, one
//! runs small, at the first column and row, and one enlarged, at the last ones.

use tilesat_judge::oracle::figure::{Figure, Point};
use tilesat_judge::oracle::verify::{self, Pair};

const SIDE: i64 = 9;
/// 5 makes exact touches with the triple (3, 4, 5), 0 makes points.
const RADII: [i64; 7] = [0, 1, 2, 3, 4, 5, 8];
/// Nearly the largest scale at which a circle of radius 8 stays in the domain when the lattice is
/// centred.
const LARGE: i64 = 44_000_003;

fn points() -> Vec<Point> {
    (0..SIDE * SIDE).map(|i| (i % SIDE, i / SIDE)).collect()
}

fn boxes() -> Vec<Figure> {
    let all = points();
    let corners = all.iter().flat_map(|p| all.iter().map(move |q| (*p, *q)));
    corners.filter(|(p, q)| p.0 <= q.0 && p.1 <= q.1).map(|(min, max)| Figure::Aabb { min, max }).collect()
}

fn circles() -> Vec<Figure> {
    points().into_iter().flat_map(|centre| RADII.map(|radius| Figure::Circle { centre, radius })).collect()
}

/// Both orders of the ends occur. The order depends only on the pair of points.
fn segments() -> Vec<Figure> {
    let all = points();
    let mut list = Vec::new();
    for (i, p) in all.iter().enumerate() {
        for (j, q) in all.iter().enumerate().skip(i) {
            let (a, b) = if (i + j) % 2 == 0 { (*p, *q) } else { (*q, *p) };
            list.push(Figure::Segment { a, b });
        }
    }
    list
}

fn enlarged(figure: &Figure) -> Figure {
    let middle = SIDE / 2;
    match figure.map(|p| ((p.0 - middle) * LARGE, (p.1 - middle) * LARGE)) {
        Figure::Circle { centre, radius } => Figure::Circle { centre, radius: radius * LARGE },
        other => other,
    }
}

/// The end of the lattice at which a pair lies.
#[derive(Clone, Copy)]
enum Corner {
    First,
    Last,
}

impl Corner {
    /// Whether two figures reach this corner's column and row together.
    fn holds(self, a: &Figure, b: &Figure) -> bool {
        let line = if matches!(self, Self::First) { 0 } else { SIDE - 1 };
        let ends = [a, b].map(|figure| match *figure {
            Figure::Aabb { min, max } => [min, max],
            Figure::Circle { centre, .. } => [centre; 2],
            Figure::Segment { a, b } => [a, b],
        });
        let mut points = ends.iter().flatten();
        points.clone().any(|p| p.0 == line) && points.any(|p| p.1 == line)
    }
}

fn check(a: &Figure, b: &Figure) {
    let pair = Pair::new(a, b);
    pair.booleans();
    pair.contact();
    pair.distances();
}

/// Every one of `first` with every one of `second`, or every unordered pair of one list, by two
/// threads.
fn exhaust(name: &str, lists: (&[Figure], Option<&[Figure]>), at: Corner, run: impl Fn(&Figure, &Figure) + Sync) {
    let (first, second) = lists;
    let start = std::time::Instant::now();
    let total = std::sync::atomic::AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for parity in 0..2 {
            let (run, total) = (&run, &total);
            scope.spawn(move || {
                for (i, a) in first.iter().enumerate().skip(parity).step_by(2) {
                    for b in second.unwrap_or(&first[i..]).iter().filter(|b| at.holds(a, b)) {
                        run(a, b);
                        total.fetch_add(1, core::sync::atomic::Ordering::Relaxed);
                    }
                }
            });
        }
    });
    println!("{name}: {} pairs, 0 wrong, {:.1} s", total.into_inner(), start.elapsed().as_secs_f64());
}

fn all_pairs(name: &str, first: &[Figure], second: Option<&[Figure]>) {
    exhaust(name, (first, second), Corner::First, check);
    exhaust(&format!("{name}, enlarged"), (first, second), Corner::Last, |a, b| {
        Pair::new(&enlarged(a), &enlarged(b)).booleans();
    });
}

#[test]
fn boxes_with_boxes() {
    all_pairs("box-box", &boxes(), None);
}

#[test]
fn circles_with_circles() {
    all_pairs("circle-circle", &circles(), None);
}

#[test]
fn circles_with_boxes() {
    all_pairs("circle-box", &circles(), Some(&boxes()));
}

#[test]
fn circles_with_segments() {
    all_pairs("circle-segment", &circles(), Some(&segments()));
}

#[test]
fn segments_with_boxes() {
    all_pairs("segment-box", &segments(), Some(&boxes()));
}

#[test]
fn segments_with_segments() {
    all_pairs("segment-segment", &segments(), None);
}

#[test]
fn points_with_every_shape() {
    for figure in boxes().iter().chain(&circles()).chain(&segments()) {
        for p in points() {
            verify::point(figure, p);
            verify::point(&figure.map(|q| (3 * q.0, 3 * q.1)), (3 * p.0 + 1, 3 * p.1 - 1));
        }
    }
}
