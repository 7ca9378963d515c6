//! Runs a program for the Game Boy Advance without a window, in any libretro core of that console,
//! such as mGBA's. Prints its log, presses its keys, and exits with its status.
//!
//! ```text
//! tilesat-gba-run CORE PROGRAM.elf [--rom FILE.gba] [--png FILE] [--scale N] [--keys STRETCHES] [--frames N]
//!   --rom     writes the cartridge's image as well
//!   --png     saves the last picture, each pixel N x N
//!   --keys    stretches of frames with keys down, for example "60 20:right 5:right+a 30:left"; none after the last
//!   --frames  ends the run after so many frames, with status 124 (36000)
//! ```

mod core;
mod host;
mod keys;
mod picture;
mod rom;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

const USAGE: &str =
    "tilesat-gba-run CORE PROGRAM.elf [--rom FILE.gba] [--png FILE] [--scale N] [--keys STRETCHES] [--frames N]";
/// The same status as `timeout`.
const TOO_LONG: u8 = 124;

struct Options {
    core: PathBuf,
    program: PathBuf,
    rom: Option<PathBuf>,
    png: Option<PathBuf>,
    scale: usize,
    keys: Vec<u16>,
    frames: usize,
}

fn options() -> Result<Options, Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let (core, program) = words.next().zip(words.next()).ok_or(USAGE)?;
    let (core, program) = (PathBuf::from(core), PathBuf::from(program));
    let mut options = Options { core, program, rom: None, png: None, scale: 1, keys: Vec::new(), frames: 36_000 };
    while let Some(word) = words.next() {
        let value = words.next().ok_or(USAGE)?;
        match word.as_str() {
            "--rom" => options.rom = Some(value.into()),
            "--png" => options.png = Some(value.into()),
            "--scale" => options.scale = value.parse()?,
            "--keys" => options.keys = keys::parse(&value)?,
            "--frames" => options.frames = value.parse()?,
            _ => return Err(USAGE.into()),
        }
    }
    Ok(options)
}

fn run() -> Result<u8, Box<dyn Error>> {
    let options = options()?;
    let rom = rom::from_elf(&std::fs::read(&options.program)?)?;
    if let Some(path) = &options.rom {
        std::fs::write(path, &rom)?;
    }
    let core = core::Core::load(&options.core, &rom)?;
    let keys = options.keys.iter().copied().chain(std::iter::repeat(0));
    let status = keys.take(options.frames).find_map(|keys| core.frame(keys));
    if let Some(path) = &options.png {
        picture::save(path, &host::screen(), options.scale)?;
    }
    if status.is_none() {
        eprintln!("still running after {} frames", options.frames);
    }
    Ok(status.unwrap_or(TOO_LONG))
}

fn main() -> ExitCode {
    run().map_or_else(
        |error| {
            eprintln!("{error}");
            ExitCode::from(2)
        },
        ExitCode::from,
    )
}
