//! What every column of the tables is.

/// Where a body is and how fast, in pixels and pixels per frame: exact for all number formats here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub centre: [f64; 2],
    pub velocity: [f64; 2],
}

impl State {
    /// Of a body that the engine has given up.
    pub const LOST: Self = Self { centre: [f64::NAN; 2], velocity: [f64::NAN; 2] };
}

/// One body in one scene.
pub trait Engine {
    /// Gravity, motion, response: one frame.
    fn frame(&mut self);

    /// Where the body is.
    fn state(&self) -> State;

    /// Whether position and velocity are all that it remembers: a frame that changes neither is
    /// then followed by none that does, and the rest of the run need not be made.
    fn forgets(&self) -> bool {
        true
    }

    /// Moves the body sideways by whole raw units.
    fn shift(&mut self, by: i32);
}
