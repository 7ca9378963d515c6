//! Broad phases without cells: the order of left sides has to be one, or to be found again.

use super::slots::{Tenants, once};
use crate::broad::order::left;
use crate::broad::{BruteForce, SortSweep, Tag};
use crate::stored::{StoredForm, Version, Wrong, ensure, stored};
use heapless::Vec;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "T: Serialize", deserialize = "T: Deserialize<'de>"))]
struct PlainTable<T, const N: usize> {
    version: Version,
    table: Tenants<T, N>,
}

impl<const N: usize, T: Tag> StoredForm<BruteForce<N, T>> for PlainTable<T, N> {
    type Fault = Wrong;

    fn of(near: &BruteForce<N, T>) -> Self {
        Self { version: Version, table: Tenants::of(&near.table) }
    }

    fn check(self) -> Result<BruteForce<N, T>, Wrong> {
        Ok(BruteForce { table: self.table.check()? })
    }
}

#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "T: Serialize", deserialize = "T: Deserialize<'de>"))]
struct InOrder<T, const N: usize> {
    version: Version,
    table: Tenants<T, N>,
    /// Each slot that was ever taken, once.
    order: Vec<u16, N>,
    sorted: u16,
    stale: bool,
    epoch: u32,
}

impl<const N: usize, T: Tag> StoredForm<SortSweep<N, T>> for InOrder<T, N> {
    type Fault = Wrong;

    fn of(near: &SortSweep<N, T>) -> Self {
        let used = near.order.get(..near.table.bodies().bounds.len()).unwrap_or_default();
        let mut order = Vec::new();
        let all = order.extend_from_slice(used);
        debug_assert!(all.is_ok(), "it is as long as the array");
        let SortSweep { sorted, stale, epoch, .. } = *near;
        Self { version: Version, table: Tenants::of(&near.table), order, sorted, stale, epoch }
    }

    fn check(self) -> Result<SortSweep<N, T>, Wrong> {
        let Self { table, order, sorted, stale, epoch, .. } = self;
        let fresh = !table.moved;
        let mut near = SortSweep { table: table.check()?, sorted, stale, epoch, ..SortSweep::new() };
        let bodies = near.table.bodies();
        ensure(order.len() == bodies.bounds.len(), order.len(), "the order has other slots than were taken")?;
        once::<N>(&order, order.len())?;
        let (first, rest) = order
            .split_at_checked(usize::from(sorted))
            .ok_or(Wrong { at: usize::from(sorted), what: "more is sorted than there is" })?;
        let taken = |slot: u16| bodies.handle(usize::from(slot)).is_taken();
        // Rebuilds what is stale and sorts what moved. Uses the rest unchanged.
        let fresh = fresh && epoch == bodies.state.epoch;
        for &slot in rest.iter().filter(|_| !stale || fresh) {
            ensure(!taken(slot), usize::from(slot), "it is taken, and not in the order")?;
        }
        for &slot in first.iter().filter(|_| !stale) {
            ensure(taken(slot), usize::from(slot), "it is free, and in the order")?;
        }
        for pair in first.windows(2).filter(|_| fresh) {
            if let &[a, b] = pair {
                ensure(
                    left(bodies.bounds, a) <= left(bodies.bounds, b),
                    usize::from(b),
                    "the order is not that of left sides",
                )?;
            }
        }
        for (place, slot) in near.order.iter_mut().zip(&order) {
            *place = *slot;
        }
        Ok(near)
    }
}

stored!([const N: usize, T: Tag] BruteForce<N, T> as PlainTable<T, N>; T);

stored!([const N: usize, T: Tag] SortSweep<N, T> as InOrder<T, N>; T);
