//! An object of an object layer, or a shape of the collision editor.

use super::decimal::Decimal;
use super::flip::Flip;
use super::property::Properties;

/// A point in pixels.
pub type Spot = (Decimal, Decimal);

/// The same points in raw units.
pub(crate) fn raw(points: &[Spot]) -> Vec<(i64, i64)> {
    points.iter().map(|(x, y)| (x.raw(), y.raw())).collect()
}

/// The form of an object.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Form {
    Rectangle,
    Ellipse,
    Capsule,
    /// Closed; relative to the object.
    Polygon(Vec<Spot>),
    /// Open; relative to the object.
    Polyline(Vec<Spot>),
    Point,
    Text,
    Tile(Stamp),
}

/// The picture of a tile as an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stamp {
    /// The object's own point is this many halves of its size right of its left side and below its
    /// top.
    pub align: (u32, u32),
    /// The drawing offset of the tileset, scaled with the picture. It turns with the object.
    pub offset: Spot,
    /// Index into the tilesets of the map.
    pub tileset: usize,
    pub id: u32,
    pub flip: Flip,
}

/// How much of an object is set at itself. The rest is from its template, its tile or its class.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Own {
    pub name: bool,
    pub class: bool,
    /// So many properties, the first ones.
    pub properties: usize,
}

/// An object, with the values of its template.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Object {
    /// Unique in a map of Tiled, and in a project of `LDtk`.
    pub id: u32,
    pub name: String,
    pub class: String,
    pub properties: Properties,
    pub own: Own,
    /// Values for the game, which decide nothing here: the fields of an `LDtk` entity.
    pub fields: Properties,
    /// The points of each field that has some, in pixels of the layer.
    pub paths: Vec<(String, Vec<Spot>)>,
    pub at: Spot,
    pub size: Spot,
    /// Degrees, clockwise if y grows downward.
    pub rotation: Decimal,
    /// Whether the editor does not show it.
    pub hidden: bool,
    pub form: Form,
}

impl Object {
    /// The same with only the name, the class and the properties that are set at itself.
    pub(crate) fn itself(&self) -> Self {
        let mut alone = self.clone();
        alone.properties.0.truncate(self.own.properties);
        if !self.own.name {
            alone.name.clear();
        }
        if !self.own.class {
            alone.class.clear();
        }
        alone
    }

    /// Whether it is nothing but a form: it has no name, no class, no properties and no picture.
    pub(crate) fn is_plain(&self) -> bool {
        [&self.name, &self.class].into_iter().all(|text| text.trim().is_empty())
            && self.properties.0.is_empty()
            && !matches!(self.form, Form::Tile(_))
    }
}
