//! The backends that answer questions about convex shapes.

mod box2d;
mod chipmunk;
mod local;
mod ours;
mod parry;
mod textbook;

use super::classes::Pair;
use crate::job::List;
use crate::pairs::truth::Answer;
use tilesat_judge::convex::shape::Kind;
use tilesat_textbook::{Q16, Wide};

pub fn all(kinds: (Kind, Kind)) -> List<Pair, Answer> {
    let mut list = List(Vec::new());
    ours::pairs(&mut list, kinds);
    textbook::pairs::<Q16>(&mut list, kinds);
    textbook::pairs::<Wide>(&mut list, kinds);
    textbook::pairs::<f32>(&mut list, kinds);
    textbook::pairs::<f64>(&mut list, kinds);
    parry::single::pairs(&mut list, kinds);
    parry::double::pairs(&mut list, kinds);
    box2d::pairs(&mut list, kinds);
    chipmunk::pairs(&mut list);
    list
}

/// The distance of capsules, and of boxes from each other and from circles.
pub fn distances(kinds: (Kind, Kind)) -> List<Pair, f64> {
    let mut list = List(Vec::new());
    if kinds.0 != Kind::Polygon {
        ours::distances(&mut list, kinds);
        textbook::distances::<Q16>(&mut list, kinds);
        textbook::distances::<Wide>(&mut list, kinds);
        textbook::distances::<f32>(&mut list, kinds);
        textbook::distances::<f64>(&mut list, kinds);
        parry::single::distances(&mut list, kinds);
        parry::double::distances(&mut list, kinds);
        box2d::distances(&mut list, kinds);
    }
    list
}
