//! Oriented boxes, polygons and capsules come to rest in tiles and on convex solids, and stay
//! (P17).
//!
//! A call depends only on the level, the body and the velocity. So a frame that returns its own
//! body and velocity repeats for ever. Each rest is played for `TILESAT_FRAMES` frames (default
//! 1000, a million in the long run) all the same.

use super::rest::{ASYMMETRIC_V, DOMES, GAP, MILD_V, SHAPES, SLOPE_AND_WALL, STEEP_V, U, V};
use std::fmt::Debug;
use tilesat::motion::{Ride, Support};
use tilesat::world::ConvexSolids;
use tilesat::{AllShapes, Axis, Body, Capsule, ConvexPolygon, Fx, Joined, Mover, OrientedBox, Outside, Ratio, Surface};
use tilesat::{TileMap, Vec2, Walker};
use tilesat_judge::rooms::drawn;
use tilesat_judge::shapes::level::Level;
use tilesat_judge::solids::shapes::{Any, Figure, Solid, plank};
use tilesat_judge::solids::{P, disc, raw, rect, vec2};
use tilesat_judge::{Random, cases, frames};

const UP: Mover = Mover::platformer(Axis::NEG_Y);
/// Raw units in a unit; a cell has 16.
const SCALES: [i64; 5] = [16, 63, 4096, 65536, 1 << 18];

/// A body of the family, by its own type.
trait Figured: Body + Copy + PartialEq + Debug {
    fn any(&self) -> Any;
}

macro_rules! figured {
    ($($body:ty),*) => {$(
        impl Figured for $body {
            fn any(&self) -> Any {
                (*self).into()
            }
        }
    )*};
}

type Polygon = ConvexPolygon<6>;
figured!(OrientedBox, Capsule, Polygon, Any);

#[derive(Clone, Copy, Debug)]
enum Way {
    Slick,
    Rough(Surface),
    /// A walker that is pushed along x.
    Walks(i64),
}

/// A body, its velocity, and the floor of a walker.
type State<B> = (B, Vec2, Option<Support>);

struct Play<'a> {
    level: TileMap<'a, AllShapes>,
    solids: Vec<Solid>,
    gravity: i64,
    way: Way,
}

impl Play<'_> {
    fn step<B: Figured>(&self, (body, v, floor): State<B>) -> State<B> {
        let solids = ConvexSolids::new(&self.solids);
        let world = Joined::new(&self.level, &solids);
        let v = vec2((raw(v).0, raw(v).1 + self.gravity));
        let (moved, floor) = match self.way {
            Way::Slick => (UP.move_and_slide(&world, &body, v), None),
            Way::Rough(surface) => (UP.with_surface(surface).move_and_slide(&world, &body, v), None),
            Way::Walks(run) => {
                let walked = Walker::new(UP).walk(&world, &body, vec2((run, raw(v).1)), floor).unwrap();
                (Ok(walked.moved), walked.floor)
            }
        };
        let moved = moved.unwrap_or_else(|e| panic!("{e:?}: {body:?} by {v:?}\n{:?}", self.solids));
        (moved.body, moved.velocity, floor)
    }

    fn is_free<B: Figured>(&self, body: &B) -> bool {
        let figure = Figure::of(&body.any());
        !self.level.overlaps(&body.any()) && !self.solids.iter().any(|s| figure.meets(&Figure::of(&s.shape())))
    }

    /// The state from which on nothing changes, and the frame. `None` if it left over the end of a
    /// slope.
    fn settles<B: Figured>(&self, body: B) -> Option<(State<B>, u32)> {
        let mut state = (body, Vec2::ZERO, None);
        for k in 0..12_000 {
            let next = self.step(state);
            if next == state {
                assert!(self.is_free(&next.0), "{next:?}\n{:?}", self.solids);
                return Some((next, k));
            }
            if raw(next.0.position()).1 > 1 << 28 {
                return None;
            }
            if k < 40 {
                assert!(self.is_free(&next.0), "{state:?} to {next:?}\n{:?}", self.solids);
            }
            state = next;
        }
        let next = self.step(state);
        panic!("moves on: {state:?} to {next:?}, from {body:?} by {}, {:?}\n{:?}", self.gravity, self.way, self.solids)
    }

    /// A body around a point, or above it where there is room.
    fn over(&self, r: &mut Random, (x, mut y): P, size: i64) -> Any {
        loop {
            let body = any(r, (x, y), size);
            if self.is_free(&body) {
                return body;
            }
            y -= size / 4;
        }
    }

    fn rests<B: Figured>(&self, body: B) -> Option<u32> {
        let (rest, k) = self.settles(body)?;
        (0..frames(1_000)).for_each(|_| assert_eq!(self.step(rest), rest));
        Some(k)
    }

    /// Each kind of body, by its own type or as any shape.
    fn all(&self, r: &mut Random, middle: P, size: i64, seen: &mut Seen) {
        for _ in 0..12 {
            let c = (middle.0 + r.around(size), middle.1 + r.around(size / 2));
            let body = any(r, c, size);
            if !self.is_free(&body) {
                continue;
            }
            let k = match body {
                Any::OrientedBox(it) if r.one_in(2) => self.rests(it),
                Any::Polygon(it) if r.one_in(2) => self.rests(it),
                // Only as any shape may it slant.
                Any::Capsule(it) if r.one_in(2) && (it.a().x == it.b().x || it.a().y == it.b().y) => self.rests(it),
                _ => self.rests(body),
            };
            seen.rests += u32::from(k.is_some());
            seen.left += u32::from(k.is_none());
            seen.latest = seen.latest.max(k.unwrap_or(0));
        }
    }
}

