//! Answers in canonical order, the first of them where room is short.

use crate::broad::cursor::Unlimited;
use crate::broad::spatial::Spatial;
use crate::broad::table::Bodies;
use crate::broad::{Handle, Pair, PairCursor, Tag};
use crate::error::Truncated;
use crate::shape::Aabb;
use heapless::{Vec, VecView};

/// The first ones, in an order, of items that come one after the other.
///
/// While there is room they are only stored. Where it ends they become a heap with the last one on top, which each one that goes before it replaces. Of n
/// items, k of them kept, that takes 2 n log2 k comparisons at most and sorting as many for the k: both bounded, in place.
pub(in crate::broad) struct First<'a, T, F> {
    out: &'a mut VecView<T>,
    /// A strict total order.
    before: F,
    seen: u32,
}

impl<'a, T: Copy, F: Fn(&T, &T) -> bool> First<'a, T, F> {
    /// Of an empty buffer.
    pub(in crate::broad) fn new(out: &'a mut VecView<T>, before: F) -> Self {
        Self { out, before, seen: 0 }
    }

    pub(in crate::broad) fn add(&mut self, item: T) {
        self.seen = self.seen.saturating_add(1);
        if self.out.push(item).is_ok() {
            if self.out.is_full() {
                heap(self.out, &self.before);
            }
        } else if let Some(last) = self.out.first_mut().filter(|last| (self.before)(&item, last)) {
            *last = item;
            sink(self.out, 0, &self.before);
        }
    }

    pub(in crate::broad) fn sort(self) -> Result<(), Truncated> {
        if !self.out.is_full() {
            heap(self.out, &self.before);
        }
        for end in (1..self.out.len()).rev() {
            if let Ok([last, place]) = self.out.get_disjoint_mut([0, end]) {
                core::mem::swap(last, place);
            }
            sink(self.out.get_mut(..end).unwrap_or_default(), 0, &self.before);
        }
        let kept = self.out.len() as u32;
        if kept == self.seen { Ok(()) } else { Err(Truncated { seen: self.seen, kept }) }
    }
}

fn heap<T: Copy>(items: &mut [T], before: &impl Fn(&T, &T) -> bool) {
    for place in (0..items.len() >> 1).rev() {
        sink(items, place, before);
    }
}

/// Puts an item where none below it goes after it.
///
/// First all the way down, the later one of two moving up, and then up again to its place, which mostly is near the bottom: half the comparisons of
/// looking for it from the top.
#[inline(never)]
fn sink<T: Copy>(items: &mut [T], top: usize, before: &impl Fn(&T, &T) -> bool) {
    let Some(&item) = items.get(top) else { return };
    let mut place = top;
    loop {
        let left = 2 * place + 1;
        let (child, value) = match (items.get(left), items.get(left + 1)) {
            (Some(a), Some(b)) if before(a, b) => (left + 1, *b),
            (Some(a), _) => (left, *a),
            (None, _) => break,
        };
        set(items, place, value);
        place = child;
    }
    while place > top {
        let parent = (place - 1) >> 1;
        let Some(&above) = items.get(parent).filter(|above| before(above, &item)) else { break };
        set(items, place, above);
        place = parent;
    }
    set(items, place, item);
}

fn set<T: Copy>(items: &mut [T], place: usize, item: T) {
    if let Some(of) = items.get_mut(place) {
        *of = item;
    }
}

impl<T: Tag> Bodies<'_, T> {
    /// Where a body stands in canonical order.
    pub(in crate::broad) fn rank(&self, handle: Handle) -> (u32, usize) {
        let slot = handle.slot();
        (self.tags.get(slot).map_or(0, Tag::key), slot)
    }
}

/// The pairs come in batches, because their keys cannot be asked for while the structure is being walked.
pub(in crate::broad) fn pairs<S: Spatial>(phase: &mut S, out: &mut VecView<Pair>) -> Result<(), Truncated> {
    out.clear();
    let (mut cursor, mut batch) = (PairCursor::new(), Vec::<Pair, 16>::new());
    let mut seen = 0u32;
    loop {
        batch.clear();
        let walked = phase.walk(&mut cursor, &mut Unlimited, |pair| batch.push(pair).is_ok());
        let bodies = phase.table();
        let mut first = First { out, before: |a: &Pair, b: &Pair| before(bodies, *a, *b), seen };
        for &pair in &batch {
            first.add(pair);
        }
        if walked.is_ok() || batch.is_empty() {
            return first.sort();
        }
        seen = first.seen;
    }
}

fn before<T: Tag>(bodies: Bodies<'_, T>, a: Pair, b: Pair) -> bool {
    let key = |handle: Handle| bodies.rank(handle).0;
    // Most pairs differ in their first body.
    let first = key(a.a).cmp(&key(b.a));
    first.then_with(|| key(a.b).cmp(&key(b.b)).then((a.a.slot(), a.b.slot()).cmp(&(b.a.slot(), b.b.slot())))).is_lt()
}

pub(in crate::broad) fn region<S: Spatial>(
    phase: &S,
    region: &Aabb,
    out: &mut VecView<Handle>,
) -> Result<(), Truncated> {
    out.clear();
    let bodies = phase.table();
    let mut first = First::new(out, |a: &Handle, b: &Handle| bodies.rank(*a) < bodies.rank(*b));
    phase.visit(region, |slot| first.add(bodies.handle(slot)));
    first.sort()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test")]
mod tests {
    use super::First;
    use crate::error::Truncated;
    use heapless::Vec;

    /// Every sequence of up to six of five numbers, told apart by their places, into room for none to seven.
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
        let mut first = First::new(&mut out, |a: &(u32, u32), b| a < b);
        for &item in items {
            first.add(item);
        }
        let told = first.sort();
        let mut expected = items.iter().copied().collect::<Vec<_, 6>>();
        expected.sort_unstable();
        let kept = expected.len().min(K);
        assert_eq!(out, expected.get(..kept).unwrap());
        let (seen, cut) = (items.len() as u32, items.len() > K);
        assert_eq!(told, if cut { Err(Truncated { seen, kept: kept as u32 }) } else { Ok(()) });
    }
}
