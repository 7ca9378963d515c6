//! Tables of the page, as Markdown: a line per question, a column per backend. The rows' file has
//! all classes.

use crate::question::{Question, usual_class};
use crate::record::Row;
use std::fmt::Write;

/// Three digits are enough to read.
pub fn short(v: f64) -> String {
    match v.abs() {
        0.0 => "0".into(),
        a if a >= 99.95 => format!("{v:.0}"),
        a if a >= 9.995 => format!("{v:.1}"),
        a if a >= 0.01 => format!("{v:.2}"),
        _ => format!("{v:.1e}"),
    }
}

/// Columns: the best way of a library with several, for a question.
const COLUMNS: [(&str, &[&str]); 12] = [
    ("tilesat", &["tilesat"]),
    ("textbook f64", &["textbook f64"]),
    ("textbook f32", &["textbook f32"]),
    ("naive Q16.16", &["naive Q16.16"]),
    ("wide Q16.16", &["wide Q16.16"]),
    ("plain integers", &["exact (no filters)", "plain integer DDA"]),
    ("parry2d, rapier2d", &["parry2d", "parry2d (special)", "parry2d Voxels", "parry2d Compound", "rapier2d"]),
    ("parry2d-f64", &["parry2d-f64", "parry2d-f64 (special)", "parry2d-f64 Voxels", "parry2d-f64 Compound"]),
    ("Box2D", &["Box2D"]),
    ("Chipmunk2D", &["Chipmunk2D"]),
    ("ncollide2d", &["ncollide2d I16F16"]),
    ("broccoli", &["broccoli"]),
];

fn head(out: &mut String, first: &str, columns: impl ExactSizeIterator<Item = &'static str>) {
    let lines = "--:|".repeat(columns.len());
    let names = columns.collect::<Vec<_>>().join(" | ");
    let _ = writeln!(out, "\n| {first} | {names} |\n|---|{lines}");
}

/// A line of cells, one per column, unless all are empty.
fn line(out: &mut String, name: &str, cells: &[Option<String>]) {
    if cells.iter().any(Option::is_some) {
        let cells: Vec<&str> = cells.iter().map(|c| c.as_deref().unwrap_or("")).collect();
        let _ = writeln!(out, "| {name} | {} |", cells.join(" | "));
    }
}

/// The row of each column that answers a question in a class.
fn answers<'a>(rows: &'a [Row], question: Question<'a>, class: &str) -> [Option<&'a Row>; 12] {
    COLUMNS.map(|(_, backends)| question.best(rows, class, |r| backends.contains(&r.backend())))
}

/// Its cost and its errors. Also the class where it is wrong most often, if that is another one.
fn cost(rows: &[Row], question: Question<'_>, row: &Row) -> Option<String> {
    let ns = row.get("ns").map(|ns| format!(" / {}", short(ns))).unwrap_or_default();
    let wrong = row.wrong_per_million()?;
    let worst = question.worst(rows, row).filter(|worst| worst.1 > wrong);
    let worst = worst.map(|(class, n)| format!("; {} {class}", short(n))).unwrap_or_default();
    Some(format!("{}{ns}; {}{worst}", short(row.get("host")?), short(wrong)))
}

/// The usual class of each question, and for each backend the class where it is wrong most often.
pub fn summary(rows: &[Row]) -> String {
    let mut out = String::new();
    head(&mut out, "usual class", COLUMNS.iter().map(|c| c.0));
    for question in Question::all(rows) {
        let class = usual_class(question.workload);
        let cells = answers(rows, question, class).map(|r| cost(rows, question, r?));
        line(&mut out, &format!("**{}**: {class}", question.name()), &cells);
    }
    out
}