#[derive(Debug, Default)]
struct Seen {
    rests: u32,
    left: u32,
    /// The frame from which on all were at rest.
    latest: u32,
}

/// An oriented box, a capsule that stands, lies or slants, or a polygon, sharp or round.
fn any(r: &mut Random, c: P, size: i64) -> Any {
    loop {
        let half = (r.within(1 + size / 8, size / 2), r.within(1 + size / 8, size / 2));
        let direction = Axis::new(r.around(9) as i32 | 1, r.around(9) as i32);
        let radius = Fx::from_bits(if r.one_in(2) { 0 } else { r.within(1, size / 4) as i32 });
        match r.below(4) {
            0 => return OrientedBox::new(vec2(c), vec2(half), direction).unwrap().into(),
            1 => {
                let to = [(half.0, 0), (0, half.1), half][r.below(3) as usize];
                let radius = Fx::from_bits(r.within(1 + size / 8, size / 3) as i32);
                return Capsule::new(vec2(c), vec2((c.0 + to.0, c.1 + to.1)), radius).unwrap().into();
            }
            2 => {
                let corners = OrientedBox::new(vec2(c), vec2(half), direction).unwrap().corners();
                let Ok(polygon) = Polygon::hull(&corners) else { continue };
                return polygon.with_radius(radius).unwrap().into();
            }
            _ => {
                let near = |r: &mut Random| vec2((c.0 + r.around(size / 2), c.1 + r.around(size / 2)));
                let points: Vec<_> = (0..r.within(3, 6)).map(|_| near(r)).collect();
                let Ok(polygon) = Polygon::hull(&points) else { continue };
                return polygon.with_radius(radius).unwrap().into();
            }
        }
    }
}

fn hull(points: &[P], s: i64) -> Any {
    let points: Vec<_> = points.iter().map(|p| vec2((p.0 * s, p.1 * s))).collect();
    ConvexPolygon::hull(&points).unwrap().into()
}

/// A wedge whose face goes from (x, y) along `d` for `times` its length, with the solid below it.
fn wedge((x, y): P, d: P, times: i64, s: i64) -> Any {
    let to = (x + d.0 * times, y + d.1 * times);
    hull(&[(x, y), to, (to.0, y.max(to.1) + 10), (x, y.max(to.1) + 10)], s)
}

fn listed(shapes: &[Any]) -> Vec<Solid> {
    shapes.iter().zip(1..).map(|(shape, key)| Solid::new(*shape, key).unwrap()).collect()
}

static NOTHING: [u8; 1] = [0];

fn open(s: i64) -> TileMap<'static, AllShapes> {
    static EMPTY: tilesat::TileKinds = tilesat::TileKinds::EMPTY;
    let grid = tilesat::Grid::new(1, 1, Fx::from_bits(16 * s as i32), Vec2::ZERO).unwrap();
    TileMap::of(&NOTHING, grid, &EMPTY).unwrap().with_outside(Outside::Empty)
}

/// A feather, and a stone.
fn gravity(r: &mut Random, s: i64) -> i64 {
    ((16 * s) >> r.within(3, 7)).max(16)
}

/// Two convex solids that hold a body between them, around (0, 0).
fn nook(r: &mut Random, s: i64) -> Vec<Any> {
    let slope = |r: &mut Random, side: i64| (side * r.within(1, 12), -r.within(1, 12));
    let dome = |r: &mut Random, side: i64| {
        let radius = r.within(20, 40) * s;
        Any::from(disc((side * radius, radius / 2), radius))
    };
    match r.below(5) {
        0 => vec![wedge((0, 0), slope(r, 1), 30, s), wedge((0, 0), slope(r, -1), 30, s)],
        1 => vec![dome(r, 1), dome(r, -1)],
        2 => vec![wedge((0, 0), slope(r, 1), 30, s), dome(r, -1)],
        // On two corners, or in the gap between them.
        3 => {
            let (left, right) = (r.within(1, 3), r.within(1, 3));
            let below = rect((-10 * s, 5 * s), (10 * s, 15 * s));
            vec![wedge((-left, 0), slope(r, -1), 30, s), below.into(), wedge((right, 0), slope(r, 1), 30, s)]
        }
        _ => {
            let left = plank((-25 * s, 0), (28 * s, 2 * s), (r.within(8, 20), r.within(1, 3)));
            vec![left, plank((25 * s, 0), (28 * s, 2 * s), (r.within(8, 20), -r.within(1, 3)))]
        }
    }
}

