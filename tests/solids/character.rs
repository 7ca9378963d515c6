//! The hero of a platformer against closed forms: jumps, their graces, floors through which it
//! drops, and ways out of a level.

use tilesat::{
    Aabb, Axis, Character, Feel, Fx, Input, Mover, Outcome, Quantity, RangeError, Slopes, Step, TileKind, TileKinds,
    TileMap, TileShape, Vec2, Walker, fx,
};
use tilesat_judge::Random;

pub(super) static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'=', TileKind::ONE_WAY_UP);
static HILLS: TileKinds =
    TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'/', TileKind::of(TileShape::SlopeBottomRight));
pub(super) const NOTHING: Input = Input { run: Fx::ZERO, jump: false, drop: false };
pub(super) const JUMP: Input = Input { jump: true, ..NOTHING };
const DROP: Input = Input { drop: true, ..NOTHING };
const RIGHT: Input = Input { run: fx!(2), ..NOTHING };

pub(super) fn boxed(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap()
}

pub(super) fn limits() -> Aabb {
    boxed(-1000, -1000, 3000, 3000)
}

/// 20 cells wide, with a floor at y = 160 in x of 0 to 160.
pub(super) fn ledge() -> TileMap<'static> {
    const ROWS: &str = "                    \n                    \n                    \n                    \n                    \n\
                        \x20                   \n                    \n                    \n                    \n                    \n\
                        ##########          \n";
    TileMap::from_ascii(ROWS, &KINDS).unwrap()
}

/// A hero of 10 by 14 that stands on the ledge with its feet at `x`.
fn standing(x: i16, feel: Feel) -> Character {
    let mut hero = Character::new(boxed(x - 5, 146, 10, 14), limits(), feel);
    for _ in 0..10 {
        let _ = hero.step(&ledge(), NOTHING).unwrap();
    }
    assert!(hero.on_floor() && hero.body().max().y == 160 && hero.velocity == Vec2::ZERO);
    hero
}

#[test]
fn a_jump_rises_by_the_sum_of_its_speeds() {
    for (gravity, n) in [(16_384, 18), (16_384, 4), (9_999, 20), (40_000, 9), (1, 30)] {
        let feel = Feel { gravity: Fx::from_bits(gravity), jump: Fx::from_bits(gravity * n), ..Feel::DEFAULT };
        let mut hero = standing(80, feel);
        let floor = hero.body().min().y;
        let mut apex = 0;
        for frame in 1..=n + 1 {
            let step = hero.step(&ledge(), JUMP).unwrap();
            assert_eq!((step.jumped, step.outcome), (frame == 1, Outcome::Moved));
            let rise = (floor - hero.body().min().y).to_bits();
            assert_eq!(rise > apex, frame <= n, "{gravity} {n} {frame}");
            apex = apex.max(rise);
        }
        assert_eq!(apex, gravity * n * (n + 1) / 2);
        // The button is still down. It lands, and does not jump again.
        let landings = (0..2 * n + 4).filter(|_| hero.step(&ledge(), JUMP).unwrap().landed).count();
        assert_eq!((landings, hero.body().min().y), (1, floor));
    }
}

#[test]
fn gravity_upward_is_the_mirror_image() {
    let level = ledge();
    let (width, height) = (20, 11);
    let mirrored: String = (0..height)
        .rev()
        .flat_map(|y| {
            (0..=width).map(move |x| {
                if x == width {
                    '\n'
                } else if y == 10 && x < 10 {
                    '#'
                } else {
                    ' '
                }
            })
        })
        .collect();
    let mirrored = TileMap::from_ascii(&mirrored, &KINDS).unwrap();
    let flip = |b: &Aabb| {
        let (lo, hi) = (b.min(), b.max());
        let y = Fx::from_num(16 * height);
        Aabb::new(Vec2::new(lo.x, y - hi.y), Vec2::new(hi.x, y - lo.y)).unwrap()
    };
    let start = boxed(60, 100, 10, 14);
    let mut down = Character::new(start, limits(), Feel::DEFAULT);
    let feel = Feel { gravity: -Feel::DEFAULT.gravity, ..Feel::DEFAULT };
    let mut up = Character::new(flip(&start), limits(), feel);
    let mut random = Random::new(3);
    for frame in 0..600 {
        let run = Fx::from_num(random.around(2));
        let input = Input { run, jump: random.below(3) != 0, drop: random.below(20) == 0 };
        let (a, b) = (down.step(&level, input).unwrap(), up.step(&mirrored, input).unwrap());
        assert_eq!((a.outcome, a.jumped, a.landed, a.wall), (b.outcome, b.jumped, b.landed, b.wall), "{frame}");
        assert_eq!((*up.body(), up.velocity.x), (flip(down.body()), down.velocity.x), "{frame}");
    }
}

