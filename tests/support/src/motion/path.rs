//! The required end of a motion, from its reported hits. Boxes exactly; circles from legs of
//! straight motion, in floating point, within a few raw.
//!
//! The other checks say what must not happen. This one says that the body advances.

#![allow(clippy::cast_precision_loss, reason = "lengths are below 2^30")]

use super::body::{Body, Outcome};
use super::level::Level;
use super::{P, Time, disc, len2, rect, ways};
use tilesat::{Hit, Mover, Response};

type V = (f64, f64);

fn respond(v: V, n: V, response: Response) -> V {
    let into = (v.0 * n.0 + v.1 * n.1) / (n.0 * n.0 + n.1 * n.1);
    let k = match response {
        Response::Touch => return (0.0, 0.0),
        Response::Slide | Response::DropThrough => into.min(0.0),
        Response::Bounce => 2.0 * into.min(0.0),
    };
    (v.0 - k * n.0, v.1 - k * n.1)
}

/// Whether a hit is of a surface that faces one hit at the same moment. Bounces between the two
/// would take no time, so it is a slide.
pub fn is_squeezed(hits: &[&Hit], i: usize) -> bool {
    let of = |hit: &Hit| ((i64::from(hit.axis.x), i64::from(hit.axis.y)), hit.toi);
    let (n, toi) = of(hits[i]);
    hits[..i].iter().any(|hit| of(hit) == ((-n.0, -n.1), toi))
}

fn near(a: P, b: V, within: f64) -> bool {
    (a.0 as f64 - b.0).abs() <= within && (a.1 as f64 - b.1).abs() <= within
}

/// How a circle came to the first surface that it touches.
#[derive(Clone, Copy, PartialEq)]
enum Came {
    Lay,
    /// To a corner on a hop, so fast that it goes round that. The next hit decides.
    Hopped,
    Flew,
}

/// The surfaces that a motion has touched so far, and its velocity at each. The start's velocity
/// presses a circle that lay on the first surface against all surfaces that it has slid along
/// since. A flying circle reaches the next with the rest that the last one left.
struct Touched {
    by: V,
    planes: Vec<Plane>,
    came: Came,
    /// Whether one-way faces count.
    fronts: bool,
}

struct Plane {
    normal: V,
    corner: bool,
    /// The distance of the corner at the hit.
    radius: f64,
    /// The cell that was hit.
    cell: P,
}

impl Plane {
    /// How far a circle has risen off a corner.
    fn gap(&self) -> f64 {
        self.normal.0.hypot(self.normal.1) - self.radius
    }
}

/// Whether a body is over a face that continues from cell to cell. `None` within some raw units of
/// where that changes.
fn is_over(level: &Level, body: &Body, plane: &Plane, fronts: bool) -> Option<bool> {
    let along_x = plane.normal.0 == 0.0;
    let n = (plane.normal.0 as i64, plane.normal.1 as i64);
    let is_face = |k: i64| {
        let (x, y) = if along_x { (k, plane.cell.1) } else { (plane.cell.0, k) };
        let front = fronts && n == (0, -1) && level.one_way(x, y);
        front || level.full(x, y) && !level.full(x + n.0, y + n.1)
    };
    let (lo, hi) = match *body {
        Body::Disc { c, core, .. } => (c, super::add(c, core)),
        Body::Rect { lo, hi } => (lo, hi),
    };
    let cell = |p: P, by: i64| if along_x { level.column(p.0 + by) } else { level.row(p.1 + by) };
    let any = |by: i64| (cell(lo, -by)..=cell(hi, by)).any(is_face);
    let (wide, narrow) = (any(16), cell(lo, 16) <= cell(hi, -16) && (cell(lo, 16)..=cell(hi, -16)).any(is_face));
    // What is over a face with one point.
    let thin = matches!(body, Body::Disc { core, .. } if (if along_x { core.0 } else { core.1 }) == 0);
    let narrow = if thin { (cell(lo, -16)..=cell(hi, 16)).all(is_face) } else { narrow };
    if wide == narrow { Some(wide) } else { None }
}

impl Touched {
    /// By how much a body may have left a plane and still touches it, in raw units.
    const NEAR: f64 = 4.0;

