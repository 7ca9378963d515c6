//! A hero where quarter pipes and domes end: at walls, and at slopes that are too steep for it.

use super::character::NOTHING;
use tilesat::{
    Aabb, AllShapes, Body, Capsule, Character, Circle, Feel, Fx, Input, Outcome, TileKind, TileKinds, TileMap,
    TileShape, Vec2, fx,
};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'(', TileKind::of(TileShape::ConcaveBottomLeft))
    .with(b')', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b'l', TileKind::of(TileShape::SteepLowBottomLeft))
    .with(b's', TileKind::of(TileShape::SteepHighBottomLeft));

/// Heroes that stand on the ground of `rows` with their left ends from `from` to a cell farther
/// on.
fn heroes<'a, B: Body + 'a>(
    rows: &'a str,
    from: Fx,
    make: impl Fn(Fx) -> B + 'a,
) -> impl Iterator<Item = (TileMap<'a, AllShapes>, Character<B>)> + 'a {
    (0..64).filter_map(move |start| {
        let level = TileMap::<AllShapes>::of_ascii(rows, &KINDS).unwrap();
        let mut hero = Character::new(make(from + Fx::from_num(start) / 4), level.bounds(), Feel::DEFAULT);
        for _ in 0..40 {
            if hero.step(&level, NOTHING).unwrap().outcome != Outcome::Moved {
                return None;
            }
        }
        hero.on_floor().then_some((level, hero))
    })
}

/// Runs `$check` with a box, a circle and a capsule of a width, which begin at `x` with their feet
/// at `y`: what makes them, and what gives their bounds.
macro_rules! with_bodies {
    ($width:expr, $feet:expr, |$make:ident, $bounds:ident| $check:expr) => {{
        let (width, feet): (Fx, Fx) = ($width, $feet);
        let r = width / 2;
        {
            let $make = move |x: Fx| Aabb::new(Vec2::new(x, feet - fx!(12)), Vec2::new(x + width, feet)).unwrap();
            let $bounds = |body: &Aabb| *body;
            $check
        }
        {
            let $make = move |x: Fx| Circle::new(Vec2::new(x + r, feet - r), r).unwrap();
            let $bounds = |body: &Circle| body.aabb();
            $check
        }
        {
            let $make =
                move |x: Fx| Capsule::new(Vec2::new(x + r, feet - fx!(12)), Vec2::new(x + r, feet - r), r).unwrap();
            let $bounds = |body: &Capsule| body.aabb();
            $check
        }
    }};
}

/// A pipe comes down to the left end of a wall, which is the right one of its tile.
#[test]
fn it_runs_through_a_pipe_up_to_the_wall() {
    for width in [fx!(2), fx!(7), fx!(10)] {
        for run in [fx!(0.5), fx!(1.5), fx!(4)] {
            with_bodies!(width, fx!(31), |make, bounds| {
                let mut count = 0;
                for (level, mut hero) in heroes("....\n#...\n#(#.\n####", fx!(16), make) {
                    if bounds(hero.body()).max().x > 32 {
                        continue; // it stands on the wall
                    }
                    for _ in 0..60 {
                        let _ = hero.step(&level, Input { run, ..NOTHING }).unwrap();
                        assert!(hero.on_floor());
                    }
                    // Bodies end at most 2 raw early at an arc.
                    assert!(fx!(32) - bounds(hero.body()).max().x < fx!(0.0001), "{width} {run} {:?}", hero.body());
                    count += 1;
                }
                assert!(count > 10, "{width} {run}: {count}");
            });
        }
    }
}

/// At the end of a pipe the ground falls away, by a slope or another pipe that is too steep to
/// stand on.
#[test]
fn it_leaves_a_pipe_at_whose_end_the_ground_falls_away() {
    for beyond in ["##l.", "##..", "##(."] {
        let rows = &format!("....\n#...\n#(..\n{beyond}\n####");
        for width in [fx!(2), fx!(7), fx!(10)] {
            for run in [fx!(0.5), fx!(1.5), fx!(4)] {
                with_bodies!(width, fx!(31), |make, bounds| {
                    let mut count = 0;
                    for (level, mut hero) in heroes(rows, fx!(16), make) {
                        for _ in 0..200 {
                            let _ = hero.step(&level, Input { run, ..NOTHING }).unwrap();
                        }
                        assert!(bounds(hero.body()).max().y > 49, "{rows} {width} {run} {:?}", hero.body());
                        count += 1;
                    }
                    assert!(count > 10, "{rows} {width} {run}: {count}");
                });
            }
        }
    }
}

/// It leaves the level foot of a pipe level, with its speed, however long its last chord is.
#[test]
fn it_leaves_the_foot_of_a_pipe_level() {
    for width in [fx!(2), fx!(7), fx!(10)] {
        for run in [fx!(6), fx!(8)] {
            let mut count = 0;
            with_bodies!(width, fx!(31), |make, bounds| {
                for (level, mut hero) in heroes("......\n#.....\n#(....\n##....\n##....\n##....\n##....", fx!(16), make)
                {
                    hero.velocity = Vec2::new(run, Fx::ZERO);
                    for frame in 0..60 {
                        let (was, stood) = (bounds(hero.body()).min(), hero.on_floor());
                        let _ = hero.step(&level, Input { run, ..NOTHING }).unwrap();
                        if !stood || hero.on_floor() {
                            continue;
                        }
                        if was.x + width / 2 > 30 {
                            break; // a round one leaves around the corner
                        }
                        let made = bounds(hero.body()).min() - was;
                        let speed = hero.velocity.length();
                        let level = made.length() > speed * fx!(0.95) && hero.velocity.y < speed * fx!(0.07);
                        assert!(level, "{width} {run} frame {frame} from {was:?} {made:?} {:?}", hero.velocity);
                        count += 1;
                        break;
                    }
                }
            });
            assert!(count > 5, "{width} {run}: {count}");
        }
    }
}

/// Against a steep slope that ends on the top of a dome: it stands there, or slides off, and does
/// not land in every second frame.
#[test]
fn it_stands_between_a_dome_and_a_steep_slope() {
    for rows in ["....\n##s.\n###)\n####", ".....\n##s..\n###).\n#####", "....\n##..\n##l.\n###)\n####"] {
        for width in [fx!(3), fx!(7), fx!(10)] {
            for run in [fx!(-0.5), fx!(-1), fx!(-3)] {
                with_bodies!(width, fx!(20), |make, bounds| {
                    for (level, mut hero) in heroes(rows, fx!(40), make).step_by(tilesat_judge::thorough(5, 1)) {
                        let (mut changes, mut stood) = (0, true);
                        for frame in 0..150 {
                            let _ = hero.step(&level, Input { run, ..NOTHING }).unwrap();
                            changes += u32::from(frame > 100 && hero.on_floor() != stood);
                            stood = hero.on_floor();
                        }
                        assert!(changes < 3, "{rows} {width} {run} {:?} {changes}", bounds(hero.body()));
                    }
                });
            }
        }
    }
}
