//! The surfaces that a mover can have: without friction or with it, and with separate responses to
//! some hits.

use super::surface::Surface;
use super::table::{Response, Responses};
use crate::motion::moved::Hit;
use crate::world::sealed::Sealed;

/// How surfaces affect a mover's bodies: [`Smooth`], which links no code for friction and
/// restitution, or a [`Surface`].
pub trait Law: Sealed + Copy {
    /// Whether there is neither friction nor a loss.
    const SMOOTH: bool;
    /// The surface.
    fn surface(&self) -> &Surface;
    /// The response to a hit, if it is not the mover's.
    #[inline]
    fn response_to(&self, hit: &Hit) -> Option<Response> {
        self.responses().response_to(hit.flags)
    }
    /// The responses to surfaces with flags.
    fn responses(&self) -> Responses {
        Responses::NONE
    }
}

/// A surface without responses by hit: [`Smooth`] or a [`Surface`].
///
/// Only a mover that has one of them takes another
/// [`with_surface`](crate::Mover::with_surface). A table or function of responses would be lost.
pub trait Plain: Law {}

impl Plain for Smooth {}
impl Plain for Surface {}

/// No friction, and bounces that lose only roundings: the default of a
/// [`Mover`](crate::motion::Mover).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Smooth;

impl Sealed for Smooth {}

impl Law for Smooth {
    const SMOOTH: bool = true;
    fn surface(&self) -> &Surface {
        &Surface::ELASTIC
    }
}

impl Law for Surface {
    const SMOOTH: bool = false;
    fn surface(&self) -> &Surface {
        self
    }
}

/// The surface of a mover that [responds by a function](crate::Mover::with_answers).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ByHit<F, S = Smooth> {
    pub(in crate::motion) surface: S,
    pub(in crate::motion) answers: F,
}

impl<F, S> Sealed for ByHit<F, S> {}

impl<F: Fn(&Hit) -> Option<Response> + Copy, S: Law> Law for ByHit<F, S> {
    const SMOOTH: bool = S::SMOOTH;
    fn surface(&self) -> &Surface {
        self.surface.surface()
    }
    fn response_to(&self, hit: &Hit) -> Option<Response> {
        (self.answers)(hit)
    }
}

/// The surface of a mover that [responds by flags](crate::Mover::with_responses).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ByFlags<S = Smooth> {
    pub(in crate::motion) surface: S,
    pub(in crate::motion) responses: Responses,
}

impl<S: Law> Sealed for ByFlags<S> {}

impl<S: Law> Law for ByFlags<S> {
    const SMOOTH: bool = S::SMOOTH;
    fn surface(&self) -> &Surface {
        self.surface.surface()
    }
    fn responses(&self) -> Responses {
        self.responses
    }
}
