//! The search for the first hit of a motion: the known parts of the level, the parts to examine,
//! and their order.

use super::body::{Body, Entry, is_by_lines};
use super::order::First;
use super::plane::{into, way};
use crate::error::{Quantity, RangeError};
use crate::num::{Axis, DOMAIN, Raw, leading_zeros32, umul};
use crate::shape::Aabb;
use crate::world::{ANY_BODY, Cells, Geometry, MotionPiece, Seen, World};

/// A region that was looked at, and the part of it that may hold something.
///
/// Most starts, ends and slides need only comparisons with the box around that part. Bodies without
/// area have no inside: theirs are [grown](hull) by a raw unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Around {
    region: Aabb,
    seen: Seen,
}

/// The contents that a region may have.
pub(super) struct Held {
    pub(super) bounds: Aabb,
    /// The cells that the inside of the bounds meets, if they are known.
    pub(super) cells: Option<Cells>,
}

impl Around {
    /// Nothing is known: no box is inside of this one. A constant would be copied as a whole.
    #[inline]
    pub(super) const fn nothing() -> Self {
        let region = Aabb::from_raw_unchecked(Raw { x: 1, y: 1 }, Raw { x: 0, y: 0 });
        Self { region, seen: Seen { held: None, cells: None } }
    }

    /// Looks at the region that a body passes in one of the pieces of a motion, unless it is
    /// already known. Returns the region.
    pub(super) fn look<W: World>(&mut self, world: &W, bounds: &Aabb, from: Raw, to: Raw, pieces: u32) -> Aabb {
        let region = piece_of(bounds, from, to, pieces);
        if !self.has_seen(&region) {
            self.region = region;
            world.look(&self.region, ANY_BODY, &mut self.seen);
        }
        region
    }

    /// In how many [pieces] the cells under the motion of a call are visited. Returns 0 if the body
    /// meets nothing on its whole motion, as most bodies do. Only this first look distinguishes the
    /// cells that the body passes. In later looks the body is near what it has met, and that took 3
    /// % more instructions than it saved. Unless it `looks`, and for a box among blocks, any number
    /// above 1 stands for several.
    ///
    /// # Errors
    /// If the motion visits too many cells.
    #[inline(always)]
    pub(super) fn begin<W: World, B: Body>(
        &mut self,
        world: &W,
        body: &B,
        d: Raw,
        looks: bool,
    ) -> Result<u32, RangeError> {
        let (bounds, side) = (body.bounds(), body.extent());
        check_cells(world, side, d)?;
        // Most motions are one piece, and this is all that most bodies run.
        let is_one = way(d) <= piece_length(world, side);
        // As [`piece_of`], with the extent at hand: by that function it is 0.5 to 2 % more.
        let piece = |to: Raw, margin: i32| hull(&bounds, Raw::ZERO, to, margin);
        if is_by_lines::<W, B>() || (!is_one && !looks) {
            let empty = world.is_known_empty(&piece(d, margin(side)));
            return Ok(if empty { 0 } else { 2 });
        }
        self.region = if is_one { piece(d, margin(side)) } else { piece(Raw::ZERO, 1) };
        let inside = world.look(&self.region, body.rounding(), &mut self.seen);
        if !is_one {
            return Ok(pieces(world, side, d));
        }
        Ok(u32::from(!self.is_empty() || !(inside || is_inside(&self.region))))
    }

    /// The contents that a known region may have. If its cells are known, only they count.
    pub(super) fn held_of(&self, region: &Aabb) -> Option<Held> {
        let cells = if *region == self.region { self.seen.cells } else { None };
        let bounds = if cells.is_some() { self.seen.held } else { self.held_in(region) };
        Some(Held { bounds: bounds?, cells })
    }

    /// The cells of [`held_of`](Self::held_of) in a grid. Copies of its bounds would take 150
    /// bytes.
    fn cells_of<W: World>(&self, world: &W, region: &Aabb) -> Option<Cells> {
        match self.known_cells() {
            Some(cells) if *region == self.region => Some(cells),
            _ => Some(world.cells(&self.held_in(region)?)),
        }
    }

    /// The cells in all of the known region, if they are known and there are any.
    pub(super) fn known_cells(&self) -> Option<Cells> {
        if self.seen.held.is_some() { self.seen.cells } else { None }
    }

    /// The part of a known region that may hold something.
    fn held_in(&self, region: &Aabb) -> Option<Aabb> {
        let (held, a, b) = (self.seen.held?, region.lo(), region.hi());
        let lo = Raw { x: a.x.max(held.lo().x), y: a.y.max(held.lo().y) };
        let hi = Raw { x: b.x.min(held.hi().x), y: b.y.min(held.hi().y) };
        (lo.x < hi.x && lo.y < hi.y).then_some(Aabb::from_raw_unchecked(lo, hi))
    }

