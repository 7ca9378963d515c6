//! Run time against error: tilesat beside textbook code and other libraries, all with the same
//! inputs.
//!
//! `run.sh` runs all of it. `measure` judges and times, `count` counts instructions on the host,
//! and `show` makes pictures and pages from the results' CSV alone. `soak` checks pairs of shapes
//! for hours.
//!
//! How to read it:
//! - Exact integers of 256 bits check every answer. A test checks that they equal big rationals.
//!   They share no code with the library.
//! - Touching counts as overlapping, or it does not. Over a class, each backend is judged by the
//!   convention that suits it better. tilesat's is the strict one.
//! - Movers of bodies: rapier2d's controller represents parry2d's casts, with which it slides.
//!   Box2D's mover is a capsule, so it moves circles only. Chipmunk2D has none. On microcontrollers
//!   only code without an allocator runs: ours and the textbook's.
//! - Lengths are raw integers, 65 536 per pixel. A float gets the nearest value to each. So an f32
//!   loses digits far from the origin, as in a game.
//! - Each moving body is judged at the exact position that its numbers mean. So each backend has
//!   its own way through a level (`moves/truth.rs`).
//! - A time is the thread's time. The program repeats passes that stray, and at last gives up
//!   (`run.rs`). It discards a time whose code has another count since.
//! - A pair of boxes that overlaps and is not reported is wrong. A pair that only touches may be
//!   reported or not (`broad/truth.rs`).
//! - A query's cost is that of one call in a loop, with operands in memory and the whole answer
//!   stored. Libraries differ in what they return.

mod batch;
mod broad;
mod callgrind;
mod casts;
mod convex;
mod each;
mod goals;
mod grids;
mod job;
mod levels;
mod micro;
mod moves;
mod pairs;
mod peers;
mod plot;
mod question;
mod rays;
mod readme;
mod record;
mod run;
mod show;
mod soak;
mod tables;
mod threads;

use record::Row;
use run::Sizes;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "tilesat-precision COMMAND [--quick] [--untimed] [--out FILE]
  measure [PART..] judges and times, and writes the rows; --untimed judges only
  count [PART..]   counts instructions under callgrind, and adds them to the rows; parts are pairs, convex, rays, casts, moves, levels, broad, regions and batch
  inputs FOLDER    writes the inputs that microcontrollers get
  add CORE FILE    adds what a microcontroller printed (m0, m4f) or a linker (flash_m0, flash_m4f)
  soak N [--state FILE]
                   runs until each pair of shapes had N queries; continues where it stopped
  threads          prints what threads add, by CPU time
  show             writes the pictures and pages of the rows";

struct Options {
    quick: bool,
    untimed: bool,
    out: PathBuf,
    state: PathBuf,
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let command = arguments.next().unwrap_or_default();
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut words: Vec<String> = Vec::new();
    let mut options = Options { quick: false, untimed: false, out: own.join("results.csv"), state: "soak.txt".into() };
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--quick" => options.quick = true,
            "--untimed" => options.untimed = true,
            "--out" => match arguments.next() {
                Some(file) => options.out = file.into(),
                None => return usage(),
            },
            "--state" => match arguments.next() {
                Some(file) => options.state = file.into(),
                None => return usage(),
            },
            word if word.starts_with('-') => return usage(),
            word => words.push(word.to_owned()),
        }
    }
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match (command.as_str(), &words[..]) {
        ("measure", parts) => chosen(parts).and_then(|parts| measure(&options, &parts)),
        ("count", parts) => count(&options, parts),
        ("count-inside", parts) => chosen(parts).map(|parts| count_inside(&sizes(&options), &parts)),
        ("inputs", [folder]) => micro::write(Path::new(folder)),
        ("add", [core, file]) => add(&options, core, Path::new(file)),
        ("soak", [n]) => match n.parse() {
            Ok(n) => soak::run(n, &options.state).and_then(|rows| join(&options, rows)),
            Err(_) => return usage(),
        },
        ("threads", []) => {
            print!("{}", threads::table());
            Ok(())
        }
        ("show", []) => show::all(&options.out),
        _ => return usage(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(text) => {
            eprintln!("{text}");
            ExitCode::FAILURE
        }
    }
}

