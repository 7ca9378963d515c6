//! Trees of libraries that hold only boxes.

use super::phases::{Phase, add};
use super::scenes::{Bounds, Class, Frame, px};
use super::truth::{Answer, touch};
use crate::job::{Format, List};
use quadtree_rs::Quadtree;
use quadtree_rs::area::{Area, AreaBuilder};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// An R*-tree, packed in each frame. That is faster than moving its boxes one by one.
struct Packed;

pub type Leaf = GeomWithData<Rectangle<[f32; 2]>, u32>;

pub fn px_box(bounds: &Bounds) -> AABB<[f32; 2]> {
    AABB::from_corners([px(bounds.lo.0), px(bounds.lo.1)], [px(bounds.hi.0), px(bounds.hi.1)])
}

pub fn leaves(boxes: &[AABB<[f32; 2]>]) -> Vec<Leaf> {
    let leaf = |(b, body): (&AABB<[f32; 2]>, u32)| Leaf::new(Rectangle::from_corners(b.lower(), b.upper()), body);
    boxes.iter().zip(0..).map(leaf).collect()
}

impl Phase for Packed {
    type Box = AABB<[f32; 2]>;

    fn boxed(bounds: &Bounds) -> Self::Box {
        px_box(bounds)
    }

    fn frame(&mut self, boxes: &[Self::Box], pairs: &mut Answer) {
        let tree = RTree::bulk_load(leaves(boxes));
        for (b, body) in boxes.iter().zip(0..) {
            let near = tree.locate_in_envelope_intersecting(*b);
            pairs.extend(near.filter(|leaf| leaf.data > body).map(|leaf| (body, leaf.data)));
        }
    }
}

/// A quadtree, filled in each frame. The exact boxes decide in the end.
struct Quad(Class);

/// The side of a smallest square is this power of two, in pixels. Of 4, 5 and 6, 5 is best for most
/// regions and for pairs in clumps. 6 takes 0.8 times as long for scattered pairs, and 1.3 times
/// for clumps.
const SQUARE: u32 = 5;

/// The exact box, and the range of smallest squares that it reaches.
pub struct Square {
    pub exact: Bounds,
    pub area: Area<i64>,
}

pub fn boxed(bounds: &Bounds) -> Square {
    let square = |raw: i64| raw >> 16 >> SQUARE;
    let (x, y) = (square(bounds.lo.0), square(bounds.lo.1));
    let size = (square(bounds.hi.0) - x + 1, square(bounds.hi.1) - y + 1);
    let area = AreaBuilder::default().anchor((x, y).into()).dimensions(size).build();
    Square { exact: *bounds, area: area.expect("an area with squares") }
}

pub fn quadtree(boxes: &[Square], class: Class) -> Quadtree<i64, u32> {
    let mut tree = Quadtree::new((class.side() >> SQUARE).ilog2() as usize + 2);
    for (b, body) in boxes.iter().zip(0..) {
        tree.insert(b.area, body);
    }
    tree
}

impl Phase for Quad {
    type Box = Square;

    fn boxed(bounds: &Bounds) -> Square {
        boxed(bounds)
    }

    fn frame(&mut self, boxes: &[Square], pairs: &mut Answer) {
        let tree = quadtree(boxes, self.0);
        for (b, body) in boxes.iter().zip(0_u32..) {
            let near = tree.query(b.area).map(|entry| *entry.value_ref()).filter(|&other| other > body);
            pairs
                .extend(near.filter(|&other| touch(&b.exact, &boxes[other as usize].exact)).map(|other| (body, other)));
        }
    }
}

pub fn all(list: &mut List<Frame, Answer>, class: Class) {
    add(list, ("rstar", "tree", Format::F32), |_: &[AABB<[f32; 2]>]| Packed);
    // It covers nothing beyond its square, and takes minutes for thousands of boxes.
    if class.origin == 0 && class.bodies <= 1024 {
        add(list, ("quadtree_rs", "tree", Format::RAW), move |_: &[Square]| Quad(class));
    }
}
