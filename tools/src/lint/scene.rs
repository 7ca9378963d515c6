//! A level as the checks see it, and what they find.

use super::finding::{Finding, Severity, Who};
use super::geometry::{Edge, Point};
use super::index::Index;
use super::surface::Surface;
use crate::rules::ground::Ground;

/// What moves through the level, in raw units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    Box { width: i64, height: i64 },
    Circle { radius: i64 },
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rules {
    pub body: Option<Body>,
    /// Edges shorter and polygons thinner than this, raw, are slivers.
    pub small: i64,
}

/// A level as the checks see it.
pub(crate) struct Scene<'a> {
    pub drawing: &'a Ground,
    pub rules: &'a Rules,
    /// Of outlines, oriented: the solid lies right of the way (y down). No edge without length, none out of the domain.
    pub edges: Vec<Edge>,
    /// Which edges are near each other.
    pub index: Index,
    pub surface: Option<Surface>,
    pub findings: Vec<Finding>,
}

impl Scene<'_> {
    pub(super) fn say(
        &mut self,
        (severity, code): (Severity, &'static str),
        who: Vec<Who>,
        at: Point,
        what: impl Into<String>,
        why: &'static str,
    ) {
        self.findings.push(Finding { severity, code, who, at, what: what.into(), why });
    }

    /// An edge's owner; an edge number is that of the drawing.
    pub(super) fn who(&self, edge: &Edge) -> Who {
        match edge.outline {
            Some(outline) => self.owner(outline, Some(edge.number)),
            None => self.tiles(),
        }
    }

    pub(super) fn owner(&self, outline: usize, edge: Option<usize>) -> Who {
        let title = &self.drawing.outlines[outline].title;
        Who { id: title.id, title: title.to_string(), edge }
    }

    pub(super) fn tiles(&self) -> Who {
        let layer = self.surface.as_ref().map_or("", |surface| &surface.layer);
        Who { id: 0, title: format!("tile layer '{layer}'"), edge: None }
    }
}
