//! Plain states in any format of `serde`: the common part of all modules.
//!
//! A type without an invariant derives both traits. Any other has a *form*: plain fields, which
//! are checked on reading by the same rules as a constructor checks its arguments.

use core::fmt;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The saved form of a `T`, which is checked on reading.
pub(crate) trait StoredForm<T>: Sized {
    /// The reason of a refusal.
    type Fault: fmt::Display;

    fn of(value: &T) -> Self;

    fn check(self) -> Result<T, Self::Fault>;
}

pub(crate) fn write<T, F: StoredForm<T> + Serialize, S: Serializer>(value: &T, to: S) -> Result<S::Ok, S::Error> {
    F::of(value).serialize(to)
}

/// The fault says what is wrong, and the name of the type says in which part of a state.
pub(crate) fn read<'de, T, F: StoredForm<T> + Deserialize<'de>, D: Deserializer<'de>>(
    name: &str,
    from: D,
) -> Result<T, D::Error> {
    F::deserialize(from)?.check().map_err(|fault| D::Error::custom(format_args!("{name}: {fault}")))
}

/// Implements both traits for a type by its form. Its parameters are in brackets, if it has any,
/// and those that have to be saved themselves are at the end.
macro_rules! stored {
    ($type:ident as $form:ident) => {
        crate::stored::stored!([] $type<> as $form<>;);
    };
    ([$($parameters:tt)*] $type:ident<$($of:ident),*> as $form:ident<$($by:ident),*>; $($held:ident),*) => {
        impl<$($parameters)*> serde::Serialize for $type<$($of),*>
        where
            $($held: serde::Serialize,)*
        {
            fn serialize<Z: serde::Serializer>(&self, to: Z) -> Result<Z::Ok, Z::Error> {
                crate::stored::write::<_, $form<$($by),*>, Z>(self, to)
            }
        }

        impl<'de, $($parameters)*> serde::Deserialize<'de> for $type<$($of),*>
        where
            $($held: serde::Deserialize<'de>,)*
        {
            fn deserialize<Z: serde::Deserializer<'de>>(from: Z) -> Result<Self, Z::Error> {
                crate::stored::read::<_, $form<$($by),*>, Z>(stringify!($type), from)
            }
        }
    };
}
pub(crate) use stored;

/// The version of the forms of states that depend on the internals of this crate. Numbers and
/// shapes have no version.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Version;

impl Version {
    const NUMBER: u8 = 1;
}

impl Serialize for Version {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_u8(Self::NUMBER)
    }
}

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        match u8::deserialize(from)? {
            Self::NUMBER => Ok(Self),
            other => {
                let known = Self::NUMBER;
                Err(D::Error::custom(format_args!("version {other} is unknown: this crate reads version {known}")))
            }
        }
    }
}

/// A state that contradicts itself, and the place of the contradiction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wrong {
    /// The slot, or the index in a list.
    pub(crate) at: usize,
    pub(crate) what: &'static str,
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "slot {}: {}", self.at, self.what)
    }
}

/// Checks a condition. Returns the fault if it does not hold.
pub(crate) const fn ensure(holds: bool, at: usize, what: &'static str) -> Result<(), Wrong> {
    if holds { Ok(()) } else { Err(Wrong { at, what }) }
}
