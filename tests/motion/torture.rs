//! Scenes that break movers, numbered as in the survey that lists them, with the required results.
//! Whole units, y grows downward.

use tilesat::{Axis, MoveError, Mover, Outside, Response, motion::Stuck};
use tilesat_judge::motion::body::{Body, Outcome, RESPONSES, at, px};
use tilesat_judge::motion::judge::check;
use tilesat_judge::motion::level::Level;
use tilesat_judge::motion::{P, Time, add};

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);

fn slide(level: &Level, body: Body, v: P) -> Outcome {
    check(level, PLAYER, Response::Slide, &body, v)
}

/// `num / den` in parts of 2^30, rounded down.
fn parts(num: i64, den: i64) -> u32 {
    Time::new(num, den).floor() as u32
}

/// A floor with its top at y = 100 and a wall with its side at x = 100; cells of 20.
fn inside_corner() -> Level {
    Level::new(&["......#", "......#", "......#", "......#", "......#", "#######", "#######"], px(20))
        .with_origin(at(-20, 0))
}

#[test]
fn scene_1_and_2_are_in_motion_floor() {
    // Flat rows have a separate file. Here only: a body starts there as it does everywhere.
    let floor = Level::new(&["....", "####"], px(16));
    let out = slide(&floor, Body::rect(at(8, 8), at(8, 8)), at(3, 1));
    assert_eq!((out.body.position(), out.v), (at(11, 8), at(3, 0)));
}

#[test]
fn scene_4_box_into_an_inside_corner() {
    let level = inside_corner();
    let body = Body::rect(at(72, 72), at(16, 16));
    let out = slide(&level, body, at(40, 40));
    assert_eq!(out.body, Body::rect(at(84, 84), at(16, 16)));
    assert_eq!(out.v, (0, 0));
    assert!(out.floor && out.wall && !out.ceiling);
    // Both at the same moment and equally opposed: x first.
    assert_eq!(out.axes(), [(-1, 0), (0, -1)]);
    assert!(out.hits.iter().all(|h| h.toi.raw().abs_diff(parts(3, 10)) <= 4));
    assert_eq!(out.hits.first().unwrap().toi.raw(), parts(3, 10));
    // More opposed first, the same position in the end. No speed pushes it out of the room.
    for (v, first) in
        [(at(40, 39), (-1, 0)), (at(39, 40), (0, -1)), (at(4000, 4000), (-1, 0)), ((px(13), px(12)), (-1, 0))]
    {
        let near = Body::rect(at(83, 83), at(16, 16));
        let out = slide(&level, near, v);
        assert_eq!((out.body.position(), out.v, out.axes()[0]), (at(84, 84), (0, 0), first));
    }
}

#[test]
fn scene_5_circle_into_an_inside_corner() {
    let level = inside_corner();
    let out = slide(&level, Body::disc(at(80, 80), px(8)), at(40, 40));
    assert_eq!((out.body, out.v), (Body::disc(at(92, 92), px(8)), (0, 0)));
    assert_eq!(out.axes(), [(-1, 0), (0, -1)]);
    assert!(out.floor && out.wall);
}

/// Box [20,40] x [3,30], as tiles of 1. The corner of a square-cornered sum would be hit at 0.375.
#[test]
fn scene_6_outside_corner_is_round() {
    let rows = ["####################"; 27];
    let level = Level::new(&rows, px(1)).with_origin(at(20, 3));
    let out = check(&level, PLAYER, Response::Touch, &Body::disc((0, 0), px(5)), at(40, 0));
    let hit = out.hits.first().unwrap();
    assert!(hit.index >= 4);
    // A lower bound, less than a raw unit of the way early.
    assert!(hit.toi.raw() <= parts(4, 10) && hit.toi.raw() + 8 >= parts(4, 10), "{hit:?}");
    let c = out.body.position();
    assert!(c.0 <= px(16) && c.0 >= px(16) - 2 && c.1 == 0, "{c:?}");
    // (-0.8, -0.6)
    let (x, y) = hit.axis.unit().raw();
    assert!(
        (f64::from(x) / f64::from(1 << 30) + 0.8).abs() < 1e-5
            && (f64::from(y) / f64::from(1 << 30) + 0.6).abs() < 1e-5
    );
}