#[test]
fn coyote_frames_are_counted() {
    for coyote in 0..9 {
        for late in 1..12_u8 {
            let feel = Feel { coyote, buffer: 0, ..Feel::DEFAULT };
            let mut hero = standing(150, feel);
            while hero.on_floor() {
                let _ = hero.step(&ledge(), RIGHT).unwrap();
            }
            for _ in 1..late {
                assert!(!hero.step(&ledge(), RIGHT).unwrap().jumped);
            }
            let step = hero.step(&ledge(), Input { jump: true, ..RIGHT }).unwrap();
            assert_eq!(step.jumped, late <= coyote, "{coyote} {late}");
            // No second jump in the air.
            let _ = hero.step(&ledge(), RIGHT).unwrap();
            assert!(!hero.step(&ledge(), JUMP).unwrap().jumped || late > coyote);
        }
    }
}

/// The longest times end, too: nothing jumps for ever.
#[test]
fn the_longest_graces_end() {
    for coyote in 250..=u8::MAX {
        let feel = Feel { coyote, wall_jump: Some(fx!(1)), fall: fx!(0.5), gravity: fx!(0.125), ..Feel::DEFAULT };
        let mut hero = Character::new(boxed(60, 0, 10, 14), limits(), feel);
        assert!(!hero.step(&ledge(), JUMP).unwrap().jumped, "it has never stood");
        // A wall from x = 160 on, which ends below.
        let level = TileMap::from_ascii("          #", &KINDS).unwrap();
        for late in 250..260 {
            let mut hero = Character::new(boxed(150, 0, 10, 14), limits(), feel);
            let _ = hero.step(&level, RIGHT).unwrap();
            let left = Input { run: fx!(-1), ..NOTHING };
            for _ in 1..late {
                assert!(!hero.step(&level, left).unwrap().wall);
            }
            let wall = hero.wall().is_some();
            let jumped = hero.step(&level, Input { jump: true, ..left }).unwrap().jumped;
            assert_eq!((wall, jumped), (late <= u32::from(coyote.min(253)) + 1, wall), "{coyote} {late}");
        }
    }
}

#[test]
fn a_press_before_the_landing_counts_for_the_buffer() {
    let fall = |press: u32, feel| {
        let mut hero = Character::new(boxed(60, 100, 10, 14), limits(), feel);
        let mut landed = None;
        for frame in 0.. {
            let step = hero.step(&ledge(), if frame == press { JUMP } else { NOTHING }).unwrap();
            landed = landed.or(step.landed.then_some(frame));
            if step.jumped {
                return (landed, Some(frame));
            }
            if frame > 80 {
                return (landed, None);
            }
        }
        unreachable!()
    };
    for buffer in 0..8 {
        let feel = Feel { buffer, ..Feel::DEFAULT };
        let landed = fall(999, feel).0.unwrap();
        for press in landed - 12..landed + 3 {
            // The first frame in which it can jump is the one after the landing.
            let jump = if press > landed { press } else { landed + 1 };
            let expected = (jump - press <= u32::from(buffer)).then_some(jump);
            assert_eq!(fall(press, feel), (Some(landed), expected), "{buffer}: {press} {landed}");
        }
    }
}

