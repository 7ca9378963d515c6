//! The results of a motion, and its hits.

use super::Body;
use super::slope_limit::SurfaceRole;
use crate::error::{RangeError, Truncated};
use crate::num::{Axis, Fx, Toi, Vec2};
use crate::world::{Cell, Feature};
use core::fmt;
use core::iter::{Chain, Flatten};
use core::slice::Iter;

/// The result of a motion: the new position, the new velocity and the hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias("KinematicCollision2D", "cols"))]
#[must_use = "the body moves only if you keep `Moved::body`"]
pub struct Moved<B> {
    /// The body at its new position. It does not overlap the level.
    pub body: B,
    /// The velocity after the response. Pass it to the next call.
    pub velocity: Vec2,
    /// The motion that is still to make, in units. It is the rest of a stopped body's motion, or
    /// what remains after [`Mover::ITERATIONS`](super::Mover::ITERATIONS) pieces: in a tight spot,
    /// or after that many bounces. A body that slides has none left, even if a wall took all of
    /// its motion. What a wall took is the velocity before, minus that after.
    pub remaining: Vec2,
    /// The hits, in order.
    pub hits: Hits,
    /// Whether a hit faced "up" within the mover's [slope limit](super::Mover::with_slope_limit),
    /// 45 degrees by default. Always false for a mover without an up. Only surfaces that the motion
    /// ran into count. A body without velocity reports no floor: add gravity in every frame, on the
    /// ground too.
    pub floor: bool,
    /// Whether a hit was neither floor nor ceiling, or a ceiling ended a walk.
    pub wall: bool,
    /// Whether a hit faced "down" within the same limit.
    pub ceiling: bool,
    /// The flags of all tiles that were hit, or-ed. Tiles that are not solid are never hit. For
    /// those use [`TileMap::flags_touched`](crate::TileMap::flags_touched), or
    /// [`TileMap::flags_swept`](crate::TileMap::flags_swept) at high speed.
    pub flags: u8,
    /// The work of the call.
    pub work: Work,
}

impl<B: Body> Moved<B> {
    /// A body that has hit nothing yet, after this many sweeps.
    #[inline]
    pub(super) fn freely(body: B, velocity: Vec2, iterations: u32) -> Self {
        Self {
            body,
            velocity,
            remaining: Vec2::ZERO,
            hits: Hits::none(),
            floor: false,
            wall: false,
            ceiling: false,
            flags: 0,
            work: Work { iterations, features: 0, checks: 0 },
        }
    }

    /// A body that slid along its only hit, of a surface with this role, or stayed there.
    #[inline(always)]
    pub(super) fn with_one(body: B, velocity: Vec2, (hit, side): (Hit, SurfaceRole), work: Work) -> Self {
        Self {
            body,
            velocity,
            remaining: Vec2::ZERO,
            hits: Hits::one(hit),
            floor: side == SurfaceRole::Floor,
            wall: side == SurfaceRole::Wall,
            ceiling: side == SurfaceRole::Ceiling,
            flags: hit.flags,
            work,
        }
    }

    /// Copies the result field by field, inline: a call of the compiler's copy routine would link
    /// 700 bytes.
    #[inline(always)]
    pub(super) fn copied(&self) -> Result<Self, super::MoveError> {
        let mut result = Ok(Self::freely(self.body, self.velocity, 0));
        if let Ok(to) = &mut result {
            to.remaining = self.remaining;
            (to.floor, to.wall, to.ceiling, to.flags, to.work) =
                (self.floor, self.wall, self.ceiling, self.flags, self.work);
            to.hits.seen = self.hits.seen;
            to.hits.early = self.hits.early;
            to.hits.late = self.hits.late;
        }
        result
    }

    /// Notes that the body met a surface of this role.
    pub(super) fn meet(&mut self, side: SurfaceRole) {
        match side {
            SurfaceRole::Floor => self.floor = true,
            SurfaceRole::Wall => self.wall = true,
            SurfaceRole::Ceiling => self.ceiling = true,
        }
    }

    /// The new position: the centre of a circle, the minimum corner of a box.
    #[must_use]
    pub fn position(&self) -> Vec2 {
        self.body.position()
    }
}

/// Counters of the work of a call, for budgets and tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Work {
    /// Sweeps of the whole remaining motion, at most
    /// [`Mover::ITERATIONS`](super::Mover::ITERATIONS).
    pub iterations: u32,
    /// Features that were swept against. For a box among blocks, the lines of the grid that it
    /// looked behind.
    pub features: u32,
    /// Exact overlap tests of the level.
    pub checks: u32,
}

