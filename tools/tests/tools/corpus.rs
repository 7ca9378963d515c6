//! Small projects of our own, one for each convention, encoding and fault. A table that people
//! review has the result for each: `corpus/expected.txt`. The projects of others beside this
//! repository, if there are any, have `corpus/others.txt`.
//!
//! Set `TILESAT_BLESS` to write the tables again. `TILESAT_FRAMES` sets how many frames each baked
//! level plays.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tilesat_tools::bake::{self, Settings};
use tilesat_tools::play::{self, Arena};
use tilesat_tools::read;

use crate::support::{self, tilesat};

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus")
}

/// A level in a few words.
fn counts(line: &str) -> String {
    let level: Value = serde_json::from_str(line).expect("a line of JSON");
    let pairs = |name: &str| {
        let all = level[name].as_object().unwrap().iter().map(|(key, count)| format!("{}={count}", key.escape_debug()));
        all.collect::<Vec<_>>().join(",")
    };
    let mut text = format!("{} {}x{} of {}", level["level"], level["width"], level["height"], level["cell"]);
    for name in ["solid", "one_way", "segments"] {
        let _ = write!(text, " {name}={}", level[name]);
    }
    for name in ["shapes", "flags"] {
        let _ = write!(text, " {name}[{}]", pairs(name));
    }
    let rule = |rule: &Value| format!("{}={}", rule["rule"].as_str().unwrap(), rule["tiles"]);
    let rules: Vec<String> = level["rules"].as_array().unwrap().iter().map(rule).collect();
    let _ = write!(text, " rules[{}]", rules.join(","));
    let ignored = level["ignored"].as_array().unwrap().len();
    if ignored > 0 {
        let _ = write!(text, " ignored={ignored}");
    }
    text
}

/// The report about a level, without its folder.
fn said(folder: &Path, file: &str, options: &str) -> String {
    let path = folder.join(file);
    let words = options.split('"').enumerate();
    let split = words.flat_map(|(i, part)| if i % 2 == 1 { vec![part] } else { part.split_whitespace().collect() });
    let args = ["bake", path.to_str().unwrap(), "--json"].into_iter().chain(split);
    let ran = tilesat(args);
    let home = format!("{}/", folder.display());
    match ran.status {
        0 => {
            let guess = if ran.err.contains("GUESS") { " GUESS" } else { "" };
            let levels: Vec<String> = ran.out.lines().map(counts).collect();
            levels.join(" + ") + guess
        }
        2 => {
            assert!(ran.out.is_empty() && ran.err.lines().count() == 1, "{file}: {ran:?}");
            let line = ran.err.trim_end();
            assert!(!line.contains(|c: char| c.is_control()), "{file}: {line:?}");
            line.replace(&home, "").replacen(&format!("tilesat bake: {file}: "), "", 1)
        }
        other => panic!("{file}: status {other}"),
    }
}

/// Compares a table with the reports about its files, or writes it.
fn compare(table: &Path, folder: &Path, cases: &[(String, String)]) {
    let mut text = String::new();
    for (file, options) in cases {
        let line = format!("{file} | {options} | {}", said(folder, file, options));
        let _ = writeln!(text, "{}", line.trim_end());
    }
    if std::env::var_os("TILESAT_BLESS").is_some() {
        fs::write(table, text).unwrap();
        return;
    }
    let expected = fs::read_to_string(table).unwrap();
    for (found, wanted) in text.lines().zip(expected.lines()) {
        assert_eq!(found, wanted, "{}", table.display());
    }
    assert_eq!(text.lines().count(), expected.lines().count());
}

fn cases() -> Vec<(String, String)> {
    let table = fs::read_to_string(corpus().join("expected.txt")).unwrap();
    let cell = |line: &str, i: usize| line.split('|').nth(i).unwrap_or_default().trim().to_owned();
    table.lines().map(|line| (cell(line, 0), cell(line, 1))).collect()
}

#[test]
fn ours() {
    compare(&corpus().join("expected.txt"), &corpus(), &cases());
}