#[test]
fn a_released_button_cuts_the_jump() {
    let Feel { gravity, jump, jump_cut, .. } = Feel::DEFAULT;
    let (g, j, cut) = (gravity.to_bits(), jump.to_bits(), jump_cut.to_bits());
    for released in 1..25 {
        let mut hero = standing(80, Feel::DEFAULT);
        let floor = hero.body().min().y;
        let (mut speed, mut rise, mut apex) = (j + g, 0, 0);
        for frame in 0..60 {
            speed -= g;
            if frame >= released && speed > cut {
                speed = cut;
            }
            rise += speed;
            apex = apex.max(rise);
            let _ = hero.step(&ledge(), if frame < released { JUMP } else { NOTHING }).unwrap();
            if rise > 0 {
                assert_eq!((floor - hero.body().min().y).to_bits(), rise, "{released} {frame}");
            }
        }
        let full = j / g * (j / g + 1) / 2 * g;
        assert_eq!(apex < full, released < 12, "{released}");
        assert!(hero.on_floor());
    }
    // A spring is no jump: nothing cuts it.
    let mut hero = standing(80, Feel::DEFAULT);
    hero.velocity.y = fx!(-4);
    let _ = hero.step(&ledge(), NOTHING).unwrap();
    assert_eq!(hero.velocity.y, fx!(-3.75));
}

#[test]
fn drops_through_one_way_floors_and_no_others() {
    let level = TileMap::from_ascii("    \n    \n====\n    \n    \n####\n    \n", &KINDS).unwrap();
    let mut hero = Character::new(boxed(20, 10, 10, 14), limits(), Feel::DEFAULT);
    for _ in 0..60 {
        let _ = hero.step(&level, NOTHING).unwrap();
    }
    assert!(hero.floor().is_some_and(|floor| floor.one_way) && hero.body().max().y == 32);
    assert_eq!(hero.step(&level, DROP).unwrap().outcome, Outcome::Moved);
    assert!(!hero.on_floor());
    assert!(!hero.step(&level, JUMP).unwrap().jumped); // dropping is not walking off
    for frame in 0..120 {
        let _ = hero.step(&level, if frame > 60 { DROP } else { NOTHING }).unwrap();
    }
    assert!(hero.floor().is_some_and(|floor| !floor.one_way) && hero.body().max().y == 80);
}

#[test]
fn falling_out_is_an_answer() {
    let level = TileMap::from_ascii("    \n    \n    \n##  \n", &KINDS).unwrap();
    let limits = Aabb::new(level.origin(), level.grid().end()).unwrap();
    let (gravity, limit) = (Feel::DEFAULT.gravity.to_bits(), Feel::DEFAULT.fall.to_bits());
    for x in [40, -30, 70] {
        let body = boxed(x, 4, 10, 14);
        let mut hero = Character::new(body, limits, Feel::DEFAULT);
        let (mut speed, mut y) = (0, 4 << 16);
        for frame in 0.. {
            speed = (speed + gravity).min(limit);
            y += speed;
            let step = hero.step(&level, NOTHING).unwrap();
            assert_eq!(hero.body().min().y.to_bits(), y);
            let out = y > 64 << 16 || !(-10..=64).contains(&x);
            assert_eq!(step.outcome, if out { Outcome::OutOfLevel } else { Outcome::Moved }, "{x} {frame}");
            if out {
                break;
            }
        }
    }
    // Above the level is not outside. At the end of the domain only the range error is left.
    let above = boxed(40, -900, 10, 14);
    assert_eq!(Character::new(above, limits, Feel::DEFAULT).step(&level, NOTHING).unwrap().outcome, Outcome::Moved);
    let far = Aabb::new(Vec2::from_ints(40, 8100), Vec2::from_ints(50, 8190)).unwrap();
    let everywhere = Aabb::new(Vec2::from_ints(-8191, -8191), Vec2::from_ints(8191, 8191)).unwrap();
    let mut hero = Character::new(far, everywhere, Feel::DEFAULT);
    let outcomes: Vec<_> = (0..9).map(|_| hero.step(&level, NOTHING).unwrap().outcome).collect();
    assert_eq!((outcomes[0], outcomes[8]), (Outcome::Moved, Outcome::OutOfLevel));
}

