//! What a hero looks for before it moves: ledges, corners, and room for another body.

use super::character::{JUMP, KINDS, NOTHING, boxed, limits};
use tilesat::{Aabb, Body, Character, Circle, Feel, Fx, Input, Outcome, Slopes, TileKind, TileKinds, TileMap};
use tilesat::{TileShape, Vec2, fx};
use tilesat_judge::Random;

static GROUND: TileKinds = KINDS
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'_', TileKind::of(TileShape::HalfBottom));

/// Ground of 30 columns whose height changes by slopes and steps, and which has pits.
fn terrain(random: &mut Random) -> String {
    let mut rows = vec![[b'.'; 30]; 8];
    let (mut height, mut x) = (5_usize, 0);
    while x < 30 {
        match random.below(8) {
            0 => x += 1, // a pit
            1 if height > 3 => {
                rows[height - 1][x] = b'/';
                rows[height][x] = b'#';
                (height, x) = (height - 1, x + 1);
            }
            2 if height < 6 => {
                rows[height][x] = b'\\';
                rows[height + 1][x] = b'#';
                (height, x) = (height + 1, x + 1);
            }
            3 => {
                rows[height - 1][x] = b'_';
                rows[height][x] = b'#';
                x += 1;
            }
            n => {
                let end = (x + 3).min(30);
                rows[height][x..end].fill(if n == 4 { b'=' } else { b'#' });
                x += 3;
            }
        }
    }
    let rows: Vec<&str> = rows.iter().map(|row| std::str::from_utf8(row).unwrap()).collect();
    rows.join("\n") + "\n"
}

/// A patrol that turns at ledges never falls. Where it turned, one that goes on does fall, before
/// it is its width and a step farther.
fn patrols<B: Body + PartialEq>(body: impl Fn(i16) -> B, width: Fx, is_round: bool, random: &mut Random) -> u32 {
    let text = terrain(random);
    let level = TileMap::<Slopes>::of_ascii(&text, &GROUND).unwrap();
    let x = random.within(20, 440) as i16;
    let mut enemy = Character::new(body(x), limits(), Feel::DEFAULT);
    while enemy.step(&level, NOTHING).unwrap().outcome == Outcome::Moved && !enemy.on_floor() {
        if enemy.body().position().y > 200 {
            return 0;
        }
    }
    let mut run = Fx::from_bits(random.within(1 << 14, 3 << 16) as i32);
    let (mut turns, mut turned) = (0, false);
    for frame in 0..300 {
        if enemy.ledge_ahead(&level, run).unwrap() {
            let (mut on, start) = (enemy, enemy.body().position());
            let sank = |on: &Character<B>| on.body().position().y - start.y > enemy.feel.snap;
            // A circle rolls over its edge, and may still follow a ledge of more than the snap
            // down.
            while on.on_floor() && !(is_round && sank(&on)) {
                let step = on.step(&level, Input { run, ..NOTHING }).unwrap();
                let way = (on.body().position().x - start.x).abs();
                assert!(!step.wall && way <= run.abs() + width + run.abs(), "{text}{frame} {run} {way}");
            }
            (run, turns) = (-run, turns + 1);
            // A place with ledges at both sides: it stays.
            if turned {
                return turns;
            }
            turned = true;
            continue;
        }
        turned = false;
        let step = enemy.step(&level, Input { run, ..NOTHING }).unwrap();
        assert!(enemy.on_floor(), "{text}{frame} {run}");
        if step.wall {
            run = -run;
        }
    }
    turns
}

#[test]
fn a_patrol_turns_exactly_where_it_would_fall() {
    let mut random = Random::new(5);
    let mut turns = 0;
    for _ in 0..400 {
        turns += patrols(|x| boxed(x, 4, 10, 12), fx!(10), false, &mut random);
        turns += patrols(|x| Circle::new(Vec2::from_ints(x, 8), fx!(6)).unwrap(), fx!(12), true, &mut random);
    }
    assert!(turns > 1000, "{turns}");
}

