//! The same bits as always: every query has its reviewed hash, and the changelog names each.
//! `.ci/targets` checks all targets.
//!
//! Accept a change of results with `cargo run --profile unlinked -p tilesat-golden -- --accept`,
//! and add the lines that it prints to the changelog.

use super::VECTORS;
use super::table::{PATH, Table, VERSION, listed};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)).unwrap()
}

fn reviewed() -> Table {
    Table::parse(&read(PATH)).unwrap()
}

#[test]
fn hashes_are_the_reviewed_ones() {
    let differences = Table::fresh(VECTORS, |_| {}).differences(&reviewed());
    assert!(differences.is_empty(), "other bits than reviewed:\n{}", differences.join("\n"));
}

/// No two families share a name. A family's hashes come after more and more vectors.
#[test]
fn families_have_names_of_their_own() {
    for (name, row) in &reviewed().rows {
        assert!(!row.hashes.is_empty() && row.hashes.windows(2).all(|two| two[0].0 < two[1].0), "{name:?}: {row:?}");
    }
}

/// Every hashed query has as many vectors as promised. Games have frames.
#[test]
fn queries_have_their_vectors() {
    let table = reviewed();
    let queries: BTreeSet<_> = table.rows.iter().map(|((query, _), _)| query).collect();
    for query in queries {
        let rows = table.rows.iter().filter(|((other, _), _)| other == query);
        let vectors: u32 = rows.map(|(_, row)| row.hashes.last().unwrap().0).sum();
        let wanted = if query == "frames" { 30_000 } else { VECTORS };
        assert!(vectors >= wanted, "{query}: {vectors} of {wanted}");
    }
}

/// Nobody edits a hash without a line in the changelog, in the section of the hash's version.
#[test]
fn the_changelog_names_every_output() {
    let (table, changelog) = (reviewed(), read("CHANGELOG.md"));
    let versions: BTreeSet<_> = table.rows.iter().map(|(_, row)| row.since.as_str()).collect();
    for version in versions {
        let listed = listed(&changelog, version);
        for line in table.outputs(version) {
            assert!(listed.contains(&line), "CHANGELOG.md, {version}, Outputs lacks\n{line}");
        }
    }
    let package = read("Cargo.toml");
    let version = package.lines().find_map(|line| line.strip_prefix("version = \"")?.strip_suffix('"')).unwrap();
    assert_eq!(
        version, VERSION,
        "rows are dated by the version of the package that writes them: tests/golden/Cargo.toml"
    );
    let now = table.outputs(version);
    for line in listed(&changelog, version) {
        assert!(now.contains(&line), "CHANGELOG.md, {version}, Outputs has what is not in {PATH}\n{line}");
    }
}
