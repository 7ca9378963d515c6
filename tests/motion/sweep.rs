//! The first hit of a motion against the exact one. Over single blocks and small groups, on all
//! scales and near the borders between hit and miss.
//!
//! Boxes: the exact floor of `2^30 num / den`, and the side. Circles: the same for faces. At
//! corners never late, and hit or miss is exact down to grazing. Bodies without area may pass along
//! a free end of a face, but never through the joint of two tiles.

#![allow(clippy::cast_precision_loss, reason = "tests stop at the first surprise")]

use tilesat::{Axis, Mover, Outside, Response};
use tilesat_judge::Random;
use tilesat_judge::motion::body::{Body, RESPONSES};
use tilesat_judge::motion::judge::check;
use tilesat_judge::motion::level::Level;
use tilesat_judge::motion::{P, add};

/// Levels of one to four blocks, one-way ones too.
const GROUPS: [&[&str]; 12] = [
    &["#"],
    &["##"],
    &["#", "#"],
    &["##", "##"],
    &["#.", ".#"],
    &[".#", "#."],
    &["##", "#."],
    &["#.", "##"],
    &["-"],
    &["--", "#-"],
    &["#-", ".."],
    &["#.#"],
];

fn group(r: &mut Random, cell: i64) -> Level {
    // The single block most often.
    let k = if r.one_in(2) { 0 } else { r.below(GROUPS.len() as i64) as usize };
    let near = 1 << 27;
    Level::new(GROUPS[k], cell).with_origin((r.around(near), r.around(near)))
}

/// Even, from 2^8 to 2^24 raw, on a logarithmic scale.
fn any_cell(r: &mut Random) -> i64 {
    (256 + r.magnitude((1 << 24) - 256)) & !1
}

/// A point of the grid's lines: where things tie.
fn corner(r: &mut Random, level: &Level) -> P {
    add(level.origin, (level.cell * r.within(0, level.width), level.cell * r.within(0, level.height)))
}

const UP: Mover = Mover::platformer(Axis::NEG_Y);
const LIMIT: i64 = 1 << 28;

/// Judged if it fits the domain of motions. Returns whether it hit.
fn try_motion(level: &Level, body: Body, d: P) -> Option<bool> {
    let (lo, hi) = body.bounds();
    let outside = |v: i64, d: i64| v.abs().max((v + d).abs()) >= 1 << 29;
    let too_far = outside(lo.0, d.0) || outside(lo.1, d.1) || outside(hi.0, d.0) || outside(hi.1, d.1);
    let too_long = d.0.abs() >= LIMIT || d.1.abs() >= LIMIT || (hi.0 - lo.0) / 2 >= LIMIT || (hi.1 - lo.1) / 2 >= LIMIT;
    if too_far || too_long || level.overlaps(&body) {
        return None;
    }
    // Every case judges the first contact. Checks after it take turns.
    let mut response = RESPONSES[(d.0 ^ d.1 ^ lo.0) as usize & 3];
    if response != Response::Touch && near_the_end(hi.0 - lo.0, d.0) | near_the_end(hi.1 - lo.1, d.1) {
        // A turned scene might leave the domain.
        response = Response::Touch;
    }
    let out = check(level, UP, response, &body, d);
    Some(!out.hits.is_empty())
}

fn near_the_end(size: i64, d: i64) -> bool {
    size + 2 * d.abs() > 1 << 28
}

#[derive(Default)]
struct Tally {
    hits: u64,
    misses: u64,
}

impl Tally {
    fn count(&mut self, hit: Option<bool>) {
        self.hits += u64::from(hit == Some(true));
        self.misses += u64::from(hit == Some(false));
    }

    /// Both outcomes occurred often enough.
    fn is_balanced(&self, cases: u64) {
        println!("{} hits, {} misses", self.hits, self.misses);
        assert!(self.hits > cases / 20 && self.misses > cases / 20, "{} hits, {} misses", self.hits, self.misses);
    }
}

fn motion(r: &mut Random, longest: i64) -> P {
    let component = |r: &mut Random| {
        if r.one_in(8) { 0 } else { r.sign() * r.magnitude(longest.min(LIMIT - 1)) }
    };
    (component(r), component(r))
}

