//! Balls and boxes that bounce for a long time. They are never in a wall and never too fast.
//! Elastic ones hardly slow down, and damped ones come to rest.
//!
//! The judge is exact and knows only the corners of a convex room. `TILESAT_FRAMES` sets the frames
//! of a run (default 2000, or 3000 in long runs).

use tilesat::{Aabb, AllShapes, Axis, Body, Circle, Fx, Grid, Mover, Path, PathKind, Ratio, Response, SegmentMap};
use tilesat::{Surface, TileKind, TileKinds, TileMap, Vec2, World, motion::Speed};
use tilesat_judge::Random;

type P = (i64, i64);

const PX: i64 = 1 << 16;

fn frames() -> u64 {
    tilesat_judge::frames(tilesat_judge::thorough(2_000, 3_000))
}

fn vec2(p: P) -> Vec2 {
    Vec2::from_raw(i32::try_from(p.0).unwrap(), i32::try_from(p.1).unwrap())
}

fn len2(v: Vec2) -> i128 {
    let (x, y) = v.raw();
    i128::from(x) * i128::from(x) + i128::from(y) * i128::from(y)
}

/// A convex room by its corners, with the inside on the left of each side if y grows up. Or a disc
/// around (0, 0), by its radius.
struct Room {
    corners: Vec<P>,
    radius: Option<i64>,
}

impl Room {
    fn of(units: &[P]) -> Self {
        Self { corners: units.iter().map(|p| (p.0 * PX, p.1 * PX)).collect(), radius: None }
    }

    /// 256 units by 256.
    fn square() -> Self {
        Self::of(&[(0, 0), (256, 0), (256, 256), (0, 256)])
    }

    /// A disc of 128 units.
    fn round() -> Self {
        Self { radius: Some(128 * PX), ..Self::of(&[(-128, -128), (128, -128), (128, 128), (-128, 128)]) }
    }

    /// A valley whose sides rise 1:`run` and 1:1 from (0, 0), under a lid: y grows downward.
    fn valley(run: i64) -> Self {
        Self::of(&[(0, 0), (-160, -160), (160 * run, -160)])
    }

    /// 13 walls of odd angles, with corners on odd raw units.
    fn askew() -> Self {
        let corner = |k: i32| {
            let angle = (f64::from(k) + 0.23) / 13.0 * std::f64::consts::TAU;
            [angle.cos(), angle.sin()].map(|c| (c * 90.0 * 65536.0) as i64 | 1)
        };
        Self { corners: (0..13).map(corner).map(|[x, y]| (x, y)).collect(), radius: None }
    }

    fn bytes(&self) -> Vec<u8> {
        let points: Vec<Vec2> = self.corners.iter().chain(self.corners.first()).map(|&p| vec2(p)).collect();
        let paths = [Path::new(PathKind::Wall, &points)];
        let size = SegmentMap::measure(&paths, Fx::from_num(32)).unwrap();
        let mut out = vec![0; size.bytes()];
        SegmentMap::build_on(&paths, size.grid(), &mut out).unwrap();
        out
    }

    /// Whether a body is in no wall. With d along a side and m from its start to the point, the
    /// point is (d x m) / |d| inside.
    fn holds(&self, body: &impl Judged) -> bool {
        let (points, r) = body.points();
        let in_disc = |radius: i64| {
            let square = |c: &P| i128::from(c.0) * i128::from(c.0) + i128::from(c.1) * i128::from(c.1);
            points.iter().all(|c| square(c) <= i128::from(radius - r).pow(2))
        };
        let n = self.corners.len();
        self.radius.is_none_or(in_disc)
            && (0..n).all(|i| {
                let (a, b) = (self.corners[i], self.corners[(i + 1) % n]);
                let d = (b.0 - a.0, b.1 - a.1);
                points.iter().all(|c| {
                    let cross = i128::from(d.0) * i128::from(c.1 - a.1) - i128::from(d.1) * i128::from(c.0 - a.0);
                    let length2 = i128::from(d.0) * i128::from(d.0) + i128::from(d.1) * i128::from(d.1);
                    cross >= 0 && cross * cross >= i128::from(r) * i128::from(r) * length2
                })
            })
    }
}

/// A body as points that keep a distance from walls, in raw units.
trait Judged: Body + std::fmt::Debug {
    fn points(&self) -> (Vec<P>, i64);
    fn at(centre: P) -> Self;
}

fn point(v: Vec2) -> P {
    let (x, y) = v.raw();
    (x.into(), y.into())
}

impl Judged for Circle {
    fn points(&self) -> (Vec<P>, i64) {
        (vec![point(self.centre())], self.radius().to_bits().into())
    }

    fn at(centre: P) -> Self {
        Self::new(vec2(centre), Fx::from_num(8)).unwrap()
    }
}

