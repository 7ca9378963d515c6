//! Scenes: what a snapshot has, where the scene and its broad phase have to agree.

use super::blocked_sides::ALL;
use super::body::{Mode, NOBODY};
use super::body_path::Drift;
use super::kernel::BodyShape;
use super::scene_character::Under;
use super::set::SleepDifference;
use super::snapshot::{Kept, Snapshot, Status};
use super::{Scene, SceneBody, SceneCharacter, Sleep};
use crate::broad::{BroadPhase, Handle, Keyed};
use crate::filter::Filter;
use crate::motion::{Body, Character};
use crate::num::{DOMAIN, Fx, Raw, Vec2};
use crate::stored::{StoredForm, Version, Wrong, ensure, read, stored, write};
use core::convert::Infallible;
use heapless::Vec;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The state that a body carries from step to step.
#[derive(Serialize, Deserialize)]
struct Lasting<S> {
    slot: u16,
    body: SceneBody<S>,
    mode: Mode,
    quiet: u8,
    support: u8,
    ground: u16,
    blocked: u8,
    drift: Drift,
}

#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "B: Serialize, S: Serialize", deserialize = "B: Deserialize<'de>, S: Deserialize<'de>"))]
struct SceneState<B, const N: usize, S> {
    version: Version,
    near: B,
    sleep: Sleep,
    bodies: Vec<Lasting<S>, N>,
    awake: Vec<u16, N>,
}

impl<B: BroadPhase<Tag = Keyed<Filter>> + Copy, const N: usize, S: BodyShape> StoredForm<Snapshot<B, N, S>>
    for SceneState<B, N, S>
{
    type Fault = Wrong;

    fn of(snapshot: &Snapshot<B, N, S>) -> Self {
        let taken = snapshot.kept.iter().enumerate().filter(|(_, kept)| kept.status.mode() != Mode::Free);
        let bodies = taken.map(|(slot, kept)| {
            let Kept { body, status, quiet, support, ground, drift } = *kept;
            let (mode, blocked) = (status.mode(), status.blocked());
            Lasting { slot: slot as u16, body, mode, quiet, support, ground, blocked, drift }
        });
        Self {
            version: Version,
            near: snapshot.near,
            sleep: snapshot.sleep.sleep(),
            bodies: bodies.collect(),
            awake: snapshot.awake.iter().copied().take(usize::from(snapshot.count)).collect(),
        }
    }

    fn check(self) -> Result<Snapshot<B, N, S>, Wrong> {
        let Self { near, sleep, bodies, awake, .. } = self;
        ensure(sleep.still >= Fx::ZERO, 0, "bodies fall asleep below a speed that is negative")?;
        let (mut kept, mut next) = ([Kept::FREE; N], 0);
        for lasting in &bodies {
            let at = usize::from(lasting.slot);
            ensure(at >= next, at, "bodies come in the order of their slots, each once")?;
            next = at + 1;
            agrees(lasting, &near)?;
            let Some(place) = kept.get_mut(at) else { return Err(Wrong { at, what: "it is beyond the last slot" }) };
            let Lasting { body, mode, quiet, support, ground, blocked, drift, .. } = *lasting;
            let ground_is_here = ground == NOBODY || usize::from(ground) < N;
            ensure(ground_is_here, at, "it is carried by what is beyond the last slot")?;
            ensure(blocked <= ALL, at, "it is blocked at more sides than four")?;
            *place = Kept { body, status: Status::of(mode, blocked), quiet, support, ground, drift };
        }
        ensure(near.len() == bodies.len(), bodies.len(), "the broad phase has more bodies")?;
        let (mut list, mut listed) = ([0; N], [false; N]);
        for (place, &slot) in list.iter_mut().zip(&awake) {
            let at = usize::from(slot);
            let is_awake = kept.get(at).is_some_and(Kept::is_awake);
            ensure(is_awake, at, "it is in the list of those awake, and is not")?;
            let seen = listed.get_mut(at).is_some_and(|seen| core::mem::replace(seen, true));
            ensure(!seen, at, "it is in the list of those awake twice")?;
            *place = slot;
        }
        let count = kept.iter().filter(|kept| kept.is_awake()).count();
        ensure(count == awake.len(), awake.len(), "the list of those awake leaves one out")?;
        Ok(Snapshot { near, kept, awake: list, count: count as u16, sleep: SleepDifference::of(sleep) })
    }
}

