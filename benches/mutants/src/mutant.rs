//! The list that cargo-mutants prints.

use serde_json::Value;
use std::fs;
use std::path::Path;

/// A line and a column, both from 1. Columns count characters.
pub(crate) type Spot = (usize, usize);

pub(crate) struct Mutant {
    /// Its position in the whole list, from 1.
    pub(crate) id: u32,
    pub(crate) name: String,
    pub(crate) file: String,
    /// From the first character to behind the last one.
    pub(crate) function: Option<(Spot, Spot)>,
    pub(crate) span: (Spot, Spot),
    pub(crate) replacement: String,
}

pub(crate) fn read(list: &Path) -> Vec<Mutant> {
    let text = fs::read_to_string(list).expect("a list of mutants");
    let list: Value = serde_json::from_str(&text).expect("JSON");
    let all = list.as_array().expect("a list");
    all.iter()
        .zip(1..)
        .map(|(item, id)| {
            let text = |name: &str| item[name].as_str().unwrap_or_default().to_owned();
            Mutant {
                id,
                name: text("name"),
                file: text("file"),
                function: item["function"].is_object().then(|| span(&item["function"]["span"])),
                span: span(&item["span"]),
                replacement: text("replacement"),
            }
        })
        .collect()
}

fn span(value: &Value) -> (Spot, Spot) {
    let spot = |end: &str| {
        let number = |name: &str| value[end][name].as_u64().expect("a number") as usize;
        (number("line"), number("column"))
    };
    (spot("start"), spot("end"))
}
