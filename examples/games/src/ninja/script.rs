//! The player's keys: a list of stretches. Each ends at a condition.

use tilesat::Vec2;

use super::runner::{Keys, Ninja, State};

enum Jump {
    No,
    Floors,
    /// Once it no longer rises.
    Walls,
}

enum Until {
    RightOf(i16),
    LeftOf(i16),
    Above(i16),
    Below(i16),
    Stands,
}

/// Follows the motion, from wall to wall.
const ON: i32 = 2;

/// The direction to run in, when to jump, and where the next stretch begins (in pixels).
type Stretch = (i32, Jump, Until);

const SCRIPT: [Stretch; 13] = [
    (1, Jump::No, Until::RightOf(375)),
    (1, Jump::Floors, Until::RightOf(480)),
    (1, Jump::No, Until::RightOf(672)),
    (1, Jump::No, Until::Above(320)),
    (ON, Jump::Walls, Until::Above(100)),
    (-1, Jump::No, Until::LeftOf(440)),
    (-1, Jump::Floors, Until::LeftOf(390)),
    (-1, Jump::No, Until::LeftOf(30)),
    (-1, Jump::No, Until::Below(320)),
    (1, Jump::No, Until::RightOf(110)),
    (1, Jump::Floors, Until::RightOf(300)),
    (-1, Jump::No, Until::LeftOf(262)),
    (0, Jump::No, Until::Stands),
];

#[derive(Clone, Copy, Debug)]
pub struct Script {
    at: usize,
    /// Frames for which the jump key stays down.
    held: u32,
    heading: i32,
}

impl Script {
    pub fn new() -> Self {
        Self { at: 0, held: 0, heading: 1 }
    }

    pub fn is_done(&self) -> bool {
        self.at >= SCRIPT.len()
    }

    /// The keys of this frame. None after the last stretch.
    pub fn keys(&mut self, ninja: &Ninja) -> Option<Keys> {
        let (run, jump, until) = SCRIPT.get(self.at)?;
        if arrived(ninja, until) {
            self.at += 1;
        }
        let speed = ninja.velocity.x.signum().to_num::<i32>();
        if speed != 0 {
            self.heading = speed;
        }
        let run = if *run == ON { self.heading } else { *run };
        let rises = ninja.velocity.y < -1;
        let jump = match jump {
            Jump::No => false,
            Jump::Floors => ninja.state == State::Floor,
            Jump::Walls => ninja.state == State::Wall && !rises,
        };
        self.held = if jump && self.held == 0 { 24 } else { self.held.saturating_sub(1) };
        Some(Keys { run, jump: self.held > 0 })
    }
}

fn arrived(ninja: &Ninja, until: &Until) -> bool {
    let Vec2 { x, y } = ninja.body.centre();
    match *until {
        Until::RightOf(at) => x > at,
        Until::LeftOf(at) => x < at,
        Until::Above(at) => y < at,
        Until::Below(at) => y > at,
        Until::Stands => ninja.state == State::Floor,
    }
}
