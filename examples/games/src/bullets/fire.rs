//! The script: who shoots in which frame, and who returns.

use tilesat::broad::{BroadPhase, Handle, Ignore};
use tilesat::{Filter, Vec2};

use super::aim::{course, turn_toward};
use super::body::FULL;
use super::{BULLETS, Body, ENEMIES, Game, Kind};

/// The player's goals, in turn.
const WAY: [(i16, i16); 8] =
    [(350, 264), (200, 260), (150, 140), (270, 100), (420, 100), (480, 170), (370, 250), (320, 300)];
/// Frames in which it must reach its goal. Otherwise it takes the next.
const PATIENCE: u16 = 150;
/// Frames for which a post stays empty.
const AWAY: u32 = 96;

impl<B: BroadPhase<Tag = Filter>> Game<B> {
    /// Sets the player's velocity for this frame.
    pub(super) fn steer(&mut self) {
        let Some((player, circle)) = self.player().and_then(|player| Some((player, self.circle(player)?))) else {
            return;
        };
        let (x, y) = WAY.get(usize::from(self.goal.0)).copied().unwrap_or((0, 0));
        let by = Vec2::from_ints(x, y) - circle.centre();
        let most = Vec2::from_ints(2, 2);
        let velocity = by.min(most).max(-most);
        self.goal.1 += 1;
        if velocity == by || self.goal.1 > PATIENCE {
            self.goal = ((self.goal.0 + 1) % WAY.len() as u8, 0);
        }
        if let Some(body) = self.bodies.get_mut(player.slot()) {
            body.velocity = velocity;
        }
    }

    /// Lets all bodies shoot, fall asleep and return. Counts the frame.
    #[inline(never)]
    pub fn fire(&mut self) {
        for i in 0..self.posts.len() {
            let Some(owner) = self.posts.get(i).and_then(|post| post.body).filter(|&body| self.near.contains(body))
            else {
                continue;
            };
            let Some(body) = self.bodies.get_mut(owner.slot()) else { continue };
            body.clock = body.clock.wrapping_add(1);
            let body = *body;
            // Neighbours shoot in different frames.
            let time = u32::from(body.clock) + 7 * i as u32;
            match body.kind {
                Kind::Turret if time.is_multiple_of(48) => {
                    for k in 0..8 {
                        self.shoot(owner, Kind::Bullet, course(4 * k + time / 48, 384));
                    }
                }
                Kind::Spinner if time.is_multiple_of(5) => self.shoot(owner, Kind::Bullet, course(time / 5 * 3, 512)),
                Kind::Patrol if time.is_multiple_of(24) => self.aim(owner, Kind::Bullet, self.player(), 448),
                Kind::Player if time.is_multiple_of(4) => self.aim(owner, Kind::Shot, self.nearest_enemy(owner), 1280),
                _ => {}
            }
            if body.kind == Kind::Patrol {
                let _ = self.near.set_tag(owner, body.kind.filter().with_still(body.sleeps()));
            }
        }
        self.staff();
        self.frame += 1;
        self.fold();
    }

    /// Fills empty posts: at the start, and later each at its time.
    pub(super) fn staff(&mut self) {
        for i in 0..self.posts.len() {
            let Some(&post) = self.posts.get(i) else { continue };
            let empty = post.body.is_none_or(|body| !self.near.contains(body));
            let late = self.frame + i as u32;
            if !empty || self.frame > 0 && !late.is_multiple_of(AWAY) {
                continue;
            }
            let life = match post.kind {
                Kind::Turret => 6,
                Kind::Player => FULL,
                _ => 3,
            };
            // Patrols do not all sleep at the same time.
            let clock = if post.kind == Kind::Patrol { 48 * i as u16 } else { 0 };
            let velocity = Vec2::from_ints(post.course.0.into(), post.course.1.into());
            let middle = |cell: u8| 16 * i16::from(cell) + 8;
            let at = Vec2::from_ints(middle(post.at.0), middle(post.at.1));
            let body = self.enter(Body { velocity, kind: post.kind, life, clock }, at);
            if let Some(post) = self.posts.get_mut(i) {
                post.body = body;
            }
        }
    }

    /// The player, while it lives.
    pub fn player(&self) -> Option<Handle> {
        let post = self.posts.iter().find(|post| post.kind == Kind::Player)?;
        post.body.filter(|&body| self.near.contains(body))
    }

    fn nearest_enemy(&self, from: Handle) -> Option<Handle> {
        let centre = self.circle(from)?.centre();
        let enemies = self.posts.iter().filter(|post| post.kind.is_enemy()).filter_map(|post| post.body);
        enemies
            .filter_map(|enemy| Some((enemy, (self.circle(enemy)?.centre() - centre).length_squared())))
            .min_by_key(|&(_, far)| far)
            .map(|(enemy, _)| enemy)
    }

    fn aim(&mut self, owner: Handle, kind: Kind, target: Option<Handle>, speed: i32) {
        let centre = |handle| self.circle(handle).map(|circle| circle.centre());
        if let (Some(from), Some(to)) = (centre(owner), target.and_then(centre)) {
            self.shoot(owner, kind, course(turn_toward(to - from), speed));
        }
    }

    /// A bullet from the middle of its shooter. It cannot hit the shooter before it has left it.
    fn shoot(&mut self, owner: Handle, kind: Kind, velocity: Vec2) {
        let (life, clock) = if kind == Kind::Shot { (1, 0) } else { (3, 240) };
        let present = self.posts.iter().filter_map(|post| post.body).filter(|&body| self.near.contains(body)).count();
        let room = self.near.len() < BULLETS + present;
        let Some(circle) = self.circle(owner).filter(|_| room) else {
            self.tally.denied += 1;
            return;
        };
        let Some(bullet) = self.enter(Body { velocity, kind, life, clock }, circle.centre()) else {
            self.tally.denied += 1;
            return;
        };
        // The player's shots never pair with the player.
        if kind == Kind::Bullet && self.exceptions.ignore(bullet, owner, Ignore::UntilApart).is_err() {
            self.tally.crowded += 1;
            let _ = self.near.remove(bullet);
            return;
        }
        self.tally.fired += 1;
    }
}

const _: () = assert!(ENEMIES + 2 + BULLETS == super::BODIES, "everybody has a slot");
