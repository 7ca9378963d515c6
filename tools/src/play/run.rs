//! Runs the simulation and checks it.

use std::collections::{HashSet, VecDeque};
use std::io::Write;
use std::time::{Duration, Instant};

use tilesat::world::{Grid, Outside, ShapeSet, TileMap, World};
use tilesat::{AllShapes, Blocks, Joined, SegmentMap, Vec2};

use tilesat_games::platformer::sim::{Actor, BODIES, FrameReport, NoRoom, Score, Shape, Sim};

use super::arena::Arena;
use super::check::Checker;
use super::drift::Drift;
use super::figure::Figure;
use super::flags;
use super::trail::Point;
use crate::bake::level::Level;
use crate::fail::{Fail, Result};

/// Frames of trail for the player and for the others.
const PLAYER_TRAIL: usize = 2400;
const TRAIL: usize = 180;

/// The traces of a run.
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
    /// The last middle points of each body. A jump back to the start begins a new piece.
    pub trails: Vec<VecDeque<Point>>,
    /// The cells whose coins are gone, counted row by row.
    pub taken: HashSet<usize>,
    /// Whether the player started where the level says.
    pub at_spawn: bool,
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

/// Plays `frames` frames. Reports progress on `err` if that takes more than a second.
///
/// # Errors
///
/// If the level has no free cell, or the library refuses it.
pub fn play(arena: &Arena, frames: u32, seed: u32, err: &mut dyn Write) -> Result<Run> {
    let level = &arena.level;
    let kinds = level.kinds();
    let too_large = |e: &dyn std::fmt::Display| Fail::new(format!("the map does not fit: {e}"));
    let grid = level.grid().map_err(|e| too_large(&e))?;
    let checker = Checker::new(level);
    let feet = arena.spawn.as_ref().map(|(spawn, _)| spawn.feet);
    let Some(bytes) = &arena.segments else {
        // A level of blocks runs code for blocks only, as on a chip.
        if level.origin != (0, 0) {
            let map = TileMap::<AllShapes>::of(&level.tiles, grid, &kinds).map_err(|e| too_large(&e))?;
            let start = (grid, feet);
            return drift(&map.with_outside(Outside::Solid), start, &checker, (frames, seed), err);
        }
        let run = if level.is_blocks() { game::<Blocks> } else { game::<AllShapes> };
        return run((level, feet), &checker, (frames, seed), err);
    };
    let map = TileMap::<AllShapes>::of(&level.tiles, grid, &kinds).map_err(|e| too_large(&e))?;
    let map = map.with_outside(Outside::Solid);
    let segments = SegmentMap::from_bytes(bytes).map_err(|e| Fail::new(format!("the segments: {e}")))?;
    drift(&Joined::new(&map, &segments), (grid, feet), &checker.with_segments(bytes), (frames, seed), err)
}

/// The traces of one frame.
struct Frame {
    report: FrameReport,
    actors: [Actor; BODIES],
    hash: u32,
}

/// The game, which knows only tiles.
fn game<S: ShapeSet>(
    (level, feet): (&Level, Option<Vec2>),
    checker: &Checker,
    (frames, seed): (u32, u32),
    err: &mut dyn Write,
) -> Result<Run> {
    let kinds = level.kinds();
    let map = level
        .grid()
        .and_then(|grid| TileMap::<S>::of(&level.tiles, grid, &kinds))
        .map_err(|e| Fail::new(format!("the map does not fit: {e}")))?
        .with_outside(Outside::Solid);
    let mut sim = Sim::new(&map, flags::rules(level), seed).map_err(|NoRoom| no_room())?;
    let at_spawn = feet.is_some_and(|feet| sim.start_at(&map, feet));
    let start = Frame { report: FrameReport::default(), actors: *sim.bodies(), hash: sim.hash() };
    let mut run = watch(checker, &start, frames, err, || {
        let report = sim.step(&map);
        Frame { report, actors: *sim.bodies(), hash: sim.hash() }
    });
    (run.score, run.at_spawn) = (sim.score(), at_spawn);
    let coins = flags::coins(level).zip(0..);
    run.taken = coins.filter(|&(_, coin)| sim.collected(coin)).map(|(cell, _)| cell).collect();
    Ok(run)
}

/// Boxes and balls only, in any level.
fn drift<W: World>(
    world: &W,
    (grid, feet): (Grid, Option<Vec2>),
    checker: &Checker,
    (frames, seed): (u32, u32),
    err: &mut dyn Write,
) -> Result<Run> {
    let mut drift = Drift::new(world, grid, seed).ok_or_else(no_room)?;
    let at_spawn = feet.is_some_and(|feet| drift.start_at(world, feet));
    let start = Frame { report: FrameReport::default(), actors: *drift.bodies(), hash: drift.hash() };
    let mut run = watch(checker, &start, frames, err, || {
        let report = drift.step(world);
        Frame { report, actors: *drift.bodies(), hash: drift.hash() }
    });
    run.at_spawn = at_spawn;
    Ok(run)
}

fn no_room() -> Fail {
    Fail::new("no room for the bodies: the level has no free cell")
}

/// Checks every body in every frame.
fn watch(checker: &Checker, start: &Frame, frames: u32, err: &mut dyn Write, mut step: impl FnMut() -> Frame) -> Run {
    let mut figures = start.actors.map(|a| figure(&a));
    let mut run = Run {
        frames,
        contacts: 0,
        overlaps: figures.iter().filter(|f| checker.overlaps(f)).count() as u64,
        escaped: figures.iter().filter(|f| !checker.inside(f)).count() as u64,
        refused: 0,
        hash: start.hash,
        score: Score::default(),
        actors: start.actors.to_vec(),
        trails: vec![VecDeque::new(); BODIES],
        taken: HashSet::new(),
        at_spawn: false,
    };
    let mut clock = Instant::now();
    for frame in 0..frames {
        let Frame { report, actors, hash } = step();
        run.contacts += u64::from(report.contacts);
        run.refused += u64::from(report.refused);
        for (i, (actor, before)) in actors.iter().zip(&mut figures).enumerate() {
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
        (run.hash, run.actors) = (hash, actors.to_vec());
        if frame % 256 == 0 && clock.elapsed() > Duration::from_secs(1) {
            clock = Instant::now();
            let _ = writeln!(err, "frame {frame} of {frames}");
        }
    }
    run
}

fn figure(actor: &Actor) -> Figure {
    let wide = |(x, y): (i32, i32)| (i64::from(x), i64::from(y));
    match actor.shape {
        Shape::Box(b) => Figure::Box { min: wide(b.min().raw()), max: wide(b.max().raw()) },
        Shape::Ball(c) => Figure::Disc { centre: wide(c.centre().raw()), radius: i64::from(c.radius().to_bits()) },
    }
}
