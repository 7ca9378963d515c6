//! Pictures of the results: cost against error, both on logarithmic scales. One panel per class,
//! one point per backend and question.

use crate::record::Row;
use std::collections::BTreeMap;
use std::fmt::Write;

const WIDTH: f64 = 390.0;
const HEIGHT: f64 = 250.0;
/// Room for the labels of an axis, left and below.
const LEFT: f64 = 68.0;
const BELOW: f64 = 34.0;
const ABOVE: f64 = 22.0;
const RIGHT: f64 = 14.0;
const COLUMNS: usize = 3;

/// The content of a picture.
pub struct Axes<'a> {
    pub title: String,
    /// The values of a row along x and y. A row that lacks one has no point.
    pub x: (&'a str, fn(&Row) -> Option<f64>),
    pub y: (&'a str, fn(&Row) -> Option<f64>),
}

/// A colour per backend, and a marker.
const STYLES: [(&str, &str, char); 22] = [
    ("tilesat", "#0a7a2f", 'o'),
    ("exact (no filters)", "#74b816", 'o'),
    ("plain integer DDA", "#74b816", 'o'),
    ("naive Q16.16", "#c92a2a", 'x'),
    ("wide Q16.16", "#f08c00", 'x'),
    ("textbook f32", "#1971c2", '+'),
    ("textbook f64", "#4dabf7", '+'),
    ("parry2d", "#862e9c", 's'),
    ("parry2d (special)", "#862e9c", 'd'),
    ("parry2d-f64", "#da77f2", 's'),
    ("parry2d-f64 (special)", "#da77f2", 'd'),
    ("ncollide2d I16F16", "#a61e4d", 't'),
    ("Box2D", "#343a40", 's'),
    ("Chipmunk2D", "#868e96", 's'),
    ("parry2d Voxels", "#862e9c", 's'),
    ("parry2d Compound", "#862e9c", 'd'),
    ("parry2d-f64 Voxels", "#da77f2", 's'),
    ("parry2d-f64 Compound", "#da77f2", 'd'),
    ("rapier2d", "#862e9c", 's'),
    ("broccoli", "#2f9e44", 't'),
    ("rstar", "#495057", 'd'),
    ("quadtree_rs", "#868e96", 'o'),
];

fn style(backend: &str) -> (&'static str, char) {
    STYLES.iter().find(|s| s.0 == backend).map_or(("#000000", 'o'), |s| (s.1, s.2))
}

/// Draws a marker. Full: a yes or no. Hollow: everything that a contact has. Half: a contact that
/// computes the rest on request, or a distance.
fn sign(out: &mut String, (x, y): (f64, f64), backend: &str, asked: &str) {
    let (colour, shape) = style(backend);
    let fill = match asked {
        "contact" => "white",
        "contact (lazy)" => "#b2f2bb",
        "distance" => "#ffec99",
        _ => colour,
    };
    let pen = format!("stroke='{colour}' stroke-width='1.6' fill='{fill}'");
    let _ = match shape {
        'o' => writeln!(out, "<circle cx='{x:.1}' cy='{y:.1}' r='4.5' {pen}/>"),
        's' => writeln!(out, "<rect x='{:.1}' y='{:.1}' width='8' height='8' {pen}/>", x - 4.0, y - 4.0),
        'd' => writeln!(out, "<path d='M{x:.1} {:.1}l5 5l-5 5l-5 -5z' {pen}/>", y - 5.0),
        't' => writeln!(out, "<path d='M{x:.1} {:.1}l5 9h-10z' {pen}/>", y - 5.0),
        // A cross that is open has a dot of the background in it.
        _ => {
            let (a, b) = if shape == 'x' { ("m-4 -4l8 8m0 -8l-8 8", 2.2) } else { ("m-5 0h10m-5 -5v10", 2.2) };
            let _ = writeln!(out, "<path d='M{x:.1} {y:.1}{a}' stroke='{colour}' stroke-width='{b}' fill='none'/>");
            if fill == colour { Ok(()) } else { writeln!(out, "<circle cx='{x:.1}' cy='{y:.1}' r='2' fill='white'/>") }
        }
    };
}

/// Powers of ten that hold all values.
#[derive(Clone, Copy)]
struct Decades {
    lo: i32,
    hi: i32,
}

impl Decades {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let (mut lo, mut hi) = (i32::MAX, i32::MIN);
        for v in values.filter(|v| *v > 0.0) {
            lo = lo.min(v.log10().floor() as i32);
            hi = hi.max(v.log10().ceil() as i32);
        }
        if lo > hi { Self { lo: 0, hi: 1 } } else { Self { lo, hi: hi.max(lo + 1) } }
    }

    /// From 0 to 1.
    fn place(self, v: f64) -> f64 {
        (v.log10() - f64::from(self.lo)) / f64::from(self.hi - self.lo)
    }

    /// Few enough that they do not meet.
    fn ticks(self) -> impl Iterator<Item = i32> {
        let step = ((self.hi - self.lo) / 6).max(1);
        (self.lo..=self.hi).filter(move |k| (k - self.lo) % step == 0)
    }
}

fn label(power: i32) -> String {
    match power {
        -2..=5 => format!("{}", 10f64.powi(power)),
        _ => format!("1e{power}"),
    }
}

/// A row and its position.
type Point<'a> = (&'a Row, f64, f64);

/// Share of a panel's height for zero, which has no logarithm.
const LANE: f64 = 0.2;

