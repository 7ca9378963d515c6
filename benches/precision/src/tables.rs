//! Tables of the page, as Markdown: a line per question, a column per backend. The rows' file has
//! all classes.

use crate::question::{Question, is_shown, usual_class};
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

/// In lines of at most so many columns.
pub fn wrapped(text: &str, most: usize) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.is_empty() || line.len() + word.len() < most => {
                line.push_str(if line.is_empty() { "" } else { " " });
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.join("\n")
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

/// A table without the columns and the lines in which nobody has a cell.
fn table(first: &str, columns: &[&str], lines: &[(String, Vec<Option<String>>)]) -> String {
    let lines: Vec<_> = lines.iter().filter(|line| line.1.iter().any(Option::is_some)).collect();
    let is_used = |column: usize| lines.iter().any(|line| line.1.get(column).is_some_and(Option::is_some));
    let used: Vec<usize> = (0..columns.len()).filter(|&column| is_used(column)).collect();
    let names = used.iter().filter_map(|&i| columns.get(i).copied()).collect::<Vec<_>>().join(" | ");
    let mut out = format!("\n| {first} | {names} |\n|---|{}\n", "--:|".repeat(used.len()));
    for (name, cells) in lines {
        let cells = used.iter().map(|&i| cells.get(i).and_then(Option::as_deref).unwrap_or_default());
        let _ = writeln!(out, "| {name} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    out
}

/// The names of all columns.
const NAMES: [&str; 12] = {
    let (mut names, mut i) = ([""; 12], 0);
    while i < 12 {
        names[i] = COLUMNS[i].0;
        i += 1;
    }
    names
};

/// The row of each column that answers a question in a class.
fn answers<'a>(rows: &'a [Row], question: Question<'a>, class: &str) -> [Option<&'a Row>; 12] {
    COLUMNS.map(|(_, backends)| question.best(rows, class, |r| backends.contains(&r.backend())))
}

/// Its cost and its errors. Also the class where it is wrong most often, if that is another one.
fn cost(rows: &[Row], question: Question<'_>, row: &Row) -> Option<String> {
    let wrong = row.wrong_per_million()?;
    let worst = question.worst(rows, row).filter(|worst| worst.1 > wrong);
    let worst = worst.map(|(class, n)| format!("; {} {class}", short(n))).unwrap_or_default();
    Some(format!("{}; {}{worst}", short(row.get("host")?), short(wrong)))
}

/// The usual class of each question, for each backend the class where it is wrong most often, and
/// more columns.
pub fn summary<const N: usize>(
    rows: &[Row],
    more: [&str; N],
    cells: impl Fn(Question<'_>) -> [Option<String>; N],
) -> String {
    let line = |question: Question<'_>| {
        let class = usual_class(question.workload);
        let costs = answers(rows, question, class).map(|r| cost(rows, question, r?));
        (format!("**{}**: {class}", question.name()), costs.into_iter().chain(cells(question)).collect::<Vec<_>>())
    };
    let names: Vec<&str> = NAMES.into_iter().chain(more).collect();
    table("usual class", &names, &Question::all(rows).into_iter().map(line).collect::<Vec<_>>())
}

/// The largest error of all classes, and for times the number of late ones. A line per backend:
/// there are more questions than backends.
pub fn errors(rows: &[Row]) -> String {
    let questions: Vec<_> = Question::all(rows);
    let questions: Vec<_> = questions.iter().filter(|q| !["overlaps", "pairs", "build"].contains(&q.asked)).collect();
    let cell = |question: &Question<'_>, column: usize| {
        let usual = answers(rows, *question, usual_class(question.workload))[column]?;
        let same =
            |r: &&Row| (r.workload(), r.backend(), r.asked()) == (usual.workload(), usual.backend(), usual.asked());
        let largest = |value: fn(&Row) -> Option<f64>| rows.iter().filter(same).filter_map(value).reduce(f64::max);
        let late = largest(|r| Some(r.get("late")? * 100.0 / r.get("hits").filter(|n| *n > 0.0)?));
        let late = late.map(|share| format!("; {}", short(share))).unwrap_or_default();
        Some(format!("{}{late}", short(largest(|r| r.get("max_px"))?)))
    };
    let line = |column: usize| questions.iter().map(|q| cell(q, column)).collect();
    let lines: Vec<(String, Vec<_>)> =
        NAMES.iter().enumerate().map(|(i, name)| ((*name).to_owned(), line(i))).collect();
    let names: Vec<String> = questions.iter().map(|q| q.name()).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    table("px; late in a hundred hits", &names, &lines)
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
    let mut lines = Vec::new();
    let mut seen: Vec<(&str, &str)> = Vec::new();
    let is_far = |r: &Row| r.class().ends_with("from the origin");
    for row in rows.iter().filter(|r| r.get("tunnels").is_some() && !is_far(r)) {
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
        lines.push((format!("{}, {}", key.0, key.1), cells.to_vec()));
    }
    table("any / > 1/64 px / > 1 px / tunnels / stuck", &names, &lines)
}

fn share(row: &Row, n: f64) -> String {
    row.get("queries").map_or_else(String::new, |all| short(n * 1e6 / all))
}

/// All classes of workloads with few rows: questions about whole levels.
pub fn classes<'a>(rows: &[Row], workloads: impl Iterator<Item = &'a str>) -> String {
    let mut lines = Vec::new();
    for workload in workloads {
        let question = Question { workload, asked: crate::question::first_asked(workload) };
        for class in question.classes(rows).into_iter().filter(|class| is_shown(class)) {
            let cells = answers(rows, question, class).map(|row| {
                let row = row?;
                let wrong = row.wrong_per_million().filter(|n| *n > 0.0);
                let wrong = wrong.map(|n| format!("; {} wrong", short(n))).unwrap_or_default();
                Some(format!("{}{wrong}", short(row.get("host")?)))
            });
            lines.push((format!("{workload}, {class}"), cells.to_vec()));
        }
    }
    table("", &NAMES, &lines)
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
        let summary = summary(&rows, [], |_| []);
        assert!(summary.contains("| **circle-circle**: uniform 50 % hits | 24.0; 0 | 18.0; 0; 480 far |"), "{summary}");
    }
}
