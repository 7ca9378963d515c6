//! Keeps slots in the order of the left sides of their boxes.

use super::Handle;
use crate::shape::Aabb;
use core::cell::Cell;

/// Puts the slots in use first, in their current order, and the free ones behind. Returns how many
/// are in use.
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

/// Sorts by left sides: by insertion, which is fast if little has changed, up to 8 shifts per slot;
/// then by a heap.
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

/// Inserts the last slot, with this key, among the others. Returns how many of them it passed.
#[inline(never)]
pub(in crate::broad) fn insert(order: &[Cell<u16>], bounds: &[Aabb], key: i32) -> usize {
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
pub(in crate::broad) fn left(bounds: &[Aabb], slot: u16) -> i32 {
    bounds.get(usize::from(slot)).map_or(i32::MAX, |b| b.lo().x)
}

/// Sorts whatever the order is: at most 2 N log2 N comparisons.
pub(in crate::broad) fn heap_sort(order: &[Cell<u16>], bounds: &[Aabb]) {
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