    /// The part of the known region that may hold something.
    pub(super) fn held(&self) -> Option<&Aabb> {
        self.seen.held.as_ref()
    }

    /// Whether the region that was looked at is inside the domain.
    pub(super) fn is_inside(&self) -> bool {
        is_inside(&self.region)
    }

    /// Whether the region that was looked at is empty.
    pub(super) fn is_empty(&self) -> bool {
        self.seen.held.is_none()
    }

    /// Whether a region is known to be empty.
    pub(super) fn is_free(&self, region: &Aabb) -> bool {
        self.has_seen(region) && self.is_free_in_sight(region)
    }

    /// [`is_free`](Self::is_free) for a region that is known.
    pub(super) fn is_free_in_sight(&self, region: &Aabb) -> bool {
        self.seen.held.is_none_or(|held| {
            let ((a, b), (lo, hi)) = ((region.lo(), region.hi()), (held.lo(), held.hi()));
            b.x <= lo.x || a.x >= hi.x || b.y <= lo.y || a.y >= hi.y
        })
    }

    fn has_seen(&self, region: &Aabb) -> bool {
        let ((a, b), (lo, hi)) = ((region.lo(), region.hi()), (self.region.lo(), self.region.hi()));
        a.x >= lo.x && b.x <= hi.x && a.y >= lo.y && b.y <= hi.y
    }
}

/// Whether a box is inside the domain.
fn is_inside(region: &Aabb) -> bool {
    let (lo, hi) = (region.lo(), region.hi());
    lo.x.min(lo.y) > -DOMAIN && hi.x.max(hi.y) < DOMAIN
}

/// How much bounds without area, by their width and height, are grown to have an inside.
pub(super) fn margin(extent: Raw) -> i32 {
    // One of them is below 1. Two comparisons take 7 of 428 instructions of a box that flies.
    ((extent.x.wrapping_sub(1) | extent.y.wrapping_sub(1)) as u32 >> 31) as i32
}

/// The box that the inside of the bounds covers between two displacements, `margin` raw units
/// larger on every side.
pub(super) fn hull(bounds: &Aabb, from: Raw, to: Raw, margin: i32) -> Aabb {
    let (a, b) = (bounds.lo(), bounds.hi());
    let lo = Raw { x: a.x + from.x.min(to.x) - margin, y: a.y + from.y.min(to.y) - margin };
    let hi = Raw { x: b.x + from.x.max(to.x) + margin, y: b.y + from.y.max(to.y) + margin };
    Aabb::from_raw_unchecked(lo, hi)
}

/// The conditions of the first hit of a body's motion, besides the level.
pub(super) struct Search<'a, B> {
    pub(super) body: &'a B,
    pub(super) around: &'a mut Around,
    /// Whether one-way faces are no hits.
    pub(super) pass_one_way: bool,
    /// A velocity: only surfaces that oppose it are hits.
    pub(super) pressed: Option<Raw>,
    /// How many features were swept against.
    pub(super) features: u32,
    /// Whether one-way faces that may be askew are near.
    pub(super) guarded: bool,
}

impl<'a, B: Body> Search<'a, B> {
    pub(super) fn new(body: &'a B, around: &'a mut Around) -> Self {
        Self { body, around, pass_one_way: false, pressed: None, features: 0, guarded: false }
    }

