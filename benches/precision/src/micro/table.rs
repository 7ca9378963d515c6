//! The microcontrollers' table, as Markdown.

use crate::question::{Question, is_broad, is_move, usual_class};
use crate::record::Row;
use crate::tables::short;
use std::fmt::Write;

const HEAD: &str = "
## Microcontrollers

Instructions on Cortex-M0 / on Cortex-M4F, in the usual class: per query, or per frame of a moving
body or of all boxes and their pairs. For tilesat and for the best of parry2d the table also has the
bytes of flash on the M0 at opt-level \"s\". They include everything that the query links, without a
level's cells and tiles. After a semicolon: textbook boxes `(columns)`.
Each class has 64 of the host's inputs, 32 rays, 16 sequences, or at least 8 frames of boxes.
`results.csv` has hits and misses, other classes and other bytes.

| | tilesat | bytes | naive Q16.16 | textbook f32 | textbook f64 | parry2d | bytes |
|---|--:|--:|--:|--:|--:|--:|--:|
";

/// The classes of frames that the table shows beside the usual one.
const FRAMED: [&str; 4] = ["circle up to 4 px", "box up to 4 px", "64 boxes", "256 boxes"];

/// Bytes of the function that serves the row's class.
fn flash(rows: &[Row], row: &Row) -> Option<f64> {
    let same = |r: &&Row| {
        (r.workload(), r.backend(), r.asked()) == (row.workload(), row.backend(), row.asked())
            && row.class().starts_with(r.class())
    };
    rows.iter().filter(same).find_map(|r| r.get("flash_m0"))
}

/// How textbook boxes are asked that look at all that they cross.
const COLUMNS: &str = "move (columns)";

/// The instructions of the best of some backends, and its bytes.
fn cells(rows: &[Row], question: Question<'_>, class: &str, (of, columns): (&str, bool)) -> [String; 2] {
    let named = |r: &&Row| {
        question.is_of(r)
            && r.class() == class
            && r.backend().starts_with(of)
            && !r.backend().contains("-f64")
            && (r.asked() == COLUMNS) == columns
    };
    let counted = rows.iter().filter(named).filter_map(|r| Some((r, r.get("m0").or(r.get("m4f"))?)));
    let Some((row, _)) = counted.min_by(|a, b| a.1.total_cmp(&b.1)) else { return Default::default() };
    let cell = |name| row.get(name).map_or_else(|| "-".to_owned(), short);
    [format!("{} / {}", cell("m0"), cell("m4f")), flash(rows, row).map(short).unwrap_or_default()]
}

/// The usual class of each question, and some classes of frames.
pub fn page(rows: &[Row]) -> String {
    let mut lines = String::new();
    for question in Question::all(rows) {
        let framed = is_move(question.workload) || is_broad(question.workload);
        let classes = if framed { &FRAMED[..] } else { &[usual_class(question.workload)] };
        for class in classes {
            let of = |backend, columns| cells(rows, question, class, (backend, columns));
            let ([ours, bytes], [parry, theirs]) = (of("tilesat", false), of("parry2d", false));
            if ours.is_empty() {
                continue;
            }
            let [naive, f32, f64] = ["naive Q16.16", "textbook f32", "textbook f64"].map(|backend| {
                let ways = [false, true].map(|columns| of(backend, columns)[0].clone());
                ways.into_iter().filter(|way| !way.is_empty()).collect::<Vec<_>>().join("; ")
            });
            let name = if framed { format!("{}, {class}", question.workload) } else { question.name() };
            let _ = writeln!(lines, "| {name} | {ours} | {bytes} | {naive} | {f32} | {f64} | {parry} | {theirs} |");
        }
    }
    if lines.is_empty() { lines } else { format!("{HEAD}{lines}") }
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
    fn queries_have_a_line_and_frames_have_one_a_class() {
        let rows = [
            row(["circle-circle", "uniform 50 % hits", "tilesat", "overlaps"], &[("m0", 3.0), ("m4f", 2.0)]),
            row(["circle-circle", "uniform 50 % hits", "textbook f64", "overlaps"], &[("m0", 900.0)]),
            row(["circle-circle", "", "tilesat", "overlaps"], &[("flash_m0", 70.0)]),
            row(["move: level", "circle up to 4 px", "tilesat", "move"], &[("m0", 500.0), ("m4f", 50.0)]),
            row(["move: level", "box up to 4 px", "tilesat", "move"], &[("m0", 400.0)]),
            row(["move: level", "box up to 4 px", "textbook f32", "move"], &[("m0", 60.0)]),
            row(["move: level", "box up to 4 px", "textbook f32", COLUMNS], &[("m0", 50.0), ("m4f", 7.0)]),
            row(["move: level", "box up to 30 px", "tilesat", "move"], &[("m0", 300.0)]),
            row(["move: level", "circle", "tilesat", "move"], &[("flash_m0", 90.0)]),
        ];
        let page = page(&rows);
        let lines: Vec<&str> = page
            .lines()
            .filter(|line| line.contains(", ") && line.starts_with("| ") || line.contains("circle-circle"))
            .collect();
        assert_eq!(
            lines,
            [
                "| circle-circle | 3.00 / 2.00 | 70.0 |  |  | 900 / - |  |  |",
                "| move: level, circle up to 4 px | 500 / 50.0 | 90.0 |  |  |  |  |  |",
                "| move: level, box up to 4 px | 400 / - |  |  | 60.0 / -; 50.0 / 7.00 |  |  |  |",
            ]
        );
    }
}
