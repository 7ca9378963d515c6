//! The inputs of moving bodies and of broad phases, and the answers of the host's backends.

use super::file::{Answered, File};
use super::inputs::words;
use crate::broad::{self, scenes};
use crate::job::{Backend, List};
use crate::moves::classes::Case;
use crate::moves::room::{Body, MAPS, Room};
use crate::moves::truth::Answer;
use crate::moves::{self, backends};
use tilesat_textbook::checksum::{START, mixed, pair};

/// Half as many as the host counts: the code of all movers takes half of the flash.
const SEQUENCES: usize = 16;

/// Frames per number of boxes, and one before them that does not count.
fn frames_of(bodies: usize) -> usize {
    (2048 / bodies).clamp(8, 32) + 1
}

/// Backends that run without an allocator.
fn fit<I, A>(list: &List<I, A>) -> Vec<&Backend<I, A>> {
    let named = |b: &&Backend<I, A>| ["tilesat", "naive Q16.16", "textbook f32", "textbook f64"].contains(&b.name);
    list.0.iter().filter(named).collect()
}

fn place(body: &Body) -> [i64; 4] {
    match *body {
        Body::Circle { c, r } => [c.0, c.1, r, 0],
        Body::Box { lo, hi } => [lo.0, lo.1, hi.0, hi.1],
    }
}

fn moved(backend: &Backend<Case, Answer>, cases: &[Case]) -> Answered {
    let answers = (backend.make)(cases).answers();
    let sum = answers.iter().flatten().fold(START, |sum, body| mixed(sum, &place(body)));
    (backend.name, backend.asked, sum)
}

/// The first corner of each class's level. The body and the motions of each sequence.
pub fn moves() -> File {
    let mut out = File::default();
    for map in MAPS {
        for class in moves::classes(map) {
            let room = Room::new(map, class.origin);
            let cases = class.cases(&room, SEQUENCES);
            let record = |c: &Case| -> Vec<i64> {
                words(&c.start).into_iter().chain(c.motions.iter().flat_map(|m| [m.0, m.1])).collect()
            };
            let records: Vec<_> = cases.iter().map(record).collect();
            let list = backends::all(&room, class.kind);
            let answers = fit(&list).into_iter().map(|b| moved(b, &cases));
            out.class((&moves::name(map), &class.name()), &[room.level.x], &records, answers);
        }
    }
    out
}

/// The size of each level, the side of a cell in pixels, the tiles by their ids, and the cells.
pub fn levels() -> File {
    let mut out = File::default();
    for map in MAPS {
        let level = Room::new(map, 0).level;
        let cell = level.cell >> 16;
        out.text(&moves::name(map));
        out.words([level.width, level.height, cell]);
        out.words(backends::tiles(cell).as_flattened().iter().map(|&word| word.into()));
        out.raw(&level.tiles);
    }
    out
}

fn told(backend: &Backend<scenes::Frame, Vec<(u32, u32)>>, frames: &[scenes::Frame]) -> Answered {
    let answers = (backend.make)(frames).answers();
    let pairs = answers.iter().enumerate().flat_map(|(frame, pairs)| pairs.iter().map(move |&p| pair(frame, p)));
    (backend.name, backend.asked, pairs.fold(0, u32::wrapping_add))
}

/// For each class of at most so many boxes: the size of its world, in raw units and in cells. For
/// each frame: the boxes.
pub fn broad(most: usize) -> File {
    let mut out = File::default();
    // The programs on chips have grids without a list for large boxes.
    let small = scenes::CLASSES.into_iter().filter(|class| class.bodies <= most && !class.has_large());
    for class in small {
        let frames = class.frames(frames_of(class.bodies));
        let record =
            |f: &scenes::Frame| -> Vec<i64> { f.iter().flat_map(|b| [b.lo.0, b.lo.1, b.hi.0, b.hi.1]).collect() };
        let records: Vec<_> = frames.iter().map(record).collect();
        let list = broad::backends(class);
        let answers = fit(&list).into_iter().map(|b| told(b, &frames));
        out.class((broad::NAME, &class.name()), &[class.origin << 16, class.grid_columns().into()], &records, answers);
    }
    out
}