/// The centre passes (15.5, 15.5), 6.36 from the corner (20, 20).
#[test]
fn scene_7_outside_corner_miss() {
    let level = Level::new(&["##", "##"], px(20)).with_origin(at(20, 20));
    for response in RESPONSES {
        let start = Body::disc((px(11) / 2, px(51) / 2), px(5));
        let out = check(&level, PLAYER, response, &start, at(20, -20));
        assert!(out.hits.is_empty());
        assert_eq!(out.body.position(), (px(51) / 2, px(11) / 2));
    }
}

/// bump's perfect corner: x first. With the axes swapped the mirrored tie is x again (documented),
/// so the end is not transposed.
#[test]
fn scene_10_box_corner_exactly_onto_a_corner() {
    let level = Level::new(&["#"], px(8));
    let out = slide(&level, Body::rect(at(10, 10), at(2, 2)), at(-9, -9));
    assert_eq!((out.axes(), out.body.position()), (vec![(1, 0)], at(8, 1)));
    assert_eq!(out.hits.first().unwrap().toi.raw(), parts(2, 9));
    // One raw unit more speed on an axis gets the box above (beside) the tile first, and then
    // swapped axes give the swapped result.
    let x = slide(&level, Body::rect(at(10, 10), at(2, 2)), (-px(9) - 1, -px(9)));
    let y = slide(&level, Body::rect(at(10, 10), at(2, 2)), (-px(9), -px(9) - 1));
    assert_eq!(x.axes(), [(0, 1)]);
    assert_eq!(y.axes(), [(1, 0)]);
    assert_eq!(x.body.position(), {
        let p = y.body.position();
        (p.1, p.0)
    });
}

/// bump's nasty corner: (0,16,16,16) moves by (-1,-1) beside (16,0,16,16); they share the corner
/// (16,16).
#[test]
fn scene_11_shared_corner_is_no_hit() {
    let level = Level::new(&["."], px(16));
    let level = Level { tiles: b".#".to_vec(), width: 2, ..level };
    for body in [Body::rect(at(0, 16), at(16, 16)), Body::disc(at(8, 24), px(8))] {
        let out = slide(&level, body, at(-1, -1));
        assert!(out.hits.is_empty());
        assert_eq!(out.body, body.moved(at(-1, -1)));
    }
    // Along the shared lines as well, in both directions.
    for v in [(0, -px(1)), (px(1), 0), (0, px(1)), (-px(1), 0)] {
        assert!(slide(&level, Body::rect(at(0, 16), at(16, 16)), v).hits.is_empty());
    }
    // Into the corner it is solid.
    assert_eq!(slide(&level, Body::rect(at(0, 16), at(16, 16)), at(1, -1)).hits.len(), 1);
}

/// A gap of one cell in a wall, and a body of exactly that width.
#[test]
fn scene_30_through_a_gap_of_ones_own_width() {
    let rows = ["######.######", "######.######", "######.######", "######.######"];
    let level = Level::new(&rows, px(16));
    let x = px(96);
    // Aligned it passes at any speed, straight down and up.
    for body in [Body::rect((x, -px(40)), at(16, 16)), Body::disc((x + px(8), -px(32)), px(8))] {
        for speed in [1, 7, 40, 140, 4000] {
            let out = slide(&level, body, at(0, speed));
            assert!(out.hits.is_empty(), "{out:?}");
            assert_eq!(out.body, body.moved(at(0, speed)));
        }
        // Inside it, pressing against a side is no obstacle either.
        let inside = body.moved(at(0, 60));
        for v in [at(3, 20), at(-3, 20), at(9, -20), (1, px(30))] {
            let out = slide(&level, inside, v);
            assert_eq!((out.body, out.v), (inside.moved((0, v.1)), (0, v.1)));
        }
    }
    // A diagonal that is aligned at the mouth enters. One raw unit beside, it stops on the top.
    let corner = |dx: i64| Body::rect((x - px(30) + dx, -px(46)), at(16, 16));
    let hit = slide(&level, corner(-1), at(90, 90));
    assert!(hit.floor && hit.body.position().1 == -px(16));
    let enters = slide(&level, corner(0), at(90, 90));
    assert_eq!(enters.body.position(), add((x, -px(46)), at(0, 90)));
    let late = slide(&level, corner(1), at(90, 90));
    assert_eq!(late.body.position().1, -px(16));
    // A circle of that width, one raw unit beside the middle, is stopped by the edge and never
    // wedged inside of it.
    for dx in [-1, 1] {
        let out = slide(&level, Body::disc((x + px(8) + dx, -px(32)), px(8)), at(0, 140));
        assert!(!out.hits.is_empty());
    }
}

