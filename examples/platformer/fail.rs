//! The one error type of the example: a sentence for the user.

use std::fmt;

/// What went wrong, to be shown on one line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fail(String);

pub type Result<T> = std::result::Result<T, Fail>;

impl Fail {
    pub fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }
}

impl fmt::Display for Fail {
    /// Names out of a file may hold line breaks; the promise is one line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<&str> = self.0.split_whitespace().collect();
        f.write_str(&words.join(" ").replace(char::is_control, "?"))
    }
}
