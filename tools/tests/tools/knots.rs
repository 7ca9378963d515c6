//! Collision polygons of tiles that cross themselves: both parts are solid, and no part is a hole.

use tilesat_tools::bake;
use tilesat_tools::read::load;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::kind::Kind;
use tilesat_tools::rules::options::Options;

use crate::support::{map, scratch};

/// A map whose first tile has this polygon, and the second one another one below it.
fn ground(polygon: &str, below: &str) -> Result<Ground, String> {
    let drawn = |id: u32, points: &str| {
        format!(
            r#"<tile id="{id}"><objectgroup><object id="1" x="0" y="0"><polygon points="{points}"/></object></objectgroup></tile>"#
        )
    };
    let text = map(4, 3, "0,0,0,0,0,1,0,0,0,0,0,0", "")
        .replace(r#"<tile id="0" type="Solid"/><tile id="1" type="OneWay"/>"#, &(drawn(0, polygon) + &drawn(1, below)))
        .replace(" <layer", "<layer name=\"low\" width=\"4\" height=\"3\"><data encoding=\"csv\">0,0,0,0,0,2,0,0,0,0,0,0</data></layer><layer");
    let text = if below.is_empty() { text.replace("0,2,0", "0,0,0") } else { text };
    let levels = load(&scratch("knots", "level.tmx", text), None).unwrap();
    Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).map_err(|fail| fail.to_string())
}

/// Corners in pixels, the least first.
fn solids(ground: &Ground) -> Vec<Vec<(i64, i64)>> {
    assert!(ground.outlines.iter().all(|outline| outline.kind == Kind::Solid), "{:?}", ground.outlines);
    let sorted = |points: &Vec<(i64, i64)>| {
        let mut points: Vec<(i64, i64)> = points.iter().map(|p| (p.0 >> 16, p.1 >> 16)).collect();
        points.sort_unstable();
        points
    };
    let mut all: Vec<_> = ground.outlines.iter().map(|outline| sorted(&outline.points)).collect();
    all.sort();
    all
}

#[test]
fn both_parts_are_solid() {
    let upright = [vec![(16, 16), (24, 24), (32, 16)], vec![(16, 32), (24, 24), (32, 32)]];
    let sideways = [vec![(16, 16), (16, 32), (24, 24)], vec![(24, 24), (32, 16), (32, 32)]];
    for (points, expected) in [("0,0 16,0 0,16 16,16", upright), ("0,0 16,16 16,0 8,8 0,16", sideways)] {
        let ground = ground(points, "").unwrap();
        assert_eq!(solids(&ground), expected, "{points}");
        let note = "2 polygons are parts of collision polygons that cross themselves, the first in layer 'World' at (";
        assert!(ground.notes.iter().any(|line| line.starts_with(note)), "{:?}", ground.notes);
    }
}

/// Its parts touch, and have one direction.
#[test]
fn an_hourglass_is_drawn_in_order() {
    let ground = ground("0,0 8,8 0,16 16,16 8,8 16,0", "").unwrap();
    assert_eq!(solids(&ground).len(), 2);
    assert!(ground.notes.is_empty(), "{:?}", ground.notes);
}

/// No part takes something away from the tile below.
#[test]
fn over_another_solid() {
    let ground = ground("0,0 16,16 16,0 0,16", "1,0 15,0 15,15 1,15").unwrap();
    assert_eq!(solids(&ground).len(), 3);
}

/// A shape of the library stays one, though a corner is drawn twice and crosses its neighbour.
#[test]
fn a_crossing_that_nobody_sees() {
    let ground = ground("0,0 16,0 16,16 0,16.05 0,15.95 0.05,16", "").unwrap();
    assert!(ground.outlines.is_empty() && ground.notes.is_empty(), "{ground:?}");
}

#[test]
fn an_inside_that_is_not_clear() {
    let why = ground("0,0 0,16 16,0 16,8 14,8 12,7.5 12,8.5 14,8 16,8 16,16", "").unwrap_err();
    assert!(why.contains("layer 'World': a collision polygon of its tile at (16, 16) crosses itself"), "{why}");
}

/// The same for a tile as an object.
#[test]
fn tiles_as_objects() {
    let ground = |polygon: &str| {
        let drawn = format!(
            r#"<tile id="0"><objectgroup><object id="1" x="0" y="0"><polygon points="{polygon}"/></object></objectgroup></tile>"#
        );
        let text = map(1, 1, "0", r#"<object id="7" gid="1" x="16" y="32" width="16" height="16"/>"#)
            .replace(r#"<tile id="0" type="Solid"/>"#, &drawn);
        let levels = load(&scratch("knots", "stamp.tmx", text), None).unwrap();
        let ground = Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default());
        bake::bake(&levels.maps, &bake::Settings::default()).map_err(|fail| fail.to_string())?;
        ground.map_err(|fail| fail.to_string())
    };
    let upright = [vec![(16, 16), (24, 24), (32, 16)], vec![(16, 32), (24, 24), (32, 32)]];
    let found = ground("0,0 16,0 0,16 16,16").unwrap();
    assert_eq!(solids(&found), upright);
    let note = "object 7 of layer 'L': the collision polygon of its tile crosses itself, and each part counts";
    assert!(found.notes.iter().any(|line| line.starts_with(note)), "{:?}", found.notes);
    // A star is solid in its middle, too, which counts twice.
    let star = solids(&ground("8,0 13,16 0,6 16,6 3,16").unwrap());
    assert!(star.len() > 1 && star.iter().any(|part| part.contains(&(24, 16))), "{star:?}");
    let plain = ground("0,0 16,0 16,16 0,16").unwrap();
    assert!(plain.notes.is_empty() && solids(&plain).len() == 1, "{:?}", plain.notes);
    let why = ground("0,0 0,16 16,0 16,8 14,8 12,7.5 12,8.5 14,8 16,8 16,16").unwrap_err();
    assert!(why.contains("object 7: the collision polygon of its tile 0 crosses itself"), "{why}");
}
