//! ncollide2d in fixed point: its generic queries with simba's I16F16. It is the only other library
//! here that computes in integers.

use crate::job::{Format, List};
use crate::pairs::classes::Pair;
use crate::pairs::truth::Answer;
use nalgebra::{Isometry2, Point2, Vector2};
use ncollide2d::query::{self, Contact};
use ncollide2d::shape::{Ball, Cuboid, Segment, Shape};
use simba::scalar::FixedI16F16 as N;
use tilesat_judge::oracle::figure::{Figure, Kind};

const NAME: &str = "ncollide2d I16F16";

fn length(raw: i64) -> N {
    N::from_bits(raw as i32)
}

fn vector((x, y): (i64, i64)) -> Vector2<N> {
    Vector2::new(length(x), length(y))
}

trait Placed: Shape<N> + Sized {
    fn of(figure: &Figure) -> (Isometry2<N>, Self);
}

fn at(p: (i64, i64)) -> Isometry2<N> {
    Isometry2::new(vector(p), length(0))
}

impl Placed for Ball<N> {
    fn of(figure: &Figure) -> (Isometry2<N>, Self) {
        let Figure::Circle { centre, radius } = *figure else { panic!("{figure:?} is no circle") };
        (at(centre), Self::new(length(radius)))
    }
}

impl Placed for Cuboid<N> {
    /// The format has no half raw unit, so an odd size loses it.
    fn of(figure: &Figure) -> (Isometry2<N>, Self) {
        let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
        let half = ((max.0 - min.0) / 2, (max.1 - min.1) / 2);
        (at((min.0 + half.0, min.1 + half.1)), Self::new(vector(half)))
    }
}

impl Placed for Segment<N> {
    fn of(figure: &Figure) -> (Isometry2<N>, Self) {
        let Figure::Segment { a, b } = *figure else { panic!("{figure:?} is no segment") };
        (at((0, 0)), Self::new(Point2::from(vector(a)), Point2::from(vector(b))))
    }
}

/// Its squares overflow beyond 181 pixels, and so do those of a segment's world coordinates.
fn fits((a, b): &Pair) -> bool {
    let most = 127 << 16;
    let near = |f: &Figure| f.vertices().iter().all(|p| p.0.abs() < most && p.1.abs() < most);
    near(a) && near(b)
}

fn contact<A: Placed, B: Placed>(list: &mut List<Pair, Answer>) {
    list.add(
        (NAME, "contact", Format::RAW),
        |(a, b): &Pair| (A::of(a), B::of(b)),
        |((p, a), (q, b))| query::contact(p, a, q, b, length(0)),
        |c: &Option<Contact<N>>| Answer {
            hit: c.is_some(),
            depth: c.map(|c| f64::from(c.depth.0.to_bits()) / 65536.0),
        },
    );
    list.only_if(fits);
}

/// Circles only. For a simplex, the format's square root repeats Newton's rule until nothing
/// changes, which may never happen.
pub fn pairs(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, Kind::Circle) => contact::<Ball<N>, Ball<N>>(list),
        (Kind::Circle, Kind::Aabb) => contact::<Ball<N>, Cuboid<N>>(list),
        (Kind::Circle, Kind::Segment) => contact::<Ball<N>, Segment<N>>(list),
        _ => {}
    }
}
