//! The solid part of a cell for each shape, for the check and for pictures. Written independently
//! of the library.

use tilesat::TileShape;

/// A point in halves of a cell, y down.
pub(super) type Half = (i64, i64);

/// The solid of a tile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Outline {
    Nothing,
    /// A convex polygon.
    Polygon(Vec<Half>),
    /// The part of the cell within a circle of one cell around a corner.
    Quarter(Half),
    /// The rest of that cell.
    Bite(Half),
}

impl Outline {
    pub(super) fn of(shape: TileShape) -> Self {
        use TileShape as S;
        // Each shape at the top left, then the sides to exchange.
        let (points, right, bottom): (&[Half], _, _) = match shape {
            S::Full => (&[(0, 0), (2, 0), (2, 2), (0, 2)], false, false),
            S::HalfTop => (HALF_TOP, false, false),
            S::HalfBottom => (HALF_TOP, false, true),
            S::HalfLeft => (HALF_LEFT, false, false),
            S::HalfRight => (HALF_LEFT, true, false),
            S::SlopeTopLeft => (SLOPE, false, false),
            S::SlopeTopRight => (SLOPE, true, false),
            S::SlopeBottomRight => (SLOPE, true, true),
            S::SlopeBottomLeft => (SLOPE, false, true),
            S::MildLowTopLeft => (MILD_LOW, false, false),
            S::MildLowTopRight => (MILD_LOW, true, false),
            S::MildLowBottomRight => (MILD_LOW, true, true),
            S::MildLowBottomLeft => (MILD_LOW, false, true),
            S::MildHighTopLeft => (MILD_HIGH, false, false),
            S::MildHighTopRight => (MILD_HIGH, true, false),
            S::MildHighBottomRight => (MILD_HIGH, true, true),
            S::MildHighBottomLeft => (MILD_HIGH, false, true),
            S::SteepLowTopLeft => (STEEP_LOW, false, false),
            S::SteepLowTopRight => (STEEP_LOW, true, false),
            S::SteepLowBottomRight => (STEEP_LOW, true, true),
            S::SteepLowBottomLeft => (STEEP_LOW, false, true),
            S::SteepHighTopLeft => (STEEP_HIGH, false, false),
            S::SteepHighTopRight => (STEEP_HIGH, true, false),
            S::SteepHighBottomRight => (STEEP_HIGH, true, true),
            S::SteepHighBottomLeft => (STEEP_HIGH, false, true),
            S::ConvexTopLeft => return Self::Quarter((0, 0)),
            S::ConvexTopRight => return Self::Quarter((2, 0)),
            S::ConvexBottomRight => return Self::Quarter((2, 2)),
            S::ConvexBottomLeft => return Self::Quarter((0, 2)),
            S::ConcaveTopLeft => return Self::Bite((2, 2)),
            S::ConcaveTopRight => return Self::Bite((0, 2)),
            S::ConcaveBottomRight => return Self::Bite((0, 0)),
            S::ConcaveBottomLeft => return Self::Bite((2, 0)),
            _ => return Self::Nothing,
        };
        let place = |&(x, y): &Half| (if right { 2 - x } else { x }, if bottom { 2 - y } else { y });
        Self::Polygon(points.iter().map(place).collect())
    }

    /// Whether a half of a cell's side is covered. Sides are 0 to 3 from the top, turning right,
    /// and the halves turn the same way. Every outline starts and ends on the half lattice, so the
    /// middle of the half decides.
    pub(super) fn covers(&self, side: usize, half: usize) -> bool {
        // In quarters of a cell.
        let along = [1, 3][half];
        let (x, y) = [(along, 0), (4, along), (4 - along, 4), (0, 4 - along)][side];
        match self {
            Self::Nothing => false,
            Self::Polygon(points) => edges(points).all(|(a, b)| {
                let (dx, dy) = (b.0 - a.0, b.1 - a.1);
                let turn = dx * (y - 2 * a.1) - dy * (x - 2 * a.0);
                turn * winding(points) >= 0
            }),
            Self::Quarter(c) => square(x - 2 * c.0) + square(y - 2 * c.1) <= 16,
            Self::Bite(c) => square(x - 2 * c.0) + square(y - 2 * c.1) >= 16,
        }
    }
}

const HALF_TOP: &[Half] = &[(0, 0), (2, 0), (2, 1), (0, 1)];
const HALF_LEFT: &[Half] = &[(0, 0), (1, 0), (1, 2), (0, 2)];
const SLOPE: &[Half] = &[(0, 0), (2, 0), (0, 2)];
const MILD_LOW: &[Half] = &[(0, 0), (2, 0), (0, 1)];
const MILD_HIGH: &[Half] = &[(0, 0), (2, 0), (2, 1), (0, 2)];
const STEEP_LOW: &[Half] = &[(0, 0), (1, 0), (0, 2)];
const STEEP_HIGH: &[Half] = &[(0, 0), (2, 0), (1, 2), (0, 2)];

pub(super) fn edges(points: &[Half]) -> impl Iterator<Item = (Half, Half)> {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(&a, &b)| (a, b))
}

/// The direction of rotation of the points, 1 or -1.
pub(super) fn winding(points: &[Half]) -> i64 {
    edges(points).map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum::<i64>().signum()
}

fn square(v: i64) -> i64 {
    v * v
}
