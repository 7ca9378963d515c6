//! The program `tilesat` itself, and the subcommands without a separate file here.

use std::ffi::OsString;
use std::fs;
use std::io::{self, ErrorKind, Write};

use tilesat_tools::cli;

use crate::support::{Ran, folder, ldtk, own, rows, run, scratch, tilesat};

/// A refusal: status 2 and one line that contains the word.
fn refused(ran: &Ran, word: &str) {
    assert!(ran.status == 2 && ran.out.is_empty() && ran.err.lines().count() == 1, "{ran:?}");
    assert!(ran.err.starts_with("tilesat") && ran.err.contains(word), "{word:?} is not in {ran:?}");
}

/// `play` calls its picture as `bake` does, too.
#[test]
fn play_writes_a_picture() {
    let level = scratch("command", "picture.tmx", rows(&["#    #", "#    #", "######"]));
    let out = folder("command").join("picture.png");
    let _ = fs::remove_file(&out);
    let ran = run("play", level, &format!("--frames 9 --picture {}", out.display()));
    assert!(ran.status == 0 && out.is_file(), "{ran:?}");
}

#[test]
fn commands() {
    refused(&tilesat([""; 0]), "no command given");
    refused(&tilesat(["bace"]), "no command is called bace; there are: bake, rooms, lint, play, sheet");
    refused(&tilesat(["--fps"]), "no command is called --fps");
    for help in ["--help", "-h"] {
        for args in [&[][..], &["bake"], &["lint"], &["play"], &["sheet"]] {
            let ran = tilesat(args.iter().chain([&help]));
            assert!(ran.status == 0 && ran.err.is_empty() && ran.out.starts_with("usage: tilesat"), "{ran:?}");
            assert!(!ran.out.lines().any(|line| line.starts_with('-')), "options are indented: {}", ran.out);
        }
    }
}

#[test]
fn the_version() {
    let ran = tilesat(["--version"]);
    assert_eq!((ran.status, &*ran.out, &*ran.err), (0, concat!("tilesat ", env!("CARGO_PKG_VERSION"), "\n"), ""));
}

/// Standard output that cannot be written, with this error.
struct Broken(ErrorKind);

impl Write for Broken {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(self.0.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A script must not take half of a report for all of it. Whoever closes a pipe has read enough.
#[test]
fn output_that_cannot_be_written() {
    let level = scratch("command", "full.tmx", rows(&["#..#", "####"]));
    let level = level.to_str().unwrap();
    for args in [&["bake", level, "--json"][..], &["lint", level], &["--help"], &["play", level, "--frames", "1"]] {
        for (kind, status) in [(ErrorKind::StorageFull, 2), (ErrorKind::BrokenPipe, 0)] {
            let mut err = Vec::new();
            let found = cli::run(args.iter().map(OsString::from), &mut Broken(kind), &mut err);
            let err = String::from_utf8(err).unwrap();
            assert_eq!((found, err.contains("cannot write the output")), (status, status == 2), "{args:?} {err}");
        }
    }
}

/// As for the names of layers and tiles.
#[test]
fn an_ignored_level_that_is_not_there() {
    let project = scratch("command", "level.ldtk", ldtk(&["Full"], 2, 1, "1,0"));
    refused(
        &run("bake", &project, "--json --ignore-level Nope"),
        "--ignore-level Nope: there is no such level; there are: One",
    );
    refused(&run("lint", &project, "--ignore-level Nope"), "there are: One");
    refused(
        &run("bake", scratch("command", "alone.tmx", rows(&["#"])), "--json --ignore-level Nope"),
        "there are: alone",
    );
    refused(&run("bake", &project, "--json --ignore-level one"), "every level is skipped");
}

/// It has no built-in level, and draws into the given file.
#[test]
fn play_takes_any_level() {
    let level = own("platformer/levels/ninja.tmx");
    refused(&tilesat(["play"]), "tilesat play: no level given");
    refused(&tilesat(["play", "--level", "ninja"]), "no level given");
    refused(&tilesat(["play", "a.tmx", "b.tmx"]), "LEVEL is given twice");
    let args = ["play".as_ref(), level.as_os_str(), "--frames".as_ref(), "600".as_ref()];
    let ran = tilesat(args);
    assert!(ran.status == 0 && ran.err.is_empty() && !ran.out.contains("picture"), "{ran:?}");
    assert!(ran.last().starts_with("frames=600 bodies=33 "), "{ran:?}");
}

#[test]
fn sheets() {
    // Nothing of another run is left there.
    let files =
        ["shapes", "mosaic", "level", "contacts"].map(|name| scratch("sheets", &format!("sheet-{name}.png"), ""));
    let ran = tilesat(["sheet".as_ref(), folder("sheets").as_os_str()]);
    assert!(ran.status == 0 && ran.err.is_empty() && ran.out.lines().count() == 4, "{ran:?}");
    for file in files {
        assert!(fs::read(&file).unwrap().starts_with(b"\x89PNG\r\n"), "{}", file.display());
    }
    refused(&tilesat(["sheet"]), "tilesat sheet: no folder given");
    refused(&tilesat(["sheet", "a", "b"]), "twice");
    refused(&tilesat(["sheet", "--wide"]), "unknown argument --wide");
    refused(&tilesat(["sheet", "/no/such/folder"]), "cannot write");
}