#[test]
fn p17_rest_between_convex_solids() {
    let mut r = Random::new(471);
    for s in SCALES {
        let mut seen = Seen::default();
        for _ in 0..cases(tilesat_judge::thorough(2, 4)) {
            let solids = listed(&nook(&mut r, s));
            let play = Play { level: open(s), solids, gravity: gravity(&mut r, s), way: Way::Slick };
            play.all(&mut r, (0, -40 * s), 12 * s, &mut seen);
        }
        println!("scale {s}: {seen:?}");
        assert!(seen.left * 20 < seen.rests, "{seen:?}");
    }
}

#[test]
fn p17_rest_in_tiles() {
    let mut r = Random::new(472);
    // The picture, the middle of its nook, and the largest body, in eighths of a cell.
    let pictures: [(&[&str], P, i64); 8] = [
        (&V, (24, 8), 8),
        (&ASYMMETRIC_V, (24, 4), 6),
        (&MILD_V, (24, 4), 6),
        (&STEEP_V, (24, 2), 6),
        (&U, (24, 8), 12),
        (&DOMES, (16, 8), 6),
        (&GAP, (24, 4), 20),
        (&SLOPE_AND_WALL, (18, 12), 5),
    ];
    for s in SCALES {
        let mut seen = Seen::default();
        for (rows, middle, size) in pictures {
            let level: Level = drawn(rows, 16 * s, &SHAPES);
            let play = Play { level: level.all(), solids: Vec::new(), gravity: gravity(&mut r, s), way: Way::Slick };
            play.all(&mut r, (2 * s * middle.0, 2 * s * middle.1), 2 * s * size, &mut seen);
        }
        println!("scale {s}: {seen:?}");
        assert!(seen.rests > 20 && seen.left == 0, "{seen:?}");
    }
}

/// A lying capsule whose round ends lie on two tips hops from one tip to the other, and comes to
/// rest on both.
#[test]
fn p17_on_two_tips() {
    let level = drawn(&STEEP_V, 65536, &SHAPES);
    for gravity in [128, 512, 1024, 1_600, 2_500, 4_000, 9_000, 12_000] {
        let play = Play { level: level.all(), solids: Vec::new(), gravity, way: Way::Slick };
        for x in (169_000..173_000).step_by(tilesat_judge::thorough(400, 100)) {
            let ends = [(x, 26_417), (x + 24_058, 26_417)].map(vec2);
            let capsule = Capsule::new(ends[0], ends[1], Fx::from_bits(6202)).unwrap();
            assert!(play.rests(capsule).is_some() && play.rests(Any::from(capsule)).is_some());
        }
    }
}

/// A body rests on a slope exactly if the tangent is at most the friction. A slick one goes down
/// every slope, and a walker stands on every floor.
#[test]
fn p17_on_a_slope() {
    let mut r = Random::new(473);
    let (mut rests, mut slides) = (0, 0);
    for s in SCALES {
        for _ in 0..cases(60) {
            let (run, rise, friction) = (r.within(1, 20), r.within(0, 20), r.within(0, 100) as u8);
            let solids = listed(&[wedge((-20 * run, 20 * rise), (run, -rise), 40, s)]);
            let gravity = gravity(&mut r, s);
            let over = Play { level: open(s), solids: solids.clone(), gravity, way: Way::Slick };
            let body = over.over(&mut r, (0, -14 * s), 12 * s);
            let rough = Way::Rough(Surface::new(Ratio::ZERO, Ratio::percent(friction).unwrap()));
            for (way, stays) in [
                (rough, 100 * rise <= i64::from(friction) * run),
                (Way::Slick, rise == 0),
                (Way::Walks(0), rise <= run),
            ] {
                let mut play = Play { level: open(s), solids: solids.clone(), gravity, way };
                if stays {
                    assert!(play.rests(body).is_some(), "{body:?} {solids:?}");
                    rests += 1;
                    continue;
                }
                // A way of less than the rounding distance per frame is none.
                if s < 4096 {
                    continue;
                }
                // It lands within these frames, and is on the slope for a while after them.
                play.gravity = s / 4;
                let mut state = (body, Vec2::ZERO, None);
                for k in 0..60 {
                    let next = play.step(state);
                    assert!(k < 40 || raw(next.0.aabb().min()).1 > raw(state.0.aabb().min()).1, "{state:?} {next:?}");
                    state = next;
                }
                slides += 1;
            }
        }
    }
    println!("{rests} rests, {slides} slides");
    assert!(rests > 100 && slides > 100);
}

