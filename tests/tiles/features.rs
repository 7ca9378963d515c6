//! The surface of a level: every neighbourhood, regions, joints, and that it is the border of the
//! set that `overlaps` calls solid.

use std::collections::BTreeSet;
use tilesat::{
    Aabb, Axis, Circle, Fx, Outside, TileMap, Vec2,
    world::{Feature, Geometry},
};
use tilesat_judge::blocks::build;
use tilesat_judge::blocks::level::Level;
use tilesat_judge::{Random, cases};

type Point = (i64, i64);

/// A feature in plain integers, ordered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Piece {
    Face { cell: Point, a: Point, b: Point, one_way: bool, joined: [bool; 2] },
    Vertex { cell: Point, p: Point, e_in: Point, e_out: Point },
}

fn piece(f: &Feature) -> Piece {
    let point = |v: Vec2| (i64::from(v.raw().0), i64::from(v.raw().1));
    let axis = |a: Axis| (i64::from(a.x), i64::from(a.y));
    let cell = (i64::from(f.cell.x), i64::from(f.cell.y));
    match f.geometry {
        Geometry::Face { a, dir, len, joined } => {
            let (a, dir, len) = (point(a), axis(dir), i64::from(len));
            assert!(len > 0 && dir.0.abs() + dir.1.abs() == 1);
            Piece::Face { cell, a, b: (a.0 + dir.0 * len, a.1 + dir.1 * len), one_way: f.one_way, joined }
        }
        Geometry::Vertex { p, e_in, e_out } => {
            assert!(!f.one_way);
            Piece::Vertex { cell, p: point(p), e_in: axis(e_in), e_out: axis(e_out) }
        }
        _ => panic!("a feature that no block has"),
    }
}

fn everything() -> Aabb {
    let end = (1 << 29) - 1;
    Aabb::new(Vec2::from_raw(-end, -end), Vec2::from_raw(end, end)).unwrap()
}

fn pieces(map: &TileMap, region: &Aabb) -> Vec<Piece> {
    map.features(region).map(|f| piece(&f)).collect()
}

/// The surface from directed edges. Each full cell gives four, and opposite ones cancel. Each end
/// of an edge is joined to the start found first when turning toward the solid. If that turn is
/// strictly convex, there is a vertex.
fn construct(level: &Level) -> BTreeSet<Piece> {
    let corner = |c: i64, r: i64| (level.x + c * level.cell, level.y + r * level.cell);
    let mut edges = Vec::new();
    for row in -2..=level.height + 1 {
        for column in -2..=level.width + 1 {
            if level.full(column, row) {
                let at = [
                    corner(column, row),
                    corner(column + 1, row),
                    corner(column + 1, row + 1),
                    corner(column, row + 1),
                ];
                for k in 0..4 {
                    edges.push((at[k], at[(k + 1) % 4], (column, row)));
                }
            }
        }
    }
    let all: BTreeSet<_> = edges.iter().map(|&(a, b, _)| (a, b)).collect();
    // A ring of cells around the map is built too, so that it cancels. Its own outer edges do not
    // belong to the level.
    let (x0, y0) = corner(-1, -1);
    let (x1, y1) = corner(level.width + 1, level.height + 1);
    let near = |p: Point| x0 < p.0 && p.0 < x1 && y0 < p.1 && p.1 < y1;
    edges.retain(|&(a, b, _)| !all.contains(&(b, a)) && near(a) && near(b));
    let step = |a: Point, b: Point| ((b.0 - a.0).signum(), (b.1 - a.1).signum());
    let cross = |u: Point, v: Point| u.0 * v.1 - u.1 * v.0;
    let mut out = BTreeSet::new();
    let (mut starts, mut ends) = (BTreeSet::new(), BTreeSet::new());
    for &(a, p, cell) in &edges {
        let e_in = step(a, p);
        let leaving = edges.iter().filter(|&&(start, _, _)| start == p).map(|&(_, b, _)| step(p, b));
        let Some(e_out) = leaving.max_by_key(|&e_out| cross(e_in, e_out)) else { continue };
        if cross(e_in, e_out) > 0 {
            out.insert(Piece::Vertex { cell, p, e_in, e_out });
            ends.insert((p, e_in));
            starts.insert((p, e_out));
        }
    }
    for &(a, b, cell) in &edges {
        let joined = [!starts.contains(&(a, step(a, b))), !ends.contains(&(b, step(a, b)))];
        out.insert(Piece::Face { cell, a, b, one_way: false, joined });
    }
    // One-way faces vanish where the lower edge of a full cell coincides.
    let up = |c: i64, r: i64| level.one_way(c, r) && !all.contains(&(corner(c + 1, r), corner(c, r)));
    for row in 0..level.height {
        for column in 0..level.width {
            if up(column, row) {
                let beside = |c: i64| level.full(c, row) || up(c, row);
                let joined = [beside(column - 1), beside(column + 1)];
                let (a, b) = (corner(column, row), corner(column + 1, row));
                out.insert(Piece::Face { cell: (column, row), a, b, one_way: true, joined });
            }
        }
    }
    out
}

