//! Levels, and cursors over what they hold.

use super::Decimal;
use crate::world::{
    ConvexFeatures, ConvexSolids, Features, Grid, Joined, JoinedFeatures, JoinedRayHits, Placed, PlacedFeatures,
    PlacedRayHits, RayWorld, Room, Rooms, SegmentFeatures, SegmentMap, SegmentRayHits, ShapeSet, Size, SolidFeatures,
    SolidRayHits, SolidShape, Solids, Store, TileKinds, TileMap, TileShape, Tiles, World,
};
use defmt::{Format, Formatter, write};

impl Format for Grid {
    fn format(&self, f: Formatter<'_>) {
        let (width, height, cell) = (self.width(), self.height(), Decimal(self.cell()));
        write!(f, "{=u16} x {=u16} cells of {} from {}", width, height, cell, self.origin());
    }
}

impl Format for TileKinds {
    fn format(&self, f: Formatter<'_>) {
        let named = (0..=u8::MAX).filter(|&id| self.get(id).shape != TileShape::Empty || self.get(id).flags != 0);
        write!(f, "TileKinds {=usize} named", named.count());
    }
}

impl<S: ShapeSet, T: Store> Format for TileMap<'_, S, T> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "TileMap {} outside {}", self.grid(), self.outside());
    }
}

impl<S: ShapeSet> Format for Room<'_, S> {
    fn format(&self, f: Formatter<'_>) {
        let (x, y) = self.first();
        write!(
            f,
            "Room {=u16} x {=u16} cells from cell ({=i32}, {=i32}) of {}",
            self.width(),
            self.height(),
            x,
            y,
            self.map()
        );
    }
}

impl<S: ShapeSet> Format for Rooms<'_, S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Rooms {=u16} x {=u16}", self.columns(), self.rows());
    }
}

impl Format for SegmentMap<'_> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "SegmentMap {} segments {=u16}", self.grid(), self.count());
    }
}

impl Format for Size {
    fn format(&self, f: Formatter<'_>) {
        let (segments, refs, bytes) = (self.segments(), self.refs(), self.bytes());
        write!(f, "Size {} segments {=u16} refs {=u16} bytes {=usize}", self.grid(), segments, refs, bytes);
    }
}

impl<A: World + Format, B: World + Format> Format for Joined<'_, A, B> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Joined {} and {}", self.first(), self.second());
    }
}

impl<W: World + Format> Format for Placed<'_, W> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Placed {} by {}", self.world(), self.offset());
    }
}

impl Format for Solids<'_> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Solids {}", self.list());
    }
}

impl<S: SolidShape + Format> Format for ConvexSolids<'_, S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "ConvexSolids {}", self.list());
    }
}

impl<S: SolidShape + Format> Format for ConvexFeatures<'_, S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "ConvexFeatures of {}", ConvexSolids::new(self.list));
    }
}

impl<S: ShapeSet, T: Store> Format for Features<'_, S, T> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Features of {}", self.map);
    }
}

impl<S: ShapeSet, T: Store> Format for Tiles<'_, S, T> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Tiles of {}", self.map);
    }
}

impl Format for SegmentFeatures<'_> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "SegmentFeatures of {}", self.map);
    }
}

impl Format for SolidFeatures<'_> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "SolidFeatures of {}", Solids::new(self.all));
    }
}

impl<A: World + Format, B: World + Format> Format for JoinedFeatures<'_, A, B> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "JoinedFeatures of {}", self.pair);
    }
}

impl<'w, W: World<Features<'w>: Format> + 'w> Format for PlacedFeatures<'w, W> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "PlacedFeatures {} by {}", self.features, self.offset.vec2());
    }
}

impl Format for SegmentRayHits<'_, '_> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "SegmentRayHits of {}", self.map);
    }
}

impl Format for SolidRayHits<'_> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "SolidRayHits of {}", self.all);
    }
}

impl<A: RayWorld + Format, B: RayWorld + Format> Format for JoinedRayHits<'_, A, B> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "JoinedRayHits of {}", self.pair);
    }
}

impl<'w, W: RayWorld<Scan<'w>: Format> + 'w> Format for PlacedRayHits<'w, W> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "PlacedRayHits {} by {}", self.scan, self.offset.vec2());
    }
}