fn usage() -> ExitCode {
    eprintln!("{USAGE}");
    ExitCode::from(2)
}

fn sizes(options: &Options) -> Sizes {
    let sizes = if options.quick { Sizes::QUICK } else { Sizes::FULL };
    if options.untimed { Sizes { passes: 0, ..sizes } } else { sizes }
}

pub fn read_rows(file: &Path) -> Result<Vec<Row>, String> {
    if !file.exists() {
        return Ok(Vec::new());
    }
    let text = std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
    record::from_csv(&text).map_err(|e| format!("{}: {e}", file.display()))
}

pub fn write(file: &Path, text: &str) -> Result<(), String> {
    std::fs::write(file, text).map_err(|e| format!("{}: {e}", file.display()))?;
    eprintln!("written: {}", file.display());
    Ok(())
}

/// Rows join those of the file, and the file is written again.
fn join(options: &Options, rows: impl IntoIterator<Item = Row>) -> Result<(), String> {
    let all = record::join(read_rows(&options.out)?.into_iter().chain(rows));
    write(&options.out, &record::to_csv(&all))
}

fn add(options: &Options, core: &str, file: &Path) -> Result<(), String> {
    let printed = std::fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
    join(options, micro::counts(core, &printed)?)
}

/// Workloads that share a measurement and a count.
struct Part {
    name: &'static str,
    measure: fn(&Sizes, &mut Vec<Row>),
    count: fn(&Sizes),
}

const PARTS: [Part; 9] = [
    Part { name: "pairs", measure: pairs::measure, count: pairs::count },
    Part { name: "convex", measure: convex::measure, count: convex::count },
    Part { name: "rays", measure: rays::measure, count: rays::count },
    Part { name: "casts", measure: casts::measure, count: casts::count },
    Part { name: "moves", measure: moves::measure, count: moves::count },
    Part { name: "levels", measure: levels::measure, count: levels::count },
    Part { name: "broad", measure: broad::measure, count: broad::count },
    Part { name: "regions", measure: broad::regions::measure, count: broad::regions::count },
    Part { name: "batch", measure: batch::measure, count: batch::count },
];

/// The named parts, or all.
fn chosen(names: &[&str]) -> Result<Vec<&'static Part>, String> {
    if let Some(name) = names.iter().find(|name| PARTS.iter().all(|p| p.name != **name)) {
        return Err(format!("{name}: no such part"));
    }
    Ok(PARTS.iter().filter(|p| names.is_empty() || names.contains(&p.name)).collect())
}

fn measure(options: &Options, parts: &[&Part]) -> Result<(), String> {
    let mut rows = Vec::new();
    parts.iter().for_each(|part| (part.measure)(&sizes(options), &mut rows));
    join(options, rows)
}

fn count_inside(sizes: &Sizes, parts: &[&Part]) {
    parts.iter().for_each(|part| (part.count)(sizes));
}

/// Runs `count-inside` under callgrind, and adds the counts.
fn count(options: &Options, parts: &[&str]) -> Result<(), String> {
    chosen(parts)?;
    let dumps = options.out.with_extension("callgrind");
    let mut arguments = vec!["count-inside".to_owned()];
    arguments.extend(parts.iter().map(|&part| part.to_owned()));
    arguments.extend(options.quick.then(|| "--quick".to_owned()));
    let status = callgrind::run(&arguments, &dumps).map_err(|e| format!("valgrind: {e}"))?;
    if !status.success() {
        return Err(format!("valgrind: {status}"));
    }
    let text = std::fs::read_to_string(&dumps).map_err(|e| format!("{}: {e}", dumps.display()))?;
    std::fs::remove_file(&dumps).map_err(|e| format!("{}: {e}", dumps.display()))?;
    let counts = callgrind::read(&text);
    if counts.is_empty() {
        return Err("callgrind counted nothing".into());
    }
    let rows = counts.iter().map(|(label, n)| {
        let key: Vec<&str> = label.split('|').collect();
        let mut row = Row::new(key[0], key[1], key[2], key[3]);
        row.set("host", *n as f64 / key[4].parse::<f64>().unwrap_or(f64::NAN));
        row
    });
    join(options, rows)
}
