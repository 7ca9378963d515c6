//! Rest in tiles of all shapes: bodies under gravity come to rest and stay (P17, torture scenes 40
//! and 49).
//!
//! A call depends only on the level, the body and the velocity. So a frame that returns its own
//! body and velocity repeats for ever. A few runs show it for `TILESAT_FRAMES` frames (default 20
//! 000, a million in the long run). Mirrored and shifted twins run beside each and must be its
//! images bit for bit (P5, P7). Whole cells, y down.

use tilesat::{Axis, Mover, Ratio, Surface};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, drawn, len2};
use tilesat_judge::shapes::level::Level;
use tilesat_judge::{Random, frames};

const UP: Mover = Mover::platformer(Axis::NEG_Y);
/// As in `motion_shape_scenes`; `d` and `b` are the sides of a dome, `s` and `S` steep slopes.
pub(super) const SHAPES: [(char, u8); 12] = [
    ('/', 8),
    ('\\', 9),
    ('l', 20),
    ('h', 24),
    ('L', 21),
    ('H', 25),
    (')', 16),
    ('(', 17),
    ('d', 13),
    ('b', 12),
    ('s', 29),
    ('S', 33),
];
const CELLS: [i64; 6] = [256, 1022, 4096, 65536, 1 << 20, 24 << 16];

pub(super) const V: [&str; 5] = ["......", r"\..../", r"#\../#", r"##\/##", "######"];
pub(super) const ASYMMETRIC_V: [&str; 4] = ["......", r"\...lh", r"#\lh##", "######"];
pub(super) const MILD_V: [&str; 4] = ["......", "HL..lh", "##HLlh", "######"];
pub(super) const STEEP_V: [&str; 4] = [".S..s.", ".#Ss#.", ".####.", "######"];
pub(super) const U: [&str; 4] = ["#....#", "#....#", "#....#", "######"];
const BOWL: [&str; 4] = ["#..#", "#..#", "#()#", "####"];
pub(super) const DOMES: [&str; 4] = ["#..#", "#..#", "#db#", "####"];
pub(super) const GAP: [&str; 4] = ["......", "......", "##..##", "##..##"];
const NARROW_GAP: [&str; 4] = [".....", ".....", "##.##", "##.##"];
pub(super) const SLOPE_AND_WALL: [&str; 6] = ["...#", "...#", r"\..#", r"#\.#", r"##\#", "####"];

fn cases() -> u32 {
    tilesat_judge::cases(60)
}

/// A body and its velocity.
type State = (Body, P);

fn seen(view: View, s: State) -> State {
    (view.body(s.0), view.direction(s.1))
}

struct Play {
    level: Level,
    room: Room,
    twins: [(View, Level); 3],
    gravity: i64,
    friction: Option<Surface>,
}

impl Play {
    fn new(level: &Level, gravity: i64) -> Self {
        let views = [View::MirrorX, View::MirrorY, View::Moved((12345, -678))];
        let twins = views.map(|view| (view, view.level(level)));
        Self { level: level.clone(), room: Room::new(level), twins, gravity, friction: None }
    }

    fn call(&self, level: &Level, up: P, body: Body, v: P) -> State {
        let mover = Mover::platformer(Axis::new(up.0 as i32, up.1 as i32));
        let out = match self.friction {
            None => body.step(&mover, &level.all(), v),
            Some(surface) => body.step_on(&mover.with_surface(surface), &level.all(), v),
        };
        let out = out.unwrap();
        (out.body, out.v)
    }

    fn step(&self, (body, v): State) -> State {
        let pulled = (v.0, v.1 + self.gravity);
        let next = self.call(&self.level, (0, -1), body, pulled);
        assert!(!self.room.overlaps(next.0, (0, 0), 0) && len2(next.1) <= len2(pulled), "{body:?} by {pulled:?}");
        next
    }

    /// The same in the twins' worlds.
    fn twins_agree(&self, (body, v): State, next: State) {
        for (view, level) in &self.twins {
            let (twin, tv) = seen(*view, (body, (v.0, v.1 + self.gravity)));
            let other = self.call(level, view.direction((0, -1)), twin, tv);
            assert_eq!(other, seen(*view, next), "{view:?}: {body:?} by {v:?} and {}", self.gravity);
        }
    }

