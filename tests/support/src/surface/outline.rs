//! The surface of a mosaic by another method: polygons whose opposite half edges cancel, and solid
//! wedges around each point, merged where their borders agree.

use super::mosaic::Mosaic;
use super::piece::{Kind, Piece};
use super::polygon::{Edge, Point, one_way, reduced, solid};
use std::collections::{BTreeSet, HashMap, HashSet};

/// A direction at a point, and the bend of a border that leaves in it: 1 toward larger angles, -1
/// toward smaller ones, 0 straight.
type Ray = (Point, i8);

/// An edge in its place, in halves of a cell from the first cell's corner, and its cell.
type Placed = (Edge, Point);

fn place(edges: Vec<Edge>, cell: Point) -> impl Iterator<Item = Placed> {
    let at = move |p: Point| (p.0 + 2 * cell.0, p.1 + 2 * cell.1);
    edges.into_iter().map(move |e| (Edge { a: at(e.a), b: at(e.b), arc: e.arc.map(|(c, v)| (at(c), v)), ..e }, cell))
}

/// The solid of a tile at one of its points: from one border to the other, turning from x to y.
struct Wedge {
    from: Ray,
    owner: Point,
    angle: f64,
}

fn back(p: Point) -> Point {
    (-p.0, -p.1)
}

/// How the borders of an arc bend away from their tangents: those of convex ones into the wedge.
fn rays(edge: &Edge) -> (Ray, Ray) {
    let bend = match edge.arc {
        None => 0,
        Some((_, true)) => 1,
        Some((_, false)) => -1,
    };
    ((edge.out(), bend), (back(edge.arrival()), -bend))
}

fn angle(from: Point, to: Point) -> f64 {
    let of = |p: Point| f64::from(p.1 as i32).atan2(f64::from(p.0 as i32));
    (of(to) - of(from)).rem_euclid(core::f64::consts::TAU)
}

pub fn construct(mosaic: &Mosaic) -> BTreeSet<Piece> {
    let cells = mosaic.cells();
    let mut edges: Vec<Placed> = Vec::new();
    let mut wedges: HashMap<(Point, Ray), Wedge> = HashMap::new();
    for &cell in &cells {
        let border: Vec<_> = place(solid(mosaic.id(cell)), cell).collect();
        for (i, (edge, _)) in border.iter().enumerate() {
            let next = &border[(i + 1) % border.len()].0;
            let ((from, _), (_, to)) = (rays(next), rays(edge));
            let angle = angle(from.0, to.0);
            assert!(wedges.insert((edge.b, to), Wedge { from, owner: cell, angle }).is_none());
        }
        edges.extend(border);
    }
    let all: HashSet<_> = edges.iter().map(|(e, _)| (e.a, e.b)).collect();
    edges.retain(|(e, _)| e.index == 8 || !all.contains(&(e.b, e.a)));

    let mut out = BTreeSet::new();
    let (mut starts, mut ends) = (HashSet::new(), HashSet::new());
    for &(edge, cell) in &edges {
        let mut ray = rays(&edge).1;
        let (mut total, mut owner) = (0.0, cell);
        while let Some(wedge) = wedges.get(&(edge.b, ray)) {
            (ray, owner) = (wedge.from, wedge.owner);
            total += wedge.angle;
        }
        // All angles are sums of those between multiples of the slopes, 18 degrees and more:
        // rounding decides nothing.
        if total < core::f64::consts::PI - 0.01 {
            starts.insert((edge.b, ray.0, owner));
            ends.insert((edge.b, edge.index, cell));
            let kind = Kind::Vertex { p: edge.b, e_in: edge.arrival(), e_out: ray.0 };
            let index = if edge.index == 8 { 9 } else { edge.index + 4 };
            out.insert(mosaic.piece(cell, index, false, kind));
        }
    }
    for (edge, cell) in runs(&edges) {
        let kind = if let Some((centre, convex)) = edge.arc {
            let middle = (edge.a.0 + edge.b.0 - 2 * centre.0, edge.a.1 + edge.b.1 - 2 * centre.1);
            Kind::Arc { centre, radius: 2, quadrant: (middle.0.signum(), middle.1.signum()), convex }
        } else {
            let start = !starts.contains(&(edge.a, edge.out(), cell));
            let end = !ends.contains(&(edge.b, edge.index, cell));
            Kind::Face { a: edge.a, b: edge.b, dir: edge.out(), joined: [start, end] }
        };
        out.insert(mosaic.piece(cell, edge.index, false, kind));
    }
    out.extend(one_ways(mosaic, &cells, &all, &wedges));
    out.into_iter().filter_map(|piece| mosaic.in_raw(piece)).collect()
}

/// The half edges of a side that follow each other as one.
fn runs(edges: &[Placed]) -> Vec<Placed> {
    let mut out: Vec<Placed> = Vec::new();
    for &(edge, cell) in edges {
        match out.iter_mut().find(|(e, c)| *c == cell && e.index == edge.index && e.b == edge.a && e.index < 8) {
            Some((first, _)) => first.b = edge.b,
            None => out.push((edge, cell)),
        }
    }
    out
}

/// One-way half edges disappear if the solid has the same half in the other direction. They are
/// joined if the solid continues along their line, the tile beside their end is solid around it, or
/// such an edge continues.
fn one_ways(
    mosaic: &Mosaic,
    cells: &[Point],
    all: &HashSet<(Point, Point)>,
    wedges: &HashMap<(Point, Ray), Wedge>,
) -> Vec<Piece> {
    let mut edges: Vec<Placed> = cells.iter().flat_map(|&c| place(one_way(mosaic.id(c)), c)).collect();
    edges.retain(|(e, _)| !all.contains(&(e.b, e.a)));
    let there: HashSet<_> = edges.iter().map(|(e, _)| (e.a, e.b)).collect();
    let goes_on = |a: Point, b: Point, p: Point, beside: Point| {
        let solid = wedges.iter().any(|(&(at, _), w)| at == p && w.owner == beside && w.angle > 0.0);
        all.contains(&(a, b)) || there.contains(&(a, b)) || solid
    };
    runs(&edges)
        .into_iter()
        .map(|(edge, cell)| {
            let dir = reduced((edge.b.0 - edge.a.0, edge.b.1 - edge.a.1));
            let step = |p: Point, n: i64| (p.0 + n * dir.0, p.1 + n * dir.1);
            // An end in the middle of a side has the tile itself beside it, which is empty.
            let beside = |p: Point, n: i64| if (p.0 + p.1) % 2 == 0 { step(cell, n) } else { cell };
            let joined = [
                goes_on(step(edge.a, -1), edge.a, edge.a, beside(edge.a, -1)),
                goes_on(edge.b, step(edge.b, 1), edge.b, beside(edge.b, 1)),
            ];
            mosaic.piece(cell, edge.index, true, Kind::Face { a: edge.a, b: edge.b, dir, joined })
        })
        .collect()
}
