//! What a body stands on.

use super::ground::Look;
use crate::error::RangeError;
use crate::motion::around::Around;
use crate::motion::run::Run;
use crate::motion::{Body, Hit, Moved, Mover};
use crate::num::{Axis, Vec2};
use crate::world::{Cell, Feature, World};

/// The floor under a body.
///
/// Plain data; where a body stands on several tiles of one height, their flags are or-ed and the cell is one of theirs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Support {
    /// The exact normal of the floor.
    pub axis: Axis,
    /// The cell of the level.
    pub cell: Cell,
    /// Which feature of the cell, as [`Feature::index`].
    pub index: u16,
    /// The user flags of the tiles or segments.
    pub flags: u8,
    /// Whether it is a one-way face.
    pub one_way: bool,
    /// Which level, as [`Feature::source`].
    pub source: u8,
}

impl Support {
    pub(super) fn of(axis: Axis, f: &Feature) -> Self {
        Self { axis, cell: f.cell, index: f.index, flags: f.flags, one_way: f.one_way, source: f.source }
    }
}

impl From<Hit> for Support {
    fn from(h: Hit) -> Self {
        Self { axis: h.axis, cell: h.cell, index: h.index, flags: h.flags, one_way: h.one_way, source: h.source }
    }
}

/// How far below a body a floor still carries it, raw: bodies come to rest at slopes and corners up to 2 raw early on each axis.
pub(in crate::motion) const CONTACT: i32 = 8;

impl Mover {
    /// The floor that carries a body which does not move: within 8 raw units of it, against "up".
    ///
    /// Floor is what the mover's slope limit says; one-way faces carry what is entirely above them, unless the mover drops through. A
    /// mover without an "up" has no floor.
    ///
    /// Cost: one sweep over the cells that the body touches.
    ///
    /// # Errors
    /// [`RangeError`] where a half extent or radius is not below 2^28 raw.
    pub fn supported<W: World, B: Body>(&self, world: &W, body: &B) -> Result<Option<Support>, RangeError> {
        body.check_size()?;
        let Some(up) = self.up else { return Ok(None) };
        let mut moved = Moved::freely(*body, Vec2::ZERO, 0);
        let mut around = Around::NOTHING;
        let mut run = Run::new(&mut moved, &mut around);
        run.pass_one_way = self.passes_one_way();
        Ok(run.floor_near(world, self, up))
    }
}
