//! Broad phases, their answers, and events of pairs.

use crate::tell;
use tilesat::broad::{
    Border, BroadError, BroadHit, BruteForce, Exceptions, GridError, Ignore, Keyed, LooseGrid, Nearest, PairCursor,
    PairEvent, PairEvents, PairsError, QueryError, SortSweep, SpatialHash,
};
use tilesat::heapless::Vec;
use tilesat::prelude::*;
use tilesat::query::BoxColumns;
use tilesat::{Aabb, Fx, Vec2, error::Truncated};

fn at(x: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8)).unwrap()
}

pub(crate) fn tell_all() {
    let mut near = SortSweep::<8>::new();
    let a = near.insert(&at(0), ()).unwrap();
    let b = near.insert(&at(6), ()).unwrap();
    tell(&BoxColumns::<2>::of(&[at(0)]).unwrap());
    tell(&near);
    let mut brute = BruteForce::<2, Keyed>::new();
    let tag = Keyed { key: 77, tag: () };
    tell(&tag);
    brute.insert(&at(0), tag).unwrap();
    tell(&brute);
    tell(&brute.insert(&at(0), tag).and_then(|_| brute.insert(&at(0), tag)).unwrap_err());
    let mut grid = LooseGrid::<2, 4>::new(Vec2::ZERO, Fx::from_num(16), 8).unwrap();
    grid.insert(&at(3), ()).unwrap();
    tell(&grid);
    tell(&SpatialHash::<4, 4>::new(Fx::from_num(16)).unwrap());
    let error: GridError = SpatialHash::<4, 4>::new(Fx::from_num(15)).err().unwrap();
    tell(&error);
    tell(&Border::Refuse);

    tell(&a);
    let mut first = None;
    near.pairs(|pair| first = Some(pair));
    let pair = first.unwrap();
    tell(&pair);
    let mut hits = Vec::<BroadHit, 2>::new();
    near.cast_ray(Vec2::from_ints(-4, 4), Vec2::from_ints(20, 0), |handle, ()| handle == b, &mut hits).unwrap();
    tell(&hits[0]);
    let mut nearest = Vec::<Nearest, 1>::new();
    near.neighbours(Vec2::from_ints(17, 4), Fx::from_num(9), |_, ()| true, &mut nearest).ok();
    tell(&nearest[0]);
    let mut cursor = PairCursor::new();
    tell(&near.pairs_from(&mut cursor, 0, &mut Vec::<_, 1>::new()).unwrap_err());
    tell(&cursor);
    tell(&PairsError::Changed);
    tell(&QueryError::Truncated(Truncated { seen: 2, kept: 1 }));
    let stale: BroadError = {
        near.remove(b).unwrap();
        near.remove(b).unwrap_err()
    };
    tell(&stale);

    let mut events = PairEvents::<4>::new();
    events.feed(pair);
    events.finish(|_| false).unwrap();
    tell(&events);
    tell(&PairEvent::Stay(pair));
    let mut exceptions = Exceptions::<4>::new();
    exceptions.ignore(b, a, Ignore::UntilApart).unwrap();
    tell(&exceptions);
    tell(&Ignore::Once);
}
