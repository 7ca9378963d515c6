//! Why a scene refuses a call, or holds a body.

use crate::broad::{BroadError, Handle};
use crate::error::RangeError;
use crate::motion::MoveError;
use core::fmt;

/// The reason of a refusal, and the body that it concerns. That body, or the scene, is unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SceneError {
    /// The body. `None` if the fault is in the call, such as a body that is not yet inserted, or a
    /// gravity.
    pub body: Option<Handle>,
    /// The fault.
    pub fault: SceneFault,
}

/// The reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SceneFault {
    /// The broad phase does not know the body, or has no room or cell for it.
    Broad(BroadError),
    /// The body already overlaps the level, would leave the domain, or is too fast or too large.
    Move(MoveError),
}

impl SceneError {
    pub(super) fn of(body: Handle, fault: impl Into<SceneFault>) -> Self {
        Self { body: Some(body), fault: fault.into() }
    }

    pub(super) fn call(fault: impl Into<SceneFault>) -> Self {
        Self { body: None, fault: fault.into() }
    }
}

impl From<BroadError> for SceneFault {
    fn from(e: BroadError) -> Self {
        Self::Broad(e)
    }
}

impl From<MoveError> for SceneFault {
    fn from(e: MoveError) -> Self {
        Self::Move(e)
    }
}

impl From<RangeError> for SceneFault {
    fn from(e: RangeError) -> Self {
        Self::Move(e.into())
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A stale handle's own text names the body.
        if let (Some(body), false) = (self.body, matches!(self.fault, SceneFault::Broad(BroadError::Stale(_)))) {
            write!(f, "body {} (generation {}): ", body.slot(), body.generation())?;
        }
        self.fault.fmt(f)
    }
}

impl fmt::Display for SceneFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Broad(e) => e.fmt(f),
            Self::Move(e) => e.fmt(f),
        }
    }
}

impl core::error::Error for SceneError {}

impl core::error::Error for SceneFault {}
