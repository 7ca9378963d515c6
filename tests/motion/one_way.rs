//! One-way faces in all four directions, as tiles and as chains, for boxes and circles. Each case
//! changes one input of a landing.

use tilesat::{Axis, Fx, Mover, Outside, Path, PathKind, Response, SegmentMap};
use tilesat_judge::rooms::body::{Body, Outcome, vec2};
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX};
use tilesat_judge::shapes::level::Level;

const CELL: i64 = 20 * PX;
const ONE_WAY: u8 = 34;

/// Up, down, left and right, each in a mirror too.
const VIEWS: [&[View]; 8] = [
    &[],
    &[View::MirrorX],
    &[View::MirrorY],
    &[View::MirrorX, View::MirrorY],
    &[View::Transpose],
    &[View::Transpose, View::MirrorX],
    &[View::Transpose, View::MirrorY],
    &[View::Transpose, View::MirrorX, View::MirrorY],
];

fn direction(views: &[View], v: P) -> P {
    views.iter().fold(v, |v, view| view.direction(v))
}

/// A picture of cells of 20 units: `-` one-way, `#` solid, `/` and `\` slopes.
fn level(rows: &[&str]) -> Level {
    let id = |c: char| match c {
        '.' => 0,
        '#' => 1,
        '-' => ONE_WAY,
        '/' => 8,
        '\\' => 9,
        _ => panic!("no shape {c}"),
    };
    let tiles = rows.iter().flat_map(|row| row.chars().map(id)).collect();
    let (width, height) = (rows[0].len() as i64, rows.len() as i64);
    Level { tiles, width, height, cell: CELL, x: 0, y: 0, outside: Outside::Empty }
}

/// The level of a scene.
enum Stage {
    Tiles(Level),
    /// Corners, left to right.
    Chain(Vec<P>),
}

impl Stage {
    /// The body's motion, turned upright again.
    fn step(&self, views: &[View], mover: &Mover, body: Body, v: P) -> Outcome {
        let there = views.iter().fold(body, |b, view| view.body(b));
        let d = direction(views, v);
        let out = match self {
            Self::Tiles(level) => {
                let level = views.iter().fold(level.clone(), |l, view| view.level(&l));
                there.step(mover, &level.all(), d).unwrap()
            }
            Self::Chain(points) => {
                let mut points: Vec<P> = points.iter().map(|p| direction(views, *p)).collect();
                // The front is to one side: an odd number of mirrors turns the chain.
                if views.len() % 2 == 1 {
                    points.reverse();
                }
                let points: Vec<_> = points.into_iter().map(vec2).collect();
                let paths = [Path::new(PathKind::OneWay, &points).with_flags(2)];
                let cell = Fx::from_bits(CELL as i32);
                let mut bytes = vec![0; SegmentMap::measure(&paths, cell).unwrap().bytes()];
                SegmentMap::build_into(&paths, cell, &mut bytes).unwrap();
                there.step(mover, &SegmentMap::from_bytes(&bytes).unwrap(), d).unwrap()
            }
        };
        let back = |v: P| views.iter().rev().fold(v, |v, view| view.direction(v));
        Outcome { body: views.iter().rev().fold(out.body, |b, view| view.body(b)), v: back(out.v), ..out }
    }
}

fn mover(views: &[View]) -> Mover {
    let up = direction(views, (0, -1));
    Mover::platformer(Axis::new(up.0 as i32, up.1 as i32))
}

/// A platform 60 wide at y = 40, x from 60 to 120.
fn stages() -> [Stage; 3] {
    [
        Stage::Tiles(level(&[".........", ".........", "...---...", "........."])),
        Stage::Chain(vec![(60 * PX, 40 * PX), (120 * PX, 40 * PX)]),
        Stage::Chain(vec![(60 * PX, 40 * PX), (75 * PX, 40 * PX), (75 * PX + 1, 40 * PX), (120 * PX, 40 * PX)]),
    ]
}

/// A player of 20 x 20 with its left side at `x` and its lower side at `y`, as a box and as a
/// circle.
fn players(x: i64, y: i64) -> [Body; 2] {
    [Body::Rect((x, y - 20 * PX), (20 * PX, 20 * PX)), Body::Disc((x + 10 * PX, y - 10 * PX), 10 * PX)]
}

/// `lands` at this part of the way: `Some((num, den))`. The motion across continues.
fn case(x: i64, y: i64, v: P, lands: Option<i64>) {
    for stage in stages() {
        for views in VIEWS {
            for body in players(x, y) {
                let out = stage.step(views, &mover(views), body, v);
                let due = (v.0, lands.unwrap_or(v.1));
                assert_eq!(out.body, body.moved(due), "{views:?} {body:?} by {v:?}: {out:?}");
                assert_eq!(out.floor, lands.is_some(), "{views:?} {body:?} by {v:?}: {out:?}");
                assert_eq!(out.v, (v.0, if lands.is_some() { 0 } else { v.1 }));
                let hit = out.hits.first();
                assert!(hit.is_none_or(|h| h.one_way && out.hits.len() == 1), "{out:?}");
                assert_eq!(hit.is_some(), lands.is_some());
            }
        }
    }
}

