//! What blocks bodies from above only: its names, and the edges of drawn forms.

use crate::support::{Ran, ldtk, map, objects, rows, run, scratch};
use tilesat_tools::read::load;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::kind::Kind;
use tilesat_tools::rules::options::Options;

/// The chains of a map, each with its corners in pixels.
fn chains(text: &str) -> Vec<(Kind, Vec<(i64, i64)>)> {
    let levels = load(&scratch("one_way", "map.tmx", text), None).unwrap();
    let ground = Ground::of(&levels.maps[0], &Options::default(), &mut Flags::default()).unwrap();
    let pixels = |points: &[(i64, i64)]| points.iter().map(|(x, y)| (x >> 16, y >> 16)).collect();
    ground.outlines.iter().map(|outline| (outline.kind, pixels(&outline.points))).collect()
}

/// One object of a class, with this form.
fn of_class(class: &str, rest: &str) -> Vec<(Kind, Vec<(i64, i64)>)> {
    let list = format!(r#"<object id="1" type="{class}" x="32" y="48" {rest}</object>"#);
    chains(&objects(&list).replace(r#"class="Solid""#, ""))
}

/// Bodies stand on the upper edges. They pass the flanks and the lower side.
#[test]
fn closed_forms_block_from_above() {
    let top = [(Kind::OneWay, vec![(32, 48), (64, 48)])];
    assert_eq!(of_class("OneWay", r#"width="32" height="8">"#), top);
    for points in ["0,0 32,0 32,8 0,8", "0,8 32,8 32,0 0,0", "32,8 32,0 0,0 0,8", "0,0 0,8 32,8 32,0"] {
        assert_eq!(of_class("OneWay", &format!(r#"><polygon points="{points}"/>"#)), top, "{points}");
    }
    // A roof of two slopes, and a bridge whose flanks lean.
    let roof = of_class("OneWay", r#"><polygon points="0,8 16,0 32,8"/>"#);
    assert_eq!(roof, [(Kind::OneWay, vec![(32, 56), (48, 48), (64, 56)])]);
    let bridge = of_class("OneWay", r#"><polygon points="0,32 4,0 28,0 32,32"/>"#);
    assert_eq!(bridge, [(Kind::OneWay, vec![(36, 48), (60, 48)])]);
    // Two towers have two tops.
    let towers = of_class("OneWay", r#"><polygon points="0,0 8,0 8,16 24,16 24,0 32,0 32,32 0,32"/>"#);
    assert_eq!(
        towers,
        [
            (Kind::OneWay, vec![(32, 48), (40, 48)]),
            (Kind::OneWay, vec![(40, 64), (56, 64)]),
            (Kind::OneWay, vec![(56, 48), (64, 48)])
        ]
    );
    // A peak has steep edges only.
    let peak = of_class("OneWay", r#"><polygon points="0,32 4,0 8,32"/>"#);
    assert_eq!(peak, [(Kind::OneWay, vec![(32, 80), (36, 48), (40, 80)])]);
    // Turned by a quarter, another edge is the upper one.
    let turned = of_class("OneWay", r#"width="8" height="32" rotation="90">"#);
    assert_eq!(turned, [(Kind::OneWay, vec![(0, 48), (32, 48)])]);
}

/// In whatever direction an author draws a line, it is a platform. Nobody stands on a steep one.
#[test]
fn lines_block_from_above() {
    for points in ["0,0 32,0", "32,0 0,0"] {
        let line = of_class("OneWay", &format!(r#"><polyline points="{points}"/>"#));
        assert_eq!(line, [(Kind::OneWay, vec![(32, 48), (64, 48)])], "{points}");
    }
    for (points, wanted) in [("0,0 0,32", [(32, 48), (32, 80)]), ("0,32 0,0", [(32, 80), (32, 48)])] {
        assert_eq!(
            of_class("OneWay", &format!(r#"><polyline points="{points}"/>"#)),
            [(Kind::OneWay, wanted.to_vec())]
        );
    }
}

const NAMES: [&str; 18] = [
    "OneWay",
    "one-way-platform",
    "OneWayPlatforms",
    "Platform_OneWay",
    "Platform_one_way",
    "Ground_oneway",
    "isOneWay",
    "OneWayBlock",
    "onewayplatform",
    "SemiSolid",
    "Semi_solid",
    "semi-solid",
    "solid_top",
    "SolidTop",
    "JumpThrough",
    "jumpthru",
    "pass_through",
    "DropThrough",
];

/// The words count in the names of tiles, properties, layers, objects and values.
#[test]
fn names_count_everywhere() {
    let one_way = |ran: Ran, what: &str| {
        let line: serde_json::Value = serde_json::from_str(&ran.out).unwrap_or_else(|_| panic!("{what} {ran:?}"));
        (line["solid"].clone(), line["one_way"].clone(), line["segments"].clone())
    };
    let bake = |name: &str, text: String| run("bake", scratch("one_way", name, text), "--json");
    for name in NAMES {
        let tiles = rows(&["=.", "##"]);
        let class = tiles.replace(r#"type="OneWay""#, &format!(r#"type="{name}""#));
        assert_eq!(one_way(bake("class.tmx", class), name), (2.into(), 1.into(), 0.into()), "{name}");
        let own = format!(r#"><properties><property name="{name}" type="bool" value="true"/></properties></tile>"#);
        let property = tiles.replace(r#" type="OneWay"/>"#, &own);
        assert_eq!(one_way(bake("property.tmx", property), name), (2.into(), 1.into(), 0.into()), "{name}");
        let layer = map(2, 1, "4,4", "").replace("World", name);
        assert_eq!(one_way(bake("layer.tmx", layer), name), (0.into(), 2.into(), 0.into()), "{name}");
        let object = r#"<object id="1" x="0" y="0" width="16" height="8"/>"#;
        let layer = objects(object).replace(r#"name="L" class="Solid""#, &format!(r#"name="{name}""#));
        assert_eq!(one_way(bake("objects.tmx", layer), name), (0.into(), 0.into(), 1.into()), "{name}");
        assert_eq!(of_class(name, r#"width="16" height="8">"#).len(), 1, "{name}");
        let value = ldtk(&[name, "Full"], 2, 1, "1,2");
        assert_eq!(one_way(bake("value.ldtk", value), name), (1.into(), 1.into(), 0.into()), "{name}");
    }
    // What follows the words in a value is a flag.
    let ran = bake("flag.ldtk", ldtk(&["OneWay_Ice", "Full"], 2, 1, "1,2"));
    assert!(ran.out.contains(r#""flags":{"Ice":1}"#), "{ran:?}");
    for name in ["Stoneway", "one", "semi", "not_one_way", "through"] {
        let text = rows(&["=.", "##"]).replace(r#"type="OneWay""#, &format!(r#"type="{name}""#));
        assert_eq!(one_way(bake("other.tmx", text), name), (2.into(), 0.into(), 0.into()), "{name}");
    }
    // The name of a shape has a side.
    let left = rows(&["=.", "##"]).replace(r#"type="OneWay""#, r#"type="one_way_left""#);
    assert!(bake("left.tmx", left).out.contains(r#""one-way-left":1"#));
}

/// A thing with both words is one-way, and so are shapes in a one-way layer.
#[test]
fn one_way_says_more_than_solid() {
    let own = r#"type="Solid"><properties><property name="oneway" type="bool" value="true"/></properties></tile>"#;
    let tile = rows(&["#"]).replace(r#"type="Solid"/>"#, own);
    let ran = run("bake", scratch("one_way", "both.tmx", tile), "--json");
    assert!(ran.out.contains(r#""solid":0,"one_way":1"#), "{ran:?}");
    let both = of_class(
        "Solid",
        r#"width="16" height="8"><properties><property name="oneway" type="bool" value="true"/></properties>"#,
    );
    assert_eq!(both, [(Kind::OneWay, vec![(32, 48), (48, 48)])]);
    let shape = r#"<tile id="3"><objectgroup><object id="1" x="0" y="8" width="16" height="4"/></objectgroup></tile></tileset>"#;
    let layer = map(1, 1, "4", "").replace("</tileset>", shape).replace("World", "One Way");
    assert_eq!(chains(&layer), [(Kind::OneWay, vec![(0, 8), (16, 8)])]);
}
