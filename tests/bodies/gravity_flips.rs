//! Characters whose gravity turns while they stand, fly and ride.

use tilesat::{
    Aabb, Character, Circle, Feel, Fx, Input, SlopeSpeed, Slopes, Solid, TileKind, TileKinds, TileMap, TileShape, Vec2,
    fx, motion::OnLeave,
};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft));

const ROOM: &str = "##########\n..........\n..........\n..........\n..../#\\...\n##########";

fn level() -> TileMap<'static, Slopes> {
    TileMap::of_ascii(ROOM, &KINDS).unwrap()
}

fn flip<B: tilesat::Body>(hero: &mut Character<B>) {
    hero.feel.gravity = -hero.feel.gravity;
}

/// In the frame of the turn it flies: it keeps its run, and gravity acts at once. On the flat floor
/// exactly so, with both speeds on slopes; on a slope to its own side.
#[test]
fn a_flip_keeps_the_run() {
    let level = level();
    for slope_speed in [SlopeSpeed::Constant, SlopeSpeed::Projected] {
        for run in [fx!(1.5), fx!(-1.5)] {
            for frames in 1..60 {
                let feel = Feel { slope_speed, ..Feel::DEFAULT };
                let x = if run > 0 { 8 } else { 152 };
                let body = Aabb::from_size(Vec2::from_ints(x - 5, 66), Vec2::from_ints(10, 14)).unwrap();
                let mut hero = Character::new(body, level.bounds(), feel);
                for _ in 0..frames {
                    let _ = hero.step(&level, Input::running(run)).unwrap();
                }
                let (at, before) = (hero.position(), hero.velocity);
                let Some(floor) = hero.floor() else { continue };
                flip(&mut hero);
                let step = hero.step(&level, Input::running(run)).unwrap();
                let made = hero.position() - at;
                assert!(!hero.on_floor() && !step.landed, "{frames} {run}");
                assert_eq!(made.x.signum(), run.signum(), "{frames} {run}: {made}");
                if floor.axis.x == 0 && before.x == run && step.hits.is_empty() {
                    assert_eq!((made, hero.velocity), (Vec2::new(run, fx!(-0.25)), made), "{frames}");
                }
            }
        }
    }
}

/// The ceiling is a floor then, on which it runs, jumps away from it, and from which it flips back.
#[test]
fn it_lands_on_the_ceiling_and_jumps_from_there() {
    let level = level();
    let body = Circle::new(Vec2::from_ints(20, 74), fx!(6)).unwrap();
    let mut hero = Character::new(body, level.bounds(), Feel::DEFAULT);
    for round in 0..6 {
        while !hero.on_floor() {
            let _ = hero.step(&level, Input::default()).unwrap();
        }
        let y = hero.position().y;
        let away = if round % 2 == 0 { fx!(-1) } else { fx!(1) };
        assert_eq!(y, if round % 2 == 0 { fx!(74) } else { fx!(22) });
        let step = hero.step(&level, Input { jump: true, ..Input::default() }).unwrap();
        assert!(step.jumped && (hero.position().y - y).signum() == away, "{round}");
        while !hero.on_floor() {
            let _ = hero.step(&level, Input::default()).unwrap();
        }
        flip(&mut hero);
        let _ = hero.step(&level, Input::default()).unwrap();
    }
}

/// A press in the frame of the turn, or in the frames of coyote time after it, is no jump off the
/// old floor. It waits for the next floor.
#[test]
fn a_flip_ends_coyote_time() {
    let level = level();
    for wait in 0..5 {
        let body = Aabb::from_size(Vec2::from_ints(20, 66), Vec2::from_ints(10, 14)).unwrap();
        let mut hero = Character::new(body, level.bounds(), Feel::DEFAULT);
        for _ in 0..3 {
            let _ = hero.step(&level, Input::default()).unwrap();
        }
        flip(&mut hero);
        for frame in 0..8 {
            let step = hero.step(&level, Input { jump: frame >= wait, ..Input::default() }).unwrap();
            assert!(!step.jumped && !step.ceiling, "{wait} {frame}");
        }
    }
}

/// What leaves a lift by a turn of gravity keeps the lift's motion, as by a jump.
#[test]
fn a_flip_leaves_a_lift_with_its_motion() {
    let (empty, room) = (TileMap::from_ascii("..", &TileKinds::EMPTY).unwrap(), Vec2::from_ints(900, 900));
    let room = Aabb::new(-room, room).unwrap();
    for (x, y) in [(2, 0), (-3, -1), (1, 1), (0, -2)] {
        for on_leave in [OnLeave::Keep, OnLeave::Add] {
            let feel = Feel { on_leave, air_acceleration: Fx::ZERO, ..Feel::DEFAULT };
            let body = Aabb::from_size(Vec2::from_ints(20, -14), Vec2::from_ints(10, 14)).unwrap();
            let mut hero = Character::new(body, room, feel);
            let mut lift = [Solid::new(Aabb::from_size(Vec2::ZERO, Vec2::from_ints(64, 4)).unwrap(), 1).unwrap()];
            let motion = Vec2::from_ints(x, y) / fx!(2);
            for frame in 0..12 {
                lift[0].set_motion(motion).unwrap();
                if frame == 6 {
                    flip(&mut hero);
                }
                let at = hero.position();
                let _ = hero.step_on(&empty, &mut lift, Input::default()).unwrap();
                if frame >= 6 {
                    let gravity = Vec2::new(Fx::ZERO, fx!(-0.25) * (frame - 5));
                    assert_eq!((hero.position() - at, hero.ridden()), (motion + gravity, None), "{x} {y} {frame}");
                } else if frame > 2 {
                    assert_eq!((hero.position() - at, hero.ridden()), (motion, Some(1)), "{x} {y} {frame}");
                }
            }
        }
    }
}

/// Without gravity, "up" is where it was, even before the first step.
#[test]
fn a_ladder_before_the_first_step() {
    let level = level();
    for stepped in [false, true] {
        let body = Aabb::from_size(Vec2::from_ints(20, 16), Vec2::from_ints(10, 14)).unwrap();
        let mut hero = Character::new(body, level.bounds(), Feel { gravity: fx!(-0.25), ..Feel::DEFAULT });
        if stepped {
            let _ = hero.step(&level, Input::default()).unwrap();
        }
        hero.feel.gravity = Fx::ZERO;
        hero.velocity.y = fx!(-1);
        let step = hero.step(&level, Input::default()).unwrap();
        assert!(hero.on_floor() && !step.ceiling, "{stepped}");
    }
}
