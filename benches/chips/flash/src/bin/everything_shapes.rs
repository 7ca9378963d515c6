//! All shapes, and all queries of all pairs of them.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::prelude::*;
use tilesat::{Aabb, Circle, Contact, Fx, Inside, Segment, Vec2};
use tilesat_flash::keep;

macro_rules! shapes {
    ($($shape:ty),+) => {
        $(keep! {
            |s: &$shape, by: Vec2| s.translated(by);
            |s: &$shape| s.aabb();
            |s: &$shape, p: Vec2| s.closest_point(p);
            |s: &$shape, p: &Vec2| s.distance(p);
            |s: &$shape, p: &Vec2| s.contains(p);
        })+
    };
}

macro_rules! pairs {
    ($($a:ty: $($b:ty),+;)+) => {
        $($(keep! {
            |a: &$a, b: &$b| a.overlaps(b);
            |a: &$a, b: &$b| a.touches(b);
            |a: &$a, b: &$b| a.contact(b);
            |a: &$a, b: &$b| a.contains(b);
            |a: &$a, b: &$b| a.distance(b);
            |a: &$a, b: &$b| a.closest_points(b);
        })+)+
    };
}

macro_rules! casts {
    ($($a:ty: $($b:ty),+;)+) => {
        $($(keep! {
            |a: &$a, b: &$b, motion: Vec2, inside: Inside| a.cast_shape(b, motion, inside);
            |a: &$a, b: &$b, motion: Vec2, inside: Inside| a.would_hit(b, motion, inside);
        })+)+
    };
}

fn makers() {
    keep! {
        |a: Vec2, b: Vec2| Aabb::new(a, b);
        |a: Vec2, b: Vec2| Aabb::from_centre(a, b);
        |b: &Aabb| (b.min(), b.max(), b.size(), b.centre());
        |a: &Aabb, b: &Aabb| a.union(b);
        |a: &Aabb, b: &Aabb| a.intersection(b);
        |a: &Aabb, by: Fx| a.grown(by);
        |c: Vec2, r: Fx| Circle::new(c, r);
        |c: &Circle| (c.centre(), c.radius());
        |a: Vec2, b: Vec2| Segment::new(a, b);
        |s: &Segment| (s.a(), s.b());
    }
    shapes!(Aabb, Circle, Segment);
}

fn verbs() {
    pairs! {
        Aabb: Aabb, Circle, Segment;
        Circle: Aabb, Circle, Segment;
        Segment: Aabb, Circle, Segment;
    }
    keep! {
        |c: &Contact| (c.axis(), c.is_degenerate());
        |c: &Contact| c.normal();
        |c: &Contact| c.depth();
        |c: &Contact| c.push_out();
        |c: &Contact| c.point_on_a();
        |c: &Contact| c.point_on_b();
    }
}

fn motions() {
    casts! {
        Aabb: Aabb, Circle, Segment;
        Circle: Aabb, Circle, Segment;
        Segment: Aabb, Circle, Segment;
        Vec2: Aabb, Circle;
    }
    keep! {
        |s: &Aabb, origin: Vec2, motion: Vec2, inside: Inside| s.cast_ray(origin, motion, inside);
        |s: &Circle, origin: Vec2, motion: Vec2, inside: Inside| s.cast_ray(origin, motion, inside);
        |s: &Segment, origin: Vec2, motion: Vec2| s.cast_ray(origin, motion);
    }
}

tilesat_flash::everything!(makers, verbs, motions);
