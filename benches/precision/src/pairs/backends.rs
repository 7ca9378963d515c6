//! The backends that answer questions about pairs.

use super::classes::Pair;
use super::truth::Answer;
use crate::job::List;
use crate::peers::textbook::{Named, contact, overlaps};
use crate::peers::{box2d, chipmunk, exact, ncollide, ours, parry};
use tilesat_judge::oracle::figure::Kind;
use tilesat_textbook::shape::{Aabb, Circle, Segment};
use tilesat_textbook::{Q16, Wide, exact as plain, pair};

pub fn all(kinds: (Kind, Kind)) -> List<Pair, Answer> {
    let mut list = List(Vec::new());
    library(&mut list, kinds);
    unfiltered(&mut list, kinds);
    textbook::<Q16>(&mut list, kinds);
    textbook::<Wide>(&mut list, kinds);
    textbook::<f32>(&mut list, kinds);
    textbook::<f64>(&mut list, kinds);
    parry::single::pairs(&mut list, kinds);
    parry::double::pairs(&mut list, kinds);
    ncollide::pairs(&mut list, kinds);
    box2d::pairs(&mut list, kinds);
    chipmunk::pairs(&mut list, kinds);
    list
}

fn library(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    use tilesat::{Aabb, Circle, Segment};
    match kinds {
        (Kind::Circle, Kind::Circle) => ours::pairs::<_, Circle, Circle>(list),
        (Kind::Circle, Kind::Aabb) => ours::pairs::<_, Circle, Aabb>(list),
        (Kind::Circle, Kind::Segment) => ours::pairs::<_, Circle, Segment>(list),
        (Kind::Aabb, Kind::Aabb) => ours::pairs::<_, Aabb, Aabb>(list),
        (Kind::Segment, Kind::Aabb) => ours::pairs::<_, Segment, Aabb>(list),
        (Kind::Segment, Kind::Segment) => ours::pairs::<_, Segment, Segment>(list),
        _ => {}
    }
}

fn unfiltered(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, Kind::Circle) => exact::overlaps(list, plain::circle_circle),
        (Kind::Circle, Kind::Aabb) => exact::overlaps(list, plain::circle_aabb),
        (Kind::Circle, Kind::Segment) => exact::overlaps(list, plain::circle_segment),
        (Kind::Aabb, Kind::Aabb) => exact::overlaps(list, plain::aabb_aabb),
        (Kind::Segment, Kind::Aabb) => exact::overlaps(list, |a, b| plain::aabb_segment(b, a)),
        (Kind::Segment, Kind::Segment) => exact::overlaps(list, plain::segment_segment),
        _ => {}
    }
}

fn textbook<S: Named>(list: &mut List<Pair, Answer>, kinds: (Kind, Kind)) {
    match kinds {
        (Kind::Circle, Kind::Circle) => {
            overlaps::<_, S, Circle<S>, Circle<S>>(list, pair::circle_circle);
            contact::<_, S, Circle<S>, Circle<S>>(list, pair::contact_circle_circle);
        }
        (Kind::Circle, Kind::Aabb) => {
            overlaps::<_, S, Circle<S>, Aabb<S>>(list, pair::circle_aabb);
            contact::<_, S, Circle<S>, Aabb<S>>(list, pair::contact_circle_aabb);
        }
        (Kind::Circle, Kind::Segment) => {
            overlaps::<_, S, Circle<S>, Segment<S>>(list, pair::circle_segment);
            contact::<_, S, Circle<S>, Segment<S>>(list, pair::contact_circle_segment);
        }
        (Kind::Aabb, Kind::Aabb) => {
            overlaps::<_, S, Aabb<S>, Aabb<S>>(list, pair::aabb_aabb);
            contact::<_, S, Aabb<S>, Aabb<S>>(list, pair::contact_aabb_aabb);
        }
        (Kind::Segment, Kind::Aabb) => {
            overlaps::<_, S, Segment<S>, Aabb<S>>(list, |a, b| pair::aabb_segment(b, a));
            contact::<_, S, Segment<S>, Aabb<S>>(list, |a, b| pair::contact_aabb_segment(b, a));
        }
        // No textbook defines a contact of two lines.
        (Kind::Segment, Kind::Segment) => overlaps::<_, S, Segment<S>, Segment<S>>(list, pair::segment_segment),
        _ => {}
    }
}
