//! Values of JSON in the forms that other programs write: whole numbers as floats, numbers as
//! texts, and null.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};

/// A whole number, also as `16.0` and as text. Null is 0.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::read) struct Whole<T>(pub(in crate::read) T);

impl<'de, T: TryFrom<i64> + Default> Deserialize<'de> for Whole<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Any<T>(PhantomData<T>);
        impl<T: TryFrom<i64> + Default> Visitor<'_> for Any<T> {
            type Value = Whole<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a whole number")
            }
            fn visit_i64<E: Error>(self, number: i64) -> Result<Whole<T>, E> {
                T::try_from(number).map(Whole).map_err(|_| E::custom(format!("{number} is out of range")))
            }
            fn visit_u64<E: Error>(self, number: u64) -> Result<Whole<T>, E> {
                let number = i64::try_from(number).map_err(|_| E::custom(format!("{number} is out of range")))?;
                self.visit_i64(number)
            }
            fn visit_f64<E: Error>(self, number: f64) -> Result<Whole<T>, E> {
                if number.fract() != 0.0 {
                    return Err(E::custom(format!("{number} is not a whole number")));
                }
                self.visit_i64(number as i64)
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Whole<T>, E> {
                let number = text.trim().parse::<f64>().map_err(|_| E::invalid_type(Unexpected::Str(text), &self))?;
                self.visit_f64(number)
            }
            fn visit_unit<E: Error>(self) -> Result<Whole<T>, E> {
                Ok(Whole(T::default()))
            }
        }
        from.deserialize_any(Any(PhantomData))
    }
}

/// A whole number.
pub(in crate::read) fn whole<'de, D: Deserializer<'de>, T: TryFrom<i64> + Default>(from: D) -> Result<T, D::Error> {
    Whole::deserialize(from).map(|number| number.0)
}

/// Whole numbers. Null is none.
pub(in crate::read) fn wholes<'de, D: Deserializer<'de>, T: TryFrom<i64> + Default>(
    from: D,
) -> Result<Vec<T>, D::Error> {
    let all = Option::<Vec<Whole<T>>>::deserialize(from)?.unwrap_or_default();
    Ok(all.into_iter().map(|number| number.0).collect())
}

/// Two whole numbers.
pub(in crate::read) fn pair<'de, D: Deserializer<'de>>(from: D) -> Result<(i32, i32), D::Error> {
    <(Whole<i32>, Whole<i32>)>::deserialize(from).map(|(x, y)| (x.0, y.0))
}

/// A whole number, if there is one.
pub(in crate::read) fn count<'de, D: Deserializer<'de>, T: TryFrom<i64> + Default>(
    from: D,
) -> Result<Option<T>, D::Error> {
    Option::<Whole<T>>::deserialize(from).map(|number| number.map(|number| number.0))
}

/// Nothing instead of null.
pub(in crate::read) fn given<'de, D: Deserializer<'de>, T: Deserialize<'de> + Default>(from: D) -> Result<T, D::Error> {
    Option::<T>::deserialize(from).map(Option::unwrap_or_default)
}

/// Whether something is set: true, the word, or a number other than 0.
fn is_set<E: Error>(value: &serde_json::Value) -> Result<Option<bool>, E> {
    match value {
        serde_json::Value::Null => Ok(None),
        serde_json::Value::Bool(is) => Ok(Some(*is)),
        serde_json::Value::Number(number) => Ok(Some(number.as_f64() != Some(0.0))),
        serde_json::Value::String(text) => Ok(Some(!["", "0", "false"].contains(&text.trim()))),
        other => Err(E::custom(format!("{other} is neither true nor false"))),
    }
}

/// The same, or nothing for null.
pub(in crate::read) fn perhaps<'de, D: Deserializer<'de>>(from: D) -> Result<Option<bool>, D::Error> {
    is_set(&serde_json::Value::deserialize(from)?)
}

/// The same. Null is false.
pub(in crate::read) fn flag<'de, D: Deserializer<'de>>(from: D) -> Result<bool, D::Error> {
    perhaps(from).map(Option::unwrap_or_default)
}

/// The same. Null is true.
pub(in crate::read) fn shown<'de, D: Deserializer<'de>>(from: D) -> Result<bool, D::Error> {
    perhaps(from).map(|is| is.unwrap_or(true))
}
