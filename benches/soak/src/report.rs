//! The progress lines, and the table at the end.

use crate::convex;
use crate::frames::WORLDS;
use crate::options::Options;
use crate::queries::{CLASSES, ROWS, pair_of};
use crate::state::{State, name};

pub fn names() {
    (0..ROWS).for_each(|row| println!("{}", name(row)));
    (0..convex::ROWS).for_each(|row| println!("{}", convex::name(row)));
    WORLDS.iter().for_each(|world| println!("{}", world.0));
    println!("tmx");
}

fn clock(seconds: f64) -> String {
    let s = seconds.round().min(9e9) as u64;
    format!("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
}

/// One line: progress towards each goal, the rates of this run, and the time left for the slowest
/// goal.
pub fn progress(options: &Options, before: &State, now: &State, seconds: f64) {
    let goals = [
        ("queries", before.answers(), now.answers(), options.queries),
        ("pairs", before.all_pairs(), now.all_pairs(), options.pairs * convex::PAIRS as u64),
        ("frames", before.all_frames(), now.all_frames(), options.frames),
        ("levels", before.next_level, now.next_level, options.levels),
    ];
    let mut left = 0.0f64;
    let mut line = clock(seconds);
    for (what, first, done, goal) in goals {
        let rate = (done - first) as f64 / seconds.max(1e-9);
        let share = if goal == 0 { 100.0 } else { done as f64 * 100.0 / goal as f64 };
        line += &format!("  {what} {done} ({share:.2} %, {rate:.0}/s)");
        if done < goal && rate > 0.0 {
            left = left.max((goal - done) as f64 / rate);
        }
    }
    let left = if options.minutes > 0 { left.min((60 * options.minutes) as f64 - seconds).max(0.0) } else { left };
    eprintln!("{line}  left {}", clock(left));
}

pub fn table(state: &State) {
    println!(
        "Seed {}, {} in all. 0 wrong answers, 0 overlaps, 0 tunnels, 0 gains of energy: any of these would have ended the run.\n",
        state.seed,
        clock(state.seconds)
    );
    println!(
        "| pair | answers | pairs | overlap | touch only | casts | hits | thorough |\n|---|---|---|---|---|---|---|---|"
    );
    let sum = |rows: &mut dyn Iterator<Item = usize>| {
        let mut all = crate::queries::Tally::default();
        rows.for_each(|row| all.add(&state.queries[row]));
        all.numbers().map(|n| n.to_string()).join(" | ")
    };
    for pair in (0..ROWS).step_by(CLASSES.len()) {
        let (a, b) = pair_of(pair);
        println!("| {a:?}-{b:?} | {} |", sum(&mut (pair..pair + CLASSES.len())));
    }
    println!("| all | {} |", sum(&mut (0..ROWS)));
    println!(
        "\n| class | answers | pairs | overlap | touch only | casts | hits | thorough |\n|---|---|---|---|---|---|---|---|"
    );
    for (k, class) in CLASSES.iter().enumerate() {
        println!("| {} | {} |", class.0, sum(&mut (k..ROWS).step_by(CLASSES.len())));
    }
    pairs(state);
    println!("\n| world | frames | hits | of circles | at rest | all iterations |\n|---|---|---|---|---|---|");
    let mut all = state.levels;
    for (world, tally) in WORLDS.iter().zip(&state.frames) {
        println!("| {} | {} |", world.0, tally.numbers().map(|n| n.to_string()).join(" | "));
        all.add(tally);
    }
    println!("| {} TMX levels | {} |", state.next_level, state.levels.numbers().map(|n| n.to_string()).join(" | "));
    println!("| all | {} |", all.numbers().map(|n| n.to_string()).join(" | "));
}

/// The pairs of all six shapes.
fn pairs(state: &State) {
    let classes = convex::CLASSES.len();
    let line = |name: &str, rows: &mut dyn Iterator<Item = usize>| {
        let mut all = crate::queries::Tally::default();
        rows.for_each(|row| all.add(&state.pairs[row]));
        let apart = all.pairs - all.overlaps - all.touches;
        let numbers = [all.pairs, all.overlaps, all.touches, apart, all.answers, all.thorough];
        println!("| {name} | {} |", numbers.map(|n| n.to_string()).join(" | "));
    };
    let head = |what| {
        println!(
            "\n| {what} | pairs | overlap | touch only | apart | answers | thorough |\n|---|---|---|---|---|---|---|"
        );
    };
    head("pair of the six shapes");
    for first in (0..convex::ROWS).step_by(classes) {
        let (a, b) = convex::pair_of(first);
        line(&format!("{a:?}-{b:?}"), &mut (first..first + classes));
    }
    line("all", &mut (0..convex::ROWS));
    head("class");
    for (k, class) in convex::CLASSES.iter().enumerate() {
        line(class.0, &mut (k..convex::ROWS).step_by(classes));
    }
}

#[cfg(test)]
mod tests {
    use super::clock;

    #[test]
    fn clocks() {
        assert_eq!((clock(59.6), clock(3_725.0)), ("0:01:00".into(), "1:02:05".into()));
    }
}
