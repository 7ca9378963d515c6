//! The linter's messages.

use std::fmt;
use std::rc::Rc;

use crate::geometry::Point;

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The library refuses it, or bodies meet something that nobody drew.
    Error,
    /// The library follows the drawing, but the author probably meant something else.
    Warning,
    Note,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Error => "error",
            Self::Warning => "warning",
            Self::Note => "note",
        })
    }
}

/// Sorts by severity, then code, then object, then position.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Finding {
    pub severity: Severity,
    pub code: &'static str,
    /// The object or layer, and a second one if two are involved.
    pub who: Vec<Who>,
    pub at: Point,
    pub what: String,
    /// Why it matters.
    pub why: &'static str,
}

/// An object or a tile layer, and one of its edges. Edge 0 starts at its first point.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Who {
    pub id: u32,
    pub title: Rc<str>,
    pub edge: Option<usize>,
}

impl fmt::Display for Finding {
    /// A finding is one line, but names in a file can contain line breaks.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let who = match &self.who[..] {
            [Who { title, edge: Some(i), .. }, Who { title: other, edge: Some(j), .. }] if title == other => {
                format!("{title}, edges {i} and {j}")
            }
            list => list.iter().map(Who::to_string).collect::<Vec<_>>().join(" and "),
        };
        let text = format!("{} {} at {}: {who}: {}; {}", self.severity, self.code, place(self.at), self.what, self.why);
        f.write_str(&text.replace(char::is_control, " "))
    }
}

impl fmt::Display for Who {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.edge {
            None => f.write_str(&self.title),
            Some(edge) => write!(f, "{}, edge {edge}", self.title),
        }
    }
}

pub(super) fn place((x, y): Point) -> String {
    format!("({}, {})", pixels(x), pixels(y))
}

/// Raw units as pixels. Five decimals distinguish all raw numbers.
pub(super) fn pixels(raw: i64) -> String {
    let scaled = (i128::from(raw.unsigned_abs()) * 100_000 + (1 << 15)) >> 16;
    let sign = if raw < 0 && scaled > 0 { "-" } else { "" };
    let text = format!("{sign}{}.{:05}", scaled / 100_000, scaled % 100_000);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