/// A block of ten by ten; the body starts deep inside.
#[test]
fn scene_43_start_deep_inside() {
    let rows = ["##########"; 10];
    for outside in [Outside::Empty, Outside::Solid, Outside::Edge] {
        let level = Level::new(&rows, px(16)).with_outside(outside);
        let map = level.map();
        for body in [
            Body::rect(at(80, 80), at(10, 12)),
            Body::disc(at(85, 80), px(6)),
            Body::disc(at(80, 80), 0),
            Body::rect(at(80, 80), (0, 0)),
        ] {
            for v in [at(5, 5), at(-5, 0), at(0, 300), at(4000, -4000)] {
                for response in RESPONSES {
                    let refused = body.step(&PLAYER.with_response(response), &map, v).unwrap_err();
                    let (x, y) = body.position();
                    assert_eq!(refused, MoveError::Stuck(Stuck { at: (x as i32, y as i32) }), "{body:?} by {v:?}");
                }
            }
            // Nothing moves, and the call does not look at the level.
            let still = body.step(&PLAYER, &map, (0, 0)).unwrap();
            assert_eq!((still.body, still.work.checks, still.hits.len()), (body, 0, 0));
        }
    }
    // One raw unit inside is inside; touching is not.
    let level = Level::new(&rows, px(16));
    let beside = Body::rect((-px(10), px(80)), at(10, 10));
    assert!(beside.step(&PLAYER, &level.map(), at(-1, 0)).is_ok());
    assert!(matches!(beside.moved((1, 0)).step(&PLAYER, &level.map(), at(-1, 0)), Err(MoveError::Stuck(_))));
}

/// One-way from the side: only a body entirely above it, or touching it, may stand.
#[test]
fn scene_31_one_way_from_the_side() {
    let level = Level::new(&["......", "..----", "......"], px(20)).with_origin(at(0, 20));
    for (bottom, stands) in [(px(39), true), (px(40), true), (px(40) + 1, false), (px(41), false)] {
        // The box's side, the circle's middle, is beside the platform and comes over it in the
        // first frame.
        for start in [Body::rect((px(24), bottom - px(16)), at(16, 16)), Body::disc((px(36), bottom - px(8)), px(8))] {
            let over = slide(&level, start, at(4, 0));
            assert_eq!((over.body, over.hits.len()), (start.moved(at(4, 0)), 0), "the side is not there");
            let (mut body, mut v) = (over.body, over.v);
            for _ in 0..10 {
                let out = slide(&level, body, (v.0, v.1 + (1 << 14)));
                (body, v) = (out.body, out.v);
            }
            let (_, hi) = body.bounds();
            assert_eq!((hi.1 == px(40), v.1 == 0), (stands, stands), "bottom {bottom}: {body:?}");
            assert_eq!(v.0, px(4));
        }
    }
}

