//! A plane of a touched surface, and how the surface bends there.

use crate::num::{Axis, Raw};
use crate::query::cast::side::along;

/// How a touched surface turns as the body moves along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    /// A face.
    Flat,
    /// The end of a face that a body is beside. Any side of the body may move along it.
    End,
    /// A corner, or an arc from outside: the normal points from its centre to the body.
    Convex,
    /// A quarter pipe of the quadrant of these signs. The body's point must stay within `room` of
    /// the centre.
    Concave { signs: (i8, i8), room: i32 },
}

impl Bend {
    /// A surface that bends more says more about how the body continues.
    pub(super) fn rank(self) -> u8 {
        match self {
            Self::End => 0,
            Self::Flat => 1,
            Self::Convex => 2,
            Self::Concave { .. } => 3,
        }
    }
}

/// A plane that a body may move along: the tangent of a touched surface.
///
/// Public in a private module, because a sealed trait's method names it.
#[derive(Clone, Copy, Debug, Eq)]
pub struct Plane {
    /// Out of the solid; not reduced at corners and arcs.
    pub(super) normal: Axis,
    pub(super) bend: Bend,
}

impl PartialEq for Plane {
    // One copy: three took 90 bytes more.
    #[inline(never)]
    fn eq(&self, other: &Self) -> bool {
        self.normal == other.normal && self.bend == other.bend
    }
}

impl Plane {
    pub(super) const fn flat(normal: Axis) -> Self {
        Self { normal, bend: Bend::Flat }
    }

    /// The end of a face, with no known side: it faces a velocity.
    pub(super) fn against(self, v: Raw) -> Self {
        let turns = self.bend == Bend::End && along(self.normal, v) > 0;
        if turns { Self { normal: self.normal.reversed(), ..self } } else { self }
    }
}
