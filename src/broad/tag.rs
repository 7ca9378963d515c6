//! What a broad phase keeps of a body beside its box: nothing, a filter, a key.

/// What a body carries in a broad phase: whom it pairs with, and where it stands in canonical order.
///
/// Asked only about two whose boxes touch. `()` pairs with all and costs nothing, [`Filter`](crate::Filter) has layers, [`Keyed`] adds a key; a rule of a game's own is a
/// type of its own:
///
/// ```
/// use tilesat::broad::Tag;
/// #[derive(Clone, Copy)]
/// struct Team(u8);
/// impl Tag for Team {
///     const BLANK: Self = Self(0);
///     fn pairs_with(&self, other: &Self) -> bool {
///         self.0 != other.0
///     }
/// }
/// assert!(Team(1).pairs_with(&Team(2)) && !Team(1).pairs_with(&Team(1)));
/// ```
pub trait Tag: Copy {
    /// What slots hold that nobody has.
    const BLANK: Self;

    /// Whether two bodies may pair; must be symmetric.
    #[inline]
    #[must_use]
    fn pairs_with(&self, other: &Self) -> bool {
        let _ = other;
        true
    }

    /// The body's place in canonical order, which does not depend on the order of insertion; unique where that matters.
    #[inline]
    #[must_use]
    fn key(&self) -> u32 {
        0
    }
}

impl Tag for () {
    const BLANK: Self = ();
}

/// A tag with a key given by the caller: pairs sorted by it are the same in whichever order bodies were inserted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Keyed<T = ()> {
    /// Unique among the bodies.
    pub key: u32,
    /// Whom it pairs with.
    pub tag: T,
}

impl<T: Tag> Tag for Keyed<T> {
    const BLANK: Self = Self { key: 0, tag: T::BLANK };

    #[inline]
    fn pairs_with(&self, other: &Self) -> bool {
        self.tag.pairs_with(&other.tag)
    }

    #[inline]
    fn key(&self) -> u32 {
        self.key
    }
}
