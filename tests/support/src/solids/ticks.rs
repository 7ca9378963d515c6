//! Ticks of a level with solids and bodies in it, each one judged.

use crate::Random;
use crate::solids::judge::{Block, Judged};
use crate::solids::twins::{mirrored, translated};
use crate::solids::{P, disc, raw, rect, show, solid, vec2};
use tilesat::prelude::*;
use tilesat::{
    Axis, Fx, Grid, Joined, MoveError, Mover, Side, Solid, Solids, Vec2, World,
    motion::{Ridden, Ride},
};

pub const SIDE: i64 = 6;

pub const CELL: i64 = 1 << 12;

pub const ALL: i64 = SIDE * CELL;

pub const MOVER: Mover = Mover::platformer(Axis::NEG_Y);

pub const FOLLOW: i64 = 300;

pub fn grid(origin: P) -> Grid {
    Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), vec2(origin)).unwrap()
}

/// A coordinate on the lattice or beside it.
pub fn coordinate(random: &mut Random) -> i64 {
    match random.below(4) {
        0 => random.within(-1, SIDE + 1) * CELL,
        1 => random.within(-1, SIDE + 1) * CELL + random.around(2),
        2 => random.within(-2, 2 * SIDE + 2) * CELL / 2,
        _ => random.within(-CELL, ALL + CELL),
    }
}

pub fn speed(random: &mut Random) -> i64 {
    match random.below(6) {
        0 | 1 => 0,
        2 => random.around(3),
        3 => random.around(CELL / 8),
        4 => random.within(-4, 4) * CELL / 4,
        _ => random.around(3 * CELL),
    }
}

pub fn solids(random: &mut Random) -> Vec<Solid> {
    let mut list = vec![];
    for key in 0..random.within(1, 6) {
        let at = (coordinate(random), coordinate(random));
        let size =
            |random: &mut Random| [CELL, CELL / 2, 1, 3 * CELL, random.within(1, 2 * CELL)][random.below(5) as usize];
        let s = solid(at, (at.0 + size(random), at.1 + size(random)), (key * 7 % 6) as u16);
        let s = match random.below(8) {
            0 => s.with_one_way(Side::Up),
            1 => s.with_one_way([Side::Left, Side::Right, Side::Down][random.below(3) as usize]),
            _ => s,
        };
        let belt = if random.one_in(4) { (random.around(200), 0) } else { (0, 0) };
        list.push(s.with_conveyor(vec2(belt)).unwrap());
    }
    // Sometimes one lies flush beside another, and moves with it.
    if list.len() > 1 && random.one_in(2) {
        let a = Block::of(&list[0].shape());
        list[1] = solid((a.hi.0, a.lo.1), (a.hi.0 + CELL, a.hi.1), list[1].key());
    }
    list
}

/// A speed along an axis that keeps what is at this coordinate near the level.
pub fn homeward(at: i64, m: i64) -> i64 {
    if at + m < -3 * CELL {
        m.abs()
    } else if at + m > ALL + 3 * CELL {
        -m.abs()
    } else {
        m
    }
}

pub fn steer(list: &mut [Solid], random: &mut Random) {
    let pair = list.len() > 1 && list[1].shape().min().x == list[0].shape().max().x;
    for s in list.iter_mut() {
        let m = (speed(random), speed(random));
        let at = raw(s.shape().min());
        *s = s.with_motion(vec2((homeward(at.0, m.0), homeward(at.1, m.1)))).unwrap();
    }
    if pair {
        list[1] = list[1].with_motion(list[0].motion()).unwrap();
    }
}

/// Counts, so that the test cannot pass without events.
#[derive(Debug, Default)]
pub struct Seen {
    pub free: u32,
    pub carried: u32,
    pub pushed: u32,
    pub squashed: u32,
    pub exact: u32,
    /// Boxes in the way of one solid that goes along an axis, and circles in the way of one in the
    /// open.
    pub alone: u32,
}

