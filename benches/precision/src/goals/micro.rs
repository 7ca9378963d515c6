//! The library's goals on microcontrollers.

use super::{Goal, at_most, best_broad, f32_too, first, ours};
use crate::record::Row;

/// Yes or no, and contacts with depth and normal.
fn both(rows: &[Row]) -> impl Iterator<Item = Row> {
    ours(rows, "overlaps").chain(ours(rows, "contact")).cloned()
}

pub fn goals(rows: &[Row]) -> Vec<Goal> {
    let parry = |_: &Row, r: &Row| r.backend().starts_with("parry2d");
    let textbook = |_: &Row, r: &Row| r.backend() == "textbook f32";
    let contacts = || ours(rows, "contact").cloned();
    let motions = || ours(rows, "ray").chain(ours(rows, "cast")).cloned();
    let moves = || first(rows, true);
    vec![
        at_most(
            rows,
            "a sixth of parry2d's instructions on Cortex-M0: hits, yes or no",
            ("m0_hit", 1.0 / 6.0),
            ours(rows, "overlaps").cloned(),
            parry,
        ),
        at_most(
            rows,
            "a twentieth of parry2d's instructions on Cortex-M0: misses, yes or no",
            ("m0_miss", 1.0 / 20.0),
            ours(rows, "overlaps").cloned(),
            parry,
        ),
        at_most(
            rows,
            "a sixth of parry2d's instructions on Cortex-M0: hits, contacts",
            ("m0_hit", 1.0 / 6.0),
            contacts(),
            move |_, r| r.backend().starts_with("parry2d") && r.asked() == "contact",
        ),
        at_most(
            rows,
            "a twentieth of parry2d's instructions on Cortex-M0: misses, casts",
            ("m0_miss", 1.0 / 20.0),
            ours(rows, "cast").cloned(),
            parry,
        ),
        at_most(
            rows,
            "a sixth of parry2d's instructions on Cortex-M0: hits, casts",
            ("m0_hit", 1.0 / 6.0),
            ours(rows, "cast").cloned(),
            parry,
        ),
        at_most(
            rows,
            "at most the instructions of textbook f32 on Cortex-M0: rays and casts",
            ("m0", 1.0),
            motions(),
            f32_too,
        ),
        at_most(
            rows,
            "at most the instructions of textbook f32 on Cortex-M4F: rays and casts",
            ("m4f", 1.0),
            motions(),
            f32_too,
        ),
        at_most(
            rows,
            "at most the instructions of textbook f32 on Cortex-M0: yes or no, contacts",
            ("m0", 1.0),
            both(rows),
            f32_too,
        ),
        at_most(
            rows,
            "at most the instructions of textbook f32 on Cortex-M4F: yes or no, contacts",
            ("m4f", 1.0),
            both(rows),
            f32_too,
        ),
        at_most(rows, "at most the instructions of textbook f32 on Cortex-M0: moves", ("m0", 1.0), moves(), f32_too),
        at_most(rows, "at most the instructions of textbook f32 on Cortex-M4F: moves", ("m4f", 1.0), moves(), f32_too),
        at_most(
            rows,
            "at most the instructions of the best textbook f32 on Cortex-M0: broad phases",
            ("m0", 1.0),
            best_broad(rows, "m0").into_iter(),
            textbook,
        ),
        at_most(
            rows,
            "at most the best textbook f32's instructions on Cortex-M4F: broad phases",
            ("m4f", 1.0),
            best_broad(rows, "m4f").into_iter(),
            textbook,
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::goals::tests::cells;

    /// The goals about some rows: the last words of their texts, and the rows that miss them.
    fn missed(rows: &[Row]) -> Vec<(&'static str, Vec<String>)> {
        let told = goals(rows).into_iter().filter(|g| g.rows > 0);
        let texts = |g: Goal| g.missed.into_iter().map(|m| format!("{}: {}", m.question, m.text)).collect();
        told.map(|g| (g.text.rsplit(" on ").next().unwrap_or_default(), texts(g))).collect()
    }

    #[test]
    fn hits_of_parry_are_six_times_ours() {
        let key = |backend| ["circle-circle", "near", backend, "overlaps"];
        let ours = |hit| cells(key("tilesat"), &[("m0_hit", hit)]);
        let parry = cells(key("parry2d"), &[("m0_hit", 120.0)]);
        assert_eq!(missed(&[ours(20.0), parry.clone()]), [("Cortex-M0: hits, yes or no", vec![])]);
        let line = "circle-circle, overlaps: near: 21.0 against 120 of parry2d".to_owned();
        assert_eq!(missed(&[ours(21.0), parry]), [("Cortex-M0: hits, yes or no", vec![line])]);
    }

    #[test]
    fn moves_are_held_to_the_textbook() {
        let row = |backend, m0, m4f| cells(["move: level", "circle", backend, "move"], &[("m0", m0), ("m4f", m4f)]);
        let line = "move: level, move: circle: 60.0 against 50.0 of textbook f32".to_owned();
        let rows = [row("tilesat", 500.0, 60.0), row("textbook f32", 500.0, 50.0), row("naive Q16.16", 1.0, 1.0)];
        assert_eq!(missed(&rows), [("Cortex-M0: moves", vec![]), ("Cortex-M4F: moves", vec![line])]);
    }

    #[test]
    fn the_best_broad_phase_is_held_to_the_best_of_the_textbook() {
        let row = |backend, asked, m0| cells(["pairs of boxes", "8 boxes", backend, asked], &[("m0", m0)]);
        let others = [row("textbook f32", "sweep", 50.0), row("textbook f32", "brute", 70.0)];
        let rows = |best| [&[row("tilesat", "grid", 90.0), row("tilesat", "sweep", best)], &others[..]].concat();
        assert_eq!(missed(&rows(50.0))[0].1, [""; 0]);
        let line = "pairs of boxes, sweep: 8 boxes: 51.0 against 50.0 of textbook f32";
        assert_eq!(missed(&rows(51.0))[0].1, [line]);
    }
}
