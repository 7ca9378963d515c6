//! An object of an object layer, or a shape of the collision editor.

use super::decimal::Decimal;
use super::property::Properties;

/// A point in pixels.
pub type Spot = (Decimal, Decimal);

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
    /// A tileset's picture, drawn above the object's own point.
    Tile,
    /// Made from a template that cannot be read, and the reason.
    Missing(String),
}

/// An object, with the values of its template.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Object {
    pub id: u32,
    pub name: String,
    pub class: String,
    pub properties: Properties,
    /// Values for the game, which decide nothing here: the fields of an `LDtk` entity.
    pub fields: Properties,
    /// The points of such a field, in pixels of the layer.
    pub path: Vec<Spot>,
    pub at: Spot,
    pub size: Spot,
    /// Degrees, clockwise if y grows downward.
    pub rotation: Decimal,
    pub form: Form,
}
