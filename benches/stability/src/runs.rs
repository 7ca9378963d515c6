//! All runs, on a few threads.

use crate::cases::{Case, Kind};
use crate::engines::Column;
use crate::level::Levels;
use crate::room::Room;
use crate::watch::{Until, Watched, watch};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The results of a case's starts in a column. Empty if the column has no engine for it.
pub type Cell = Vec<Watched>;

/// Frames per required bounce, after which a run ends without the rest.
const PATIENCE: u64 = 60;

/// A row per case, a cell per column. The result does not depend on the thread that makes a run.
pub fn all(cases: &[Case], columns: &[Column], frames: u64, threads: usize) -> Vec<Vec<Cell>> {
    let levels: Vec<Levels> = cases.iter().map(|case| Levels::new(&case.scene)).collect();
    let jobs: Vec<(usize, usize, usize)> = (0..cases.len())
        .flat_map(|case| (0..columns.len()).map(move |column| (case, column)))
        .flat_map(|(case, column)| (0..cases[case].starts.len()).map(move |start| (case, column, start)))
        .collect();
    let seen: Vec<Mutex<Option<Watched>>> = jobs.iter().map(|_| Mutex::new(None)).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        while let Some((i, &(case, column, start))) = {
            let i = next.fetch_add(1, Ordering::Relaxed);
            jobs.get(i).map(|job| (i, job))
        } {
            if start == 0 {
                eprintln!("{:4} of {}  {}: {}", i + 1, jobs.len(), cases[case].scene.name, columns[column].name);
            }
            *seen[i].lock().expect("no thread fails") =
                run(&cases[case], &levels[case], &columns[column], start, frames);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
    let mut table: Vec<Vec<Cell>> = cases.iter().map(|_| vec![Vec::new(); columns.len()]).collect();
    for ((case, column, _), seen) in jobs.iter().zip(seen) {
        table[*case][*column].extend(seen.into_inner().expect("no thread fails"));
    }
    table
}

fn run(case: &Case, levels: &Levels, column: &Column, start: usize, frames: u64) -> Option<Watched> {
    let scene = &case.scene;
    let mut engine = (column.make)(scene, levels, &case.starts[start])?;
    let until = match case.kind {
        Kind::Bounces => Until { frames: frames * PATIENCE, turns: frames },
        _ => Until { frames, turns: u64::MAX },
    };
    Some(watch(&mut *engine, &Room::new(scene), scene.period, until))
}
