//! The tables in the documents, and the text about who is better in which class.

use crate::question::{self, Question, cheapest, is_library, is_right};
use crate::record::Row;
use crate::tables::{short, wrapped};
use std::fmt::Write;

/// The lines of the longer table: the question, and the class whose costs it shows.
const LINES: [(&str, &str, &str); 12] = [
    ("AABB-AABB", "uniform 50 % hits", "overlaps"),
    ("circle-circle", "uniform 50 % hits", "overlaps"),
    ("circle-AABB", "uniform 50 % hits", "overlaps"),
    ("circle-segment", "uniform 50 % hits", "overlaps"),
    ("circle-circle", "uniform 50 % hits", "contact"),
    ("circle-segment", "uniform 50 % hits", "contact"),
    ("rays: platformer 20 %", "generic", "ray"),
    ("cast: circle-circle", "uniform 50 % hits", "cast"),
    ("cast: circle-segment", "uniform 50 % hits", "cast"),
    ("move: blocks 25 %", "circle up to 4 px", "move"),
    ("move: blocks 25 %", "box up to 4 px", "move"),
    ("pairs of boxes", "256 boxes", "pairs"),
];

const HEAD: &str = "<!-- precision:begin (benches/precision/run.sh writes this) -->
| | tilesat | textbook f64 | textbook f32 | naive Q16.16 | fastest library that is exact here | fastest of all others | Cortex-M0: tilesat, f32, f64 |
|---|--:|--:|--:|--:|--:|--:|--:|
";

const FOOT: &str = "
Instructions on x86-64; wrong answers in a million, in the class of the row / in the worst class of
the workload. In the class of a row, half of the pairs hit, and rays are generic. A circle or a box
moves up to 4 px per frame among blocks. The frame of 256 boxes is one of coherent motion. A frame
is wrong if it ends in the solid, even by a little. On x86-64 tilesat uses its feature `libm`, on
the Cortex-M0 it does not. Textbook boxes look only where they end, if that is exact, else at all
that they cross.
";

/// The lines of the README's table: a name, then as in [`LINES`].
const README_LINES: [(&str, &str, &str, &str); 6] = [
    ("two circles", "circle-circle", "uniform 50 % hits", "overlaps"),
    ("contact of two circles", "circle-circle", "uniform 50 % hits", "contact"),
    ("a ray through a platformer's tiles", "rays: platformer 20 %", "generic", "ray"),
    ("a circle cast at a circle", "cast: circle-circle", "uniform 50 % hits", "cast"),
    ("a circle moves, a quarter of the cells full", "move: blocks 25 %", "circle up to 4 px", "move"),
    ("a box moves there", "move: blocks 25 %", "box up to 4 px", "move"),
];

const README_HEAD: &str = "<!-- exact:begin (benches/precision/run.sh writes this) -->
| | tilesat | textbook `f64` | textbook `f32` | on a Cortex-M0: tilesat, `f32`, `f64` |
|---|--:|--:|--:|--:|
";

/// The table of the README: costs, and errors in the worst class.
pub fn readme_table(rows: &[Row]) -> String {
    let mut out = String::from(README_HEAD);
    for (name, workload, class, asked) in README_LINES {
        let question = Question { workload, asked };
        let cells = ["tilesat", "textbook f64", "textbook f32"].map(|backend| {
            let row = question.best(rows, class, |r| r.backend() == backend)?;
            let worst = grouped(&short(question.worst(rows, row)?.1));
            let worst = if worst == "0" && backend == "tilesat" { "**0**".to_owned() } else { worst };
            Some(format!("{}; {worst}", grouped(&short(row.get("host")?))))
        });
        let [ours, f64, f32] = cells.map(|cell| cell.unwrap_or("-".into()));
        let m0 = on_m0(rows, question, class, ["tilesat", "textbook f32", "textbook f64"]).map(|cell| grouped(&cell));
        let _ = writeln!(out, "| {name} | {ours} | {f64} | {f32} | {} |", m0.join(", "));
    }
    let [instructions, time] = ["host", "ns"].map(|column| cheaper(&shares(rows, column, "textbook f64", is_pair)));
    let on_m4f = cheaper(&shares(rows, "m4f", "textbook f32", |_| true));
    let text = format!(
        "On a desktop, textbook `f64` takes fewer instructions than tilesat in {instructions} of pairs, and less time in {time}. \
         On a Cortex-M4F, whose FPU computes `f32`, textbook `f32` takes fewer instructions in {on_m4f} of all queries."
    );
    format!("{out}\n{}\n<!-- exact:end -->\n", wrapped(&text, 100))
}

