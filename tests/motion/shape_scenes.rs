//! Scenes with slopes and arcs: smooth joints, pipes, wedges, peaks.

use tilesat::{Axis, Mover, Response};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::{Body, Outcome};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, drawn, len2, mosaic};
use tilesat_judge::shapes::level::Level;

const UP: Mover = Mover::platformer(Axis::NEG_Y);
/// Slopes by their solid side, y down: `/` rises to the right, `\` to the left. Mild ones in two
/// halves. Quarter pipes.
const SHAPES: [(char, u8); 13] = [
    ('/', 8),
    ('\\', 9),
    ('l', 20),
    ('h', 24),
    ('L', 21),
    ('H', 25),
    (')', 16),
    ('(', 17),
    ('"', 15),
    ('\'', 14),
    ('_', 4),
    ('^', 2),
    ('t', 7),
];

fn level(rows: &[&str]) -> Level {
    drawn(rows, 16 * PX, &SHAPES)
}

fn px(x: i64, y: i64) -> P {
    (x * PX, y * PX)
}

fn disc(x: i64, y: i64, r: i64) -> Body {
    Body::Disc(px(x, y), r * PX)
}

/// Frames with a pull, each judged. Returns the outcomes.
fn play(level: &Level, body: Body, v: P, gravity: i64, frames: u32) -> Vec<Outcome> {
    let room = Room::new(level);
    let (mut body, mut v) = (body, v);
    (0..frames)
        .map(|_| {
            let pulled = (v.0, v.1 + gravity);
            let out = body.step(&UP, &level.all(), pulled).unwrap();
            assert!(!room.overlaps(out.body, (0, 0), 0), "{out:?}");
            assert!(len2(out.v) <= len2(pulled), "{out:?} by {pulled:?}");
            (body, v) = (out.body, out.v);
            out
        })
        .collect()
}

/// The last frames all alike.
fn rests(level: &Level, body: Body, v: P) -> Outcome {
    for view in [View::MirrorX, View::Moved((12345, -678))] {
        let seen = play(&view.level(level), view.body(body), view.direction(v), PX / 4, 1000);
        let last = seen[seen.len() - 1];
        assert!(seen[500..].iter().all(|o| o.body == last.body && o.v == (0, 0)), "{last:?}");
    }
    let all = play(level, body, v, PX / 4, 10_000);
    let last = all[all.len() - 1];
    let moving = all.iter().rposition(|o| o.body != last.body || o.v != (0, 0)).unwrap_or(0);
    assert!(moving < 500, "moved in frame {moving}: {:?}", all[moving]);
    last
}

#[test]
fn a_v_of_two_slopes() {
    let v = level(&["......", r"\..../", r"#\../#", r"##\/##", "######"]);
    for r in [3, 8, 11] {
        for x in [40, 48, 55] {
            let out = rests(&v, disc(x, 12, r), (PX / 3, 0));
            assert!((out.body.position().0 - 48 * PX).abs() <= 4, "{out:?}");
            assert!(out.floor && !out.wall);
        }
    }
    rests(&v, Body::Rect(px(40, 2), px(9, 7)), (PX, 0));
    // 45 degrees at the left, half of that slope at the right.
    let v = level(&["......", r"\...lh", r"#\lh##", "######"]);
    for r in [2, 5, 9] {
        rests(&v, disc(30, 9, r), (PX / 3, 0));
    }
    rests(&v, Body::Rect(px(30, 2), px(7, 7)), (0, 0));
}

/// Torture scene 40: a slope that ends at a wall, a slope under a ceiling, flat into a slope into
/// flat.
#[test]
fn slopes_and_walls() {
    let wall = level(&["...#", "...#", r"\..#", r"#\.#", r"##\#", "####"]);
    let out = rests(&wall, disc(20, 16, 4), (PX, 0));
    assert!(out.body.position().0 == 44 * PX && out.wall, "{out:?}");
    rests(&wall, Body::Rect(px(16, 16), px(5, 6)), (PX, 0));
    // Up a slope into the wedge under the ceiling: it stops there and does not come to rest inside.
    let wedge = level(&["....", "..##", "../#", "./##", "/###"]);
    for r in [2, 5] {
        let out = play(&wedge, disc(5, 50, r), px(4, -4), 0, 60);
        let last = out[out.len() - 1];
        assert!(out[40..].iter().all(|o| o.body == last.body && o.v == (0, 0)), "{last:?}");
    }
    // Over a hill: no hop at the joints.
    let hill = level(&["........", "........", "..lhHL..", "########"]);
    let all = play(&hill, disc(8, 42, 6), px(2, 0), PX / 8, 45);
    assert!(all.iter().all(|o| !o.wall && !o.ceiling));
}

