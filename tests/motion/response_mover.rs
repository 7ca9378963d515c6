//! Movers on surfaces with friction and restitution.

#![allow(clippy::cast_precision_loss, reason = "tests stop at the first surprise")]

use tilesat::{
    Aabb, AllShapes, Axis, Body, Circle, Fx, Mover, Ratio, Response, Surface, TileKind, TileKinds, TileMap,
    TileShape as Shape, Vec2, World, motion::Speed,
};
use tilesat_judge::{Random, frames};

const UP: Mover = Mover::platformer(Axis::NEG_Y);
const PX: i32 = 1 << 16;
const G: Vec2 = Vec2::from_raw(0, PX / 4);

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(Shape::SlopeBottomRight))
    .with(b'\\', TileKind::of(Shape::SlopeBottomLeft))
    .with(b'l', TileKind::of(Shape::MildLowBottomRight))
    .with(b'h', TileKind::of(Shape::MildHighBottomRight))
    .with(b'L', TileKind::of(Shape::MildLowBottomLeft))
    .with(b'H', TileKind::of(Shape::MildHighBottomLeft))
    .with(b'(', TileKind::of(Shape::ConcaveBottomLeft))
    .with(b')', TileKind::of(Shape::ConcaveBottomRight))
    .with(b'^', TileKind::of(Shape::ConvexBottomRight))
    .with(b'v', TileKind::of(Shape::ConvexBottomLeft))
    .with(b'"', TileKind::of(Shape::ConvexTopLeft))
    .with(b'`', TileKind::of(Shape::ConvexTopRight));

type Map = TileMap<'static, AllShapes>;

fn map(text: &'static str) -> Map {
    TileMap::of_ascii(text, &KINDS).unwrap()
}

fn disc(x: i32, y: i32, r: i32) -> Circle {
    Circle::new(Vec2::from_raw(x, y), Fx::from_bits(r)).unwrap()
}

fn rect(x: i32, y: i32, side: i32) -> Aabb {
    Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + side, y + side)).unwrap()
}

const HILL: &str = "        \n  /\\    \n /##\\   \n/####\\  \n########\n";
const MILD: &str = "        \n        \n  lhHL  \nlh####HL\n########\n";

/// The resting position of a body that is dropped on a surface. Returns the frames that it took.
fn comes_to_rest<B: Body + PartialEq + core::fmt::Debug>(
    map: &Map,
    start: B,
    v: Vec2,
    surface: Surface,
    frames: u32,
) -> u32 {
    let mover = UP.with_surface(surface);
    let (mut body, mut v, mut last, mut floor) = (start, v, 0, false);
    for frame in 0..frames {
        let moved = mover.move_and_slide(map, &body, v + G).unwrap();
        assert!(moved.velocity.length_squared() <= (v + G).length_squared());
        if moved.body != body || moved.velocity != Vec2::ZERO {
            last = frame;
        }
        (body, v, floor) = (moved.body, moved.velocity, moved.floor);
    }
    assert!(floor || last + 1 == frames, "rests on no floor: {body:?}");
    last
}

/// P17, slope with friction: below the angle of friction a body stays at its position, to the bit,
/// for a million frames.
#[test]
fn a_slope_with_friction_holds() {
    let grip = |percent| Surface::new(Ratio::ZERO, Ratio::percent(percent).unwrap());
    for (level, hold) in [(HILL, 100), (MILD, 50)] {
        let map = map(level);
        for x in [20 * PX, 23 * PX + 77, 70 * PX + 1] {
            let n = frames(100_000);
            assert!(comes_to_rest(&map, disc(x, 10 * PX, 4 * PX), Vec2::ZERO, grip(hold), n) < 100, "{level} {x}");
            assert!(comes_to_rest(&map, rect(x, 10 * PX, 7 * PX), Vec2::ZERO, grip(hold), n) < 100, "{level} {x}");
            // With a little less it slides down, all the way to the level's border.
            let slid = comes_to_rest(&map, disc(x, 10 * PX, 4 * PX), Vec2::ZERO, grip(hold - 10), 60);
            assert_eq!(slid, 59, "{level} {x}");
        }
    }
}

