//! The verbs of compounds: their bounding boxes first, then their parts.

use super::cast::kernel::{CastHit, Course, Enter, InDomain, Inside, Moment};
use super::cast::{CastShape, share};
use super::closest::{ClosestPoint, Distance};
use super::contact::{Contact, Contacts};
use super::convex::{Manifold, ManifoldPoint, Manifolds};
use super::meet::aabb_aabb;
use super::overlap::{Contains, Overlaps, Touches};
use crate::error::RangeError;
use crate::num::{Axis, Fx, Raw, Vec2};
use crate::shape::kernel::Extent;
use crate::shape::{Aabb, AnyShape, Capsule, Circle, Compound, ConvexPolygon, OrientedBox, Segment, Single};

/// The answer with the least key; on a tie the first by geometry, so the order of parts does not
/// matter.
fn least<T, K: Ord>(answers: impl Iterator<Item = T>, key: impl Fn(&T) -> K) -> Option<T> {
    answers.min_by_key(key)
}

fn order(axis: Axis) -> (u32, u32, i32, i32) {
    (axis.x.unsigned_abs(), axis.y.unsigned_abs(), axis.x, axis.y)
}

/// On a tie of the depth, the one that is farther along x, then along y. The rest of the key
/// distinguishes all other contacts.
fn rank(c: &Contact) -> impl Ord + use<> {
    let points = (c.point_on_a().raw(), c.point_on_b().raw());
    let of_what = (c.overlap, c.core.x, c.core.y, c.core_on_b, c.radius_a, c.radius_b, c.is_degenerate());
    (core::cmp::Reverse(c.depth()), order(c.axis()), points, of_what)
}

fn deepest(contacts: impl Iterator<Item = Contact>) -> Option<Contact> {
    least(contacts, rank)
}

fn deepest_manifold(all: impl Iterator<Item = Manifold>) -> Option<Manifold> {
    let of = |point: &ManifoldPoint| (rank(&point.contact), point.part_a, point.part_b);
    least(all, |m| (of(m.deepest()), m.points().nth(1).map(of)))
}

/// The result of a motion for several parts: inside if one is, else the earliest hit.
fn first<M: Moment>(courses: impl Iterator<Item = Course<M>>, d: Raw) -> Course<M> {
    let mut best: Option<M> = None;
    for course in courses {
        match course {
            Course::Free => {}
            Course::Inside => return Course::Inside,
            Course::Meets(moment) => {
                let key = |m: &M| {
                    let (toi, step, axis) = m.contact(d);
                    (m.exact_toi(d), toi, order(axis), (step.x, step.y))
                };
                if best.as_ref().is_none_or(|kept| key(&moment) < key(kept)) {
                    best = Some(moment);
                }
            }
        }
    }
    best.map_or(Course::Free, Course::Meets)
}

/// A displacement up to a hit, reduced until nothing overlaps. It is rounded away from the part
/// that is hit, and may lead into another part. The steps are 1, 2, 4, ... raw units along the
/// motion, rounded to the motion on the other axis. At the start nothing overlaps.
fn led_back(d: Raw, step: Raw, is_free: impl Fn(Raw) -> bool) -> Raw {
    let (mut at, mut back) = (step, 1);
    let steep = d.y.unsigned_abs() > d.x.unsigned_abs();
    while !is_free(at) {
        let of = |from: i32, by: i32| if back < from.unsigned_abs() { from - by * from.signum() } else { 0 };
        at = if steep {
            let y = of(step.y, back as i32);
            Raw { x: share(d.x, y, d.y), y }
        } else {
            let x = of(step.x, back as i32);
            Raw { x, y: share(d.y, x, d.x) }
        };
        if at.is_zero() {
            break;
        }
        back <<= 1;
    }
    at
}

/// Whether two shapes overlap, by a motion of length zero.
fn is_inside<M>(course: &Course<M>) -> bool {
    matches!(course, Course::Inside)
}

/// The nearest of the pairs of points of the parts; none if a part touches.
fn nearest(pairs: impl Iterator<Item = (Fx, Option<(Vec2, Vec2)>)>) -> Option<(Vec2, Vec2)> {
    let key = |(far, pair): &(Fx, Option<(Vec2, Vec2)>)| (*far, pair.map(|(p, q)| (p.raw(), q.raw())));
    least(pairs, key)?.1
}

fn boxes_meet<const CLOSED: bool>(a: &Aabb, b: &Aabb) -> bool {
    aabb_aabb::<CLOSED>(a.lo(), a.hi(), b.lo(), b.hi())
}

