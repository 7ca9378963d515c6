//! The linter's time and output are bounded, and its search for neighbours misses nothing.

use std::collections::HashSet;

use tilesat::TileKind;
use tilesat_tools::geometry::{Edge, Meeting, Point, Side, doubled_area, meet, orient, winding};
use tilesat_tools::lint::{self, Rules, SHOWN, Severity};
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::kind::Kind;
use tilesat_tools::rules::outline::{Outline, Title};

const RULES: Rules = Rules { body: None, small: 1 << 16 };

/// A level of these tiles of 16 pixels.
fn tiles(width: u16, height: u16, cells: Vec<TileKind>) -> Ground {
    Ground {
        name: "level".into(),
        layer: "World".into(),
        layers: 1,
        tile: 16,
        origin: (0, 0),
        width,
        height,
        cells,
        outlines: Vec::new(),
        left_out: Vec::new(),
        applied: Vec::new(),
        ignored: Vec::new(),
        unused: Vec::new(),
        notes: Vec::new(),
        doubts: Vec::new(),
        place: None,
        shift: (0, 0),
    }
}

/// A level of polygons, in pixels.
fn polygons(list: impl IntoIterator<Item = Vec<Point>>) -> Ground {
    let outline = |(id, points): (u32, Vec<Point>)| Outline {
        title: Title { id, name: String::new(), layer: "L".into() },
        kind: Kind::Solid,
        closed: true,
        rounding: vec![0; points.len()],
        points: points.into_iter().map(|(x, y)| (x << 16, y << 16)).collect(),
        flags: Vec::new(),
    };
    Ground { outlines: (1..).zip(list).map(outline).collect(), ..tiles(0, 0, Vec::new()) }
}

