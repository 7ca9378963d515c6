//! Seams of flush boxes: a ball or a capsule that moves over them behaves as on one floor. A corner
//! that sticks out still turns it aside.

use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{SceneBody, SceneTag, WithCapsules};
use tilesat::{Aabb, Capsule, Circle, Fx, Scene, TileMap, Vec2, fx};
use tilesat_judge::scenes::{BODIES, KINDS};

type Rolling = Scene<SortSweep<BODIES, SceneTag>, BODIES, 0, WithCapsules>;

/// The top of all floors.
const FLOOR: i16 = 64;

fn level(floor: bool) -> TileMap<'static> {
    static TILES: [&str; 2] = [
        "..............\n..............\n..............\n..............\n",
        "..............\n..............\n..............\n..............\n##############",
    ];
    TileMap::from_ascii(TILES[usize::from(floor)], &KINDS).unwrap()
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Floor {
    /// Of tiles: no seams.
    Tiles,
    /// Flush boxes of this width.
    Fixed(i16),
    /// Crates on a fixed box.
    Crates(i16),
}

#[derive(Clone, Copy, Debug)]
enum Roller {
    Ball,
    Standing,
    Lying,
}

#[derive(Clone, Copy, Debug)]
struct Roll {
    roller: Roller,
    radius: i16,
    speed: Fx,
    gravity: Fx,
    /// How far the body falls first.
    drop: Fx,
    /// To the left, among mirrored bodies.
    mirrored: bool,
}

fn aabb(x: i16, y: i16, width: i16, height: i16) -> Aabb {
    Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(width, height)).unwrap()
}

fn fixed(shape: Aabb, key: u32) -> SceneBody<WithCapsules> {
    SceneBody { mass: None, ..SceneBody::of(shape, key) }
}

impl Roll {
    fn turned(&self, v: Vec2) -> Vec2 {
        if self.mirrored { Vec2::new(-v.x, v.y) } else { v }
    }

    fn shape(&self, x: Fx) -> WithCapsules {
        let r = Fx::from(self.radius);
        let at = self.turned(Vec2::new(x, Fx::from(FLOOR) - r - self.drop));
        let along = |by: Vec2| Capsule::new(at, at + by, r).unwrap().into();
        match self.roller {
            Roller::Ball => Circle::new(at, r).unwrap().into(),
            Roller::Standing => along(Vec2::new(fx!(0), -r)),
            Roller::Lying => along(self.turned(Vec2::new(r, fx!(0)))),
        }
    }

    /// Boxes from x = 0 on. The key of the roller is in their middle, so it is `a` of some pairs.
    fn scene(&self, floor: Floor) -> (Rolling, Handle) {
        let mut scene = Rolling::new(SortSweep::new());
        let (width, crates) = match floor {
            Floor::Tiles => (0, false),
            Floor::Fixed(width) => (width, false),
            Floor::Crates(width) => (width, true),
        };
        let at = |x: i16, y: i16, width: i16| {
            let left = if self.mirrored { -x - width } else { x };
            aabb(left, y, width, 16)
        };
        let count = if width == 0 { 0 } else { 208 / width };
        for k in 0..count {
            let key = if self.mirrored { 100 - k } else { k } as u32;
            let body = fixed(at(k * width, FLOOR, width), key);
            scene.insert(&SceneBody { mass: NonZeroU8::new(u8::from(crates)), ..body }).unwrap();
        }
        if crates {
            scene.insert(&fixed(at(-16, FLOOR + 16, 240), 200)).unwrap();
        }
        let roller = scene.insert(&SceneBody::of(self.shape(fx!(33.3)), 10)).unwrap();
        scene.set_velocity(roller, self.turned(Vec2::new(self.speed, fx!(0)))).unwrap();
        (scene, roller)
    }

    /// Compares each step on a floor with seams with that on tiles.
    fn check(&self, floor: Floor) {
        let maps = [level(false), level(true)];
        // Tiles are not mirrored: there the body rolls to the right.
        let plain = Self { mirrored: false, ..*self };
        let ((mut scene, roller), (mut oracle, judge)) = (self.scene(floor), plain.scene(Floor::Tiles));
        let gravity = Vec2::new(fx!(0), self.gravity);
        let mut landed = self.drop == 0;
        for step in 0.. {
            scene.step(&maps[0], gravity, |_| {}).unwrap();
            oracle.step(&maps[1], gravity, |_| {}).unwrap();
            let (body, other) = (scene.body(roller).unwrap(), oracle.body(judge).unwrap());
            let (bounds, expected) = (body.shape.aabb(), other.shape.aabb());
            if expected.max().x >= fx!(176) {
                break;
            }
            let what = format!("{self:?} {floor:?} step {step}: {bounds:?} {}", body.velocity);
            let left = if self.mirrored { -bounds.max().x } else { bounds.min().x };
            assert_eq!(self.turned(body.velocity).x, other.velocity.x, "{what}");
            landed |= bounds.max().y >= FLOOR;
            assert!(!landed || bounds.max().y >= FLOOR, "{what}");
            // The mover rounds the place of a landing on tiles.
            assert!(self.drop > 0 || (left, bounds.max().y) == (expected.min().x, Fx::from(FLOOR)), "{what}");
        }
        assert!(landed, "{self:?} {floor:?}");
    }
}

fn rolls(roller: Roller, floors: &[Floor]) {
    for &floor in floors {
        for gravity in [fx!(0.1), fx!(0.25), fx!(0.5)] {
            for (speed, drop) in [(fx!(0.4), 0_i16), (fx!(0.9), 3), (fx!(1.7), 0), (fx!(2.3), 11), (fx!(2.9), 0)] {
                for radius in [3, 6, 10] {
                    for mirrored in [false, true] {
                        let drop = Fx::from(drop);
                        Roll { roller, radius, speed, gravity, drop, mirrored }.check(floor);
                    }
                }
            }
        }
    }
}

