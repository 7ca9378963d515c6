//! The ninja of the example for ten thousand frames: its script, then keys of a generator, and
//! again.

use tilesat_games::ninja::{Keys, Ninja, Script, level};

use super::family::{Line, Run};
use super::hash::Hash;
use super::random::Random;

/// As of the other two games.
pub(crate) const FRAMES: [u32; 2] = [600, 10_000];
/// A script that has not ended by now has failed.
const PATIENCE: u32 = 1800;
/// After a script, the generator holds the keys for this long.
const WILD: u32 = 900;

/// Keys that stay down for a while.
fn wild(r: &mut Random, was: Keys) -> Keys {
    let run = if r.once_in(24) { r.small(1) } else { was.run };
    let jump = if r.once_in(12) { !was.jump } else { was.jump };
    Keys { run, jump }
}

pub(crate) fn run(run: &mut Run<'_>) {
    let (Ok(level), Ok(first)) = (level::map(), Ninja::new(level::START)) else { return };
    let (mut ninja, mut script, mut keys) = (first, Some(Script::new()), Keys::default());
    let (mut hash, mut random, mut since) = (Hash::new(), Random::new(1), 0);
    for frame in 1..=FRAMES[1] {
        let scripted = script.as_mut().and_then(|script| script.keys(&ninja)).filter(|_| since < PATIENCE);
        if script.is_some() && scripted.is_none() {
            (script, since) = (None, 0);
        }
        keys = scripted.unwrap_or_else(|| wild(&mut random, keys));
        let stepped = ninja.step(&level, keys);
        hash.add(stepped);
        hash.add([ninja.body.centre(), ninja.velocity]);
        hash.add([ninja.state as u32, ninja.jumps, ninja.wall_jumps]);
        since += 1;
        if script.is_none() && since == WILD {
            (ninja, script, since) = (first, Some(Script::new()), 0);
        }
        if FRAMES.contains(&frame) {
            run.line(&Line { query: "frames", of: "ninja", count: frame, hash });
        }
    }
}
