//! Contacts of every pair of shapes: the points of the manifold, the way out, and A pushed out.

use tilesat::prelude::*;
use tilesat::shape::AnyShape;
use tilesat::{Aabb, Axis, Capsule, Circle, ConvexPolygon, Fx, OrientedBox, RangeError, Segment, Vec2};

use super::glyphs::{self, Frame};
use crate::fail::{Fail, Result};
use crate::picture::ink::{COIN, CONTACT, FAINT, Ink, SLIDE, TEXT, TOUCH};
use crate::picture::marks::{Scene, Spot};

type Any = AnyShape<5>;

const PANEL: f32 = 170.0;
/// Where B is drawn in its panel.
const MIDDLE: Vec2 = Vec2::from_ints(96, 104);
const NAMES: [&str; 6] = ["Aabb", "Circle", "Segment", "Capsule", "OrientedBox", "ConvexPolygon"];

pub(super) fn sheet() -> Result<Scene> {
    let side = PANEL * NAMES.len() as f32;
    let mut scene = Scene::new(side, side + 30.0, 1.0, 1.0);
    for (row, (a, name)) in shapes(MIDDLE - Vec2::from_ints(22, 14))?.iter().zip(NAMES).enumerate() {
        for (column, (b, other)) in shapes(MIDDLE)?.iter().zip(NAMES).enumerate() {
            let at = (column as f32 * PANEL, row as f32 * PANEL);
            scene.text((at.0 + 8.0, at.1 + 18.0), format!("{name}, {other}"), FAINT);
            panel(&mut scene, at, a, b).map_err(|e| Fail::new(format!("{name}, {other}: {e}")))?;
        }
    }
    let legend = "A  B  points of the manifold, normal from A to B; faint: A after its push";
    scene.text((8.0, side + 16.0), legend, TEXT);
    Ok(scene)
}

/// One of each kind around a point.
fn shapes(at: Vec2) -> Result<[Any; 6]> {
    let p = |x, y| at + Vec2::from_ints(x, y);
    let radius = Fx::from_num(8);
    let make = || -> std::result::Result<_, RangeError> {
        Ok([
            Aabb::new(p(-26, -18), p(26, 18))?.into(),
            Circle::new(at, Fx::from_num(24))?.into(),
            Segment::new(p(-28, -16), p(28, 14))?.into(),
            Capsule::new(p(-18, 14), p(18, -14), Fx::from_num(12))?.into(),
            OrientedBox::new(at, Vec2::from_ints(24, 14), Axis::new(2, 1))?.into(),
        ])
    };
    let [a, b, c, d, e] = make().map_err(|e| Fail::new(e.to_string()))?;
    let polygon = ConvexPolygon::new(&[p(-18, -12), p(10, -18), p(20, 4), p(2, 18), p(-16, 12)]);
    let polygon = polygon.map_err(|e| Fail::new(e.to_string()))?;
    Ok([a, b, c, d, e, polygon.with_radius(radius).map_err(|e| Fail::new(e.to_string()))?.into()])
}

fn panel(scene: &mut Scene, at: Spot, a: &Any, b: &Any) -> std::result::Result<(), RangeError> {
    outline(scene, at, b, SLIDE)?;
    outline(scene, at, a, COIN)?;
    let Some(manifold) = a.manifold(b) else { return Ok(()) };
    outline(scene, at, &a.translated(manifold.deepest().contact.push_out())?, COIN.alpha(0.35))?;
    let frame = Frame { at, scale: 1.0, arrow: 20.0, details: false };
    let unit = manifold.axis().unit();
    let normal = (unit.x().to_num::<f32>(), unit.y().to_num::<f32>());
    for point in manifold.points() {
        let (on_a, on_b) = (spot(at, point.contact.point_on_a()), spot(at, point.contact.point_on_b()));
        scene.line(vec![on_a, on_b], 2.0, TOUCH, false);
        scene.disc(on_b, 3.0, CONTACT);
        glyphs::arrow(scene, &frame, on_a, normal, TOUCH);
    }
    Ok(())
}

fn spot(at: Spot, p: Vec2) -> Spot {
    (at.0 + p.x.to_num::<f32>(), at.1 + p.y.to_num::<f32>())
}

/// A shape's border: the points of it that are nearest to those of a circle around it.
fn outline(scene: &mut Scene, at: Spot, shape: &Any, ink: Ink) -> std::result::Result<(), RangeError> {
    let bounds = shape.aabb();
    let middle = bounds.min() + (bounds.max() - bounds.min()) * Fx::from_num(0.5);
    let mut border = Vec::new();
    for k in 0..=240 {
        let far = Axis::from_turns(Fx::from_num(k) / 240).unit().scaled(Fx::from_num(60));
        let point = Any::from(Circle::new(middle + far, Fx::ZERO)?);
        border.extend(shape.closest_points(&point).map(|(on_shape, _)| spot(at, on_shape)));
    }
    scene.line(border, 2.0, ink, false);
    Ok(())
}
