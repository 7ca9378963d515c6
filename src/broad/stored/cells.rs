//! Broad phases with cells: the bodies are linked into their cells again, in an order that gives
//! the same lists.

use super::slots::{Tenants, once};
use crate::broad::cells::lists::Lists;
use crate::broad::cells::{Border, InCells, LooseGrid, SpatialHash};
use crate::broad::table::{Bodies, Spatial, Table};
use crate::broad::{BroadError, GridError, Tag};
use crate::num::{Fx, Vec2};
use crate::stored::{StoredForm, Version, Wrong, ensure, stored};
use core::fmt;
use heapless::Vec;
use serde::{Deserialize, Serialize};

/// Why a broad phase with cells is refused.
enum CellsFault {
    Wrong(Wrong),
    Grid(GridError),
    /// A body has no cell.
    Body(usize, BroadError),
}

impl From<Wrong> for CellsFault {
    fn from(e: Wrong) -> Self {
        Self::Wrong(e)
    }
}

impl From<GridError> for CellsFault {
    fn from(e: GridError) -> Self {
        Self::Grid(e)
    }
}

impl fmt::Display for CellsFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wrong(e) => e.fmt(f),
            Self::Grid(e) => e.fmt(f),
            Self::Body(at, e) => write!(f, "slot {at}: {e}"),
        }
    }
}

/// An enumeration may stand at a body that was removed since, and follow its links. These are not
/// stored, so it begins again, as after a move. A scene leaves no such links, so its flag stays as
/// it is.
fn tenants<T: Tag, const N: usize>(table: &Table<T, N>, lists: &Lists<'_>) -> Tenants<T, N> {
    let (mut tenants, bodies) = (Tenants::of(table), table.bodies());
    let left = |slot: usize| !bodies.handle(slot).is_taken() && lists.has_links(slot);
    tenants.moved |= (0..bodies.bounds.len()).any(left);
    tenants
}

/// The bodies of each list, first to last; list after list.
fn listed<const N: usize>(cells: &impl InCells) -> Vec<u16, N> {
    let lists = cells.lists();
    let heads = lists.heads.iter().chain(core::iter::once(&lists.large));
    heads.flat_map(|&head| lists.from(head)).map(|slot| slot as u16).take(N).collect()
}

/// Each is put before those of its list that were there.
fn link<const N: usize>(cells: &mut impl Spatial, order: &[u16]) -> Result<(), CellsFault> {
    let bodies = cells.table();
    once::<N>(order, bodies.bounds.len())?;
    let len = usize::from(bodies.state.len);
    ensure(order.len() == len, order.len(), "the order has more or fewer bodies than there are")?;
    for &slot in order.iter().rev() {
        let at = usize::from(slot);
        let bodies: Bodies<'_, _> = cells.table();
        let bounds = bodies.bounds.get(at).copied().filter(|_| bodies.handle(at).is_taken());
        let bounds = bounds.ok_or(Wrong { at, what: "it is in the order, and it is free" })?;
        let place = cells.admit(&bounds).map_err(|error| CellsFault::Body(at, error))?;
        cells.link(at, place);
    }
    Ok(())
}

#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "T: Serialize", deserialize = "T: Deserialize<'de>"))]
struct Bounded<T, const N: usize> {
    version: Version,
    origin: Vec2,
    cell: Fx,
    columns: u16,
    border: Border,
    table: Tenants<T, N>,
    order: Vec<u16, N>,
}

impl<const BLOCKS: usize, const N: usize, T: Tag, const LARGE: bool> StoredForm<LooseGrid<BLOCKS, N, T, LARGE>>
    for Bounded<T, N>
{
    type Fault = CellsFault;

    fn of(grid: &LooseGrid<BLOCKS, N, T, LARGE>) -> Self {
        Self {
            version: Version,
            origin: grid.lattice.origin.vec2(),
            cell: Fx::from_bits(grid.lattice.side()),
            columns: 1 << grid.rows.log_columns,
            border: grid.border,
            table: tenants(&grid.table, &grid.lists()),
            order: listed(grid),
        }
    }

    fn check(self) -> Result<LooseGrid<BLOCKS, N, T, LARGE>, CellsFault> {
        let mut grid = LooseGrid::new(self.origin, self.cell, self.columns)?;
        grid.table = self.table.check()?;
        // A refusing border refuses only later bodies.
        link::<N>(&mut grid, &self.order)?;
        Ok(grid.with_border(self.border))
    }
}

#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "T: Serialize", deserialize = "T: Deserialize<'de>"))]
struct Endless<T, const N: usize> {
    version: Version,
    cell: Fx,
    table: Tenants<T, N>,
    order: Vec<u16, N>,
}

impl<const BUCKETS: usize, const N: usize, T: Tag, const LARGE: bool> StoredForm<SpatialHash<BUCKETS, N, T, LARGE>>
    for Endless<T, N>
{
    type Fault = CellsFault;

    fn of(hash: &SpatialHash<BUCKETS, N, T, LARGE>) -> Self {
        Self {
            version: Version,
            cell: Fx::from_bits(hash.lattice.side()),
            table: tenants(&hash.table, &hash.lists()),
            order: listed(hash),
        }
    }

    fn check(self) -> Result<SpatialHash<BUCKETS, N, T, LARGE>, CellsFault> {
        let mut hash = SpatialHash::new(self.cell)?;
        hash.table = self.table.check()?;
        link::<N>(&mut hash, &self.order)?;
        Ok(hash)
    }
}

stored! {
    [const BLOCKS: usize, const N: usize, T: Tag, const LARGE: bool]
    LooseGrid<BLOCKS, N, T, LARGE> as Bounded<T, N>; T
}
stored! {
    [const BUCKETS: usize, const N: usize, T: Tag, const LARGE: bool]
    SpatialHash<BUCKETS, N, T, LARGE> as Endless<T, N>; T
}