#[test]
fn slides_down_walls_and_jumps_off_them() {
    // A shaft from x = 16 to 64, far above its floor.
    let rows = "#   #\n".repeat(30);
    let level = TileMap::from_ascii(&rows, &KINDS).unwrap();
    let feel = Feel { wall_jump: Some(fx!(3)), wall_slide: Some(fx!(1)), ..Feel::DEFAULT };
    for side in [1, -1] {
        let toward = Input { run: fx!(2) * Fx::from_num(side), ..NOTHING };
        let mut hero = Character::new(boxed(35, 100, 10, 14), limits(), feel);
        while !hero.step(&level, toward).unwrap().wall {}
        let _ = hero.step(&level, toward).unwrap();
        for _ in 0..20 {
            let y = hero.body().min().y;
            assert!(hero.step(&level, toward).unwrap().wall);
            assert_eq!(hero.body().min().y - y, 1);
            assert_eq!(hero.wall(), Some(Axis::new(-side, 0)));
        }
        // Without running against it, it falls.
        let mut falls = hero;
        let _ = falls.step(&level, NOTHING).unwrap();
        assert_eq!(falls.velocity.y, fx!(1.25));
        for late in 1..10_u8 {
            let mut hero = hero;
            for _ in 1..late {
                let _ = hero.step(&level, NOTHING).unwrap();
            }
            let wall = hero.wall();
            let step = hero.step(&level, JUMP).unwrap();
            let jumps = late <= feel.coyote + 1;
            assert_eq!(step.jumped, jumps, "{late}");
            assert_eq!(wall, jumps.then_some(Axis::new(-side, 0)), "it is told while it can be used");
            if jumps {
                assert_eq!(hero.velocity, Vec2::new(fx!(-3) * Fx::from_num(side), -feel.jump));
                assert_eq!(hero.wall(), None, "it has jumped off it");
            }
        }
        // Without the option there is no such jump.
        let mut plain = hero;
        plain.feel.wall_jump = None;
        assert!(!plain.step(&level, Input { jump: true, ..toward }).unwrap().jumped);
    }
}

#[test]
fn a_closed_door_is_told_and_left() {
    let open = TileMap::from_ascii("   \n###", &KINDS).unwrap();
    let closed = TileMap::from_ascii(" # \n###", &KINDS).unwrap();
    let mut hero = Character::new(boxed(20, 2, 10, 14), limits(), Feel::DEFAULT);
    for _ in 0..3 {
        assert_eq!(hero.step(&open, RIGHT).unwrap().outcome, Outcome::Moved);
    }
    let before = *hero.body();
    assert_eq!(hero.step(&closed, RIGHT).unwrap().outcome, Outcome::Stuck);
    assert_eq!(*hero.body(), before);
    hero.place(boxed(2, 2, 10, 14));
    assert_eq!(hero.step(&closed, RIGHT).unwrap().outcome, Outcome::Moved);
}

#[test]
fn walks_as_the_pieces_do_and_a_copy_is_a_snapshot() {
    let rows = "            \n            \n      /##   \n ////##     \n############\n";
    let level = TileMap::<Slopes>::of_ascii(rows, &HILLS).unwrap();
    let Feel { snap, step, slope_speed, .. } = Feel::DEFAULT;
    let walker = Walker::new(Mover::platformer(Axis::NEG_Y)).with_slope_speed(slope_speed);
    let walker = walker.with_snap(snap).unwrap().with_step(step).unwrap();
    let mut hero = Character::new(boxed(4, 40, 10, 14), limits(), Feel { acceleration: fx!(9), ..Feel::DEFAULT });
    while !hero.on_floor() {
        let _ = hero.step(&level, NOTHING).unwrap();
    }
    let (mut body, mut floor) = (*hero.body(), hero.floor());
    let saved = hero;
    let mut ways = [Vec::new(), Vec::new()];
    for frame in 0..60 {
        let walked = walker.walk(&level, &body, Vec2::new(RIGHT.run, Feel::DEFAULT.gravity), floor).unwrap();
        (body, floor) = (walked.moved.body, walked.floor);
        let step = hero.step(&level, RIGHT).unwrap();
        ways[0].push((step, hero));
        if floor.is_none() {
            break;
        }
        assert_eq!((*hero.body(), hero.floor(), step.hits), (body, floor, walked.moved.hits), "{frame}");
    }
    assert!(ways[0].len() > 20);
    hero = saved;
    ways[1].extend((0..ways[0].len()).map(|_| (hero.step(&level, RIGHT).unwrap(), hero)));
    assert_eq!(ways[0], ways[1]);
}

