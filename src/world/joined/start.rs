//! The start of a ray where it touches two levels.
//!
//! There a level alone cannot tell what the ray meets. A face of one level may be hidden by the
//! other one, while the other one's face at the same point is in plain view. And a ray along the
//! seam of two flush solids is in neither of them, but inside both together.

use super::hidden::{FaceSegment, PartPath, front_of_end, point};
use crate::num::{Axis, Raw, usqr};
use crate::world::level::{Feature, Geometry, normal};
use crate::world::ray::world::RayWorld;
use crate::world::ray::{Met, RayPieces, meet};

/// The surface at the start of a ray.
#[derive(Default)]
pub(super) struct StartSurface {
    /// Whether the start is on the surface of all levels together; otherwise it is inside.
    pub(super) bare: bool,
    /// Whether the ray continues along a seam.
    pub(super) on_seam: bool,
    /// A face at the start: its feature names the solid there.
    pub(super) face: Option<Feature>,
    /// What the ray meets at once: the best solid face, and the best one-way face.
    pub(super) best: [Option<Met>; 2],
}

impl StartSurface {
    /// Looks at the start of a ray from `o` by `d` through all parts of a level.
    pub(super) fn of<J: RayWorld + RayPieces>(level: &J, o: Raw, d: Raw) -> Self {
        let mut start = Self::default();
        level.parts(PartPath::default(), &mut |path, own| {
            own.each(&point(o), &mut |found| {
                let feature = Feature { source: path.source(found.source), ..*found };
                match feature.geometry {
                    Geometry::Face { a, dir, len, .. } => {
                        let face = FaceSegment::new(Raw::of(a), dir, len);
                        if face.holds(o) {
                            start.add_face((level, path), (o, d), &face, &feature);
                        }
                    }
                    // Arcs stay, covered or not.
                    Geometry::Arc { centre, radius, quadrant, .. } if J::ARCS => {
                        let m = o.sub(Raw::of(centre));
                        let in_quadrant = m.x.signum() != -quadrant.x && m.y.signum() != -quadrant.y;
                        if in_quadrant && m.len2() == usqr(radius as u32) {
                            start.bare = true;
                            start.meet::<J>((o, d), &feature);
                        }
                    }
                    _ => {}
                }
                true
            });
        });
        start
    }

    /// The better one of the solid face and the one-way face, of those that count.
    pub(super) fn first_met(&mut self, solid_counts: bool, one_way_counts: bool, d: Raw) -> Option<&mut Met> {
        let [solid, one_way] = &mut self.best;
        let solid = solid.as_mut().filter(|_| solid_counts);
        let one_way = one_way.as_mut().filter(|_| one_way_counts);
        match (solid, one_way) {
            (Some(solid), Some(one_way)) => {
                Some(if one_way.touch.ranks_above(&one_way.feature, solid, d) { one_way } else { solid })
            }
            (solid, one_way) => solid.or(one_way),
        }
    }

    fn add_face<J: RayWorld + RayPieces>(
        &mut self,
        (level, path): (&J, PartPath),
        (o, d): (Raw, Raw),
        face: &FaceSegment,
        feature: &Feature,
    ) {
        let n = normal(face.dir);
        let mut bare = false;
        for (along, end) in [(face.dir, face.b), (face.dir.reversed(), face.a)] {
            if o == end {
                continue;
            }
            let covered = is_covered(level, Some(path), (o, along), n);
            let way = Axis::new(d.x, d.y);
            bare |= !covered;
            self.on_seam |= covered && !feature.one_way && along.perp_dot(way) == 0 && along.dot(way) > 0;
        }
        if !feature.one_way {
            self.bare |= bare;
            self.face = self.face.or(Some(*feature));
        }
        if bare {
            self.meet::<J>((o, d), feature);
        }
    }

    fn meet<J: RayPieces>(&mut self, (o, d): (Raw, Raw), feature: &Feature) {
        let Some(touch) = meet::<J>(o, d, feature) else { return };
        let [solid, one_way] = &mut self.best;
        let best = if feature.one_way { one_way } else { solid };
        let first = best.as_ref().is_none_or(|best| touch.ranks_above(feature, best, d));
        if first && touch.is_at_start() {
            *best = Some(Met { feature: *feature, touch });
        }
    }
}

/// Whether the points just in front of a face with the normal `n` are in the solid, from `p` on in
/// the direction `along`. They are in the solid of one part, or of none. The part at `own` has the
/// face.
pub(super) fn is_covered<J: RayWorld>(level: &J, own: Option<PartPath>, (p, along): (Raw, Axis), n: Axis) -> bool {
    let mut covered = false;
    level.parts(PartPath::default(), &mut |path, part| {
        covered |= own != Some(path) && front_of_end::<J>(p, along, n, part) == Some(true);
    });
    covered
}
