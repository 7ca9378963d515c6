//! Just enough XML for the files of Tiled. Reads tag by tag, with limits on everything that could
//! grow.
//!
//! Only the five entities of XML and numbers. Skips a document type. Of namespaces it knows a
//! prefix of the first element: names with that prefix are read without it.

use super::text::unmarked;
use std::borrow::Cow;

/// The depth of nested elements.
const MAX_DEPTH: usize = 100;
/// Attributes of one tag. Tiled writes at most about twenty.
const MAX_ATTRIBUTES: usize = 500;

type Result<T> = std::result::Result<T, String>;

/// The next part of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Event<'a> {
    /// A child begins. Its own events come before those of the element around it.
    Start(Tag<'a>),
    Text(Cow<'a, str>),
    /// The element ends.
    End,
}

/// The name and the attributes of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Tag<'a> {
    pub(super) name: &'a str,
    attributes: Vec<(&'a str, Cow<'a, str>)>,
}

impl Tag<'_> {
    pub(super) fn get(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| *key == name).map(|(_, value)| &**value)
    }

    /// The attribute as text. Empty if it is missing.
    pub(super) fn text(&self, name: &str) -> String {
        self.get(name).unwrap_or_default().to_owned()
    }
}

/// A position in a document.
pub(super) struct Xml<'a> {
    text: &'a str,
    at: usize,
    open: Vec<&'a str>,
    /// Names that a document type declares. Nothing resolves them.
    entities: Vec<&'a str>,
    /// What the names of elements begin with, such as `t:`. Empty before the first element.
    prefix: &'a str,
    /// The last opened element closes in the same tag.
    empty: bool,
}

