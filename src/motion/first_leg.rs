//! The first straight part of a motion that meets something.

use super::body::{Body, Entry, is_by_lines};
use super::mover::Mover;
use super::order::First;
use super::plane::SurfaceRole;
use super::response::{Law, Response};
use super::run::{Run, check_inside};
use super::search::{Around, Search, piece_of};
use super::{Hit, Hits, MoveError, Moved, Work};
use crate::num::{Raw, Toi, Vec2};
use crate::world::{Feature, World};

impl<S: Law> Mover<S> {
    /// A separate function: most bodies fly, and need no stack for the rest.
    #[inline(never)]
    pub(super) fn run_into<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        velocity: Vec2,
        pieces: u32,
        around: &mut Around,
    ) -> Result<Moved<B>, MoveError> {
        let (d, bounds) = (Raw::of(velocity), body.bounds());
        let mut found = Found { work: Work { iterations: 1, features: 0, checks: 0 }, inside: false, guarded: false };
        let mut first = First::none();
        if is_by_lines::<W, B>() {
            let mut lines = world.lines(&bounds, d);
            found.inside = world.starts_inside(&lines, &bounds);
            found.work.checks = 1;
            self.check_start(body, found.inside)?;
            check_inside(&bounds, d)?;
            if let Some(hit) = &world.next_block(&mut lines, false, &mut found.work.features) {
                first.take_block(world, hit);
            }
        } else {
            // The body's own position has already been looked at.
            let free = around.is_free_in_sight(&piece_of(&bounds, Raw::ZERO, Raw::ZERO, 1));
            found.inside = !free && self.is_inside(world, body, &mut found.work)?;
            check_inside(&bounds, d)?;
            let mut search = Search::new(body, around);
            search.find_first_in(world, pieces, d, &mut first);
            (found.work.features, found.guarded) = (search.features, search.guarded);
        }
        if let Some((entry, feature)) = first.hit::<B, W>(body, d) {
            if self.rests(d, entry, feature) {
                let side = self.side(entry.normal);
                return Ok(Moved {
                    body: *body,
                    velocity: Vec2::ZERO,
                    remaining: Vec2::ZERO,
                    hits: Hits::one(Hit::of(entry.normal, feature, Toi::ZERO)),
                    floor: side == SurfaceRole::Floor,
                    wall: side == SurfaceRole::Wall,
                    ceiling: side == SurfaceRole::Ceiling,
                    flags: feature.flags,
                    work: found.work,
                });
            }
        }
        self.go_on(world, body, velocity, around, &mut first, &found)
    }

    /// Continues a motion after its first hit has been found.
    #[inline(never)]
    fn go_on<W: World, B: Body>(
        &self,
        world: &W,
        body: &B,
        velocity: Vec2,
        around: &mut Around,
        first: &mut First,
        found: &Found,
    ) -> Result<Moved<B>, MoveError> {
        let mut moved = Moved::freely(*body, velocity, 0);
        moved.work = found.work;
        let mut run = Run::new(&mut moved, around);
        (run.inside, run.guarded) = (found.inside, found.guarded);
        if !self.follow::<W, B, false>(world, &mut run, Raw::of(velocity), first) {
            self.slide::<W, B, false>(world, &mut run, first)?;
        }
        run.end::<W>();
        moved.copied()
    }

    /// Whether a hit takes all of a motion and leaves nothing, as for most resting bodies. The
    /// answer is that of [`respond`](Self::respond), found without the work that other hits need.
    ///
    /// The body touches the face, so it makes none of the motion. The motion is straight into the
    /// face, so no part is left along it, for friction neither. A single plane along x or y leaves
    /// nothing askew that could [wedge](Self::wedge) the body.
    fn rests(&self, d: Raw, entry: &Entry, feature: &Feature) -> bool {
        let Entry { num, normal, at_end, ref step, .. } = *entry;
        let straight = (normal.x == 0 && d.x == 0) || (normal.y == 0 && d.y == 0);
        num == 0
            && step.is_none()
            && !at_end
            && straight
            && !(feature.one_way && self.passes_one_way())
            && match self.response_to(normal, feature, Toi::ZERO) {
                Response::Touch => false,
                Response::Slide | Response::DropThrough => true,
                Response::Bounce => self.surface.surface().stops(d, normal),
            }
    }
}

/// The results known when a motion has found its first hit.
struct Found {
    work: Work,
    inside: bool,
    guarded: bool,
}
