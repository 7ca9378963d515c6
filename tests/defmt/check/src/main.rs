//! Decodes the firmware's log and compares it with the reviewed lines. Compares its types with
//! those in the documentation.
//!
//! ```text
//! tilesat-defmt-check PROGRAM.elf FRAMES DOCUMENTATION EXPECTED [--accept]
//! ```

mod frames;
mod types;

use std::collections::BTreeSet;
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (files, accept) = match args.split_last() {
        Some((last, files)) if last == "--accept" => (files, true),
        _ => (&args[..], false),
    };
    let [elf, frames, docs, expected] = files else {
        eprintln!("usage: tilesat-defmt-check PROGRAM.elf FRAMES DOCUMENTATION EXPECTED [--accept]");
        return ExitCode::from(2);
    };
    match check(Path::new(elf), Path::new(frames), Path::new(docs), Path::new(expected), accept) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(e) => {
            eprintln!("check: {e}");
            ExitCode::FAILURE
        }
    }
}

fn check(elf: &Path, frames: &Path, docs: &Path, expected: &Path, accept: bool) -> Result<bool, Box<dyn Error>> {
    let bytes = std::fs::read(frames)?;
    let lines = frames::decode(&std::fs::read(elf)?, &bytes)?;
    let told: BTreeSet<&str> = lines.iter().map(|line| line.path.as_str()).collect();
    let public = types::public(docs)?;
    let mut good = true;
    for path in public.iter().filter(|path| !told.contains(path.as_str())) {
        good = false;
        println!("no line: the public type {path} is not logged by tests/defmt/firmware");
    }
    for path in told.iter().filter(|path| !public.contains(**path)) {
        good = false;
        println!("no type: {path} is logged, but the documentation has no such public type");
    }
    // A type by its name only: the file that defines it is not promised.
    let name = |path: &str| path.rsplit("::").next().unwrap_or_default().to_owned();
    let text: String = lines.iter().map(|line| format!("{} = {}\n", name(&line.path), line.value)).collect();
    if accept {
        std::fs::write(expected, &text)?;
    }
    good &= same(&std::fs::read_to_string(expected)?, &text);
    let kinds = public.len();
    println!(
        "{} lines of {kinds} public types in {} bytes of frames, {}",
        lines.len(),
        bytes.len(),
        if good { "ok" } else { "FAILED" }
    );
    Ok(good)
}

/// Reports where two texts differ.
fn same(expected: &str, found: &str) -> bool {
    let (mut a, mut b) = (expected.lines(), found.lines());
    let mut same = true;
    loop {
        match (a.next(), b.next()) {
            (None, None) => return same,
            (x, y) if x == y => {}
            (x, y) => {
                same = false;
                println!("expected: {}\nfound:    {}", x.unwrap_or("nothing more"), y.unwrap_or("nothing more"));
            }
        }
    }
}
