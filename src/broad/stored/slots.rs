//! Handles, and the slots of a broad phase.

use crate::broad::table::{NIL, State, Table, dead};
use crate::broad::{Handle, Tag};
use crate::shape::Aabb;
use crate::stored::{StoredForm, Wrong, ensure, stored};
use heapless::Vec;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct Name {
    slot: u16,
    generation: u16,
}

impl StoredForm<Handle> for Name {
    type Fault = Wrong;

    fn of(handle: &Handle) -> Self {
        Self { slot: handle.slot() as u16, generation: handle.generation() }
    }

    fn check(self) -> Result<Handle, Wrong> {
        let at = usize::from(self.slot);
        let handle = Handle::new(at, self.generation);
        ensure(handle.is_taken(), at, "a generation that names a body is odd")?;
        Ok(handle)
    }
}

stored!(Handle as Name);

/// One slot that was ever taken.
#[derive(Serialize, Deserialize)]
enum Tenant<T> {
    /// With an odd generation.
    Body { generation: u16, bounds: Aabb, tag: T },
    /// With an even generation, the left side of its last body, and the next free slot.
    Nobody { generation: u16, left: i32, next: u16 },
}

/// The slots that were ever taken, and the first of those that are free.
#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "T: Serialize", deserialize = "T: Deserialize<'de>"))]
pub(super) struct Tenants<T, const N: usize> {
    slots: Vec<Tenant<T>, N>,
    free: u16,
    pub(super) moved: bool,
    epoch: u32,
}

impl<T: Tag, const N: usize> StoredForm<Table<T, N>> for Tenants<T, N> {
    type Fault = Wrong;

    fn of(table: &Table<T, N>) -> Self {
        let mut slots = Vec::new();
        let bodies = table.bodies();
        for (at, (bounds, &tag)) in bodies.bounds.iter().zip(bodies.tags).enumerate() {
            let handle = bodies.handle(at);
            let generation = handle.generation();
            let tenant = if handle.is_taken() {
                Tenant::Body { generation, bounds: *bounds, tag }
            } else {
                Tenant::Nobody { generation, left: bounds.lo().x, next: slot_of(bounds.hi().y as u16) }
            };
            let room = slots.push(tenant).is_ok();
            debug_assert!(room, "a table has at most N slots");
        }
        let State { free, moved, epoch, .. } = table.state;
        Self { slots, free: slot_of(free), moved, epoch }
    }

    fn check(self) -> Result<Table<T, N>, Wrong> {
        let Self { slots, free, moved, epoch } = self;
        let mut table = Table::new();
        let places = table.bounds.iter_mut().zip(&mut table.tags).zip(&mut table.generations);
        let mut len = 0;
        for (at, (tenant, ((place, own), known))) in slots.iter().zip(places).enumerate() {
            match *tenant {
                Tenant::Body { generation, bounds, tag } => {
                    ensure(Handle::new(at, generation).is_taken(), at, "it is taken, and its generation is even")?;
                    (*place, *own, *known) = (bounds, tag, generation);
                    len += 1;
                }
                Tenant::Nobody { generation, left, next } => {
                    ensure(!Handle::new(at, generation).is_taken(), at, "it is free, and its generation is odd")?;
                    (*place, *known) = (dead(left, link_to(next)), generation);
                }
            }
        }
        // A finite path along free slots visits none twice. So if it has the right length, it
        // visits each of them.
        let (mut next, mut left) = (free, slots.len() - usize::from(len));
        while next != NIL {
            let at = usize::from(next);
            let Some(Tenant::Nobody { next: then, .. }) = slots.get(at) else {
                return Err(Wrong { at, what: "the list of free slots leads here, and it is not free" });
            };
            let Some(rest) = left.checked_sub(1) else {
                return Err(Wrong { at, what: "the list of free slots leads here twice" });
            };
            (next, left) = (*then, rest);
        }
        ensure(left == 0, usize::from(free), "the list of free slots, which begins here, leaves some out")?;
        table.state = State { free: link_to(free), top: slots.len() as u16, len, moved, epoch };
        Ok(table)
    }
}

/// A table counts free slots from 1, and what is stored from 0, with NIL at the end.
const fn slot_of(link: u16) -> u16 {
    link.wrapping_sub(1)
}

const fn link_to(slot: u16) -> u16 {
    slot.wrapping_add(1)
}

/// Slots that come once each, all of them below `end`.
pub(super) fn once<const N: usize>(slots: &[u16], end: usize) -> Result<(), Wrong> {
    let mut seen = [false; N];
    for &slot in slots {
        let at = usize::from(slot);
        match seen.get_mut(at).filter(|_| at < end) {
            Some(seen) if !*seen => *seen = true,
            Some(_) => return Err(Wrong { at, what: "it is in the order twice" }),
            None => return Err(Wrong { at, what: "it is in the order, and was never taken" }),
        }
    }
    Ok(())
}
