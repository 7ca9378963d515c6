//! The interface of every column of the tables.

/// Position and velocity of a body, in pixels and pixels per frame. Exact for all number formats
/// here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub centre: [f64; 2],
    pub velocity: [f64; 2],
}

impl State {
    /// The engine has given up the body.
    pub const LOST: Self = Self { centre: [f64::NAN; 2], velocity: [f64::NAN; 2] };
}

/// One body in one scene.
pub trait Engine {
    /// Gravity, motion, response: one frame.
    fn frame(&mut self);

    /// The body's position.
    fn state(&self) -> State;

    /// Whether position and velocity are its whole state. Then after a frame that changes neither,
    /// no later frame does, and the run can end.
    fn forgets(&self) -> bool {
        true
    }

    /// Moves the body sideways by whole raw units.
    fn shift(&mut self, by: i32);
}
