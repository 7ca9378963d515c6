//! The inputs of microcontrollers: the first inputs of the host, as many as fit beside the code in
//! 256 KiB of flash.

use super::file::File;
use super::frames;
use crate::casts::{self, truth::Truth as Impact};
use crate::pairs::{self, classes::Class};
use crate::rays::{self, level::Level, truth::Truth};
use std::path::Path;
use tilesat_judge::oracle::figure::{Figure, PAIRS};
use tilesat_judge::oracle::measure::Measure;

const PAIR_CLASSES: [Class; 5] = [Class::Hits(50), Class::Boxes, Class::Near, Class::Far, Class::Domain];
const A_CLASS: usize = 64;
/// Beside the cells of three maps, 192 KiB.
const RAYS_A_CLASS: usize = 32;

pub fn words(figure: &Figure) -> [i64; 4] {
    match *figure {
        Figure::Circle { centre, radius } => [centre.0, centre.1, radius, 0],
        Figure::Aabb { min, max } => [min.0, min.1, max.0, max.1],
        Figure::Segment { a, b } => [a.0, a.1, b.0, b.1],
    }
}

fn pairs() -> File {
    let mut out = File::default();
    for kinds in PAIRS {
        for of in PAIR_CLASSES {
            let record = |(a, b): &(Figure, Figure)| {
                let ([p, q, r, s], [t, u, v, w]) = (words(a), words(b));
                [p, q, r, s, t, u, v, w, Measure::new(a, b).overlaps().into()]
            };
            let records: Vec<_> = of.pairs(kinds, A_CLASS).iter().map(record).collect();
            out.queries((pairs::name(kinds), of.name()), &records);
        }
    }
    out
}

fn casts() -> File {
    let mut out = File::default();
    for kinds in casts::classes::KINDS {
        for of in casts::classes::CLASSES {
            let record = |c: &casts::classes::Case| {
                let ([p, q, r, s], [t, u, v, w]) = (words(&c.a), words(&c.b));
                [p, q, r, s, t, u, v, w, c.d.0, c.d.1, Impact::new(c).toi.is_some().into()]
            };
            let records: Vec<_> = of.cases(kinds, A_CLASS).iter().map(record).collect();
            out.queries((&casts::name(kinds), of.name()), &records);
        }
    }
    out
}

/// The rays, and the cells that they cross.
fn rays() -> (File, Vec<u8>) {
    let (mut out, mut cells) = (File::default(), Vec::new());
    for map in rays::level::MAPS {
        let level = Level::new(map);
        for of in rays::classes::CLASSES {
            let record =
                |r: &rays::classes::Ray| [r.o.0, r.o.1, r.d.0, r.d.1, Truth::new(&level, r).closed.is_some().into()];
            let records: Vec<_> = of.rays(&level, RAYS_A_CLASS).iter().map(record).collect();
            out.queries((&rays::name(map), of.name()), &records);
        }
        cells.extend(level.cells);
    }
    (out, cells)
}

/// A file for each part.
///
/// # Errors
/// If it cannot write a file.
pub fn write(folder: &Path) -> Result<(), String> {
    let (rays, cells) = rays();
    let files = [
        ("pairs", pairs().bytes()),
        ("casts", casts().bytes()),
        ("rays", rays.bytes()),
        ("cells", cells),
        ("moves", frames::moves().bytes()),
        ("levels", frames::levels().bytes()),
        ("broad", frames::broad(256).bytes()),
        ("crowds", frames::broad(4096).bytes()),
    ];
    for (name, bytes) in files {
        let file = folder.join(name).with_extension("bin");
        std::fs::write(&file, bytes).map_err(|e| format!("{}: {e}", file.display()))?;
    }
    Ok(())
}
