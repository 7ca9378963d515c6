//! Names, order, and the bodies that are kept where room is short.

#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod handle {
    use crate::broad::{Handle, Pair};

    #[test]
    fn a_pair_knows_its_two() {
        let [a, b] = [Handle::new(3, 5), Handle::new(5, 3)];
        let pair = Pair { a, b };
        assert_eq!([a, b].map(|body| pair.other(body)), [Some(b), Some(a)]);
        assert!(pair.has(a) && pair.has(b));
        for stranger in [Handle::new(3, 3), Handle::new(5, 5), Handle::new(3, 7), Handle::new(4, 5)] {
            assert!(!pair.has(stranger) && pair.other(stranger).is_none());
        }
    }

    #[test]
    fn words_are_in_the_order_of_the_parts() {
        let ends = [0, 1, 0x7fff, 0x8000, 0xffff];
        let handle = |i: usize| Handle::new(usize::from(ends[i / 5 % 5]), ends[i % 5]);
        let parts = |h: &Handle| (h.slot(), h.generation());
        let pairs: [Pair; 625] = core::array::from_fn(|i| Pair { a: handle(i / 25), b: handle(i) });
        let both = |pair: &Pair| (parts(&pair.a), parts(&pair.b));
        for x in &pairs {
            assert_eq!(x.a.cmp(&x.b), parts(&x.a).cmp(&parts(&x.b)));
            for y in &pairs {
                assert_eq!(x.cmp(y), both(x).cmp(&both(y)));
                assert_eq!(x.partial_cmp(y), Some(x.cmp(y)));
            }
        }
    }
}

#[allow(clippy::unwrap_used, reason = "a test")]
mod ask {
    use crate::broad::ask::FirstFew;
    use crate::error::Truncated;
    use heapless::Vec;

    /// Every sequence of up to six of five numbers, told apart by their places, into room for none
    /// to seven.
    #[test]
    fn keeps_the_first_ones_sorted() {
        for len in 0..=6u32 {
            for code in 0..5u32.pow(len) {
                let items: Vec<(u32, u32), 6> = (0..len).map(|i| (code / 5u32.pow(i) % 5, i)).collect();
                check::<0>(&items);
                check::<1>(&items);
                check::<2>(&items);
                check::<3>(&items);
                check::<5>(&items);
                check::<6>(&items);
                check::<7>(&items);
            }
        }
    }

    fn check<const K: usize>(items: &[(u32, u32)]) {
        let mut out = Vec::<_, K>::new();
        let mut first = FirstFew::new(&mut out, |a: &(u32, u32), b| a < b);
        for &item in items {
            first.add(item);
        }
        let sorted = first.sort();
        let mut expected = items.iter().copied().collect::<Vec<_, 6>>();
        expected.sort_unstable();
        let kept = expected.len().min(K);
        assert_eq!(out, expected.get(..kept).unwrap());
        let (seen, cut) = (items.len() as u32, items.len() > K);
        assert_eq!(sorted, if cut { Err(Truncated { seen, kept: kept as u32 }) } else { Ok(()) });
    }
}

mod order {
    use crate::broad::order::{compact, heap_sort, insert, left, sort};
    use crate::num::Raw;
    use crate::shape::Aabb;
    use core::cell::Cell;
    use std::vec::Vec;

    extern crate std;

    fn boxes(lefts: &[i32]) -> Vec<Aabb> {
        lefts.iter().map(|&x| Aabb::from_raw_unchecked(Raw { x, y: 0 }, Raw { x: x + 1, y: 1 })).collect()
    }

    /// Checks that the slots are the same ones, in the order of their left sides.
    fn check(order: &[u16], bounds: &[Aabb]) {
        assert!(order.is_sorted_by_key(|&slot| left(bounds, slot)), "{order:?}");
        let mut slots = order.to_vec();
        slots.sort_unstable();
        assert!(slots.iter().copied().eq(0..bounds.len() as u16));
    }

    /// Every sequence of up to 6 left sides out of 5, sorted in both ways: all orders, all ties.
    #[test]
    fn all_small_orders() {
        for n in 0..=6 {
            for code in 0..5_i32.pow(n) {
                let lefts: Vec<_> = (0..n).map(|i| code / 5_i32.pow(i) % 5).collect();
                let bounds = boxes(&lefts);
                let mut order: Vec<_> = (0..n as u16).collect();
                sort(&mut order, &bounds);
                check(&order, &bounds);
                let mut order: Vec<_> = (0..n as u16).collect();
                heap_sort(Cell::from_mut(&mut *order).as_slice_of_cells(), &bounds);
                check(&order, &bounds);
            }
        }
    }

    /// Reversed orders, which take i shifts for the i-th slot. The sort has to give up in the
    /// middle, does not have to, or is at the border.
    #[test]
    fn backwards() {
        for n in [1, 2, 16, 17, 18, 19, 40, 1000] {
            let bounds = boxes(&(0..n).rev().collect::<Vec<_>>());
            let mut order: Vec<_> = (0..n as u16).collect();
            sort(&mut order, &bounds);
            check(&order, &bounds);
        }
    }

    #[test]
    fn insertion_counts_what_it_passes() {
        for passed in 0..6_u16 {
            let bounds = boxes(&[0, 2, 4, 6, 8, 9 - 2 * i32::from(passed)]);
            let mut order: Vec<_> = (0..6).collect();
            let cells = Cell::from_mut(&mut *order).as_slice_of_cells();
            assert_eq!(insert(cells, &bounds, left(&bounds, 5)), usize::from(passed));
            check(&order, &bounds);
        }
    }

    /// Every set of six slots that are in use, in a shuffled order.
    #[test]
    fn compact_keeps_the_order() {
        let order = [3, 0, 5, 1, 4, 2];
        for used in 0..64 {
            let generations: Vec<u16> = (0..6).map(|slot| 6 + (used >> slot & 1)).collect();
            let (mut now, mut expected) = (order, order.to_vec());
            let n = usize::from(compact(&mut now, &generations));
            expected.retain(|&slot| used >> slot & 1 == 1);
            assert_eq!(now.get(..n), Some(&*expected));
            now.sort_unstable();
            assert_eq!(now, [0, 1, 2, 3, 4, 5]);
        }
    }
}
