//! The response of a body to a hit, and exceptions by the flags of surfaces.

/// How a body responds to a hit. The names are those of bump.lua.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Response {
    /// Slides along the surface.
    #[default]
    Slide,
    /// Stops at the first contact. Its velocity is then zero, and
    /// [`Moved::remaining`](crate::Moved::remaining) is the motion not made.
    Touch,
    /// Passes one-way faces, to drop through a platform, and slides along the solid.
    /// [`Moved::hits`](crate::Moved::hits) lists the first one-way face that it passes in a call.
    /// That face is neither floor, wall nor ceiling.
    ///
    /// Prefer [`Mover::with_drop_through`](crate::Mover::with_drop_through): it does the same with
    /// every response.
    DropThrough,
    /// Bounces off the surface like a mirror image: exact at a face along x or y. Elsewhere
    /// rounding may take up to 2 raw units of speed. It never gains speed.
    /// [`Mover::with_surface`](crate::Mover::with_surface) sets a weaker bounce, or bounces that do
    /// not lose those units.
    Bounce,
}

/// The response to all other surfaces. The mover's own is 0: a static [`Scene`](crate::Scene)
/// without bodies takes no flash then. As an `Option`, none would be 4.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(in crate::motion) enum Otherwise {
    #[default]
    Mover,
    Slide,
    Touch,
    DropThrough,
    Bounce,
}

impl Otherwise {
    const fn of(response: Response) -> Self {
        match response {
            Response::Slide => Self::Slide,
            Response::Touch => Self::Touch,
            Response::DropThrough => Self::DropThrough,
            Response::Bounce => Self::Bounce,
        }
    }

    const fn response(self) -> Option<Response> {
        match self {
            Self::Mover => None,
            Self::Slide => Some(Response::Slide),
            Self::Touch => Some(Response::Touch),
            Self::DropThrough => Some(Response::DropThrough),
            Self::Bounce => Some(Response::Bounce),
        }
    }
}

/// The responses to surfaces with flags, by the flags of the tile, the segment or the
/// [`Solid`](crate::Solid) that a body hits.
///
/// A surface with none of the flags receives the mover's [`Response`], unless the table has one for
/// [all others](Self::otherwise). With flags of several kinds, touching wins over bouncing, and
/// bouncing over sliding. The response applies to one hit: a body can bounce off a spring and slide
/// along the floor in the same call.
///
/// The table applies only to surfaces that stop the body. For tiles that a kind of body passes, use
/// [`TileKinds::passing`](crate::TileKinds::passing). For one-way faces, use
/// [`Mover::with_drop_through`](crate::Mover::with_drop_through).
///
/// ```
/// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2, motion::Responses};
/// const SPRING: u8 = 1;
/// const GLUE: u8 = 2;
/// static KINDS: TileKinds = TileKinds::EMPTY
///     .with(b'#', TileKind::FULL)
///     .with(b's', TileKind::FULL.with_flags(SPRING))
///     .with(b'g', TileKind::FULL.with_flags(GLUE));
/// const MOVER: Mover<tilesat::motion::ByFlags> =
///     Mover::platformer(Axis::NEG_Y).with_responses(Responses::NONE.bouncing(SPRING).touching(GLUE));
///
/// let level = TileMap::from_ascii("......\n##ssgg", &KINDS)?;
/// let body = |x| Aabb::new(Vec2::from_ints(x, 4), Vec2::from_ints(x + 8, 14));
/// let after = |x| MOVER.move_and_slide(&level, &body(x).unwrap(), Vec2::from_ints(3, 6)).map(|moved| moved.velocity);
/// assert_eq!(after(4)?, Vec2::from_ints(3, 0)); // the floor
/// assert_eq!(after(36)?, Vec2::from_ints(3, -6)); // the spring
/// assert_eq!(after(68)?, Vec2::ZERO); // the glue
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[doc(alias("collision filter", "filter", "response table"))]
pub struct Responses {
    pub(in crate::motion) touch: u8,
    pub(in crate::motion) bounce: u8,
    pub(in crate::motion) slide: u8,
    pub(in crate::motion) otherwise: Otherwise,
}

impl Responses {
    /// Every surface receives the mover's response.
    pub const NONE: Self = Self { touch: 0, bounce: 0, slide: 0, otherwise: Otherwise::Mover };

    /// The response to a surface with these flags, if the table has one.
    #[must_use]
    pub const fn response_to(self, flags: u8) -> Option<Response> {
        if flags & self.touch != 0 {
            Some(Response::Touch)
        } else if flags & self.bounce != 0 {
            Some(Response::Bounce)
        } else if flags & self.slide != 0 {
            Some(Response::Slide)
        } else {
            self.otherwise.response()
        }
    }

    /// Sets the response to surfaces with none of the flags, in place of the mover's. A bullet of a
    /// [`Scene`](crate::Scene) that stops at every wall has `Responses::NONE` with
    /// [`Response::Touch`] here.
    #[must_use]
    pub const fn otherwise(self, response: Response) -> Self {
        Self { otherwise: Otherwise::of(response), ..self }
    }

    /// Whether a surface can make a body bounce.
    pub(in crate::motion) const fn bounces(self) -> bool {
        self.bounce != 0 || matches!(self.otherwise, Otherwise::Bounce)
    }

    /// Adds [`Response::Touch`] for surfaces with any of these flags.
    #[must_use]
    pub const fn touching(self, flags: u8) -> Self {
        Self { touch: self.touch | flags, ..self }
    }

    /// Adds [`Response::Bounce`] for surfaces with any of these flags. The mover's
    /// [`Surface`](crate::Surface) says how much speed is returned.
    #[must_use]
    pub const fn bouncing(self, flags: u8) -> Self {
        Self { bounce: self.bounce | flags, ..self }
    }

    /// Adds [`Response::Slide`] for surfaces with any of these flags.
    #[must_use]
    pub const fn sliding(self, flags: u8) -> Self {
        Self { slide: self.slide | flags, ..self }
    }
}