#[test]
fn every_neighbourhood_of_nine_tiles() {
    for outside in [Outside::Empty, Outside::Solid] {
        for code in 0..19_683 {
            let tiles = (0..9).map(|i| (code / 3u32.pow(i) % 3) as u8).collect();
            let level = Level { width: 3, height: 3, cell: 256, x: -256, y: 512, outside, tiles };
            let got = pieces(&level.map(), &everything());
            let set: BTreeSet<_> = got.iter().copied().collect();
            assert_eq!(set.len(), got.len(), "twice: {level:?}");
            assert_eq!(set, construct(&level), "{level:?}");
        }
    }
}

/// With the border repeated, the surface is that of a level with wide margins of the same tiles,
/// cut at the domain's end.
#[test]
fn every_neighbourhood_with_its_border_repeated() {
    const FAR: i64 = (1 << 29) - 1;
    for code in 0..19_683 {
        let tiles = (0..9).map(|i| (code / 3u32.pow(i) % 3) as u8).collect();
        let level = Level { width: 3, height: 3, cell: 256, x: -256, y: 512, outside: Outside::Edge, tiles };
        let wide = Level { width: 5, height: 5, x: -512, y: 256, outside: Outside::Empty, ..level.clone() };
        let wide = Level { tiles: (0..25).map(|i| level.id(i % 5 - 1, i / 5 - 1)).collect(), ..wide };
        // Pieces of the wide level that are not on its own border, moved into the cells of the
        // small one.
        let cut = |p: Point| {
            let x = if p.0 == -512 {
                -FAR
            } else if p.0 == 768 {
                FAR
            } else {
                p.0
            };
            (
                x,
                if p.1 == 256 {
                    -FAR
                } else if p.1 == 1536 {
                    FAR
                } else {
                    p.1
                },
            )
        };
        let owner = |c: Point| ((c.0 - 1).clamp(0, 2), (c.1 - 1).clamp(0, 2));
        let on_border = |p: Point| p.0 == -512 || p.0 == 768 || p.1 == 256 || p.1 == 1536;
        let mut expected = BTreeSet::new();
        for piece in construct(&wide) {
            match piece {
                Piece::Vertex { cell, p, e_in, e_out } if !on_border(p) => {
                    expected.insert(Piece::Vertex { cell: owner(cell), p, e_in, e_out });
                }
                Piece::Face { a, b, .. }
                    if (on_border(a) && on_border(b)) && (a.0 == b.0 || a.1 == 256 || a.1 == 1536) => {}
                Piece::Face { cell, a, b, one_way, joined } => {
                    let joined = [joined[0] || on_border(a), joined[1] || on_border(b)];
                    expected.insert(Piece::Face { cell: owner(cell), a: cut(a), b: cut(b), one_way, joined });
                }
                Piece::Vertex { .. } => {}
            }
        }
        // The margin is one cell wide: its faces continue those of the border cells.
        let got: BTreeSet<_> = pieces(&level.map(), &everything()).into_iter().collect();
        assert_eq!(points(&got), points(&expected), "{level:?}");
    }
}

/// One-way, direction, start and end.
type Run = (bool, Point, Point, Point);

/// The extents of pieces, with collinear faces that continue each other joined.
fn points(pieces: &BTreeSet<Piece>) -> (Vec<Run>, Vec<Piece>) {
    let mut faces: Vec<_> = pieces
        .iter()
        .filter_map(|p| match *p {
            Piece::Face { a, b, one_way, .. } => Some((one_way, ((b.0 - a.0).signum(), (b.1 - a.1).signum()), a, b)),
            Piece::Vertex { .. } => None,
        })
        .collect();
    loop {
        let pair = (0..faces.len())
            .flat_map(|i| (0..faces.len()).map(move |j| (i, j)))
            .find(|&(i, j)| i != j && faces[i].0 == faces[j].0 && faces[i].1 == faces[j].1 && faces[i].3 == faces[j].2);
        let Some((i, j)) = pair else { break };
        faces[i].3 = faces[j].3;
        faces.remove(j);
    }
    faces.sort_unstable();
    (faces, pieces.iter().filter(|p| matches!(p, Piece::Vertex { .. })).copied().collect())
}

fn meets(p: &Piece, region: &Aabb) -> bool {
    let (lo, hi) = (region.min().raw(), region.max().raw());
    let (a, b) = match *p {
        Piece::Face { a, b, .. } => (a, b),
        Piece::Vertex { p, .. } => (p, p),
    };
    a.0.min(b.0) <= i64::from(hi.0)
        && a.0.max(b.0) >= i64::from(lo.0)
        && a.1.min(b.1) <= i64::from(hi.1)
        && a.1.max(b.1) >= i64::from(lo.1)
}

