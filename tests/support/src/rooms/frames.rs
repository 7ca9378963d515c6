//! Frames of motion in rooms of all shapes, each judged by sets of points and beside its mirror
//! images.

use crate::Random;
use crate::rooms::body::{Body, Outcome};
use crate::rooms::room::{FINE, Room};
use crate::rooms::view::View;
use crate::rooms::{P, PX, len2};
use crate::shapes::level::Level;
use tilesat::{Axis, Mover, Response};

pub const RESPONSES: [Response; 4] = [Response::Slide, Response::Bounce, Response::DropThrough, Response::Touch];

#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    pub frames: u64,
    pub hits: u64,
    pub askew: u64,
    pub free: u64,
    /// Frames of circles. The rest is of boxes.
    pub round: u64,
    /// Motions of circles and of boxes that met nothing and were not made: roundings, no obstacles.
    pub refused: [u64; 2],
    pub full_iterations: u64,
    pub at_rest: u64,
    pub ties: u64,
    /// Hits that stopped the body although its way was free for more than a unit.
    pub held: u64,
    pub features: u64,
}

pub struct Scene<'a> {
    pub level: &'a Level,
    pub room: &'a Room,
    pub body: Body,
    pub v: P,
    pub response: Response,
}

pub fn mover(up: P, response: Response) -> Mover {
    Mover::platformer(Axis::new(up.0 as i32, up.1 as i32)).with_response(response)
}

pub fn describe(s: &Scene, what: &str) -> String {
    let rows: Vec<_> = s.level.tiles.chunks(s.level.width as usize).collect();
    format!(
        "{what}: {:?} by {:?} {:?}, cell {} at {:?}\n{rows:?}",
        s.body,
        s.v,
        s.response,
        s.level.cell,
        (s.level.x, s.level.y)
    )
}

/// The first contact: the way to it is free, at sixteen exact places.
pub fn judge_way(r: &mut Random, s: &Scene, tally: &mut Tally) {
    let touch = s.body.step(&mover((0, -1), Response::Touch), &s.level.all(), s.v).unwrap();
    assert!(!s.room.overlaps(touch.body, (0, 0), 0), "{}", describe(s, "stops inside"));
    let one = i64::from(1 << 30);
    let until = touch.hits.first().map_or(one, |h| i64::from(h.toi.raw())) * FINE / one;
    for _ in 0..16 {
        let k = 2 * r.within(0, until / 2);
        assert!(!s.room.overlaps(s.body, s.v, k), "{}", describe(s, "passes through"));
    }
    if until > FINE / 2 && touch.body == s.body && len2(s.v) > (4 * PX as i128).pow(2) {
        tally.held += 1;
    }
}

/// All but the names of cells and the work.
pub type Bits = (Body, P, P, [bool; 3], Vec<(u32, P, bool)>);

pub fn bits(out: &Outcome, view: Option<View>) -> Bits {
    let turn = |p: P| view.map_or(p, |v| v.direction(p));
    let hits = out.hits.iter().map(|h| (h.toi.raw(), turn((h.axis.x.into(), h.axis.y.into())), h.one_way));
    let body = view.map_or(out.body, |v| v.body(out.body));
    (body, turn(out.v), turn(out.remaining), [out.floor, out.wall, out.ceiling], hits.collect())
}

