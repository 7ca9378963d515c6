//! The public types, as rustdoc lists them. It omits private and hidden types and includes new
//! ones, so there is no list to maintain.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::Path;

/// The path of each public struct, enum and union, such as `tilesat::num::vec2::Vec2`.
/// `core::any::type_name` gives the same path.
///
/// A type that two modules show is defined once, and listed once.
pub(crate) fn public(docs: &Path) -> Result<BTreeSet<String>, Box<dyn Error>> {
    let all = std::fs::read_to_string(docs.join("all.html"))?;
    let mut types = BTreeSet::new();
    for page in links(&all, "href=\"").filter(|page| is_type(page)) {
        let html = std::fs::read_to_string(docs.join(page))?;
        let source =
            links(&html, "class=\"src\" href=\"").find_map(|link| link.split_once("/src/")).map(|(_, file)| file);
        let file = source.and_then(|s| s.split(".rs.html").next()).ok_or_else(|| format!("{page} names no source"))?;
        let module = file.strip_suffix("/mod").unwrap_or(file).replace('/', "::");
        types.insert(format!("{module}::{}", name(page)));
    }
    // One type that surely exists, in case the form of these pages changes.
    if !types.contains("tilesat::num::vec2::Vec2") {
        return Err("the documentation's list of types is not in the form that is known".into());
    }
    Ok(types)
}

fn links<'a>(html: &'a str, before: &'a str) -> impl Iterator<Item = &'a str> {
    html.split(before).skip(1).filter_map(|rest| rest.split('"').next())
}

fn file_of(page: &str) -> &str {
    page.rsplit('/').next().unwrap_or(page)
}

fn is_type(page: &str) -> bool {
    ["struct.", "enum.", "union."].iter().any(|kind| file_of(page).starts_with(kind))
}

fn name(page: &str) -> &str {
    file_of(page).split('.').nth(1).unwrap_or_default()
}
