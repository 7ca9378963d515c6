//! The path of a body through a level, and what lies on it.

use super::cell::{Block, Cells, Way};
use super::convex::ConvexBody;
use super::level::{Feature, MotionPiece, Seen, World, meets_as_world, sealed};
use super::lines::{BlockHit, Lines};
use super::probes::Probe;
use super::tangent::Tangent;
use super::tile_map::kind::Fill;
use crate::num::{Raw, Vec2};
use crate::shape::{Aabb, Circle};
use core::cell::Cell;

/// The straight parts of the path of a body in one call, in order.
///
/// [`Mover::move_along`](crate::Mover::move_along) writes it. [`TileMap::tiles_on`] and
/// [`Solids::on`] then list everything that the body passed: bump.lua's "cross", exact on every
/// part of a path that slides and bounces. Plain data, 40 bytes.
///
/// [`TileMap::tiles_on`]: crate::TileMap::tiles_on
/// [`Solids::on`]: crate::Solids::on
///
/// ```
/// use tilesat::world::Trail;
/// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let level = TileMap::from_ascii("....\n####", &KINDS)?; // the floor is at y = 16
/// let body = Aabb::new(Vec2::from_ints(4, 4), Vec2::from_ints(12, 12))?;
/// let mut trail = Trail::default();
/// Mover::platformer(Axis::NEG_Y).move_along(&level, &body, Vec2::from_ints(16, 8), &mut trail)?;
/// let parts: Vec<_> = trail.parts().collect();
/// assert_eq!(parts[0], (Vec2::ZERO, Vec2::from_ints(8, 4))); // down to the floor
/// assert_eq!(parts[1], (Vec2::from_ints(8, 4), Vec2::from_ints(8, 0))); // and along it
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "cross")]
pub struct Trail {
    parts: [Vec2; Trail::PARTS],
    len: u8,
}

impl Trail {
    /// The most straight parts of one call: one for each of the mover's
    /// [sweeps](crate::Mover::ITERATIONS).
    pub const PARTS: usize = 4;

    /// Each part: its start, relative to the start of the path, and its displacement.
    ///
    /// A body that stays has no parts.
    pub fn parts(&self) -> impl Iterator<Item = (Vec2, Vec2)> + Clone + use<> {
        let mut at = Vec2::ZERO;
        self.parts.into_iter().take(self.len.into()).map(move |by| {
            let from = at;
            at = at.saturating_add(by);
            (from, by)
        })
    }

    /// The parts; for a body that stays, one of length zero.
    pub(in crate::world) fn legs(&self) -> impl Iterator<Item = (Vec2, Vec2)> + Clone + use<> {
        self.parts().chain((self.len == 0).then_some((Vec2::ZERO, Vec2::ZERO)))
    }

    /// A path of one part.
    pub(crate) fn straight(by: Vec2) -> Self {
        let mut trail = Self::default();
        trail.push(by);
        trail
    }

    fn push(&mut self, by: Vec2) {
        if by == Vec2::ZERO {
            return;
        }
        if let Some(place) = self.parts.get_mut(usize::from(self.len)) {
            (*place, self.len) = (by, self.len + 1);
        } else if let Some(last) = self.parts.last_mut() {
            // A mover makes no fifth part. If anything else did, the end would stay exact.
            *last = last.saturating_add(by);
        }
    }
}

/// Another level, which also records the path of a mover. It answers as that level does.
pub(crate) struct Traced<'w, W> {
    world: &'w W,
    trail: Cell<Trail>,
}

impl<'w, W> Traced<'w, W> {
    pub(crate) fn new(world: &'w W) -> Self {
        Self { world, trail: Cell::new(Trail::default()) }
    }

    pub(crate) fn trail(&self) -> Trail {
        self.trail.get()
    }
}

impl<W> sealed::Sealed for Traced<'_, W> {}