    /// Drops the surfaces that a leg has left: faces by rising or by passing their end, corners by
    /// another way than round them, or by flying past. Returns whether that is certain: not if a
    /// body just passes the end of a face.
    fn slide(&mut self, leg: V, level: &Level, there: &Body) -> bool {
        let (lies, hopped, fronts) = (self.came == Came::Lay, self.came == Came::Hopped, self.fronts);
        let mut certain = true;
        self.planes.retain_mut(|plane| {
            if plane.corner {
                plane.normal = (plane.normal.0 + leg.0, plane.normal.1 + leg.1);
            }
            let n = plane.normal;
            let out = n.0 * leg.0 + n.1 * leg.1;
            if plane.corner {
                // A step along its tangent rises by so much.
                let gap = plane.gap() - (leg.0 * leg.0 + leg.1 * leg.1) / (2.0 * plane.radius);
                certain &= !lies || (gap - Self::NEAR).abs() > 3.0;
                // A turn of a quarter of the normal is the limit, which roundings decide.
                let turn = 4.0 * leg.0.hypot(leg.1) / plane.radius;
                certain &= !(lies || hopped) || !(0.7..1.4).contains(&turn);
                return (hopped || lies && gap <= Self::NEAR) && turn <= 1.0;
            }
            let over = is_over(level, there, plane, fronts);
            certain &= over.is_some();
            out <= Self::NEAR && over.unwrap_or(true)
        });
        certain
    }

    /// Decides at a hit after a hop whether the circle lay on the corner from which it hopped. It
    /// did if that corner and the surface that it hits, of normal `m`, hold its velocity together:
    /// the velocity is between the reverses of both normals. Then it meets both with that velocity.
    /// Returns whether it lay there; `None` if roundings decide that.
    fn end_hop(&mut self, m: V, hits_face: bool) -> Option<bool> {
        if self.came != Came::Hopped {
            return Some(false);
        }
        self.came = Came::Flew;
        let first = self.planes.first().filter(|plane| plane.corner && !hits_face);
        if let Some(n) = first.map(|plane| plane.normal) {
            let turn = |a: V, b: V| (a.0 * b.1 - a.1 * b.0) / a.0.hypot(a.1) / b.0.hypot(b.1);
            let (between, to_m, to_n) = (turn(m, n), turn(self.by, m), turn(self.by, n));
            let sides = [to_m, -to_n].map(|side| side * between.signum());
            if [between, to_m, to_n].iter().any(|turn| turn.abs() < 1.0e-3) {
                return None;
            }
            if sides.iter().all(|side| *side > 0.0) {
                self.came = Came::Lay;
            }
        }
        let lies = self.came == Came::Lay;
        self.planes.retain(|plane| !plane.corner || lies && plane.gap() <= Self::NEAR);
        Some(lies)
    }

    /// The faces that end at the corner that was hit last, if it is as high over them as its radius
    /// passes the corner.
    fn ends(&self) -> Vec<V> {
        let Some(last) = self.planes.last().filter(|plane| plane.corner) else { return Vec::new() };
        let n = last.normal;
        let faces = [(n.0.signum(), 0.0), (0.0, n.1.signum())].into_iter();
        faces.filter(|face| last.radius - (face.0 * n.0 + face.1 * n.1) <= Self::NEAR).collect()
    }

    /// The longest velocity along one of the planes and into none, or rest.
    fn velocity(&self) -> V {
        let all = self.planes.iter().map(|plane| respond(self.by, plane.normal, Response::Slide));
        let free = all.filter(|v| {
            let into = |n: V| (v.0 * n.0 + v.1 * n.1) / n.0.hypot(n.1);
            self.planes.iter().all(|plane| into(plane.normal) >= -8.0)
        });
        free.max_by(|a, b| a.0.hypot(a.1).total_cmp(&b.0.hypot(b.1))).unwrap_or_default()
    }
}