/// Over a pit that is as wide as itself, a box stands nowhere at one place alone. At whatever speed
/// and from wherever it comes, it turns before. A narrower pit it crosses.
#[test]
fn a_patrol_turns_at_a_pit_as_wide_as_itself() {
    let rows = ["#......................#\n", "#......................#\n", "#######.#####.#########\n"];
    for floor in ['#', '='] {
        let ground = rows[2].replace('#', &floor.to_string());
        let level = rows[..2].concat() + &format!("#{ground}") + &format!("#{ground}");
        let level = TileMap::from_ascii(&level, &KINDS).unwrap();
        for (width, crosses) in [(15 << 16, false), (16 << 16, false), ((16 << 16) + 1, true), (18 << 16, true)] {
            for speed in [fx!(0.25), fx!(0.5), fx!(0.75), fx!(1.5), fx!(2.5)] {
                for start in (18..90).step_by(tilesat_judge::thorough(17, 5)) {
                    let lo = Vec2::from_ints(start, 16);
                    let body = Aabb::new(lo, Vec2::new(lo.x + Fx::from_bits(width), fx!(32))).unwrap();
                    let mut enemy = Character::new(body, limits(), Feel::DEFAULT);
                    let (mut run, mut walls) = (speed, [false; 2]);
                    let _ = enemy.step(&level, NOTHING).unwrap();
                    let way = if crosses { fx!(800) } else { fx!(300) };
                    for _ in 0..(way / speed).to_num::<i32>() {
                        let step = enemy.step(&level, Input { run, ..NOTHING }).unwrap();
                        assert!(enemy.on_floor(), "{width} {speed} {start} {}", enemy.body().min().x);
                        let ledge = enemy.ledge_ahead(&level, enemy.stopping_distance(run)).unwrap();
                        assert!(!(ledge && crosses), "{width} {speed} {start} {}", enemy.body().min().x);
                        walls[usize::from(run > 0)] |= step.wall;
                        run = if step.wall || ledge { -run } else { run };
                    }
                    // The first pit is right of it, and the left wall it always comes to.
                    assert_eq!(walls, [true, crosses], "{width} {speed} {start}");
                }
            }
        }
    }
}

/// The search for a gap comes down to a few raw units on a slope, which no walk makes. It ends
/// all the same.
#[test]
fn a_look_down_a_slope_into_a_pit_ends() {
    let rows = ["........\n#\\..#...\n##..#...\n#######.", "........\n...#../#\n...#..##\n.#######"];
    for (rows, x, run) in [(rows[0], fx!(10), fx!(1)), (rows[1], fx!(92), fx!(-1))] {
        let level = TileMap::<Slopes>::of_ascii(rows, &GROUND).unwrap();
        let feel = Feel { snap: fx!(16), step: fx!(8), ..Feel::DEFAULT };
        for (width, start) in [10, 12, 16].into_iter().flat_map(|width| (0..64).map(move |start| (width, start))) {
            let body = Aabb::from_size(Vec2::new(x + Fx::from_num(start) / 8, fx!(0)), Vec2::from_ints(width, 14));
            let mut enemy = Character::new(body.unwrap(), limits(), feel);
            for frame in 0..60 {
                let _ = enemy.step(&level, Input::running(if frame < 20 { fx!(0) } else { run })).unwrap();
                let _ = enemy.ledge_ahead(&level, enemy.stopping_distance(run)).unwrap();
            }
            assert!(enemy.on_floor(), "{rows} {width} {start}");
        }
    }
}

