//! Balls on a pinball table with bumpers, slingshots, flippers and a kicker. Run it with `cargo run
//! --release --example pinball [-- FILE.png]`.
//!
//! `tilesat_games::pinball` is the game. Its table is tiles, joined to polygons and to two planks
//! that turn. Its balls fall and bounce on a surface that takes a little of their speed. Bumpers
//! and flippers push them. The picture, `target/pinball.png`, shows the ways of five balls in
//! twenty seconds.
#![allow(unreachable_pub, reason = "a program has no public interface; `pub` marks items that its other files use")]
#![allow(
    clippy::std_instead_of_core,
    clippy::float_arithmetic,
    clippy::cast_precision_loss,
    reason = "drawing, on a desktop"
)]

use std::process::ExitCode;

use tilesat::{Joined, MoveError, Vec2, World};
use tilesat_games::pinball::{Ball, Flippers, RADIUS, table};
use tilesat_tools::fail::{Fail, Result};
use tilesat_tools::picture::ink::{BOUNCE, COIN, CROSS, Ink, SLIDE, TOUCH};
use tilesat_tools::picture::sketch::{self, Sketch};

const FRAMES: u32 = 1200;
/// The number of balls.
const INKS: [Ink; 5] = [BOUNCE, COIN, CROSS, SLIDE, TOUCH];

fn main() -> ExitCode {
    sketch::exit("pinball", play())
}

fn play() -> Result<()> {
    let tiles = table::tiles().map_err(|e| Fail::new(e.to_string()))?;
    let table = Joined::new(&tiles, &table::SLINGSHOTS);
    let mut sketch = Sketch::new(&table, table::SIZE, 2);
    let mut flippers = Flippers::new().map_err(|e| Fail::new(e.to_string()))?;
    let mut fastest = 0;
    let mut meetings = 0;
    let start = |i: usize| {
        let (place, velocity) =
            (Vec2::from_ints(60 + 50 * i as i16, 30), Vec2::from_raw(70_000 * i as i32 - 150_000, 0));
        Ball::new(place, velocity).map_err(|e| Fail::new(e.to_string()))
    };
    let mut balls = [start(0)?, start(1)?, start(2)?, start(3)?, start(4)?];
    let mut ways: Vec<Vec<Vec2>> = balls.iter().map(|ball| vec![ball.body.centre()]).collect();
    for frame in 0..FRAMES {
        let fail = |e: MoveError| Fail::new(format!("frame {frame}: {e}"));
        flippers.step(&table, &mut balls).map_err(fail)?;
        let planks = flippers.level();
        let table = Joined::new(&table, &planks);
        for i in 0..balls.len() {
            balls[i].step(&table).map_err(fail)?;
            let (before, rest) = balls.split_at_mut(i);
            for other in before {
                meetings += u32::from(rest[0].meet(other, &table).map_err(fail)?);
            }
        }
        for (ball, way) in balls.iter().zip(&mut ways) {
            if table.overlaps_circle(&ball.body) {
                return Err(Fail::new(format!("frame {frame}: inside the table")));
            }
            fastest = fastest.max(ball.velocity.length().to_bits());
            way.push(ball.body.centre());
        }
    }
    for solid in flippers.level().list() {
        let [a, b, c, d] = solid.shape().corners();
        sketch.way(&[a, b, c, d, a], 2.0, COIN);
    }
    for ((ball, way), ink) in balls.iter().zip(&ways).zip(INKS) {
        sketch.way(way, 1.2, ink.alpha(0.6));
        sketch.ring(ball.body.centre(), RADIUS.to_num(), 3.0, ink);
    }
    let sum = |count: fn(&Ball) -> u32| balls.iter().map(count).sum::<u32>();
    let (bumps, kicks, flips) = (sum(|b| b.bumps), sum(|b| b.kicks), sum(|b| b.flips));
    let summary = format!(
        "balls={} frames={FRAMES} meetings={meetings} bumps={bumps} kicks={kicks} flips={flips} fastest={:.2}",
        balls.len(),
        f64::from(fastest) / 65536.0
    );
    println!("{summary}");
    sketch.save("pinball.png", &[summary])
}