/// The nine cases, one input changed at a time.
#[test]
fn one_input_at_a_time() {
    let (x, top) = (80 * PX, 40 * PX);
    // It lands: from exactly above, from higher, from much higher in one step, one raw unit higher.
    case(x, top, (0, 10 * PX), Some(0));
    case(x, top - 10 * PX, (0, 30 * PX), Some(10 * PX));
    case(x, top - 20 * PX, (0, 1000 * PX), Some(20 * PX));
    case(x, top - 1, (0, 2), Some(1));
    case(x, top, (0, 1), Some(0));
    // Across it, standing and landing.
    case(x, top, (-7 * PX, PX), Some(0));
    case(x, top - 4 * PX, (7 * PX, 8 * PX), Some(4 * PX));
    // The position: below, one raw unit below, half through.
    case(x, top + 50 * PX, (0, 10 * PX), None);
    case(x, top + 1, (0, 10 * PX), None);
    case(x, top + 5 * PX, (0, 10 * PX), None);
    // The direction: up from above, from below, through; the length: up to it and not into it.
    case(x, top, (0, -5 * PX), None);
    case(x, top + 50 * PX, (0, -5 * PX), None);
    case(x, top + 10 * PX, (0, -40 * PX), None);
    case(x, top + 30 * PX, (3 * PX, -100 * PX), None);
    case(x, top - 10 * PX, (0, 10 * PX), None);
    case(x, top - 10 * PX, (0, 10 * PX + 1), Some(10 * PX));
    // No motion, and none into it.
    case(x, top, (0, 0), None);
    case(x, top, (11 * PX, 0), None);
}

/// A jump whose highest point is exactly on the plane lands. One raw unit lower it does not.
#[test]
fn the_top_of_a_jump() {
    for (apex, lands) in [(40 * PX, true), (40 * PX + 1, false), (40 * PX - 1, true)] {
        for stage in stages() {
            for views in VIEWS {
                for body in players(80 * PX, 60 * PX) {
                    let up = stage.step(views, &mover(views), body, (0, apex - 60 * PX));
                    assert!(up.hits.is_empty());
                    let down = stage.step(views, &mover(views), up.body, (0, 9 * PX));
                    assert_eq!(down.floor, lands, "{views:?} {down:?}");
                    assert_eq!(down.body.bounds().1.1, if lands { 40 * PX } else { apex + 9 * PX });
                }
            }
        }
    }
}

/// Torture scene 31: in from the side at heights around the plane, nothing stops it. Then it stands
/// if its lower side is not below.
#[test]
fn from_the_side() {
    for raw in [-PX, -2, -1, 0, 1, 2, PX, 10 * PX] {
        for from in [20 * PX, 140 * PX] {
            for stage in stages() {
                for views in VIEWS {
                    for body in players(from, 40 * PX + raw) {
                        let d = (80 * PX - from, 0);
                        let out = stage.step(views, &mover(views), body, d);
                        assert!(out.hits.is_empty() && out.body == body.moved(d), "{views:?} {out:?}");
                        let fall = stage.step(views, &mover(views), out.body, (0, 20 * PX));
                        assert_eq!(fall.floor, raw <= 0, "{views:?} {raw} {fall:?}");
                        assert_eq!(fall.body.bounds().1.1, if raw <= 0 { 40 * PX } else { 60 * PX + raw });
                    }
                }
            }
        }
    }
}

/// At the corner: a body that reaches the plane beside the platform passes. A body with a raw unit
/// over it, or that moves over its end there, lands. Boxes; for a circle, its lowest point decides.
#[test]
fn at_the_corner() {
    for (stage, views) in stages().iter().flat_map(|s| VIEWS.map(|v| (s, v))) {
        for beside in [-3, -1, 0, 1, 3] {
            // The right side is at x = 60 + beside when the lower side is at the plane, half way.
            for dx in [10 * PX, 0, -10 * PX] {
                let [b, c] = players(40 * PX + beside - dx, 30 * PX);
                let v = (2 * dx, 20 * PX);
                let out = stage.step(views, &mover(views), b, v);
                let lands = beside > 0 || (beside == 0 && dx > 0);
                assert_eq!(out.floor, lands, "{views:?} {beside} {dx}: {out:?}");
                let c = c.moved((10 * PX, 0));
                let out = stage.step(views, &mover(views), c, v);
                assert_eq!(out.floor, beside >= 0, "{views:?} {beside} {dx}: {out:?}");
            }
        }
    }
}

