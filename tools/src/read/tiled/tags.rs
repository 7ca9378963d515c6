//! The XML of Tiled: maps, tilesets and templates, element by element.

use super::raw::{
    Chunk, Data, Layer, Listed, Map, Number, Object, ObjectType, Point, Template, Tile, Tileset, special,
};
use crate::model::decimal::Decimal;
use crate::model::object::Spot;
use crate::model::property::{Properties, Value};
use crate::read::xml::{Event, Tag, Xml};

type Result<T> = std::result::Result<T, String>;

pub(super) fn map(bytes: &[u8]) -> Result<Map> {
    let (mut xml, tag) = open(bytes, "map")?;
    let mut map = Map {
        orientation: tag.text("orientation"),
        class: tag.text("class"),
        width: number(&xml, &tag, "width")?,
        height: number(&xml, &tag, "height")?,
        tilewidth: number(&xml, &tag, "tilewidth")?,
        tileheight: number(&xml, &tag, "tileheight")?,
        infinite: tag.get("infinite") == Some("1"),
        ..Map::default()
    };
    while let Some(tag) = xml.child()? {
        if tag.name == "tileset" {
            map.tilesets.push(tileset(&mut xml, &tag)?);
        } else if tag.name == "properties" {
            map.properties = properties(&mut xml)?;
        } else if let Some(layer) = layer(&mut xml, &tag)? {
            map.layers.push(layer);
        }
    }
    ends(&mut xml)?;
    Ok(map)
}

pub(super) fn tileset_file(bytes: &[u8]) -> Result<Tileset> {
    let (mut xml, tag) = open(bytes, "tileset")?;
    let tileset = tileset(&mut xml, &tag)?;
    ends(&mut xml)?;
    Ok(tileset)
}

pub(super) fn template(bytes: &[u8]) -> Result<Template> {
    let (mut xml, _) = open(bytes, "template")?;
    let mut template = Template::default();
    while let Some(tag) = xml.child()? {
        match tag.name {
            "tileset" => template.tileset = Some(tileset(&mut xml, &tag)?),
            "object" => template.object = Some(object(&mut xml, &tag)?),
            _ => xml.skip()?,
        }
    }
    ends(&mut xml)?;
    Ok(template)
}

fn open<'a>(bytes: &'a [u8], name: &str) -> Result<(Xml<'a>, Tag<'a>)> {
    let mut xml = Xml::new(bytes)?;
    let tag = xml.root()?;
    if tag.name == name { Ok((xml, tag)) } else { Err(format!("it begins with <{}>", tag.name)) }
}

/// Only white space may follow the element.
fn ends(xml: &mut Xml<'_>) -> Result<()> {
    loop {
        match xml.next()? {
            Event::End => return Ok(()),
            Event::Text(text) if text.trim().is_empty() => {}
            _ => return Err(xml.here("something after the last element")),
        }
    }
}

/// A whole number, or 0 if it is missing.
fn number<T: std::str::FromStr + Default>(xml: &Xml<'_>, tag: &Tag<'_>, name: &str) -> Result<T> {
    Ok(count(xml, tag, name)?.unwrap_or_default())
}

fn count<T: std::str::FromStr>(xml: &Xml<'_>, tag: &Tag<'_>, name: &str) -> Result<Option<T>> {
    let bad = |text: &str| xml.here(&format!("<{}> has {name}=\"{text}\"", tag.name));
    let read = |text: &str| text.parse().ok().or_else(|| whole(text)?.parse().ok());
    tag.get(name).map(|text| read(text.trim()).ok_or_else(|| bad(text))).transpose()
}

/// A whole number as programs write it that count in decimals: `16.0`.
fn whole(text: &str) -> Option<&str> {
    let (whole, part) = text.split_once('.')?;
    part.bytes().all(|digit| digit == b'0').then_some(whole)
}

fn decimal(xml: &Xml<'_>, tag: &Tag<'_>, name: &str) -> Result<Option<Number>> {
    let read = |text: &str| match Decimal::saturated(text.as_bytes()) {
        Some(value) => Ok(Number(value)),
        None => Err(xml.here(&format!("{}: {name} is '{text}', not a number{}", whose(tag), comma(text)))),
    };
    tag.get(name).map(read).transpose()
}

/// What is wrong with a number of another language.
fn comma(text: &str) -> &'static str {
    if text.contains(',') { ": write a point, not a comma" } else { "" }
}

fn whose(tag: &Tag<'_>) -> String {
    match tag.get("id") {
        Some(id) if tag.name == "object" => format!("object {id}"),
        _ => format!("<{}>", tag.name),
    }
}