impl Judged for Aabb {
    fn points(&self) -> (Vec<P>, i64) {
        let (lo, hi) = (point(self.min()), point(self.max()));
        (vec![lo, hi, (lo.0, hi.1), (hi.0, lo.1)], 0)
    }

    fn at(centre: P) -> Self {
        let (w, h) = (7 * PX, 11 * PX + 1);
        Self::new(vec2((centre.0 - w, centre.1 - h)), vec2((centre.0 + w, centre.1 + h))).unwrap()
    }
}

/// Starts in a room, clear of its walls, with velocities of a length of about `speed` in any
/// direction.
fn starts<B: Judged>(room: &Room, seed: u64, n: usize, speed: i64) -> Vec<(B, Vec2)> {
    let mut r = Random::new(seed);
    let range =
        |f: fn(&P) -> i64| (room.corners.iter().map(f).min().unwrap(), room.corners.iter().map(f).max().unwrap());
    let (x, y) = (range(|p| p.0), range(|p| p.1));
    (0..n)
        .map(|_| {
            let body = loop {
                let body = B::at((r.within(x.0, x.1), r.within(y.0, y.1)));
                if room.holds(&body) {
                    break body;
                }
            };
            let v = loop {
                let v = (r.around(speed), r.around(speed));
                if (speed * 3 / 4..=speed).contains(&(v.0 * v.0 + v.1 * v.1).isqrt()) {
                    break v;
                }
            };
            (body, vec2(v))
        })
        .collect()
}

/// At restitution one: as fast as at the start, minus at most 2 raw, in every frame.
fn elastic<W: World, B: Judged>(world: &W, room: &Room, seed: u64, speed: i64) {
    for (mut body, mut v) in starts::<B>(room, seed, 4, speed) {
        let surface = Surface::ELASTIC.with_speed(Speed::of(v));
        let mover = Mover::new().with_response(Response::Bounce).with_surface(surface);
        let bound = len2(v);
        let least = (bound.isqrt() - 2).pow(2);
        let mut hits = 0;
        for frame in 0..frames() {
            let moved = mover.move_and_slide(world, &body, v).unwrap();
            (body, v) = (moved.body, moved.velocity);
            hits += moved.hits.len() as i64;
            assert!(room.holds(&body), "in a wall, frame {frame}: {body:?}");
            assert!((least..=bound).contains(&len2(v)), "frame {frame}: {v:?}, {} of {bound}", len2(v));
        }
        // No room is wider than 500 units.
        assert!(speed * frames() as i64 <= (hits + 1) * 1000 * PX, "{hits} bounces");
    }
}

#[test]
fn elastic_bounces_keep_their_speed() {
    let (square, askew, valley) = (Room::square(), Room::askew(), Room::valley(2));
    let (square_bytes, askew_bytes, valley_bytes) = (square.bytes(), askew.bytes(), valley.bytes());
    let tiles = square_of_tiles();
    for (seed, speed) in [(1, 2 * PX), (2, 12 * PX), (3, 60 * PX), (4, 300 * PX), (5, 40)] {
        elastic::<_, Circle>(&tiles, &square, seed, speed);
        elastic::<_, Aabb>(&tiles, &square, seed, speed);
        elastic::<_, Circle>(&SegmentMap::from_bytes(&square_bytes).unwrap(), &square, seed, speed);
        elastic::<_, Circle>(&SegmentMap::from_bytes(&askew_bytes).unwrap(), &askew, seed, speed);
        elastic::<_, Aabb>(&SegmentMap::from_bytes(&askew_bytes).unwrap(), &askew, seed, speed);
        elastic::<_, Circle>(&SegmentMap::from_bytes(&valley_bytes).unwrap(), &valley, seed, speed);
    }
}

/// Quarter pipes all around: most bounces graze, and some meet two pipes at their joint.
#[test]
fn elastic_bounces_in_a_round_room() {
    use tilesat::TileShape::{ConcaveBottomLeft, ConcaveBottomRight, ConcaveTopLeft, ConcaveTopRight};
    static KINDS: TileKinds = TileKinds::EMPTY
        .with(0, TileKind::of(ConcaveTopLeft))
        .with(1, TileKind::of(ConcaveTopRight))
        .with(2, TileKind::of(ConcaveBottomLeft))
        .with(3, TileKind::of(ConcaveBottomRight));
    let grid = Grid::new(2, 2, Fx::from_num(128), Vec2::from_ints(-128, -128)).unwrap();
    let map = TileMap::<AllShapes>::of(&[0, 1, 2, 3], grid, &KINDS).unwrap();
    for (seed, speed) in [(1, 2 * PX), (2, 12 * PX), (3, 60 * PX), (4, 300 * PX), (5, 40)] {
        elastic::<_, Circle>(&map, &Room::round(), seed, speed);
        elastic::<_, Aabb>(&map, &Room::round(), seed, speed);
    }
}

