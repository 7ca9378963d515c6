//! The linter: each mistake in a separate level, with the exact lines about it. Also tiles,
//! arguments and bad files.

use crate::lint_cases::CASES;
use crate::support::{self, Ran, layered, objects, own, rows, scratch};

fn run(name: &str, level: impl AsRef<[u8]>, options: &str) -> Ran {
    let path = scratch("lint", name, level);
    support::run("lint", path, options)
}

/// The lines about a level of these objects, without the last line.
fn said(name: &str, level: &str, options: &str) -> Vec<String> {
    let ran = run(&format!("{name}.tmx"), level, options);
    assert!(ran.err.is_empty() && ran.status < 2, "{name} {ran:?}");
    let lines: Vec<String> = ran.out.lines().map(str::to_owned).collect();
    let (last, lines) = lines.split_last().unwrap();
    let errors = lines.iter().filter(|line| line.starts_with("error ")).count();
    assert!(last.contains(&format!("errors={errors} ")) && (errors > 0) == (ran.status == 1), "{ran:?}");
    lines.to_vec()
}

#[test]
fn each_mistake_once() {
    for (name, list, options, expected) in CASES {
        assert_eq!(said(name, &objects(list), options), *expected, "{name}");
    }
}

/// Every kind of finding has a case.
#[test]
fn no_code_is_forgotten() {
    let codes = "crossing duplicate hole-buried hole-outside left-out no-area not-closed off-lattice out-of-domain overlap pocket \
                 reversed self-crossing self-touch sliver solid-buried t-junction unreachable zero-length";
    let lines: Vec<&str> = CASES.iter().flat_map(|case| case.3).copied().collect();
    for code in codes.split(' ') {
        assert!(lines.iter().any(|line| line.split(' ').nth(1) == Some(code)), "{code}");
    }
    for line in lines {
        let code = line.split(' ').nth(1).unwrap();
        assert!(codes.split(' ').any(|known| known == code), "{line}");
    }
}

