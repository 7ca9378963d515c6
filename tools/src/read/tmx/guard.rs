//! Reads files for the `tiled` crate: refuses what would exhaust memory or stack, drops what a baker
//! does not need, and puts other forms into the one that the crate reads.
//!
//! The crate reserves room for `tilecount` tiles before it has seen one, unpacks whatever a layer
//! unpacks to, walks over chunks of any size, and descends into nested elements by recursion. It
//! knows neither tilesets without `tilecount` and `columns`, which old files lack, nor layers as
//! XML elements, which Tiled still offers; and objects, images and properties that it does not
//! understand would make it refuse a map whose tiles are fine.

use std::io::{Cursor, Error, ErrorKind, Result};
use std::path::Path;

use super::unpack::{Packing, unpack};
use super::xml::{Part, Tag, parts};
use crate::read::file;

/// The properties that are kept beside boolean ones, as text.
pub(super) const SHAPE: &str = "shape";
pub(super) const NPP: &str = "npp";

const MAX_DEPTH: usize = 200;
const MAX_TILES: u64 = 1 << 20;
/// In all layers of a map together.
const MAX_CELLS: u64 = 1 << 22;

/// A file of a map: the map itself or a tileset.
pub(super) fn read(path: &Path) -> Result<Cursor<Vec<u8>>> {
    normalise(&file::bytes(path)?).map(Cursor::new)
}

fn invalid(message: impl Into<String>) -> Error {
    Error::new(ErrorKind::InvalidData, message.into())
}

fn normalise(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut guard = Guard { out: Vec::with_capacity(bytes.len()), ..Guard::default() };
    for part in parts(bytes) {
        match part {
            Part::Tag(tag) => guard.tag(tag)?,
            Part::Plain(text) => guard.text(text),
        }
    }
    Ok(guard.out)
}

#[derive(Default)]
struct Guard {
    out: Vec<u8>,
    depth: usize,
    /// The depth outside of the element that is being dropped.
    dropping: Option<usize>,
    /// The layer data that is being gathered.
    data: Option<Data>,
    /// Width times height of the layer that this is in, and of all layer data so far.
    cells: Option<u64>,
    total: u64,
}

struct Data {
    /// The depth outside of it.
    outside: usize,
    encoding: Encoding,
    text: Vec<u8>,
}

#[derive(Clone, Copy, PartialEq)]
enum Encoding {
    Elements,
    Csv,
    Base64(Packing),
}

impl Guard {
    fn text(&mut self, part: &[u8]) {
        if self.dropping.is_none() {
            let into = self.data.as_mut().map_or(&mut self.out, |data| &mut data.text);
            into.extend_from_slice(plain(part));
        }
    }

    fn tag(&mut self, tag: Tag<'_>) -> Result<()> {
        let outside = if tag.closes() { self.depth.saturating_sub(1) } else { self.depth };
        self.depth = if tag.closes() || tag.is_empty() { outside } else { outside + 1 };
        if self.depth > MAX_DEPTH {
            return Err(invalid(format!("elements nested more than {MAX_DEPTH} deep")));
        }
        if let Some(depth) = self.dropping {
            if depth == outside && tag.closes() {
                self.dropping = None;
            }
        } else if let Some(data) = self.data.take_if(|data| data.outside == outside) {
            self.write_data(&data)?;
        } else if let Some(data) = &mut self.data {
            if data.encoding == Encoding::Elements {
                list_gid(&mut data.text, tag);
            } else if !tag.is_empty() && !tag.closes() {
                // A chunk of an infinite map, which is refused later.
                self.dropping = Some(outside);
            }
        } else if tag.closes() {
            self.cells = self.cells.filter(|_| tag.name() != b"layer");
            self.out.extend_from_slice(tag.0);
        } else if is_needless(tag) || (tag.name() == b"data" && self.cells.is_none()) {
            self.dropping = (!tag.is_empty()).then_some(outside);
        } else {
            self.open(tag, outside)?;
        }
        Ok(())
    }

    /// Writes a tag that is kept; of layer data, nothing before all of it is here.
    fn open(&mut self, tag: Tag<'_>, outside: usize) -> Result<()> {
        // The crate does not tell `a:b` from `b`.
        if tag.name().contains(&b':') || tag.attributes().any(|(key, _)| key.contains(&b':')) {
            return Err(invalid("namespaces are not for maps"));
        }
        match tag.name() {
            b"property" => write_property(&mut self.out, tag),
            b"tileset" if tag.attribute("source").is_none() => write_tileset(&mut self.out, tag)?,
            b"data" => {
                let data = Data { outside, encoding: encoding(tag)?, text: Vec::new() };
                self.total = self.total.saturating_add(self.cells.unwrap_or(0));
                if self.total > MAX_CELLS {
                    return Err(invalid(format!("layers of more than {MAX_CELLS} tiles")));
                }
                if tag.is_empty() {
                    self.write_data(&data)?;
                } else {
                    self.data = Some(data);
                }
            }
            name => {
                if name == b"layer" {
                    let side = |name| tag.attribute(name).map_or(0, number);
                    self.cells = Some(side("width").saturating_mul(side("height")));
                }
                self.out.extend_from_slice(tag.0);
            }
        }
        Ok(())
    }

