//! Bounces that would take no time: along a wall into a quarter pipe, and between facing surfaces.

use tilesat::{
    Aabb, AllShapes, Axis, Body, Circle, Fx, Mover, Ratio, Response, Surface, TileKind, TileKinds, TileMap, TileShape,
    Vec2, fx,
};
use tilesat_judge::{Random, cases};

const GRAVITY: Vec2 = Vec2::from_raw(0, 1 << 13);

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b')', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'7', TileKind::of(TileShape::SlopeTopRight))
    .with(b'r', TileKind::of(TileShape::SlopeTopLeft));

fn map(text: &'static str) -> TileMap<'static, AllShapes> {
    TileMap::of_ascii(text, &KINDS).unwrap()
}

fn bouncing(surface: Surface) -> Mover<Surface> {
    Mover::platformer(Axis::NEG_Y).with_response(Response::Bounce).with_surface(surface)
}

/// A body that falls along the wall or rolls along the floor goes through the pipe.
fn enters<B: Body + core::fmt::Debug>(body: B, v: Vec2, gravity: Vec2, surface: Surface) {
    let level = map("#...#\n#...#\n#...#\n#...#\n#..)#\n#####");
    let (mut now, mut speed) = (body, v);
    for frame in 0..200 {
        let moved = bouncing(surface).move_and_slide(&level, &now, speed + gravity).unwrap();
        let stuck = moved.body.position() == now.position() && (moved.velocity.length() > fx!(0.5));
        assert!(!stuck, "frame {frame}: {now:?} by {speed:?} from {body:?} by {v:?}");
        (now, speed) = (moved.body, moved.velocity);
        if now.aabb_of().max().y < fx!(16) {
            return; // up and out of the pipe
        }
    }
}

/// The bounding box of the two kinds of bodies here.
trait Bounds {
    fn aabb_of(&self) -> Aabb;
}

impl<B: Body> Bounds for B {
    fn aabb_of(&self) -> Aabb {
        Aabb::new(self.position(), self.position()).unwrap()
    }
}

#[test]
fn bounces_enter_quarter_pipes() {
    let mut r = Random::new(311);
    for _ in 0..cases(400) {
        let surface = Surface::new(
            [Ratio::ONE, Ratio::HALF, Ratio::percent(90).unwrap()][r.below(3) as usize],
            Ratio::percent(r.below(3) as u8 * 50).unwrap(),
        );
        let height = Fx::from_bits((r.within(20 << 16, 56 << 16)) as i32);
        let ball = Circle::new(Vec2::new(fx!(59), height), fx!(5)).unwrap();
        enters(ball, Vec2::ZERO, GRAVITY, surface);
        enters(ball, Vec2::from_ints(0, 2), Vec2::ZERO, surface);
        let box_ = Aabb::from_size(Vec2::new(fx!(54), height), Vec2::from_ints(10, 8)).unwrap();
        enters(box_, Vec2::ZERO, GRAVITY, surface);
        let rolls = Circle::new(Vec2::from_ints(30, 75), fx!(5)).unwrap();
        enters(rolls, Vec2::from_ints(2, 0), Vec2::ZERO, surface);
    }
}

fn advances<B: Body>(level: &TileMap<'_, AllShapes>, body: B, gravity: Vec2) {
    let (mut now, mut v) = (body, Vec2::from_ints(1, 2));
    for _ in 0..50 {
        let moved = bouncing(Surface::ELASTIC).move_and_slide(level, &now, v + gravity).unwrap();
        (now, v) = (moved.body, moved.velocity);
    }
    assert_eq!(now.position() - body.position(), Vec2::from_ints(50, 0));
    assert_eq!(v, Vec2::from_ints(1, 0));
}

/// In a corridor as high as the body, the part of the velocity across it is lost.
#[test]
fn bounces_between_facing_surfaces_end() {
    let flat = map("##########\n..........\n##########");
    let ball = Circle::new(Vec2::from_ints(24, 24), fx!(8)).unwrap();
    let box_ = Aabb::from_size(Vec2::from_ints(16, 16), Vec2::from_ints(10, 16)).unwrap();
    for gravity in [Vec2::ZERO, GRAVITY] {
        advances(&flat, ball, gravity);
        advances(&flat, box_, gravity);
    }
}

/// A corner of a floor and a wall returns what comes, at once.
#[test]
fn bounces_in_a_corner_are_kept() {
    let level = map("....#\n....#\n#####");
    let box_ = Aabb::from_size(Vec2::from_ints(40, 8), Vec2::from_ints(8, 8)).unwrap();
    let moved = bouncing(Surface::ELASTIC).move_and_slide(&level, &box_, Vec2::from_ints(20, 20)).unwrap();
    assert_eq!((moved.velocity, moved.hits.len()), (Vec2::from_ints(-20, -20), 2));
}
