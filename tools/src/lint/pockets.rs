//! Finds room between two faces that is too narrow for the body.

use super::finding::Severity::Warning;
use super::finding::pixels;
use super::index::{Bounds, Index, Work};
use super::scene::{Body, Scene};
use crate::geometry::{Edge, Point, Side, hides};

type Wide = (i128, i128);

/// The room between two faces, measured along a direction.
struct Gap {
    /// Rounded down to raw units.
    least: i128,
    most: i128,
    /// Raw points of the faces that are opposite each other, half way along.
    ends: [Point; 2],
}

pub(super) fn check(scene: &mut Scene<'_>) {
    let Some(body) = scene.rules.body else { return };
    let faces = faces(scene);
    let index = Index::new(&faces);
    let reach = match body {
        Body::Box { width, height } => width.max(height),
        Body::Circle { radius } => 2 * radius,
    };
    let mut work = Work::for_edges(faces.len());
    for (i, s) in faces.iter().enumerate() {
        let near: Vec<usize> = index.near(s, reach, &mut work).filter(|&j| j != i).collect();
        for j in near {
            let t = &faces[j];
            let Some((gap, what)) = too_narrow(body, s, t, i < j) else { continue };
            let [p, q] = gap.ends;
            let hidden =
                index.within(Bounds::of(gap.ends), &mut work).any(|k| k != i && k != j && hides(&faces[k], p, q));
            if !hidden && !work.is_spent() {
                let at = ((p.0 + q.0).div_euclid(2), (p.1 + q.1).div_euclid(2));
                let who = vec![scene.who(s), scene.who(t)];
                scene.say((Warning, "pocket"), who, at, what, "the body cannot get in, or gets stuck on its way");
            }
        }
        if work.is_spent() {
            return scene.say_unfinished(s, "the linter did not check narrow gaps from here on");
        }
    }
}

/// All sides that block. A wall has two.
fn faces(scene: &Scene<'_>) -> Vec<Edge> {
    let mut faces = Vec::new();
    for edge in scene.edges.iter().chain(scene.surface.iter().flat_map(|surface| &surface.edges)) {
        match edge.side {
            Side::Solid => faces.push(*edge),
            Side::Wall => faces.extend([*edge, edge.reversed()]),
            Side::OneWay => {}
        }
    }
    faces
}

fn too_narrow(body: Body, s: &Edge, t: &Edge, first: bool) -> Option<(Gap, String)> {
    match body {
        // Each pair comes twice, and one of the two is ahead along the axis.
        Body::Box { width, height } => {
            let steep = |e: &Edge| e.normal().0.abs() > e.normal().1.abs();
            let flat = |e: &Edge| e.normal().1.abs() > e.normal().0.abs();
            let (axis, need, word) = if steep(s) && steep(t) {
                ((1, 0), width, "wide")
            } else if flat(s) && flat(t) {
                ((0, 1), height, "high")
            } else {
                return None;
            };
            narrow(gap(s, t, axis)?, need, word)
        }
        // Along the normal of the longer one. On a tie, of the first.
        Body::Circle { radius } => {
            let (a, b) = (s.length_squared(), t.length_squared());
            let dot = s.normal().0 * t.normal().0 + s.normal().1 * t.normal().1;
            let opposed = dot < 0 && 2 * dot * dot > a * b;
            let leads = a > b || a == b && first;
            if leads && opposed { narrow(gap(s, t, s.normal())?, 2 * radius, "wide") } else { None }
        }
    }
}

/// Faces that meet are a corner. A corner is a pocket only if its mouth is too narrow.
fn narrow(gap: Gap, need: i64, word: &str) -> Option<(Gap, String)> {
    let need = i128::from(need);
    if gap.most >= need && (gap.least == 0 || gap.least >= need) {
        return None;
    }
    let show = |raw: i128| pixels(raw as i64);
    let what = match (show(gap.least), show(gap.most)) {
        (least, most) if least == most => format!("the room between them is {most} {word}, the body {}", show(need)),
        (least, most) => format!("the room between them is {least} to {most} {word}, the body {}", show(need)),
    };
    Some((gap, what))
}

/// `None` if `t` is not in front of `s`, seen along `n`.
fn gap(s: &Edge, t: &Edge, n: Wide) -> Option<Gap> {
    let dot = |(x, y): Wide, (z, w): Wide| x * z + y * w;
    if dot(s.normal(), n) <= 0 || dot(t.normal(), n) >= 0 {
        return None;
    }
    let square = dot(n, n);
    let along = (-n.1, n.0);
    // Relative to s: below 2^31 along an axis, else below 2^62.
    let origin = s.a;
    let frame = |p: Point| {
        let p = (i128::from(p.0 - origin.0), i128::from(p.1 - origin.1));
        (dot(p, along), dot(p, n))
    };
    let (s, t) = (Line::new(frame(s.a), frame(s.b)), Line::new(frame(t.a), frame(t.b)));
    let (from, to) = (s.from.0.max(t.from.0), s.to.0.min(t.to.0));
    if from >= to {
        return None;
    }
    let [first, last] = [from, to].map(|u| t.at(u) - s.at(u));
    if first < 0 || last < 0 || first + last == 0 {
        return None;
    }
    // In raw units, rounded down. The root of a quotient rounded down is the rounded quotient.
    let raw = |v: i128| (v * v / square).isqrt();
    let middle = (from + to).div_euclid(2);
    let back = |v: i128| {
        let nearest = |x: i128| (2 * x + square).div_euclid(2 * square) as i64;
        (origin.0 + nearest(along.0 * middle + n.0 * v), origin.1 + nearest(along.1 * middle + n.1 * v))
    };
    let ends = [s.at(middle), t.at(middle)].map(back);
    Some(Gap { least: raw(first.min(last)), most: raw(first.max(last)), ends })
}

/// A face in the frame of a gap, from smaller to larger u.
struct Line {
    from: Wide,
    to: Wide,
}

impl Line {
    fn new(a: Wide, b: Wide) -> Self {
        if a.0 <= b.0 { Self { from: a, to: b } } else { Self { from: b, to: a } }
    }

    /// v at u, rounded down.
    fn at(&self, u: i128) -> i128 {
        let (du, dv) = (self.to.0 - self.from.0, self.to.1 - self.from.1);
        self.from.1 + ((u - self.from.0) * dv).div_euclid(du)
    }
}