/// Torture scene 9: the peak of two slopes, head on.
#[test]
fn a_peak_head_on() {
    let peak = level(&["....", "....", r"./\.", "####"]);
    let out = disc(32, 0, 8).at(px(32, 8)).step(&UP.with_response(Response::Touch), &peak.all(), px(0, 32)).unwrap();
    let hit = out.hits.first().unwrap();
    assert_eq!(hit.axis, Axis::NEG_Y);
    assert!((1 << 29) - hit.toi.raw() <= 2, "{hit:?}");
    let above = disc(32, 24, 8).position();
    assert_eq!(out.body.position().0, above.0);
    assert!((0..=1).contains(&(above.1 - out.body.position().1)));
    let out = disc(32, 8, 8).step(&UP.with_response(Response::Bounce), &peak.all(), px(0, 20)).unwrap();
    assert_eq!((out.body.position().0, out.v), (32 * PX, px(0, -20)));
}

/// Along a slope the velocity keeps its direction to the last bit, and nothing is hit.
#[test]
fn down_a_long_slope() {
    let long = level(&["........", r"\.......", r"#\......", r"##\.....", r"###\....", r"####\...", "########"]);
    let all = play(&long, Body::Rect(px(17, 4), px(8, 12)), px(1, 1), PX / 8, 30);
    let sliding: Vec<_> = all.iter().filter(|o| o.hits.first().is_some_and(|h| h.axis == Axis::new(1, -1))).collect();
    assert!(sliding.len() > 10 && sliding.iter().all(|o| o.v.0 == o.v.1 || o.hits.len() > 1), "{all:?}");
    let all = play(&long, disc(24, 10, 5), px(1, 1), 0, 20);
    assert!(all.iter().all(|o| o.hits.is_empty() || o.v.0 == o.v.1));
}

/// From a floor through a quarter pipe up a wall, and the same upside down. Nearly all of the speed
/// stays.
#[test]
fn up_a_quarter_pipe() {
    let pipe = level(&["....#", "....#", "....#", "....#", "...)#", "#####"]);
    for (r, speed) in [(4, 3 * PX), (10, 3 * PX), (10, 12 * PX), (15, PX), (1, 40 * PX), (16, 2 * PX)] {
        let all = play(&pipe, disc(20, 80 - r, r), (speed, 0), 0, 60);
        let wall = px(64 - r, 0).0;
        let up = all.iter().find(|o| o.v.0 == 0).unwrap_or_else(|| panic!("{r} {speed}: {:?}", all[20]));
        if r < 16 {
            assert_eq!(up.body.position().0, wall, "{r} {speed}");
            let lost = speed + up.v.1;
            assert!(lost >= 0 && lost < speed / 4000 + 64, "{r} {speed}: {lost} of {speed} lost");
            // Straight up, and that loses nothing.
            assert!(all.iter().filter(|o| o.v.0 == 0 && o.v.1 != 0).all(|o| o.v.1 == up.v.1));
        } else {
            assert_eq!(up.v, (0, 0), "as wide as the pipe");
        }
    }
    // A box rolls its corner through it.
    let all = play(&pipe, Body::Rect(px(20, 72), px(8, 8)), px(3, 0), 0, 60);
    let up = all.iter().find(|o| o.v.0 == 0).unwrap();
    assert!(up.v.1 < -3 * PX + 64 && up.body.position().0 == px(56, 0).0, "{up:?}");
}

/// To and fro in a half pipe under gravity: never higher than the start, and hardly lower.
#[test]
fn a_half_pipe() {
    let pipe = level(&["#......#", "#......#", "#......#", "#(....)#", "########"]);
    let all = play(&pipe, disc(20, 30, 4), (0, 0), PX / 8, 2000);
    let mut tops = Vec::new();
    for w in all.windows(3) {
        let y = |k: usize| w[k].body.position().1;
        if y(0) > y(1) && y(1) <= y(2) {
            tops.push(y(1));
        }
    }
    assert!(tops.len() > 10 && tops.iter().all(|&y| y >= 30 * PX), "{tops:?}");
    assert!(tops[1] < 40 * PX, "{tops:?}");
}