fn tileset(xml: &mut Xml<'_>, tag: &Tag<'_>) -> Result<Tileset> {
    let mut set = Tileset {
        firstgid: number(xml, tag, "firstgid")?,
        source: tag.get("source").map(str::to_owned),
        name: tag.text("name"),
        class: tag.text("class"),
        tilewidth: number(xml, tag, "tilewidth")?,
        tileheight: number(xml, tag, "tileheight")?,
        tilecount: count(xml, tag, "tilecount")?,
        columns: number(xml, tag, "columns")?,
        margin: number(xml, tag, "margin")?,
        spacing: number(xml, tag, "spacing")?,
        tilerendersize: tag.text("tilerendersize"),
        fillmode: tag.text("fillmode"),
        objectalignment: tag.text("objectalignment"),
        ..Tileset::default()
    };
    while let Some(tag) = xml.child()? {
        match tag.name {
            "image" => {
                (set.image, set.imagewidth, set.imageheight) = image(xml, &tag)?;
                xml.skip()?;
            }
            "tileoffset" => {
                (set.tileoffset.x, set.tileoffset.y) = (number(xml, &tag, "x")?, number(xml, &tag, "y")?);
                xml.skip()?;
            }
            "properties" => set.properties = properties(xml)?,
            "tile" => {
                let tile = tile(xml, &tag)?;
                set.tiles.0.push(tile);
            }
            _ => xml.skip()?,
        }
    }
    Ok(set)
}

fn image(xml: &Xml<'_>, tag: &Tag<'_>) -> Result<(Option<String>, u32, u32)> {
    Ok((tag.get("source").map(str::to_owned), number(xml, tag, "width")?, number(xml, tag, "height")?))
}

fn tile(xml: &mut Xml<'_>, tag: &Tag<'_>) -> Result<Tile> {
    let class = tag.get("type").or(tag.get("class")).unwrap_or_default().to_owned();
    let mut tile = Tile {
        id: number(xml, tag, "id")?,
        class,
        x: number(xml, tag, "x")?,
        y: number(xml, tag, "y")?,
        width: number(xml, tag, "width")?,
        height: number(xml, tag, "height")?,
        ..Tile::default()
    };
    while let Some(tag) = xml.child()? {
        match tag.name {
            "properties" => tile.properties = properties(xml)?,
            "objectgroup" => tile.objectgroup = layer(xml, &tag)?.map(Box::new),
            "image" => {
                (tile.image, tile.imagewidth, tile.imageheight) = image(xml, &tag)?;
                xml.skip()?;
            }
            _ => xml.skip()?,
        }
    }
    Ok(tile)
}

fn properties(xml: &mut Xml<'_>) -> Result<Listed> {
    let mut all = Vec::new();
    while let Some(tag) = xml.child()? {
        let name = tag.text("name");
        let mut text = tag.text("value");
        // Text of several lines is the content of the element.
        loop {
            match xml.next()? {
                Event::Start(_) => xml.skip()?,
                Event::Text(inner) if tag.get("value").is_none() => text.push_str(&inner),
                Event::Text(_) => {}
                Event::End => break,
            }
        }
        all.extend(value(tag.get("type"), text).map(|value| (name, value)));
    }
    Ok(Listed(Properties(all)))
}

/// The value of a property of this type.
fn value(form: Option<&str>, text: String) -> Option<Value> {
    match form {
        Some("bool") => Some(Value::Bool(truth(&text))),
        // The default of a number.
        Some("int" | "float") if text.trim().is_empty() => Some(Value::Number("0".to_owned())),
        Some("int" | "float") => Some(Value::Number(text)),
        None | Some("string" | "file" | "color") => Some(Value::Text(text)),
        Some(other) => special(other, &text),
    }
}

/// The object types of a project before Tiled 1.9, and what each gives its tiles and objects.
pub(super) fn object_types(bytes: &[u8]) -> Result<Vec<ObjectType>> {
    let (mut xml, _) = open(bytes, "objecttypes")?;
    let mut types = Vec::new();
    while let Some(tag) = xml.child()? {
        let mut own = ObjectType { name: tag.text("name"), ..ObjectType::default() };
        while let Some(tag) = xml.child()? {
            let given = value(tag.get("type"), tag.text("default"));
            own.properties.0.0.extend(given.map(|given| (tag.text("name"), given)));
            xml.skip()?;
        }
        types.push(own);
    }
    ends(&mut xml)?;
    Ok(types)
}

/// As Tiled reads it: everything is true, except 0, the word false and nothing.
fn truth(text: &str) -> bool {
    !["", "0", "false"].iter().any(|no| text.trim().eq_ignore_ascii_case(no))
}