pub struct Scene<'a, W> {
    pub level: &'a W,
    pub mirror: &'a W,
    pub moved: &'a W,
    pub by: P,
    /// The full cells, where the level is of blocks.
    pub cells: Option<Vec<Block>>,
}

impl<W: World> Scene<'_, W> {
    pub fn ride<B: Judged>(&self, list: &[Solid], body: &B, random: &mut Random, seen: &mut Seen) -> Option<Ridden<B>>
    where
        W: Overlaps<B>,
    {
        let follow = Fx::from_bits(FOLLOW as i32);
        let ridden = match MOVER.ride(self.level, list, body, follow) {
            Ok(r) => r,
            Err(e) => panic!("{body:?} {e:?}"),
        };
        let case = || format!("{}\n{}\n{ridden:?}", show(list), body.show());
        let made = raw(ridden.motion);
        assert_eq!(body.at(made), ridden.body, "{}", case());
        assert!(!self.level.overlaps(&ridden.body), "in the level: {}", case());
        if let Some(cells) = &self.cells {
            assert!(!cells.iter().any(|&c| ridden.body.in_block(c)), "in a cell: {}", case());
        }
        let squashed = matches!(ridden.ride, Ride::Squashed { .. });
        for s in list {
            let (m, old) = (raw(s.motion()), Block::of(&s.shape()));
            if squashed {
                continue;
            }
            assert!(!ridden.body.overlaps_solid(&s.moved()), "in a solid: {}", case());
            if s.one_way().is_none() && !body.in_block(old) {
                assert!(!body.goes_through((made.0 - m.0, made.1 - m.1), old), "passed by {s:?}: {}", case());
            }
        }
        self.judge(list, body, &ridden, seen);
        self.twins(list, body, &ridden, random);
        (!squashed).then_some(ridden)
    }

    pub fn judge<B: Judged>(&self, list: &[Solid], body: &B, ridden: &Ridden<B>, seen: &mut Seen) {
        let case = || format!("{}\n{}\n{ridden:?}", show(list), body.show());
        let carry = raw(ridden.carry);
        match ridden.ride {
            Ride::Free => {
                seen.free += 1;
                assert_eq!((ridden.body, ridden.floor), (*body, None), "{}", case());
            }
            Ride::Carried => {
                seen.carried += 1;
                assert!(ridden.floor.is_some(), "{}", case());
            }
            Ride::Pushed { by, normal } => {
                seen.pushed += 1;
                // A pushing solid comes along the normal.
                let comes =
                    |s: &Solid| i64::from(normal.x) * raw(s.motion()).0 + i64::from(normal.y) * raw(s.motion()).1 > 0;
                assert!(list.iter().any(|s| s.key() == by && comes(s)), "{}", case());
            }
            Ride::Squashed { by, .. } => {
                seen.squashed += 1;
                assert_eq!(ridden.body, *body, "{}", case());
                let way = body.block().swept(carry);
                let near = |s: &Solid| {
                    let b = Block::of(&s.shape()).swept(raw(s.motion()));
                    let (w, z) = ((way.hi.0 - way.lo.0) + 8 * CELL, (way.hi.1 - way.lo.1) + 8 * CELL);
                    Block { lo: (b.lo.0 - w, b.lo.1 - z), hi: (b.hi.0 + w, b.hi.1 + z) }.meets(way)
                };
                assert!(list.iter().any(|s| s.key() == by && near(s)), "{}", case());
            }
        }
        let Some(cells) = &self.cells else { return };
        // With a free way, the carrier's motion is made to the bit.
        let way = body.block().swept(carry);
        let carrier = list.iter().find(|s| Some(s.key()) == ridden.floor);
        let alone = list.iter().all(|s| {
            carrier.is_some_and(|c| c.key() == s.key() || raw(s.motion()) == carry)
                || !Block::of(&s.shape()).swept(raw(s.motion())).meets(way)
        });
        // A belt may roll a circle over the corner on which it lies.
        let rolls = !B::IS_BOX && carrier.is_some_and(|c| raw(c.conveyor()) != (0, 0));
        if carrier.is_some() && alone && !rolls && !cells.iter().any(|c| c.meets(way)) {
            seen.exact += 1;
            assert_eq!(ridden.motion, ridden.carry, "{}", case());
        }
        // In the open there is always a way out of one solid's way.
        if let [s] = list
            && ridden.ride != Ride::Free
            && !body.in_block(Block::of(&s.shape()))
        {
            let (w, m) = (body.block(), raw(s.motion()));
            let reach = m.0.abs().max(m.1.abs()) * 4 + 99;
            let open = Block { lo: (w.lo.0 - reach, w.lo.1 - reach), hi: (w.hi.0 + reach, w.hi.1 + reach) };
            if !cells.iter().any(|c| c.meets(open)) {
                seen.alone += 1;
                assert!(matches!(ridden.ride, Ride::Carried | Ride::Pushed { .. }), "{}", case());
            }
        }
        // One solid along one axis and no carrier. How far it pushes a box, and whether there is
        // room, is known.
        if let ([s], None, None) = (list, ridden.floor, list[0].one_way()) {
            let (m, old, b) = (raw(s.motion()), Block::of(&s.shape()), body.block());
            let boxed = rect(b.lo, b.hi);
            if (m.0 == 0) == (m.1 == 0) || !B::IS_BOX || b.meets(old) {
                return;
            }
            let need = if !boxed.goes_through((-m.0, -m.1), old) {
                (0, 0)
            } else if m.0 != 0 {
                (if m.0 > 0 { old.hi.0 + m.0 - b.lo.0 } else { old.lo.0 + m.0 - b.hi.0 }, 0)
            } else {
                (0, if m.1 > 0 { old.hi.1 + m.1 - b.lo.1 } else { old.lo.1 + m.1 - b.hi.1 })
            };
            seen.alone += u32::from(need != (0, 0));
            if cells.iter().any(|c| c.meets(b.swept(need))) {
                assert!(matches!(ridden.ride, Ride::Squashed { .. }), "{}", case());
            } else {
                assert_eq!(raw(ridden.motion), need, "{}", case());
                let normal = Axis::new(m.0.signum() as i32, m.1.signum() as i32);
                let pushed = Ride::Pushed { by: s.key(), normal };
                assert_eq!(ridden.ride, if need == (0, 0) { Ride::Free } else { pushed }, "{}", case());
            }
        }
    }

    pub fn twins<B: Judged>(&self, list: &[Solid], body: &B, ridden: &Ridden<B>, random: &mut Random) {
        let case = || format!("{}\n{}\n{ridden:?}", show(list), body.show());
        let follow = Fx::from_bits(FOLLOW as i32);
        let mut other = list.to_vec();
        random.shuffle(&mut other);
        assert_eq!(
            MOVER.ride(self.level, &other, body, follow).unwrap(),
            *ridden,
            "shuffled {}\n{}",
            show(&other),
            case()
        );
        let other: Vec<_> = list.iter().map(|s| translated(s, self.by)).collect();
        let twin = MOVER.ride(self.moved, &other, &body.at(self.by), follow).unwrap();
        assert_eq!((twin.body, twin.ride), (ridden.body.at(self.by), ridden.ride), "translated {}", case());
        let other: Vec<_> = list.iter().map(mirrored).collect();
        let twin = MOVER.ride(self.mirror, &other, &body.mirrored(), follow).unwrap();
        let ride = match ridden.ride {
            Ride::Squashed { by, normal } => Ride::Squashed { by, normal: Axis::new(-normal.x, normal.y) },
            Ride::Pushed { by, normal } => Ride::Pushed { by, normal: Axis::new(-normal.x, normal.y) },
            ride => ride,
        };
        assert_eq!((twin.body, twin.floor), (ridden.body.mirrored(), ridden.floor), "mirrored {}\n{twin:?}", case());
        let same = twin.ride == ride;
        let middle = list.iter().any(|s| body.overlaps_solid(s));
        assert!(same || middle, "mirrored {}\n{twin:?}", case());
    }

    pub fn play<B: Judged>(&self, make: impl Fn(&mut Random) -> B, ticks: u32, random: &mut Random, seen: &mut Seen)
    where
        W: Overlaps<B>,
        for<'s> Joined<'s, W, Solids<'s>>: Overlaps<B>,
    {
        let mut list = solids(random);
        let mut bodies: Vec<(Option<B>, Vec2)> = vec![(None, Vec2::ZERO); random.within(1, 4) as usize];
        for _ in 0..ticks {
            {
                let here = Solids::new(&list);
                let joined = Joined::new(self.level, &here);
                for (body, v) in &mut bodies {
                    // New ones, some of them on a solid.
                    if body.is_none() || random.one_in(12) {
                        let mut new = make(random);
                        if random.one_in(2) {
                            let s = list[random.below(list.len() as i64) as usize];
                            let (b, s) = (new.block(), Block::of(&s.shape()));
                            let side = (b.lo.0 + b.hi.0 - s.lo.0 - s.hi.0) / 2;
                            new = new.at((-side + random.around(2) * (s.hi.0 - s.lo.0) / 3, s.lo.1 - b.hi.1));
                        }
                        (*body, *v) = ((!joined.overlaps(&new)).then_some(new), Vec2::ZERO);
                    }
                }
            }
            steer(&mut list, random);
            for (body, _) in &mut bodies {
                *body = body.and_then(|b| self.ride(&list, &b, random, seen)).map(|r| r.body);
            }
            Solid::move_all(&mut list);
            let here = Solids::new(&list);
            let joined = Joined::new(self.level, &here);
            for (body, v) in &mut bodies {
                let Some(b) = body else { continue };
                let push = if random.one_in(3) { (raw(*v).0, raw(*v).1 + 100) } else { (speed(random), speed(random)) };
                match MOVER.move_and_slide(&joined, b, vec2(push)) {
                    Ok(moved) => {
                        assert!(!list.iter().any(|s| moved.body.overlaps_solid(s)));
                        (*body, *v) = (Some(moved.body), moved.velocity);
                        let c = raw(moved.body.position());
                        if c.0.abs().max(c.1.abs()) > 40 * CELL {
                            *body = None;
                        }
                    }
                    Err(MoveError::Stuck(_)) => panic!("stuck without being squashed: {} {}", b.show(), show(&list)),
                    Err(e) => panic!("{e:?}"),
                }
            }
        }
    }
}

