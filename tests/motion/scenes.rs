//! Rest, calls without effect, refusals, and test cases of other libraries. Whole units, y grows
//! downward.
//!
//! bump.lua uses goals instead of velocities, and rectangles of any size instead of cells. Each
//! case describes its translation.

use tilesat::{Aabb, Axis, Fx, Inside, MoveError, Mover, Outside, Quantity, RangeError, Response, Solid, Vec2, Walker};
use tilesat_judge::motion::body::{Body, Outcome, RESPONSES, at, px};
use tilesat_judge::motion::judge::check;
use tilesat_judge::motion::level::Level;
use tilesat_judge::motion::{P, Time};

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);
const GRAVITY: i64 = 1 << 14;

fn go(level: &Level, response: Response, body: Body, v: P) -> Outcome {
    check(level, PLAYER, response, &body, v)
}

/// `num / den` in parts of 2^30, rounded down.
fn parts(num: i64, den: i64) -> u32 {
    Time::new(num, den).floor() as u32
}

/// Frames of gravity; nothing may move. A call depends only on its arguments, so the first that
/// changes nothing stands for all that follow. The others check that no call keeps a state.
fn rests(level: &Level, body: Body, v: P) {
    let map = level.map();
    let first = go(level, Response::Slide, body, v);
    assert_eq!((first.body, first.v), (body, (0, 0)), "{first:?}");
    for _ in 0..1000 {
        let out = body.step(&PLAYER, &map, v).unwrap();
        assert_eq!(out, first);
    }
}

/// Lets a body fall for this many frames. Then it must rest.
fn settles(level: &Level, mut body: Body, frames: u32) -> Body {
    let mut v = (0, 0);
    for _ in 0..frames {
        let out = go(level, Response::Slide, body, (v.0, v.1 + GRAVITY));
        (body, v) = (out.body, out.v);
    }
    assert_eq!(v, (0, 0), "still moving at {body:?}");
    rests(level, body, (0, GRAVITY));
    body
}

#[test]
fn at_rest_on_a_floor() {
    let level = Level::new(&["...", "...", "###"], px(16));
    rests(&level, Body::rect((px(7) + 123, px(20)), at(11, 12)), (0, GRAVITY));
    rests(&level, Body::disc((px(17) + 321, px(24)), px(8)), (0, GRAVITY));
}

#[test]
fn at_rest_in_a_corner() {
    let level = Level::new(&["..#", "..#", "###"], px(16));
    rests(&level, Body::rect(at(21, 20), at(11, 12)), (px(1), GRAVITY));
    rests(&level, Body::disc(at(24, 24), px(8)), (px(1), GRAVITY));
}

#[test]
fn at_rest_on_a_one_way() {
    let level = Level::new(&["...", "---", "..."], px(16));
    rests(&level, Body::rect((px(7) + 123, px(4)), at(11, 12)), (0, GRAVITY));
    rests(&level, Body::disc((px(17) + 321, px(8)), px(8)), (0, GRAVITY));
    // With its middle on the very end of the face.
    rests(&level, Body::disc((0, px(8)), px(8)), (0, GRAVITY));
}

/// Exactly above a corner, the end of the face carries it. A sixteenth of a unit beside, it rolls
/// off. (Within 1/500 it stays: the slide is then below two raw per frame, which is the price of a
/// rounding that never gains.)
#[test]
fn at_rest_on_a_corner() {
    let level = Level::new(&["#"], px(16));
    for x in [0, px(16)] {
        rests(&level, Body::disc((x, -px(8)), px(8)), (0, GRAVITY));
    }
    for (x, side) in [(-4096, -1), (px(16) + 4096, 1)] {
        let (mut body, mut v) = (Body::disc((x, -px(8)), px(8)), (0, 0));
        for _ in 0..2000 {
            let out = go(&level, Response::Slide, body, (v.0, v.1 + GRAVITY));
            (body, v) = (out.body, out.v);
            if body.position().1 > px(40) {
                break;
            }
        }
        assert!(v.0 * side > 0 && body.position().1 > px(40), "{body:?} by {v:?}");
    }
}

