//! The microcontrollers' tables, as Markdown.

use crate::record::Row;
use crate::tables::{is_broad, short, usual_class};
use std::fmt::Write;

const QUERIES: &str = "
## Microcontrollers

Instructions of hits / of misses, half of the pairs and casts hit, generic rays; bytes of flash at opt-level \"s\" of the \
query with all that it pulls in, without a ray's cells. Of each class 64 of the host's inputs, 32 rays. Other classes are in `results.csv`.

| | Cortex-M0 | Cortex-M4F | flash M0 | flash M4F |
|---|--:|--:|--:|--:|
";

const FRAMES: &str = "
Instructions of a frame of bodies that move, or of all boxes and their pairs; bytes as above, of 64 boxes, without a level's cells and tiles. \
Of each class 16 of the host's sequences, or 8 frames of boxes or more; every answer of every backend is the host's, bit by bit. The M0 has the \
numbers of boxes that 16 KB of RAM hold. Other classes are below, each at its workload.

| | Cortex-M0 | Cortex-M4F | flash M0 | flash M4F |
|---|--:|--:|--:|--:|
";

/// The classes whose frames are told.
const FRAMED: [&str; 5] = ["circle up to 4 px", "box up to 4 px", "8 boxes", "64 boxes", "256 boxes"];

fn cell(row: &Row, name: &str) -> String {
    row.get(name).map(short).unwrap_or_default()
}

/// Bytes of the function that serves the row's class.
fn flash(rows: &[Row], row: &Row, name: &str) -> String {
    let same = |r: &&Row| {
        (r.workload(), r.backend(), r.asked()) == (row.workload(), row.backend(), row.asked())
            && row.class().starts_with(r.class())
    };
    rows.iter().filter(same).find_map(|r| r.get(name)).map(short).unwrap_or_default()
}

/// A row of a table, from its name and two counts.
fn line(out: &mut String, rows: &[Row], row: &Row, name: &str, [m0, m4f]: [String; 2]) {
    let _ = write!(out, "| {name}, {}: {} | {m0} | {m4f} ", row.backend(), row.asked());
    let _ = writeln!(out, "| {} | {} |", flash(rows, row, "flash_m0"), flash(rows, row, "flash_m4f"));
}

/// The usual class of each workload, and some classes of frames.
pub fn page(rows: &[Row]) -> String {
    let (mut queries, mut frames) = (String::new(), String::new());
    for row in rows.iter().filter(|r| r.get("m0").is_some()) {
        let (workload, class) = (row.workload(), row.class());
        if workload.starts_with("move") || is_broad(workload) {
            if FRAMED.contains(&class) {
                let name = format!("{workload}, {class}");
                line(&mut frames, rows, row, &name, ["m0", "m4f"].map(|core| cell(row, core)));
            }
        } else if class == usual_class(workload) {
            let counts = ["m0", "m4f"].map(|core| {
                let of = |which: &str| cell(row, &format!("{core}_{which}"));
                format!("{} / {}", of("hit"), of("miss"))
            });
            line(&mut queries, rows, row, workload, counts);
        }
    }
    let mut out = String::new();
    for (head, lines) in [(QUERIES, queries), (FRAMES, frames)] {
        if !lines.is_empty() {
            out += head;
            out += &lines;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(key: [&str; 4], cells: &[(&str, f64)]) -> Row {
        let mut row = Row::new(key[0], key[1], key[2], key[3]);
        for (column, value) in cells {
            row.set(column, *value);
        }
        row
    }

    #[test]
    fn queries_have_hits_and_misses_and_frames_have_one_count() {
        let rows = [
            row(
                ["circle-circle", "uniform 50 % hits", "b", "overlaps"],
                &[("m0", 3.0), ("m0_hit", 4.0), ("m0_miss", 2.0)],
            ),
            row(["circle-circle", "", "b", "overlaps"], &[("flash_m0", 70.0)]),
            row(["move: level", "circle up to 4 px", "b", "move"], &[("m0", 500.0), ("m4f", 50.0)]),
            row(["move: level", "box up to 4 px", "b", "move"], &[("m0", 400.0)]),
            row(["move: level", "box up to 30 px", "b", "move"], &[("m0", 300.0)]),
            row(["move: level", "circle", "b", "move"], &[("flash_m0", 90.0), ("flash_m4f", 91.0)]),
            row(["move: level", "box", "b", "move"], &[("flash_m0", 80.0)]),
        ];
        let page = page(&rows);
        let lines: Vec<&str> = page.lines().filter(|line| line.contains(", b: ")).collect();
        assert_eq!(
            lines,
            [
                "| circle-circle, b: overlaps | 4.00 / 2.00 |  /  | 70.0 |  |",
                "| move: level, circle up to 4 px, b: move | 500 | 50.0 | 90.0 | 91.0 |",
                "| move: level, box up to 4 px, b: move | 400 |  | 80.0 |  |",
            ]
        );
    }
}
