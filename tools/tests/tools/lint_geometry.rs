//! The basis of the linter's answers: how edges meet, areas, windings and exact decimals.

use num_bigint::BigInt;
use num_rational::Ratio;
use tilesat_tools::geometry::{Edge, Meeting, Point, Side, doubled_area, meet, winding};
use tilesat_tools::model::decimal::Decimal;

type Fraction = Ratio<BigInt>;

fn edge(a: Point, b: Point) -> Edge {
    Edge { a, b, outline: None, number: 0, side: Side::Solid }
}

fn fraction(n: i64) -> Fraction {
    Fraction::from(BigInt::from(n))
}

/// The same question answered by parameters along both edges, in fractions.
fn expected(s: &Edge, t: &Edge) -> Meeting {
    let (d, e) = ((s.b.0 - s.a.0, s.b.1 - s.a.1), (t.b.0 - t.a.0, t.b.1 - t.a.1));
    let gap = (t.a.0 - s.a.0, t.a.1 - s.a.1);
    let (zero, one) = (fraction(0), fraction(1));
    let determinant = d.0 * e.1 - d.1 * e.0;
    if determinant == 0 {
        if gap.0 * d.1 != gap.1 * d.0 {
            return Meeting::Apart;
        }
        // In lengths of s.
        let along = |p: Point| {
            let square = d.0 * d.0 + d.1 * d.1;
            fraction((p.0 - s.a.0) * d.0 + (p.1 - s.a.1) * d.1) / fraction(square)
        };
        let (u, v) = (along(t.a), along(t.b));
        let (lo, hi) = (u.clone().min(v.clone()), u.clone().max(v.clone()));
        let (from, to) = (lo.clone().max(zero.clone()), hi.clone().min(one.clone()));
        if from > to {
            return Meeting::Apart;
        }
        let place = |k: &Fraction| {
            let at = |a: i64, d: i64| (fraction(a) + k * fraction(d)).to_integer().try_into().unwrap();
            (at(s.a.0, d.0), at(s.a.1, d.1))
        };
        if from == to {
            return Meeting::SharedEnd(place(&from));
        }
        let at = place(&from).min(place(&to));
        return Meeting::Overlap { at, reversed: u > v, whole: lo == zero && hi == one };
    }
    let u = fraction(gap.0 * e.1 - gap.1 * e.0) / fraction(determinant);
    let v = fraction(gap.0 * d.1 - gap.1 * d.0) / fraction(determinant);
    let within = |k: &Fraction| *k >= zero && *k <= one;
    let end = |k: &Fraction| *k == zero || *k == one;
    if !within(&u) || !within(&v) {
        return Meeting::Apart;
    }
    // Nearest, halves up.
    let nearest = |a: i64, d: i64| {
        let doubled = (fraction(a) + &u * fraction(d)) * fraction(2) + fraction(1);
        (doubled / fraction(2)).floor().to_integer().try_into().unwrap()
    };
    let at = (nearest(s.a.0, d.0), nearest(s.a.1, d.1));
    match (end(&u), end(&v)) {
        (true, true) => Meeting::SharedEnd(at),
        (false, false) => Meeting::Cross(at),
        _ => Meeting::Tee(at),
    }
}

#[test]
fn all_pairs_on_a_small_lattice() {
    let points: Vec<Point> = (0..4).flat_map(|x| (0..4).map(move |y| (x, y))).collect();
    let edges: Vec<Edge> =
        points.iter().flat_map(|&a| points.iter().filter(move |&&b| b != a).map(move |&b| edge(a, b))).collect();
    let first = edges.iter().filter(|e| e.a.0 <= 1 && e.a.1 <= 1);
    for s in first {
        for t in &edges {
            assert_eq!(meet(s, t), expected(s, t), "{s:?} {t:?}");
        }
    }
}

/// Far from the origin, and one raw unit apart at the scale of the whole domain.
#[test]
fn close_misses_of_long_edges() {
    let far = 1 << 29;
    let long = edge((-far, -far + 1), (far, far));
    for x in [-far + 2, -12_345_678, -1, 0, 1, 99_999_999, far - 2] {
        for offset in -3..=3 {
            // The long edge is half a raw unit above the diagonal in the middle.
            for (a, b) in [((x, x + offset), (x + 7, x - 400)), ((x, x - 400), (x, x + offset))] {
                let t = edge(a, b);
                assert_eq!(meet(&long, &t), expected(&long, &t), "{t:?}");
                assert_eq!(meet(&t, &long), expected(&t, &long), "{t:?}");
            }
        }
    }
}

#[test]
fn areas_and_windings() {
    let square = [(0, 0), (4, 0), (4, 4), (0, 4)];
    let back: Vec<Point> = square.iter().rev().copied().collect();
    assert_eq!((doubled_area(&square), doubled_area(&back)), (32, -32));
    // A bow tie of two equal wings.
    assert_eq!(doubled_area(&[(0, 0), (4, 4), (4, 0), (0, 4)]), 0);
    // A U, in doubled coordinates: all points that are not on it, including those at the heights of
    // its corners.
    let u = [(0, 0), (2, 0), (2, 4), (4, 4), (4, 0), (6, 0), (6, 6), (0, 6)];
    for y in -1..14 {
        for x in -1..14 {
            let within =
                |x: i64, y: i64| (0..12).contains(&x) && (0..12).contains(&y) && !((4..8).contains(&x) && y < 8);
            let inside = within(x, y);
            // Points on it have both inside and outside beside them.
            if [within(x - 1, y - 1), within(x, y - 1), within(x - 1, y)].iter().any(|&other| other != inside) {
                continue;
            }
            assert_eq!(winding(&u, (x, y)), i32::from(inside), "({x}, {y})");
            let turned: Vec<Point> = u.iter().rev().copied().collect();
            assert_eq!(winding(&turned, (x, y)), -i32::from(inside), "({x}, {y})");
        }
    }
}

#[test]
fn decimals() {
    let raw = |text: &str| Decimal::parse(text.as_bytes()).map(|d| (d.raw(), d.off_lattice()));
    for (text, expected) in [
        ("0", (0, 0)),
        ("-12.5", (-819_200, 0)),
        (" +3. ", (196_608, 0)),
        (".0000152587890625", (1, 0)),
        (".00000762939453125", (1, 500)),
        ("-.00000762939453125", (0, 500)),
        ("0.1", (6554, 400)),
        ("-0.1", (-6554, 400)),
        ("1.13687e-13", (0, 1)),
        ("8191.9999847412109375", ((1 << 29) - 1, 0)),
        ("1.5E+2", (150 << 16, 0)),
        ("000000000000000000012.0000000000000000000000000000000000", (12 << 16, 0)),
        ("999999.99999", (65_535_999_999, 345)),
        ("0.00000000000000000000000000000001", (0, 0)),
        ("0e399", (0, 0)),
    ] {
        assert_eq!(raw(text), Some(expected), "{text}");
    }
    for text in [
        "",
        "-",
        ".",
        "e5",
        "1e",
        "0x10",
        "1,5",
        "nan",
        "inf",
        "1e6",
        "1000000",
        "1e9999999999",
        "--1",
        "1.2.3",
        "\u{661}",
    ] {
        assert_eq!(raw(text), None, "{text}");
    }
}
