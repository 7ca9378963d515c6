//! The saved values of responses: surfaces, sticks, masses, gravity in parts.

use super::acceleration::{Acceleration, Carry};
use super::impact::Masses;
use super::surface::{Speed, Surface};
use super::verlet::Stick;
use crate::error::RangeError;
use crate::num::{Fx, Ratio, Vec2};
use crate::stored::{StoredForm, stored};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct Material {
    restitution: Ratio,
    friction: Ratio,
    speed: Option<Speed>,
    rest: u32,
}

impl StoredForm<Surface> for Material {
    type Fault = &'static str;

    fn of(surface: &Surface) -> Self {
        let Surface { restitution, friction, speed, rest } = *surface;
        Self { restitution, friction, speed, rest }
    }

    fn check(self) -> Result<Surface, Self::Fault> {
        let Self { restitution, friction, speed, rest } = self;
        if i32::try_from(rest).is_err() {
            return Err("the speed at which bodies rest is above 2^31 - 1 raw");
        }
        Ok(Surface { restitution, friction, speed, rest })
    }
}

#[derive(Serialize, Deserialize)]
struct Rod {
    length: Fx,
    share_of_a: Ratio,
    slack: bool,
}

impl StoredForm<Stick> for Rod {
    type Fault = RangeError;

    fn of(stick: &Stick) -> Self {
        let Stick { length, share_of_a, slack } = *stick;
        Self { length, share_of_a, slack }
    }

    fn check(self) -> Result<Stick, RangeError> {
        let stick = if self.slack { Stick::rope(self.length) } else { Stick::new(self.length) }?;
        Ok(stick.with_share_of_a(self.share_of_a))
    }
}

/// The change of each of the two velocities, in lowest terms.
#[derive(Serialize, Deserialize)]
struct Terms {
    a: u8,
    b: u8,
}

impl StoredForm<Masses> for Terms {
    type Fault = &'static str;

    fn of(masses: &Masses) -> Self {
        let Masses { a, b } = *masses;
        Self { a, b }
    }

    fn check(self) -> Result<Masses, Self::Fault> {
        let masses = match self {
            Self { a: 0, b: 1 } => Some(Masses::A_FIXED),
            Self { a: 1, b: 0 } => Some(Masses::B_FIXED),
            Self { a, b } => Masses::new(b, a),
        };
        masses.filter(|&Masses { a, b }| (a, b) == (self.a, self.b)).ok_or("the masses are not in lowest terms")
    }
}

/// The change in every `frames` frames.
#[derive(Serialize, Deserialize)]
struct Change {
    by: Vec2,
    frames: u32,
}

impl StoredForm<Acceleration> for Change {
    type Fault = &'static str;

    fn of(acceleration: &Acceleration) -> Self {
        let Acceleration { whole, part, frames } = *acceleration;
        // It was a number of the domain before it was divided.
        let all = |whole: i32, part: i32| whole.wrapping_mul(frames).wrapping_add(part);
        Self { by: Vec2::from_raw(all(whole.0, part.0), all(whole.1, part.1)), frames: frames.unsigned_abs() }
    }

    fn check(self) -> Result<Acceleration, Self::Fault> {
        Acceleration::new(self.by, self.frames).ok_or("it has no frames, too many, or leads out of the domain")
    }
}

#[derive(Serialize, Deserialize)]
struct CarryParts {
    x: i32,
    y: i32,
}

impl StoredForm<Carry> for CarryParts {
    type Fault = &'static str;

    fn of(carry: &Carry) -> Self {
        let Carry { x, y } = *carry;
        Self { x, y }
    }

    fn check(self) -> Result<Carry, Self::Fault> {
        let Self { x, y } = self;
        let most = 1 << 30;
        if x.unsigned_abs() > most || y.unsigned_abs() > most {
            return Err("it is more than 2^30 parts, the most that a raw unit can have");
        }
        Ok(Carry { x, y })
    }
}

stored!(Surface as Material);
stored!(Stick as Rod);
stored!(Masses as Terms);
stored!(Acceleration as Change);
stored!(Carry as CarryParts);
