//! All checks of a level, and what they share.

use super::edges;
use super::finding::{Finding, Severity, Who};
use super::geometry::{Edge, Point};
use super::index::Index;
use super::level_io::Drawing;
use super::level_io::fail::{Fail, Result};
use super::surface::{self, Surface};
use super::{crossings, nesting, outlines, pockets, reach};

/// What moves through the level, in raw units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    Box { width: i64, height: i64 },
    Circle { radius: i64 },
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rules {
    pub body: Option<Body>,
    /// Edges shorter and polygons thinner than this, raw, are slivers.
    pub small: i64,
    /// The tile layer that is solid.
    pub layer: Option<String>,
}

/// A level as the checks see it.
pub struct Scene<'a> {
    pub drawing: &'a Drawing,
    pub rules: &'a Rules,
    /// Of outlines, oriented: the solid lies right of the way (y down). No edge without length, none out of the domain.
    pub edges: Vec<Edge>,
    /// Which edges are near each other.
    pub index: Index,
    pub surface: Option<Surface>,
    findings: Vec<Finding>,
}

/// As many edges as a segment map can hold.
const MAX_EDGES: usize = 65_534;

pub fn check(drawing: &Drawing, rules: &Rules) -> Result<Vec<Finding>> {
    let edges = edges::of(&drawing.outlines);
    if edges.len() > MAX_EDGES {
        return Err(Fail::new(format!("{} edges; a segment map holds {MAX_EDGES}", edges.len())));
    }
    let surface = drawing.level(rules.layer.as_deref())?.map(surface::of).transpose()?;
    let index = Index::new(&edges);
    let mut scene = Scene { drawing, rules, edges, index, surface, findings: Vec::new() };
    outlines::check(&mut scene);
    let crossed = crossings::check(&mut scene);
    nesting::check(&mut scene, &crossed);
    reach::check(&mut scene);
    pockets::check(&mut scene);
    let mut findings = scene.findings;
    findings.sort_unstable();
    findings.dedup();
    Ok(findings)
}

impl Scene<'_> {
    pub fn say(
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
    pub fn who(&self, edge: &Edge) -> Who {
        match edge.outline {
            Some(outline) => self.owner(outline, Some(edge.number)),
            None => self.tiles(),
        }
    }

    pub fn owner(&self, outline: usize, edge: Option<usize>) -> Who {
        let title = &self.drawing.outlines[outline].title;
        Who { id: title.id, title: title.to_string(), edge }
    }

    pub fn tiles(&self) -> Who {
        let layer = self.surface.as_ref().map_or("", |surface| &surface.layer);
        Who { id: 0, title: format!("tile layer '{layer}'"), edge: None }
    }
}
