//! Everything that is shown, from the rows alone: pictures, the page of results, and a short table.

use crate::goals;
use crate::micro;
use crate::plot::{Axes, svg};
use crate::record::Row;
use crate::tables;
use crate::{read_rows, write};
use std::fmt::Write;
use std::path::Path;

type Value = fn(&Row) -> Option<f64>;

/// Workloads in the order of the rows.
pub fn workloads(rows: &[Row]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for row in rows {
        if !names.contains(&row.workload()) {
            names.push(row.workload());
        }
    }
    names
}

/// A name for a file.
fn file_name(workload: &str) -> String {
    let plain = workload.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' });
    plain.collect::<String>().split('-').filter(|s| !s.is_empty()).collect::<Vec<_>>().join("-")
}

/// # Errors
/// Where the rows cannot be read or a file not be written.
pub fn all(results: &Path) -> Result<(), String> {
    let rows = read_rows(results)?;
    if rows.is_empty() {
        return Err(format!("{}: no results", results.display()));
    }
    let folder = results.with_file_name("plots");
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut page = String::from(HEAD);
    let machine = results.with_file_name("machine.md");
    page.push_str(&std::fs::read_to_string(&machine).map_err(|e| format!("{}: {e}", machine.display()))?);
    page.push_str(&goals::page(&rows));
    page.push_str(&micro::page(&rows));
    for workload in workloads(&rows) {
        let of: Vec<&Row> = rows.iter().filter(|r| r.workload() == workload && !r.class().is_empty()).collect();
        if of.iter().all(|r| r.get("host").is_none()) {
            continue;
        }
        let _ = writeln!(page, "\n## {workload}");
        let label =
            if tables::is_framed(&of) { "instructions a frame (x86-64)" } else { "instructions a query (x86-64)" };
        let x: (&str, Value) = (label, |r| r.get("host"));
        let wrong: (&str, Value) = ("wrong in a million", Row::wrong_per_million);
        let error: (&str, Value) = ("largest error, px", |r| r.get("max_px"));
        for (what, ending, y) in [("wrong answers", "", wrong), ("largest error", "-error", error)] {
            if of.iter().all(|r| (y.1)(r).is_none()) {
                continue;
            }
            let name = format!("{}{ending}.svg", file_name(workload));
            let title = format!("{workload}: {what} against instructions");
            write(&folder.join(&name), &svg(&of, &Axes { title, x, y }))?;
            let _ = writeln!(page, "\n![{workload}, {what}](plots/{name})");
        }
        page.push_str(&tables::workload(&of));
    }
    write(&results.with_file_name("results.md"), &page)?;
    write(&results.with_file_name("readme-table.md"), &tables::readme(&rows))
}

const HEAD: &str = "# Run time against error

Written by `benches/precision/run.sh` from `results.csv`. What is asked, of whom and how it is judged: `src/main.rs`.

- **Wrong in a million**: yes or no against exact integers, by the convention that suits the backend better over a class: touching is
  overlapping (marked `c`), or it is not. A ray is right that fits one of the two.
- **Instructions**: callgrind, one call from a loop with operands in memory and the whole answer stored; the loop is in it (about 6).
- **ns**: the fastest of 7 passes within one run, backends in turn. Compare within a row's class only.
- **Error**: of depths, and of times of impact as pixels of way. `late`: of all hits, those whose time is beyond the true one.
- **Moves**: a frame is wrong that ends in the solid, by however little, or tunnels; ends by over 1/64 px and depths are told beside it. A
  sequence of 32 frames is judged until it is lost: a pixel deep, or through a wall. Engines keep a gap of their own from the solid.
- **Pairs of boxes**: wrong are those that overlap and are not told; a frame moves all boxes and tells all pairs.
- `overlaps`, `would hit`: yes or no. `contact`: depth and normal at once. `contact (lazy)`: as it is returned, nothing rounded yet.

";