    /// The frame from which on nothing changes.
    fn settles(&self, start: State, frames: u32) -> (u32, State) {
        self.settles_beside(start, frames, 100)
    }

    /// The same, and the twins agree in the first frames.
    fn settles_beside(&self, start: State, frames: u32, twins: u32) -> (u32, State) {
        let mut state = start;
        for k in 0..frames {
            let next = self.step(state);
            if k < twins {
                self.twins_agree(state, next);
            }
            if next == state {
                return (k, state);
            }
            state = next;
        }
        // A ball that rolls on a floor at some raw units per frame meets the wall much later.
        let (_, v) = state;
        if v.1 == 0 && self.step(state).1 == v {
            return (frames, state);
        }
        let rows: Vec<_> = self.level.tiles.chunks(self.level.width as usize).collect();
        panic!("moves on: {state:?}, from {start:?} by {}, cell {}\n{rows:?}", self.gravity, self.level.cell);
    }
}

fn level(rows: &[&str], cell: i64) -> Level {
    drawn(rows, cell, &SHAPES)
}

/// Bodies of some sizes, over the parts of the level from `from` to `to` (in eighths of a cell),
/// until enough have come to rest.
struct Drop<'a> {
    rows: &'a [&'a str],
    /// Half of a circle's width, or a box's width, at most, in eighths of a cell.
    largest: i64,
    from: P,
    to: P,
    friction: Option<Surface>,
    /// Circles or boxes alone.
    round: Option<bool>,
}

impl Drop<'_> {
    fn rest(&self, cells: &[i64]) {
        for &cell in cells {
            let level = level(self.rows, cell);
            let mut r = Random::new(cell as u64);
            let mut latest = 0;
            for n in 0..cases() {
                // A feather, and a stone. At least 16 raw, or rounding would be everything.
                let gravity = (cell >> r.within(3, 7)).max(16.min(cell >> 4));
                let play = Play { friction: self.friction, ..Play::new(&level, gravity) };
                let (body, v) = self.any(&mut r, &play, cell, self.round.unwrap_or(n % 2 == 0));
                let (k, _) = play.settles((body, v), 12_000);
                latest = latest.max(k);
            }
            println!("cell {cell}: at rest after {latest} frames at the latest");
        }
    }

    fn any(&self, r: &mut Random, play: &Play, cell: i64, round: bool) -> State {
        loop {
            let size = |r: &mut Random| cell / 8 + r.below(self.largest * cell / 8);
            let kind =
                if round { Body::Disc((0, 0), (size(r) / 2).max(1)) } else { Body::Rect((0, 0), (size(r), size(r))) };
            let at = |r: &mut Random, from: i64, to: i64| from * cell / 8 + r.below((to - from) * cell / 8);
            let body = kind.at((at(r, self.from.0, self.to.0), at(r, self.from.1, self.to.1)));
            // Not so slow that a slide over a floor takes all the time.
            let v = if r.one_in(2) { (0, 0) } else { (r.around(4) * cell / 16, r.around(4) * cell / 16) };
            if !play.room.overlaps(body, (0, 0), 0) {
                return (body, v);
            }
        }
    }
}

