//! Layers of `LDtk`: where it draws tiles and entities, and what the report says of them.

use tilesat_tools::read;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::options::Options;

use crate::support::scratch;

/// A project of one level of 8 x 8 cells of 16 pixels. Its tileset has tiles of this side, and all
/// of them are solid.
fn project(layers: &str, definition: &str, side: u32) -> String {
    let ids: Vec<String> = (0..16).map(|id| id.to_string()).collect();
    format!(
        r#"{{"jsonVersion":"1.5.3","defs":{{"layers":[{{"uid":2,{definition}"intGridValues":[{{"value":1,"identifier":"Full"}}]}}],
        "tilesets":[{{"uid":1,"identifier":"T","pxWid":128,"pxHei":128,"tileGridSize":{side},"spacing":0,"padding":0,
        "enumTags":[{{"enumValueId":"Solid","tileIds":[{}]}}]}}]}},
        "levels":[{{"identifier":"One","pxWid":128,"pxHei":128,"layerInstances":[{layers}]}}]}}"#,
        ids.join(",")
    )
}

/// A layer of this type and this member.
fn layer(form: &str, offset: (i32, i32), member: &str) -> String {
    format!(
        r#"{{"__type":"{form}","__identifier":"Solid","__cWid":8,"__cHei":8,"__gridSize":16,"__pxTotalOffsetX":{},"__pxTotalOffsetY":{},
        "__tilesetDefUid":1,"layerDefUid":2,{member}}}"#,
        offset.0, offset.1
    )
}

fn ground(name: &str, text: &str) -> Ground {
    let levels = read::load(&scratch("ldtk", &format!("{name}.ldtk"), text), None).unwrap();
    Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).unwrap()
}

/// The box around everything solid, in halves of a pixel.
fn extent(ground: &Ground) -> [i64; 4] {
    let mut points: Vec<(i64, i64)> = ground.outlines.iter().flat_map(|outline| outline.points.clone()).collect();
    let side = i64::from(ground.tile) << 16;
    for (index, _) in ground.cells.iter().enumerate().filter(|(_, kind)| **kind == tilesat::TileKind::FULL) {
        let (column, row) = ((index % usize::from(ground.width)) as i64, (index / usize::from(ground.width)) as i64);
        let corner = (i64::from(ground.origin.0) + column * side, i64::from(ground.origin.1) + row * side);
        points.extend([corner, (corner.0 + side, corner.1 + side)]);
    }
    let along = |of: fn(&(i64, i64)) -> i64| points.iter().map(of);
    [along(|p| p.0).min(), along(|p| p.1).min(), along(|p| p.0).max(), along(|p| p.1).max()].map(|v| v.unwrap() >> 15)
}

