//! Compares one pair of shapes after the other with exact integers, around touches, for any length
//! of time.
//!
//! For each generated pair it also tests the neighbours: up to 2 raw units away in each direction,
//! and with radii one more and one less. The judge of this many uses plain 64- and 128-bit
//! integers. The 256-bit judge checks it for some pairs.

use crate::pairs::name;
use crate::peers::exact::Shape as Plain;
use crate::peers::ours::Shape as Ours;
use crate::record::Row;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;
use tilesat::prelude::*;
use tilesat_judge::oracle::figure::{Figure, Kind, PAIRS};
use tilesat_judge::oracle::generate::{CLASSES, Pairs};
use tilesat_judge::oracle::measure::Measure;
use tilesat_textbook::exact;

/// Generated pairs per chunk. It looks at the clock between two chunks, and a seed stands for one.
const CHUNK: u32 = 20_000;
/// The slower judge checks one generated pair in so many.
const SAMPLE: u32 = 50;

/// The results for one pair of kinds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Tally {
    chunks: u64,
    queries: u64,
    wrong: u64,
}

/// A line per pair of kinds, so that a run continues where the last one stopped.
fn load(state: &Path) -> [Tally; 6] {
    let mut tallies = [Tally::default(); 6];
    let text = std::fs::read_to_string(state).unwrap_or_default();
    for line in text.lines() {
        let fields: Vec<&str> = line.split('|').collect();
        if let [kind, chunks, queries, wrong] = fields[..]
            && let Some(i) = PAIRS.iter().position(|&k| name(k) == kind)
            && let (Ok(chunks), Ok(queries), Ok(wrong)) = (chunks.parse(), queries.parse(), wrong.parse())
        {
            tallies[i] = Tally { chunks, queries, wrong };
        }
    }
    tallies
}

fn store(state: &Path, tallies: &[Tally; 6]) -> Result<(), String> {
    let mut text = String::new();
    for (kinds, t) in PAIRS.iter().zip(tallies) {
        let _ = writeln!(text, "{}|{}|{}|{}", name(*kinds), t.chunks, t.queries, t.wrong);
    }
    // Writes beside it and moves it over: a run that is stopped at any moment leaves a whole file.
    let beside = state.with_extension("new");
    std::fs::write(&beside, text)
        .and_then(|()| std::fs::rename(&beside, state))
        .map_err(|e| format!("{}: {e}", state.display()))
}

/// Runs until every pair of kinds has had `goal` queries. Returns the rows so far.
///
/// # Errors
/// If an answer is wrong, after reporting all, or if it cannot write the state.
pub fn run(goal: u64, state: &Path) -> Result<Vec<Row>, String> {
    let mut tallies = load(state);
    let (start, mut told) = (Instant::now(), Instant::now());
    // In turns, so that a run that stops early has tested all alike.
    while let Some(i) = (0..6).filter(|&i| tallies[i].queries < goal).min_by_key(|&i| tallies[i].queries) {
        let chunk = chunk(PAIRS[i], tallies[i].chunks);
        tallies[i] = Tally {
            chunks: tallies[i].chunks + 1,
            queries: tallies[i].queries + chunk.queries,
            wrong: tallies[i].wrong + chunk.wrong,
        };
        store(state, &tallies)?;
        if told.elapsed().as_secs() >= 5 {
            told = Instant::now();
            let least = tallies.iter().map(|t| t.queries).min().unwrap_or(0);
            eprintln!(
                "{:6} s: {least} of {goal} queries per pair, {} wrong",
                start.elapsed().as_secs(),
                total(&tallies)
            );
        }
    }
    let rows = PAIRS.iter().zip(&tallies).map(|(kinds, t)| {
        let mut row = Row::new(name(*kinds), "soak", "tilesat", "overlaps");
        row.set("queries", t.queries as f64).set("wrong", t.wrong as f64);
        row
    });
    match total(&tallies) {
        0 => Ok(rows.collect()),
        wrong => Err(format!("{wrong} wrong answers")),
    }
}

