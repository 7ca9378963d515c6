//! A segment map as a level.

use super::{SegmentFeatures, SegmentMap};
use crate::shape::{Aabb, Circle};
use crate::world::{World, sealed};

impl sealed::Sealed for SegmentMap<'_> {}

impl World for SegmentMap<'_> {
    const BLOCKS: bool = false;
    const ROUND: bool = false;
    const WIDE: bool = true;

    type Features<'w>
        = SegmentFeatures<'w>
    where
        Self: 'w;

    fn features(&self, region: &Aabb) -> SegmentFeatures<'_> {
        SegmentMap::features(self, region)
    }

    fn cell_size(&self) -> u32 {
        self.grid.cell as u32
    }

    fn overlaps_aabb(&self, b: &Aabb) -> bool {
        SegmentMap::overlaps(self, b)
    }

    fn overlaps_circle(&self, c: &Circle) -> bool {
        SegmentMap::overlaps(self, c)
    }

    fn touches_aabb(&self, b: &Aabb) -> bool {
        SegmentMap::touches(self, b)
    }

    fn touches_circle(&self, c: &Circle) -> bool {
        SegmentMap::touches(self, c)
    }
}
