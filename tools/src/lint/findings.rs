//! The linter's report: the first findings of each kind, and their number.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};

use super::finding::{Finding, Severity};

/// The findings of a kind to show. The others are counted.
pub const SHOWN: usize = 50;
/// The findings of a kind to count. More of them are one mistake.
pub const COUNTED: usize = 100_000;

/// Unique findings in order, the worst first.
#[derive(Debug, Clone, Default)]
pub struct Findings {
    kinds: BTreeMap<(Severity, &'static str), Kind>,
}

#[derive(Debug, Clone, Default)]
struct Kind {
    /// The first findings in order, not in time.
    shown: BTreeSet<Finding>,
    /// The hashes of all findings.
    known: HashSet<u64>,
    /// Whether there are more than are counted.
    more: bool,
}

impl Findings {
    /// Whether no more of a kind are counted. Also notes that there is one more.
    pub(super) fn is_full(&mut self, severity: Severity, code: &'static str) -> bool {
        let Some(kind) = self.kinds.get_mut(&(severity, code)) else { return false };
        kind.more |= kind.known.len() >= COUNTED;
        kind.more
    }

    pub(super) fn add(&mut self, finding: Finding) {
        let mut hasher = DefaultHasher::new();
        finding.hash(&mut hasher);
        let kind = self.kinds.entry((finding.severity, finding.code)).or_default();
        if kind.known.insert(hasher.finish()) {
            kind.shown.insert(finding);
            if kind.shown.len() > SHOWN {
                kind.shown.pop_last();
            }
        }
    }

    /// The number of findings, at most [`COUNTED`] of a kind.
    pub fn count(&self, severity: Severity) -> usize {
        let of_it = self.kinds.iter().filter(|((of, _), _)| *of == severity);
        of_it.map(|(_, kind)| kind.known.len()).sum()
    }

    /// A line for each finding that is shown, and one for the others of its kind.
    pub fn lines(&self) -> Vec<String> {
        let mut lines = Vec::new();
        for ((severity, code), kind) in &self.kinds {
            lines.extend(kind.shown.iter().map(Finding::to_string));
            let others = kind.known.len() - kind.shown.len();
            if others > 0 {
                let bound = if kind.more { "over " } else { "" };
                lines.push(format!("{severity} {code}: {bound}{others} more"));
            }
        }
        lines
    }
}
