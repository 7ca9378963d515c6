//! Movers and walkers, the hero, and memos.

use super::character::Memory;
use super::feel::Feel;
use super::inside::StartInside;
use super::memo::Memo;
use super::mover::Mover;
use super::response::{Law, Response};
use super::slope_limit::SlopeLimit;
use super::walk::{SlopeSpeed, Support, Walker};
use super::{Body, Character};
use crate::error::RangeError;
use crate::num::{Axis, Fx, Vec2};
use crate::shape::Aabb;
use crate::stored::{StoredForm, Version, stored};
use core::convert::Infallible;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct MoverFields<S> {
    version: Version,
    up: Option<Axis>,
    response: Response,
    limit: SlopeLimit,
    drop_through: bool,
    inside: StartInside,
    surface: S,
}

impl<S: Law> StoredForm<Mover<S>> for MoverFields<S> {
    type Fault = &'static str;

    fn of(mover: &Mover<S>) -> Self {
        let Mover { up, response, limit, drop_through, inside, surface, .. } = *mover;
        Self { version: Version, up, response, limit, drop_through, inside, surface }
    }

    fn check(self) -> Result<Mover<S>, Self::Fault> {
        let Self { up, response, limit, drop_through, inside, surface, .. } = self;
        if up.is_some_and(Axis::is_zero) {
            return Err("its \"up\" is no direction: both components are zero");
        }
        if !up.is_none_or(Axis::has_opposite) {
            return Err("its \"up\" has no opposite: a component is i32::MIN");
        }
        let Mover { bounce, .. } = Mover::new().with_response(response).with_responses(surface.responses());
        Ok(Mover { up, response, bounce, limit, drop_through, inside, surface })
    }
}

stored!([S: Law] Mover<S> as MoverFields<S>; S);

#[derive(Serialize, Deserialize)]
struct Gait {
    mover: Mover,
    snap: Fx,
    step: Fx,
    speed: SlopeSpeed,
}

impl StoredForm<Walker> for Gait {
    type Fault = RangeError;

    fn of(walker: &Walker) -> Self {
        let Walker { mover, snap, step, speed } = *walker;
        Self { mover, snap: Fx::from_bits(snap), step: Fx::from_bits(step), speed }
    }

    fn check(self) -> Result<Walker, RangeError> {
        Walker::new(self.mover).with_slope_speed(self.speed).with_snap(self.snap)?.with_step(self.step)
    }
}

stored!(Walker as Gait);

#[derive(Serialize, Deserialize)]
struct Hero<B> {
    version: Version,
    velocity: Vec2,
    feel: Feel,
    body: B,
    limits: Aabb,
    floor: Option<Support>,
    memory: Memory,
}

/// The fields that a character and its form have in common, copied from one to the other.
macro_rules! fields {
    ($to:ident of $from:expr $(, version: $version:expr)?) => {
        $to {
            $(version: $version,)?
            velocity: $from.velocity,
            feel: $from.feel,
            body: $from.body,
            limits: $from.limits,
            floor: $from.floor,
            memory: $from.memory,
        }
    };
}

impl<B: Copy> StoredForm<Character<B>> for Hero<B> {
    type Fault = &'static str;

    fn of(hero: &Character<B>) -> Self {
        fields!(Self of hero, version: Version)
    }

    fn check(self) -> Result<Character<B>, Self::Fault> {
        if !(-1..=1).contains(&self.memory.wall) {
            return Err("the side of its last wall is -1, 0 or 1");
        }
        if self.floor.is_some_and(|floor| floor.axis.is_zero()) {
            return Err("its floor has no normal");
        }
        if !self.floor.is_none_or(|floor| floor.axis.has_opposite()) {
            return Err("the normal of its floor has no opposite: a component is i32::MIN");
        }
        Ok(fields!(Character of self))
    }
}

stored!([B: Body] Character<B> as Hero<B>; B);

/// A memo only saves time, and its answer cannot be checked without the level. So it is not saved,
/// and reads back empty.
#[derive(Serialize, Deserialize)]
struct Forgotten {
    version: Version,
}

impl<B, S> StoredForm<Memo<B, S>> for Forgotten {
    type Fault = Infallible;

    fn of(_: &Memo<B, S>) -> Self {
        Self { version: Version }
    }

    fn check(self) -> Result<Memo<B, S>, Infallible> {
        Ok(Memo::new())
    }
}

stored!([B, S] Memo<B, S> as Forgotten<>;);