/// The data of a body that both a scene and its broad phase have.
fn agrees<B: BroadPhase<Tag = Keyed<Filter>>, S: BodyShape>(lasting: &Lasting<S>, near: &B) -> Result<(), Wrong> {
    let Lasting { slot, ref body, mode, .. } = *lasting;
    let at = usize::from(slot);
    let handle = near.table().handle(at);
    ensure(near.contains(handle), at, "the broad phase has no body there")?;
    ensure(near.bounds(handle) == Ok(body.shape.aabb()), at, "the broad phase has another box")?;
    let known = near.tag(handle).is_ok_and(|known| known == body.tag(!mode.is_awake()));
    ensure(known, at, "the broad phase has another filter, key or rest")?;
    let mode_fits = match mode {
        Mode::Free => false,
        Mode::Fixed => body.mass.is_none(),
        Mode::Woken | Mode::Awake | Mode::Asleep => body.mass.is_some(),
    };
    ensure(mode_fits, at, "what has no mass is fixed, and nothing else is")?;
    // A step leaves motions, plus the changes that bodies give each other. With the pushes of a
    // step, which are motions, that stays below 2^31.
    let Raw { x, y } = Raw::of(body.velocity);
    let most = x.unsigned_abs().max(y.unsigned_abs());
    ensure(most < 2 * DOMAIN.unsigned_abs(), at, "its velocity is one that no step leaves")
}

#[derive(Serialize, Deserialize)]
struct LedCharacter<B: Body> {
    version: Version,
    #[serde(bound(serialize = "B: Serialize", deserialize = "B: Deserialize<'de>"))]
    character: Character<B>,
    body: Handle,
    seen: Vec2,
    at: Vec2,
    on: Option<Under>,
    rides: Option<Under>,
    carry: Vec2,
}

impl<B: Body> StoredForm<SceneCharacter<B>> for LedCharacter<B> {
    type Fault = Infallible;

    fn of(led: &SceneCharacter<B>) -> Self {
        let SceneCharacter { character, body, seen, at, on, rides, carry } = *led;
        Self { version: Version, character, body, seen, at, on, rides, carry }
    }

    fn check(self) -> Result<SceneCharacter<B>, Infallible> {
        let Self { character, body, seen, at, on, rides, carry, .. } = self;
        Ok(SceneCharacter { character, body, seen, at, on, rides, carry })
    }
}

stored!([B: Body] SceneCharacter<B> as LedCharacter<B>; B);

impl<B: BroadPhase<Tag = Keyed<Filter>> + Copy + Serialize, const N: usize, S: BodyShape + Serialize> Serialize
    for Snapshot<B, N, S>
{
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        write::<_, SceneState<B, N, S>, T>(self, to)
    }
}

impl<'de, B: BroadPhase<Tag = Keyed<Filter>> + Copy + Deserialize<'de>, const N: usize, S> Deserialize<'de>
    for Snapshot<B, N, S>
where
    S: BodyShape + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        read::<_, SceneState<B, N, S>, D>("Scene", from)
    }
}

impl<B: BroadPhase<Tag = Keyed<Filter>> + Copy + Serialize, const N: usize, const M: usize, S> Serialize
    for Scene<B, N, M, S>
where
    S: BodyShape + Serialize,
{
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        self.snapshot().serialize(to)
    }
}

impl<'de, B: BroadPhase<Tag = Keyed<Filter>> + Copy + Deserialize<'de>, const N: usize, const M: usize, S>
    Deserialize<'de> for Scene<B, N, M, S>
where
    S: BodyShape + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let snapshot = Snapshot::deserialize(from)?;
        let mut scene = Self::remembering(snapshot.near, snapshot.sleep.sleep());
        scene.restore(&snapshot);
        Ok(scene)
    }
}