const CASES: u64 = 300_000;

/// A body that is near `there` at some moment of its motion by `d`.
fn backwards(r: &mut Random, there: Body, d: P, jitter: i64) -> Body {
    let part = r.within(0, 1 << 20);
    let back = |v: i64| -((v * part) >> 20);
    there.moved((back(d.0) + r.around(jitter), back(d.1) + r.around(jitter)))
}

#[test]
fn boxes_on_all_scales() {
    let mut r = Random::new(1);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let cell = any_cell(&mut r);
        let level = group(&mut r, cell);
        let size = (1 + r.magnitude(4 * cell), 1 + r.magnitude(4 * cell));
        let d = motion(&mut r, 8 * cell);
        // Anywhere around a corner of the level.
        let c = corner(&mut r, &level);
        let there = Body::rect((c.0 - r.within(0, size.0), c.1 - r.within(0, size.1)), size);
        let body = backwards(&mut r, there, d, cell / 4);
        tally.count(try_motion(&level, body, d));
    }
    tally.is_balanced(CASES);
}

/// A corner of the box passes a corner of the level within two raw, in any direction. Exact ties
/// are frequent.
#[test]
fn boxes_corner_to_corner() {
    let mut r = Random::new(2);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let cell = if r.one_in(2) { 256 } else { any_cell(&mut r) };
        let level = group(&mut r, cell);
        let size = (1 + r.magnitude(2 * cell), 1 + r.magnitude(2 * cell));
        let d = if r.one_in(2) { motion(&mut r, 64) } else { motion(&mut r, 4 * cell) };
        let c = corner(&mut r, &level);
        let there = Body::rect((c.0 - size.0 * r.below(2), c.1 - size.1 * r.below(2)), size);
        let steps = r.within(0, 4);
        // Whole and rounded multiples of the motion back.
        let start = if r.one_in(2) {
            there.moved((-d.0 * steps / 4, -d.1 * steps / 4))
        } else {
            backwards(&mut r, there, d, 2)
        };
        tally.count(try_motion(&level, start, d));
    }
    tally.is_balanced(CASES);
}

fn radius(r: &mut Random, cell: i64) -> i64 {
    1 + r.magnitude(4 * cell)
}

#[test]
fn circles_on_all_scales() {
    let mut r = Random::new(3);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let cell = any_cell(&mut r);
        let level = group(&mut r, cell);
        let radius = radius(&mut r, cell);
        let d = motion(&mut r, 8 * cell);
        let c = corner(&mut r, &level);
        let there = Body::disc((c.0 + r.around(radius), c.1 + r.around(radius)), radius);
        let body = backwards(&mut r, there, d, cell / 4);
        tally.count(try_motion(&level, body, d));
    }
    tally.is_balanced(CASES);
}

/// `v` turned by a right angle and scaled to length `length`, rounded.
fn across(v: P, length: i64) -> P {
    let (x, y) = (v.0 as f64, v.1 as f64);
    let scale = length as f64 / x.hypot(y).max(1.0);
    ((-y * scale).round() as i64, (x * scale).round() as i64)
}

/// The centre passes a corner at the distance of the radius, within two raw.
#[test]
fn circles_grazing() {
    let mut r = Random::new(4);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let cell = any_cell(&mut r);
        let level = group(&mut r, cell);
        let radius = radius(&mut r, cell);
        let d = motion(&mut r, 8 * radius.max(64));
        let away = across(d, radius * r.sign());
        let c = add(corner(&mut r, &level), away);
        let body = backwards(&mut r, Body::disc(c, radius), d, 2);
        tally.count(try_motion(&level, body, d));
    }
    tally.is_balanced(CASES);
}

