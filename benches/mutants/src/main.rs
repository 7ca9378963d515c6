//! Weaves all mutants that cargo-mutants lists into one program, so that one build compiles them.
//!
//! `weave LIST.json TREE [--of N --seed K] [--only FILE] [--tests NAMES]` takes all mutants, those
//! numbered K, K + N, ..., or those that a file names. It changes the sources of a copied tree.
//! Each function's body becomes a match on a number, with an arm per mutant and the original body
//! for all other numbers. The environment variable `MUTANT` gives the number when the program
//! starts.
//!
//! Builds of the library and of the named tests find the functions that the compiler evaluates for
//! constants, and mutants that are no valid program. The tool leaves both out. It writes
//! `mutants.tsv` into the tree: number, verdict before any test (`woven`, `unviable`, `constant`)
//! and name.

mod built;
mod mutant;
mod text;

use mutant::Mutant;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use std::{env, fs};
use text::Source;

/// Code for every tree: reads the number before any test runs, and ends at the first failure.
const ACTIVE: &str = r#"
#[doc(hidden)]
pub static mut ACTIVE: u32 = 0;

#[used]
#[unsafe(link_section = ".init_array")]
static BEGIN: extern "C" fn() = {
    extern crate std;
    extern "C" fn begin() {
        if let Some(number) = std::env::var("MUTANT").ok().and_then(|text| text.parse().ok()) {
            unsafe { ACTIVE = number };
        }
        std::panic::set_hook(std::boxed::Box::new(|_| std::process::exit(101)));
    }
    begin
};

// The compiler evaluates the constants of a generic type only for a type that a program names.
#[doc(hidden)]
pub static SCENE: scene::SortSweepScene<2> = scene::SortSweepScene::empty();
#[doc(hidden)]
pub static SNAPSHOT: scene::Snapshot<broad::SortSweep<2, scene::SceneTag>, 2> =
    scene::Snapshot::new(broad::SortSweep::new());
"#;

fn main() {
    let mut args = env::args().skip(1);
    let (list, tree) = (args.next().expect("a list"), args.next().expect("a tree"));
    let (mut of, mut seed, mut only, mut programs) = (1, 0, None, String::new());
    while let (Some(option), Some(value)) = (args.next(), args.next()) {
        match option.as_str() {
            "--of" => of = value.parse().expect("a number"),
            "--seed" => seed = value.parse().expect("a number"),
            "--only" => only = Some(fs::read_to_string(value).expect("a file of names")),
            "--tests" => programs = value,
            _ => panic!("--of N, --seed K, --only FILE or --tests NAMES"),
        }
    }
    let tree = Path::new(&tree);
    let only: Option<BTreeSet<&str>> = only.as_ref().map(|names: &String| names.lines().collect());
    let wanted = |mutant: &Mutant| {
        mutant.id as usize % of == seed % of && only.as_ref().is_none_or(|only| only.contains(&*mutant.name))
    };
    let mutants: Vec<Mutant> = mutant::read(Path::new(&list)).into_iter().filter(wanted).collect();
    let programs: Vec<&str> = programs.split_whitespace().collect();
    let sources = Source::of(tree, &mutants);
    let (mut unviable, mut constant) = (BTreeSet::new(), BTreeSet::new());
    loop {
        for source in &sources {
            fs::write(tree.join(&source.file), source.woven(&unviable, &constant)).expect("the tree is ours");
        }
        begin(tree);
        let errors = built::errors(tree, &programs);
        if errors.is_empty() {
            break;
        }
        let before = (unviable.len(), constant.len());
        for error in &errors {
            for (file, line) in &error.places {
                let Some(source) = sources.iter().find(|source| source.file == *file) else { continue };
                match source.at_line(*line, &unviable, &constant) {
                    Some(text::Place::Arm(id)) => unviable.insert(id),
                    Some(text::Place::Match(function)) => constant.insert((file.clone(), function)),
                    None => false,
                };
            }
        }
        assert!((unviable.len(), constant.len()) != before, "no mutant is to blame: {}", errors[0].text);
        eprintln!("weave: {} unviable, {} functions for constants; once more", unviable.len(), constant.len());
    }
    let mut table = String::new();
    for mutant in &mutants {
        let held = sources.iter().find(|s| s.file == mutant.file).is_none_or(|s| !s.has_arm(mutant.id, &constant));
        let verdict = match () {
            () if unviable.contains(&mutant.id) => "unviable",
            () if held => "constant",
            () => "woven",
        };
        let _ = writeln!(table, "{}\t{verdict}\t{}", mutant.id, mutant.name);
    }
    fs::write(tree.join("mutants.tsv"), table).expect("the tree is ours");
}

/// Prepares the first file of the crate.
fn begin(tree: &Path) {
    let path = tree.join("src/lib.rs");
    let text = fs::read_to_string(&path).expect("a crate");
    if text.contains("static mut ACTIVE") {
        return;
    }
    let text: String = text
        .lines()
        .filter(|line| !line.contains("forbid(unsafe_code)"))
        .fold(String::new(), |all, line| all + line + "\n");
    let text = text.replace("#![no_std]", "#![no_std]\n#![allow(warnings, clippy::all)]");
    fs::write(path, text.replace("deny(missing_docs)", "allow(missing_docs)") + ACTIVE).expect("the tree is ours");
}
