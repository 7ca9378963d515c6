//! The files of the library form layers. None imports itself, even indirectly, and none imports
//! from a layer above.
//!
//! An import is a path behind `use`, or one in the code that begins with `crate`, `super`, a module
//! below or an imported name. If a file only re-exports (`pub use`), the import counts for the file
//! that defines the item. Unit tests do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The layers from the ground up. Modules in one row do not import each other. The root re-exports
/// names, and `format` prints everything.
const LAYERS: [&[&str]; 7] = [
    &["num", "error", "stored"],
    &["filter", "shape"],
    &["query"],
    &["world"],
    &["broad", "motion"],
    &["scene"],
    &["", "format"],
];

/// Its files still import each other. The test checks what it takes from others.
const LEFT: &str = "motion";

type Module = Vec<String>;

#[derive(Default)]
struct File {
    /// The paths of `use`, and the meaning of each name that `use` imports or re-exports.
    taken: Vec<Module>,
    names: BTreeMap<String, Module>,
    /// The paths and words of the rest.
    words: BTreeSet<Module>,
}

fn split(path: &str) -> Module {
    path.split("::").map(|part| part.trim().to_string()).filter(|part| !part.is_empty()).collect()
}

/// The paths of a tree, each with the name that it gives.
fn leaves(tree: &str) -> Vec<(Module, String)> {
    let Some((before, inside)) = tree.trim().strip_suffix('}').and_then(|tree| tree.split_once('{')) else {
        let (path, name) = tree.split_once(" as ").unwrap_or((tree, tree));
        return vec![(split(path), split(name).pop().unwrap_or_default())];
    };
    let mut depth = 0;
    let parts = inside.split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    let below = parts.filter(|part| !part.trim().is_empty()).flat_map(leaves);
    below.map(|(path, name)| (split(before).into_iter().chain(path).collect(), name)).collect()
}

fn read(text: &str) -> File {
    let (mut file, mut statement) = (File::default(), None::<String>);
    // Unit tests inside a file are its last module.
    let tests = text
        .find("\n#[cfg(test)]\n")
        .filter(|&at| text[at..].lines().any(|line| line.starts_with("mod ") && line.ends_with('{')));
    let text = &text[..tests.unwrap_or(text.len())];
    for line in text.lines().map(|line| line.split("//").next().unwrap()) {
        let start = line.trim_start();
        let is_public = start.starts_with("pub");
        let behind = match start.strip_prefix("pub(").and_then(|rest| rest.split_once(") ")) {
            Some((_, behind)) => behind,
            None => start.strip_prefix("pub ").unwrap_or(start),
        };
        if let Some(tree) = behind.strip_prefix("use ") {
            // In a module inside a file, `super` is the file.
            let inner = line.starts_with(' ');
            statement = Some(format!(
                "{}{}",
                if is_public { "pub " } else { "" },
                if inner { tree.replacen("super", "self", 1) } else { tree.into() }
            ));
        } else if let Some(open) = &mut statement {
            open.push_str(start);
        } else if !behind.starts_with("mod ") {
            let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
            file.words.extend(behind.split(|c| !is_part(c)).map(split).filter(|path| !path.is_empty()));
        }
        if let Some(whole) = statement.take_if(|open| open.trim_end().ends_with(';')) {
            let tree = whole.trim_end().trim_end_matches(';');
            let (is_public, tree) = tree.strip_prefix("pub ").map_or((false, tree), |tree| (true, tree));
            for (mut path, name) in leaves(tree) {
                path.retain(|part| part != "self");
                if !is_public {
                    file.taken.push(path.clone());
                }
                file.names.insert(if name == "self" { path.last().cloned().unwrap_or_default() } else { name }, path);
            }
        }
    }
    file
}

fn read_all(folder: &Path, module: &Module, files: &mut BTreeMap<Module, File>) {
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_stem().unwrap().to_str().unwrap().to_string();
        let below: Module = module.iter().cloned().chain([name.clone()]).collect();
        if entry.is_dir() {
            read_all(&entry, &below, files);
        } else if entry.extension().is_some_and(|e| e == "rs") && name != "tests" {
            let of = if name == "mod" || name == "lib" { module.clone() } else { below };
            files.insert(of, read(&fs::read_to_string(&entry).unwrap()));
        }
    }
}

/// The file that defines the target of a path in a file.
fn defining(files: &BTreeMap<Module, File>, from: &Module, path: &[String], steps: u32) -> Option<Module> {
    let (first, rest) = path.split_first()?;
    let step = steps.checked_sub(1)?;
    let below = |module: &Module, name: &String| -> Module { module.iter().chain([name]).cloned().collect() };
    let mut here = match first.as_str() {
        "crate" => Module::new(),
        "super" => from[..from.len().saturating_sub(1)].to_vec(),
        _ if files.contains_key(&below(from, first)) => below(from, first),
        _ => return defining(files, from, &[files[from].names.get(first)?, rest].concat(), step),
    };
    for (at, name) in rest.iter().enumerate() {
        if files.contains_key(&below(&here, name)) {
            here = below(&here, name);
        } else if name == "super" {
            here.pop();
        } else {
            let handed_on = files.get(&here)?.names.get(name);
            let further = handed_on.and_then(|to| defining(files, &here, &[to, &rest[at + 1..]].concat(), step));
            return further.or(Some(here));
        }
    }
    Some(here)
}

#[test]
fn files_stand_in_layers() {
    let mut files = BTreeMap::new();
    read_all(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &Module::new(), &mut files);
    let mut imports: BTreeMap<&Module, BTreeSet<Module>> = BTreeMap::new();
    for (module, file) in &files {
        // A single word is an import only if `use` has named it.
        let words = file.words.iter().filter(|path| path.len() > 1 || file.names.contains_key(&path[0]));
        let found = file.taken.iter().chain(words).filter_map(|path| defining(&files, module, path, 20));
        imports.insert(module, found.filter(|to| to != module).collect());
    }
    assert!(imports.values().map(BTreeSet::len).sum::<usize>() > 2 * files.len(), "hardly an import was found");

    let layer = |module: &Module| {
        let top = module.first().map_or("", |top| top);
        (
            LAYERS.iter().position(|row| row.contains(&top)).unwrap_or_else(|| panic!("{top} is in no layer")),
            top.to_string(),
        )
    };
    let mut wrong = Vec::new();
    for (module, to) in &imports {
        for to in to {
            let (above, below) = (layer(module), layer(to));
            if below.0 > above.0 || (below.0 == above.0 && above.0 > 0 && below.1 != above.1) {
                wrong.push(format!("{} imports {}, which is not below it", module.join("::"), to.join("::")));
            }
        }
        let (mut reached, mut left) = (BTreeSet::new(), vec![*module]);
        while let Some(next) = left.pop() {
            left.extend(imports[next].iter().filter(|to| reached.insert(*to)));
        }
        if reached.contains(module) && module.first().is_none_or(|top| top != LEFT) {
            let circle: Vec<_> =
                imports[module].iter().filter(|to| imports.contains_key(to)).map(|to| to.join("::")).collect();
            wrong.push(format!("{} reaches itself, by one of {circle:?}", module.join("::")));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