/// The largest error of all classes, and for times the number of late ones.
pub fn errors(rows: &[Row]) -> String {
    let mut out = String::new();
    head(&mut out, "px; late in a hundred hits", COLUMNS.iter().map(|c| c.0));
    for question in Question::all(rows).into_iter().filter(|q| !["overlaps", "pairs", "build"].contains(&q.asked)) {
        let cells = answers(rows, question, usual_class(question.workload)).map(|usual| {
            let usual = usual?;
            let same =
                |r: &&Row| (r.workload(), r.backend(), r.asked()) == (usual.workload(), usual.backend(), usual.asked());
            let largest = |value: fn(&Row) -> Option<f64>| rows.iter().filter(same).filter_map(value).reduce(f64::max);
            let late = largest(|r| Some(r.get("late")? * 100.0 / r.get("hits").filter(|n| *n > 0.0)?));
            let late = late.map(|share| format!("; {}", short(share))).unwrap_or_default();
            Some(format!("{}{late}", short(largest(|r| r.get("max_px"))?)))
        });
        line(&mut out, &question.name(), &cells);
    }
    out
}

/// Frames of moving bodies: how many end in the solid, how deep, and the other faults.
pub fn frames(rows: &[Row]) -> String {
    let movers = [
        ("tilesat", "move"),
        ("textbook f64", "move"),
        ("textbook f64", "move (columns)"),
        ("textbook f32", "move"),
        ("textbook f32", "move (columns)"),
        ("naive Q16.16", "move"),
        ("naive Q16.16", "move (columns)"),
        ("rapier2d", "move"),
        ("Box2D", "move"),
    ];
    let names =
        ["tilesat", "f64", "f64 (columns)", "f32", "f32 (columns)", "naive", "naive (columns)", "rapier2d", "Box2D"];
    let mut out = String::new();
    head(&mut out, "any / > 1/64 px / > 1 px / tunnels / stuck", names.into_iter());
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for row in rows.iter().filter(|r| r.get("tunnels").is_some()) {
        let key = (row.workload(), row.class());
        if seen.contains(&key) {
            continue;
        }
        seen.push(key);
        let cells = movers.map(|(backend, asked)| {
            let of = |r: &&Row| (r.workload(), r.class()) == key && (r.backend(), r.asked()) == (backend, asked);
            let row = rows.iter().find(of)?;
            let share = |name| row.get(name).map_or("-".to_owned(), |n| share(row, n));
            Some(["wrong", "deep", "lost", "tunnels", "stuck"].map(share).join(" / "))
        });
        line(&mut out, &format!("{}, {}", key.0, key.1), &cells);
    }
    out
}

fn share(row: &Row, n: f64) -> String {
    row.get("queries").map_or_else(String::new, |all| short(n * 1e6 / all))
}

/// All classes of a workload with few rows: bodies among bodies, or questions that only ours
/// answers.
pub fn classes(rows: &[Row], workload: &str) -> String {
    let mut out = String::new();
    let question = Question { workload, asked: crate::question::first_asked(workload) };
    head(&mut out, workload, COLUMNS.iter().map(|c| c.0));
    for class in question.classes(rows) {
        let cells = answers(rows, question, class).map(|row| {
            let row = row?;
            let wrong = row.wrong_per_million().filter(|n| *n > 0.0);
            let wrong = wrong.map(|n| format!("; {} wrong", short(n))).unwrap_or_default();
            Some(format!("{}: {}{wrong}", short(row.get("host")?), row.asked()))
        });
        line(&mut out, class, &cells);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_has_its_usual_and_its_worst_class() {
        let row = |backend, class, host, wrong| {
            let mut row = Row::new("circle-circle", class, backend, "overlaps");
            row.set("queries", 1e6).set("host", host).set("wrong", wrong);
            row
        };
        let rows = [
            row("tilesat", "uniform 50 % hits", 24.0, 0.0),
            row("textbook f64", "uniform 50 % hits", 18.0, 0.0),
            row("textbook f64", "far", 18.0, 480.0),
        ];
        let summary = summary(&rows);
        assert!(
            summary.contains("| **circle-circle**: uniform 50 % hits | 24.0; 0 | 18.0; 0; 480 far |  |"),
            "{summary}"
        );
    }
}
