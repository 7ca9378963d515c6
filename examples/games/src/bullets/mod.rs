//! A game of many bullets.
//!
//! A frame has three steps, and a desktop can look at the game between them. [`Game::fly`] moves
//! every body through the level. [`Game::meet`] finds the bodies that are hit. [`Game::fire`] lets
//! all of them shoot. A body is a slot of the broad phase, which keeps its box and its filter, and
//! an entry at the same index of the game's table.

mod aim;
mod body;
mod fire;
mod level;
mod meet;
mod tally;

pub use body::{Body, Kind};
pub use level::{Level, ROWS, SIZE, SPONGE, bounds, level};
pub use tally::Tally;

use body::Flight;
use tilesat::broad::{BroadPhase, Exceptions, Handle, PairEvents, SortSweep};
use tilesat::heapless::Vec;
use tilesat::{Aabb, Circle, Filter, Vec2};

pub const BULLETS: usize = 240;
pub const ENEMIES: usize = 32;
/// With the player and the zone.
pub const BODIES: usize = BULLETS + ENEMIES + 2;
/// Frames of the run whose hash desktop and firmware compare.
pub const FRAMES: u32 = 600;

/// A post at which an enemy stands or returns.
#[derive(Debug, Clone, Copy)]
pub struct Post {
    pub kind: Kind,
    /// Its cell.
    pub at: (u8, u8),
    /// The first direction of its enemy.
    pub course: (i8, i8),
    pub body: Option<Handle>,
}

/// With fields sorted by size, it fits the smallest chip.
pub type Near = SortSweep<BODIES, Filter>;

/// The whole state is plain data, so a snapshot is a copy. It takes 13 KB, so on a chip it is a
/// `static`. Every broad phase gives the same game.
#[derive(Debug, Clone, Copy)]
pub struct Game<B = Near> {
    pub near: B,
    pub bodies: [Body; BODIES],
    pub events: PairEvents<64>,
    /// Bullets that leave their shooter, and shots that leave the turret that they bounced off.
    pub exceptions: Exceptions<48>,
    /// The filters of enemies, of the player and of the zone.
    pub posts: [Post; ENEMIES + 2],
    /// The player's goal, and for how long it has had it.
    goal: (u8, u16),
    pub frame: u32,
    pub tally: Tally,
}

impl<B> Game<B> {
    /// A game with an empty broad phase.
    pub const fn new(near: B) -> Self {
        Self {
            near,
            bodies: [Body::NONE; BODIES],
            events: PairEvents::new(),
            exceptions: Exceptions::new(),
            posts: [Post { kind: Kind::Zone, at: (0, 0), course: (0, 0), body: None }; ENEMIES + 2],
            goal: (0, 0),
            frame: 0,
            tally: Tally::NONE,
        }
    }
}

impl<B: BroadPhase<Tag = Filter>> Game<B> {
    /// Puts all bodies of a new game at their start.
    pub fn start(&mut self) {
        self.tally.hash = tally::BASIS;
        for (post, (kind, at, course)) in self.posts.iter_mut().zip(level::posts()) {
            (post.kind, post.at, post.course) = (kind, at, course);
        }
        self.staff();
    }

    /// Plays one frame.
    // The three are not inlined. Otherwise the lists of each would lie on a chip's stack below the
    // motion of every body.
    pub fn step(&mut self, level: &Level) {
        self.fly(level);
        self.meet();
        self.fire();
    }

    /// Moves all bodies. Removes bullets that the level ended.
    #[inline(never)]
    pub fn fly(&mut self, level: &Level) {
        self.steer();
        let Self { near, bodies, tally, .. } = self;
        let mut flight = Flight::default();
        let moved = near.move_each(|handle, bounds| match bodies.get_mut(handle.slot()) {
            Some(body) => body.fly(level, bounds, &mut flight),
            None => *bounds,
        });
        tally.bounces += flight.bounces;
        tally.refused += flight.refused + u32::from(moved.is_err());
        self.bury();
    }

    /// A body's entry, while the body exists.
    pub fn body(&self, handle: Handle) -> Option<&Body> {
        self.bodies.get(handle.slot()).filter(|_| self.near.contains(handle))
    }

    /// The circle of a body. For the zone, the circle in its box.
    pub fn circle(&self, handle: Handle) -> Option<Circle> {
        self.body(handle)?.circle(&self.near.bounds(handle).ok()?).ok()
    }

    /// Adds a body. Returns `None` if there is no room.
    fn enter(&mut self, body: Body, at: Vec2) -> Option<Handle> {
        let bounds = Aabb::from_centre(at, body.kind.half()).ok()?;
        let handle = self.near.insert(&bounds, body.kind.filter()).ok()?;
        *self.bodies.get_mut(handle.slot())? = body;
        Some(handle)
    }

    /// Removes all bodies without a life.
    #[inline(never)]
    fn bury(&mut self) {
        let Some(all) = level::bounds() else { return };
        loop {
            // In ascending order: no broad phase then decides the order in which slots become free.
            let mut dead = Vec::<Handle, 32>::new();
            let bodies = &self.bodies;
            self.near.in_region(&all, |handle| {
                if bodies.get(handle.slot()).is_some_and(|body| body.life > 0) {
                    return;
                }
                let place = dead.iter().position(|other| handle < *other).unwrap_or(dead.len());
                if dead.is_full() && place < dead.len() {
                    dead.pop();
                }
                let _ = dead.insert(place, handle);
            });
            for &handle in &dead {
                let _ = self.near.remove(handle);
            }
            if !dead.is_full() {
                break;
            }
        }
    }
}