/// The centre enters a corner's disc near the border of its cone, where a face takes over: above,
/// below, left or right of the corner.
#[test]
fn circles_at_the_borders_of_cones() {
    let mut r = Random::new(5);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let cell = any_cell(&mut r);
        let level = group(&mut r, cell);
        let radius = radius(&mut r, cell);
        let d = motion(&mut r, 4 * radius.max(64));
        let (along, side) = (r.around(2), r.sign() * (radius + r.around(1)));
        let offset = if r.one_in(2) { (along, side) } else { (side, along) };
        let c = add(corner(&mut r, &level), offset);
        let jitter = 2 * r.below(2);
        let body = backwards(&mut r, Body::disc(c, radius), d, jitter);
        tally.count(try_motion(&level, body, d));
    }
    tally.is_balanced(CASES);
}

/// Tiny numbers with all possible ties: all circles of radius 5 (3-4-5) around a corner, all
/// motions up to 12 raw.
#[test]
fn circles_exhaustively() {
    let level = Level::new(&["#"], 256);
    let (mut hits, mut misses) = (0, 0);
    for x in -10..=6 {
        for y in -10..=6 {
            for dx in -12..=12 {
                for dy in -12..=12 {
                    match try_motion(&level, Body::disc((x, y), 5), (dx, dy)) {
                        Some(true) => hits += 1,
                        Some(false) => misses += 1,
                        None => {}
                    }
                }
            }
        }
    }
    assert!(hits > 10_000 && misses > 10_000, "{hits} hits, {misses} misses");
}

/// As above for boxes of 0..=2 raw a side, around the four-cell joints of every group.
#[test]
fn small_boxes_exhaustively() {
    let (mut hits, mut misses) = (0, 0);
    for rows in GROUPS {
        let level = Level::new(rows, 256);
        let spots: Vec<P> =
            (0..=level.width).flat_map(|i| (0..=level.height).map(move |j| (i * 256, j * 256))).collect();
        for spot in spots {
            for k in 0..7 * 7 * 7 * 7 * 9 {
                let (x, y, dx, dy) = (k % 7 - 3, k / 7 % 7 - 3, k / 49 % 7 - 3, k / 343 % 7 - 3);
                let size = (k / 2401 % 3, k / 7203);
                match try_motion(&level, Body::rect(add(spot, (x, y)), size), (dx, dy)) {
                    Some(true) => hits += 1,
                    Some(false) => misses += 1,
                    None => {}
                }
            }
        }
    }
    assert!(hits > 5_000 && misses > 5_000, "{hits} hits, {misses} misses");
}

/// Points, flat boxes and circles of radius zero, mostly aimed at joints and ends, in all groups
/// and with all policies outside.
#[test]
fn bodies_without_area() {
    let mut r = Random::new(6);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let cell = any_cell(&mut r);
        let outside = [Outside::Empty, Outside::Solid, Outside::Edge][r.below(3) as usize];
        let level = group(&mut r, cell).with_outside(outside);
        let longest = if r.one_in(2) { 16 } else { 2 * cell };
        let d = motion(&mut r, longest);
        let long = r.magnitude(2 * cell);
        let c = corner(&mut r, &level);
        let there = match r.below(4) {
            0 => Body::disc(c, 0),
            1 => Body::rect(c, (0, 0)),
            2 => Body::rect((c.0, c.1 - r.within(0, long)), (0, long)),
            _ => Body::rect((c.0 - r.within(0, long), c.1), (long, 0)),
        };
        let steps = r.within(0, 4);
        let start = if r.one_in(2) {
            there.moved((-d.0 * steps / 4, -d.1 * steps / 4))
        } else {
            backwards(&mut r, there, d, 1)
        };
        tally.count(try_motion(&level, start, d));
    }
    tally.is_balanced(CASES);
}

/// A point runs into a wall exactly on the joint of two tiles, from every side. It must not get in
/// between.
#[test]
fn no_leak_through_a_joint() {
    for rows in [&["##"] as &[&str], &["#", "#"]] {
        let level = Level::new(rows, 1 << 20);
        let joint = if rows.len() == 1 { (1 << 20, 0) } else { (0, 1 << 20) };
        for k in 1..=40 {
            for across in -40..=40 {
                let d = if rows.len() == 1 { (across, k) } else { (k, across) };
                let start = (joint.0 - d.0, joint.1 - d.1);
                for body in [Body::disc(start, 0), Body::rect(start, (0, 0))] {
                    let twice = (2 * d.0, 2 * d.1);
                    let out = check(&level, UP, Response::Touch, &body, twice);
                    assert_eq!(out.body.position(), joint, "{d:?}");
                    assert_eq!(out.hits.first().unwrap().toi.raw(), 1 << 29, "{d:?}");
                }
            }
        }
    }
}