/// Whether the bounding box of a motion of A touches that of B.
fn comes_near(a: &Aabb, b: &Aabb, d: Raw) -> bool {
    let (lo, hi) = (a.lo(), a.hi());
    let from = Raw { x: lo.x.wrapping_add(d.x.min(0)), y: lo.y.wrapping_add(d.y.min(0)) };
    let to = Raw { x: hi.x.wrapping_add(d.x.max(0)), y: hi.y.wrapping_add(d.y.max(0)) };
    let (lo, hi) = (b.lo(), b.hi());
    from.x <= hi.x && from.y <= hi.y && to.x >= lo.x && to.y >= lo.y
}

// A compound as A, against all that has a bounding box: shapes and compounds.

impl<S: Single + Overlaps<B>, B: Extent, const M: usize> Overlaps<B> for Compound<S, M> {
    fn overlaps(&self, b: &B) -> bool {
        boxes_meet::<false>(&self.aabb(), &b.extent()) && self.parts().iter().any(|part| part.overlaps(b))
    }
}

impl<S: Single + Touches<B>, B: Extent, const M: usize> Touches<B> for Compound<S, M> {
    fn touches(&self, b: &B) -> bool {
        boxes_meet::<true>(&self.aabb(), &b.extent()) && self.parts().iter().any(|part| part.touches(b))
    }
}

impl<S: Single + Contacts<B>, B: Extent, const M: usize> Contacts<B> for Compound<S, M> {
    fn contact(&self, b: &B) -> Option<Contact> {
        let meets = boxes_meet::<false>(&self.aabb(), &b.extent());
        if meets { deepest(self.parts().iter().filter_map(|part| part.contact(b))) } else { None }
    }
}

impl<S: Single + Manifolds<B>, B: Extent, const M: usize> Manifolds<B> for Compound<S, M> {
    fn manifold(&self, b: &B) -> Option<Manifold> {
        let meets = boxes_meet::<false>(&self.aabb(), &b.extent());
        if meets { deepest_manifold(self.parts().iter().filter_map(|part| part.manifold(b))) } else { None }
    }
}

impl<S: Single + Distance<B>, B: Extent, const M: usize> Distance<B> for Compound<S, M> {
    fn distance(&self, b: &B) -> Fx {
        self.parts().iter().map(|part| part.distance(b)).min().unwrap_or(Fx::ZERO)
    }
}

impl<S: Single + ClosestPoint<B> + Distance<B>, B: Extent, const M: usize> ClosestPoint<B> for Compound<S, M> {
    fn closest_points(&self, b: &B) -> Option<(Vec2, Vec2)> {
        nearest(self.parts().iter().map(|part| (part.distance(b), part.closest_points(b))))
    }
}

impl<S: Single, const M: usize> InDomain for Compound<S, M> {}

impl<S: Single + Enter<B>, B: Extent, const M: usize> Enter<B> for Compound<S, M> {
    type Moment = S::Moment;

    fn enter(&self, b: &B, d: Raw) -> Course<S::Moment> {
        if !comes_near(&self.aabb(), &b.extent(), d) {
            return Course::Free;
        }
        first(self.parts().iter().map(|part| part.enter(b, d)), d)
    }

    fn led_back(&self, b: &B, d: Raw, step: Raw) -> Raw {
        led_back(d, step, |by| {
            let meets = |part: &S| part.moved(by.vec2()).is_ok_and(|part| is_inside(&part.enter(b, Raw::ZERO)));
            !self.parts().iter().any(meets)
        })
    }
}

impl<S: Single + Enter<B>, B: Extent, const M: usize> CastShape<B> for Compound<S, M> {}

impl<S: Single + Contains<Vec2>, const M: usize> Contains<Vec2> for Compound<S, M> {
    fn contains(&self, b: &Vec2) -> bool {
        self.aabb().contains(b) && self.parts().iter().any(|part| part.contains(b))
    }
}

impl<S: Single + Distance<Vec2>, const M: usize> Distance<Vec2> for Compound<S, M> {
    fn distance(&self, b: &Vec2) -> Fx {
        self.parts().iter().map(|part| part.distance(b)).min().unwrap_or(Fx::ZERO)
    }
}