/// 16 by 16 cells of 16 units, with only solid around.
fn square_of_tiles() -> TileMap<'static> {
    static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
    TileMap::new(&[0; 256], 16, 16, &KINDS).unwrap().with_outside(tilesat::Outside::Solid)
}

/// A room of tiles and the same room of segments give the same bits, for ball and box, with every
/// surface, with gravity and without.
#[test]
fn tiles_and_segments_bounce_alike() {
    fn alike<B: Judged + PartialEq>(seed: u64) {
        let square = Room::square();
        let bytes = square.bytes();
        let (tiles, segments) = (square_of_tiles(), SegmentMap::from_bytes(&bytes).unwrap());
        for (percent, friction, gravity) in [(100, 0, 0), (100, 0, GRAVITY), (50, 0, GRAVITY), (90, 30, GRAVITY)] {
            let ratio = |percent| Ratio::percent(percent).unwrap();
            let surface = Surface::new(ratio(percent), ratio(friction));
            let mover = Mover::platformer(Axis::NEG_Y).with_response(Response::Bounce).with_surface(surface);
            for (mut body, mut v) in starts::<B>(&square, seed, 2, 9 * PX) {
                for frame in 0..frames() {
                    let pulled = v + Vec2::from_raw(0, gravity);
                    let moved = mover.move_and_slide(&tiles, &body, pulled).unwrap();
                    let other = mover.move_and_slide(&segments, &body, pulled).unwrap();
                    assert_eq!((moved.body, moved.velocity), (other.body, other.velocity), "frame {frame}");
                    (body, v) = (moved.body, moved.velocity);
                }
            }
        }
    }
    alike::<Circle>(9);
    alike::<Aabb>(10);
}

/// Damped, or without a reference speed: slower and slower, or as fast.
#[test]
fn bounces_without_a_reference_never_gain() {
    let askew = Room::askew();
    let bytes = askew.bytes();
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    for percent in [0, 50, 90, 99, 100] {
        let surface = Surface::new(Ratio::percent(percent).unwrap(), Ratio::ZERO);
        let mover = Mover::new().with_response(Response::Bounce).with_surface(surface);
        for (mut body, mut v) in starts::<Circle>(&askew, u64::from(percent), 4, 12 * PX) {
            for frame in 0..frames() {
                let moved = mover.move_and_slide(&map, &body, v).unwrap();
                assert!(len2(moved.velocity) <= len2(v), "{percent} %, frame {frame}: {v:?} {moved:?}");
                (body, v) = (moved.body, moved.velocity);
                assert!(askew.holds(&body), "in a wall, {percent} %, frame {frame}: {body:?}");
            }
        }
    }
}

/// Raw units per frame per frame.
const GRAVITY: i32 = 10_922;

/// Drops balls until they rest. Returns the last frame in which one moved.
fn falls<W: World>(world: &W, room: &Room, percent: u8, friction: u8, seed: u64) -> u64 {
    // Gravity acts once per frame. Free flight keeps the energy v^2 / 2 + g h + g v / 2. A bounce
    // at w (after gravity) in the part T of a frame changes it by -(1 - e^2) w^2 / 2 + (1 + e) g w
    // (1/2 - T). That is a loss for every T if w is above g / (1 - e). At T = 0 it is a loss only
    // then.
    let rest = GRAVITY * 100 / (100 - i32::from(percent)) + 1;
    let ratio = |percent| Ratio::percent(percent).unwrap();
    let surface = Surface::new(ratio(percent), ratio(friction)).resting_below(Fx::from_bits(rest));
    let mover = Mover::platformer(Axis::NEG_Y).with_response(Response::Bounce).with_surface(surface);
    let mut last = 0;
    for (mut body, mut v) in starts::<Circle>(room, seed, 16, 2 * PX) {
        for frame in 0..frames() {
            let pulled = v + Vec2::from_raw(0, GRAVITY);
            let moved = mover.move_and_slide(world, &body, pulled).unwrap();
            assert!(len2(moved.velocity) <= len2(pulled), "frame {frame}: {pulled:?} {moved:?}");
            if moved.body != body || moved.velocity != Vec2::ZERO {
                last = last.max(frame);
            }
            (body, v) = (moved.body, moved.velocity);
            assert!(room.holds(&body), "in a wall, {percent} %, frame {frame}: {body:?}");
        }
    }
    last
}

#[test]
fn damped_balls_come_to_rest_in_whatever_moment_of_a_frame_they_land() {
    for percent in [0, 25, 50, 75, 90] {
        let square = Room::square();
        let last = falls(&square_of_tiles(), &square, percent, 20, 7);
        assert!(last < 1500, "{percent} % in the square: {last}");
        for run in [1, 2] {
            let valley = Room::valley(run);
            let bytes = valley.bytes();
            let last = falls(&SegmentMap::from_bytes(&bytes).unwrap(), &valley, percent, 0, 8);
            assert!(last < 1500, "{percent} % in a valley of 1:{run}: {last}");
        }
    }
}
