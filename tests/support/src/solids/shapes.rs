//! Moving solids of any convex shape, judged by the exact sum of two convex shapes.

use super::ticks::{CELL, FOLLOW, MOVER, coordinate, homeward, speed};
use super::{P, disc, raw, rect, vec2};
use crate::Random;
use crate::convex::shape::{MOST, hull};
use crate::oracle::measure::Measure;
use crate::oracle::sum::Sum;
use tilesat::prelude::*;
use tilesat::shape::AnyShape;
use tilesat::world::{ConvexSolid, ConvexSolids};
use tilesat::{
    Aabb, Axis, Body, Capsule, Circle, ConvexPolygon, Fx, Joined, MoveError, OrientedBox, Vec2, World,
    motion::{Ridden, Ride},
};

pub type Any = AnyShape<MOST>;
pub type Solid = ConvexSolid<Any>;

/// Points, and a radius around their hull.
#[derive(Clone, Debug)]
pub struct Figure {
    pub points: Vec<P>,
    pub radius: i64,
}

impl Figure {
    pub fn of(shape: &Any) -> Self {
        let all = |points: &[Vec2], radius: Fx| Self {
            points: points.iter().map(|p| raw(*p)).collect(),
            radius: radius.to_bits().into(),
        };
        match shape {
            Any::Aabb(b) => {
                let (lo, hi) = (raw(b.min()), raw(b.max()));
                Self { points: vec![lo, (hi.0, lo.1), hi, (lo.0, hi.1)], radius: 0 }
            }
            Any::Circle(c) => all(&[c.centre()], c.radius()),
            Any::Segment(s) => all(&[s.a(), s.b()], Fx::ZERO),
            Any::Capsule(c) => all(&[c.a(), c.b()], c.radius()),
            Any::OrientedBox(b) => all(&b.corners(), b.radius()),
            Any::Polygon(p) => all(p.vertices(), p.radius()),
        }
    }

    /// All places on a straight way; round ones a raw unit smaller.
    pub fn swept(&self, d: P) -> Self {
        let points = self.points.iter().flat_map(|&p| [p, (p.0 + d.0, p.1 + d.1)]).collect();
        Self { points, radius: (self.radius - 1).max(0) }
    }

    pub fn meets(&self, other: &Self) -> bool {
        let (p, q) = (hull(&self.points), hull(&other.points));
        let all: Vec<P> = p.iter().flat_map(|p| q.iter().map(|q| (p.0 - q.0, p.1 - q.1))).collect();
        Measure::of(&Sum::of_hull(&hull(&all), self.radius + other.radius)).overlaps()
    }
}

/// A body, as points and a radius.
pub trait Rider: Body + Copy + PartialEq + std::fmt::Debug {
    fn any(&self) -> Any;
    fn of(any: &Any) -> Self;

    fn figure(&self) -> Figure {
        Figure::of(&self.any())
    }

    fn at(&self, d: P) -> Self {
        Self::of(&self.any().translated(vec2(d)).unwrap())
    }

    fn mirrored(&self) -> Self {
        Self::of(&mirrored_shape(&self.any()))
    }
}

macro_rules! riders {
    ($($kind:ident: $body:ty),*) => {$(
        impl Rider for $body {
            fn any(&self) -> Any {
                Any::$kind(*self)
            }

            fn of(any: &Any) -> Self {
                match any {
                    Any::$kind(it) => *it,
                    other => panic!("{other:?}"),
                }
            }
        }
    )*};
}

riders!(Aabb: Aabb, Circle: Circle, Capsule: Capsule, Polygon: ConvexPolygon<MOST>);

fn flip(p: Vec2) -> Vec2 {
    vec2((-raw(p).0, raw(p).1))
}

