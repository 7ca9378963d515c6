//! Verlet points, sticks and ropes, and a ragdoll that falls down some stairs.

#![allow(clippy::cast_precision_loss, reason = "tests stop at the first surprise")]

use tilesat::motion::response::{Link, Particle, Quiet, RelaxError, Stick, relax};
use tilesat::{Fx, Mover, Quantity, RangeError, Ratio, Surface, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::plain::{P, raw, vec2};
use tilesat_judge::{Random, cases, frames};

const PX: i64 = 1 << 16;
const RADIUS: i64 = PX;
const CELL: i64 = 16 * PX;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

const STAIRS: &str = "\
################
#              #
#              #
#              #
#              #
###            #
####           #
#####   ##     #
######         #
########      ##
#########    ###
################
";

fn len2(a: P, b: P) -> i128 {
    let (x, y) = (i128::from(a.0 - b.0), i128::from(a.1 - b.1));
    x * x + y * y
}

/// Whether a disc overlaps a solid cell: its distance from the cell's square is less than its
/// radius.
fn inside(c: P) -> bool {
    let rows: Vec<&[u8]> = STAIRS.lines().map(str::as_bytes).collect();
    rows.iter().enumerate().any(|(y, row)| {
        row.iter().enumerate().any(|(x, &tile)| {
            let (x, y) = (x as i64 * CELL, y as i64 * CELL);
            let near = (c.0.clamp(x, x + CELL), c.1.clamp(y, y + CELL));
            tile == b'#' && len2(c, near) < i128::from(RADIUS).pow(2)
        })
    })
}

/// Within `by` raw of a length, exactly.
fn is_long(a: P, b: P, length: i64, by: i64) -> bool {
    let square = |n: i64| i128::from(n.max(0)).pow(2);
    (square(length - by)..=square(length + by)).contains(&len2(a, b))
}

#[test]
fn one_correction_is_enough_and_the_second_is_none() {
    let mut r = Random::new(11);
    for case in 0..cases(100_000) {
        let most = 1 << (case % 28);
        let at = (r.around(1 << 27), r.around(1 << 27));
        let to = (at.0 + r.around(most), at.1 + r.around(most));
        let length = r.within(0, most);
        let share = [Ratio::ZERO, Ratio::HALF, Ratio::new(1, 3).unwrap(), Ratio::ONE, Ratio::from_raw(77).unwrap()];
        let share = share[r.below(5) as usize];
        let stick = Stick::new(Fx::from_bits(length as i32)).unwrap().with_share_of_a(share);
        let (by_a, by_b) = stick.pull(vec2(at), vec2(to));
        let (a, b) = (raw(vec2(at) + by_a), raw(vec2(to) + by_b));
        assert!(is_long(a, b, length, 3), "{at:?} {to:?} to {length}: {a:?} {b:?}");
        assert_eq!(stick.pull(vec2(a), vec2(b)), (Vec2::ZERO, Vec2::ZERO), "{at:?} {to:?} to {length}: drifts");
        let swapped = stick.with_share_of_a(share.complement()).pull(vec2(to), vec2(at));
        let mirrored = stick.pull(vec2((-at.0, at.1)), vec2((-to.0, to.1)));
        if at != to {
            assert_eq!(swapped, (by_b, by_a));
            let flip = |v: Vec2| vec2((-raw(v).0, raw(v).1));
            assert_eq!(mirrored, (flip(by_a), flip(by_b)));
        }
        let rope = Stick::rope(Fx::from_bits(length as i32)).unwrap().with_share_of_a(share);
        let slack = len2(at, to) < i128::from(length + 3).pow(2);
        assert_eq!(rope.pull(vec2(at), vec2(to)), if slack { (Vec2::ZERO, Vec2::ZERO) } else { (by_a, by_b) });
    }
}

fn link(a: u8, b: u8, points: &[Particle]) -> Link {
    let way = points[usize::from(b)].position - points[usize::from(a)].position;
    Link { a, b, stick: Stick::new(way.length()).unwrap() }
}

/// Head, neck, hips, elbows, hands, knees and one foot, and the sticks between them.
fn doll(at: P) -> (Vec<Particle>, Vec<Link>) {
    let body = [(0, 0), (0, 6), (0, 16), (-6, 8), (6, 8), (-10, 13), (10, 13), (-3, 23), (3, 23), (-4, 30)];
    let points: Vec<Particle> = body.iter().map(|p| Particle::at(vec2((at.0 + p.0 * PX, at.1 + p.1 * PX)))).collect();
    let pairs = [(0, 1), (1, 2), (1, 3), (1, 4), (3, 5), (4, 6), (2, 7), (2, 8), (7, 9), (0, 2), (7, 8), (3, 4)];
    let links = pairs.iter().map(|&(a, b)| link(a, b, &points)).collect();
    (points, links)
}

/// The error of a stick's length, in units.
fn off(link: &Link, points: &[Particle]) -> f64 {
    let (a, b) = (points[usize::from(link.a)].position, points[usize::from(link.b)].position);
    ((len2(raw(a), raw(b)) as f64).sqrt() - f64::from(link.stick.length().to_bits())).abs() / PX as f64
}

/// A falling doll: `awake` frames without sleep, then until it sleeps. Returns the worst stick
/// ever, and at rest.
fn fall(start: P, awake: u32) -> (f64, f64) {
    let map: TileMap<'_> = TileMap::of_ascii(STAIRS, &KINDS).unwrap();
    let mover = Mover::new().with_surface(Surface::new(Ratio::ZERO, Ratio::HALF));
    let (gravity, drag, radius) = (Fx::from_bits(8_192), Ratio::percent(2).unwrap(), Fx::from_bits(RADIUS as i32));
    let (mut points, links) = doll((start.0 * PX, start.1 * PX));
    let (mut worst, mut quiet, mut frame) = (0.0_f64, Quiet::NOT, 0);
    while frame < awake || !quiet.for_steps(30) {
        for point in &mut points {
            *point = point.step_in(&map, &mover, radius, Vec2::new(Fx::ZERO, gravity), drag).unwrap();
        }
        relax(&mut points, &links, 8, &map, &mover, radius).unwrap();
        quiet = quiet.watch(&points, gravity * 2);
        worst = links.iter().map(|link| off(link, &points)).fold(worst, f64::max);
        assert!(points.iter().all(|p| !inside(raw(p.position))), "frame {frame}: {points:?}");
        frame += 1;
        assert!(frame < awake + 3_000, "no rest from {start:?}");
    }
    let rest = links.iter().map(|link| off(link, &points)).fold(0.0, f64::max);
    println!("from {start:?}: asleep after {frame} frames, {worst:.3} and {rest:.3} units off");
    (worst, rest)
}

#[test]
fn a_ragdoll_falls_and_lies() {
    for start in
        [(60, 20), (75, 21), (90, 20), (105, 40), (120, 18), (131, 33), (150, 30), (166, 24), (177, 20), (200, 20)]
    {
        let (worst, rest) = fall(start, 0);
        assert!(worst < 1.5 && rest < 1.5, "{start:?}: {worst} {rest}");
    }
    // A soak takes 100 000.
    let (worst, _) = fall((120, 18), frames(5_000));
    assert!(worst < 1.5, "{worst}");
}

#[test]
fn what_relax_refuses() {
    let map: TileMap<'_> = TileMap::of_ascii(STAIRS, &KINDS).unwrap();
    let (mut points, links) = doll((100 * PX, 40 * PX));
    let before = points.clone();
    let stick = links[0].stick;
    for wrong in [Link { a: 10, b: 0, stick }, Link { a: 0, b: 255, stick }, Link { a: 3, b: 3, stick }] {
        let answer = relax(&mut points, &[links[0], wrong], 4, &map, &Mover::new(), Fx::ONE);
        assert_eq!(answer, Err(RelaxError::NoPoint { link: 1 }));
        assert_eq!(points, before);
    }
    assert_eq!(relax(&mut points, &links, 4, &map, &Mover::new(), Fx::ONE), Ok(0), "satisfied");
    points[1].position = vec2((0, 0));
    let answer = relax(&mut points, &links, 4, &map, &Mover::new(), Fx::ONE);
    assert!(matches!(answer, Err(RelaxError::Move { link: 0, .. })), "{answer:?}");
}

#[test]
fn a_length_that_is_none_is_called_one() {
    for value in [-1, 1 << 29, i32::MIN] {
        let refused = Err(RangeError { what: Quantity::Length, value });
        assert_eq!((Stick::new(Fx::from_bits(value)), Stick::rope(Fx::from_bits(value))), (refused, refused));
    }
    let error = Stick::rope(Fx::from_num(-1)).unwrap_err();
    assert_eq!(error.to_string(), "Length is out of range: -1 (-65536 raw); it must be from 0 to below 8192 units");
}

/// A pendulum on a nailed end. Its rope never stretches by more than the rounding.
#[test]
fn a_rope_holds() {
    let map: TileMap<'_> = TileMap::of_ascii(STAIRS, &KINDS).unwrap();
    let nail = vec2((120 * PX, 20 * PX));
    let mut points = [Particle::at(nail), Particle::at(vec2((150 * PX, 20 * PX)))];
    let rope = Stick::rope(Fx::from_num(30)).unwrap().with_share_of_a(Ratio::ZERO);
    let links = [Link { a: 0, b: 1, stick: rope }];
    let (mover, radius) = (Mover::new(), Fx::ONE);
    for _ in 0..frames(100_000) {
        points[1] = points[1].step_in(&map, &mover, radius, Vec2::from_raw(0, 8_192), Ratio::ZERO).unwrap();
        relax(&mut points, &links, 2, &map, &mover, radius).unwrap();
        assert_eq!(points[0].position, nail);
        let long = len2(raw(points[1].position), raw(nail));
        assert!(long <= i128::from(30 * PX + 3).pow(2), "{points:?}");
    }
}
