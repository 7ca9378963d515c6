//! Prints lines for the user.

use std::io::Write;

use crate::fail::{Result, one_line};

/// One line. A closed pipe is not an error.
pub(crate) fn tell(to: &mut dyn Write, line: &str) {
    let _ = writeln!(to, "{}", one_line(line));
}

/// Our own text of several lines.
pub(crate) fn usage(to: &mut dyn Write, text: &str) {
    let _ = to.write_all(text.as_bytes());
}

/// The exit status of a program. It is 2 after an error, with one line about the reason.
pub(crate) fn status(program: &str, result: Result<u8>, err: &mut dyn Write) -> u8 {
    result.unwrap_or_else(|fail| {
        tell(err, &format!("{program}: {fail}"));
        2
    })
}

/// The most lines of one kind.
const MOST: usize = 50;

/// Lines of one kind, each after its word. Counts the rest if there are many.
pub(crate) fn list(to: &mut dyn Write, word: &str, lines: &[String]) {
    for line in lines.iter().take(MOST) {
        tell(to, &format!("{word:<7} {line}"));
    }
    if lines.len() > MOST {
        tell(to, &format!("{word:<7} and {} more", lines.len() - MOST));
    }
}
