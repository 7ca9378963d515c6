//! The one error type of the tools: a sentence for the user.

use std::fmt;

/// An error that is shown on one line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fail(String);

/// A value, or a sentence that says why there is none.
pub type Result<T> = std::result::Result<T, Fail>;

impl Fail {
    /// The sentence should say what is wrong, where, and what would settle it.
    pub fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }
}

impl fmt::Display for Fail {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<&str> = self.0.split_whitespace().collect();
        f.write_str(&one_line(&words.join(" ")))
    }
}

/// The longest line that is shown.
const LONGEST: usize = 1000;

/// Text as it can stand on a line of a terminal: names out of a file may hold line breaks, escape
/// codes, marks that turn the direction of writing, and be of any length.
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