/// The same point passes along the free end of a face: it touches a corner and never has solid on
/// both sides.
#[test]
fn points_pass_free_ends() {
    let level = Level::new(&["#"], 1 << 20);
    for (k, l) in (1..=20).flat_map(|k| (1..=20).map(move |l| (k, l))) {
        let start = (-k, l);
        for body in [Body::disc(start, 0), Body::rect(start, (0, 0))] {
            let out = check(&level, UP, Response::Slide, &body, (2 * k, -2 * l));
            assert!(out.hits.is_empty());
        }
    }
}

/// A circle wedged between two corners, where rounding away from one grazes the other. It tries
/// lattice positions beside the first choice, and stays only if there are none.
#[test]
fn circles_between_two_corners() {
    let mut r = Random::new(8);
    let (mut beside, mut stays) = (0, 0);
    let cases = tilesat_judge::thorough(CASES / 4, CASES);
    for _ in 0..cases {
        let cell = any_cell(&mut r);
        let rows: [&[&str]; 3] = [&["#..", "...", "..#"], &["#.", "..", ".#"], &["#.#"]];
        let k = r.below(3) as usize;
        let level = Level::new(rows[k], cell);
        // The corner that it runs along, relative to the one that it runs into. Also how far aside
        // it rests from the middle of both.
        let gap = [(cell, cell), (0, cell), (cell, 0)][k];
        let first = [(cell, cell), (cell, cell), (cell, 0)][k];
        let half = (gap.0 as f64).hypot(gap.1 as f64) / 2.0;
        let radius = half as i64 + 1 + r.magnitude(cell / 4);
        let depth = ((radius as f64).powi(2) - half * half).sqrt().ceil() as i64;
        let rest = add(add(first, (gap.0 / 2, gap.1 / 2)), across(gap, -depth));
        let from_second = (rest.0 - first.0 - gap.0, rest.1 - first.1 - gap.1);
        let aside = across(from_second, r.within(0, 2 * (radius as f64).sqrt() as i64));
        let body = Body::disc(add(rest, (aside.0 + r.around(1), aside.1 + r.around(1))), radius);
        let d = across(from_second, -r.within(1, cell));
        if level.overlaps(&body) || try_motion(&level, body, d).is_none() {
            continue;
        }
        let out = body.step(&UP.with_response(Response::Touch), &level.map(), d).unwrap();
        // The start, the first choice, and six others.
        let second_choice = !out.hits.is_empty() && out.work.checks > 2;
        beside += u64::from(second_choice && out.body != body);
        stays += u64::from(second_choice && out.body == body);
        assert!(out.work.checks <= 8);
    }
    println!("{beside} beside the first choice, {stays} stayed");
    assert!(beside > cases / 1000 && stays < beside, "{beside} beside the first choice, {stays} stayed");
}

/// The largest bodies and motions of the contract: components and radii just below 2^28.
#[test]
fn at_the_limits_of_motion() {
    let mut r = Random::new(7);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let cell = (1 << 24) - 2 * r.magnitude(1 << 22);
        let level = group(&mut r, cell);
        let large = |r: &mut Random| LIMIT - 1 - r.magnitude(LIMIT - 1);
        let d = (r.sign() * large(&mut r), r.sign() * large(&mut r));
        let c = corner(&mut r, &level);
        let there = if r.one_in(2) {
            let size = (large(&mut r), large(&mut r));
            Body::rect((c.0 - size.0 * r.below(2), c.1 - size.1 * r.below(2)), size)
        } else {
            let radius = large(&mut r);
            Body::disc(add(c, across(d, radius * r.sign())), radius)
        };
        let body = backwards(&mut r, there, d, 2);
        tally.count(try_motion(&level, body, d));
    }
    println!("{} hits, {} misses", tally.hits, tally.misses);
    assert!(tally.hits > 1000 && tally.misses > 1000);
}
