//! A character among moving platforms: `cargo run --release --example platforms [-- FILE.png]`.
//!
//! It walks over steps and slopes, is conveyed over a pit, waits for a crusher, takes a lift, jumps through a one-way lift, rides up and drops
//! through the ledge there. `game.rs` is the game; this is the level, the script and the picture, `target/platforms.png`.
#![allow(unreachable_pub, reason = "a program has no outside; `pub` marks what other files of it use")]
#![allow(
    clippy::std_instead_of_core,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    clippy::indexing_slicing,
    reason = "drawing, on a desktop"
)]

mod game;
#[allow(dead_code, reason = "its canvas is used here")]
#[path = "../platformer/main.rs"]
mod platformer;
#[allow(dead_code, reason = "shared by the small games")]
#[path = "../sketch/mod.rs"]
mod sketch;
#[path = "../sheet/solid.rs"]
mod solid;

use std::process::ExitCode;

use game::{CRUSHER, Game, Keys, LIFT, MACHINES, SHELF};
use platformer::fail::{Fail, Result};
use platformer::picture::ink::{BOUNCE, COIN, CROSS, EDGE, PLANK, SLIDE};
use sketch::Sketch;
use tilesat::{Ride, TileKind, TileKinds, TileMap, TileShape, Vec2, World};

const ROWS: &str = "\
##################################################
#................................................#
#...........................================.....#
#................................................#
#................................................#
#................................................#
#....................................../#_.......#
#.......................##########...#############
#.......................##########...#############
#....................................#############
#....................................#############
#....................................#############
#...._##\\..abcd......................#############
#################......###########...#############
#################......###########################
##################################################
";
static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'=', TileKind::ONE_WAY_UP)
    .with(b'_', TileKind::of(TileShape::HalfBottom))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight))
    .with(b'c', TileKind::of(TileShape::MildHighBottomLeft))
    .with(b'd', TileKind::of(TileShape::MildLowBottomLeft));

const NONE: Keys = Keys { run: 0, jump: false, drop: false };
const RIGHT: Keys = Keys { run: 1, ..NONE };
const LEFT: Keys = Keys { run: -1, ..NONE };

/// Keys, and until when they are held.
type Stretch = (Keys, fn(&Game) -> bool);
const SCRIPT: [Stretch; 16] = [
    (RIGHT, |game| game.at().x > 280),
    (NONE, |game| game.at().x > 370), // the belt takes it there
    (RIGHT, |game| game.at().x > 436),
    (NONE, |game| game.is_back(CRUSHER)),
    (RIGHT, |game| game.at().x > 530),
    (NONE, |game| game.is_back(LIFT)),
    (RIGHT, |game| game.at().x > 568),
    (NONE, |game| game.at().y < 106),
    (RIGHT, |game| game.at().x > 728),
    (NONE, |game| game.is_back(SHELF)),
    (Keys { jump: true, ..NONE }, |game| game.at().y < 88), // through it from below
    (NONE, |game| game.floor.is_some()),
    (NONE, |game| game.at().y < 26),
    (LEFT, |game| game.at().x < 520),
    (Keys { drop: true, ..NONE }, |game| game.floor.is_none()),
    (LEFT, |game| game.at().x < 420),
];

/// A minute is enough.
const FRAMES: u32 = 3600;

fn main() -> ExitCode {
    sketch::exit("platforms", play())
}

fn play() -> Result<()> {
    let level = TileMap::of_ascii(ROWS, &KINDS).map_err(|e| Fail::new(e.to_string()))?;
    let mut game = Game::new(level, (40, 208)).map_err(|e| Fail::new(e.to_string()))?;
    let mut sketch = Sketch::new(&game.level, (50 * 16, 16 * 16), 2);
    for machine in &MACHINES {
        for (y, ink) in [(machine.way, EDGE.alpha(0.25)), (0, PLANK.alpha(0.8))] {
            let [x0, y0, x1, y1] = machine.at;
            let (min, max) = (sketch.spot(Vec2::from_ints(x0, y0 + y)), sketch.spot(Vec2::from_ints(x1, y1 + y)));
            sketch.scene.rect(min, (max.0 - min.0, max.1 - min.1), ink);
        }
    }
    let (mut frame, mut done, mut dropped) = (0, 0, 0);
    while let Some((keys, until)) = SCRIPT.get(done)
        && frame < FRAMES
    {
        let (from, stepped) = (game.at(), game.stepped);
        let ride = game.step(*keys).map_err(|e| Fail::new(format!("frame {frame}: {e}")))?;
        if matches!(ride, Ride::Squashed { .. }) || game.level.overlaps_aabb(&game.body) {
            return Err(Fail::new(format!("frame {frame}: squashed")));
        }
        frame += 1;
        dropped += u32::from(keys.drop);
        let at = game.at();
        let walks = if game.floor.is_some() { BOUNCE } else { CROSS };
        let ink = if ride == Ride::Carried { SLIDE } else { walks };
        sketch.way(&[from, at], 2.5, ink);
        if game.stepped != stepped {
            sketch.dot(at, COIN);
        }
        if frame % 16 == 0 {
            let (lo, hi) = (game.body.min(), game.body.max());
            sketch.way(&[lo, Vec2::new(hi.x, lo.y), hi, Vec2::new(lo.x, hi.y), lo], 1.0, ink.alpha(0.5));
        }
        done += usize::from(until(&game));
    }
    let all = done == SCRIPT.len();
    let summary = format!(
        "frames={frame} stepped={:.1} carried={} dropped={dropped} done={all}",
        game.stepped.to_num::<f32>(),
        game.carried
    );
    println!("{summary}");
    let legend =
        "green: walks; blue: is carried; violet: in the air; yellow: steps; brown: machines, and where they go";
    sketch.save("platforms.png", &[summary, legend.to_owned()])?;
    if all { Ok(()) } else { Err(Fail::new(format!("the script stopped in stretch {done}"))) }
}
