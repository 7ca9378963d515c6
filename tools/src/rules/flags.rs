//! Names of flags, and the bit of each.

/// A tile and a segment carry eight.
const MOST: usize = 8;

/// The flags of one or more levels, bit 0 first.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Flags {
    pub names: Vec<String>,
    /// Whether the user has named the flags that stay.
    chosen: bool,
    /// The flags that were dropped.
    pub dropped: Vec<String>,
}

impl Flags {
    /// The user's names come first, whether a level uses them or not.
    ///
    /// # Errors
    ///
    /// If there are more than eight.
    pub fn new(chosen: &[String]) -> Result<Self, String> {
        let mut flags = Self::default();
        for name in chosen {
            flags.bit(name)?;
        }
        flags.chosen = !chosen.is_empty();
        Ok(flags)
    }

    /// The bit of a flag. Adds new flags.
    ///
    /// # Errors
    ///
    /// If it would be the ninth, and the user has not said which ones stay.
    pub fn bit(&mut self, name: &str) -> Result<u8, String> {
        if let Some(bit) = self.names.iter().position(|known| known.eq_ignore_ascii_case(name)) {
            return Ok(1 << bit);
        }
        if self.names.len() < MOST {
            self.names.push(name.to_owned());
            return Ok(1 << (self.names.len() - 1));
        }
        if !self.chosen {
            let list = self.names.join(", ");
            return Err(format!(
                "'{name}' would be the ninth flag, after {list}; add --flag NAME for each of those that should stay"
            ));
        }
        if !self.dropped.iter().any(|known| known.eq_ignore_ascii_case(name)) {
            self.dropped.push(name.to_owned());
        }
        Ok(0)
    }

    /// The names of the bits of a mask.
    pub(super) fn of(&self, mask: u8) -> Vec<String> {
        let named = self.names.iter().enumerate().filter(|(bit, _)| mask >> bit & 1 != 0);
        named.map(|(_, name)| name.clone()).collect()
    }
}
