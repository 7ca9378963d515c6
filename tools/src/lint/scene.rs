//! A level for the checks, and their findings.

use std::rc::Rc;

use super::edges::is_sound;
use super::finding::{Finding, Severity, Who};
use super::findings::Findings;
use super::index::Index;
use super::surface::Surface;
use crate::geometry::{Edge, Point, doubled_area};
use crate::rules::ground::Ground;
use crate::rules::outline::Outline;

/// The body that moves through the level, in raw units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    Box { width: i64, height: i64 },
    Circle { radius: i64 },
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rules {
    pub body: Option<Body>,
    /// Slivers: edges shorter than this and polygons thinner than this, in raw units.
    pub small: i64,
}

/// A level for the checks.
pub(crate) struct Scene<'a> {
    pub drawing: &'a Ground,
    pub rules: &'a Rules,
    /// Edges of outlines, oriented: the solid lies right of the way (y down). None has length zero
    /// or is outside the domain.
    pub edges: Vec<Edge>,
    /// The index of edges that are near each other.
    pub index: Index,
    pub surface: Option<Surface>,
    pub findings: Findings,
    /// The name of each outline.
    titles: Vec<Rc<str>>,
    /// Whether each outline has an inside.
    insides: Vec<bool>,
}

impl<'a> Scene<'a> {
    pub(super) fn new(drawing: &'a Ground, rules: &'a Rules, edges: Vec<Edge>, surface: Option<Surface>) -> Self {
        let outlines = &drawing.outlines;
        let titles = outlines.iter().map(|outline| outline.title.to_string().into()).collect();
        let inside =
            |outline: &Outline| outline.kind.has_area() && is_sound(outline) && doubled_area(&outline.points) != 0;
        let insides = outlines.iter().map(inside).collect();
        let index = Index::new(&edges);
        Self { drawing, rules, edges, index, surface, findings: Findings::default(), titles, insides }
    }

    pub(super) fn say(
        &mut self,
        (severity, code): (Severity, &'static str),
        who: Vec<Who>,
        at: Point,
        what: impl Into<String>,
        why: &'static str,
    ) {
        if !self.findings.is_full(severity, code) {
            self.findings.add(Finding { severity, code, who, at, what: what.into(), why });
        }
    }

    /// Reports that a check ended at an edge, because the rest is too much.
    pub(super) fn say_unfinished(&mut self, at: &Edge, what: &'static str) {
        let why = "too much lies over each other here to find other mistakes";
        self.say((Severity::Warning, "unfinished"), vec![self.who(at)], at.a, what, why);
    }

    /// An edge's owner. Edge numbers are those of the drawing.
    pub(super) fn who(&self, edge: &Edge) -> Who {
        match edge.outline {
            Some(outline) => self.owner(outline, Some(edge.number)),
            None => self.tiles(),
        }
    }

    pub(super) fn owner(&self, outline: usize, edge: Option<usize>) -> Who {
        Who { id: self.drawing.outlines[outline].title.id, title: self.titles[outline].clone(), edge }
    }

    pub(super) fn tiles(&self) -> Who {
        let layer = self.surface.as_ref().map_or("", |surface| &surface.layer);
        Who { id: 0, title: format!("tile layer '{layer}'").into(), edge: None }
    }

    /// Whether an edge belongs to the border of a solid or a hole that has an inside.
    pub(super) fn bounds_inside(&self, edge: &Edge) -> bool {
        edge.outline.is_some_and(|outline| self.insides[outline])
    }
}
