//! The free ways of a body, and those that a surface leaves.

use super::{FreeWay, Plane, Smooth, across, project};
use crate::num::{Axis, Raw};
use crate::shape::Circle;
use crate::world::{AllShapes, TileMap};
use core::cmp::Ordering;
use tilesat_judge::{Random, cases, enough};

fn way(v: Raw, n: Axis) -> FreeWay {
    let v = project::<Circle, TileMap<'static, AllShapes>, _>(v, n, &Smooth);
    FreeWay::of(Some(Plane::flat(n)), v, v, false)
}

/// Rounded lengths never say the opposite of the exact ones. The second normal is often the
/// first one, turned by little or mirrored.
#[test]
fn rounded_lengths_agree_with_exact_ones() {
    let (mut random, mut told) = (Random::new(17), 0u32);
    for _ in 0..cases(400_000) {
        let (speed, size) = (1 << random.within(1, 24), 1 << random.within(1, 17));
        let part = |random: &mut Random, most: i64| random.around(most) as i32;
        let v = Raw { x: part(&mut random, speed), y: part(&mut random, speed) };
        let n = Axis::new(part(&mut random, size), part(&mut random, size));
        let turned = [Axis::new(n.y, n.x), Axis::new(n.x.wrapping_add(1), n.y), Axis::new(-n.x, n.y)];
        let other = Axis::new(part(&mut random, size), part(&mut random, size));
        for m in turned.into_iter().chain([other]) {
            if n.is_zero() || m.is_zero() {
                continue;
            }
            let (a, b) = (i128::from(across(v, n)), i128::from(across(v, m)));
            let square = |n: Axis| i128::from(n.length_squared());
            let exact = (a * a * square(m)).cmp(&(b * b * square(n)));
            let (one, two) = (way(v, n), way(v, m));
            if one.v.is_zero() || two.v.is_zero() {
                continue;
            }
            if let Some(longer) = one.is_clearly_longer(&two) {
                assert_eq!(longer, exact == Ordering::Greater, "{v:?} along {n:?} and {m:?}");
                assert_ne!(exact, Ordering::Equal, "{v:?} along {n:?} and {m:?}");
                told += 1;
            }
        }
    }
    assert!(enough(told > 10_000), "{told}");
}
