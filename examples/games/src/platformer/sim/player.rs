//! The scripted player: a small state machine that sees the level through tile lookups.

use tilesat::motion::Response;
use tilesat::world::{Cell, ShapeSet, TileKind, TileMap, TileShape};
use tilesat::{Aabb, Vec2};

use super::actor::{Actor, Outcome, Shape};
use super::rng::Rng;
use super::start::place;
use super::{FrameReport, Rules};

/// The number of coins that can be taken, row by row. Further coins stay.
pub const MAX_COINS: u32 = 32 * COIN_WORDS as u32;
const COIN_WORDS: usize = 32;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Score {
    pub coins: u32,
    pub deaths: u32,
    pub wins: u32,
    /// Jumps that ended at a ceiling.
    pub bumps: u32,
    /// Landings on one-way tiles.
    pub landings: u32,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Player {
    rules: Rules,
    start: Aabb,
    /// 1 to the right, -1 to the left.
    direction: i32,
    last: Outcome,
    airborne: bool,
    /// Flags of the tiles around it at the end of the last frame.
    within: u8,
    /// The middle of the ladder that it is at, and whether it wants to climb.
    ladder: i32,
    climbing: bool,
    /// Frames for which it does not turn or look ahead.
    careless: u8,
    /// Its position at the last check of progress, the frames since then, and the number of failed
    /// checks.
    anchor: i32,
    since: u8,
    stuck: u8,
    score: Score,
    coins: [u32; COIN_WORDS],
}

impl Player {
    pub(super) fn new<S: ShapeSet>(map: &TileMap<'_, S>, rules: Rules, rng: &mut Rng) -> Option<(Self, Actor)> {
        let cell = map.cell().to_bits();
        let half = (cell * 3 / 8, cell * 7 / 16);
        let mut shape = place(map, half, false, rules.kill, rng)?;
        for _ in 0..16 {
            if lands_safely(map, &shape, rules.kill) {
                break;
            }
            shape = place(map, half, false, rules.kill, rng)?;
        }
        let Shape::Box(start) = shape else { return None };
        let player = Self {
            rules,
            start,
            direction: 1,
            last: Outcome::default(),
            airborne: true,
            within: 0,
            ladder: 0,
            climbing: false,
            careless: 0,
            anchor: start.min().raw().0,
            since: 0,
            stuck: 0,
            score: Score::default(),
            coins: [0; COIN_WORDS],
        };
        Some((player, Actor::new(shape, Response::Slide, true)))
    }

    /// Starts with the feet at a point, if it is free.
    pub(super) fn start_at<S: ShapeSet>(&mut self, map: &TileMap<'_, S>, actor: &mut Actor, feet: Vec2) -> bool {
        let stands = actor.stand_at(map, feet);
        if let Shape::Box(start) = actor.shape {
            (self.start, self.anchor) = (start, start.min().raw().0);
        }
        stands
    }

    pub(super) fn score(&self) -> Score {
        self.score
    }

    pub(super) fn collected(&self, coin: u32) -> bool {
        self.coins.get((coin / 32) as usize).is_some_and(|word| word >> (coin % 32) & 1 != 0)
    }

    pub(super) fn step<S: ShapeSet>(
        &mut self,
        map: &TileMap<'_, S>,
        actor: &mut Actor,
        rng: &mut Rng,
        report: &mut FrameReport,
    ) {
        let Shape::Box(body) = actor.shape else { return };
        self.decide(&body, rng);
        actor.velocity = self.steer(map, &body, actor.velocity, rng);
        let rising = actor.velocity.raw().1 < 0;
        self.last = actor.advance(map, report);
        self.score.bumps += u32::from(rising && self.last.ceiling);
        self.score.landings += u32::from(self.airborne && self.last.floor && self.last.one_way);
        self.airborne = !self.last.floor;
        self.feel(map, actor, report);
    }

    /// Turns round if the last 96 frames led nowhere, and sometimes without a reason.
    fn decide(&mut self, body: &Aabb, rng: &mut Rng) {
        let (left, right) = (body.min().raw().0, body.max().raw().0);
        self.since += 1;
        if self.since == 32 {
            let there = (left - self.anchor).abs() > (right - left) / 2;
            self.stuck = if there || self.climbing { 0 } else { self.stuck + 1 };
            (self.since, self.anchor) = (0, left);
        }
        if self.stuck == 3 || rng.once_in(900) {
            self.direction = -self.direction;
            self.stuck = 0;
        }
    }

    /// The velocity that it wants. It runs, jumps at walls, gaps and spikes, and climbs ladders.
    fn steer<S: ShapeSet>(&mut self, map: &TileMap<'_, S>, body: &Aabb, velocity: Vec2, rng: &mut Rng) -> Vec2 {
        let cell = map.cell().to_bits();
        let (run, jump, gravity) = (cell * 7 / 64, cell * 21 / 64, cell / 64);
        let (x, y) = velocity.raw();
        if self.climbing {
            if self.within & self.rules.ladder != 0 {
                let off = self.ladder - body.centre().raw().0;
                let up = if off.abs() < cell / 8 { -run } else { 0 };
                return Vec2::from_raw(off.clamp(-run, run), up);
            }
            self.climbing = false;
            return Vec2::from_raw(self.direction * run, -jump / 2);
        }
        self.careless = self.careless.saturating_sub(1);
        let push = (self.direction * run - x).clamp(-gravity, gravity);
        let mut fall = (y + gravity).min(cell / 2);
        if self.last.floor {
            if self.careless == 0 && self.obstacle(map, body) {
                if rng.once_in(12) {
                    self.careless = 30;
                } else {
                    fall = -jump;
                }
            } else if rng.once_in(150) {
                fall = -jump * 3 / 4;
            }
        }
        Vec2::from_raw(x + push, fall)
    }

    /// Whether the way ahead needs a jump.
    fn obstacle<S: ShapeSet>(&self, map: &TileMap<'_, S>, body: &Aabb) -> bool {
        let cell = map.cell().to_bits();
        let ((left, _), (right, bottom)) = (body.min().raw(), body.max().raw());
        let front = if self.direction > 0 { right } else { left } + self.direction * cell / 4;
        let look = |y: i32| -> TileKind { map.kind(map.cell_at(Vec2::from_raw(front, y))) };
        let (ahead, below, deeper) = (look(bottom - 1), look(bottom + 1), look(bottom + cell + 1));
        let deadly = (ahead.flags | below.flags | deeper.flags) & self.rules.kill != 0;
        let gap = below.shape == TileShape::Empty && deeper.shape == TileShape::Empty;
        ahead.shape == TileShape::Full || gap || deadly
    }

    /// Reacts to the flags of the tiles that it is in, and of those that it ran into.
    fn feel<S: ShapeSet>(&mut self, map: &TileMap<'_, S>, actor: &mut Actor, report: &mut FrameReport) {
        let Shape::Box(body) = actor.shape else { return };
        let cell = map.cell().to_bits();
        let margin = cell / 16;
        let before = self.within;
        self.within = 0;
        // Grazing does not count: this inner box is smaller than the one that collides.
        let (min, max) = (body.min(), body.max());
        let inset = Vec2::from_raw(margin, margin);
        if let Ok(inner) = Aabb::new(min + inset, max - inset) {
            for tile in map.tiles_in(&inner) {
                self.within |= tile.kind.flags;
                if tile.kind.flag(self.rules.coin) {
                    self.take(map, tile.cell);
                }
                if tile.kind.flag(self.rules.ladder) {
                    self.ladder = i32::from(tile.cell.x) * cell + cell / 2;
                }
            }
        }
        let entered = self.within & !before;
        if entered & self.rules.ladder != 0 {
            self.climbing = true;
        }
        if entered & self.rules.win != 0 {
            self.score.wins += 1;
            self.direction = -self.direction;
        }
        if (self.within | self.last.flags) & self.rules.kill != 0 {
            self.score.deaths += 1;
            report.respawned = true;
            actor.shape = Shape::Box(self.start);
            actor.velocity = Vec2::ZERO;
            (self.within, self.climbing, self.direction) = (0, false, 1);
        }
    }

    /// A bit per coin takes less memory than a bit per cell. It counts coins only while it is in
    /// one.
    fn take<S: ShapeSet>(&mut self, map: &TileMap<'_, S>, at: Cell) {
        let width = map.width() as i16;
        let before = (0..=at.y).flat_map(|y| (0..width).map(move |x| Cell::new(x, y)));
        let before = before.take_while(|&cell| cell != at);
        let coin = before.filter(|&cell| map.kind(cell).flag(self.rules.coin)).count() as u32;
        if !self.collected(coin) {
            if let Some(word) = self.coins.get_mut((coin / 32) as usize) {
                *word |= 1 << (coin % 32);
                self.score.coins += 1;
            }
        }
    }
}

/// Whether nothing deadly lies between a position and the ground straight below it.
fn lands_safely<S: ShapeSet>(map: &TileMap<'_, S>, place: &Shape, kill: u8) -> bool {
    let Shape::Box(body) = place else { return true };
    [body.min().x, body.max().x].iter().all(|&x| {
        let top = map.cell_at(Vec2::new(x, body.min().y));
        let column = (top.y..=map.height() as i16).map(|y| map.kind(Cell::new(top.x, y)));
        let mut fall = column.take_while(|kind| kind.shape == TileShape::Empty);
        fall.all(|kind| !kind.flag(kill))
    })
}
