//! Solids: shapes with an inside, and motions that they may make.

use super::convex_solid::{ConvexSolid, SolidShape};
use super::solid::{Side, Solid};
use crate::error::RangeError;
use crate::num::Vec2;
use crate::shape::Aabb;
use crate::stored::{StoredForm, Version, stored};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct Machine {
    version: Version,
    shape: Aabb,
    motion: Vec2,
    conveyor: Vec2,
    key: u16,
    flags: u8,
    one_way: Option<Side>,
}

impl StoredForm<Solid> for Machine {
    type Fault = RangeError;

    fn of(solid: &Solid) -> Self {
        Self {
            version: Version,
            shape: solid.shape(),
            motion: solid.motion(),
            conveyor: solid.conveyor(),
            key: solid.key(),
            flags: solid.flags(),
            one_way: solid.one_way(),
        }
    }

    fn check(self) -> Result<Solid, RangeError> {
        let solid = Solid::new(self.shape, self.key)?.with_flags(self.flags);
        let solid = solid.with_conveyor(self.conveyor)?.with_motion(self.motion)?;
        Ok(match self.one_way {
            Some(side) => solid.with_one_way(side),
            None => solid,
        })
    }
}

stored!(Solid as Machine);

#[derive(Serialize, Deserialize)]
struct ConvexMachine<S> {
    version: Version,
    shape: S,
    change: NextShape<S>,
    key: u16,
    flags: u8,
}

/// How it changes to its next shape.
#[derive(Serialize, Deserialize)]
enum NextShape<S> {
    Moves(Vec2),
    Turns(S),
}

impl<S: SolidShape> StoredForm<ConvexSolid<S>> for ConvexMachine<S> {
    type Fault = RangeError;

    fn of(solid: &ConvexSolid<S>) -> Self {
        let change = solid.motion().map_or_else(|| NextShape::Turns(solid.next()), NextShape::Moves);
        Self { version: Version, shape: solid.shape(), change, key: solid.key(), flags: solid.flags() }
    }

    fn check(self) -> Result<ConvexSolid<S>, RangeError> {
        let solid = ConvexSolid::new(self.shape, self.key)?.with_flags(self.flags);
        match self.change {
            NextShape::Moves(motion) => solid.with_motion(motion),
            NextShape::Turns(next) => solid.with_turn(next),
        }
    }
}

stored!([S: SolidShape] ConvexSolid<S> as ConvexMachine<S>; S);
