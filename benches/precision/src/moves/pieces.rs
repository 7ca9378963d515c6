//! The tiles of a level as convex polygons, for engines without arcs. None covers less of the plane
//! than its tile.

use tilesat_judge::shapes::level::{Level, shape};
use tilesat_judge::shapes::region::Region;

pub type Corner = (f64, f64);

/// Pieces per arc. A polygon of Box2D has at most 8 corners.
const CUTS: u32 = 5;

/// The polygons of a shape, in a cell of side 1.
fn polygons(id: u8) -> Vec<Vec<Corner>> {
    let half = |p: (i128, i128)| (p.0 as f64 / 2.0, p.1 as f64 / 2.0);
    match shape(id).0 {
        None => Vec::new(),
        Some(Region::Polygon(points)) => vec![points.into_iter().map(half).collect()],
        Some(Region::Arc { centre, far, outside }) => {
            let (c, f) = (half(centre), half(far));
            let at = |step: f64, reach: f64| {
                let (sin, cos) = (step * std::f64::consts::FRAC_PI_2).sin_cos();
                (c.0 + (f.0 - c.0) * cos * reach, c.1 + (f.1 - c.1) * sin * reach)
            };
            let part = |k: u32| f64::from(k) / f64::from(CUTS);
            if outside {
                // Between the corner and chords of the arc.
                return (0..CUTS).map(|k| vec![f, at(part(k), 1.0), at(part(k + 1), 1.0)]).collect();
            }
            // Around the arc: the points where its tangents meet.
            let beyond = 1.0 / (part(1) * std::f64::consts::FRAC_PI_4).cos();
            let meet = (0..CUTS).map(|k| at(part(k) + part(1) / 2.0, beyond));
            vec![[c, at(0.0, 1.0)].into_iter().chain(meet).chain([at(1.0, 1.0)]).collect()]
        }
    }
}

/// All of a level, in pixels.
pub fn all(level: &Level) -> Vec<Vec<Corner>> {
    let px = |raw: i64| raw as f64 / 65536.0;
    let mut out = Vec::new();
    for (i, &id) in level.tiles.iter().enumerate() {
        let (column, row) = (i as i64 % level.width, i as i64 / level.width);
        let place = |(x, y): Corner| {
            (
                px(level.x + column * level.cell) + x * px(level.cell),
                px(level.y + row * level.cell) + y * px(level.cell),
            )
        };
        out.extend(polygons(id).into_iter().map(|polygon| polygon.into_iter().map(place).collect::<Vec<_>>()));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area.
    fn area(polygon: &[Corner]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        polygon.iter().zip(next).map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum::<f64>().abs()
    }

    #[test]
    fn pieces_hold_the_tiles_and_little_more() {
        let quarter = std::f64::consts::FRAC_PI_4;
        let areas = [1.0, 0.5, 0.5, quarter, 1.0 - quarter, 0.25, 0.75, 0.25, 0.75];
        for id in 1..34u8 {
            let exact = areas[(usize::from(id) + 2) / 4];
            let made = polygons(id).iter().map(|p| area(p)).sum::<f64>() / 2.0;
            assert!(made >= exact - 1e-12 && made < exact + 0.02, "{id}: {made} for {exact}");
            assert!(polygons(id).iter().all(|p| p.len() <= 8));
        }
        assert!(polygons(0).is_empty());
    }
}
