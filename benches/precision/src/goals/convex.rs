//! The library's goal for pairs of convex shapes.

use super::{Goal, at_most, ours};
use crate::convex::is_convex;
use crate::question::is_library;
use crate::record::Row;

/// Against the cheapest of three, right or wrong.
pub fn goal(rows: &[Row]) -> Goal {
    let own = ["overlaps", "contact", "distance"]
        .into_iter()
        .flat_map(|asked| ours(rows, asked))
        .filter(|r| is_convex(r.workload()))
        .cloned();
    let text = "at most the instructions of textbook f64, parry2d and Box2D, convex pairs";
    let others = |own: &Row, other: &Row| {
        let is_rival = ["textbook f64", "parry2d", "Box2D"].iter().any(|name| other.backend().starts_with(name));
        // A library's contact also answers yes or no.
        let answers = other.asked() == own.asked()
            || (own.asked() == "overlaps" && other.asked() == "contact" && is_library(other.backend()));
        is_rival && answers
    };
    at_most(rows, text, ("host", 1.0), own, others)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::goals::tests::cells;

    #[test]
    fn each_question_is_held_to_its_answers() {
        let row = |backend, asked, host| cells(["quad-quad", "boxes overlap", backend, asked], &[("host", host)]);
        let rows = [
            row("tilesat", "overlaps", 50.0),
            row("tilesat", "contact", 90.0),
            row("textbook f64", "overlaps", 50.0),
            row("textbook f32", "overlaps", 9.0),
            row("Box2D", "contact", 80.0),
            row("Chipmunk2D", "contact", 1.0),
        ];
        let missed = goal(&rows);
        assert_eq!((missed.rows, missed.missed.len()), (2, 1));
        assert_eq!(missed.missed[0].text, "boxes overlap: 90.0 against 80.0 of Box2D");
    }
}