/// Between two of them there is no gap, for bodies of any width, even zero. Nor between them and
/// solid tiles or slopes.
#[test]
fn no_fall_between_two() {
    let rows: [&[&str]; 3] = [
        &["........", "........", "--------"],
        &["........", "........", "--#-#---"],
        &["........", "........", "-##-\\.."],
    ];
    for row in &rows[..2] {
        let stage = Stage::Tiles(level(row));
        for views in VIEWS {
            for seam in (1..8).map(|k| k * CELL) {
                for half in [0, 1, 2, 5 * PX, 10 * PX] {
                    for off in [-half - 1, -half, -1, 0, 1, half, half + 1] {
                        for (dx, speed) in [(0, 1), (0, 40 * PX), (PX / 3, PX / 4), (-7 * PX, 3 * PX), (1, 9 * PX)] {
                            let middle = (seam + off, 40 * PX - half);
                            let size = (2 * half, 2 * half);
                            for body in [Body::Rect((middle.0 - half, middle.1 - half), size), Body::Disc(middle, half)]
                            {
                                let out = stage.step(views, &mover(views), body, (dx, speed));
                                assert_eq!(
                                    out.body,
                                    body.moved((dx, 0)),
                                    "{views:?} {body:?} by {dx} {speed}: {out:?}"
                                );
                                assert!(out.floor && !out.wall);
                            }
                        }
                    }
                }
            }
        }
    }
}

/// Beside a block: up through it along the block, a stop at the block, flush from one to the other.
#[test]
fn beside_a_block_and_a_slope() {
    let stage = Stage::Tiles(level(&["......", "......", "--##--", "......", "......"]));
    for views in VIEWS {
        for body in players(20 * PX, 70 * PX) {
            // Along the block's side, and pressed to it.
            for dx in [0, 5 * PX] {
                let out = stage.step(views, &mover(views), body, (dx, -50 * PX));
                assert_eq!((out.body, out.wall), (body.moved((0, -50 * PX)), dx != 0), "{views:?} {out:?}");
            }
            // From below into the block, half under it.
            let out = stage.step(views, &mover(views), body.moved((15 * PX, 20 * PX)), (0, -50 * PX));
            assert!((out.ceiling || out.wall) && out.body.bounds().0.1 >= 50 * PX, "{views:?} {out:?}");
        }
        // From one to the other, both ways.
        for dx in [9 * PX, -9 * PX] {
            for mut body in players(50 * PX - dx, 40 * PX) {
                for _ in 0..4 {
                    let out = stage.step(views, &mover(views), body, (dx, 2 * PX));
                    assert_eq!((out.body, out.v, out.wall), (body.moved((dx, 0)), (dx, 0), false), "{views:?}");
                    body = out.body;
                }
            }
        }
    }
    // Up a slope on to it.
    let one = Stage::Tiles(level(&[".......", ".......", "..../--", "#####..", "......."]));
    let two = Stage::Tiles(level(&[".......", ".......", "...../-", "..../#.", "#####.."]));
    for (stage, floor) in [(one, 60), (two, 80)] {
        for views in &VIEWS[..4] {
            for mut body in players(15 * PX, floor * PX) {
                for _ in 0..120 {
                    let out = stage.step(views, &mover(views), body, (3 * PX, PX));
                    assert!(out.floor && !out.wall, "{views:?} {out:?}");
                    body = out.body;
                    if body.middle().0 > 128 * PX {
                        break;
                    }
                }
                assert!(body.bounds().1.1 <= 40 * PX + 2 && body.middle().0 > 128 * PX, "{views:?} {body:?}");
            }
        }
    }
}

/// Dropping through: with every response, reported once, no floor. A body half on a block stays.
/// Without the setting it lands again.
#[test]
fn drop_through() {
    let low = Stage::Tiles(level(&["......", "------", "------", "......", "######"]));
    let mixed = Stage::Tiles(level(&["......", "......", "--##--"]));
    for views in VIEWS {
        let all = [Response::Slide, Response::DropThrough, Response::Bounce, Response::Touch];
        for response in all {
            let drops = mover(views).with_response(response).with_drop_through(true);
            for body in players(30 * PX, 20 * PX) {
                // Through two of them. The first is reported.
                let out = low.step(views, &drops, body, (PX, 30 * PX));
                assert_eq!((out.body, out.v, out.hits.len()), (body.moved((PX, 30 * PX)), (PX, 30 * PX), 1), "{out:?}");
                assert!(!out.floor && out.hits.first().unwrap().one_way && out.hits.first().unwrap().toi.raw() == 0);
                // On to the block below.
                let out = low.step(views, &drops, body, (0, 100 * PX));
                assert!(out.floor && out.body.bounds().1.1 <= 80 * PX);
                if response != Response::Bounce {
                    assert_eq!(out.body.bounds().1.1, 80 * PX);
                }
                // In the next frame it is no longer above the first, and lands on the second.
                let out = low.step(views, &drops, body, (0, PX));
                let next = low.step(views, &mover(views), out.body, (0, 60 * PX));
                assert!(next.floor && next.body.bounds().1.1 == 40 * PX, "{next:?}");
            }
            for body in players(25 * PX, 40 * PX) {
                let out = mixed.step(views, &drops, body, (0, 5 * PX));
                let stays = out.floor && (out.body == body || response == Response::Bounce);
                assert!(matches!(body, Body::Disc(..)) || stays, "{out:?}");
            }
        }
    }
}
