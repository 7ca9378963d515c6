//! A question of a workload, and the backends whose answers are compared.

use crate::record::Row;
use crate::show::workloads;

/// A workload and its question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Question<'a> {
    pub workload: &'a str,
    pub asked: &'static str,
}

/// Libraries of other people, unlike textbook code.
pub fn is_library(backend: &str) -> bool {
    ["parry2d", "ncollide2d", "Box2D", "Chipmunk2D", "rapier2d", "broccoli", "rstar", "quadtree_rs"]
        .iter()
        .any(|l| backend.starts_with(l))
}

/// Whether it reports pairs of many boxes. We have several broad phases, and a game chooses one by
/// its number of bodies.
pub fn is_broad(workload: &str) -> bool {
    workload.starts_with("pairs of boxes")
}

/// Whether it moves bodies.
pub fn is_move(workload: &str) -> bool {
    workload.starts_with("move")
}

/// The first of our answers: the cheapest of a workload. For pairs of boxes each backend has
/// separate answers.
pub fn first_asked(workload: &str) -> &'static str {
    let starts = ["rays", "cast", "move", "pairs of boxes", "tiles: cast", "building"];
    let asked = ["ray", "cast", "move", "pairs", "cast", "build"];
    starts.iter().zip(asked).find(|(start, _)| workload.starts_with(**start)).map_or("overlaps", |(_, asked)| asked)
}

/// The class of a workload whose costs are shown.
pub fn usual_class(workload: &str) -> &'static str {
    match first_asked(workload) {
        "ray" if workload.ends_with("empty map") => "1024 x 1024 cells",
        "ray" => "generic",
        "move" => "circle up to 4 px",
        "pairs" => "256 boxes",
        "build" => "1000 segments",
        _ if workload.starts_with("tiles") => "platformer 20 %",
        _ => "uniform 50 % hits",
    }
}

/// Whether the tables that list classes have a line for one. The others are between two of these,
/// and only in the rows' file.
pub fn is_shown(class: &str) -> bool {
    const BETWEEN: [&str; 5] =
        ["256 x 256 cells", "2048 x 2048 cells", "100 segments", "64 boxes in clumps", "1024 boxes and a huge one"];
    let leaps = class.ends_with("that leap") && !class.starts_with("256");
    // Boxes far from the origin cost about as much as others.
    let far = class.ends_with("000 px from the origin");
    !(class.is_empty() || BETWEEN.contains(&class) || leaps || far)
}

impl<'a> Question<'a> {
    /// All our answers, with the cheapest of each workload first. Leaves out parts of other
    /// answers.
    pub fn all(rows: &'a [Row]) -> Vec<Self> {
        let mut all = Vec::new();
        for workload in workloads(rows) {
            all.push(Self { workload, asked: first_asked(workload) });
            for asked in ["contact", "distance"] {
                let is_ours = |r: &Row| (r.workload(), r.backend(), r.asked()) == (workload, "tilesat", asked);
                if rows.iter().any(is_ours) {
                    all.push(Self { workload, asked });
                }
            }
        }
        all
    }

    /// Whether a row answers it. A library's contact also answers yes or no.
    pub fn is_of(self, row: &Row) -> bool {
        row.workload() == self.workload
            && !row.class().is_empty()
            && match self.asked {
                "pairs" => true,
                "overlaps" => row.asked() == "overlaps" || (is_library(row.backend()) && row.asked() == "contact"),
                "move" => row.asked().starts_with("move"),
                asked => row.asked() == asked,
            }
    }

    /// The classes in which somebody answers it.
    pub fn classes(self, rows: &'a [Row]) -> Vec<&'a str> {
        let mut classes: Vec<&str> = Vec::new();
        for row in rows.iter().filter(|r| self.is_of(r)) {
            if !classes.contains(&row.class()) {
                classes.push(row.class());
            }
        }
        classes
    }

    pub fn name(self) -> String {
        match (self.asked, first_asked(self.workload)) {
            (asked, first) if asked == first => self.workload.to_owned(),
            (asked, _) => format!("{}, {asked}", self.workload),
        }
    }

    /// The row of some backends that answers it in a class: the cheapest correct one, else the
    /// cheapest.
    pub fn best(self, rows: &'a [Row], class: &str, of: impl Fn(&Row) -> bool) -> Option<&'a Row> {
        let all = || rows.iter().filter(|r| self.is_of(r) && r.class() == class && of(r));
        cheapest(all().filter(|r| is_right(r)), "host").or_else(|| cheapest(all(), "host"))
    }

    /// The class in which the same backend is wrong most often, and how often in a million.
    pub fn worst(self, rows: &'a [Row], row: &Row) -> Option<(&'a str, f64)> {
        let same = |r: &&Row| {
            (r.workload(), r.backend(), r.asked()) == (row.workload(), row.backend(), row.asked())
                && r.class() != "soak"
                && is_alike(r.class(), row.class())
        };
        let wrong = rows.iter().filter(same).filter_map(|r| Some((r.class(), r.wrong_per_million()?)));
        wrong.reduce(|most, other| if other.1 > most.1 { other } else { most })
    }
}

/// Moving boxes use another function than moving circles. Columns of boxes are another scene than
/// scattered boxes.
fn is_alike(a: &str, b: &str) -> bool {
    ["box up", "boxes in columns"].iter().all(|other| a.contains(other) == b.contains(other))
}

/// Whether nothing is wrong in its class.
pub fn is_right(row: &Row) -> bool {
    row.wrong_per_million() == Some(0.0)
}

/// The least cost of those rows that have one.
pub fn cheapest<'a>(rows: impl Iterator<Item = &'a Row>, column: &str) -> Option<&'a Row> {
    let costs = rows.filter_map(|r| Some((r, r.get(column)?)));
    costs.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(row, _)| row)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(backend: &str, class: &str, asked: &str, host: f64, wrong: f64) -> Row {
        let mut row = Row::new("circle-circle", class, backend, asked);
        row.set("queries", 1e6).set("host", host).set("wrong", wrong);
        row
    }

    #[test]
    fn the_cheapest_that_is_right_comes_first_and_its_worst_class_is_told() {
        let rows = [
            row("tilesat", "plain", "overlaps", 20.0, 0.0),
            row("tilesat", "plain", "contact", 90.0, 0.0),
            row("Box2D", "plain", "contact", 9.0, 1.0),
            row("parry2d", "plain", "overlaps", 30.0, 0.0),
            row("parry2d", "far", "overlaps", 30.0, 7.0),
        ];
        let all = Question::all(&rows);
        assert_eq!(all.iter().map(|q| q.name()).collect::<Vec<_>>(), ["circle-circle", "circle-circle, contact"]);
        let best = all[0].best(&rows, "plain", |r| is_library(r.backend())).unwrap();
        assert_eq!(best.backend(), "parry2d");
        assert_eq!(all[0].worst(&rows, best), Some(("far", 7.0)));
        assert_eq!(all[1].best(&rows, "plain", |r| is_library(r.backend())).unwrap().backend(), "Box2D");
    }
}
