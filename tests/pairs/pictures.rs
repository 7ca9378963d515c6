//! The picture in the documentation of `query` is drawn from the library's answers.
//!
//! `TILESAT_BLESS=1 cargo test --test pairs pictures` draws it again.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use tilesat::prelude::*;
use tilesat::shape::AnyShape;
use tilesat::{Aabb, Axis, Capsule, Circle, ConvexPolygon, OrientedBox, Segment, Vec2, fx};

type Any = AnyShape<5>;

/// The size of a panel, and how many there are in a row.
const PANEL: Vec2 = Vec2::from_ints(92, 66);
const ROW: usize = 3;
const MARKS: (&str, &str) = ("//! <!-- contacts:begin -->\n", "//! <!-- contacts:end -->\n");
/// Longer lines are refused by the checks of the sources.
const COLUMNS: usize = 100;

/// One of each kind, into the upper left of the box B.
fn shapes() -> Result<[(&'static str, Any); 6], Box<dyn std::error::Error>> {
    let p = Vec2::from_ints;
    let polygon = ConvexPolygon::new(&[p(14, 26), p(34, 16), p(50, 30), p(40, 42), p(20, 40)])?;
    Ok([
        ("Aabb", Aabb::new(p(20, 18), p(48, 38))?.into()),
        ("Circle", Circle::new(p(32, 30), fx!(16))?.into()),
        ("Segment", Segment::new(p(22, 46), p(58, 24))?.into()),
        ("Capsule", Capsule::new(p(18, 36), p(44, 25), fx!(9))?.into()),
        ("OrientedBox", OrientedBox::new(p(34, 28), p(18, 9), Axis::new(3, 1))?.into()),
        ("ConvexPolygon", polygon.with_radius(fx!(3))?.into()),
    ])
}

/// Corners, and the radius around them.
fn corners(shape: &Any) -> (Vec<Vec2>, f64) {
    let (points, radius) = match shape {
        Any::Aabb(it) => {
            let (lo, hi) = (it.min(), it.max());
            (vec![lo, Vec2::new(hi.x, lo.y), hi, Vec2::new(lo.x, hi.y)], fx!(0))
        }
        Any::Circle(it) => (vec![it.centre()], it.radius()),
        Any::Segment(it) => (vec![it.a(), it.b()], fx!(0)),
        Any::Capsule(it) => (vec![it.a(), it.b()], it.radius()),
        Any::OrientedBox(it) => (it.corners().to_vec(), it.radius()),
        Any::Polygon(it) => (it.vertices().to_vec(), it.radius()),
    };
    (points, radius.to_num())
}

fn spot(p: Vec2) -> String {
    let one = |v: tilesat::Fx| format!("{:.1}", v.to_num::<f64>()).trim_end_matches(".0").to_owned();
    format!("{},{}", one(p.x), one(p.y))
}

/// The shape as a thick line around its corners, which the radius makes round.
fn element(shape: &Any) -> String {
    let (points, radius) = corners(shape);
    let list: Vec<String> = points.iter().map(|p| spot(*p)).collect();
    format!("<path d=\"M{}Z\" stroke-width=\"{}\"/>", list.join(" "), 2.0 * radius + 1.0)
}

fn picture() -> Result<String, Box<dyn std::error::Error>> {
    let mut out = String::from("<p>\n");
    let (wide, high) = (PANEL.x.to_num::<i32>() * ROW as i32, PANEL.y.to_num::<i32>() * 2);
    writeln!(out, "<svg width=\"{}\" height=\"{}\" viewBox=\"0 0 {wide} {high}\"", 2 * wide, 2 * high)?;
    writeln!(out, "font-size=\"7\" stroke-linejoin=\"round\" stroke-linecap=\"round\">")?;
    for (i, (name, a)) in shapes()?.iter().enumerate() {
        panel(&mut out, i, name, a)?;
    }
    out.push_str("</svg>\n</p>\n");
    Ok(out)
}

fn panel(out: &mut String, i: usize, name: &str, a: &Any) -> Result<(), Box<dyn std::error::Error>> {
    let b: Any = Aabb::new(Vec2::from_ints(40, 32), Vec2::from_ints(84, 62))?.into();
    let manifold = a.manifold(&b).ok_or("apart")?;
    let contact = manifold.deepest().contact;
    let at = Vec2::new(PANEL.x * (i % ROW) as i32, PANEL.y * (i / ROW) as i32);
    writeln!(out, "<g transform=\"translate({})\">", spot(at))?;
    writeln!(out, "<text x=\"3\" y=\"9\" fill=\"currentColor\">{name}</text>")?;
    let pushed = a.translated(contact.push_out())?;
    for (ink, opacity, body) in [("#888", "0.5", b), ("#d80", "0.6", *a), ("#d80", "0.2", pushed)] {
        writeln!(out, "<g fill=\"{ink}\" stroke=\"{ink}\" opacity=\"{opacity}\">")?;
        writeln!(out, "{}</g>", element(&body))?;
    }
    // From the point on A, 10 units along the normal.
    let to = manifold.axis().unit().scaled(fx!(10));
    writeln!(out, "<g fill=\"none\" stroke=\"#d22\">")?;
    for point in manifold.points() {
        let (on_a, on_b) = (point.contact.point_on_a(), point.contact.point_on_b());
        writeln!(out, "<path d=\"M{}L{}\" stroke-width=\"3\"/>", spot(on_b), spot(on_b))?;
        writeln!(out, "<path d=\"M{}L{}\"/>", spot(on_a), spot(on_a + to))?;
    }
    out.push_str("</g>\n</g>\n");
    Ok(())
}

#[test]
fn the_documentation_s_picture_is_the_library_s_answer() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/query/mod.rs");
    let text = fs::read_to_string(&path).unwrap();
    let (before, rest) = text.split_once(MARKS.0).expect("the begin of the picture");
    let (shown, after) = rest.split_once(MARKS.1).expect("the end of the picture");
    let mut drawn = String::new();
    for line in picture().unwrap().lines() {
        writeln!(drawn, "//! {line}").unwrap();
    }
    for line in drawn.lines() {
        assert!(line.len() <= COLUMNS, "{} columns: {line}", line.len());
    }
    if std::env::var_os("TILESAT_BLESS").is_some() {
        fs::write(&path, format!("{before}{}{drawn}{}{after}", MARKS.0, MARKS.1)).unwrap();
    } else {
        assert_eq!(shown, drawn, "src/query/mod.rs shows other contacts: see tests/pairs/pictures.rs");
    }
}