/// The folders of levels and projects of others, if they exist.
fn others() -> Option<(PathBuf, Vec<(String, String)>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared");
    let mut pending = vec![folder.join("levels"), folder.join("projects")];
    let mut files = BTreeSet::new();
    while let Some(path) = pending.pop() {
        if path.is_dir() {
            pending.extend(fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|end| end == "tmx" || end == "tmj" || end == "ldtk") {
            files.insert(path.strip_prefix(&folder).unwrap().to_str().unwrap().to_owned());
        }
    }
    let cases: Vec<(String, String)> = files.into_iter().map(|file| (file, String::new())).collect();
    (!cases.is_empty()).then_some((folder, cases))
}

#[test]
fn projects_of_others() {
    match others() {
        Some((folder, cases)) => compare(&corpus().join("others.txt"), &folder, &cases),
        None => println!("skipped: there are no levels of others beside the repository"),
    }
}

/// Every level that bakes without an option plays, and no body ever overlaps the solid or escapes.
#[test]
fn baked_levels_play() {
    let frames = std::env::var("TILESAT_FRAMES").ok().and_then(|text| text.parse().ok()).unwrap_or(300);
    let mut all: Vec<PathBuf> =
        cases().into_iter().filter(|(_, options)| options.is_empty()).map(|(file, _)| corpus().join(file)).collect();
    if let Some((folder, cases)) = others() {
        all.extend(cases.into_iter().map(|(file, _)| folder.join(file)));
    }
    let mut played = 0;
    for file in all {
        let Ok(levels) = read::load(&file, None) else { continue };
        let Ok(bundle) = bake::bake(&levels.maps, &Settings::default()) else { continue };
        for baked in &bundle.levels {
            let Ok(arena) = Arena::of(baked) else { continue };
            match play::play(&arena, frames, 11, &mut std::io::sink()) {
                Ok(run) => {
                    let faults = (run.overlaps, run.escaped, run.refused);
                    assert_eq!(faults, (0, 0, 0), "{}: {}", file.display(), baked.ground.name);
                    played += 1;
                }
                Err(why) => assert!(why.to_string().contains("no room"), "{}: {why}", file.display()),
            }
        }
    }
    println!("{played} levels played {frames} frames");
    assert!(played > 100);
}

/// The program plays a baked level as it plays the drawn one.
#[test]
fn baked_files_play() {
    for (file, level) in [
        ("encodings/csv.tmx", ""),
        ("shapes/slab.tmx", ""),
        ("objects/only.tmx", ""),
        ("encodings/infinite.tmx", ""),
        ("ldtk/grid_vania.ldtk", "hall"),
    ] {
        let drawn = corpus().join(file);
        let option = |args: &mut Vec<String>, name: &str| {
            if !level.is_empty() {
                args.extend(["--level".to_owned(), name.to_owned()]);
            }
        };
        let mut args = vec!["play".to_owned(), drawn.display().to_string(), "--frames".to_owned(), "200".to_owned()];
        option(&mut args, "Hall");
        let expected = tilesat(args);
        assert!(expected.status == 0 && expected.last().contains("overlaps=0 escaped=0"), "{expected:?}");
        for end in ["rs", "bin"] {
            let out = support::scratch("baked", &format!("{}.{end}", file.replace('/', "-")), "");
            let ran = tilesat(["bake".as_ref(), drawn.as_os_str(), "-o".as_ref(), out.as_os_str()]);
            assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{file}");
            // Of several files, the caller can name any.
            let whole = if level.is_empty() { out.clone() } else { out.with_extension(format!("{level}.{end}")) };
            let whole = if end == "rs" { out } else { whole };
            let mut args =
                vec!["play".to_owned(), whole.display().to_string(), "--frames".to_owned(), "200".to_owned()];
            if end == "rs" {
                option(&mut args, level);
            }
            let again = tilesat(args);
            assert_eq!(again.last(), expected.last(), "{file} {end} {again:?}");
        }
    }
}
