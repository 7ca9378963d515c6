//! Replays the corpus on any toolchain, and continues from it without guidance.
//!
//! `replay [--random N] [TARGET...]` runs every committed input of the targets, `faults` included.
//! By default it runs all targets. Then it runs N changed inputs of each target. Prints the number
//! of an input that fails, and writes its bytes beside the program.

mod inputs;

use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use inputs::inputs;
use tilesat_fuzz::{TARGETS, check};

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 33) as usize % n.max(1)
    }

    /// A committed input with a few changed bytes, or random bytes.
    fn input(&mut self, seeds: &[Vec<u8>]) -> Vec<u8> {
        let mut data = match self.below(4) {
            0 => Vec::new(),
            _ => seeds.get(self.below(seeds.len())).cloned().unwrap_or_default(),
        };
        for _ in 0..self.below(if data.is_empty() { 200 } else { 6 }) {
            let (at, byte) = (self.below(data.len() + 1), self.below(256) as u8);
            match data.get_mut(at) {
                Some(there) if self.below(4) > 0 => *there = byte,
                _ => data.insert(at, byte),
            }
        }
        data
    }
}

/// Runs one input. Keeps it if it fails.
fn run(target: &str, data: &[u8], what: &str) -> bool {
    if std::panic::catch_unwind(|| check(target, data)).is_ok() {
        return true;
    }
    let path = std::env::temp_dir().join(format!("tilesat-fuzz-{target}.bin"));
    let kept = fs::write(&path, data).is_ok();
    println!("{target}: FAILED on {what}; {}", if kept { path.display().to_string() } else { format!("{data:?}") });
    false
}

fn main() -> ExitCode {
    let (mut random, mut wanted) = (0u32, Vec::new());
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--random" => random = args.next().and_then(|n| n.parse().ok()).expect("--random N"),
            _ => wanted.push(arg),
        }
    }
    if let Some(unknown) = wanted.iter().find(|name| TARGETS.iter().all(|(target, _)| target != name)) {
        eprintln!("replay: no target {unknown}");
        return ExitCode::from(2);
    }
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut good = true;
    for (target, _) in TARGETS.iter().filter(|(name, _)| wanted.is_empty() || wanted.iter().any(|w| w == name)) {
        let begin = Instant::now();
        let seeds =
            ["corpus", "faults"].iter().flat_map(|folder| inputs(&here.join(folder), target)).collect::<Vec<_>>();
        let mut failed = seeds.iter().filter(|seed| !run(target, &seed.bytes, &seed.place)).count();
        let bytes: Vec<Vec<u8>> = seeds.into_iter().map(|seed| seed.bytes).collect();
        let mut r = Random(0x7113);
        for case in 0..random {
            if failed == 0 && !run(target, &r.input(&bytes), &format!("random case {case}")) {
                failed += 1;
            }
        }
        // An empty corpus would always pass.
        let empty = bytes.is_empty();
        println!(
            "{target:13} {:4} inputs, {random} random, {failed} failed, {:5.1} s{}",
            bytes.len(),
            begin.elapsed().as_secs_f64(),
            if empty { ", NO CORPUS" } else { "" }
        );
        good &= failed == 0 && (!empty || random > 0);
    }
    ExitCode::from(u8::from(!good))
}
