//! The search for the first hit of a motion: which parts of the level it asks, and in which order.

use super::around::{Around, Held, hull};
use super::body::Body;
use super::order::First;
use super::plane::{into, way};
use super::run::margin;
use crate::num::{Raw, leading_zeros32, umul};
use crate::shape::Aabb;
use crate::world::{Geometry, Way, World};

/// What the first hit of a body's motion depends on, beside the level.
pub(super) struct Search<'a, B> {
    pub(super) body: &'a B,
    pub(super) around: &'a mut Around,
    /// Whether one-way faces are no hits.
    pub(super) pass_one_way: bool,
    /// A velocity, of which only what opposes it is a hit.
    pub(super) pressed: Option<Raw>,
    /// How many features were swept against.
    pub(super) features: u32,
    /// Whether one-way faces are near that may be askew.
    pub(super) guarded: bool,
}

impl<'a, B: Body> Search<'a, B> {
    pub(super) fn new(body: &'a B, around: &'a mut Around) -> Self {
        Self { body, around, pass_one_way: false, pressed: None, features: 0, guarded: false }
    }

    /// Looks for the first hit of the motion. Cells are visited piece by piece so that the work is linear in the motion's length; the sweeps
    /// themselves always see the whole motion.
    #[inline(never)]
    pub(super) fn find_first<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
        let bounds = self.body.bounds();
        match pieces(world, &bounds, d) {
            1 => {
                let region = piece_of(&bounds, Raw::ZERO, d, 1);
                self.around.look(world, &region);
                self.meet(world, self.around.held_of(&region).as_ref(), None, d, first);
            }
            pieces => self.find_in_pieces(world, pieces, d, first),
        }
        self.find_cusp(world, d, first);
    }

    /// The same of a motion in so many pieces; where it is one, the level has been looked at.
    pub(super) fn find_first_in<W: World>(&mut self, world: &W, pieces: u32, d: Raw, first: &mut First) {
        if pieces == 1 {
            match self.around.known_cells() {
                Some(mut cells) if W::GRID => self.meet_blocks(world, &mut cells, d, first),
                _ => self.meet(world, self.around.held_of_all().as_ref(), None, d, first),
            }
        } else {
            self.find_in_pieces(world, pieces, d, first);
        }
        self.find_cusp(world, d, first);
    }

    #[inline]
    fn find_cusp<W: World>(&mut self, world: &W, d: Raw, first: &mut First) {
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
            let region = piece_of(&bounds, from, to, pieces);
            from = to;
            self.around.look(world, &region);
            self.meet(world, self.around.held_of(&region).as_ref(), before.as_ref(), d, first);
            // Later pieces hold only later hits.
            if first.is_within(piece, pieces) {
                break;
            }
            before = Some(region);
        }
    }

    #[inline]
    fn meet<W: World>(&mut self, world: &W, held: Option<&Held>, before: Option<&Aabb>, d: Raw, first: &mut First) {
        let Some(held) = held else { return };
        if W::GRID {
            let mut cells = held.cells.unwrap_or_else(|| world.cells(&held.bounds));
            self.meet_blocks(world, &mut cells, d, first);
        } else {
            self.meet_features(world, held, before, d, first);
        }
    }

    /// Takes the hits of the features of a piece of the motion.
    #[inline(never)]
    fn meet_features<W: World>(&mut self, world: &W, held: &Held, before: Option<&Aabb>, d: Raw, first: &mut First) {
        let body = self.body;
        let (whole, joints) = (hull(&body.bounds(), Raw::ZERO, d, 1), body.meets_joints());
        let way = Way { piece: &held.bounds, cells: held.cells, before, whole, d, joints };
        let mut features = world.features_ahead(&way);
        // By reference, as all that is larger than a few words: copies of features and entries would be most of the stack.
        while let Some(feature) = &features.next() {
            self.features += 1;
            if feature.one_way && self.pass_one_way {
                continue;
            }
            self.guarded |= !W::BLOCKS && feature.one_way;
            let entry = &if W::BLOCKS {
                body.sweep_block(d, feature)
            } else if W::ROUND || !matches!(feature.geometry, Geometry::Arc { .. }) {
                body.sweep(d, feature)
            } else {
                None
            };
            let Some(entry) = entry else { continue };
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

/// In how many pieces, a power of two, the cells under a motion are visited: no shorter than the body either, or each would visit the body's own
/// cells again. Up to half as long again is one piece: a look-up more costs less than another start. At most 2^21, for a motion below 2^29 in cells of
/// 2^8.
pub(super) fn pieces<W: World>(world: &W, bounds: &Aabb, d: Raw) -> u32 {
    let longest = way(d);
    let side = Raw::of(bounds.size());
    let length = world.cell_size().max(side.x.max(side.y) as u32);
    let mut log = 0;
    while longest >> log > length + (length >> 1) {
        log += 1;
    }
    1 << log
}

/// What the inside of the bounds covers in one of the pieces of a motion. Where there are more, displacements are rounded: a raw unit larger then.
pub(super) fn piece_of(bounds: &Aabb, from: Raw, to: Raw, pieces: u32) -> Aabb {
    hull(bounds, from, to, if pieces == 1 { margin(bounds) } else { 1 })
}