/// A layer, a group of layers, or nothing of the kind.
fn layer(xml: &mut Xml<'_>, tag: &Tag<'_>) -> Result<Option<Layer>> {
    let form = match tag.name {
        "layer" => "tilelayer",
        "objectgroup" => "objectgroup",
        "imagelayer" => "imagelayer",
        "group" => "group",
        _ => {
            xml.skip()?;
            return Ok(None);
        }
    };
    let mut read = Layer {
        form: form.to_owned(),
        name: tag.text("name"),
        class: tag.text("class"),
        offsetx: decimal(xml, tag, "offsetx")?.unwrap_or_default(),
        offsety: decimal(xml, tag, "offsety")?.unwrap_or_default(),
        visible: tag.get("visible") != Some("0"),
        ..Layer::default()
    };
    read.parallaxx = decimal(xml, tag, "parallaxx")?.unwrap_or(read.parallaxx);
    read.parallaxy = decimal(xml, tag, "parallaxy")?.unwrap_or(read.parallaxy);
    read.opacity = decimal(xml, tag, "opacity")?.unwrap_or(read.opacity);
    if form == "tilelayer" {
        (read.x, read.y) = (number(xml, tag, "x")?, number(xml, tag, "y")?);
        (read.width, read.height) = (number(xml, tag, "width")?, number(xml, tag, "height")?);
    }
    while let Some(tag) = xml.child()? {
        match (tag.name, form) {
            ("properties", _) => read.properties = properties(xml)?,
            ("data", "tilelayer") => data(xml, &tag, &mut read)?,
            ("object", "objectgroup") => {
                let object = object(xml, &tag)?;
                read.objects.push(object);
            }
            (_, "group") => read.layers.extend(layer(xml, &tag)?),
            _ => xml.skip()?,
        }
    }
    Ok(Some(read))
}

fn data(xml: &mut Xml<'_>, tag: &Tag<'_>, layer: &mut Layer) -> Result<()> {
    // Without an encoding, each tile is an element.
    layer.encoding = Some(tag.get("encoding").unwrap_or("xml").to_owned());
    layer.compression = tag.get("compression").map(str::to_owned);
    let (data, chunks) = cells(xml, layer.encoding.as_deref() == Some("xml"))?;
    layer.chunks.extend(chunks);
    layer.data = Some(data);
    Ok(())
}

/// Tiles up to the end of the element, and chunks, which only the data of a layer has.
fn cells(xml: &mut Xml<'_>, elements: bool) -> Result<(Data, Vec<Chunk>)> {
    let (mut gids, mut text, mut chunks) = (Vec::new(), String::new(), Vec::new());
    loop {
        match xml.next()? {
            Event::Start(tag) if tag.name == "tile" && elements => {
                gids.push(number(xml, &tag, "gid")?);
                xml.skip()?;
            }
            Event::Start(tag) if tag.name == "chunk" => {
                let (x, y) = (number(xml, &tag, "x")?, number(xml, &tag, "y")?);
                let (width, height) = (number(xml, &tag, "width")?, number(xml, &tag, "height")?);
                let (data, _) = cells(xml, elements)?;
                chunks.push(Chunk { x, y, width, height, data: Some(data) });
            }
            Event::Start(_) => xml.skip()?,
            Event::Text(part) if !elements => text.push_str(&part),
            Event::Text(_) => {}
            Event::End => return Ok((if elements { Data::List(gids) } else { Data::Text(text) }, chunks)),
        }
    }
}

fn object(xml: &mut Xml<'_>, tag: &Tag<'_>) -> Result<Object> {
    let id = tag.get("id").map_or(Ok(0), str::parse);
    let mut object = Object {
        id: id.map_err(|_| xml.here(&format!("an object with the id '{}'", tag.text("id"))))?,
        name: tag.get("name").map(str::to_owned),
        class: tag.get("type").or(tag.get("class")).map(str::to_owned),
        x: decimal(xml, tag, "x")?.unwrap_or_default(),
        y: decimal(xml, tag, "y")?.unwrap_or_default(),
        width: decimal(xml, tag, "width")?,
        height: decimal(xml, tag, "height")?,
        rotation: decimal(xml, tag, "rotation")?,
        gid: count(xml, tag, "gid")?,
        visible: tag.get("visible").map(|value| value != "0"),
        template: tag.get("template").map(str::to_owned),
        ..Object::default()
    };
    while let Some(tag) = xml.child()? {
        match tag.name {
            "properties" => {
                object.properties = properties(xml)?;
                continue;
            }
            "ellipse" => object.ellipse = true,
            "capsule" => object.capsule = true,
            "point" => object.point = true,
            "text" => object.text = true,
            "polygon" => object.polygon = Some(points(xml, &tag, object.id)?),
            "polyline" => object.polyline = Some(points(xml, &tag, object.id)?),
            "object" => return Err(xml.here("an object within an object")),
            _ => {}
        }
        xml.skip()?;
    }
    Ok(object)
}

fn points(xml: &Xml<'_>, tag: &Tag<'_>, id: u32) -> Result<Vec<Point>> {
    let list = tag.get("points").ok_or_else(|| xml.here(&format!("object {id} has no points")))?;
    let coordinate = |what: &str, text: &str| {
        let bad = || xml.here(&format!("object {id}: a point's {what} is '{text}', not a number{}", comma(text)));
        Decimal::saturated(text.as_bytes()).ok_or_else(bad)
    };
    let pair = |pair: &str| -> Result<Point> {
        let (x, y) = pair.split_once(',').unwrap_or((pair, ""));
        let spot: Spot = (coordinate("x", x)?, coordinate("y", y)?);
        Ok(spot.into())
    };
    list.split_ascii_whitespace().map(pair).collect()
}
