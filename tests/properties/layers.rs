//! The files of the library form layers. None imports itself, even indirectly, and none imports
//! from a layer above. No two of them have types of one name. The root has few names.
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

type Module = Vec<String>;

#[derive(Default)]
struct File {
    /// The modules that are written out in it.
    inner: BTreeMap<String, File>,
    /// The paths of `use`, and the meaning of each name that `use` imports or re-exports.
    taken: Vec<Module>,
    names: BTreeMap<String, Module>,
    /// The paths and words of the rest.
    words: BTreeSet<Module>,
    /// The types that it defines; no associated types.
    types: BTreeSet<String>,
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
    // Unit tests inside a file are its last module.
    let tests = text
        .find("\n#[cfg(test)]\n")
        .filter(|&at| text[at..].lines().any(|line| line.starts_with("mod ") && line.ends_with('{')));
    read_module(&mut text[..tests.unwrap_or(text.len())].lines(), "")
}

/// Reads to the end of a module whose lines are indented by this.
fn read_module<'t>(lines: &mut impl Iterator<Item = &'t str>, indent: &str) -> File {
    let (mut file, mut statement) = (File::default(), None::<String>);
    while let Some(line) = lines.next().map(|line| line.split("//").next().unwrap()) {
        let start = line.trim_start();
        if indent.strip_suffix("    ").is_some_and(|outer| line == format!("{outer}}}")) {
            break;
        }
        let is_public = start.starts_with("pub");
        let behind = match start.strip_prefix("pub(").and_then(|rest| rest.split_once(") ")) {
            Some((_, behind)) => behind,
            None => start.strip_prefix("pub ").unwrap_or(start),
        };
        if let Some(tree) = behind.strip_prefix("use ") {
            statement = Some(format!("{}{tree}", if is_public { "pub " } else { "" }));
        } else if let Some(open) = &mut statement {
            open.push_str(start);
        } else if let Some(name) = behind.strip_prefix("mod ") {
            if let Some(name) = name.strip_suffix(" {") {
                file.inner.insert(name.into(), read_module(lines, &format!("{indent}    ")));
            }
        } else {
            let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
            let is_type =
                |word: &str| matches!(word, "struct" | "enum" | "trait" | "union") || word == "type" && line == start;
            if let Some((_, of)) = behind.split_once(' ').filter(|(word, _)| is_type(word)) {
                file.types.extend(of.split(|c| !is_part(c)).next().map(String::from));
            }
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

/// Lists a file. A module that is written out in it is a folder if its own modules are files.
/// Otherwise its imports are those of the file.
fn unfold(files: &mut BTreeMap<Module, File>, module: Module, mut file: File) {
    for (name, inner) in std::mem::take(&mut file.inner) {
        let below: Module = module.iter().cloned().chain([name]).collect();
        if files.keys().any(|other| other.len() > below.len() && other.starts_with(&below)) {
            unfold(files, below, inner);
            continue;
        }
        let from_file = |mut path: Module| {
            path.drain(..usize::from(path.first().is_some_and(|first| first == "super")));
            path
        };
        file.taken.extend(inner.taken.into_iter().map(from_file));
        file.types.extend(inner.types);
        file.words.extend(inner.words.into_iter().map(from_file).filter(|path| !path.is_empty()));
        for (name, path) in inner.names {
            file.names.entry(name).or_insert(from_file(path));
        }
    }
    files.insert(module, file);
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

/// All that a file imports, also through others.
fn reach<'f>(imports: &'f BTreeMap<&Module, BTreeSet<Module>>, from: &Module) -> BTreeSet<&'f Module> {
    let (mut reached, mut left) = (BTreeSet::new(), imports[from].iter().collect::<Vec<_>>());
    while let Some(next) = left.pop() {
        if reached.insert(next) {
            left.extend(&imports[next]);
        }
    }
    reached
}

fn library() -> BTreeMap<Module, File> {
    let mut files = BTreeMap::new();
    read_all(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &Module::new(), &mut files);
    for module in files.keys().cloned().collect::<Vec<_>>() {
        let file = std::mem::take(files.get_mut(&module).unwrap());
        unfold(&mut files, module, file);
    }
    files
}

#[test]
fn no_two_types_share_a_name() {
    let files = library();
    let mut found = BTreeMap::<_, Vec<_>>::new();
    for (module, file) in files.iter().filter(|(module, _)| !module.iter().any(|part| part == "tests")) {
        for name in &file.types {
            found.entry(name.as_str()).or_default().push(module.join("::"));
        }
    }
    assert!(found.len() > files.len(), "hardly a type was found");
    found.retain(|_, modules| modules.len() > 1);
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn files_stand_in_layers() {
    let files = library();
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
    }
    for (module, to) in &imports {
        if let Some(to) = to.iter().find(|to| reach(&imports, to).contains(module)) {
            wrong.push(format!("{} imports {}, which imports it again", module.join("::"), to.join("::")));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Crates, modules and macros do not count.
#[test]
fn the_root_has_at_most_sixty_names() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).unwrap();
    let uses = text.split("\npub use ").skip(1).filter_map(|rest| rest.split_once(';'));
    let paths = uses.flat_map(|(tree, _)| leaves(tree)).filter(|(path, _)| path.len() > 1);
    let names: BTreeSet<String> = paths.map(|(_, name)| name).collect();
    assert!(["Character", "Fx", "TileMap", "World"].iter().all(|&name| names.contains(name)), "{names:#?}");
    assert!(names.len() <= 60, "{} names: {names:#?}", names.len());
}

/// The tables of a page name each file that makes up a scene, and no file that is gone.
#[test]
fn the_architecture_names_the_files_of_a_scene() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("ARCHITECTURE.md")).unwrap();
    let (_, section) = page.split_once("## The files of a scene").unwrap();
    let rows = section.split("\n## ").next().unwrap().lines().filter_map(|line| line.strip_prefix("| `"));
    let cells = rows.filter_map(|row| row.split_once(" |")).map(|(cell, _)| cell);
    let named: BTreeSet<_> = cells.flat_map(|cell| cell.split("`, `")).map(|name| name.trim_matches('`')).collect();
    let names =
        fs::read_dir(root.join("src/scene")).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap());
    let files: Vec<_> = names.filter(|name| name != "mod.rs").collect();
    assert_eq!(named, files.iter().map(String::as_str).collect(), "the files of src/scene");
}
