//! Keeps slots in the order of the left sides of their boxes.

use crate::broad::Handle;
use crate::shape::Aabb;
use core::cell::Cell;

/// Puts the slots that are in use first, in the order that they have, the free ones behind, and counts them.
pub(in crate::broad) fn compact(order: &mut [u16], generations: &[u16]) -> u16 {
    let order = Cell::from_mut(order).as_slice_of_cells();
    let mut used = 0;
    for place in order {
        let slot = usize::from(place.get());
        let taken = generations.get(slot).is_some_and(|&generation| Handle::new(slot, generation).is_taken());
        if let Some(first) = order.get(usize::from(used)).filter(|_| taken) {
            first.swap(place);
            used += 1;
        }
    }
    used
}

/// Sorts by left sides: by insertion, which is fast where little has changed, until that took 8 shifts a slot; then by a heap.
#[inline(never)]
pub(in crate::broad) fn sort(order: &mut [u16], bounds: &[Aabb]) {
    let order = Cell::from_mut(order).as_slice_of_cells();
    let mut most = i32::MIN;
    let mut shifts = 8 * order.len();
    let mut rest = order.iter();
    while let Some(place) = rest.next() {
        let Some(body) = bounds.get(usize::from(place.get())) else { break };
        let key = body.lo().x;
        if key >= most {
            most = key;
            continue;
        }
        let sorted = order.get(..order.len() - rest.len()).unwrap_or_default();
        let Some(left) = shifts.checked_sub(insert(sorted, bounds, key)) else { return heap_sort(order, bounds) };
        shifts = left;
    }
}

/// Puts the last slot, whose key is given, where it belongs among the others: past how many of them.
#[inline(never)]
fn insert(order: &[Cell<u16>], bounds: &[Aabb], key: i32) -> usize {
    let Some((last, mut below)) = order.split_last() else { return 0 };
    let slot = last.get();
    let mut free = last;
    while let Some((before, rest)) = below.split_last() {
        let Some(body) = bounds.get(usize::from(before.get())) else { break };
        if body.lo().x <= key {
            break;
        }
        free.set(before.get());
        free = before;
        below = rest;
    }
    free.set(slot);
    order.len() - 1 - below.len()
}

#[inline]
fn left(bounds: &[Aabb], slot: u16) -> i32 {
    bounds.get(usize::from(slot)).map_or(i32::MAX, |b| b.lo().x)
}

/// Sorts whatever the order is: at most 2 N log2 N comparisons.
fn heap_sort(order: &[Cell<u16>], bounds: &[Aabb]) {
    for root in (0..order.len() / 2).rev() {
        sift_down(order, root, bounds);
    }
    let mut heap = order;
    while let [greatest, .., last] = heap {
        greatest.swap(last);
        heap = heap.get(..heap.len() - 1).unwrap_or_default();
        sift_down(heap, 0, bounds);
    }
}

/// Restores the heap below a root: no parent is less than its children.
fn sift_down(heap: &[Cell<u16>], mut root: usize, bounds: &[Aabb]) {
    let key = |place: &Cell<u16>| left(bounds, place.get());
    while let Some(parent) = heap.get(root) {
        let Some(mut child) = heap.get(2 * root + 1) else { return };
        root = 2 * root + 1;
        if let Some(other) = heap.get(root + 1).filter(|other| key(other) > key(child)) {
            child = other;
            root += 1;
        }
        if key(child) <= key(parent) {
            return;
        }
        parent.swap(child);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Raw;
    use std::vec::Vec;

    extern crate std;

    fn boxes(lefts: &[i32]) -> Vec<Aabb> {
        lefts.iter().map(|&x| Aabb::from_raw_unchecked(Raw { x, y: 0 }, Raw { x: x + 1, y: 1 })).collect()
    }

    /// The same slots, by left sides.
    fn check(order: &[u16], bounds: &[Aabb]) {
        assert!(order.is_sorted_by_key(|&slot| left(bounds, slot)), "{order:?}");
        let mut slots = order.to_vec();
        slots.sort_unstable();
        assert!(slots.iter().copied().eq(0..bounds.len() as u16));
    }

    /// Every sequence of up to 6 left sides out of 5, by both ways: all orders, all ties.
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

    /// Where it has to give up in the middle, where it has not, and at the border: i shifts for the i-th slot.
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
