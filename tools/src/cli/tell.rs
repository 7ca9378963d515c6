//! Lines for the user.

use std::io::Write;

use crate::fail::{Result, one_line};

/// One line; a closed pipe is no reason to stop.
pub(crate) fn tell(to: &mut dyn Write, line: &str) {
    let _ = writeln!(to, "{}", one_line(line));
}

/// Text of ours, of many lines.
pub(crate) fn usage(to: &mut dyn Write, text: &str) {
    let _ = to.write_all(text.as_bytes());
}

/// The exit status of a program: 2 where it failed, with one line on why.
pub(crate) fn status(program: &str, result: Result<u8>, err: &mut dyn Write) -> u8 {
    result.unwrap_or_else(|fail| {
        tell(err, &format!("{program}: {fail}"));
        2
    })
}

/// Lines of one kind that are shown.
const MOST: usize = 50;

/// Lines of one kind, each with the word before it; where there are many, the rest is counted.
pub(crate) fn list(to: &mut dyn Write, word: &str, lines: &[String]) {
    for line in lines.iter().take(MOST) {
        tell(to, &format!("{word:<7} {line}"));
    }
    if lines.len() > MOST {
        tell(to, &format!("{word:<7} and {} more", lines.len() - MOST));
    }
}
