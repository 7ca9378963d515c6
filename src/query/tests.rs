//! The kernels of pair queries against wider numbers.

mod meet {
    use crate::query::meet::{by_octagons, by_squares};

    fn both_ways<const CLOSED: bool>(x: u32, y: u32, r: u32) {
        if x > r || y > r || (!CLOSED && (x == r || y == r)) {
            return;
        }
        let (square, limit) = (u64::from(x).pow(2) + u64::from(y).pow(2), u64::from(r).pow(2));
        let expected = if CLOSED { square <= limit } else { square < limit };
        assert_eq!(by_octagons::<CLOSED>(x, y, r), expected, "octagons {x} {y} {r}");
        assert_eq!(by_squares::<CLOSED>(x, y, r), expected, "squares {x} {y} {r}");
    }

    #[test]
    fn octagons_change_no_answer() {
        for r in 0..40 {
            for x in 0..42 {
                for y in 0..42 {
                    both_ways::<false>(x, y, r);
                    both_ways::<true>(x, y, r);
                }
            }
        }
        // Around the border of large discs, in all directions: y is the root that x leaves, give or
        // take a unit.
        for r in [1 << 16, (1 << 24) + 12_345, (1 << 30) - 1] {
            for step in 0..1000 {
                let x = r / 1000 * step;
                let y = (u64::from(r).pow(2) - u64::from(x).pow(2)).isqrt() as u32;
                for y in y.saturating_sub(2)..=y + 2 {
                    both_ways::<false>(x, y, r);
                    both_ways::<true>(x, y, r);
                }
            }
        }
    }
}

mod crossing {
    use crate::num::Raw;
    use crate::query::cast::moment::{Crossing, octagons};

    #[test]
    fn the_rim_is_not_inside() {
        let crossing = Crossing::of(Raw { x: -5, y: 0 }, 3, Raw { x: 9, y: 0 });
        for (x, inside) in [(0, true), (-2, true), (2, true), (-3, false), (3, false), (-4, false), (1 << 29, false)] {
            assert_eq!(crossing.map(|c| c.starts_inside(Raw { x, y: 0 })), Some(inside), "{x}");
        }
    }

    fn check(x: i32, y: i32) {
        let square = u64::from(x.unsigned_abs()).pow(2) + u64::from(y.unsigned_abs()).pow(2);
        let (below, above) = octagons(Raw { x, y });
        assert!(u64::from(below).pow(2) <= square && square <= u64::from(above).pow(2), "{x} {y}: {below} {above}");
    }

    #[test]
    fn octagons_are_on_both_sides() {
        for x in -700..700 {
            for y in -700..700 {
                check(x, y);
            }
        }
        // All directions, by the slope of long vectors: finer than any of the shifts.
        for k in 0..1 << 16 {
            check((1 << 29) - 1, k << 13);
            check(-k << 13, (1 << 29) - 1);
        }
    }
}

mod moment {
    use crate::num::{Toi, sqr64};
    use crate::query::cast::moment::{exit_time, gap_time, ratio};

    const ONE: u128 = 1 << 30;

    /// Every bit length, a few numbers of each.
    fn numbers(bits: u32) -> impl Iterator<Item = u64> + Clone {
        (0..bits)
            .flat_map(|k| [1, 3, 5, 0x9e37_79b9_7f4a_7c15 >> (63 - k)].map(|n| (n << k >> k & ((2 << k) - 1)) | 1 << k))
    }

    /// No more than `num / den`, and less by four parts in 2^30 and two steps at most.
    fn check(got: Toi, num: u64, den: u64, case: &[u64]) {
        let exact = (u128::from(num) * ONE / u128::from(den)).min(ONE);
        let got = u128::from(got.raw());
        assert!(got <= exact && exact - got <= (exact >> 28) + 2, "{got} for {exact}: {case:?}");
    }

    #[test]
    fn ratios_are_rounded_down_to_one() {
        assert_eq!(ratio(1 << 40, 1 << 41).raw(), 1 << 29);
        for den in numbers(62) {
            for num in
                [0, 1, den / 3, den / 2, den - 1, den, den.saturating_add(1), den.saturating_mul(2), u64::MAX >> 1]
            {
                check(ratio(num, den), num, den, &[num, den]);
            }
            // By a power of two it is exact.
            for shift in 0..den.leading_zeros() {
                assert_eq!(ratio(1, 1 << shift).raw(), (1u32 << 30).checked_shr(shift).unwrap_or(0), "{shift}");
            }
        }
    }

    #[test]
    fn gaps_fall_to_a_whole_root() {
        for root in numbers(60) {
            for into in numbers(60) {
                for left in [0, 1, into / 7, into / 2, into - 1, into] {
                    let gap = root + left;
                    check(gap_time(gap, into, sqr64(root)), left, into, &[gap, into, root]);
                }
            }
        }
    }

    #[test]
    fn exits_with_a_whole_root() {
        for root in numbers(58) {
            for b in numbers(58) {
                for cross in [0, 1, 1 << 40, -(1 << 57)] {
                    let (square, across) = (u128::from(root).pow(2), u128::from(i64::unsigned_abs(cross)).pow(2));
                    let sum = square + across;
                    let rra = ((sum >> 64) as u64, sum as u64);
                    let far = b + root;
                    for a in [far, far * 2 + 1, far / 2 + 1] {
                        check(exit_time(0, b as i64, a, rra, cross), far, a, &[b, a, root]);
                    }
                    for inner in [far / 3, far, far * 2] {
                        check(exit_time(inner, -(b as i64), 1, rra, cross), inner, far, &[inner, b, root]);
                    }
                    check(exit_time(root / 2, 0, 1, rra, cross), root / 2, root, &[root]);
                }
            }
        }
    }
}

mod side {
    use crate::query::cast::moment::is_below;

    #[test]
    fn heights_are_below_a_root_that_is_larger() {
        for height in [1u64, 5, 25 << 20, 1 << 31, u64::from(u32::MAX), 1 << 32, 3 << 32, (1 << 61) - 1] {
            let square = u128::from(height).pow(2);
            for (reach, below) in
                [(square - 1, false), (square, false), (square + 1, true), (1, false), (1 << 123, true)]
            {
                assert_eq!(is_below(height, ((reach >> 64) as u64, reach as u64)), below, "{height} {reach}");
            }
        }
        assert!(is_below(0, (0, 1)) && !is_below(0, (0, 0)));
    }
}
