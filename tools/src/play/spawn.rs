//! Where the author of a level wants its player.

use tilesat::Vec2;

use crate::rules::outline::LeftOut;
use crate::rules::same;

/// The names and classes of such an object, the surest first.
const NAMES: [&str; 5] = ["spawn", "player spawn", "player start", "spawn point", "player"];

/// A place for the feet of the player.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spawn {
    /// The object, for the user.
    pub title: String,
    /// The middle of the body's lower side.
    pub feet: Vec2,
}

/// An object that may be the place: its title, its name and class, and the box around it, raw.
pub(super) struct Candidate<'a> {
    pub(super) title: String,
    pub(super) name: &'a str,
    pub(super) class: &'a str,
    pub(super) area: [(i64, i64); 2],
}

impl<'a> Candidate<'a> {
    pub(super) fn of(object: &'a LeftOut) -> Option<Self> {
        let area = object.area.filter(|_| object.is_listed())?;
        Some(Self { title: object.title.to_string(), name: &object.title.name, class: &object.class, area })
    }

    /// The place in [`NAMES`]. A name tells more than a class.
    fn rank(&self) -> Option<usize> {
        let place = |own: &str| NAMES.iter().position(|name| same(own, name));
        place(self.name).or_else(|| Some(place(self.class)? + NAMES.len()))
    }
}

/// The best of these objects, moved by raw units, and how many others would do.
pub(super) fn find<'a>(objects: impl Iterator<Item = Candidate<'a>>, by: (i32, i32)) -> Option<(Spawn, usize)> {
    let mut ranked: Vec<(usize, Candidate<'a>)> = objects.filter_map(|object| Some((object.rank()?, object))).collect();
    // The first in the file of those that are as good.
    ranked.sort_by_key(|(rank, _)| *rank);
    let others = ranked.len().saturating_sub(1);
    let (_, best) = ranked.into_iter().next()?;
    let [(left, _), (right, bottom)] = best.area;
    let raw = |v: i64, by: i32| i32::try_from(v + i64::from(by)).ok();
    let feet = Vec2::from_raw(raw((left + right) >> 1, by.0)?, raw(bottom, by.1)?);
    Some((Spawn { title: best.title, feet }, others))
}
