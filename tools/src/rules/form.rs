//! The corners of drawn objects.

use crate::model::decimal::Decimal;
use crate::model::object::{Form, Object, Spot, Stamp};

/// The corners, and whether the last one joins the first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Corners {
    pub(super) points: Vec<Spot>,
    pub(super) closed: bool,
    /// For round forms: the greatest distance between the form and the polygon within it, in
    /// thousandths of a pixel.
    pub(super) error: u32,
}

/// The tolerance of round forms, in pixels.
const OFF: f64 = 1.0 / 8.0;
/// More segments would not be visible, and cost flash.
const MOST_CORNERS: u32 = 64;

/// The corners of an object. `None` for a point and a text, which have no extent, and for unknown
/// forms.
pub(super) fn corners(object: &Object) -> Option<Corners> {
    enlarged(object, 1.0)
}

/// The same of an object that is drawn so many times larger: round forms have more corners, and the
/// error is that of the drawing.
pub(super) fn enlarged(object: &Object, zoom: f64) -> Option<Corners> {
    let ((w, h), zero) = (object.size, Decimal::ZERO);
    let box_of = |top: Decimal, bottom: Decimal| vec![(zero, top), (w, top), (w, bottom), (zero, bottom)];
    let (points, closed, error) = match &object.form {
        Form::Point | Form::Text => return None,
        Form::Rectangle => (box_of(zero, h), true, 0),
        Form::Tile(stamp) => {
            let points = of_picture(object, stamp, &box_of(zero, h));
            return Some(Corners { points, closed: true, error: 0 });
        }
        Form::Ellipse => round(object.size, object.size, zoom),
        Form::Capsule => {
            let side = w.min(h);
            round(object.size, (side, side), zoom)
        }
        Form::Polygon(points) => (points.clone(), true, 0),
        Form::Polyline(points) => {
            // A chain that ends where it began is a loop.
            let joined = points.len() > 3 && points.first() == points.last();
            let end = points.len() - usize::from(joined);
            (points[..end].to_vec(), joined, 0)
        }
    };
    Some(Corners { points: points.into_iter().map(|point| placed(object, point)).collect(), closed, error })
}

/// Whether an object can be solid. Points and texts have no extent, nor has a rectangle that an
/// editor draws if the user clicks instead of dragging.
pub(super) fn has_extent(object: &Object) -> bool {
    match object.form {
        Form::Point | Form::Text => false,
        Form::Rectangle | Form::Ellipse | Form::Capsule => object.size != (Decimal::ZERO, Decimal::ZERO),
        Form::Polygon(_) | Form::Polyline(_) | Form::Tile(_) => true,
    }
}

/// Whether an object or a shape has a number that is too large to be meant. See
/// [`Decimal::saturated`].
pub(super) fn is_far(object: &Object) -> bool {
    [object.at.0, object.at.1, object.size.0, object.size.1].into_iter().any(Decimal::is_far)
}

/// Points from the corner of a tile's picture, at their positions in the layer.
pub(super) fn of_picture(object: &Object, stamp: &Stamp, points: &[Spot]) -> Vec<Spot> {
    let along = |halves: u32, side: Decimal, offset: Decimal| offset - side.scaled(halves, 2);
    let x = along(stamp.align.0, object.size.0, stamp.offset.0);
    let y = along(stamp.align.1, object.size.1, stamp.offset.1);
    points.iter().map(|p| placed(object, (p.0 + x, p.1 + y))).collect()
}

/// A point of an object at its position in the layer.
fn placed(object: &Object, point: Spot) -> Spot {
    let (x, y) = turned(point, object.rotation);
    (object.at.0 + x, object.at.1 + y)
}

/// A box of this size whose corners are quarters of an ellipse of that size.
fn round((w, h): Spot, (wide, high): Spot, zoom: f64) -> (Vec<Spot>, bool, u32) {
    let half = |v: Decimal| v.to_f64() / 2.0;
    let (rx, ry) = (half(wide), half(high));
    let radius = rx.max(ry) * zoom;
    let off = |corners: u32| radius * (1.0 - (std::f64::consts::PI / f64::from(corners)).cos());
    let corners = (2..=MOST_CORNERS / 4).map(|k| 4 * k).find(|&k| off(k) <= OFF).unwrap_or(MOST_CORNERS);
    let (far_x, far_y) = (w.to_f64() - rx, h.to_f64() - ry);
    let mut points: Vec<Spot> = Vec::new();
    for k in 0..corners {
        let quarter = 4 * k / corners;
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / f64::from(corners)).sin_cos();
        // The quarters lie around the lower right, lower left, upper left and upper right.
        let x = if matches!(quarter, 0 | 3) { far_x } else { rx };
        let y = if quarter < 2 { far_y } else { ry };
        // A straight side leads from the end of one quarter to the next.
        if k * 4 % corners == 0 && k > 0 {
            let before =
                (if matches!(quarter, 0 | 1) { far_x } else { rx }, if matches!(quarter, 1 | 2) { far_y } else { ry });
            points.push((Decimal::from_f64(before.0 + rx * cos), Decimal::from_f64(before.1 + ry * sin)));
        }
        points.push((Decimal::from_f64(x + rx * cos), Decimal::from_f64(y + ry * sin)));
    }
    points.push((Decimal::from_f64(far_x + rx), Decimal::from_f64(ry)));
    points.dedup_by_key(|(x, y)| (x.raw(), y.raw()));
    if points.first().map(|(x, y)| (x.raw(), y.raw())) == points.last().map(|(x, y)| (x.raw(), y.raw())) {
        points.pop();
    }
    (points, true, (off(corners) * 1000.0).ceil() as u32)
}

/// Rotates around the object's own point. Exact for right angles.
fn turned((x, y): Spot, degrees: Decimal) -> Spot {
    let right_angles = [
        (0, (x, y)),
        (90, (-y, x)),
        (180, (-x, -y)),
        (270, (y, -x)),
        (-90, (y, -x)),
        (-180, (-x, -y)),
        (-270, (-y, x)),
        (360, (x, y)),
    ];
    if let Some((_, exact)) = right_angles.iter().find(|(angle, _)| Decimal::whole(*angle) == degrees) {
        return *exact;
    }
    let (sin, cos) = degrees.to_f64().to_radians().sin_cos();
    let (x, y) = (x.to_f64(), y.to_f64());
    (Decimal::from_f64(x * cos - y * sin), Decimal::from_f64(x * sin + y * cos))
}