fn drop<'a>(rows: &'a [&'a str], largest: i64, from: P, to: P) -> Drop<'a> {
    Drop { rows, largest, from, to, friction: None, round: None }
}

#[test]
fn p17_rest_in_a_v() {
    drop(&V, 12, (0, 0), (48, 16)).rest(&CELLS);
}

#[test]
fn p17_rest_in_an_asymmetric_v() {
    drop(&ASYMMETRIC_V, 12, (0, 0), (48, 8)).rest(&CELLS);
}

#[test]
fn p17_rest_in_a_mild_v() {
    drop(&MILD_V, 8, (16, 0), (32, 8)).rest(&CELLS);
}

#[test]
fn p17_rest_in_a_steep_v() {
    drop(&STEEP_V, 8, (12, 0), (36, 4)).rest(&CELLS);
}

#[test]
fn p17_rest_in_a_u() {
    drop(&U, 16, (8, 0), (40, 16)).rest(&CELLS);
}

#[test]
fn p17_rest_between_a_slope_and_a_wall() {
    drop(&SLOPE_AND_WALL, 6, (8, 0), (24, 24)).rest(&CELLS);
}

/// On two corners, with a part between them.
#[test]
fn p17_rest_over_a_gap() {
    drop(&GAP, 24, (16, 0), (32, 8)).rest(&CELLS);
}

/// On corners so near that a ball that slides along one of them has left it by more than roundings
/// when it meets the other.
#[test]
fn p17_balls_rest_over_a_narrow_gap() {
    let mut r = Random::new(17);
    for cell in CELLS {
        let level = level(&NARROW_GAP, cell);
        for _ in 0..10 * cases() {
            let play = Play::new(&level, 16 + r.below(cell / 16));
            let radius = cell / 2 + 1 + r.below(cell / 2);
            let ball = Body::Disc((2 * cell + r.below(cell), 2 * cell - radius), radius);
            // No twins: a ball in the middle meets both corners at once, and +x is first in the
            // mirror too.
            play.settles_beside((ball, (r.around(cell / 8), 0)), 12_000, 0);
        }
    }
}

/// A valley between two domes.
#[test]
fn p17_rest_on_domes() {
    drop(&DOMES, 12, (8, 0), (24, 16)).rest(&CELLS);
}

/// Boxes only: each of their corners is in a quarter pipe. A circle without friction swings.
#[test]
fn p17_boxes_rest_in_a_bowl() {
    let boxes = Drop { round: Some(false), ..drop(&BOWL, 14, (8, 0), (24, 16)) };
    boxes.rest(&CELLS);
}

/// With friction the single slope, the bowl and the floor hold a body too.
#[test]
fn p17_rest_with_friction() {
    let slope = [r"\....", r"#\...", r"##\..", "######"];
    let rough = Some(Surface::new(Ratio::ZERO, Ratio::ONE));
    for rows in [&slope[..], &BOWL, &ASYMMETRIC_V, &U, &DOMES] {
        let width = rows[0].len() as i64;
        Drop { friction: rough, ..drop(rows, 4, (8, 0), (8 * width - 8, 8)) }.rest(&[4096, 65536, 24 << 16]);
    }
}

/// A ball rolls to and fro in a bowl. It never gets higher than before.
#[test]
fn a_ball_swings_in_a_bowl() {
    let frames = frames(20_000);
    for (cell, r) in [(65536, 10_000), (1 << 20, 300_000), (24 << 16, 200_000)] {
        let play = Play::new(&level(&BOWL, cell), cell / 64);
        let start = Body::Disc((cell + r, 2 * cell), r);
        let (mut state, mut top) = ((start, (0, 0)), vec![i64::MAX; 8]);
        for k in 0..frames {
            state = play.step(state);
            let part = &mut top[(8 * k / frames) as usize];
            *part = (*part).min(state.0.position().1);
        }
        println!("cell {cell}: {:?}", top.iter().map(|y| y - 2 * cell).collect::<Vec<_>>());
        // Gravity acts once per frame: heights of frames differ by the fall of a frame.
        assert!(top.iter().all(|&y| y >= 2 * cell - play.gravity), "higher than at the start: {top:?}");
        assert!(top[1] < 3 * cell, "{top:?}");
    }
}

/// Bodies that the game's velocity pushes into a corner, frame after frame. A single one ends in
/// it, to the raw unit.
#[test]
fn p17_pushed_into_a_corner() {
    let rows = ["...#", "...#", "...#", "####"];
    let mut r = Random::new(5);
    for cell in CELLS {
        let level = level(&rows, cell);
        let play = Play::new(&level, 0);
        for k in 0..40 {
            let kind = if k % 2 == 0 { Body::Disc((0, 0), cell / 3) } else { Body::Rect((0, 0), (cell / 3, cell / 5)) };
            let push = (cell / 64 + r.magnitude(cell), cell / 64 + r.magnitude(cell));
            let mut body = kind.at((cell / 2 + r.below(cell), cell / 2 + r.below(cell)));
            for _ in 0..3 * cell / push.0.min(push.1) + 2 {
                body = play.call(&play.level, (0, -1), body, push).0;
            }
            assert_eq!(body.bounds().1, (3 * cell, 3 * cell), "{push:?}");
            let again = play.call(&play.level, (0, -1), body, push);
            play.twins_agree((body, push), again);
            assert_eq!(again, (body, (0, 0)));
        }
    }
}

/// Torture scene 38: four bodies pushed into one corner, and out of each other by half of their
/// depth, each from the positions at the start of the frame. No body enters the wall, and the order
/// of the bodies does not matter.
#[test]
fn scene_38_a_stack_in_a_corner() {
    use tilesat::prelude::*;
    use tilesat::{Circle, Fx};
    let level = level(&["...#", "...#", "...#", "####"], 65536);
    let play = Play::new(&level, 0);
    let radius = [9000, 11_000, 14_000, 14_000];
    let run = |order: [usize; 4]| {
        let mut at: [P; 4] = [(150_000, 150_000), (120_000, 150_000), (150_000, 110_000), (100_000, 100_000)];
        let mut last = at;
        for frame in 0..2000 {
            let circle = |k: usize| {
                let c = tilesat::Vec2::from_raw(at[k].0 as i32, at[k].1 as i32);
                Circle::new(c, Fx::from_bits(radius[k])).unwrap()
            };
            let mut next = at;
            for &k in &order {
                let mut push = (600, 400);
                for other in (0..4).filter(|&other| other != k) {
                    if let Some(contact) = circle(k).contact(&circle(other)) {
                        let (x, y) = contact.push_out().raw();
                        push = (push.0 + i64::from(x / 2), push.1 + i64::from(y / 2));
                    }
                }
                next[k] = play.step((Body::Disc(at[k], radius[k].into()), push)).0.position();
            }
            (last, at) = (at, next);
            assert!(frame < 1000 || at.iter().zip(&last).all(|(a, b)| (a.0 - b.0).abs().max((a.1 - b.1).abs()) <= 2));
        }
        (last, at)
    };
    let ends = run([0, 1, 2, 3]);
    println!("{ends:?}");
    for order in [[3, 2, 1, 0], [1, 3, 0, 2], [2, 0, 3, 1]] {
        assert_eq!(run(order), ends);
    }
}

/// The same rest for as many frames as are asked for.
#[test]
fn p17_a_million_frames_of_rest() {
    let rough = Surface::new(Ratio::ZERO, Ratio::ONE);
    let slope = [r"\....", r"#\...", r"##\..", "######"];
    let cell = 65536;
    for (rows, friction) in [
        (&V[..], None),
        (&ASYMMETRIC_V, None),
        (&U, None),
        (&DOMES, None),
        (&SLOPE_AND_WALL, None),
        (&slope, Some(rough)),
        (&BOWL, Some(rough)),
    ] {
        let level = level(rows, cell);
        for kind in [Body::Disc((0, 0), 20_000), Body::Rect((0, 0), (30_000, 20_011))] {
            let play = Play { friction, ..Play::new(&level, cell / 64) };
            let x = cell + cell / 3;
            let start =
                (0..8 * 3).map(|k| kind.at((x, k * cell / 8 - cell / 4))).find(|b| !play.room.overlaps(*b, (0, 0), 0));
            let (_, rest) = play.settles((start.unwrap(), (cell / 16, 0)), 2000);
            let all = level.all();
            for _ in 0..frames(20_000) {
                let next = match friction {
                    None => rest.0.step(&UP, &all, (rest.1.0, rest.1.1 + play.gravity)),
                    Some(rough) => rest.0.step_on(&UP.with_surface(rough), &all, (rest.1.0, rest.1.1 + play.gravity)),
                };
                let next = next.unwrap();
                assert_eq!((next.body, next.v), rest);
            }
        }
    }
}
