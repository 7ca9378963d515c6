//! Rollback: `cargo run --release --example rollback [-- FRAMES]`.
//!
//! Two machines play one game of 64 bodies over a link that loses, doubles and reorders packets.
//! `tilesat_games::rollback` has a file for each part: keys, a link, prediction and rollback. After
//! each frame that both have confirmed, both states equal those of a game without a network, bit
//! for bit. An independent account counts the frames that had to be replayed, and no machine
//! replays more.

mod cost;

use std::process::ExitCode;

use tilesat_games::rollback::{Broken, DELAY, Matched, Totals, WINDOW, Weather, arena};

const FRAMES: u32 = 100_000;

/// Kinds of links, and each one's share of the frames.
const LINKS: [(&str, Weather, u32); 4] = [
    ("one room", Weather { loss: 0, doubled: 0, least: 1, most: 1 }, 10),
    ("one city", Weather { loss: 2, doubled: 1, least: 2, most: 4 }, 10),
    ("a train", Weather { loss: 15, doubled: 5, least: 3, most: 9 }, 1),
    ("a tunnel", Weather { loss: 70, doubled: 5, least: 4, most: 12 }, 10),
];

fn main() -> ExitCode {
    let frames = std::env::args().nth(1).map_or(Ok(FRAMES), |frames| frames.parse());
    let done = frames.map_err(Into::into).and_then(play);
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("rollback: {error}");
            ExitCode::FAILURE
        }
    }
}

fn play(frames: u32) -> Result<(), Box<dyn std::error::Error>> {
    println!("keys take effect after {DELAY} frames; a machine plays up to {WINDOW} frames ahead\n");
    println!("link       frames  packets    lost  twice  overtaken  rollbacks      replayed  at most  waits  awake");
    for (name, weather, part) in LINKS {
        let Totals { confirmed, sent, lost, doubled, overtaken, rollbacks, again, deepest, waits, awake, .. } =
            run(weather, frames / part)?;
        println!(
            "{name:<9} {confirmed:>7}  {sent:>7} {lost:>7} {doubled:>6} {overtaken:>10} {rollbacks:>10} {again:>13} {deepest:>8} {waits:>6} {:>6}",
            awake / u64::from(confirmed.max(1)),
        );
    }
    println!("\nall confirmed states are equal, and no frame was replayed without need");
    cost::print(arena()?)?;
    Ok(())
}

fn run(weather: Weather, frames: u32) -> Result<Totals, Box<dyn std::error::Error>> {
    let mut matched = Matched::new(arena()?, weather, 22)?;
    while matched.totals().confirmed < frames {
        matched.call().map_err(|broken: Broken| Box::new(broken))?;
    }
    Ok(matched.totals())
}
