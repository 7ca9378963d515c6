//! The object layers of a Tiled map, tag by tag.

use super::object::{Layer, Object, text};
use super::xml::{Part, Tag, parts};
use crate::read::decimal::Decimal;
use crate::read::outline::{LeftOut, Outline};

/// An element that is open.
struct Open<'a> {
    name: &'a [u8],
    /// Of the layers around.
    offset: (Decimal, Decimal),
}

#[derive(Default)]
struct Reader<'a> {
    open: Vec<Open<'a>>,
    layer: Option<Layer>,
    object: Option<Object>,
    outlines: Vec<Outline>,
    left_out: Vec<LeftOut>,
}

/// The outlines of all object layers in drawing order, and the objects that are none.
pub(crate) fn read(bytes: &[u8]) -> Result<(Vec<Outline>, Vec<LeftOut>), String> {
    let mut reader = Reader::default();
    let mut offset = 0;
    for part in parts(bytes) {
        match part {
            Part::Plain(text) => offset += text.len(),
            Part::Tag(tag) => {
                reader.tag(tag).map_err(|why| format!("line {}: {why}", line(bytes, offset)))?;
                offset += tag.0.len();
            }
        }
    }
    match reader.open.last() {
        None => Ok((reader.outlines, reader.left_out)),
        Some(open) => Err(format!("the file ends within <{}>", text(open.name))),
    }
}

fn line(bytes: &[u8], offset: usize) -> usize {
    1 + bytes.iter().take(offset).filter(|&&b| b == b'\n').count()
}

impl<'a> Reader<'a> {
    fn tag(&mut self, tag: Tag<'a>) -> Result<(), String> {
        if !tag.0.ends_with(b">") {
            return Err("the file ends within a tag".to_owned());
        }
        if tag.closes() {
            match self.open.pop() {
                Some(open) if open.name == tag.name() => self.close(&open),
                Some(open) => Err(format!("</{}> closes <{}>", text(tag.name()), text(open.name))),
                None => Err(format!("</{}> closes nothing", text(tag.name()))),
            }
        } else {
            let open = self.start(tag)?;
            if tag.is_empty() {
                return self.close(&open);
            }
            self.open.push(open);
            Ok(())
        }
    }

    /// The name of the element `back` levels out, 0 being the innermost.
    fn around(&self, back: usize) -> &[u8] {
        self.open.iter().rev().nth(back).map_or(b"", |open| open.name)
    }

    fn start(&mut self, tag: Tag<'a>) -> Result<Open<'a>, String> {
        let mut offset = self.open.last().map_or((Decimal::ZERO, Decimal::ZERO), |open| open.offset);
        match tag.name() {
            name @ (b"group" | b"objectgroup") => {
                let number = |name: &str| match tag.attribute(name) {
                    None => Ok(Decimal::ZERO),
                    Some(digits) => {
                        Decimal::parse(digits).ok_or_else(|| format!("{name} is '{}', no number", text(digits)))
                    }
                };
                offset = (offset.0 + number("offsetx")?, offset.1 + number("offsety")?);
                // Tiles have object layers too, for their collision shapes.
                if name == b"objectgroup" && !self.open.iter().any(|open| open.name == b"tileset") {
                    let name = tag.attribute("name").map(text).unwrap_or_default();
                    let class = tag.attribute("class").map(text).unwrap_or_default();
                    self.layer = Some(Layer { name, class });
                }
            }
            b"object" if self.layer.is_some() => {
                if self.object.is_some() {
                    return Err("an object within an object".to_owned());
                }
                self.object = Some(Object::start(tag)?);
            }
            b"property" if self.around(0) == b"properties" && self.around(1) == b"object" => {
                if let Some(object) = &mut self.object {
                    object.property(tag);
                }
            }
            _ if self.around(0) == b"object" => {
                if let Some(object) = &mut self.object {
                    object.part(tag)?;
                }
            }
            _ => {}
        }
        Ok(Open { name: tag.name(), offset })
    }

    fn close(&mut self, open: &Open<'a>) -> Result<(), String> {
        match open.name {
            b"objectgroup" => self.layer = None,
            b"object" => {
                if let (Some(object), Some(layer)) = (self.object.take(), &self.layer) {
                    match object.finish(layer, open.offset)? {
                        Ok(outline) => self.outlines.push(outline),
                        Err(left_out) => self.left_out.push(left_out),
                    }
                }
            }
            _ => {}
        }
        Ok(())
    }
}
