//! The compiler's messages about a tree.

use serde_json::Value;
use std::path::Path;
use std::process::Command;

pub(crate) struct Error {
    pub(crate) text: String,
    /// Files and lines of the error, of all frames of an evaluation.
    pub(crate) places: Vec<(String, usize)>,
}

/// The errors of builds of the library and of the test programs. A check alone would not evaluate
/// constants, and some functions are evaluated only for constants of tests.
pub(crate) fn errors(tree: &Path, programs: &[&str]) -> Vec<Error> {
    let errors = errors_of(tree, &["build", "--lib"]);
    if !errors.is_empty() || programs.is_empty() {
        return errors;
    }
    let mut args = vec!["test", "--no-run", "--no-fail-fast", "--lib"];
    args.extend(programs.iter().flat_map(|program| ["--test", program]));
    errors_of(tree, &args)
}

fn errors_of(tree: &Path, args: &[&str]) -> Vec<Error> {
    let out = Command::new("cargo")
        .args(args)
        .args(["--package", "tilesat", "--profile", "mutants", "--message-format", "json", "--quiet"])
        .current_dir(tree)
        .output()
        .expect("cargo runs");
    let messages: Vec<Value> =
        String::from_utf8_lossy(&out.stdout).lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    let errors = messages.iter().map(|m| &m["message"]).filter(|m| m["level"] == "error" && has_place(m));
    let errors: Vec<Error> = errors.map(error).collect();
    assert!(out.status.success() || !errors.is_empty(), "{}", String::from_utf8_lossy(&out.stderr));
    errors
}

fn has_place(message: &Value) -> bool {
    message["spans"].as_array().is_some_and(|spans| !spans.is_empty())
}

fn error(message: &Value) -> Error {
    let evaluation = message["code"]["code"] == "E0080";
    let mut places = Vec::new();
    let mut pending = vec![message];
    while let Some(message) = pending.pop() {
        for span in message["spans"].as_array().into_iter().flatten().filter(|s| evaluation || s["is_primary"] == true)
        {
            let file = span["file_name"].as_str().unwrap_or_default().to_owned();
            places.push((file, span["line_start"].as_u64().unwrap_or(0) as usize));
        }
        // For an evaluation, every frame counts. For other errors, the further places are only
        // declarations.
        if evaluation {
            pending.extend(message["children"].as_array().into_iter().flatten());
        }
    }
    Error { text: message["rendered"].as_str().unwrap_or_default().to_owned(), places }
}
