//! Oriented boxes and other polygons among moving solids, by the exact sum of two convex shapes.

use super::judge::{Block, Judged};
use super::ticks::{CELL, coordinate};
use super::{P, raw, vec2};
use crate::Random;
use crate::convex::shape::{MOST, hull};
use crate::oracle::measure::Measure;
use crate::oracle::sum::Sum;
use tilesat::{Aabb, ConvexPolygon, Fx, OrientedBox};

type Polygon = ConvexPolygon<MOST>;

fn corners(body: &Polygon) -> Vec<P> {
    body.vertices().iter().map(|p| raw(*p)).collect()
}

fn radius(body: &Polygon) -> i64 {
    body.radius().to_bits().into()
}

/// Whether what is around points by a radius overlaps a block.
fn meets(points: &[P], radius: i64, block: Block) -> bool {
    let at = [block.lo, (block.hi.0, block.lo.1), block.hi, (block.lo.0, block.hi.1)];
    let all: Vec<P> = points.iter().flat_map(|p| at.map(|q| (p.0 - q.0, p.1 - q.1))).collect();
    Measure::of(&Sum::of_hull(&hull(&all), radius)).overlaps()
}

impl Judged for Polygon {
    const IS_BOX: bool = false;

    fn block(&self) -> Block {
        let bounds: Aabb = self.aabb();
        Block::of(&bounds)
    }

    fn in_block(&self, block: Block) -> bool {
        meets(&corners(self), radius(self), block)
    }

    fn at(&self, d: P) -> Self {
        self.translated(vec2(d)).unwrap()
    }

    fn mirrored(&self) -> Self {
        let points: Vec<_> = corners(self).iter().map(|p| vec2((-p.0, p.1))).collect();
        Self::new(&points).unwrap().with_radius(self.radius()).unwrap()
    }

    fn goes_through(&self, d: P, block: Block) -> bool {
        let here = corners(self);
        let swept: Vec<P> = here.iter().flat_map(|&p| [p, (p.0 + d.0, p.1 + d.1)]).collect();
        meets(&swept, (radius(self) - 1).max(0), block)
    }
}

/// Oriented boxes as polygons, triangles and others, sharp or round.
pub fn polygons(random: &mut Random) -> Polygon {
    loop {
        let c = (coordinate(random), coordinate(random));
        let size = [CELL / 2, CELL / 3, 2, random.within(2, CELL)][random.below(4) as usize];
        let points: Vec<_> = if random.one_in(2) {
            let half = vec2((random.within(1, size), random.within(1, size)));
            let direction = tilesat::Axis::new(random.around(9) as i32 | 1, random.around(9) as i32);
            OrientedBox::new(vec2(c), half, direction).unwrap().corners().to_vec()
        } else {
            (0..random.within(3, 6)).map(|_| vec2((c.0 + random.around(size), c.1 + random.around(size)))).collect()
        };
        let radius = if random.one_in(2) { 0 } else { random.within(1, size) };
        if let Ok(polygon) = Polygon::hull(&points) {
            return polygon.with_radius(Fx::from_bits(radius as i32)).unwrap();
        }
    }
}
