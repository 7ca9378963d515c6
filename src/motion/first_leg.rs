//! The first straight part of a motion that meets something.

use super::body::{Body, is_by_lines};
use super::mover::Mover;
use super::only_hit::OnlyHit;
use super::order::First;
use super::response::Law;
use super::run::{Run, check_inside, is_certain};
use super::search::{Around, Search, box_here};
use super::{Hit, MoveError, Moved, Work};
use crate::num::{Raw, Vec2};
use crate::world::World;

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
        if pieces == 1 {
            if let Some(moved) = self.slides_on_block(world, body, d, around) {
                return Ok(moved);
            }
        }
        let mut found = Found { work: Work { iterations: 1, features: 0, checks: 0 }, inside: false, guarded: false };
        let mut first = First::none();
        if is_by_lines::<W, B>() {
            let mut lines = world.lines(&bounds, d);
            found.inside = world.starts_inside(&lines, &bounds);
            found.work.checks = 1;
            self.check_start(body, found.inside)?;
            if !lines.are_in_map() {
                check_inside(&bounds, d)?;
            }
            if let Some(hit) = &world.next_block(&mut lines, false, &mut found.work.features) {
                first.take_block(world, hit);
            }
        } else {
            // The body's own position has already been looked at.
            let free = around.is_free_in_sight(&box_here(body));
            found.inside = !free && self.is_inside(world, body, &mut found.work)?;
            check_inside(&bounds, d)?;
            let mut search = Search::new(body, around);
            search.find_first_in(world, pieces, d, &mut first);
            (found.work.features, found.guarded) = (search.features, search.guarded);
        }
        let known = if found.inside || found.guarded { None } else { Some(&*around) };
        match first.hit::<B, W>(body, d) {
            Some(hit) => {
                if let Some(OnlyHit { toi, made, rest, v }) = self.only_hit(world, body, d, hit, known) {
                    let (normal, feature) = (hit.0.normal, hit.1);
                    debug_assert!(
                        found.inside || !body.shifted(made.add(rest)).overlaps_world(world),
                        "a place was taken for free"
                    );
                    let hit = (Hit::of(normal, feature, toi), self.side(normal));
                    found.work.iterations += u32::from(!rest.is_zero());
                    return Ok(Moved::with_one(body.shifted(made.add(rest)), v.vec2(), hit, found.work));
                }
            }
            None if known.is_some() && is_certain::<W, B>(body) => {
                world.made(d);
                return Ok(Moved { work: found.work, ..Moved::freely(body.shifted(d), velocity, 0) });
            }
            None => {}
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
}

/// The results known when a motion has found its first hit.
struct Found {
    work: Work,
    inside: bool,
    guarded: bool,
}
