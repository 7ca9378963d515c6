//! Solids and one-way edges by their corners, in raw units: objects, and tiles that are not a shape
//! of the library.

use std::fmt;

use super::kind::Kind;
use crate::model::property::{Properties, Value};

/// Contract C1 of the library: every coordinate stays below 2^29 raw.
const DOMAIN: i64 = 1 << 29;

/// The name of an object.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Title {
    pub id: u32,
    pub name: String,
    pub layer: String,
}

impl Title {
    /// Made from the tiles of a layer.
    pub fn tiles(layer: &str) -> Self {
        Self { id: u32::MAX, name: String::new(), layer: layer.to_owned() }
    }

    pub(crate) fn is_tiles(&self) -> bool {
        self.id == u32::MAX
    }
}

impl fmt::Display for Title {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.id {
            u32::MAX => write!(f, "the tiles")?,
            id => write!(f, "object {id}")?,
        }
        if !self.name.is_empty() {
            write!(f, " '{}'", self.name)?;
        }
        write!(f, " of layer '{}'", self.layer)
    }
}

impl LeftOut {
    /// Moves it, by raw units.
    pub(crate) fn shift(&mut self, by: (i64, i64)) {
        let named = self.named.iter_mut().flat_map(|(_, points)| points);
        for point in self.area.iter_mut().flatten().chain(&mut self.points).chain(named) {
            *point = (point.0 + by.0, point.1 + by.1);
        }
    }

    /// Whether all of it is in the library's domain.
    pub(crate) fn is_inside(&self) -> bool {
        let inside = |p: &(i64, i64)| [p.0, p.1].iter().all(|v| (-DOMAIN + 1..DOMAIN).contains(v));
        let named = self.named.iter().flat_map(|(_, points)| points);
        self.area.iter().flatten().chain(&self.points).chain(named).all(inside)
    }

    /// A line about it, if its author has surely meant it to be in the level.
    pub(crate) fn warning(&self) -> Option<String> {
        let pixels = |raw: i64| coordinate(raw, raw.div_euclid(1 << 16));
        let line = || format!("{} at ({}, {}): {}", self.title, pixels(self.at.0), pixels(self.at.1), self.why);
        self.suspicious.then(line)
    }

    /// Whether the output has an entry for it.
    pub(crate) fn is_listed(&self) -> bool {
        !self.suspicious && self.area.is_some() && self.is_inside()
    }

    /// Drops its references, except those that lead to an entry.
    pub(crate) fn settle(&mut self, leads: impl Fn(u32) -> bool) {
        for (_, value) in &mut self.properties.0 {
            if let Value::Object(id) = *value {
                if !leads(id) {
                    *value = Value::Lost(format!("it refers to object {id}, which is not in OBJECTS"));
                }
            }
        }
    }
}

/// A coordinate in a message, in these pixels. A number of a file from a million on is a million.
pub(crate) fn coordinate(raw: i64, pixels: impl fmt::Display) -> String {
    match raw >> 16 {
        1_000_000.. => "1000000 or more".to_owned(),
        ..=-1_000_000 => "-1000000 or less".to_owned(),
        _ => pixels.to_string(),
    }
}

/// A polygon or a chain of an object layer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outline {
    pub title: Title,
    pub kind: Kind,
    /// Whether the last point joins the first.
    pub closed: bool,
    /// In raw units, rounded to nearest. May be outside the domain.
    pub points: Vec<(i64, i64)>,
    /// The rounding error of each point, in thousandths of a raw unit.
    pub rounding: Vec<i64>,
    /// All other names from the object's class and true properties.
    pub flags: Vec<String>,
}

impl Outline {
    /// The ends of each edge, in drawing order.
    pub fn edges(&self) -> impl Iterator<Item = ((i64, i64), (i64, i64))> + '_ {
        let close = if self.closed { self.points.first() } else { None };
        let ends = self.points.iter().skip(1).chain(close);
        self.points.iter().copied().zip(ends.copied())
    }
}

/// An object that is not part of the level's surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    pub title: Title,
    /// Its class or type, or else that of its layer.
    pub class: String,
    /// In raw units.
    pub at: (i64, i64),
    /// The box around it in the level, raw: its smallest and its largest corner. `None` if its form
    /// is unknown.
    pub area: Option<[(i64, i64); 2]>,
    /// The points of a polygon, of a polyline or of the first field that has some, raw.
    pub points: Vec<(i64, i64)>,
    /// The points of all fields that have some, raw.
    pub named: Vec<(String, Vec<(i64, i64)>)>,
    /// Its properties and fields.
    pub properties: Properties,
    pub why: String,
    /// Whether its author has surely meant it to be in the level.
    pub suspicious: bool,
}
