//! Just enough XML to walk over a file tag by tag.

/// A part of a file; all parts together are the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part<'a> {
    /// Text, comments and declarations.
    Plain(&'a [u8]),
    Tag(Tag<'a>),
}

/// What stands between `<` and `>`, both included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Tag<'a>(pub &'a [u8]);

pub(super) fn parts(mut rest: &[u8]) -> impl Iterator<Item = Part<'_>> {
    std::iter::from_fn(move || {
        let length = match rest {
            [] => return None,
            [b'<', b'!', b'-', b'-', ..] => through(rest, b"-->"),
            [b'<', b'!', b'[', ..] => through(rest, b"]]>"),
            [b'<', ..] => tag_length(rest),
            _ => rest.iter().position(|&b| b == b'<').unwrap_or(rest.len()),
        };
        let (part, after) = rest.split_at(length);
        rest = after;
        Some(match part {
            [b'<', b'!' | b'?', ..] => Part::Plain(part),
            [b'<', ..] => Part::Tag(Tag(part)),
            _ => Part::Plain(part),
        })
    })
}

fn through(text: &[u8], end: &[u8]) -> usize {
    text.windows(end.len()).position(|w| w == end).map_or(text.len(), |at| at + end.len())
}

/// To the closing `>`, which may also stand inside a quoted value.
fn tag_length(text: &[u8]) -> usize {
    let mut quote = None;
    for (i, &b) in text.iter().enumerate() {
        match (quote, b) {
            (None, b'>') => return i + 1,
            (None, b'"' | b'\'') => quote = Some(b),
            (Some(q), _) if q == b => quote = None,
            _ => {}
        }
    }
    text.len()
}

impl<'a> Tag<'a> {
    /// `</...>`
    pub(super) fn closes(self) -> bool {
        self.0.starts_with(b"</")
    }

    /// `<.../>`
    pub(super) fn is_empty(self) -> bool {
        self.0.ends_with(b"/>")
    }

    /// With its prefix, where it has one.
    pub(super) fn name(self) -> &'a [u8] {
        let name = self.0.strip_prefix(b"<").unwrap_or_default();
        let name = name.strip_prefix(b"/").unwrap_or(name);
        let name = name.strip_suffix(b">").unwrap_or(name);
        let name = name.strip_suffix(b"/").unwrap_or(name);
        let end = name.iter().position(u8::is_ascii_whitespace).unwrap_or(name.len());
        &name[..end]
    }

    pub(super) fn attribute(self, name: &str) -> Option<&'a [u8]> {
        self.attributes().find(|(key, _)| *key == name.as_bytes()).map(|(_, value)| value)
    }

    /// Keys and values, up to the first that is not `key="value"`.
    pub(super) fn attributes(self) -> impl Iterator<Item = (&'a [u8], &'a [u8])> {
        let mut rest = self.0.get(1 + self.name().len()..).unwrap_or_default();
        std::iter::from_fn(move || {
            let equals = rest.iter().position(|&b| b == b'=')?;
            let (key, after) = rest.split_at(equals);
            let open = after.iter().position(|b| b"\"'".contains(b))?;
            let value = &after[open + 1..];
            let close = value.iter().position(|&b| b == after[open])?;
            rest = &value[close + 1..];
            Some((key.trim_ascii(), &value[..close]))
        })
    }
}
