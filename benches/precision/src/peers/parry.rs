//! parry2d, in both precisions: its general queries, as its users call them, and the special
//! functions below them. The latter take the relative position as a difference, because nothing
//! rotates.

/// Shared code of both precisions. The modules below differ in the crate and its number type.
macro_rules! parry {
    ($module:ident, $parry:ident, $real:ty, $format:ident, $general:literal, $direct:literal) => {
        pub mod $module {
            use crate::job::{Format, List};
            use crate::pairs::classes::Pair;
            use crate::pairs::truth::Answer;
            use tilesat_judge::oracle::figure::{Figure, Kind};
            use $parry::bounding_volume::{Aabb, BoundingVolume};
            use $parry::math::{Pose, Real, Vector};
            use $parry::query::{self, Contact, ShapeIntersection, details};
            use $parry::shape::{Ball, Cuboid, Segment, Shape};
            use $parry::utils::segments_intersection2d;

            pub const FORMAT: Format = Format::$format;

            pub fn length(raw: f64) -> Real {
                (raw / 65536.0) as $real
            }

            pub fn vector((x, y): (i64, i64)) -> Vector {
                Vector::new(length(x as f64), length(y as f64))
            }

            /// A shape and its position: the middle of a ball or box, and the origin for a segment,
            /// which is a wall.
            pub trait Placed<F = Figure>: Shape + Sized {
                fn of(figure: &F) -> (Pose, Self);
            }

            pub fn at(p: Vector) -> Pose {
                Pose::translation(p.x, p.y)
            }

            impl Placed for Ball {
                fn of(figure: &Figure) -> (Pose, Self) {
                    let Figure::Circle { centre, radius } = *figure else { panic!("{figure:?} is no circle") };
                    (at(vector(centre)), Self::new(length(radius as f64)))
                }
            }

            impl Placed for Cuboid {
                fn of(figure: &Figure) -> (Pose, Self) {
                    let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
                    let middle = |a: i64, b: i64| length((a + b) as f64 / 2.0);
                    let half = |a: i64, b: i64| length((b - a) as f64 / 2.0);
                    (
                        at(Vector::new(middle(min.0, max.0), middle(min.1, max.1))),
                        Self::new(Vector::new(half(min.0, max.0), half(min.1, max.1))),
                    )
                }
            }

            impl Placed for Segment {
                fn of(figure: &Figure) -> (Pose, Self) {
                    let Figure::Segment { a, b } = *figure else { panic!("{figure:?} is no segment") };
                    (Pose::identity(), Self::new(vector(a), vector(b)))
                }
            }

            fn aabb(figure: &Figure) -> Aabb {
                let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
                Aabb::new(vector(min), vector(max))
            }

            fn of_contact(c: &Option<Contact>) -> Answer {
                Answer { hit: c.is_some(), depth: c.map(|c| -f64::from(c.dist)) }
            }

            pub fn of_yes(yes: &bool) -> Answer {
                Answer { hit: *yes, depth: None }
            }

            type Placement<T> = (Pose, T);

            fn shapes<F, A: Placed<F>, B: Placed<F>>((a, b): &(F, F)) -> (Placement<A>, Placement<B>) {
                (A::of(a), B::of(b))
            }

            pub fn general<F: 'static, A: Placed<F>, B: Placed<F>>(list: &mut List<(F, F), Answer>) {
                list.add(
                    ($general, "overlaps", FORMAT),
                    shapes::<F, A, B>,
                    |((p, a), (q, b))| {
                        query::intersection_test(p, a, q, b).is_ok_and(|i: ShapeIntersection| i.intersecting)
                    },
                    of_yes,
                );
                list.add(
                    ($general, "contact", FORMAT),
                    shapes::<F, A, B>,
                    |((p, a), (q, b))| query::contact(p, a, q, b, 0.0).ok().flatten(),
                    of_contact,
                );
            }

            /// Nothing rotates: the position of A relative to B is a plain difference.
            pub fn seen(p: &Pose, q: &Pose) -> Pose {
                Pose::from_translation(p.translation - q.translation)
            }

            pub fn direct<F: 'static, A: Placed<F>, B: Placed<F>>(
                list: &mut List<(F, F), Answer>,
                overlaps: impl Fn(&Pose, &A, &Pose, &B) -> bool + Copy + 'static,
                contact: impl Fn(&Pose, &A, &Pose, &B) -> Option<Contact> + Copy + 'static,
            ) {
                list.add(
                    ($direct, "overlaps", FORMAT),
                    shapes::<F, A, B>,
                    move |((p, a), (q, b))| overlaps(p, a, q, b),
                    of_yes,
                );
                list.add(
                    ($direct, "contact", FORMAT),
                    shapes::<F, A, B>,
                    move |((p, a), (q, b))| contact(p, a, q, b),
                    of_contact,
                );
            }

            fn boxes(list: &mut List<Pair, Answer>) {
                list.add(
                    ($direct, "overlaps", FORMAT),
                    |(a, b): &Pair| (aabb(a), aabb(b)),
                    |(a, b)| a.intersects(b),
                    of_yes,
                );
            }

            fn segment_and_box(list: &mut List<Pair, Answer>) {
                list.add(
                    ($direct, "overlaps", FORMAT),
                    |(a, b): &Pair| (Segment::of(a).1, aabb(b)),
                    |(a, b)| details::intersection_test_aabb_segment(b, a),
                    of_yes,
                );
            }

            fn segments(list: &mut List<Pair, Answer>) {
                list.add(
                    ($direct, "overlaps", FORMAT),
                    |(a, b): &Pair| (Segment::of(a).1, Segment::of(b).1),
                    |(s, t)| segments_intersection2d(s.a, s.b, t.a, t.b, 0.0).is_some(),
                    of_yes,
                );
            }

            pub fn pairs(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
                match kinds {
                    (Kind::Circle, Kind::Circle) => {
                        general::<_, Ball, Ball>(list);
                        direct::<_, Ball, Ball>(
                            list,
                            |p, a, q, b| details::intersection_test_ball_ball(seen(p, q).translation, a, b),
                            |p, a, q, b| details::contact_ball_ball(&seen(p, q), b, a, 0.0),
                        );
                    }
                    (Kind::Circle, Kind::Aabb) => {
                        general::<_, Ball, Cuboid>(list);
                        direct::<_, Ball, Cuboid>(
                            list,
                            |p, a, q, b| details::intersection_test_point_query_ball(&seen(p, q), b, a).intersecting,
                            |p, a, q, b| details::contact_convex_polyhedron_ball(&seen(p, q), b, a, 0.0),
                        );
                    }
                    (Kind::Circle, Kind::Segment) => {
                        general::<_, Ball, Segment>(list);
                        direct::<_, Ball, Segment>(
                            list,
                            |p, a, q, b| details::intersection_test_point_query_ball(&seen(p, q), b, a).intersecting,
                            |p, a, q, b| details::contact_convex_polyhedron_ball(&seen(p, q), b, a, 0.0),
                        );
                    }
                    (Kind::Aabb, Kind::Aabb) => {
                        general::<_, Cuboid, Cuboid>(list);
                        boxes(list);
                    }
                    (Kind::Segment, Kind::Aabb) => {
                        general::<_, Segment, Cuboid>(list);
                        segment_and_box(list);
                    }
                    (Kind::Segment, Kind::Segment) => {
                        general::<_, Segment, Segment>(list);
                        segments(list);
                    }
                    _ => {}
                }
            }
        }
    };
}

parry!(single, parry2d, f32, F32, "parry2d", "parry2d (special)");
parry!(double, parry2d_f64, f64, F64, "parry2d-f64", "parry2d-f64 (special)");