/// Each tile of a straight shape is four tiles of half its size.
fn cut(l: &Level) -> Level {
    let quarters = |id: u8| -> [u8; 4] {
        if id < 2 {
            return [id; 4];
        }
        let (group, turn) = ((id - 2) / 4, (id - 2) % 4);
        if group == 0 {
            return [[1, 1, 0, 0], [0, 1, 0, 1], [0, 0, 1, 1], [1, 0, 1, 0]][turn as usize];
        }
        let g = |k: u8| 2 + 4 * k + turn;
        // With the solid corner at the top left; then mirrored.
        let q = match group {
            1 => [1, g(1), g(1), 0],
            4 => [g(5), g(4), 0, 0],
            5 => [1, 1, g(5), g(4)],
            6 => [g(7), 0, g(6), 0],
            7 => [1, g(7), 1, g(6)],
            _ => panic!("{id} is not straight"),
        };
        match turn {
            0 => q,
            1 => [q[1], q[0], q[3], q[2]],
            2 => [q[3], q[2], q[1], q[0]],
            _ => [q[2], q[3], q[0], q[1]],
        }
    };
    let (w, h) = (2 * l.width, 2 * l.height);
    let tile = |k: i64| {
        let (x, y) = (k % w, k / w);
        quarters(l.tiles[(y / 2 * l.width + x / 2) as usize])[(y % 2 * 2 + x % 2) as usize]
    };
    Level { tiles: (0..w * h).map(tile).collect(), width: w, height: h, cell: l.cell / 2, ..l.clone() }
}

/// A chain of collinear faces is one long face: worlds of straight shapes, and the same cut into
/// smaller tiles, bit for bit.
#[test]
fn joints_are_none() {
    let mut r = Random::new(3);
    let frames: u64 = tilesat_judge::frames(100_000);
    let (mut seen, mut hits) = (0, 0);
    while seen < frames / 2 {
        let cell = [16 * PX, 24 * PX, 2 * 7 * 64 * r.within(2, 800)][r.below(3) as usize];
        let dense = r.within(10, 50);
        let mut whole = mosaic(&mut r, (12, 9), cell, dense, 0);
        whole.tiles.iter_mut().filter(|id| (10..18).contains(*id)).for_each(|id| *id = 0);
        let fine = cut(&whole);
        let finer = cut(&fine);
        let room = Room::new(&whole);
        let size = (2 + r.below(2 * cell), 2 + r.below(2 * cell));
        let kind = if r.one_in(2) { Body::Rect((0, 0), size) } else { Body::Disc((0, 0), size.0 / 2) };
        let mut place = || kind.at((r.below(12 * cell), r.below(9 * cell)));
        let Some(mut body) = (0..100).map(|_| place()).find(|b| !room.overlaps(*b, (0, 0), 0)) else { continue };
        let mut v = (0, 0);
        for _ in 0..100 {
            if len2(v) < 1 << 16 || r.one_in(20) {
                v = (r.around(cell), r.around(cell));
            }
            v.1 += cell / 64;
            let out = body.step(&UP, &whole.all(), v).unwrap();
            for other in [&fine, &finer] {
                let o = body.step(&UP, &other.all(), v).unwrap();
                let list = |o: &Outcome| o.hits.iter().map(|h| (h.toi.raw(), h.axis)).collect::<Vec<_>>();
                let case = || format!("{body:?} by {v:?} in {:?} of {cell}", whole.tiles);
                assert_eq!(
                    (o.body, o.v, o.remaining, list(&o)),
                    (out.body, out.v, out.remaining, list(&out)),
                    "{}",
                    case()
                );
            }
            hits += out.hits.len();
            seen += 1;
            (body, v) = (out.body, out.v);
        }
    }
    assert!(hits as u64 > seen / 4);
}

/// A flying ball that meets a slope and slides from it to the floor continues along the floor,
/// whatever part of its way the frame ends in.
#[test]
fn lands_in_an_obtuse_corner_and_rolls_on() {
    use tilesat::{Axis, Circle, Fx, Mover, Slopes, TileKind, TileKinds, TileMap, TileShape, Vec2};
    static KINDS: TileKinds =
        TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'\\', TileKind::of(TileShape::SlopeBottomLeft));
    let level = "             \n#            \n#\\           \n#############\n";
    let map = TileMap::from_ascii(level, &TileKinds::EMPTY).unwrap().with_kinds::<Slopes>(&KINDS).unwrap();
    let mover = Mover::platformer(Axis::NEG_Y);
    for phase in 0..10 {
        let tenth = |n: i32| Fx::from_bits((n << 16) / 10);
        let at = Vec2::new(Fx::from_num(36) + tenth(3 * phase), Fx::from_num(38) - tenth(6 * phase));
        let mut ball = Circle::new(at, Fx::from_num(8)).unwrap();
        let mut v = Vec2::from_ints(-3, 6);
        for _ in 0..3 {
            let moved = mover.move_and_slide(&map, &ball, v).unwrap();
            (ball, v) = (moved.body, moved.velocity);
        }
        assert!((v.x - Fx::lit("1.5")).abs() < Fx::lit("0.001") && v.y == 0, "{phase}: {v:?}");
    }
}