#[test]
fn on_even_ground_it_turns_with_its_front_on_the_floor() {
    let level = TileMap::from_ascii("          \n ======   \n", &KINDS).unwrap(); // from 16 to 112
    for (way, run) in [(1, fx!(0.3)), (1, fx!(2)), (-1, fx!(0.7)), (-1, fx!(3))] {
        let mut enemy = Character::new(boxed(60, 2, 10, 14), limits(), Feel::DEFAULT);
        let run = run * way;
        let _ = enemy.step(&level, NOTHING).unwrap();
        while !enemy.ledge_ahead(&level, run).unwrap() {
            let _ = enemy.step(&level, Input { run, ..NOTHING }).unwrap();
        }
        let (lo, hi) = (enemy.body().min().x, enemy.body().max().x);
        let left = if way > 0 { fx!(112) - hi } else { lo - fx!(16) };
        assert!((Fx::ZERO..=run.abs()).contains(&left), "{run}: {left}");
        assert!(!enemy.ledge_ahead(&level, -run).unwrap());
        // Without a sign it looks to larger x.
        for _ in 0..2 {
            let _ = enemy.step(&level, Input { run, ..NOTHING }).unwrap();
        }
        assert_eq!((enemy.on_floor(), enemy.ledge_ahead(&level, Fx::ZERO)), (true, Ok(way > 0)));
    }
    let flying = Character::new(boxed(60, -40, 10, 14), limits(), Feel::DEFAULT);
    assert_eq!(flying.ledge_ahead(&level, fx!(1)), Ok(false));
    // In a wall that closed on it nothing is ahead, and beyond the end of the coordinates no floor.
    let mut stands = Character::new(boxed(60, 2, 10, 14), limits(), Feel::DEFAULT);
    let _ = stands.step(&level, NOTHING).unwrap();
    let closed = TileMap::from_ascii("##########\n##########\n", &KINDS).unwrap();
    assert_eq!((stands.on_floor(), stands.ledge_ahead(&closed, fx!(1))), (true, Ok(false)));
    let far = TileMap::from_ascii(" \n=\n", &KINDS).unwrap().with_outside(tilesat::Outside::Edge);
    let mut last = Character::new(boxed(8170, 2, 10, 14), limits(), Feel::DEFAULT);
    let _ = last.step(&far, NOTHING).unwrap();
    assert_eq!(
        (last.on_floor(), last.ledge_ahead(&far, fx!(4)), last.ledge_ahead(&far, fx!(-4))),
        (true, Ok(true), Ok(false))
    );
}

/// At any speed a patrol that looks ahead as the guide does keeps its front on the floor, on long
/// and on short platforms, and comes near both ends.
#[test]
fn a_patrol_brakes_before_the_ledge() {
    let mut random = Random::new(21);
    for n in 0..60 {
        let speed = if n < 4 {
            [fx!(0.5), fx!(1.5), fx!(4), fx!(8)][n]
        } else {
            Fx::from_bits(random.within(1 << 14, 8 << 16) as i32)
        };
        let acceleration = [Feel::DEFAULT.acceleration, fx!(0.25), fx!(1)][n / 4 % 3];
        let tiles = [2, 3, 6, 30][n % 4];
        let text = ".".repeat(40) + "\n." + &"=".repeat(tiles) + &".".repeat(39 - tiles) + "\n";
        let level = TileMap::from_ascii(&text, &KINDS).unwrap();
        let end = fx!(16) + Fx::from_num(16 * tiles);
        let mut enemy = Character::new(boxed(18, 2, 10, 14), limits(), Feel { acceleration, ..Feel::DEFAULT });
        let (mut way, mut turns, mut ends) = (1, 0, (fx!(999), fx!(0)));
        for _ in 0..3000 {
            let _ = enemy.step(&level, Input { run: speed * way, ..NOTHING }).unwrap();
            if enemy.ledge_ahead(&level, enemy.stopping_distance(speed * way)).unwrap() {
                (way, turns) = (-way, turns + 1);
            }
            ends = (ends.0.min(enemy.body().min().x), ends.1.max(enemy.body().max().x));
            assert!(enemy.on_floor() && ends.0 >= 16 && ends.1 <= end, "{speed} {acceleration} {ends:?}");
        }
        let near = (speed + acceleration) * 2;
        assert!(
            turns > 1 && ends.1 + near >= end && ends.0 <= near + fx!(16),
            "{speed} {acceleration} {ends:?} {turns}"
        );
    }
}