    /// Looks for the first hit of the motion. Visiting cells piece by piece keeps the work linear
    /// in the motion's length. The sweeps themselves always see the whole motion.
    #[inline(never)]
    pub(super) fn find_first<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
        if is_by_lines::<W, B>() {
            return self.find_by_lines(world, d, first);
        }
        self.find_in_pieces(world, pieces(world, self.body.extent(), d), d, first);
        self.find_cusp(world, d, first);
    }

    /// [`find_first`](Self::find_first) for a motion in `pieces` pieces. If it is one, the level
    /// has been looked at.
    #[inline(always)]
    pub(super) fn find_first_in<W: World>(&mut self, world: &W, pieces: u32, d: Raw, first: &mut First) {
        match self.around.known_cells() {
            Some(mut cells) if W::GRID && pieces == 1 => {
                self.meet_cells(world, &mut cells, d, first);
            }
            _ => self.find_in_pieces(world, pieces, d, first),
        }
        self.find_cusp(world, d, first);
    }

    /// [`find_first`](Self::find_first) in a grid, strip by strip. Returns whether a cell of the
    /// first strip, in which the body starts, may hold something.
    ///
    /// Strips visit each cell once, so long casts take up to 15 % fewer instructions. Movers do
    /// without: the code of strips would add 1 000 bytes to each of them, and 1 % to short motions.
    #[inline(never)]
    pub(super) fn find_on_way<W: World>(&mut self, world: &W, d: Raw, first: &mut First) -> bool {
        if is_by_lines::<W, B>() {
            self.find_by_lines(world, d, first);
            return true;
        }
        let mut way = world.way(&self.body.bounds(), self.body.rounding(), d);
        self.meet_cells(world, &mut way, d, first);
        self.find_cusp(world, d, first);
        way.starts_beside()
    }

    #[inline]
    pub(super) fn find_cusp<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
        if W::ROUND && self.may_meet_cusp(d) {
            self.meet_cusp(world, d, first);
        }
    }

    #[inline(never)]
    fn find_in_pieces<W: World>(&mut self, world: &W, pieces: u32, d: Raw, first: &mut First) {
        let bounds = self.body.bounds();
        let (mut from, mut before) = (Raw::ZERO, None);
        for piece in 1..=pieces {
            let to = part(d, piece, pieces);
            let region = self.around.look(world, &bounds, from, to, pieces);
            from = to;
            if W::GRID {
                if let Some(cells) = &mut self.around.cells_of(world, &region) {
                    self.meet_cells(world, cells, d, first);
                }
            } else {
                let held = self.around.held_of(&region);
                if let Some(held) = &held {
                    self.meet_features(world, held, before.as_ref(), d, first);
                }
                before = held.map(|held| held.bounds);
            }
            // Later pieces hold only later hits.
            if first.is_within(piece, pieces) {
                break;
            }
        }
    }

    /// Takes the hits of the features of a piece of the motion.
    #[inline(never)]
    fn meet_features<W: World>(&mut self, world: &W, held: &Held, before: Option<&Aabb>, d: Raw, first: &mut First) {
        self.meet_all(world, &mut self.ahead(world, held, before, d), d, first);
    }

    /// The features ahead in a piece of the motion.
    pub(super) fn ahead<'w, W: World>(
        &self,
        world: &'w W,
        held: &Held,
        before: Option<&Aabb>,
        d: Raw,
    ) -> W::Features<'w> {
        if B::NOTCHED {
            return world.features(&held.bounds);
        }
        let (whole, joints) = (hull(&self.body.bounds(), Raw::ZERO, d, 1), self.body.meets_joints());
        world.features_ahead(&MotionPiece { piece: &held.bounds, cells: held.cells, before, whole, d, joints })
    }

    /// Takes the hits of all features that a cursor returns; in a grid, of its current cell.
    #[inline(never)]
    pub(super) fn meet_all<W: World>(&mut self, world: &W, features: &mut W::Features<'_>, d: Raw, first: &mut First) {
        let body = self.body;
        // By reference: copies of features and entries would be most of the stack.
        while let Some(feature) = &if W::GRID { world.next_here(features) } else { features.next() } {
            self.features += 1;
            if feature.one_way && self.pass_one_way {
                continue;
            }
            self.guarded |= !W::BLOCKS && feature.one_way;
            let Some(entry) = &body.sweep_in::<W>(d, feature) else { continue };
            if !W::BLOCKS && self.pressed.is_some_and(|v| into(v, entry.normal) >= 0) {
                continue;
            }
            first.add::<B, W>(entry, feature, d);
        }
    }
}

/// `d * k / n`, rounded toward zero, for a power of two n and k up to n.
fn part(d: Raw, k: u32, n: u32) -> Raw {
    if k == n {
        return d;
    }
    let of = |c: i32| {
        // As words: n is more than one, and the result fits one.
        let (log, size) = ((31 - leading_zeros32(n)) & 31, umul(c.unsigned_abs(), k));
        let size = ((size >> 32) as u32) << ((32 - log) & 31) | size as u32 >> log;
        if c < 0 { (size as i32).wrapping_neg() } else { size as i32 }
    };
    Raw { x: of(d.x), y: of(d.y) }
}

/// In how many pieces, a power of two, the cells under a motion are visited. A piece is no shorter
/// than the body, or each would visit the body's own cells again. Up to half as long again is one
/// piece: one more look-up costs less than another start. At most 2^21, for a motion below 2^29 in
/// cells of 2^8.
pub(super) fn pieces<W: World>(world: &W, side: Raw, d: Raw) -> u32 {
    let (longest, length) = (way(d), piece_length(world, side));
    let mut log = 0;
    while longest >> log > length {
        log += 1;
    }
    1 << log
}

/// The longest motion that is one piece.
#[inline]
fn piece_length<W: World>(world: &W, side: Raw) -> u32 {
    let length = world.cell_size().max(side.x.max(side.y) as u32);
    length + (length >> 1)
}

