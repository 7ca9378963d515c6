//! Tiles as objects, and the drawing offset of their tileset.

use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::kind::Kind;
use tilesat_tools::rules::options::Options;
use tilesat_tools::{bake, read};

use crate::support::scratch;

/// A map of 16 pixels per cell with one tileset, a tile layer of 4 x 4 cells and objects. Tile 0 is
/// solid, and tile 1 has a ramp from the lower left to the upper right in the collision editor.
fn map(tileset: &str, offset: (i32, i32), csv: &str, list: &str) -> String {
    format!(
        r#"<map version="1.10" orientation="orthogonal" width="4" height="4" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="t" tilecount="4" columns="4" {tileset}><tileoffset x="{}" y="{}"/>
  <tile id="0" type="Solid"/>
  <tile id="1"><objectgroup><object id="1" x="0" y="16"><polygon points="0,0 16,-16 16,0"/></object></objectgroup></tile>
 </tileset>
 <layer id="1" name="tiles" width="4" height="4"><data encoding="csv">{csv}</data></layer>
 <objectgroup id="2" name="things">{list}</objectgroup>
</map>"#,
        offset.0, offset.1
    )
}

const NOTHING: &str = "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0";
/// A solid tile in the second cell of the second row.
const ONE: &str = "0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0";
const PLAIN: &str = r#"tilewidth="16" tileheight="16""#;

fn ground(name: &str, text: &str, options: &Options) -> Ground {
    let levels = read::load(&scratch("stamps", &format!("{name}.tmx"), text), None).unwrap();
    Ground::of(&levels.maps[0], options, &mut Flags::default()).unwrap()
}

/// The corners of each outline in pixels, in the order of their coordinates.
fn corners(ground: &Ground) -> Vec<Vec<(i64, i64)>> {
    let of_outline = |points: &Vec<(i64, i64)>| {
        assert!(points.iter().all(|p| p.0 % 65536 == 0 && p.1 % 65536 == 0), "{points:?}");
        let mut points: Vec<_> = points.iter().map(|p| (p.0 >> 16, p.1 >> 16)).collect();
        points.sort_unstable();
        points
    };
    ground.outlines.iter().map(|outline| of_outline(&outline.points)).collect()
}