pub fn mirrored_shape(shape: &Any) -> Any {
    match shape {
        Any::Aabb(b) => rect(raw(flip(b.min())), raw(flip(b.max()))).into(),
        Any::Circle(c) => Circle::new(flip(c.centre()), c.radius()).unwrap().into(),
        Any::Capsule(c) => Capsule::new(flip(c.a()), flip(c.b()), c.radius()).unwrap().into(),
        Any::Polygon(p) => {
            let points: Vec<_> = p.vertices().iter().map(|p| flip(*p)).collect();
            ConvexPolygon::new(&points).unwrap().with_radius(p.radius()).unwrap().into()
        }
        // Oriented boxes are polygons here: a mirrored direction rounds in another way.
        Any::Segment(_) | Any::OrientedBox(_) => panic!("not made"),
    }
}

pub fn mirrored(solid: &Solid) -> Solid {
    let new = Solid::new(mirrored_shape(&solid.shape()), solid.key()).unwrap();
    match solid.motion() {
        Some(motion) => new.with_motion(flip(motion)).unwrap(),
        None => new.with_turn(mirrored_shape(&solid.next())).unwrap(),
    }
}

pub fn show(list: &[Solid]) -> String {
    let one = |s: &Solid| format!("{} {:?} to {:?} by {:?}\n", s.key(), s.shape(), s.next(), s.motion());
    list.iter().map(one).collect::<Vec<_>>().concat()
}

/// An oriented box as a polygon.
pub fn plank(c: P, half: P, direction: (i64, i64)) -> Any {
    let direction = Axis::new(direction.0 as i32, direction.1 as i32);
    let turned = OrientedBox::new(vec2(c), vec2(half), direction).unwrap();
    ConvexPolygon::new(&turned.corners()).map_or_else(|_| Any::Aabb(turned.aabb()), Any::from)
}

pub fn shape(random: &mut Random) -> Any {
    loop {
        let c = (coordinate(random), coordinate(random));
        let size = [CELL, CELL / 2, CELL / 3, random.within(2, 2 * CELL)][random.below(4) as usize];
        let any: Any = match random.below(6) {
            0 => rect(c, (c.0 + size, c.1 + random.within(1, size))).into(),
            1 => disc(c, size / 2).into(),
            2 => {
                let long = random.around(size);
                let end = if random.one_in(2) { (c.0 + long, c.1) } else { (c.0, c.1 + long) };
                Capsule::new(vec2(c), vec2(end), Fx::from_bits(1 + (size / 3) as i32)).unwrap().into()
            }
            3 => plank(c, (size, random.within(2, size)), (random.around(9) | 1, random.around(9))),
            4 => {
                let r = Fx::from_bits(1 + (size / 4) as i32);
                let points = [c, (c.0 + size, c.1), (c.0 + size, c.1 + size / 2), (c.0, c.1 + size / 2)].map(vec2);
                ConvexPolygon::new(&points).unwrap().with_radius(r).unwrap().into()
            }
            _ => {
                let near = |random: &mut Random| vec2((c.0 + random.around(size), c.1 + random.around(size)));
                let points: Vec<_> = (0..random.within(3, 5)).map(|_| near(random)).collect();
                let Ok(polygon) = ConvexPolygon::hull(&points) else { continue };
                polygon.into()
            }
        };
        if Solid::new(any, 0).is_ok() {
            return any;
        }
    }
}

/// A shape turned by about `k / 32`, and moved.
fn turned(shape: &Any, k: i64, by: P) -> Option<Any> {
    let Any::Polygon(p) = shape else { return None };
    if p.radius() != Fx::ZERO {
        return None;
    }
    let all: Vec<P> = p.vertices().iter().map(|p| raw(*p)).collect();
    let n = all.len() as i64;
    let c = (all.iter().map(|p| p.0).sum::<i64>() / n, all.iter().map(|p| p.1).sum::<i64>() / n);
    let turn = |p: &P| {
        let m = (p.0 - c.0, p.1 - c.1);
        vec2((p.0 - m.1 * k / 32 + by.0, p.1 + m.0 * k / 32 + by.1))
    };
    let points: Vec<_> = all.iter().map(turn).collect();
    Some(ConvexPolygon::new(&points).ok()?.into())
}

