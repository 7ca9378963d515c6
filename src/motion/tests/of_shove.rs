//! How a body yields along a slope.

use super::{Axis, Raw, quotient_up, yielding};

/// Against the division of the processor, at both ends of the range and around each multiple.
#[test]
fn quotients_round_up() {
    for a in [1u32, 2, 3, 5, 7, 0xffff, 0x1_0000, 0x7fff_ffff, 0xffff_ffff] {
        for times in [0u64, 1, 2, 3, 0xffff, 0x7fff_ffff, 0xffff_fffe] {
            for beside in [-1i64, 0, 1] {
                let Some(v) = (u64::from(a) * times).checked_add_signed(beside) else { continue };
                assert_eq!(u64::from(quotient_up(v, a)), v.div_ceil(u64::from(a)), "{v} / {a}");
            }
        }
    }
}

/// The rest leads out of the plane or along it, and not back.
#[test]
fn what_yields_does_not_lead_in() {
    let steps = || [-70i32, -9, -1, 0, 1, 9, 70].into_iter();
    for (nx, ny) in steps().flat_map(|x| steps().map(move |y| (x, y))).filter(|n| *n != (0, 0)) {
        let n = if nx == 0 || ny == 0 { Axis::new(nx.signum(), ny.signum()) } else { Axis::new(nx, ny) };
        let into = |v: Raw| i64::from(v.x) * i64::from(n.x) + i64::from(v.y) * i64::from(n.y);
        for rest in steps().flat_map(|x| steps().map(move |y| Raw { x: x * 3, y: y * 2 })) {
            for held in [(true, false), (false, true), (true, true)] {
                let left = yielding(rest, n, held);
                assert!(into(left) >= 0 || into(rest) >= 0, "{rest:?} {n:?} {held:?} {left:?}");
            }
        }
    }
}