#[test]
fn a_ball_rolls_over_seams_as_over_tiles() {
    rolls(Roller::Ball, &[Floor::Fixed(8), Floor::Fixed(16), Floor::Crates(8), Floor::Crates(16)]);
}

#[test]
fn capsules_slide_over_seams_as_over_tiles() {
    for roller in [Roller::Standing, Roller::Lying] {
        rolls(roller, &[Floor::Fixed(8), Floor::Crates(16)]);
    }
}

/// Seen from above, a ball that hits a wall of boxes slides along it and keeps its speed.
#[test]
fn a_ball_slides_along_a_wall_of_boxes() {
    let map = level(false);
    for across in [false, true] {
        let turn = |v: Vec2| if across { Vec2::new(v.y, v.x) } else { v };
        for start in 0_i16..64 {
            let mut scene = Rolling::new(SortSweep::new());
            for k in 0..20 {
                let at = turn(Vec2::from_ints(k * 8, FLOOR));
                scene.insert(&fixed(Aabb::from_size(at, Vec2::from_ints(8, 8)).unwrap(), k as u32)).unwrap();
            }
            let at = turn(Vec2::new(fx!(20) + Fx::from(start) / 4, fx!(57)));
            let velocity = turn(Vec2::new(fx!(1.3), fx!(0.7)));
            let ball = SceneBody { velocity, ..SceneBody::of(Circle::new(at, fx!(5)).unwrap(), 10) };
            let ball = scene.insert(&ball).unwrap();
            for step in 0..60 {
                scene.step(&map, Vec2::ZERO, |_| {}).unwrap();
                let now = turn(scene.body(ball).unwrap().velocity);
                assert_eq!(now.x, fx!(1.3), "{across} {start} {step}");
                assert!(step < 5 || now.y == 0, "{across} {start} {step}");
            }
        }
    }
}

/// The game presses the ball into the wall in each step. At each seam the ball must meet the box
/// before it, not the corner behind it.
#[test]
fn a_ball_pressed_along_a_wall_of_boxes_keeps_its_speed() {
    let map = level(false);
    for side in 0..4 {
        let turn = |v: Vec2| match side {
            0 => v,
            1 => Vec2::new(v.x, -v.y),
            2 => Vec2::new(v.y, v.x),
            _ => Vec2::new(-v.y, v.x),
        };
        for (radius, width, press) in
            [(3_i16, 8, fx!(0.05)), (3, 16, fx!(0.25)), (5, 8, fx!(1)), (8, 8, fx!(0.1)), (8, 16, fx!(0.5))]
        {
            for (speed, start) in [fx!(0.7), fx!(1.3), fx!(2.1)].into_iter().flat_map(|v| (0..8).map(move |s| (v, s))) {
                let mut scene = Rolling::new(SortSweep::new());
                for k in 0..20 {
                    let corners = [Vec2::from_ints(k * width, FLOOR), Vec2::from_ints((k + 1) * width, FLOOR + 16)];
                    let [a, b] = corners.map(turn);
                    scene.insert(&fixed(Aabb::new(a.min(b), a.max(b)).unwrap(), k as u32)).unwrap();
                }
                let at = Vec2::new(fx!(24) + Fx::from_bits(start * 40_219), Fx::from(FLOOR - radius));
                let ball = Circle::new(turn(at), Fx::from(radius)).unwrap();
                let ball = SceneBody { velocity: turn(Vec2::new(speed, Fx::ZERO)), ..SceneBody::of(ball, 100) };
                let ball = scene.insert(&ball).unwrap();
                for step in 0..40 {
                    scene.push(ball, turn(Vec2::new(Fx::ZERO, press))).unwrap();
                    scene.step(&map, Vec2::ZERO, |_| {}).unwrap();
                    let (along, out) = (turn(Vec2::from_ints(1, 0)), turn(Vec2::from_ints(0, -1)));
                    let body = scene.body(ball).unwrap();
                    let what = format!("{side} {radius} {width} {press} {speed} {start} {step}: {body:?}");
                    let part = |of: Vec2| body.velocity.x * of.x + body.velocity.y * of.y;
                    assert!(part(along) == speed && part(out) <= Fx::ZERO, "{what}");
                    let height = body.shape.position().x * out.x + body.shape.position().y * out.y;
                    assert!(height + Fx::from(FLOOR - radius) > fx!(-0.07), "{what}");
                }
            }
        }
    }
}

/// A ball that comes down on a corner leaves it sideways, if no box beside it is as high.
#[test]
fn a_corner_that_sticks_out_counts() {
    let map = level(false);
    for beside in [None, Some(1), Some(6)] {
        for gap in [0, 3] {
            for offset in 1..4 {
                let mut scene = Rolling::new(SortSweep::new());
                scene.insert(&fixed(aabb(32, FLOOR, 16, 16), 1)).unwrap();
                if let Some(lower) = beside {
                    scene.insert(&fixed(aabb(16 - gap, FLOOR + lower, 16, 16), 2)).unwrap();
                }
                let ball = Circle::new(Vec2::from_ints(32 - offset, FLOOR - 9), fx!(8)).unwrap();
                let ball = scene.insert(&SceneBody::of(ball, 3)).unwrap();
                let mut least = Fx::ZERO;
                for _ in 0..30 {
                    scene.step(&map, Vec2::new(fx!(0), fx!(0.25)), |_| {}).unwrap();
                    least = least.min(scene.body(ball).unwrap().velocity.x);
                }
                assert!(least < fx!(-0.05), "{beside:?} {gap} {offset}: {least}");
            }
        }
    }
}
