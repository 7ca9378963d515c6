//! Tables, as Markdown.

use crate::record::Row;
use crate::show::workloads;
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
    if rows.iter().any(|r| r.get("late").is_some()) {
        out += &table("Late in a hundred hits / deepest px", rows, |r| {
            let share = r.get("late")? * 100.0 / r.get("hits").filter(|n| *n > 0.0)?;
            Some(format!("{} / {}", short(share), r.get("deepest_px").map(short).unwrap_or_default()))
        });
    }
    out
}

/// Microcontrollers: half of the inputs hit.
pub fn micro(rows: &[Row]) -> String {
    let half: Vec<&Row> = rows.iter().filter(|r| r.class() == "uniform 50 % hits" && r.get("m0").is_some()).collect();
    if half.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "\n## Microcontrollers\n\nInstructions of hits / of misses, half of the pairs hit; bytes of flash at opt-level \"s\" of the query with all that it \
         pulls in. Other classes are in `results.csv`.\n\n| | Cortex-M0 | Cortex-M4F | flash M0 | flash M4F |\n|---|--:|--:|--:|--:|\n",
    );
    for row in half {
        let cell = |name: &str| row.get(name).map(short).unwrap_or_default();
        let same = |r: &&Row| {
            r.class().is_empty()
                && (r.workload(), r.backend(), r.asked()) == (row.workload(), row.backend(), row.asked())
        };
        let flash = |name: &str| rows.iter().find(same).and_then(|r| r.get(name)).map(short).unwrap_or_default();
        let _ = writeln!(
            out,
            "| {}, {}: {} | {} / {} | {} / {} | {} | {} |",
            row.workload(),
            row.backend(),
            row.asked(),
            cell("m0_hit"),
            cell("m0_miss"),
            cell("m4f_hit"),
            cell("m4f_miss"),
            flash("flash_m0"),
            flash("flash_m4f")
        );
    }
    out
}

/// Other people's libraries, unlike textbook code.
pub fn is_library(backend: &str) -> bool {
    ["parry2d", "ncollide2d", "Box2D", "Chipmunk2D"].iter().any(|l| backend.starts_with(l))
}

/// What ours says first: the cheapest answer of a workload.
pub fn first_asked(workload: &str) -> &'static str {
    if workload.starts_with("rays") {
        "ray"
    } else if workload.starts_with("cast") {
        "cast"
    } else {
        "overlaps"
    }
}

/// The class of a workload by which costs are told.
pub fn usual_class(workload: &str) -> &'static str {
    if workload.starts_with("rays") { "generic" } else { "uniform 50 % hits" }
}

/// The most wrong answers in a million, of all classes.
fn worst(rows: &[Row], workload: &str, backend: &str, asked: &str) -> Option<f64> {
    let of = |r: &&Row| (r.workload(), r.backend(), r.asked()) == (workload, backend, asked) && r.class() != "soak";
    rows.iter().filter(of).filter_map(Row::wrong_per_million).reduce(f64::max)
}

/// The short table.
pub fn readme(rows: &[Row]) -> String {
    let mut out = String::from(
        "<!-- precision:begin -->\n| yes or no, rays, casts | tilesat | textbook f32 | naive Q16.16 | fastest library | Cortex-M0: tilesat, f32, parry2d |\n\
         |---|--:|--:|--:|--:|--:|\n",
    );
    for workload in workloads(rows) {
        let (asked, class) = (first_asked(workload), usual_class(workload));
        let at = |r: &&Row| r.workload() == workload && r.class() == class;
        let cell = |backend: &str, asked: &str| {
            let row = rows.iter().filter(at).find(|r| r.backend() == backend && r.asked() == asked)?;
            let wrong = worst(rows, workload, backend, asked)?;
            Some(format!("{}; {} wrong", short(row.get("host")?), short(wrong)))
        };
        let Some(ours) = cell("tilesat", asked) else { continue };
        let peer = rows.iter().filter(at).filter(|r| is_library(r.backend()) && r.get("host").is_some());
        let fastest =
            peer.min_by(|a, b| a.get("host").partial_cmp(&b.get("host")).unwrap_or(std::cmp::Ordering::Equal));
        let peer = fastest.and_then(|r| Some(format!("{}, {}", cell(r.backend(), r.asked())?, r.backend())));
        // The fastest of a library's functions that say yes or no.
        let m0 = |of: &dyn Fn(&str) -> bool| {
            let of = rows.iter().filter(at).filter(|r| r.asked() == asked && of(r.backend()));
            of.filter_map(|r| r.get("m0")).reduce(f64::min).map(short)
        };
        let cores = [m0(&|b| b == "tilesat"), m0(&|b| b == "textbook f32"), m0(&|b| b.starts_with("parry2d"))];
        let cores: Vec<String> = cores.into_iter().flatten().collect();
        let _ = writeln!(
            out,
            "| {workload} | {ours} | {} | {} | {} | {} |",
            cell("textbook f32", asked).unwrap_or_default(),
            cell("naive Q16.16", asked).unwrap_or_default(),
            peer.unwrap_or_default(),
            cores.join(", ")
        );
    }
    out += "\nInstructions on x86-64 and on a Cortex-M0, half of the pairs hit; wrong in a million in the worst class of inputs, by the convention that suits each best.\n<!-- precision:end -->\n";
    out
}
