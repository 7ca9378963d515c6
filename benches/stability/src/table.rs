//! The tables as Markdown: a row per engine, a column per scene.

use crate::cases::{Case, Kind};
use crate::engines::Column;
use crate::runs::Cell;
use crate::watch::Watched;
use std::fmt::Write;

/// The table of the cases of one kind. Empty without cases.
pub fn of(kind: Kind, cases: &[Case], columns: &[Column], results: &[Vec<Cell>]) -> String {
    let chosen: Vec<usize> = (0..cases.len()).filter(|&i| cases[i].kind == kind).collect();
    if chosen.iter().all(|&i| results[i].iter().all(Vec::is_empty)) {
        return String::new();
    }
    let mut out = format!("\n{}\n\n|", title(kind));
    for &i in &chosen {
        let _ = write!(out, " | {}", cases[i].scene.name);
    }
    let _ = writeln!(out, " |\n|---{}|", "|---".repeat(chosen.len()));
    for (column, engine) in columns.iter().enumerate() {
        if chosen.iter().all(|&i| results[i][column].is_empty()) {
            continue;
        }
        let _ = write!(out, "| {}", engine.name);
        for &i in &chosen {
            let cell = &results[i][column];
            let text = if cell.is_empty() { String::from("-") } else { cell_text(&cases[i], cell) };
            let _ = write!(out, " | {text}");
        }
        out.push_str(" |\n");
    }
    out
}

/// The title of a table, and what its cells show.
fn title(kind: Kind) -> String {
    let (name, cells) = match kind {
        Kind::Floor => (
            "Runs on a flat floor at 3.37 px per frame".to_owned(),
            "Ghost frames; speed at the end; highest pop; deepest, px.",
        ),
        Kind::Valley => (
            "Falls into a corner, the worst of 16 balls".to_owned(),
            "Last frame with a motion; speed at the end, raw; longest step of the last 1000 frames, raw;\ndeepest, px.",
        ),
        Kind::Bounces => (
            "Elastic bounces, 2 starts".to_owned(),
            "Energy left, min..max; its peak; runs that lost the body (first frame).",
        ),
        Kind::LongRun(bounce) => (
            format!("Restitution {}", f64::from(bounce) / 256.0),
            "Escapes of 16 runs (first frame); energy at the end / at the start, min..median..max of the runs\n\
             that stayed in; deepest, px; without gravity, the greatest excess over the start speed.",
        ),
    };
    format!("**{name}**\n\n{cells}")
}

fn cell_text(case: &Case, cell: &[Watched]) -> String {
    let worst = |value: fn(&Watched) -> f64| cell.iter().map(value).fold(f64::NEG_INFINITY, f64::max);
    let depth = length(worst(|w| w.deepest));
    match case.kind {
        Kind::Floor => {
            let w = &cell[0];
            let end =
                if let Some(frame) = w.escaped { format!("lost in frame {frame}") } else { number(w.velocity[0]) };
            format!("{}; {end}; {}; {depth}", w.turns, length(w.highest))
        }
        Kind::Valley => format!(
            "{}{}; {}; {}; {depth}",
            lost(cell),
            cell.iter().map(|w| w.last_motion).max().unwrap_or(0),
            number(worst(Watched::residual)),
            number(worst(|w| w.late_step)),
        ),
        Kind::Bounces => {
            let (lo, _, hi) = kept(cell);
            format!("{}..{}; {}; {}", number(lo), number(hi), number(worst(|w| w.peak_energy)), escapes(cell))
        }
        Kind::LongRun(_) => {
            let (lo, middle, hi) = kept(cell);
            let energy = if lo.is_nan() {
                String::from("all gone")
            } else {
                format!("{}..{}..{}", number(lo), number(middle), number(hi))
            };
            let faster = if case.scene.gravity != 0 {
                String::new()
            } else if worst(|w| w.peak_square) <= 1.0 {
                String::from("; never faster")
            } else {
                format!("; faster by {:.1e}", worst(|w| w.peak_square).sqrt() - 1.0)
            };
            format!("{}; {energy}; {depth}{faster}", escapes(cell))
        }
    }
}

fn lost(cell: &[Watched]) -> String {
    if cell.iter().any(|w| w.escaped.is_some()) { format!("{}; ", escapes(cell)) } else { String::new() }
}

fn escapes(cell: &[Watched]) -> String {
    let frames = cell.iter().filter_map(|w| w.escaped);
    match frames.clone().min() {
        None => String::from("0 esc"),
        Some(first) => format!("{} esc ({first})", frames.count()),
    }
}

/// Least, median and greatest energy of the runs that stayed in the room.
fn kept(cell: &[Watched]) -> (f64, f64, f64) {
    let mut kept: Vec<f64> = cell.iter().filter(|w| w.escaped.is_none()).map(Watched::kept).collect();
    kept.sort_by(f64::total_cmp);
    match (kept.first(), kept.get(kept.len() / 2), kept.last()) {
        (Some(lo), Some(middle), Some(hi)) => (*lo, *middle, *hi),
        _ => (f64::NAN, f64::NAN, f64::NAN),
    }
}

/// A length in pixels. Lengths below the judge's own error, far below a raw unit, print as zero.
fn length(px: f64) -> String {
    if px < 1e-7 { String::from("0") } else { number(px) }
}

/// Four digits after the leading digits of small numbers.
fn number(x: f64) -> String {
    let size = x.abs();
    let text = if size != 0.0 && size < 1e-4 {
        return format!("{x:.1e}");
    } else if size < 10.0 {
        format!("{x:.6}")
    } else {
        format!("{x:.1}")
    };
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { String::from("0") } else { short.into() }
}
