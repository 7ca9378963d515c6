//! The tile shapes as polygons on the lattice of half cells, y down, the solid on the right of a
//! walker (the left of `dir` in the library's words).

pub type Point = (i64, i64);

/// One piece of a border, cut at every half of a cell's side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    pub a: Point,
    pub b: Point,
    /// For an arc: its centre, and whether it is convex.
    pub arc: Option<(Point, bool)>,
    /// 0 to 3 on the sides, else 8.
    pub index: u16,
}

/// One polygon of each group, solid in the corner (0, 0), as corners in halves of a cell; then the
/// first id.
const GROUPS: [(u8, &[Point]); 9] = [
    (2, &[(0, 0), (2, 0), (2, 1), (0, 1)]),
    (6, &[(0, 0), (2, 0), (0, 2)]),
    (10, &[(0, 0), (2, 0), (0, 2)]),
    (14, &[(0, 0), (2, 0), (0, 2)]),
    (18, &[(0, 0), (2, 0), (0, 1)]),
    (22, &[(0, 0), (2, 0), (2, 1), (0, 2)]),
    (26, &[(0, 0), (1, 0), (0, 2)]),
    (30, &[(0, 0), (2, 0), (1, 2), (0, 2)]),
    (34, &[]),
];

/// The border of a shape's solid, in order.
pub fn solid(id: u8) -> Vec<Edge> {
    if id == 0 || id > 33 {
        return Vec::new();
    }
    if id == 1 {
        return cut(&[(0, 0), (2, 0), (2, 2), (0, 2)], None);
    }
    let (first, points) = *GROUPS.iter().rfind(|g| g.0 <= id).unwrap();
    let turn = id - first;
    let place = |(x, y): Point| match turn {
        0 => (x, y),
        // Halves are turned. Shapes with a corner are mirrored, so that their slope stays mild or
        // steep.
        1 if first == 2 => (2 - y, x),
        1 => (2 - x, y),
        2 => (2 - x, 2 - y),
        _ if first == 2 => (y, 2 - x),
        _ => (x, 2 - y),
    };
    let mut points: Vec<_> = points.iter().map(|&p| place(p)).collect();
    if first != 2 && turn % 2 == 1 {
        points.reverse();
    }
    let arc = match first {
        10 => Some((place((0, 0)), true)),
        14 => Some((place((2, 2)), false)),
        _ => None,
    };
    cut(&points, arc)
}

/// The edge of a one-way tile: Up, Right, Down, Left from 34 on.
pub fn one_way(id: u8) -> Vec<Edge> {
    let corners = [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)];
    match id {
        34..=37 => halves(corners[usize::from(id - 34)], corners[usize::from(id - 33)]),
        _ => Vec::new(),
    }
}

fn cut(points: &[Point], arc: Option<(Point, bool)>) -> Vec<Edge> {
    (0..points.len())
        .flat_map(|i| {
            let (a, b) = (points[i], points[(i + 1) % points.len()]);
            // Of polygons with an arc, the slanted piece is the arc.
            if arc.is_some() && a.0 != b.0 && a.1 != b.1 { vec![Edge { a, b, arc, index: 8 }] } else { halves(a, b) }
        })
        .collect()
}

fn halves(a: Point, b: Point) -> Vec<Edge> {
    let index = match (a, b) {
        ((_, 0), (_, 0)) => 0,
        ((2, _), (2, _)) => 1,
        ((_, 2), (_, 2)) => 2,
        ((0, _), (0, _)) => 3,
        _ => 8,
    };
    let middle = (i64::midpoint(a.0, b.0), i64::midpoint(a.1, b.1));
    let edge = |a, b| Edge { a, b, arc: None, index };
    if index < 8 && (a.0 - b.0).abs() + (a.1 - b.1).abs() == 2 {
        vec![edge(a, middle), edge(middle, b)]
    } else {
        vec![edge(a, b)]
    }
}

impl Edge {
    /// The reduced direction in which a walker sets out.
    pub fn out(&self) -> Point {
        self.direction(self.a)
    }

    /// The reduced direction in which a walker arrives.
    pub fn arrival(&self) -> Point {
        self.direction(self.b)
    }

    fn direction(&self, at: Point) -> Point {
        match self.arc {
            None => reduced((self.b.0 - self.a.0, self.b.1 - self.a.1)),
            Some((c, convex)) => {
                let sign = if convex { 1 } else { -1 };
                reduced((sign * (c.1 - at.1), sign * (at.0 - c.0)))
            }
        }
    }
}

pub fn reduced((x, y): Point) -> Point {
    let g = (1..=x.abs().max(y.abs())).rev().find(|g| x % g == 0 && y % g == 0).unwrap();
    (x / g, y / g)
}
