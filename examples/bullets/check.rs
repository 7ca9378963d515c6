//! Checks every frame by other means: all pairs of all bodies, the events of their beginning and
//! end, and the ways of all flying bodies.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::rooms::{Rooms, solid};
use tilesat::broad::{BroadPhase, Handle, Pair, PairEvent};
use tilesat::{Aabb, Vec2};
use tilesat_games::bullets::{Game, Kind, Near};

/// All bodies, by slot.
pub fn everybody(near: &Near) -> Vec<Handle> {
    let mut all = Vec::new();
    let most = Vec2::from_ints(8000, 8000);
    if let Ok(everywhere) = Aabb::new(-most, most) {
        near.in_region(&everywhere, |handle| all.push(handle));
    }
    all.sort();
    all
}

/// A body as whole numbers: twice its centre and its width, in raw units. Nothing is rounded.
#[derive(Clone, Copy)]
struct Plain {
    handle: Handle,
    kind: Kind,
    still: bool,
    centre: (i64, i64),
    size: (i64, i64),
}

impl Plain {
    fn all(game: &Game) -> Vec<Self> {
        let plain = |handle| {
            let (body, bounds) = (game.body(handle)?, game.near.bounds(handle).ok()?);
            let ((x0, y0), (x1, y1)) = (bounds.min().raw(), bounds.max().raw());
            let (x0, y0, x1, y1) = (i64::from(x0), i64::from(y0), i64::from(x1), i64::from(y1));
            let stands = matches!(body.kind, Kind::Zone | Kind::Turret | Kind::Spinner);
            // A patrol falls asleep at the end of a frame.
            let still = stands || body.kind == Kind::Patrol && body.clock % 256 >= 160;
            Some(Self { handle, kind: body.kind, still, centre: (x0 + x1, y0 + y1), size: (x1 - x0, y1 - y0) })
        };
        everybody(&game.near).into_iter().filter_map(plain).collect()
    }

    fn apart(&self, other: &Self) -> (i64, i64) {
        ((self.centre.0 - other.centre.0).abs(), (self.centre.1 - other.centre.1).abs())
    }

    fn boxes_touch(&self, other: &Self) -> bool {
        let (x, y) = self.apart(other);
        x <= self.size.0 + other.size.0 && y <= self.size.1 + other.size.1
    }

    fn touches(&self, other: &Self) -> bool {
        let (x, y) = self.apart(other);
        let reach = match (self.kind, other.kind) {
            // From the box to the centre, and the circle's radius.
            (Kind::Zone, _) | (_, Kind::Zone) => {
                let (zone, circle) = if self.kind == Kind::Zone { (self, other) } else { (other, self) };
                let (x, y) = ((x - zone.size.0).max(0), (y - zone.size.1).max(0));
                return x * x + y * y <= circle.size.0 * circle.size.0;
            }
            _ => self.size.0 + other.size.0,
        };
        x * x + y * y <= reach * reach
    }

    /// Which kinds of bodies affect each other, as a table.
    fn wants(&self, other: &Self) -> bool {
        use Kind::{Bullet, Patrol, Player, Shot, Spinner, Turret, Zone};
        let ordered = |a, b| {
            matches!((a, b), (Zone | Bullet, Player) | (Zone | Bullet | Shot | Player, Turret | Spinner | Patrol))
        };
        !(self.still && other.still) && (ordered(self.kind, other.kind) || ordered(other.kind, self.kind))
    }
}

type Names = (Handle, Handle);

pub struct Judge {
    rooms: Rooms,
    room_of: BTreeMap<Handle, u8>,
    /// Pairs that have begun.
    last: BTreeSet<Names>,
    /// Pairs that are ignored until they separate, and whether the game added them after the last
    /// frame's pairs.
    ignored: BTreeMap<Names, bool>,
    straight: u32,
    bent: u32,
    other: u32,
    near: u32,
    events: u32,
}

impl Judge {
    pub fn new() -> Self {
        let (room_of, last, ignored) = Default::default();
        Self { rooms: Rooms::new(), room_of, last, ignored, straight: 0, bent: 0, other: 0, near: 0, events: 0 }
    }

    /// No body is in the solid on its way or at its end, or in another room than before.
    pub fn flights(&mut self, before: &Game, after: &Game) -> Result<(), String> {
        for handle in everybody(&after.near) {
            let (Some(then), Some(now)) = (before.body(handle), after.body(handle)) else {
                return Err(format!("{handle:?} appeared in flight"));
            };
            let (Some(from), Some(to)) = (before.circle(handle), after.circle(handle)) else { continue };
            let stands = matches!(now.kind, Kind::Zone | Kind::Turret | Kind::Spinner);
            if stands && from == to {
                continue;
            }
            let (from, to, radius) = (spot(from.centre()), spot(to.centre()), to.radius().to_num::<f64>());
            let room = *self.room_of.entry(handle).or_insert_with(|| self.rooms.at(from));
            if room == 0 || self.rooms.at(to) != room {
                return Err(format!("{:?} went from room {room} to {} at {to:?}", now.kind, self.rooms.at(to)));
            }
            // One bounce: from + v t + w (1 - t) = to, for the best fitting t.
            let (v, w) = (spot(then.velocity), spot(now.velocity));
            let (d, e) = ((v.0 - w.0, v.1 - w.1), (to.0 - from.0 - w.0, to.1 - from.1 - w.1));
            let turned = d.0 * d.0 + d.1 * d.1;
            let t = if turned > 0.0 { ((d.0 * e.0 + d.1 * e.1) / turned).clamp(0.0, 1.0) } else { 1.0 };
            let off = (e.0 - t * d.0).hypot(e.1 - t * d.1);
            let turn = (from.0 + t * v.0, from.1 + t * v.1);
            let legs = match now.kind {
                Kind::Patrol | Kind::Bullet | Kind::Shot if off < 0.01 => vec![(from, turn), (turn, to)],
                _ => vec![(to, to)],
            };
            match legs.len() {
                2 if turned == 0.0 => self.straight += 1,
                2 => self.bent += 1,
                _ => self.other += 1,
            }
            if let Some(at) = legs.into_iter().find_map(|leg| blocked(leg, radius)) {
                return Err(format!("{:?} from {from:?} to {to:?} is in the solid at {at:?}", now.kind));
            }
        }
        Ok(())
    }