pub fn svg(rows: &[&Row], axes: &Axes<'_>) -> String {
    let points: Vec<Point<'_>> = rows.iter().filter_map(|&r| Some((r, (axes.x.1)(r)?, (axes.y.1)(r)?))).collect();
    let mut panels: Vec<(&str, Vec<&Point<'_>>)> = Vec::new();
    for point in &points {
        match panels.iter_mut().find(|p| p.0 == point.0.class()) {
            Some(panel) => panel.1.push(point),
            None => panels.push((point.0.class(), vec![point])),
        }
    }
    let (x, y) = (Decades::of(points.iter().map(|p| p.1)), Decades::of(points.iter().map(|p| p.2)));
    let lines = panels.len().div_ceil(COLUMNS).max(1);
    let legend = legend(&points);
    let legend_rows = legend.len().div_ceil(4);
    let width = WIDTH * COLUMNS as f64;
    let top = 34.0;
    let height = top + HEIGHT * lines as f64 + 20.0 * legend_rows as f64 + 16.0;
    let mut out = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {height}' font-family='sans-serif' font-size='12'>\n\
         <rect width='100%' height='100%' fill='white'/>\n\
         <text x='{}' y='22' font-size='16' text-anchor='middle' font-weight='bold'>{}</text>\n",
        width / 2.0,
        axes.title
    );
    for (i, (class, points)) in panels.iter().enumerate() {
        let (dx, dy) = ((i % COLUMNS) as f64 * WIDTH, top + (i / COLUMNS) as f64 * HEIGHT);
        let _ = writeln!(out, "<g transform='translate({dx} {dy})'>");
        panel(&mut out, class, points, axes, (x, y));
        out.push_str("</g>\n");
    }
    for (i, ((backend, asked), text)) in legend.iter().enumerate() {
        let at = ((i % 4) as f64 * width / 4.0 + 20.0, top + HEIGHT * lines as f64 + 14.0 + (i / 4) as f64 * 20.0);
        sign(&mut out, at, backend, asked);
        let _ = writeln!(out, "<text x='{:.1}' y='{:.1}'>{text}</text>", at.0 + 12.0, at.1 + 4.0);
    }
    out.push_str("</svg>\n");
    out
}

/// The backends with markers, in the order of the rows.
fn legend<'a>(points: &[Point<'a>]) -> Vec<((&'a str, &'a str), String)> {
    let mut seen: BTreeMap<(&str, &str), ()> = BTreeMap::new();
    let mut out = Vec::new();
    for (row, ..) in points {
        let key = (row.backend(), row.asked());
        if seen.insert(key, ()).is_none() {
            out.push((key, format!("{}: {}", key.0, key.1)));
        }
    }
    out
}

fn panel(out: &mut String, class: &str, points: &[&Point<'_>], axes: &Axes<'_>, (x, y): (Decades, Decades)) {
    let (w, h) = (WIDTH - LEFT - RIGHT, HEIGHT - ABOVE - BELOW);
    let floor = ABOVE + h;
    let across = |v: f64| LEFT + w * x.place(v);
    let up = |v: f64| if v > 0.0 { floor - h * (LANE + (1.0 - LANE) * y.place(v)) } else { floor - h * LANE / 2.0 };
    let _ = writeln!(out, "<text x='{}' y='15' text-anchor='middle' font-weight='bold'>{class}</text>", LEFT + w / 2.0);
    // The lane of zero has another background.
    let _ = writeln!(
        out,
        "<rect x='{LEFT}' y='{:.1}' width='{w}' height='{:.1}' fill='#e6f4ea'/><text x='{}' y='{:.1}' text-anchor='end'>0</text>",
        floor - h * LANE,
        h * LANE,
        LEFT - 5.0,
        up(0.0) + 4.0
    );
    for k in y.ticks() {
        let at = up(10f64.powi(k));
        let _ = writeln!(
            out,
            "<path d='M{LEFT} {at:.1}h{w}' stroke='#ddd'/><text x='{}' y='{:.1}' text-anchor='end'>{}</text>",
            LEFT - 5.0,
            at + 4.0,
            label(k)
        );
    }
    for k in x.ticks() {
        let at = across(10f64.powi(k));
        let _ = writeln!(
            out,
            "<path d='M{at:.1} {ABOVE}v{h}' stroke='#ddd'/><text x='{at:.1}' y='{:.1}' text-anchor='middle'>{}</text>",
            floor + 15.0,
            label(k)
        );
    }
    let _ = writeln!(
        out,
        "<rect x='{LEFT}' y='{ABOVE}' width='{w}' height='{h}' fill='none' stroke='#888'/>\
         <text x='{}' y='{:.1}' text-anchor='middle' fill='#555' font-size='11'>{}</text>\
         <text transform='translate(11 {:.1}) rotate(-90)' text-anchor='middle' fill='#555' font-size='11'>{}</text>",
        LEFT + w / 2.0,
        floor + 29.0,
        axes.x.0,
        ABOVE + h / 2.0,
        axes.y.0
    );
    // The library's last, on top.
    for (row, a, b) in points.iter().rev() {
        // In the lane of zero, height means nothing. It only separates the markers.
        let kind = STYLES.iter().position(|s| s.0 == row.backend()).unwrap_or(0);
        let lift = if *b > 0.0 { 0.0 } else { (kind % 3) as f64 * 12.0 - 12.0 };
        sign(out, (across(*a), up(*b) + lift), row.backend(), row.asked());
    }
}