fn rectangle(x: i64, y: i64, width: i64, height: i64) -> Vec<Point> {
    vec![(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
}

/// Points in a square, the same in each run.
fn random(state: &mut u64, points: usize, side: u64) -> Vec<Point> {
    let mut below = || {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (((*state >> 32) * side) >> 32) as i64
    };
    (0..points).map(|_| (below(), below())).collect()
}

/// The lines of a kind that show a finding, and the line for the others.
fn of_kind(lines: &[String], kind: &str) -> (usize, Option<String>) {
    let shown = lines.iter().filter(|line| line.starts_with(&format!("{kind} at "))).count();
    (shown, lines.iter().find(|line| line.starts_with(&format!("{kind}: "))).cloned())
}

#[test]
fn fifty_of_a_kind_are_shown() {
    for (count, others) in [(SHOWN, None), (SHOWN + 1, Some(1)), (3 * SHOWN, Some(2 * SHOWN))] {
        let twice = (0..count as i64).map(|i| vec![(9 * i, 0), (9 * i, 0), (9 * i + 8, 0), (9 * i, 8)]);
        let findings = lint::check(&polygons(twice), &RULES).unwrap();
        let others = others.map(|others| format!("error zero-length: {others} more"));
        assert_eq!(of_kind(&findings.lines(), "error zero-length"), (SHOWN, others));
        assert_eq!(findings.count(Severity::Error), count);
    }
}

/// If all pairs are too many, the linter does not look for them to the end, and says so.
#[test]
fn everything_on_everything() {
    let equal = polygons((0..2000).map(|_| rectangle(8, 8, 32, 32)));
    let star = polygons([random(&mut 1, 4000, 8000)]);
    for (drawing, kind) in [(equal, "error duplicate"), (star, "error self-crossing")] {
        let lines = lint::check(&drawing, &RULES).unwrap().lines();
        assert_eq!(of_kind(&lines, kind), (SHOWN, Some(format!("{kind}: over 99950 more"))));
        let (unfinished, _) = of_kind(&lines, "warning unfinished");
        assert!(unfinished > 0 && lines.len() < 4 * SHOWN, "{lines:?}");
    }
}

/// The greatest number of rectangles, side by side and each within another. The linter looks at all
/// of them.
#[test]
fn many_things_are_looked_at() {
    let apart = polygons((0..16_383).map(|i| rectangle(i % 128 * 60, i / 128 * 60, 50, 50)));
    let nested = polygons((0..2000).map(|i| rectangle(i, i, 8000 - 2 * i, 8000 - 2 * i)));
    for (drawing, kind, count) in [(apart, "warning pocket", 32_510), (nested, "warning solid-buried", 1999)] {
        let body = Some(lint::Body::Box { width: 20 << 16, height: 20 << 16 }).filter(|_| kind.ends_with("pocket"));
        let findings = lint::check(&drawing, &Rules { body, ..RULES }).unwrap();
        assert_eq!(of_kind(&findings.lines(), kind).0, SHOWN);
        assert_eq!((findings.count(Severity::Warning), findings.count(Severity::Error)), (count, 0), "{kind}");
    }
}

/// A level far beyond the coordinates of the library, without a face inside.
#[test]
fn sixteen_million_solid_tiles() {
    let mut level = tiles(4000, 4000, vec![TileKind::FULL; 16_000_000]);
    assert_eq!(lint::check(&level, &RULES).unwrap().lines(), [""; 0]);

    // Every second one: more faces than it compares.
    level.cells.iter_mut().step_by(2).for_each(|cell| *cell = TileKind::EMPTY);
    let refused = lint::check(&level, &RULES).unwrap_err().to_string();
    assert_eq!(refused, "layer 'World' has more faces and corners than can be compared, which is 1048576");
}

/// Crossings, touches and nesting, counted over all pairs.
#[test]
fn near_edges_are_not_missed() {
    let mut buried = 0;
    for seed in 0..60 {
        let mut state = seed;
        // Small ones among large ones, so that some lie within others.
        let mut triangle = |i: i64| {
            let side = if i % 3 == 0 { 60 } else { 8 };
            let corner = random(&mut state, 1, 60 - side + 1)[0];
            random(&mut state, 3, side).iter().map(|p| (corner.0 + p.0, corner.1 + p.1)).collect()
        };
        let triangles: Vec<Vec<Point>> = (0..40).map(&mut triangle).collect();
        let triangles: Vec<_> = triangles.into_iter().filter(|points| doubled_area(&closed(points)) != 0).collect();
        let edges: Vec<Edge> = (0..).zip(&triangles).flat_map(|(i, points)| sides(i, points)).collect();
        let mut crossings = HashSet::new();
        let mut crossing = HashSet::new();
        for (i, s) in edges.iter().enumerate() {
            for (j, t) in edges.iter().enumerate().skip(i + 1) {
                if let Meeting::Cross(_) = meet(s, t) {
                    crossings.insert((i, j));
                    crossing.extend([s.outline, t.outline]);
                }
            }
        }
        let free = (0..triangles.len()).filter(|&i| !crossing.contains(&Some(i)));
        let expected = free.filter(|&i| is_buried(&triangles, &edges, i)).count();
        let lines = lint::check(&polygons(triangles.clone()), &RULES).unwrap().lines();
        let count = |kind: &str| {
            let (shown, others) = of_kind(&lines, kind);
            let others = others.map_or(0, |line| line.split(' ').nth(2).unwrap().parse().unwrap());
            shown + others
        };
        assert_eq!(count("warning crossing"), crossings.len(), "seed {seed}");
        assert_eq!(count("warning solid-buried"), expected, "seed {seed}");
        buried += expected;
    }
    assert!(buried > 50, "{buried}");
}

fn closed(points: &[Point]) -> Vec<Point> {
    [points, &points[..1]].concat()
}

/// In the linter's orientation: the solid lies on the right.
fn sides(outline: usize, points: &[Point]) -> Vec<Edge> {
    let mut points = closed(points);
    if doubled_area(&points) < 0 {
        points.reverse();
    }
    let edge = |(number, ends): (usize, &[Point])| Edge {
        a: (ends[0].0 << 16, ends[0].1 << 16),
        b: (ends[1].0 << 16, ends[1].1 << 16),
        outline: Some(outline),
        number,
        side: Side::Solid,
    };
    points.windows(2).enumerate().map(edge).collect()
}

/// Whether others contain the middle of its first edge that lies on no other, in the order of the
/// drawing.
fn is_buried(triangles: &[Vec<Point>], edges: &[Edge], i: usize) -> bool {
    let free = (0..3).find_map(|k| {
        let (a, b) = (triangles[i][k], triangles[i][(k + 1) % 3]);
        // In halves of a pixel.
        let middle = (a.0 + b.0, a.1 + b.1);
        let raw = (middle.0 << 15, middle.1 << 15);
        let on_another = edges.iter().any(|other| other.outline != Some(i) && touches(other, raw));
        (!on_another).then_some(middle)
    });
    let Some(middle) = free else { return false };
    let others = triangles.iter().enumerate().filter(|(j, _)| *j != i);
    others.filter(|(_, points)| winding(points, middle) != 0).count() > 0
}

fn touches(edge: &Edge, p: Point) -> bool {
    let between = |v: i64, a: i64, b: i64| a.min(b) <= v && v <= a.max(b);
    let (a, b) = (edge.a, edge.b);
    orient(a, b, p) == 0 && between(p.0, a.0, b.0) && between(p.1, a.1, b.1)
}
