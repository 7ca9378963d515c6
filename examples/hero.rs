//! A platformer on the crate alone: slopes, a one-way ledge, a lift, coins, spikes, and an enemy
//! that patrols. One struct holds the game's whole state, so a copy of it is a saved game.
//!
//! ```text
//! cargo run --release --example hero
//! ```
//!
//! A script plays. The program draws the level with the hero's path, and checks how the game ends.

use std::error::Error;
use tilesat::prelude::*;
use tilesat::{
    Aabb, Character, Feel, Fx, Grid, Input, Outcome, RangeError, Slopes, Solid, TileKind, TileKinds, TileMap,
    TileMapError, TileShape, Vec2, fx,
};

const COIN: u8 = 1;
const SPIKE: u8 = 2;
/// What each byte of the level is. Bytes that are not named are empty.
static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'=', TileKind::ONE_WAY_UP)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'o', TileKind::EMPTY.with_flags(COIN))
    .with(b'^', TileKind::EMPTY.with_flags(SPIKE));

const WIDTH: usize = 44;
const HEIGHT: usize = 6;
type Tiles = [[u8; WIDTH]; HEIGHT];
const START: Tiles = [
    *b"............................................",
    *b"................o...........................",
    *b"........................o...........o.......",
    *b".......o..............=====......./##\\......",
    *b"....../#\\...............^^......./####\\.....",
    *b"#############.......#######.################",
];
/// Cells of 16 x 16 units, row 0 on top.
const GRID: Grid = match Grid::new(WIDTH as u16, HEIGHT as u16, fx!(16), Vec2::ZERO) {
    Ok(grid) => grid,
    Err(_) => panic!("the grid is wrong"),
};

fn level_of(tiles: &Tiles) -> Result<TileMap<'_, Slopes>, TileMapError> {
    TileMap::of(tiles.as_flattened(), GRID, &KINDS)
}

/// A box that stands on the ground, 10 wide.
fn standing(x: i16, height: i16) -> Result<Aabb, RangeError> {
    Aabb::from_size(Vec2::from_ints(x, 80 - height), Vec2::from_ints(10, height))
}

#[derive(Clone, Copy)]
struct Game {
    tiles: Tiles,
    hero: Character,
    enemy: Option<(Character, Fx)>,
    lift: [Solid; 1],
    frame: u32,
    coins: u32,
    deaths: u32,
}

impl Game {
    fn new() -> Result<Self, Box<dyn Error>> {
        let limits = level_of(&START)?.bounds();
        let lift = Aabb::from_size(Vec2::from_ints(208, 80), Vec2::from_ints(32, 6))?;
        let enemy = Character::new(standing(500, 12)?, limits, Feel::DEFAULT);
        Ok(Self {
            tiles: START,
            hero: Character::new(standing(8, 14)?, limits, Feel::DEFAULT),
            enemy: Some((enemy, fx!(-0.75))),
            lift: [Solid::new(lift, 1)?],
            frame: 0,
            coins: 0,
            deaths: 0,
        })
    }

    /// One frame.
    fn step(&mut self, input: Input) -> Result<(), Box<dyn Error>> {
        let level = level_of(&self.tiles)?;
        // The lift crosses the gap in 80 frames, and comes back.
        let x = if (self.frame / 80).is_multiple_of(2) { fx!(1) } else { fx!(-1) };
        self.lift[0].set_motion(Vec2::new(x, fx!(0)))?;
        self.frame += 1;

        let step = self.hero.step_on(&level, &mut self.lift, input)?;
        let hurts = level.tiles_in(self.hero.body()).any(|tile| tile.kind.flag(SPIKE));
        let mut dies = hurts || step.outcome != Outcome::Moved;

        if let Some((enemy, run)) = &mut self.enemy {
            let walked = enemy.step(&level, Input { run: *run, ..Input::default() })?;
            if walked.wall || enemy.ledge_ahead(&level, enemy.stopping_distance(*run))? {
                *run = -*run;
            }
            if enemy.body().overlaps(self.hero.body()) {
                if self.hero.velocity.y > fx!(0) && !self.hero.on_floor() {
                    self.hero.velocity.y = fx!(-3); // off its head
                    self.enemy = None;
                } else {
                    dies = true;
                }
            }
        }
        if dies {
            self.deaths += 1;
            self.hero.place(standing(8, 14)?);
        }
        self.take_coins()
    }

    /// Takes all coins whose cells the hero overlaps.
    fn take_coins(&mut self) -> Result<(), Box<dyn Error>> {
        loop {
            let level = level_of(&self.tiles)?;
            let coin = level.tiles_in(self.hero.body()).find(|tile| tile.kind.flag(COIN));
            let Some(index) = coin.and_then(|tile| GRID.index_of(tile.cell)) else { return Ok(()) };
            self.tiles.as_flattened_mut()[index] = b'.';
            self.coins += 1;
        }
    }

    /// The player: to the right, by the lift, over the spikes.
    fn script(&self) -> Input {
        let x = self.hero.body().min().x;
        let on_lift = self.hero.ridden() == Some(1);
        let lift = self.lift[0].shape();
        let waits = if on_lift { lift.max().x < 318 } else { x > 190 && x < 200 && lift.min().x > 212 };
        let run = if waits { fx!(0) } else { fx!(1.5) };
        let meets = self.enemy.is_some_and(|(enemy, _)| (0..76).contains(&(enemy.body().min().x - x).to_num::<i32>()));
        // A button that is released cuts the jump, so it is held while the hero rises.
        let jump = self.hero.velocity.y < 0 || meets || (on_lift && x > 236 && x < 246) || (x > 338 && x < 345);
        Input { run, jump, drop: false }
    }

    /// Draws the level. `path` holds the places of the hero's middle.
    fn picture(&self, path: &[Vec2]) -> String {
        let mut cells = self.tiles;
        for &place in path {
            if let Some(index) = GRID.index_of(GRID.cell_at(place)) {
                let cell = &mut cells.as_flattened_mut()[index];
                *cell = if matches!(cell, b'.' | b'o') { b'+' } else { *cell };
            }
        }
        cells.iter().map(|row| String::from_utf8_lossy(row).replace('.', " ") + "\n").collect()
    }
}

/// Plays to the end of the level. Returns the places of the hero, and the game as it was in frame
/// 100.
fn play(game: &mut Game) -> Result<(Vec<Vec2>, Game), Box<dyn Error>> {
    let (mut path, mut saved) = (Vec::new(), *game);
    while game.deaths == 0 && game.frame < 1000 && game.hero.body().max().x < 690 {
        game.step(game.script())?;
        path.push(game.hero.body().centre());
        if game.frame == 100 {
            saved = *game;
        }
    }
    Ok((path, saved))
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut game = Game::new()?;
    let (path, mut saved) = play(&mut game)?;
    print!("{}", game.picture(&path));
    let enemy = if game.enemy.is_some() { "alive" } else { "stomped" };
    println!("{} frames, {} coins, {} deaths, the enemy is {enemy}", game.frame, game.coins, game.deaths);
    assert_eq!((game.coins, game.deaths, game.enemy.is_none()), (4, 0, true));

    // The saved game ends where this one did, bit for bit.
    play(&mut saved)?;
    assert_eq!((saved.frame, saved.hero.body()), (game.frame, game.hero.body()));
    Ok(())
}