/// Groups the digits of a whole number from five on.
fn grouped(number: &str) -> String {
    match number.len().checked_sub(3) {
        Some(at) if at >= 2 && number.bytes().all(|c| c.is_ascii_digit()) => {
            format!("{} {}", &number[..at], &number[at..])
        }
        _ => number.to_owned(),
    }
}

/// The costs on a Cortex-M0 of the functions whose costs on a desktop are shown.
fn on_m0<const N: usize>(rows: &[Row], question: Question<'_>, class: &str, backends: [&str; N]) -> [String; N] {
    backends.map(|backend| {
        let row = question.best(rows, class, |r| r.backend() == backend);
        row.and_then(|r| r.get("m0")).map_or_else(|| "-".to_owned(), short)
    })
}

pub fn table(rows: &[Row]) -> String {
    let mut out = String::from(HEAD);
    for (workload, class, asked) in LINES {
        line(&mut out, rows, Question { workload, asked }, class);
    }
    out += FOOT;
    out += &floats(rows);
    out += "<!-- precision:end -->\n";
    out
}

/// A cost, and the errors here and in the worst class.
fn said(rows: &[Row], question: Question<'_>, row: &Row) -> Option<String> {
    let worst = question.worst(rows, row)?.1;
    Some(format!("{}; {} / {}", short(row.get("host")?), short(row.wrong_per_million()?), short(worst)))
}

fn line(out: &mut String, rows: &[Row], question: Question<'_>, class: &str) {
    let cell = |backend: &str| said(rows, question, question.best(rows, class, |r| r.backend() == backend)?);
    let Some(ours) = cell("tilesat") else { return };
    let here = |of: fn(&Row) -> bool| {
        let row = cheapest(rows.iter().filter(|r| question.is_of(r) && r.class() == class && of(r)), "host")?;
        Some(format!("{}, {}", said(rows, question, row)?, row.backend()))
    };
    let library = here(|r| is_library(r.backend()) && is_right(r));
    let any = here(|r| r.backend() != "tilesat");
    let m0 = on_m0(rows, question, class, ["tilesat", "textbook f32", "textbook f64"]);
    let name = if is_move(question) {
        format!("{}, {}", question.workload, class.split(' ').next().unwrap_or_default())
    } else if question.asked == "pairs" {
        format!("{}, {class}", question.workload)
    } else {
        question.name()
    };
    let [f64, f32, naive] = ["textbook f64", "textbook f32", "naive Q16.16"].map(|b| cell(b).unwrap_or("-".into()));
    let or_none = |cell: Option<String>| cell.unwrap_or_else(|| "none".to_owned());
    let _ = writeln!(
        out,
        "| {name} | {ours} | {f64} | {f32} | {naive} | {} | {} | {} |",
        or_none(library),
        or_none(any),
        m0.join(", ")
    );
}

