//! Boxes in columns: one box against many, each answer judged alone.

use tilesat::error::Truncated;
use tilesat::query::BoxColumns;
use tilesat::{Aabb, Vec2};
use tilesat_judge::Random;
use tilesat_judge::oracle::figure::{Figure, Kind, Point};
use tilesat_judge::oracle::generate::{Class, Pairs};
use tilesat_judge::oracle::measure::Measure;

const PLACES: usize = 37;

fn shape(figure: &Figure) -> Aabb {
    let Figure::Aabb { min, max } = *figure else { panic!("{figure:?} is no box") };
    let at = |(x, y): Point| Vec2::from_raw(x as i32, y as i32);
    Aabb::new(at(min), at(max)).expect("inside the domain")
}

/// One box against the columns of others, of which there may be fewer than places.
fn judge(a: &Figure, many: &[Figure]) {
    let boxes: Vec<Aabb> = many.iter().map(shape).collect();
    let columns = BoxColumns::<PLACES>::of(&boxes).expect("room for all");
    let (overlaps, touches) = (columns.overlaps(&shape(a)), columns.touches(&shape(a)));
    for (place, (overlaps, touches)) in overlaps.into_iter().zip(touches).enumerate() {
        let wanted = many.get(place).map_or((false, false), |b| {
            let measure = Measure::new(a, b);
            (measure.overlaps(), measure.touches())
        });
        assert_eq!((overlaps, touches), wanted, "{a:?} {:?}", many.get(place));
    }
}

/// All boxes of a lattice of four by four points, those without area too, as they are and enlarged
/// to the size of the domain.
#[test]
fn every_box_of_a_lattice() {
    let points = || (0..16).map(|i| (i % 4, i / 4));
    let corners = points().flat_map(|p| points().map(move |q| (p, q)));
    let boxes: Vec<Figure> =
        corners.filter(|(p, q)| p.0 <= q.0 && p.1 <= q.1).map(|(min, max)| Figure::Aabb { min, max }).collect();
    assert_eq!(boxes.len(), 100);
    for scale in [1, 268_435_455] {
        let large = |f: &Figure| f.map(|p| ((2 * p.0 - 3) * scale / 3, (2 * p.1 - 3) * scale / 3));
        let boxes: Vec<Figure> = boxes.iter().map(large).collect();
        for a in &boxes {
            boxes.chunks(PLACES).for_each(|many| judge(a, many));
        }
    }
}

/// Hard pairs of boxes of each class, and every number of boxes.
#[test]
fn boxes_that_nearly_touch() {
    let mut r = Random::new(0xc01);
    for class in [Class::Near, Class::Exact, Class::Far, Class::Domain] {
        let mut pairs = Pairs::new((Kind::Aabb, Kind::Aabb), class, 0xc01);
        for _ in 0..400 {
            let count = r.within(0, PLACES as i64) as usize;
            let (first, other): (Vec<Figure>, Vec<Figure>) = (0..=count).map(|_| pairs.next()).unzip();
            judge(&first[0], &other[..count]);
        }
    }
}

#[test]
fn one_box_too_many_is_refused() {
    let boxes = [shape(&Figure::Aabb { min: (0, 0), max: (8, 8) }); 4];
    assert_eq!(BoxColumns::<3>::of(&boxes), Err(Truncated { seen: 4, kept: 0 }));
    assert_eq!(BoxColumns::<0>::of(&[]).map(|none| none.touches(&boxes[0])), Ok([]));
}
