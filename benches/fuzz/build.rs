//! Brings the judges of the crate's tests here, so that no second set is written for fuzzing.
//!
//! The folder of tests is copied. The one file of random numbers is replaced by a reader of the fuzzer's bytes, which steers the tests' own
//! generators of adversarial cases; `mod` lines that bring helpers into a test become imports, and what is private there can be seen.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders of helpers, as modules of the same names.
const HELPERS: [&str; 9] = [
    "broad_support",
    "cast_support",
    "motion_shape_support",
    "motion_support",
    "oracle",
    "ray_support",
    "segment_world_support",
    "solids",
    "solids_support",
];
/// Tests whose functions are used.
const TESTS: [&str; 10] = [
    "cast_classes",
    "motion_segments",
    "motion_shapes",
    "scene_change",
    "segment_world_hostile",
    "segment_world_rays",
    "shape_overlap",
    "shape_rays",
    "solids_ticks",
    "world_oracle",
];
const RANDOM: &str = "pub(crate) use crate::stream::Random;\n";

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let (path, to) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() {
            copy(&path, &to);
        } else if path.extension().is_some_and(|end| end == "rs") {
            fs::write(to, fs::read(&path).unwrap()).unwrap();
        }
    }
}

/// A test as a module of helpers.
fn opened(text: &str) -> String {
    let mut out = String::new();
    let (mut fields, mut methods) = (false, false);
    for line in text.lines() {
        let item = ["fn ", "struct ", "enum ", "const ", "static ", "type "].iter().any(|word| line.starts_with(word));
        if let Some(name) = line.strip_prefix("mod ").and_then(|rest| rest.strip_suffix(';')) {
            out += &format!("use crate::{name};\n");
            continue;
        }
        let plain = |prefix: &str| line.strip_prefix(prefix).is_some_and(|rest| rest.starts_with(char::is_lowercase));
        let member = (fields && plain("    ")) || (methods && line.starts_with("    fn "));
        if item {
            out += "pub(crate) ";
        }
        if member {
            out += "    pub(crate) ";
        }
        out += if member { line.trim_start() } else { line };
        out.push('\n');
        match line {
            "}" => (fields, methods) = (false, false),
            _ if line.starts_with("struct ") && line.ends_with('{') => fields = true,
            _ if line.starts_with("impl") && !line.contains(" for ") && line.ends_with('{') => methods = true,
            _ => {}
        }
    }
    out
}

fn main() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests");
    println!("cargo::rerun-if-changed={}", tests.display());
    println!("cargo::rerun-if-changed=build.rs");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").unwrap());
    let copied = out.join("tests");
    let _ = fs::remove_dir_all(&copied);
    for folder in HELPERS.into_iter().chain(["support"]) {
        copy(&tests.join(folder), &copied.join(folder));
    }
    fs::write(copied.join("oracle/random.rs"), RANDOM).unwrap();
    let mut modules = String::new();
    let mut module = |name: &str, file: &str| {
        modules += &format!("#[path = {:?}]\nmod {name};\n", copied.join(file).to_str().unwrap());
    };
    for name in HELPERS.into_iter().chain(["support"]) {
        module(name, &format!("{name}/mod.rs"));
    }
    for name in TESTS {
        let file = format!("{name}.rs");
        let text = opened(&fs::read_to_string(tests.join(&file)).unwrap());
        fs::write(copied.join(&file), text).unwrap();
        module(name, &file);
    }
    fs::write(out.join("judges.rs"), modules).unwrap();
}
