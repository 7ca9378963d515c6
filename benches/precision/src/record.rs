//! The results: a row per workload, class, backend and question. All pages and pictures come from
//! this file alone.
//!
//! A cell that was not measured is empty. Another workload adds rows, and another measure adds a
//! column to [`COLUMNS`]. Their keys join parts that different programs measured.

use std::collections::BTreeMap;
use std::fmt::Write;

/// The key of a row.
pub const KEYS: [&str; 4] = ["workload", "class", "backend", "asked"];

/// The values of a row. Errors are in pixels; for a time, in pixels of way. `ulp` is in units of
/// the backend's own format.
pub const COLUMNS: [&str; 25] = [
    "queries",
    // Answers that are wrong by the strict convention, and by the one in which touching counts.
    "wrong",
    "wrong_closed",
    "max_px",
    "mean_px",
    "max_ulp",
    "mean_ulp",
    // Times of impact beyond the true one, of all hits, and how far they lead into the other shape.
    "late",
    "hits",
    "deepest_px",
    // Frames that move a body: ends deeper than a 64th of a pixel and than a pixel, through the
    // solid, or without a possible motion. For pairs of boxes: disjoint ones.
    "deep",
    "lost",
    "tunnels",
    "stuck",
    "extra",
    "ns",
    // Instructions per query: on the host by callgrind, on microcontrollers in the emulator.
    "host",
    "m0",
    "m0_hit",
    "m0_miss",
    "m4f",
    "m4f_hit",
    "m4f_miss",
    // Bytes of the query with everything that it links. In a row without a class, or with the
    // common prefix of its classes.
    "flash_m0",
    "flash_m4f",
];

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    pub key: [String; 4],
    cells: BTreeMap<&'static str, f64>,
}

impl Row {
    pub fn new(workload: &str, class: &str, backend: &str, asked: &str) -> Self {
        Self { key: [workload, class, backend, asked].map(str::to_owned), cells: BTreeMap::new() }
    }

    /// # Panics
    /// If there is no such column.
    pub fn set(&mut self, column: &str, value: f64) -> &mut Self {
        self.cells.insert(column_named(column).expect("a column of the table"), value);
        self
    }

    pub fn get(&self, column: &str) -> Option<f64> {
        self.cells.get(column).copied()
    }

    pub fn remove(&mut self, column: &str) {
        self.cells.remove(column);
    }

    pub fn workload(&self) -> &str {
        &self.key[0]
    }

    pub fn class(&self) -> &str {
        &self.key[1]
    }

    pub fn backend(&self) -> &str {
        &self.key[2]
    }

    pub fn asked(&self) -> &str {
        &self.key[3]
    }

    /// Wrong answers in a million, tunnels included, by the convention that suits the backend
    /// better. `None` if nothing was judged.
    pub fn wrong_per_million(&self) -> Option<f64> {
        let strict = self.get("wrong")?;
        let wrong = self.get("wrong_closed").map_or(strict, |closed| strict.min(closed));
        Some((wrong + self.get("tunnels").unwrap_or(0.0)) * 1e6 / self.get("queries")?)
    }

    /// Takes the cells of a later part. A time belongs to the code that was counted. With another
    /// count it goes, unless there is a new time.
    fn renew(&mut self, part: Self) {
        if let (Some(old), Some(new)) = (self.get("host"), part.get("host"))
            && (new - old).abs() > old * SAME
        {
            self.remove("ns");
        }
        self.cells.extend(part.cells);
    }

    /// Whether the convention that suits it is the one in which touching counts.
    pub fn is_closed(&self) -> bool {
        matches!((self.get("wrong"), self.get("wrong_closed")), (Some(strict), Some(closed)) if closed < strict)
    }
}

/// Counts of the same code may differ by this much: code around the loop takes a different time.
const SAME: f64 = 0.01;

fn column_named(name: &str) -> Option<&'static str> {
    COLUMNS.iter().copied().find(|c| *c == name)
}

/// All values except counts have at most six significant digits.
fn number(v: f64) -> String {
    if v == v.trunc() && v.abs() < 1e15 {
        format!("{v}")
    } else {
        format!("{}", format!("{v:.5e}").parse::<f64>().unwrap_or(v))
    }
}

pub fn to_csv(rows: &[Row]) -> String {
    let mut out = KEYS.iter().chain(&COLUMNS).copied().collect::<Vec<_>>().join(",");
    out.push('\n');
    for row in rows {
        out.push_str(&row.key.join(","));
        for column in COLUMNS {
            let _ = write!(out, ",{}", row.get(column).map(number).unwrap_or_default());
        }
        out.push('\n');
    }
    out
}

/// # Errors
/// A text with the number of the wrong line.
pub fn from_csv(text: &str) -> Result<Vec<Row>, String> {
    let mut lines = text.lines().enumerate();
    let header: Vec<&str> = lines.next().map(|(_, l)| l.split(',').collect()).unwrap_or_default();
    if header.get(..4) != Some(&KEYS) {
        return Err("line 1: not a table of results".into());
    }
    lines
        .map(|(i, line)| {
            let fields: Vec<&str> = line.split(',').collect();
            if fields.len() != header.len() {
                return Err(format!("line {}: {} fields", i + 1, fields.len()));
            }
            let mut row = Row::new(fields[0], fields[1], fields[2], fields[3]);
            for (name, field) in header[4..].iter().zip(&fields[4..]).filter(|(_, f)| !f.is_empty()) {
                let column = column_named(name).ok_or_else(|| format!("line 1: no column {name}"))?;
                let value = field.parse().map_err(|_| format!("line {}: {field}", i + 1))?;
                row.cells.insert(column, value);
            }
            Ok(row)
        })
        .collect()
}

/// Rows of all parts, in the order in which their keys first appear. A later part's cell replaces
/// an earlier one.
pub fn join(parts: impl IntoIterator<Item = Row>) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for part in parts {
        match rows.iter_mut().find(|r| r.key == part.key) {
            Some(row) => row.renew(part),
            None => rows.push(part),
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::{Row, from_csv, join, to_csv};

    #[test]
    fn csv_keeps_what_was_measured() {
        let mut a = Row::new("w", "c", "b", "q");
        a.set("wrong", 3.0).set("ns", 12.25);
        let mut b = Row::new("w", "c", "b", "q");
        b.set("host", 41.0);
        let rows = join([a, b]);
        assert_eq!(rows.len(), 1);
        assert_eq!(from_csv(&to_csv(&rows)).as_deref(), Ok(&rows[..]));
        let mut other = Row::new("w", "c", "b", "q");
        other.set("host", 41.2);
        assert_eq!(join([rows[0].clone(), other.clone()])[0].get("ns"), Some(12.25));
        other.set("host", 45.0);
        assert_eq!(join([rows[0].clone(), other])[0].get("ns"), None);
        assert!(from_csv("workload,class\n").is_err());
        assert_eq!(from_csv(&to_csv(&rows).replace("12.25", "x")).unwrap_err(), "line 2: x");
    }
}
