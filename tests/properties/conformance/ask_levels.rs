//! Runs every row of levels and of motion in them through the library.

use super::levels::DIGITS;
use super::stored;
use super::table::Row;
use std::collections::HashMap;
use tilesat::{Axis, Inside, Mover, Outside, Response, world::RayRules};
use tilesat_judge::motion::body::Body;
use tilesat_judge::motion::level::Level as Blocks;
use tilesat_judge::oracle::figure::Figure;
use tilesat_judge::oracle::kernel::{aabb, circle, vec2};
use tilesat_judge::rays::level::Level;

fn outside(row: &Row<'_>) -> Outside {
    match row.text("outside") {
        "empty" => Outside::Empty,
        "solid" => Outside::Solid,
        _ => Outside::Edge,
    }
}

fn levels() -> HashMap<i64, Level> {
    let mut all = HashMap::new();
    stored("levels.csv").each(|row| {
        let rows: Vec<&str> = row.text("tiles").split('/').collect();
        let id = |c: u8| DIGITS.iter().position(|d| *d == c).unwrap() as u8;
        let level = Level {
            width: rows[0].len() as i64,
            height: rows.len() as i64,
            cell: row.number("cell"),
            origin: row.point("origin"),
            outside: outside(&row),
            tiles: rows.iter().flat_map(|r| r.bytes().map(id)).collect(),
        };
        all.insert(row.number("level"), level);
    });
    all
}

#[test]
fn rays_in_levels() {
    let levels = levels();
    stored("tile_rays.csv").each(|row| {
        let level = &levels[&row.number("level")];
        let map = level.map();
        let (o, d) = (row.point("from"), row.point("motion"));
        let rules = RayRules { inside: Inside::Ignore, one_way: row.yes("one_way") };
        let within = map.cast_ray(vec2(o), vec2(d), RayRules { inside: Inside::Hit, ..rules }).unwrap();
        assert_eq!(within.is_some_and(|h| h.inside), row.yes("inside"), "{row:?}");
        if row.yes("inside") {
            return;
        }
        let hit = map.cast_ray(vec2(o), vec2(d), rules).unwrap();
        assert_eq!(hit.is_some(), row.yes("hit"), "{row:?}");
        let Some(hit) = hit else { return };
        let (raw, toi) = (i64::from(hit.toi.raw()), row.number("toi30"));
        if let Some(&n) = row.points("normal").first() {
            // A straight face or an end of an arc.
            assert_eq!((raw, (i64::from(hit.axis.x), i64::from(hit.axis.y))), (toi, n), "{row:?}");
        } else {
            // Within an arc a lower bound, less than four raw units of way early.
            let early = i128::from(toi - raw).pow(2) * (i128::from(d.0).pow(2) + i128::from(d.1).pow(2));
            assert!(raw <= toi && early < 1 << 64, "{raw}: {row:?}");
        }
        if !row.text("cell").is_empty() {
            assert_eq!((i64::from(hit.cell.x), i64::from(hit.cell.y)), row.point("cell"), "{row:?}");
        }
    });
}

#[test]
fn bodies_in_levels() {
    let levels = levels();
    stored("tile_bodies.csv").each(|row| {
        let map = levels[&row.number("level")].map();
        let (overlaps, touches) = match row.figure("body") {
            Figure::Aabb { min, max } => (map.overlaps(&aabb(min, max)), map.touches(&aabb(min, max))),
            Figure::Circle { centre, radius } => {
                (map.overlaps(&circle(centre, radius)), map.touches(&circle(centre, radius)))
            }
            Figure::Segment { .. } => panic!("{row:?}"),
        };
        assert_eq!((overlaps, touches), (row.yes("overlaps"), row.yes("touches")), "{row:?}");
    });
}

#[test]
fn motion_in_blocks() {
    stored("slides.csv").each(|row| {
        let rows: Vec<&str> = row.text("tiles").split('/').collect();
        let level = Blocks::new(&rows, row.number("cell")).with_outside(outside(&row));
        let Figure::Aabb { min, max } = row.figure("body") else { panic!("{row:?}") };
        let body = Body::rect(min, (max.0 - min.0, max.1 - min.1));
        let response = match row.text("response") {
            "slide" => Response::Slide,
            "touch" => Response::Touch,
            _ => Response::Bounce,
        };
        let mover = Mover::platformer(Axis::NEG_Y).with_response(response);
        let out = body.step(&mover, &level.map(), row.point("motion")).unwrap();
        assert_eq!((out.body.position(), out.v), (row.point("end"), row.point("velocity")), "{row:?}");
        assert_eq!(out.hits.len() as i64, row.number("hits"), "{row:?}");
        assert_eq!(
            (out.floor, out.wall, out.ceiling),
            (row.yes("floor"), row.yes("wall"), row.yes("ceiling")),
            "{row:?}"
        );
    });
}

/// The row also has the slide that their tests expect, in units.
#[test]
fn ends_of_other_engines() {
    let mut seen = 0;
    stored("slides.csv").each(|row| {
        let theirs = row.text("theirs");
        let Some(at) = theirs.split_once('(').map(|t| t.1.trim_end_matches(')')) else { return };
        let n: Vec<i64> = at.split(' ').map(|n| n.parse::<i64>().unwrap() << 16).collect();
        assert_eq!(row.point("end"), (n[0], n[1]), "{row:?}");
        seen += 1;
    });
    assert_eq!(seen, 7);
}
