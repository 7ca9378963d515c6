//! Tables, as Markdown.

use crate::record::Row;
use crate::show::workloads;
use std::cmp::Ordering::Equal;
use std::fmt::Write;

/// Three digits are enough to read.
pub fn short(v: f64) -> String {
    match v.abs() {
        0.0 => "0".into(),
        a if a >= 99.95 => format!("{v:.0}"),
        a if a >= 9.995 => format!("{v:.1}"),
        a if a >= 0.01 => format!("{v:.2}"),
        _ => format!("{v:.1e}"),
    }
}

fn classes<'a>(rows: &[&'a Row]) -> Vec<&'a str> {
    let mut names: Vec<&str> = Vec::new();
    for row in rows {
        if !names.contains(&row.class()) && row.get("host").is_some() {
            names.push(row.class());
        }
    }
    names
}

/// A table of one figure: a row a backend and question, a column a class.
fn table(title: &str, rows: &[&Row], cell: impl Fn(&Row) -> Option<String>) -> String {
    let classes = classes(rows);
    let mut out = format!("\n**{title}**\n\n| |");
    for class in &classes {
        let _ = write!(out, " {class} |");
    }
    let _ = writeln!(out, "\n|---|{}", "--:|".repeat(classes.len()));
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for row in rows {
        let key = (row.backend(), row.asked());
        if seen.contains(&key) {
            continue;
        }
        seen.push(key);
        let of = |class: &&str| rows.iter().find(|r| (r.backend(), r.asked()) == key && r.class() == *class);
        let cells: Vec<Option<String>> = classes.iter().map(|c| of(c).and_then(|r| cell(r))).collect();
        if cells.iter().all(Option::is_none) {
            continue;
        }
        let _ = write!(out, "| {}: {} |", key.0, key.1);
        for cell in cells {
            let _ = write!(out, " {} |", cell.unwrap_or_default());
        }
        out.push('\n');
    }
    out
}

/// All of a workload.
pub fn workload(rows: &[&Row]) -> String {
    let mut out = table("Wrong in a million", rows, |r| {
        let mark = if r.is_closed() { " c" } else { "" };
        Some(format!("{}{mark}", short(r.wrong_per_million()?)))
    });
    out += &table("Instructions / ns", rows, |r| {
        let ns = r.get("ns").map(short).unwrap_or_default();
        Some(format!("{} / {ns}", short(r.get("host")?)))
    });
    if rows.iter().any(|r| r.get("max_px").is_some()) {
        out += &table("Error in px: largest / mean", rows, |r| {
            Some(format!("{} / {}", short(r.get("max_px")?), short(r.get("mean_px")?)))
        });
        out += &table("Error in units of the last place of the answer: largest / mean", rows, |r| {
            Some(format!("{} / {}", short(r.get("max_ulp")?), short(r.get("mean_ulp")?)))
        });
    }
    if rows.iter().any(|r| r.get("tunnels").is_some()) {
        out +=
            &table("Ends in the solid / of them by over 1/64 px / tunnels / stuck, in a million frames", rows, |r| {
                let share = |name| Some(short(r.get(name)? * 1e6 / r.get("queries")?));
                Some([share("wrong")?, share("deep")?, share("tunnels")?, share("stuck")?].join(" / "))
            });
        out += &table("Deepest px / raw units", rows, |r| {
            let px = r.get("deepest_px")?;
            Some(format!("{} / {}", short(px), short(px * 65536.0)))
        });
    }
    if rows.iter().any(|r| r.get("extra").is_some()) {
        out += &table("Pairs told that do not touch, in a million pairs", rows, |r| {
            Some(short(r.get("extra")? * 1e6 / r.get("queries").filter(|n| *n > 0.0)?))
        });
    }
    if rows.iter().any(|r| r.get("late").is_some()) {
        out += &table("Late in a hundred hits / deepest px", rows, |r| {
            let share = r.get("late")? * 100.0 / r.get("hits").filter(|n| *n > 0.0)?;
            Some(format!("{} / {}", short(share), r.get("deepest_px").map(short).unwrap_or_default()))
        });
    }
    if is_framed(rows) && rows.iter().any(|r| r.get("m0").is_some()) {
        out += &table("Instructions on Cortex-M0 / on Cortex-M4F", rows, |r| {
            let count = |core| r.get(core).map_or_else(|| "-".to_owned(), short);
            r.get("m4f").map(|_| format!("{} / {}", count("m0"), count("m4f")))
        });
    }
    out
}

/// Whether what is asked is a frame, not one query.
pub fn is_framed(rows: &[&Row]) -> bool {
    rows.iter().any(|r| r.get("tunnels").or(r.get("extra")).is_some())
}

