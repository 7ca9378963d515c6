//! Goals against everyone else. For each class: the fastest backend with exact answers there, and
//! the fastest of all.

use super::at_most;
use crate::question::{Question, is_right};
use crate::record::Row;
use crate::tables::short;
use std::fmt::Write;

const HEAD: &str = "
This table compares with the fastest of all others: textbook code in every format, this benchmark's
own integers, and libraries. The columns *exact* count only backends that are exact in the class,
and the columns *any* count all. A cell shows in how many classes the library misses the goal, and
by what factor in the worst one. Only times that did not stray count, so few classes may be left. An
empty cell has none.

| missed | instructions, exact | instructions, any | ns, exact | ns, any |
|---|--:|--:|--:|--:|
";

/// A table of all questions.
pub fn page(rows: &[Row]) -> String {
    let mut out = String::from(HEAD);
    for question in Question::all(rows) {
        let cells = [("host", true), ("host", false), ("ns", true), ("ns", false)];
        let cells = cells.map(|(column, exact)| cell(rows, question, column, exact));
        if cells.iter().any(|c| !c.is_empty()) {
            let _ = writeln!(out, "| {} | {} |", question.name(), cells.join(" | "));
        }
    }
    out
}

fn cell(rows: &[Row], question: Question<'_>, column: &str, exact: bool) -> String {
    let own = question.classes(rows).into_iter().filter_map(|class| {
        let ours = rows.iter().filter(|r| question.is_of(r) && r.class() == class && r.backend() == "tilesat");
        crate::question::cheapest(ours, column)
    });
    let others = |_: &Row, r: &Row| r.backend() != "tilesat" && question.is_of(r) && (!exact || is_right(r));
    let goal = at_most(rows, "", (column, 1.0), own.cloned(), others);
    match goal.missed.iter().max_by(|a, b| a.times.total_cmp(&b.times)) {
        None if goal.rows == 0 => String::new(),
        None => format!("met, {} of {0}", goal.rows),
        Some(worst) => {
            format!("**{} of {}**, {} times: {}", goal.missed.len(), goal.rows, short(worst.times), worst.text)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::goals::tests::cells as row;

    #[test]
    fn whoever_is_wrong_counts_only_among_any() {
        let key = |backend, asked| ["circle-circle", "near", backend, asked];
        let rows = [
            row(key("tilesat", "overlaps"), &[("host", 30.0), ("wrong", 0.0)]),
            row(key("Box2D", "contact"), &[("host", 15.0), ("wrong", 3.0)]),
            row(key("textbook f64", "overlaps"), &[("host", 40.0), ("wrong", 0.0)]),
        ];
        let page = page(&rows);
        let line = "| circle-circle | met, 1 of 1 | **1 of 1**, 2.00 times: near: 30.0 against 15.0 of Box2D |  |  |";
        assert!(page.contains(line), "{page}");
    }

    /// A game chooses the broad phase that suits it.
    #[test]
    fn the_best_broad_phase_is_held_to_the_best_of_others() {
        let own = |asked, host| row(["pairs of boxes", "8 boxes", "tilesat", asked], &[("host", host), ("wrong", 0.0)]);
        let other = row(["pairs of boxes", "8 boxes", "textbook f32", "brute"], &[("host", 50.0), ("wrong", 0.0)]);
        assert!(
            page(&[own("grid", 90.0), own("sweep", 50.0), other.clone()]).contains("| met, 1 of 1 | met, 1 of 1 |")
        );
        assert!(page(&[own("grid", 90.0), own("sweep", 51.0), other]).contains("51.0 against 50.0 of textbook f32"));
    }
}