pub fn steer(list: &mut [Solid], random: &mut Random) {
    for s in list.iter_mut() {
        let m = (speed(random), speed(random));
        let at = raw(s.shape().aabb().min());
        let m = (homeward(at.0, m.0), homeward(at.1, m.1));
        let slow = (m.0 / 8, m.1 / 8);
        let by = if random.one_in(2) { (0, 0) } else { slow };
        let next = if random.one_in(3) { turned(&s.shape(), random.around(9), by) } else { None };
        *s = match next.and_then(|next| s.with_turn(next).ok()) {
            Some(turns) => turns,
            None => s.with_motion(vec2(m)).unwrap(),
        };
    }
}

/// Counts, so that the test cannot pass without events.
#[derive(Debug, Default)]
pub struct Seen {
    pub free: u32,
    pub carried: u32,
    pub pushed: u32,
    pub squashed: u32,
    /// Carried by exactly the carry.
    pub exact: u32,
    /// In the open, by one solid.
    pub alone: u32,
    pub turned: u32,
    /// Squashed alone in the open.
    pub dead: u32,
    pub moves: u32,
}

pub struct Scene<'a, W> {
    pub level: &'a W,
    pub mirror: &'a W,
    /// Whether nothing is in the level.
    pub open: bool,
}

impl<W: World> Scene<'_, W> {
    pub fn ride<B: Rider>(&self, list: &[Solid], body: &B, random: &mut Random, seen: &mut Seen) -> Option<Ridden<B>>
    where
        W: Overlaps<B>,
    {
        let follow = Fx::from_bits(FOLLOW as i32);
        let ask = |list: &[Solid], level: &W, body: &B| match MOVER.ride_convex(level, list, body, follow) {
            Ok(r) => r,
            Err(e) => panic!("{body:?} {e:?}\n{}", show(list)),
        };
        let ridden = ask(list, self.level, body);
        let case = || format!("{}\n{body:?}\n{ridden:?}", show(list));
        let made = raw(ridden.motion);
        assert_eq!(body.at(made), ridden.body, "{}", case());
        assert!(!self.level.overlaps(&ridden.body), "in the level: {}", case());
        let squashed = matches!(ridden.ride, Ride::Squashed { .. });
        let (here, there) = (body.figure(), ridden.body.figure());
        let mut inside = false;
        for s in list {
            let (old, new) = (Figure::of(&s.shape()), Figure::of(&s.next()));
            inside |= here.meets(&old);
            if squashed {
                continue;
            }
            assert!(!there.meets(&new), "in a solid: {}", case());
            if let Some(m) = s.motion().map(raw)
                && !here.meets(&old)
            {
                let way = here.swept((made.0 - m.0, made.1 - m.1));
                assert!(!way.meets(&old), "passed by {s:?}: {}", case());
            }
        }
        match ridden.ride {
            Ride::Free => {
                seen.free += 1;
                assert_eq!((ridden.body, ridden.floor), (*body, None), "{}", case());
            }
            Ride::Carried => {
                seen.carried += 1;
                assert!(ridden.floor.is_some(), "{}", case());
            }
            Ride::Pushed { .. } => seen.pushed += 1,
            Ride::Squashed { .. } => {
                seen.squashed += 1;
                assert_eq!(ridden.body, *body, "{}", case());
            }
        }
        if let ([s], true, false) = (list, self.open, inside) {
            seen.alone += u32::from(ridden.ride != Ride::Free);
            seen.turned += u32::from(ridden.ride != Ride::Free && s.motion().is_none());
            if squashed {
                seen.dead += 1;
            }
            if let (Ride::Carried, Some(m)) = (ridden.ride, s.motion()) {
                seen.exact += 1;
                assert_eq!(ridden.motion, m, "{}", case());
            }
        }
        let mut other = list.to_vec();
        random.shuffle(&mut other);
        assert_eq!(ask(&other, self.level, body), ridden, "shuffled {}", case());
        let other: Vec<_> = list.iter().map(mirrored).collect();
        let twin = ask(&other, self.mirror, &body.mirrored());
        let of = |ridden: &Ridden<B>| match ridden.ride {
            Ride::Pushed { by, .. } | Ride::Squashed { by, .. } => (ridden.floor, Some(by)),
            Ride::Free | Ride::Carried => (ridden.floor, None),
        };
        assert_eq!((twin.body, of(&twin)), (ridden.body.mirrored(), of(&ridden)), "mirrored {}\n{twin:?}", case());
        (!squashed).then_some(ridden)
    }

    pub fn play<B: Rider>(&self, make: impl Fn(&mut Random) -> B, ticks: u32, random: &mut Random, seen: &mut Seen)
    where
        W: Overlaps<B>,
        for<'s> Joined<'s, W, ConvexSolids<'s, Any>>: Overlaps<B>,
    {
        let count = if self.open && random.one_in(2) { 1 } else { random.within(1, 4) };
        let mut list: Vec<Solid> =
            (0..count).map(|key| Solid::new(shape(random), (key * 7 % 6) as u16).unwrap()).collect();
        let mut bodies: Vec<(Option<B>, Vec2)> = vec![(None, Vec2::ZERO); random.within(1, 4) as usize];
        for _ in 0..ticks {
            {
                let here = ConvexSolids::new(&list);
                let joined = Joined::new(self.level, &here);
                for (body, v) in &mut bodies {
                    if body.is_none() || random.one_in(12) {
                        let mut new = make(random);
                        // Some of them over a solid, down onto it.
                        let s = list[random.below(list.len() as i64) as usize].shape().aabb();
                        let b = new.any().aabb();
                        let middle = (raw(s.centre()).0 - raw(b.centre()).0, raw(s.min()).1 - raw(b.max()).1);
                        let falls = random.one_in(2);
                        if falls {
                            let aside = random.around(1 + (raw(s.size()).0 / 2));
                            new = new.at((middle.0 + aside, middle.1 - 1));
                        }
                        (*body, *v) = ((!joined.overlaps(&new)).then_some(new), Vec2::ZERO);
                        if let (true, Some(b)) = (falls, *body) {
                            let down = vec2((0, 2 * CELL));
                            *body = MOVER.move_and_slide(&joined, &b, down).ok().map(|moved| moved.body);
                        }
                    }
                }
            }
            steer(&mut list, random);
            for (body, _) in &mut bodies {
                *body = body.and_then(|b| self.ride(&list, &b, random, seen)).map(|r| r.body);
            }
            Solid::move_all(&mut list);
            let here = ConvexSolids::new(&list);
            let joined = Joined::new(self.level, &here);
            for (body, v) in &mut bodies {
                let Some(b) = body else { continue };
                let push = if random.one_in(3) { (raw(*v).0, raw(*v).1 + 100) } else { (speed(random), speed(random)) };
                match MOVER.move_and_slide(&joined, b, vec2(push)) {
                    Ok(moved) => {
                        let figure = moved.body.figure();
                        let inside = list.iter().any(|s| figure.meets(&Figure::of(&s.shape())));
                        assert!(!inside, "{b:?} by {push:?} to {:?}\n{}", moved.body, show(&list));
                        seen.moves += 1;
                        (*body, *v) = (Some(moved.body), moved.velocity);
                        let c = raw(moved.body.position());
                        if c.0.abs().max(c.1.abs()) > 40 * CELL {
                            *body = None;
                        }
                    }
                    Err(MoveError::Stuck(_)) => panic!("stuck without being squashed: {b:?} {}", show(&list)),
                    Err(e) => panic!("{e:?}"),
                }
            }
        }
    }
}
