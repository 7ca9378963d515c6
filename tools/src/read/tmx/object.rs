//! One object of a Tiled object layer: what stands in the file, and the outline it means.

use super::xml::Tag;
use crate::read::decimal::Decimal;
use crate::read::outline::{LeftOut, Outline, Title};
use crate::rules::kind::Kind;

type Spot = (Decimal, Decimal);

/// What an object is drawn as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Form {
    #[default]
    Rectangle,
    Polygon,
    Polyline,
    Point,
    /// What has no straight edges, by its name.
    Round(&'static str),
    Text,
    /// A picture out of a tileset.
    Tile,
    Template,
}

/// An object while it is being read.
#[derive(Debug, Clone, Default)]
pub(super) struct Object {
    id: u32,
    name: String,
    class: String,
    at: Spot,
    size: Spot,
    /// Degrees, clockwise where y grows downward.
    rotation: Decimal,
    form: Form,
    points: Vec<Spot>,
    /// The property `kind`.
    kind: Option<String>,
    /// Names of true properties.
    marks: Vec<String>,
}

/// The object layer around it.
#[derive(Debug, Clone)]
pub(super) struct Layer {
    pub name: String,
    pub class: String,
}

impl Object {
    pub(super) fn start(tag: Tag<'_>) -> Result<Self, String> {
        let mut object = Self::default();
        if let Some(id) = tag.attribute("id") {
            let id = text(id);
            object.id = id.parse().map_err(|_| format!("an object with the id '{id}'"))?;
        }
        object.name = tag.attribute("name").map(text).unwrap_or_default();
        object.class = tag.attribute("type").or(tag.attribute("class")).map(text).unwrap_or_default();
        let whose = object.whose();
        let number = |name: &str| number(&whose, name, tag.attribute(name).unwrap_or(b"0"));
        object.at = (number("x")?, number("y")?);
        object.size = (number("width")?, number("height")?);
        object.rotation = number("rotation")?;
        if tag.attribute("template").is_some() {
            object.form = Form::Template;
        } else if tag.attribute("gid").is_some() {
            object.form = Form::Tile;
        }
        Ok(object)
    }

    /// An element directly within the object.
    pub(super) fn part(&mut self, tag: Tag<'_>) -> Result<(), String> {
        let form = match tag.name() {
            b"polygon" => Form::Polygon,
            b"polyline" => Form::Polyline,
            b"point" => Form::Point,
            b"ellipse" => Form::Round("an ellipse"),
            b"capsule" => Form::Round("a capsule"),
            b"text" => Form::Text,
            _ => return Ok(()),
        };
        self.form = form;
        if let Form::Polygon | Form::Polyline = form {
            let list = tag.attribute("points").ok_or_else(|| format!("{} has no points", self.whose()))?;
            self.points.clear();
            for pair in list.split(u8::is_ascii_whitespace).filter(|pair| !pair.is_empty()) {
                let comma = pair.iter().position(|&b| b == b',').unwrap_or(pair.len());
                let (x, y) = (&pair[..comma], pair.get(comma + 1..).unwrap_or_default());
                self.points.push((number(&self.whose(), "a point's x", x)?, number(&self.whose(), "a point's y", y)?));
            }
        }
        Ok(())
    }

    /// A property of the object.
    pub(super) fn property(&mut self, tag: Tag<'_>) {
        let name = tag.attribute("name").map(text).unwrap_or_default();
        match (tag.attribute("type"), tag.attribute("value")) {
            (Some(b"bool"), Some(b"true")) => self.marks.push(name),
            (None | Some(b"string"), Some(value)) if name.eq_ignore_ascii_case("kind") => self.kind = Some(text(value)),
            _ => {}
        }
    }

    fn whose(&self) -> String {
        format!("object {}", self.id)
    }

    /// The outline, moved by the offset of the layers around; or why there is none.
    pub(super) fn finish(mut self, layer: &Layer, offset: Spot) -> Result<Result<Outline, LeftOut>, String> {
        let title = Title { id: self.id, name: self.name.clone(), layer: layer.name.clone() };
        let at = ((self.at.0 + offset.0).raw(), (self.at.1 + offset.1).raw());
        let left_out = |why: String, suspicious| Ok(Err(LeftOut { title: title.clone(), at, why, suspicious }));
        match self.form {
            Form::Tile => return left_out("a tile as an object".to_owned(), false),
            Form::Point => return left_out("a point".to_owned(), false),
            Form::Text => return left_out("a text".to_owned(), false),
            Form::Template => return left_out("made from a template: detach it in Tiled".to_owned(), true),
            Form::Round(what) => return left_out(format!("{what}: draw it as a polygon"), true),
            Form::Rectangle | Form::Polygon | Form::Polyline => {}
        }
        let Some(kind) = self.kind(layer)? else {
            return left_out(format!("class '{}' is for the game", self.class_or(layer)), false);
        };
        let closed = self.form != Form::Polyline;
        if self.form == Form::Rectangle {
            let ((w, h), zero) = (self.size, Decimal::ZERO);
            self.points = vec![(zero, zero), (w, zero), (w, h), (zero, h)];
        }
        let flags = self.flags();
        let mut outline = Outline { title, kind, closed, points: Vec::new(), rounding: Vec::new(), flags };
        for &point in &self.points {
            let (x, y) = turned(point, self.rotation);
            let (x, y) = (self.at.0 + x + offset.0, self.at.1 + y + offset.1);
            outline.points.push((x.raw(), y.raw()));
            outline.rounding.push(x.off_lattice().max(y.off_lattice()));
        }
        // A chain that ends where it began is a loop.
        if !closed && outline.points.len() > 3 && outline.points.first() == outline.points.last() {
            outline.points.pop();
            outline.rounding.pop();
            outline.closed = true;
        }
        Ok(Ok(outline))
    }

