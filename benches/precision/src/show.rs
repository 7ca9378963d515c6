//! Pictures, the page of results, and a short table, all from the rows alone.

use crate::batch;
use crate::goals;
use crate::grids;
use crate::micro;
use crate::plot::{Axes, svg};
use crate::readme;
use crate::record::Row;
use crate::tables;
use crate::{read_rows, write};
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
/// If it cannot read the rows or write a file.
pub fn all(results: &Path) -> Result<(), String> {
    let rows = read_rows(results)?;
    if rows.is_empty() {
        return Err(format!("{}: no results", results.display()));
    }
    let folder = results.with_file_name("plots");
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let counted: Vec<&Row> = rows.iter().filter(|r| r.get("host").is_some()).collect();
    let timed = counted.iter().filter(|r| r.get("ns").is_some()).count();
    let mut page = HEAD.replace("TIMED", &format!("{timed} of {}", counted.len()));
    let machine = results.with_file_name("machine.md");
    page.push_str(&std::fs::read_to_string(&machine).map_err(|e| format!("{}: {e}", machine.display()))?);
    page.push_str(&goals::page(&rows));
    page.push_str("\n## Cost and errors\n\nInstructions; wrong in a million; and the same in the class in which that answer is wrong most\noften, if that is another one. The last two columns: in how many classes the fastest of all others\ntakes fewer instructions, and where it is most. *Exact* counts only backends exact there.\n");
    page.push_str(&tables::summary(&rows, goals::peers::NAMES, |question| goals::peers::cells(&rows, question)));
    page.push_str("\n## Errors of depths and times\n\nThe largest error of all classes, in px, of the way whose cost is shown; of times also % late. The\ngeneral contact of capsules in parry2d-f64 is at most 3.9e-4 px off.\n");
    page.push_str(&tables::errors(&rows));
    page.push_str(
        "\n## Frames of bodies that move\n\nPer million frames. `results.csv` has the same 7000 px from the origin.\n",
    );
    page.push_str(&tables::frames(&rows));
    page.push_str("\n## Levels\n\nInstructions of the cheapest answer, and errors in a million. Circles ask parry2d's tree of boxes:\n`Voxels` take 2 to 8 times as much, and up to 9277 casts in a million are wrong.\n");
    let levels = workloads(&rows).into_iter().filter(|w| w.contains("map") || w.starts_with("tiles"));
    page.push_str(&tables::classes(&rows, levels));
    page.push_str(&grids::page(&rows));
    page.push_str(&batch::page(&rows));
    page.push_str(&micro::page(&rows));
    for workload in workloads(&rows) {
        plots(&rows, workload, &folder)?;
    }
    write(&results.with_file_name("results.md"), &page)?;
    // The documents show the reviewed rows, not those of a quick run.
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    if results.canonicalize().ok() == own.join("results.csv").canonicalize().ok() {
        put(&own.join("../../src/boards.md"), &readme::table(&rows))?;
        put(&own.join("../../README.md"), &readme::readme_table(&rows))?;
    }
    Ok(())
}

/// Puts a block in place of that with the same marks, which are its first and last lines.
fn put(document: &Path, block: &str) -> Result<(), String> {
    let failed = |why: &dyn std::fmt::Display| format!("{}: {why}", document.display());
    let text = std::fs::read_to_string(document).map_err(|e| failed(&e))?;
    let (begin, end) = (block.lines().next().unwrap_or_default(), block.lines().last().unwrap_or_default());
    let parts = text.split_once(begin).and_then(|(before, rest)| Some((before, rest.split_once(end)?.1)));
    let (before, after) = parts.ok_or_else(|| failed(&format!("no lines \"{begin}\" and \"{end}\"")))?;
    write(document, &format!("{before}{}{after}", block.trim_end()))
}

/// The pictures of a workload.
fn plots(rows: &[Row], workload: &str, folder: &Path) -> Result<(), String> {
    let of: Vec<&Row> = rows.iter().filter(|r| r.workload() == workload && !r.class().is_empty()).collect();
    let framed = of.iter().any(|r| r.get("tunnels").or(r.get("extra")).is_some());
    let x: (&str, Value) = (if framed { FRAME } else { QUERY }, |r| r.get("host"));
    let wrong: (&str, Value) = ("wrong in a million", Row::wrong_per_million);
    let error: (&str, Value) = ("largest error, px", |r| r.get("max_px"));
    for (what, ending, y) in [("wrong answers", "", wrong), ("largest error", "-error", error)] {
        if of.iter().all(|r| r.get("host").is_none() || (y.1)(r).is_none()) {
            continue;
        }
        let name = format!("{}{ending}.svg", file_name(workload));
        let title = format!("{workload}: {what} against instructions");
        write(&folder.join(&name), &svg(&of, &Axes { title, x, y }))?;
    }
    Ok(())
}

const FRAME: &str = "instructions per frame (x86-64)";
const QUERY: &str = "instructions per query (x86-64)";

const HEAD: &str = "# Run time against error

Written by `benches/precision/run.sh` from `results.csv`, which has all classes. `src/main.rs`
explains the questions, the backends and the judges. [plots](plots) has pictures of each workload:
wrong answers against instructions, and the largest error in those that end in `-error`.

- **Wrong in a million**: yes or no, compared with exact integers. Touching counts as overlapping or
  not, whichever suits the backend over a class, and a ray is right by one of the two. Walks over
  half-open cells are neither `on lines`, those of exact integers included: that is no rounding.
- **Instructions**: callgrind. One call in a loop (about 6), with operands in memory and the whole
  answer stored. Wrongly predicted branches do not count: the times show them.
- **Times** are in `results.csv`, for TIMED rows that the host counted.
- **Error**: of depths; of times, as pixels of way. `late`: the share of hits after the true time.
- **Moves**: a frame is wrong if it ends in the solid, even by a little, or tunnels. Also shown:
  ends deeper than 1/64 px and 1 px. A sequence of 32 frames counts until the body is lost: a pixel
  deep, or through a wall. Engines keep a gap to the solid. rapier2d has one polygon per tile.
- **Pairs of boxes**: wrong if an overlap is not reported. A frame moves all boxes and reports all
  pairs. Motion is coherent. In `leap` classes, three in a hundred jump in each frame. `f64` bodies
  are judged at the nearest 2^-25 px, boxes at 2^-24 px: no smaller overlap shows.
- **Textbook boxes** among blocks look where they end, or at all `(columns)` and rows that they
  cross. Textbook circles move in steps.
- **Textbook contacts** have no case for circles without a radius: it is not rounding. These, and
  boxes without width, which Box2D's manual excludes, occur from `within 2 raw of touching` on.
- **Convex pairs**, on the host only: boxes and capsules point along Pythagorean triples, so corners
  are whole. Box2D, parry2d, and textbook contacts, distances and circles round a box's cosine and
  sine. Textbook directions and normals are made before the count, with their roots; tilesat's count
  has all. A third of those `8000 px from the origin` nearly touch. Distances count to a raw unit.
- `overlaps`, `would hit`: Box2D, Chipmunk2D and ncollide2d answer by a contact, Box2D convex pairs
  also by its distance, and two segments by a ray. Some of `parry2d (special)` are put together here
  from its functions. `contact`: depth and normal. `contact (lazy)`: neither yet.
- **Box2D, Chipmunk2D**: calls cross a language border without link-time optimisation, so none is
  inlined. `b2AABB_Overlaps` and `cpBBIntersects` have no row: they are inline in C headers, and no
  binding exports them. Textbook f32 and f64 compare the same numbers.

";