    /// Compares all pairs of bodies with the events that the game reported for them.
    pub fn meetings(&mut self, flown: &Game, met: &Game) -> Result<(), String> {
        let bodies = Plain::all(flown);
        let (mut near, mut touching) = (BTreeSet::new(), BTreeSet::new());
        for (i, b) in bodies.iter().enumerate() {
            for a in bodies.iter().take(i).filter(|a| a.wants(b)) {
                let names = (a.handle, b.handle);
                if a.boxes_touch(b) {
                    near.insert(names);
                }
                if a.touches(b) {
                    touching.insert(names);
                }
            }
        }
        let (mut found, mut phase, mut twice) = (BTreeSet::new(), flown.near, 0);
        phase.pairs(|Pair { a, b }| twice += u32::from(!found.insert((a, b))));
        if found != near || twice > 0 {
            return Err(format!(
                "{} pairs are near, the game found {}, {twice} of them twice",
                near.len(),
                found.len()
            ));
        }
        self.near += near.len() as u32;

        let rests = |handle| bodies.iter().any(|body| body.handle == handle && body.still);
        let here = |handle| bodies.iter().any(|body| body.handle == handle);
        let held = self.last.iter().filter(|names| rests(names.0) && rests(names.1));
        let now: BTreeSet<Names> =
            touching.iter().filter(|names| !self.ignored.contains_key(names)).chain(held).copied().collect();
        let mut expected = BTreeMap::new();
        for &(a, b) in self.last.union(&now) {
            let event = match (self.last.contains(&(a, b)), now.contains(&(a, b))) {
                (false, _) => PairEvent::Begin(Pair { a, b }),
                (true, true) => PairEvent::Stay(Pair { a, b }),
                (true, false) => PairEvent::End(Pair { a, b }),
            };
            expected.insert((a, b), event);
        }
        if !met.events.iter().eq(expected.into_values()) {
            return Err("unexpected events".to_owned());
        }
        self.events += met.events.iter().count() as u32;
        self.last = now;

        self.ignored.retain(|names, fresh| (touching.contains(names) || *fresh) && here(names.0) && here(names.1));
        self.ignored.values_mut().for_each(|fresh| *fresh = false);
        // Shots whose way bends began to touch a turret and turned there.
        for handle in everybody(&met.near) {
            let (Some(then), Some(now)) = (flown.body(handle), met.body(handle)) else { continue };
            if now.kind == Kind::Shot && now.velocity != then.velocity {
                let turned = |pair: Pair| pair.a == handle || pair.b == handle;
                let begun = met.events.iter().filter(|event| matches!(event, PairEvent::Begin(_)));
                self.ignored
                    .extend(begun.map(|event| event.pair()).find(|&pair| turned(pair)).map(|p| ((p.a, p.b), false)));
            }
        }
        let ignored = met.exceptions.iter().map(|(Pair { a, b }, _)| (a, b));
        if !ignored.eq(self.ignored.keys().copied()) {
            return Err("unexpected pairs are ignored".to_owned());
        }
        Ok(())
    }

    /// Notes the bodies that new bullets must not hit: those at their start.
    pub fn shots(&mut self, met: &Game, fired: &Game) {
        let bodies = Plain::all(fired);
        for bullet in bodies.iter().filter(|body| body.kind == Kind::Bullet && !met.near.contains(body.handle)) {
            let owner = bodies.iter().find(|body| body.centre == bullet.centre && body.kind != Kind::Bullet);
            let names = owner.map(|owner| (owner.handle.min(bullet.handle), owner.handle.max(bullet.handle)));
            self.ignored.extend(names.map(|names| (names, true)));
        }
    }
}

fn spot(p: Vec2) -> (f64, f64) {
    (p.x.to_num(), p.y.to_num())
}

/// The first position on a leg at which the circle, minus a tiny margin, is in the solid. Tests its
/// middle and 16 points of its rim, four times per unit.
fn blocked((from, to): ((f64, f64), (f64, f64)), radius: f64) -> Option<(f64, f64)> {
    let steps = ((to.0 - from.0).hypot(to.1 - from.1) * 4.0).ceil() as u32;
    (0..=steps).find_map(|step| {
        let share = f64::from(step) / f64::from(steps.max(1));
        let (x, y) = (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
        let rim = (0..16).map(|k| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_8).sin_cos();
            (x + (radius - 0.05) * cos, y + (radius - 0.05) * sin)
        });
        rim.chain([(x, y)]).find(|&(x, y)| solid(x, y))
    })
}

impl fmt::Display for Judge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { straight, bent, other, near, events, .. } = self;
        write!(
            f,
            "{near} pairs, {events} events; flights: {straight} straight, {bent} with a bounce, {other} by their end; "
        )?;
        write!(f, "{} rooms", self.rooms.count())
    }
}
