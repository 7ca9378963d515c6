//! `slides.csv`: boxes that move among blocks and one-way edges, with the exact result if all
//! contacts are at whole raw positions.
//!
//! The first contact of each piece of a motion is the exact judge's. Its position is on the
//! lattice, or the test skips the scene, so nothing is rounded. The rest of the motion goes along
//! the face, back from it, or ends.

use super::table::{Table, bit, pair};
use tilesat::Outside;
use tilesat_judge::Random;
use tilesat_judge::motion::body::Body;
use tilesat_judge::motion::level::Level;
use tilesat_judge::motion::rect::{First, first_one_way, first_solid};
use tilesat_judge::motion::{P, scene};

const RANDOM: usize = 900;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Response {
    Slide,
    Touch,
    Bounce,
}

const RESPONSES: [(&str, Response); 3] =
    [("slide", Response::Slide), ("touch", Response::Touch), ("bounce", Response::Bounce)];

struct Outcome {
    body: Body,
    v: P,
    hits: Vec<P>,
}

/// The whole motion. `None` if a contact is between two raw positions, or there are more than
/// three.
fn exact(level: &Level, start: Body, v: P, response: Response) -> Option<Outcome> {
    let (mut body, mut v, mut rest, mut hits) = (start, v, v, Vec::new());
    while rest != (0, 0) {
        let Some(first) = First::earlier(first_solid(level, &body, rest), first_one_way(level, &body, rest)) else {
            return Some(Outcome { body: body.moved(rest), v, hits });
        };
        let n = first.normal(rest)?;
        let part = |d: i64| {
            let scaled = i128::from(d) * i128::from(first.time.num);
            (scaled % i128::from(first.time.den) == 0).then(|| (scaled / i128::from(first.time.den)) as i64)
        };
        let way = (part(rest.0)?, part(rest.1)?);
        body = body.moved(way);
        hits.push(n);
        let left = (rest.0 - way.0, rest.1 - way.1);
        let turn = |p: P| match response {
            Response::Slide => (if n.0 == 0 { p.0 } else { 0 }, if n.1 == 0 { p.1 } else { 0 }),
            Response::Bounce => (if n.0 == 0 { p.0 } else { -p.0 }, if n.1 == 0 { p.1 } else { -p.1 }),
            Response::Touch => (0, 0),
        };
        (v, rest) = (turn(v), turn(left));
        if hits.len() > 3 {
            return None;
        }
    }
    Some(Outcome { body, v, hits })
}

fn level_text(level: &Level) -> String {
    let row = |tiles: &[u8]| {
        tiles
            .iter()
            .map(|t| {
                if *t == b'o' {
                    '.'
                } else if *t == b'%' {
                    '#'
                } else {
                    char::from(*t)
                }
            })
            .collect::<String>()
    };
    level.tiles.chunks(level.width as usize).map(row).collect::<Vec<_>>().join("/")
}

fn row(
    id: usize,
    source: &str,
    theirs: &str,
    level: &Level,
    body: &Body,
    v: P,
    response: (&str, Response),
) -> Option<Vec<String>> {
    let out = exact(level, *body, v, response.1)?;
    let ((lo, hi), (end, _)) = (body.bounds(), out.body.bounds());
    let faces = |up: fn(&P) -> bool| out.hits.iter().any(up);
    Some(vec![
        id.to_string(),
        source.into(),
        theirs.into(),
        level.cell.to_string(),
        match level.outside {
            Outside::Solid => "solid".into(),
            _ => "empty".into(),
        },
        level_text(level),
        format!("B {} {}", pair(lo), pair(hi)),
        pair(v),
        response.0.into(),
        pair(end),
        pair(out.v),
        out.hits.len().to_string(),
        bit(faces(|n| n.1 < 0)),
        bit(faces(|n| n.0 != 0)),
        bit(faces(|n| n.1 > 0)),
    ])
}

