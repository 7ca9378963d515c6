//! Positions of the surface of a disc.

use super::{Axis, offset, offset_to_radius};

/// Around an offset equal to the radius, by parts of it and by raw units: the bounds agree with
/// exact squares.
#[test]
#[allow(clippy::cast_precision_loss, reason = "only to come near the edge")]
fn bounds_of_offsets_are_on_both_sides() {
    for (x, y) in [(1, 0), (0, -1), (1, 1), (-1, 1), (2, 1), (1, -2), (-2, -1), (2, 2), (3, 1), (70_001, -13)] {
        let e = Axis::new(x, y);
        let length = (e.length_squared() as f64).sqrt();
        for r in [0, 1, 7, 655_361, (1 << 28) - 1] {
            for du in [1, -3, 65_537, -2_621_443, (1 << 29) + 5, 1 << 31] {
                let edge = (f64::from(r) * (du as f64).abs() / length) as i64;
                let near = (-128..=128).flat_map(|k| [edge + edge / 64 * k, edge + edge / 8192 * k, edge + k]);
                for cross in near {
                    let wanted = offset_to_radius(cross, e, r, du);
                    assert_eq!(offset(cross, e, r, du), wanted, "{cross} {e:?} {r} {du}");
                }
            }
        }
    }
}
