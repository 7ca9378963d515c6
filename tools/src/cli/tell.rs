//! Prints lines for the user.

use std::io::{self, Error, ErrorKind, Write};

use crate::fail::{Result, one_line};

/// One line. A closed pipe is not an error.
pub(crate) fn tell(to: &mut dyn Write, line: &str) {
    let _ = writeln!(to, "{}", one_line(line));
}

/// Output that remembers the first error. A closed pipe is none.
pub(crate) struct Checked<'a> {
    to: &'a mut dyn Write,
    error: Option<Error>,
}

impl<'a> Checked<'a> {
    pub(crate) fn new(to: &'a mut dyn Write) -> Self {
        Self { to, error: None }
    }

    /// The exit status of a program with this one: 2 if its output is not complete.
    pub(crate) fn status(mut self, status: u8, err: &mut dyn Write) -> u8 {
        if let Err(error) = self.to.flush() {
            self.keep(error);
        }
        let Some(error) = self.error else { return status };
        tell(err, &format!("tilesat: cannot write the output: {error}"));
        2
    }

    fn keep(&mut self, error: Error) {
        if error.kind() != ErrorKind::BrokenPipe {
            self.error.get_or_insert(error);
        }
    }
}

impl Write for Checked<'_> {
    /// The program goes on: files that it writes do not depend on its lines.
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.to.write(bytes) {
            Err(error) if error.kind() != ErrorKind::Interrupted => {
                self.keep(error);
                Ok(bytes.len())
            }
            result => result,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
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
