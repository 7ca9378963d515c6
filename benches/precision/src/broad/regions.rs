//! The workload of static boxes: which of them are in a region. Nothing moves but the regions.

use super::phases::{Phase, add};
use super::scenes::{Bounds, Class, Frame, Kind};
use super::trees::{Leaf, Square, boxed, px_box, touch};
use super::truth::{Answer, Truth, judge};
use crate::callgrind;
use crate::job::{Format, Job, List};
use crate::peers::ours;
use crate::record::Row;
use crate::run::{Sizes, time};
use parry2d::partitioning::{Bvh, BvhBuildStrategy};
use quadtree_rs::Quadtree;
use rstar::RTree;
use tilesat::broad::{BruteForce, LooseGrid, SortSweep, SpatialHash};
use tilesat::prelude::*;
use tilesat::{Aabb, Fx};

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

/// Added to the number of a box, to tell it from that of a region.
const HELD: u32 = 1 << 20;

/// The regions of a frame are its boxes; those of the first frame stay.
fn frames(class: Class, n: usize) -> Vec<Frame> {
    class.frames(n.max(2))
}

struct Own<B>(B);

impl<B: BroadPhase<Tag = ()> + 'static> Own<B> {
    fn of(mut near: B, boxes: &[Aabb]) -> Self {
        for bounds in boxes {
            near.insert(bounds, ()).expect("there is room for all of them");
        }
        Self(near)
    }
}

impl<B: BroadPhase<Tag = ()> + 'static> Phase for Own<B> {
    type Box = Aabb;

    fn boxed(bounds: &Bounds) -> Aabb {
        Aabb::new(ours::vec2(bounds.lo), ours::vec2(bounds.hi)).expect("scenes stay inside the domain")
    }

    fn frame(&mut self, regions: &[Aabb], found: &mut Answer) {
        for (region, k) in regions.iter().zip(0..) {
            self.0.in_region(region, |handle| found.push((k, handle.slot() as u32 + HELD)));
        }
    }
}

struct Parry(Bvh);

impl Phase for Parry {
    type Box = parry2d::bounding_volume::Aabb;

    fn boxed(bounds: &Bounds) -> Self::Box {
        let place = crate::peers::parry::single::vector;
        Self::Box::new(place(bounds.lo), place(bounds.hi))
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

fn sized<const N: usize, const BLOCKS: usize, const LARGE: bool>(list: &mut List<Frame, Answer>, class: Class) {
    let (cell, named) = (Fx::from_num(class.cell()), |asked| (ours::NAME, asked, Format::RAW));
    add(list, named("sweep"), |boxes| Own::of(SortSweep::<N>::new(), boxes));
    add(list, named("grid"), move |boxes| {
        let near = LooseGrid::<BLOCKS, N, (), LARGE>::new(ours::vec2((0, 0)), cell, class.grid_columns());
        Own::of(near.expect("a legal grid"), boxes)
    });
    add(list, named("hash"), move |boxes| {
        Own::of(SpatialHash::<N, N, (), LARGE>::new(cell).expect("a legal cell"), boxes)
    });
    add(list, named("brute"), |boxes| Own::of(BruteForce::<N>::new(), boxes));
}

fn backends(class: Class) -> List<Frame, Answer> {
    let mut list = List(Vec::new());
    match (class.bodies, class.has_large()) {
        (256, false) => sized::<256, 32, false>(&mut list, class),
        (256, true) => sized::<256, 32, true>(&mut list, class),
        (_, false) => sized::<1024, 128, false>(&mut list, class),
        (_, true) => sized::<1024, 128, true>(&mut list, class),
    }
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

/// What is missing, and how long the regions of a frame take.
pub fn measure(sizes: &Sizes, rows: &mut Vec<Row>) {
    for class in CLASSES {
        let frames = frames(class, (sizes.boxes / class.bodies).clamp(8, 256));
        eprintln!("{NAME}, {}: {} frames", class.name(), frames.len());
        let truths: Vec<Truth> = frames.iter().map(|regions| Truth::of(regions, &frames[0], HELD)).collect();
        let from = rows.len();
        let mut jobs: Vec<Box<dyn Job<Answer>>> = Vec::new();
        for backend in &backends(class).0 {
            let mut row = Row::new(NAME, &class.name(), backend.name, backend.asked);
            let job = (backend.make)(&frames);
            judge(&mut row, &truths, &job.answers());
            jobs.push(job);
            rows.push(row);
        }
        time(&mut rows[from..], &mut jobs, 1, sizes);
    }
}

/// How many instructions the regions of a frame take; under callgrind.
pub fn count(sizes: &Sizes) {
    for class in CLASSES {
        let frames = frames(class, (8 * sizes.counted / class.bodies).clamp(3, 16));
        for backend in &backends(class).0 {
            let mut job = (backend.make)(&frames);
            let label = [NAME, &class.name(), backend.name, backend.asked, &job.len().to_string()].join("|");
            callgrind::instrumented(|| callgrind::count(&label, || job.pass()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ours and the trees find all, and nothing twice.
    #[test]
    fn all_find_each_box_once() {
        for class in CLASSES.into_iter().filter(|c| c.bodies <= 256) {
            let frames = frames(class, 16);
            let truths: Vec<Truth> = frames.iter().map(|regions| Truth::of(regions, &frames[0], HELD)).collect();
            for backend in &backends(class).0 {
                let mut row = Row::new(NAME, &class.name(), backend.name, backend.asked);
                judge(&mut row, &truths, &(backend.make)(&frames).answers());
                assert!(row.get("queries") > Some(1000.0));
                assert_eq!((row.get("wrong"), row.get("extra")), (Some(0.0), Some(0.0)), "{row:?}");
            }
        }
    }
}
