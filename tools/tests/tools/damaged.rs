//! Damaged levels. Whatever a file contains, the level tools report the fault or do their work.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::support::{self, ldtk, own, scratch};

/// Numbers that such files should not contain.
const ODD: [&str; 16] = [
    "-1",
    "0",
    "1",
    "65535",
    "65536",
    "2147483647",
    "4294967296",
    "-9223372036854775808",
    "1e308",
    "1e-320",
    "nan",
    "0.00001",
    "8191.99999",
    "8192",
    "\u{e9}",
    "",
];

struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % end.max(1)
    }

    fn range(&mut self, length: usize, most: usize) -> Range<usize> {
        let start = self.below(length);
        start..(start + self.below(most)).min(length)
    }
}

/// One to four kinds of damage.
fn damaged(level: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = level.to_vec();
    for _ in 0..=random.below(4) {
        let length = bytes.len();
        match random.below(12) {
            0 => bytes.truncate(random.below(length)),
            1 => drop(bytes.drain(random.range(length, 64))),
            2 => {
                let copy = bytes[random.range(length, 64)].to_vec();
                let at = random.below(length);
                bytes.splice(at..at, copy);
            }
            3 => {
                let at = random.below(length);
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
            _ => {
                let number = numbers(&bytes);
                if !number.is_empty() {
                    let at = number[random.below(number.len())].clone();
                    bytes.splice(at, ODD[random.below(ODD.len())].bytes());
                }
            }
        }
    }
    bytes
}

/// The positions of digits.
fn numbers(bytes: &[u8]) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    for (i, _) in bytes.iter().enumerate().filter(|(_, byte)| byte.is_ascii_digit()) {
        match found.last_mut() {
            Some(last) if last.end == i => last.end += 1,
            _ => found.push(i..i + 1),
        }
    }
    found
}

/// Returns the number of levels that were still accepted.
fn torture(name: &str, level: &[u8], seed: u64) -> usize {
    let scale = std::env::var("TILESAT_CASES").ok().and_then(|text| text.parse().ok());
    let mut random = Random(seed);
    let mut taken = 0;
    for case in 0..scale.unwrap_or(150) {
        let bytes = damaged(level, &mut random);
        let file = scratch("fuzz", name, &bytes);
        let ran = support::run("lint", &file, "--body 10x14");
        assert!(ran.status <= 2 && (ran.status == 2) == (ran.err.lines().count() == 1), "case {case}: {ran:?}");
        let out = scratch("fuzz", &format!("{name}.rs"), "");
        let ran = support::run("bake", file, &format!("-o {}", out.display()));
        assert!((ran.status == 2) == (ran.err.lines().count() == 1), "case {case}: {ran:?}");
        assert!(ran.status == 0 || ran.status == 2 && fs::read(&out).unwrap().is_empty(), "case {case}: {ran:?}");
        taken += usize::from(ran.status == 0);
    }
    println!("{name}: {taken} are still levels");
    taken
}

#[test]
fn tiled() {
    let text = fs::read_to_string(own("levels/quarry.tmx")).unwrap();
    let tileset = own("platformer/levels/meadow.tsx");
    let level = text.replace("../platformer/levels/meadow.tsx", tileset.to_str().unwrap());
    assert!(torture("quarry.tmx", level.as_bytes(), 1) > 0);
}

#[test]
fn many_objects() {
    let shapes = [
        r#"<polygon points="0,0 9.5,0 3,8"/>"#,
        r#"<polyline points="0,0 9,0 3,8 0,0"/>"#,
        "<ellipse/>",
        r#"<properties><property name="kind" value="hole"/></properties>"#,
    ];
    let object = |i: usize| {
        let (x, y, shape) = (i % 8 * 12, i / 8 * 12, shapes[i % 4]);
        let (class, rotation) = (["", "Solid", "OneWay", "Wall"][i / 4 % 4], i * 15);
        format!(
            r#"<object id="{i}" class="{class}" x="{x}" y="{y}" width="9" height="7.25" rotation="{rotation}">{shape}</object>"#
        )
    };
    let list = (0..40).map(object).collect::<Vec<_>>().concat();
    assert!(torture("objects.tmx", support::objects(&list).as_bytes(), 2) > 0);
}

#[test]
fn ldtk_projects() {
    let level = fs::read(own("levels/steps.ldtk")).unwrap();
    torture("steps.ldtk", &level, 3);
    let small = ldtk(&["Full", "SlopeTopLeft_Ice", "Empty_Coin"], 4, 2, "1,0,3,1,2,2,0,1");
    assert!(torture("small.ldtk", small.as_bytes(), 4) > 0);
}

fn copied(from: &Path, to: &Path, files: &mut Vec<PathBuf>) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let (from, to) = (entry.as_ref().unwrap().path(), to.join(entry.unwrap().file_name()));
        if from.is_dir() {
            copied(&from, &to, files);
        } else {
            fs::copy(&from, &to).unwrap();
            files.push(to);
        }
    }
}

/// A thousand kinds of damage, each to one file of the corpus. Bakes the level that reads the file,
/// if that is another one.
#[test]
fn the_corpus() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    let (home, mut files) = (support::folder("corpus").join("files"), Vec::new());
    copied(&corpus, &home, &mut files);
    files.retain(|file| !file.ends_with("expected.txt") && !file.ends_with("others.txt"));
    files.sort();
    let reader = |file: &Path| match file.extension().and_then(|end| end.to_str()) {
        Some("tsx") => Some("encodings/outside.tmx"),
        Some("tsj") => Some("encodings/outside.tmj"),
        Some("ldtkl") => Some("ldtk/outside.ldtk"),
        Some("tx") => Some(if file.ends_with("box.tx") { "shapes/template.tmx" } else { "objects/template.tmx" }),
        Some("toml") => Some("project/level.tmx"),
        _ => None,
    };
    let out = home.join("out");
    fs::create_dir_all(&out).unwrap();
    let mut random = Random(5);
    let (mut taken, mut longest) = (0, Duration::ZERO);
    for case in 0..1000 {
        let file = &files[case % files.len()];
        let before = fs::read(file).unwrap();
        fs::write(file, damaged(&before, &mut random)).unwrap();
        let level = reader(file).map_or_else(|| file.clone(), |level| home.join(level));
        let end = ["rs", "bin"][case % 2];
        let start = Instant::now();
        let ran = support::run("bake", &level, &format!("-o {}", out.join(format!("a.{end}")).display()));
        longest = longest.max(start.elapsed());
        let written: Vec<PathBuf> = fs::read_dir(&out).unwrap().map(|entry| entry.unwrap().path()).collect();
        let fine = ran.status == 0 && ran.err.is_empty() && !written.is_empty();
        let refused = ran.status == 2 && ran.err.lines().count() == 1 && written.is_empty();
        assert!(fine || refused, "case {case}: {} {ran:?} {written:?}", file.display());
        assert!(!ran.err.trim_end().contains(char::is_control), "case {case}: {ran:?}");
        taken += usize::from(fine);
        for file in written {
            fs::remove_file(file).unwrap();
        }
        fs::write(file, before).unwrap();
    }
    println!("{taken} of 1000 are still levels; the longest took {longest:?}");
    assert!((50..900).contains(&taken) && longest < Duration::from_secs(10));
}