/// The velocity along a [face that ends](Touched::ends) at the corner that was hit last, if a body
/// continues by that, though the tangent there leads off the face.
fn along_an_end(level: &Level, there: &Body, touched: &Touched, v: P) -> Option<V> {
    touched.ends().into_iter().map(|face| respond(touched.by, face, Response::Slide)).find(|way| {
        let d = (way.0 as i64, way.1 as i64);
        near(v, *way, 1.0)
            && rect::first_one_way(level, there, d).is_none()
            && !disc::enters_solid(level, there, d, Time::new(1, 16))
    })
}

/// How a circle of velocity `v` came to the surface that it hits after a leg. It lay there if it is
/// as near as roundings leave it, or as a step along a corner's tangent. That rises by
/// `s^2 / 2 rho` over a way `s` of at most a quarter of `rho`. `None` if a raw unit would decide.
fn came(leg: V, v: V, hit: &Hit) -> Option<Came> {
    let n = (f64::from(hit.axis.x), f64::from(hit.axis.y));
    let (rho, was) = (n.0.hypot(n.1), (n.0 - leg.0).hypot(n.1 - leg.1));
    if hit.index < 4 {
        let way = leg.0.abs().max(leg.1.abs());
        return if way < Touched::NEAR - 2.0 {
            Some(Came::Lay)
        } else if way > Touched::NEAR * 1.0e3 {
            Some(Came::Flew)
        } else {
            None
        };
    }
    let off = ((leg.0 * n.0 + leg.1 * n.1).abs() - Touched::NEAR * (n.0.abs() + n.1.abs())) / rho;
    if off < -3.0 {
        return Some(Came::Lay);
    } else if off < 3.0 {
        return None;
    }
    let s = (v.0 * n.1 - v.1 * n.0).abs() / rho;
    let step = s.min(rho / 4.0);
    let over = was - rho - Touched::NEAR - step * step / (2.0 * rho);
    if over.abs() < 3.0 || (4.0 * s - rho).abs() < 4.0 {
        return None;
    }
    Some(if over >= 0.0 {
        Came::Flew
    } else if s <= step {
        Came::Lay
    } else {
        Came::Hopped
    })
}

/// Away from zero: a way that leads into a wall by a part of a raw unit is also blocked. Exact zero
/// with noise of floats is not.
fn outward(c: f64) -> f64 {
    if c.abs() < 1.0e-6 { 0.0 } else { c.abs().ceil().copysign(c) }
}

/// The verdict on a body that goes on by `v`, where its hits leave `vel`. They may be corners along
/// which it slides.
///
/// After a corner that is met nearly head on, `vel` is slower than a way, and leads nowhere. Then
/// the hits do not tell what leads on: something else that is touched, such as the face that ends
/// at the corner. If the way along that is free, a body that stopped would break L1. The judge of
/// [ways] knows from the place alone which are free, and which is the longest.
fn goes_on_by_another(v: P, vel: V, along_corners: bool) -> Result<(), String> {
    let is_no_way = vel != (0.0, 0.0) && vel.0.hypot(vel.1) < f64::from(ways::SLOWEST);
    if along_corners && is_no_way { Ok(()) } else { Err(format!("goes on by {v:?}, not {vel:?}")) }
}

/// Whether velocity and place are what the hits imply, and a round body that stops has nowhere to
/// go.
///
/// A raw unit may decide which of the hits are still touched at the last one. In any case the
/// velocity is [the longest free part](ways::keeps_the_longest) of what some of them leave.
pub fn follows(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let slides = matches!(response, Response::Slide | Response::DropThrough);
    let round = slides && matches!(start, Body::Disc { r, .. } if *r > 0);
    if round {
        ways::stops_rightly(level, start, v, response, out)?;
        ways::keeps_the_longest(level, start, v, response, out)?;
    }
    // What else it touches at its first hit may have turned its way.
    if out.hits.len() > 1 && ways::touches_another_at_first(level, start, v, out) {
        return Ok(());
    }
    replays(level, start, v, response, out)
}