meets_as_world! { [W: World] Traced<'_, W> }

impl<W: World> World for Traced<'_, W> {
    const BLOCKS: bool = W::BLOCKS;
    const ROUND: bool = W::ROUND;
    const WIDE: bool = W::WIDE;
    const CERTAIN: bool = W::CERTAIN;

    #[doc(hidden)]
    const ARCS: bool = W::ARCS;
    const GRID: bool = W::GRID;

    type Features<'f>
        = W::Features<'f>
    where
        Self: 'f;

    fn made(&self, by: Raw) {
        let mut trail = self.trail.get();
        trail.push(by.vec2());
        self.trail.set(trail);
    }

    fn features(&self, region: &Aabb) -> W::Features<'_> {
        self.world.features(region)
    }

    fn features_near(&self, region: &Aabb, joints: bool) -> W::Features<'_> {
        self.world.features_near(region, joints)
    }

    fn next_near(&self, features: &mut W::Features<'_>) -> Option<Feature> {
        self.world.next_near(features)
    }

    fn features_ahead(&self, way: &MotionPiece) -> W::Features<'_> {
        self.world.features_ahead(way)
    }

    fn cells(&self, region: &Aabb) -> Cells {
        self.world.cells(region)
    }

    fn next_cell(&self, cells: &mut Cells) -> Option<Block> {
        self.world.next_cell(cells)
    }

    fn way(&self, bounds: &Aabb, r: i32, d: Raw) -> Way {
        self.world.way(bounds, r, d)
    }

    fn next_strip(&self, way: &mut Way) {
        self.world.next_strip(way);
    }

    fn next_on_way(&self, way: &mut Way) -> Option<Block> {
        self.world.next_on_way(way)
    }

    fn lines(&self, bounds: &Aabb, d: Raw) -> Lines {
        self.world.lines(bounds, d)
    }

    fn starts_inside(&self, lines: &Lines, bounds: &Aabb) -> bool {
        self.world.starts_inside(lines, bounds)
    }

    fn next_block(&self, lines: &mut Lines, pass_one_way: bool, seen: &mut u32) -> Option<BlockHit> {
        self.world.next_block(lines, pass_one_way, seen)
    }

    fn corners(&self, block: &Block) -> (Raw, Raw) {
        self.world.corners(block)
    }

    fn features_of_cells(&self, region: &Aabb, d: Raw, joints: bool) -> W::Features<'_> {
        self.world.features_of_cells(region, d, joints)
    }

    fn enter(&self, features: &mut W::Features<'_>, block: &Block) {
        self.world.enter(features, block);
    }

    fn next_here(&self, features: &mut W::Features<'_>) -> Option<Feature> {
        self.world.next_here(features)
    }

    fn fill(&self, x: i32, y: i32) -> Fill {
        self.world.fill(x, y)
    }

    fn one_way_face(&self, block: &Block) -> Option<Feature> {
        self.world.one_way_face(block)
    }

    fn look(&self, region: &Aabb, r: i32, seen: &mut Seen) -> bool {
        self.world.look(region, r, seen)
    }

    fn is_behind(&self, region: &Aabb, r: i32, line: &Tangent) -> bool {
        self.world.is_behind(region, r, line)
    }

    fn cell_size(&self) -> u32 {
        self.world.cell_size()
    }

    fn most_cells(&self, width: u32, height: u32) -> u32 {
        self.world.most_cells(width, height)
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        self.world.overlaps_aabb(b)
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        self.world.overlaps_circle(c)
    }

    fn meets_convex(&self, body: &ConvexBody<'_>, closed: bool) -> bool {
        self.world.meets_convex(body, closed)
    }

    fn touches_aabb(&self, b: &Aabb) -> bool {
        self.world.touches_aabb(b)
    }

    fn touches_circle(&self, c: &Circle) -> bool {
        self.world.touches_circle(c)
    }

    fn flags_touched<P: Probe>(&self, shape: &P) -> u8 {
        self.world.flags_touched(shape)
    }
}