/// Other people's libraries, unlike textbook code.
pub fn is_library(backend: &str) -> bool {
    ["parry2d", "ncollide2d", "Box2D", "Chipmunk2D", "rapier2d", "broccoli"].iter().any(|l| backend.starts_with(l))
}

/// What ours says first: the cheapest answer of a workload.
pub fn first_asked(workload: &str) -> &'static str {
    if workload.starts_with("rays") {
        "ray"
    } else if workload.starts_with("cast") {
        "cast"
    } else if workload.starts_with("move") {
        "move"
    } else {
        "overlaps"
    }
}

/// Whether it tells pairs of many boxes: ours are several, and a game takes the one that suits its number of bodies.
pub fn is_broad(workload: &str) -> bool {
    workload.starts_with("pairs of boxes")
}

/// The least cost of those rows that are asked for.
pub fn cheapest<'a>(rows: impl Iterator<Item = &'a Row>, column: &str) -> Option<&'a Row> {
    rows.filter(|r| r.get(column).is_some()).min_by(|a, b| a.get(column).partial_cmp(&b.get(column)).unwrap_or(Equal))
}

/// The class of a workload by which costs are told.
pub fn usual_class(workload: &str) -> &'static str {
    if workload.starts_with("rays") {
        "generic"
    } else if workload.starts_with("move") {
        "circle up to 4 px"
    } else if is_broad(workload) {
        "256 boxes"
    } else {
        "uniform 50 % hits"
    }
}

/// The most wrong answers in a million, of all classes.
fn worst(rows: &[Row], workload: &str, backend: &str, asked: &str) -> Option<f64> {
    let of = |r: &&Row| (r.workload(), r.backend(), r.asked()) == (workload, backend, asked) && r.class() != "soak";
    rows.iter().filter(of).filter_map(Row::wrong_per_million).reduce(f64::max)
}

/// The short table.
pub fn readme(rows: &[Row]) -> String {
    let mut out = String::from(
        "<!-- precision:begin -->\n| yes or no, rays, casts, moves, pairs of boxes | tilesat | textbook f32 | naive Q16.16 | fastest library | Cortex-M0: tilesat, f32, parry2d |\n\
         |---|--:|--:|--:|--:|--:|\n",
    );
    for workload in workloads(rows) {
        line(&mut out, rows, workload, usual_class(workload));
        if is_broad(workload) {
            line(&mut out, rows, workload, "4096 boxes");
        }
    }
    out += "\nInstructions on x86-64 and on a Cortex-M0, half of the pairs hit; wrong in a million in the worst class of inputs, by the convention that suits each best.\n\
            Of moves, instructions a frame of a circle that goes up to 4 px, and frames that end in the solid, however little, or beyond it. Of pairs of boxes, instructions\n\
            a frame in which all of them move, and pairs that are missing.\n<!-- precision:end -->\n";
    out
}

fn line(out: &mut String, rows: &[Row], workload: &str, class: &str) {
    let at = |r: &&Row| r.workload() == workload && r.class() == class;
    let broad = is_broad(workload);
    let asked = |r: &&Row| broad || r.asked() == first_asked(workload);
    let said = |row: &Row| {
        let wrong = worst(rows, workload, row.backend(), row.asked())?;
        Some(format!("{}; {} wrong", short(row.get("host")?), short(wrong)))
    };
    let cell = |backend: &str| {
        let of = rows.iter().filter(at).filter(asked).filter(|r| r.backend() == backend);
        said(cheapest(of, "host")?)
    };
    let Some(ours) = cell("tilesat") else { return };
    let peer = cheapest(rows.iter().filter(at).filter(|r| is_library(r.backend())), "host");
    let peer = peer.and_then(|r| Some(format!("{}, {}", said(r)?, r.backend())));
    // The fastest of a library's functions that say the same.
    let m0 = |of: &dyn Fn(&str) -> bool| {
        let of = rows.iter().filter(at).filter(asked).filter(|r| of(r.backend()));
        of.filter_map(|r| r.get("m0")).reduce(f64::min).map(short)
    };
    let cores = [m0(&|b| b == "tilesat"), m0(&|b| b == "textbook f32"), m0(&|b| b.starts_with("parry2d"))];
    let cores = if cores.iter().all(Option::is_none) {
        String::new()
    } else {
        cores.map(|count| count.unwrap_or_else(|| "-".to_owned())).join(", ")
    };
    let name = if broad { format!("{workload}: {class}") } else { workload.to_owned() };
    let _ = writeln!(
        out,
        "| {name} | {ours} | {} | {} | {} | {} |",
        cell("textbook f32").unwrap_or_default(),
        cell("naive Q16.16").unwrap_or_default(),
        peer.unwrap_or_default(),
        cores
    );
}