/// A circle over a gap that is narrower than it: two corners, a V without faces.
#[test]
fn at_rest_in_a_gap() {
    let level = Level::new(&["...", "#.#", "#.#"], px(16));
    for dx in [0, 1, -1, 12_345, -200_000] {
        let body = settles(&level, Body::disc((px(24) + dx, px(3)), px(10)), 3000);
        // Within two raw of the middle; the depth is 10 - 6 of a 6-8-10 triangle.
        let (x, y) = body.position();
        assert!((x - px(24)).abs() <= 8 && (y - px(10)).abs() <= 8, "{dx}: {body:?}");
    }
}

/// A second call without velocity moves neither a resting body nor any other.
#[test]
fn without_velocity_nothing_happens() {
    let level = Level::new(&["..#", "--#", "###"], px(16));
    for body in [
        Body::rect(at(20, 4), at(12, 12)),
        Body::disc(at(24, 8), px(8)),
        Body::disc(at(9, 9), px(8)),
        Body::rect(at(32, 0), (0, 0)),
    ] {
        for response in RESPONSES {
            let out = body.step(&PLAYER.with_response(response), &level.map(), (0, 0)).unwrap();
            assert_eq!((out.body, out.v, out.remaining, out.hits.len()), (body, (0, 0), (0, 0), 0));
            assert_eq!((out.work.iterations, out.floor || out.wall || out.ceiling), (0, false));
        }
    }
}

fn refused(level: &Level, body: Body, v: P) -> RangeError {
    match body.step(&PLAYER, &level.map(), v).unwrap_err() {
        MoveError::Range(e) => e,
        stuck => panic!("{stuck}"),
    }
}

#[test]
fn what_is_out_of_range() {
    let level = Level::new(&["#"], px(16)).with_origin(at(1000, -1000));
    let small = Body::rect((0, 0), at(4, 4));
    let limit = 1 << 28;
    for k in [limit, -limit, i64::from(i32::MAX), i64::from(i32::MIN)] {
        assert_eq!(refused(&level, small, (k, 0)), RangeError { what: Quantity::MotionX, value: k as i32 });
        assert_eq!(refused(&level, small, (0, k)), RangeError { what: Quantity::MotionY, value: k as i32 });
    }
    for v in [(limit - 1, limit - 1), (1 - limit, 1 - limit)] {
        assert_eq!(go(&level, Response::Slide, small, v).body, small.moved(v));
    }
    // Bodies: the radius, or half of a side.
    let wide = |size: P| Body::rect((-size.0 / 2, -size.1 / 2), size);
    assert!(
        wide((2 * limit - 1, 0)).step(&PLAYER, &level.map(), (0, 0)).is_ok()
            || level.overlaps(&wide((2 * limit - 1, 0)))
    );
    assert_eq!(refused(&level, wide((2 * limit, 8)), (0, 0)).what, Quantity::BodySize);
    assert_eq!(refused(&level, wide((8, 2 * limit)), (0, 0)).what, Quantity::BodySize);
    assert_eq!(
        refused(&level, Body::disc((0, 0), limit), (0, 0)),
        RangeError { what: Quantity::BodySize, value: 1 << 28 }
    );
    // The end of the domain, one raw unit before and after it.
    let end = (1 << 29) - 1;
    let near = Body::rect((end - px(100), 0), at(50, 50));
    assert_eq!(go(&level, Response::Slide, near, at(50, 0)).body, near.moved(at(50, 0)));
    assert_eq!(refused(&level, near, (px(50) + 1, 0)), RangeError { what: Quantity::EndX, value: 1 << 29 });
    let near = Body::disc((0, px(100) - end), px(50));
    assert_eq!(go(&level, Response::Slide, near, at(0, -50)).body, near.moved(at(0, -50)));
    assert_eq!(refused(&level, near, (0, -px(50) - 1)), RangeError { what: Quantity::EndY, value: -(1 << 29) });
}

