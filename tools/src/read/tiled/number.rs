//! Numbers of a file that need not be whole.

use std::fmt;

use serde::de::Error;
use serde::{Deserialize, Deserializer};

use crate::model::decimal::Decimal;

/// A decimal as it is written. From a million on, it is a million.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Number(pub(super) Decimal);

impl Number {
    pub(super) fn is_far(&self) -> bool {
        self.0.is_far()
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.to_f64())
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let text = match serde_json::Value::deserialize(from)? {
            serde_json::Value::Null => return Ok(Self::default()),
            serde_json::Value::Number(number) => number.to_string(),
            serde_json::Value::String(text) => text,
            other => return Err(D::Error::custom(format!("{other} is not a number"))),
        };
        let wrong = || D::Error::custom(format!("'{text}' is not a number"));
        Decimal::saturated(text.as_bytes()).map(Self).ok_or_else(wrong)
    }
}

/// Null is 1.
pub(super) fn one<'de, D: Deserializer<'de>>(from: D) -> Result<Number, D::Error> {
    Option::<Number>::deserialize(from).map(|number| number.unwrap_or(Number(Decimal::whole(1))))
}