fn total(tallies: &[Tally]) -> u64 {
    tallies.iter().map(|t| t.wrong).sum()
}

fn chunk(kinds: (Kind, Kind), seed: u64) -> Tally {
    use exact as plain;
    use tilesat::{Aabb, Circle, Segment};
    match kinds {
        (Kind::Circle, Kind::Circle) => ask::<Circle, Circle, _, _>(kinds, seed, plain::circle_circle),
        (Kind::Circle, Kind::Aabb) => ask::<Circle, Aabb, _, _>(kinds, seed, plain::circle_aabb),
        (Kind::Circle, Kind::Segment) => ask::<Circle, Segment, _, _>(kinds, seed, plain::circle_segment),
        (Kind::Aabb, _) => ask::<Aabb, Aabb, _, _>(kinds, seed, plain::aabb_aabb),
        (Kind::Segment, Kind::Aabb) => {
            ask::<Segment, Aabb, exact::Segment, exact::Aabb>(kinds, seed, |a, b| plain::aabb_segment(b, a))
        }
        (Kind::Segment, _) => ask::<Segment, Segment, _, _>(kinds, seed, plain::segment_segment),
    }
}

/// A circle a raw unit smaller or larger. Other shapes once, unchanged.
fn sizes(figure: Figure) -> impl Iterator<Item = Figure> {
    (-1..=1).filter_map(move |by| match figure {
        Figure::Circle { centre, radius } if radius + by >= 0 => Some(Figure::Circle { centre, radius: radius + by }),
        Figure::Circle { .. } => None,
        _ => (by == 0).then_some(figure),
    })
}

fn ask<A, B, C, D>(kinds: (Kind, Kind), seed: u64, judge: fn(&C, &D) -> bool) -> Tally
where
    A: Ours + Overlaps<B>,
    B: Ours + Overlaps<A>,
    C: Plain,
    D: Plain,
{
    let mut tally = Tally::default();
    let mut streams = CLASSES.map(|class| Pairs::new(kinds, class, 0x50a4 + seed));
    for n in 0..CHUNK {
        // The plain class comes last and least: it says the least.
        let stream = if n % 64 == 0 { 0 } else { 1 + (n as usize % (CLASSES.len() - 1)) };
        let (a, b) = streams[stream].next();
        for a in sizes(a).filter(Figure::in_domain) {
            let (ours, plain) = (A::of(&a), C::of(&a));
            for (x, y) in (-2..=2).flat_map(|x| (-2..=2).map(move |y| (x, y))) {
                let b = b.moved((x, y));
                if !b.in_domain() {
                    continue;
                }
                let (other, right) = (B::of(&b), judge(&plain, &D::of(&b)));
                // One order on even neighbours, the other on odd ones.
                let told = if (x + y) % 2 == 0 { ours.overlaps(&other) } else { other.overlaps(&ours) };
                tally.queries += 1;
                if told != right {
                    tally.wrong += 1;
                    eprintln!("WRONG: {a:?} {b:?}: {told}");
                }
                if n % SAMPLE == 0 {
                    assert_eq!(right, Measure::new(&a, &b).overlaps(), "the judge is wrong about {a:?} {b:?}");
                }
            }
        }
    }
    tally
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_goes_on_where_it_ended() {
        let state = std::env::temp_dir().join(format!("tilesat-soak-{}", std::process::id()));
        let _ = std::fs::remove_file(&state);
        let first = run(1_000, &state).unwrap();
        let chunks = load(&state).map(|t| t.chunks);
        assert_eq!(chunks, [1; 6]);
        assert!(first.iter().all(|r| r.get("queries") > Some(1_000.0) && r.get("wrong") == Some(0.0)));
        // Nothing is left to ask.
        assert_eq!(run(1_000, &state).unwrap(), first);
        let _ = std::fs::remove_file(&state);
    }
}