/// One raw unit of way or of body more is a cell more: over cells of 2^8 raw on both axes, beyond
/// the map's border on one, and in pieces.
#[test]
fn what_comes_to_too_many_cells() {
    let cells = i64::from(Mover::CELLS);
    let level = Level::new(&[".".repeat(1000).as_str(); 1000], 256);
    // A look meets up to two cells more than a length has. As one of several, it is a raw unit
    // larger on each side, and one for the rounding.
    let most = 511 * 256 - 5;
    let square = |side: i64| Body::rect((300, 300), (side, side));
    assert_eq!(go(&level, Response::Slide, square(most), (1, 1)).body, square(most).moved((1, 1)));
    assert_eq!(refused(&level, square(most + 1), (1, 1)), RangeError { what: Quantity::Cells, value: 513 * 513 });
    assert!(square(most + 1).step(&PLAYER, &level.map(), (0, 0)).is_ok());
    // A map of four rows has six with its surroundings.
    let flat = Level::new(&[".".repeat(1000).as_str(); 4], 256);
    assert_eq!(go(&flat, Response::Slide, square(4 * most), (0, 1)).work.iterations, 1);
    // A piece of a cell's length is over two or three cells: 2^17 of them are too many.
    let long = (1 << 28) - 1;
    let error = refused(&flat, square(256), (long, 0));
    assert!(error.what == Quantity::Cells && i64::from(error.value) > cells, "{error}");
    assert_eq!(go(&flat, Response::Slide, square(256), (1 << 22, 0)).work.iterations, 1);
    assert_eq!(
        error.to_string(),
        format!("the motion visits too many cells, {} or more: shorten it, or enlarge the cells", error.value)
    );

    let (map, mover) = (level.map(), PLAYER);
    let large = Aabb::new(Vec2::from_raw(300, 300), Vec2::from_raw(301 + most as i32, 301 + most as i32)).unwrap();
    let (step, is_range) =
        (Vec2::from_raw(1, 1), |e: MoveError| matches!(e, MoveError::Range(e) if e.what == Quantity::Cells));
    assert!(is_range(mover.move_and_slide(&map, &large, step).unwrap_err()));
    assert!(is_range(Walker::new(mover).walk(&map, &large, step, None).unwrap_err()));
    assert_eq!(map.cast_shape(&large, step, Inside::Hit).unwrap_err().what, Quantity::Cells);
    assert_eq!(mover.supported(&map, &large).unwrap_err().what, Quantity::Cells);
    let (left, right) = (Vec2::from_raw(300, large.max().y.to_bits()), large.max() + Vec2::from_raw(0, 99));
    let lift = Solid::new(Aabb::new(left, right).unwrap(), 1).unwrap().with_motion(Vec2::from_raw(0, -4)).unwrap();
    assert!(is_range(mover.ride(&map, &[lift], &large, Fx::ONE).unwrap_err()));
}

// bump.lua, rect_spec and responses_spec. An item is a map of one tile; goals become velocities.

/// A map of one tile: `x, y, side`.
fn tile(x: i64, y: i64, side: i64) -> Level {
    Level::new(&["#"], px(side)).with_origin(at(x, y))
}

#[test]
fn bump_detects_at_these_times() {
    for (from, other, goal, time, normal) in [
        ((1, 1), (5, 0), (6, 0), (6, 10), (-1, 0)),
        ((6, 0), (1, 0), (1, 1), (8, 10), (1, 0)),
        ((0, 0), (0, 4), (0, 5), (6, 10), (0, -1)),
        ((0, 4), (0, 0), (0, -1), (6, 10), (0, 1)),
    ] {
        let body = Body::rect(at(from.0, from.1), at(1, 1));
        let out = go(&tile(other.0, other.1, 1), Response::Touch, body, at(goal.0 - from.0, goal.1 - from.1));
        assert_eq!((out.axes(), out.hits.first().unwrap().toi.raw()), (vec![normal], parts(time.0, time.1)));
    }
}

/// Slide: (10,10,2,2) against (0,0,8,8).
#[test]
fn bump_slides_over_tunnels() {
    for (goal, touch, normal, end) in
        [((1, 4), (7, 8), (0, 1), (1, 8)), ((4, 1), (8, 7), (1, 0), (8, 1)), ((1, 1), (8, 8), (1, 0), (8, 1))]
    {
        let (level, body, v) = (tile(0, 0, 8), Body::rect(at(10, 10), at(2, 2)), at(goal.0 - 10, goal.1 - 10));
        let stopped = go(&level, Response::Touch, body, v);
        assert_eq!((stopped.body.position(), stopped.axes()), (at(touch.0, touch.1), vec![normal]));
        let out = go(&level, Response::Slide, body, v);
        assert_eq!(out.body.position(), at(end.0, end.1));
    }
}