impl<'a> Xml<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self> {
        let bytes = unmarked(bytes);
        let text = std::str::from_utf8(bytes)
            .map_err(|e| format!("line {}: not UTF-8 text: save it as UTF-8", line(&bytes[..e.valid_up_to()])))?;
        Ok(Self { text, at: 0, open: Vec::new(), entities: Vec::new(), prefix: "", empty: false })
    }

    /// Adds the current line before the message.
    pub(super) fn here(&self, why: &str) -> String {
        format!("line {}: {why}", line(&self.text.as_bytes()[..self.at.min(self.text.len())]))
    }

    /// The element of the document.
    pub(super) fn root(&mut self) -> Result<Tag<'a>> {
        loop {
            match self.next()? {
                Event::Start(tag) => return Ok(tag),
                Event::Text(text) if text.trim().is_empty() => {}
                Event::Text(_) => return Err(self.here("text before the first element")),
                Event::End => return Err("there is no element".to_owned()),
            }
        }
    }

    /// The next child of the open element. `None` at its end.
    pub(super) fn child(&mut self) -> Result<Option<Tag<'a>>> {
        loop {
            match self.next()? {
                Event::Start(tag) => return Ok(Some(tag)),
                Event::Text(_) => {}
                Event::End => return Ok(None),
            }
        }
    }

    /// Skips to the end of the open element.
    pub(super) fn skip(&mut self) -> Result<()> {
        let depth = self.open.len();
        while self.open.len() >= depth {
            self.next()?;
        }
        Ok(())
    }

    pub(super) fn next(&mut self) -> Result<Event<'a>> {
        if std::mem::take(&mut self.empty) {
            self.open.pop();
            return Ok(Event::End);
        }
        loop {
            let rest = &self.text[self.at..];
            if rest.is_empty() {
                return match self.open.last() {
                    None => Ok(Event::End),
                    Some(name) => Err(self.here(&format!("the file ends within <{name}>"))),
                };
            }
            if let Some(inner) = rest.strip_prefix("<![CDATA[") {
                let end = inner.find("]]>").ok_or_else(|| self.here("the file ends within a CDATA section"))?;
                self.at += "<![CDATA[]]>".len() + end;
                return Ok(Event::Text(Cow::Borrowed(&inner[..end])));
            }
            if let Some(length) = self.passed(rest)? {
                self.at += length;
            } else if rest.starts_with("<!") {
                let length = self.declaration(rest)?;
                let declared = rest[..length].split("<!ENTITY").skip(1);
                self.entities.extend(declared.filter_map(|inner| inner.split_ascii_whitespace().next()));
                self.at += length;
            } else if let Some(inner) = rest.strip_prefix("</") {
                return self.close(inner);
            } else if let Some(inner) = rest.strip_prefix('<') {
                return self.start(inner);
            } else {
                let end = rest.find('<').unwrap_or(rest.len());
                self.at += end;
                return Ok(Event::Text(self.resolved(&rest[..end])?));
            }
        }
    }

    /// The length of a comment or an instruction, if the text begins with one.
    fn passed(&self, rest: &str) -> Result<Option<usize>> {
        let both = [("<!--", "-->"), ("<?", "?>")];
        let Some((begin, end)) = both.iter().find(|(begin, _)| rest.starts_with(begin)) else { return Ok(None) };
        let length = rest[begin.len()..].find(end).ok_or_else(|| self.here("the file ends within a comment"))?;
        Ok(Some(begin.len() + length + end.len()))
    }

    /// The length of a document type, whose own declarations are in brackets.
    fn declaration(&self, rest: &str) -> Result<usize> {
        let (mut depth, mut quote, mut after) = (0usize, None, 0);
        for (i, b) in rest.bytes().enumerate() {
            if i < after {
                continue;
            }
            match (quote, b) {
                (Some(q), _) if q == b => quote = None,
                (None, b'"' | b'\'') => quote = Some(b),
                // An apostrophe in a comment is no quote.
                (None, b'<') => match self.passed(&rest[i..])? {
                    Some(length) => after = i + length,
                    None => depth += 1,
                },
                (None, b'>') => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                return Ok(i + 1);
            }
        }
        Err(self.here("the file ends within a declaration"))
    }

    fn resolved<'b>(&self, raw: &'b str) -> Result<Cow<'b, str>> {
        let used = |name: &&&str| raw.split('&').skip(1).any(|part| part.split(';').next() == Some(**name));
        match self.entities.iter().find(used) {
            Some(name) => Err(self.here(&format!("&{name}; is declared in the document type: write its text instead"))),
            None => Ok(resolved(raw)),
        }
    }

    fn close(&mut self, inner: &'a str) -> Result<Event<'a>> {
        let end = inner.find('>').ok_or_else(|| self.here("the file ends within a tag"))?;
        let name = inner[..end].trim_end();
        match self.open.pop() {
            Some(open) if open == name => {
                self.at += end + "</>".len();
                Ok(Event::End)
            }
            Some(open) => Err(self.here(&format!("</{name}> closes <{open}>"))),
            None => Err(self.here(&format!("</{name}> closes nothing"))),
        }
    }

    fn start(&mut self, inner: &'a str) -> Result<Event<'a>> {
        let is_end = |c: char| c.is_ascii_whitespace() || "/>=\"'<".contains(c);
        let cut = |xml: &Self| xml.here("the file ends within a tag");
        let length = inner.find(is_end).ok_or_else(|| cut(self))?;
        let name = &inner[..length];
        if name.is_empty() {
            return Err(self.here("a tag without a name"));
        }
        if self.open.len() >= MAX_DEPTH {
            return Err(self.here(&format!("elements nested more than {MAX_DEPTH} deep")));
        }
        if self.open.is_empty() {
            self.prefix = name.find(':').map_or("", |colon| &name[..=colon]);
        }
        let prefix = self.prefix;
        let own = |name: &'a str| name.strip_prefix(prefix).unwrap_or(name);
        let mut tag = Tag { name: own(name), attributes: Vec::new() };
        let mut rest = inner[length..].trim_start();
        loop {
            let closed = rest.strip_prefix("/>").map(|after| (after, true));
            if let Some((after, empty)) = closed.or_else(|| rest.strip_prefix('>').map(|after| (after, false))) {
                self.at = self.text.len() - after.len();
                self.open.push(name);
                self.empty = empty;
                return Ok(Event::Start(tag));
            }
            let length = rest.find(is_end).ok_or_else(|| cut(self))?;
            let (key, after) = rest.split_at(length);
            let after = after.trim_start().strip_prefix('=').map(str::trim_start);
            let quoted =
                after.and_then(|after| Some((after.chars().next().filter(|c| "\"'".contains(*c))?, &after[1..])));
            let Some((quote, value)) = quoted.filter(|_| !key.is_empty()) else {
                return Err(self.here(&format!("<{name}> has something that is not an attribute")));
            };
            let end = value.find(quote).ok_or_else(|| cut(self))?;
            if tag.attributes.len() == MAX_ATTRIBUTES {
                return Err(self.here(&format!("<{name}> has more than {MAX_ATTRIBUTES} attributes")));
            }
            tag.attributes.push((own(key), self.resolved(&value[..end])?));
            rest = value[end + 1..].trim_start();
        }
    }
}

fn line(before: &[u8]) -> usize {
    1 + before.split(|&b| b == b'\n').count().saturating_sub(1)
}

/// Resolves entities in text. Unknown ones stay unchanged.
fn resolved(raw: &str) -> Cow<'_, str> {
    if !raw.contains('&') {
        return Cow::Borrowed(raw);
    }
    let mut out = String::with_capacity(raw.len());
    let mut rest = raw;
    while let Some(start) = rest.find('&') {
        out.push_str(&rest[..start]);
        rest = &rest[start + 1..];
        // The longest is a number: `#x10ffff`.
        let end = rest.bytes().take(9).position(|b| b == b';');
        let entity = end.map_or("", |end| &rest[..end]);
        let code = match (entity.strip_prefix("#x"), entity.strip_prefix('#')) {
            (Some(hex), _) => u32::from_str_radix(hex, 16).ok().and_then(char::from_u32),
            (None, Some(decimal)) => decimal.parse().ok().and_then(char::from_u32),
            (None, None) => {
                let known = [("amp", '&'), ("lt", '<'), ("gt", '>'), ("quot", '"'), ("apos", '\'')];
                known.iter().find(|(name, _)| *name == entity).map(|&(_, c)| c)
            }
        };
        match (code, end) {
            (Some(code), Some(end)) => {
                out.push(code);
                rest = &rest[end + 1..];
            }
            _ => out.push('&'),
        }
    }
    out.push_str(rest);
    Cow::Owned(out)
}