/// The extent that `LDtk` draws, from `display.LayerRender` of its version 1.5.3.
#[test]
fn tiles_lie_where_ldtk_draws_them() {
    // The member, the pivot, the side of a tile, the flips, and left, top, right and bottom of the
    // tile in column 3, row 4, in pixels.
    let (grid, auto) = ("gridTiles", "autoLayerTiles");
    for (member, pivot, side, flips, wanted) in [
        (grid, (0.0, 0.0), 16, 0, [48, 64, 64, 80]),
        (grid, (0.0, 0.0), 32, 0, [48, 64, 80, 96]),
        // The pivot of the picture is on that of the cell.
        (grid, (0.5, 0.5), 32, 0, [40, 56, 72, 88]),
        (grid, (1.0, 1.0), 32, 0, [32, 48, 64, 80]),
        (grid, (0.5, 0.5), 8, 0, [52, 68, 60, 76]),
        (grid, (1.0, 1.0), 8, 0, [56, 72, 64, 80]),
        (grid, (0.5, 0.5), 16, 0, [48, 64, 64, 80]),
        // A flipped picture ends where its cell does.
        (grid, (0.0, 0.0), 32, 1, [32, 64, 64, 96]),
        (grid, (0.0, 0.0), 32, 3, [32, 48, 64, 80]),
        (grid, (0.0, 0.0), 8, 2, [48, 72, 56, 80]),
        (grid, (0.5, 0.5), 16, 1, [64, 64, 80, 80]),
        // The x pivot of the cell counts in both directions.
        (grid, (0.5, 1.0), 16, 0, [48, 56, 64, 72]),
        (grid, (0.0, 1.0), 32, 0, [48, 32, 80, 64]),
        // Rules have their pictures from the corner on.
        (auto, (0.0, 0.0), 16, 3, [48, 64, 64, 80]),
        (auto, (0.0, 0.0), 32, 1, [32, 64, 64, 96]),
        (auto, (0.5, 1.0), 16, 0, [56, 80, 72, 96]),
    ] {
        let definition = format!(r#""tilePivotX":{},"tilePivotY":{},"#, pivot.0, pivot.1);
        let tile = format!(r#""{member}":[{{"px":[48,64],"src":[0,0],"f":{flips},"t":1}}]"#);
        let found = ground("pivot", &project(&layer("Tiles", (0, 0), &tile), &definition, side));
        let wanted: [i64; 4] = wanted.map(|v: i64| 2 * v);
        assert_eq!(extent(&found), wanted, "{member} {pivot:?} {side} {flips}");
        // Programs that follow the documentation draw a tile from its pivot, flipped or not.
        let corner = |at: f64, pivot: f64| (2.0 * (at + pivot * (16.0 - f64::from(side)))) as i64;
        let documented = (corner(48.0, pivot.0), corner(64.0, pivot.1)) == (wanted[0], wanted[1]);
        let noted = found.notes.iter().any(|note| note.contains("LDtk draws 1 of its tiles elsewhere"));
        assert_eq!(noted, !documented, "{:?}", found.notes);
        // An offset of the layer moves all of them.
        let moved = ground("moved", &project(&layer("Tiles", (16, -32), &tile), &definition, side));
        let [left, top, right, bottom] = wanted;
        assert_eq!(extent(&moved), [left + 32, top - 64, right + 32, bottom - 64]);
    }
}

/// An entity's own point is its pivot.
#[test]
fn entities_lie_around_their_pivot() {
    for (pivot, wanted) in [("0,0", [40, 72, 64, 112]), ("0.5,1", [28, 32, 52, 72]), ("1,0.5", [16, 52, 40, 92])] {
        let entity = format!(
            r#""entityInstances":[{{"__identifier":"Solid","__pivot":[{pivot}],"px":[40,72],"width":24,"height":40}}]"#
        );
        let found = ground("entity", &project(&layer("Entities", (0, 0), &entity), "", 16));
        assert_eq!(extent(&found), wanted.map(|v: i64| 2 * v), "{pivot}");
        let moved = ground("entities", &project(&layer("Entities", (8, 4), &entity), "", 16));
        let [left, top, right, bottom] = wanted.map(|v: i64| 2 * v);
        assert_eq!(extent(&moved), [left + 16, top + 8, right + 16, bottom + 8], "{pivot}");
    }
}

#[test]
fn hidden_layers_of_solid_entities_are_noted() {
    let entity = r#""visible":false,"entityInstances":[{"__identifier":"Solid","__pivot":[0,0],"px":[0,0],"width":16,"height":16}]"#;
    let found = ground("hidden", &project(&layer("Entities", (0, 0), entity), "", 16));
    assert!(found.notes.iter().any(|note| note.starts_with("layer 'Solid' is hidden")), "{:?}", found.notes);
}

/// Nine tiles in one cell: one too many.
#[test]
fn tiles_that_are_not_read_are_noted() {
    let tiles = [r#"{"px":[48,64],"src":[0,0],"f":0,"t":1}"#; 9].join(",");
    let found = ground("pile", &project(&layer("Tiles", (0, 0), &format!(r#""gridTiles":[{tiles}]"#)), "", 16));
    let note =
        "layer 'Solid': 1 tiles lie over 8 others in their cells, and are not read; the first is in column 3, row 4";
    assert!(found.notes.iter().any(|line| line.starts_with(note)), "{:?}", found.notes);
}