#[test]
fn wrong_input_is_refused_and_changes_nothing() {
    let level = ledge();
    let hero = standing(80, Feel::DEFAULT);
    let bad = |hero: Character, input: Input| -> Option<Quantity> {
        let mut after = hero;
        let refused: Result<Step, RangeError> = after.step(&level, input);
        assert!(refused.is_ok() || after == hero);
        refused.err().map(|e| e.what)
    };
    let with = |feel| {
        let mut other = hero;
        other.feel = feel;
        other
    };
    let base = Feel { acceleration: Fx::MAX, ..Feel::DEFAULT };
    assert_eq!(bad(with(base), Input { run: fx!(4096), ..NOTHING }), Some(Quantity::MotionX));
    assert_eq!(bad(with(base), Input { run: Fx::MIN, ..NOTHING }), Some(Quantity::MotionX));
    assert_eq!(bad(with(base), Input { run: fx!(4095), ..NOTHING }), None);
    assert_eq!(bad(with(Feel { jump: Fx::MAX, ..base }), JUMP), Some(Quantity::MotionY));
    assert_eq!(bad(with(Feel { snap: fx!(-1), ..base }), NOTHING), Some(Quantity::Snap));
    assert_eq!(bad(with(Feel { step: Fx::MAX, ..base }), NOTHING), Some(Quantity::StepHeight));
    let signed = [
        (Feel { fall: fx!(-6), ..base }, Quantity::Fall, fx!(-6)),
        (Feel { jump: fx!(-4.5), ..base }, Quantity::Jump, fx!(-4.5)),
        (Feel { jump_cut: -Fx::DELTA, ..base }, Quantity::JumpCut, -Fx::DELTA),
        (Feel { acceleration: fx!(-1), ..base }, Quantity::Acceleration, fx!(-1)),
        (Feel { air_acceleration: fx!(-1), ..base }, Quantity::AirAcceleration, fx!(-1)),
        (Feel { wall_jump: Some(fx!(-2)), ..base }, Quantity::WallJump, fx!(-2)),
        (Feel { wall_slide: Some(fx!(-2)), ..base }, Quantity::WallSlide, fx!(-2)),
    ];
    for (feel, what, value) in signed {
        assert_eq!(bad(with(feel), NOTHING), Some(what), "{feel:?}");
        assert_eq!(feel.check(), Err(RangeError { what, value: value.to_bits() }));
    }
    assert_eq!(base.check(), Ok(()));
    assert_eq!(Feel { snap: fx!(-1), ..base }.check().map_err(|e| e.what), Err(Quantity::Snap));
    assert_eq!(Feel { step: Fx::MAX, ..base }.check().map_err(|e| e.what), Err(Quantity::StepHeight));
    assert_eq!(bad(with(Feel { gravity: fx!(-0.25), ..base }), NOTHING), None);
    for gravity in [Fx::MIN, Fx::MAX, Fx::ZERO, Fx::DELTA] {
        for all in [Fx::MIN, Fx::MAX, fx!(-1)] {
            let feel = Feel {
                gravity,
                fall: all,
                jump: all,
                jump_cut: all,
                wall_jump: Some(all),
                wall_slide: Some(all),
                ..base
            };
            let mut hero = with(feel);
            for _ in 0..4 {
                let _ = hero.step(&level, Input { run: all, jump: true, drop: false });
                let _ = hero.step(&level, NOTHING);
            }
        }
    }
}