#[test]
fn bump_bounces_over_tunnels() {
    for (goal, normal, end) in [((1, 4), (0, 1), (1, 12)), ((4, 1), (1, 0), (12, 1)), ((1, 1), (1, 0), (15, 1))] {
        let v = at(goal.0 - 10, goal.1 - 10);
        let out = go(&tile(0, 0, 8), Response::Bounce, Body::rect(at(10, 10), at(2, 2)), v);
        assert_eq!((out.body.position(), out.axes()), (at(end.0, end.1), vec![normal]));
    }
}

/// bump pushes a body that starts inside out against its motion. Here it is `Stuck` and the caller
/// decides (see scene 43).
#[test]
fn bump_overlap_at_the_start_is_refused() {
    for goal in [(4, 5), (5, 4), (2, 1), (1, 2)] {
        let v = at(goal.0 - 3, goal.1 - 3);
        assert!(matches!(
            Body::rect(at(3, 3), at(2, 2)).step(&PLAYER, &tile(0, 0, 8).map(), v),
            Err(MoveError::Stuck(_))
        ));
    }
}

// bump.lua, World_spec.

/// (0,0,32,100) becomes 8 x 25 tiles of 4.
#[test]
fn bump_touching_then_penetrating_is_one_collision() {
    let level = Level::new(&["########"; 25], px(4));
    let out = go(&level, Response::Touch, Body::rect(at(32, 50), at(20, 20)), at(-2, 0));
    assert_eq!((out.hits.len(), out.body.position(), out.axes()), (1, at(32, 50), vec![(1, 0)]));
    assert_eq!(out.hits.first().unwrap().toi.raw(), 0);
}

/// Items in a row: bump lists all, sorted. Here only the nearest is reported, and the other times
/// are those of the motion without it.
#[test]
fn bump_collisions_in_order() {
    let rows = [("#.#.#", 1), ("#.#..", 3), ("#....", 5)];
    for (row, time) in rows {
        let level = Level::new(&[row], px(10)).with_origin(at(50, 0));
        let out = go(&level, Response::Touch, Body::rect(at(110, 0), at(10, 10)), at(-100, 0));
        assert_eq!(out.hits.first().unwrap().toi.raw(), parts(time, 10));
    }
}

/// a (0,0,1,1), b (0,2,1,2), c (2,1,1,1), from (0,0) to (5,5): slides along c into the gap of its
/// own width.
#[test]
fn bump_moves_with_each_response() {
    let level = Level::new(&["...", "..#", "#..", "#.."], px(1));
    let a = Body::rect((0, 0), at(1, 1));
    let out = go(&level, Response::Slide, a, at(5, 5));
    assert_eq!((out.axes(), out.body.position()), (vec![(-1, 0)], at(1, 5)));
    let b = Level::new(&[".", ".", "#", "#"], px(1));
    let out = go(&b, Response::Touch, a, at(0, 5));
    assert_eq!((out.body.position(), out.hits.len(), out.remaining), (at(0, 1), 1, at(0, 4)));
    let out = go(&b, Response::Bounce, a, at(0, 5));
    assert_eq!((out.body.position(), out.v), (at(0, -3), at(0, -5)));
    // bump's cross passes through everything. Ours passes only through one-way faces, and slides
    // along the solid.
    assert_eq!(go(&b, Response::DropThrough, a, at(0, 5)).body.position(), at(0, 1));
    let b = Level::new(&[".", ".", "-", "-"], px(1));
    let out = go(&b, Response::DropThrough, a, at(0, 5));
    assert_eq!((out.body.position(), out.hits.first().unwrap().toi.raw()), (at(0, 5), parts(1, 5)));
}

// PixelRoot32, test_collision_system.

