//! The objects for the game, each in one room.

use std::collections::HashSet;

use super::Baked;
use super::part::Part;
use crate::bake::things::lost;
use crate::rules::outline::LeftOut;

/// Gives each object to the room that holds its middle, in coordinates of the room. Where levels
/// overlap, to its own. Returns those that no room holds, and other parts that no output has.
///
/// Objects of several maps of Tiled stay in the room of their map: their ids are those of the map.
pub(super) fn share(parts: &[Part], rooms: &mut [Baked], cell: u16) -> Vec<String> {
    let side = i64::from(cell) << 16;
    let mut unused = Vec::new();
    let apart = parts.len() > 1 && parts.iter().all(|part| part.own_ids);
    for part in parts {
        for object in &part.objects {
            let holds = |room: &Baked| {
                room.plane == part.plane && object.area.is_some_and(|area| holds_middle(room, area, side))
            };
            let own = rooms.iter().position(|room| room.name == part.name && (apart || holds(room)));
            let found = own.or_else(|| rooms.iter().position(holds)).map(|index| &mut rooms[index]);
            let moved = found.map(|room| {
                let mut object: LeftOut = object.clone();
                object.shift((i64::from(-room.first.0) * side, i64::from(-room.first.1) * side));
                (room, object)
            });
            match moved {
                Some((room, object)) if object.is_listed() => room.objects.push(object),
                Some((room, _)) => {
                    let why = format!("it reaches outside of the domain of room '{}': make it smaller", room.name);
                    unused.push(format!("{}: {why}", object.title));
                }
                None => unused.push(format!("{}: no room holds its middle", object.title)),
            }
        }
    }
    let scope = |room: usize| if apart { room } else { 0 };
    let ids = |(number, room): (usize, &Baked)| {
        room.objects.iter().map(|object| (scope(number), object.title.id)).collect::<Vec<_>>()
    };
    let listed: HashSet<(usize, u32)> = rooms.iter().enumerate().flat_map(ids).collect();
    for (number, room) in rooms.iter_mut().enumerate() {
        room.objects.iter_mut().for_each(|object| object.settle(|id| listed.contains(&(scope(number), id))));
    }
    unused.extend(rooms.iter().flat_map(|room| lost(&room.objects)));
    unused.extend(Part::told(parts, |part| &part.unused));
    unused
}

/// Whether the middle of an area is in a room, both in raw units of the world.
fn holds_middle(room: &Baked, [a, b]: [(i64, i64); 2], side: i64) -> bool {
    let along = |sum: i64, first: i32, size: u16| {
        let cell = sum.div_euclid(2).div_euclid(side);
        (i64::from(first)..i64::from(first) + i64::from(size)).contains(&cell)
    };
    along(a.0 + b.0, room.first.0, room.size.0) && along(a.1 + b.1, room.first.1, room.size.1)
}
