//! Runs the simulation and watches it.

use std::collections::{HashSet, VecDeque};
use std::io::Write;
use std::time::{Duration, Instant};

use tilesat::world::{Grid, Outside, Set, TileMap};
use tilesat::{AllShapes, Blocks, Fx, Vec2};

use tilesat_games::platformer::sim::{Actor, BODIES, NoRoom, Score, Shape, Sim};

use super::check::Checker;
use super::figure::Figure;
use super::flags;
use super::trail::Point;
use crate::bake::level::Level;
use crate::fail::{Fail, Result};

/// Frames of trail that are kept for the player and for the others.
const PLAYER_TRAIL: usize = 2400;
const TRAIL: usize = 180;

/// What a run left behind.
#[derive(Debug, Clone)]
pub struct Run {
    pub frames: u32,
    pub contacts: u64,
    pub overlaps: u64,
    pub escaped: u64,
    pub refused: u64,
    pub hash: u32,
    pub score: Score,
    /// Where the bodies ended, the player first.
    pub actors: Vec<Actor>,
    /// Per body, its last middle points; a jump back to the start begins a new piece.
    pub trails: Vec<VecDeque<Point>>,
    /// The cells whose coins are gone, counted row by row.
    pub taken: HashSet<usize>,
}

impl Run {
    /// The last line of the program: counts, and the hash of all frames.
    pub fn line(&self) -> String {
        format!(
            "frames={} bodies={BODIES} contacts={} overlaps={} escaped={} hash={:08x}",
            self.frames, self.contacts, self.overlaps, self.escaped, self.hash
        )
    }
}

/// Plays `frames` frames; says on `err` how far it is when that takes more than a second.
///
/// # Errors
///
/// The level has no free cell, or the library does not take it.
pub fn play(level: &Level, frames: u32, seed: u32, err: &mut dyn Write) -> Result<Run> {
    // A level of blocks is played with code for blocks alone, as on a chip.
    if level.is_blocks() { run::<Blocks>(level, frames, seed, err) } else { run::<AllShapes>(level, frames, seed, err) }
}

fn run<S: Set>(level: &Level, frames: u32, seed: u32, err: &mut dyn Write) -> Result<Run> {
    let kinds = level.kinds();
    let map = Grid::new(level.width, level.height, Fx::from_num(level.tile), Vec2::ZERO)
        .and_then(|grid| TileMap::<S>::of(&level.tiles, grid, &kinds))
        .map_err(|e| Fail::new(format!("the map does not fit: {e}")))?
        .with_outside(Outside::Solid);
    let mut sim = Sim::new(&map, flags::rules(level), seed)
        .map_err(|NoRoom| Fail::new("no room for the bodies: the level has no free cell"))?;
    let checker = Checker::new(level);
    let mut figures = sim.bodies().map(|a| figure(&a));
    let mut run = Run {
        frames,
        contacts: 0,
        overlaps: figures.iter().filter(|f| checker.overlaps(f)).count() as u64,
        escaped: figures.iter().filter(|f| !checker.inside(f)).count() as u64,
        refused: 0,
        hash: sim.hash(),
        score: sim.score(),
        actors: Vec::new(),
        trails: vec![VecDeque::new(); BODIES],
        taken: HashSet::new(),
    };
    let mut clock = Instant::now();
    for frame in 0..frames {
        let report = sim.step(&map);
        run.contacts += u64::from(report.contacts);
        run.refused += u64::from(report.refused);
        for (i, (actor, before)) in sim.bodies().iter().zip(&mut figures).enumerate() {
            let now = figure(actor);
            let fresh = i == 0 && report.respawned;
            let (x, y) = actor.asked.raw();
            // A body that was put back did not move there.
            let from = if fresh { now } else { *before };
            let fault = checker.check(&from, &now, (i64::from(x), i64::from(y)));
            run.overlaps += u64::from(fault.overlap);
            run.escaped += u64::from(fault.escape);
            *before = now;
            let keep = if i == 0 { PLAYER_TRAIL } else { TRAIL };
            if frames - frame <= keep as u32 {
                let met = actor.hit.filter(|_| !fresh);
                let contact = met.map(|hit| Point::contact(&from, &hit, actor.asked));
                let point = Point::end(&now, fresh);
                run.trails[i].extend(contact.into_iter().chain([point]));
            }
        }
        if frame % 256 == 0 && clock.elapsed() > Duration::from_secs(1) {
            clock = Instant::now();
            let _ = writeln!(err, "frame {frame} of {frames}");
        }
    }
    run.hash = sim.hash();
    run.score = sim.score();
    run.actors = sim.bodies().to_vec();
    let coins = flags::coins(level).zip(0..);
    run.taken = coins.filter(|&(_, coin)| sim.collected(coin)).map(|(cell, _)| cell).collect();
    Ok(run)
}

fn figure(actor: &Actor) -> Figure {
    let wide = |(x, y): (i32, i32)| (i64::from(x), i64::from(y));
    match actor.shape {
        Shape::Box(b) => Figure::Box { min: wide(b.min().raw()), max: wide(b.max().raw()) },
        Shape::Ball(c) => Figure::Disc { centre: wide(c.centre().raw()), radius: i64::from(c.radius().to_bits()) },
    }
}