    fn write_data(&mut self, data: &Data) -> Result<()> {
        let cells = self.cells.unwrap_or(0);
        let too_long = || invalid("a tile layer holds more than its width and height say");
        if let Encoding::Base64(packing) = data.encoding {
            let packed = unpack(&data.text, packing, cells.saturating_mul(4))?.ok_or_else(too_long)?;
            self.out.extend_from_slice(b"<data encoding=\"base64\">");
            self.out.extend_from_slice(packed.as_bytes());
        } else {
            if data.text.split(|&b| b == b',').count() as u64 > cells.max(1) {
                return Err(too_long());
            }
            self.out.extend_from_slice(b"<data encoding=\"csv\">");
            self.out.extend_from_slice(&data.text);
        }
        self.out.extend_from_slice(b"</data>");
        Ok(())
    }
}

/// What counts of a part that is no tag: not comments, declarations and instructions, in which this walk and the crate's could
/// differ about what is a tag.
fn plain(part: &[u8]) -> &[u8] {
    let inner = part.strip_prefix(b"<![CDATA[").and_then(|rest| rest.strip_suffix(b"]]>"));
    match (inner, part) {
        (Some(text), _) if !text.iter().any(|b| b"<&".contains(b)) => text,
        (_, [b'<', ..]) => &[],
        _ => part,
    }
}

/// Whether the tiles of a level mean the same without this element.
fn is_needless(tag: Tag<'_>) -> bool {
    match tag.name() {
        b"property" => tag.attribute("type") != Some(b"bool") && kept(tag).is_none(),
        b"objectgroup" | b"imagelayer" | b"image" | b"wangsets" | b"animation" | b"editorsettings" => true,
        _ => false,
    }
}

fn kept(tag: Tag<'_>) -> Option<&'static str> {
    [SHAPE, NPP].into_iter().find(|name| tag.attribute("name") == Some(name.as_bytes()))
}

fn encoding(tag: Tag<'_>) -> Result<Encoding> {
    let packing = match tag.attribute("compression") {
        None | Some(b"") => Packing::None,
        Some(b"zlib") => Packing::Zlib,
        Some(b"gzip") => Packing::Gzip,
        Some(b"zstd") => Packing::Zstd,
        Some(other) => return Err(invalid(format!("compression '{}' is not known", String::from_utf8_lossy(other)))),
    };
    match tag.attribute("encoding") {
        None => Ok(Encoding::Elements),
        Some(b"csv") => Ok(Encoding::Csv),
        Some(b"base64") => Ok(Encoding::Base64(packing)),
        Some(other) => Err(invalid(format!("encoding '{}' is not known", String::from_utf8_lossy(other)))),
    }
}

/// A property that names a shape becomes text whatever its type, so that a bad value is told with the tile that has it.
fn write_property(out: &mut Vec<u8>, tag: Tag<'_>) {
    let Some(name) = kept(tag) else {
        out.extend_from_slice(tag.0);
        return;
    };
    out.extend_from_slice(format!("<property name=\"{name}\"").as_bytes());
    if let Some(value) = tag.attribute("value") {
        out.extend_from_slice(b" value=\"");
        for &b in value {
            out.extend_from_slice(if b == b'"' { b"&quot;" } else { std::slice::from_ref(&b) });
        }
        out.push(b'"');
    }
    out.extend_from_slice(if tag.is_empty() { b"/>" } else { b">" });
}

fn write_tileset(out: &mut Vec<u8>, tag: Tag<'_>) -> Result<()> {
    let end = tag.0.len() - if tag.is_empty() { 2 } else { 1.min(tag.0.len()) };
    let (start, end) = tag.0.split_at(end);
    out.extend_from_slice(start);
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
    out.extend_from_slice(end);
    Ok(())
}

/// A tile as an element becomes an item of a list.
fn list_gid(out: &mut Vec<u8>, tag: Tag<'_>) {
    if tag.name() == b"tile" && !tag.closes() {
        if !out.is_empty() {
            out.push(b',');
        }
        out.extend_from_slice(tag.attribute("gid").unwrap_or(b"0"));
    }
}

/// What is no number is too large a one: the crate's parser and this one must not read it differently.
fn number(text: &[u8]) -> u64 {
    std::str::from_utf8(text).ok().and_then(|text| text.parse().ok()).unwrap_or(u64::MAX)
}
