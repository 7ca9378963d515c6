//! A ninja among boxes and balls on one screen of all shapes.
//!
//! Left and right run. A jumps. Hold Select at power-on for 64 bodies instead of 32. Start ends the
//! game and prints its cost.
#![no_std]
#![no_main]

mod crowd;
mod draw;
mod level;

use crowd::Crowd;
use tilesat_games::ninja::{Keys, Ninja};
use tilesat_gba::cycles::{self, FRAME};
use tilesat_gba::pad::{Key, Pad};
use tilesat_gba::{entry, println, sample, screen, stack};

entry!(main);

/// The cost of the frames so far.
#[derive(Default)]
struct Cost {
    frames: u32,
    sum: u64,
    most: u32,
    /// Frames whose work took longer than one picture.
    late: u32,
}

impl Cost {
    fn add(&mut self, collision: u32, all: u32) {
        self.frames += 1;
        self.sum += u64::from(collision);
        self.most = self.most.max(collision);
        self.late += u32::from(all > FRAME);
    }
}

fn main() -> i32 {
    match play() {
        Ok(()) => 0,
        Err(why) => {
            println!("{why}");
            1
        }
    }
}

fn play() -> Result<(), &'static str> {
    let level = level::map().map_err(|_| "the level is invalid")?;
    let mut ninja = Ninja::new(level::START).map_err(|_| "the ninja starts outside the domain")?;
    let count = if Pad::read().is_down(Key::Select) { crowd::MOST } else { crowd::MOST / 2 };
    let mut crowd = Crowd::EMPTY;
    crowd.fill(&level, count).ok_or("there is no room for the bodies")?;
    draw::prepare(&level);
    screen::on();

    let (mut cost, mut drawing, mut hash) = (Cost::default(), 0, 0x811c_9dc5);
    loop {
        let pad = Pad::read();
        if pad.is_down(Key::Start) {
            break;
        }
        let run = i32::from(pad.is_down(Key::Right)) - i32::from(pad.is_down(Key::Left));
        cycles::start();
        sample::resume();
        ninja.step(&level, Keys { run, jump: pad.is_down(Key::A) }).map_err(|_| "the ninja cannot move")?;
        crowd.step(&level).map_err(|_| "a body cannot move")?;
        sample::pause();
        let collision = cycles::stop();
        hash = crowd.hash(hash);

        screen::wait();
        cycles::start();
        draw::bodies(&ninja, &crowd);
        // Shows the last frame, because this one is not over.
        draw::bar(collision, collision + drawing, count);
        drawing = cycles::stop();
        cost.add(collision, collision + drawing);
    }
    let Cost { frames, sum, most, late } = cost;
    let mean = sum / u64::from(frames.max(1));
    sample::print();
    let stack = stack::used().0;
    println!("bodies={count} frames={frames} mean={mean} most={most} late={late} stack={stack} hash={hash:08x}");
    Ok(())
}
