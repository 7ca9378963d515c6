//! Chooses the next batches. Each thread takes one at a time.

use crate::convex::{self, PAIRS};
use crate::frames::{self, WORLDS};
use crate::options::Options;
use crate::queries::{self, ROWS};
use crate::state::{State, name};
use crate::tmx;
use std::path::{Path, PathBuf};
use std::thread;

/// The share of a thread. It is small, so that the threads do not wait long for the end of a round.
const BATCHES: u64 = 4;

/// A batch. Equal numbers give equal batches.
#[derive(Clone, Copy, Debug)]
pub enum Job {
    Queries(usize, u64),
    Pairs(usize, u64),
    Frames(usize, u64),
    Level(u64),
}

#[derive(Clone, Copy, Debug)]
enum Done {
    Queries(usize, queries::Tally),
    Pairs(usize, queries::Tally),
    Frames(usize, frames::Tally),
    Level(frames::Tally),
}

pub struct Plan {
    query_rows: Vec<usize>,
    pair_rows: Vec<usize>,
    world_rows: Vec<usize>,
    levels: bool,
    scratch: PathBuf,
}

impl Plan {
    pub fn new(options: &Options, scratch: &Path) -> Self {
        let chosen = |name: &str| options.classes.is_empty() || options.classes.iter().any(|part| name.contains(part));
        Self {
            query_rows: (0..ROWS).filter(|&row| chosen(&name(row))).collect(),
            pair_rows: (0..convex::ROWS).filter(|&row| chosen(&convex::name(row))).collect(),
            world_rows: (0..WORLDS.len()).filter(|&row| chosen(WORLDS[row].0)).collect(),
            levels: chosen("tmx"),
            scratch: scratch.to_owned(),
        }
    }

    /// The batches of one round, some per thread, of the goal that is farthest behind. So all goals
    /// end together.
    pub fn round(&self, options: &Options, state: &mut State) -> Vec<Job> {
        let share = |done: u64, goal: u64| if done < goal { done as f64 / goal as f64 } else { f64::INFINITY };
        let none = |empty: bool, share: f64| if empty { f64::INFINITY } else { share };
        let shares = [
            none(self.query_rows.is_empty(), share(state.answers(), options.queries)),
            none(self.world_rows.is_empty(), share(state.all_frames(), options.frames)),
            none(!self.levels, share(state.next_level, options.levels)),
            none(self.pair_rows.is_empty(), share(state.all_pairs(), options.pairs * PAIRS as u64)),
        ];
        let least = shares.iter().copied().fold(f64::INFINITY, f64::min);
        if least == f64::INFINITY {
            return Vec::new();
        }
        (0..BATCHES * options.threads)
            .filter_map(|_| {
                Some(if shares[0] == least {
                    let row = *self.query_rows.iter().min_by_key(|&&row| state.next_queries[row])?;
                    state.next_queries[row] += 1;
                    Job::Queries(row, state.next_queries[row] - 1)
                } else if shares[1] == least {
                    let row = *self.world_rows.iter().min_by_key(|&&row| state.next_frames[row])?;
                    state.next_frames[row] += 1;
                    Job::Frames(row, state.next_frames[row] - 1)
                } else if shares[3] == least {
                    let row = *self.pair_rows.iter().min_by_key(|&&row| state.next_pairs[row])?;
                    state.next_pairs[row] += 1;
                    Job::Pairs(row, state.next_pairs[row] - 1)
                } else {
                    state.next_level += 1;
                    Job::Level(state.next_level - 1)
                })
            })
            .collect()
    }

    /// Runs a round and adds it up. Returns the job that found a fault; its thread has printed it.
    pub fn run(&self, options: &Options, state: &mut State, jobs: &[Job]) -> Result<(), Job> {
        let seed = options.seed;
        let each = jobs.len().div_ceil(options.threads as usize).max(1);
        let results: Vec<Result<Done, Job>> = thread::scope(|scope| {
            let threads: Vec<_> = jobs
                .chunks(each)
                .map(|chunk| {
                    scope.spawn(move || {
                        chunk
                            .iter()
                            .map(|&job| std::panic::catch_unwind(|| self.one(job, seed)).map_err(|_| job))
                            .collect::<Vec<_>>()
                    })
                })
                .collect();
            threads.into_iter().flat_map(|t| t.join().unwrap_or_default()).collect()
        });
        for done in results {
            match done? {
                Done::Queries(row, tally) => state.queries[row].add(&tally),
                Done::Pairs(row, tally) => state.pairs[row].add(&tally),
                Done::Frames(row, tally) => state.frames[row].add(&tally),
                Done::Level(tally) => state.levels.add(&tally),
            }
        }
        Ok(())
    }

    fn one(&self, job: Job, seed: u64) -> Done {
        match job {
            Job::Queries(row, number) => Done::Queries(row, queries::batch(row, seed, number)),
            Job::Pairs(row, number) => Done::Pairs(row, convex::batch(row, seed, number)),
            Job::Frames(row, number) => Done::Frames(row, frames::batch(row, seed, number)),
            Job::Level(number) => Done::Level(tmx::level(&self.scratch, seed, number)),
        }
    }
}