/// Tiled draws an object of a tile at its point, plus the alignment, plus the offset times the size
/// of the object over that of the picture, and turns all of it around the point.
#[test]
fn offsets_move_objects() {
    let object =
        |more: &str| format!(r#"<object id="1" gid="1" type="Solid" x="100" y="50" width="32" height="16" {more}/>"#);
    for (align, turn, wanted) in [
        ("", "", [(108, 28), (108, 44), (140, 28), (140, 44)]),
        ("bottomleft", "", [(108, 28), (108, 44), (140, 28), (140, 44)]),
        ("topleft", "", [(108, 44), (108, 60), (140, 44), (140, 60)]),
        ("center", "", [(92, 36), (92, 52), (124, 36), (124, 52)]),
        ("", r#"rotation="90""#, [(106, 58), (106, 90), (122, 58), (122, 90)]),
        ("", r#"rotation="180""#, [(60, 56), (60, 72), (92, 56), (92, 72)]),
    ] {
        let set = format!(r#"{PLAIN} objectalignment="{align}""#);
        let found = ground("offset", &map(&set, (4, -6), NOTHING, &object(turn)), &Options::default());
        assert_eq!(corners(&found), [wanted], "{align} {turn}");
        assert_eq!(found.shift, (0, 0));
    }
}

/// The same for tiles of a layer: whole cells stay cells, and a tile that is drawn as large as a
/// cell scales its offset.
#[test]
fn offsets_move_tiles() {
    let solid = |ground: &Ground| {
        let cells: Vec<usize> =
            (0..16).filter(|&i| ground.cells.get(i).is_some_and(|kind| kind.shape as u8 == 1)).collect();
        (cells, corners(ground))
    };
    let large = r#"tilewidth="32" tileheight="64""#;
    let grid = r#"tilewidth="32" tileheight="64" tilerendersize="grid""#;
    let square = |x: i64, y: i64, w: i64, h: i64| vec![(x, y), (x, y + h), (x + w, y), (x + w, y + h)];
    let none = Vec::<Vec<(i64, i64)>>::new();
    for (set, offset, wanted) in [
        (PLAIN, (0, 0), (vec![5], none.clone())),
        (PLAIN, (16, -16), (vec![2], none.clone())),
        (PLAIN, (4, -6), (vec![], vec![square(20, 10, 16, 16)])),
        (large, (0, 16), (vec![1, 2, 5, 6, 9, 10], vec![square(16, -16, 32, 16)])),
        (large, (8, -8), (vec![], vec![square(24, -40, 32, 64)])),
        (grid, (8, -8), (vec![], vec![square(20, 14, 16, 16)])),
        (grid, (32, 64), (vec![10], none.clone())),
    ] {
        // Above row 0 nothing is a cell, but a polygon.
        let found = ground("layer", &map(set, offset, ONE, ""), &Options::default());
        assert_eq!(solid(&found), wanted, "{set} {offset:?}");
    }
}

/// A solid object has the shapes of its tile, at its size and with its flips.
#[test]
fn shapes_of_the_tile() {
    let ramp = |gid: u32, more: &str| {
        let text = format!(r#"<object id="7" gid="{gid}" x="100" y="50" width="32" height="16" {more}/>"#);
        ground("shapes", &map(PLAIN, (0, 0), ONE, &text), &Options::default())
    };
    for (gid, wanted) in [
        (2, [(100, 50), (132, 34), (132, 50)]),
        (2 | 1 << 31, [(100, 34), (100, 50), (132, 50)]),
        (2 | 1 << 30, [(100, 34), (132, 34), (132, 50)]),
        (2 | 3 << 30, [(100, 34), (100, 50), (132, 34)]),
    ] {
        let found = ramp(gid, r#"type="Solid""#);
        assert_eq!(corners(&found), [wanted], "{gid:x}");
        assert_eq!((found.outlines[0].kind, found.outlines[0].title.id), (Kind::Solid, 7));
    }
    assert_eq!(corners(&ramp(2, r#"type="Solid" rotation="90""#)), [[(100, 50), (100, 82), (116, 82)]]);
    // One-way, it is the edge of the shape that faces up. Without shapes, the picture counts.
    assert_eq!(corners(&ramp(2, r#"type="OneWay""#)), [[(100, 50), (132, 34)]]);
    assert_eq!(corners(&ramp(3, r#"type="OneWay""#)), [[(100, 34), (132, 34)]]);
    assert_eq!(corners(&ramp(3, r#"type="Solid""#)), [[(100, 34), (100, 50), (132, 34), (132, 50)]]);
}

/// Many tiles as objects are things of the game: their shapes alone make no wall of them.
#[test]
fn shapes_alone_are_not_solid() {
    let list = r#"<object id="7" name="crate" gid="2" x="32" y="32" width="16" height="16"/>
        <object id="8" gid="3" x="48" y="32" width="16" height="16"/>"#;
    let text = map(PLAIN, (0, 0), ONE, list);
    let found = ground("alone", &text, &Options::default());
    assert!(found.outlines.is_empty());
    let why: Vec<&str> = found.left_out.iter().map(|object| object.why.as_str()).collect();
    let wanted = "it is a tile as an object, whose tile has a collision shape, but nothing says that it is solid; \
                  give it the class Solid, or add --objects 'things'";
    assert_eq!(why, [wanted, "it is a tile as an object, and nothing says that it is solid"]);
    let settings = bake::Settings::default();
    let levels = read::load(&scratch("stamps", "listed.tmx", &text), None).unwrap();
    assert!(bake::bake(&levels.maps, &settings).unwrap().source().contains("OBJECT_CRATE"));
    // What the message says helps.
    let options = Options { objects: vec!["things".to_owned()], ..Options::default() };
    let found = ground("said", &text, &options);
    assert_eq!(corners(&found), [vec![(32, 32), (48, 16), (48, 32)], vec![(48, 16), (48, 32), (64, 16), (64, 32)]]);
    let classed = text.replace(r#"name="crate""#, r#"type="Solid""#);
    assert_eq!(corners(&ground("classed", &classed, &Options::default())), [[(32, 32), (48, 16), (48, 32)]]);
}

/// The stated error of a round form is that of the drawing.
#[test]
#[allow(clippy::cast_precision_loss, reason = "raw coordinates are below 2^30")]
fn round_shapes_of_larger_pictures() {
    let disc = r#"<tile id="1"><objectgroup><object id="1" x="0" y="0" width="16" height="16"><ellipse/></object></objectgroup></tile>"#;
    let plain = map(PLAIN, (0, 0), NOTHING, "");
    let (from, to) = (plain.find(r#"<tile id="1">"#).unwrap(), plain.find("</tileset>").unwrap());
    let text = |list: &str| {
        format!("{}{disc}{}", &plain[..from], &plain[to..])
            .replace("</objectgroup>\n</map>", &format!("{list}</objectgroup>\n</map>"))
    };
    let object = r#"<object id="1" gid="2" type="Solid" x="0" y="320" width="320" height="320"/>"#;
    let ellipse = r#"<object id="1" type="Solid" x="0" y="0" width="32" height="32"><ellipse/></object>"#;
    let in_layer = text("").replace(NOTHING, &ONE.replace('1', "2"));
    // A picture of 4 pixels, drawn as large as a cell.
    let small = in_layer
        .replace(&format!("columns=\"4\" {PLAIN}"), r#"columns="4" tilewidth="4" tileheight="4" tilerendersize="grid""#)
        .replace(r#"width="16" height="16"><ellipse"#, r#"width="4" height="4"><ellipse"#);
    for (name, text, scale, radius) in [
        ("object", text(object), None, 160.0),
        ("ellipse", text(ellipse), Some((8, 1)), 128.0),
        ("layer", in_layer.clone(), Some((8, 1)), 64.0),
        ("plain", in_layer, None, 8.0),
        ("small", small, Some((8, 1)), 64.0),
    ] {
        let options = Options { scale, ..Options::default() };
        let found = ground(name, &text, &options);
        let [outline] = &found.outlines[..] else { panic!("{name} {found:?}") };
        let end = |of: fn(&(i64, i64)) -> i64| outline.points.iter().map(of).max().unwrap() as f64 / 65536.0 - radius;
        let centre = (end(|p| p.0), end(|p| p.1));
        let middle = |(a, b): ((i64, i64), (i64, i64))| {
            let at = |a: i64, b: i64, centre: f64| (a + b) as f64 / 131_072.0 - centre;
            at(a.0, b.0, centre.0).hypot(at(a.1, b.1, centre.1))
        };
        let ends = outline.points.iter().copied().zip(outline.points.iter().copied().cycle().skip(1));
        let measured = radius - ends.map(middle).fold(radius, f64::min);
        let note = found.notes.iter().find_map(|note| note.split("off by at most ").nth(1)).unwrap();
        let stated: f64 = note.split(' ').next().unwrap().parse().unwrap();
        assert!(measured <= stated && (stated <= 0.125 || outline.points.len() == 64), "{name} {measured} {note}");
    }
}