    /// The property `kind`, then class and true properties, then the layer's class, then what the form suggests.
    fn kind(&self, layer: &Layer) -> Result<Option<Kind>, String> {
        if let Some(name) = &self.kind {
            let kind = Kind::from_name(name);
            let known = "there are solid, hole, wall and one-way";
            return kind.map(Some).ok_or_else(|| format!("{} has the kind '{name}'; {known}", self.whose()));
        }
        let mut kinds: Vec<Kind> = self.names().filter_map(Kind::from_name).collect();
        kinds.sort_unstable();
        kinds.dedup();
        if let [a, b, ..] = kinds[..] {
            return Err(format!("{} is both {a} and {b}", self.whose()));
        }
        let by_form = if self.form == Form::Polyline { Kind::Wall } else { Kind::Solid };
        let unnamed = self.class.is_empty() && layer.class.is_empty();
        Ok(kinds.first().copied().or(Kind::from_name(&layer.class)).or(unnamed.then_some(by_form)))
    }

    fn class_or<'a>(&'a self, layer: &'a Layer) -> &'a str {
        if self.class.is_empty() { &layer.class } else { &self.class }
    }

    fn names(&self) -> impl Iterator<Item = &str> {
        [&self.class].into_iter().chain(&self.marks).map(|name| name.trim()).filter(|name| !name.is_empty())
    }

    fn flags(&self) -> Vec<String> {
        let mut flags: Vec<String> = Vec::new();
        for name in self.names().filter(|name| Kind::from_name(name).is_none()) {
            if !flags.iter().any(|f| f.eq_ignore_ascii_case(name)) {
                flags.push(name.to_owned());
            }
        }
        flags
    }
}

fn number(whose: &str, what: &str, digits: &[u8]) -> Result<Decimal, String> {
    let bad = || format!("{whose}: {what} is '{}', no number below a million", text(digits));
    Decimal::parse(digits).ok_or_else(bad)
}

/// Around the object's own point; exact for right angles.
fn turned((x, y): Spot, degrees: Decimal) -> Spot {
    let right_angles: [(&[u8], Spot); 8] = [
        (b"0", (x, y)),
        (b"90", (-y, x)),
        (b"180", (-x, -y)),
        (b"270", (y, -x)),
        (b"-90", (y, -x)),
        (b"-180", (-x, -y)),
        (b"-270", (-y, x)),
        (b"360", (x, y)),
    ];
    if let Some((_, exact)) = right_angles.iter().find(|(angle, _)| Decimal::parse(angle) == Some(degrees)) {
        return *exact;
    }
    let (sin, cos) = degrees.to_f64().to_radians().sin_cos();
    let (x, y) = (x.to_f64(), y.to_f64());
    (Decimal::from_f64(x * cos - y * sin), Decimal::from_f64(x * sin + y * cos))
}

/// The text of an attribute, its entities resolved.
pub(super) fn text(raw: &[u8]) -> String {
    let raw = String::from_utf8_lossy(raw);
    let mut out = String::new();
    let mut rest = &raw[..];
    while let Some(start) = rest.find('&') {
        out.push_str(&rest[..start]);
        rest = &rest[start..];
        let end = rest.find(';').unwrap_or(0);
        let entity = rest.get(1..end).unwrap_or_default();
        let code = match (entity.strip_prefix("#x"), entity.strip_prefix('#')) {
            (Some(hex), _) => u32::from_str_radix(hex, 16).ok().and_then(char::from_u32),
            (None, Some(decimal)) => decimal.parse().ok().and_then(char::from_u32),
            (None, None) => {
                let known = [("amp", '&'), ("lt", '<'), ("gt", '>'), ("quot", '"'), ("apos", '\'')];
                known.iter().find(|(name, _)| *name == entity).map(|&(_, c)| c)
            }
        };
        // What is no entity stands for itself.
        out.push(code.unwrap_or('&'));
        rest = &rest[if code.is_some() { end + 1 } else { 1 }..];
    }
    out.push_str(rest);
    out
}