pub fn judge_views(s: &Scene, out: &Outcome, views: &[View], tally: &mut Tally) {
    for &view in views {
        let level = view.level(s.level);
        let seen =
            view.body(s.body).step(&mover(view.direction((0, -1)), s.response), &level.all(), view.direction(s.v));
        let (seen, expected) = (bits(&seen.unwrap(), None), bits(out, Some(view)));
        if seen != expected {
            // A full tie: other surfaces at the same moment. The first report may differ. The end
            // differs only if x goes before y.
            let parts = seen.4.iter().zip(&expected.4).find(|(a, b)| a != b);
            let tie = parts.is_some_and(|(a, b)| a.0 == b.0 && len2(a.1) == len2(b.1))
                && (view == View::Transpose || (seen.0, seen.1, seen.2) == (expected.0, expected.1, expected.2));
            // If two lattice vectors are equally near to a bounce, coordinates choose one.
            let near = |p: P, q: P| (p.0 - q.0).abs().max((p.1 - q.1).abs()) <= 1;
            let bounce = view == View::Transpose && s.response == Response::Bounce && near(seen.1, expected.1);
            // Before a diagonal surface a position is rounded along x or along y.
            let diagonal = view == View::Transpose
                && seen.4.first().is_some_and(|hit| hit.1.0.abs() == hit.1.1.abs())
                && near(seen.0.position(), expected.0.position())
                && (seen.1, seen.2, seen.3, &seen.4) == (expected.1, expected.2, expected.3, &expected.4);
            assert!(
                (tie || bounce || diagonal) && !matches!(view, View::Moved(_)),
                "{}\n{seen:?}\n{expected:?}",
                describe(s, &format!("{view:?}"))
            );
            tally.ties += 1;
        }
    }
}

pub fn frame(r: &mut Random, s: &Scene, views: &[View], tally: &mut Tally) -> Outcome {
    let out = s.body.step(&mover((0, -1), s.response), &s.level.all(), s.v);
    let out = out.unwrap_or_else(|e| panic!("{}", describe(s, &format!("{e:?}"))));
    assert!(!s.room.overlaps(out.body, (0, 0), 0), "{}", describe(s, "ends inside"));
    assert!(len2(out.v) <= len2(s.v), "{}", describe(s, "is faster"));
    let round = !matches!(s.body, Body::Rect(..));
    tally.round += u64::from(round);
    assert!(out.hits.len() as u32 <= out.work.iterations && out.work.iterations <= Mover::ITERATIONS);
    if out.hits.is_empty() {
        assert_eq!((out.v, out.remaining), (s.v, (0, 0)), "{}", describe(s, "lost something"));
        tally.refused[usize::from(!round)] += u64::from(out.body != s.body.moved(s.v));
    }
    judge_way(r, s, tally);
    judge_views(s, &out, views, tally);
    tally.frames += 1;
    tally.hits += out.hits.len() as u64;
    tally.askew += out.hits.iter().filter(|h| h.axis.x != 0 && h.axis.y != 0).count() as u64;
    tally.free += u64::from(out.hits.is_empty());
    tally.full_iterations += u64::from(out.work.iterations == Mover::ITERATIONS);
    tally.at_rest += u64::from(out.v == (0, 0));
    tally.features += u64::from(out.work.features);
    out
}

pub fn any_velocity(r: &mut Random, fastest: i64) -> P {
    let raw = fastest * PX;
    match r.below(6) {
        0 => (r.around(fastest) * PX, r.around(fastest) * PX),
        1 => (r.around(raw), 0),
        2 => (0, r.around(raw)),
        3 => {
            let v = r.around(raw);
            (v, v * r.sign())
        }
        4 => (r.sign() * r.magnitude(raw), r.sign() * r.magnitude(raw)),
        _ => (r.around(raw), r.around(raw)),
    }
}

pub fn any_body(r: &mut Random, cell: i64) -> Body {
    let size = |r: &mut Random| match r.below(4) {
        0 => 20 * PX,
        1 => 2 + r.magnitude(cell),
        2 => cell,
        _ => 2 + r.below(3 * cell),
    };
    match r.below(4) {
        0 => Body::Rect((0, 0), (size(r), size(r))),
        1 => any_capsule(r, cell),
        _ => Body::Disc((0, 0), (size(r) / 2).max(1)),
    }
}

/// A standing or lying capsule of up to two cells, its first end either one.
pub fn any_capsule(r: &mut Random, cell: i64) -> Body {
    let radius = [cell / 4, cell / 3, 1 + r.magnitude(cell / 2), 1 + r.below(cell)][r.below(4) as usize];
    let long = [cell / 2, cell / 4, r.magnitude(cell), r.below(2 * cell)][r.below(4) as usize] * r.sign();
    Body::Pill((0, 0), if r.one_in(2) { (long, 0) } else { (0, long) }, radius)
}