/// The classes in which textbook f64 is wrong, those in which it is right, and which of the two is
/// cheaper there.
fn floats(rows: &[Row]) -> String {
    // The workloads that fail in the same classes, and the greatest error rate.
    let mut wrong: Vec<(String, Vec<&str>, f64)> = Vec::new();
    let (mut right, mut exact, mut won) = (Vec::new(), 0, 0);
    for question in Question::all(rows).into_iter().filter(|q| q.asked != "distance") {
        let (mut failing, mut asked, mut most) = (Vec::new(), 0, 0.0_f64);
        for class in question.classes(rows) {
            let best = |backend: &str| question.best(rows, class, |r| r.backend() == backend);
            let (Some(theirs), Some(ours)) = (best("textbook f64"), best("tilesat")) else { continue };
            asked += 1;
            if is_right(theirs) {
                exact += 1;
                won += u32::from(theirs.get("host") < ours.get("host"));
            } else if let Some(n) = theirs.wrong_per_million() {
                failing.push(class);
                most = most.max(n);
            }
        }
        if asked == 0 || question.asked == "contact" {
            continue;
        }
        let all = failing.len() == asked;
        let classes = if all { "all classes".to_owned() } else { failing.join(", ") };
        match wrong.iter_mut().find(|w| w.0 == classes) {
            _ if failing.is_empty() => right.push(question.workload),
            Some(same) => {
                same.1.push(question.workload);
                same.2 = same.2.max(most);
            }
            None => wrong.push((classes, vec![question.workload], most)),
        }
    }
    let wrong =
        wrong.iter().map(|(classes, of, most)| format!("| {} | {classes} | {} |\n", of.join(", "), short(*most)));
    let deepest = rows.iter().filter(|r| r.backend() == "textbook f64" && r.workload() == "move: blocks 25 %");
    let deepest = deepest.filter(|r| r.class().starts_with("circle")).filter_map(|r| r.get("deepest_px"));
    let boxes = Question { workload: "move: blocks 25 %", asked: "move" };
    let [naive, double, ours] = ["naive Q16.16", "textbook f64", "tilesat"].map(|backend| {
        let row = boxes.best(rows, "box up to 4 px", |r| r.backend() == backend);
        row.and_then(|r| r.get("host")).map_or_else(|| "-".to_owned(), short)
    });
    let m0 = ["textbook f64", "textbook f32", "naive Q16.16"].map(|it| cheaper(&shares(rows, "m0", it, |_| true)));
    let m4f = cheaper(&shares(rows, "m4f", "textbook f32", |_| true));
    let [instructions, time] = ["host", "ns"].map(|column| cheaper(&shares(rows, column, "textbook f64", is_pair)));
    let of = |which: fn(Question<'_>) -> bool| shares(rows, "host", "textbook f64", which);
    let [overlaps, contacts, moves] =
        [of(|q| is_pair(q) && q.asked == "overlaps"), of(|q| is_pair(q) && q.asked == "contact"), of(is_move)];
    let [least, most] = [moves.first(), moves.last()].map(|share| decimals(share.copied()));
    let [overlaps, contacts, moves] = [overlaps, contacts, moves].map(|shares| decimals(median(&shares)));
    let wrong_moves = rows.iter().filter(|r| r.backend() == "naive Q16.16" && question::is_move(r.workload()));
    let text = format!(
        "**Where we lose.** On a desktop textbook f64 is right in most classes: in {exact}, contacts included. In {won} of those it \
         takes fewer instructions than tilesat. Of pairs, right or wrong, it takes fewer in {instructions}, and less time in {time}. The \
         median of its instructions is {overlaps} of ours for overlaps of pairs, and {contacts} for contacts. For moves it is {moves}, \
         from {least} to {most}. On a Cortex-M4F, whose FPU computes f32, textbook f32 takes fewer instructions in {m4f}. tilesat wins \
         without an FPU, if the bits must be equal on every machine, and in the classes in which f64 is wrong:"
    );
    let after = format!(
        "Its circles among blocks are at most {} px deep. On a Cortex-M0 textbook f64 takes fewer instructions than tilesat in {}, f32 in \
         {}. Naive Q16.16, right or wrong, takes fewer in {}. Convex pairs were not counted there. Only among blocks, boxes that look at \
         all columns and rows that they cross are right in every format. They take {naive} instructions in naive Q16.16 and {double} in \
         f64; ours takes {ours}. A naive Q16.16 mover takes fewer than ours in {} on a desktop, and in {} on a Cortex-M0. It ends \
         in the solid in up to {:.0} % of its frames.",
        short(deepest.fold(0.0, f64::max)),
        m0[0],
        m0[1],
        m0[2],
        cheaper(&shares(rows, "host", "naive Q16.16", is_move)),
        cheaper(&shares(rows, "m0", "naive Q16.16", is_move)),
        wrong_moves.filter_map(Row::wrong_per_million).fold(0.0, f64::max) / 1e4,
    );
    let table = "| f64 is wrong in | classes | errors in a million, up to |\n|---|---|--:|\n";
    let wrong: String = wrong.collect();
    let never = format!("| {} | none | 0 |\n", right.join(", "));
    format!("\n{}\n\n{table}{wrong}{never}\n{}\n", wrapped(&text, 100), wrapped(&after, 100))
}

/// Whether it asks about two shapes.
fn is_pair(question: Question<'_>) -> bool {
    question.workload.contains('-') && !question.workload.contains(':')
}

fn is_move(question: Question<'_>) -> bool {
    question::is_move(question.workload)
}

/// What a backend's best costs in each class, as a share of ours, in rising order.
fn shares(rows: &[Row], column: &str, backend: &str, which: impl Fn(Question<'_>) -> bool) -> Vec<f64> {
    let mut shares = Vec::new();
    for question in Question::all(rows).into_iter().filter(|q| which(*q)) {
        for class in question.classes(rows) {
            let of = |name: &str| {
                let answers = rows.iter().filter(|r| question.is_of(r) && r.class() == class && r.backend() == name);
                cheapest(answers, column).and_then(|r| r.get(column))
            };
            if let (Some(theirs), Some(ours)) = (of(backend), of("tilesat")) {
                shares.push(theirs / ours);
            }
        }
    }
    shares.sort_by(f64::total_cmp);
    shares
}

fn cheaper(shares: &[f64]) -> String {
    format!("{} of {} classes", shares.iter().filter(|share| **share < 1.0).count(), shares.len())
}

fn median(shares: &[f64]) -> Option<f64> {
    let half = shares.len() / 2;
    let upper = *shares.get(half)?;
    Some(if shares.len().is_multiple_of(2) { f64::midpoint(upper, shares[half - 1]) } else { upper })
}

fn decimals(number: Option<f64>) -> String {
    number.map_or_else(|| "-".to_owned(), |n| format!("{n:.2}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(backend: &str, class: &str, host: f64, wrong: f64) -> Row {
        let mut row = Row::new("circle-circle", class, backend, "overlaps");
        row.set("queries", 1e6).set("host", host).set("wrong", wrong);
        row
    }

    #[test]
    fn the_classes_in_which_floats_fail_are_named() {
        let usual = "uniform 50 % hits";
        let mut rows = vec![
            row("tilesat", usual, 24.0, 0.0),
            row("tilesat", "far", 24.0, 0.0),
            row("textbook f64", usual, 18.0, 0.0),
            row("textbook f64", "far", 18.0, 480.0),
            row("Box2D", usual, 17.0, 3.0),
            row("Chipmunk2D", usual, 39.0, 0.0),
        ];
        rows[0].set("m0", 30.5);
        let table = table(&rows);
        let line = "| circle-circle | 24.0; 0 / 0 | 18.0; 0 / 480 | - | - | 39.0; 0 / 0, Chipmunk2D | 17.0; 3.00 / 3.00, Box2D | 30.5, -, - |";
        assert!(table.contains(line), "{table}");
        let line = "| two circles | 24.0; **0** | 18.0; 480 | - | 30.5, -, - |";
        assert!(readme_table(&rows).contains(line), "{}", readme_table(&rows));
        let words = table.split_whitespace().collect::<Vec<_>>().join(" ");
        let pairs = "Of pairs, right or wrong, it takes fewer in 2 of 2 classes, and less time in 0 of 0 classes.";
        assert!(words.contains(pairs) && words.contains("is 0.75 of ours for overlaps of pairs"), "{table}");
        assert!(
            table.contains("| circle-circle | far | 480 |") && table.contains("most classes: in 1, contacts included"),
            "{table}"
        );
    }
}
