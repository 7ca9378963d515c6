//! parry2d, in both precisions: its general queries, and the special functions below them. Only
//! boxes rotate; other shapes have their corners around their middle, so that the relative position
//! is a difference.

/// Shared code of both precisions. The modules below differ in the crate and its number type.
macro_rules! parry {
    ($module:ident, $parry:ident, $general:literal, $direct:literal) => {
        pub mod $module {
            use crate::convex::classes::Pair;
            use crate::convex::peers::local::Local;
            use crate::job::List;
            use crate::pairs::truth::Answer;
            use crate::peers::parry::$module::{FORMAT, at, direct, general, length, seen};
            use crate::peers::parry::$module::{Placed, of_yes};
            use tilesat_judge::convex::shape::{Kind, Shape};
            use $parry::math::{Pose, Real, Rotation, Vector};
            use $parry::query::sat::cuboid_cuboid_find_local_separating_normal_oneway as least_of;
            use $parry::query::{self, ContactManifold, details};
            use $parry::shape::{Ball, Capsule, ConvexPolygon, Cuboid};

            fn vector((x, y): (f64, f64)) -> Vector {
                Vector::new(length(x), length(y))
            }

            impl Placed<Shape> for Ball {
                fn of(shape: &Shape) -> (Pose, Self) {
                    (at(vector(Local::of(shape).middle)), Self::new(length(shape.radius() as f64)))
                }
            }

            impl Placed<Shape> for Capsule {
                fn of(shape: &Shape) -> (Pose, Self) {
                    let local = Local::of(shape);
                    let radius = length(shape.radius() as f64);
                    (at(vector(local.middle)), Self::new(vector(local.corners[0]), vector(local.corners[1]), radius))
                }
            }

            impl Placed<Shape> for ConvexPolygon {
                fn of(shape: &Shape) -> (Pose, Self) {
                    let local = Local::of(shape);
                    let corners = local.corners.into_iter().map(vector).collect();
                    let polygon = Self::from_convex_polyline(corners).expect("classes make convex polygons");
                    (at(vector(local.middle)), polygon)
                }
            }

            impl Placed<Shape> for Cuboid {
                fn of(shape: &Shape) -> (Pose, Self) {
                    let (local, turned) = (Local::of(shape), Local::turned(shape));
                    let rotation = Rotation::from_cos_sin_unchecked(turned.cos as _, turned.sin as _);
                    (Pose::from_parts(vector(local.middle), rotation), Self::new(vector(turned.half)))
                }
            }

            /// The position of a ball relative to a box.
            fn ball_in_box(ball: &Pose, cuboid: &Pose) -> Pose {
                at(cuboid.inverse_transform_point(ball.translation))
            }

            /// Its test for overlaps, and a contact by the two halves of that test. It also has a
            /// contact of boxes, which its queries do not call: that one misses half of the hits.
            fn boxes(list: &mut List<Pair, Answer>) {
                type Placement = (Pose, Cuboid);
                let shapes = |(a, b): &Pair| -> (Placement, Placement) { (Cuboid::of(a), Cuboid::of(b)) };
                list.add(
                    ($direct, "overlaps", FORMAT),
                    shapes,
                    |((p, a), (q, b))| details::intersection_test_cuboid_cuboid(&p.inv_mul(q), a, b),
                    of_yes,
                );
                list.add(
                    ($direct, "contact", FORMAT),
                    shapes,
                    |((p, a), (q, b))| {
                        let b_in_a = p.inv_mul(q);
                        let of_a = least_of(a, b, &b_in_a);
                        if of_a.0 > 0.0 {
                            return None;
                        }
                        let of_b = least_of(b, a, &b_in_a.inverse());
                        let of_b = (of_b.0, b_in_a.rotation * -of_b.1);
                        (of_b.0 <= 0.0).then_some(if of_b.0 > of_a.0 { of_b } else { of_a })
                    },
                    |found| Answer { hit: found.is_some(), depth: found.map(|f| -f64::from(f.0)) },
                );
            }

            fn polygons(list: &mut List<Pair, Answer>) {
                direct::<_, ConvexPolygon, ConvexPolygon>(
                    list,
                    |p, a, q, b| details::intersection_test_support_map_support_map(&seen(q, p), a, b),
                    |p, a, q, b| details::contact_support_map_support_map(&seen(q, p), a, b, 0.0),
                );
            }

            /// The distance between the cores. The contact is that of its manifolds.
            fn capsules(list: &mut List<Pair, Answer>) {
                type Placement = (Pose, Capsule);
                let shapes = |(a, b): &Pair| -> (Placement, Placement) { (Capsule::of(a), Capsule::of(b)) };
                list.add(
                    ($direct, "overlaps", FORMAT),
                    shapes,
                    |((p, a), (q, b))| {
                        let d = details::distance_segment_segment(&seen(q, p), &a.segment, &b.segment);
                        d <= a.radius + b.radius
                    },
                    of_yes,
                );
                list.add(
                    ($direct, "contact", FORMAT),
                    shapes,
                    |((p, a), (q, b))| {
                        let mut manifold = ContactManifold::<(), ()>::new();
                        details::contact_manifold_capsule_capsule(&seen(q, p), a, b, 0.0, &mut manifold);
                        let deepest = manifold.points.iter().map(|p| p.dist).reduce(|a, b| a.min(b));
                        deepest.filter(|d| *d <= 0.0).map(|d| (d, manifold.local_n1))
                    },
                    |found| Answer { hit: found.is_some(), depth: found.map(|f| -f64::from(f.0)) },
                );
            }

            pub fn pairs(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
                match kinds {
                    (Kind::Circle, _) => {
                        general::<_, Ball, Cuboid>(list);
                        direct::<_, Ball, Cuboid>(
                            list,
                            |p, a, q, b| {
                                details::intersection_test_point_query_ball(&ball_in_box(p, q), b, a).intersecting
                            },
                            |p, a, q, b| details::contact_convex_polyhedron_ball(&ball_in_box(p, q), b, a, 0.0),
                        );
                    }
                    (Kind::Turned, _) => {
                        general::<_, Cuboid, Cuboid>(list);
                        boxes(list);
                    }
                    (Kind::Polygon, _) => {
                        general::<_, ConvexPolygon, ConvexPolygon>(list);
                        polygons(list);
                    }
                    _ => {
                        general::<_, Capsule, Capsule>(list);
                        capsules(list);
                    }
                }
            }

            fn distance<A: Placed<Shape>, B: Placed<Shape>>(
                list: &mut List<Pair, f64>,
                ask: impl Fn(&Pose, &A, &Pose, &B) -> Real + Copy + 'static,
            ) {
                let shapes = |(a, b): &Pair| (A::of(a), B::of(b));
                list.add(
                    ($general, "distance", FORMAT),
                    shapes,
                    |((p, a), (q, b))| query::distance(p, a, q, b).map_or(Real::NAN, |found| found.distance),
                    |d| f64::from(*d),
                );
                let told = move |((p, a), (q, b)): &((Pose, A), (Pose, B))| ask(p, a, q, b);
                list.add(($direct, "distance", FORMAT), shapes, told, |d| f64::from(*d));
            }

            pub fn distances(list: &mut List<Pair, f64>, kinds: (Kind, Kind)) {
                match kinds {
                    (Kind::Circle, _) => distance::<Ball, Cuboid>(list, |p, a, q, b| {
                        details::distance_convex_polyhedron_ball(&ball_in_box(p, q), b, a)
                    }),
                    (Kind::Turned, _) => distance::<Cuboid, Cuboid>(list, |p, a, q, b| {
                        details::distance_cuboid_cuboid(&p.inv_mul(q), a, b)
                    }),
                    _ => distance::<Capsule, Capsule>(list, |p, a, q, b| {
                        let d = details::distance_segment_segment(&seen(q, p), &a.segment, &b.segment);
                        (d - a.radius - b.radius).max(0.0)
                    }),
                }
            }
        }
    };
}

parry!(single, parry2d, "parry2d", "parry2d (special)");
parry!(double, parry2d_f64, "parry2d-f64", "parry2d-f64 (special)");