/// The most cells that a motion visits: [`Mover::CELLS`](crate::Mover::CELLS).
pub(super) const CELLS: u32 = 1 << 18;

/// Refuses a motion that visits more than [`CELLS`] cells.
///
/// A hull of up to 256 cells a side never does. In one piece it meets at most 258 squared, in
/// pieces longer than the body fewer.
#[inline]
pub(super) fn check_cells<W: World>(world: &W, side: Raw, d: Raw) -> Result<(), RangeError> {
    let longest = (side.x.max(side.y) as u32).wrapping_add(way(d));
    if longest >> 8 < world.cell_size() { Ok(()) } else { count_cells(world, side, d) }
}

#[inline(never)]
fn count_cells<W: World>(world: &W, side: Raw, d: Raw) -> Result<(), RangeError> {
    let pieces = pieces(world, side, d);
    let part = part(d, 1, pieces);
    let along = |side: i32, part: i32| (side as u32).wrapping_add(part.unsigned_abs()).wrapping_add(3);
    let cells = umul(world.most_cells(along(side.x, part.x), along(side.y, part.y)), pieces);
    if cells <= u64::from(CELLS) {
        return Ok(());
    }
    Err(RangeError { what: Quantity::Cells, value: cells.min(i32::MAX as u64) as i32 })
}

/// The box that the inside of the bounds covers in one of the pieces of a motion. With several
/// pieces, displacements are rounded, and the box is a raw unit larger.
pub(super) fn piece_of(bounds: &Aabb, from: Raw, to: Raw, pieces: u32) -> Aabb {
    hull(bounds, from, to, if pieces == 1 { margin(Raw::of(bounds.size())) } else { 1 })
}

/// The box that the inside of a body covers where it is.
pub(super) fn box_here<B: Body>(body: &B) -> Aabb {
    hull(&body.bounds(), Raw::ZERO, Raw::ZERO, margin(body.extent()))
}

impl<B: Body> Search<'_, B> {
    /// Handles the end of an arc at which a body without extent across its motion enters the solid.
    /// Takes the first such end that precedes all other hits.
    ///
    /// The gap between a convex arc and the surface that it touches closes to nothing. Both are
    /// tangent to the motion, and the solid behind the end of the arc has no face there. A quarter
    /// pipe ends on the line of the wall beside it, where a body that comes down the wall passes
    /// the arc. Only a motion along x or y reaches either.
    ///
    /// From the end on, the body is inside of the solid, or outside of it, for at least half a
    /// cell. The test therefore looks a raw unit farther. If the solid has a face there, the face
    /// is hit at the same moment.
    ///
    /// ```text
    ///       ....          the arc ends at P along the motion; the floor   ....|o         the pipe ends at P, across the motion
    ///   .solid..`.        and the solid above it continue behind P        wall|V       .
    ///   ..........P<--- o                                                 ....P    . `
    ///   .......solid.....                                                 ......solid..
    /// ```
    #[inline(never)]
    fn meet_cusp<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
        let bounds = self.body.bounds();
        let (lo, hi) = (bounds.lo(), bounds.hi());
        let front = Raw { x: if d.x > 0 { hi.x } else { lo.x }, y: if d.y > 0 { hi.y } else { lo.y } };
        let step = Raw { x: d.x.signum(), y: d.y.signum() };
        let mut features = world.features(&hull(&bounds, Raw::ZERO, d, 1));
        while let Some(feature) = &features.next() {
            self.features += 1;
            let Geometry::Arc { centre, radius, quadrant, convex } = feature.geometry else { continue };
            let (x, y) = if convex == (d.x == 0) { (quadrant.x, 0) } else { (0, quadrant.y) };
            let end = Raw::of(centre).add(Raw { x: x.wrapping_mul(radius), y: y.wrapping_mul(radius) });
            let q = end.sub(front);
            if q.cross(d) != 0 || q.dot(d) < 0 || way(q) >= way(d) || first.is_within(way(q), way(d)) {
                continue;
            }
            if B::is_inside(world, end.add(step)) {
                let normal = Axis::new(step.x.wrapping_neg(), step.y.wrapping_neg());
                let entry = Entry { num: way(q), den: way(d), normal, at_end: true, step: Some(q) };
                first.only(&entry, feature);
            }
        }
    }

    /// Whether the motion is along x or y and the body has no extent across it.
    fn may_meet_cusp(&self, d: Raw) -> bool {
        let bounds = self.body.bounds();
        (d.x == 0 && bounds.lo().x == bounds.hi().x) || (d.y == 0 && bounds.lo().y == bounds.hi().y)
    }
}
