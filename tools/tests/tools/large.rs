//! Tiles larger or smaller than a cell, and tiles of several shapes: all that the editor draws is
//! there, as cells or as polygons.

use tilesat::TileShape;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::options::Options;
use tilesat_tools::{bake, read};

use crate::support::scratch;

type Corners = Vec<(i64, i64)>;

fn ground(name: &str, text: &str) -> Ground {
    let levels = read::load(&scratch("large", name, text), None).unwrap();
    Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).unwrap()
}

/// A map of 8 x 6 cells of 16 pixels, with this tileset, tiles at these cells, and objects.
fn map(tileset: &str, placed: &[(usize, usize, u32)], objects: &str) -> String {
    let mut cells = vec!["0".to_owned(); 48];
    for &(x, y, gid) in placed {
        cells[8 * y + x] = gid.to_string();
    }
    format!(
        r#"<map version="1.10" orientation="orthogonal" width="8" height="6" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="t" tilecount="4" columns="4" {tileset}</tileset>
 <layer id="1" name="tiles" width="8" height="6"><data encoding="csv">{}</data></layer>
 <objectgroup id="2" name="things">{objects}</objectgroup>
</map>"#,
        cells.join(",")
    )
}

/// The cells of which this is true, by column and row.
fn cells(ground: &Ground, is: impl Fn(&tilesat::TileKind) -> bool) -> Vec<(usize, usize)> {
    let width = usize::from(ground.width);
    ground.cells.iter().enumerate().filter(|(_, kind)| is(kind)).map(|(i, _)| (i % width, i / width)).collect()
}

fn full(ground: &Ground) -> Vec<(usize, usize)> {
    cells(ground, |kind| kind.shape == TileShape::Full)
}

/// The corners of each outline in tenths of a pixel, sorted.
fn corners(ground: &Ground) -> Vec<Corners> {
    let tenths = |raw: i64| (raw * 10 + 32768).div_euclid(65536);
    let sorted = |points: &Corners| {
        let mut points: Corners = points.iter().map(|p| (tenths(p.0), tenths(p.1))).collect();
        points.sort_unstable();
        points
    };
    let mut all: Vec<Corners> = ground.outlines.iter().map(|outline| sorted(&outline.points)).collect();
    all.sort_unstable();
    all
}

/// The corners of a box of these pixels.
fn square(x: i64, y: i64, w: i64, h: i64) -> Corners {
    [(x, y), (x, y + h), (x + w, y), (x + w, y + h)].map(|p| (p.0 * 10, p.1 * 10)).to_vec()
}

const LARGE: &str = r#"tilewidth="32" tileheight="32""#;

