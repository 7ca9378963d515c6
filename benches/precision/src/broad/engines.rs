//! Broad phases of libraries.

use super::phases::{Phase, add};
use super::scenes::{Bounds, Frame, px};
use super::truth::Answer;
use crate::job::{Format, List};
use crate::peers::{BROCCOLI, box2d};
use boxdd_sys::ffi::{
    b2AABB, b2DynamicTree, b2DynamicTree_Create, b2DynamicTree_CreateProxy, b2DynamicTree_EnlargeProxy,
    b2DynamicTree_Query, b2DynamicTree_Rebuild, b2Vec2,
};
use broccoli::{Tree, rect};
use parry2d::bounding_volume::Aabb;
use parry2d::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use std::os::raw::c_void;
use tilesat_judge::oracle::figure::Point;

/// The tree of parry2d, used as rapier2d does, without margins.
struct ParryTree {
    tree: Bvh,
    work: BvhWorkspace,
}

pub fn parry_box(bounds: &Bounds) -> Aabb {
    let place = crate::peers::parry::single::vector;
    Aabb::new(place(bounds.lo), place(bounds.hi))
}

impl Phase for ParryTree {
    type Box = Aabb;

    fn boxed(bounds: &Bounds) -> Aabb {
        parry_box(bounds)
    }

    fn frame(&mut self, boxes: &[Aabb], pairs: &mut Answer) {
        for (bounds, body) in boxes.iter().zip(0..) {
            self.tree.insert_or_update_partially(*bounds, body, 0.0);
        }
        self.tree.optimize_incremental(&mut self.work);
        self.tree.refit(&mut self.work);
        self.tree.traverse_bvtt_single_tree::<false>(&mut self.work, &mut |a, b| pairs.push((a, b)));
    }
}

/// A tree that is rebuilt in every frame, as its manual advises.
struct Broccoli(Vec<(broccoli::axgeom::Rect<f32>, u32)>);

impl Phase for Broccoli {
    type Box = broccoli::axgeom::Rect<f32>;

    fn boxed(bounds: &Bounds) -> Self::Box {
        rect(px(bounds.lo.0), px(bounds.hi.0), px(bounds.lo.1), px(bounds.hi.1))
    }

    fn frame(&mut self, boxes: &[Self::Box], pairs: &mut Answer) {
        self.0.clear();
        self.0.extend(boxes.iter().copied().zip(0..));
        Tree::new(&mut self.0).find_colliding_pairs(|a, b| pairs.push((*a.unpack_inner(), *b.unpack_inner())));
    }
}

/// Its dynamic tree alone. Boxes in it are enlarged by a body's motion in a frame, and the exact
/// boxes decide in the end.
struct Box2dTree {
    tree: b2DynamicTree,
    /// Members of the tree: numbers and boxes.
    proxies: Vec<(i32, b2AABB)>,
}

/// In pixels.
const MARGIN: f32 = 2.0;

fn fattened(b: &b2AABB) -> b2AABB {
    let (lo, hi) = (b.lowerBound, b.upperBound);
    b2AABB {
        lowerBound: b2Vec2 { x: lo.x - MARGIN, y: lo.y - MARGIN },
        upperBound: b2Vec2 { x: hi.x + MARGIN, y: hi.y + MARGIN },
    }
}

fn holds(a: &b2AABB, b: &b2AABB) -> bool {
    a.lowerBound.x <= b.lowerBound.x
        && a.lowerBound.y <= b.lowerBound.y
        && b.upperBound.x <= a.upperBound.x
        && b.upperBound.y <= a.upperBound.y
}

/// As in the library's own inline function.
fn touch(a: &b2AABB, b: &b2AABB) -> bool {
    !(b.lowerBound.x > a.upperBound.x
        || b.lowerBound.y > a.upperBound.y
        || a.lowerBound.x > b.upperBound.x
        || a.lowerBound.y > b.upperBound.y)
}

/// The box whose pairs it looks for.
struct Asking<'a> {
    body: u32,
    boxes: &'a [b2AABB],
    pairs: &'a mut Answer,
}

/// # Safety
/// `context` is an [`Asking`] that nobody else uses.
unsafe extern "C" fn near(_: i32, other: u64, context: *mut c_void) -> bool {
    // SAFETY: as above.
    let asking = unsafe { &mut *context.cast::<Asking<'_>>() };
    let other = other as u32;
    if other > asking.body && touch(&asking.boxes[other as usize], &asking.boxes[asking.body as usize]) {
        asking.pairs.push((asking.body, other));
    }
    true
}

impl Box2dTree {
    fn new(boxes: &[b2AABB]) -> Self {
        // SAFETY: makes a new tree.
        let mut tree = unsafe { b2DynamicTree_Create(boxes.len() as i32) };
        let fat = boxes.iter().map(fattened).zip(0..);
        // SAFETY: the tree exists.
        let add = |(fat, body)| (unsafe { b2DynamicTree_CreateProxy(&mut tree, fat, 1, body) }, fat);
        let proxies = fat.map(add).collect();
        Self { tree, proxies }
    }
}

impl Phase for Box2dTree {
    type Box = b2AABB;

    fn boxed(bounds: &Bounds) -> b2AABB {
        let place = |p: Point| box2d::vector(p);
        b2AABB { lowerBound: place(bounds.lo), upperBound: place(bounds.hi) }
    }

    fn frame(&mut self, boxes: &[b2AABB], pairs: &mut Answer) {
        // SAFETY: the tree exists, its proxies are those of the boxes, and the callback gets its
        // own context.
        unsafe {
            for (bounds, (id, fat)) in boxes.iter().zip(&mut self.proxies) {
                if !holds(fat, bounds) {
                    *fat = fattened(bounds);
                    b2DynamicTree_EnlargeProxy(&mut self.tree, *id, *fat);
                }
            }
            b2DynamicTree_Rebuild(&mut self.tree, false);
            for (bounds, body) in boxes.iter().zip(0..) {
                let mut asking = Asking { body, boxes, pairs };
                b2DynamicTree_Query(&self.tree, *bounds, u64::MAX, Some(near), (&raw mut asking).cast());
            }
        }
    }
}

pub fn all(list: &mut List<Frame, Answer>) {
    add(list, ("parry2d", "tree", Format::F32), |boxes: &[Aabb]| ParryTree {
        tree: Bvh::from_leaves(BvhBuildStrategy::Binned, boxes),
        work: BvhWorkspace::default(),
    });
    add(list, (BROCCOLI, "tree", Format::F32), |boxes| Broccoli(Vec::with_capacity(boxes.len())));
    add(list, (box2d::NAME, "tree", Format::F32), Box2dTree::new);
}
