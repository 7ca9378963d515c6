//! Levels without anything solid: one of several is a menu or a title, a single one is a mistake.

use std::fs;

use tilesat_tools::build;

use crate::support::{folder, ldtk, objects, rows, run, scratch};

/// A project of two levels: `Cave` has a floor, and `Menu` only this layer.
fn project(menu: &str) -> String {
    let floor = r#"{"__type":"IntGrid","__identifier":"G","__cWid":2,"__cHei":1,"__gridSize":16,"layerDefUid":2,"intGridCsv":[1,1]}"#;
    let level = |name: &str, x: u32, layer: &str| {
        format!(r#"{{"identifier":"{name}","worldX":{x},"worldY":0,"pxWid":32,"pxHei":16,"layerInstances":[{layer}]}}"#)
    };
    format!(
        r#"{{"worldLayout":"Free","defs":{{"layers":[{{"uid":2,"intGridValues":[{{"value":1,"identifier":"Full"}},{{"value":2,"identifier":"Snow"}}]}}]}},"levels":[{},{}]}}"#,
        level("Cave", 0, floor),
        level("Menu", 32, menu)
    )
}

const SNOW: &str = r#"{"__type":"IntGrid","__identifier":"G","__cWid":2,"__cHei":1,"__gridSize":16,"layerDefUid":2,"intGridCsv":[2,0]}"#;
const SPAWN: &str = r#"{"__type":"Entities","__identifier":"E","__gridSize":16,"entityInstances":[{"__identifier":"Spawn","__pivot":[0,0],"px":[0,0],"width":16,"height":16}]}"#;

#[test]
fn one_level_of_several_can_have_nothing_solid() {
    let out = scratch("hollow", "out.rs", "").display().to_string();
    for (name, menu) in [("snow", SNOW), ("spawn", SPAWN)] {
        let level = || scratch("hollow", &format!("{name}.ldtk"), project(menu));
        for (command, options) in
            [("bake", format!("-o {out}")), ("rooms", format!("-o {out}")), ("lint", String::new())]
        {
            let ran = run(command, level(), &options);
            let wanted = (ran.status, ran.err.as_str()) == (0, "")
                && ran.out.contains("nothing is solid: no tile, no object")
                && ran.out.contains("--ignore-level 'Menu' skips the level");
            assert!(wanted, "{name} {command} {ran:?}");
        }
        // Alone it is refused: with the option there is nothing left.
        let ran = run("bake", level(), &format!("-o {out} --level Menu"));
        assert!(
            ran.status == 2 && ran.err.contains("nothing is solid") && !ran.err.contains("ignore-level"),
            "{ran:?}"
        );
        let ran = run("bake", level(), &format!("-o {out} --ignore-level Cave"));
        assert!(ran.status == 2 && ran.err.contains("nothing is solid"), "{ran:?}");
    }
}

#[test]
fn several_levels_without_anything_solid_are_refused() {
    let text = project(SNOW).replace("[1,1]", "[2,2]");
    let out = scratch("hollow", "none.rs", "").display().to_string();
    for (command, options) in [("bake", format!("-o {out}")), ("rooms", format!("-o {out}")), ("lint", String::new())] {
        let ran = run(command, scratch("hollow", "none.ldtk", &text), &options);
        assert!(ran.status == 2 && ran.out.is_empty() && ran.err.contains("level 'Cave': nothing is solid"), "{ran:?}");
    }
}

#[test]
fn a_map_of_a_world_can_have_nothing_solid() {
    let world =
        r#"{"type":"world","maps":[{"fileName":"floor.tmx","x":0,"y":0},{"fileName":"title.tmx","x":32,"y":0}]}"#;
    scratch("hollow", "floor.tmx", rows(&["##"]));
    scratch("hollow", "title.tmx", rows(&["##"]).replace("Solid", "Logo"));
    let out = scratch("hollow", "world.rs", "").display().to_string();
    let ran = run("bake", scratch("hollow", "two.world", world), &format!("-o {out}"));
    assert!(ran.status == 0 && ran.out.contains("--ignore-level 'title' skips the level"), "{ran:?}");
}

/// In a build script the levels of a file belong together, and those of other files do not.
#[test]
fn each_file_of_a_folder_has_something_solid() {
    let levels = folder("hollow").join("levels");
    // Of an earlier run.
    let _ = fs::remove_dir_all(&levels);
    fs::create_dir_all(&levels).unwrap();
    let out = folder("hollow").join("out.rs");
    fs::write(levels.join("a.tmx"), rows(&["##"])).unwrap();
    fs::write(levels.join("b.ldtk"), project(SNOW)).unwrap();
    let made = build::folder(&levels, &out).unwrap();
    assert_eq!(made.warnings.len(), 1, "{:?}", made.warnings);
    assert!(made.warnings[0].contains("level 'Menu': the level: nothing is solid"), "{:?}", made.warnings);
    fs::write(levels.join("c.tmx"), objects("")).unwrap();
    let failed = build::folder(&levels, &out).unwrap_err();
    assert!(failed.0.len() == 1 && failed.to_string().contains("c.tmx: nothing is solid"), "{failed}");
    fs::write(levels.join("c.tmx"), rows(&["##"])).unwrap();
    fs::write(levels.join("d.ldtk"), ldtk(&["Snow"], 2, 1, "1,0").replace("Solid", "G")).unwrap();
    let failed = build::folder(&levels, &out).unwrap_err();
    assert!(failed.0.len() == 1 && failed.to_string().contains("d.ldtk: nothing is solid"), "{failed}");
}