/// The body overlaps the level before it moves, and nothing was moved. A call without velocity
/// moves nothing and does not look.
///
/// The level changed (a [door](crate::motion#doors) closed), or the game put the body into the
/// solid. If you want a way out, [`escape`](super::escape) pushes the body out by the nearest
/// surface that it reaches. It returns `Stuck` too if it reaches none, or none is free.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stuck {
    /// The position of the body, as [`Moved::position`], raw.
    pub at: (i32, i32),
}

/// Why a motion was refused. The body stays as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum MoveError {
    /// The velocity or the body is too large, the motion visits too many cells, or it would leave
    /// the domain.
    Range(RangeError),
    /// The body already overlaps the level.
    Stuck(Stuck),
}

impl From<Stuck> for MoveError {
    fn from(e: Stuck) -> Self {
        Self::Stuck(e)
    }
}

impl From<RangeError> for MoveError {
    fn from(e: RangeError) -> Self {
        Self::Range(e)
    }
}

impl fmt::Display for Stuck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (x, y) = self.at;
        let at = (Fx::from_bits(x), Fx::from_bits(y));
        write!(
            f,
            "the body at ({}, {}) = ({x}, {y}) raw overlaps the level: move it out, for example with `motion::escape`",
            at.0, at.1
        )
    }
}

impl core::error::Error for Stuck {}

impl fmt::Display for MoveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(e) => e.fmt(f),
            Self::Stuck(e) => e.fmt(f),
        }
    }
}

impl core::error::Error for MoveError {}

/// One hit of a moving body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
// The flag that distinguishes `None` from `Some` is behind the words. In front of them, the
// following fields would begin at an odd address: 8834 instructions for a hero's frame on a
// Cortex-M0, not 5658.
#[repr(C)]
pub struct Hit {
    /// The part of the motion made before the hit: a fraction of the motion, 0 to 1. It is exact,
    /// rounded down, for the first hit on a face along x or y, and for a box on a tile's slope.
    /// At other surfaces it may be early, by less than one raw unit of travel. A later hit of the
    /// same call adds the rounding of the earlier ones.
    pub toi: Toi,
    /// The exact normal of the surface: out of the solid, toward the body.
    pub axis: Axis,
    /// The cell of the level that was hit. For a moving solid it holds the key: see
    /// [`solid`](Self::solid).
    pub cell: Cell,
    /// Which feature of the cell, as [`Feature::index`](crate::world::Feature::index).
    pub index: u16,
    /// The user flags of the tile or segment.
    pub flags: u8,
    /// Whether it is a one-way face.
    pub one_way: bool,
    /// Which level, as [`Feature::source`](crate::world::Feature::source).
    pub source: u8,
}

impl Hit {
    /// The speed into the surface, in units per call: how hard the body hit. Use it for damage,
    /// dust and sounds.
    ///
    /// `velocity` is the velocity before the call; the events of a scene [contain
    /// it](crate::scene::SceneEvent::Level). For a surface that moves, subtract its velocity.
    /// Rounded as [`Axis::approach`].
    ///
    /// For a later hit of the same call, this is still the part of the whole velocity into its
    /// surface. If an earlier hit took a part of that, the body was slower.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Fx, Mover, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("....\n....\n####", &KINDS)?;
    /// let body = Aabb::new(Vec2::from_ints(4, 18), Vec2::from_ints(12, 28))?;
    /// let fall = Vec2::from_ints(2, 9);
    /// let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&level, &body, fall)?;
    /// assert_eq!(moved.hits.first().map(|hit| hit.approach(fall)), Some(Fx::from_num(9)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[doc(alias("impact speed", "normal impulse"))]
    pub const fn approach(&self, velocity: Vec2) -> Fx {
        self.axis.approach(velocity)
    }

    /// The key of the moving solid that was hit: a [`Solid`](crate::Solid) or a
    /// [`ConvexSolid`](crate::world::ConvexSolid). `None` for a tile or a segment.
    ///
    /// In a [joined](crate::Joined) level, [`source`](Self::source) distinguishes two lists.
    /// [`Mover::with_answers`](crate::Mover::with_answers) has an example.
    #[must_use]
    pub const fn solid(&self) -> Option<u16> {
        self.cell.solid()
    }