/// Levels of cells of one unit. Positions and motions in units.
fn portable(table: &mut Table) {
    // bump's item at (0,0,8,8), relative to (10,10,2,2). Goals are positions, so the motion is the
    // goal minus the position.
    let mut block = vec!["........................"; 8];
    let rows: Vec<String> =
        block.drain(..).map(|r| format!("########{}", &r[8..])).chain((0..16).map(|_| ".".repeat(24))).collect();
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    let bump = Level::new(&rows, 1 << 16);
    let cases: [(&str, &str, P, &str); 7] = [
        ("bump responses_spec slide down", "end (1 8)", (1, 4), "slide"),
        ("bump responses_spec slide right", "end (8 1)", (4, 1), "slide"),
        ("bump responses_spec perfect corner, slide", "end (8 1)", (1, 1), "slide"),
        ("bump responses_spec touch down", "touch (7 8)", (1, 4), "touch"),
        ("bump responses_spec bounce down", "end (1 12)", (1, 4), "bounce"),
        ("bump responses_spec bounce right", "end (12 1)", (4, 1), "bounce"),
        ("bump responses_spec perfect corner, bounce", "end (15 1)", (1, 1), "bounce"),
    ];
    let units = |p: P| (p.0 << 16, p.1 << 16);
    for (source, theirs, goal, response) in cases {
        let body = Body::rect(units((10, 10)), units((2, 2)));
        let response = *RESPONSES.iter().find(|r| r.0 == response).unwrap();
        let id = table.rows.len();
        table.push(&row(id, source, theirs, &bump, &body, units((goal.0 - 10, goal.1 - 10)), response).unwrap());
    }
    // PixelRoot32's player of 20 x 20 (by its middle) and a platform whose top is y = 40. One
    // changed input per case.
    let platform = Level::new(&["......", "......", ".---..", "......", "......", "......"], 20 << 16);
    let one_way: [(&str, &str, P, P); 9] = [
        ("PixelRoot32 one-way: above, falling", "accept", (50, 30), (0, 5)),
        ("PixelRoot32 one-way: touching, falling", "accept", (50, 30), (0, 1)),
        ("PixelRoot32 one-way: below, falling", "reject", (50, 50), (0, 5)),
        ("PixelRoot32 one-way: below, rising", "reject", (50, 70), (0, -25)),
        ("PixelRoot32 one-way: above, rising", "reject", (50, 30), (0, -5)),
        ("PixelRoot32 one-way: large delta", "accept", (50, 10), (0, 60)),
        ("PixelRoot32 one-way: stationary", "accept", (50, 30), (0, 0)),
        ("PixelRoot32 one-way: beside it", "no contact", (90, 30), (0, 25)),
        ("PixelRoot32 one-way: along it", "slides", (50, 30), (15, 10)),
    ];
    for (source, theirs, middle, v) in one_way {
        let body = Body::rect(units((middle.0 - 10, middle.1 - 10)), units((20, 20)));
        let id = table.rows.len();
        table.push(&row(id, source, theirs, &platform, &body, units(v), RESPONSES[0]).unwrap());
    }
    // Torture scenes 4, 11, 30: a corner of a room, a shared corner, a gap of the body's width.
    let room = Level::new(&["......#", "......#", "......#", "......#", "......#", "......#", "#######"], 16 << 16);
    let gap = Level::new(&["....", "....", "#.##", "#.##", "#.##"], 16 << 16);
    let scenes: [(&str, &Level, P, P, P); 5] = [
        ("torture 4: inside corner", &room, (60, 60), (16, 16), (40, 40)),
        ("torture 4: inside corner, one way longer", &room, (60, 60), (16, 16), (40, 24)),
        ("torture 11: shared corner", &gap, (0, 16), (16, 16), (-1, -1)),
        ("torture 30: gap of its own width, aligned", &gap, (16, 0), (16, 16), (0, 60)),
        ("torture 30: gap of its own width, beside it", &gap, (15, 0), (16, 16), (0, 60)),
    ];
    for (source, level, at, size, v) in scenes {
        let body = Body::rect(units(at), units(size));
        let id = table.rows.len();
        table.push(&row(id, source, "", level, &body, units(v), RESPONSES[0]).unwrap());
    }
}

pub(crate) fn make() -> Table {
    let mut table =
        Table::new("id,source,theirs,cell,outside,tiles,body,motion,response,end,velocity,hits,floor,wall,ceiling");
    portable(&mut table);
    let mut r = Random::new(0x51d3);
    let goal = table.rows.len() + RANDOM;
    while table.rows.len() < goal {
        let cell = if r.one_in(2) { 16 << 16 } else { 256 };
        let (solid, one_way) = (r.within(5, 50), r.within(0, 20));
        let mut level = scene::blocks(&mut r, (6, 5), cell, solid, one_way);
        level.outside = if r.one_in(2) { Outside::Solid } else { Outside::Empty };
        // Lattice sizes and motions, so that most contacts are on the lattice; sixteenths of a
        // cell.
        let unit = cell / 16;
        let body = Body::rect((0, 0), (r.within(1, 24) * unit, r.within(1, 24) * unit));
        let at = (r.within(0, 90) * unit, r.within(0, 76) * unit);
        let body = body.moved(at);
        let k = 1 << r.below(5);
        let v = match r.below(3) {
            0 => (r.around(64) * unit, 0),
            1 => (0, r.around(64) * unit),
            _ => (r.around(64 / k) * unit * k, r.around(64 / k) * unit * k),
        };
        let response = RESPONSES[r.below(3) as usize];
        if level.overlaps(&body) {
            continue;
        }
        if let Some(row) = row(table.rows.len(), "random", "", &level, &body, v, response) {
            table.push(&row);
        }
    }
    table
}
