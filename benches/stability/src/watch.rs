//! One run, watched frame by frame.

use crate::engine::Engine;
use crate::room::Room;

/// Samples of the energy per run.
pub const SAMPLES: usize = 128;

/// In these last frames a body that came to rest should not move.
const LATE: u64 = 1000;

#[derive(Clone, Debug)]
pub struct Watched {
    pub frames: u64,
    /// The frame in which it was lost.
    pub escaped: Option<u64>,
    /// Greatest depth in a wall before it was lost, in pixels.
    pub deepest: f64,
    /// Frames that changed the sideways speed.
    pub turns: u64,
    /// The greatest height above the lowest position, in pixels.
    pub highest: f64,
    /// The last frame that moved the centre.
    pub last_motion: u64,
    /// The longest step in the last frames, in raw units.
    pub late_step: f64,
    /// The velocity at the end, in pixels per frame.
    pub velocity: [f64; 2],
    /// Energy every so many frames, relative to the start. The last sample is at the end.
    pub energy: Vec<f64>,
    pub every: u64,
    /// The highest energy of all frames, relative to the start.
    pub peak_energy: f64,
    /// The greatest square of the speed, relative to the start. It is exactly at most 1 if the body
    /// was never faster, as f64 holds the squares.
    pub peak_square: f64,
}

/// Conditions for the end of a run.
#[derive(Clone, Copy, Debug)]
pub struct Until {
    pub frames: u64,
    /// After so many turns.
    pub turns: u64,
}

pub fn watch(engine: &mut dyn Engine, room: &Room, period: i32, until: Until) -> Watched {
    let mut before = engine.state();
    let start_energy = room.energy(&before);
    let square = |v: [f64; 2]| v[0] * v[0] + v[1] * v[1];
    let start_square = square(before.velocity);
    let every = (until.frames / SAMPLES as u64).max(1);
    let mut seen = Watched {
        frames: 0,
        escaped: None,
        deepest: room.depth(before.centre),
        turns: 0,
        highest: room.height(before.centre),
        last_motion: 0,
        late_step: 0.0,
        velocity: before.velocity,
        energy: vec![1.0],
        every,
        peak_energy: 1.0,
        peak_square: 1.0,
    };
    let limit = f64::from(period) / 65536.0;
    while seen.frames < until.frames && seen.turns < until.turns {
        engine.frame();
        seen.frames += 1;
        let now = engine.state();
        let depth = room.depth(now.centre);
        if room.is_lost(&now, depth) {
            seen.escaped = Some(seen.frames);
            break;
        }
        seen.deepest = seen.deepest.max(depth);
        seen.highest = seen.highest.max(room.height(now.centre));
        seen.turns += u64::from(now.velocity[0] != before.velocity[0]);
        if now.centre != before.centre {
            seen.last_motion = seen.frames;
            if seen.frames + LATE > until.frames {
                let step = (now.centre[0] - before.centre[0]).hypot(now.centre[1] - before.centre[1]);
                seen.late_step = seen.late_step.max(step * 65536.0);
            }
        }
        let energy = room.energy(&now) / start_energy;
        seen.peak_energy = seen.peak_energy.max(energy);
        seen.peak_square = seen.peak_square.max(square(now.velocity) / start_square);
        if seen.frames.is_multiple_of(every) {
            seen.energy.push(energy);
        }
        if now == before && engine.forgets() {
            seen.frames = until.frames;
            seen.energy.resize(SAMPLES, energy);
            break;
        }
        before = now;
        if period > 0 && now.centre[0].abs() >= limit {
            engine.shift(-period * now.centre[0].signum() as i32);
            before = engine.state();
        }
    }
    if seen.escaped.is_none() {
        seen.energy.push(room.energy(&before) / start_energy);
    }
    seen.velocity = before.velocity;
    seen
}

impl Watched {
    /// Speed at the end, in raw units per frame.
    pub fn residual(&self) -> f64 {
        self.velocity[0].hypot(self.velocity[1]) * 65536.0
    }

    /// Energy at the end, relative to the start.
    pub fn kept(&self) -> f64 {
        self.energy.last().copied().unwrap_or(1.0)
    }
}
