//! The reply of a surface, for movers that bounce.

use super::reply::{Rule, reply};
use crate::num::{Axis, Raw};
use core::fmt;

/// What replies to a velocity: [`reply`], of which a program without a mover that bounces links nothing.
pub(in crate::motion) type Reply = fn(Raw, Axis, &Rule) -> Raw;

/// Whether a mover bounces, and by what. A function by its address: code that is named where nobody asks for it would be linked all the same.
#[derive(Clone, Copy, Default)]
pub(in crate::motion) struct Bounce(pub(in crate::motion) Option<Reply>);

impl Bounce {
    pub(in crate::motion) const NONE: Self = Self(None);
    pub(in crate::motion) const LINKED: Self = Self(Some(reply));
}

/// There is but one function, whose address may differ.
impl PartialEq for Bounce {
    fn eq(&self, other: &Self) -> bool {
        self.0.is_some() == other.0.is_some()
    }
}

impl Eq for Bounce {}

impl fmt::Debug for Bounce {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.is_some().fmt(f)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Bounce {
    fn format(&self, f: defmt::Formatter<'_>) {
        self.0.is_some().format(f);
    }
}
