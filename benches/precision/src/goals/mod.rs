//! The library's goals, and the rows that miss them.

mod convex;
mod micro;
pub mod peers;

use crate::question::{first_asked, is_broad, is_move, usual_class};
use crate::record::Row;
use crate::tables::{short, wrapped};
use std::fmt::Write;

/// A missed goal: the question, its class, the backend, and how many times the allowed cost it has.
struct Miss {
    question: String,
    text: String,
    times: f64,
}

/// One goal: the number of rows that it covers, and the rows that miss it.
struct Goal {
    text: &'static str,
    rows: usize,
    missed: Vec<Miss>,
}

/// The library's rows that answer a question.
fn ours<'a>(rows: &'a [Row], asked: &'a str) -> impl Iterator<Item = &'a Row> {
    rows.iter().filter(move |r| r.backend() == "tilesat" && r.asked() == asked)
}

/// The least cost among rows of the same workload and class.
fn least<'a>(rows: &'a [Row], row: &Row, column: &str, of: impl Fn(&Row) -> bool) -> Option<(&'a Row, f64)> {
    let same = rows.iter().filter(|r| r.workload() == row.workload() && r.class() == row.class() && of(r));
    same.filter_map(|r| Some((r, r.get(column)?))).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// At most `factor` times the best cost of others.
fn at_most(
    rows: &[Row],
    text: &'static str,
    (column, factor): (&str, f64),
    own: impl Iterator<Item = Row>,
    others: impl Fn(&Row, &Row) -> bool,
) -> Goal {
    let mut goal = Goal { text, rows: 0, missed: Vec::new() };
    for row in own {
        let Some(cost) = row.get(column) else { continue };
        let Some((best, other)) = least(rows, &row, column, |r| others(&row, r)) else { continue };
        goal.rows += 1;
        if cost > other * factor {
            goal.missed.push(Miss {
                question: format!("{}, {}", row.workload(), row.asked()),
                text: format!("{}: {} against {} of {}", row.class(), short(cost), short(other), best.backend()),
                times: cost / (other * factor),
            });
        }
    }
    goal
}

/// The first question of each workload: yes or no, rays, casts, moves.
fn first(rows: &[Row], moves: bool) -> impl Iterator<Item = Row> {
    let of = move |r: &&Row| r.backend() == "tilesat" && r.asked() == first_asked(r.workload());
    rows.iter().filter(of).filter(move |r| is_move(r.workload()) == moves).cloned()
}

/// The cheapest of our broad phases in each class.
fn best_broad(rows: &[Row], column: &str) -> Vec<Row> {
    let own = |r: &&Row| r.backend() == "tilesat" && is_broad(r.workload());
    let mut classes: Vec<&str> = rows.iter().filter(own).map(Row::class).collect();
    classes.dedup();
    classes
        .iter()
        .filter_map(|c| crate::question::cheapest(rows.iter().filter(own).filter(|r| r.class() == *c), column))
        .cloned()
        .collect()
}

/// A count of faults, which must be zero.
fn none(rows: &[Row], text: &'static str, column: &str, of: impl Fn(&str) -> bool) -> Goal {
    let own = rows.iter().filter(|r| r.backend() == "tilesat" && r.get(column).is_some() && of(r.workload()));
    let bad = own.clone().filter(|r| r.get(column) > Some(0.0));
    let told = |r: &Row| {
        let (n, all) = (r.get(column).unwrap_or(0.0), r.get("queries").unwrap_or(0.0));
        Miss {
            question: format!("{}, {}", r.workload(), r.asked()),
            text: format!("{}: {} of {}", r.class(), short(n), short(all)),
            times: n,
        }
    };
    Goal { text, rows: own.count(), missed: bad.map(told).collect() }
}

/// The textbook's answer to the same question.
fn f32_too(own: &Row, other: &Row) -> bool {
    other.backend() == "textbook f32" && other.asked() == own.asked()
}

fn goals(rows: &[Row]) -> Vec<Goal> {
    let usual = |r: &Row| r.class() == usual_class(r.workload());
    let mut soak = Goal { text: "0 wrong of 10^9 adversarial queries per pair", rows: 0, missed: Vec::new() };
    for row in ours(rows, "overlaps").filter(|r| r.class() == "soak") {
        soak.rows += 1;
        let (n, wrong) = (row.get("queries").unwrap_or(0.0), row.get("wrong").unwrap_or(0.0));
        if n < 1e9 || wrong > 0.0 {
            let text = format!("{wrong} wrong of {n:.2e}");
            soak.missed.push(Miss { question: row.workload().to_owned(), text, times: wrong });
        }
    }
    vec![
        none(rows, "0 wrong answers", "wrong", |w| !is_move(w) && !is_broad(w)),
        none(rows, "0 late times of impact", "late", |_| true),
        none(rows, "0 overlaps after a move", "wrong", is_move),
        none(rows, "0 tunnels", "tunnels", is_move),
        none(rows, "0 frames stuck although a way existed", "stuck", is_move),
        none(rows, "0 missing pairs of boxes", "wrong", is_broad),
        soak,
        at_most(
            rows,
            "at most 1.25 times the instructions of textbook f32, half of the pairs hit",
            ("host", 1.25),
            ours(rows, "overlaps").filter(|r| usual(r)).cloned(),
            f32_too,
        ),
        at_most(
            rows,
            "at most the instructions of a plain integer walk: rays",
            ("host", 1.0),
            ours(rows, "ray").cloned(),
            |_, r| r.backend() == "plain integer DDA",
        ),
        convex::goal(rows),
    ]
}

/// The questions that miss a goal, with their numbers of classes, and the worst of all.
fn misses(out: &mut String, missed: &[Miss]) {
    let Some(worst) = missed.iter().max_by(|a, b| a.times.total_cmp(&b.times)) else { return };
    let mut questions: Vec<(&str, usize)> = Vec::new();
    for miss in missed {
        match questions.iter_mut().find(|q| q.0 == miss.question) {
            Some(question) => question.1 += 1,
            None => questions.push((&miss.question, 1)),
        }
    }
    let all = questions.iter().map(|(question, n)| format!("{question} ({n})")).collect::<Vec<_>>().join("; ");
    let text = wrapped(&format!("{all}. Worst: {}, {}", worst.question, worst.text), 98);
    let _ = writeln!(out, "  {}", text.replace('\n', "\n  "));
}

/// The part of the page that shows our losses.
pub fn page(rows: &[Row]) -> String {
    let mut out = String::from("\n## Goals, and the classes that miss them\n\n");
    let (mut met, mut unmeasured) = (Vec::new(), Vec::new());
    for goal in goals(rows).into_iter().chain(micro::goals(rows)) {
        if goal.rows == 0 {
            unmeasured.push(goal.text.to_owned());
        } else if goal.missed.is_empty() {
            met.push(format!("{} ({})", goal.text, goal.rows));
        } else {
            let (missed, all) = (goal.missed.len(), goal.rows);
            let text = wrapped(&format!("- **missed in {missed} of {all} classes**: {}.", goal.text), 98);
            let _ = writeln!(out, "{}", text.replace('\n', "\n  "));
            misses(&mut out, &goal.missed);
        }
    }
    for (mark, goals) in [("met, with the number of classes", met), ("not measured", unmeasured)] {
        if !goals.is_empty() {
            let text = wrapped(&format!("- **{mark}**: {}", goals.join("; ")), 98);
            let _ = writeln!(out, "{}", text.replace('\n', "\n  "));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(backend: &str, host: f64, wrong: f64) -> Row {
        let mut row = Row::new("circle-circle", "uniform 50 % hits", backend, "overlaps");
        row.set("queries", 10.0).set("host", host).set("wrong", wrong);
        row
    }

    #[test]
    fn a_goal_is_missed_where_others_are_faster_or_an_answer_is_wrong() {
        let met = page(&[row("tilesat", 20.0, 0.0), row("Box2D", 20.0, 3.0), row("textbook f32", 16.0, 1.0)]);
        assert!(!met.contains("missed"), "{met}");
        let missed = page(&[row("tilesat", 21.0, 1.0), row("Box2D", 20.0, 0.0), row("textbook f32", 16.0, 1.0)]);
        assert_eq!(missed.matches("missed in").count(), 2, "{missed}");
        let words = missed.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains("uniform 50 % hits: 21.0 against 16.0 of textbook f32"), "{missed}");
    }

    pub(super) fn cells(key: [&str; 4], cells: &[(&str, f64)]) -> Row {
        let mut row = Row::new(key[0], key[1], key[2], key[3]);
        row.set("queries", 100.0);
        for (column, value) in cells {
            row.set(column, *value);
        }
        row
    }

    #[test]
    fn moves_are_held_to_no_overlap_and_no_tunnel() {
        let row = |wrong, tunnels, stuck| {
            let counts = [("wrong", wrong), ("tunnels", tunnels), ("stuck", stuck)];
            page(&[cells(["move: level", "circle", "tilesat", "move"], &counts)])
        };
        assert!(!row(0.0, 0.0, 0.0).contains("missed"));
        assert!(row(1.0, 0.0, 0.0).contains("**missed in 1 of 1 classes**: 0 overlaps after a move"));
        assert!(
            row(0.0, 2.0, 0.0)
                .contains("0 tunnels.\n  move: level, move (1). Worst: move: level, move, circle: 2.00 of 100")
        );
        assert!(row(0.0, 0.0, 3.0).contains("**missed in 1 of 1 classes**: 0 frames stuck"));
    }
}
