//! The promises of this library for these scenes, checked on its own columns.

use crate::cases::{Case, Kind};
use crate::runs::Cell;
use crate::watch::Watched;

/// More than the judge's own error, and far less than a raw unit (1.5e-5).
const TOUCH: f64 = 1e-7;

/// The missed goals, one line per run.
pub fn missed(case: &Case, column: &str, cell: &Cell) -> Vec<String> {
    let mut lines = Vec::new();
    for (start, run) in cell.iter().enumerate() {
        for (what, ok) in goals(case, column, run) {
            if !ok {
                lines.push(format!(
                    "{column}: {} ({:?}), start {start}: {what} (escaped {:?}, deepest {:e}, kept {}, square {})",
                    case.scene.name,
                    case.kind,
                    run.escaped,
                    run.deepest,
                    run.kept(),
                    run.peak_square
                ));
            }
        }
    }
    lines
}

fn goals(case: &Case, column: &str, run: &Watched) -> Vec<(&'static str, bool)> {
    let mut goals = vec![("never lost", run.escaped.is_none()), ("never inside", run.deepest < TOUCH)];
    match case.kind {
        Kind::Floor => {
            let [vx, vy] = case.starts[0].velocity.map(|c| f64::from(c) / 65536.0);
            goals.push(("no ghosts", run.turns == 0 && run.velocity == [vx, vy] && run.highest < TOUCH));
        }
        Kind::Valley => goals.push(("comes to rest and stays", run.late_step == 0.0 && run.velocity == [0.0, 0.0])),
        Kind::Bounces | Kind::LongRun(_) => {}
    }
    if case.scene.gravity == 0 {
        goals.push(("never faster", run.peak_square <= 1.0));
        if case.scene.bounce == 256 {
            goals.push(("keeps 0.9 of its energy", run.kept() >= 0.9));
        }
    }
    if column.contains("renewed") {
        // Integers are exact; the ratio here is not.
        goals.push(("never more energy, and nearly all of it", run.peak_energy < 1.0 + 1e-12 && run.kept() >= 0.999));
    }
    goals
}