/// A slope that no tile has: the normal of a corner, of any length.
#[test]
fn a_body_rests_on_a_corner_with_friction() {
    let map = map("        \n        \n   ##   \n   ##   \n        \n");
    // Over the corner at (48, 32), so that the normal is up to 45 degrees off.
    for x in [45 * PX, 46 * PX + 12_345, 47 * PX] {
        let surface = Surface::new(Ratio::ZERO, Ratio::ONE);
        let n = frames(100_000);
        let last = comes_to_rest(&map, disc(x, 20 * PX, 5 * PX), Vec2::ZERO, surface, n);
        assert!(last < 100, "{x}: {last}");
    }
}

const PIPE: &str = "#          #\n#          #\n#          #\n#(        )#\n############\n";

/// In a quarter pipe a body comes to rest where the slope is as steep as the friction, or on the
/// way down. Thrown slowly or fast.
#[test]
fn a_pipe_with_friction_holds() {
    let map = map(PIPE);
    for percent in [5, 30, 100] {
        let surface = Surface::new(Ratio::ZERO, Ratio::percent(percent).unwrap());
        for (x, v) in [(22, 0), (25, 60_000), (90, 200_000), (160, -400_000)] {
            let v = Vec2::from_raw(v, 0);
            let last = comes_to_rest(&map, disc(x * PX, 30 * PX, 5 * PX), v, surface, frames(20_000));
            assert!(last < 1_500, "{percent} % from {x}: {last}");
            let last = comes_to_rest(&map, rect(x * PX, 30 * PX, 6 * PX), v, surface, frames(20_000));
            assert!(last < 1_500, "{percent} % from {x}: {last}");
        }
    }
}

/// Through a quarter pipe, weightless: friction takes `e^(-friction angle)` of the speed, about as
/// much in steps.
#[test]
fn a_pipe_brakes() {
    let map = map(PIPE);
    for (percent, kept) in [(0, 1.0), (20, 0.730), (50, 0.456)] {
        let mover = UP.with_surface(Surface::new(Ratio::ZERO, Ratio::percent(percent).unwrap()));
        for start in [PX / 2, 2 * PX] {
            // Near enough to the pipe that it loses nothing before: a body that slides along a
            // floor does not press on it.
            let (mut body, mut v) = (disc(100 * PX, 59 * PX, 5 * PX), Vec2::from_raw(start, 0));
            for _ in 0..400 {
                if v.raw().0 == 0 {
                    break;
                }
                let moved = mover.move_and_slide(&map, &body, v).unwrap();
                (body, v) = (moved.body, moved.velocity);
            }
            let left = f64::from(-v.raw().1) / f64::from(start);
            println!("{percent} %: {left:.3} of the speed");
            assert!(v.raw().0 == 0 && (left - kept).abs() < 0.06, "{percent} % from {start}: {v:?}");
        }
    }
}

/// Friction takes its share of gravity in each frame: 3 units per frame are gone after 48 of them,
/// at 1/16 per frame.
#[test]
fn a_box_skids_to_a_stop() {
    let map =
        map("                                                \n################################################\n");
    let mover = UP.with_surface(Surface::new(Ratio::ZERO, Ratio::percent(25).unwrap()));
    for direction in [1, -1] {
        let mut body = rect(300 * PX, 6 * PX, 10 * PX);
        let mut v = Vec2::from_raw(direction * 3 * PX, 0);
        for frame in 1..=48 {
            let moved = mover.move_and_slide(&map, &body, v + G).unwrap();
            (body, v) = (moved.body, moved.velocity);
            assert_eq!(v, Vec2::from_raw(direction * (3 * PX - frame * PX / 16), 0), "frame {frame}");
        }
    }
}

