//! The reviewed table, and its lines in the changelog. Only on a computer.
#![allow(clippy::std_instead_of_core, reason = "files and strings")]

use std::collections::BTreeMap;
use std::fmt::{Display, Write};

use super::family::{Line, Run};
use super::groups::{GAMES, GROUPS};

/// The version of the library under test.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The reviewed hashes, relative to the root of the repository.
pub const PATH: &str = "tests/golden/hashes.txt";

const HEAD: &str = "\
# The reviewed hashes of every query; written by `cargo run --release -p tilesat-golden -- --accept`, compared by `cargo test -p tilesat-golden --lib`
# and, on every target, by `.ci/targets`. A row: the query, of what, the version that its answers are from, and after so many vectors (of games
# frames) the hash. The last hash of a row stands in the changelog's list of outputs of that version.
";

/// A family: the version of its hashes, and the hashes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    pub since: String,
    /// By the number of vectors.
    pub hashes: Vec<(u32, String)>,
}

impl Row {
    /// The hash of all vectors.
    pub fn last(&self) -> &str {
        self.hashes.last().map_or("", |(_, hash)| hash)
    }
}

/// The families by query and kind, in the order in which they are run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    pub rows: Vec<((String, String), Row)>,
}

impl Table {
    /// Runs everything. `tell` gets each line as it comes, and the total.
    pub fn fresh(count: u32, mut tell: impl FnMut(&dyn Display)) -> Self {
        let mut table = Self::default();
        let mut each = |line: &Line| {
            tell(line);
            table.add(line);
        };
        let mut run = Run::new(count, &mut each);
        for part in GROUPS.iter().copied().flatten().chain(GAMES) {
            part(&mut run);
        }
        let total = run.to_string();
        tell(&total);
        table
    }

    fn add(&mut self, line: &Line) {
        let (name, hash) = ((line.query.to_owned(), line.of.to_owned()), (line.count, line.hash.to_string()));
        match self.rows.iter_mut().find(|(other, _)| *other == name) {
            Some((_, row)) => row.hashes.push(hash),
            None => self.rows.push((name, Row { since: VERSION.to_owned(), hashes: vec![hash] })),
        }
    }

    /// `None` if the line is not one of a table.
    pub fn parse(text: &str) -> Option<Self> {
        let mut rows = Vec::new();
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            let mut words = line.split_whitespace();
            let name = (words.next()?.to_owned(), words.next()?.to_owned());
            let since = words.next()?.to_owned();
            let hash = |word: &str| Some((word.split_once(':')?.0.parse().ok()?, word.split_once(':')?.1.to_owned()));
            rows.push((name, Row { since, hashes: words.map(hash).collect::<Option<_>>()? }));
        }
        Some(Self { rows })
    }

    pub fn text(&self) -> String {
        let mut text = HEAD.to_owned();
        for ((query, of), row) in &self.rows {
            let _ = write!(text, "{query} {of} {}", row.since);
            for (count, hash) in &row.hashes {
                let _ = write!(text, " {count}:{hash}");
            }
            text.push('\n');
        }
        text
    }

    /// The same with the versions of families that have not changed.
    #[must_use]
    pub fn dated(mut self, reviewed: &Self) -> Self {
        for (name, row) in &mut self.rows {
            if let Some((_, old)) = reviewed.rows.iter().find(|(other, old)| other == name && old.hashes == row.hashes)
            {
                row.since.clone_from(&old.since);
            }
        }
        self
    }

    /// The differences from the reviewed table, each family by its name. A shorter run is compared
    /// as far as it went.
    pub fn differences(&self, reviewed: &Self) -> Vec<String> {
        let mut found = Vec::new();
        for ((query, of), row) in &self.rows {
            let Some((_, old)) = reviewed.rows.iter().find(|((q, o), _)| q == query && o == of) else {
                found.push(format!("{query} of {of}: not in the table"));
                continue;
            };
            for (count, hash) in &row.hashes {
                match old.hashes.iter().find(|(other, _)| other == count) {
                    Some((_, old)) if old == hash => continue,
                    Some((_, old)) => found.push(format!("{query} of {of}: {hash} after {count}, reviewed is {old}")),
                    None => found.push(format!("{query} of {of}: nothing reviewed after {count}")),
                }
                break;
            }
        }
        for (name, _) in reviewed.rows.iter().filter(|(name, _)| self.rows.iter().all(|(other, _)| other != name)) {
            found.push(format!("{} of {}: in the table, and not asked", name.0, name.1));
        }
        found
    }

    /// Its part of the changelog's list for a version: a line per query, with every kind and its
    /// last hash.
    pub fn outputs(&self, version: &str) -> Vec<String> {
        let mut queries = BTreeMap::<&str, String>::new();
        for ((query, of), row) in self.rows.iter().filter(|(_, row)| row.since == version) {
            let line = queries.entry(query).or_insert_with(|| format!("- `{query}`:"));
            let _ = write!(line, "{}{of} {}", if line.ends_with(':') { " " } else { ", " }, row.last());
        }
        queries.into_values().collect()
    }
}

/// The lines of the list of outputs in the changelog's section of a version.
pub fn listed(changelog: &str, version: &str) -> Vec<String> {
    let head = format!("## {version} ");
    let section = changelog.lines().skip_while(|line| !line.starts_with(&head)).skip(1);
    let section = section.take_while(|line| !line.starts_with("## "));
    let list = section.skip_while(|line| *line != "### Outputs").skip(1).take_while(|line| !line.starts_with('#'));
    list.filter(|line| line.starts_with("- ")).map(str::to_owned).collect()
}