pub fn boxes(random: &mut Random) -> tilesat::Aabb {
    let at = (coordinate(random), coordinate(random));
    let size = |random: &mut Random| [CELL, CELL / 2, 1, random.within(1, 2 * CELL)][random.below(4) as usize];
    rect(at, (at.0 + size(random), at.1 + size(random)))
}

pub fn balls(random: &mut Random) -> tilesat::Circle {
    let r = [CELL / 2, CELL / 4, 1, random.within(1, CELL)][random.below(4) as usize];
    disc((coordinate(random), coordinate(random)), r)
}

/// Upright and level.
pub fn capsules(random: &mut Random) -> tilesat::Capsule {
    let (at, long) = ((coordinate(random), coordinate(random)), random.within(-CELL, CELL));
    let r = [CELL / 4, CELL / 3, 1, random.within(1, CELL / 2)][random.below(4) as usize];
    let end = if random.one_in(3) { (at.0 + long, at.1) } else { (at.0, at.1 + long) };
    tilesat::Capsule::new(vec2(at), vec2(end), tilesat::Fx::from_bits(r as i32)).unwrap()
}

pub fn tiles(random: &mut Random, ids: i64) -> Vec<u8> {
    let dense = random.within(2, 12);
    (0..SIDE * SIDE).map(|_| if random.one_in(dense) { random.within(1, ids) as u8 } else { 0 }).collect()
}
