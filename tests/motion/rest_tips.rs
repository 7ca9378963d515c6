//! Balls, and capsules that lie or stand, come to rest on two tips or arcs (P17), under gravities
//! of up to two of their radii per frame.
//!
//! In one frame of such a gravity a body leaves the first of the two by more than roundings, before
//! it meets the second one. What throws it up again is less than what gravity takes back in the
//! next frame, so it would hop on the spot for ever.

use std::collections::BTreeMap;
use std::fmt::Debug;
use tilesat::world::{ConvexSolids, World};
use tilesat::{AllShapes, Axis, Body, Capsule, ConvexPolygon, Fx, Joined, Mover, Outside, TileMap, Vec2};
use tilesat_judge::rooms::drawn;
use tilesat_judge::solids::shapes::{Any, Solid};
use tilesat_judge::solids::{P, disc, raw, vec2};
use tilesat_judge::{Random, cases};

const UP: Mover = Mover::platformer(Axis::NEG_Y);
/// Gravity per frame, in sixteenths of the smaller of the two radii.
const GRAVITIES: [i64; 10] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32];
const FRAMES: usize = 2_000;

/// How often bodies of a kind came to rest, and left over a tip.
type Seen = BTreeMap<(i64, &'static str), [u32; 2]>;

#[derive(Clone, Copy, Debug)]
struct Play<'a, W> {
    world: &'a W,
    gravity: i64,
    /// What is farther down has left.
    far: i64,
}

impl<W: World> Play<'_, W> {
    /// Whether it comes to rest. If not, it leaves.
    fn rests<B: Body + Copy + PartialEq + Debug>(&self, start: B) -> bool {
        let (mut body, mut v, mut last) = (start, Vec2::ZERO, Vec::new());
        for k in 0..FRAMES {
            let moved = UP.move_and_slide(self.world, &body, v + vec2((0, self.gravity))).unwrap();
            if (moved.body, moved.velocity) == (body, v) {
                return true;
            }
            (body, v) = (moved.body, moved.velocity);
            if raw(body.position()).1 > self.far {
                return false;
            }
            if k + 4 >= FRAMES {
                last.push((body.position(), v));
            }
        }
        panic!("hops: {start:?} by {}, at last {last:?}", self.gravity)
    }

    /// By its own type, and as any shape.
    fn both(&self, body: Any) -> bool {
        let rests = self.rests(body);
        match body {
            Any::Circle(it) => assert_eq!(self.rests(it), rests, "{it:?}"),
            Any::Capsule(it) => assert_eq!(self.rests(it), rests, "{it:?}"),
            _ => {}
        }
        rests
    }

    /// A body whose first centre is above a point, as low as there is room.
    fn over(&self, (x, mut y): P, radius: i64, (kind, core): (&str, i64)) -> Any {
        loop {
            let (a, r) = (vec2((x, y)), Fx::from_bits(radius as i32));
            let body = match kind {
                "ball" => disc((x, y), radius).into(),
                "lies" => Capsule::new(a, vec2((x + core, y)), r).unwrap().into(),
                _ => Capsule::new(a, vec2((x, y - core)), r).unwrap().into(),
            };
            if UP.move_and_slide(self.world, &body, vec2((0, 1))).is_ok() {
                return body;
            }
            y -= radius / 16 + 1;
        }
    }
}

/// A ball, or a capsule with a core of some length.
fn kind(r: &mut Random, radius: i64) -> (&'static str, i64) {
    (["ball", "lies", "stands"][r.below(3) as usize], radius * r.within(1, 24) / 4)
}

fn assert_most_rest(seen: &Seen) {
    for (of, [rests, leaves]) in seen {
        println!("{of:?}: {rests} rest, {leaves} leave");
        // The share of a few bodies says nothing.
        assert!(rests + leaves < 40 || 2 * rests > *leaves, "{of:?}: {rests} rest, {leaves} leave");
    }
    assert_eq!(seen.len(), 3 * GRAVITIES.len());
}

