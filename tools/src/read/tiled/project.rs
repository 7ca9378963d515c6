//! The classes of a project of Tiled. Since 1.9 Tiled does not write a property that has the value
//! that its class gives it.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use serde::Deserialize;

use super::raw::ObjectType;
use super::tags;
use crate::model::property::{Properties, Value};
use crate::read::file::Files;
use crate::read::text::unmarked;
use crate::read::{json, lax};

/// The file is in the map's folder or at most this many folders above.
const HIGHEST: usize = 6;

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Project {
    #[serde(rename = "propertyTypes", deserialize_with = "lax::given")]
    types: Vec<Type>,
    /// A file of older classes, which had no members of their own.
    #[serde(rename = "objectTypesFile", deserialize_with = "lax::given")]
    older: String,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Type {
    #[serde(deserialize_with = "lax::given")]
    name: String,
    #[serde(rename = "type", deserialize_with = "lax::given")]
    form: String,
    #[serde(deserialize_with = "lax::given")]
    members: Vec<Member>,
    /// For tiles, objects, layers and so on. Older versions: for all.
    #[serde(rename = "useAs")]
    used: Option<Vec<String>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Member {
    #[serde(deserialize_with = "lax::given")]
    name: String,
    #[serde(rename = "type", deserialize_with = "lax::given")]
    form: String,
    value: serde_json::Value,
}

/// The properties of each class, and what it is for.
#[derive(Debug, Default)]
pub(super) struct Classes {
    all: HashMap<String, (Option<Vec<String>>, Properties)>,
    none: Properties,
}

/// The projects that are read. The maps of a world have the same one.
#[derive(Debug, Default)]
pub(super) struct Projects(HashMap<PathBuf, Rc<Classes>>);

impl Projects {
    /// The classes of the nearest project around a map's folder.
    pub(super) fn around(&mut self, folder: &Path, files: &mut Files) -> Rc<Classes> {
        let projects = nearest(folder);
        let [path] = &projects[..] else {
            if let Some(path) = projects.first() {
                let what = "several projects, so nobody knows what classes give their tiles and objects";
                files.notes.push(format!("{}: {what}", path.with_file_name("").display()));
            }
            return Rc::default();
        };
        if let Some(known) = self.0.get(path) {
            return Rc::clone(known);
        }
        let classes = Rc::new(Classes::of_file(path, files));
        self.0.insert(path.clone(), Rc::clone(&classes));
        classes
    }
}

impl Classes {
    /// The properties that a class gives a tile, an object or a layer.
    pub(super) fn of(&self, class: &str, what: &str) -> &Properties {
        let known = self
            .all
            .get(class)
            .filter(|(used, _)| used.as_ref().is_none_or(|used| used.iter().any(|known| known == what)));
        known.map_or(&self.none, |(_, properties)| properties)
    }

    fn of_file(path: &Path, files: &mut Files) -> Self {
        let read = files.utf8(path).and_then(|bytes| json::parse::<Project>(&bytes));
        let project = match read {
            Ok(project) => project,
            Err(why) => {
                files.notes.push(format!("the project {} is not read: {why}", path.display()));
                return Self::default();
            }
        };
        let classes = project.types.into_iter().filter(|known| known.form == "class");
        let entry = |known: Type| {
            // A reference is to no object, and neither is a value that a class does not give.
            let members = known.members.into_iter().filter(|member| member.form != "object");
            let members = members.filter(|member| !is_nothing(&member.value));
            let values = members.map(|member| (member.name, Value::from(&member.value)));
            (known.name, (known.used, Properties(values.collect())))
        };
        let mut all: HashMap<String, _> = classes.map(entry).collect();
        if !project.older.is_empty() {
            let older = files.named(path.parent().unwrap_or(Path::new("")), &project.older);
            match files.utf8(&older).and_then(|bytes| object_types(&bytes)) {
                Ok(types) => {
                    for known in types {
                        all.entry(known.name).or_insert((None, known.properties.0));
                    }
                }
                Err(why) => files.notes.push(format!("the object types {} are not read: {why}", older.display())),
            }
        }
        Self { all, none: Properties::default() }
    }
}

/// Before Tiled 1.9, a project named a file of its object types.
fn object_types(bytes: &[u8]) -> Result<Vec<ObjectType>, String> {
    let text = unmarked(bytes).trim_ascii_start();
    if text.starts_with(b"[") { json::list(bytes) } else { tags::object_types(bytes) }
}

/// Whether a class gives no value: an empty list, or a class without values of its own.
fn is_nothing(value: &serde_json::Value) -> bool {
    match value {
        serde_json::Value::Null => true,
        serde_json::Value::Array(values) => values.is_empty(),
        serde_json::Value::Object(members) => members.is_empty(),
        _ => false,
    }
}

/// The projects in the nearest folder that has some.
fn nearest(folder: &Path) -> Vec<PathBuf> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let projects = |folder: &Path| -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).into_iter().flatten();
        let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
        paths.filter(|path| path.extension().is_some_and(|end| end == "tiled-project")).collect()
    };
    let Ok(folder) = fs::canonicalize(folder) else { return Vec::new() };
    let mut around = folder.ancestors().take(HIGHEST).map(projects);
    around.find(|found| !found.is_empty()).unwrap_or_default()
}
