//! A shape as an engine holds it: corners around its middle, and of a box the turn.

use tilesat_judge::convex::shape::Shape;

/// In raw units, or halves of them.
pub struct Local {
    pub middle: (f64, f64),
    pub corners: Vec<(f64, f64)>,
}

/// A box that is turned by an angle with this cosine and sine.
pub struct Turned {
    pub half: (f64, f64),
    pub cos: f64,
    pub sin: f64,
}

impl Local {
    pub fn of(shape: &Shape) -> Self {
        let corners = shape.vertices();
        let middle = |of: fn(&(i64, i64)) -> i64| {
            let all = || corners.iter().map(of);
            (all().min().unwrap_or(0) + all().max().unwrap_or(0)) as f64 / 2.0
        };
        let middle = (middle(|p| p.0), middle(|p| p.1));
        let corners = corners.iter().map(|p| (p.0 as f64 - middle.0, p.1 as f64 - middle.1)).collect();
        Self { middle, corners }
    }

    pub fn turned(shape: &Shape) -> Turned {
        let Shape::Turned { half, direction: (x, y), .. } = *shape else { panic!("{shape:?} is no box") };
        let h = ((x * x + y * y) as f64).sqrt();
        Turned { half: (half.0 as f64, half.1 as f64), cos: x as f64 / h, sin: y as f64 / h }
    }
}