/// Where the hits tell for certain what is left, it is that.
fn replays(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let hits: Vec<&Hit> = out.hits.iter().collect();
    let corners = hits.iter().any(|h| h.index >= 4);
    let (mut vel, mut place, mut now) = ((v.0 as f64, v.1 as f64), (0.0, 0.0), 0.0);
    let leg = |vel: V, time: f64| (vel.0 * time, vel.1 * time);
    let plus = |a: V, b: V| (a.0 + b.0, a.1 + b.1);
    let (mut first_leg, mut way) = (None, (0.0, 0.0));
    // A circle between two corners may stay where it is, a little before the contact: then both are
    // touched together.
    let wedge = if let Body::Disc { r, .. } = *start { 2.0 * (r as f64).sqrt() } else { 0.0 };
    let slides = matches!(response, Response::Slide | Response::DropThrough);
    let mut touched =
        Touched { by: vel, planes: Vec::new(), came: Came::Flew, fronts: response != Response::DropThrough };
    let mut at_last = *start;
    for (i, hit) in hits.iter().enumerate() {
        let toi = f64::from(hit.toi.raw()) / f64::from(1u32 << 30);
        if corners && first_leg.is_some() && vel.0.hypot(vel.1) * (toi - now) < wedge.max(16.0) {
            return Ok(());
        }
        if response == Response::DropThrough && hit.one_way && i as u32 + 1 == Mover::ITERATIONS {
            // It takes an iteration to find that it can pass, and none is left.
            break;
        }
        let made = leg(vel, toi - now);
        place = plus(place, made);
        let there = start.moved((place.0 as i64, place.1 as i64));
        at_last = there;
        first_leg.get_or_insert(place);
        now = toi;
        way = plus(way, made);
        // A one-way face that a body passes changes nothing, so nothing is looked at there.
        if response != Response::DropThrough || !hit.one_way {
            let made = core::mem::take(&mut way);
            if !touched.slide(made, level, &there) {
                return Ok(());
            }
            let normal = (hit.axis.x.into(), hit.axis.y.into());
            if slides {
                let Some(keeps) = touched.end_hop(normal, hit.index < 4) else { return Ok(()) };
                if touched.planes.is_empty() && !keeps {
                    let Some(came) = came(made, vel, hit) else { return Ok(()) };
                    let lost = !matches!(start, Body::Disc { .. }) || (i > 0 && came == Came::Hopped);
                    touched.came = if lost { Came::Flew } else { came };
                    touched.by = vel;
                } else if touched.came != Came::Lay {
                    touched.by = vel;
                }
                let cell = (hit.cell.x.into(), hit.cell.y.into());
                let radius = f64::hypot(normal.0, normal.1);
                touched.planes.push(Plane { radius, normal, corner: hit.index >= 4, cell });
                vel = touched.velocity();
                // The last way is compared with both. Between hits the next leg would tell which of
                // them it was, by less than the roundings.
                if i + 1 < hits.len() && hit.index >= 4 && !touched.ends().is_empty() {
                    return Ok(());
                }
            } else {
                vel = respond(vel, normal, if is_squeezed(&hits, i) { Response::Slide } else { response });
            }
        }
    }
    if let Some(way) = along_an_end(level, &out.body, &touched, out.v) {
        vel = way;
    }
    // Four hits use up the iterations. The rest is reported and not made, and the next call shows
    // where the last hit left the body.
    if corners && hits.len() as u32 == Mover::ITERATIONS {
        return Ok(());
    }
    if (hits.len() as u32) < Mover::ITERATIONS {
        place = plus(place, leg(vel, 1.0 - now));
    }
    let length = (len2(v) as f64).sqrt();
    // The place at a corner is off by so much, which turns the tangent there.
    let radius = hits.iter().filter(|h| h.index >= 4).map(|h| f64::from(h.axis.x).hypot(f64::from(h.axis.y)));
    let turns = f64::from(ways::off_place(out)) * length / radius.fold(f64::INFINITY, f64::min);
    let rounding = (8.0 + length / f64::from(1 << 24) + turns) * hits.len().max(1) as f64;
    // What the hits do not tell: something else that was touched at the end or at the last hit, in
    // the way for the next 64 raw units.
    let disc = matches!(start, Body::Disc { r, .. } if *r > 0);
    let blocked_at = |body: &Body, d: V, far: f64, rounded: fn(f64) -> f64| {
        let way = d.0.abs().max(d.1.abs()).max(1.0);
        // Away from zero: a way that leads into a wall by a part of a raw unit is also blocked.
        // Exact zero with noise of floats is not.
        let d = (rounded(d.0 * far / way) as i64, rounded(d.1 * far / way) as i64);
        let one_way = || response != Response::DropThrough && rect::first_one_way(level, body, d).is_some();
        disc && (disc::enters_solid(level, body, d, Time::END) || one_way())
    };
    let blocked = |d: V, far: f64, rounded: fn(f64) -> f64| blocked_at(&out.body, d, far, rounded);
    if blocked(vel, 64.0, outward) || (corners && blocked_at(&at_last, vel, 64.0, outward)) {
        return Ok(());
    }
    // Between several surfaces, one of them round, a raw unit decides which of them are touched.
    // Then the remaining velocity leads on freely: by 4 raw of it, which the body may have made.
    if disc && corners && hits.len() > 1 && out.v != (0, 0) {
        let speed = out.v.0.abs().max(out.v.1.abs());
        let has_gone = speed as f64 * (1.0 - now) >= 4.0;
        let until = Time::new(4.min(speed), speed);
        let fronts = response != Response::DropThrough;
        let front = || rect::first_one_way(level, &out.body, out.v).is_some_and(|first| first.time < until);
        let at_once = !has_gone && (disc::enters_solid(level, &out.body, out.v, until) || (fronts && front()));
        return if at_once { Err(format!("is blocked at once, by {:?}", out.v)) } else { Ok(()) };
    }
    if !near(out.v, vel, rounding) {
        return goes_on_by_another(out.v, vel, slides && corners);
    }
    // A body that no way is free for creeps to where it is bound.
    let crept = f64::from(ways::off_place(out)) - f64::from(ways::PLACE);
    let short_leg = if first_leg.is_some_and(|leg| leg.0.hypot(leg.1) < wedge) { wedge } else { 0.0 };
    let (p, q) = (start.position(), out.body.position());
    let moved = (q.0 - p.0, q.1 - p.1);
    let left = (place.0 - moved.0 as f64, place.1 - moved.1 as f64);
    if near(moved, place, rounding + short_leg + crept) || blocked(left, 64.0, f64::trunc) {
        Ok(())
    } else {
        Err(format!("moved by {moved:?}, not {place:?}"))
    }
}

