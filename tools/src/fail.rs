//! The one error type of the tools: a sentence for the user.

use std::fmt;

/// An error that is shown on one line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fail(String);

/// A value, or a sentence about the reason that there is none.
pub type Result<T> = std::result::Result<T, Fail>;

impl Fail {
    /// The sentence should say what is wrong, where, and how to fix it.
    pub fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }

    /// Names the level, if there are several.
    pub(crate) fn of_level(self, name: &str, several: bool) -> Self {
        if several { Self(format!("level '{name}': {self}")) } else { self }
    }
}

impl fmt::Display for Fail {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<&str> = self.0.split_whitespace().collect();
        f.write_str(&one_line(&words.join(" ")))
    }
}

/// The greatest length of a line.
const LONGEST: usize = 1000;

/// Makes text safe for one line of a terminal. Names in a file can contain line breaks, escape
/// codes and marks that reverse the direction of writing, and can have any length.
pub(crate) fn one_line(text: &str) -> String {
    let unseen = |c: char| {
        c.is_control()
            || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
    };
    let mut line: String = text.chars().take(LONGEST).map(|c| if unseen(c) { '?' } else { c }).collect();
    if text.chars().nth(LONGEST).is_some() {
        line.push_str("...");
    }
    line
}