/// Beyond the grid no cell can hold them.
#[test]
fn parts_beyond_the_grid_are_polygons() {
    let set = format!(r#"{LARGE}><tile id="0" type="Solid"/>"#);
    let found = ground("edge.tmx", &map(&set, &[(2, 0, 1), (7, 4, 1)], ""));
    assert_eq!(full(&found), [(2, 0), (3, 0), (7, 3), (7, 4)]);
    assert_eq!(corners(&found), [square(32, -16, 32, 16), square(128, 48, 16, 32)]);
    // In a corner, it is one polygon.
    let found = ground("corner.tmx", &map(&set, &[(7, 0, 1)], ""));
    let corner = [(112, -16), (144, -16), (144, 16), (128, 16), (128, 0), (112, 0)].map(|p| (p.0 * 10, p.1 * 10));
    let mut corner = corner.to_vec();
    corner.sort_unstable();
    assert_eq!((full(&found), corners(&found)), (vec![(7, 0)], vec![corner]));
    // With its flags.
    let set = format!(
        r#"{LARGE}><tile id="0" type="Solid"><properties><property name="Kill" type="bool" value="true"/></properties></tile>"#
    );
    let found = ground("flags.tmx", &map(&set, &[(2, 0, 1)], ""));
    assert_eq!(found.outlines[0].flags, ["Kill"]);
    assert_eq!(cells(&found, |kind| kind.flags != 0), [(2, 0), (3, 0)]);
}

#[test]
fn flags_cover_the_tile() {
    let block = vec![(2, 2), (3, 2), (2, 3), (3, 3)];
    let kill = r#"<properties><property name="Kill" type="bool" value="true"/></properties>"#;
    let solid = r#"<tile id="1" type="Solid"/>"#;
    for (name, tile, size, wanted) in [
        ("class.tmx", r#"<tile id="0" type="Kill"/>"#.to_owned(), (32, 32), block.clone()),
        ("solid.tmx", format!(r#"<tile id="0" type="Solid">{kill}</tile>"#), (32, 32), block),
        ("small.tmx", r#"<tile id="0" type="Kill"/>"#.to_owned(), (8, 8), vec![(2, 3)]),
        ("high.tmx", r#"<tile id="0" type="Kill"/>"#.to_owned(), (16, 30), vec![(2, 2), (2, 3)]),
    ] {
        let set = format!(r#"tilewidth="{}" tileheight="{}">{tile}{solid}"#, size.0, size.1);
        let found = ground(name, &map(&set, &[(2, 3, 1), (5, 5, 2)], ""));
        assert_eq!(cells(&found, |kind| kind.flags != 0), wanted, "{name}");
    }
}

/// No cell and no polygon holds a flag beyond the map.
#[test]
fn flags_beyond_the_map_are_reported() {
    let set = format!(r#"{LARGE}><tile id="0" type="ladder"/><tile id="1" type="Solid"/>"#);
    let line = "flags of 2 tiles of layer 'tiles' beyond the cells of the map: no output has them";
    let found = ground("lost.tmx", &map(&set, &[(2, 0, 1), (7, 3, 1), (4, 4, 2)], ""));
    assert!(found.unused.iter().any(|unused| unused.starts_with(line)), "{:?}", found.unused);
    assert_eq!(cells(&found, |kind| kind.flags != 0), [(2, 0), (3, 0), (7, 2), (7, 3)]);
    let found = ground("kept.tmx", &map(&set, &[(2, 1, 1), (4, 4, 2)], ""));
    assert_eq!(found.unused, Vec::<String>::new());
}

/// Cells of 16x24 pixels are 2x3 cells of 8. Tiles that are drawn as large as one fill it.
#[test]
fn tiles_as_large_as_cells_that_are_not_square() {
    let of = |set: &str, gid: u32| {
        let text = map(set, &[(2, 1, gid)], "");
        let text = text.replacen(r#"tilewidth="16" tileheight="16""#, r#"tilewidth="16" tileheight="24""#, 1);
        let deco = r#"<tileset firstgid="9" name="deco" tilewidth="20" tileheight="20" tilerendersize="grid"/>"#;
        text.replace("<tileset firstgid=\"1\"", &format!("{deco}<tileset firstgid=\"1\""))
    };
    let block: Vec<(usize, usize)> = (3..6).flat_map(|y| [(4, y), (5, y)]).collect();
    let solid = r#"<tile id="0" type="Solid"/>"#;
    let fit = r#"tilerendersize="grid" fillmode="preserve-aspect-fit""#;
    for set in [
        r#"tilewidth="16" tileheight="24""#,
        r#"tilewidth="16" tileheight="24" tilerendersize="grid""#,
        r#"tilewidth="32" tileheight="48" tilerendersize="grid""#,
        r#"tilewidth="10" tileheight="10" tilerendersize="grid""#,
        &format!(r#"tilewidth="8" tileheight="12" {fit}"#),
    ] {
        let found = ground("cell.tmx", &of(&format!("{set}>{solid}"), 1));
        assert_eq!((full(&found), corners(&found)), (block.clone(), vec![]), "{set}");
    }
    // What is left of the cell is on both sides.
    for (size, wanted) in
        [("\"32\" tileheight=\"32\"", square(32, 28, 16, 16)), ("\"6\" tileheight=\"12\"", square(34, 24, 12, 24))]
    {
        let found = ground("aspect.tmx", &of(&format!(r"tilewidth={size} {fit}>{solid}"), 1));
        assert_eq!(corners(&found), [wanted], "{size}");
    }
    let ramp = r#"<tile id="0"><objectgroup><object id="1" x="0" y="48"><polygon points="0,0 32,-48 32,0"/></object></objectgroup></tile>"#;
    let found = ground("ramp.tmx", &of(&format!(r#"tilewidth="32" tileheight="48" tilerendersize="grid">{ramp}"#), 1));
    assert_eq!(corners(&found), [[(320, 480), (480, 240), (480, 480)]]);
    // Nobody says where a turned one lies.
    let turned = 1 | 1 << 29;
    let text = of(&format!(r#"tilewidth="32" tileheight="48" tilerendersize="grid">{solid}"#), turned);
    let why = read::load(&scratch("large", "turned.tmx", text), None).unwrap_err().to_string();
    assert!(why.contains("tile 0 of tileset 't' is turned") && why.contains("Tile Render Size"), "{why}");
    let text = of(&format!(r#"tilewidth="16" tileheight="24" tilerendersize="grid">{solid}"#), turned);
    assert_eq!(corners(&ground("own.tmx", &text)), Vec::<Corners>::new());
}

/// A box as large as the tile covers only what lies on it.
#[test]
fn a_full_box_and_other_shapes() {
    let box_of = |more: &str| format!(r#"<object id="1" x="0" y="0" width="16" height="16"/>{more}"#);
    let of = |more: &str| {
        let tile = format!(r#"<tile id="0"><objectgroup>{}</objectgroup></tile>"#, box_of(more));
        ground("box.tmx", &map(&format!(r#"tilewidth="16" tileheight="16">{tile}"#), &[(2, 3, 1)], ""))
    };
    let ledge = r#"<object id="2" x="16" y="0" width="8" height="4"/>"#;
    let found = of(ledge);
    assert_eq!((full(&found), corners(&found)), (vec![(2, 3)], vec![square(48, 48, 8, 4)]));
    let found = of(r#"<object id="2" x="4" y="4" width="8" height="4"/>"#);
    assert_eq!((full(&found), corners(&found)), (vec![(2, 3)], vec![]));
    let found = of(r#"<object id="2" type="Hole" x="4" y="4" width="8" height="4"/>"#);
    assert_eq!((full(&found), corners(&found)), (vec![], vec![square(32, 48, 16, 16), square(36, 52, 8, 4)]));
}

/// `LDtk` draws a tile at its own size, from the upper left corner of its cell.
#[test]
fn large_tiles_of_a_project() {
    let text = |side: u32| {
        format!(
            r#"{{"__header__":{{"app":"LDtk"}},"defs":{{"layers":[{{"uid":2,"intGridValues":[]}}],"tilesets":[{{"uid":7,"identifier":"S","pxWid":64,"pxHei":64,"tileGridSize":{side},"spacing":0,"padding":0,"enumTags":[{{"enumValueId":"Solid","tileIds":[0]}}]}}]}},"levels":[{{"identifier":"One","worldX":0,"worldY":0,"pxWid":128,"pxHei":96,"layerInstances":[{{"__type":"Tiles","__identifier":"T","__cWid":8,"__cHei":6,"__gridSize":16,"__tilesetDefUid":7,"layerDefUid":2,"gridTiles":[{{"px":[32,48],"src":[0,0],"f":0,"t":0}}]}}]}}]}}"#
        )
    };
    for (side, cells, outlines) in [
        (16, vec![(2, 3)], vec![]),
        (32, vec![(2, 3), (3, 3), (2, 4), (3, 4)], vec![]),
        (8, vec![], vec![square(32, 48, 8, 8)]),
    ] {
        let found = ground(&format!("s{side}.ldtk"), &text(side));
        assert_eq!((full(&found), corners(&found)), (cells, outlines), "{side}");
    }
}

/// Tiled fits the picture into the cell or the object, and centres it.
#[test]
fn pictures_that_keep_their_aspect() {
    let ramp = r#"<tile id="1"><objectgroup><object id="1" x="0" y="48"><polygon points="0,0 24,-48 24,0"/></object></objectgroup></tile>"#;
    let of = |size: (u32, u32), placed: &[(usize, usize, u32)], objects: &str| {
        let (w, h) = size;
        let set = format!(
            r#"tilewidth="{w}" tileheight="{h}" tilerendersize="grid" fillmode="preserve-aspect-fit"><tile id="0" type="Solid"/>{ramp}"#
        );
        ground("aspect.tmx", &map(&set, placed, objects))
    };
    let high = (24, 48);
    assert_eq!(corners(&of(high, &[(2, 3, 1)], "")), [square(36, 48, 8, 16)]);
    assert_eq!(corners(&of((48, 24), &[(2, 3, 1)], "")), [square(32, 52, 16, 8)]);
    assert_eq!(full(&of((32, 32), &[(2, 3, 1)], "")), [(2, 3)]);
    assert_eq!(corners(&of((20, 32), &[(2, 3, 1)], "")), [square(35, 48, 10, 16)]);
    // Turned, with the drawn shape.
    assert_eq!(corners(&of(high, &[(2, 3, 2)], "")), [[(360, 640), (440, 480), (440, 640)]]);
    let turned = 1 | 1 << 29;
    assert_eq!(corners(&of(high, &[(2, 3, turned)], "")), [square(32, 52, 16, 8)]);
    let object =
        |gid: u32| format!(r#"<object id="1" gid="{gid}" type="Solid" x="32" y="64" width="48" height="48"/>"#);
    assert_eq!(corners(&of(high, &[], &object(1))), [square(44, 16, 24, 48)]);
    assert_eq!(corners(&of(high, &[], &object(2))), [[(440, 640), (680, 160), (680, 640)]]);
    let stretched = map(
        r#"tilewidth="24" tileheight="48" tilerendersize="grid" fillmode="stretch"><tile id="0" type="Solid"/>"#,
        &[(2, 3, 1)],
        "",
    );
    assert_eq!(full(&ground("stretch.tmx", &stretched)), [(2, 3)]);
    let odd = stretched.replace("fillmode=\"stretch\"", "fillmode=\"fit\"");
    let why = read::load(&scratch("large", "odd.tmx", odd), None).unwrap_err().to_string();
    assert!(why.contains("tileset 't': fillmode 'fit' is unknown"), "{why}");
}

/// Inside and outside change places where a polygon crosses itself.
#[test]
fn polygons_that_cross_themselves_are_refused() {
    let polygon =
        r#"<object id="7" name="bow" type="Solid" x="8" y="8"><polygon points="0,0 60,30 60,0 0,10"/></object>"#;
    let text = map(r#"tilewidth="16" tileheight="16">"#, &[], polygon);
    let levels = read::load(&scratch("large", "bow.tmx", text), None).unwrap();
    let why = bake::bake(&levels.maps, &bake::Settings::default()).unwrap_err().to_string();
    for part in ["object 7 'bow' of layer 'things'", "crosses itself at (23, 15.5)", "two polygons"] {
        assert!(why.contains(part), "{part} is not in {why}");
    }
    let cut = tilesat_tools::rooms::Cut { room: Some((4, 3)), ..Default::default() };
    let why = tilesat_tools::rooms::bake(&levels.maps, &Options::default(), &cut).unwrap_err().to_string();
    assert!(why.contains("crosses itself at (23, 15.5)"), "{why}");
}