/// A box's motion along each axis is exact: from face to face, and what is left of the speed after
/// the last one.
pub fn box_is_exact(level: &Level, start: &Body, v: P, response: Response, out: &Outcome) -> Result<(), String> {
    let ((lo, hi), (end, _)) = (start.bounds(), out.body.bounds());
    let size = (hi.0 - lo.0, hi.1 - lo.1);
    // Where the box is, on the axis of the hit, when it touches each face in turn.
    let mut stops = (vec![lo.0], vec![lo.1]);
    let obeyed: Vec<&Hit> = out.hits.iter().filter(|h| response != Response::DropThrough || !h.one_way).collect();
    let ends = |along: fn(&Hit) -> i32| {
        (0..obeyed.len()).any(|i| along(obeyed[i]) != 0 && (response != Response::Bounce || is_squeezed(&obeyed, i)))
    };
    for hit in &obeyed {
        let (a, b) = level.square(hit.cell.x.into(), hit.cell.y.into());
        match hit.index {
            0 => stops.1.push(a.1 - size.1),
            1 => stops.0.push(b.0),
            2 => stops.1.push(b.1),
            _ => stops.0.push(a.0 - size.0),
        }
    }
    let axis = |stops: &[i64], ends: bool, end: i64, v: i64, remaining: i64| {
        let way: i64 = stops.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
        let last = *stops.last().unwrap_or(&end);
        if ends { end == last && remaining == 0 } else { way + (end - last).abs() + remaining.abs() == v.abs() }
    };
    let ok = axis(&stops.0, ends(|h| h.axis.x), end.0, v.0, out.remaining.0)
        && axis(&stops.1, ends(|h| h.axis.y), end.1, v.1, out.remaining.1);
    let stopped = response == Response::Touch && !out.hits.is_empty();
    if ok || stopped { Ok(()) } else { Err("a box's motion is not exact".to_owned()) }
}
