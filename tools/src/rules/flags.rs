//! Names of flags, and the bit of each.

/// A tile and a segment carry eight.
const MOST: usize = 8;

/// The flags of one or more levels, bit 0 first.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Flags {
    pub names: Vec<String>,
    /// Whether the user has named the flags that stay.
    chosen: bool,
    /// The flags that were dropped: the later ones.
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
            if flags.bit(name) == 0 {
                return Err(format!("--flag {name} would be the ninth flag: tiles and segments have at most {MOST}"));
            }
        }
        flags.chosen = !chosen.is_empty();
        Ok(flags)
    }

    /// The bit of a flag. Adds new flags. 0 for the ninth and all later ones, which are dropped: no
    /// flag changes what is solid.
    pub fn bit(&mut self, name: &str) -> u8 {
        if let Some(bit) = self.names.iter().position(|known| known.eq_ignore_ascii_case(name)) {
            return 1 << bit;
        }
        if self.names.len() < MOST {
            self.names.push(name.to_owned());
            return 1 << (self.names.len() - 1);
        }
        if !self.dropped.iter().any(|known| known.eq_ignore_ascii_case(name)) {
            self.dropped.push(name.to_owned());
        }
        0
    }

    /// A line about the flags that were dropped, unless the user has chosen those that stay.
    pub(crate) fn warning(&self) -> Option<String> {
        let dropped = self.dropped.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
        (!self.chosen && !dropped.is_empty()).then(|| {
            format!(
                "tiles and segments have at most {MOST} flags; {} stay, and these are dropped: {dropped}; add --flag NAME \
                 for each of those that should stay",
                self.names.join(", ")
            )
        })
    }

    /// The names of the bits of a mask.
    pub(super) fn of(&self, mask: u8) -> Vec<String> {
        let named = self.names.iter().enumerate().filter(|(bit, _)| mask >> bit & 1 != 0);
        named.map(|(_, name)| name.clone()).collect()
    }
}
