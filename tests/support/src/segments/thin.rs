//! Boxes of no width or no height against the inside of the solid.

use super::{P, SCALE, Scene, Shape, cross, sub};

/// Whether a point between two points, one straight right of or above the other, has solid all
/// around it.
///
/// The edges' lines cut the way into pieces. The middle of each piece represents it, tested
/// slightly to both sides.
pub fn overlaps(scene: &Scene, lo: P, hi: P) -> bool {
    let upright = lo.0 == hi.0;
    let turned = |p: P| if upright { (p.1, p.0) } else { p };
    let (from, to) = (turned(lo), turned(hi));
    // Distances from the start as fractions with a positive divisor.
    let mut cuts: Vec<(i128, i128)> = vec![(0, 1), (to.0 - from.0, 1)];
    for (a, b) in scene.shapes.iter().flat_map(Shape::edges) {
        let (a, b) = (sub(turned(a), from), sub(turned(b), from));
        let d = sub(b, a);
        if d.1 != 0 {
            // Where it crosses the height 0: a.0 - a.1 d.0 / d.1.
            let (num, den) = (a.0 * d.1 - a.1 * d.0, d.1);
            cuts.push(if den < 0 { (-num, -den) } else { (num, den) });
        } else {
            cuts.extend([(a.0, 1), (b.0, 1)]);
        }
    }
    let length = to.0 - from.0;
    cuts.retain(|&(n, d)| 0 <= n && n <= length * d);
    cuts.sort_by(|a, b| cross((b.1, b.0), (a.1, a.0)).cmp(&0).reverse());
    cuts.windows(2).any(|w| {
        let ((n0, d0), (n1, d1)) = (w[0], w[1]);
        if n0 * d1 == n1 * d0 {
            return false;
        }
        // The middle, times SCALE and rounded. Its error is far less than the length of the piece.
        let middle = (n0 * d1 + n1 * d0) * (SCALE / 2) / (d0 * d1);
        let at = |off: i128| {
            let p = (from.0 * SCALE + middle, from.1 * SCALE + off);
            scene.winding(turned(p))
        };
        at(1) > 0 && at(-1) > 0
    })
}