/// A walker that is pushed on into the corner between a slope and a ceiling, or a floor and a
/// slanted ceiling, stays there.
#[test]
fn p17_between_a_slope_and_a_ceiling() {
    let (mut r, mut rests) = (Random::new(474), 0);
    for s in SCALES {
        for _ in 0..cases(tilesat_judge::thorough(20, 60)) {
            let (run, rise) = (r.within(8, 20), r.within(0, 8));
            let (over, fall) = (r.within(8, 20), r.within(i64::from(rise == 0), 30));
            // They meet on the right.
            let floor = wedge((400 - 40 * run, 40 * rise), (run, -rise), 40, s);
            let ceiling = hull(&[(400, 0), (400 - 40 * over, -40 * fall), (400, -40 * fall - 10)], s);
            let under = -s * 20 * run * fall / over;
            let flat = rect((0, -40 * s), (400 * s, 5 * s)).into();
            let ceiling = if rise > 0 && r.one_in(2) { flat } else { ceiling };
            let middle = (400 * s - 20 * s * run, s * r.within(-20, 20 * rise));
            let body = any(&mut r, middle, 8 * s);
            let solids = listed(&[floor, ceiling]);
            let run = s * r.within(1, 6) / 2;
            let play = Play { level: open(s), solids, gravity: gravity(&mut r, s), way: Way::Walks(run) };
            // A thin ceiling leaves room above it, from where a body walks over its end.
            if play.is_free(&body) && middle.1 > under {
                assert!(play.rests(body).is_some(), "{body:?} {:?}", play.solids);
                rests += 1;
            }
        }
    }
    assert!(rests > tilesat_judge::thorough(34, 100));
}

/// Bodies at rest on solids that move together and stop: they go by exactly that, and are at rest
/// again in each frame.
#[test]
fn p17_on_a_lift() {
    let mut r = Random::new(475);
    let mut seen = 0;
    for s in SCALES {
        for k in 0..cases(40) {
            let slope = |r: &mut Random, side: i64| (side * r.within(6, 12), -r.within(1, 6));
            let mut shapes = match k % 3 {
                0 => vec![wedge((0, 0), slope(&mut r, 1), 30, s), wedge((0, 0), slope(&mut r, -1), 30, s)],
                // A stack.
                1 => (0..4).map(|i| rect(((-30 + i) * s, i * 5 * s), ((28 - i) * s, (i * 5 + 5) * s)).into()).collect(),
                _ => vec![wedge((-240, 0), slope(&mut r, 1), 40, s)],
            };
            r.shuffle(&mut shapes);
            let way = if k % 3 == 2 { Way::Rough(Surface::new(Ratio::ZERO, Ratio::ONE)) } else { Way::Slick };
            let mut play = Play { level: open(s), solids: listed(&shapes), gravity: gravity(&mut r, s), way };
            let at = if k % 3 == 2 { -120 * s } else { 0 };
            let body = play.over(&mut r, (at, -14 * s), 12 * s);
            let (mut rest, _) = play.settles(body).expect("it stays");
            let mut m = (0, 0);
            for frame in 0..frames(1_000) {
                if r.one_in(20) {
                    m = if r.one_in(3) { (0, 0) } else { (r.around(3 * s), r.around(3 * s)) };
                    // Back to the middle.
                    let at = raw(rest.0.position());
                    m = (if at.0 * m.0 > 0 { -m.0 } else { m.0 }, if at.1 * m.1 > 0 { -m.1 } else { m.1 });
                }
                for solid in &mut play.solids {
                    *solid = solid.with_motion(vec2(m)).unwrap();
                }
                // A slope that goes sideways sinks, too.
                let follow = Fx::from_bits(8 * s as i32);
                let ridden = UP.ride_convex(&play.level, &play.solids, &rest.0, follow).unwrap();
                assert_eq!(
                    (ridden.ride, ridden.motion),
                    (Ride::Carried, vec2(m)),
                    "{frame}: {rest:?} {:?}",
                    play.solids
                );
                Solid::move_all(&mut play.solids);
                rest.0 = ridden.body;
                assert_eq!(play.step(rest), rest, "{frame}: {:?}", play.solids);
                seen += u32::from(m != (0, 0));
            }
        }
    }
    assert!(seen > 1000);
}
