//! Distances and quotients of the world against wider numbers.

mod measure {
    use crate::num::usqr;
    use crate::world::measure::Measure;
    use crate::world::{AllShapes, Joined, SegmentMap, TileMap};
    use core::cmp::Ordering;

    type Tiles = TileMap<'static, AllShapes>;
    type Both = Joined<'static, Tiles, SegmentMap<'static>>;

    /// For a level with free lines, and for one of tiles if it can have both.
    fn order(a: Measure, b: Measure) -> Ordering {
        let free = |m: &Measure| matches!(m, Measure::Line { den, .. } if ![2, 5].contains(den));
        let order = a.order::<Both>(&b);
        if !free(&a) && !free(&b) {
            assert_eq!(a.order::<Tiles>(&b), order, "{a:?} {b:?}");
        }
        order
    }

    /// All small measures, compared by their values where those are apart, and as equal where they
    /// are so by construction.
    #[test]
    #[allow(
        clippy::cast_precision_loss,
        clippy::float_arithmetic,
        clippy::indexing_slicing,
        reason = "a test; values that differ do so by more than 1e-9"
    )]
    fn orders_as_the_values_do() {
        let at = |i: u64| {
            let (n, kind) = (i / 16, i % 16);
            match kind {
                0..11 => Measure::Ring { square: n, radius: 1 + kind as u32 },
                11 => Measure::root(n),
                _ => Measure::height(n / 4, [1, 2, 5, 13][kind as usize - 12]),
            }
        };
        let value = |m: &Measure| match *m {
            Measure::Point { square } => (square as f64).sqrt(),
            Measure::Line { front, den } => front as f64 / (den as f64).sqrt(),
            Measure::Ring { square, radius } => ((square as f64).sqrt() - f64::from(radius)).abs(),
        };
        for i in 0..16 * 160 {
            for j in 0..16 * 160 {
                let (a, b) = (at(i), at(j));
                let difference = value(&a) - value(&b);
                let expected = if difference.abs() < 1e-9 { Ordering::Equal } else { difference.total_cmp(&0.0) };
                assert_eq!(order(a, b), expected, "{a:?} {b:?}");
            }
        }
    }

    /// Exact ties and the least differences at the ends of the ranges.
    #[test]
    fn orders_large_measures() {
        let far = (1u64 << 30) - 1;
        for radius in [1u32, 1 << 16, (1 << 24) - 2] {
            // From (3k, 4k), 5k away.
            let k = far / 5;
            let (square, apart) = (25 * k * k, 5 * k - u64::from(radius));
            let ring = Measure::Ring { square, radius };
            // Directions with an integer length also have integer heights over lines.
            for length in [1u64, 2, 5, (1 << 30) - 35] {
                let height = |front| Measure::height(front, length * length);
                assert_eq!(order(ring, height(length * apart)), Ordering::Equal);
                assert_eq!(order(ring, height(length * apart + 1)), Ordering::Less);
                assert_eq!(order(height(length * apart - 1), ring), Ordering::Less);
                assert_eq!(order(height(length * apart), Measure::root(apart * apart)), Ordering::Equal);
                assert_eq!(order(height(length * apart), Measure::root(apart * apart - 1)), Ordering::Greater);
            }
            assert_eq!(order(ring, Measure::root(apart * apart)), Ordering::Equal);
            assert_eq!(order(ring, Measure::root(apart * apart + 1)), Ordering::Less);
            assert_eq!(order(Measure::root(apart * apart - 1), ring), Ordering::Less);
            assert_eq!(order(ring, Measure::Ring { square: square + 1, radius }), Ordering::Less);
            let inside = Measure::Ring { square: usqr(radius - 1), radius };
            assert_eq!(order(inside, Measure::root(1)), Ordering::Equal);
            assert_eq!(order(inside, Measure::Ring { square: usqr(radius + 1), radius }), Ordering::Equal);
            assert_eq!(order(inside, Measure::Ring { square: usqr(radius + 2), radius: radius + 1 }), Ordering::Equal);
            assert_eq!(order(ring, inside), Ordering::Greater);
            // A tile's slopes: the heights on both sides of sqrt(d) times the distance.
            for den in [2u64, 5] {
                let front = (den * apart * apart).isqrt();
                assert_eq!(order(Measure::height(front, den), ring), Ordering::Less);
                assert_eq!(order(Measure::height(front + 1, den), ring), Ordering::Greater);
            }
        }
    }
}

#[allow(clippy::expect_used, reason = "a test")]
mod grid {
    use crate::num::{Fx, Vec2};
    use crate::world::grid::Grid;

    /// The code of cores without a long product, at both sides of every line in the domain.
    #[test]
    fn quotients_by_words() {
        for cell in [258, 1000, 70_002, (1 << 17) - 2, 1_572_864, (1 << 24) - 2] {
            let grid = Grid::new(1, 1, Fx::from_bits(cell), Vec2::ZERO).expect("a grid");
            for index in 0..32_767.min((1 << 30) / cell as u32) {
                let d = index * cell as u32;
                for (d, expected) in [(d, index), (d + cell as u32 - 1, index), (d + cell as u32 / 2, index)] {
                    assert_eq!(grid.quotient_by_words(d), expected, "{d} / {cell}");
                }
            }
        }
    }
}