/// A box reaches the end of a quarter pipe and the wall below it at one moment. It hits the wall (a
/// face before an arc).
#[test]
fn a_wall_goes_before_the_end_of_a_pipe() {
    let l = Level { cell: 65536, ..drawn(&["##", ".\"", ".#"], 65536, &SHAPES) };
    let box_ = Body::Rect((0, 65536), (20454, 131_072));
    for view in [View::MirrorX, View::MirrorY, View::Transpose, View::Moved((77, -1_000_003)), View::Moved((0, 0))] {
        let level = view.level(&l);
        for speed in [81_521, 45_083, 50_000, 65_536, 90_001, 3_000_017] {
            let out = view.body(box_).step(&UP, &level.all(), view.direction((speed, 0))).unwrap();
            let n = view.direction((-1, 0));
            let first = out.hits.first().unwrap();
            assert_eq!((first.axis, out.v), (Axis::new(n.0 as i32, n.1 as i32), (0, 0)), "{view:?} {speed}");
            assert_eq!(out.body, view.body(box_.moved((45_082, 0))));
        }
    }
}

/// A body as wide as a shaft falls to where the shaft's side turns into a quarter pipe. Its
/// velocity ends there, frame after frame.
#[test]
fn a_shaft_ends_in_a_pipe() {
    let cell = 65536;
    for end in [17, 16] {
        let l = drawn(&["#.##", "#.##", "#(##", "####"], cell, &[('(', end)]);
        for body in [Body::Disc((3 * cell / 2, cell), cell / 2), Body::Rect((cell, cell / 3), (cell, cell))] {
            for view in [View::MirrorX, View::MirrorY, View::Transpose, View::Moved((77, -1_000_003))] {
                let level = view.level(&l);
                let (mut body, mut v) = (view.body(body), (0, 0));
                for frame in 0..40 {
                    let pull = view.direction((0, cell / 64));
                    let out = body.step(&UP, &level.all(), (v.0 + pull.0, v.1 + pull.1)).unwrap();
                    (body, v) = (out.body, out.v);
                    assert!(frame < 20 || (v, out.remaining) == ((0, 0), (0, 0)), "{view:?} {end}: {out:?}");
                }
            }
        }
    }
}

/// A point that runs into the cusp between an arc and its floor stops at its end, and the call
/// reports it.
#[test]
fn a_point_in_a_cusp() {
    let shapes = [('q', 10), ('p', 11)];
    let l = drawn(&["#q..p#", "######"], 65536, &shapes);
    for body in [Body::Disc((3 * 65536, 65536), 0), Body::Rect((3 * 65536, 65536), (0, 0))] {
        for view in [View::MirrorX, View::MirrorY, View::Transpose, View::Moved((77, -1_000_003)), View::Moved((0, 0))]
        {
            let level = view.level(&l);
            for (speed, toi) in [(3 * 65536, 2), (131_073, 0), (200_000, 0), (90_000_000, 0)] {
                let v = view.direction((-speed, 0));
                let out = view.body(body).step(&UP, &level.all(), v).unwrap();
                let first = out.hits.first().unwrap();
                let n = view.direction((1, 0));
                assert_eq!((first.axis, out.v), (Axis::new(n.0 as i32, n.1 as i32), (0, 0)), "{view:?} {speed}");
                assert_eq!(out.body, view.body(body.at((65536, 65536))));
                assert!(toi == 0 || first.toi.raw() == (1 << 30) * 2 / 3);
                let touch = UP.with_response(Response::Touch);
                let touched = view.body(body).step(&touch, &level.all(), v).unwrap();
                assert_eq!((touched.body, touched.hits.len()), (out.body, 1));
                // Once there it stays there.
                let again = out.body.step(&UP, &level.all(), v).unwrap();
                assert_eq!((again.body, again.v, again.hits.len()), (out.body, (0, 0), 1));
                // Out of it, and exactly up to it, the way is free.
                let back = out.body.step(&UP, &level.all(), view.direction((65536, 0))).unwrap();
                assert!(back.hits.is_empty() && back.body == view.body(body.at((131_072, 65536))));
                let to = view.body(body).step(&UP, &level.all(), view.direction((-131_072, 0))).unwrap();
                assert!(to.hits.is_empty() && to.body == out.body);
            }
        }
    }
}