/// The stopping distance is what a patrol still moves, plus half of its speed and roundings.
#[test]
fn a_patrol_stops_within_its_stopping_distance() {
    let text = ".".repeat(60) + "\n" + &"=".repeat(60) + "\n";
    let level = TileMap::from_ascii(&text, &KINDS).unwrap();
    let mut random = Random::new(22);
    for n in 0..300 {
        let mut number = |from, to| Fx::from_bits(random.within(from, to) as i32);
        let acceleration = number(1 << 12, 2 << 16);
        let run = number(-8 << 16, 8 << 16);
        let mut enemy = Character::new(boxed(480, 2, 10, 14), limits(), Feel { acceleration, ..Feel::DEFAULT });
        let _ = enemy.step(&level, NOTHING).unwrap();
        enemy.velocity.x = number(-8 << 16, 8 << 16);
        let from = enemy.position().x;
        let stops = enemy.stopping_distance(run) * run.signum();
        let before = enemy.velocity.x;
        let mut far = fx!(0);
        let _ = enemy.step(&level, Input::running(run)).unwrap();
        let speed = enemy.velocity.x * run.signum();
        loop {
            far = far.max((enemy.position().x - from) * run.signum());
            if enemy.velocity.x * run.signum() <= 0 {
                break;
            }
            let _ = enemy.step(&level, Input::running(-run)).unwrap();
        }
        assert!(enemy.on_floor() && stops >= 0);
        // Faster than it runs, or backward, it does not reach the speed for which the distance is.
        if before * run.signum() >= 0 && before.abs() <= run.abs() {
            let more = speed.max(fx!(0)) / 2 + acceleration + fx!(0.01);
            assert!(far <= stops && stops <= far + more, "{n} {run} {before} {acceleration}: {far} {stops}");
        }
    }
    let mut sled = Character::new(boxed(80, 2, 10, 14), limits(), Feel { acceleration: fx!(0), ..Feel::DEFAULT });
    assert_eq!(sled.stopping_distance(fx!(2)), 0);
    sled.velocity.x = fx!(1);
    assert_eq!(sled.stopping_distance(fx!(2)), Fx::MAX);
    for run in [Fx::MIN, Fx::MAX] {
        for velocity in [Fx::MIN, Fx::MAX] {
            (sled.velocity.x, sled.feel.acceleration) = (velocity, Fx::MAX);
            let toward = (velocity < 0) == (run < 0);
            assert_eq!(sled.stopping_distance(run).signum(), run.signum(), "{toward}");
        }
    }
}

