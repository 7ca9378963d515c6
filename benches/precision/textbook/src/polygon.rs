//! Convex polygons: every side of both is an axis.

use crate::Scalar;
use crate::shape::{Contact, Vector};

/// Corners in order, and the outward normals of the sides that begin there. For a contact their
/// length is one.
#[derive(Clone, Copy, Debug)]
pub struct Polygon<S, const N: usize> {
    pub corners: [Vector<S>; N],
    pub normals: [Vector<S>; N],
}

impl<S: Scalar, const N: usize> Polygon<S, N> {
    #[inline]
    fn sides(&self) -> impl Iterator<Item = (Vector<S>, Vector<S>)> + '_ {
        self.corners.iter().copied().zip(self.normals.iter().copied())
    }

    /// Whether a side of it has all of `b` beyond it.
    #[inline]
    fn separates<const M: usize>(&self, b: &Polygon<S, M>) -> bool {
        self.sides().any(|(p, n)| {
            let own = n.dot(p);
            b.corners.iter().all(|q| n.dot(*q) >= own)
        })
    }

    /// The side of it that `b` is least behind, and how far. `None` if it separates them.
    #[inline]
    fn least<const M: usize>(&self, b: &Polygon<S, M>) -> Option<Contact<S>> {
        let mut best: Option<Contact<S>> = None;
        for (p, normal) in self.sides() {
            let deepest = b.corners.iter().map(|q| normal.dot(*q)).reduce(S::least)?;
            let depth = normal.dot(p) - deepest;
            if depth <= S::ZERO {
                return None;
            }
            if best.is_none_or(|best| depth < best.depth) {
                best = Some(Contact { depth, normal });
            }
        }
        best
    }
}

#[inline]
pub fn polygon_polygon<S: Scalar, const N: usize, const M: usize>(a: &Polygon<S, N>, b: &Polygon<S, M>) -> bool {
    !a.separates(b) && !b.separates(a)
}

#[inline]
pub fn contact_polygon_polygon<S: Scalar, const N: usize, const M: usize>(
    a: &Polygon<S, N>,
    b: &Polygon<S, M>,
) -> Option<Contact<S>> {
    let (of_a, of_b) = (a.least(b)?, b.least(a)?);
    let n = of_b.normal;
    Some(if of_a.depth <= of_b.depth { of_a } else { Contact { normal: Vector { x: -n.x, y: -n.y }, ..of_b } })
}
