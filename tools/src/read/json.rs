//! Files in JSON.

use super::text::unmarked;
use serde::Deserialize;

/// The depth of nested lists and members. Groups of Tiled nest as deep as in XML: two of these
/// each.
const MAX_DEPTH: usize = 208;

/// Whether a file contains JSON. Everything else is XML.
pub(in crate::read) fn is_json(bytes: &[u8]) -> bool {
    let text = unmarked(bytes).trim_ascii_start();
    text.starts_with(b"{") || text.starts_with(b"[")
}

/// Its members, by name. A list would be read as members without names.
pub(in crate::read) fn parse<'a, T: Deserialize<'a>>(bytes: &'a [u8]) -> Result<T, String> {
    if unmarked(bytes).trim_ascii_start().starts_with(b"[") {
        return Err("it is a list of JSON, in [], and such a file has members, in {}".to_owned());
    }
    list(bytes)
}

/// A list, or members.
pub(in crate::read) fn list<'a, T: Deserialize<'a>>(bytes: &'a [u8]) -> Result<T, String> {
    let bytes = unmarked(bytes);
    let mut depth = 0usize;
    for mark in (Marks { bytes, at: 0 }) {
        depth = mark.depth(depth);
        if depth > MAX_DEPTH {
            return Err(format!("lists and members nested more than {MAX_DEPTH} deep: use fewer groups in groups"));
        }
    }
    let mut reader = serde_json::Deserializer::from_slice(bytes);
    // Its own limit is lower than that of XML here.
    reader.disable_recursion_limit();
    T::deserialize(&mut reader).and_then(|read| reader.end().map(|()| read)).map_err(|e| e.to_string())
}

/// The names of its members, not of those within them. Damaged text has the names up to the damage.
pub(in crate::read) fn keys(bytes: &[u8]) -> Vec<&[u8]> {
    let (mut keys, mut depth, mut last) = (Vec::new(), 0, None);
    for mark in (Marks { bytes, at: 0 }) {
        depth = mark.depth(depth);
        match mark {
            Mark::Text(text) => last = Some(text).filter(|_| depth == 1),
            Mark::Sign(b':') => keys.extend(last.take()),
            Mark::Sign(_) => {}
        }
    }
    keys
}

/// A text, or a sign outside of texts.
#[derive(Debug, Clone, Copy)]
enum Mark<'a> {
    Text(&'a [u8]),
    Sign(u8),
}

impl Mark<'_> {
    /// The depth after it.
    fn depth(self, before: usize) -> usize {
        match self {
            Mark::Sign(b'{' | b'[') => before + 1,
            Mark::Sign(b'}' | b']') => before.saturating_sub(1),
            _ => before,
        }
    }
}

/// The marks of a file, up to a text without an end.
struct Marks<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Iterator for Marks<'a> {
    type Item = Mark<'a>;

    fn next(&mut self) -> Option<Self::Item> {
        let rest = self.bytes.get(self.at..)?;
        let first = rest.iter().position(|byte| b"{}[]:\"".contains(byte))?;
        let begin = self.at + first + 1;
        self.at = begin;
        if rest[first] != b'"' {
            return Some(Mark::Sign(rest[first]));
        }
        let mut escaped = false;
        for (i, byte) in self.bytes.iter().enumerate().skip(begin) {
            match byte {
                b'"' if !escaped => {
                    self.at = i + 1;
                    return Some(Mark::Text(&self.bytes[begin..i]));
                }
                byte => escaped = !escaped && *byte == b'\\',
            }
        }
        self.at = self.bytes.len();
        None
    }
}