    pub(super) const fn of(axis: Axis, feature: &Feature, toi: Toi) -> Self {
        let Feature { cell, index, flags, one_way, source, .. } = *feature;
        Self { toi, axis, cell, index, flags, one_way, source }
    }
}

/// The hits of one motion in the order in which they happened, at most [`Hits::CAPACITY`].
///
/// Plain data: a copy is a snapshot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Hits {
    /// In halves: 48 bytes are made and copied inline, but 96 bytes by a library routine.
    early: [Option<Hit>; 2],
    late: [Option<Hit>; 2],
    seen: u8,
}

impl Hits {
    /// How many hits are kept: one per iteration.
    pub const CAPACITY: usize = 4;

    #[inline]
    pub(super) const fn none() -> Self {
        Self { early: [None; 2], late: [None; 2], seen: 0 }
    }

    #[inline]
    pub(crate) const fn one(hit: Hit) -> Self {
        Self { early: [Some(hit), None], late: [None; 2], seen: 1 }
    }

    /// The hits, if there are at most two.
    pub(crate) fn few(&self) -> Option<[Option<Hit>; 2]> {
        (self.seen <= 2).then_some(self.early)
    }

    /// The hits of [`few`](Self::few).
    pub(crate) fn of_few(early: [Option<Hit>; 2]) -> Self {
        Self { early, late: [None; 2], seen: early.iter().flatten().count() as u8 }
    }

    /// Whether the hits already report this feature, or one with the same normal. A face that is
    /// cut is therefore reported once.
    pub(super) fn already_lists(&self, axis: Axis, feature: &Feature) -> bool {
        let is = |hit: &Hit| (hit.cell, hit.index, hit.source) == (feature.cell, feature.index, feature.source);
        // Not by a chain of both halves, which takes 60 bytes more.
        [&self.early, &self.late].into_iter().any(|half| half.iter().flatten().any(|hit| hit.axis == axis || is(hit)))
    }

    /// The last hit that was kept.
    pub(super) fn last(&self) -> Option<&Hit> {
        let half = if self.seen <= 2 { &self.early } else { &self.late };
        let at = usize::from(self.seen.min(Self::CAPACITY as u8).wrapping_sub(1)) & 1;
        half.get(at)?.as_ref()
    }

    pub(super) fn push(&mut self, hit: Hit) {
        let half = if self.seen < 2 { &mut self.early } else { &mut self.late };
        if let Some(slot) = half.get_mut(usize::from(self.seen & 1)).filter(|_| self.seen < Self::CAPACITY as u8) {
            *slot = Some(hit);
        }
        self.seen = self.seen.saturating_add(1);
    }

    /// The hits, first to last.
    pub fn iter(&self) -> impl Iterator<Item = &Hit> {
        self.into_iter()
    }

    /// The number of hits kept.
    #[must_use]
    pub fn len(&self) -> usize {
        (self.seen as usize).min(Self::CAPACITY)
    }

    /// Whether the motion was free.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.seen == 0
    }

    /// The first hit.
    #[must_use]
    pub const fn first(&self) -> Option<Hit> {
        self.early[0]
    }

    /// Copies the hits into a vector of any capacity, first to last.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..#\n..#\n###", &KINDS)?;
    /// let body = Aabb::new(Vec2::from_ints(16, 16), Vec2::from_ints(24, 26))?;
    /// let moved = Mover::new().move_and_slide(&level, &body, Vec2::from_ints(16, 9))?;
    /// let mut log = heapless::Vec::<_, 8>::new(); // of several frames or bodies
    /// moved.hits.copy_to(&mut log)?;
    /// assert_eq!(log.iter().map(|hit| hit.axis).collect::<Vec<_>>(), [Axis::NEG_X, Axis::NEG_Y]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Truncated`] if they do not fit. `out` then holds the earliest.
    pub fn copy_to(&self, out: &mut heapless::VecView<Hit>) -> Result<(), Truncated> {
        for (kept, hit) in self.iter().enumerate() {
            if out.push(*hit).is_err() {
                return Err(Truncated { seen: self.seen.into(), kept: kept as u32 });
            }
        }
        Ok(())
    }
}

impl<'a> IntoIterator for &'a Hits {
    type Item = &'a Hit;
    type IntoIter = Flatten<Chain<Iter<'a, Option<Hit>>, Iter<'a, Option<Hit>>>>;
    fn into_iter(self) -> Self::IntoIter {
        self.early.iter().chain(&self.late).flatten()
    }
}
