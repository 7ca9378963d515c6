//! Bullets everywhere: `cargo run --release --example bullets [-- FILE.png]`.
//!
//! 32 enemies fill two galleries and an arena with up to 240 bullets. The player walks among them,
//! shoots, gets hit, and is repaired in its zone. `tilesat_games::bullets` is the game. It runs
//! unchanged on a microcontroller (`examples/bullets_firmware.rs`), to the same hash. In every
//! frame, `check.rs` finds all pairs, all events and all walls again by other means. The picture,
//! `target/bullets.png`, is the last frame, with the ways of half a second.
#![allow(unreachable_pub, reason = "a program has no public interface; `pub` marks items that its other files use")]
#![allow(
    clippy::std_instead_of_core,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    reason = "drawing, on a desktop"
)]

mod check;
mod others;
mod rooms;

use std::collections::BTreeMap;
use std::process::ExitCode;

use check::{Judge, everybody};
use others::Others;
use tilesat::Vec2;
use tilesat::broad::{BroadPhase, Handle};
use tilesat_games::bullets::{self, FRAMES, Game, Kind, Near, SIZE, SPONGE};
use tilesat_tools::fail::{Fail, Result};
use tilesat_tools::picture::ink::{BOUNCE, COIN, CROSS, Ink, KILL, PLANK, PLAYER, SLIDE, TOUCH, WATER};
use tilesat_tools::picture::sketch::{self, Sketch};

/// The number of frames whose ways are drawn.
const TRAIL: u32 = 14;

fn main() -> ExitCode {
    sketch::exit("bullets", play())
}

fn play() -> Result<()> {
    let level = bullets::level().map_err(|e| Fail::new(e.to_string()))?;
    let mut game = Game::new(Near::new());
    game.start();
    let mut others = Others::new()?;
    let mut judge = Judge::new();
    let mut ways = BTreeMap::<Handle, Vec<Vec2>>::new();
    let mut rounds: Vec<Vec<Vec2>> = Vec::new();
    while game.frame < FRAMES {
        let (frame, before) = (game.frame, game);
        let fail = |why: String| Fail::new(format!("frame {frame}: {why}"));
        game.fly(&level);
        judge.flights(&before, &game).map_err(fail)?;
        let flown = game;
        game.meet();
        judge.meetings(&flown, &game).map_err(fail)?;
        let met = game;
        game.fire();
        judge.shots(&met, &game);
        others.step(&level, &game).map_err(fail)?;
        if frame + TRAIL >= FRAMES {
            for handle in everybody(&game.near) {
                ways.entry(handle).or_default().extend(game.circle(handle).map(|circle| circle.centre()));
            }
        }
        match (met.player().and_then(|player| met.circle(player)), rounds.last_mut()) {
            (None, _) => rounds.push(Vec::new()),
            (Some(circle), Some(round)) => round.push(circle.centre()),
            (Some(circle), None) => rounds.push(vec![circle.centre()]),
        }
    }
    println!("checked {judge}");
    println!("{game}");

    let mut sketch = Sketch::new(&level, (16 * i32::from(SIZE.0), 16 * i32::from(SIZE.1)), 2);
    for tile in bullets::bounds().iter().flat_map(|all| level.tiles_in(all)).filter(|tile| tile.kind.flag(SPONGE)) {
        let corner = Vec2::from_ints(16 * tile.cell.x, 16 * tile.cell.y);
        sketch.scene.rect(sketch.spot(corner), (32.0, 32.0), PLANK.alpha(0.5));
    }
    for round in rounds.iter().filter(|round| !round.is_empty()) {
        sketch.way(round, 1.5, PLAYER.alpha(0.35));
    }
    for handle in everybody(&game.near) {
        draw(&mut sketch, &game, handle, ways.get(&handle).map_or(&[], Vec::as_slice));
    }
    let line = game.to_string();
    let (first, second) = line.split_once(" kills").unwrap_or((&line, ""));
    let legend = "yellow: the player, its way, its shots; red: turrets; violet: spinners; orange: patrols, blue asleep; \
                  green: repairs; brown: swallows";
    sketch.save("bullets.png", &[first.to_owned(), format!("kills{second}"), legend.to_owned()])
}

fn ink(kind: Kind) -> Ink {
    match kind {
        Kind::Zone => BOUNCE,
        Kind::Player => PLAYER,
        Kind::Turret => KILL,
        Kind::Spinner => CROSS,
        Kind::Patrol => TOUCH,
        Kind::Bullet => SLIDE,
        Kind::Shot => COIN,
    }
}

fn draw(sketch: &mut Sketch, game: &Game, handle: Handle, way: &[Vec2]) {
    let (Some(body), Some(circle), Ok(bounds)) = (game.body(handle), game.circle(handle), game.near.bounds(handle))
    else {
        return;
    };
    let (kind, radius) = (body.kind, circle.radius().to_num::<f32>());
    let asleep = kind == Kind::Patrol && game.near.tag(handle).is_ok_and(|filter| filter.still());
    let ink = if asleep { WATER } else { ink(kind) };
    match kind {
        Kind::Zone => {
            let (lo, hi) = (sketch.spot(bounds.min()), sketch.spot(bounds.max()));
            sketch.scene.rect(lo, (hi.0 - lo.0, hi.1 - lo.1), ink.alpha(0.2));
        }
        Kind::Bullet | Kind::Shot => {
            sketch.way(way, 1.2, ink.alpha(0.35));
            sketch.dot(circle.centre(), ink);
        }
        _ => sketch.ring(circle.centre(), radius, 3.0, ink),
    }
}