#[test]
fn a_region_gives_exactly_what_meets_it() {
    let mut random = Random::new(42);
    for _ in 0..cases(60_000) / 20 {
        let level = build::level(&mut random);
        let map = level.map();
        let all = pieces(&map, &everything());
        for _ in 0..20 {
            let (a, b) = (build::point(&mut random, &level), build::point(&mut random, &level));
            let b = if random.one_in(3) { (a.0 + random.below(3), a.1 + random.below(3)) } else { b };
            let cap = |v: i64| v.min((1 << 29) - 1) as i32;
            let lo = Vec2::from_raw(cap(a.0.min(b.0)), cap(a.1.min(b.1)));
            let hi = Vec2::from_raw(cap(a.0.max(b.0)), cap(a.1.max(b.1)));
            let region = Aabb::new(lo, hi).unwrap();
            let expected: Vec<_> = all.iter().filter(|p| meets(p, &region)).copied().collect();
            assert_eq!(pieces(&map, &region), expected, "{level:?} {region:?}");
        }
    }
}

/// For bodies with area: overlap is the same as any feature strictly overlapped, or the centre in
/// the solid.
#[test]
fn overlap_is_a_feature_overlapped_or_the_centre_in_the_solid() {
    let mut random = Random::new(43);
    let mut overlapped = 0u64;
    let total = cases(200_000);
    for _ in 0..total / 50 {
        let level = build::level(&mut random);
        let map = level.map();
        let cells = level.cells();
        for _ in 0..50 {
            let (x, y) = build::point(&mut random, &level);
            let limit = (1i64 << 29) - 1 - x.abs().max(y.abs());
            let (w, h) = (random.magnitude(3 * level.cell) + 1, random.magnitude(3 * level.cell) + 1);
            if w.max(h) > limit {
                continue;
            }
            // The centre doubled, so that it is an integer.
            let (overlaps, bounds, centre, circle) = if random.one_in(2) {
                let b = Aabb::new(Vec2::from_raw(x as i32, y as i32), Vec2::from_raw((x + w) as i32, (y + h) as i32))
                    .unwrap();
                (map.overlaps(&b), b, (2 * x + w, 2 * y + h), None)
            } else {
                let c = Circle::new(Vec2::from_raw(x as i32, y as i32), Fx::from_bits(w as i32)).unwrap();
                (map.overlaps(&c), c.aabb(), (2 * x, 2 * y), Some(w))
            };
            let (lo, hi) = (bounds.min().raw(), bounds.max().raw());
            let strict = |p: &Piece| {
                let (a, b, one_way) = match *p {
                    Piece::Face { a, b, one_way, .. } => (a, b, one_way),
                    Piece::Vertex { p, .. } => (p, p, false),
                };
                let (x0, x1, y0, y1) = (a.0.min(b.0), a.0.max(b.0), a.1.min(b.1), a.1.max(b.1));
                // A face is an interval of no length on one axis: it meets an open one where it
                // lies in it.
                let open = |lo: i32, hi: i32, from: i64, to: i64| i64::from(lo) < to && from < i64::from(hi);
                let meets = match circle {
                    None => open(lo.0, hi.0, x0, x1) && open(lo.1, hi.1, y0, y1),
                    Some(r) => {
                        let (gx, gy) = ((x0 - x).max(x - x1).max(0), (y0 - y).max(y - y1).max(0));
                        i128::from(gx) * i128::from(gx) + i128::from(gy) * i128::from(gy)
                            < i128::from(r) * i128::from(r)
                    }
                };
                meets && !one_way
            };
            let any = pieces(&map, &bounds).iter().any(strict);
            let solid = cells.iter().any(|c| {
                c.full && 2 * c.x0 <= centre.0 && centre.0 <= 2 * c.x1 && 2 * c.y0 <= centre.1 && centre.1 <= 2 * c.y1
            });
            assert_eq!(overlaps, any || solid, "{level:?} {bounds:?} {circle:?}");
            overlapped += u64::from(overlaps);
        }
    }
    assert!(overlapped > total / 10);
}

#[test]
fn a_seam_has_no_corner_and_a_door_is_one_byte() {
    let mut tiles = vec![0u8; 8];
    tiles.extend([1u8; 8]);
    let level = Level { width: 8, height: 2, cell: 16 << 16, x: 0, y: 0, outside: Outside::Empty, tiles };
    let count = |level: &Level| {
        let all = pieces(&level.map(), &everything());
        let corners = all.iter().filter(|p| matches!(p, Piece::Vertex { .. })).count();
        (all.len() - corners, corners)
    };
    // Eight faces above and below, two at the ends, and the four corners of the whole row.
    assert_eq!(count(&level), (18, 4));
    let mut door = level.clone();
    door.tiles[11] = 0;
    assert_eq!(count(&door), (18, 8));
    // Torture scene 45: the neighbours' edges appear with the door and go with it.
    door.tiles[11] = 1;
    assert_eq!(pieces(&door.map(), &everything()), pieces(&level.map(), &everything()));
}

/// Torture scene 43: deep inside a block of 10 x 10 there is nothing to see, and everything
/// overlaps.
#[test]
fn nothing_is_seen_deep_inside() {
    let level =
        Level { width: 10, height: 10, cell: 16 << 16, x: 0, y: 0, outside: Outside::Empty, tiles: vec![1; 100] };
    let body = Aabb::from_centre(Vec2::from_ints(80, 80), Vec2::from_ints(40, 40)).unwrap();
    assert_eq!(level.map().features(&body).count(), 0);
    assert!(level.map().overlaps(&body));
}
