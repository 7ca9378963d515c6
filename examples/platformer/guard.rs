//! Reads files for the `tiled` crate: refuses what would exhaust memory or stack, drops what a baker
//! does not need, and puts old forms into the one that the crate reads.
//!
//! The crate reserves room for `tilecount` tiles before it has seen one, and descends into nested
//! elements by recursion. It knows neither tilesets without `tilecount` and `columns`, which old
//! files lack, nor layers as XML elements, which Tiled still offers; and objects, images and
//! properties that it does not understand would make it refuse a map whose tiles are fine.

use std::fs::File;
use std::io::{Cursor, Error, ErrorKind, Read, Result};
use std::path::Path;

use super::xml::{Part, Tag, parts};

const MAX_BYTES: u64 = 64 << 20;
const MAX_DEPTH: usize = 200;
const MAX_TILES: u32 = 1 << 20;

/// A file of a map: the map itself or a tileset.
pub fn read(path: &Path) -> Result<Cursor<Vec<u8>>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(invalid(format!("larger than {} MiB", MAX_BYTES >> 20)));
    }
    normalise(&bytes).map(Cursor::new)
}

fn invalid(message: String) -> Error {
    Error::new(ErrorKind::InvalidData, message)
}

fn normalise(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut out = Vec::with_capacity(bytes.len());
    let mut depth = 0usize;
    // The depth outside of the element that is being dropped, and of layer data that is elements.
    let (mut dropping, mut elements) = (None, None);
    for part in parts(bytes) {
        let Part::Tag(tag) = part else {
            if let (Part::Plain(text), None, None) = (part, dropping, elements) {
                out.extend_from_slice(text);
            }
            continue;
        };
        let outside = if tag.closes() { depth.saturating_sub(1) } else { depth };
        depth = if tag.closes() || tag.is_empty() { outside } else { depth + 1 };
        if depth > MAX_DEPTH {
            return Err(invalid(format!("elements nested more than {MAX_DEPTH} deep")));
        }
        if dropping.is_some() {
            if dropping == Some(outside) && tag.closes() {
                dropping = None;
            }
        } else if elements.is_some() && elements != Some(outside) {
            list_gid(&mut out, tag);
        } else if elements.take().is_some() {
            out.extend_from_slice(tag.0);
        } else if tag.closes() || !is_needless(tag) {
            elements = open(&mut out, tag)?.then_some(outside);
        } else if !tag.is_empty() {
            dropping = Some(outside);
        }
    }
    Ok(out)
}

/// Whether the tiles of a level mean the same without this element.
fn is_needless(tag: Tag<'_>) -> bool {
    let name = tag.name();
    let property = name == b"property" && tag.attribute("type") != Some(b"bool");
    property
        || [&b"objectgroup"[..], b"imagelayer", b"image", b"wangsets", b"animation", b"editorsettings"].contains(&name)
}

/// Writes a tag that is kept; tells whether layer data follows that is elements.
fn open(out: &mut Vec<u8>, tag: Tag<'_>) -> Result<bool> {
    let elements = tag.name() == b"data" && !tag.closes() && !tag.is_empty() && tag.attribute("encoding").is_none();
    let end = tag.0.len() - if tag.is_empty() { 2 } else { 1.min(tag.0.len()) };
    let (start, end) = tag.0.split_at(end);
    out.extend_from_slice(start);
    if elements {
        out.extend_from_slice(b" encoding=\"csv\"");
    }
    if tag.name() == b"tileset" && !tag.closes() && tag.attribute("source").is_none() {
        match tag.attribute("tilecount") {
            None => out.extend_from_slice(b" tilecount=\"0\""),
            Some(count) if number(count) > MAX_TILES => {
                return Err(invalid(format!("a tileset with more than {MAX_TILES} tiles")));
            }
            Some(_) => {}
        }
        if tag.attribute("columns").is_none() {
            out.extend_from_slice(b" columns=\"1\"");
        }
    }
    out.extend_from_slice(end);
    Ok(elements)
}

/// A tile as an element becomes an item of a list.
fn list_gid(out: &mut Vec<u8>, tag: Tag<'_>) {
    if tag.name() == b"tile" && !tag.closes() {
        if !out.ends_with(b">") {
            out.push(b',');
        }
        out.extend_from_slice(tag.attribute("gid").unwrap_or(b"0"));
    }
}

/// 0 for what is no number, which the parser then reports; a number that does not fit is too large.
fn number(text: &[u8]) -> u32 {
    let digits = text.iter().filter(|b| b.is_ascii_digit());
    digits.fold(0, |n: u32, b| n.saturating_mul(10).saturating_add(u32::from(b - b'0')))
}
