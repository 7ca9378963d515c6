//! The workload of static boxes: which of them are in a region? Only the regions move.

use super::engines::parry_box;
use super::phases::{self, Ask, Phase, add};
use super::scenes::{Bounds, Class, Frame, Kind};
use super::trees::{Leaf, Square, boxed, px_box};
use super::truth::{Answer, Truth, touch};
use super::workload::Workload;
use crate::job::{Format, List};
use crate::record::Row;
use crate::run::Sizes;
use parry2d::partitioning::{Bvh, BvhBuildStrategy};
use quadtree_rs::Quadtree;
use rstar::RTree;
use tilesat::Aabb;
use tilesat::prelude::*;

pub const NAME: &str = "boxes in regions";

const fn class(kind: Kind, bodies: usize) -> Class {
    Class { kind, bodies, origin: 0 }
}

const CLASSES: [Class; 8] = [
    class(Kind::Scattered, 256),
    class(Kind::Scattered, 1024),
    class(Kind::Clumps, 256),
    class(Kind::Clumps, 1024),
    class(Kind::Huge, 256),
    class(Kind::Huge, 1024),
    class(Kind::Uneven, 256),
    class(Kind::Uneven, 1024),
];

/// Added to the number of a box, to distinguish it from a region's.
const HELD: u32 = 1 << 20;

/// The regions of a frame are its boxes. The boxes of the first frame stay.
const REGIONS: Workload = Workload {
    name: NAME,
    classes: &CLASSES,
    most: (256, 16),
    truths: |frames| frames.iter().map(|regions| Truth::regions(regions, &frames[0], HELD)).collect(),
    backends,
};

struct Regions;

impl Ask for Regions {
    fn ask<B: BroadPhase<Tag = ()>>(near: &mut B, regions: &[Aabb], found: &mut Answer) {
        for (region, k) in regions.iter().zip(0..) {
            near.in_region(region, |handle| found.push((k, handle.slot() as u32 + HELD)));
        }
    }
}

struct Parry(Bvh);

impl Phase for Parry {
    type Box = parry2d::bounding_volume::Aabb;

    fn boxed(bounds: &Bounds) -> Self::Box {
        parry_box(bounds)
    }

    fn frame(&mut self, regions: &[Self::Box], found: &mut Answer) {
        for (region, k) in regions.iter().zip(0..) {
            found.extend(self.0.intersect_aabb(region).map(|body| (k, body + HELD)));
        }
    }
}

struct Packed(RTree<Leaf>);

impl Phase for Packed {
    type Box = rstar::AABB<[f32; 2]>;

    fn boxed(bounds: &Bounds) -> Self::Box {
        px_box(bounds)
    }

    fn frame(&mut self, regions: &[Self::Box], found: &mut Answer) {
        for (region, k) in regions.iter().zip(0..) {
            found.extend(self.0.locate_in_envelope_intersecting(*region).map(|leaf| (k, leaf.data + HELD)));
        }
    }
}

struct Quad {
    tree: Quadtree<i64, u32>,
    held: Vec<Bounds>,
}

impl Phase for Quad {
    type Box = Square;

    fn boxed(bounds: &Bounds) -> Square {
        boxed(bounds)
    }

    fn frame(&mut self, regions: &[Square], found: &mut Answer) {
        for (region, k) in regions.iter().zip(0..) {
            let near = self.tree.query(region.area).map(|entry| *entry.value_ref());
            let exact = near.filter(|&body| touch(&region.exact, &self.held[body as usize]));
            found.extend(exact.map(|body| (k, body + HELD)));
        }
    }
}

fn backends(class: Class) -> List<Frame, Answer> {
    let mut list = List(Vec::new());
    phases::library::<Regions>(&mut list, class);
    add(&mut list, ("parry2d", "tree", Format::F32), |boxes: &[parry2d::bounding_volume::Aabb]| {
        Parry(Bvh::from_leaves(BvhBuildStrategy::Binned, boxes))
    });
    add(&mut list, ("rstar", "tree", Format::F32), |boxes: &[rstar::AABB<[f32; 2]>]| {
        Packed(RTree::bulk_load(super::trees::leaves(boxes)))
    });
    add(&mut list, ("quadtree_rs", "tree", Format::RAW), move |boxes: &[Square]| Quad {
        tree: super::trees::quadtree(boxes, class),
        held: boxes.iter().map(|b| b.exact).collect(),
    });
    list
}

pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    REGIONS.measure(sizes, rows);
}

pub fn count(sizes: &Sizes) {
    REGIONS.count(sizes);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ours and the trees find everything, and nothing twice.
    #[test]
    fn all_find_each_box_once() {
        for row in REGIONS.small(|_| true) {
            assert!(row.get("queries") > Some(1000.0));
            assert_eq!((row.get("wrong"), row.get("extra")), (Some(0.0), Some(0.0)), "{row:?}");
        }
    }
}