/// A circle of radius 5 from -20 to 20 through 0..10 is hit at 0.375: here a block of 10 with the
/// circle's height at its middle.
#[test]
fn pixelroot_swept_circle() {
    let out = go(&tile(0, -5, 10), Response::Touch, Body::disc(at(-20, 0), px(5)), at(40, 0));
    assert_eq!((out.hits.first().unwrap().toi.raw(), out.body.position()), (parts(375, 1000), at(-5, 0)));
    // Starting inside is its time 0, our `Stuck`.
    assert!(matches!(
        Body::disc(at(0, 0), px(5)).step(&PLAYER, &tile(0, -5, 10).map(), at(1, 0)),
        Err(MoveError::Stuck(_))
    ));
}

/// Its nine one-way cases, player 20 x 20, platform 60 x 16 at y = 40. Each changes one input of
/// the first.
mod pixelroot_one_way {
    use super::*;

    /// Three one-way tiles of 20; the player's lower side is at `bottom`.
    fn lands(row: &str, bottom: i64, v: P) -> bool {
        let level = Level::new(&["...", row, "..."], px(20)).with_origin(at(0, 20));
        let body = Body::rect((px(20), bottom - px(20)), at(20, 20));
        let out = go(&level, Response::Slide, body, v);
        assert_eq!(out.floor, out.flags == 2);
        out.floor
    }

    #[test]
    fn from_above_with_the_bottom_exactly_on_it() {
        assert!(lands("---", px(40), at(0, 5)));
    }

    #[test]
    fn from_one_raw_unit_lower_it_is_not_above() {
        assert!(!lands("---", px(40) + 1, at(0, 5)));
    }

    /// Its case "below" also moves upward; this one falls.
    #[test]
    fn below_and_falling() {
        assert!(!lands("---", px(70), at(0, 5)));
    }

    #[test]
    fn below_and_rising() {
        assert!(!lands("---", px(70), at(0, -5)) && !lands("---", px(70), at(0, -50)));
    }

    /// Its case "wrong normal": faces always look up here, so only the direction of the motion can
    /// differ.
    #[test]
    fn moving_up_from_above() {
        assert!(!lands("---", px(40), at(0, -5)));
    }

    #[test]
    fn large_step() {
        assert!(lands("---", px(20), at(0, 50)) && lands("---", px(20), at(0, 100)));
    }

    /// It has 20 -> 30 with no velocity and accepts. Here a motion is a velocity, and without one
    /// nothing is hit.
    #[test]
    fn stationary() {
        assert!(!lands("---", px(40), at(0, 0)) && lands("---", px(40), (0, 1)));
    }

    /// Its velocity changes sign between the frames. Only the motion of this frame counts.
    #[test]
    fn change_of_sign() {
        assert!(!lands("---", px(40), (0, -1)) && lands("---", px(40), (px(7), 1)));
    }

    /// Its case "flag off, always accept" is a solid tile here: it also stops bodies from below.
    #[test]
    fn solid_instead() {
        let level = Level::new(&["...", "###", "..."], px(20)).with_origin(at(0, 20));
        let out = go(&level, Response::Slide, Body::rect(at(20, 60), at(20, 20)), at(0, -5));
        assert!(out.ceiling && !out.floor);
    }
}

/// A ball that lands and slides a tenth of a unit into a corner, half a unit below its middle,
/// climbs it with the velocity that the floor left. The fall has not pressed it against both.
#[test]
fn lands_before_a_corner() {
    let level = Level::new(&[".....", ".....", "...#.", "#####"], px(16));
    let ball = Body::disc((px(48) - 2_064_384, px(32) - 1_015_808), 1_081_344);
    for response in [Response::Slide, Response::DropThrough] {
        let out = go(&level, response, ball, (2_950_813, 2_967_197));
        assert_eq!((out.hits.len(), out.floor, out.wall), (2, true, true), "{out:?}");
        assert!(out.v.0 > 2600 && out.v.1 < -89_000, "{out:?}");
    }
}

/// A closed room around a map is closed at any speed.
#[test]
fn nothing_leaves_a_closed_room() {
    let level = Level::new(&["....", "....", "...."], px(16)).with_outside(Outside::Solid);
    for v in [at(4000, 0), at(-4000, 1), at(3, 4000), at(0, -4000), at(4000, 4000), at(-4000, 3999)] {
        for response in RESPONSES {
            for body in [Body::rect(at(20, 20), at(5, 7)), Body::disc(at(20, 20), px(5))] {
                go(&level, response, body, v);
            }
        }
    }
}