/// A single shape as A, and a compound as B.
macro_rules! against {
    ([$($n:tt)*] $a:ty) => {
        impl<$($n)* S: Single, const K: usize> Overlaps<Compound<S, K>> for $a where $a: Overlaps<S> {
            fn overlaps(&self, b: &Compound<S, K>) -> bool {
                boxes_meet::<false>(&self.aabb(), &b.aabb()) && b.parts().iter().any(|part| self.overlaps(part))
            }
        }

        impl<$($n)* S: Single, const K: usize> Touches<Compound<S, K>> for $a where $a: Touches<S> {
            fn touches(&self, b: &Compound<S, K>) -> bool {
                boxes_meet::<true>(&self.aabb(), &b.aabb()) && b.parts().iter().any(|part| self.touches(part))
            }
        }

        impl<$($n)* S: Single, const K: usize> Contacts<Compound<S, K>> for $a where $a: Contacts<S> {
            fn contact(&self, b: &Compound<S, K>) -> Option<Contact> {
                let meets = boxes_meet::<false>(&self.aabb(), &b.aabb());
                if meets { deepest(b.parts().iter().filter_map(|part| self.contact(part))) } else { None }
            }
        }

        impl<$($n)* S: Single, const K: usize> Manifolds<Compound<S, K>> for $a where $a: Manifolds<S> {
            fn manifold(&self, b: &Compound<S, K>) -> Option<Manifold> {
                let meets = boxes_meet::<false>(&self.aabb(), &b.aabb());
                if meets { deepest_manifold(b.parts().iter().filter_map(|part| self.manifold(part))) } else { None }
            }
        }

        impl<$($n)* S: Single, const K: usize> Contains<Compound<S, K>> for $a where $a: Contains<S> {
            fn contains(&self, b: &Compound<S, K>) -> bool {
                b.parts().iter().all(|part| self.contains(part))
            }
        }

        impl<$($n)* S: Single, const K: usize> Distance<Compound<S, K>> for $a where $a: Distance<S> {
            fn distance(&self, b: &Compound<S, K>) -> Fx {
                b.parts().iter().map(|part| self.distance(part)).min().unwrap_or(Fx::ZERO)
            }
        }

        impl<$($n)* S: Single, const K: usize> ClosestPoint<Compound<S, K>> for $a
        where
            $a: ClosestPoint<S> + Distance<S>,
        {
            fn closest_points(&self, b: &Compound<S, K>) -> Option<(Vec2, Vec2)> {
                nearest(b.parts().iter().map(|part| (self.distance(part), self.closest_points(part))))
            }
        }

        impl<$($n)* S: Single, const K: usize> Enter<Compound<S, K>> for $a where $a: Enter<S> {
            type Moment = <$a as Enter<S>>::Moment;

            fn enter(&self, b: &Compound<S, K>, d: Raw) -> Course<Self::Moment> {
                if !comes_near(&self.aabb(), &b.aabb(), d) {
                    return Course::Free;
                }
                first(b.parts().iter().map(|part| self.enter(part, d)), d)
            }

            fn led_back(&self, b: &Compound<S, K>, d: Raw, step: Raw) -> Raw {
                led_back(d, step, |by| {
                    let moved = self.translated(by.vec2());
                    !moved.is_ok_and(|a| b.parts().iter().any(|part| is_inside(&a.enter(part, Raw::ZERO))))
                })
            }
        }

        impl<$($n)* S: Single, const K: usize> CastShape<Compound<S, K>> for $a where $a: Enter<S> {}
    };
}

against!([] Aabb);
against!([] Circle);
against!([] Segment);
against!([] Capsule);
against!([] OrientedBox);
against!([const N: usize,] ConvexPolygon<N>);
against!([const N: usize,] AnyShape<N>);

macro_rules! rays {
    ([$($n:tt)*] $shape:ty) => {
        impl<$($n)* const M: usize> Compound<$shape, M> {
            /// The first point of a part that a ray from `origin` along `motion` meets, by the
            /// rules of the parts.
            ///
            /// The ray starts inside if it starts inside any part.
            ///
            /// # Errors
            /// [`RangeError`] if the start or the end is outside of the
            /// [domain](crate::num::DOMAIN).
            pub fn cast_ray(&self, origin: Vec2, motion: Vec2, inside: Inside) -> Result<Option<CastHit>, RangeError> {
                let mut best: Option<CastHit> = None;
                for part in self.parts() {
                    let Some(hit) = part.cast_ray(origin, motion, inside)? else { continue };
                    let key = |hit: &CastHit| (!hit.inside, hit.toi, order(hit.axis));
                    if best.as_ref().is_none_or(|kept| key(&hit) < key(kept)) {
                        best = Some(hit);
                    }
                }
                Ok(best)
            }
        }
    };
}

rays!([] Aabb);
rays!([] Circle);
rays!([] Capsule);
rays!([] OrientedBox);
rays!([const N: usize,] ConvexPolygon<N>);
rays!([const N: usize,] AnyShape<N>);
