//! Goals against everyone else. For each class: the fastest backend with exact answers there, and
//! the fastest of all.

use super::at_most;
use crate::question::{Question, is_right};
use crate::record::Row;
use crate::tables::short;

/// Columns of the table of costs.
pub const NAMES: [&str; 2] = ["dearer than the fastest exact", "dearer than the fastest of all"];

/// In how many classes the fastest of the others takes less, and the class in which it is most.
pub fn cells(rows: &[Row], question: Question<'_>) -> [Option<String>; 2] {
    [true, false].map(|exact| Some(cell(rows, question, exact)).filter(|cell| !cell.is_empty()))
}

fn cell(rows: &[Row], question: Question<'_>, exact: bool) -> String {
    let column = "host";
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
        let [exact, any] = cells(&rows, Question { workload: "circle-circle", asked: "overlaps" });
        assert_eq!(exact.as_deref(), Some("met, 1 of 1"));
        assert_eq!(any.as_deref(), Some("**1 of 1**, 2.00 times: near: 30.0 against 15.0 of Box2D"));
    }

    /// A game chooses the broad phase that suits it.
    #[test]
    fn the_best_broad_phase_is_held_to_the_best_of_others() {
        let own = |asked, host| row(["pairs of boxes", "8 boxes", "tilesat", asked], &[("host", host), ("wrong", 0.0)]);
        let other = row(["pairs of boxes", "8 boxes", "textbook f32", "brute"], &[("host", 50.0), ("wrong", 0.0)]);
        let exact = |rows: &[Row]| cells(rows, Question { workload: "pairs of boxes", asked: "pairs" })[0].clone();
        assert_eq!(exact(&[own("grid", 90.0), own("sweep", 50.0), other.clone()]).as_deref(), Some("met, 1 of 1"));
        let missed = exact(&[own("grid", 90.0), own("sweep", 51.0), other]).unwrap_or_default();
        assert!(missed.contains("51.0 against 50.0 of textbook f32"), "{missed}");
    }
}