/// One-way: a large step down through the top, standing, a jump from below, and a jump whose apex
/// is exactly at the plane.
#[test]
fn scene_32_one_way_steps() {
    let level = Level::new(&["...", "---", "..."], px(20)).with_origin(at(0, 20));
    for start in [Body::rect(at(20, -20), at(20, 20)), Body::disc(at(30, -10), px(10))] {
        let landed = slide(&level, start, at(0, 60));
        assert_eq!((landed.body, landed.v), (start.moved(at(0, 40)), (0, 0)));
        assert!(landed.floor && landed.flags == 2 && landed.hits.first().unwrap().one_way);
        let fast = slide(&level, start, at(0, 4000));
        assert_eq!(fast.body, landed.body);
        let standing = slide(&level, landed.body, (0, 1));
        assert_eq!((standing.body, standing.v), (landed.body, (0, 0)));
        assert_eq!(slide(&level, landed.body, (0, 0)).body, landed.body);
        // From below: up through it, at any height, without a hit.
        let below = landed.body.moved(at(0, 40));
        for v in [at(0, -10), at(0, -30), at(5, -50), at(0, -4000)] {
            let out = slide(&level, below, v);
            assert!(out.hits.is_empty());
            assert_eq!(out.body, below.moved(v));
        }
        // Half way through and falling: it falls on.
        let half = landed.body.moved((0, 1));
        assert!(slide(&level, half, at(0, 30)).hits.is_empty());
        // The apex exactly at the plane counts as in front: it lands.
        let apex = slide(&level, below, at(0, -40));
        assert_eq!(apex.body, landed.body);
        let out = slide(&level, apex.body, at(2, 3));
        assert_eq!((out.body, out.v), (landed.body.moved(at(2, 0)), at(2, 0)));
        // One raw unit below it does not.
        let short = slide(&level, below, (0, -px(40) + 1));
        assert!(slide(&level, short.body, at(2, 3)).hits.is_empty());
    }
}

/// Cross passes one-way faces and reports them. It is no floor then. The solid below still is.
#[test]
fn cross_drops_through_a_one_way() {
    let level = Level::new(&["...", "---", "...", "###"], px(20));
    let start = Body::rect(at(20, 0), at(20, 20));
    let out = check(&level, PLAYER, Response::DropThrough, &start, at(0, 10));
    assert_eq!((out.body, out.v), (start.moved(at(0, 10)), at(0, 10)));
    assert!(!out.floor && out.flags == 2 && out.hits.len() == 1);
    let out = check(&level, PLAYER, Response::DropThrough, &start, at(1, 90));
    assert_eq!(out.body.position().1, px(40));
    assert!(out.floor && out.hits.len() == 2);
    assert_eq!(out.v, at(1, 0));
}

/// A one-way face that a ball passes does not change what it touches: it falls along a wall with a
/// gap, and is held between the wall and a corner.
#[test]
fn a_face_that_is_passed_changes_nothing() {
    for one_way in ['-', '.'] {
        let rows = ["..#", "..#", "...", "..#", "?.#", ".##"].map(|row| row.replace('?', &one_way.to_string()));
        let level = Level::new(&rows.each_ref().map(String::as_str), px(16)).with_origin(at(80, 0));
        let ball = Body::disc((6_164_626, 1_175_406), 1_175_406);
        let out = check(&level, PLAYER, Response::DropThrough, &ball, (1_659_218, 3_498_314));
        assert_eq!((out.v, out.body.position().0), ((0, 0), 6_164_626));
    }
}

/// Between two corners, as far apart as a capsule is wide, roundings turn its way into the one that
/// it met last.
#[test]
fn a_gap_between_corners_as_wide_as_a_capsule() {
    let level = Level::new(&["##.##", "#...#", "#...#", "##...", "####."], px(24)).with_origin(at(48, 192));
    let capsule = Body::Disc { c: (7_078_408, 15_204_742), core: (0, px(16)), r: px(20) };
    let out = check(&level, PLAYER, Response::DropThrough, &capsule, (-36_452, -27_310));
    assert!(out.hits.len() == 4 && out.v.0 < 0 && out.v.1 < 0);
}

/// On a flat floor with gravity and without friction. `scenes` has other positions and runs without
/// a judge.
#[test]
fn scene_49_resting_ten_thousand_ticks() {
    let level = Level::new(&["......", "######"], px(16));
    for start in [Body::rect(at(5, 4), at(12, 12)), Body::disc(at(40, 8), px(8))] {
        let (mut body, mut v) = (start, (0, 0));
        for _ in 0..10_000 {
            let out = slide(&level, body, (v.0, v.1 + (1 << 14)));
            (body, v) = (out.body, out.v);
            assert_eq!((body, v), (start, (0, 0)));
        }
    }
}
