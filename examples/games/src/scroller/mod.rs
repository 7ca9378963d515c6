//! A runner in a world of 40 000 pixels, five times the range of coordinates. The world is cut into
//! rooms, and the borders do not affect the runner.

mod runner;
pub mod world;

pub use runner::{Outcome, Runner};

use tilesat::{AllShapes, MoveError, Rooms};

/// Ten minutes, which are enough.
const FRAMES: u32 = 36_000;

/// Runs through a world from end to end.
pub fn run(world: &Rooms<'_, AllShapes>) -> Result<Outcome, MoveError> {
    let Some(mut runner) = Runner::new(world)? else { return Ok(Outcome::default()) };
    while !runner.has_arrived() && runner.outcome.frames < FRAMES {
        runner.step(world)?;
    }
    Ok(runner.outcome)
}
