//! Which cells share a list.

/// Factors for 2^6 to 2^15 buckets.
///
/// Two cells share a list where their distance (x, y) has `x + K y` a multiple of the buckets B. Such distances form a lattice; each of
/// these factors is odd (so no two cells of a column of B share one) and of all factors the one with the largest least `|x y|` among
/// those with neither 0: at least B / 4. The nearest to B times the golden ratio would do for some B only.
const FACTORS: [u16; 10] = [19, 47, 75, 149, 275, 791, 1557, 2431, 6229, 12031];

/// The factor for a number of buckets; refused by the compiler where there is none.
pub(in crate::broad) const fn factor(buckets: usize) -> u16 {
    assert!(
        buckets.is_power_of_two() && buckets >= 64 && buckets <= 32_768,
        "a spatial hash has a power of two of buckets, from 64 to 32768"
    );
    let (mut rest, mut log) = (FACTORS.as_slice(), buckets.trailing_zeros() - 6);
    loop {
        match rest {
            [first, ..] if log == 0 => return *first,
            [_, tail @ ..] => (rest, log) = (tail, log - 1),
            [] => return 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::factor;

    /// The claim, for every distance: two cells with a list in common are in one column or row at a multiple of all buckets, or else far apart.
    #[test]
    fn cells_that_share_a_list_are_far_apart() {
        for log in 6..=15 {
            let buckets = 1u64 << log;
            let factor = u64::from(factor(1 << log));
            for y in 1..buckets {
                let x = factor * y % buckets;
                assert!(x != 0, "a column");
                assert!(4 * x.min(buckets - x) * y.min(buckets - y) > buckets, "{buckets} buckets: ({x}, {y})");
            }
        }
    }
}
