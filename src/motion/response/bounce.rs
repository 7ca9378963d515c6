//! The bounces of a mover, which a program links only if one of its movers bounces.

use super::reply::{Rule, reply};
use super::surface::Surface;
use crate::motion::moved::{Hit, Hits};
use crate::num::{Axis, Raw};
use core::fmt;
use core::hash::{Hash, Hasher};

/// The reply to a velocity: [`reply`].
pub(in crate::motion) type ReplyFn = fn(Raw, Axis, &Rule) -> Raw;

/// What a mover that bounces calls: [`slides`] and [`reply`].
struct Functions {
    slides: fn(&Surface, (Raw, Axis), Option<&Hits>) -> bool,
    reply: ReplyFn,
}

/// Whether a mover bounces, and by which functions. It holds their addresses: a function that is
/// named directly would be linked even if nobody calls it.
#[derive(Clone, Copy, Default)]
pub(in crate::motion) struct Bounce(Option<&'static Functions>);

impl Bounce {
    pub(in crate::motion) const NONE: Self = Self(None);
    pub(in crate::motion) const LINKED: Self = Self(Some(&Functions { slides, reply }));

    /// The reply to a hit, unless that is a slide. `here` lists the hits so far, if the body has
    /// not moved since the last one.
    pub(in crate::motion) fn reply(self, surface: &Surface, hit: (Raw, Axis), here: Option<&Hits>) -> Option<ReplyFn> {
        self.0.filter(|functions| !(functions.slides)(surface, hit, here)).map(|functions| functions.reply)
    }
}

/// Whether a hit of a mover that bounces is a slide. It is if the surface [stops](Surface::stops)
/// the body, or faces another one that the body touches at the same place. Bounces between facing
/// surfaces would take no time, and never end.
fn slides(surface: &Surface, (v, normal): (Raw, Axis), here: Option<&Hits>) -> bool {
    let is_squeezed = |hits: &Hits| {
        let faces = |hit: &Hit| hit.axis == normal.reversed() && hits.last().is_some_and(|last| last.toi == hit.toi);
        hits.iter().any(faces)
    };
    surface.stops(v, normal) || here.is_some_and(is_squeezed)
}

/// The responses of a mover say whether the functions are called: linking them changes no answer.
impl PartialEq for Bounce {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for Bounce {}

/// Equal movers have equal hashes.
impl Hash for Bounce {
    fn hash<H: Hasher>(&self, _: &mut H) {}
}

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