/// A ball whose bounces get lower comes to rest: it slides once it is slower than one frame's
/// gravity.
#[test]
fn a_bouncing_ball_comes_to_rest() {
    let mover_rest = |percent| Surface::new(Ratio::percent(percent).unwrap(), Ratio::ZERO).resting_below(G.y);
    for level in [
        "            \n            \n            \n############\n",
        "#          #\n#\\        /#\n##\\      /##\n############\n",
    ] {
        let map = map(level);
        for percent in [0, 30, 50, 80, 90, 95] {
            for x in [60 * PX, 70 * PX + 4_321] {
                let mover = UP.with_response(Response::Bounce).with_surface(mover_rest(percent));
                let (mut body, mut v, mut last) = (disc(x, 8 * PX, 5 * PX), Vec2::from_raw(0, 0), 0);
                for frame in 0..20_000 {
                    let moved = mover.move_and_slide(&map, &body, v + G).unwrap();
                    assert!(moved.velocity.length_squared() <= (v + G).length_squared());
                    if moved.body != body || moved.velocity != Vec2::ZERO {
                        last = frame;
                    }
                    (body, v) = (moved.body, moved.velocity);
                }
                println!("{percent} %: at rest after frame {last}");
                assert!(last < 1000, "{percent} % at {x}");
            }
        }
    }
}

const ROOM: &str = "\
##############
#  \"      #  #
#   /\\    #  #
#  /##\\      #
#     \"   ^# #
# lhHL       #
#        /\\  #
#\\    (#)   /#
##############
";

/// Endless elastic bounces: never faster than at the start, and slower only by the last bounce's
/// rounding.
#[test]
fn an_elastic_ball_keeps_its_speed() {
    let map = map(ROOM);
    for (start, mut v) in
        [((30, 30), Vec2::from_raw(100_000, -31_234)), ((150, 100), Vec2::from_raw(-7 * PX, 5 * PX + 3))]
    {
        let speed = Speed::of(v);
        let mover = Mover::new().with_response(Response::Bounce).with_surface(Surface::ELASTIC.with_speed(speed));
        let mut body = disc(start.0 * PX, start.1 * PX, 4 * PX);
        let mut least = f64::MAX;
        for _ in 0..frames(200_000) {
            let moved = mover.move_and_slide(&map, &body, v).unwrap();
            assert!(moved.velocity.length_squared() <= speed.squared(), "{body:?} by {v:?}: {moved:?}");
            (body, v) = (moved.body, moved.velocity);
            least = least.min(v.length_squared() as f64 / speed.squared() as f64);
        }
        assert!(!map.overlaps_circle(&body));
        println!("least speed {}", least.sqrt());
        assert!(least.sqrt() >= 0.999, "{least}");
    }
}

fn all_the_same<B: Body + PartialEq + core::fmt::Debug>(map: &Map, start: B, r: &mut Random) {
    for response in [Response::Slide, Response::Bounce, Response::Touch, Response::DropThrough] {
        let (plain, mut body) = (UP.with_response(response), start);
        let surface = plain.with_surface(Surface::ELASTIC);
        for _ in 0..300 {
            let v = Vec2::from_raw(r.around(1 << 20) as i32, r.around(1 << 20) as i32);
            let (a, b) = (plain.move_and_slide(map, &body, v), surface.move_and_slide(map, &body, v));
            assert_eq!(a, b, "{body:?} by {v:?}");
            body = a.unwrap().body;
        }
    }
}

/// No friction and no loss is the same as a mover without a surface.
#[test]
fn elastic_and_slick_is_the_plain_mover() {
    let mut r = Random::new(3);
    for _ in 0..20 {
        all_the_same(&map(ROOM), disc(30 * PX, 30 * PX, 4 * PX), &mut r);
        all_the_same(&map(ROOM), rect(30 * PX, 30 * PX, 9 * PX + 1), &mut r);
    }
}