/// A head that is `under` raw units under a corner at its left or its right: within the reach it
/// loses no height, and beyond it is where it would be without.
#[test]
fn a_corner_within_reach_costs_no_height() {
    let rows = "       \n       \n##   ##\n       \n       \n#######\n"; // the ceiling ends at y = 48
    let level = TileMap::from_ascii(rows, &KINDS).unwrap();
    let (reach, unit) = (3 << 16, 1 << 16);
    for under in [0, 1, unit, reach - 1, reach, reach + 1, 5 * unit] {
        for right in [false, true] {
            let x = if right { (70 << 16) + under } else { (32 << 16) - under }; // corners at 32 and 80
            let lo = Vec2::from_raw(x, 64 << 16);
            let body = Aabb::new(lo, lo + Vec2::from_ints(10, 16)).unwrap();
            let top = |reach: Option<Fx>| {
                let mut hero = Character::new(body, limits(), Feel::DEFAULT);
                let _ = hero.step(&level, NOTHING).unwrap();
                let (mut top, mut moves) = (hero.body().min().y, 0);
                for _ in 0..30 {
                    if let Some(reach) = reach {
                        moves += i32::from(hero.assist(&level, JUMP, reach).unwrap());
                    }
                    let _ = hero.step(&level, JUMP).unwrap();
                    top = top.min(hero.body().min().y);
                }
                (top, moves, (hero.body().min().x - body.min().x).abs().to_bits())
            };
            let whole = fx!(64) - fx!(42.75);
            let blocked = if under == 0 { whole } else { fx!(48) };
            assert_eq!(top(None), (blocked, 0, 0), "{under} {right}");
            let helps = 0 < under && under <= reach;
            let expected = if helps { (whole, 1, under) } else { (blocked, 0, 0) };
            assert_eq!(top(Some(Fx::from_bits(reach))), expected, "{under} {right}");
        }
    }
    // The first frame of a jump counts: its head is a unit under the corner.
    let mut hero = Character::new(boxed(31, 49, 10, 31), limits(), Feel::DEFAULT);
    hero.feel.jump = fx!(1.5);
    let _ = hero.step(&level, NOTHING).unwrap();
    let standing = hero;
    assert!(hero.on_floor() && hero.assist(&level, JUMP, fx!(3)).unwrap());
    // It changes the position and nothing else: the press still counts.
    assert_eq!(hero.body().min(), Vec2::from_ints(32, 49));
    assert!(hero.set_body(&level, *standing.body()) && hero == standing);
    // Without a rise it does nothing, though a foot is a unit under the edge of a block.
    let steps = TileMap::from_ascii("      \n      \n  ####\n      \n", &KINDS).unwrap(); // from (32, 32)
    let mut falling = Character::new(boxed(21, 19, 10, 14), limits(), Feel::DEFAULT);
    falling.velocity = Vec2::from_ints(3, 0);
    let before = falling;
    assert_eq!(falling.assist(&steps, Input { run: fx!(3), ..NOTHING }, fx!(3)), Ok(false));
    assert!(falling == before && !steps.overlaps(falling.body()));
    let mut hero = Character::new(boxed(40, 60, 10, 16), limits(), Feel::DEFAULT);
    assert_eq!(hero.assist(&level, JUMP, fx!(-1)).unwrap_err().what, tilesat::Quantity::Assist);
}

#[test]
fn another_body_is_taken_if_it_has_room() {
    let mut random = Random::new(8);
    let level = TileMap::from_ascii("......\n.##.=.\n......\n#.####\n", &KINDS).unwrap();
    let (mut taken, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let mut random_box = || {
            let corner = |r: &mut Random| Vec2::from_raw(r.within(0, 96 << 16) as i32, r.within(0, 64 << 16) as i32);
            let lo = corner(&mut random);
            let size = Vec2::from_raw(random.within(0, 20 << 16) as i32, random.within(0, 20 << 16) as i32);
            // Half of them on the cells' borders.
            let at =
                if random.below(2) == 0 { lo } else { Vec2::from_raw(lo.raw().0 >> 20 << 20, lo.raw().1 >> 20 << 20) };
            Aabb::new(at, at + size).unwrap()
        };
        let (old, new) = (random_box(), random_box());
        let mut hero = Character::new(old, limits(), Feel::DEFAULT);
        hero.velocity = Vec2::from_ints(1, 2);
        let before = hero;
        let (lo, hi) = (new.min().raw(), new.max().raw());
        // Which cells it overlaps, cell by cell.
        let solid = |x: i32, y: i32| b"......\n.##.=.\n......\n#.####\n"[(y * 7 + x) as usize] == b'#';
        let meets = |x: i32, y: i32| {
            let (a, b) = ((x << 20, y << 20), ((x + 1) << 20, (y + 1) << 20));
            let strictly = |lo: i32, hi: i32, a: i32, b: i32| lo < b && a < hi;
            strictly(lo.0, hi.0, a.0, b.0) && strictly(lo.1, hi.1, a.1, b.1)
        };
        let room = !(0..6).any(|x| (0..4).any(|y| solid(x, y) && meets(x, y)));
        assert_eq!(hero.set_body(&level, new), room, "{new:?}");
        assert_eq!(*hero.body(), if room { new } else { old });
        assert!(hero.velocity == before.velocity && (room || hero == before));
        *(if room { &mut taken } else { &mut refused }) += 1;
    }
    assert!(taken > 1000 && refused > 1000);
}
