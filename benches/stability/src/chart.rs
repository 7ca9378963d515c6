//! The picture: energy over frames, relative to the start. One panel per scene, one line per
//! engine.

use crate::cases::{Case, Kind};
use crate::engines::Column;
use crate::runs::Cell;
use crate::watch::Watched;
use std::fmt::Write;

const WIDTH: f64 = 520.0;
const HEIGHT: f64 = 240.0;
const MARGIN: f64 = 48.0;
const COLOURS: [&str; 10] =
    ["#0a7a2f", "#12b886", "#9775fa", "#c92a2a", "#f76707", "#1971c2", "#e8b100", "#862e9c", "#495057", "#adb5bd"];

/// An SVG of all cases that should keep their energy.
pub fn svg(cases: &[Case], columns: &[Column], results: &[Vec<Cell>]) -> String {
    let chosen: Vec<usize> =
        (0..cases.len()).filter(|&i| !matches!(cases[i].kind, Kind::Valley | Kind::LongRun(128))).collect();
    let rows = chosen.len().div_ceil(2) as f64;
    let (width, height) = (2.0 * WIDTH, rows * HEIGHT + 20.0 * (columns.len() as f64 + 1.0));
    let mut out = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {height}' font-family='sans-serif' font-size='12'>\n\
         <rect width='100%' height='100%' fill='white'/>\n"
    );
    for (slot, &i) in chosen.iter().enumerate() {
        let (x, y) = ((slot % 2) as f64 * WIDTH, (slot / 2) as f64 * HEIGHT);
        let _ = writeln!(out, "<g transform='translate({x} {y})'>");
        panel(&mut out, &cases[i], &results[i]);
        out.push_str("</g>\n");
    }
    for (k, column) in columns.iter().enumerate() {
        let y = rows * HEIGHT + 20.0 * (k as f64 + 1.0);
        let _ = writeln!(
            out,
            "<rect x='{MARGIN}' y='{}' width='24' height='4' fill='{}'/><text x='{}' y='{y}'>{}</text>",
            y - 6.0,
            COLOURS[k % COLOURS.len()],
            MARGIN + 34.0,
            column.name
        );
    }
    out.push_str("</svg>\n");
    out
}

/// Position of an energy ratio on an axis from 0 to 1.
#[derive(Clone, Copy)]
enum Scale {
    /// The greatest distance from 1.
    Linear(f64),
    /// From and to this power of ten.
    Decades(f64, f64),
}

impl Scale {
    fn of(ratios: impl Iterator<Item = f64> + Clone) -> Self {
        let far = ratios.clone().map(|r| (r - 1.0).abs()).fold(1e-6, f64::max);
        if far < 0.5 {
            return Self::Linear(far);
        }
        let decades = || ratios.clone().map(|r| r.max(1e-3).log10());
        Self::Decades(decades().fold(-1.0, f64::min).floor(), decades().fold(1.0, f64::max).ceil())
    }

    fn place(self, ratio: f64) -> f64 {
        match self {
            Self::Linear(far) => 0.5 + (ratio - 1.0) / (2.0 * far),
            Self::Decades(lo, hi) => (ratio.max(1e-3).log10() - lo) / (hi - lo),
        }
    }

    /// Ratios with their labels.
    fn ticks(self) -> Vec<(f64, String)> {
        match self {
            Self::Linear(far) => [-1.0, 0.0, 1.0]
                .map(|k| (1.0 + k * far, if k == 0.0 { "1".into() } else { format!("{:+.0e}", k * far) }))
                .into(),
            Self::Decades(lo, hi) => {
                (lo as i32..=hi as i32).map(|k| (10f64.powi(k), format!("x{}", 10f64.powi(k)))).collect()
            }
        }
    }
}

fn panel(out: &mut String, case: &Case, row: &[Cell]) {
    let (w, h) = (WIDTH - 1.5 * MARGIN, HEIGHT - 1.5 * MARGIN);
    let frames = row.iter().flatten().map(|run| run.frames).max().unwrap_or(1);
    let lines: Vec<Vec<(u64, f64)>> = row.iter().map(|cell| medians(cell)).collect();
    let scale = Scale::of(lines.iter().flatten().map(|sample| sample.1));
    let y = |ratio: f64| 26.0 + h * (1.0 - scale.place(ratio));
    let _ = writeln!(out, "<text x='{MARGIN}' y='16' font-weight='bold'>{}</text>", case.scene.name);
    let _ = writeln!(out, "<text x='{}' y='{}' text-anchor='end'>{frames} frames</text>", MARGIN + w, h + MARGIN - 6.0);
    for (ratio, label) in scale.ticks() {
        let (y, grey) = (y(ratio), if (ratio - 1.0).abs() < 1e-12 { "#888" } else { "#ddd" });
        let _ = writeln!(
            out,
            "<path d='M{MARGIN} {y:.1}h{w}' stroke='{grey}'/><text x='{}' y='{:.1}' text-anchor='end'>{label}</text>",
            MARGIN - 4.0,
            y + 4.0,
        );
    }
    // The first column comes last, so that it is on top.
    for (k, line) in lines.iter().enumerate().rev().filter(|(_, line)| !line.is_empty()) {
        let mut path = String::new();
        for (i, &(frame, ratio)) in line.iter().enumerate() {
            let x = MARGIN + w * frame as f64 / frames as f64;
            let _ = write!(path, "{}{x:.1} {:.1}", if i == 0 { 'M' } else { 'L' }, y(ratio));
        }
        let colour = COLOURS[k % COLOURS.len()];
        let _ = writeln!(out, "<path d='{path}' fill='none' stroke='{colour}' stroke-width='1.5'/>");
    }
}

/// The median of the runs that stayed in, sample by sample, with its frame.
fn medians(cell: &[Watched]) -> Vec<(u64, f64)> {
    let runs: Vec<_> = cell.iter().filter(|run| run.escaped.is_none()).collect();
    let samples = runs.iter().map(|run| run.energy.len()).min().unwrap_or(0);
    let frames = runs.iter().map(|run| run.frames).max().unwrap_or(0);
    (0..samples)
        .map(|i| {
            let mut values: Vec<f64> = runs.iter().map(|run| run.energy[i]).collect();
            values.sort_by(f64::total_cmp);
            let last = i + 1 == samples;
            (if last { frames } else { runs[0].every * i as u64 }, values[values.len() / 2])
        })
        .collect()
}
