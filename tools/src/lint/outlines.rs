//! Checks each outline by itself.

use super::edges::{in_domain, is_sound};
use super::finding::Severity::{Error, Note, Warning};
use super::finding::{Who, pixels};
use super::scene::Scene;
use crate::geometry::{Point, doubled_area};
use crate::rules::outline::Outline;

pub(super) fn check(scene: &mut Scene<'_>) {
    for left_out in &scene.drawing.left_out {
        let who = Who { id: left_out.title.id, title: left_out.title.to_string().into(), edge: None };
        let severity = if left_out.suspicious { Warning } else { Note };
        let then = if left_out.is_listed() {
            "it is not solid: bake writes it to OBJECTS"
        } else {
            "nothing collides with it"
        };
        scene.say((severity, "left-out"), vec![who], left_out.at, left_out.why.clone(), then);
    }
    for doubt in &scene.drawing.doubts {
        let who = Who { id: 0, title: doubt.who.as_str().into(), edge: None };
        let at = (scene.drawing.origin.0.into(), scene.drawing.origin.1.into());
        scene.say((Warning, "doubtful"), vec![who], at, doubt.what.clone(), doubt.why);
    }
    for i in 0..scene.drawing.outlines.len() {
        let outline = &scene.drawing.outlines[i];
        form(scene, i, outline);
        if is_sound(outline) {
            rounding(scene, i, outline);
            lengths(scene, i, outline);
            area(scene, i, outline);
            corners(scene, i, outline);
        }
    }
}

fn form(scene: &mut Scene<'_>, i: usize, outline: &Outline) {
    let first = outline.points.first().copied().unwrap_or((0, 0));
    let who = vec![scene.owner(i, None)];
    let count = outline.points.len();
    if outline.kind.has_area() && (!outline.closed || count < 3) {
        let what = format!("a {} of {count} points that is not closed", outline.kind);
        scene.say((Error, "not-closed"), who.clone(), first, what, "it has no inside");
    } else if count < 2 {
        let what = format!("a {} of {count} points", outline.kind);
        scene.say((Error, "not-closed"), who.clone(), first, what, "a chain needs two points to block");
    }
    if let Some(&p) = outline.points.iter().find(|&&p| !in_domain(p)) {
        let what = "a point beyond the domain";
        scene.say((Error, "out-of-domain"), who, p, what, "coordinates stay below 8192 pixels");
    }
}

fn rounding(scene: &mut Scene<'_>, i: usize, outline: &Outline) {
    let moved = outline.rounding.iter().filter(|&&off| off > 0).count();
    let Some((worst, &off)) = outline.rounding.iter().enumerate().max_by_key(|&(k, off)| (off, usize::MAX - k)) else {
        return;
    };
    if moved > 0 {
        let what = format!(
            "{moved} of {} points lie between raw units and were rounded, this one by {}.{:03} raw",
            outline.points.len(),
            off / 1000,
            off % 1000
        );
        let why = "points that should lie on a line or on each other may miss it by a raw unit";
        scene.say((Note, "off-lattice"), vec![scene.owner(i, None)], outline.points[worst], what, why);
    }
}

fn lengths(scene: &mut Scene<'_>, i: usize, outline: &Outline) {
    let small = i128::from(scene.rules.small);
    for (number, (a, b)) in outline.edges().enumerate() {
        let (x, y) = (i128::from(b.0 - a.0), i128::from(b.1 - a.1));
        let square = x * x + y * y;
        let who = vec![scene.owner(i, Some(number))];
        if square == 0 {
            scene.say((Error, "zero-length"), who, a, "no length", "an edge without a direction has no normal");
        } else if square < small * small {
            let what = format!("{} long", pixels(square.isqrt() as i64));
            scene.say((Warning, "sliver"), who, a, what, "a body may catch on it: move its two corners onto one point");
        }
    }
}

fn area(scene: &mut Scene<'_>, i: usize, outline: &Outline) {
    if !outline.kind.has_area() {
        return;
    }
    let doubled = doubled_area(&outline.points).abs();
    let longest = outline.edges().map(|(a, b)| distance_squared(a, b)).max().unwrap_or(0).isqrt().max(1);
    let (who, at) = (vec![scene.owner(i, None)], outline.points[0]);
    if doubled == 0 {
        scene.say((Error, "no-area"), who, at, "no area", "it has no inside");
    } else if doubled < 2 * i128::from(scene.rules.small) * longest {
        let what = format!("on average only {} thick", pixels((doubled / longest / 2) as i64));
        scene.say((Warning, "sliver"), who, at, what, "a body meets two of its faces at once");
    }
}

fn corners(scene: &mut Scene<'_>, i: usize, outline: &Outline) {
    let count = outline.points.len();
    let at = |k: usize| outline.points[k % count];
    let range = if outline.closed { 0..count } else { 0..count.saturating_sub(2) };
    for k in range {
        let (before, corner, after) = (at(k), at(k + 1), at(k + 2));
        let cross = crate::geometry::orient(corner, before, after).abs();
        let dot = dot(corner, before, after);
        // Less than an eighth of a radian, 7 degrees. Another check finds edges that lie on each
        // other.
        if cross != 0 && dot > 0 && cross < dot / 8 {
            let who = vec![scene.owner(i, Some((k + 1) % count))];
            let what = "an angle of less than 7 degrees where this edge begins";
            scene.say((Warning, "sliver"), who, corner, what, "bodies get wedged in it or catch on it");
        }
    }
}

fn distance_squared(a: Point, b: Point) -> i128 {
    dot(a, b, b)
}

fn dot(origin: Point, p: Point, q: Point) -> i128 {
    i128::from(p.0 - origin.0) * i128::from(q.0 - origin.0) + i128::from(p.1 - origin.1) * i128::from(q.1 - origin.1)
}