/// A solid whose top is the point `at`, or a round one with its top there.
fn solid(r: &mut Random, at: P, round: i64, deep: i64) -> Any {
    if round > 0 {
        return disc((at.0, at.1 + round), round).into();
    }
    let (left, right) = (r.within(deep / 16, deep / 4), r.within(deep / 16, deep / 4));
    let points = [at, (at.0 + right, at.1 + deep), (at.0 - left, at.1 + deep)].map(vec2);
    ConvexPolygon::<6>::hull(&points).unwrap().into()
}

/// Tips and rounds of any two heights and radii.
#[test]
fn p17_on_two_tips_or_rounds() {
    static NOTHING: tilesat::TileKinds = tilesat::TileKinds::EMPTY;
    let level = TileMap::from_ascii(".", &NOTHING).unwrap().with_outside(Outside::Empty);
    let (mut r, mut seen) = (Random::new(476), Seen::new());
    for _ in 0..cases(3_000) {
        let radius = [300, 6_202, 65_536, 500_000][r.below(4) as usize] + r.below(100);
        let rounds = [0, 1].map(|_| if r.one_in(2) { 0 } else { radius * r.within(1, 16) / 8 });
        let least = radius + rounds[0].min(rounds[1]);
        let (kind, core) = kind(&mut r, radius);
        let (apart, rise) = (least * r.within(1, 60) / 32, least * r.around(10) / 32);
        // A lying body touches the second one with its second end.
        let second = (apart + if kind == "lies" { core } else { 0 }, rise);
        let shapes =
            [((0, 0), rounds[0]), (second, rounds[1])].map(|(at, round)| solid(&mut r, at, round, 4 * least.max(core)));
        let solids: Vec<_> = shapes.iter().zip(1..).map(|(shape, key)| Solid::new(*shape, key).unwrap()).collect();
        let solids = ConvexSolids::new(&solids);
        let sixteenths = GRAVITIES[r.below(GRAVITIES.len() as i64) as usize];
        let far = 120 * radius + 4 * core;
        let play = Play { world: &Joined::new(&level, &solids), gravity: least * sixteenths / 16, far };
        let body = play.over((apart * r.within(6, 26) / 32, -radius / 4), radius, (kind, core));
        seen.entry((sixteenths, kind)).or_default()[usize::from(!play.both(body))] += 1;
    }
    assert_most_rest(&seen);
}

/// The same among tiles: the corners beside a gap, and a valley between two domes.
#[test]
fn p17_on_two_corners_or_domes_of_tiles() {
    let (mut r, mut seen) = (Random::new(477), Seen::new());
    for cell in [1 << 10, 1 << 16, 1 << 20] {
        let gap = drawn(&["....", "....", "#..#", "#..#"], cell, &[]);
        let domes = drawn(&["....", "....", "#db#", "####"], cell, &[('d', 13), ('b', 12)]);
        for n in 0..cases(1_000) {
            let (level, round): (TileMap<'_, AllShapes>, _) =
                if n % 2 == 0 { (gap.all(), 0) } else { (domes.all(), cell) };
            let level = level.with_outside(Outside::Empty);
            let radius = if n % 2 == 0 { cell * r.within(33, 64) / 32 } else { cell * r.within(2, 16) / 32 };
            let (kind, core) = if n % 2 == 0 { kind(&mut r, radius) } else { ("ball", 0) };
            let sixteenths = GRAVITIES[r.below(GRAVITIES.len() as i64) as usize];
            let play = Play { world: &level, gravity: (radius + round) * sixteenths / 16, far: 3 * cell };
            let x = cell + 2 * cell * r.within(6, 26) / 32 - if kind == "lies" { core / 2 } else { 0 };
            let body = play.over((x, cell), radius, (kind, core));
            seen.entry((sixteenths, kind)).or_default()[usize::from(!play.both(body))] += 1;
        }
    }
    assert_most_rest(&seen);
}