fn wild<B: Body + core::fmt::Debug>(map: &Map, start: B, inside: impl Fn(&B) -> bool, r: &mut Random) {
    for _ in 0..30 {
        let ratio = |r: &mut Random| Ratio::percent(r.within(0, 100) as u8).unwrap();
        let surface = Surface::new(ratio(r), ratio(r)).resting_below(Fx::from_bits(r.within(0, 40_000) as i32));
        let response = [Response::Slide, Response::Bounce][r.below(2) as usize];
        let mover = UP.with_response(response).with_surface(surface);
        let (mut body, mut v) = (start, Vec2::from_raw(r.around(1 << 20) as i32, r.around(1 << 20) as i32));
        for _ in 0..1_000 {
            let pulled = v + G;
            let moved = mover.move_and_slide(map, &body, pulled).unwrap();
            assert!(moved.velocity.length_squared() <= pulled.length_squared(), "{body:?} by {pulled:?}: {moved:?}");
            assert!(!inside(&moved.body));
            (body, v) = (moved.body, moved.velocity);
        }
    }
}

/// Whatever the surface, nothing ends inside and nothing gains.
#[test]
fn nothing_gains_on_any_surface() {
    let mut r = Random::new(4);
    let map = map(ROOM);
    wild(&map, disc(30 * PX, 30 * PX, 4 * PX), |b| map.overlaps_circle(b), &mut r);
    wild(&map, rect(30 * PX, 30 * PX, 9 * PX + 1), |b| map.overlaps_aabb(b), &mut r);
}

/// The room seen in a mirror.
fn mirrored(text: &str) -> &'static str {
    let swap = |c: char| {
        let pairs = ["/\\", "lL", "hH", "()", "^v", "\"`"];
        let other = |pair: &str| pair.chars().find(|&p| p != c);
        pairs.iter().find(|pair| pair.contains(c)).and_then(|pair| other(pair)).unwrap_or(c)
    };
    let rows = text.lines().map(|row| row.chars().rev().map(swap).collect::<String>() + "\n");
    rows.collect::<String>().leak()
}

/// The same game in a mirror, bit for bit.
#[test]
fn a_mirrored_room() {
    let (here, there) = (map(ROOM), map(mirrored(ROOM)));
    let width = i32::from(here.width()) * 16 * PX;
    let mut r = Random::new(5);
    let flip = |v: Vec2| Vec2::from_raw(-v.raw().0, v.raw().1);
    for _ in 0..60 {
        let ratio = |r: &mut Random| Ratio::percent(r.within(0, 100) as u8).unwrap();
        let surface = Surface::new(ratio(&mut r), ratio(&mut r)).resting_below(Fx::from_bits(20_000));
        let surface =
            if r.one_in(2) { Surface::ELASTIC.with_speed(Speed::of(Vec2::from_raw(300_000, 0))) } else { surface };
        let response = [Response::Slide, Response::Bounce][r.below(2) as usize];
        let mover = UP.with_response(response).with_surface(surface);
        let mut a = disc(30 * PX, 30 * PX, 4 * PX);
        let mut v = Vec2::from_raw(r.around(1 << 19) as i32, r.around(1 << 19) as i32);
        for frame in 0..400 {
            let b = disc(width - a.centre().raw().0, a.centre().raw().1, 4 * PX);
            let (left, right) = (mover.move_and_slide(&here, &a, v + G), mover.move_and_slide(&there, &b, flip(v + G)));
            let (left, right) = (left.unwrap(), right.unwrap());
            let at = right.body.centre().raw();
            assert_eq!(
                (left.body.centre().raw(), left.velocity),
                ((width - at.0, at.1), flip(right.velocity)),
                "{frame}"
            );
            (a, v) = (left.body, left.velocity);
        }
    }
}
