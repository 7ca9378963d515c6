//! Finds the bodies that are hit.

use tilesat::broad::{BroadPhase, Handle, Ignore, Pair, PairCursor, PairEvent, PairsError};
use tilesat::heapless::Vec;
use tilesat::motion::response::bounce;
use tilesat::prelude::*;
use tilesat::{Filter, Ratio};

use super::body::FULL;
use super::{Body, Game, Kind};

/// Whether both bodies of a pair are still. The broad phase does not report such pairs.
fn rest(near: &impl BroadPhase<Tag = Filter>, pair: Pair) -> bool {
    let still = |handle| near.tag(handle).is_ok_and(|filter| filter.still());
    still(pair.a) && still(pair.b)
}

impl<B: BroadPhase<Tag = Filter>> Game<B> {
    /// Finds the pairs that touch, reports the ends of earlier ones, and applies the effects.
    #[inline(never)]
    pub fn meet(&mut self) {
        let mut cursor = PairCursor::new();
        let mut some = Vec::<Pair, 32>::new();
        loop {
            let found = self.near.pairs_from(&mut cursor, u32::MAX, &mut some);
            for &pair in &some {
                if self.touch(pair) && self.exceptions.passes(pair) {
                    self.events.feed(pair);
                }
            }
            some.clear();
            match found {
                Ok(()) => break,
                Err(PairsError::Changed) => self.events.cancel(),
                Err(PairsError::Full | PairsError::BudgetExceeded) => {}
            }
        }
        let near = &self.near;
        self.tally.crowded += u32::from(self.events.finish(|&pair| rest(near, pair)).is_err());
        let events = self.events;
        for event in events.iter() {
            self.tally.hash_event(event);
            let (Some(a), Some(b)) = (self.body(event.pair().a), self.body(event.pair().b)) else { continue };
            let (a, b) = ((event.pair().a, *a), (event.pair().b, *b));
            // A body that was already hit in this frame is not hit again.
            if a.1.life > 0 && b.1.life > 0 && !self.happens(event, a, b) {
                self.happens(event, b, a);
            }
        }
        let near = &self.near;
        self.exceptions.finish(|handle| near.contains(handle), |&pair| rest(near, pair));
        self.bury();
    }

    /// The game's own test of the shapes.
    fn touch(&self, pair: Pair) -> bool {
        let (Some(a), Some(b)) = (self.circle(pair.a), self.circle(pair.b)) else { return false };
        let zone = |handle| self.body(handle).is_some_and(|body| body.kind == Kind::Zone);
        match (self.near.bounds(pair.a), self.near.bounds(pair.b)) {
            (Ok(bounds), _) if zone(pair.a) => bounds.touches(&b),
            (_, Ok(bounds)) if zone(pair.b) => bounds.touches(&a),
            _ => a.touches(&b),
        }
    }

    /// Handles an event between these two. Returns false if the caller must try the other order.
    fn happens(&mut self, event: PairEvent, a: (Handle, Body), b: (Handle, Body)) -> bool {
        use PairEvent::{Begin, End, Stay};
        match (event, a.1.kind, b.1.kind) {
            (Begin(_), Kind::Bullet, Kind::Player) => {
                self.tally.hits += 1;
                self.end(a.0);
                if self.hurt(b.0) {
                    self.tally.deaths += 1;
                }
            }
            (Begin(_), Kind::Player, enemy) if enemy.is_enemy() => {
                self.tally.rammed += 1;
                if self.hurt(a.0) {
                    self.tally.deaths += 1;
                }
            }
            (Begin(_), Kind::Bullet, enemy) if enemy.is_enemy() => {
                self.tally.cover += 1;
                self.end(a.0);
            }
            (Begin(_), Kind::Shot, enemy) if enemy.is_enemy() => {
                if self.hurt(b.0) {
                    self.tally.kills += 1;
                }
                if enemy != Kind::Turret || !self.reflect(a, b.0) {
                    self.end(a.0);
                }
            }
            (Begin(_), Kind::Zone, _) => self.tally.visits += 1,
            (Stay(_), Kind::Zone, Kind::Player) if self.frame.is_multiple_of(8) && b.1.life < FULL => {
                self.tally.repairs += 1;
                if let Some(player) = self.bodies.get_mut(b.0.slot()) {
                    player.life += 1;
                }
            }
            (End(_), Kind::Zone, _) => self.tally.left += 1,
            _ => return false,
        }
        true
    }

    /// Takes a life. Returns whether it was the last.
    fn hurt(&mut self, handle: Handle) -> bool {
        let Some(body) = self.bodies.get_mut(handle.slot()) else { return true };
        body.life = body.life.saturating_sub(1);
        body.life == 0
    }

    fn end(&mut self, handle: Handle) {
        if let Some(body) = self.bodies.get_mut(handle.slot()) {
            body.life = 0;
        }
    }

    /// Turns a shot round at a turret, and ignores the pair until they separate. Returns whether
    /// that worked.
    fn reflect(&mut self, shot: (Handle, Body), turret: Handle) -> bool {
        let (Some(a), Some(b)) = (self.circle(turret), self.circle(shot.0)) else { return false };
        let Some(contact) = a.contact(&b) else { return false };
        let Ok(velocity) = bounce(shot.1.velocity, contact.axis(), Ratio::ONE) else { return false };
        if self.exceptions.ignore(shot.0, turret, Ignore::UntilApart).is_err() {
            self.tally.crowded += 1;
            return false;
        }
        if let Some(body) = self.bodies.get_mut(shot.0.slot()) {
            body.velocity = velocity;
        }
        self.tally.reflected += 1;
        true
    }
}
