//! The three shapes as bare integers.

/// The end of the domain: every coordinate and radius has a smaller magnitude.
pub const LIMIT: i64 = 1 << 29;

pub type Point = (i64, i64);

/// A shape of which nothing is known. Failure messages print it as raw integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    Aabb { min: Point, max: Point },
    Circle { centre: Point, radius: i64 },
    Segment { a: Point, b: Point },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Aabb,
    Circle,
    Segment,
}

/// The six unordered pairs.
pub const PAIRS: [(Kind, Kind); 6] = [
    (Kind::Aabb, Kind::Aabb),
    (Kind::Circle, Kind::Circle),
    (Kind::Circle, Kind::Aabb),
    (Kind::Circle, Kind::Segment),
    (Kind::Segment, Kind::Aabb),
    (Kind::Segment, Kind::Segment),
];

impl Figure {
    pub const fn kind(&self) -> Kind {
        match self {
            Self::Aabb { .. } => Kind::Aabb,
            Self::Circle { .. } => Kind::Circle,
            Self::Segment { .. } => Kind::Segment,
        }
    }

    /// The vertices whose hull, grown by [`radius`](Self::radius), is the shape.
    pub fn vertices(&self) -> Vec<Point> {
        let (points, count) = self.corners();
        points[..count].to_vec()
    }

    /// The same without a heap allocation; the array is filled up with repeats.
    pub const fn corners(&self) -> ([Point; 4], usize) {
        match *self {
            Self::Aabb { min, max } => ([min, (max.0, min.1), max, (min.0, max.1)], 4),
            Self::Circle { centre, .. } => ([centre; 4], 1),
            Self::Segment { a, b } => ([a, b, a, b], 2),
        }
    }

    pub const fn radius(&self) -> i64 {
        match *self {
            Self::Circle { radius, .. } => radius,
            _ => 0,
        }
    }

    /// The shape with every vertex mapped by `f`; a box is put back in order.
    pub fn map(&self, f: impl Fn(Point) -> Point) -> Self {
        match *self {
            Self::Aabb { min, max } => {
                let (p, q) = (f(min), f(max));
                Self::Aabb { min: (p.0.min(q.0), p.1.min(q.1)), max: (p.0.max(q.0), p.1.max(q.1)) }
            }
            Self::Circle { centre, radius } => Self::Circle { centre: f(centre), radius },
            Self::Segment { a, b } => Self::Segment { a: f(a), b: f(b) },
        }
    }

    pub fn moved(&self, by: Point) -> Self {
        self.map(|p| (p.0 + by.0, p.1 + by.1))
    }

    /// Inside the domain with its whole extent, as the library's constructors ask.
    pub fn in_domain(&self) -> bool {
        in_domain(&self.corners().0, self.radius())
    }
}

/// Whether points with a radius around them are inside the domain.
pub fn in_domain(points: &[Point], radius: i64) -> bool {
    let limit = LIMIT - radius;
    radius >= 0 && points.iter().all(|p| p.0.abs() < limit && p.1.abs() < limit)
}
