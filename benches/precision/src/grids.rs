//! Our broad phases beside the trees of libraries.

use crate::broad;
use crate::question::is_shown;
use crate::record::Row;
use std::fmt::Write;

const OURS: [&str; 4] = ["sweep", "grid", "hash", "brute"];
/// In the format in which each is fastest. No textbook has a search of regions.
const BOOK: [(&str, &str); 2] = [("textbook f32", "sweep"), ("textbook f64", "sweep")];
const TREES: [&str; 5] = ["parry2d", "Box2D", "broccoli", "rstar", "quadtree_rs"];

/// Instructions of a backend's answer in a class.
fn host(rows: &[Row], (workload, class): (&str, &str), (backend, asked): (&str, &str)) -> Option<f64> {
    let is = |r: &&Row| (r.workload(), r.class()) == (workload, class) && (r.backend(), r.asked()) == (backend, asked);
    rows.iter().find(is)?.get("host")
}

/// A section of the page: one table per workload of boxes.
pub fn page(rows: &[Row]) -> String {
    let mut out = String::from(HEAD);
    for workload in [broad::NAME, broad::regions::NAME] {
        let book = if workload == broad::NAME { &BOOK[..] } else { &[] };
        let names = OURS.iter().copied().chain(book.iter().map(|b| b.0)).chain(TREES).collect::<Vec<_>>().join(" | ");
        let lines = "--:|".repeat(10 + book.len());
        let _ = writeln!(out, "\n| {workload} | {names} | best tree / best of ours |\n|---|{lines}");
        let mut classes: Vec<&str> = Vec::new();
        for row in rows.iter().filter(|r| r.workload() == workload && is_shown(r.class())) {
            if !classes.contains(&row.class()) {
                classes.push(row.class());
            }
        }
        for class in classes {
            let of = |who| host(rows, (workload, class), who);
            let ours = OURS.map(|asked| of(("tilesat", asked)));
            let trees = TREES.map(|library| of((library, "tree")));
            let least = |all: &[Option<f64>]| all.iter().flatten().copied().reduce(f64::min);
            let ratio = least(&trees).zip(least(&ours)).map(|(tree, own)| format!("{:.2}", tree / own));
            let book = book.iter().map(|&who| of(who));
            let cells = ours.into_iter().chain(book).chain(trees);
            let cells = cells.map(|n| n.map_or(String::new(), |n| format!("{n:.0}")));
            let cells = cells.chain(ratio).collect::<Vec<_>>().join(" | ");
            let _ = writeln!(out, "| {class} | {cells} |");
        }
    }
    out
}

const HEAD: &str = "
## Grids and trees

Instructions per frame. In the first table all boxes move, and the broad phase reports all pairs. In
the second, the boxes of the first frame stay, and those of each frame are regions to search.
`clumps`: 32 boxes in 128 x 128 px, and nothing between. `a huge one`: half as wide as the scene.
`uneven`: sides from 4 to 512 px, half as many of twice the side, and one in sixteen moves. The
textbook's code is a sort and sweep too. In f32 it misses pairs `in columns`, up to 995 502 in a
million. Cells of the grid and the hash are 32 px, and 128 px in `uneven`. That is their best size
there, except for regions among 256 boxes. Larger boxes go into a separate list. To pack rstar and
to fill quadtree_rs in each frame is faster than to move each box. A smallest square of the quadtree
is 32 px. With 64 px it takes 0.8 times as long for scattered pairs, 1.3 times for clumps, and
longer for all regions. With 16 px it takes longer for pairs.
";