/// Neither the order of the file nor the direction of polygons changes a finding about one object.
#[test]
fn winding_and_order_do_not_matter() {
    let hole = |points: &str| {
        format!(
            r#"<object id="4" x="0" y="0"><properties><property name="kind" value="hole"/></properties><polygon points="{points}"/></object>"#
        )
    };
    let solid = |points: &str| format!(r#"<object id="3" x="0" y="0"><polygon points="{points}"/></object>"#);
    let (there, back) = ("0,0 64,0 64,64 0,64", "0,64 64,64 64,0 0,0");
    let (inner, outer) = ("8,8 16,8 16,16 8,16", "80,16 88,16 88,8 80,8");
    let clean = [solid(there) + &hole(inner), hole(inner) + &solid(back), solid(back) + &hole(inner)];
    for (i, list) in clean.iter().enumerate() {
        assert_eq!(said(&format!("order{i}"), &objects(list), "--body 8x8"), [""; 0]);
    }
    for (i, list) in [solid(there) + &hole(outer), hole(outer) + &solid(back)].iter().enumerate() {
        let lines = said(&format!("stray{i}"), &objects(list), "");
        assert!(lines.len() == 1 && lines[0].starts_with("error hole-outside at (84, 16)"), "{lines:?}");
    }
}

#[test]
fn tiles() {
    let slot = ["####", "#  #", "## #", "####"];
    assert_eq!(said("fits", &rows(&slot), "--body 16x16"), [""; 0]);
    let lines = said("tight", &rows(&slot), "--body 17x16");
    assert_eq!(
        lines,
        [
            "warning pocket at (40, 40): tile layer 'World' and tile layer 'World': the room between them is 16 wide, the body 17; \
          the body cannot get in, or gets stuck on its way"
        ]
    );
    // The room is one tile high over the step, and two beside it.
    let lines = said("low", &rows(&slot), "--body 16x17");
    assert!(lines.len() == 1 && lines[0].contains("at (24, 24)") && lines[0].contains("16 high"), "{lines:?}");
    // One-way tiles: under a solid, with room for the body, and without.
    let shelf = ["####", "#==#", "#  #", "####"];
    let lines = said("covered", &rows(&shelf), "");
    assert!(lines.len() == 2 && lines[0].contains("column 1, row 1 has a solid on its edge"), "{lines:?}");
    let shelf = ["####", "#  #", "#==#", "####"];
    assert_eq!(said("room", &rows(&shelf), "--body 16x16"), [""; 0]);
    let lines = said("no_room", &rows(&shelf), "--body 16x16.01");
    assert!(lines.iter().any(|line| line.starts_with("warning unreachable at (32, 32)")), "{lines:?}");
    // An object in a tile's way.
    let both = rows(&["    ", "====", "    "])
        .replace("</objectgroup>", r#"<object id="9" y="10" width="64" height="6"/></objectgroup>"#);
    let lines = said("both", &both, "");
    assert!(lines.len() == 1 && lines[0].starts_with("warning unreachable at (32, 16): tile layer"), "{lines:?}");
}

/// Collision shapes of two layers join, and lie over each other. Their union is solid. So the
/// inside is clear, but bodies may catch at the borders.
#[test]
fn shapes_of_tiles_that_cross() {
    let shape = |id: u32, points: &str| {
        format!(
            r#"<tile id="{id}"><objectgroup><object id="1" x="0" y="0"><polygon points="{points}"/></object></objectgroup></tile>"#
        )
    };
    let tiles = shape(0, "0,1 8,0 8,16 0,15") + &shape(1, "8,0 16,1 16,15 4,12 8,8");
    let lines = said(
        "crossed_tiles",
        &layered(&[("A", "1,0,0,0,0,0,0,0,0,0,0,0"), ("B", "2,0,0,0,0,0,0,0,0,0,0,0")], &tiles, ""),
        "",
    );
    let crossing =
        |line: &&String| line.contains("warning crossing") && line.contains("collision shapes of tiles cross");
    assert!(lines.iter().filter(crossing).count() > 0, "{lines:?}");
    assert!(!lines.iter().any(|line| line.contains("self-crossing")), "{lines:?}");
}

#[test]
fn own_levels_are_clean() {
    for (level, layers) in [("levels/quarry.tmx", 1), ("levels/steps.ldtk", 1), ("platformer/levels/meadow.tmx", 3)] {
        let ran = support::run("lint", own(level), "--body 10x14 --strict");
        assert!(ran.status == 0 && ran.err.is_empty(), "{level} {ran:?}");
        assert!(ran.out.lines().last().unwrap().starts_with(&format!("layers={layers} ")), "{level} {ran:?}");
    }
}

#[test]
fn strict() {
    let cross = CASES.iter().find(|case| case.0 == "crossing").unwrap();
    assert_eq!(run("loose.tmx", objects(cross.1), "").status, 0);
    assert_eq!(run("strict.tmx", objects(cross.1), "--strict").status, 1);
    let tee = CASES.iter().find(|case| case.0 == "tee").unwrap();
    assert_eq!(run("tee.tmx", objects(tee.1), "--strict").status, 0);
}

/// A refusal: status 2 and one line that contains the word.
fn refused(ran: &Ran, word: &str) {
    assert!(ran.status == 2 && ran.out.is_empty() && ran.err.lines().count() == 1, "{ran:?}");
    assert!(ran.err.starts_with("tilesat lint: ") && ran.err.contains(word), "{word:?} is not in {ran:?}");
}

#[test]
fn bad_arguments() {
    let cases = [
        ("--fps 3", "--fps"),
        ("--body", "--body needs a value"),
        ("--body 10", "WIDTHxHEIGHT"),
        ("--body 0x3", "pixels above 0 and below 8192, got 0"),
        ("--body 3x9000", "got 9000"),
        ("--circle big", "got big"),
        ("--circle 4 --body 3x3", "twice"),
        ("--small -1", "--small needs pixels above 0 and below 8192, got -1"),
        ("--layer Nowhere", "no tile layer 'Nowhere'; there are: World"),
        ("--level Somewhere", "a Tiled map is one level"),
        ("other.tmx", "twice"),
    ];
    for (options, word) in cases {
        refused(&run("arguments.tmx", rows(&["##"]), options), word);
    }
    let none = |options| support::run("lint", "", options);
    refused(&none(""), "an empty argument");
    refused(&support::run("lint", "/no/such/level.tmx", ""), "cannot read");
    let help = support::run("lint", "--help", "");
    assert!(help.status == 0 && help.out.starts_with("usage: tilesat lint "), "{help:?}");
}

#[test]
fn bad_maps() {
    let good = objects(r#"<object id="7" name="a" x="0" y="0"><polygon points="0,0 8,0 8,8"/></object>"#);
    let change = |from: &str, to: &str| good.replacen(from, to, 1);
    let cases = [
        ("empty", String::new(), "the file is empty"),
        ("html", "<html></html>".into(), "not a Tiled map"),
        ("cut", good[..good.len() - 9].into(), "not a Tiled map"),
        ("cut_tag", good[..good.len() - 18].into(), "not a Tiled map"),
        ("crossed", change("</object>", "</objects>"), "line 7: </objects> closes <object>"),
        ("letters", change("8,0 ", "8,a "), "line 7: object 7: a point's y is 'a', not a number"),
        ("single", change("8,0 ", "8 "), "object 7: a point's y is '', not a number"),
        ("nan", change("x=\"0\"", "x=\"nan\""), "object 7: x is 'nan'"),
        ("id", change("id=\"7\"", "id=\"-7\""), "an object with the id '-7'"),
        ("no_points", change("points", "pints"), "object 7 has no points"),
        ("nested", change("<polygon", "<object id=\"8\"/><polygon"), "an object within an object"),
        (
            "kind",
            change("<polygon", "<properties><property name=\"kind\" value=\"sold\"/></properties><polygon"),
            "object 7 has the kind 'sold'; the kinds are solid, hole, wall and one-way",
        ),
        (
            "kinds",
            change("name=\"a\"", "type=\"Hole\"").replace(
                "<polygon",
                "<properties><property name=\"Solid\" type=\"bool\" value=\"true\"/></properties><polygon",
            ),
            "object 7 is both solid and hole: remove its class 'Hole' or its property 'Solid'",
        ),
        ("offset", change("name=\"L\"", "name=\"L\" offsetx=\"far\""), "offsetx is 'far', not a number"),
        ("isometric", change("orthogonal", "isometric"), "isometric"),
    ];
    for (name, text, word) in cases {
        refused(&run(&format!("{name}.tmx"), text, ""), word);
    }
}
