//! Folders of levels for a build script.

use std::fs;
use std::path::{Path, PathBuf};

use tilesat_tools::build;

use crate::support::{folder, ldtk, objects, rows};

/// An empty folder for levels, and the file for their source.
fn places() -> (PathBuf, PathBuf) {
    let (levels, out) = (folder("build").join("levels"), folder("build").join("levels.rs"));
    // Removes files of an earlier run.
    let _ = (fs::remove_dir_all(&levels), fs::remove_file(&out));
    fs::create_dir_all(&levels).unwrap();
    (levels, out)
}

#[test]
fn a_module_for_each_level() {
    let (levels, out) = places();
    fs::write(levels.join("cave 1.tmx"), rows(&["#..#", "####"])).unwrap();
    fs::write(levels.join("tower.ldtk"), ldtk(&["Full"], 2, 1, "1,0")).unwrap();
    fs::write(levels.join("notes.txt"), "no level").unwrap();
    build::folder(&levels, &out).unwrap();
    let source = fs::read_to_string(&out).unwrap();
    for part in [
        "pub mod levels {",
        "pub static KINDS",
        "pub mod cave_1 {",
        "pub mod one {",
        "pub const WIDTH: u16 = 4;",
        "pub const WIDTH: u16 = 2;",
    ] {
        assert!(source.contains(part), "{part} is not in {source}");
    }
}

/// Reports all wrong levels at once, a line each, and writes nothing.
#[test]
fn every_fault_has_its_line() {
    let (levels, out) = places();
    let of_folder = |folder: &Path| build::folder(folder, &out).unwrap_err();
    assert!(of_folder(&levels).to_string().ends_with("has no level: no file ends in .tmx, .tmj, .ldtk"));
    assert!(of_folder(&levels.join("none")).to_string().starts_with("cannot read the folder "));

    fs::write(levels.join("good.tmx"), rows(&["##"])).unwrap();
    fs::write(levels.join("empty.tmx"), objects("")).unwrap();
    fs::write(levels.join("torn.ldtk"), "{").unwrap();
    let failed = of_folder(&levels);
    let lines = failed.to_string();
    assert_eq!(failed.0.len(), 2, "{lines}");
    assert_eq!(format!("{failed:?}"), format!("no levels\n{lines}"));
    for (line, file) in lines.lines().zip(["empty.tmx: ", "torn.ldtk: "]) {
        assert!(line.contains(file), "{line}");
    }
    assert!(!out.exists());
}
